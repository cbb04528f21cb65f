/* From the needle over the swage to the thread: one curve by one arc length. */
#include "curve_fixture.h"
#include "fixture.h"

enum { NODES = 8 };

/* A needle anywhere, and a thread that leaves it some degrees off where it points and then bends. */
static void draw(harness_source *source, const fixture *f, laid *l)
{
    const double swage = vbss_needle_length(f->n);
    vec3 position = harness_draw_vec3(source, -0.1, 0.1);
    const pose at = pose_make(position, harness_draw_unit_quat(source));
    vec3 begin = pose_apply(at, vbss_needle_point(f->n, swage));
    vec3 direction = vec3_neg(quat_rotate(at.orientation, vbss_needle_direction(f->n, swage)));
    direction = vec3_unit_or(vec3_add(direction, harness_draw_vec3(source, -0.3, 0.3)), direction);
    place_any(source, l, NODES, begin, direction);
    l->line.needle = f->n;
    l->line.needle_pose = at;
    l->line.swage_arc = swage;
}

/* Where the needle points at its end. */
static vec3 end_of_needle(const laid *l)
{
    const suture_curve *line = &l->line;
    return quat_rotate(line->needle_pose.orientation,
                       vbss_needle_direction(line->needle, line->swage_arc));
}

/* ---- the span over the swage by hand, a Bezier curve */

static void de_casteljau(const vec3 corner[4], double u, vec3 found[3])
{
    const vec3 a = vec3_lerp(corner[0], corner[1], u), b = vec3_lerp(corner[1], corner[2], u);
    const vec3 c = vec3_lerp(corner[2], corner[3], u);
    const vec3 d = vec3_lerp(a, b, u), e = vec3_lerp(b, c, u);
    found[0] = vec3_lerp(d, e, u);
    found[1] = vec3_scale(vec3_sub(e, d), 3.0);
    found[2] = vec3_scale(vec3_sub(vec3_sub(c, b), vec3_sub(b, a)), 6.0);
}

/* It leaves the needle's end along the needle, as fast as the first segment is long, and goes over into the next span. */
static hand_place swage_by_hand(const laid *l, double u)
{
    const hand_place next = by_hand(l, 1, 0.0);
    const vec3 out = vec3_scale(end_of_needle(l), -l->rest[0]);
    const vec3 points[4] = {l->x[0], vec3_add_scaled(l->x[0], 1.0 / 3.0, out),
                            vec3_add_scaled(next.point, -1.0 / 3.0, next.derivative), next.point};
    const double begin = l->line.swage_arc;
    const vec3 arcs[4] = {{begin, 0.0, 0.0},
                          {begin + l->rest[0] / 3.0, 0.0, 0.0},
                          {next.arc - next.rate / 3.0, 0.0, 0.0},
                          {next.arc, 0.0, 0.0}};
    vec3 at[3], length[3];
    de_casteljau(points, u, at);
    de_casteljau(arcs, u, length);
    return (hand_place){at[0], at[1], at[2], length[0].x, length[1].x};
}

/* ---- where it goes */

/* In small steps of the point along the curve: arc lengths grow, the place has no step and its direction no corner: it turns
 * by no more than it is bent. */
static void any_curve_goes_on_over_the_swage(harness_source *source, void *user)
{
    const fixture *f = user;
    laid l;
    draw(source, f, &l);
    const double step = 2e-6, swage = l.line.swage_arc, of_needle = 1.0 / f->n->config.radius;
    const vec3 first = vbss_needle_point(f->n, swage - 1e-3);
    suture_curve_point before =
        vbss_suture_nearest_point(&l.line, swage - 1e-3, pose_apply(l.line.needle_pose, first));
    double bent_before = of_needle;
    expect_near(swage - 1e-3, before.arc, 1e-12);
    assert_int_equal(before.span, SUTURE_ON_NEEDLE);
    int passed = 0;
    for (int i = 0; i < 1500; i++) {
        vec3 on = vec3_add_scaled(before.position, -step, before.tangent);
        const suture_curve_point place = vbss_suture_nearest_point(&l.line, before.arc, on);
        bool needle = place.span == SUTURE_ON_NEEDLE;
        double bent = needle ? of_needle : vec3_norm(place.curvature);
        double turned = vec3_distance(before.tangent, place.tangent);
        assert_true(place.arc > before.arc + 0.5 * step && place.arc < before.arc + 2.0 * step);
        assert_true(vec3_distance(place.position, before.position) < 1.01 * step);
        expect_near(0.0, vec3_distance(place.position, point_by_weights(&l, &place)), 1e-14);
        expect_near(1.0, sum_of_weights(&l, &place), 1e-12);
        /* 1e-5: where a span ends within a step, it may be bent more there. */
        assert_true(turned < 1.001 * step * fmax(bent, bent_before) + 1e-5);
        if (!needle && before.span == SUTURE_ON_NEEDLE) {
            expect_near(swage, place.arc, 1.01 * step);
            passed++;
        }
        bent_before = bent;
        before = place;
    }
    assert_int_equal(passed, 1);
    assert_true(before.span >= 1 && before.span != SUTURE_ON_NEEDLE);
}

