/* What a shell refuses, what it tells of triangles that are turned over, and what it weighs. */
#include "base/elementary.h"
#include "drain/shell_rig.h"

#include "harness/harness.h"

static vec3 unit_square(double u, double v, const void *user)
{
    (void)user;
    return vec3_make(u, v, 0.0);
}

/* Four cells: every triangle has free sides, and one in the middle two neighbours. */
static void begin(shell_rig *r, vbss_shell_input *in)
{
    shell_rig_mesh(r, 2, 2, false, false, unit_square, NULL);
    *in = shell_rig_input(r);
    shell_rig_start(r, in);
}

static void expect_refused(shell_rig *r, const vbss_shell_input *in, vbss_result result)
{
    vbss_shell shell;
    expect_result(result, vbss_shell_init(NULL, in, r->groups, &shell));
}

static void bad_numbers_are_rejected(void **state)
{
    (void)state;
    shell_rig r;
    vbss_shell_input in;
    begin(&r, &in);
    double *const fields[] = {&in.young,   &in.poisson,  &in.thickness,
                              &in.density, &r.rest[4].y, &r.widths[3]};
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        double good = *fields[i];
        for (int k = 0; k < 3; k++) {
            *fields[i] = harness_bad_numbers[k];
            expect_refused(&r, &in, VBSS_ERROR_NOT_FINITE);
        }
        *fields[i] = -1.0;
        expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
        *fields[i] = good;
    }
    in.poisson = 0.6;
    expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
    in.poisson = 0.0;
    r.widths[3] = 1.7;
    expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
    shell_rig_end(&r);
}

static void bad_meshes_are_rejected(void **state)
{
    (void)state;
    shell_rig r;
    vbss_shell_input in;
    begin(&r, &in);
    uint32_t *const nodes[] = {&r.triangles[2][1], &r.opposite[2][1]};
    for (int i = 0; i < 2; i++) {
        uint32_t good = *nodes[i];
        *nodes[i] = r.node_count;
        expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
        *nodes[i] = r.triangles[2][0]; /* twice in a patch */
        expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
        *nodes[i] = good;
    }
    assert_int_not_equal(SHELL_NONE, r.opposite[1][0]);
    assert_int_not_equal(SHELL_NONE, r.opposite[1][2]);
    uint32_t far = r.opposite[1][0];
    r.opposite[1][0] = r.opposite[1][2]; /* two neighbours end in one node */
    expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
    r.opposite[1][0] = far;
    vec3 good = r.rest[4];
    r.rest[4] = r.rest[3]; /* triangles without area */
    expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
    r.rest[4] = vec3_make(1.7, 1.7, 0.0); /* beyond the far corner: folded over */
    expect_refused(&r, &in, VBSS_ERROR_OUT_OF_RANGE);
    r.rest[4] = good;
    expect_refused(&r, &in, VBSS_OK);
    shell_rig_end(&r);
}

static uint32_t count_inverted(shell_rig *r)
{
    uint32_t count = 0;
    shell_rig_energy(r);
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        assert_int_equal(vbss_shell_is_inverted(&r->shell, i, r->x), r->states[i].is_inverted);
        count += r->states[i].is_inverted;
    }
    return count;
}

static void inverted_elements_are_counted(void **state)
{
    (void)state;
    shell_rig r;
    vbss_shell_input in;
    begin(&r, &in);
    assert_int_equal(0, count_inverted(&r));
    for (uint32_t i = 0; i < r.node_count; i++) { /* turning it all is no inversion */
        r.x[i] = vec3_make(r.rest[i].x, -r.rest[i].y, -r.rest[i].z);
    }
    assert_int_equal(0, count_inverted(&r));
    for (uint32_t i = 0; i < r.node_count; i++) {
        r.x[i] = r.rest[i];
    }
    r.x[8] = vec3_make(0.4, 0.4, 0.0); /* the far corner pushed back past the middle */
    assert_true(count_inverted(&r) >= 1);
    r.x[8] = r.x[4]; /* onto it */
    assert_true(count_inverted(&r) >= 1);
    assert_true(vec3_is_finite(r.forces[8]));
    for (uint32_t i = 0; i < r.node_count; i++) { /* a hundredth of the area and less is none */
        r.x[i] = vec3_scale(r.rest[i], 0.101);
    }
    assert_int_equal(0, count_inverted(&r));
    for (uint32_t i = 0; i < r.node_count; i++) {
        r.x[i] = vec3_scale(r.rest[i], 0.099);
    }
    assert_int_equal(r.triangle_count, count_inverted(&r));
    shell_rig_end(&r);
}

static void crease_is_no_inversion(void **state)
{
    (void)state;
    shell_rig r;
    shell_rig_mesh(&r, 4, 2, false, false, unit_square, NULL);
    vbss_shell_input in = shell_rig_input(&r);
    shell_rig_start(&r, &in);
    for (uint32_t i = 0; i < r.node_count; i++) { /* folded by 100 degrees along x = 1/2 */
        double beyond = r.rest[i].x - 0.5;
        if (beyond > 0.0) {
            double c = vbss_cos(1.75), s = vbss_sin(1.75);
            r.x[i] = vec3_make(0.5 + c * beyond, r.rest[i].y, s * beyond);
        }
    }
    assert_int_equal(0, count_inverted(&r));
    shell_rig_end(&r);
}

static void mass_is_wall_mass(void **state)
{
    (void)state;
    shell_rig r;
    vbss_shell_input in;
    begin(&r, &in);
    double masses[9] = {0.0}, sum = 0.0;
    vbss_shell_add_masses(&r.shell, masses);
    for (int i = 0; i < 9; i++) {
        sum += masses[i];
    }
    expect_near(in.density * in.thickness, sum, 1e-16);
    expect_near(in.density * in.thickness / 4.0, masses[4], 1e-16); /* six triangles of an eighth */
    shell_rig_end(&r);
}

int test_shell_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_numbers_are_rejected),
        cmocka_unit_test(bad_meshes_are_rejected),
        cmocka_unit_test(inverted_elements_are_counted),
        cmocka_unit_test(crease_is_no_inversion),
        cmocka_unit_test(mass_is_wall_mass),
    };
    return cmocka_run_group_tests_name("drain.shell_refusals", tests, NULL, NULL);
}
