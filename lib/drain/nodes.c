/* Nodes of the mesh: numbering and rest positions. */
#include "base/elementary.h"
#include "drain/mesh.h"

void vbss_drain_count_nodes(drain_mesh *m)
{
    const drain_grid *g = &m->grid;
    uint32_t doubled = g->tip_rows > 0 ? 2 * g->tip_rows - 1 : 0;
    m->node_count = (g->axial_cells + 1) * g->round_cells + doubled;
    m->slit_count = g->tip_rows > 0 ? 2 * g->tip_rows + 1 : 0;
}

uint32_t vbss_drain_node_index(const drain_mesh *m, uint32_t row, uint32_t column, int side)
{
    const drain_grid *g = &m->grid;
    if (side == DRAIN_RIGHT) {
        return row * g->round_cells + column;
    }
    if (column == 0 && vbss_drain_is_slit_row(m, row)) {
        uint32_t first = g->axial_cells / 2 - g->tip_rows + 1;
        return (g->axial_cells + 1) * g->round_cells + row - first;
    }
    return row * g->round_cells + (g->round_cells - column) % g->round_cells;
}

/* Sets a node of the right side and its mirror image. 0 - z leaves no negative zeros. */
static void set_mirrored_nodes(drain_mesh *m, uint32_t row, uint32_t column)
{
    double radius = m->options.radius, x = vbss_drain_row_x(m, row),
           angle = vbss_drain_column_angle(m, column);
    bool bottom = column == m->grid.round_cells / 2;
    uint32_t left = vbss_drain_node_index(m, row, column, DRAIN_LEFT);
    uint32_t right = vbss_drain_node_index(m, row, column, DRAIN_RIGHT);
    double arc = radius * angle, shift = vbss_drain_slit_shift(m, x, arc);
    double sine, cosine;
    angle += shift / radius;
    vbss_sincos(angle, &sine, &cosine);
    double z = bottom ? 0.0 : radius * sine;
    m->rest[right] = vec3_make(x, radius * cosine, z);
    m->angle[right] = angle;
    m->material_coordinates[right][0] = arc;
    m->material_coordinates[right][1] = x;
    if (left != right) {
        m->rest[left] = vec3_make(x, radius * cosine, 0.0 - z);
        m->angle[left] = 0.0 - angle;
        m->material_coordinates[left][0] = 0.0 - arc;
        m->material_coordinates[left][1] = x;
    }
}

void vbss_drain_compute_nodes(drain_mesh *m)
{
    for (uint32_t row = 0; row <= m->grid.axial_cells; row++) {
        for (uint32_t column = 0; column <= m->grid.round_cells / 2; column++) {
            set_mirrored_nodes(m, row, column);
        }
    }
}