static void curve_is_smooth_over_swage(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("swage", 20, any_curve_goes_on_over_the_swage, &f);
    end(&f);
}

/* It begins in the needle's end along the needle; the spans behind join it in place, direction and arc length. Its curvature
 * has a step there, which it has not from the second node on. */
static void any_joint_has_no_step(harness_source *source, void *user)
{
    const fixture *f = user;
    laid l;
    draw(source, f, &l);
    for (uint32_t i = 0; i + 1 < NODES; i++) {
        const hand_place wanted = i == 0 ? swage_by_hand(&l, 0.0) : by_hand(&l, i, 0.0);
        const vec3 along = i == 0 ? end_of_needle(&l) : tangent_by_hand(&wanted);
        expect_no_step(&l.line, &wanted, along, i >= 2);
    }
    expect_near(0.0, vec3_distance(swage_by_hand(&l, 0.0).point, l.x[0]), 0.0);
    expect_near(l.line.swage_arc, swage_by_hand(&l, 0.0).arc, 0.0);
}

static void curve_leaves_needle_tangentially_and_joins_thread(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("joints", 100, any_joint_has_no_step, &f);
    end(&f);
}

/* ---- the search */

/* Back and forth, from either side: on the needle before its end, on the first span behind. */
static void any_search_passes_the_swage(harness_source *source, void *user)
{
    const fixture *f = user;
    laid l;
    draw(source, f, &l);
    for (int i = -30; i <= 9; i++) {
        const double before = l.line.swage_arc + 1e-4 * i;
        const hand_place behind = swage_by_hand(&l, 0.05 + 0.1 * i);
        const bool needle = i < 0;
        vec3 to =
            needle ? pose_apply(l.line.needle_pose, vbss_needle_point(f->n, before)) : behind.point;
        const double arc = needle ? before : behind.arc;
        for (int from = -20; from <= 20; from++) {
            const suture_curve_point place =
                vbss_suture_nearest_point(&l.line, l.line.swage_arc + 1e-4 * from, to);
            expect_near(arc, place.arc, 1e-12);
            expect_near(0.0, vec3_distance(to, place.position), 1e-12);
            assert_int_equal(place.span, needle ? SUTURE_ON_NEEDLE : 0);
            if (!needle) {
                expect_near(0.0, vec3_distance(tangent_by_hand(&behind), place.tangent), 1e-9);
                expect_near(0.0, vec3_distance(turn_by_hand(&behind), place.curvature), 1e-6);
            }
        }
        assert_int_equal(vbss_suture_span_at(&l.line, arc), 0);
    }
}

static void search_crosses_swage_in_both_directions(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("search", 5, any_search_passes_the_swage, &f);
    end(&f);
}

/* Beside the curve: a stationary point, and nothing that is sampled on the span over the swage and the next is nearer. */
static void any_nearest_place_is_one(harness_source *source, void *user)
{
    const fixture *f = user;
    laid l;
    draw(source, f, &l);
    const hand_place by = swage_by_hand(&l, harness_draw_real(source, 0.0, 1.0));
    vec3 to = vec3_add(by.point, harness_draw_vec3(source, -0.3e-3, 0.3e-3));
    double from = l.line.swage_arc + harness_draw_real(source, -1e-3, 2e-3);
    const suture_curve_point place = vbss_suture_nearest_point(&l.line, from, to);
    double smallest = HUGE_VAL;
    expect_near(0.0, vec3_dot(place.tangent, vec3_sub(place.position, to)), 1e-12);
    for (int i = 0; i <= 200; i++) {
        smallest = fmin(smallest, vec3_distance(swage_by_hand(&l, i / 200.0).point, to));
        smallest = fmin(smallest, vec3_distance(by_hand(&l, 1, i / 200.0).point, to));
    }
    assert_true(vec3_distance(place.position, to) <= smallest + 1e-12);
}

