/* Nodes that somebody asks for: marks, the middle of the slit, the strip that does not move. */
#include "drain/mesh.h"

void vbss_drain_choose_marks(drain_mesh *m)
{
    uint32_t row = m->grid.axial_cells / 2;
    bool any = m->grid.tip > 0;
    for (int side = DRAIN_LEFT; side <= DRAIN_RIGHT; side++) {
        m->marks[side] = any ? vbss_drain_node(m, row, m->grid.mark, side) : DRAIN_NONE;
        m->middle[side] = any ? vbss_drain_node(m, row, 0, side) : DRAIN_NONE;
    }
}

/* By a column of either side; a line that should be where the strip begins is. The paper's drain has no strip: its
 * particles are tied to their rest positions, all alike. */
bool vbss_drain_is_fixed(const drain_mesh *m, uint32_t column)
{
    return m->options.kind != DRAIN_MESH_PAPER &&
           vbss_drain_column(m, column) >= DRAIN_STRIP * (1.0 - 1e-9);
}

void vbss_drain_list_fixed(drain_mesh *m)
{
    uint32_t columns = m->grid.round_cells, count = 0;
    for (uint32_t row = 0; row <= m->grid.axial_cells; row++) {
        for (uint32_t j = 0; j < columns; j++) {
            if (vbss_drain_is_fixed(m, j <= columns / 2 ? j : columns - j)) {
                m->fixed[count++] = row * columns + j;
            }
        }
    }
}
