/* The drain at rest: by itself, under its weight, under loads, in any frame. */
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"

static void turn(drain_rig *r, harness_source *source)
{
    quat q = harness_draw_unit_quat(source);
    r->config.orientation[0] = 3.0 * q.w; /* of any length */
    r->config.orientation[1] = 3.0 * q.x;
    r->config.orientation[2] = 3.0 * q.y;
    r->config.orientation[3] = 3.0 * q.z;
    vec3_store(r->config.position, harness_draw_vec3(source, -0.05, 0.05));
}

static pose frame_of(const drain_rig *r)
{
    const double *q = r->config.orientation;
    return pose_make(vec3_load(r->config.position), quat_unit(quat_make(q[0], q[1], q[2], q[3])));
}

/* ---- nothing acts */

static void rest_alone(harness_source *source, void *user)
{
    (void)user;
    drain_rig r;
    static vec3 x[DRAIN_RIG_NODES];
    drain_rig_begin(&r);
    r.config.mesh = (vbss_drain_mesh)harness_draw_below(source, 4);
    turn(&r, source);
    drain_rig_make(&r);
    drain_rig_copy(&r, x);
    const vec3 *rest = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_REST_POSITIONS);
    for (uint32_t i = 0; i < r.places.node_count; i++) {
        expect_near_vec3(pose_apply(frame_of(&r), rest[i]), x[i], 1e-16);
    }
    drain_rig_run(&r, 1e-3, 1000);
    expect_near(0.0, drain_rig_distance(&r, x), 1e-15);
    expect_near(0.0, drain_rig_energies(&r).total, 1e-25);
    drain_rig_end(&r);
}

static void unloaded_drain_stays(void **state)
{
    (void)state;
    harness_property("alone", 8, rest_alone, NULL);
}

/* ---- in any frame */

enum { LOADS = 3 };

/* Under loads and gravity given in the drain's frame, its shape in its frame, and its anchors' forces. */
static void loaded(drain_rig *r, vec3 *shape, vec3 *held)
{
    pose frame = frame_of(r);
    vec3_store(r->config.gravity, quat_rotate(frame.orientation, vec3_make(1.0, -9.0, 4.0)));
    drain_rig_statics(r);
    drain_rig_make(r);
    const vec3 loads[LOADS] = {{0.0, 0.01, 0.05}, {0.01, -0.02, -0.06}, {-0.02, 0.01, 0.01}};
    const uint32_t nodes[LOADS] = {r->places.marks[0], r->places.marks[1], r->places.gap_points[0]};
    for (int k = 0; k < LOADS; k++) {
        drain_rig_force(r, nodes[k], quat_rotate(frame.orientation, loads[k]));
    }
    drain_rig_relax(r, 1e-12, 500);
    drain_rig_copy(r, shape);
    for (uint32_t i = 0; i < r->places.node_count; i++) {
        shape[i] = pose_apply_inverse(frame, shape[i]);
    }
    const vec3 *forces = drain_rig_vectors(r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
    for (uint32_t i = 0; i < drain_rig_count(r, VBSS_DRAIN_VIEW_ANCHORS); i++) {
        held[i] = quat_rotate_back(frame.orientation, forces[i]);
    }
}

static void same_in_a_frame(harness_source *source, void *user)
{
    (void)user;
    drain_rig plain, turned;
    static vec3 x[2][DRAIN_RIG_NODES], held[2][DRAIN_RIG_NODES];
    drain_rig_begin(&plain);
    drain_rig_begin(&turned);
    turn(&turned, source);
    loaded(&plain, x[0], held[0]);
    loaded(&turned, x[1], held[1]);
    for (uint32_t i = 0; i < plain.places.node_count; i++) {
        expect_near_vec3(x[0][i], x[1][i], 1e-11);
    }
    for (uint32_t i = 0; i < drain_rig_count(&plain, VBSS_DRAIN_VIEW_ANCHORS); i++) {
        expect_near_vec3(held[0][i], held[1][i], 1e-9);
    }
    expect_near(drain_rig_gap(&plain).signed_gap, drain_rig_gap(&turned).signed_gap, 1e-11);
    drain_rig_end(&turned);
    drain_rig_end(&plain);
}

static void static_shape_is_frame_invariant(void **state)
{
    (void)state;
    harness_property("frames", 6, same_in_a_frame, NULL);
}

/* ---- what anchors bear */

static void anchors_carry_target_load(void **state)
{
    (void)state;
    const vec3 loads[] = {{0.03, 0.0, 0.0}, {0.0, 0.05, 0.0}, {0.0, -0.02, 0.08}};
    for (int k = 0; k < 3; k++) {
        drain_rig r;
        drain_rig_begin(&r);
        drain_rig_statics(&r);
        drain_rig_make(&r);
        drain_rig_force(&r, r.places.marks[k % 2], loads[k]);
        drain_rig_relax(&r, 1e-13, 500);
        expect_near_vec3(vec3_neg(loads[k]), drain_rig_anchor_sum(&r), 1e-9 * vec3_norm(loads[k]));
        drain_rig_end(&r);
    }
}

static void anchors_carry_weight(void **state)
{
    (void)state;
    drain_rig r;
    double masses[DRAIN_RIG_NODES], mass = 0.0;
    drain_rig_begin(&r);
    drain_rig_statics(&r);
    r.config.gravity[0] = 2.0;
    r.config.gravity[1] = -9.81;
    drain_rig_make(&r);
    drain_rig_masses(&r, masses);
    for (uint32_t i = 0; i < r.places.node_count; i++) {
        mass += masses[i];
    }
    /* The tube's, less the slit's: an ellipse of 10 x 3 mm. Flat triangles have a little less. */
    double pi = 3.14159265358979323846, area = 2 * pi * 6.5e-3 * 32e-3 - pi / 4 * 10e-3 * 3e-3;
    expect_near(950.0 * 1e-3 * area, mass, 0.04 * mass);
    drain_rig_relax(&r, 1e-13, 500);
    expect_near_vec3(vec3_scale(vec3_load(r.config.gravity), -mass), drain_rig_anchor_sum(&r),
                     1e-9 * 9.81 * mass);
    assert_true(drain_rig_energies(&r).bending > 0.0); /* it sags */
    drain_rig_end(&r);
}

int test_drain_statics(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(unloaded_drain_stays),
        harness_test(static_shape_is_frame_invariant),
        cmocka_unit_test(anchors_carry_target_load),
        cmocka_unit_test(anchors_carry_weight),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
