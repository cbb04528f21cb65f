/* Signed turns about a finite tool: what a projection takes for a loop, and strands in the jaws. */
#include "base/elementary.h"
#include "knot/winding_rig.h"

/* A shaft of 300 mm from above to the origin. */
static knot_tool shaft(void)
{
    knot_tool tool = {2, VBSS_KNOT_HELD_NOTHING, {{0.0, 0.0, 0.3}}, {2e-3}, 0.0};
    return tool;
}

static void add(line *l, double x, double y, double z)
{
    assert_true(l->count < MAX_COUNT);
    l->points[l->count++] = vec3_make(x, y, z);
}

/* Round the axis from one radius, angle (in turns) and height to another. */
static void add_arc(line *l, const double from[3], const double to[3], int segments)
{
    for (int i = 0; i <= segments; i++) {
        double t = (double)i / segments, r = from[0] + t * (to[0] - from[0]), s, c;
        vbss_sincos(2.0 * PI * (from[1] + t * (to[1] - from[1])), &s, &c);
        add(l, r * c, r * s, from[2] + t * (to[2] - from[2]));
    }
}

/* ---- the cases of the reference, by their letters */

/* A loop in from afar, round once and out again; at this height. */
static line honest_loop(double height, double turns)
{
    line l = {.count = 0};
    add(&l, 0.04, -0.04 * 0.22, height + 0.004);
    add_arc(&l, (double[]){3e-3, 0.0, height + 0.002}, (double[]){3e-3, turns, height - 0.002}, 32);
    return l;
}

static void loops_round_tool_have_turns(void **state)
{
    (void)state;
    line a = honest_loop(0.01, 1.035); /* and 0.035 on the way in */
    expect_near(1.07, wind(&a, shaft()).turns, 1e-3);
    assert_int_equal(1, wind(&a, shaft()).sense);
    line b = {.count = 0};
    add(&b, 0.04, 0.0, 0.01);
    add_arc(&b, (double[]){2e-3, 0.0, 0.01}, (double[]){6e-3, 1.94, 0.01}, 60);
    expect_near(1.94, wind(&b, shaft()).turns, 1e-12);
    line c = {.count = 0};
    add_arc(&c, (double[]){2.5e-3, 0.0, 0.01}, (double[]){2.5e-3, 2.0, 0.006}, 32);
    expect_near(2.0, wind(&c, shaft()).turns, 1e-12);
}

static void turn_and_counter_turn_cancel(void **state)
{
    (void)state;
    line d = {.count = 0};
    add_arc(&d, (double[]){3e-3, 0.0, 0.015}, (double[]){3e-3, 1.0, 0.012}, 32);
    add_arc(&d, (double[]){3.5e-3, 1.0, 0.011}, (double[]){3e-3, -0.02, 0.008}, 32);
    knot_winding got = wind(&d, shaft());
    expect_near(-0.02, got.turns, 1e-12);
    assert_int_equal(1, got.runs);
    assert_int_equal(0, got.sense);
}

static void distant_loops_have_no_turns(void **state)
{
    (void)state;
    line f = honest_loop(-0.02, 1.07), h = honest_loop(-0.045, 1.07),
         over = honest_loop(0.32, 1.07);
    const line *lines[] = {&f, &h, &over};
    for (int k = 0; k < 3; k++) {
        knot_winding got = wind(lines[k], shaft());
        assert_int_equal(0, got.runs);
        expect_same_bits(0.0, got.turns);
        expect_same_bits(0.0, got.run_turns);
        assert_int_equal(0, got.sense);
    }
    line beside = honest_loop(0.01, 1.07);
    for (uint32_t i = 0; i < beside.count; i++) {
        beside.points[i].y += 0.01;
    }
    expect_near(0.0, wind(&beside, shaft()).turns, 0.25);
}

/* ---- through the axis */

