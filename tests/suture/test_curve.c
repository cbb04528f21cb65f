/* The thread as a smooth curve: where it goes, what is nearest on it, how weights and tangents change along it. */
#include "curve_fixture.h"

enum { NODES = 9, FEWEST = 3 };

static void draw(harness_source *source, laid *l, uint32_t count)
{
    vec3 begin = harness_draw_vec3(source, -0.1, 0.1);
    vec3 direction = harness_draw_vec3(source, -1.0, 1.0);
    place_any(source, l, count, begin, vec3_unit_or(direction, vec3_make(1.0, 0.0, 0.0)));
}

static void draw_any_count(harness_source *source, laid *l)
{
    draw(source, l, FEWEST + harness_draw_below(source, NODES + 1 - FEWEST));
}

/* The begin of the span of a node's segment, or the end of the last. */
static hand_place joint(const laid *l, uint32_t node)
{
    bool end = node + 1 == l->thread.node_count;
    return by_hand(l, end ? node - 1 : node, end ? 1.0 : 0.0);
}

/* ---- where it goes */

/* From either side, ends and what is straight beyond them included. */
static void any_joint_has_no_step(harness_source *source, void *user)
{
    (void)user;
    laid l;
    draw_any_count(source, &l);
    for (uint32_t i = 0; i < l.thread.node_count; i++) {
        const hand_place wanted = joint(&l, i);
        expect_no_step(&l.line, &wanted, tangent_by_hand(&wanted), true);
    }
}

static void spans_join_with_continuous_curvature(void **state)
{
    (void)state;
    harness_property("joints", 200, any_joint_has_no_step, NULL);
}

/* It begins in the first node and ends in the last; on from there it is straight, and as long as the thread would be. */
static void any_end_goes_on_straight(harness_source *source, void *user)
{
    (void)user;
    laid l;
    draw_any_count(source, &l);
    const uint32_t last = l.thread.node_count - 1;
    for (int end = 0; end < 2; end++) {
        const vec3 back = back_along(&l, end ? last - 1 : 0), node = l.x[end ? last : 0];
        const double arc = end ? vbss_thread_arc_length(&l.thread, last) : 0.0;
        for (int i = 0; i <= 20; i++) {
            const double on = 1e-4 * i * (end ? 1.0 : -1.0);
            const vec3 wanted = vec3_add_scaled(node, -on, back);
            vec3 aside = vec3_cross(back, harness_draw_vec3(source, -1e-4, 1e-4));
            const suture_curve_point place =
                vbss_suture_nearest_point(&l.line, arc, vec3_add(wanted, aside));
            expect_near(0.0, vec3_distance(wanted, place.position), 1e-15);
            expect_near(0.0, vec3_distance(wanted, point_by_weights(&l, &place)), 1e-15);
            expect_near(0.0, vec3_distance(back, place.tangent), 1e-12);
            expect_near(arc + on, place.arc, 1e-15);
            expect_near(0.0, vec3_norm(place.curvature), 1e-8);
            assert_int_equal(place.span, end ? last - 1 : 0);
        }
    }
}

static void curve_ends_in_last_nodes_and_extends_straight(void **state)
{
    (void)state;
    harness_property("ends", 100, any_end_goes_on_straight, NULL);
}

/* Whatever the segments are: arc length and place have the same weights. Also beyond the ends. */
static void straight_thread_is_measured_exactly(void **state)
{
    (void)state;
    const double rest[2][6] = {{1e-3, 0.2e-3, 3e-3, 0.5e-3, 0.5e-3, 1.7e-3},
                               {1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3}};
    const vec3 direction = vec3_make(0.48, -0.6, 0.64), aside = vec3_make(0.8, 0.0, -0.6);
    for (int which = 0; which < 2; which++) {
        laid l;
        place_nodes(&l, 7);
        l.x[0] = vec3_make(0.01, 0.02, 0.03);
        for (uint32_t i = 1; i < 7; i++) {
            place_on(&l, i, rest[which][i - 1], direction);
        }
        for (int i = -40; i <= 110; i++) {
            double arc = 1e-4 * i;
            vec3 on = vec3_add_scaled(l.x[0], arc, direction), moved = vec3_zero();
            const suture_curve_point place =
                vbss_suture_nearest_point(&l.line, 3e-3, vec3_add_scaled(on, 0.4e-3, aside));
            expect_near(arc, place.arc, 1e-15);
            expect_near(0.0, vec3_distance(on, place.position), 1e-15);
            expect_near(0.0, vec3_distance(vec3_neg(direction), place.tangent), 1e-12);
            expect_near(0.0, vec3_distance(point_by_weights(&l, &place), on), 1e-15);
            expect_near(0.0, vec3_norm(place.curvature), 1e-8);
            /* Weights of what slides on: their slopes move the point by as much. */
            for (uint32_t k = 0; k < 7; k++) {
                moved =
                    vec3_add_scaled(moved, number_of(&place, place.weight_derivatives, k), l.x[k]);
            }
            expect_near(0.0, vec3_distance(moved, direction), 1e-9);
        }
    }
}

