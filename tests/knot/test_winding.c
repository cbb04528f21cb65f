/* Signed turns about a straight tool: helices, what changes their sign and what changes nothing. */
#include "base/elementary.h"
#include "harness/harness.h"
#include "knot/knot.h"

#define PI 3.141592653589793
#define LENGTH 0.03

enum { MAX_COUNT = 512 };

typedef struct line {
    vec3 points[MAX_COUNT];
    uint32_t count;
} line;

static knot_tool straight_tool(void)
{
    knot_tool tool = {2, VBSS_KNOT_HELD_NOTHING, {{0.0, 0.0, LENGTH}}, {2e-3}, 0.0};
    return tool;
}

/* About a tool that ends in the origin, with the tissue at this place. */
static knot_winding wind_from(const line *l, knot_tool tool, double tissue_place)
{
    line copy = *l;
    knot_input scene = {.point_count = copy.count,
                        .tool_count = 1,
                        .has_holes = tissue_place >= 0.0,
                        .tissue_place = tissue_place,
                        .points = copy.points,
                        .tools = &tool};
    knot_winding winding;
    vbss_knot_measure_winding(&scene, 0, &winding);
    assert_true(isfinite(winding.turns) && isfinite(winding.run_turns));
    for (int k = 0; k < 2; k++) {
        assert_true(isfinite(winding.run_heights[k]));
        assert_true(winding.run_places[k] >= 0.0 && winding.run_places[k] <= copy.count - 1);
    }
    assert_in_range(winding.sense + 1, 0, 2);
    return winding;
}

static knot_winding wind(const line *l)
{
    return wind_from(l, straight_tool(), -1.0);
}

/* From height z0 to z1 while it makes `turns`, from this angle on. */
static line helix(double turns, double radius, double z0, double z1, double angle, uint32_t count)
{
    line l = {.count = count};
    for (uint32_t i = 0; i < count; i++) {
        double t = (double)i / (count - 1), s, c;
        vbss_sincos(angle + 2.0 * PI * turns * t, &s, &c);
        l.points[i] = vec3_make(radius * c, radius * s, z0 + t * (z1 - z0));
    }
    return l;
}

static line reversed(const line *l)
{
    line r = {.count = l->count};
    for (uint32_t i = 0; i < l->count; i++) {
        r.points[i] = l->points[l->count - 1 - i];
    }
    return r;
}

/* ---- helices */

static void helix_has_its_turns(void **state)
{
    (void)state;
    static const double slopes[] = {-0.02, -0.001, 0.0, 1e-5, 0.004, 0.015};
    for (int halves = -6; halves <= 6; halves++) {
        for (size_t k = 0; k < sizeof slopes / sizeof slopes[0]; k++) {
            for (int a = 0; a < 8; a++) { /* from angles on the axes too, where turns are counted */
                double w = 0.5 * halves, radius = k % 2 == 0 ? 3e-3 : 0.04;
                line l = helix(w, radius, 0.025, 0.025 - fabs(slopes[k]), a * PI / 4.0, 200);
                l = slopes[k] < 0.0 ? reversed(&l) : l;
                knot_winding got = wind(&l);
                double wanted = slopes[k] < 0.0 ? -w : w;
                expect_near(wanted, got.turns, 1e-12);
                expect_same_bits(got.turns, got.run_turns);
                assert_int_equal(1, got.runs);
                expect_same_bits(0.0, got.run_places[0]);
                expect_same_bits(199.0, got.run_places[1]);
                expect_near(l.points[0].z, got.run_heights[0], 1e-15);
                expect_near(l.points[199].z, got.run_heights[1], 1e-15);
            }
        }
    }
}

static void mirror_and_reversal_flip_sign(void **state)
{
    (void)state;
    line l = helix(1.7, 3e-3, 0.02, 0.01, 0.3, 100), m = l, r = reversed(&l);
    for (uint32_t i = 0; i < m.count; i++) {
        m.points[i].x = -m.points[i].x;
    }
    expect_near(1.7, wind(&l).turns, 1e-13);
    expect_near(-1.7, wind(&m).turns, 1e-13);
    expect_near(-1.7, wind(&r).turns, 1e-13);
}

