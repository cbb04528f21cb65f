/* Method IMPLICIT: waves along the thread, and what a moving end sends into it. */
#include <math.h>

#include "thread/reference.h"
#include "thread/rig.h"

static const double pi = 0x1.921fb54442d18p1, gravity = 9.81, density = 6.4e-5, stiffness = 427.0;
enum { MAX_NODES = 121 };

static vbss_thread_config wave_config(uint32_t segments)
{
    vbss_thread_config config = rig_config(0.15, segments);
    config.gravity[1] = 0.0;
    config.spectral_radius = 1.0; /* nothing of the waves is lost in time */
    config.stretch_tolerance = config.position_tolerance = 1e-12;
    return config;
}

/* ---- along the thread */

/* A short pull at the free node 0 runs to the other end: c = sqrt(EA / lambda) = 2583 m/s, speed of
 * the nodes F / sqrt(EA lambda), twice that where it turns back. */
static void tension_wave_travels_at_sound_speed(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        enum { SEGMENTS = 100, MIDDLE = 50 };
        rig r;
        vbss_thread_config config = wave_config(SEGMENTS);
        config.bending = k;
        double h = 2.5e-7, lasts = 20e-6, c = sqrt(stiffness / density), pull = 0.5;
        double passed = 0.0, when = 0.0, peak_middle = 0.0, peak_end = 0.0;
        rig_begin(&r, &config);
        uint32_t id = rig_force(&r, 0, vec3_zero());
        for (int step = 1; step * h < 0.15 / c + lasts; step++) {
            double t = step * h, wave = t < lasts ? sin(pi * t / lasts) : 0.0;
            rig_move(&r, id, vec3_make(-pull * wave * wave, 0.0, 0.0));
            rig_run(&r, h, 1);
            double middle = -rig_velocity(&r, MIDDLE).x;
            peak_end = fmax(peak_end, -rig_velocity(&r, SEGMENTS).x);
            if (t < 0.075 / c + lasts + 5e-6) { /* not what comes back */
                passed += middle * h;
                when += middle * h * t;
                peak_middle = fmax(peak_middle, middle);
            }
        }
        rig_end(&r);
        expect_near(1.0, 0.075 / (when / passed - 0.5 * lasts) / c, 2e-3);
        double impedance = sqrt(stiffness * density);
        expect_near(1.0, peak_middle / (pull / impedance), 1e-2);
        expect_near(2.0, peak_end / (pull / impedance), 2e-2);
        expect_near(1.0, passed / (0.5 * pull * lasts / impedance), 1e-3);
    }
}

/* ---- across it */

/* How far from its mirror image, upside down, a plucked bump is after L / c, as a share of it; there
 * and back once more it must be itself. Pulled to 1 N: c = 125 m/s. */
static void pluck(vbss_thread_bending bending, uint32_t n, double bounds[2])
{
    rig r;
    vec3 x[MAX_NODES], later[MAX_NODES];
    vbss_thread_config config = wave_config(n);
    config.bending = bending;
    config.bending_stiffness = 0.0;
    double strain = 1.0 / stiffness, height = 1e-5;
    /* By rest length: the thread is longer than that and so lighter by the metre. */
    double c = sqrt(1.0 / (density * (1.0 + strain)));
    rig_begin(&r, &config);
    for (uint32_t i = 0; i <= n; i++) {
        double s = (double)i / n, bump = fabs(s - 0.35) < 0.25 ? cos(2.0 * pi * (s - 0.35)) : 0.0;
        x[i] = vec3_make(0.15 * s * (1.0 + strain), 0.0, height * pow(bump, 4.0));
    }
    rig_place(&r, x, NULL);
    rig_pin_here(&r, 0);
    uint32_t id = rig_pin_here(&r, n);
    uint32_t steps = 4 * n;
    for (int turn = 0; turn < 2; turn++) {
        rig_run(&r, 0.15 / c / steps, steps);
        rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, later);
        bounds[turn] = 0.0;
        for (uint32_t i = 0; i <= n; i++) {
            double wanted = turn == 0 ? -x[n - i].z : x[i].z;
            bounds[turn] = fmax(bounds[turn], fabs(later[i].z - wanted) / height);
        }
        expect_near(1.0, rig_reaction_force(&r, id).x, 1e-4);
    }
    rig_end(&r);
}

static void plucked_bump_reflects_inverted(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        double coarse[2], fine[2];
        pluck(k, 60, coarse);
        pluck(k, 120, fine);
        expect_near(0.0, fine[0], k == 0 ? 1e-4 : 1e-3);
        expect_near(0.0, fine[1], k == 0 ? 2e-4 : 2e-3);
        assert_true(log2(coarse[0] / fine[0]) > (k == 0 ? 3.0 : 1.8));
    }
}

/* ---- ends that move */

/* A chain hangs from an end that moves as A sin(W t), at 2.5 Hz, between its first two frequencies.
 * Steady: x(s) = A J0(2 W sqrt((L - s) / g)) / J0(2 W sqrt(L / g)), and the end is pushed by -T x'.
 * Errors of tip and force as shares of their amplitudes, the largest of a period. */
