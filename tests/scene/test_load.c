/* A scene that is loaded from the bytes of another one alone goes on with the same bits. */
#include <stdlib.h>
#include <string.h>

#include "fixtures/adaptive_scene.h"
#include "fixtures/cutting_scene.h"
#include "fixtures/needle_scenes.h"
#include "fixtures/paper_needle_scenes.h"
#include "fixtures/scene_scenes.h"
#include "fixtures/tool_scenes.h"
#include "scene/small.h"

typedef struct bytes {
    uint8_t *at;
    uint64_t count;
} bytes;

static bytes save(vbss_scene *scene)
{
    bytes saved = {NULL, 0};
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(scene, NULL, 0, &saved.count));
    saved.at = malloc((size_t)saved.count);
    assert_non_null(saved.at);
    expect_ok(vbss_scene_save(scene, saved.at, saved.count, &saved.count));
    return saved;
}

static uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

static void expect_same_bytes(const bytes *a, const bytes *b)
{
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->at, b->at, (size_t)a->count);
}

/* ---- scenes of every kind of body, by both methods */

typedef struct run {
    const char *name;
    vbss_result (*create)(vbss_context *context, vbss_scene **scene);
    vbss_result (*step)(vbss_scene *scene);
    uint32_t every, loads, steps; /* steps between loads; loads; steps after each */
} run;

static vbss_result create_tools(vbss_context *context, vbss_scene **scene)
{
    return tool_scene_create(context, VBSS_METHOD_IMPLICIT, scene);
}
static vbss_result create_paper_tools(vbss_context *context, vbss_scene **scene)
{
    return tool_scene_create(context, VBSS_METHOD_VBLAST, scene);
}
static vbss_result create_cuts(vbss_context *context, vbss_scene **scene)
{
    return cutting_scene_create(context, VBSS_METHOD_IMPLICIT, scene);
}
static vbss_result create_paper_cuts(vbss_context *context, vbss_scene **scene)
{
    return cutting_scene_create(context, VBSS_METHOD_VBLAST, scene);
}
static vbss_result create_adaptive(vbss_context *context, vbss_scene **scene)
{
    return adaptive_scene_create(context, VBSS_THREAD_BENDING_SPLINE, scene);
}
static vbss_result create_rods(vbss_context *context, vbss_scene **scene)
{
    return scene_scene_create(context, SCENE_SCENE_TOOLS, scene);
}
static vbss_result step_rods(vbss_scene *scene)
{
    return scene_scene_step(scene, SCENE_SCENE_TOOLS);
}
static vbss_result create_mesh(vbss_context *context, vbss_scene **scene)
{
    return scene_scene_create(context, SCENE_SCENE_MESH, scene);
}
static vbss_result step_mesh(vbss_scene *scene)
{
    return scene_scene_step(scene, SCENE_SCENE_MESH);
}

static const run runs[] = {
    {"rods and a thread", create_rods, step_rods, 40, 4, 5},
    {"drain", create_mesh, step_mesh, 20, 3, 3},
    {"graspers", create_tools, tool_scene_step, 150, 6, 5},
    {"graspers, baseline method", create_paper_tools, tool_scene_step, 100, 3, 3},
    {"needle, drain, thread and graspers", needle_scene_create, needle_scene_step, 275, 8, 4},
    {"needle, baseline method", paper_needle_scene_create, paper_needle_scene_step, 400, 4, 3},
    {"cuts", create_cuts, cutting_scene_step, 40, 5, 5},
    {"cuts, baseline method", create_paper_cuts, cutting_scene_step, 40, 3, 3},
    {"adaptive threads", create_adaptive, adaptive_scene_step, 40, 5, 5},
};

