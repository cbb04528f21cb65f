/* The thread as a smooth curve: where it goes through, what is nearest on it, how weights and tangents change along it. */
#include "curve_fixture.h"

enum { NODES = 9 };

static void draw(harness_source *source, laid *l)
{
    vec3 begin = harness_draw_vec3(source, -0.1, 0.1);
    vec3 way = harness_draw_vec3(source, -1.0, 1.0);
    lay_any(source, l, NODES, begin, vec3_unit_or(way, vec3_make(1.0, 0.0, 0.0)));
}

/* ---- where it goes */

/* The joints of its spans, from either side: no step in place, direction or arc length. */
static void any_curve_goes_through_middles(harness_source *source, void *user)
{
    (void)user;
    laid l;
    draw(source, &l);
    for (uint32_t i = 0; i + 1 < NODES; i++) {
        const vec3 middle = middle_of(&l, i), back = back_along(&l, i);
        const double arc = arc_of_middle(&l, i);
        for (int side = -1; side <= 1; side++) {
            vec3 near = vec3_add_scaled(middle, -1e-10 * side, back);
            const suture_place place = vbss_suture_nearest(&l.line, arc + 1e-5 * side, near);
            expect_near(0.0, vec3_distance(middle, place.point), 1.1e-10);
            expect_near(0.0, vec3_distance(back, place.tangent), 1e-6);
            expect_near(arc, place.arc, 1.1e-10);
        }
    }
}

static void it_goes_through_the_middles_of_segments_along_them(void **state)
{
    (void)state;
    harness_property("middles", 100, any_curve_goes_through_middles, NULL);
}

/* Also beyond the middles of the first and the last segment, and beyond the ends. */
static void a_straight_thread_is_measured_exactly(void **state)
{
    (void)state;
    const double rest[6] = {1e-3, 0.2e-3, 3e-3, 0.5e-3, 0.5e-3, 1.7e-3};
    const vec3 way = vec3_make(0.48, -0.6, 0.64), aside = vec3_make(0.8, 0.0, -0.6);
    laid l;
    lay_nodes(&l, 7);
    l.x[0] = vec3_make(0.01, 0.02, 0.03);
    for (uint32_t i = 1; i < 7; i++) {
        lay_on(&l, i, rest[i - 1], way);
    }
    for (int i = -40; i <= 110; i++) {
        double arc = 1e-4 * i;
        vec3 on = vec3_add_scaled(l.x[0], arc, way);
        const suture_place place =
            vbss_suture_nearest(&l.line, 3e-3, vec3_add_scaled(on, 0.4e-3, aside));
        expect_near(arc, place.arc, 1e-15);
        expect_near(0.0, vec3_distance(on, place.point), 1e-15);
        expect_near(0.0, vec3_distance(vec3_neg(way), place.tangent), 1e-12);
        expect_near(0.0, vec3_distance(point_by_weights(&l.line, &place), on), 1e-15);
        expect_near(0.0, vec3_norm(place.turn), 1e-8);
        /* Weights of what slides on: their slopes move the point by as much. */
        vec3 moved = vec3_zero();
        for (uint32_t k = 0; k < 3; k++) {
            moved = vec3_add_scaled(moved, place.slopes[k], l.x[place.first + k]);
        }
        expect_near(0.0, vec3_distance(moved, way), 1e-9);
    }
}

/* ---- what is nearest */

/* It is a stationary point, and nothing that is sampled within a span and a half is nearer. */
static void any_nearest_place_is_one(harness_source *source, void *user)
{
    int *inside = user;
    laid l;
    draw(source, &l);
    double from = harness_draw_real(source, 0.0, 8e-3);
    uint32_t by = harness_draw_below(source, NODES);
    vec3 to = vec3_add(l.x[by], harness_draw_vec3(source, -0.8e-3, 0.8e-3));
    const suture_place place = vbss_suture_nearest(&l.line, from, to);
    expect_near(0.0, vec3_dot(place.tangent, vec3_sub(place.point, to)), 1e-12);
    expect_near(0.0, vec3_distance(place.point, point_by_weights(&l.line, &place)), 1e-15);
    expect_near(1.0, place.weights[0] + place.weights[1] + place.weights[2], 1e-12);
    expect_near(1.0, vec3_norm(place.tangent), 1e-12);
    /* Of de Casteljau's parabolas, by hand. */
    double least = HUGE_VAL, off = vec3_distance(place.point, to);
    uint32_t low = place.span > 1 ? place.span - 1 : 1;
    uint32_t high = place.span + 1 < NODES - 1 ? place.span + 1 : NODES - 2;
    for (uint32_t k = low; k <= high; k++) {
        for (int i = 0; i <= 200; i++) {
            double u = i / 200.0;
            vec3 a = vec3_lerp(middle_of(&l, k - 1), l.x[k], u);
            vec3 b = vec3_lerp(l.x[k], middle_of(&l, k), u);
            least = fmin(least, vec3_distance(vec3_lerp(a, b, u), to));
        }
    }
    assert_true(off <= least + 1e-12);
    *inside += off > least - 1e-6; /* not beyond an end */
}