static void drive_chain(uint32_t n, double *tip_error, double *force_error)
{
    rig r;
    vec3 x[MAX_NODES], v[MAX_NODES];
    double h = 0.5e-3, drive = 2.0 * pi * 2.5, amplitude = 1e-6, l = 0.15 / n;
    double at_end = 2.0 * drive * sqrt(0.15 / gravity),
           share = amplitude / reference_bessel(0, at_end);
    double force = -density * sqrt(gravity * 0.15) * drive * share * reference_bessel(1, at_end);
    vbss_thread_config config = rig_config(0.15, n);
    config.stretch_tolerance = config.position_tolerance = 1e-12;
    config.spectral_radius = 0.5;
    config.bending_stiffness = 0.0;
    config.direction[0] = 0.0;
    config.direction[1] = -1.0;
    for (uint32_t i = 0; i <= n; i++) {
        double s = (double)i / n, weight = density * gravity * (0.15 - (i - 0.5) * l);
        double along = share * reference_bessel(0, at_end * sqrt(1.0 - s));
        x[i] = vec3_make(0.0, i == 0 ? 0.0 : x[i - 1].y - l * (1.0 + weight / stiffness), 0.0);
        v[i] = vec3_make(drive * along, 0.0, 0.0);
    }
    rig_begin(&r, &config);
    rig_place(&r, x, v);
    uint32_t id = rig_pin_here(&r, 0);
    *tip_error = *force_error = 0.0;
    for (int step = 1; step * h < 0.4; step++) {
        double phase = drive * step * h;
        rig_move(&r, id, vec3_make(amplitude * sin(phase), 0.0, 0.0));
        rig_run(&r, h, 1);
        double off = fabs(rig_tip(&r).x - share * sin(phase)) / fabs(share);
        *tip_error = fmax(*tip_error, off);
        off = fabs(rig_reaction_force(&r, id).x - force * sin(phase)) / fabs(force);
        *force_error = step * h > 0.01 ? fmax(*force_error, off) : 0.0;
    }
    rig_end(&r);
}

static void shaken_chain_response(void **state)
{
    (void)state;
    double tip[2], force[2];
    drive_chain(60, &tip[0], &force[0]);
    drive_chain(120, &tip[1], &force[1]);
    expect_near(0.0, tip[1], 2.5e-4);
    expect_near(0.0, force[1], 2.5e-3);
    assert_true(log2(tip[0] / tip[1]) > 1.8);
    assert_true(log2(force[0] / force[1]) > 1.8);
}

/* A straight thread pushed and pulled along itself is as good as rigid. */
static double force_error_of_a_shaken_thread(double h)
{
    rig r;
    vec3 v[13];
    double drive = 125.0, amplitude = 1e-3, mass = density * 0.15, worst = 0.0;
    vbss_thread_config config = wave_config(12);
    config.spectral_radius = 0.5;
    for (int i = 0; i <= 12; i++) {
        v[i] = vec3_make(drive * amplitude, 0.0, 0.0);
    }
    rig_begin(&r, &config);
    rig_place(&r, NULL, v);
    uint32_t id = rig_pin_here(&r, 0);
    for (int step = 1; step * h < 0.1; step++) {
        double phase = drive * step * h;
        rig_move(&r, id, vec3_make(amplitude * sin(phase), 0.0, 0.0));
        rig_run(&r, h, 1);
        double wanted = -mass * drive * drive * amplitude * sin(phase);
        double off = fabs(rig_reaction_force(&r, id).x - wanted);
        worst = step * h > 0.02 ? fmax(worst, off) : worst;
    }
    rig_end(&r);
    return worst / (mass * drive * drive * amplitude);
}

static void shaken_end_feels_thread_inertia(void **state)
{
    (void)state;
    double coarse = force_error_of_a_shaken_thread(1e-3);
    double fine = force_error_of_a_shaken_thread(0.5e-3);
    expect_near(0.0, fine, 5e-3);
    /* First order, by the mass of the end's own half segment: a node that is taken along evenly in each
     * step has the acceleration of the middle of two. */
    assert_true(log2(coarse / fine) > 0.9);
}

/* What an end gives that starts to move at once is the thread's momentum; then its weight and drag. */
static void moving_end_transfers_thread_momentum(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = wave_config(12);
    config.spectral_radius = 0.5;
    config.gravity[0] = gravity;
    config.drag = 2.0;
    rig_begin(&r, &config);
    uint32_t id = rig_pin_here(&r, 0);
    rig_run(&r, 1e-3, 200);
    double mass = density * 0.15, weight = mass * gravity, impulse = 0.0;
    expect_near(-weight, rig_reaction_force(&r, id).x, 1e-9 * weight);
    for (int step = 1; step <= 200; step++) {
        rig_move(&r, id, vec3_make(-0.2e-3 * step, 0.0, 0.0));
        rig_run(&r, 1e-3, 1);
        impulse += 1e-3 * (rig_reaction_force(&r, id).x + weight);
    }
    double dragged = 2.0 * mass * 0.2;
    expect_near(-weight - dragged, rig_reaction_force(&r, id).x, 1e-9 * weight);
    expect_near(-mass * 0.2 - dragged * 0.2, impulse, 2e-3 * mass * 0.2);
    expect_near(-0.2, rig_fastest(&r) * -1.0, 1e-9);
    rig_end(&r);
}

int test_waves(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tension_wave_travels_at_sound_speed),
        harness_test(plucked_bump_reflects_inverted),
        harness_test(shaken_chain_response),
        harness_test(shaken_end_feels_thread_inertia),
        harness_test(moving_end_transfers_thread_momentum),
    };
    return cmocka_run_group_tests_name("thread.waves", tests, NULL, NULL);
}
