/* What friction is worth in a bend: Euler and Eytelwein's rope round a post, T2 = T1 exp(mu theta), in components along and
 * across what runs through. */
#include "base/elementary.h"
#include "curve_fixture.h"
#include "fixture.h"

enum { NODES = 41, CORNER = 20 };
static const double fine = 0.05e-3;

/* Two straight limbs, fine, that meet at a node under the angle theta; the tip is along -x. */
static void place_bend(laid *l, double theta)
{
    double sine, cosine;
    vbss_sincos(theta, &sine, &cosine);
    place_nodes(l, NODES);
    for (uint32_t i = 1; i < NODES; i++) {
        place_on(l, i, fine, i <= CORNER ? vec3_make(1.0, 0.0, 0.0) : vec3_make(cosine, sine, 0.0));
    }
}

/* Where the two spans beside the corner join: the tangent halves the bend. */
static suture_curve_point middle_of_bend(const laid *l)
{
    return vbss_suture_nearest_point(&l->line, CORNER * fine, by_hand(l, CORNER, 0.0).point);
}

/* As much as a straight suture rubs is mixed in for bends that are none. */
#define MIXED 0.01
static double mixed(double along, double aside, double mu)
{
    return (along + MIXED * mu) / (aside + MIXED);
}

static void symmetric_bend_grip_is_capstan(void **state)
{
    (void)state;
    for (int i = 1; i <= 28; i++) {
        for (int m = 1; m <= 6; m++) {
            double theta = 0.1 * i, mu = 0.15 * m, grip[2], sine, cosine;
            laid l;
            place_bend(&l, theta);
            const suture_curve_point place = middle_of_bend(&l);
            vbss_suture_capstan_friction(&l.line, &place, mu, grip);
            vbss_sincos(0.5 * theta, &sine, &cosine);
            /* tanh(mu theta / 2) / tan(theta / 2) */
            double e = exp(mu * theta), rope = tanh(0.5 * mu * theta) * cosine / sine;
            for (int sense = 0; sense < 2; sense++) {
                expect_near(mixed((e - 1.0) * cosine, (e + 1.0) * sine, mu), grip[sense], 1e-9);
                double little = MIXED / ((e + 1.0) * sine + MIXED);
                expect_near(rope, grip[sense], 1.01 * little * fabs(mu - rope) + 1e-9);
            }
        }
    }
}

static void straight_grip_is_friction_coefficient(void **state)
{
    (void)state;
    const double angles[] = {0.0, 1e-9, 1e-6, 1e-4, 1e-2};
    for (int i = 0; i < 5; i++) {
        double grip[2];
        laid l;
        place_bend(&l, angles[i]);
        for (int node = 0; node < NODES; node++) { /* ends too */
            const suture_curve_point place =
                vbss_suture_nearest_point(&l.line, node * fine, l.x[node]);
            vbss_suture_capstan_friction(&l.line, &place, 0.3, grip);
            expect_near(0.3, grip[0], 1e-5 + 0.6 * angles[i]);
            expect_near(0.3, grip[1], 1e-5 + 0.6 * angles[i]);
        }
        const suture_curve_point place = middle_of_bend(&l);
        vbss_suture_capstan_friction(&l.line, &place, 0.3, grip);
        expect_near(0.3, grip[0], 1e-5);
        expect_near(grip[0], grip[1], 1e-9);
    }
}

/* Nearer to one limb than to the other, it holds back more against what runs toward the nearer: the pull of that limb, which is
 * the greater by then, is along. Bent are the two spans beside the corner; from one and a half in one of the directions, two segments off, begins to
 * turn round it. */
static void grip_depends_on_direction_beside_middle(void **state)
{
    (void)state;
    const double theta = 1.2, mu = 0.4;
    laid l;
    place_bend(&l, theta);
    for (int i = -19; i <= 19; i++) {
        const double along = 0.1 * i;
        const uint32_t span = (uint32_t)(CORNER + (int)floor(along));
        const hand_place at = by_hand(&l, span, along - floor(along));
        const suture_curve_point place = vbss_suture_nearest_point(&l.line, at.arc, at.point);
        double grip[2];
        vbss_suture_capstan_friction(&l.line, &place, mu, grip);
        /* angles of the tangent with the limb on the tip's side and with the other */
        double turned = atan2(-place.tangent.y, -place.tangent.x);
        double on = fmax(along - 1.5, 0.0), back = fmax(-1.5 - along, 0.0);
        double from = atan2(on * sin(theta), 1.0 - on + on * cos(theta));
        double to = atan2((1.0 - back) * sin(theta), back + (1.0 - back) * cos(theta));
        double first = turned - from, other = to - turned, e = exp(mu * (to - from));
        expect_near(mixed(e * cos(first) - cos(other), e * sin(first) + sin(other), mu), grip[0],
                    1e-8);
        expect_near(mixed(e * cos(other) - cos(first), e * sin(other) + sin(first), mu), grip[1],
                    1e-8);
        assert_true((turned > 1e-9) == (i > -10) && (theta - turned > 1e-9) == (i < 10));
        assert_true(i == 0 || (grip[0] > grip[1]) == (i < 0));
    }
}

