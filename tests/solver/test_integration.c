#include <math.h>

#include "harness/harness.h"
#include "solver/solver.h"

/* ---- the formulas */

typedef struct vertex_motion {
    vec3 x, v, a, q; /* q: the acceleration that balances the forces */
} motion;

static motion predicted_of(const vbss_integration *i, motion m)
{
    motion p = {m.x, m.v, m.a, m.q};
    vbss_integration_predict(i, 3, &m.x.x, &m.v.x, &m.a.x, &m.q.x, &p.x.x, &p.v.x, &p.a.x);
    return p;
}

/* One step, as a body takes it: x as if found from the forces, then what follows from it. */
static motion step_to(const vbss_integration *i, motion m, vec3 q)
{
    motion p = predicted_of(i, m), next;
    next.x = vec3_add_scaled(p.x, 1.0 / i->inertia, q);
    vbss_integration_correct(i, 3, &next.x.x, &p.x.x, &p.v.x, &p.a.x, &next.v.x, &next.a.x,
                             &next.q.x);
    next.q = q; /* but for rounding */
    return next;
}

#define expect_vec3(wanted, got, tolerance) near_vec3((wanted), (got), (tolerance), #got, __LINE__)
static void near_vec3(vec3 wanted, vec3 got, double tolerance, const char *what, int line)
{
    harness_near(wanted.x, got.x, tolerance, what, __FILE__, line);
    harness_near(wanted.y, got.y, tolerance, what, __FILE__, line);
    harness_near(wanted.z, got.z, tolerance, what, __FILE__, line);
}

/* Chung and Hulbert 1993, written out: Newmark's formulas, the balance between the two ends of the
 * step, and their four parameters by the spectral radius. */
static void recurrences(harness_source *source, void *user)
{
    (void)user;
    double h = pow(2.0, harness_draw_real(source, -12.0, 0.0));
    double r = harness_draw_real(source, 0.0, 1.0);
    vec3 x = harness_draw_vec3(source, -1.0, 1.0), v = harness_draw_vec3(source, -1.0, 1.0);
    vec3 a0 = harness_draw_vec3(source, -1.0, 1.0), q0 = harness_draw_vec3(source, -1.0, 1.0);
    vec3 q1 = harness_draw_vec3(source, -1.0, 1.0);
    double am = (2.0 * r - 1.0) / (r + 1.0), af = r / (r + 1.0);
    double gamma = 0.5 - am + af, beta = 0.25 * (1.0 - am + af) * (1.0 - am + af);
    /* (1 - am) a1 + am a0 = (1 - af) q1 + af q0 */
    vec3 forces = vec3_add_scaled(vec3_scale(q0, af), 1.0 - af, q1);
    vec3 a1 = vec3_scale(vec3_add_scaled(forces, -am, a0), 1.0 / (1.0 - am));
    vec3 mean_v = vec3_add_scaled(vec3_scale(a0, 1.0 - gamma), gamma, a1);
    vec3 mean_x = vec3_add_scaled(vec3_scale(a0, 0.5 - beta), beta, a1);
    vbss_integration i = vbss_integration_generalised_alpha(h, r);
    expect_near(h, i.h, 0.0);
    motion next = step_to(&i, (motion){x, v, a0, q0}, q1);
    expect_vec3(vec3_add_scaled(vec3_add_scaled(x, h, v), h * h, mean_x), next.x, 1e-14);
    /* What follows from x has its rounding, over h and h^2. */
    expect_vec3(vec3_add_scaled(v, h, mean_v), next.v, 1e-14 / h);
    expect_vec3(a1, next.a, 1e-14 / (h * h));
}

static void coefficients_match_recurrences(void **state)
{
    (void)state;
    harness_property("recurrences", 2000, recurrences, NULL);
}

static void backward_euler_is_bit_exact(void **state)
{
    (void)state;
    /* Short fractions of two: nothing rounds. */
    vbss_integration i = vbss_integration_backward_euler(0x1p-10);
    motion m = {{3.0, -5.0, 0.5}, {7.0, 2.0, -1.0}, {1e300, -1e300, 77.0}, {-1e300, 1e300, 55.0}};
    vec3 q = vec3_make(9.0, -4.0, 6.0);
    motion next = step_to(&i, m, q);
    vec3 v = vec3_add_scaled(m.v, 0x1p-10, q);
    expect_vec3(v, next.v, 0.0);
    expect_vec3(vec3_add_scaled(m.x, 0x1p-10, v), next.x, 0.0);
    expect_vec3(q, next.a, 0.0);
    /* And to rounding where h is no fraction of two. */
    i = vbss_integration_backward_euler(1e-3);
    expect_near(1e6, i.inertia, 1e-9);
    expect_near(1e3, i.velocity_factor, 1e-12);
    expect_near(1e-3, i.h, 0.0);
}

static void constant_acceleration_is_exact(void **state)
{
    (void)state;
    vec3 g = vec3_make(0.25, -9.81, 3.0);
    for (int k = 0; k <= 8; k++) {
        double r = k / 8.0;
        vbss_integration i = vbss_integration_generalised_alpha(0x1p-7, r);
        motion m = {{0, 0, 0}, {1, 2, -3}, g, g};
        for (int n = 1; n <= 256; n++) {
            m = step_to(&i, m, g);
            double t = n * 0x1p-7;
            vec3 v = vec3_make(1, 2, -3);
            expect_vec3(vec3_add_scaled(v, t, g), m.v, 1e-10);
            expect_vec3(vec3_add_scaled(vec3_scale(v, t), 0.5 * t * t, g), m.x, 1e-10);
            expect_vec3(g, m.a, 1e-8);
        }
    }
}

