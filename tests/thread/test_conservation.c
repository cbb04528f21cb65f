/* Method IMPLICIT: what a motion must keep. Angular momentum and energy are kept to the order of the
 * integration, linear momentum and rest to rounding. */
#include <math.h>
#include <string.h>

#include "thread/rig.h"
#include "thread/thread.h"

enum { SEGMENTS = 8, NODES = SEGMENTS + 1, MAX_NODES = 16 };

/* ---- the damping alone */

typedef struct sum {
    vec3 linear, angular; /* about the centre of mass */
    double speed, swing;  /* sums of the absolute values: what rounding is relative to */
} sum;

static sum sum_up(const double *mass, const vec3 *x, const vec3 *v, uint32_t n)
{
    sum s = {vec3_zero(), vec3_zero(), 0.0, 0.0};
    vec3 centre = vec3_zero();
    double total = 0.0;
    for (uint32_t i = 0; i < n; i++) {
        centre = vec3_add_scaled(centre, mass[i], x[i]);
        total += mass[i];
    }
    centre = vec3_scale(centre, 1.0 / total);
    for (uint32_t i = 0; i < n; i++) {
        vec3 r = vec3_sub(x[i], centre), p = vec3_scale(v[i], mass[i]);
        s.linear = vec3_add(s.linear, p);
        s.angular = vec3_add(s.angular, vec3_cross(r, p));
        s.speed += vec3_norm(p);
        s.swing += vec3_norm(p) * vec3_norm(r);
    }
    return s;
}

typedef struct section {
    double thickness; /* nodes are that close to a line of length 1; 0: on it to rounding */
    double angular;   /* largest relative change of angular momentum */
} section;

static void damping_keeps_momentum(harness_source *source, void *user)
{
    const section *s = user;
    double thickness = s->thickness, mass[MAX_NODES];
    vec3 x[MAX_NODES], v[MAX_NODES];
    uint32_t n = 2 + harness_draw_below(source, MAX_NODES - 1);
    vec3 from = harness_draw_vec3(source, -1.0, 1.0),
         direction = harness_draw_vec3(source, -1.0, 1.0);
    direction = vec3_unit_or(direction, vec3_make(1.0, 0.0, 0.0));
    for (uint32_t i = 0; i < n; i++) {
        mass[i] = pow(10.0, harness_draw_real(source, -5.0, -3.0));
        double place = (double)i / (n - 1);
        vec3 aside = harness_draw_vec3(source, -thickness, thickness);
        x[i] = vec3_add(vec3_add_scaled(from, place, direction), aside);
        v[i] = harness_draw_vec3(source, -1.0, 1.0);
    }
    sum before = sum_up(mass, x, v, n);
    double share = harness_draw_real(source, 0.0, 1.0);
    vbss_damp_relative_motion(mass, x, v, 0, n - 1, share);
    sum after = sum_up(mass, x, v, n);
    expect_near(0.0, vec3_distance(before.linear, after.linear) / before.speed, 1e-12);
    expect_near(0.0, vec3_distance(before.angular, after.angular) / before.swing, s->angular);
}

static void damping_conserves_momentum_of_any_section(void **state)
{
    (void)state;
    section sections[] = {{1.0, 1e-12}, {1e-1, 1e-12}, {1e-2, 1e-12}, {0.0, 1e-12}};
    for (int k = 0; k < 4; k++) {
        harness_property("momentum of a section", 1000, damping_keeps_momentum, &sections[k]);
    }
}

/* Inertia about the line is small there and the rotation about it fast, which costs digits of what
 * turns across it; below 3e-7 there is none, and what turns about the line may be lost. */
static void damping_conserves_momentum_of_nearly_straight_sections(void **state)
{
    (void)state;
    section sections[] = {{1e-3, 2e-12}, {1e-4, 1e-9}, {1e-5, 1e-8}, {1e-6, 1e-6}, {1e-8, 1e-6}};
    for (int k = 0; k < 5; k++) {
        harness_property("nearly straight", 400, damping_keeps_momentum, &sections[k]);
    }
}

