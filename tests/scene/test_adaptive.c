/* Threads of a scene that adapt their meshes: what a knot gains, what is left alone, what does not fit. */
#include <math.h>

#include "oracle/knot_type.h"
#include "scene/mesh_rig.h"
#include "fixtures/contact_scenes.h"

/* ---- knots */

typedef struct tied {
    vbss_context *context;
    contact_scene scene;
    thread_object *thread;
} tied;

typedef struct mesh {
    vbss_thread_mesh kind;
    double finest, coarsest; /* at first */
    uint32_t nodes;
} mesh;

static void tie(tied *k, const mesh *m, vbss_thread_bending bending)
{
    contact_scene_options o;
    expect_ok(vbss_context_create(NULL, &k->context));
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_PULLED));
    o.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    o.knot.kind = KNOT_DOUBLE_OVERHAND;
    o.knot.size = 2e-3;
    o.knot.length = 0.15;
    o.knot.finest = m->finest;
    o.knot.coarsest = m->coarsest;
    o.pull = (contact_pull){0.1, 2.0, 0.0};
    o.thread.bending = bending;
    o.thread.mesh = m->kind;
    o.thread.node_capacity = m->nodes;
    expect_ok(contact_scene_create(k->context, &o, &k->scene));
    k->thread = mesh_thread(k->scene.threads[0]);
}

/* Length that the knot keeps when it has borne the load for a while, m. */
static double taken_up(tied *k)
{
    for (int i = 0; i < 3000 && contact_scene_pull_felt(&k->scene) < 1.99; i++) {
        expect_ok(contact_scene_step(&k->scene, 1e-3));
    }
    for (int i = 0; i < 200; i++) {
        expect_ok(contact_scene_step(&k->scene, 1e-3));
    }
    assert_true(contact_scene_pull_felt(&k->scene) >= 1.99);
    knot_type found, right = knot_type_of_kind(KNOT_DOUBLE_OVERHAND, false);
    const thread_object *t = k->thread;
    assert_true(knot_type_of(t->now.x, t->node_count, &found) && knot_type_same(found, right));
    uint32_t last = t->node_count - 1;
    return vbss_thread_arc_length(t, last) - vec3_distance(t->now.x[0], t->now.x[last]);
}

static void coarse_knot_takes_up_as_much_as_fine(void **state)
{
    (void)state;
    static const mesh fine = {VBSS_THREAD_MESH_FIXED, 0.3e-3, 2e-3, 0};
    static const mesh coarse = {VBSS_THREAD_MESH_FIXED, 1.2e-3, 1.2e-3, 0};
    static const mesh adaptive = {VBSS_THREAD_MESH_ADAPTIVE, 1.2e-3, 1.2e-3, 500};
    for (int bending = 0; bending < 2; bending++) {
        tied k[3];
        tie(&k[0], &fine, bending);
        tie(&k[1], &coarse, bending);
        tie(&k[2], &adaptive, bending);
        double right = taken_up(&k[0]), wrong = taken_up(&k[1]), found = taken_up(&k[2]);
        assert_true(wrong > 1.3 * right); /* there is something to gain */
        expect_near(1.0, found / right, 0.04);
        vbss_thread_statistics s = mesh_statistics(k[2].scene.threads[0]);
        assert_true(s.refined > 50 && s.coarsened > 10 && s.refused_capacity == 0);
        assert_true(s.most_nodes < 400 && s.nodes == k[2].thread->node_count);
        assert_true(mesh_ratio(k[2].thread) <= 2.0 * REMESH_MAX_LENGTH_RATIO);
        for (int i = 0; i < 3; i++) {
            vbss_context_destroy(k[i].context);
        }
    }
}

static void rejected_refinements_are_counted(void **state)
{
    (void)state;
    static const mesh full = {VBSS_THREAD_MESH_ADAPTIVE, 1.2e-3, 1.2e-3, 140};
    tied k;
    tie(&k, &full, VBSS_THREAD_BENDING_SPLINE);
    for (int i = 0; i < 300; i++) {
        expect_ok(contact_scene_step(&k.scene, 1e-3));
        assert_true(k.thread->node_count <= 140);
    }
    vbss_thread_statistics s = mesh_statistics(k.scene.threads[0]);
    assert_int_equal(s.most_nodes, 140);
    assert_true(s.refused_capacity > 0);
    vbss_context_destroy(k.context);

    small one;
    small_begin(&one);
    one.config.node_capacity = 60;
    small_create(&one);
    one.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    one.thread.node_capacity = 61;
    one.thread.segment_count = 20;
    vbss_thread *thread;
    uint32_t body;
    expect_ok(vbss_thread_create(one.context, &one.thread, &thread));
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_thread(one.scene, thread, &body));
    expect_ok(vbss_thread_destroy(thread));
    one.thread.node_capacity = 60;
    expect_ok(vbss_thread_create(one.context, &one.thread, &thread));
    expect_ok(vbss_scene_add_thread(one.scene, thread, &body));
    small_end(&one);
}