/* ---- the linear oscillator: q = -w^2 x */

/* Solves for the x whose forces balance: inertia (x - predicted) = -w^2 x. */
static motion oscillate(const vbss_integration *i, motion m, double w)
{
    vec3 x = vec3_scale(predicted_of(i, m).x, i->inertia / (i->inertia + w * w));
    return step_to(i, m, vec3_scale(x, -w * w));
}

/* Error at t = 3 of x and v / w from x = 1 at rest, with w = 2. */
static vec3 oscillator_error(const vbss_integration *i)
{
    motion m = {{1, 0, 0}, {0, 0, 0}, {-4, 0, 0}, {-4, 0, 0}};
    for (int n = (int)lround(3.0 / i->h); n > 0; n--) {
        m = oscillate(i, m, 2.0);
    }
    return vec3_make(m.x.x - cos(6.0), m.v.x / 2.0 + sin(6.0), 0.0);
}

static void generalised_alpha_is_second_order_and_backward_euler_first(void **state)
{
    (void)state;
    for (int k = 0; k <= 8; k++) {
        double r = k / 8.0;
        vbss_integration coarse = vbss_integration_generalised_alpha(0.005, r);
        vbss_integration fine = vbss_integration_generalised_alpha(0.0025, r);
        expect_near(4.0, vec3_norm(oscillator_error(&coarse)) / vec3_norm(oscillator_error(&fine)),
                    0.05);
        assert_true(vec3_norm(oscillator_error(&coarse)) < 4e-4);
    }
    vbss_integration coarse = vbss_integration_backward_euler(0.005);
    vbss_integration fine = vbss_integration_backward_euler(0.0025);
    expect_near(2.0, vec3_norm(oscillator_error(&coarse)) / vec3_norm(oscillator_error(&fine)),
                0.05);
}

/* The matrix of one step for the state (h^2 q, h v, h^2 a), with x = -q / w^2: in these numbers
 * there is nothing large, and w may be infinite (soft = 1 / (w h)^2 = 0). */
static mat3 amplification(const vbss_integration *i, double soft)
{
    mat3 columns;
    double h = i->h;
    for (int c = 0; c < 3; c++) {
        double q = (c == 0) / (h * h), v = (c == 1) / h, a = (c == 2) / (h * h);
        double s = soft * h * h; /* 1 / w^2 */
        vec3 x = vec3_make(-s * q, 0, 0);
        motion m = {x, {v, 0, 0}, {a, 0, 0}, {q, 0, 0}};
        double next = -i->inertia * predicted_of(i, m).x.x / (i->inertia * s + 1.0);
        m = step_to(i, m, vec3_make(next, 0, 0));
        vec3_store(columns.m[c], vec3_make(h * h * next, h * m.v.x, h * h * m.a.x));
    }
    return mat3_transpose(columns);
}

/* |m^n|^(1/n) for n = 2^30, by squaring; a matrix without a full set of eigenvectors hides a power
 * of n in it, whose root is 1 + 1e-7 at most. */
static double spectral_radius(mat3 m)
{
    double logarithm = 0.0;
    for (int k = 0; k <= 30; k++) {
        double size = 0.0;
        for (int e = 0; e < 9; e++) {
            size = fmax(size, fabs(m.m[e / 3][e % 3]));
        }
        if (size == 0.0) {
            return 0.0;
        }
        logarithm += log(size) / ldexp(1.0, k);
        m = mat3_scale(m, 1.0 / size);
        m = mat3_mul(m, m);
    }
    return exp(logarithm);
}

/* All three eigenvalues are the same there, so that rounding moves them by its cube root. */
static void infinite_frequency_decays_as_configured(void **state)
{
    (void)state;
    for (int k = 0; k <= 16; k++) {
        double r = k / 16.0;
        vbss_integration i = vbss_integration_generalised_alpha(1e-3, r);
        expect_near(r, spectral_radius(amplification(&i, 0.0)), 1e-4);
        expect_near(r, spectral_radius(amplification(&i, 1e-16)), 1e-4);
    }
    vbss_integration euler = vbss_integration_backward_euler(1e-3);
    expect_near(0.0, spectral_radius(amplification(&euler, 0.0)), 1e-4);
}

static void no_frequency_is_amplified(void **state)
{
    (void)state;
    for (int k = 0; k <= 16; k++) {
        double r = k / 16.0;
        vbss_integration i = vbss_integration_generalised_alpha(1e-3, r);
        for (int p = -40; p <= 120; p++) {
            double power = p / 20.0; /* of w h */
            double radius = spectral_radius(amplification(&i, pow(10.0, -2.0 * power)));
            assert_true(radius <= 1.0 + 1e-6);
            assert_true(radius >= r - 1e-4);
            /* Slow motion is left alone, fast motion is not. */
            assert_true(power > -1.0 || radius > 1.0 - 1e-3);
            assert_true(power < 2.0 || radius < r + 0.06);
        }
    }
}

int test_integration(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(coefficients_match_recurrences),
        harness_test(backward_euler_is_bit_exact),
        harness_test(constant_acceleration_is_exact),
        harness_test(generalised_alpha_is_second_order_and_backward_euler_first),
        harness_test(infinite_frequency_decays_as_configured),
        harness_test(no_frequency_is_amplified),
    };
    return cmocka_run_group_tests_name("solver.integration", tests, NULL, NULL);
}
