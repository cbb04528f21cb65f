/* Method VBLAST: its mesh, what it does when it is pulled, and what it cannot do. */
#include "fixtures/baseline_of.h"
#include "drain/paper_drain_rig.h"

#include <math.h>

/* ---- the mesh */

/* 7 x 12 particles and one that doubles the middle of the slit; a segment for each cell along, round and across, and the
 * slit's two along are doubled. */
static void mesh_matches_publication(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    config.mesh = VBSS_DRAIN_MESH_225;
    config.mesh_divisions = 4;
    paper_begin(&r, &config);
    const drain_mesh *m = &r.object->mesh;
    uint32_t along = 0, round = 0, across = 0;
    assert_int_equal(7 * 12 + 1, m->node_count);
    assert_int_equal(2 * 6 * 12, m->triangle_count);
    for (uint32_t s = 0; s < m->edge_count; s++) {
        uint32_t a = m->edges[s].nodes[0], b = m->edges[s].nodes[1];
        bool same_row = m->material_coordinates[a][1] == m->material_coordinates[b][1];
        bool same_column = m->material_coordinates[a][0] == m->material_coordinates[b][0];
        along += same_column;
        round += same_row;
        across += !same_row && !same_column;
        assert_false(same_row && same_column);
    }
    assert_int_equal(6 * 12 + 2, along);
    assert_int_equal(7 * 12, round);
    assert_int_equal(6 * 12, across);
    paper_end(&r);
}

/* The slit is two cells long, 10.67 mm; the marks are on the lines at 30 degrees. */
static void slit_and_targets_snap_to_nearest_lines(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    paper_begin(&r, &config);
    vbss_drain_places p = paper_places(&r);
    vbss_view left;
    expect_ok(vbss_drain_get_view(r.drain, VBSS_DRAIN_VIEW_SLIT_LEFT, &left, sizeof left));
    assert_int_equal(3, left.count);
    const uint32_t *edge = left.data;
    expect_near(32e-3 / 3.0, paper_place(&r, edge[2]).x - paper_place(&r, edge[0]).x, 1e-17);
    assert_int_equal(PAPER_MIDDLE, p.gap_points[1]);
    assert_int_equal(PAPER_DOUBLE, p.gap_points[0]);
    assert_int_equal(PAPER_MIDDLE + 1, p.marks[1]);
    assert_int_equal(PAPER_MIDDLE + 11, p.marks[0]);
    vbss_view anchors;
    expect_ok(vbss_drain_get_view(r.drain, VBSS_DRAIN_VIEW_ANCHORS, &anchors, sizeof anchors));
    assert_int_equal(0, anchors.count);
    expect_ok(
        vbss_drain_get_view(r.drain, VBSS_DRAIN_VIEW_ANCHOR_FORCES, &anchors, sizeof anchors));
    assert_int_equal(0, anchors.count);
    paper_end(&r);
}

/* The wall's mass: a little less than of a round tube, as triangles are chords and the slit is open. */
static void particle_masses_sum_to_wall_mass(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    paper_begin(&r, &config);
    double sum = 0.0, area = 0.0, tube = 2.0 * VBSS_PI * 6.5e-3 * 32e-3;
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        double wanted = 950.0 * 1e-3 * r.object->mesh.node_area[i];
        expect_near(1.0, r.object->mass[i] / wanted, 1e-12);
        sum += r.object->mass[i];
        area += r.object->mesh.node_area[i];
    }
    expect_near(950.0 * 1e-3 * area, sum, 1e-16);
    expect_near(0.97, area / tube, 0.02);
    paper_end(&r);
}

/* ---- at rest under a load */

static void expect_others_at_rest(paper_rig *r, const uint32_t *pulled, uint32_t count)
{
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        bool moves = false;
        for (uint32_t k = 0; k < count; k++) {
            moves = moves || pulled[k] == i;
        }
        if (!moves) {
            expect_near_vec3(vec3_zero(), paper_moved(r, i), 1e-12);
        }
    }
}

static void pulled_particle_moves_force_over_stiffness_alone(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_damping = 0.5;
    baseline_of(&config.baseline)->drain_stiffness = 80.0;
    paper_begin(&r, &config);
    const uint32_t node = PAPER_MIDDLE + 2;
    vec3 force = vec3_make(0.02, -0.05, 0.11);
    uint32_t id = paper_attach(&r, VBSS_DRAIN_ATTACHMENT_FORCE, node, force, 0.0);
    paper_run(&r, 1e-3, 400);
    expect_near_vec3(vec3_scale(force, 1.0 / 80.0), paper_moved(&r, node), 1e-12);
    expect_near_vec3(force, paper_reaction(&r, id), 0.0);
    expect_others_at_rest(&r, &node, 1);
    expect_near(0.5 * vec3_dot(force, force) / 80.0, paper_energies(&r).springs, 1e-12);
    paper_end(&r);
}

