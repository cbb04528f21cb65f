/* A reduction removes what has nothing in its way, and only that. */
#include "base/elementary.h"
#include "knot/reduction_rig.h"

enum { RING = 24 };

/* ---- random polygons: more or less smooth, in space, in a plane, on a grid, with points twice */

static void draw_polygon(harness_source *source)
{
    reduction_start(harness_draw_below(source, 2) == 0);
    uint32_t n = 3 + harness_draw_below(source, 100), kind = harness_draw_below(source, 4);
    double step = harness_draw_real(source, 0.02, 1.0);
    vec3 x = vec3_zero();
    for (uint32_t i = 0; i < n; i++) {
        if (harness_draw_below(source, 20) != 0) {
            vec3 d = harness_draw_vec3(source, -1.0, 1.0);
            x = kind == 3 ? harness_draw_vec3(source, -1.0, 1.0) : vec3_add_scaled(x, step, d);
        }
        if (kind == 1) {
            x.z = 0.25;
        } else if (kind == 2) {
            x = vec3_make(floor(4.0 * x.x) / 4.0, floor(4.0 * x.y) / 4.0, floor(4.0 * x.z) / 4.0);
        }
        reduction_add(x, harness_draw_below(source, 15) == 0);
    }
    for (uint32_t i = harness_draw_below(source, 30); i > 0; i--) {
        vec3 from = harness_draw_below(source, 2) == 0
                        ? reduction_r.x[harness_draw_below(source, n)]
                        : harness_draw_vec3(source, -2.0, 2.0);
        reduction_add_obstacle(from, harness_draw_vec3(source, -9.0, 9.0));
    }
}

static void reduces_plainly(harness_source *source, void *user)
{
    (void)user;
    static reduction_plain p;
    draw_polygon(source);
    reduction_take(&p);
    reduction_reduce_plainly(&p);
    reduction_reduce();
    reduction_expect(&p);
}

static void matches_testing_every_edge(void **state)
{
    (void)state;
    harness_property("as plainly", 3000, reduces_plainly, NULL);
}

static void in_slices_as_at_once(harness_source *source, void *user)
{
    (void)user;
    static reduction_plain p, given;
    draw_polygon(source);
    reduction_take(&given);
    reduction_reduce();
    reduction_take(&p);
    reduction_put(&given);
    reduction_reduce_in_slices(1 + (knot_ops)harness_draw_below(source, 300));
    reduction_expect(&p);
}

static void does_not_depend_on_slices(void **state)
{
    (void)state;
    harness_property("slices", 1000, in_slices_as_at_once, NULL);
}

/* ---- what has nothing in its way */

static void planar_polygon_reduces_to_triangle(void **state)
{
    (void)state;
    for (int tilted = 0; tilted < 2; tilted++) {
        reduction_start(true);
        for (int i = 0; i < 400; i++) { /* out along a spiral, back beside it */
            double t = i < 200 ? 0.1 * i : 0.1 * (400 - i) - 0.05, w = i < 200 ? 1.0 : 1.1;
            vec3 x = vec3_make(w * (1.0 + t) * vbss_cos(t), w * (1.0 + t) * vbss_sin(t), 0.0);
            quat turn = quat_unit(quat_make(0.9, 0.1, -0.3, 0.2));
            reduction_add(tilted ? quat_rotate(turn, x) : x, false);
        }
        reduction_reduce();
        assert_int_equal(3, reduction_r.polygon.count);
    }
}

static void straight_line_reduces_to_ends(void **state)
{
    (void)state;
    reduction_start(false);
    for (int i = 0; i < 200; i++) {
        reduction_add(vec3_scale(vec3_make(0.1, -0.7, 0.3), 1.0 / 3.0 * i), false);
    }
    reduction_add(reduction_r.x[199], false);
    reduction_reduce();
    assert_int_equal(2, reduction_r.polygon.count);
    assert_true(reduction_r.place[0] == 0.0 && reduction_r.place[1] == 200.0);
}

/* ---- what has */

static void ring_round_obstacle_stays(void **state)
{
    (void)state;
    for (int through = 0; through < 2; through++) {
        reduction_start(true);
        for (int i = 0; i < RING; i++) {
            double t = 2.0 * 3.141592653589793 / RING * i;
            reduction_add(vec3_make(vbss_cos(t), vbss_sin(t), 0.2 * vbss_sin(3.0 * t)), i == 5);
        }
        double aside = through ? 0.0 : 2.0;
        reduction_add_obstacle(vec3_make(aside, 0.1, -3.0), vec3_make(aside, -0.1, 4.0));
        reduction_reduce();
        assert_int_equal(3, reduction_r.polygon.count);
        double turn = 0.0; /* about the obstacle */
        for (uint32_t i = 0; i < 3; i++) {
            vec3 p = reduction_r.x[i], q = reduction_r.x[(i + 1) % 3];
            turn += vbss_atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y);
        }
        assert_true(!through || fabs(turn) > 6.28);
        assert_true(reduction_r.stays[0] + reduction_r.stays[1] + reduction_r.stays[2] == 1);
    }
}

static void kept_points_stay(void **state)
{
    (void)state;
    reduction_start(false);
    for (int i = 0; i < 100; i++) {
        reduction_add(vec3_make(i, 0.1 * (i % 7), 0.01 * (i % 5)), i % 10 == 3);
    }
    reduction_reduce();
    assert_int_equal(12, reduction_r.polygon.count);
    for (uint32_t i = 1; i < 11; i++) {
        assert_true(reduction_r.stays[i] == 1 && reduction_r.place[i] == 10.0 * i - 7.0);
    }
}

int test_reduction(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(matches_testing_every_edge),
        harness_test(does_not_depend_on_slices),
        harness_test(planar_polygon_reduces_to_triangle),
        harness_test(straight_line_reduces_to_ends),
        harness_test(ring_round_obstacle_stays),
        harness_test(kept_points_stay),
    };
    return cmocka_run_group_tests(tests, reduction_make_rig, reduction_end_rig);
}
