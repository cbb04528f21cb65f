/* Triangles of the grid, their edges, and the opposite nodes of their neighbours. */
#include "drain/mesh.h"

/* ---- triangles */

/* Divides a cell into two triangles, from its corner nearest to the top and to -x. On the left side
 * columns run the other way round, so two nodes are exchanged. */
static void divide_cell(drain_mesh *m, uint32_t row, uint32_t column, int side, uint32_t first)
{
    uint32_t corner = vbss_drain_node_index(m, row, column, side);
    uint32_t along = vbss_drain_node_index(m, row + 1, column, side);
    uint32_t beside = vbss_drain_node_index(m, row, column + 1, side);
    uint32_t across = vbss_drain_node_index(m, row + 1, column + 1, side);
    const uint32_t cell[2][3] = {{corner, beside, across}, {corner, across, along}};
    int second = side == DRAIN_RIGHT ? 1 : 2;
    for (uint32_t k = 0; k < 2; k++) {
        uint32_t *triangle = m->triangles[first + k];
        triangle[0] = cell[k][0];
        triangle[second] = cell[k][1];
        triangle[3 - second] = cell[k][2];
    }
}

void vbss_drain_list_triangles(drain_mesh *m)
{
    uint32_t half = m->grid.round_cells / 2, right = 0, left = m->triangle_count / 2;
    for (uint32_t row = 0; row < m->grid.axial_cells; row++) {
        for (uint32_t column = 0; column < half; column++, right += 2, left += 2) {
            divide_cell(m, row, column, DRAIN_RIGHT, right);
            divide_cell(m, row, column, DRAIN_LEFT, left);
        }
    }
}

/* ---- edges */

static uint32_t min_node(const uint32_t nodes[2])
{
    return nodes[0] < nodes[1] ? nodes[0] : nodes[1];
}

/* Finds the edge that another triangle has with the opposite direction, or adds it. */
static uint32_t find_edge(drain_mesh *m, uint32_t from, uint32_t to)
{
    const uint32_t nodes[2] = {from, to};
    uint32_t lesser_node = min_node(nodes);
    for (uint32_t s = m->first_edge[lesser_node]; s != DRAIN_NONE; s = m->next_edge[s]) {
        if (m->edges[s].nodes[0] == to && m->edges[s].nodes[1] == from) {
            return s;
        }
    }
    uint32_t s = m->edge_count++;
    const drain_edge edge = {{from, to}, {DRAIN_NONE, DRAIN_NONE}};
    m->edges[s] = edge;
    m->next_edge[s] = m->first_edge[lesser_node];
    m->first_edge[lesser_node] = s;
    return s;
}

/* Index of the corner that is not on the edge. */
static int opposite_corner(const uint32_t triangle[3], const drain_edge *edge)
{
    int vertex = 0;
    while (triangle[vertex] == edge->nodes[0] || triangle[vertex] == edge->nodes[1]) {
        vertex++;
    }
    return vertex;
}

static void link_neighbours(drain_mesh *m, const drain_edge *edge)
{
    uint32_t a = edge->triangles[0], b = edge->triangles[1];
    int corner_a = opposite_corner(m->triangles[a], edge);
    m->opposite_node[a][corner_a] = DRAIN_NONE;
    if (b != DRAIN_NONE) {
        int corner_b = opposite_corner(m->triangles[b], edge);
        m->opposite_node[a][corner_a] = m->triangles[b][corner_b];
        m->opposite_node[b][corner_b] = m->triangles[a][corner_a];
    }
}

/* Both edges of the slit have their own nodes, so no triangle has a neighbour across it. */
void vbss_drain_list_edges(drain_mesh *m)
{
    m->edge_count = 0;
    for (uint32_t i = 0; i < m->node_count; i++) {
        m->first_edge[i] = DRAIN_NONE;
    }
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            uint32_t s = find_edge(m, m->triangles[t][k], m->triangles[t][(k + 1) % 3]);
            m->edges[s].triangles[m->edges[s].triangles[0] != DRAIN_NONE] = t;
        }
    }
    for (uint32_t s = 0; s < m->edge_count; s++) {
        link_neighbours(m, &m->edges[s]);
    }
}