/* ---- what is near */

/* A strand comes down beside another in the middle; both are 40 mm long. */
static void contact_refines_and_separation_coarsens(void **state)
{
    (void)state;
    small s;
    vbss_thread *low, *high;
    small_begin(&s);
    s.config.node_capacity = 500;
    small_create(&s);
    s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    s.thread.node_capacity = 200;
    uint32_t a = small_thread(&s, vec3_zero(), vec3_make(0.04, 0.0, 0.0), 20, &low);
    uint32_t b =
        small_thread(&s, vec3_make(0.02, 5e-3, -0.02), vec3_make(0.02, 5e-3, 0.02), 20, &high);
    small_pin_ends(&s, a, 21);
    (void)b;
    vbss_thread_attachment pin;
    uint32_t ids[2];
    expect_ok(vbss_thread_attachment_init(&pin, sizeof pin));
    for (int k = 0; k < 2; k++) {
        pin.node = k == 0 ? 0 : 20;
        vec3_store(pin.position, vec3_make(0.02, 5e-3, k == 0 ? -0.02 : 0.02));
        expect_ok(vbss_thread_attach(high, &pin, &ids[k]));
    }
    for (int variant = 0; variant < 2; variant++) {
        for (int i = 0; i <= 150; i++) {
            double y = variant == 0 ? 5e-3 - 4e-3 * i / 150.0 : 1e-3 + 9e-3 * i / 150.0;
            for (int k = 0; k < 2; k++) {
                double to[3] = {0.02, y, k == 0 ? -0.02 : 0.02};
                expect_ok(vbss_thread_set_attachment_target(high, ids[k], to, NULL));
            }
            small_steps(&s, 1, 1e-3);
        }
        small_steps(&s, 60, 1e-3);
        cut_expect_sound(small_object(&s));
        const thread_object *t = mesh_thread(low), *u = mesh_thread(high);
        if (variant == 0) { /* in the middle only */
            assert_true(t->node_count > 26 && t->node_count < 60);
            assert_true(u->node_count > 26 && u->node_count < 60);
            expect_near(2e-3, t->rest[0], 1e-15);
            double finest = 1.0;
            for (uint32_t i = 0; i + 1 < t->node_count; i++) {
                finest = fmin(finest, t->rest[i]);
            }
            expect_near(0.25e-3, finest, 1e-15);
        } else {
            /* Halves of different segments may have become one: then two are left over. */
            assert_true(t->node_count <= 23);
            assert_true(u->node_count <= 23);
        }
        assert_true(mesh_ratio(t) <= REMESH_MAX_LENGTH_RATIO &&
                    mesh_ratio(u) <= REMESH_MAX_LENGTH_RATIO);
    }
    small_end(&s);
}

static void refinement_follows_tool_radius_and_ignores_floor(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -1e-3;
    small_create(&s);
    s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    s.thread.node_capacity = 150;
    (void)small_thread(&s, vec3_zero(), vec3_make(0.04, 0.0, 0.0), 20, &thread);
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.021, 3e-3, 0.0),
                      vec3_make(0.0, 0.0, 0.01), 2.2e-3);
    small_steps(&s, 60, 1e-3);
    const thread_object *t = mesh_thread(thread);
    double finest = 1.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        finest = fmin(finest, t->rest[i]);
    }
    expect_near(0.5e-3, finest, 1e-15); /* 0.55 mm would do */
    expect_near(2e-3, t->rest[0], 1e-15);
    expect_near(2e-3, t->rest[t->node_count - 2], 1e-15);
    small_end(&s);
}

int test_adaptive(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coarse_knot_takes_up_as_much_as_fine),
        cmocka_unit_test(rejected_refinements_are_counted),
        cmocka_unit_test(contact_refines_and_separation_coarsens),
        cmocka_unit_test(refinement_follows_tool_radius_and_ignores_floor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
