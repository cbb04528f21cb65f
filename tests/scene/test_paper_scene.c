/* Method VBLAST of scenes: what is stopped and carried. Knots: test_paper_knots.c. */
#include "base/elementary.h"
#include "fixtures/step_events.h"
#include "scene/paper_fixture.h"

/* ---- two threads */

/* Hanging between two hands: an arc of a circle, 150 mm long, ends 140 mm apart at height y. */
static void hang(stage *s, int which, bool along_z, double y)
{
    vbss_thread_config c = paper_thread(SEGMENTS);
    double x[NODES][3], half = 0.6405, turn = 2.0 * half / SEGMENTS; /* sin(half) / half = 14/15 */
    double radius = 0.5 * 0.005 / vbss_sin(0.5 * turn);
    for (int i = 0; i < NODES; i++) {
        double angle = -half + turn * i, side = radius * vbss_sin(angle);
        x[i][0] = along_z ? 0.0 : side;
        x[i][1] = y - radius * (vbss_cos(angle) - vbss_cos(half));
        x[i][2] = along_z ? side : 0.0;
    }
    c.positions = x[0];
    add(s, which, &c);
}

static void move_hands(stage *s, int which, hands *h, vec3 displacement)
{
    for (int k = 0; k < 2; k++) {
        double to[3];
        h->at[k] = vec3_add(h->at[k], displacement);
        vec3_store(to, h->at[k]);
        expect_ok(vbss_thread_set_attachment_target(s->threads[which], h->ids[k], to, NULL));
    }
}

/* The second is above the first, and touches or does not. */
static void expect_above(stage *s, double smallest)
{
    uint32_t n, m;
    const vec3 *below = places(s->threads[0], &n), *above = places(s->threads[1], &m);
    vec3 up = between(below, n, above, m);
    assert_true(up.y > 0.0);
    assert_true(vec3_norm(up) >= smallest);
}

static double middle_z(stage *s)
{
    uint32_t n;
    return places(s->threads[0], &n)[SEGMENTS / 2].z;
}

