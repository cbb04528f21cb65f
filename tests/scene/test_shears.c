/* Blades that close: what they cut, where it lies, and what they leave alone. Hard cases: test_shears_worst,
 * test_shears_throws. */
#include "scene/shears_rig.h"

/* Far more than rounding of events, to whole micrometres. */
#define TOLERANCE 1e-6

static void expect_cut_at(const shears_rig *r, double arc, double tolerance)
{
    const scene_object *o = small_object(&r->tools.s);
    assert_int_equal(r->cuts, 1);
    assert_int_equal(r->first.body_a, r->tools.body);
    expect_near(arc, r->first.arc_length, tolerance + TOLERANCE);
    expect_near(arc, cut_length(cut_thread(o, r->tools.body)), tolerance + TOLERANCE);
}

/* How far from the plane of the blades the thread's new end is. */
static double off_the_plane(const shears_rig *r)
{
    vbss_grasper_state tool = tools_state(&r->tools, 0); /* the thread has pushed it, too */
    const double *q = tool.orientation;
    pose at = pose_make(vec3_load(tool.position), quat_make(q[0], q[1], q[2], q[3]));
    return pose_apply_inverse(at, small_node(r->tools.thread, cut_nodes(r->tools.thread) - 1)).y;
}

/* ---- where it lies */

/* Between the ends of the whole range of a straight thread; blades that are turned cut where their plane is. */
static void thread_is_cut_in_place(void **state)
{
    (void)state;
    const double places[] = {-14.2e-3, -7.31e-3, -0.13e-3, 0.0, 5.26e-3, 14.4e-3};
    for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
        for (int method = 0; method < 2; method++) {
            /* By method VBLAST turned blades shake the short end beside a pin. */
            bool short_end = method == VBSS_METHOD_VBLAST && fabs(places[k]) > 0.01;
            for (int turned = 0; turned < (short_end ? 1 : 3); turned++) {
                shears_rig r;
                shears_begin(&r, method); /* turned blades shake a soft thread too much */
                small_create(&r.tools.s);
                shears_line(&r, true);
                shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, places[k], 0.5 * turned);
                assert_true(shears_cut(&r, 0));
                /* Turned blades push it along a little: it is cut where it is by then, in their plane. */
                expect_cut_at(&r, 0.015 + places[k], turned > 0 ? 0.09e-3 : 0.0);
                expect_near(0.0, off_the_plane(&r), 0.02e-3);
                shears_steps(&r, 100);
                assert_int_equal(r.cuts, 1);
                shears_expect_shut(&r, 0);
                shears_end(&r);
            }
        }
    }
}

/* A thread that rises through the plane, as chords: the share of the way is the share of the arc. */
static void slanting_thread_is_cut_in_blade_plane(void **state)
{
    (void)state;
    for (int k = 0; k < 5; k++) {
        for (int method = 0; method < 2; method++) {
            shears_rig r;
            vec3 nodes[41];
            double rise = -1.0 + 0.5 * k, plane = 0.37e-3 + 0.4e-3 * k;
            for (int i = 0; i <= 40; i++) {
                double y = -5e-3 + 0.25e-3 * i;
                nodes[i] = vec3_make(0.0, y, 0.5 * rise * y);
            }
            shears_begin_scene(&r, method);
            shears_laid(&r, nodes, 41);
            small_pin_ends(&r.tools.s, r.tools.body, 41);
            shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, plane, 0.0);
            assert_true(shears_cut(&r, 0));
            expect_cut_at(&r, (plane + 5e-3) * sqrt(1.0 + 0.25 * rise * rise), 0.02e-3);
            shears_end(&r);
        }
    }
}