static void damping_spares_rigid_motion_and_decays_the_rest(void **state)
{
    (void)state;
    const double mass[] = {1.0, 2.0, 3.0, 1.5};
    const vec3 x[] = {{0, 0, 0}, {1, 0.2, 0}, {1.5, 1, 0.3}, {1, 2, 0.5}};
    vec3 drift = vec3_make(0.3, -0.2, 1.0), turn = vec3_make(1.0, 2.0, -0.7), v[4], once[4];
    for (int i = 0; i < 4; i++) {
        v[i] = vec3_add(drift, vec3_cross(turn, x[i]));
    }
    vbss_damp_relative_motion(mass, x, v, 0, 3, 0.7);
    for (int i = 0; i < 4; i++) {
        expect_near_vec3(vec3_add(drift, vec3_cross(turn, x[i])), v[i], 1e-14);
    }
    /* Two times 0.3 and once 0.51 take the same; all of it leaves a rigid motion. */
    v[1] = vec3_add(v[1], vec3_make(0.5, -1.0, 0.2));
    v[2] = vec3_add(v[2], vec3_make(-0.3, 0.1, 0.9));
    memcpy(once, v, sizeof v);
    vbss_damp_relative_motion(mass, x, once, 0, 3, 0.51);
    vbss_damp_relative_motion(mass, x, v, 0, 3, 0.3);
    vbss_damp_relative_motion(mass, x, v, 0, 3, 0.3);
    for (int i = 0; i < 4; i++) {
        expect_near_vec3(once[i], v[i], 1e-14);
    }
    vbss_damp_relative_motion(mass, x, v, 0, 3, 1.0);
    for (int k = 0; k < 16; k++) {
        vec3 e = vec3_sub(x[k / 4], x[k % 4]);
        expect_near(0.0, vec3_dot(e, vec3_sub(v[k / 4], v[k % 4])), 1e-14);
    }
}

/* ---- a free thread */

/* Corrects the chords until the segments have their lengths: a stretch of 1e-4 has more energy than
 * the motion. */
static void relax(rig *r, vec3 *x)
{
    for (int k = 0; k < 60; k++) {
        rig_place(r, x, NULL);
        vbss_view view;
        expect_ok(vbss_thread_get_view(r->thread, VBSS_THREAD_VIEW_LENGTHS, &view, sizeof view));
        const double *lengths = view.data;
        vec3 from = x[0];
        for (uint32_t i = 0; i < SEGMENTS; i++) {
            vec3 chord = vec3_sub(x[i + 1], from);
            from = x[i + 1];
            x[i + 1] = vec3_add_scaled(x[i], 0.15 / SEGMENTS / lengths[i], chord);
        }
    }
}

/* Part of a helix, turning and flying off. */
static void launch(rig *r, const vbss_thread_config *config)
{
    vec3 x[NODES], v[NODES];
    for (uint32_t i = 0; i < NODES; i++) {
        double turned = 3.0 * i / SEGMENTS;
        x[i] = vec3_make(0.03 * cos(turned), 0.03 * sin(turned), 0.12 * i / SEGMENTS);
    }
    rig_begin(r, config);
    relax(r, x);
    for (uint32_t i = 0; i < NODES; i++) {
        vec3 spin = vec3_cross(vec3_make(4.0, 12.0, -7.0), x[i]);
        v[i] = vec3_add(spin, vec3_make(0.012, -0.01, 0.016));
    }
    rig_place(r, x, v);
}

/* About the centre of mass. */
static vec3 spin_of(rig *r)
{
    vbss_thread_momentum m = rig_momentum(r);
    return vec3_sub(vec3_load(m.angular), vec3_cross(vec3_load(m.centre), vec3_load(m.linear)));
}

typedef struct drift {
    double linear, angular, energy; /* relative changes at the end */
    double growth;                  /* of energy: the largest on the way */
} drift;

static vbss_thread_config free_config(vbss_thread_bending bending, double spectral_radius)
{
    vbss_thread_config config = rig_config(0.15, SEGMENTS);
    config.bending = bending;
    config.spectral_radius = spectral_radius;
    config.gravity[1] = 0.0;
    config.stretch_tolerance = config.position_tolerance = 1e-12;
    return config;
}

/* With a mass on a node, if it is not zero. */
static drift fly(const vbss_thread_config *config, double mass, double h, uint32_t steps)
{
    rig r;
    drift d = {0, 0, 0, 0};
    launch(&r, config);
    if (mass > 0.0) {
        rig_mass(&r, 2, mass);
    }
    vec3 angular = spin_of(&r), linear = vec3_load(rig_momentum(&r).linear);
    double energy = rig_energies(&r).total;
    for (uint32_t k = 0; k < steps; k += 5) {
        rig_run(&r, h, 5);
        d.energy = rig_energies(&r).total / energy - 1.0;
        d.growth = fmax(d.growth, d.energy);
    }
    d.linear = vec3_distance(linear, vec3_load(rig_momentum(&r).linear)) / vec3_norm(linear);
    d.angular = vec3_distance(angular, spin_of(&r)) / vec3_norm(angular);
    assert_int_equal(0, rig_statistics(&r).rejections);
    rig_end(&r);
    return d;
}