static void axis_crossing_is_one_sided(void **state)
{
    (void)state;
    for (int octant = 0; octant < 8; octant++) {
        double s, c;
        vbss_sincos(octant * PI / 4.0, &s, &c);
        line there = {.count = 0}, back = {.count = 0}, by_point = {.count = 0};
        add(&there, -8e-3 * c, -8e-3 * s, 0.01);
        add(&by_point, -8e-3 * c, -8e-3 * s, 0.01);
        add(&by_point, 0.0, 0.0, 0.01);
        add(&there, 8e-3 * c, 8e-3 * s, 0.01);
        add(&by_point, 8e-3 * c, 8e-3 * s, 0.01);
        add(&back, 8e-3 * c, 8e-3 * s, 0.01);
        add(&back, -8e-3 * c, -8e-3 * s, 0.01);
        double turns = wind(&there, shaft()).turns;
        expect_near(0.5, fabs(turns), 1e-12);
        expect_same_bits(-turns, wind(&back, shaft()).turns);
        expect_near(turns, wind(&by_point, shaft()).turns, 1e-12);
    }
    line along = {.count = 0};
    add(&along, 0.0, 0.0, 0.4);
    add(&along, 0.0, 0.0, -0.1);
    expect_same_bits(0.0, wind(&along, shaft()).turns);
    assert_int_equal(1, wind(&along, shaft()).runs);
}

/* Round tools along each coordinate, from each direction, with zeros of both signs. */
static void signed_zeros_are_equal(void **state)
{
    (void)state;
    for (int k = 0; k < 6 * 8 * 8; k++) {
        int along = k % 3, start = k / 6 % 8;
        double tip = k / 3 % 2 == 0 ? -1.0 : 1.0, zeros[3];
        knot_tool tool = {2, VBSS_KNOT_HELD_NOTHING, {{0.0, 0.0, 0.0}}, {0.1}, 0.0};
        double axis[2][3] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        axis[0][along] = -tip;
        axis[1][along] = tip;
        tool.axis[0] = vec3_load(axis[0]);
        tool.axis[1] = vec3_load(axis[1]);
        for (int i = 0; i < 3; i++) {
            zeros[i] = (k / 48 >> i & 1) != 0 ? -0.0 : 0.0;
        }
        line l = {.count = 0};
        for (int i = start; i <= start + 8; i++) {
            static const double round[8] = {1.0, 1.0, 0.0, -1.0, -1.0, -1.0, 0.0, 1.0};
            double x[3] = {zeros[0], zeros[1], zeros[2]}, c = round[i % 8], s = round[(i + 6) % 8];
            x[(along + 1) % 3] = c != 0.0 ? c : x[(along + 1) % 3];
            x[(along + 2) % 3] = s != 0.0 ? s : x[(along + 2) % 3];
            add(&l, x[0], x[1], x[2]);
        }
        expect_near(-tip, wind(&l, tool).turns, 1e-12);
    }
}

/* ---- what the tool holds */

/* A strand through the jaws, `off` beside the axis, with so many points. */
static line strand(double off, uint32_t count)
{
    line l = {.count = 0};
    for (uint32_t i = 0; i < count; i++) {
        add(&l, -0.02 + 0.04 * i / (count - 1), off, 0.004);
    }
    return l;
}

static void held_strand_is_no_half_turn(void **state)
{
    (void)state;
    for (uint32_t count = 2; count < 60; count++) {
        for (int off = -1; off <= 1; off++) {
            line l = strand(off * 1e-4, count);
            knot_tool tool = shaft();
            expect_near(0.5, fabs(wind(&l, tool).turns), 0.01);
            tool.held = VBSS_KNOT_HELD_THREAD;
            tool.held_place = 0.5 * (count - 1);
            knot_winding got = wind(&l, tool);
            double wanted = -off * 2.0 *
                            (vbss_atan2(1e-4, sqrt(4e-6 - 1e-8)) - vbss_atan2(1e-4, 0.02)) /
                            (2.0 * PI);
            expect_near(off == 0 ? 0.0 : wanted, got.turns, 1e-12);
            assert_int_equal(2, got.runs);
            tool.held_place = 0.1 * (count - 1); /* held there, it lies outside the capsule here */
            expect_near(0.5, fabs(wind(&l, tool).turns), 0.01);
        }
    }
}

