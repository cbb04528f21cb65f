/* Method IMPLICIT: frequencies, of chains, cantilevers, pendulums and masses on springs. */
#include <math.h>

#include "thread/reference.h"
#include "thread/rig.h"

static const double pi = 0x1.921fb54442d18p1, gravity = 9.81, density = 6.4e-5;
enum { PERIOD = 100, SAMPLES = 4 * PERIOD + 1, MAX_NODES = 65 };

/* ---- a frequency from samples */

/* A sine has p(i + k) + p(i - k) = 2 cos(w k h) p(i); with k near a quarter of a period the fit is
 * as good as the samples. Spectral radius 1 is the trapezoidal rule, which turns an oscillation by
 * 2 atan(w h / 2) a step: this is undone, and what is left is the error in space. */
static double angular_frequency(const double *p, int count, int quarter, double h)
{
    double above = 0.0, below = 0.0;
    for (int i = quarter; i + quarter < count; i++) {
        above += p[i] * (p[i + quarter] + p[i - quarter]);
        below += 2.0 * p[i] * p[i];
    }
    return 2.0 / h * tan(0.5 * acos(above / below) / quarter);
}

static vbss_thread_config exact_config(double length, uint32_t segments)
{
    vbss_thread_config config = rig_config(length, segments);
    config.spectral_radius = 1.0;
    config.stretch_tolerance = config.position_tolerance = 1e-12;
    return config;
}

/* ---- hanging chains and cantilevers */

typedef struct mode {
    double (*shape)(double number, double s); /* s from 0 at the held end to 1 */
    double number, length, w;
    bool hangs;
} mode;

static double chain_shape(double number, double s)
{
    return reference_bessel(0, number * sqrt(1.0 - s));
}

static double beam_shape(double number, double s)
{
    double b = number, mix = (cosh(b) + cos(b)) / (sinh(b) + sin(b));
    return cosh(b * s) - cos(b * s) - mix * (sinh(b * s) - sin(b * s));
}

static mode chain_mode(double number)
{
    return (mode){chain_shape, number, 0.15, 0.5 * number * sqrt(gravity / 0.15), true};
}

static mode beam_mode(double number)
{
    double w = number * number / (0.03 * 0.03) * sqrt(1e-8 / density);
    return (mode){beam_shape, number, 0.03, w, false};
}

/* Down from the origin, displaced along z by the mode, every segment as long as its tension asks. */
static void place_mode(rig *r, const mode *m, uint32_t n)
{
    vec3 x[MAX_NODES];
    double l = m->length / n, amplitude = 1e-5 * m->length;
    x[0] = vec3_make(0.0, 0.0, amplitude * m->shape(m->number, 0.0));
    for (uint32_t i = 1; i <= n; i++) {
        double weight = m->hangs ? density * gravity * (m->length - (i - 0.5) * l) : 0.0;
        double chord = l * (1.0 + weight / 427.0);
        double z = amplitude * m->shape(m->number, (double)i / n), dz = z - x[i - 1].z;
        x[i] = vec3_make(0.0, x[i - 1].y - sqrt(chord * chord - dz * dz), z);
    }
    rig_place(r, x, NULL);
    m->hangs ? rig_pin_here(r, 0) : rig_clamp_here(r, 0, vec3_make(0.0, -1.0, 0.0));
}

static double frequency_error(const mode *m, vbss_thread_bending bending, uint32_t n)
{
    rig r;
    vec3 x[MAX_NODES];
    double samples[SAMPLES], h = 2.0 * pi / m->w / PERIOD;
    vbss_thread_config config = exact_config(m->length, n);
    config.bending = bending;
    config.bending_stiffness = m->hangs ? 0.0 : 1e-8;
    config.gravity[1] = m->hangs ? -gravity : 0.0;
    config.direction[0] = 0.0;
    config.direction[1] = -1.0;
    rig_begin(&r, &config);
    place_mode(&r, m, n);
    for (int k = 0; k < SAMPLES; k++) {
        rig_run(&r, h, 1);
        rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
        samples[k] = 0.0;
        for (uint32_t i = 1; i <= n; i++) {
            samples[k] += m->shape(m->number, (double)i / n) * x[i].z * (i == n ? 0.5 : 1.0);
        }
    }
    rig_end(&r);
    double w = angular_frequency(samples, SAMPLES, PERIOD / 4, h);
    return w / m->w - 1.0;
}