/* ---- what is nearest */

/* It is a stationary point, and nothing that is sampled within a span and a half is nearer. */
static void any_nearest_place_is_one(harness_source *source, void *user)
{
    int *inside = user;
    laid l;
    draw(source, &l, NODES);
    double from = harness_draw_real(source, 0.0, 8e-3);
    uint32_t by = harness_draw_below(source, NODES);
    vec3 to = vec3_add(l.x[by], harness_draw_vec3(source, -0.8e-3, 0.8e-3));
    const suture_curve_point place = vbss_suture_nearest_point(&l.line, from, to);
    expect_near(0.0, vec3_dot(place.tangent, vec3_sub(place.position, to)), 1e-12);
    expect_near(0.0, vec3_distance(place.position, point_by_weights(&l, &place)), 1e-15);
    expect_near(1.0, sum_of_weights(&l, &place), 1e-12);
    expect_near(1.0, vec3_norm(place.tangent), 1e-12);
    double smallest = HUGE_VAL, off = vec3_distance(place.position, to);
    uint32_t low = place.span > 0 ? place.span - 1 : 0;
    uint32_t high = place.span + 2 < NODES ? place.span + 1 : NODES - 2;
    for (uint32_t k = low; k <= high; k++) {
        for (int i = 0; i <= 200; i++) {
            smallest = fmin(smallest, vec3_distance(by_hand(&l, k, i / 200.0).point, to));
        }
    }
    assert_true(off <= smallest + 1e-12);
    *inside += off > smallest - 1e-6; /* not beyond an end */
}

static void nearest_point_is_perpendicular_and_minimal(void **state)
{
    (void)state;
    int inside = 0;
    harness_property("nearest", 500, any_nearest_place_is_one, &inside);
    assert_true(inside > 300);
}

/* From wherever the search begins on a thread that is nearly straight; and no further than a span beside the one given. */
static void search_ends_at_expected_point(void **state)
{
    (void)state;
    laid l;
    place_nodes(&l, NODES);
    for (uint32_t i = 1; i < NODES; i++) {
        place_on(&l, i, 1e-3, vec3_make(1.0, 0.0, 0.0));
    }
    for (int i = -7; i <= 87; i++) { /* no joint is met */
        double arc = 1e-4 * i + 0.3e-4;
        uint32_t wanted = arc < 0.0 ? 0 : arc > 8e-3 ? NODES - 2 : (uint32_t)(arc * 1e3);
        assert_int_equal(vbss_suture_span_at(&l.line, arc), wanted);
        for (int from = -2; from <= 10; from++) {
            vec3 to = vec3_make(arc, 0.3e-3, 0.0);
            expect_near(arc, vbss_suture_nearest_point(&l.line, 1e-3 * from, to).arc, 1e-15);
            assert_int_equal(vbss_suture_nearest_point(&l.line, 1e-3 * from, to).span, wanted);
        }
    }
    assert_int_equal(vbss_suture_span_at(&l.line, -1.0), 0);
    assert_int_equal(vbss_suture_span_at(&l.line, 1.0), NODES - 2);
    for (uint32_t by = 0; by + 1 < NODES; by++) {
        for (int i = -2; i <= 10; i++) {
            const suture_curve_point place = vbss_suture_nearest_point_around_span(
                &l.line, by, 1e-3 * by, vec3_make(1e-3 * i, 0.1e-3, 0.0));
            assert_true(place.span + 1 >= by && place.span <= by + 1);
            for (uint32_t k = 0; k < SUTURE_SPAN_NODES; k++) { /* nothing of nodes that are not */
                bool node = place.first_node + k < NODES;
                assert_true(node ||
                            (place.weights[k] == 0.0 && place.weight_derivatives[k] == 0.0));
            }
            expect_near(1e-3 * i, place.arc, 1e-15); /* beyond, straight on along its span */
        }
    }
}

/* Where the spans that are looked at end it goes on straight, along their end and as fast, though the thread is bent. */
static void any_search_beside_a_span_goes_on_straight(harness_source *source, void *user)
{
    (void)user;
    laid l;
    draw(source, &l, NODES);
    uint32_t by = 2 + harness_draw_below(source, NODES - 5);
    for (int end = 0; end < 2; end++) {
        const hand_place at = by_hand(&l, end ? by + 1 : by - 1, end ? 1.0 : 0.0);
        const vec3 back = tangent_by_hand(&at);
        const double speed = vec3_norm(at.derivative), on = end ? 0.4e-3 : -0.4e-3;
        const vec3 wanted = vec3_add_scaled(at.point, -on, back);
        vec3 aside = vec3_cross(back, harness_draw_vec3(source, -1e-4, 1e-4)), total = vec3_zero();
        const suture_curve_point place =
            vbss_suture_nearest_point_around_span(&l.line, by, at.arc, vec3_add(wanted, aside));
        expect_near(0.0, vec3_distance(wanted, place.position), 1e-15);
        expect_near(0.0, vec3_distance(wanted, point_by_weights(&l, &place)), 1e-15);
        expect_near(0.0, vec3_distance(back, place.tangent), 1e-12);
        expect_near(at.arc + on * at.rate / speed, place.arc, 1e-15);
        expect_near(0.0, vec3_norm(place.curvature), 0.0);
        for (uint32_t k = 0; k < NODES; k++) {
            total = vec3_add_scaled(total, number_of(&place, place.weight_derivatives, k), l.x[k]);
        }
        expect_near(0.0, vec3_distance(vec3_neg(back), total), 1e-9);
    }
}

