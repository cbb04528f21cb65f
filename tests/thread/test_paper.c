/* Method VBLAST: its forces, the elastica, its steps. Its sections: test_paper_sections.c. */
#include <math.h>

#include "fixtures/baseline_of.h"
#include "baseline/thread.h"
#include "thread/paper_rig.h"
#include "thread/reference.h"

/* ---- forces */

typedef struct loose {
    rig r;
    thread_object *object;
} loose;

static double energy_of(const loose *l)
{
    vbss_thread_compute_strains(l->object, l->object->now.x, l->object->strains);
    return vbss_baseline_bending_energy(l->object);
}

static vec3 slope_at(const loose *l, uint32_t node)
{
    double *x = &l->object->now.x[node].x, slope[3];
    for (int c = 0; c < 3; c++) {
        double before = x[c], h = 1e-5;
        x[c] = before + h;
        double high = energy_of(l);
        x[c] = before - h;
        slope[c] = (high - energy_of(l)) / (2 * h);
        x[c] = before;
    }
    energy_of(l);
    return vec3_load(slope);
}

/* Random shapes of segments longer than at rest (shorter ones bend as if they were not), in which
 * some turns are beyond 120 degrees. */
static void forces_are_slopes(harness_source *source, void *user)
{
    enum { NODES = 8 };
    loose l;
    vbss_thread_config config = paper(NODES - 1);
    config.rest_curvature = *(const double *)user;
    config.length = 1.0;
    config.bending_stiffness = 1.0;
    rig_begin(&l.r, &config);
    expect_ok(vbss_thread_open(l.r.thread, &l.object));
    uint32_t clamped = harness_draw_below(source, NODES);
    rig_clamp_here(&l.r, clamped, harness_draw_vec3(source, -1, 1));
    thread_object *t = l.object;
    for (uint32_t i = 1; i < NODES; i++) {
        vec3 direction = vec3_unit_or(harness_draw_vec3(source, -1, 1), along);
        t->now.x[i] =
            vec3_add_scaled(t->now.x[i - 1], harness_draw_real(source, 0.2, 1.0), direction);
    }
    expect_ok(vbss_thread_update_derived(t));
    energy_of(&l);
    vec3 forces[NODES] = {{0, 0, 0}}, sum = vec3_zero(), moment = vec3_zero();
    vbss_baseline_add_internal_forces(t, 0.0, forces); /* springs have no stiffness before a step */
    for (uint32_t i = 0; i < NODES; i++) {
        vec3 error = vec3_add(slope_at(&l, i), forces[i]);
        /* What central differences leave where a turn is sharp. */
        expect_near(0.0, vec3_norm(error), 1e-5 * (1.0 + vec3_norm(forces[i])));
        sum = vec3_add(sum, forces[i]);
        moment = vec3_add(moment, vec3_cross(t->now.x[i], forces[i]));
    }
    expect_near(0.0, vec3_norm(sum), 1e-10);
    expect_near(0.0, vec3_distance(moment, vbss_baseline_reaction_torque(t, clamped)), 1e-10);
    rig_end(&l.r);
}

static void bending_force_is_energy_gradient_and_balances_clamp(void **state)
{
    (void)state;
    double straight = 0.0, curved = 5.0;
    harness_property("forces are slopes", 200, forces_are_slopes, &straight);
    harness_property("forces with rest curvature are slopes", 200, forces_are_slopes, &curved);
}

/* A whole circle of its rest curvature has no energy; a straight thread EI/2 k^2 L. */
static void rest_curvature_minimises_energy(void **state)
{
    (void)state;
    loose l;
    vbss_thread_config config = paper(100);
    config.rest_curvature = 2.0 * 3.14159265358979 / config.length;
    rig_begin(&l.r, &config);
    expect_ok(vbss_thread_open(l.r.thread, &l.object));
    double k = config.rest_curvature, scale = 0.5 * config.bending_stiffness * k * k * 0.15;
    expect_near(1.0, energy_of(&l) / scale,
                0.02); /* the smoothing, and half a segment at each end */
    for (uint32_t i = 0; i <= 100; i++) {
        double angle = k * 0.0015 * i;
        l.object->now.x[i] = vec3_make(vbss_sin(angle) / k, (1.0 - vbss_cos(angle)) / k, 0.0);
    }
    expect_near(0.0, energy_of(&l) / scale, 1e-6);
    rig_end(&l.r);
}

/* ---- the cantilever */

static double static_error(uint32_t segments, double stiffness)
{
    rig r;
    vbss_thread_config config = paper(segments);
    config.drag = 8.0;
    baseline_of(&config.baseline)->thread_stiffness = stiffness;
    rig_begin(&r, &config);
    rig_clamp_here(&r, 0, along);
    rig_run(&r, 1e-3, 6000);
    double error = vec3_distance(rig_tip(&r), hanging_tip);
    rig_end(&r);
    return error;
}

static void cantilever_converges_to_elastica_at_second_order(void **state)
{
    (void)state;
    double coarse = static_error(15, 0.0), medium = static_error(30, 0.0);
    double fine = static_error(60, 0.0);
    expect_near(0.848e-3, coarse, 0.01e-3);
    expect_near(0.258e-3, medium, 0.005e-3);
    expect_near(0.080e-3, fine, 0.003e-3);
    assert_true(coarse / medium > 3.0 && medium / fine > 3.0);
    /* The springs only start the projection. */
    expect_near(medium, static_error(30, 0.01), 1e-9);
}

static vec3 released_tip(uint32_t segments, uint32_t substeps)
{
    rig r;
    vbss_thread_config config = paper(segments);
    baseline_of(&config.baseline)->thread_substeps = substeps;
    baseline_of(&config.baseline)->thread_tolerance = 1e-11;
    rig_begin(&r, &config);
    rig_clamp_here(&r, 0, along);
    rig_run(&r, 1e-3, 100);
    vec3 tip = rig_tip(&r);
    assert_int_equal(100 * substeps, rig_statistics(&r).substeps);
    rig_end(&r);
    return tip;
}

