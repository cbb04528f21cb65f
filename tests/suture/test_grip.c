/* What friction is worth in a bend: Euler and Eytelwein's rope round a post, T2 = T1 exp(mu theta), in components along and
 * across what runs through. */
#include "curve_fixture.h"

enum { NODES = 41, CORNER = 20 };
static const double fine = 0.05e-3;

/* Two straight limbs, fine, that meet at a node under the angle theta; the tip is along -x. */
static void lay_bend(laid *l, double theta)
{
    double sine, cosine;
    vbss_sincos(theta, &sine, &cosine);
    lay_nodes(l, NODES);
    for (uint32_t i = 1; i < NODES; i++) {
        lay_on(l, i, fine, i <= CORNER ? vec3_make(1.0, 0.0, 0.0) : vec3_make(cosine, sine, 0.0));
    }
}

/* The middle of the parabola over the corner: its tangent halves the bend. */
static suture_place middle_of_bend(const laid *l)
{
    vec3 middle = vec3_lerp(middle_of(l, CORNER - 1), middle_of(l, CORNER), 0.5);
    middle = vec3_lerp(middle, l->x[CORNER], 0.5);
    return vbss_suture_nearest(&l->line, CORNER * fine, middle);
}

/* As much as a straight suture rubs is mixed in for bends that are none. */
#define MIXED 0.01
static double mixed(double along, double aside, double mu)
{
    return (along + MIXED * mu) / (aside + MIXED);
}

static void in_a_symmetric_bend_it_is_the_ropes(void **state)
{
    (void)state;
    for (int i = 1; i <= 28; i++) {
        for (int m = 1; m <= 6; m++) {
            double theta = 0.1 * i, mu = 0.15 * m, grip[2], sine, cosine;
            laid l;
            lay_bend(&l, theta);
            const suture_place place = middle_of_bend(&l);
            vbss_suture_grip(&l.line, &place, mu, grip);
            vbss_sincos(0.5 * theta, &sine, &cosine);
            /* tanh(mu theta / 2) / tan(theta / 2) */
            double e = exp(mu * theta), rope = tanh(0.5 * mu * theta) * cosine / sine;
            for (int way = 0; way < 2; way++) {
                expect_near(mixed((e - 1.0) * cosine, (e + 1.0) * sine, mu), grip[way], 1e-9);
                double little = MIXED / ((e + 1.0) * sine + MIXED);
                expect_near(rope, grip[way], 1.01 * little * fabs(mu - rope) + 1e-9);
            }
        }
    }
}

static void straight_on_it_is_the_coefficient(void **state)
{
    (void)state;
    const double angles[] = {0.0, 1e-9, 1e-6, 1e-4, 1e-2};
    for (int i = 0; i < 5; i++) {
        double grip[2];
        laid l;
        lay_bend(&l, angles[i]);
        for (int node = 0; node < NODES; node++) { /* ends too */
            const suture_place place = vbss_suture_nearest(&l.line, node * fine, l.x[node]);
            vbss_suture_grip(&l.line, &place, 0.3, grip);
            expect_near(0.3, grip[0], 1e-5 + 0.6 * angles[i]);
            expect_near(0.3, grip[1], 1e-5 + 0.6 * angles[i]);
        }
        const suture_place place = middle_of_bend(&l);
        vbss_suture_grip(&l.line, &place, 0.3, grip);
        expect_near(0.3, grip[0], 1e-5);
        expect_near(grip[0], grip[1], 1e-9);
    }
}

/* Nearer to one limb than to the other, it holds back more against what runs toward the nearer: the pull of that limb, which is
 * the greater by then, is along. */
static void beside_the_middle_the_two_ways_differ(void **state)
{
    (void)state;
    const double theta = 1.2, mu = 0.4;
    laid l;
    lay_bend(&l, theta);
    const vec3 low = middle_of(&l, CORNER - 1), high = middle_of(&l, CORNER);
    for (int i = 0; i <= 20; i++) {
        double u = i / 20.0, grip[2], e = exp(mu * theta);
        vec3 a = vec3_lerp(low, l.x[CORNER], u), b = vec3_lerp(l.x[CORNER], high, u);
        const suture_place place =
            vbss_suture_nearest(&l.line, (CORNER - 0.4 + 0.8 * u) * fine, vec3_lerp(a, b, u));
        vbss_suture_grip(&l.line, &place, mu, grip);
        /* angles of the tangent with the limb on the tip's side and with the other */
        double first = atan2(-place.tangent.y, -place.tangent.x), other = theta - first;
        expect_near(mixed(e * cos(first) - cos(other), e * sin(first) + sin(other), mu), grip[0],
                    1e-8);
        expect_near(mixed(e * cos(other) - cos(first), e * sin(other) + sin(first), mu), grip[1],
                    1e-8);
        assert_true(i == 10 || (grip[0] > grip[1]) == (i < 10));
    }
}

/* The bend is that of what is beyond the nodes which the place moves: a bend three spans away is none of its. */
static void only_what_is_near_bends_it(void **state)
{
    (void)state;
    double straight[2], bent[2];
    laid l, plain;
    lay_bend(&l, 1.5);
    lay_bend(&plain, 0.0);
    for (uint32_t k = CORNER - 6; k <= CORNER + 6; k++) {
        const suture_place place = vbss_suture_nearest(&l.line, k * fine, l.x[k]);
        const suture_place other = vbss_suture_nearest(&plain.line, k * fine, plain.x[k]);
        vbss_suture_grip(&l.line, &place, 0.5, bent);
        vbss_suture_grip(&plain.line, &other, 0.5, straight);
        bool near = k + 1 >= CORNER && k <= CORNER + 1;
        assert_int_equal(fabs(bent[0] - straight[0]) + fabs(bent[1] - straight[1]) > 0.05, near);
    }
}

int test_grip(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_a_symmetric_bend_it_is_the_ropes),
        cmocka_unit_test(straight_on_it_is_the_coefficient),
        cmocka_unit_test(beside_the_middle_the_two_ways_differ),
        cmocka_unit_test(only_what_is_near_bends_it),
    };
    return cmocka_run_group_tests_name("suture.grip", tests, NULL, NULL);
}