static void linear_momentum_is_conserved_to_rounding(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        vbss_thread_config config = free_config(k % 2, 0.5);
        double mass = k < 2 ? 0.0 : 1e-5;                            /* as heavy as the thread */
        config.stretch_tolerance = config.position_tolerance = 1e-6; /* converged or not */
        expect_near(0.0, fly(&config, mass, 1e-3, 10000).linear, 1e-10);
        config.damping = 50.0;
        drift damped = fly(&config, mass, 1e-3, 10000);
        expect_near(0.0, damped.linear, 1e-10);
        expect_near(0.0, damped.angular, 1e-4);
        expect_near(k < 2 ? -0.05 : -0.041, damped.energy, 0.003); /* what bending had */
    }
}

static void angular_momentum_and_energy_errors_are_second_order(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        double radius = k < 2 ? 0.5 : 0.0;
        vbss_thread_config config = free_config(k % 2, radius);
        drift coarse = fly(&config, 0.0, 0.5e-3, 1000), fine = fly(&config, 0.0, 0.25e-3, 2000);
        expect_near(2.0, log2(coarse.angular / fine.angular), 0.1);
        expect_near(2.2, log2(coarse.energy / fine.energy), 0.25);
        expect_near(0.0, fine.angular, k < 2 ? 8e-6 : 3e-5);
        expect_near(0.0, fine.energy, k < 2 ? 7e-6 : 4e-5);
        expect_near(0.0, fmax(coarse.growth, fine.growth), 1e-12);
    }
}

static void undamped_energy_stays_bounded(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        vbss_thread_config config = free_config(k, 1.0);
        drift d = fly(&config, 0.0, 0.25e-3, 4000);
        expect_near(0.0, d.growth, 5e-7);
        expect_near(0.0, d.energy, 5e-6);
        expect_near(0.0, d.angular, 1e-5);
    }
}

/* ---- rest */

/* How far the worst node goes in 10 s. */
static double wandering(rig *r)
{
    vec3 before[NODES], after[NODES];
    double worst = 0.0;
    rig_read(r, VBSS_THREAD_VIEW_POSITIONS, before);
    rig_run(r, 1e-3, 10000);
    rig_read(r, VBSS_THREAD_VIEW_POSITIONS, after);
    for (uint32_t i = 0; i < NODES; i++) {
        worst = fmax(worst, vec3_distance(before[i], after[i]));
    }
    return worst;
}

static void straight_resting_thread_stays(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        rig r;
        vbss_thread_config config = free_config(k % 2, 0.5);
        config.length = 0.125; /* along an axis these short fractions of two hardly round */
        config.direction[1] = k < 2 ? 0.0 : -0.7;
        rig_begin(&r, &config);
        /* Else the rounding of positions in the first part of a step, over its length, is a speed. */
        expect_near(0.0, wandering(&r), k < 2 ? 1e-14 : 1e-10);
        rig_end(&r);
    }
}

static void hanging_resting_thread_stays(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        rig r;
        vec3 x[NODES];
        vbss_thread_config config = rig_config(0.15, SEGMENTS);
        config.drag = 8.0; /* finds the equilibrium; what is tested has none */
        rig_begin(&r, &config);
        k == 0 ? rig_pin_here(&r, 0) : rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        rig_relax(&r, 2e-3, 1e-12, 10000);
        rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
        rig_end(&r);
        config.drag = 0.0;
        rig_begin(&r, &config);
        rig_place(&r, x, NULL);
        k == 0 ? rig_pin_here(&r, 0) : rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        expect_near(0.0, wandering(&r), 1e-11);
        rig_end(&r);
    }
}

int test_conservation(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(damping_conserves_momentum_of_any_section),
        harness_test(damping_conserves_momentum_of_nearly_straight_sections),
        harness_test(damping_spares_rigid_motion_and_decays_the_rest),
        harness_test(linear_momentum_is_conserved_to_rounding),
        harness_test(angular_momentum_and_energy_errors_are_second_order),
        harness_test(undamped_energy_stays_bounded),
        harness_test(straight_resting_thread_stays),
        harness_test(hanging_resting_thread_stays),
    };
    return cmocka_run_group_tests_name("thread.conservation", tests, NULL, NULL);
}