static void load_and_compare(const run *r, vbss_scene *scene)
{
    harness_memory memory;
    vbss_context *other = harness_context(&memory);
    vbss_scene *loaded;
    bytes saved = save(scene);
    vbss_result result = vbss_scene_load(other, saved.at, saved.count, &loaded);
    if (result != VBSS_OK) {
        const char *text;
        expect_ok(vbss_context_get_last_error(other, &result, &text));
        print_error("%s: %s\n", r->name, text);
    }
    expect_ok(result);
    bytes again = save(loaded);
    expect_same_bytes(&saved, &again);
    for (uint32_t i = 0; i < r->steps; i++) {
        assert_int_equal(hash_of(scene), hash_of(loaded));
        expect_ok(r->step(scene));
        expect_ok(r->step(loaded));
    }
    assert_int_equal(hash_of(scene), hash_of(loaded));
    free(saved.at);
    free(again.at);
    harness_context_end(other, &memory);
}

static void loaded_scene_continues_with_same_bits(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof runs / sizeof runs[0]; i++) {
        const run *r = &runs[i];
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        vbss_scene *scene;
        expect_ok(r->create(context, &scene));
        for (uint32_t k = 0; k < r->loads; k++) {
            load_and_compare(r, scene);
            for (uint32_t step = r->steps; step < r->every; step++) {
                expect_ok(r->step(scene));
            }
        }
        load_and_compare(r, scene);
        harness_context_end(context, &memory);
    }
}

/* ---- bodies that came, went, and were cut */

static vbss_scene *load(vbss_context *context, vbss_scene *scene)
{
    vbss_scene *loaded;
    bytes saved = save(scene);
    expect_ok(vbss_scene_load(context, saved.at, saved.count, &loaded));
    free(saved.at);
    return loaded;
}

/* The loaded scene has the numbers of the bodies, and gives the next one to a new body. */
static void expect_same_future(small *s)
{
    vbss_scene *loaded = load(s->context, s->scene);
    uint32_t numbers[2][16], counts[2], added[2];
    vbss_scene *scenes[2] = {s->scene, loaded};
    vbss_scene_capsule capsule = {{0.3, 0.3, 0.3}, {0.31, 0.3, 0.3}, 1e-3};
    vbss_scene_rigid_config config;
    expect_ok(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_SCENE_RIGID_FREE;
    config.capsule_count = 1;
    config.capsules = &capsule;
    for (int i = 0; i < 2; i++) {
        expect_ok(vbss_scene_get_bodies(scenes[i], numbers[i], 16, &counts[i]));
        expect_ok(vbss_scene_step(scenes[i], 1e-3));
        expect_ok(vbss_scene_add_rigid(scenes[i], &config, &added[i]));
        expect_ok(vbss_scene_step(scenes[i], 1e-3));
    }
    assert_int_equal(counts[0], counts[1]);
    assert_memory_equal(numbers[0], numbers[1], counts[0] * sizeof(uint32_t));
    assert_int_equal(added[0], added[1]);
    assert_int_equal(hash_of(s->scene), hash_of(loaded));
    expect_ok(vbss_scene_destroy(loaded));
    expect_ok(vbss_scene_remove(s->scene, added[0]));
}

static void removed_bodies_leave_their_places_free(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    small_create(&s);
    uint32_t first =
        small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0, 0, 0), vec3_make(0.01, 0, 0), 1e-3);
    uint32_t line = small_thread(&s, vec3_make(0, 0.05, 0), vec3_make(0.1, 0.05, 0), 20, &thread);
    small_capsule(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0, 0.1, 0), vec3_make(0.01, 0.1, 0), 1e-3);
    expect_ok(vbss_scene_remove(s.scene, first));
    expect_same_future(&s);
    small_capsule(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0, 0.2, 0), vec3_make(0.01, 0.2, 0), 2e-3);
    expect_same_future(&s);
    expect_ok(vbss_scene_remove(s.scene, line));
    expect_same_future(&s);
    small_end(&s);
}

static uint32_t cuttable_thread(small *s, vbss_thread **thread)
{
    vbss_thread_config c;
    uint32_t body;
    expect_ok(vbss_thread_config_init(&c, sizeof c));
    c.segment_count = 30;
    c.length = 0.06;
    c.cut_capacity = 3;
    expect_ok(vbss_thread_create(s->context, &c, thread));
    expect_ok(vbss_scene_add_thread(s->scene, *thread, &body));
    return body;
}