/* A blade comes first to a thread beside the middle, and takes it along: cut where it then lies. */
static void off_centre_thread_is_dragged_and_cut(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        shears_rig r;
        double tip[3] = {side * 1.5e-3, 3.21e-3, -SHEARS_BELOW};
        shears_begin_scene(&r, VBSS_METHOD_IMPLICIT);
        shears_line(&r, true);
        shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, 3.21e-3, 0.0);
        tools_move(&r.tools, 0, vec3_load(tip));
        shears_steps(&r, 100);
        assert_true(shears_cut(&r, 0));
        /* Stretched to two sides of a triangle, which it slides along, but not by much. */
        expect_cut_at(&r, 18.21e-3, 0.1e-3);
        shears_steps(&r, 100);
        shears_expect_shut(&r, 0);
        shears_end(&r);
    }
}

/* A cut on a node adds none: both parts have it; nearer than a hundredth of a segment it snaps. */
static void cut_at_node_splits_node(void **state)
{
    (void)state;
    const double beside[] = {0.0, 4e-6, -4e-6, 0.1e-3};
    for (int k = 0; k < 4; k++) {
        for (int method = 0; method < 2; method++) {
            shears_rig r;
            vbss_thread *piece;
            shears_begin_scene(&r, method);
            shears_line(&r, true);
            shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, 4.0 * SHEARS_SEGMENT + beside[k], 0.0);
            assert_true(shears_cut(&r, 0));
            expect_ok(vbss_scene_get_thread(r.tools.s.scene, r.first.body_b, &piece));
            assert_int_equal(cut_nodes(r.tools.thread), k < 3 ? 35 : 36);
            assert_int_equal(cut_nodes(piece), 27);
            expect_near(2e-3 + beside[k], small_node(piece, 0).y, 6e-6);
            shears_steps(&r, 100);
            shears_expect_shut(&r, 0);
            shears_end(&r);
        }
    }
}

/* ---- what is not cut */

static void blades_close_on_nothing(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        shears_rig r;
        shears_begin_scene(&r, method);
        shears_line(&r, true);
        shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, 17e-3, 0.0); /* beyond the thread's end */
        double angle = r.tools.config.shears_opening, largest = 1e-3 * r.tools.config.jaw_speed;
        uint64_t nodes = cut_nodes(r.tools.thread);
        tools_open(&r.tools, 0, 0.0);
        for (int i = 0; i < 60; i++) {
            shears_steps(&r, 1);
            angle = vbss_max(angle - largest, 0.0);
            expect_near(angle, tools_state(&r.tools, 0).jaw_angle, 1e-14);
            assert_int_equal(step_events_of(r.tools.s.scene).count, 0);
        }
        assert_int_equal(cut_nodes(r.tools.thread), nodes);
        expect_near(0.0, vec3_norm(vec3_load(tools_state(&r.tools, 0).hand_force)), 1e-9);
        expect_near(0.0, tools_state(&r.tools, 0).pressure, 0.0);
        shears_expect_shut(&r, 0);
        shears_end(&r);
    }
}

/* Less than the thread is thick is not cut off: blades close, whatever lies between them. */
static void cut_at_end_does_nothing_and_blades_close(void **state)
{
    (void)state;
    for (int k = -10; k <= 10; k += 2) {
        for (int side = -1; side <= 1; side += 2) {
            for (int method = 0; method < 2; method++) {
                shears_rig r;
                double off = 0.04e-3 * k; /* of the blades, from the end outward */
                shears_begin_scene(&r, method);
                shears_line(&r, false);
                double thick = 2.0 * r.tools.s.thread.radius;
                shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, side * (0.015 + off), 0.0);
                assert_int_equal(shears_cut(&r, 0), off < -thick);
                shears_steps(&r, 100);
                assert_int_equal(r.cuts, off < -thick);
                assert_int_equal(r.failed_cuts, 0);
                shears_expect_shut(&r, 0);
                shears_end(&r);
            }
        }
    }
}

