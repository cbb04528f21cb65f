/* Holes that a host makes: what is refused, and changes nothing; how many there may be; what goes with a thread or a drain; a
 * state from the middle; one thread in four holes. */
#include "scene/stitch_case.h"

#include <stdlib.h>

#include "drain/drain.h"

static stitch_case c;

static const double corner[3] = {1.0, 0.0, 0.0};

/* ---- refusals */

typedef struct asked {
    uint32_t body;
    double arc;
    uint32_t drain, triangle;
    const double *weights;
} asked;

static void expect_refused(vbss_result wanted, asked a)
{
    uint32_t id = 77;
    uint64_t before = small_hash(&c.s);
    expect_result(wanted, vbss_scene_make_hole(c.s.scene, a.body, a.arc, a.drain, a.triangle,
                                               a.weights, &id));
    assert_int_equal(id, 77);
    assert_true(before == small_hash(&c.s));
}

static void impossible_hole_is_rejected_and_changes_nothing(void **state)
{
    (void)state;
    static const double below[3] = {-0.1, 1.0, 0.1}, more[3] = {0.5, 0.5, 0.5};
    static const double none[3] = {(double)NAN, 0.5, 0.5}, over[3] = {1.1, 0.0, -0.1};
    vbss_scene_hole hole;
    stitch_case_open(&c, 0);
    assert_true(stitch_case_hole(&c, 0, &hole));
    const asked good = {c.stitch.thread_body, hole.arc_length, c.stitch.drain_body, hole.triangle,
                        hole.weights};
    uint32_t stick = small_stick(&c.s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.1, 0.0),
                                 vec3_make(0.0, 0.0, 1e-3), 1e-3);
    vbss_thread_config pair = c.options.thread;
    vbss_thread *two;
    uint32_t two_body;
    pair.segment_count = 1;
    pair.cut_capacity = 0;
    pair.start[1] = 0.2;
    expect_ok(vbss_thread_create(c.s.context, &pair, &two));
    expect_ok(vbss_scene_add_thread(c.s.scene, two, &two_body));
    asked a = good;
    const uint32_t bodies[] = {0, 4000, c.stitch.drain_body, stick, two_body};
    for (int i = 0; i < 5; i++) {
        a.body = bodies[i];
        expect_refused(i < 2 ? VBSS_ERROR_NOT_FOUND : VBSS_ERROR_INCOMPATIBLE, a);
    }
    a = good;
    const uint32_t drains[] = {0, 4000, c.stitch.thread_body, stick};
    for (int i = 0; i < 4; i++) {
        a.drain = drains[i];
        expect_refused(i < 2 ? VBSS_ERROR_NOT_FOUND : VBSS_ERROR_INCOMPATIBLE, a);
    }
    a = good;
    a.triangle = 240;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, a);
    a = good;
    const double arcs[] = {-1e-6, 1.0};
    for (int i = 0; i < 2; i++) {
        a.arc = arcs[i];
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, a);
    }
    a.arc = (double)NAN;
    expect_refused(VBSS_ERROR_NOT_FINITE, a);
    a = good;
    a.weights = NULL;
    expect_refused(VBSS_ERROR_NULL_ARGUMENT, a);
    a.weights = none;
    expect_refused(VBSS_ERROR_NOT_FINITE, a);
    const double *const wrong[] = {below, more, over};
    for (int i = 0; i < 3; i++) {
        a.weights = wrong[i];
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, a);
    }
    a = good;
    a.weights = corner;
    a.triangle = 0; /* far from the thread */
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, a);
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_make_hole(NULL, 1, 0.0, 1, 0, corner, NULL));
    stitch_case_end(&c);
}

/* A second hole at the place of the first would double its friction. */
static void hole_at_the_place_of_a_hole_is_refused(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    c.options.scene.hole_capacity = 8;
    stitch_case_make(&c);
    uint32_t count = 0;
    vbss_scene_hole hole;
    while (vbss_scene_get_hole(c.s.scene, count, &hole, sizeof hole) == VBSS_OK) {
        count++;
    }
    assert_true(count > 0);
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_scene_get_hole(c.s.scene, i, &hole, sizeof hole));
        const double shift = 1e-4;
        for (int k = -1; k <= 1; k++) {
            expect_refused(VBSS_ERROR_IN_USE, (asked){hole.thread, hole.arc_length + k * shift,
                                                      hole.drain, hole.triangle, hole.weights});
        }
    }
    stitch_case_end(&c);
}

static void hole_count_is_limited_by_capacity(void **state)
{
    (void)state;
    vbss_scene_hole hole;
    stitch_case_begin(&c);
    c.options.scene.hole_capacity = 2;
    stitch_case_make(&c);
    assert_true(stitch_case_hole(&c, 0, &hole));
    const asked a = {c.stitch.thread_body, hole.arc_length, c.stitch.drain_body, hole.triangle,
                     hole.weights};
    expect_refused(VBSS_ERROR_CAPACITY, a);
    stitch_case_wait(&c, 20);
    stitch_case_finish(&c, "full", 0.05);
}

/* ---- what goes with a body */

static void removed_thread_removes_holes(void **state)
{
    (void)state;
    stitch_case_open(&c, 0);
    stitch_case_wait(&c, 10);
    stitch_case_drop(&c, 0);
    stitch_case_drop(&c, 1);
    expect_ok(vbss_scene_remove(c.s.scene, c.stitch.thread_body));
    stitch_case_wait(&c, 20);
    assert_int_equal(c.watch.holes, 0);
    stitch_case_finish(&c, "thread removed", 0.05);
}

