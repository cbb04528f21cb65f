/* Method VBLAST in motion: its oscillator, its damping, the length of its explicit steps. */
#include "fixtures/baseline_of.h"
#include "drain/paper_drain_rig.h"

#include <math.h>

/* ---- the oscillator
 *
 * Two particles that mirror each other, displaced against each other, have no momentum, so that damping sees all of
 * their motion. With q = (1 - c) / (1 + dt drag) and s = dt^2 k / m the scheme is
 *   x' = (1 + q - q s) x - q x_before:  x_n = sqrt(q)^n (cos n a + b sin n a) x_0. */

static const uint32_t pair[2] = {PAPER_MIDDLE + 2, PAPER_MIDDLE + 10};

static void displace_pair(paper_rig *r, double amplitude)
{
    const vec3 displacements[2] = {{0.0, 0.0, amplitude}, {0.0, 0.0, -amplitude}};
    paper_displace(r, pair, displacements, 2);
}

static void expect_oscillation(double damping, double drag, uint32_t substeps)
{
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_damping = damping;
    config.drag = drag;
    baseline_of(&config.baseline)->drain_substeps = substeps;
    paper_begin(&r, &config);
    double mass = r.object->mass[pair[0]], dt = 1e-3 / substeps, amplitude = 1e-3;
    double q = (1.0 - damping) / (1.0 + dt * drag), s = dt * dt * 125.0 / mass;
    double root = sqrt(q), cosine = (1.0 + q - q * s) / (2.0 * root), angle = acos(cosine);
    double b = ((1.0 - q * s) / root - cosine) / sin(angle);
    assert_true(fabs(cosine) < 1.0);
    assert_true(mass == r.object->mass[pair[1]]);
    displace_pair(&r, amplitude);
    for (uint32_t n = 1; n <= 60; n++) {
        paper_run(&r, 1e-3, 1);
        double k = (double)n * substeps;
        double wanted = amplitude * pow(root, k) * (cos(k * angle) + b * sin(k * angle));
        expect_near(wanted, paper_moved(&r, pair[0]).z, 1e-11 * amplitude);
        expect_near(-wanted, paper_moved(&r, pair[1]).z, 1e-11 * amplitude);
    }
    paper_end(&r);
}

static void displaced_particles_oscillate_as_scheme(void **state)
{
    (void)state;
    expect_oscillation(0.0, 0.0, 4);
    expect_oscillation(0.0, 20.0, 4);
    expect_oscillation(0.02, 0.0, 4);
    expect_oscillation(0.3, 5.0, 8);
}

/* The largest error within 20 ms from the damped oscillator itself. */
static double error_of(uint32_t substeps)
{
    paper_rig r;
    vbss_drain_config config = paper_config();
    config.drag = 100.0;
    baseline_of(&config.baseline)->drain_substeps = substeps;
    paper_begin(&r, &config);
    double omega = sqrt(125.0 / r.object->mass[pair[0]]), largest = 0.0;
    double damped = sqrt(omega * omega - 50.0 * 50.0);
    displace_pair(&r, 1e-3);
    for (uint32_t n = 1; n <= 20; n++) {
        paper_run(&r, 1e-3, 1);
        double t = 1e-3 * n;
        double wanted = exp(-50.0 * t) * (cos(damped * t) + 50.0 / damped * sin(damped * t));
        largest = fmax(largest, fabs(paper_moved(&r, pair[0]).z - 1e-3 * wanted));
    }
    paper_end(&r);
    return largest;
}

static void first_order_convergence_to_damped_oscillator(void **state)
{
    (void)state;
    double coarse = error_of(128), medium = error_of(256), fine = error_of(512);
    expect_near(2.0, coarse / medium, 0.1);
    expect_near(2.0, medium / fine, 0.1);
    assert_true(fine < 1e-5);
}

/* Damping takes what is relative to the rigid motion only: what one particle had, all have. */
static void damping_conserves_momentum(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_damping = 1.0;
    baseline_of(&config.baseline)->drain_stiffness = 0.0;
    paper_begin(&r, &config);
    vec3 v[PAPER_NODES] = {{0.0, 0.0, 0.0}};
    v[7] = vec3_make(0.3, -0.2, 0.5);
    expect_ok(vbss_drain_set_state(r.drain, NULL, &v[0].x, PAPER_NODES));
    paper_run(&r, 1e-3, 1);
    vec3 sum = vec3_zero();
    double total = 0.0;
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        sum = vec3_add_scaled(sum, r.object->mass[i], r.object->v[i]);
        total += r.object->mass[i];
    }
    expect_near_vec3(vec3_scale(v[7], r.object->mass[7]), sum, 1e-18);
    /* What is left is a rigid motion of where they were. */
    vec3 offset = vec3_sub(r.object->mesh.rest[50], r.object->mesh.rest[20]);
    vec3 rate = vec3_sub(r.object->v[50], r.object->v[20]);
    expect_near(0.0, vec3_dot(offset, rate), 1e-14 * vec3_norm(v[7]) * vec3_norm(offset));
    assert_true(vec3_norm(rate) > 1e-3);
    assert_true(total > 80.0 * r.object->mass[7]);
    paper_end(&r);
}

