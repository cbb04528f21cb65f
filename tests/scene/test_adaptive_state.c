/* Scenes with adapted threads: saved, hashed, restored to the bit whatever mesh is there; nothing allocated. */
#include <stdlib.h>

#include "base/error.h"
#include "scene/mesh_rig.h"

/* Two strands come together and part again, one of them is cut. */
enum { CUT_AT = 70 };

static vbss_result add_thread(vbss_scene *scene, vbss_context *context, const double start[3],
                              const double direction[3], vbss_bending bending)
{
    vbss_thread_config c;
    vbss_thread *thread;
    uint32_t body;
    VBSS_TRY(vbss_thread_config_init(&c, sizeof c));
    c.mesh = VBSS_MESH_ADAPTIVE;
    c.bending = bending;
    c.segment_count = 20;
    c.node_capacity = 120;
    c.length = 0.04;
    c.cut_capacity = 1;
    memcpy(c.start, start, sizeof c.start);
    memcpy(c.direction, direction, sizeof c.direction);
    VBSS_TRY(vbss_thread_create(context, &c, &thread));
    return vbss_scene_add_thread(scene, thread, &body);
}

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    static const double places[2][3] = {{0.0, 0.0, 0.0}, {0.02, 2.5e-3, -0.02}};
    static const double ways[2][3] = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    const vbss_capsule capsule = {{0.012, 0.0, -5e-3}, {0.012, 0.0, 5e-3}, 1.2e-3};
    vbss_scene_config config;
    vbss_rigid_config rigid;
    vbss_scene *scene;
    uint32_t body, pin;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.node_capacity = 260;
    VBSS_TRY(vbss_scene_create(context, &config, &scene));
    for (int k = 0; k < 2; k++) {
        VBSS_TRY(add_thread(scene, context, places[k], ways[k], *(const vbss_bending *)user));
    }
    VBSS_TRY(vbss_rigid_config_init(&rigid, sizeof rigid));
    rigid.capsules = &capsule;
    rigid.capsule_count = 1;
    rigid.position[1] = -1.33e-3;
    VBSS_TRY(vbss_scene_add_rigid(scene, &rigid, &body));
    VBSS_TRY(vbss_scene_pin_thread(scene, 1, 0, 0, NULL, &pin));
    VBSS_TRY(vbss_scene_pin_thread(scene, 1, 20, 0, NULL, &pin));
    *handle = scene;
    return VBSS_OK;
}

static vbss_result step(void *handle)
{
    vbss_scene_statistics statistics;
    uint32_t piece;
    VBSS_TRY(vbss_scene_get_statistics(handle, &statistics, sizeof statistics));
    if (statistics.steps == CUT_AT) {
        VBSS_TRY(vbss_scene_cut_thread(handle, 2, 0.0122, &piece));
    }
    return vbss_scene_step(handle, 1e-3);
}

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static vbss_bending bendings[] = {VBSS_BENDING_SPLINE, VBSS_BENDING_LOCAL};

static harness_body body_of(int bending)
{
    harness_body body = {"scene that adapts", &vbss_scene_kind, create, NULL, step, destroy,
                         &bendings[bending]};
    return body;
}

/* The scene does what it is there for. */
static void mesh_adapts_on_both_sides_of_cut(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    expect_ok(create(context, &bendings[0], &scene));
    uint32_t most = 0, least = 1000;
    for (int i = 0; i < 160; i++) {
        expect_ok(step(scene));
        const scene_object *s = mesh_scene(scene);
        cut_expect_sound(s);
        most = s->node_count > most ? s->node_count : most;
        least = s->node_count < least ? s->node_count : least;
    }
    assert_true(most > 90 && least <= 44);
    expect_ok(vbss_scene_destroy(scene));
    harness_context_end(context, &memory);
}

static void restored_scene_adapts_bit_equal(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        harness_body body = body_of(bending);
        static const size_t moments[] = {0, 3, 20, 45, 69, 70, 71, 110};
        harness_save_restore_continue_at(&body, moments, sizeof moments / sizeof moments[0], 30);
    }
}

static void adapting_steps_do_not_allocate(void **state)
{
    (void)state;
    harness_body body = body_of(0);
    assert_int_equal(harness_step_allocations(&body, 120), 0);
}

static void bad_adapted_snapshots_are_rejected(void **state)
{
    (void)state;
    harness_body body = body_of(0);
    harness_refuses_bad_snapshots(&body, 30);
}

/* ---- which copy of the search finds what is near does not matter */

static uint64_t hash_after(bool wide, uint32_t steps)
{
    vbss_context *context;
    void *scene = NULL;
    uint64_t hash;
    expect_ok(vbss_context_create(NULL, &context));
    expect_ok(create(context, &bendings[0], &scene));
    scene_object *s = mesh_scene(scene);
    s->collision->wide = s->collision->wide && wide;
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(step(scene));
    }
    expect_ok(vbss_scene_get_hash(scene, &hash));
    vbss_context_destroy(context);
    return hash;
}

static void scalar_and_simd_search_adapt_alike(void **state)
{
    (void)state;
    assert_true(hash_after(false, 120) == hash_after(true, 120));
}

int test_adaptive_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mesh_adapts_on_both_sides_of_cut),
        cmocka_unit_test(restored_scene_adapts_bit_equal),
        cmocka_unit_test(adapting_steps_do_not_allocate),
        cmocka_unit_test(bad_adapted_snapshots_are_rejected),
        cmocka_unit_test(scalar_and_simd_search_adapt_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