/* Relative errors with 16 and 32 segments: bounds 1.3 times what was measured; and the order. */
static void compare(mode m, vbss_thread_bending bending, const double bounds[2])
{
    double coarse = frequency_error(&m, bending, 16), fine = frequency_error(&m, bending, 32);
    double order = bending == VBSS_THREAD_BENDING_SPLINE ? 2.7 : 1.8;
    expect_near(0.0, coarse, bounds[0]);
    expect_near(0.0, fine, bounds[1]);
    assert_true(log2(coarse / fine) > order);
}

static void hanging_chain_has_bessel_frequencies(void **state)
{
    (void)state;
    const double zeros[] = {2.40482556, 5.52007811, 8.65372791}; /* 1.5476, 3.5524, 5.5691 Hz */
    const double spline[][2] = {{1.2e-4, 1.5e-5}, {6e-3, 8e-4}, {4.7e-2, 7e-3}};
    const double local[][2] = {{2.7e-4, 5.3e-5}, {1.2e-2, 2.2e-3}, {7.4e-2, 1.4e-2}};
    for (int k = 0; k < 3; k++) {
        compare(chain_mode(zeros[k]), VBSS_THREAD_BENDING_SPLINE, spline[k]);
        compare(chain_mode(zeros[k]), VBSS_THREAD_BENDING_LOCAL, local[k]);
    }
}

static void cantilever_frequencies(void **state)
{
    (void)state;
    /* 7.772, 48.71, 136.4, 267.3 Hz */
    const double roots[] = {1.87510407, 4.69409113, 7.85475744, 10.99554073};
    const double spline[][2] = {
        {1.4e-4, 1.8e-5}, {1.8e-3, 2.2e-4}, {4.9e-3, 6.1e-4}, {1.1e-2, 1.3e-3}};
    const double local[][2] = {
        {1.9e-3, 4.8e-4}, {1.3e-2, 3.3e-3}, {2.9e-2, 7.8e-3}, {5.3e-2, 1.5e-2}};
    for (int k = 0; k < 4; k++) {
        compare(beam_mode(roots[k]), VBSS_THREAD_BENDING_SPLINE, spline[k]);
        compare(beam_mode(roots[k]), VBSS_THREAD_BENDING_LOCAL, local[k]);
    }
}

/* ---- one segment: half of its mass at the tip, a pendulum of length L (the rod would be faster) */

static void single_segment_is_pendulum_at_any_amplitude(void **state)
{
    (void)state;
    for (int degrees = 30; degrees <= 150; degrees += 60) {
        rig r;
        double angle = degrees * pi / 180.0, h = 0.25e-3;
        vbss_thread_config config = rig_config(0.15, 1); /* which calms its stretch */
        config.direction[0] = sin(angle);
        config.direction[1] = -cos(angle);
        rig_begin(&r, &config);
        rig_pin_here(&r, 0);
        /* Gauss: the period is 2 pi sqrt(L / g) over the mean of 1 and cos(angle / 2). */
        double a = 1.0, b = cos(0.5 * angle);
        for (int k = 0; k < 6; k++) {
            double mean = 0.5 * (a + b);
            b = sqrt(a * b);
            a = mean;
        }
        double half = pi * sqrt(0.15 / gravity) / a, before, now = 0.0;
        int steps = 0;
        do { /* until it has stopped on the other side and comes back */
            before = now;
            rig_run(&r, h, 1);
            now = vec3_cross(rig_tip(&r), rig_velocity(&r, 1)).z;
        } while (++steps < 2 || now < 0.0);
        expect_near(half, h * (steps - now / (now - before)), 1e-5 * half);
        expect_near(-sin(angle), rig_tip(&r).x / 0.15, 1e-4);
        rig_end(&r);
    }
}

/* ---- masses and springs */

static void mass_on_thread_oscillates_axially(void **state)
{
    (void)state;
    enum { COUNT = 400 };
    rig r;
    double mass = 0.05, samples[COUNT], w = sqrt(427.0 / 0.15 / mass), h = 2.0 * pi / w / PERIOD;
    vbss_thread_config config = exact_config(0.15, 6);
    config.direction[0] = 0.0;
    config.direction[1] = -1.0;
    rig_begin(&r, &config);
    rig_pin_here(&r, 0);
    uint32_t id = rig_mass(&r, 6, mass);
    for (int k = 0; k < COUNT; k++) {
        rig_run(&r, h, 1);
        samples[k] = rig_tip(&r).y + 0.15 + mass * gravity * 0.15 / 427.0;
        double pull = rig_tension(&r, 5); /* what the mass pulls with, and half a segment's */
        expect_near(-pull, rig_reaction_force(&r, id).y, 2e-4);
    }
    rig_end(&r);
    w = angular_frequency(samples, COUNT, PERIOD / 4, h);
    /* A third of the thread's mass swings with it. */
    expect_near(sqrt(427.0 / 0.15 / (mass + density * 0.15 / 3.0)), w, 2e-5 * w);
}