static void winding_beside_held_place_counts(void **state)
{
    (void)state;
    knot_tool tool = shaft();
    line l = {.count = 0};
    add(&l, -0.01, 1e-5, 0.003);
    add(&l, 0.0, 1e-5, 0.003);
    add_arc(&l, (double[]){3e-3, 0.0, 0.02}, (double[]){3e-3, 1.5, 0.01}, 40);
    tool.held = VBSS_KNOT_HELD_THREAD;
    tool.held_place = 1.0;
    knot_winding got = wind(&l, tool);
    expect_near(1.5, got.run_turns, 1e-2);
    vec3 x = vec3_lerp(l.points[1], l.points[2], got.run_places[0] - 1.0);
    expect_near(2e-3, sqrt(x.x * x.x + x.y * x.y), 1e-14); /* it begins on the capsule */
    assert_int_equal(1, got.sense);
    for (uint32_t i = 0; i < l.count / 2; i++) {
        x = l.points[i];
        l.points[i] = l.points[l.count - 1 - i];
        l.points[l.count - 1 - i] = x;
    }
    tool.held_place = l.count - 1.9; /* just beyond a corner within the jaws */
    got = wind(&l, tool);
    x = vec3_lerp(l.points[l.count - 3], l.points[l.count - 2],
                  got.run_places[1] - (l.count - 3.0));
    expect_near(2e-3, sqrt(x.x * x.x + x.y * x.y), 1e-14);
    l.count--;
    tool.held = VBSS_KNOT_HELD_NEEDLE; /* whose end is in the jaws */
    tool.held_place = l.count - 1;
    expect_near(-1.5, wind(&l, tool).run_turns, 1e-2);
    assert_int_equal(1, wind(&l, tool).runs);
}

static void held_place_beyond_capsules_holds_nothing(void **state)
{
    (void)state;
    knot_tool tool = shaft();
    line l = {.count = 0};
    add(&l, 1e-3, 1e-3, -5e-3);
    add(&l, 1e-3, -1e-3, 5e-3);
    add(&l, 1e-3, -1e-3, 0.1);
    tool.held = VBSS_KNOT_HELD_THREAD;
    assert_int_equal(1, wind(&l, tool).runs);
    expect_near(0.5, wind(&l, tool).run_places[0], 1e-15);
    tool.held_place = 0.4; /* in the round end of the capsule */
    assert_int_equal(0, wind(&l, tool).runs);
    line back = {.count = 0}; /* what comes back from beyond is another strand */
    add(&back, 1e-3, 0.0, 4e-3);
    add(&back, 1e-3, 0.0, -4e-3);
    add(&back, -1e-3, 0.0, 4e-3);
    tool.held_place = 0.0;
    assert_int_equal(1, wind(&back, tool).runs);
    expect_near(1.5, wind(&back, tool).run_places[0], 1e-15);
}

static void strand_along_jaws_is_held_across_joints(void **state)
{
    (void)state;
    knot_tool tool = {3,
                      VBSS_KNOT_HELD_THREAD,
                      {{0.0, 0.0, 0.05}, {0.0, 0.0, 0.02}, {0.01, 0.0, 0.0}},
                      {2e-3, 2e-3},
                      0.0};
    line l = {.count = 0};
    add(&l, 0.015, 0.0, -0.01);
    for (int i = 0; i <= 10; i++) { /* zigzags along the axis */
        add(&l, 0.01 - 1e-3 * i, i % 2 == 0 ? 1e-4 : -1e-4, 2e-3 * i);
    }
    for (int i = 0; i <= 10; i++) {
        add(&l, i % 2 == 0 ? 1e-4 : -1e-4, i % 3 == 0 ? 1e-4 : -1e-4, 0.021 + 1e-3 * i);
    }
    add(&l, 0.02, 0.01, 0.031);
    for (uint32_t k = 1; k + 1 < l.count; k++) {
        tool.held_place = k;
        knot_winding got = wind(&l, tool);
        expect_near(0.0, got.turns, 0.01);
        assert_int_equal(1, got.runs);
        assert_true(got.run_places[0] > l.count - 2.0);
    }
    tool.held = VBSS_KNOT_HELD_NOTHING;
    assert_true(fabs(wind(&l, tool).turns) > 0.1);
    assert_true(wind(&l, tool).run_places[0] < 5.0);
}

int test_winding_cases(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(loops_round_tool_have_turns),
        harness_test(turn_and_counter_turn_cancel),
        harness_test(distant_loops_have_no_turns),
        harness_test(axis_crossing_is_one_sided),
        harness_test(signed_zeros_are_equal),
        harness_test(held_strand_is_no_half_turn),
        harness_test(winding_beside_held_place_counts),
        harness_test(held_place_beyond_capsules_holds_nothing),
        harness_test(strand_along_jaws_is_held_across_joints),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
