/* From the needle over the swage to the thread: one curve by one arc length. */
#include "curve_fixture.h"
#include "fixture.h"

enum { NODES = 8 };

/* A needle anywhere, and a thread that leaves it as it points and then bends. */
static void draw(harness_source *source, const fixture *f, laid *l)
{
    const double swage = vbss_needle_length(f->n);
    vec3 position = harness_draw_vec3(source, -0.1, 0.1);
    const pose at = pose_make(position, harness_draw_unit_quat(source));
    vec3 begin = pose_apply(at, vbss_needle_point(f->n, swage));
    vec3 way = quat_rotate(at.orientation, vbss_needle_direction(f->n, swage));
    lay_any(source, l, NODES, begin, vec3_neg(way));
    l->line.needle = f->n;
    l->line.at = at;
    l->line.swage = swage;
}

/* In small steps of the point along the curve: arc lengths grow, the place and its direction have no step but the angle
 * between an arc of one wire's radius and its chord. */
static void any_curve_goes_on_over_the_swage(harness_source *source, void *user)
{
    const fixture *f = user;
    laid l;
    draw(source, f, &l);
    const double step = 2e-6, swage = l.line.swage, leg = WIRE;
    const double corner = 0.5 * leg / f->n->config.radius;
    const vec3 first = vbss_needle_point(f->n, swage - 1e-3);
    suture_place before = vbss_suture_nearest(&l.line, swage - 1e-3, pose_apply(l.line.at, first));
    expect_near(swage - 1e-3, before.arc, 1e-12);
    assert_int_equal(before.span, SUTURE_ON_NEEDLE);
    int corners = 0;
    for (int i = 0; i < 1500; i++) {
        vec3 on = vec3_add_scaled(before.point, -step, before.tangent);
        const suture_place place = vbss_suture_nearest(&l.line, before.arc, on);
        double turned = vec3_distance(before.tangent, place.tangent);
        assert_true(place.arc > before.arc + 0.5 * step && place.arc < before.arc + 2.0 * step);
        assert_true(vec3_distance(place.point, before.point) < 1.01 * step);
        expect_near(0.0, vec3_distance(place.point, point_by_weights(&l.line, &place)), 1e-14);
        double sum = place.span == SUTURE_ON_NEEDLE ? 0.0 : place.weights[0] + place.weights[1];
        expect_near(1.0, sum + place.on_needle + place.weights[2], 1e-12);
        if (place.span == 0 && before.span == SUTURE_ON_NEEDLE) {
            expect_near(swage - leg, place.arc, 1.01 * step);
            assert_true(turned < 1.2 * corner);
            corners++;
        } else {
            assert_true(turned < 0.02);
        }
        before = place;
    }
    assert_int_equal(corners, 1);
    assert_true(before.span >= 2);
}

static void it_goes_on_over_the_swage(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("swage", 20, any_curve_goes_on_over_the_swage, &f);
    end(&f);
}

/* Back and forth, from either side. */
static void any_search_passes_the_swage(harness_source *source, void *user)
{
    const fixture *f = user;
    laid l;
    draw(source, f, &l);
    const vec3 way = vec3_neg(back_along(&l, 0));
    for (int i = -30; i <= 3; i++) {
        double arc = l.line.swage + 1e-4 * i;
        vec3 to = i < -3 ? pose_apply(l.line.at, vbss_needle_point(f->n, arc))
                         : vec3_add_scaled(l.x[0], 1e-4 * i, way);
        for (int from = -20; from <= 20; from++) {
            const suture_place place = vbss_suture_nearest(&l.line, l.line.swage + 1e-4 * from, to);
            expect_near(arc, place.arc, i < -3 ? 1e-12 : 5e-5);
            assert_int_equal(place.span, i < -3 ? SUTURE_ON_NEEDLE : 0);
        }
        assert_int_equal(vbss_suture_span_at(&l.line, arc), 0);
    }
}

static void the_search_passes_the_swage_both_ways(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("search", 5, any_search_passes_the_swage, &f);
    end(&f);
}

/* A needle alone is its arc, straight beyond its ends; so is a thread alone where there is no needle. */
static void a_needle_alone_is_its_arc(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const quat turn = quat_unit(quat_make(0.3, -0.5, 0.7, 0.1));
    const suture_line line = {.needle = f.n, .at = pose_make(vec3_make(0.1, 0.2, 0.3), turn)};
    const double length = vbss_needle_length(f.n);
    for (int i = -5; i <= 45; i++) {
        double arc = length * i / 40.0;
        vec3 to = pose_apply(line.at, vbss_needle_point(f.n, arc));
        const suture_place place = vbss_suture_nearest(&line, 0.0, to);
        expect_near(arc, place.arc, 1e-12);
        expect_near(0.0, vec3_distance(to, place.point), 1e-14);
        expect_near(1.0, place.on_needle, 0.0);
        vec3 wanted = quat_rotate(turn, vbss_needle_direction(f.n, arc));
        expect_near(0.0, vec3_distance(place.tangent, wanted), 1e-12);
    }
    end(&f);
}

/* Over the swage: slopes of the needle's share and of both nodes, by the change from place to place. */
static void any_slopes_hold_over_the_swage(harness_source *source, void *user)
{
    const fixture *f = user;
    const double step = 1e-8;
    laid l;
    draw(source, f, &l);
    double off = harness_draw_real(source, -0.2e-3, 0.25e-3);
    vec3 to = vec3_add_scaled(l.x[0], off, back_along(&l, 0));
    const suture_place here = vbss_suture_nearest(&l.line, l.line.swage, to);
    const vec3 back = vec3_add_scaled(here.point, step, here.tangent);
    const vec3 on = vec3_add_scaled(here.point, -step, here.tangent);
    const suture_place a = vbss_suture_nearest(&l.line, here.arc, back);
    const suture_place b = vbss_suture_nearest(&l.line, here.arc, on);
    double far = b.arc - a.arc;
    assert_int_equal(here.span, 0);
    for (int k = 0; k < 2; k++) {
        expect_near((b.weights[k] - a.weights[k]) / far, here.slopes[k], 1e-2);
    }
    vec3 turn = vec3_scale(vec3_sub(b.tangent, a.tangent), 1.0 / far);
    expect_near(0.0, vec3_distance(turn, here.turn), 1e-2);
}

static void slopes_hold_over_the_swage(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("slopes", 100, any_slopes_hold_over_the_swage, &f);
    end(&f);
}

int test_curve_swage(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(it_goes_on_over_the_swage),
        harness_test(the_search_passes_the_swage_both_ways),
        cmocka_unit_test(a_needle_alone_is_its_arc),
        harness_test(slopes_hold_over_the_swage),
    };
    return cmocka_run_group_tests_name("suture.curve_swage", tests, NULL, NULL);
}