static void moved(harness_source *source, void *user)
{
    (void)user;
    line l = helix(harness_draw_real(source, -3.0, 3.0), 3e-3, 0.02, -0.01, 0.1, 150);
    knot_tool tool = straight_tool();
    knot_winding before = wind(&l);
    pose p = {harness_draw_vec3(source, -0.5, 0.5), harness_draw_unit_quat(source)};
    for (uint32_t i = 0; i < l.count; i++) {
        l.points[i] = pose_apply(p, l.points[i]);
    }
    for (uint32_t k = 0; k < tool.point_count; k++) {
        tool.axis[k] = pose_apply(p, tool.axis[k]);
    }
    knot_winding after = wind_from(&l, tool, -1.0);
    expect_near(before.turns, after.turns, 1e-11);
    assert_int_equal(before.sense, after.sense);
    assert_int_equal(before.runs, after.runs);
    for (int k = 0; k < 2; k++) {
        expect_near(before.run_places[k], after.run_places[k], 1e-9);
        expect_near(before.run_heights[k], after.run_heights[k], 1e-12);
    }
}

static void rigid_motion_invariance(void **state)
{
    (void)state;
    harness_property("winding moved", 200, moved, NULL);
}

/* Points put between those of a line, some of them twice, change the numbers of places only. */
static void resampled(harness_source *source, void *user)
{
    (void)user;
    line l = helix(harness_draw_real(source, -3.0, 3.0), 3e-3, 0.015, -0.01, 0.1, 100),
         fine = {.count = 0};
    knot_winding coarse = wind(&l);
    for (uint32_t i = 0; i + 1 < l.count; i++) {
        uint32_t parts = 1 + harness_draw_below(source, 4);
        for (uint32_t k = 0; k < parts; k++) {
            double t =
                k == 0 ? 0.0 : harness_draw_real(source, 0.0, 1.0) / parts + (double)k / parts;
            fine.points[fine.count++] = vec3_lerp(l.points[i], l.points[i + 1], t);
        }
    }
    fine.points[fine.count++] = l.points[l.count - 1];
    knot_winding got = wind(&fine);
    expect_near(coarse.turns, got.turns, 1e-11);
    expect_near(coarse.run_heights[0], got.run_heights[0], 1e-12);
    expect_near(coarse.run_heights[1], got.run_heights[1], 1e-12);
    assert_int_equal(coarse.sense, got.sense);
    assert_int_equal(coarse.runs, got.runs);
}

static void resampling_invariance(void **state)
{
    (void)state;
    harness_property("winding resampled", 200, resampled, NULL);
}

/* ---- runs */

static void runs_end_where_thread_leaves(void **state)
{
    (void)state;
    line l = {.count = 7}; /* past the tip and back, past the handle and back */
    for (uint32_t i = 0; i < l.count; i++) {
        l.points[i] = vec3_make(4e-3, 1e-3 * i, 0.01);
    }
    l.points[2].z = -0.01;
    l.points[4].z = LENGTH + 0.01;
    knot_winding got = wind(&l);
    assert_int_equal(3, got.runs);
    expect_near(0.0, got.run_places[0], 1e-15); /* the first is nearest, so it turns most */
    expect_near(1.5, got.run_places[1], 1e-14);
    expect_near(0.01, got.run_heights[0], 1e-15);
    expect_near(0.0, got.run_heights[1], 1e-15);
    double angles = vbss_atan2(1.5, 4.0) + vbss_atan2(3.0 + 2.0 / 3.0, 4.0) - vbss_atan2(2.5, 4.0) +
                    vbss_atan2(6.0, 4.0) - vbss_atan2(4.0 + 1.0 / 3.0, 4.0);
    expect_near(angles / (2.0 * PI), got.turns, 1e-13);
    expect_near(vbss_atan2(1.5, 4.0) / (2.0 * PI), got.run_turns, 1e-13);
}

static void largest_run_is_reported(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        double sign = k / 2 == 0 ? 1.0 : -1.0, w[2] = {0.7, -1.6};
        line l = helix(sign * w[k % 2], 3e-3, 0.01, 0.005, 0.5, 100),
             tail = helix(0.0, 3e-3, -0.01, -0.02, 0.0, 2);
        line other = helix(sign * w[1 - k % 2], 3e-3, 0.01, 0.005, 0.5, 100);
        l.points[l.count++] = tail.points[0]; /* past the tip */
        for (uint32_t i = 0; i < other.count; i++) {
            l.points[l.count++] = other.points[i];
        }
        knot_winding got = wind(&l);
        assert_int_equal(2, got.runs);
        expect_near(-1.6 * sign, got.run_turns, 0.1);
        expect_near(-0.9 * sign, got.turns, 0.2);
        assert_true(k % 2 == 0 ? got.run_places[0] > 100.0 : got.run_places[1] < 100.0);
    }
}

static void touching_at_end_is_no_gap(void **state)
{
    (void)state;
    for (int end = 0; end < 2; end++) {
        line l = helix(2.0, 3e-3, 0.01, 0.02, 0.0, 81);
        l.points[40].z = end == 0 ? 0.0 : LENGTH;
        assert_int_equal(1, wind(&l).runs);
        expect_near(2.0, wind(&l).turns, 1e-13);
        l.points[40].z += end == 0 ? -1e-9 : 1e-9;
        assert_int_equal(2, wind(&l).runs);
    }
}

