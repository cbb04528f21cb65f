/* Areas, widths, and that the left half mirrors the right to the bit. */
#include "base/elementary.h"
#include "drain/mesh_rig.h"

#include <string.h>

/* ---- areas */

/* Relative, against the tube less the ellipse. */
static double area_error(drain_mesh_kind kind, double opening, uint32_t divisions)
{
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_options(kind);
    o.opening = opening;
    o.divisions = divisions;
    double lens = 0.25 * VBSS_PI * o.slit_length * o.opening;
    double exact = 2.0 * VBSS_PI * o.radius * o.length - lens;
    mesh_rig_begin(&rig, &o);
    double error = (mesh_rig_area(&rig.mesh) - exact) / exact;
    mesh_rig_end(&rig);
    return error;
}

/* Chords of the tube have an error of second order. Those of the ellipse, which has 1.8 % of the area, add to
 * it with order 3/2 at the tips. */
static void areas_converge(void **state)
{
    (void)state;
    for (int kind = DRAIN_MESH_N; kind <= DRAIN_MESH_R; kind++) {
        double cut[3], lens[3];
        for (int k = 0; k < 3; k++) {
            cut[k] = area_error((drain_mesh_kind)kind, 0.0, 1u << k);
            lens[k] = area_error((drain_mesh_kind)kind, 3e-3, 1u << k);
        }
        expect_near(2.0, log2(cut[0] / cut[1]), 0.02);
        expect_near(2.0, log2(cut[1] / cut[2]), 0.02);
        assert_true(fabs(lens[0]) < 0.02 && fabs(lens[1]) < 0.005 && fabs(lens[2]) < 0.001);
        print_message("mesh %d: area %+.3f %%, with cells divided by 2 and 4 %+.3f %%, %+.3f %%\n",
                      kind, 100.0 * lens[0], 100.0 * lens[1], 100.0 * lens[2]);
    }
}

/* A regular prism has an exact area. */
static void equal_cells_have_prism_area(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_tube(5, 12);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    double facet = 2.0 * o.radius * sin(VBSS_PI / 12.0) * o.length / 5.0;
    expect_near(60.0 * facet, mesh_rig_area(m), 1e-15 * 60.0);
    for (uint32_t i = 0; i < m->node_count; i++) {
        /* Inside, six of the triangles, of which each is half a facet; at the ends, three. */
        bool end = i < 12 || i >= 60;
        bool mirror_line = i % 6 == 0; /* there, diagonals meet or pass by */
        double facets = m->node_area[i] / facet;
        if (!mirror_line) {
            expect_near(end ? 0.5 : 1.0, facets, 1e-12);
        }
        assert_true(facets > 0.33 && facets < 1.34);
    }
    mesh_rig_end(&rig);
}

static void any_lumped_areas_sum_to_all(harness_source *source, void *user)
{
    (void)user;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_draw(source, false);
    mesh_rig_begin(&rig, &o);
    double lumped = 0.0, all = mesh_rig_area(&rig.mesh);
    for (uint32_t i = 0; i < rig.mesh.node_count; i++) {
        assert_true(rig.mesh.node_area[i] > 0.0);
        lumped += rig.mesh.node_area[i];
    }
    expect_near(all, lumped, 1e-12 * all);
    mesh_rig_end(&rig);
}

static void lumped_areas_sum_to_total(void **state)
{
    (void)state;
    harness_property("lumped areas", 100, any_lumped_areas_sum_to_all, NULL);
}

/* ---- widths */

static void widths_are_axial_angles(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options tube = mesh_rig_tube(4, 12);
    mesh_rig_begin(&rig, &tube);
    for (uint32_t t = 0; t < rig.mesh.triangle_count; t++) {
        expect_near(30.0 * RIG_DEGREE, rig.mesh.angular_width[t], 1e-15);
    }
    mesh_rig_end(&rig);

    /* Far from the slit, those of the list: 155 to 180 degrees, three nodes of which two are on a line. */
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_N);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    uint32_t low = 0;
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        double from = VBSS_PI, to = 0.0;
        for (int k = 0; k < 3; k++) {
            vec3 p = m->rest[m->triangles[t][k]];
            double angle = fabs(vbss_atan2(p.z, p.y));
            from = fmin(from, angle);
            to = fmax(to, angle);
        }
        expect_near(to - from, m->angular_width[t], 1e-14);
        if (from > 154.9 * RIG_DEGREE) {
            low++;
            expect_near(25.0 * RIG_DEGREE, m->angular_width[t], 1e-14);
        }
    }
    assert_int_equal(2 * 2 * 10, low);
    mesh_rig_end(&rig);
}

