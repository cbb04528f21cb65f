/* Method VBLAST: projection, damping and fallback of sections, forces at held nodes, promises. */
#include <math.h>

#include "fixtures/baseline_of.h"
#include "thread/paper_rig.h"
#include "thread/thread.h"

static vec3 at(double x)
{
    return vec3_make(x, 0.0, 0.0);
}

static double change(const double before[3], const double after[3])
{
    return vec3_distance(vec3_load(after), vec3_load(before)) / vec3_norm(vec3_load(before));
}

/* ---- projection and damping */

/* A tumbling thread. Returns how much its angular momentum changed in 0.2 s. */
static double tumble(uint32_t substeps)
{
    enum { NODES = 31 };
    rig r;
    vbss_thread_config config = paper(NODES - 1);
    config.gravity[1] = 0.0;
    baseline_of(&config.baseline)->thread_substeps = substeps;
    baseline_of(&config.baseline)->thread_damping = 0.02;
    rig_begin(&r, &config);
    vec3 velocities[NODES];
    vbss_random random;
    vbss_random_seed(&random, 5, 1);
    for (uint32_t i = 0; i < NODES; i++) {
        vec3 v = vec3_cross(vec3_make(3, 5, 7), rig_position(&r, i));
        velocities[i] = vec3_add_scaled(v, 0.2, vbss_random_direction(&random));
    }
    rig_place(&r, NULL, velocities);
    vbss_thread_momentum before = rig_momentum(&r);
    rig_run(&r, 1e-3, 200);
    vbss_thread_momentum after = rig_momentum(&r);
    expect_near(0.0, change(before.linear, after.linear), 1e-12);
    vbss_thread_statistics s = rig_statistics(&r);
    vbss_baseline_statistics own = rig_baseline_statistics(&r);
    /* |e|^2 / l^2 - 1, which is within the tolerance, is twice the stretch. */
    expect_near(0.0, s.stretch_error, 0.5 * baseline_of(&config.baseline)->thread_tolerance);
    assert_true(baseline_of(&config.baseline)->thread_tolerance <= 1e-6 &&
                own.projection_iterations >= s.substeps);
    assert_int_equal(0, own.failed_projections);
    rig_end(&r);
    return change(before.angular, after.angular);
}

static void free_section_conserves_length_and_momentum(void **state)
{
    (void)state;
    double coarse = tumble(4), fine = tumble(8);
    /* Multipliers turn with the segments in the projection: of first order. */
    assert_true(coarse < 0.02 && fine < 0.7 * coarse);
}

/* Full damping leaves the rigid motion of each section: a pin in the middle divides them. */
static void damping_is_per_section(void **state)
{
    (void)state;
    enum { NODES = 21, MIDDLE = 10 };
    rig r;
    vbss_thread_config config = paper(NODES - 1);
    config.gravity[1] = 0.0;
    baseline_of(&config.baseline)->thread_damping = 1.0;
    rig_begin(&r, &config);
    rig_pin_here(&r, MIDDLE);
    vec3 velocities[NODES], rigid[NODES];
    for (uint32_t i = 0; i < NODES; i++) {
        double arm = rig_position(&r, i).x - 0.075;
        rigid[i] = vec3_make(0, (i < MIDDLE ? 1.0 : 2.0) * arm, 0);
        velocities[i] = vec3_add(rigid[i], vec3_make(0, 0, i % 2 == 0 ? 0.01 : -0.01));
    }
    velocities[MIDDLE] = vec3_zero();
    rig_place(&r, NULL, velocities);
    rig_run(&r, 1e-3, 1);
    for (uint32_t i = 0; i < NODES; i++) {
        expect_near_vec3(rigid[i], rig_velocity(&r, i), 3e-3);
    }
    rig_end(&r);
}

/* ---- fallback */

static void pull(rig *r, uint32_t id, double from, double to)
{
    for (uint32_t i = 1; i <= 100; i++) {
        rig_move(r, id, at(from + (to - from) * i / 100.0));
        rig_run(r, 1e-3, 1);
    }
}

