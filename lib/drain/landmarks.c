/* Landmarks: nodes at the marks, at the middle of the slit, and in the fixed strip. */
#include "drain/mesh.h"

void vbss_drain_find_landmarks(drain_mesh *m)
{
    uint32_t row = m->grid.axial_cells / 2;
    bool has_slit = m->grid.tip_rows > 0;
    for (int side = DRAIN_LEFT; side <= DRAIN_RIGHT; side++) {
        m->marks[side] =
            has_slit ? vbss_drain_node_index(m, row, m->grid.mark_column, side) : DRAIN_NONE;
        m->slit_middle[side] = has_slit ? vbss_drain_node_index(m, row, 0, side) : DRAIN_NONE;
    }
}

/* Columns count from the top on either side. The tolerance keeps the column at the edge of
 * the strip. The baseline's drain has no strip, as springs tie all of its particles to their
 * rest positions. */
bool vbss_drain_is_anchor_column(const drain_mesh *m, uint32_t column)
{
    return m->options.kind != DRAIN_MESH_6X12 &&
           vbss_drain_column_angle(m, column) >= DRAIN_STRIP_ANGLE * (1.0 - 1e-9);
}

void vbss_drain_list_anchors(drain_mesh *m)
{
    uint32_t columns = m->grid.round_cells, count = 0;
    for (uint32_t row = 0; row <= m->grid.axial_cells; row++) {
        for (uint32_t j = 0; j < columns; j++) {
            if (vbss_drain_is_anchor_column(m, j <= columns / 2 ? j : columns - j)) {
                m->anchors[count++] = row * columns + j;
            }
        }
    }
}
