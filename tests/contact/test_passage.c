/* The re-test of recorded motion finds every passage, and nothing else. */
#include "oracle/passing.h"

#include "harness/harness.h"
#include "oracle/oracle.h"
#include "fixtures/knots.h"

enum { MAX_NODES = 640 };

/* ---- two segments: a at rest along x, b moving */

static const vec3 a_nodes[2] = {{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};

static uint64_t pass_a(const vec3 start[2], const vec3 end[2])
{
    passing_chain chains[2] = {{a_nodes, a_nodes, 2, false}, {start, end, 2, false}};
    return passing_count(chains, 2, NULL);
}

static void expect_passing(uint64_t wanted, double start_0, double start_1, double end_0,
                           double end_1, double start_y, double end_y)
{
    vec3 start[2] = {vec3_make(0.0, -1.0, start_0), vec3_make(0.0, start_y, start_1)};
    vec3 end[2] = {vec3_make(0.0, -1.0, end_0), vec3_make(0.0, end_y, end_1)};
    assert_int_equal(wanted, pass_a(start, end));
}

static void crossing_is_found(void **state)
{
    (void)state;
    expect_passing(1, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0);
    expect_passing(1, 0x1p-40, 0x1p-40, -0x1p-40, -0x1p-40, 1.0, 1.0);
    expect_passing(0, 1.0, 1.0, 0x1p-40, 0x1p-40, 1.0, 1.0);
}

/* Over y = 0 the height of b is that of (1 - 2 t)(3 - 2 t) + start_1 + 4 t, a parabola with its least
 * value, 2 + start_1, in the middle. */
static void crossing_and_return_is_found(void **state)
{
    (void)state;
    expect_passing(1, 1.0, -2.25, -1.0, 1.75, 3.0, 1.0);
    expect_passing(0, 1.0, -1.75, -1.0, 2.25, 3.0, 1.0);
}

static void touching_is_exact(void **state)
{
    (void)state;
    double e = 0x1p-50;
    expect_passing(1, 1.0, -2.0, -1.0, 2.0, 3.0, 1.0);         /* in the middle of the step */
    expect_passing(0, 1.0, -2.0 + e, -1.0, 2.0 + e, 3.0, 1.0); /* not quite */
    expect_passing(1, 1.0, -2.0 - e, -1.0, 2.0 - e, 3.0, 1.0); /* a little more */
    expect_passing(1, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0);           /* at the end */
    expect_passing(1, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0);           /* at the beginning */
    expect_passing(0, 1.0, 1.0, 0x1p-1074, 0x1p-1074, 1.0, 1.0);
    expect_passing(1, 1.0, 1.0, -1.0, -1.0, 0.0, 0.0); /* with its very end */
    expect_passing(0, 1.0, 1.0, -1.0, -1.0, -0x1p-60, -0x1p-60);
}

/* ---- which pairs are asked */

static void adjacent_segments_are_skipped(void **state)
{
    (void)state;
    static const vec3 zigzag[5] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    static const vec3 pin[2] = {{0.5, -1.0, 0.0}, {0.5, 1.0, 0.0}};
    passing_chain thread = {zigzag, zigzag, 5, false}, tool = {zigzag, zigzag, 5, true};
    passing_chain axis = {pin, pin, 2, true}, strand = {pin, pin, 2, false};
    passing_report report;
    assert_int_equal(3, passing_count(&thread, 1, &report)); /* 0 2, 0 3, 1 3 */
    assert_int_equal(3, report.pairs);
    assert_int_equal(0, passing_count(&tool, 1, &report));
    assert_int_equal(0, report.pairs);
    passing_chain tools[2] = {tool, axis}, mixed[2] = {thread, axis}, crossed[2] = {tool, strand};
    assert_int_equal(0, passing_count(tools, 2, NULL));
    assert_int_equal(7, passing_count(mixed, 2, &report));
    assert_int_equal(7, report.pairs);
    assert_int_equal(4, passing_count(crossed, 2, &report));
    assert_int_equal(0, report.chains[0]);
    assert_int_equal(1, report.chains[1]);
    assert_int_equal(0, report.segments[0]);
    assert_int_equal(0, report.segments[1]);
}

static void empty_motion_has_no_crossing(void **state)
{
    (void)state;
    passing_chain point = {a_nodes, a_nodes, 1, false}, none = {NULL, NULL, 0, false};
    passing_chain both[2] = {point, none};
    assert_int_equal(0, passing_count(NULL, 0, NULL));
    assert_int_equal(0, passing_count(both, 2, NULL));
}

static void non_finite_motion_counts_as_crossing(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        vec3 far_away[2] = {vec3_make(5.0, 5.0, 5.0), vec3_make(6.0, 6.0, 6.0)};
        assert_int_equal(0, pass_a(far_away, far_away));
        far_away[1].y = harness_bad_numbers[i];
        assert_int_equal(1, pass_a(far_away, far_away));
        assert_int_equal(1, pass_a(a_nodes, far_away));
    }
}

