/* The slit and what lies near it: the lens, its tips, the marks, the strip below. */
#include "drain/mesh_rig.h"

/* ---- the lens */

/* 1 on the ellipse, from arc and x at rest. */
static double ellipse(const drain_mesh *m, uint32_t node)
{
    double b = 0.5 * m->options.opening, a = m->rest[m->slit_nodes[0][m->slit_count - 1]].x;
    double arc = m->angle[node] * m->options.radius / b, x = m->rest[node].x / a;
    return arc * arc + x * x;
}

static void any_edge_is_an_ellipse(harness_source *source, void *user)
{
    (void)user;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_draw(source, true);
    o.opening = fmax(o.opening, 1e-3 * o.radius);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    for (uint32_t k = 0; k < m->slit_count; k++) {
        uint32_t left = m->slit_nodes[DRAIN_LEFT][k], right = m->slit_nodes[DRAIN_RIGHT][k];
        bool tip = k == 0 || k == m->slit_count - 1;
        assert_int_equal(tip, left == right);
        expect_near(1.0, ellipse(m, left), 1e-12);
        expect_near(1.0, ellipse(m, right), 1e-12);
        assert_true(tip || (m->angle[left] < 0.0 && m->angle[right] > 0.0));
        assert_true(k == 0 || m->rest[m->slit_nodes[0][k]].x > m->rest[m->slit_nodes[0][k - 1]].x);
        expect_same_bits(0.0, m->material_coordinates[left][0]);
        expect_same_bits(0.0, m->material_coordinates[right][0]);
    }
    mesh_rig_end(&rig);
}

static void slit_edges_are_ellipses(void **state)
{
    (void)state;
    harness_property("ellipse", 200, any_edge_is_an_ellipse, NULL);
}

static void slit_length_and_width(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_N);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    assert_int_equal(7, m->slit_count);
    assert_int_equal(m->slit_nodes[DRAIN_LEFT][3], m->slit_middle[DRAIN_LEFT]);
    assert_int_equal(m->slit_nodes[DRAIN_RIGHT][3], m->slit_middle[DRAIN_RIGHT]);
    expect_same_bits(-5e-3, m->rest[m->slit_nodes[DRAIN_LEFT][0]].x);
    expect_same_bits(5e-3, m->rest[m->slit_nodes[DRAIN_LEFT][6]].x);
    /* 3 mm along the surface is 2 R sin(1.5/R) straight across. */
    vec3 left = m->rest[m->slit_middle[DRAIN_LEFT]], right = m->rest[m->slit_middle[DRAIN_RIGHT]];
    expect_near(13e-3 * sin(1.5 / 6.5), vec3_distance(left, right), 1e-16);
    assert_true(right.z > 0.0 && right.x == 0.0);
    /* The tips are on top. */
    expect_same_bits(6.5e-3, m->rest[m->slit_nodes[DRAIN_LEFT][0]].y);
    expect_same_bits(0.0, m->rest[m->slit_nodes[DRAIN_LEFT][0]].z);
    mesh_rig_end(&rig);
}

/* Without opening, both nodes of a pair are at one place, and no node has moved. */
static void zero_width_cut_moves_no_node(void **state)
{
    (void)state;
    for (int kind = 0; kind < DRAIN_MESH_KINDS; kind++) {
        mesh_rig rig;
        drain_mesh_options o = mesh_rig_options((drain_mesh_kind)kind);
        o.slit_length = kind == DRAIN_MESH_UNIFORM ? 32e-3 / 3.0 : o.slit_length;
        o.mark_arc = kind == DRAIN_MESH_UNIFORM ? VBSS_PI / 6.0 * o.radius : o.mark_arc;
        o.opening = 0.0;
        mesh_rig_begin(&rig, &o);
        const drain_mesh *m = &rig.mesh;
        for (uint32_t k = 1; k + 1 < m->slit_count; k++) {
            vec3 left = m->rest[m->slit_nodes[0][k]], right = m->rest[m->slit_nodes[1][k]];
            assert_true(m->slit_nodes[0][k] != m->slit_nodes[1][k]);
            expect_same_bits(0.0, left.z);
            assert_memory_equal(&left, &right, sizeof left);
        }
        for (uint32_t i = 0; i < m->node_count; i++) {
            expect_near(m->material_coordinates[i][0], m->angle[i] * o.radius, 1e-17);
        }
        mesh_rig_end(&rig);
    }
}

/* Laplace's equation in arc and x, once the factor that ends the shift at the strip is taken away: the
 * five-point sum vanishes beside what a curvature of b/a^2 would give. */