/* The usual test of a drain: the marks are drawn together, and the slit stands open as before. */
static void closing_targets_leaves_slit_open(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_VBLAST;
    paper_begin(&r, &config);
    vbss_drain_places p = paper_places(&r);
    vbss_drain_gap before, after;
    expect_ok(vbss_drain_get_gap(r.drain, &before, sizeof before));
    expect_near(2.0 * 6.5e-3 * sin(1.5e-3 / 6.5e-3), before.gap, 1e-12);
    paper_attach(&r, VBSS_DRAIN_ATTACHMENT_FORCE, p.marks[0], vec3_make(0.0, 0.0, 0.247), 0.0);
    paper_attach(&r, VBSS_DRAIN_ATTACHMENT_FORCE, p.marks[1], vec3_make(0.0, 0.0, -0.247), 0.0);
    paper_run(&r, 1e-3, 400);
    expect_ok(vbss_drain_get_gap(r.drain, &after, sizeof after));
    expect_near(0.247 / 125.0, paper_moved(&r, p.marks[0]).z, 1e-12);
    expect_near(before.gap, after.gap, 1e-12);
    expect_near(before.largest, after.largest, 1e-12);
    expect_others_at_rest(&r, p.marks, 2);
    paper_end(&r);
}

static void closing_lips_closes_slit(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_damping = 0.5;
    paper_begin(&r, &config);
    vbss_drain_places p = paper_places(&r);
    double force = 0.1;
    paper_attach(&r, VBSS_DRAIN_ATTACHMENT_FORCE, p.gap_points[0], vec3_make(0, 0, force), 0.0);
    paper_attach(&r, VBSS_DRAIN_ATTACHMENT_FORCE, p.gap_points[1], vec3_make(0, 0, -force), 0.0);
    paper_run(&r, 1e-3, 400);
    vbss_drain_gap gap;
    double wanted = 2.0 * 6.5e-3 * sin(1.5e-3 / 6.5e-3) - 2.0 * force / 125.0;
    expect_ok(vbss_drain_get_gap(r.drain, &gap, sizeof gap));
    expect_near(wanted, gap.gap, 1e-12);
    expect_near(wanted, gap.signed_gap, 1e-12);
    paper_end(&r);
}

/* All particles hang by their own weight, each on its spring, in any frame. */
static void each_particle_hangs_on_its_spring(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    config.drag = 200.0;
    config.gravity[2] = -9.81;
    config.position[0] = 0.3;
    config.orientation[1] = 0.7;
    paper_begin(&r, &config);
    paper_run(&r, 1e-3, 400);
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        vec3 rest = pose_apply(r.object->frame, r.object->mesh.rest[i]);
        vec3 sag = vec3_make(0.0, 0.0, -9.81 * r.object->mass[i] / 125.0);
        expect_near_vec3(vec3_add(rest, sag), paper_place(&r, i), 1e-12);
    }
    paper_end(&r);
}

/* Strains are told though nothing resists them. */
static void strain_is_of_surface(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    paper_begin(&r, &config);
    for (uint32_t t = 0; t < r.object->mesh.triangle_count; t++) {
        expect_near_vec3(vec3_zero(), paper_vector(&r, VBSS_DRAIN_VIEW_STRAINS, t), 1e-12);
        expect_near_vec3(vec3_zero(), paper_vector(&r, VBSS_DRAIN_VIEW_CURVATURES, t), 1e-6);
    }
    /* Everything 1 % longer along the axis, which is no side's direction: e11 + e22 is what all see. */
    vec3 x[PAPER_NODES];
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        x[i] = r.object->x[i];
        x[i].x *= 1.01;
    }
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, PAPER_NODES));
    for (uint32_t t = 0; t < r.object->mesh.triangle_count; t++) {
        vec3 strain = paper_vector(&r, VBSS_DRAIN_VIEW_STRAINS, t);
        expect_near(0.5 * (1.01 * 1.01 - 1.0), strain.x + strain.y, 1e-3);
    }
    expect_near(0.0, paper_energies(&r).membrane + paper_energies(&r).bending, 0.0);
    assert_int_equal(0, paper_statistics(&r).inverted);
    paper_end(&r);
}

int test_paper_drain(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(mesh_matches_publication),
        harness_test(slit_and_targets_snap_to_nearest_lines),
        harness_test(particle_masses_sum_to_wall_mass),
        harness_test(pulled_particle_moves_force_over_stiffness_alone),
        harness_test(closing_targets_leaves_slit_open),
        harness_test(closing_lips_closes_slit),
        harness_test(each_particle_hangs_on_its_spring),
        harness_test(strain_is_of_surface),
    };
    return cmocka_run_group_tests_name("drain.paper_drain", tests, NULL, NULL);
}