static void search_extends_straight_beside_span(void **state)
{
    (void)state;
    harness_property("beside", 200, any_search_beside_a_span_goes_on_straight, NULL);
}

/* The span in which an arc length is, where segments differ and the thread is bent: that of the place which has it. */
static void any_arc_is_in_its_span(harness_source *source, void *user)
{
    (void)user;
    laid l;
    draw_any_count(source, &l);
    uint32_t span = harness_draw_below(source, l.thread.node_count - 1);
    const hand_place wanted = by_hand(&l, span, harness_draw_real(source, 0.01, 0.99));
    assert_int_equal(vbss_suture_span_at(&l.line, wanted.arc), span);
    const suture_curve_point place = vbss_suture_nearest_point(&l.line, wanted.arc, wanted.point);
    assert_int_equal(place.span, span);
    expect_near(wanted.arc, place.arc, 1e-12);
    expect_near(0.0, vec3_distance(wanted.point, place.position), 1e-12);
    expect_near(0.0, vec3_distance(tangent_by_hand(&wanted), place.tangent), 1e-9);
    expect_near(0.0, vec3_distance(turn_by_hand(&wanted), place.curvature), 1e-6);
}

static void arc_length_matches_span_of_point(void **state)
{
    (void)state;
    harness_property("spans", 300, any_arc_is_in_its_span, NULL);
}

/* ---- how it changes */

/* By the length of the curve as it is, whatever the thread's at rest; over joints too, as nothing has a step there. */
static void any_slopes_are_those_of_weights_and_tangent(harness_source *source, void *user)
{
    const double step = 1e-9;
    int *joints = user;
    laid l;
    draw(source, &l, NODES);
    for (uint32_t i = 0; i + 1 < NODES; i++) {
        l.rest[i] *= harness_draw_real(source, 0.7, 1.4);
    }
    uint32_t by = harness_draw_below(source, NODES);
    const hand_place at = joint(&l, by);
    vec3 aside = vec3_scale(tangent_by_hand(&at), harness_draw_real(source, -0.4e-3, 0.4e-3));
    if (harness_draw_below(source, 4) == 0) { /* on the joint itself */
        aside = vec3_zero();
    }
    const suture_curve_point here =
        vbss_suture_nearest_point(&l.line, at.arc, vec3_add(at.point, aside));
    const vec3 back = vec3_add_scaled(here.position, step, here.tangent);
    const vec3 on = vec3_add_scaled(here.position, -step, here.tangent);
    const suture_curve_point a = vbss_suture_nearest_point(&l.line, here.arc, back);
    const suture_curve_point b = vbss_suture_nearest_point(&l.line, here.arc, on);
    double far = vec3_distance(a.position, b.position);
    vec3 moved = vec3_zero();
    assert_true(far > 0.0);
    for (uint32_t k = 0; k < NODES; k++) {
        double slope = number_of(&here, here.weight_derivatives, k);
        double change = number_of(&b, b.weights, k) - number_of(&a, a.weights, k);
        expect_near(change / far, slope, 2e-3);
        moved = vec3_add_scaled(moved, slope, l.x[k]);
    }
    expect_near(0.0, vec3_distance(vec3_neg(here.tangent), moved), 1e-9);
    vec3 turn = vec3_scale(vec3_sub(b.tangent, a.tangent), 1.0 / far);
    expect_near(0.0, vec3_distance(turn, here.curvature), 2e-3);
    expect_near(0.0, vec3_dot(here.curvature, here.tangent), 1e-9);
    *joints += a.span != b.span;
}

static void jacobian_matches_weights_and_tangent(void **state)
{
    (void)state;
    int joints = 0;
    harness_property("slopes", 500, any_slopes_are_those_of_weights_and_tangent, &joints);
    assert_true(joints > 50);
}

int test_curve(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(spans_join_with_continuous_curvature),
        harness_test(curve_ends_in_last_nodes_and_extends_straight),
        cmocka_unit_test(straight_thread_is_measured_exactly),
        harness_test(nearest_point_is_perpendicular_and_minimal),
        cmocka_unit_test(search_ends_at_expected_point),
        harness_test(search_extends_straight_beside_span),
        harness_test(arc_length_matches_span_of_point),
        harness_test(jacobian_matches_weights_and_tangent),
    };
    return cmocka_run_group_tests_name("suture.curve", tests, NULL, NULL);
}
