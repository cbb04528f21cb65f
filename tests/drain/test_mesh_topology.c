/* How triangles hang together: neighbours, sides, orientation, nothing across the slit. */
#include "drain/mesh_rig.h"

static int place_of(const uint32_t triangle[3], uint32_t node)
{
    for (int k = 0; k < 3; k++) {
        if (triangle[k] == node) {
            return k;
        }
    }
    return -1;
}

/* The triangle that runs from one node to another, by looking at all of them. */
static uint32_t runs_along(const drain_mesh *m, uint32_t from, uint32_t to)
{
    uint32_t found = DRAIN_NONE;
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        int k = place_of(m->triangles[t], from);
        if (k >= 0 && m->triangles[t][(k + 1) % 3] == to) {
            assert_int_equal(DRAIN_NONE, found);
            found = t;
        }
    }
    return found;
}

static void expect_neighbours(const drain_mesh *m)
{
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            uint32_t p = m->triangles[t][(k + 1) % 3], q = m->triangles[t][(k + 2) % 3];
            uint32_t other = runs_along(m, q, p), beyond = m->opposite_node[t][k];
            assert_int_equal(other == DRAIN_NONE, beyond == DRAIN_NONE);
            if (other != DRAIN_NONE) {
                int off = place_of(m->triangles[other], beyond);
                assert_true(off >= 0 && beyond != p && beyond != q);
                assert_int_equal(m->triangles[t][k], m->opposite_node[other][off]);
            }
        }
    }
}

static void expect_sides(const drain_mesh *m)
{
    uint32_t free_sides = 0, seen = 0;
    for (uint32_t s = 0; s < m->edge_count; s++) {
        const drain_edge *side = &m->edges[s];
        assert_int_equal(runs_along(m, side->nodes[0], side->nodes[1]), side->triangles[0]);
        assert_int_equal(runs_along(m, side->nodes[1], side->nodes[0]), side->triangles[1]);
        free_sides += side->triangles[1] == DRAIN_NONE;
    }
    /* Two ends, two edges of the slit. */
    uint32_t edges = m->slit_count > 0 ? 2 * (m->slit_count - 1) : 0;
    assert_int_equal(2 * m->grid.round_cells + edges, free_sides);
    /* Each is found from its lesser node. */
    for (uint32_t i = 0; i < m->node_count; i++) {
        for (uint32_t s = m->first_edge[i]; s != DRAIN_NONE; s = m->next_edge[s], seen++) {
            const uint32_t *n = m->edges[s].nodes;
            assert_int_equal(i, n[0] < n[1] ? n[0] : n[1]);
        }
    }
    assert_int_equal(m->edge_count, seen);
}

/* A tube is an annulus, a slit one more hole; planned and found numbers of sides agree. */
static void expect_euler(const drain_mesh *m)
{
    drain_mesh planned;
    expect_ok(vbss_drain_mesh_plan(NULL, &m->options, &planned));
    assert_int_equal(planned.edge_count, m->edge_count);
    int64_t characteristic = (int64_t)m->node_count - m->edge_count + m->triangle_count;
    assert_int_equal(m->slit_count > 0 ? -1 : 0, characteristic);
}

static void expect_outward(const drain_mesh *m)
{
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        vec3 normal = mesh_rig_normal(m, t), sum = vec3_zero();
        for (int k = 0; k < 3; k++) {
            sum = vec3_add(sum, m->rest[m->triangles[t][k]]);
        }
        sum.x = 0.0;
        assert_true(vec3_dot(normal, sum) > 0.9 * vec3_norm(normal) * vec3_norm(sum));
    }
}

static bool touches(const drain_mesh *m, uint32_t triangle, int side)
{
    bool any = false;
    for (uint32_t k = 1; k + 1 < m->slit_count; k++) {
        any = any || place_of(m->triangles[triangle], m->slit_nodes[side][k]) >= 0 ||
              place_of(m->opposite_node[triangle], m->slit_nodes[side][k]) >= 0;
    }
    return any;
}

/* No triangle has or sees inner nodes of both edges; no side leads over the top from left to right. */
static void expect_nothing_across(const drain_mesh *m)
{
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        assert_false(touches(m, t, DRAIN_LEFT) && touches(m, t, DRAIN_RIGHT));
    }
    for (uint32_t s = 0; s < m->edge_count; s++) {
        double p = m->material_coordinates[m->edges[s].nodes[0]][0],
               q = m->material_coordinates[m->edges[s].nodes[1]][0];
        assert_false(p * q < 0.0 && fabs(p - q) < VBSS_PI * m->options.radius);
    }
}

static void expect_sound(const drain_mesh_options *o)
{
    mesh_rig rig;
    mesh_rig_begin(&rig, o);
    expect_neighbours(&rig.mesh);
    expect_sides(&rig.mesh);
    expect_euler(&rig.mesh);
    expect_outward(&rig.mesh);
    expect_nothing_across(&rig.mesh);
    mesh_rig_end(&rig);
}

static void mesh_is_connected(void **state)
{
    (void)state;
    for (int kind = 0; kind < DRAIN_MESH_KINDS; kind++) {
        drain_mesh_options o = mesh_rig_options((drain_mesh_kind)kind);
        if (kind == DRAIN_MESH_UNIFORM) {
            o = mesh_rig_tube(7, 14);
        }
        expect_sound(&o);
        o.divisions = 2;
        expect_sound(&o);
        o.opening = 0.0;
        expect_sound(&o);
    }
}

static void equal_cells_allow_slit(void **state)
{
    (void)state;
    drain_mesh_options o = mesh_rig_tube(32, 36);
    o.slit_length = 10e-3;
    o.mark_arc = 40.0 * RIG_DEGREE * o.radius;
    expect_sound(&o);
    drain_mesh m;
    expect_ok(vbss_drain_mesh_plan(NULL, &o, &m));
    assert_int_equal(33 * 36 + 9, m.node_count);
    assert_int_equal(11, m.slit_count);
    assert_int_equal(4, m.grid.mark_column);
}

/* All diagonals of one side run one way, and its neighbour's over the mirror line the other. */
static void diagonals_have_one_direction(void **state)
{
    (void)state;
    mesh_rig rig;
    drain_mesh_options o = mesh_rig_tube(5, 12);
    mesh_rig_begin(&rig, &o);
    const drain_mesh *m = &rig.mesh;
    double half = VBSS_PI * o.radius;
    uint32_t left = 0, right = 0;
    for (uint32_t s = 0; s < m->edge_count; s++) {
        const double *p = m->material_coordinates[m->edges[s].nodes[0]];
        const double *q = m->material_coordinates[m->edges[s].nodes[1]];
        double arc = q[0] - p[0], x = q[1] - p[1];
        arc -= 2.0 * half * floor(0.5 * arc / half + 0.5);
        if (fabs(arc) > 1e-9 && fabs(x) > 1e-9) {
            double middle = p[0] + 0.5 * arc;
            middle -= 2.0 * half * floor(0.5 * middle / half + 0.5);
            assert_true((arc * x > 0.0) == (middle > 0.0));
            right += middle > 0.0;
            left += middle < 0.0;
        }
    }
    assert_int_equal(5 * 6, left);
    assert_int_equal(5 * 6, right);
    mesh_rig_end(&rig);
}

int test_mesh_topology(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mesh_is_connected),
        cmocka_unit_test(equal_cells_allow_slit),
        cmocka_unit_test(diagonals_have_one_direction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