static void overstretched_section_falls_back_to_points(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(30);
    config.drag = 20.0;
    rig_begin(&r, &config);
    rig_pin_here(&r, 0);
    rig_pin(&r, 10, at(0.045));
    uint32_t end = rig_pin(&r, 30, at(0.14));
    rig_run(&r, 1e-3, 100);
    assert_int_equal(0, rig_baseline_statistics(&r).failed_projections);
    pull(&r, end, 0.14, 0.23); /* 185 mm for 100 mm */
    uint64_t fallbacks = rig_baseline_statistics(&r).failed_projections;
    assert_true(fallbacks > 10);
    uint64_t substeps = rig_statistics(&r).substeps;
    rig_run(&r, 1e-3, 500);
    vbss_thread_statistics s = rig_statistics(&r);
    /* One section of two; the other keeps its lengths. */
    assert_int_equal(s.substeps - substeps,
                     rig_baseline_statistics(&r).failed_projections - fallbacks);
    for (uint32_t i = 0; i < 10; i++) {
        expect_near(0.005, vec3_distance(rig_position(&r, i), rig_position(&r, i + 1)), 1e-8);
    }
    expect_near_vec3(at(0.23), rig_position(&r, 30), 0.0);
    expect_near_vec3(at(0.045), rig_position(&r, 10), 0.0);
    assert_true(s.last_stretch >= 0.85 && s.last_stretch < 1.0);
    expect_near(s.last_stretch, s.last_stretch_error, 0.0);
    assert_true(s.stretch_error >= s.last_stretch_error);
    /* The springs alone pull back, and ask for no shorter parts. */
    assert_int_equal(1000, s.substeps - substeps);
    double spring =
        config.linear_density * 0.005 * 1.01 * 0.75 / (0.5e-3 * 0.5e-3); /* drag: 1.01 */
    expect_near(spring * 0.85 * 0.005, rig_tension(&r, 20), 3e-4);
    expect_near(spring * 0.85 * 0.005, rig_reaction_force(&r, end).x, 3e-4);
    pull(&r, end, 0.23, 0.14);
    fallbacks = rig_baseline_statistics(&r).failed_projections;
    rig_run(&r, 1e-3, 100);
    assert_int_equal(fallbacks, rig_baseline_statistics(&r).failed_projections);
    expect_near(0.0, rig_statistics(&r).last_stretch_error,
                baseline_of(&config.baseline)->thread_tolerance);
    rig_end(&r);
}

static void coincident_nodes_recover_length(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(10);
    double positions[11][3] = {{0.0}};
    config.positions = positions[0];
    rig_begin(&r, &config);
    rig_run(&r, 1e-3, 100);
    expect_near(0.0, rig_statistics(&r).last_stretch_error,
                baseline_of(&config.baseline)->thread_tolerance);
    rig_end(&r);
}

/* ---- what holds and loads it */

static void clamp_carries_weight_and_moment(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(30);
    config.drag = 8.0;
    baseline_of(&config.baseline)->thread_tolerance =
        1e-2; /* met before: there is one iteration all the same */
    rig_begin(&r, &config);
    uint32_t clamp = rig_clamp_here(&r, 0, along);
    rig_relax(&r, 1e-3, 1e-10, 12000);
    double line = 9.81 * config.linear_density, weight = line * config.length;
    vbss_thread_momentum m = rig_momentum(&r);
    expect_near_vec3(vec3_make(0.0, weight, 0.0), rig_reaction_force(&r, clamp), 1e-7 * weight);
    expect_near_vec3(vec3_make(0.0, 0.0, weight * m.centre[0]), rig_reaction_torque(&r, clamp),
                     1e-3 * weight * m.centre[0]);
    /* What hangs on a segment is the weight below, along its tangent. */
    for (uint32_t i = 0; i < 30; i++) {
        vec3 e = vec3_sub(rig_position(&r, i + 1), rig_position(&r, i));
        double below = line * (config.length - (i + 0.5) * 0.005);
        expect_near(-below * e.y / vec3_norm(e), rig_tension(&r, i), 0.01 * weight);
    }
    rig_end(&r);
}

/* What pulls at the thread from outside is what changes its momentum, moved ends included. */
static void reactions_equal_momentum_change(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(30);
    baseline_of(&config.baseline)->thread_substeps = 1;
    rig_begin(&r, &config);
    uint32_t ids[3] = {rig_clamp_here(&r, 0, along), rig_pin(&r, 12, at(0.055)),
                       rig_spring(&r, 30, at(0.12), 200.0, 0.01)};
    rig_run(&r, 2e-4, 100);
    double mass = rig_momentum(&r).mass, h = 2e-4;
    for (int i = 0; i < 200; i++) {
        rig_move(&r, ids[1], vec3_make(0.055 + 1e-5 * i, 1e-5 * i, 0.0));
        rig_move(&r, ids[2], vec3_make(0.12 - 1e-4 * i, 1e-4 * i, 2e-5 * i));
        vec3 before = vec3_load(rig_momentum(&r).linear);
        rig_run(&r, h, 1);
        vec3 rate = vec3_scale(vec3_sub(vec3_load(rig_momentum(&r).linear), before), 1.0 / h);
        vec3 wanted = vec3_scale(vec3_make(0, -9.81, 0), mass);
        double largest = vec3_norm(wanted);
        for (int k = 0; k < 3; k++) {
            vec3 force = rig_reaction_force(&r, ids[k]);
            wanted = vec3_add(wanted, force);
            largest += vec3_norm(force);
        }
        expect_near_vec3(wanted, rate, 1e-9 * largest);
    }
    assert_int_equal(0, rig_baseline_statistics(&r).failed_projections);
    rig_end(&r);
}

static void springs_and_masses_carry_load(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config config = paper(12);
    config.drag = 20.0;
    rig_begin(&r, &config);
    rig_spring(&r, 0, at(0.0), 50.0, 0.0);
    uint32_t mass = rig_mass(&r, 12, 1e-4);
    rig_relax(&r, 1e-3, 1e-9, 12000);
    double load = 9.81e-4, weight = 9.81 * config.linear_density * 0.15;
    expect_near_vec3(vec3_make(0.0, -(load + weight) / 50.0, 0.0), rig_position(&r, 0), 1e-8);
    expect_near(load + 0.5 * weight / 12.0, rig_tension(&r, 11), 1e-7 * load);
    expect_near_vec3(vec3_make(0.0, -load, 0.0), rig_reaction_force(&r, mass), 1e-6 * load);
    rig_end(&r);
}

