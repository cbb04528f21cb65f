/* The viscous branch of bending, a standard linear solid, against its exponentials. */
#include <math.h>

#include "base/elementary.h"
#include "thread/bend_rig.h"

static const double ratio = 0.8, time_constant = 0.5;

static vbss_thread_config viscous_config(int bending)
{
    vbss_thread_config c = bend_config(bending);
    c.relaxation_ratio = ratio;
    c.relaxation_time = time_constant;
    return c;
}

/* Bent within 5 % of the relaxation time at a constant rate and held: the moment falls to that of EI. */
static void moment_of_held_bend_relaxes(void **state)
{
    (void)state;
    const double curvature = 100.0, ramp = 0.025;
    for (int bending = 0; bending < 2; bending++) {
        vbss_thread_config c = viscous_config(bending);
        bend_rig b;
        bend_begin(&b, &c);
        bend_to(&b, curvature, 25, ramp / 25.0);
        /* of the branch at the end of the ramp */
        double x = ramp / time_constant, peak = ratio * (1.0 - vbss_exp(-x)) / x;
        for (int k = 1; k <= 20; k++) {
            bend_to(&b, curvature, 100, 1e-3);
            double wanted = 1.0 + peak * vbss_exp(-0.1 * k / time_constant);
            expect_near(wanted, bend_moment(&b) / (BEND_STIFFNESS * curvature), 4e-3);
        }
        bend_end(&b);
    }
}

/* Deflection of the end under a small force, which is far below gravity's in other tests: at once
 * that of EI (1 + ratio), and at last that of EI. */
static void loaded_thread_creeps(void **state)
{
    (void)state;
    const double force = 2e-7, creep_time = time_constant * (1.0 + ratio);
    for (int bending = 0; bending < 2; bending++) {
        vbss_thread_config c = viscous_config(bending);
        c.drag = 50.0;
        rig r;
        rig_begin(&r, &c);
        rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        rig_force(&r, BEND_SEGMENTS, vec3_make(0.0, force, 0.0));
        const double cube = BEND_LENGTH * BEND_LENGTH * BEND_LENGTH;
        double last = force * cube / (3.0 * BEND_STIFFNESS);
        rig_run(&r, 1e-3, 100); /* swings and comes to rest on the creeping curve */
        for (int k = 1; k <= 20; k++) {
            rig_run(&r, 1e-3, 100);
            double t = 0.1 + 0.1 * k;
            double wanted = 1.0 - ratio / (1.0 + ratio) * vbss_exp(-t / creep_time);
            /* The drag delays it by some ms. */
            expect_near(wanted, rig_position(&r, BEND_SEGMENTS).y / last, 0.015);
        }
        rig_end(&r);
    }
}

/* Held for long and let go: it springs back to ratio / (1 + ratio) of its curvature, the set, which
 * decays. */
static void set_of_released_thread_decays(void **state)
{
    (void)state;
    const double curvature = 60.0, creep_time = time_constant * (1.0 + ratio);
    for (int bending = 0; bending < 2; bending++) {
        vbss_thread_config c = viscous_config(bending);
        c.drag = 50.0;
        bend_rig b;
        bend_begin(&b, &c);
        bend_to(&b, curvature, 100, 1e-3);
        bend_to(&b, curvature, 100, 5e-2);
        bend_release(&b);
        rig_run(&b.r, 1e-3, 200);
        for (int k = 0; k < 8; k++) {
            double t = 0.2 + 0.1 * k;
            double wanted = ratio / (1.0 + ratio) * vbss_exp(-t / creep_time);
            double now = bend_component(&b, VBSS_THREAD_VIEW_CURVATURES, 5) / curvature;
            expect_near(wanted, now, 0.01);
            rig_run(&b.r, 1e-3, 100);
        }
        bend_end(&b);
    }
}

/* Moment after a bend along a parabola in two relaxation times, in steps of `h`, over that of EI. */
static double moment_after_ramp(double h)
{
    const double curvature = 80.0, duration = 0.2;
    vbss_thread_config c = viscous_config(VBSS_THREAD_BENDING_LOCAL);
    c.relaxation_time = 0.1;
    c.drag = 2000.0;
    c.linear_density = 1e-7;
    bend_rig b;
    bend_begin(&b, &c);
    uint32_t steps = (uint32_t)(duration / h + 0.5);
    for (uint32_t k = 1; k <= steps; k++) {
        double part = (double)k / steps;
        bend_to(&b, curvature * part * part, 1, h);
    }
    double moment = bend_moment(&b) / (BEND_STIFFNESS * curvature);
    bend_end(&b);
    return moment;
}

static void relaxation_converges_with_square_of_step(void **state)
{
    (void)state;
    /* The elastic part v of the branch: v' = s' - v / tau, with s' growing from 0 at a constant rate. */
    const double x = 2.0, exact = 1.0 + ratio * 2.0 / x * (1.0 - (1.0 - vbss_exp(-x)) / x);
    double last = moment_after_ramp(0.2 / 128.0);
    expect_near(exact, last, 1e-3 * exact); /* of the mesh */
    double coarse = fabs(moment_after_ramp(0.2 / 4.0) - last);
    double fine = fabs(moment_after_ramp(0.2 / 16.0) - last);
    if (!(coarse < 0.02 && fine < 0.1 * coarse)) {
        fail_msg("errors %g and %g", coarse, fine);
    }
}

/* A relaxation time of a year, and one of a microsecond. */
static void extreme_times_are_elastic(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        vbss_thread_config c = viscous_config(VBSS_THREAD_BENDING_SPLINE);
        c.relaxation_time = k == 0 ? 3e7 : 1e-6;
        bend_rig b;
        bend_begin(&b, &c);
        bend_to(&b, 60.0, 200, 1e-3);
        bend_to(&b, 60.0, 200, 1e-3);
        double wanted = k == 0 ? 1.0 + ratio : 1.0;
        expect_near(wanted, bend_moment(&b) / (BEND_STIFFNESS * 60.0), 4e-3);
        double dissipated = rig_energies(&b.r).dissipated;
        double stored = rig_energies(&b.r).bending;
        assert_true(dissipated >= 0.0 && dissipated < 1e-4 * stored);
        bend_end(&b);
    }
}

int test_bending_relaxation(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moment_of_held_bend_relaxes),
        cmocka_unit_test(loaded_thread_creeps),
        cmocka_unit_test(set_of_released_thread_decays),
        cmocka_unit_test(relaxation_converges_with_square_of_step),
        cmocka_unit_test(extreme_times_are_elastic),
    };
    return cmocka_run_group_tests_name("thread.bending_relaxation", tests, NULL, NULL);
}
