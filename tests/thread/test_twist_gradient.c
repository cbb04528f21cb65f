/* Forces, stiffness and torques of twist against finite differences of its energy. */
#include <math.h>
#include <string.h>

#include "base/rotation.h"
#include "thread/rig.h"
#include "thread/twist.h"

enum { SEGMENTS = 12, NODES = SEGMENTS + 1 };

/* A bent thread with three clamps, at its ends and inside, which turn in the next step. */
typedef struct twisted {
    rig r;
    thread_object *t;
    uint32_t clamps[3];
    vec3 x[NODES];
} twisted;

static const uint32_t clamp_nodes[3] = {0, 5, SEGMENTS};

static vec3 draw_direction(harness_source *source)
{
    const vec3 d = harness_draw_vec3(source, -0.7, 0.7);
    return vec3_unit_or(vec3_add(d, vec3_make(1.0, 0.0, 0.0)), vec3_make(1.0, 0.0, 0.0));
}

static void twisted_begin(twisted *w, harness_source *source, double stiffness, double roll)
{
    vbss_thread_config c = rig_config(0.12, SEGMENTS);
    c.torsional_stiffness = stiffness;
    c.rest_twist = 30.0;
    rig_begin(&w->r, &c);
    for (uint32_t i = 0; i < NODES; i++) {
        w->x[i] = vec3_add(vec3_make(0.01 * i, 0.0, 0.0), harness_draw_vec3(source, -4e-3, 4e-3));
    }
    rig_place(&w->r, w->x, NULL);
    for (int k = 0; k < 3; k++) {
        double target[3], direction[3];
        w->clamps[k] = rig_clamp_here(&w->r, clamp_nodes[k], draw_direction(source));
        vec3_store(target, w->x[clamp_nodes[k]]);
        vec3_store(direction, draw_direction(source));
        expect_ok(vbss_thread_set_attachment_target(w->r.thread, w->clamps[k], target, direction));
        expect_ok(vbss_thread_set_roll(w->r.thread, w->clamps[k], roll * (k == 1)));
    }
    expect_ok(vbss_thread_open(w->r.thread, &w->t));
    expect_ok(vbss_thread_update_derived(w->t));
    vbss_thread_set_clamp_directions(w->t, 1.0);
    vbss_thread_begin_twist(w->t);
    memcpy(w->t->trial, w->x, sizeof w->x);
}

static double trial_energy(twisted *w)
{
    double energy = 0.0;
    for (uint32_t k = 0; k < 2; k++) {
        thread_twist_span *span = &w->t->twist_spans[k];
        vbss_thread_set_twist(w->t, w->t->trial, span);
        energy +=
            0.5 * span->length * span->torque * span->torque / w->t->config.torsional_stiffness;
    }
    return energy;
}

static const vbss_integration integration = {.h = 1e-3, .inertia = 1e6, .velocity_factor = 1e3};

static thread_substep full_substep(void)
{
    return (thread_substep){
        .integration = &integration, .step_length = 1e-3, .end_fraction = 1.0, .min_tension = -1.0};
}

static void check_forces(harness_source *source, void *user)
{
    (void)user;
    twisted w;
    twisted_begin(&w, source, 1e-6, harness_draw_real(source, -9.0, 9.0));
    const thread_substep substep = full_substep();
    vbss_thread_update_twist(w.t, &substep);
    double largest = 0.0;
    for (uint32_t i = 0; i < NODES; i++) {
        largest = fmax(largest, vec3_norm(w.t->twist_forces[i]));
    }
    for (uint32_t i = 0; i < NODES; i++) {
        const vec3 along = draw_direction(source), force = w.t->twist_forces[i];
        const double d = 1e-6;
        w.t->trial[i] = vec3_add_scaled(w.x[i], d, along);
        const double high = trial_energy(&w);
        w.t->trial[i] = vec3_add_scaled(w.x[i], -d, along);
        const double low = trial_energy(&w);
        w.t->trial[i] = w.x[i];
        expect_near(-(high - low) / (2.0 * d) / largest, vec3_dot(force, along) / largest, 1e-6);
    }
    rig_end(&w.r);
}

static void forces_are_slopes_of_energy(void **state)
{
    (void)state;
    harness_property("forces of twist", 20, check_forces, NULL);
}

static void check_stiffness(harness_source *source, void *user)
{
    (void)user;
    twisted w;
    twisted_begin(&w, source, 1e-12, 1e5);
    const thread_substep substep = full_substep();
    double residual[2];
    vec3 move[NODES], u[NODES];
    for (uint32_t i = 0; i < NODES; i++) {
        const vec3 drawn = harness_draw_vec3(source, -1e-4, 1e-4);
        move[i] = w.t->prescribed_by[i] != 0 ? vec3_zero() : drawn;
    }
    for (int k = 0; k < 2; k++) {
        memcpy(w.t->trial, w.x, sizeof w.x);
        vbss_thread_update_twist(w.t, &substep);
        for (uint32_t i = 0; i < NODES; i++) {
            u[i] = vec3_scale(move[i], k == 0 ? 1.0 : 0.1);
            w.t->trial[i] = vec3_add(w.x[i], u[i]);
        }
        residual[k] = vbss_thread_twist_residual(w.t, &integration, u);
    }
    assert_true(residual[1] > 0.0 && residual[1] < 0.02 * residual[0]);
    rig_end(&w.r);
}

/* A small stiffness and a large twist: the torque is constant, and the stiffness exact. What it did not
 * foresee is then of second order. */
static void stiffness_is_slope_of_forces(void **state)
{
    (void)state;
    harness_property("stiffness of twist", 20, check_stiffness, NULL);
}

static void check_balance(harness_source *source, void *user)
{
    (void)user;
    twisted w;
    twisted_begin(&w, source, 1e-6, harness_draw_real(source, -9.0, 9.0));
    vec3 sum = vec3_zero(), moment = vec3_zero();
    double scale = 0.0;
    vbss_thread_commit_twist(w.t);
    for (uint32_t i = 0; i < NODES; i++) {
        const vec3 force = vbss_thread_twist_force(w.t, i);
        sum = vec3_add(sum, force);
        moment = vec3_add(moment, vec3_cross(w.x[i], force));
    }
    for (uint32_t k = 0; k < 3; k++) {
        const vec3 torque = vbss_thread_twist_torque(w.t, clamp_nodes[k]);
        scale = fmax(scale, vec3_norm(torque));
        moment = vec3_sub(moment, torque);
    }
    expect_near(0.0, vec3_norm(moment) / scale, 1e-12);
    expect_near(0.0, vec3_norm(sum) * 0.12 / scale, 1e-12);
    rig_end(&w.r);
}

/* A rigid rotation of thread and clamps does no work, so the torques of clamps balance the moments of the
 * forces. */
static void torques_of_clamps_balance_forces(void **state)
{
    (void)state;
    harness_property("torques of clamps", 20, check_balance, NULL);
}

int test_twist_gradient(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_are_slopes_of_energy),
        cmocka_unit_test(stiffness_is_slope_of_forces),
        cmocka_unit_test(torques_of_clamps_balance_forces),
    };
    return cmocka_run_group_tests_name("thread.twist_gradient", tests, NULL, NULL);
}