/* Jaws that are still, or open, cut nothing, wherever they go. */
static void only_closing_cuts(void **state)
{
    (void)state;
    shears_rig r;
    shears_begin_scene(&r, VBSS_METHOD_IMPLICIT);
    shears_line(&r, true);
    shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, 0.3e-3, 0.0);
    tools_open(&r.tools, 0, 0.4);
    shears_steps(&r, 100);
    for (int i = 1; i <= 100; i++) {
        tools_move(&r.tools, 0, vec3_make(0.0, 0.3e-3 + 4e-5 * i, -SHEARS_BELOW));
        tools_open(&r.tools, 0, 0.4 + 6e-3 * i);
        shears_steps(&r, 1);
    }
    assert_int_equal(r.cuts + r.failed_cuts, 0);
    assert_true(shears_cut(&r, 0));
    shears_end(&r);
}

/* ---- two strands */

/* There and back, `apart` from each other along the shaft: nodes evenly along two lines and a half circle. */
static void there_and_back(vec3 nodes[81], double apart)
{
    double radius = 0.5 * apart, turn = 3.141592653589793 * radius, straight = 0.5 * (0.04 - turn);
    for (int i = 0; i <= 80; i++) {
        double arc = 0.5e-3 * i, angle = (arc - straight) / radius;
        if (arc < straight) {
            nodes[i] = vec3_make(0.0, arc - 0.01, 0.0);
        } else if (arc > straight + turn) {
            nodes[i] = vec3_make(0.0, 2.0 * straight + turn - arc - 0.01, apart);
        } else {
            nodes[i] =
                vec3_make(0.0, straight - 0.01 + radius * sin(angle), radius * (1.0 - cos(angle)));
        }
    }
}

/* The far one first, so that the arc lengths of both are those of the whole. */
static void two_strands_are_cut_in_one_step(void **state)
{
    (void)state;
    const double apart[] = {0.3e-3, 0.7e-3, 1.5e-3, 3e-3};
    for (int k = 0; k < 4; k++) {
        for (int method = 0; method < 2; method++) {
            shears_rig r;
            vec3 nodes[81];
            there_and_back(nodes, apart[k]);
            shears_begin_scene(&r, method);
            shears_laid(&r, nodes, 81);
            const scene_object *o = small_object(&r.tools.s);
            double length = cut_length(cut_thread(o, r.tools.body));
            shears_tool(&r, VBSS_GRASPER_KIND_SHEARS, -2.23e-3, 0.0);
            assert_true(shears_cut(&r, 0));
            assert_int_equal(r.cuts, 2);
            uint32_t far = r.tools.bodies[0] + 1, middle = r.tools.bodies[0] + 2;
            assert_true(r.first.body_a == r.tools.body && r.first.body_b == far);
            assert_true(r.last.body_a == r.tools.body && r.last.body_b == middle);
            double first = -2.23e-3 + 0.01;
            expect_near(length - first, r.first.arc_length, 0.02e-3);
            expect_near(first, r.last.arc_length, 0.02e-3);
            expect_near(first, cut_length(cut_thread(o, r.tools.body)), 0.02e-3);
            expect_near(first, cut_length(cut_thread(o, far)), 0.02e-3);
            expect_near(length - 2.0 * first, cut_length(cut_thread(o, middle)), 0.04e-3);
            expect_near(length,
                        cut_length(cut_thread(o, r.tools.body)) + cut_length(cut_thread(o, far)) +
                            cut_length(cut_thread(o, middle)),
                        1e-12);
            shears_steps(&r, 100);
            assert_int_equal(r.cuts, 2);
            shears_expect_shut(&r, 0);
            shears_end(&r);
        }
    }
}

/* ---- exchange */

static uint32_t exchanges(const shears_rig *r, vbss_scene_event_kind kind, vbss_scene_event *event)
{
    return small_events(&r->tools.s, kind, event);
}

