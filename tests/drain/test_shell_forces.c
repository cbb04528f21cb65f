/* Forces of a shell: the slope of its energy, none by moving rigidly, none at rest. */
#include <string.h>

#include "drain/shell_sheet.h"

#include "harness/harness.h"

static double slope(shell_rig *r, double *at)
{
    const double h = 1e-4, home = *at;
    double energy[4];
    static const double offsets[4] = {-2.0, -1.0, 1.0, 2.0};
    for (int k = 0; k < 4; k++) {
        *at = home + offsets[k] * h;
        energy[k] = shell_rig_energy(r);
    }
    *at = home;
    return (8.0 * (energy[2] - energy[1]) - (energy[3] - energy[0])) / (12.0 * h);
}

static void force_is_slope(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    shell_sheet_start(source, &r);
    shell_sheet_deform(source, &r, 0.15);
    double stiffest = vbss_max(shell_rig_stiffest(&r), 1.0);
    for (uint32_t i = 0; i < r.node_count; i++) {
        vec3 slopes;
        slopes.x = slope(&r, &r.x[i].x);
        slopes.y = slope(&r, &r.x[i].y);
        slopes.z = slope(&r, &r.x[i].z);
        shell_rig_energy(&r);
        expect_near(0.0, vec3_norm(vec3_add(r.forces[i], slopes)), 5e-9 * stiffest);
    }
    shell_rig_end(&r);
}

static void force_is_negative_energy_gradient(void **state)
{
    (void)state;
    harness_property("shell forces are slopes", 60, force_is_slope, NULL);
}

static void forces_balance(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    shell_sheet_start(source, &r);
    shell_sheet_deform(source, &r, 0.3);
    double rounding = r.node_count * shell_rig_rounding(&r), size = 0.0;
    shell_rig_energy(&r);
    vec3 force = vec3_zero(), moment = vec3_zero();
    for (uint32_t i = 0; i < r.node_count; i++) {
        force = vec3_add(force, r.forces[i]);
        moment = vec3_add(moment, vec3_cross(r.x[i], r.forces[i]));
        size += vec3_norm(r.forces[i]);
    }
    expect_near(0.0, vec3_norm(force), 1e-15 * size + rounding);
    expect_near(0.0, vec3_norm(moment), 1e-14 * size + 4.0 * rounding);
    shell_rig_end(&r);
}

static void net_force_and_moment_are_zero(void **state)
{
    (void)state;
    harness_property("shell forces balance", 60, forces_balance, NULL);
}

static void rest_is_quiet(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    shell_sheet_start(source, &r);
    expect_same_bits(0.0, shell_rig_energy(&r)); /* any shape is free of stress, to the bit */
    for (uint32_t i = 0; i < r.node_count; i++) {
        expect_near(0.0, vec3_norm(r.forces[i]), 0.0);
    }
    shell_sheet_deform(source, &r, 0.0);
    double rounding = 8.0 * shell_rig_rounding(&r), stiffest = shell_rig_stiffest(&r);
    expect_near(0.0, shell_rig_energy(&r), r.node_count * rounding * rounding / stiffest);
    for (uint32_t i = 0; i < r.node_count; i++) {
        expect_near(0.0, vec3_norm(r.forces[i]), rounding);
    }
    shell_rig_end(&r);
}

static void rigid_motion_has_no_stress(void **state)
{
    (void)state;
    harness_property("shells rest", 60, rest_is_quiet, NULL);
}

/* ---- the mirror image, with the corners of each triangle the other way round */

static vec3 mirrored(vec3 v)
{
    return vec3_make(v.x, v.y, -v.z);
}