/* What jumped from span to span pushed a thread that hardly rubbed to and fro between two of them. */
static void grip_is_continuous_across_spans(void **state)
{
    (void)state;
    double last[2] = {0.0, 0.0}, largest = 0.0;
    laid l;
    place_bend(&l, 1.5);
    for (int i = -400; i <= 400; i++) {
        const double along = 0.01 * i;
        const hand_place at =
            by_hand(&l, (uint32_t)(CORNER + (int)floor(along)), along - floor(along));
        const suture_curve_point place = vbss_suture_nearest_point(&l.line, at.arc, at.point);
        double grip[2];
        vbss_suture_capstan_friction(&l.line, &place, 0.07, grip);
        for (int k = 0; k < 2; k++) {
            largest = i > -400 ? fmax(largest, fabs(grip[k] - last[k])) : largest;
            last[k] = grip[k];
        }
    }
    print_message("over a hundredth of a segment it goes on by %g at most\n", largest);
    assert_true(largest > 0.005 && largest < 0.02);
}

/* The bend is that of what is beyond the nodes which the place moves: from the segment two before its own to that two after. */
static void only_nearby_bend_counts(void **state)
{
    (void)state;
    double straight[2], bent[2];
    laid l, plain;
    place_bend(&l, 1.5);
    place_bend(&plain, 0.0);
    for (uint32_t k = CORNER - 6; k <= CORNER + 6; k++) {
        const hand_place at = by_hand(&l, k, 0.5), even = by_hand(&plain, k, 0.5);
        const suture_curve_point place = vbss_suture_nearest_point(&l.line, at.arc, at.point);
        const suture_curve_point other =
            vbss_suture_nearest_point(&plain.line, even.arc, even.point);
        assert_int_equal(place.span, k);
        vbss_suture_capstan_friction(&l.line, &place, 0.5, bent);
        vbss_suture_capstan_friction(&plain.line, &other, 0.5, straight);
        bool near = k + 2 >= CORNER && k <= CORNER + 1;
        assert_int_equal(fabs(bent[0] - straight[0]) + fabs(bent[1] - straight[1]) > 0.05, near);
    }
}

/* A straight thread under an angle with its needle: the first two spans are moved by the swage, and beyond is the needle. */
static void grip_behind_swage_is_of_needle(void **state)
{
    (void)state;
    const double mu = 0.5;
    fixture f;
    laid l;
    begin(&f);
    const double swage = vbss_needle_length(f.n);
    const vec3 out = vec3_neg(vbss_needle_direction(f.n, swage));
    const vec3 direction = vec3_unit_or(vec3_add(out, vec3_any_normal(out)), out);
    place_nodes(&l, 8);
    l.line.needle = f.n;
    l.line.swage_arc = swage;
    l.x[0] = vbss_needle_point(f.n, swage);
    for (uint32_t i = 1; i < 8; i++) {
        place_on(&l, i, 1e-3, direction);
    }
    for (uint32_t k = 0; k < 6; k++) {
        const hand_place at = by_hand(&l, k, 0.7);
        const suture_curve_point place = vbss_suture_nearest_point(&l.line, at.arc, at.point);
        double grip[2];
        assert_int_equal(place.span, k);
        vbss_suture_capstan_friction(&l.line, &place, mu, grip);
        assert_int_equal(fabs(grip[0] - mu) + fabs(grip[1] - mu) > 0.05, k < 2);
    }
    end(&f);
}

int test_grip(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(symmetric_bend_grip_is_capstan),
        cmocka_unit_test(straight_grip_is_friction_coefficient),
        cmocka_unit_test(grip_depends_on_direction_beside_middle),
        cmocka_unit_test(grip_is_continuous_across_spans),
        cmocka_unit_test(only_nearby_bend_counts),
        cmocka_unit_test(grip_behind_swage_is_of_needle),
    };
    return cmocka_run_group_tests_name("suture.grip", tests, NULL, NULL);
}