static void nearest_point_is_perpendicular_and_minimal(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("nearest", 300, any_nearest_place_is_one, &f);
    end(&f);
}

/* A needle alone is its arc, straight beyond its ends; so is a thread alone where there is no needle. */
static void needle_alone_is_its_arc(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const quat turn = quat_unit(quat_make(0.3, -0.5, 0.7, 0.1));
    const suture_curve line = {.needle = f.n,
                               .needle_pose = pose_make(vec3_make(0.1, 0.2, 0.3), turn)};
    const double length = vbss_needle_length(f.n);
    for (int i = -5; i <= 45; i++) {
        double arc = length * i / 40.0;
        vec3 to = pose_apply(line.needle_pose, vbss_needle_point(f.n, arc));
        const suture_curve_point place = vbss_suture_nearest_point(&line, 0.0, to);
        expect_near(arc, place.arc, 1e-12);
        expect_near(0.0, vec3_distance(to, place.position), 1e-14);
        expect_near(1.0, place.needle_weight, 0.0);
        vec3 wanted = quat_rotate(turn, vbss_needle_direction(f.n, arc));
        expect_near(0.0, vec3_distance(place.tangent, wanted), 1e-12);
    }
    end(&f);
}

/* ---- how it changes */

/* On the span over the swage: slopes of its nodes by the change from place to place, by the curve's length as it is; the
 * needle's share changes by what is left of their sum. */
static void any_slopes_hold_over_the_swage(harness_source *source, void *user)
{
    const fixture *f = user;
    const double step = 1e-9;
    laid l;
    draw(source, f, &l);
    for (uint32_t i = 1; i + 1 < NODES; i++) { /* the first is how fast it leaves the needle */
        l.rest[i] *= harness_draw_real(source, 0.7, 1.4);
    }
    const hand_place at = swage_by_hand(&l, harness_draw_real(source, 0.01, 0.99));
    const suture_curve_point here = vbss_suture_nearest_point(&l.line, l.line.swage_arc, at.point);
    const vec3 back = vec3_add_scaled(here.position, step, here.tangent);
    const vec3 on = vec3_add_scaled(here.position, -step, here.tangent);
    const suture_curve_point a = vbss_suture_nearest_point(&l.line, here.arc, back);
    const suture_curve_point b = vbss_suture_nearest_point(&l.line, here.arc, on);
    double far = vec3_distance(a.position, b.position);
    vec3 moved = vec3_zero(), point = on_needle(&l.line, &here);
    assert_int_equal(here.span, 0);
    for (uint32_t k = 0; k < NODES; k++) {
        double slope = number_of(&here, here.weight_derivatives, k);
        double change = number_of(&b, b.weights, k) - number_of(&a, a.weights, k);
        expect_near(change / far, slope, 2e-3);
        moved = vec3_add_scaled(moved, slope, vec3_sub(l.x[k], point));
    }
    expect_near(0.0, vec3_distance(vec3_neg(here.tangent), moved), 1e-9);
    vec3 turn = vec3_scale(vec3_sub(b.tangent, a.tangent), 1.0 / far);
    expect_near(0.0, vec3_distance(turn, here.curvature), 5e-3);
    expect_near(0.0, vec3_dot(here.curvature, here.tangent), 1e-9);
}

static void jacobian_holds_over_swage(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("slopes", 200, any_slopes_hold_over_the_swage, &f);
    end(&f);
}

int test_curve_swage(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(curve_is_smooth_over_swage),
        harness_test(curve_leaves_needle_tangentially_and_joins_thread),
        harness_test(search_crosses_swage_in_both_directions),
        harness_test(nearest_point_is_perpendicular_and_minimal),
        cmocka_unit_test(needle_alone_is_its_arc),
        harness_test(jacobian_holds_over_swage),
    };
    return cmocka_run_group_tests_name("suture.curve_swage", tests, NULL, NULL);
}