/* ---- mirror */

static void expect_mirrored_node(const drain_mesh *m, uint32_t i)
{
    uint32_t j = mesh_rig_mirrored(m, i);
    assert_int_equal(i, mesh_rig_mirrored(m, j));
    expect_same_bits(m->rest[i].x, m->rest[j].x);
    expect_same_bits(m->rest[i].y, m->rest[j].y);
    expect_same_bits(m->rest[i].z, 0.0 - m->rest[j].z);
    expect_same_bits(m->material_coordinates[i][1], m->material_coordinates[j][1]);
    if (i != j) {
        expect_same_bits(m->angle[i], 0.0 - m->angle[j]);
        expect_same_bits(m->material_coordinates[i][0], 0.0 - m->material_coordinates[j][0]);
        expect_same_bits(m->node_area[i], m->node_area[j]);
    }
}

static void expect_mirrored_triangle(const drain_mesh *m, uint32_t t)
{
    uint32_t u = t + m->triangle_count / 2;
    const int place[3] = {0, 2, 1};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(mesh_rig_mirrored(m, m->triangles[t][k]), m->triangles[u][place[k]]);
        uint32_t beyond = m->opposite_node[t][k];
        uint32_t mirrored = beyond == DRAIN_NONE ? beyond : mesh_rig_mirrored(m, beyond);
        assert_int_equal(mirrored, m->opposite_node[u][place[k]]);
    }
    expect_same_bits(m->angular_width[t], m->angular_width[u]);
}

static void any_left_half_mirrors_the_right(harness_source *source, void *user)
{
    (void)user;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_draw(source, true);
    mesh_rig_begin(&rig, &o);
    for (uint32_t i = 0; i < rig.mesh.node_count; i++) {
        expect_mirrored_node(&rig.mesh, i);
    }
    for (uint32_t t = 0; t < rig.mesh.triangle_count / 2; t++) {
        expect_mirrored_triangle(&rig.mesh, t);
    }
    assert_int_equal(rig.mesh.marks[0], mesh_rig_mirrored(&rig.mesh, rig.mesh.marks[1]));
    mesh_rig_end(&rig);
}

static void mesh_halves_are_mirror_images(void **state)
{
    (void)state;
    harness_property("mirror", 100, any_left_half_mirrors_the_right, NULL);
}

/* ---- shape */

static void any_mesh_is_well_shaped(harness_source *source, void *user)
{
    double *smallest = user;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_draw(source, true);
    mesh_rig_begin(&rig, &o);
    double angle = mesh_rig_min_angle(&rig.mesh);
    assert_true(angle > (o.kind == DRAIN_MESH_UNIFORM ? 1.5 : 2.5));
    *smallest = fmin(*smallest, angle);
    for (uint32_t t = 0; t < rig.mesh.triangle_count; t++) {
        vec3 p = rig.mesh.rest[rig.mesh.triangles[t][0]];
        p.x = 0.0;
        assert_true(vec3_dot(p, mesh_rig_normal(&rig.mesh, t)) > 0.0);
    }
    for (uint32_t i = 0; i < rig.mesh.node_count; i++) {
        vec3 p = rig.mesh.rest[i];
        expect_near(o.radius, sqrt(p.y * p.y + p.z * p.z), 1e-14 * o.radius);
    }
    mesh_rig_end(&rig);
}

static void no_degenerate_or_folded_triangle(void **state)
{
    (void)state;
    double smallest = 180.0;
    harness_property("shape", 1000, any_mesh_is_well_shaped, &smallest);
    print_message("least angle of any mesh: %.2f degrees\n", smallest);
    /* The usual drain has better ones. */
    const double usual[] = {13.0, 17.5, 10.5, 11.0};
    for (int kind = DRAIN_MESH_N; kind <= DRAIN_MESH_R; kind++) {
        mesh_rig rig;
        drain_mesh_options o = mesh_rig_options((drain_mesh_kind)kind);
        mesh_rig_begin(&rig, &o);
        assert_true(mesh_rig_min_angle(&rig.mesh) > usual[kind]);
        mesh_rig_end(&rig);
    }
}

int test_mesh_measures(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_converge),
        cmocka_unit_test(equal_cells_have_prism_area),
        harness_test(lumped_areas_sum_to_total),
        cmocka_unit_test(widths_are_axial_angles),
        harness_test(mesh_halves_are_mirror_images),
        harness_test(no_degenerate_or_folded_triangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