static void opening_decays_harmonically(void **state)
{
    (void)state;
    drain_mesh m;
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_N);
    expect_ok(vbss_drain_mesh_plan(NULL, &o, &m));
    const double end = DRAIN_STRIP_ANGLE * o.radius, h = 2e-5;
    const double curved = 0.5 * o.opening * (h / 5e-3) * (h / 5e-3);
    const double step[5][2] = {{0.0, 0.0}, {h, 0.0}, {-h, 0.0}, {0.0, h}, {0.0, -h}};
    for (int i = 1; i <= 10; i++) {
        for (int j = 1; j <= 8; j++) {
            double x = 1.5e-3 * i, arc = 2e-3 * j, v[5];
            for (int k = 0; k < 5; k++) {
                double at = arc + step[k][1], share = at / end;
                v[k] = vbss_drain_slit_shift(&m, x + step[k][0], at) / (1.0 - share * share);
            }
            assert_true(v[0] > 0.0 && v[0] < 0.5 * o.opening);
            expect_near(0.0, v[1] + v[2] + v[3] + v[4] - 4.0 * v[0], 1e-4 * curved);
        }
    }
    expect_same_bits(0.0, vbss_drain_slit_shift(&m, 5e-3, 0.0));
    expect_same_bits(0.0, vbss_drain_slit_shift(&m, 7e-3, 0.0));
    expect_same_bits(0.0, vbss_drain_slit_shift(&m, 0.0, end));
}

/* ---- marks and strip */

static void any_mark_is_where_it_should_be(harness_source *source, void *user)
{
    (void)user;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_draw(source, true);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    uint32_t left = m->marks[DRAIN_LEFT], right = m->marks[DRAIN_RIGHT];
    assert_true(right < m->node_count);
    expect_same_bits(m->material_coordinates[right][0], 0.0 - m->material_coordinates[left][0]);
    expect_near(0.0, m->rest[right].x, 1e-17 * o.length);
    /* The paper's has a line every 30 degrees. */
    double off = o.kind == DRAIN_MESH_6X12 ? 15.0001 * RIG_DEGREE * o.radius : 2e-6 * o.radius;
    expect_near(o.mark_arc, m->material_coordinates[right][0], off);
    /* The opening moved it outward, less than the edge. */
    double moved = m->angle[right] * o.radius - m->material_coordinates[right][0];
    assert_true(moved >= -1e-15 * o.radius && moved <= 0.5 * o.opening);
    mesh_rig_end(&rig);
}

static void target_positions(void **state)
{
    (void)state;
    harness_property("marks", 300, any_mark_is_where_it_should_be, NULL);
}

/* 4.5 mm before the opening; 9.2 mm from each other at rest, as the study of the shell had them. */
static void default_targets(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_N);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    uint32_t left = m->marks[DRAIN_LEFT], right = m->marks[DRAIN_RIGHT];
    expect_near(4.5e-3, m->material_coordinates[right][0], 1e-17);
    expect_near(-4.5e-3, m->material_coordinates[left][0], 1e-17);
    double chord = vec3_distance(m->rest[left], m->rest[right]);
    expect_near(9.2e-3, chord, 0.05e-3);
    mesh_rig_end(&rig);
}

/* Nodes within 25 degrees of the bottom, three columns, where the tube is as it was; the paper's has none. */
static void anchor_strip_is_below(void **state)
{
    (void)state;
    for (int kind = 0; kind < DRAIN_MESH_KINDS; kind++) {
        mesh_rig rig;
        drain_mesh_options o = kind == DRAIN_MESH_UNIFORM ? mesh_rig_tube(4, 72)
                                                          : mesh_rig_options((drain_mesh_kind)kind);
        mesh_rig_begin(&rig, &o);
        const drain_mesh *m = &rig.mesh;
        uint32_t columns = kind == DRAIN_MESH_UNIFORM ? 11 : kind == DRAIN_MESH_6X12 ? 0 : 3;
        assert_int_equal(columns * (m->grid.axial_cells + 1), m->anchor_count);
        uint32_t next = 0;
        for (uint32_t i = 0; i < m->node_count; i++) {
            bool low = kind != DRAIN_MESH_6X12 &&
                       fabs(m->material_coordinates[i][0]) >= 154.999 * RIG_DEGREE * o.radius;
            assert_true(low == (next < m->anchor_count && m->anchors[next] == i));
            next += low;
            if (low) {
                expect_near(m->material_coordinates[i][0], m->angle[i] * o.radius, 1e-17);
            }
        }
        assert_int_equal(m->anchor_count, next);
        mesh_rig_end(&rig);
    }
}

static void plain_tube_has_no_slit_or_targets(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_tube(3, 8);
    o.opening = o.mark_arc = (double)NAN; /* nobody reads them */
    mesh_rig_begin(&rig, &o);
    assert_int_equal(4 * 8, rig.mesh.node_count);
    assert_int_equal(0, rig.mesh.slit_count);
    for (int side = 0; side < 2; side++) {
        assert_int_equal(DRAIN_NONE, rig.mesh.marks[side]);
        assert_int_equal(DRAIN_NONE, rig.mesh.slit_middle[side]);
    }
    mesh_rig_end(&rig);
}

int test_mesh_slit(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(slit_edges_are_ellipses),
        cmocka_unit_test(slit_length_and_width),
        cmocka_unit_test(zero_width_cut_moves_no_node),
        cmocka_unit_test(opening_decays_harmonically),
        harness_test(target_positions),
        cmocka_unit_test(default_targets),
        cmocka_unit_test(anchor_strip_is_below),
        cmocka_unit_test(plain_tube_has_no_slit_or_targets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