/* A driver holds, lets go, leaves the work volume, comes back as shears and cuts. */
static void driver_exchanged_for_shears_cuts(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        shears_rig r;
        vbss_scene_event event;
        shears_begin(&r, method);
        r.tools.config.exchange_distance = 0.06;
        r.tools.config.shears_opening = 0.3;
        r.tools.s.config.contact_capacity = 1024;
        small_create(&r.tools.s);
        shears_line(&r, true);
        shears_tool(&r, VBSS_GRASPER_KIND_NEEDLE_DRIVER, 3.3e-3, 0.0);
        if (method == VBSS_METHOD_VBLAST) { /* which takes what is near the tip */
            tools_move(&r.tools, 0, vec3_make(0.0, 3.3e-3, 0.8e-3));
        }
        shears_steps(&r, 50);
        tools_open(&r.tools, 0, 0.0);
        shears_steps(&r, 100);
        assert_int_equal(tools_state(&r.tools, 0).grasp_count, 1);
        expect_ok(vbss_grasper_exchange(r.tools.tools[0], VBSS_GRASPER_KIND_SHEARS));
        shears_steps(&r, 1); /* it holds something, and is within */
        assert_int_equal(exchanges(&r, VBSS_SCENE_EVENT_NOT_EXCHANGED, &event), 1);
        assert_true(event.body_a == r.tools.bodies[0] && event.id == VBSS_GRASPER_KIND_SHEARS);
        shears_steps(&r, 10); /* what was refused is forgotten */
        assert_int_equal(exchanges(&r, VBSS_SCENE_EVENT_NOT_EXCHANGED, &event), 0);
        assert_int_equal(tools_state(&r.tools, 0).kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER);
        tools_open(&r.tools, 0, 1.0);
        shears_steps(&r, 100);
        expect_ok(vbss_grasper_exchange(r.tools.tools[0], VBSS_GRASPER_KIND_SHEARS));
        shears_steps(&r, 1); /* with empty jaws, but still within */
        assert_int_equal(exchanges(&r, VBSS_SCENE_EVENT_NOT_EXCHANGED, &event), 1);
        for (int i = 1; i <= 200; i++) {
            tools_move(&r.tools, 0, vec3_make(0.0, 3.3e-3, -SHEARS_BELOW + 3.5e-4 * i));
            shears_steps(&r, 1);
        }
        shears_steps(&r, 50);
        expect_ok(vbss_grasper_exchange(r.tools.tools[0], VBSS_GRASPER_KIND_SHEARS));
        shears_steps(&r, 1);
        assert_int_equal(exchanges(&r, VBSS_SCENE_EVENT_EXCHANGED, &event), 1);
        assert_true(event.body_a == r.tools.bodies[0] && event.id == VBSS_GRASPER_KIND_SHEARS);
        assert_int_equal(tools_state(&r.tools, 0).kind, VBSS_GRASPER_KIND_SHEARS);
        for (int i = 200; i >= 0; i--) {
            tools_move(&r.tools, 0, vec3_make(0.0, 3.3e-3, -SHEARS_BELOW + 3.5e-4 * i));
            shears_steps(&r, 1);
        }
        shears_steps(&r, 50);
        assert_true(shears_cut(&r, 0));
        expect_cut_at(&r, 18.3e-3, 0.1e-3);
        assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
        shears_steps(&r, 100);
        shears_expect_shut(&r, 0);
        shears_end(&r);
    }
}

int test_shears(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_is_cut_in_place),
        cmocka_unit_test(slanting_thread_is_cut_in_blade_plane),
        cmocka_unit_test(off_centre_thread_is_dragged_and_cut),
        cmocka_unit_test(cut_at_node_splits_node),
        cmocka_unit_test(blades_close_on_nothing),
        cmocka_unit_test(cut_at_end_does_nothing_and_blades_close),
        cmocka_unit_test(only_closing_cuts),
        cmocka_unit_test(two_strands_are_cut_in_one_step),
        cmocka_unit_test(driver_exchanged_for_shears_cuts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
