/* Motions that must not gain energy: nothing feeds them. */
#include "fixture.h"
#include "reference.h"

/* A stone on a string, whirling at 5 m/s. */
static void whirl(double spectral_radius, const double *sizes, uint32_t count)
{
    fixture f;
    double v[6] = {0.0, 0.0, 0.0, 0.0, 5.0, 0.0};
    begin(&f);
    f.config.segment_count = 1;
    f.config.length = 0.02;
    f.config.gravity[1] = 0.0;
    f.config.spectral_radius = spectral_radius;
    vbss_thread *thread = make(&f);
    hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    expect_ok(vbss_thread_set_state(thread, NULL, v, 2));
    double first = energies_of(thread).total;
    for (uint32_t i = 0; i < 1000; i++) {
        expect_ok(vbss_thread_step(thread, sizes[i % count]));
        double now = energies_of(thread).total;
        if (!(now <= 1.1 * first)) {
            fail_msg("spectral radius %g, step %u of %g s: %g J where there were %g",
                     spectral_radius, i, sizes[i % count], now, first);
        }
    }
    end(&f);
}

static void whirling_in_equal_steps_gains_no_energy(void **state)
{
    (void)state;
    const double sizes[] = {1e-3};
    whirl(0.0, sizes, 1);
    whirl(0.5, sizes, 1);
}

static void whirling_in_unequal_steps_gains_no_energy(void **state)
{
    (void)state;
    const double sizes[] = {1e-4, 1e-3}, mixed[] = {1e-3, 1e-3, 5e-4, 2e-3, 1e-4};
    whirl(0.5, sizes, 2);
    whirl(0.5, mixed, 5);
    whirl(0.0, mixed, 5);
    whirl(0.0, sizes, 2);
}

/* 10 N along a straight thread: it is stretched, and not turned over and back for ever. */
static void axially_pulled_thread_comes_to_rest(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.gravity[1] = 0.0;
    f.config.length = 0.01;
    f.config.bending = VBSS_THREAD_BENDING_LOCAL;
    f.config.drag = 10.0;
    vbss_thread *thread = make(&f);
    hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_FORCE, 12);
    a.force[0] = 10.0;
    attach(thread, &a);
    steps(thread, 1000, 1e-3);
    expect_near_vec3(vec3_zero(), vector_at(thread, VBSS_THREAD_VIEW_VELOCITIES, 12), 1e-3);
    expect_near(10.0, number_at(thread, VBSS_THREAD_VIEW_TENSIONS, 5), 1e-2);
    end(&f);
}

/* Three segments of 1 mm between clamps on a circle: there is nothing to make it zigzag. */
static void short_stretch_between_clamps_stays(void **state)
{
    (void)state;
    const double radius = 0.02;
    fixture f;
    double x[12], directions[12];
    begin(&f);
    for (int i = 0; i < 4; i++) {
        double sine, cosine;
        vbss_sincos(1e-3 * i / radius, &sine, &cosine);
        vec3_store(x + 3 * (size_t)i, vec3_make(radius * sine, radius * (1.0 - cosine), 0.0));
        vec3_store(directions + 3 * (size_t)i, vec3_make(cosine, sine, 0.0));
    }
    f.config.segment_count = 3;
    f.config.length = 3e-3;
    f.config.gravity[1] = 0.0;
    f.config.bending = VBSS_THREAD_BENDING_LOCAL;
    f.config.positions = x;
    vbss_thread *thread = make(&f);
    for (uint32_t i = 0; i < 4; i += 3) {
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, i);
        memcpy(a.position, x + 3 * (size_t)i, sizeof a.position);
        memcpy(a.direction, directions + 3 * (size_t)i, sizeof a.direction);
        attach(thread, &a);
    }
    double first = energies_of(thread).total;
    for (int i = 0; i < 100; i++) {
        steps(thread, 1, 1e-3);
        assert_true(energies_of(thread).total <= 1.5 * first);
    }
    end(&f);
}

/* A clamp across a straight thread that is there already turns it within a step: that puts the energy
 * of bending into it, some ten times as much to take its neighbours along, and nothing afterwards. */
static void transverse_clamp_adds_no_energy(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        fixture f;
        begin(&f);
        f.config.gravity[1] = 0.0;
        f.config.bending = bending;
        vbss_thread *thread = make(&f), *twin = make(&f);
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, 6);
        vec3_store(a.position, place_of(thread, 6));
        vec3_store(a.direction, vec3_make(0.2, 1.0, 0.0));
        attach(twin, &a);
        double put_in = energies_of(twin).bending;
        steps(thread, 1, 1e-3);
        attach(thread, &a);
        double now = 0.0;
        for (int i = 0; i < 50; i++) {
            steps(thread, 1, 1e-3);
            now = energies_of(thread).total;
            assert_true(now <= 12.0 * put_in);
        }
        assert_true(now <= 3.0 * put_in);
        end(&f);
    }
}