/* Sine of the angle between the forces and the normals. */
static double tilt_of_forces(stage *s)
{
    vbss_view forces = view_of(s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    vbss_view normals = view_of(s, VBSS_SCENE_VIEW_CONTACT_NORMALS);
    double tilt = 0.0;
    for (uint64_t k = 0; k < forces.count; k++) {
        vec3 f = ((const vec3 *)forces.data)[k], n = ((const vec3 *)normals.data)[k];
        tilt = vbss_max(vec3_norm(vec3_cross(f, n)) / vec3_norm(f), tilt);
    }
    return tilt;
}

/* No friction: forces stand across both, and what is drawn along goes alone. */
static void crossing_threads_stop_and_slide(void **state)
{
    (void)state;
    const double h = 2e-4;
    double tilt = 0.0;
    stage s;
    begin(&s);
    make(&s);
    hang(&s, 0, false, 0.0);
    hang(&s, 1, true, 0.004);
    hold_ends(&s, 0);
    hands high = hold_ends(&s, 1);
    for (int i = 0; i < 2500; i++) {
        move_hands(&s, 1, &high, vec3_make(0.0, -0.02 * h, 0.0));
        expect_ok(vbss_scene_step(s.scene, h));
        expect_above(&s, 1.99 * RADIUS);
    }
    assert_true(statistics_of(&s).contacts > 0);
    double before = middle_z(&s);
    for (int i = 0; i < 2500; i++) {
        move_hands(&s, 1, &high, vec3_make(0.0, 0.0, 0.02 * h));
        expect_ok(vbss_scene_step(s.scene, h));
        expect_above(&s, 1.99 * RADIUS);
        tilt = vbss_max(tilt_of_forces(&s), tilt);
    }
    vbss_scene_statistics q = statistics_of(&s);
    expect_near(before, middle_z(&s), 2e-4); /* of 10 mm */
    assert_true(tilt < 0.05);
    assert_true(q.stretch_error < 1e-3);
    vbss_baseline_statistics own = baseline_statistics_of(&s);
    assert_true(own.tested_pairs > 0 && own.last_candidates > 0);
    /* One pass in free flight; what rests asks for one more, and rounding for none. */
    assert_true(own.passes > q.steps && 5 * own.passes < 13 * q.steps);
    end(&s);
}

/* The steps of the paper are long: the thread that is lowered is held up a frame at a time, and stretched. */
static void long_steps_stop_thread_but_stretch_it(void **state)
{
    (void)state;
    stage s;
    begin(&s);
    make(&s);
    hang(&s, 0, false, 0.0);
    hang(&s, 1, true, 0.004);
    hold_ends(&s, 0);
    hands high = hold_ends(&s, 1);
    for (int i = 0; i < 75; i++) {
        move_hands(&s, 1, &high, vec3_make(0.0, -0.02 * FRAME, 0.0));
        expect_ok(vbss_scene_step(s.scene, FRAME));
        expect_above(&s, 1.99 * RADIUS);
    }
    vbss_scene_statistics q = statistics_of(&s);
    assert_true(q.stretch_error > 0.01 && q.stretch_error < 1.0);
    end(&s);
}

/* ---- a tool */

/* What the hand carries is the thread's weight; a coupled tool goes where it is told like a driven one. */
static void tool_carries_and_lifts_thread(void **state)
{
    (void)state;
    const vbss_scene_rigid_kind kinds[] = {VBSS_SCENE_RIGID_DRIVEN, VBSS_SCENE_RIGID_COUPLED};
    for (int k = 0; k < 2; k++) {
        stage s;
        begin(&s);
        make(&s);
        vec3 axis[2] = {vec3_make(0, 0, -0.02), vec3_make(0, 0, 0.02)};
        uint32_t tool = add_capsule(s.scene, kinds[k], axis[0], axis[1], 2.5e-3);
        place_over(&s, 0.003);
        double touching = 2.5e-3 + RADIUS, weight = 9.81 * 6.4e-5 * 0.15, mean = 0.0;
        for (int i = 0; i < 600; i++) {
            expect_ok(vbss_scene_step(s.scene, 1e-3));
            assert_true(distance_to_axis(&s, axis[0], axis[1]) > 0.999 * touching);
            mean += i >= 400 ? rigid_of(&s, tool).hand_force[1] / 200.0 : 0.0;
        }
        expect_near(-weight, mean, 0.05 * weight);
        for (int i = 0; i < 300; i++) {
            vec3 displacement = vec3_make(0.0, 5e-5, 0.0);
            axis[0] = vec3_add(axis[0], displacement);
            axis[1] = vec3_add(axis[1], displacement);
            double to[3] = {0.0, axis[0].y, 0.0};
            expect_ok(vbss_scene_set_rigid_target(s.scene, tool, to, NULL));
            expect_ok(vbss_scene_step(s.scene, 1e-3));
            assert_true(distance_to_axis(&s, axis[0], axis[1]) > 0.99 * touching);
            expect_same_bits(axis[0].y, rigid_of(&s, tool).position[1]);
            expect_near(0.05, rigid_of(&s, tool).velocity[1], 1e-12);
        }
        assert_true(distance_to_axis(&s, axis[0], axis[1]) < 1.5 * touching);
        end(&s);
    }
}

/* ---- the floor */

static void thread_falls_and_rests_on_floor(void **state)
{
    (void)state;
    stage s;
    uint32_t n;
    begin(&s);
    s.config.floor = 1;
    s.config.floor_height = 0.002;
    make(&s);
    place_over(&s, 0.005);
    int touches = 0, parts = 0;
    for (int i = 0; i < 400; i++) {
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        const step_events events = step_events_of(s.scene);
        for (uint32_t k = 0; k < events.count; k++) {
            const vbss_scene_event *e = &events.of[k];
            assert_true(e->body_a == s.bodies[0] && e->body_b == 0);
            touches += e->kind == VBSS_SCENE_EVENT_TOUCH;
            parts += e->kind == VBSS_SCENE_EVENT_PART;
        }
    }
    const vec3 *x = places(s.threads[0], &n);
    for (uint32_t i = 0; i < n; i++) {
        expect_near(0.002 + RADIUS, x[i].y, 1e-9);
    }
    assert_true(touches == parts + 1);
    assert_int_equal(n, statistics_of(&s).contacts);
    const uint32_t *first = view_of(&s, VBSS_SCENE_VIEW_CONTACTS).data;
    assert_int_equal(VBSS_SCENE_CONTACT_NODE_FLOOR, first[0]);
    assert_int_equal(1, first[7]); /* the second row's node */
    end(&s);
}

int test_paper_scene(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(crossing_threads_stop_and_slide),
        harness_test(long_steps_stop_thread_but_stretch_it),
        harness_test(tool_carries_and_lifts_thread),
        harness_test(thread_falls_and_rests_on_floor),
    };
    return cmocka_run_group_tests_name("scene.paper_scene", tests, NULL, NULL);
}