static void mirror_image_agrees(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    vbss_shell_input in;
    shell_sheet_draw(source, &r, &in);
    shell_rig_start(&r, &in);
    shell_sheet_deform(source, &r, 0.2);
    double energy = shell_rig_energy(&r);
    vec3 forces[32];
    assert_true(r.node_count <= 32);
    memcpy(forces, r.forces, r.node_count * sizeof *forces);
    for (uint32_t i = 0; i < r.node_count; i++) {
        r.rest[i] = mirrored(r.rest[i]);
        r.x[i] = mirrored(r.x[i]);
    }
    for (uint32_t i = 0; i < r.triangle_count; i++) {
        uint32_t corner = r.triangles[i][1], far = r.opposite[i][1];
        r.triangles[i][1] = r.triangles[i][2];
        r.triangles[i][2] = corner;
        r.opposite[i][1] = r.opposite[i][2];
        r.opposite[i][2] = far;
    }
    expect_ok(vbss_shell_init(NULL, &in, r.groups, &r.shell));
    expect_near(energy, shell_rig_energy(&r), 1e-12 * energy);
    for (uint32_t i = 0; i < r.node_count; i++) {
        double apart = vec3_distance(forces[i], mirrored(r.forces[i]));
        expect_near(0.0, apart, 1e-13 * (1.0 + vec3_norm(forces[i])));
    }
    shell_rig_end(&r);
}

static void mirrored_shell_has_mirrored_forces(void **state)
{
    (void)state;
    harness_property("shells in the mirror", 40, mirror_image_agrees, NULL);
}

/* ---- a flat sheet stretched along x: plane stress (Saint Venant and Kirchhoff) */

static vec3 flat(double u, double v, const void *user)
{
    const double *size = user;
    return vec3_make(size[0] * u, size[1] * v, 0.0);
}

static void stretched_sheet_contracts_as_plane_stress(void **state)
{
    (void)state;
    const double size[2] = {3.0, 2.0}, stretch = 1.2, nu = 0.47;
    shell_rig r;
    shell_rig_mesh(&r, 4, 3, false, false, flat, size);
    vbss_shell_input in = shell_rig_input(&r);
    in.poisson = nu;
    shell_rig_start(&r, &in);
    double e = 0.5 * (stretch * stretch - 1.0), width = sqrt(1.0 - 2.0 * nu * e);
    for (uint32_t i = 0; i < r.node_count; i++) {
        r.x[i] = vec3_make(stretch * r.rest[i].x, width * r.rest[i].y, 0.0);
    }
    /* E e^2 / 2 of the volume; along the length a force E e stretch of the cross-section at rest */
    double volume = size[0] * size[1] * in.thickness;
    expect_near(0.5 * e * e * volume, shell_rig_energy(&r), 1e-15);
    double pull = 0.0;
    for (uint32_t i = 0; i < r.node_count; i++) {
        bool edge = r.rest[i].x < 1e-9 || r.rest[i].x > size[0] - 1e-9;
        pull += r.rest[i].x < 1e-9 ? r.forces[i].x : 0.0;
        expect_near(0.0, edge ? 0.0 : r.forces[i].x, 1e-15);
        expect_near(0.0, r.forces[i].y, 1e-15); /* sides are free of stress */
    }
    expect_near(e * stretch * size[1] * in.thickness, pull, 1e-14);
    for (uint32_t i = 0; i < r.triangle_count; i++) {
        const vbss_shell_response *s = &r.states[i];
        /* whichever way the triangle's own axes turn, trace and determinant stay */
        double across = 0.5 * (width * width - 1.0);
        double determinant = s->strain[0] * s->strain[1] - 0.25 * s->strain[2] * s->strain[2];
        expect_near(e + across, s->strain[0] + s->strain[1], 1e-14);
        expect_near(e * across, determinant, 1e-14);
        expect_near(in.thickness * e, s->membrane_force[0] + s->membrane_force[1], 1e-14);
    }
    shell_rig_end(&r);
}

int test_shell_forces(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(force_is_negative_energy_gradient),
        harness_test(net_force_and_moment_are_zero),
        harness_test(rigid_motion_has_no_stress),
        harness_test(mirrored_shell_has_mirrored_forces),
        cmocka_unit_test(stretched_sheet_contracts_as_plane_stress),
    };
    return cmocka_run_group_tests_name("drain.shell_forces", tests, NULL, NULL);
}