static void the_nearest_place_is_square_and_nothing_nearby_is_nearer(void **state)
{
    (void)state;
    int inside = 0;
    harness_property("nearest", 500, any_nearest_place_is_one, &inside);
    assert_true(inside > 300);
}

/* From wherever the search begins on a thread that is nearly straight; and no further than a span beside the one given. */
static void the_search_ends_where_it_should(void **state)
{
    (void)state;
    laid l;
    lay_nodes(&l, NODES);
    for (uint32_t i = 1; i < NODES; i++) {
        lay_on(&l, i, 1e-3, vec3_make(1.0, 0.0, 0.0));
    }
    for (uint32_t k = 1; k + 1 < NODES; k++) {
        for (int i = -4; i <= 4; i++) {
            double arc = 1e-3 * k + 1.2e-4 * i;
            uint32_t wanted = arc >= 7.5e-3 ? 7 : arc <= 0.5e-3 ? 1 : (uint32_t)(arc * 1e3 + 0.5);
            assert_int_equal(vbss_suture_span_at(&l.line, arc), wanted);
            for (int from = -2; from <= 10; from++) {
                vec3 to = vec3_make(arc, 0.3e-3, 0.0);
                expect_near(arc, vbss_suture_nearest(&l.line, 1e-3 * from, to).arc, 1e-15);
                assert_int_equal(vbss_suture_nearest(&l.line, 1e-3 * from, to).span, wanted);
            }
        }
    }
    assert_int_equal(vbss_suture_span_at(&l.line, -1.0), 1);
    assert_int_equal(vbss_suture_span_at(&l.line, 1.0), NODES - 2);
    for (uint32_t by = 1; by + 1 < NODES; by++) {
        for (int i = -2; i <= 10; i++) {
            const suture_place place =
                vbss_suture_nearest_by(&l.line, by, 1e-3 * by, vec3_make(1e-3 * i, 0.1e-3, 0.0));
            assert_true(place.span + 1 >= by && place.span <= by + 1);
            assert_true(place.first + 2 < NODES);
            expect_near(1e-3 * i, place.arc, 1e-15); /* beyond, straight on along its segment */
        }
    }
}

/* ---- how it changes */

/* Along the curve: the change from place to place, by arc length. */
static void any_slopes_are_those_of_weights_and_tangent(harness_source *source, void *user)
{
    const double step = 1e-8;
    int *seen = user;
    laid l;
    draw(source, &l);
    uint32_t by = 1 + harness_draw_below(source, NODES - 2);
    vec3 to = vec3_add(l.x[by], harness_draw_vec3(source, -0.3e-3, 0.3e-3));
    const suture_place here = vbss_suture_nearest(&l.line, 1e-3 * by, to);
    const vec3 back = vec3_add_scaled(here.point, step, here.tangent);
    const vec3 on = vec3_add_scaled(here.point, -step, here.tangent);
    const suture_place a = vbss_suture_nearest(&l.line, here.arc, back);
    const suture_place b = vbss_suture_nearest(&l.line, here.arc, on);
    double far = b.arc - a.arc;
    assert_true(far > 0.0);
    if (a.span != here.span || b.span != here.span ||
        (vec3_norm(a.turn) > 0.0) != (vec3_norm(b.turn) > 0.0)) {
        return; /* at a joint its curvature has a step */
    }
    for (int k = 0; k < 3; k++) {
        expect_near((b.weights[k] - a.weights[k]) / far, here.slopes[k], 1e-2);
    }
    vec3 turn = vec3_scale(vec3_sub(b.tangent, a.tangent), 1.0 / far);
    expect_near(0.0, vec3_distance(turn, here.turn), 1e-2);
    expect_near(0.0, vec3_dot(here.turn, here.tangent), 1e-9);
    (*seen)++;
}

static void slopes_and_turn_are_those_of_weights_and_tangent(void **state)
{
    (void)state;
    int seen = 0;
    harness_property("slopes", 500, any_slopes_are_those_of_weights_and_tangent, &seen);
    assert_true(seen > 400);
}

int test_curve(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(it_goes_through_the_middles_of_segments_along_them),
        cmocka_unit_test(a_straight_thread_is_measured_exactly),
        harness_test(the_nearest_place_is_square_and_nothing_nearby_is_nearer),
        cmocka_unit_test(the_search_ends_where_it_should),
        harness_test(slopes_and_turn_are_those_of_weights_and_tangent),
    };
    return cmocka_run_group_tests_name("suture.curve", tests, NULL, NULL);
}