static void removed_drain_removes_holes(void **state)
{
    (void)state;
    vbss_scene_hole hole;
    stitch_case_open(&c, 0);
    stitch_case_wait(&c, 10);
    expect_ok(vbss_scene_remove(c.s.scene, c.stitch.drain_body));
    c.stitch.drain = NULL;
    assert_false(stitch_case_hole(&c, 0, &hole) || stitch_case_hole(&c, 1, &hole));
    stitch_case_wait(&c, 20);
    stitch_case_finish(&c, "drain removed", 0.05);
}

/* ---- a state */

static const vec3 slide = {0.0, 0.0, 0.2e-3};

static void tug(uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        stitch_case_shift(&c, 1, slide);
        stitch_case_step(&c);
    }
}

/* The thread slides on in its holes after it as before it, and leaves one. */
static void restored_scene_continues_bit_equal(void **state)
{
    (void)state;
    stitch_case_open(&c, 0);
    tug(40);
    small_state saved = small_save(&c.s);
    stitch_case_hand hands[2] = {c.hands[0], c.hands[1]};
    stitch_case_drop(&c, 0);
    tug(160);
    uint64_t hash = small_hash(&c.s);
    expect_ok(vbss_scene_restore(c.s.scene, saved.bytes, saved.count));
    memcpy(c.hands, hands, sizeof hands);
    stitch_case_drop(&c, 0);
    tug(160);
    assert_true(hash == small_hash(&c.s));
    free(saved.bytes);
    stitch_case_end(&c);
}

/* ---- more holes */

/* Two more threads, straight through both walls beside the stitch. */
static void several_threads_share_one_drain(void **state)
{
    (void)state;
    drain_object *d;
    stitch_case_begin(&c);
    c.options.thread.cut_capacity = 0;
    stitch_case_make(&c);
    expect_ok(vbss_drain_open(c.stitch.drain, &d));
    for (int k = 0; k < 2; k++) {
        double x = k == 0 ? -7e-3 : 7e-3, length = 30e-3, y = 1e-3;
        vbss_thread_config t = c.options.thread;
        vbss_thread *thread;
        uint32_t body, made = 0;
        t.segment_count = 60;
        t.length = length;
        vec3_store(t.start, vec3_make(x, y, -0.5 * length));
        vec3_store(t.direction, vec3_make(0.0, 0.0, 1.0));
        expect_ok(vbss_thread_create(c.s.context, &t, &thread));
        expect_ok(vbss_scene_add_thread(c.s.scene, thread, &body));
        for (uint32_t i = 0; i < d->mesh.triangle_count; i++) {
            const uint32_t *node = d->mesh.triangles[i];
            vec3 a = d->x[node[0]], e1 = vec3_sub(d->x[node[1]], a),
                 e2 = vec3_sub(d->x[node[2]], a);
            double size = e1.x * e2.y - e1.y * e2.x, px = x - a.x, py = y - a.y; /* seen along z */
            double v = (px * e2.y - py * e2.x) / size, w = (e1.x * py - e1.y * px) / size;
            if (fabs(size) > 1e-12 && v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
                const double weights[3] = {1.0 - v - w, v, w};
                double z = a.z + v * e1.z + w * e2.z;
                expect_ok(vbss_scene_make_hole(c.s.scene, body, z + 0.5 * length,
                                               c.stitch.drain_body, i, weights, NULL));
                made++;
            }
        }
        assert_int_equal(made, 2);
    }
    stitch_case_reckon(&c);
    for (int i = 0; i < 150; i++) {
        stitch_case_shift(&c, 0, vec3_make(0.0, 0.0, 0.05e-3)); /* it follows the other */
        stitch_case_shift(&c, 1, vec3_make(0.0, 0.0, 0.05e-3));
        stitch_case_step(&c);
    }
    assert_int_equal(c.watch.holes, 6);
    assert_int_equal(c.watch.crossings, 6);
    stitch_case_finish(&c, "three threads", 0.05);
}

/* A piece of one segment has no curve that a hole could slide along. */
static void single_segment_piece_leaves_hole(void **state)
{
    (void)state;
    vbss_scene_hole hole;
    vbss_view nodes;
    stitch_case_begin(&c);
    c.options.segment = 1.8e-3; /* no node within 0.2 mm of the hole, where cuts are made */
    stitch_case_make(&c);
    assert_true(stitch_case_hole(&c, 0, &hole));
    const double beside = 0.02e-3;
    const uint32_t thread = c.stitch.thread_body;
    assert_int_not_equal(stitch_case_cut(&c, thread, hole.arc_length + beside), 0);
    assert_true(stitch_case_hole(&c, 0, &hole));
    assert_int_equal(hole.thread, thread);
    assert_int_not_equal(stitch_case_cut(&c, thread, hole.arc_length - beside), 0);
    expect_ok(
        vbss_thread_get_view(c.stitch.thread, VBSS_THREAD_VIEW_POSITIONS, &nodes, sizeof nodes));
    assert_true(nodes.count > 2);
    assert_false(stitch_case_hole(&c, 0, &hole));
    assert_true(stitch_case_hole(&c, 1, &hole));
    stitch_case_wait(&c, 20);
    assert_int_equal(c.watch.holes, 1);
    stitch_case_end(&c);
}

int test_stitch_rules(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impossible_hole_is_rejected_and_changes_nothing),
        cmocka_unit_test(hole_at_the_place_of_a_hole_is_refused),
        cmocka_unit_test(hole_count_is_limited_by_capacity),
        cmocka_unit_test(removed_thread_removes_holes),
        cmocka_unit_test(removed_drain_removes_holes),
        cmocka_unit_test(restored_scene_continues_bit_equal),
        cmocka_unit_test(several_threads_share_one_drain),
        cmocka_unit_test(single_segment_piece_leaves_hole),
    };
    return cmocka_run_group_tests_name("scene.stitch_rules", tests, NULL, NULL);
}