/* ---- sense */

static void sense_is_seen_from_tissue(void **state)
{
    (void)state;
    line down = helix(1.5, 3e-3, 0.02, 0.01, 0.4, 120), up = reversed(&down);
    assert_int_equal(1,
                     wind(&down).sense); /* it is before the run unless it is known to be after */
    assert_int_equal(-1, wind(&up).sense);
    assert_int_equal(1, wind_from(&down, straight_tool(), 10.0).sense);
    assert_int_equal(-1, wind_from(&down, straight_tool(), 110.0).sense);
    assert_int_equal(1, wind_from(&up, straight_tool(), 110.0).sense);
    assert_int_equal(1, wind_from(&down, straight_tool(), 50.0).sense);
    assert_int_equal(-1, wind_from(&down, straight_tool(), 70.0).sense);
    for (uint32_t i = 0; i < down.count; i++) {
        down.points[i].z = 0.01 + 0.01 * (down.points[i].z - 0.01); /* no thread is as thin */
    }
    assert_int_equal(0, wind(&down).sense);
    down = helix(0.45, 3e-3, 0.02, 0.01, 0.4, 120);
    assert_int_equal(0, wind(&down).sense);
}

static void sense_is_of_wound_part(void **state)
{
    (void)state;
    /* Some have a quarter or three quarters of their turns done where the run began. */
    static const double turns[] = {0.7, 1.0, 4.0 / 3.0, 1.5, 1.9, 2.5, 8.0 / 3.0, 3.0, 4.0, 8.0};
    for (int k = 0; k < 40; k++) {
        double w = k % 2 == 0 ? turns[k / 4] : -turns[k / 4];
        line l = helix(w, 3e-3, 0.02, 0.01, 1.0, 400);
        l.points[0] = vec3_make(5.0 * l.points[1].x, 5.0 * l.points[1].y, -0.002);
        vec3 *end = &l.points[l.count - 1];
        *end = vec3_make(5.0 * end[-1].x, 5.0 * end[-1].y, k / 2 % 2 == 0 ? -0.002 : 0.029);
        line r = reversed(&l);
        expect_near(w, wind(&l).turns, 0.05);
        assert_int_equal(1, wind(&l).sense);
        assert_int_equal(-1, wind(&r).sense);
    }
    for (int k = 0; k < 10; k++) {
        line l = helix(turns[k], 3e-3, 0.02, 0.01, 0.0, 400);
        line r = reversed(&l);
        assert_int_equal(1, wind(&l).sense);
        assert_int_equal(-1, wind(&r).sense);
    }
}

/* Joins helices; the last point of one is the first of the next. */
static line joined(const line *lines, int count)
{
    line all = {.count = 0};
    for (int k = 0; k < count; k++) {
        for (uint32_t i = k == 0 ? 0 : 1; i < lines[k].count; i++) {
            all.points[all.count++] = lines[k].points[i];
        }
    }
    return all;
}

static void counter_winding_keeps_sense(void **state)
{
    (void)state;
    /* A quarter is done first at 19 mm, later at 28; three quarters at 23. */
    line bits[3] = {helix(0.6, 3e-3, 0.02, 0.018, 0.0, 50),
                    helix(-0.4, 3e-3, 0.018, 0.028, 1.2 * PI, 50),
                    helix(1.3, 3e-3, 0.028, 0.021, 0.4 * PI, 50)};
    line l = joined(bits, 3), r = reversed(&l);
    expect_near(1.5, wind(&l).turns, 1e-12);
    assert_int_equal(-1, wind(&l).sense);
    assert_int_equal(1, wind(&r).sense);
    /* Three quarters at 19.2 mm; a turn more, left again, at 19.7. */
    line beyond[2] = {helix(1.9, 3e-3, 0.02, 0.018, 0.0, 100),
                      helix(-0.9, 3e-3, 0.018, 0.028, 3.8 * PI, 50)};
    l = joined(beyond, 2);
    expect_near(1.0, wind(&l).turns, 1e-12);
    assert_int_equal(1, wind(&l).sense);
}

int test_winding(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(helix_has_its_turns),          harness_test(mirror_and_reversal_flip_sign),
        harness_test(rigid_motion_invariance),      harness_test(resampling_invariance),
        harness_test(runs_end_where_thread_leaves), harness_test(largest_run_is_reported),
        harness_test(touching_at_end_is_no_gap),    harness_test(sense_is_seen_from_tissue),
        harness_test(sense_is_of_wound_part),       harness_test(counter_winding_keeps_sense),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