/* New velocities do not make a thread that has moved one that is being set up: the clamp's direction
 * is taken in the next step, as without them. */
static void clamp_direction_waits_for_step_after_velocity_change(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        fixture f;
        double v[39] = {0.0};
        begin(&f);
        f.config.gravity[1] = 0.0;
        f.config.bending = k % 2;
        vbss_thread *thread = make(&f);
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, 6);
        vec3_store(a.position, place_of(thread, 6));
        vec3_store(a.direction, vec3_make(0.2, 1.0, 0.0));
        steps(thread, 1, 1e-3);
        expect_ok(vbss_thread_set_state(thread, NULL, k < 2 ? v : NULL, 13));
        double before = energies_of(thread).total;
        attach(thread, &a);
        expect_near(before, energies_of(thread).total, 1e-16);
        steps(thread, 1, 1e-3);
        assert_true(energies_of(thread).bending > 1e-7);
        end(&f);
    }
}

/* ---- curved at rest */

/* From an arc a thread that weighs nothing springs into its rest curvature, beyond it, and back, in step
 * with the bending it resists. It never comes by way of straight. */
static void spring_round(vbss_thread_bending bending, double h)
{
    const double curvature = 16.0, l = 0.15 / 12;
    fixture f;
    double x[39], fastest = 0.0, last = 0.0;
    begin(&f);
    f.config.gravity[1] = 0.0;
    f.config.bending = bending;
    f.config.rest_curvature = 20.0;
    f.config.stretch_tolerance = f.config.position_tolerance = 1e-12;
    double turn =
        bending == VBSS_THREAD_BENDING_LOCAL ? 2.0 * asin(0.5 * l * curvature) : l * curvature;
    for (int i = 0; i < 13; i++) {
        vec3_store(x + 3 * (size_t)i, on_circle(curvature, turn * i / curvature));
    }
    f.config.positions = x;
    vbss_thread *thread = make(&f);
    steps(thread, (uint32_t)(0.01 / h + 0.5), h); /* end segments find their lengths */
    double first = energies_of(thread).total;
    for (int i = 0; i * h < 2.0; i++) {
        expect_ok(vbss_thread_step(thread, h));
        vbss_thread_energies e = energies_of(thread);
        if (!(e.total <= first * (1.0 + 1e-5))) {
            fail_msg("step %d of %g s: %g J where there were %g", i, h, e.total, first);
        }
        fastest = fmax(fastest, e.kinetic);
        last = e.total;
    }
    assert_true(fastest > 0.7 * first && last > 0.9 * first); /* nor is it merely damped */
    end(&f);
}

static void oscillation_about_rest_curvature_gains_no_energy(void **state)
{
    (void)state;
    const double sizes[] = {1e-4, 5e-4, 1e-3, 2e-3};
    for (int k = 0; k < 8; k++) {
        spring_round(k % 2, sizes[k / 2]);
    }
}

/* Pulled by some mN, which is hardly any strain, and let go at one end. */
static void released_thread_gains_no_energy(void **state)
{
    (void)state;
    for (int n = 15; n <= 120; n *= 2) {
        for (int k = 0; k < 4; k++) {
            const double pulls[] = {1e-3, 2e-3, 8e-3, 1.0}, pull = pulls[k];
            fixture f;
            begin(&f);
            f.config.segment_count = (uint32_t)n;
            f.config.length = 0.15;
            f.config.gravity[1] = 0.0;
            vbss_thread *thread = make(&f);
            double stretched = 0.15 * (1.0 + pull / f.config.axial_stiffness);
            hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
            uint32_t far = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, (uint32_t)n,
                                vec3_make(stretched, 0.0, 0.0));
            steps(thread, 200, 2e-3);
            double first = energies_of(thread).total;
            expect_ok(vbss_thread_detach(thread, far));
            for (int i = 0; i < 20; i++) {
                steps(thread, 1, 2e-3);
                assert_true(energies_of(thread).total <= 1.02 * first);
            }
            end(&f);
        }
    }
}

int test_energy_gain(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(released_thread_gains_no_energy),
        cmocka_unit_test(whirling_in_equal_steps_gains_no_energy),
        cmocka_unit_test(whirling_in_unequal_steps_gains_no_energy),
        cmocka_unit_test(axially_pulled_thread_comes_to_rest),
        cmocka_unit_test(transverse_clamp_adds_no_energy),
        cmocka_unit_test(clamp_direction_waits_for_step_after_velocity_change),
        cmocka_unit_test(oscillation_about_rest_curvature_gains_no_energy),
        cmocka_unit_test(short_stretch_between_clamps_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
