/* How hard it is to close the slit: the coarse meshes against fine ones, which agree within 1 %.
 *
 * The marks are pulled towards each other by a pair of forces. The stiffness at the marks and of the gap is that at
 * rest, from the approach under 0.01 mN; the pull at a gap of 0.5 mm is far in the nonlinear range. */
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"

typedef struct closing {
    double marks, gap; /* N/m */
    double pull;       /* N */
} closing;

static double marks_apart(drain_rig *r)
{
    const uint32_t *marks = r->places.marks;
    return vec3_distance(drain_rig_position(r, marks[0]), drain_rig_position(r, marks[1]));
}

static double gap_under(drain_rig *r, double force)
{
    drain_rig_move(r, 1, vec3_make(0.0, 0.0, force));
    drain_rig_move(r, 2, vec3_make(0.0, 0.0, -force));
    drain_rig_relax(r, 1e-9, 1000);
    return drain_rig_gap(r).signed_gap;
}

static closing close_slit(vbss_drain_mesh mesh, uint32_t divisions, double thickness)
{
    const double little = 1e-5, wanted = 0.5e-3, scale = pow(thickness / 1e-3, 2.7);
    drain_rig r;
    closing c;
    drain_rig_begin(&r);
    drain_rig_statics(&r);
    r.config.mesh = mesh;
    r.config.mesh_divisions = divisions;
    r.config.thickness = thickness;
    drain_rig_make(&r);
    double apart = marks_apart(&r), gap = drain_rig_gap(&r).signed_gap;
    drain_rig_pull_marks(&r, little);
    drain_rig_relax(&r, 1e-12, 500);
    c.marks = little / (apart - marks_apart(&r));
    c.gap = little / (gap - drain_rig_gap(&r).signed_gap);
    /* Where the gap is the wanted one, by secants from two pulls short of it. */
    gap_under(&r, 0.15 * scale);
    double f0 = 0.2 * scale, g0 = gap_under(&r, f0), f1 = 0.22 * scale, g1 = gap_under(&r, f1);
    for (int k = 0; k < 12 && fabs(g1 - wanted) > 1e-8; k++) {
        double next = f1 - (g1 - wanted) * (f1 - f0) / (g1 - g0);
        f0 = f1;
        g0 = g1;
        f1 = next;
        g1 = gap_under(&r, f1);
    }
    expect_near(wanted, g1, 1e-8);
    c.pull = f1;
    drain_rig_end(&r);
    return c;
}

/* The mesh of 225 nodes in cells of a third, 1877 nodes: worked out once. */
static closing fine;

static int find_reference(void **state)
{
    (void)state;
    fine = close_slit(VBSS_DRAIN_MESH_225, 3, 1e-3);
    return 0;
}

static void expect_within(const closing *wanted, const closing *got, double marks, double gap,
                          double pull)
{
    expect_near(1.0, got->marks / wanted->marks, marks);
    expect_near(1.0, got->gap / wanted->gap, gap);
    expect_near(1.0, got->pull / wanted->pull, pull);
}

/* Another fine mesh says the same; and a feasibility study's of 1061 to 1863 nodes: 79 N/m, 132 N/m, 0.241 N. */
static void fine_meshes_converge(void **state)
{
    (void)state;
    closing other = close_slit(VBSS_DRAIN_MESH_181, 3, 1e-3);
    expect_within(&fine, &other, 0.01, 0.01, 0.01);
    const closing study = {79.0, 132.0, 0.241};
    expect_within(&study, &fine, 0.01, 0.03, 0.03);
}

/* Seen of the default mesh: -1.1 % at the marks, +1.9 % of the gap, +1 % of the pull. */
static void default_mesh_closes_like_fine_mesh(void **state)
{
    (void)state;
    closing own = close_slit(VBSS_DRAIN_MESH_137, 1, 1e-3);
    expect_within(&fine, &own, 0.05, 0.05, 0.05);
}

/* Their bending stiffness is right where the default's is, but in large bending they fold sooner. */
static void initial_closing_converges_with_mesh(void **state)
{
    (void)state;
    const vbss_drain_mesh meshes[] = {VBSS_DRAIN_MESH_159, VBSS_DRAIN_MESH_181,
                                      VBSS_DRAIN_MESH_225};
    const double marks[] = {0.06, 0.05, 0.05};
    for (int k = 0; k < 3; k++) {
        closing own = close_slit(meshes[k], 1, 1e-3);
        expect_within(&fine, &own, marks[k], 0.05, 0.09);
    }
}

static double stiffness_of(double thickness, double modulus)
{
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_statics(&r);
    r.config.thickness = thickness;
    r.config.young_modulus = modulus;
    drain_rig_make(&r);
    double apart = marks_apart(&r);
    drain_rig_pull_marks(&r, 1e-5);
    drain_rig_relax(&r, 1e-12, 500);
    double stiffness = 1e-5 / (apart - marks_apart(&r));
    drain_rig_end(&r);
    return stiffness;
}

/* Between t of membrane alone and t^3 of bending alone: the study has 0.0790 and 0.0099 N/mm for 1 and 0.4 mm. */
static void stiffness_scales_with_wall_and_modulus(void **state)
{
    (void)state;
    double thick = stiffness_of(1e-3, 1.2e6), thin = stiffness_of(0.4e-3, 1.2e6);
    expect_near(0.0790 / 0.0099, thick / thin, 0.25);
    expect_near(2.0 * thick, stiffness_of(1e-3, 2.4e6), 1e-3 * thick);
}

int test_drain_stiffness(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fine_meshes_converge),
        cmocka_unit_test(default_mesh_closes_like_fine_mesh),
        cmocka_unit_test(initial_closing_converges_with_mesh),
        cmocka_unit_test(stiffness_scales_with_wall_and_modulus),
    };
    return cmocka_run_group_tests(tests, find_reference, NULL);
}