static void undamped_energy_is_conserved(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_substeps = 64;
    paper_begin(&r, &config);
    displace_pair(&r, 1e-3);
    double begin = paper_energies(&r).total;
    expect_near(2.0 * 0.5 * 125.0 * 1e-6, begin, 1e-16);
    for (uint32_t n = 0; n < 500; n++) {
        paper_run(&r, 1e-3, 1);
        expect_near(1.0, paper_energies(&r).total / begin, 0.03); /* dt omega / 2 */
    }
    paper_end(&r);
}

/* ---- the length of the explicit steps */

static uint32_t parts_of(double stiffness, double h)
{
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_stiffness = stiffness;
    paper_begin(&r, &config);
    paper_run(&r, h, 1);
    uint32_t parts = (uint32_t)paper_statistics(&r).parts;
    paper_end(&r);
    return parts;
}

static uint32_t lightest(const paper_rig *r)
{
    uint32_t node = 0;
    for (uint32_t i = 1; i < PAPER_NODES; i++) {
        node = r->object->mass[i] < r->object->mass[node] ? i : node;
    }
    return node;
}

static void substeps_follow_lightest_particle(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    paper_begin(&r, &config);
    double smallest = r.object->mass[lightest(&r)];
    paper_end(&r);
    const double stiffness[] = {1.0, 125.0, 2e3, 1e5};
    for (int k = 0; k < 4; k++) {
        double wanted = 1e-3 / (0.9 * 2.0 * sqrt(smallest / stiffness[k]));
        assert_int_equal(ceil(wanted), parts_of(stiffness[k], 1e-3));
    }
    assert_int_equal(3, parts_of(125.0, 1e-3));
    assert_int_equal(1, parts_of(0.0, 0.1));
}

/* How many times its energy the lightest has after so many ms. */
static double growth(uint32_t substeps, uint32_t steps)
{
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_stiffness = 2e4;
    baseline_of(&config.baseline)->drain_substeps = substeps;
    paper_begin(&r, &config);
    const uint32_t node = lightest(&r);
    const vec3 displacement = {1e-6, 0.0, 0.0};
    paper_displace(&r, &node, &displacement, 1);
    double begin = paper_energies(&r).total;
    paper_run(&r, 1e-3, steps);
    double factor = paper_energies(&r).total / begin;
    paper_end(&r);
    return factor;
}

static void stability_bound_is_sharp(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    paper_begin(&r, &config);
    double smallest = r.object->mass[lightest(&r)];
    paper_end(&r);
    double bound = 1e-3 / (2.0 * sqrt(smallest / 2e4));
    assert_true(growth((uint32_t)bound + 1, 200) < 100.0);
    assert_true(growth((uint32_t)bound, 1) > 1e6);
    uint32_t chosen = parts_of(2e4, 1e-3);
    assert_in_range(chosen, (uint32_t)bound + 1, (uint32_t)(bound / 0.9) + 1);
}

static void diverged_step_is_reported_and_undone(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_substeps = 1000;
    baseline_of(&config.baseline)->drain_stiffness = 1e9;
    paper_begin(&r, &config);
    displace_pair(&r, 1e-3);
    uint64_t hash = paper_hash(&r);
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_drain_step(r.drain, 0.1));
    assert_true(hash == paper_hash(&r));
    paper_end(&r);
}

int test_paper_drain_motion(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(displaced_particles_oscillate_as_scheme),
        harness_test(first_order_convergence_to_damped_oscillator),
        harness_test(damping_conserves_momentum),
        harness_test(undamped_energy_is_conserved),
        harness_test(substeps_follow_lightest_particle),
        harness_test(stability_bound_is_sharp),
        harness_test(diverged_step_is_reported_and_undone),
    };
    return cmocka_run_group_tests_name("drain.paper_drain_motion", tests, NULL, NULL);
}
