/* The pinched cylinder with end diaphragms (reference: Lindberg, Olson, Cowper 1969): R = 300, L = 600, t = 3,
 * E = 3e6, nu = 0.3, unit forces; they move by 1.8248e-5. */
#include "base/elementary.h"
#include "drain/shell_rig.h"

#include "harness/harness.h"

/* An eighth: from the force's meridian a quarter around, from the middle to the diaphragm. */
static vec3 eighth_at(double u, double v, const void *user)
{
    (void)user;
    double angle = 0x1.921fb54442d18p0 * u;
    return vec3_make(300.0 * vbss_cos(angle), 300.0 * vbss_sin(angle), 300.0 * v);
}

static double pinched_ratio(uint32_t cells, bool flipped)
{
    shell_rig r;
    shell_rig_mesh(&r, cells, cells, false, flipped, eighth_at, NULL);
    for (int axis = 0; axis < 3; axis++) {
        shell_rig_mirror(&r, axis, 0.0);
    }
    vbss_shell_input in = shell_rig_input(&r);
    in.young = 3e6;
    in.poisson = 0.3;
    in.thickness = 3.0;
    shell_rig_start(&r, &in);
    for (uint32_t i = 0; i < r.own_count; i++) {
        if (r.rest[i].z > 299.9) {
            r.held[i][0] = r.held[i][1] = true;
        }
    }
    r.load[0].x = -0.25;
    assert_int_equal(1, shell_rig_solve(&r, 1));
    double moved = r.rest[0].x - r.x[0].x;
    shell_rig_end(&r);
    return moved / 1.8248e-5;
}

static void pinched_cylinder_converges(void **state)
{
    (void)state;
    for (int flipped = 0; flipped < 2; flipped++) {
        double coarse = pinched_ratio(24, flipped), middle = pinched_ratio(32, flipped);
        double fine = pinched_ratio(48, flipped);
        expect_near(1.0, coarse, 0.15);
        assert_true(coarse > middle && middle > fine && fine > 1.0);
        expect_near(1.0, fine, 0.05);
    }
}

int test_shell_cylinder(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pinched_cylinder_converges),
    };
    return cmocka_run_group_tests_name("drain.shell_cylinder", tests, NULL, NULL);
}