static void removed_threads_leave_their_pieces(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint32_t first, second;
    small_begin(&s);
    s.config.thread_capacity = 8;
    small_create(&s);
    uint32_t line = cuttable_thread(&s, &thread);
    expect_ok(vbss_scene_cut_thread(s.scene, line, 0.02, &first));
    expect_same_future(&s);
    expect_ok(vbss_scene_cut_thread(s.scene, first, 0.02, &second));
    expect_ok(vbss_scene_remove(s.scene, first));
    expect_same_future(&s);
    expect_ok(vbss_scene_remove(s.scene, line));
    expect_same_future(&s);
    vbss_scene *loaded = load(s.context, s.scene);
    uint32_t pieces[2];
    expect_ok(vbss_scene_cut_thread(s.scene, second, 0.01, &pieces[0]));
    expect_ok(vbss_scene_cut_thread(loaded, second, 0.01, &pieces[1]));
    assert_int_equal(pieces[0], pieces[1]);
    assert_int_equal(hash_of(s.scene), hash_of(loaded));
    small_end(&s);
}

/* ---- whose the bodies are */

static void scene_destroys_bodies_it_was_loaded_with(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread, *own, *piece_handle;
    uint32_t piece, number;
    small_begin(&s);
    s.config.thread_capacity = 8;
    small_create(&s);
    uint32_t line = cuttable_thread(&s, &thread);
    small_drain(&s, NULL);
    vbss_scene *loaded = load(s.context, s.scene);
    expect_ok(vbss_scene_get_thread(loaded, line, &own));
    assert_ptr_not_equal(own, thread);
    expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_destroy(own));
    expect_ok(vbss_scene_cut_thread(loaded, line, 0.02, &piece));
    expect_ok(vbss_scene_get_thread(loaded, piece, &piece_handle));
    expect_ok(vbss_scene_remove(loaded, line));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_thread_destroy(own));
    expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_destroy(piece_handle));

    vbss_thread *hosts;
    expect_ok(vbss_thread_create(s.context, NULL, &hosts));
    expect_ok(vbss_scene_add_thread(loaded, hosts, &number));
    expect_ok(vbss_scene_destroy(loaded));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_thread_destroy(piece_handle));
    expect_ok(vbss_thread_destroy(hosts));
    expect_ok(vbss_scene_remove(s.scene, line));
    expect_ok(vbss_thread_destroy(thread));
    small_end(&s);
}

/* ---- memory */

static vbss_result attempt_load(vbss_context *context, void *user)
{
    const bytes *saved = user;
    vbss_scene *scene;
    vbss_result result = vbss_scene_load(context, saved->at, saved->count, &scene);
    if (result == VBSS_OK) {
        expect_ok(vbss_scene_destroy(scene));
    } else {
        assert_null(scene);
    }
    return result;
}

static void load_survives_every_failed_allocation(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint32_t piece;
    small_begin(&s);
    s.config.thread_capacity = 6;
    small_create(&s);
    uint32_t line = cuttable_thread(&s, &thread);
    expect_ok(vbss_scene_cut_thread(s.scene, line, 0.02, &piece));
    expect_ok(vbss_scene_remove(s.scene, line));
    small_thread(&s, vec3_make(0, 0.05, 0), vec3_make(0.1, 0.05, 0), 20, &thread);
    small_capsule(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0, 0.1, 0), vec3_make(0.01, 0.1, 0), 1e-3);
    bytes saved = save(s.scene);
    harness_fail_every_allocation(attempt_load, &saved);
    free(saved.at);
    small_end(&s);
}

int test_load(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(loaded_scene_continues_with_same_bits),
        harness_test(removed_bodies_leave_their_places_free),
        harness_test(removed_threads_leave_their_pieces),
        harness_test(scene_destroys_bodies_it_was_loaded_with),
        harness_test(load_survives_every_failed_allocation),
    };
    return cmocka_run_group_tests_name("scene.load", tests, NULL, NULL);
}
