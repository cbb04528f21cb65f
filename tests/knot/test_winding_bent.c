/* Signed turns about bent tools, and of any polyline against the sum of its angles. */
#include "base/elementary.h"
#include "base/rotation.h"
#include "knot/winding_rig.h"

static knot_tool bent_tool(harness_source *source, uint32_t points, double bend)
{
    knot_tool tool = {points, VBSS_KNOT_HELD_NOTHING, {{0.0, 0.0, 0.0}}, {1e-3, 1e-3, 1e-3}, 0.0};
    vec3 u = quat_rotate(harness_draw_unit_quat(source), vec3_make(1.0, 0.0, 0.0));
    tool.axis[points - 1] = harness_draw_vec3(source, -0.1, 0.1);
    for (uint32_t k = points - 1; k-- > 0;) {
        tool.axis[k] = vec3_add_scaled(tool.axis[k + 1], harness_draw_real(source, 0.01, 0.03), u);
        vec3 across = vec3_cross(u, quat_rotate(harness_draw_unit_quat(source), u));
        u = quat_rotate(vbss_quat_from_rotation_vector(vec3_scale(
                            vec3_unit_or(across, u), harness_draw_real(source, 0.0, bend))),
                        u);
    }
    return tool;
}

static vec3 up_of(const knot_tool *tool, uint32_t piece)
{
    return vec3_unit_or(vec3_sub(tool->axis[piece], tool->axis[piece + 1]), vec3_zero());
}

/* The plane over piece k, or under piece k - 1. */
static double over_plane(const knot_tool *tool, uint32_t k, vec3 x)
{
    vec3 n = up_of(tool, k == 0 ? 0 : k - 1);
    n = vec3_add(n, up_of(tool, k + 1 == tool->point_count ? k - 1 : k));
    return vec3_dot(n, vec3_sub(x, tool->axis[k]));
}

/* 2 mm from the axis beside piece c, so far up between its planes. */
static vec3 beside(const knot_tool *tool, uint32_t c, vec3 e1, double turns, double part)
{
    double length = vec3_distance(tool->axis[c], tool->axis[c + 1]), sine, cosine, along[2];
    vec3 up = up_of(tool, c), e2 = vec3_cross(up, e1);
    vbss_sincos(2.0 * PI * turns, &sine, &cosine);
    vec3 x = vec3_add_scaled(tool->axis[c + 1], 2e-3 * cosine, e1);
    x = vec3_add_scaled(x, 2e-3 * sine, e2);
    for (uint32_t k = 0; k < 2; k++) { /* to the plane below, and above */
        double a = over_plane(tool, c + 1 - k, x);
        double b = over_plane(tool, c + 1 - k, vec3_add_scaled(x, length, up));
        along[k] = -a / (b - a) * length;
    }
    return vec3_add_scaled(x, along[0] + part * (along[1] - along[0]), up);
}

/* A piece of a helix made in planes that lean with the bends, so that it follows them. */
static void follows(harness_source *source, void *user)
{
    (void)user;
    enum { STEPS = 80 };
    knot_tool tool = bent_tool(source, 2 + harness_draw_below(source, 3), 1.2);
    double w = 0.5 * ((double)harness_draw_below(source, 13) - 6.0), base = 0.0;
    double turns[MAX_COUNT], heights[MAX_COUNT];
    line all = {.count = 0}, l = {.count = 0};
    vec3 up = up_of(&tool, tool.point_count - 2), e1 = vec3_any_normal(up);
    for (uint32_t c = tool.point_count - 1; c-- > 0;) {
        e1 = quat_rotate(quat_between(up, up_of(&tool, c)), e1);
        up = up_of(&tool, c);
        for (int i = 0; i <= STEPS; i++) {
            double part = 1e-6 + (1.0 - 2e-6) * i / STEPS;
            heights[all.count] = base + part * vec3_distance(tool.axis[c], tool.axis[c + 1]);
            turns[all.count] = w * heights[all.count] / 0.04;
            all.points[all.count] = beside(&tool, c, e1, turns[all.count], part);
            all.count++;
        }
        base += vec3_distance(tool.axis[c], tool.axis[c + 1]);
    }
    uint32_t first = harness_draw_below(source, all.count / 2);
    uint32_t last = all.count - 1 - harness_draw_below(source, all.count / 2 - 1);
    uint32_t ends[2] = {first, last};
    bool upwards = harness_draw_below(source, 2) == 1;
    for (uint32_t i = 0; i <= last - first; i++) {
        l.points[l.count++] = all.points[upwards ? first + i : last - i];
    }
    knot_winding got = wind(&l, tool);
    double wanted = turns[ends[upwards]] - turns[ends[!upwards]];
    expect_near(wanted, got.turns, 1e-12);
    assert_int_equal(1, got.runs);
    expect_near(heights[ends[!upwards]], got.run_heights[0], 1e-14);
    expect_near(heights[ends[upwards]], got.run_heights[1], 1e-14);
    if (fabs(fabs(wanted) - 0.5) > 1e-3) {
        assert_int_equal(fabs(wanted) < 0.5 ? 0 : upwards ? -1 : 1, got.sense);
    }
}

static void helix_round_bent_tool_has_its_turns(void **state)
{
    (void)state;
    harness_property("winding bent", 500, follows, NULL);
}