/* ---- against rational arithmetic for every pair */

typedef struct chains {
    vec3 start[3][6], end[3][6];
    passing_chain chains[3];
} chains;

/* Anywhere; on few places, so that much touches, is parallel, or is of no length; or on few places beside
 * each other, which floating point can hardly tell apart. */
typedef enum spread { ANYWHERE, FEW, BESIDE, SPREADS } spread;

static vec3 draw_node(harness_source *source, spread how)
{
    vec3 x = harness_draw_vec3(source, 0.0, 3.0);
    vec3 place = vec3_make(floor(x.x), floor(x.y), floor(x.z));
    return how == ANYWHERE ? x
           : how == FEW    ? place
                           : vec3_add_scaled(vec3_make(1.3, 1.7, 1.9), 0x1p-52, place);
}

static void draw_chains(harness_source *source, chains *c)
{
    spread how = (spread)harness_draw_below(source, SPREADS);
    double reach = how != ANYWHERE ? 1.0 : harness_draw_real(source, 0.0, 0.5);
    for (int k = 0; k < 3; k++) {
        size_t nodes = k == 2 ? 2 : 2 + harness_draw_below(source, 5);
        for (size_t i = 0; i < nodes; i++) {
            c->start[k][i] = draw_node(source, how);
            c->end[k][i] = vec3_lerp(c->start[k][i], draw_node(source, how), reach);
        }
        c->chains[k] = (passing_chain){c->start[k], c->end[k], nodes, k == 2};
    }
}

static bool truth(const chains *c, int k, size_t i, int l, size_t j)
{
    collision_query query = {.kind = VBSS_COLLISION_PAIR_EDGE_EDGE};
    for (size_t n = 0; n < 2; n++) {
        vec3_store(query.start + 3 * n, c->start[k][i + n]);
        vec3_store(query.start + 6 + 3 * n, c->start[l][j + n]);
        vec3_store(query.end + 3 * n, c->end[k][i + n]);
        vec3_store(query.end + 6 + 3 * n, c->end[l][j + n]);
    }
    return oracle_meets(&query);
}

typedef struct totals {
    uint64_t pairs, asked, passed;
} totals;

static void agrees_with_the_truth(harness_source *source, void *user)
{
    totals *sum = user;
    chains c;
    passing_report report;
    uint64_t pairs = 0, passed = 0;
    draw_chains(source, &c);
    passing_count(c.chains, 3, &report);
    for (int k = 0; k < 3; k++) {
        for (int l = k; l < 3 && k < 2; l++) {
            for (size_t i = 0; i + 1 < c.chains[k].nodes; i++) {
                for (size_t j = k == l ? i + 2 : 0; j + 1 < c.chains[l].nodes; j++) {
                    pairs++;
                    passed += truth(&c, k, i, l, j) ? 1 : 0;
                }
            }
        }
    }
    assert_int_equal(pairs, report.pairs);
    assert_int_equal(passed, report.passed);
    assert_true(report.asked >= passed);
    if (passed > 0) {
        assert_true(truth(&c, (int)report.chains[0], report.segments[0], (int)report.chains[1],
                          report.segments[1]));
    }
    sum->pairs += pairs;
    sum->asked += report.asked;
    sum->passed += passed;
}

static void filter_and_rationals_agree(void **state)
{
    (void)state;
    totals sum = {0, 0, 0};
    harness_property("agrees with the truth", 600, agrees_with_the_truth, &sum);
    assert_true(sum.passed > 1000);
    assert_true(sum.pairs - sum.asked > 3000); /* proven without */
}

static vec3 draw_steps(harness_source *source)
{
    vec3 x = harness_draw_vec3(source, -3.0, 4.0);
    return vec3_make(floor(x.x), floor(x.y), floor(x.z));
}

/* b stands on the middle of a and leaves square to it, all within some units in the last place, or so small
 * that products vanish. The plane between them holds a: only rounding tells a side. */
static void leaves_square_to_it(harness_source *source, void *user)
{
    (void)user;
    bool tiny = harness_draw_below(source, 2) != 0;
    vec3 place = tiny ? vec3_zero() : vec3_make(1.3, 1.7, 1.9);
    vec3 along = draw_steps(source), up = draw_steps(source);
    double e = tiny ? 0x1p-538 : 0x1p-52, slope = floor(harness_draw_real(source, -2.0, 3.0));
    up = vec3_cross(along, up);
    vec3 aside = vec3_add_scaled(up, slope, along);
    vec3 a[2] = {vec3_add_scaled(place, -e, along), vec3_add_scaled(place, e, along)};
    vec3 start[2] = {place, vec3_add_scaled(place, e, aside)};
    vec3 end[2] = {vec3_add_scaled(start[0], e, up), vec3_add_scaled(start[1], e, up)};
    passing_chain both[2] = {{a, a, 2, false}, {start, end, 2, false}};
    assert_int_equal(1, passing_count(both, 2, NULL));
    passing_chain turned[2] = {both[1], both[0]};
    assert_int_equal(1, passing_count(turned, 2, NULL));
}