/* A mass on a spring to a moving end; the thread of 1e-12 kg only follows. */
typedef struct oscillator {
    rig r;
    uint32_t mass, spring;
} oscillator;
static const double mass_of = 1e-2, stiffness_of = 40.0;

static void begin_oscillator(oscillator *o, double radius, double x, double v, double damping)
{
    vbss_thread_config config = exact_config(1e-3, 1);
    config.linear_density = 1e-9;
    config.gravity[1] = 0.0;
    config.spectral_radius = radius;
    const vec3 at[2] = {{x, 0, 0}, {x + 1e-3, 0, 0}}, speed[2] = {{v, 0, 0}, {v, 0, 0}};
    rig_begin(&o->r, &config);
    rig_place(&o->r, at, speed);
    o->mass = rig_mass(&o->r, 0, mass_of);
    o->spring = rig_spring(&o->r, 0, vec3_zero(), stiffness_of, damping);
}

static void mass_on_spring_frequency(void **state)
{
    (void)state;
    oscillator o;
    double samples[SAMPLES], w = sqrt(stiffness_of / mass_of), h = 2.0 * pi / w / PERIOD;
    begin_oscillator(&o, 1.0, 1e-3, 0.0, 0.0);
    for (int k = 0; k < SAMPLES; k++) {
        rig_run(&o.r, h, 1);
        samples[k] = rig_position(&o.r, 0).x;
        expect_near(-stiffness_of * samples[k], rig_reaction_force(&o.r, o.spring).x, 1e-12);
    }
    rig_end(&o.r);
    double found = angular_frequency(samples, SAMPLES, PERIOD / 4, h);
    expect_near(w, found, 1e-9 * w);
}

/* The end moves as A sin(W t). Error of the motion, relative to its amplitude, after `warm` seconds;
 * m x'' = k (X - x) + c (X' - x'). */
static double driven_error(double ratio, double damping, double radius, double h, double warm)
{
    oscillator o;
    double drive = ratio * sqrt(stiffness_of / mass_of), amplitude = 1e-3, worst = 0.0;
    double dr = stiffness_of - mass_of * drive * drive, di = damping * drive;
    double size = dr * dr + di * di, in = (stiffness_of * dr + di * di) / size;
    double across = (di * dr - stiffness_of * di) / size;
    begin_oscillator(&o, radius, amplitude * across, amplitude * in * drive, damping);
    for (int k = 1; k * h < warm + 0.3; k++) {
        double phase = drive * h * k;
        rig_move(&o.r, o.spring, vec3_make(amplitude * sin(phase), 0.0, 0.0));
        rig_run(&o.r, h, 1);
        vec3 force = rig_reaction_force(&o.r, o.spring);
        expect_near_vec3(vec3_neg(force), rig_reaction_force(&o.r, o.mass), 1e-8);
        if (h * k > warm) {
            double wanted = amplitude * (in * sin(phase) + across * cos(phase));
            worst = fmax(worst, fabs(rig_position(&o.r, 0).x - wanted));
        }
    }
    rig_end(&o.r);
    return worst / (amplitude * sqrt(in * in + across * across));
}

/* With a damper the order is one: it feels how the end has moved in the step, half a step late. */
static void driven_spring_response(void **state)
{
    (void)state;
    double damping = 0.2 * sqrt(stiffness_of * mass_of);
    const double ratio[] = {0.5, 1.0, 2.0}, bound[] = {8e-4, 3e-3, 1.1e-2};
    for (int k = 0; k < 3; k++) {
        double coarse = driven_error(1.2 * ratio[k], 0.0, 0.5, 0.5e-3, 0.0);
        double fine = driven_error(1.2 * ratio[k], 0.0, 0.5, 0.25e-3, 0.0);
        expect_near(0.0, fine, 1.5e-3);
        expect_near(2.0, log2(coarse / fine), 0.1);
        coarse = driven_error(ratio[k], damping, 0.5, 0.5e-3, 1.0);
        fine = driven_error(ratio[k], damping, 0.5, 0.25e-3, 1.0);
        expect_near(0.0, fine, bound[k]);
        assert_true(log2(coarse / fine) > 0.9);
    }
}

int test_vibration(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hanging_chain_has_bessel_frequencies),
        harness_test(cantilever_frequencies),
        harness_test(single_segment_is_pendulum_at_any_amplitude),
        harness_test(mass_on_thread_oscillates_axially),
        harness_test(mass_on_spring_frequency),
        harness_test(driven_spring_response),
    };
    return cmocka_run_group_tests_name("thread.vibration", tests, NULL, NULL);
}