/* ---- the promises of a step */

static void non_finite_state_is_reported_and_undone(void **state)
{
    (void)state;
    rig r;
    thread_object *t;
    vbss_thread_config config = paper(8);
    rig_begin(&r, &config);
    expect_ok(vbss_thread_open(r.thread, &t));
    rig_run(&r, 1e-3, 1);
    uint64_t before, after;
    t->now.v[8] = vec3_make(1e60, 0, 0); /* no call gives it that */
    expect_ok(vbss_thread_get_hash(r.thread, &before));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_thread_step(r.thread, 1e-3));
    expect_ok(vbss_thread_get_hash(r.thread, &after));
    assert_int_equal(before, after);
    rig_end(&r);
}

/* At a clamp, over half of the segment behind it: from the clamp's direction to the chord's. */
static vec3 curvature_behind(rig *r, uint32_t node, vec3 direction)
{
    vec3 chord = vec3_sub(rig_position(r, node + 1), rig_position(r, node));
    return vec3_scale(vec3_sub(vec3_scale(chord, 1.0 / 0.005), direction), 2.0 / 0.005);
}

static void clamped_thread_shows_curvature(void **state)
{
    (void)state;
    const uint32_t nodes[] = {0, 5};
    for (int k = 0; k < 2; k++) {
        rig r;
        vbss_thread_config config = paper(30);
        vec3 oblique = vec3_make(0.6, 0.0, 0.8);
        rig_begin(&r, &config);
        uint32_t clamp = rig_clamp_here(&r, nodes[k], along);
        expect_near_vec3(vec3_zero(), rig_curvature(&r, nodes[k]), 1e-10); /* straight, aligned */
        expect_ok(vbss_thread_detach(r.thread, clamp));
        rig_clamp_here(&r, nodes[k], vec3_scale(oblique, 3.0));
        vec3 wanted = vec3_make(0.4 * 400.0, 0.0, -0.8 * 400.0); /* nothing has moved */
        expect_near_vec3(wanted, rig_curvature(&r, nodes[k]), 1e-9);
        rig_run(&r, 1e-3, 100);
        wanted = curvature_behind(&r, nodes[k], oblique);
        expect_near_vec3(wanted, rig_curvature(&r, nodes[k]), 1e-10 * vec3_norm(wanted));
        assert_true(wanted.y < -5.0); /* bent down by its weight */
        assert_true(rig_energies(&r).bending > 0.0);
        rig_end(&r);
    }
}

/* Cosines of straight turns round to beyond one. */
static void straight_thread_has_no_bending_in_any_direction(void **state)
{
    (void)state;
    vbss_random random;
    vbss_random_seed(&random, 1, 2);
    for (int k = 0; k < 200; k++) {
        rig r;
        vbss_thread_config config = paper(20);
        config.rest_curvature = k % 2 == 0 ? 0.0 : 1e-3;
        vec3_store(config.direction, vbss_random_direction(&random));
        rig_begin(&r, &config);
        expect_near(0.0, rig_energies(&r).bending, 1e-15);
        rig_run(&r, 1e-4, 1);
        rig_end(&r);
    }
}

/* Also where a load strains the last segment by half of itself within one explicit step. */
static void loaded_thread_has_load_in_every_segment(void **state)
{
    (void)state;
    const double loads[] = {1e-4, 1e-2, 0.1};
    for (int k = 0; k < 3; k++) {
        rig r;
        vbss_thread_config config = paper(12);
        config.length = 0.01;
        config.gravity[1] = 0.0;
        config.drag = 8.0;
        rig_begin(&r, &config);
        rig_clamp_here(&r, 0, along);
        rig_force(&r, 12, vec3_scale(along, loads[k]));
        rig_run(&r, 1e-3, 300);
        for (uint32_t i = 0; i < 12; i++) {
            expect_near(loads[k], rig_tension(&r, i), 1e-5 * loads[k]);
        }
        rig_end(&r);
    }
}

int test_paper_sections(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loaded_thread_has_load_in_every_segment),
        cmocka_unit_test(straight_thread_has_no_bending_in_any_direction),
        cmocka_unit_test(clamped_thread_shows_curvature),
        harness_test(free_section_conserves_length_and_momentum),
        harness_test(damping_is_per_section),
        harness_test(overstretched_section_falls_back_to_points),
        harness_test(coincident_nodes_recover_length),
        harness_test(clamp_carries_weight_and_moment),
        harness_test(reactions_equal_momentum_change),
        harness_test(springs_and_masses_carry_load),
        harness_test(non_finite_state_is_reported_and_undone),
    };
    return cmocka_run_group_tests_name("thread.paper_sections", tests, NULL, NULL);
}