static void rounding_proves_no_crossing(void **state)
{
    (void)state;
    harness_property("leaves square to it", 500, leaves_square_to_it, NULL);
}

/* ---- knots in motion */

typedef struct moving_knot {
    knot_line line;
    vec3 start[MAX_NODES], end[MAX_NODES];
} moving_knot;

static void make_knot(moving_knot *m, knot_kind kind)
{
    static double rest_lengths[MAX_NODES];
    knot_shape shape;
    knot_shape_init(&shape, kind);
    shape.cylinder = true;
    expect_ok(knot_make(&shape, MAX_NODES, m->start, rest_lengths, &m->line));
}

static passing_report report_of(const moving_knot *m)
{
    vec3 axis[2] = {m->line.cylinder_begin, m->line.cylinder_end};
    passing_chain both[2] = {{m->start, m->end, m->line.node_count, false}, {axis, axis, 2, true}};
    passing_report report;
    passing_count(both, 2, &report);
    return report;
}

/* A millisecond of violent motion: 3 m/s with a share of each node's own. */
static void shake(harness_source *source, moving_knot *m, double own)
{
    vec3 all = harness_draw_vec3(source, -1e-3, 1e-3);
    all.x = all.z = 0.0; /* along the cylinder */
    for (uint32_t i = 0; i < m->line.node_count; i++) {
        vec3 alone = harness_draw_vec3(source, -own, own);
        m->end[i] = vec3_add(m->start[i], vec3_add(all, alone));
    }
}

static void knots_that_shake_are_clean(harness_source *source, void *user)
{
    (void)user;
    static moving_knot m;
    make_knot(&m, (knot_kind)harness_draw_below(source, KNOT_KINDS));
    shake(source, &m, 0.05e-3); /* strands are 0.33 mm apart at least */
    passing_report report = report_of(&m);
    uint64_t segments = m.line.node_count - 1;
    assert_int_equal(segments * (segments - 1) / 2 - (segments - 1) + segments, report.pairs);
    assert_int_equal(0, report.passed);
    assert_int_equal(0, report.asked); /* all by bounds */
}

static void clean_motion_needs_no_exact_test(void **state)
{
    (void)state;
    harness_property("clean", 60, knots_that_shake_are_clean, NULL);
}

/* The middle crossing of the first throw is turned round: its strands go through each other. */
static void untied_knot_is_detected(void **state)
{
    (void)state;
    static moving_knot m;
    make_knot(&m, KNOT_OVERHAND);
    for (uint32_t i = 0; i < m.line.node_count; i++) {
        m.end[i] = m.start[i];
        if (m.start[i].z > -0.5e-3 && fabs(m.start[i].x) < 0.75e-3) {
            m.end[i].y = -m.start[i].y;
        }
    }
    passing_report report = report_of(&m);
    assert_true(report.passed >= 1 && report.passed <= 4);
    assert_true(report.asked <= 200);
    assert_int_equal(0, report.chains[0]);
    assert_int_equal(0, report.chains[1]);
    assert_true(report.segments[1] > report.segments[0] + 10);
}

/* The whole knot is lifted off its cylinder within one step. */
static void loop_leaving_its_cylinder_is_detected(void **state)
{
    (void)state;
    static moving_knot m;
    make_knot(&m, KNOT_SQUARE);
    for (uint32_t i = 0; i < m.line.node_count; i++) {
        m.end[i] = vec3_add(m.start[i], vec3_make(0.0, 0.0, 0.01));
    }
    passing_report report = report_of(&m);
    assert_true(report.passed >= 1 && report.passed <= 2);
    assert_int_equal(1, report.chains[1]);
    for (uint32_t i = 0; i < m.line.node_count; i++) {
        m.end[i] = vec3_add(m.start[i], vec3_make(0.0, 0.0, -1e-3));
    }
    assert_int_equal(0, report_of(&m).passed);
}

int test_passage(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossing_is_found),
        cmocka_unit_test(crossing_and_return_is_found),
        cmocka_unit_test(touching_is_exact),
        cmocka_unit_test(adjacent_segments_are_skipped),
        cmocka_unit_test(empty_motion_has_no_crossing),
        cmocka_unit_test(non_finite_motion_counts_as_crossing),
        harness_test(filter_and_rationals_agree),
        harness_test(rounding_proves_no_crossing),
        harness_test(clean_motion_needs_no_exact_test),
        cmocka_unit_test(untied_knot_is_detected),
        cmocka_unit_test(loop_leaving_its_cylinder_is_detected),
    };
    return cmocka_run_group_tests_name("contact.passage", tests, NULL, NULL);
}
