/* Method IMPLICIT: the heavy cantilever, clamped level, straight, and let go, against a converged
 * solution by another method (reference.h). */
#include <math.h>

#include "thread/reference.h"
#include "thread/rig.h"

static void release(rig *r, const vbss_thread_config *config)
{
    rig_begin(r, config);
    rig_clamp_here(r, 0, vec3_make(1.0, 0.0, 0.0));
}

/* ---- against the converged solution */

typedef struct run {
    vbss_thread_bending bending;
    uint32_t segments;
    double h;
    double bounds[FALLING_TIPS]; /* of the tip's error, m: about twice what was measured */
} run;

static void compare(const run *c)
{
    rig r;
    vbss_thread_config config = rig_config(0.15, c->segments);
    config.bending = c->bending;
    release(&r, &config);
    for (int shot = 0; shot < FALLING_TIPS; shot++) {
        rig_run(&r, c->h, (uint32_t)lround(0.05 / c->h));
        expect_near(0.0, vec3_distance(falling_tip[shot], rig_tip(&r)), c->bounds[shot]);
    }
    for (uint32_t i = 0; i <= c->segments; i++) {
        expect_near(0.0, rig_position(&r, i).z, 0.0); /* it stays in its plane to the bit */
    }
    vbss_thread_statistics s = rig_statistics(&r);
    expect_near(0.0, s.stretch_error, 1e-6); /* as configured */
    assert_int_equal(0, s.rejections);
    assert_int_equal(0, s.forced);
    assert_int_equal(1, s.first_order); /* where the motion starts */
    /* One linearisation a step, and hardly ever a second. */
    assert_in_range(s.iterations, s.substeps, s.substeps + s.substeps / 20);
    rig_end(&r);
}

static void tip_fall_matches_converged_solution(void **state)
{
    (void)state;
    const run runs[] = {
        {VBSS_THREAD_BENDING_SPLINE, 120, 1e-3, {6e-6, 1e-5, 7e-5, 3e-5}},
        {VBSS_THREAD_BENDING_SPLINE, 30, 1e-3, {8e-6, 1e-5, 1.2e-4, 6e-5}},
        {VBSS_THREAD_BENDING_LOCAL, 120, 1e-3, {6e-6, 2e-5, 1.2e-4, 6e-5}},
        {VBSS_THREAD_BENDING_LOCAL, 30, 1e-3, {3e-5, 2.3e-4, 5e-4, 1.2e-4}},
        /* Short steps: what is left is the error in space, and of the other solution. */
        {VBSS_THREAD_BENDING_SPLINE, 60, 0.125e-3, {1.3e-6, 2e-6, 9e-6, 8e-6}},
    };
    for (size_t i = 0; i < sizeof runs / sizeof runs[0]; i++) {
        compare(&runs[i]);
    }
}

/* ---- order in time */

enum { SEGMENTS = 12, NODES = SEGMENTS + 1, LADDER = 4 };

/* Bending starts with a jump at the clamp, which excites waves of all frequencies: the order shows
 * only where the steps follow the fastest of them. */
static void shape_after(vbss_thread_bending bending, double spectral_radius, uint32_t steps,
                        rig_shape *s)
{
    rig r;
    vbss_thread_config config = rig_config(0.15, SEGMENTS);
    config.bending = bending;
    config.spectral_radius = spectral_radius;
    config.stretch_tolerance = config.position_tolerance = 1e-12;
    release(&r, &config);
    rig_run(&r, 0.1 / steps, steps);
    *s = rig_shape_of(&r);
    rig_end(&r);
}

static void order_in_time(vbss_thread_bending bending, double spectral_radius)
{
    rig_shape shapes[LADDER];
    vec3 d[LADDER - 1];
    for (int k = 0; k < LADDER; k++) {
        shape_after(bending, spectral_radius, 1000u << k, &shapes[k]);
    }
    for (int k = 0; k + 1 < LADDER; k++) {
        d[k] = rig_difference(&shapes[k], &shapes[k + 1]);
    }
    vec3 coarse = d[LADDER - 3], fine = d[LADDER - 2];
    expect_near(2.0, log2(coarse.x / fine.x), 0.05);
    expect_near(2.0, log2(coarse.y / fine.y), 0.1);
    expect_near(2.3, log2(coarse.z / fine.z), 0.5); /* of tension: 2 and a fading start */
}

static void error_is_second_order_in_step(void **state)
{
    (void)state;
    order_in_time(VBSS_THREAD_BENDING_SPLINE, 0.5);
    order_in_time(VBSS_THREAD_BENDING_SPLINE, 0.0);
    order_in_time(VBSS_THREAD_BENDING_SPLINE, 0.9);
    order_in_time(VBSS_THREAD_BENDING_LOCAL, 0.5);
}

/* ---- a taut thread let go */

/* Whatever the step leaves of the waves, they have no more energy than the pull put in: T^2 L / 2 EA.
 * The thread's own motion would be a wave of T / sqrt(EA lambda) = 6 m/s. */
static void let_go(uint32_t segments, double spectral_radius, bool by_force)
{
    rig r;
    vbss_thread_config config = rig_config(0.15, segments);
    config.spectral_radius = spectral_radius;
    config.gravity[1] = 0.0;
    rig_begin(&r, &config);
    rig_pin_here(&r, 0);
    double longer = 0.15 * (1.0 + 1.0 / config.axial_stiffness);
    uint32_t held = by_force ? rig_force(&r, segments, vec3_make(1.0, 0.0, 0.0))
                             : rig_pin(&r, segments, vec3_make(longer, 0.0, 0.0));
    rig_run(&r, 1e-3, 200);
    double energy = rig_energies(&r).total;
    expect_near(0.5 * 0.15 / config.axial_stiffness, energy, 0.1 * energy);
    if (by_force) {
        rig_move(&r, held, vec3_zero());
    } else {
        expect_ok(vbss_thread_detach(r.thread, held));
    }
    for (int k = 0; k < 100; k++) {
        rig_run(&r, 1e-3, 1);
        assert_true(rig_energies(&r).total <= energy);
        expect_near(0.15, rig_tip(&r).x, 1e-3); /* no segment has turned over */
    }
    rig_end(&r);
}

static void removed_force_relaxes_taut_thread(void **state)
{
    (void)state;
    let_go(30, 0.5, true);
    let_go(30, 0.0, true);
}

static void detached_taut_thread_relaxes(void **state)
{
    (void)state;
    let_go(30, 0.5, false);
    let_go(30, 0.0, false);
    let_go(120, 0.5, false);
}

int test_release(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tip_fall_matches_converged_solution),
        harness_test(error_is_second_order_in_step),
        harness_test(removed_force_relaxes_taut_thread),
        harness_test(detached_taut_thread_relaxes),
    };
    return cmocka_run_group_tests_name("thread.release", tests, NULL, NULL);
}
