/* The named meshes: how many nodes and triangles they have, and where their lines are. */
#include "drain/mesh_rig.h"

static void expect_counts(drain_mesh_kind kind, uint32_t nodes, uint32_t triangles, uint32_t fixed)
{
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_options(kind);
    mesh_rig_begin(&rig, &o);
    assert_int_equal(nodes, rig.mesh.node_count);
    assert_int_equal(triangles, rig.mesh.triangle_count);
    assert_int_equal(fixed, rig.mesh.anchor_count);
    mesh_rig_end(&rig);
}

static void named_mesh_counts(void **state)
{
    (void)state;
    drain_mesh_options o;
    vbss_drain_mesh_defaults(&o);
    assert_int_equal(DRAIN_MESH_N, o.kind);
    expect_counts(DRAIN_MESH_N, 137, 240, 33);
    expect_counts(DRAIN_MESH_D, 159, 280, 33);
    expect_counts(DRAIN_MESH_S, 181, 320, 33);
    expect_counts(DRAIN_MESH_R, 225, 400, 33);
    expect_counts(DRAIN_MESH_6X12, 7 * 12 + 1, 2 * 6 * 12, 0);
}

/* The lists as they were published, to rounding of the mark: 39.67 degrees for 4.5 mm. */
static void expect_lines(drain_mesh_kind kind, const double *degrees, uint32_t columns,
                         const double *mm, uint32_t rows)
{
    drain_mesh m;
    drain_mesh_options o = mesh_rig_options(kind);
    expect_ok(vbss_drain_mesh_plan(NULL, &o, &m));
    assert_int_equal(2 * columns - 2, m.grid.round_cells);
    assert_int_equal(2 * rows - 2, m.grid.axial_cells);
    for (uint32_t j = 0; j < columns; j++) {
        expect_near(degrees[j], vbss_drain_column_angle(&m, j) / RIG_DEGREE, 0.004);
    }
    for (uint32_t i = 0; i < rows; i++) {
        expect_near(1e-3 * mm[i], vbss_drain_row_x(&m, rows - 1 + i), 1e-17);
        expect_same_bits(-vbss_drain_row_x(&m, rows - 1 + i) + 0.0,
                         vbss_drain_row_x(&m, rows - 1 - i));
    }
}

static void line_lists_match_mesh(void **state)
{
    (void)state;
    const double n[] = {0, 23, 39.67, 70, 110, 155, 180};
    const double d[] = {0, 20, 39.67, 60, 90, 122, 155, 180};
    const double s[] = {0, 13, 26, 39.67, 58, 80, 115, 155, 180};
    const double r[] = {0, 13, 26, 39.67, 52, 66, 82, 100, 127, 155, 180};
    const double n_rows[] = {0, 1.7, 3.4, 5, 8, 16}, d_rows[] = {0, 1.7, 3.4, 5, 9, 16};
    expect_lines(DRAIN_MESH_N, n, 7, n_rows, 6);
    expect_lines(DRAIN_MESH_D, d, 8, d_rows, 6);
    expect_lines(DRAIN_MESH_S, s, 9, n_rows, 6);
    expect_lines(DRAIN_MESH_R, r, 11, d_rows, 6);
}

/* Whatever the drain's measures, some lines are where something is. */
static void any_drain_has_lines_where_they_matter(harness_source *source, void *user)
{
    (void)user;
    drain_mesh m;
    drain_mesh_options o = mesh_rig_draw(source, true);
    o.kind = o.kind < DRAIN_MESH_UNIFORM ? o.kind : DRAIN_MESH_N;
    if (vbss_drain_mesh_plan(NULL, &o, &m) != VBSS_OK) {
        return; /* what was drawn for equal cells may be too much for graded ones */
    }
    uint32_t middle = m.grid.axial_cells / 2, bottom = m.grid.round_cells / 2;
    expect_same_bits(0.0, vbss_drain_row_x(&m, middle) + 0.0);
    expect_same_bits(0.5 * o.slit_length, vbss_drain_row_x(&m, middle + m.grid.tip_rows));
    expect_same_bits(0.5 * o.length, vbss_drain_row_x(&m, m.grid.axial_cells));
    expect_same_bits(o.mark_arc / o.radius, vbss_drain_column_angle(&m, m.grid.mark_column));
    expect_same_bits(VBSS_PI, vbss_drain_column_angle(&m, bottom));
    bool strip = false;
    for (uint32_t j = 0; j < bottom; j++) {
        strip = strip || vbss_drain_column_angle(&m, j) == DRAIN_STRIP_ANGLE;
        assert_true(vbss_drain_column_angle(&m, j) < vbss_drain_column_angle(&m, j + 1));
    }
    assert_true(strip);
    for (uint32_t i = 0; i < m.grid.axial_cells; i++) {
        assert_true(vbss_drain_row_x(&m, i) < vbss_drain_row_x(&m, i + 1));
    }
}

static void lines_stay_on_features(void **state)
{
    (void)state;
    harness_property("lines", 2000, any_drain_has_lines_where_they_matter, NULL);
}

/* Divided, a mesh keeps its lines and gets others between them. */
static void subdivision_refines(void **state)
{
    (void)state;
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_R);
    drain_mesh coarse, fine;
    expect_ok(vbss_drain_mesh_plan(NULL, &o, &coarse));
    o.divisions = 3;
    expect_ok(vbss_drain_mesh_plan(NULL, &o, &fine));
    assert_int_equal(9 * coarse.triangle_count, fine.triangle_count);
    for (uint32_t i = 0; i <= coarse.grid.axial_cells; i++) {
        expect_same_bits(vbss_drain_row_x(&coarse, i), vbss_drain_row_x(&fine, 3 * i));
    }
    for (uint32_t j = 0; j <= coarse.grid.round_cells / 2; j++) {
        expect_same_bits(vbss_drain_column_angle(&coarse, j),
                         vbss_drain_column_angle(&fine, 3 * j));
    }
}

/* Springs of the paper: along the drain, round it, and one diagonal a cell. */
static void published_grid_edge_count(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_6X12);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    uint32_t along = 0, around = 0, diagonal = 0;
    for (uint32_t s = 0; s < m->edge_count; s++) {
        const double *p = m->material_coordinates[m->edges[s].nodes[0]];
        const double *q = m->material_coordinates[m->edges[s].nodes[1]];
        bool same_x = p[1] == q[1], same_arc = fabs(fabs(p[0]) - fabs(q[0])) < 1e-12;
        along += same_arc && !same_x;
        around += same_x && !same_arc;
        diagonal += !same_x && !same_arc;
    }
    assert_int_equal(6 * 12 + 2, along); /* two run along the slit twice */
    assert_int_equal(7 * 12, around);
    assert_int_equal(6 * 12, diagonal);
    /* Two cells, 10.7 mm, are nearest to the slit, 30 degrees to the marks. */
    assert_int_equal(3, m->slit_count);
    expect_near(32e-3 / 6.0, m->rest[m->slit_nodes[DRAIN_LEFT][2]].x, 1e-17);
    expect_near(30.0 * RIG_DEGREE * 6.5e-3, m->material_coordinates[m->marks[DRAIN_RIGHT]][0],
                1e-17);
    mesh_rig_end(&rig);
}

int test_mesh_counts(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(named_mesh_counts),         cmocka_unit_test(line_lists_match_mesh),
        harness_test(lines_stay_on_features),        cmocka_unit_test(subdivision_refines),
        cmocka_unit_test(published_grid_edge_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