/* From beside the first piece to beside the last, between them beside both. */
static void shared_turn_is_counted_once(void **state)
{
    (void)state;
    knot_tool tool = {4,
                      VBSS_KNOT_HELD_NOTHING,
                      {{0.0, 0.0, 1e-2}, {0.0, 0.0, 0.0}, {1e-2, 0.0, 0.0}, {1e-2, 0.0, 1e-2}},
                      {1e-3, 1e-3, 1e-3},
                      0.0};
    line l = {.points = {{0.0, 3e-3, 8e-3}, {1e-2, 3e-3, 8e-3}}, .count = 2};
    knot_winding got = wind(&l, tool);
    assert_int_equal(2, got.runs);
    expect_near(0.0, got.run_places[0], 1e-15);
    expect_near(0.8, got.run_places[1], 1e-14);
    expect_near((vbss_atan2(2.0, 3.0) - vbss_atan2(8.0, 3.0)) / (2.0 * PI), got.turns, 1e-12);
    expect_near(-vbss_atan2(8.0, 3.0) / (2.0 * PI), got.run_turns, 1e-12);
}

/* ---- against the sum of angles */

/* The angle about one piece of the part of a segment in its cell. */
static double angle_beside(const knot_tool *tool, uint32_t c, vec3 a, vec3 b)
{
    double upper[2] = {over_plane(tool, c, a), over_plane(tool, c, b)};
    double lower[2] = {over_plane(tool, c + 1, a), over_plane(tool, c + 1, b)};
    double from = 0.0, to = 1.0;
    if (upper[0] >= 0.0 && upper[1] >= 0.0) {
        return 0.0; /* what is in a plane is above it */
    }
    for (int k = 0; k < 2; k++) {
        double ha = k == 0 ? -upper[0] : lower[0], hb = k == 0 ? -upper[1] : lower[1];
        if (ha < 0.0 && hb < 0.0) {
            return 0.0;
        }
        from = ha < 0.0 ? fmax(from, ha / (ha - hb)) : from;
        to = hb < 0.0 ? fmin(to, ha / (ha - hb)) : to;
    }
    if (from >= to) {
        return 0.0;
    }
    vec3 u = up_of(tool, c);
    vec3 p = vec3_sub(vec3_lerp(a, b, from), tool->axis[c]),
         q = vec3_sub(vec3_lerp(a, b, to), tool->axis[c]);
    p = vec3_add_scaled(p, -vec3_dot(p, u), u);
    q = vec3_add_scaled(q, -vec3_dot(q, u), u);
    return vbss_atan2(vec3_dot(u, vec3_cross(p, q)), vec3_dot(p, q));
}

static void summed(harness_source *source, void *user)
{
    (void)user;
    knot_tool tool = bent_tool(source, 2 + harness_draw_below(source, 3), 0.5);
    line l = {.count = 2 + harness_draw_below(source, MAX_COUNT - 2)};
    double size = harness_draw_real(source, 1e-3, 0.02), sum = 0.0;
    for (uint32_t i = 0; i < l.count; i++) {
        vec3 near = tool.axis[harness_draw_below(source, tool.point_count)];
        l.points[i] = vec3_add(near, harness_draw_vec3(source, -size, size));
    }
    for (uint32_t i = 0; i + 1 < l.count; i++) {
        for (uint32_t c = 0; c + 1 < tool.point_count; c++) {
            sum += angle_beside(&tool, c, l.points[i], l.points[i + 1]);
        }
    }
    expect_near(sum / (2.0 * PI), wind(&l, tool).turns, 1e-9);
}

static void turns_are_sum_of_angles(void **state)
{
    (void)state;
    harness_property("winding summed", 1000, summed, NULL);
}

/* Points of a lattice lie on planes, joints and ends, in line with each other and upon each other. */
static void lies_on_planes(harness_source *source, void *user)
{
    (void)user;
    knot_tool tool = {4,
                      VBSS_KNOT_HELD_NOTHING,
                      {{0.31, 0.37, 3.0}, {0.31, 0.37, 2.0}, {0.31, 0.37, 1.0}, {0.31, 0.37, 0.0}},
                      {0.1, 0.1, 0.1},
                      0.0};
    line l = {.count = 2 + harness_draw_below(source, 100)};
    double sum = 0.0;
    for (uint32_t i = 0; i < l.count; i++) {
        double x = harness_draw_below(source, 3) - 1.0, y = harness_draw_below(source, 3) - 1.0;
        l.points[i] = vec3_make(x, y, harness_draw_below(source, 6) - 1.0);
        for (uint32_t c = 0; i > 0 && c < 3; c++) {
            sum += angle_beside(&tool, c, l.points[i - 1], l.points[i]);
        }
    }
    expect_near(sum / (2.0 * PI), wind(&l, tool).turns, 1e-12);
    tool.axis[0] = vec3_make(0.0, 0.0, 3.0); /* and through the axis, once of a folded tool */
    tool.axis[1] = vec3_make(0.0, 0.0, 2.0);
    tool.axis[2] = vec3_make(0.0, 0.0, 1.0);
    tool.axis[3] = vec3_make(0.0, 0.0, harness_draw_below(source, 2) == 0 ? 0.0 : 2.0);
    tool.held = (vbss_knot_held)harness_draw_below(source, 3);
    tool.held_place = harness_draw_real(source, 0.0, l.count - 1.0);
    knot_winding once = wind(&l, tool), again = wind(&l, tool);
    expect_same_bits(once.turns, again.turns);
    assert_true(fabs(once.turns) <= 0.5 * l.count);
}

static void points_on_planes_and_axis_are_handled(void **state)
{
    (void)state;
    harness_property("winding on a lattice", 2000, lies_on_planes, NULL);
}

int test_winding_bent(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(helix_round_bent_tool_has_its_turns),
        harness_test(shared_turn_is_counted_once),
        harness_test(turns_are_sum_of_angles),
        harness_test(points_on_planes_and_axis_are_handled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