/* What two explicit steps, one half of the other, say of ever shorter ones. */
static vec3 extrapolated(vec3 coarse, vec3 fine)
{
    return vec3_add(fine, vec3_sub(fine, coarse));
}

static void release_converges_at_first_order_in_time(void **state)
{
    (void)state;
    vec3 wanted = falling_tip[1], tips[3]; /* after 0.1 s */
    for (uint32_t k = 0; k < 3; k++) {
        tips[k] = released_tip(30, 8u << k);
    }
    expect_near(2.0, vec3_distance(tips[0], tips[1]) / vec3_distance(tips[1], tips[2]), 0.1);
    /* What remains is of the segments' length, to second order. */
    double coarse = vec3_distance(extrapolated(tips[1], tips[2]), wanted);
    vec3 low = released_tip(60, 16), high = released_tip(60, 32);
    double fine = vec3_distance(extrapolated(low, high), wanted);
    expect_near(0.195e-3, coarse, 0.005e-3);
    expect_near(4.0, coarse / fine, 0.3);
}

/* ---- the length of the explicit steps */

static uint64_t substeps_of_next_step(rig *r)
{
    uint64_t before = rig_statistics(r).substeps;
    rig_run(r, 1e-3, 1);
    return rig_statistics(r).substeps - before;
}

static void substeps_follow_bending_stiffness(void **state)
{
    (void)state;
    /* 1/0.9 of h omega / 2 with omega = 4 / l^2 sqrt(EI / density), rounded up. */
    const uint32_t segments[] = {30, 60, 120, 240}, wanted[] = {2, 5, 18, 72};
    for (int i = 0; i < 4; i++) {
        rig r;
        vbss_thread_config config = paper(segments[i]);
        rig_begin(&r, &config);
        assert_int_equal(wanted[i], substeps_of_next_step(&r));
        rig_end(&r);
    }
}

/* A turn of 90 degrees is eight times as stiff as a straight one. */
static void rotation_needs_shorter_steps(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(60);
    double positions[61][3] = {{0.0}};
    for (int i = 0; i <= 60; i++) {
        int right = (i + 1) / 2, up = i / 2;
        positions[i][0] = 0.0025 * right;
        positions[i][1] = 0.0025 * up;
    }
    config.positions = positions[0];
    rig_begin(&r, &config);
    assert_int_equal(13, substeps_of_next_step(&r)); /* 4 / 0.9 sqrt(8) */
    rig_end(&r);
}

static void tension_needs_shorter_steps(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(30);
    config.drag = 100.0;
    rig_begin(&r, &config);
    rig_clamp_here(&r, 0, along);
    uint32_t load = rig_force(&r, 30, vec3_make(0.0, 0.0, 0.0));
    for (int i = 1; i <= 400; i++) {
        rig_move(&r, load, vec3_make(0.001 * i, 0.0, 0.0));
        rig_run(&r, 1e-3, 1);
    }
    /* dt^2 4 T / (m l) <= 4/3 */
    double dt = sqrt(config.linear_density * 0.005 * 0.005 / (3.0 * 0.4));
    expect_near(1e-3 / dt / 0.9, (double)substeps_of_next_step(&r), 1.0);
    rig_run(&r, 1e-3, 500);
    expect_near(0.4, rig_tension(&r, 15), 1e-6);
    expect_near(0.0, rig_fastest(&r), 1e-6);
    assert_int_equal(0, rig_baseline_statistics(&r).failed_projections);
    rig_end(&r);
}

/* ---- what holds it */

static void held_nodes_move_linearly_to_targets(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(12);
    baseline_of(&config.baseline)->thread_substeps = 4;
    rig_begin(&r, &config);
    uint32_t clamp = rig_clamp_here(&r, 0, along);
    rig_pin(&r, 6, vec3_make(0.07, 0.0, 0.0));
    rig_run(&r, 1e-3, 5);
    vec3 target = vec3_make(0.001, 0.002, -0.001);
    rig_move(&r, clamp, target);
    rig_run(&r, 1e-3, 1);
    expect_near_vec3(target, rig_position(&r, 0), 0.0);
    expect_near_vec3(vec3_scale(target, 1e3), rig_velocity(&r, 0), 1e-12);
    rig_run(&r, 1e-3, 1);
    expect_near_vec3(vec3_zero(), rig_velocity(&r, 0), 0.0);
    rig_end(&r);
}

/* Straight between two pins: no constraint can move anything, and none needs to. */
static void straight_section_between_holds_stays(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(8);
    config.gravity[1] = 0.0;
    rig_begin(&r, &config);
    rig_pin_here(&r, 0);
    rig_pin_here(&r, 8);
    rig_run(&r, 1e-3, 20);
    assert_int_equal(0, rig_baseline_statistics(&r).failed_projections);
    expect_near(0.0, rig_fastest(&r), 1e-9);
    rig_end(&r);
}

int test_paper(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(bending_force_is_energy_gradient_and_balances_clamp),
        harness_test(rest_curvature_minimises_energy),
        harness_test(cantilever_converges_to_elastica_at_second_order),
        harness_test(release_converges_at_first_order_in_time),
        harness_test(substeps_follow_bending_stiffness),
        harness_test(rotation_needs_shorter_steps),
        harness_test(tension_needs_shorter_steps),
        harness_test(held_nodes_move_linearly_to_targets),
        harness_test(straight_section_between_holds_stays),
    };
    return cmocka_run_group_tests_name("thread.paper", tests, NULL, NULL);
}
