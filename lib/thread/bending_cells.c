/* Cells of bending. */
#include "thread/bending_cells.h"

static vec3 chord(const thread_object *t, const vec3 *x, uint32_t segment)
{
    return vec3_scale(vec3_sub(x[segment + 1], x[segment]), t->inverse_rest[segment]);
}

int vbss_thread_bending_cells(const thread_object *t, const vec3 *x, uint32_t node,
                              bending_cell cells[2])
{
    bool before = node > 0, after = node + 1 < t->node_count;
    int count = 0;
    if (vbss_thread_is_clamped(t, node)) {
        vec3 direction = vbss_thread_clamp_direction(t, node);
        if (before) {
            vec3 turn = vec3_sub(direction, chord(t, x, node - 1));
            cells[count++] = (bending_cell){turn, 0.5 * t->rest[node - 1], true, false};
        }
        if (after) {
            vec3 turn = vec3_sub(chord(t, x, node), direction);
            cells[count++] = (bending_cell){turn, 0.5 * t->rest[node], false, true};
        }
    } else if (before && after) {
        vec3 turn = vec3_sub(chord(t, x, node), chord(t, x, node - 1));
        cells[count++] =
            (bending_cell){turn, 0.5 * (t->rest[node - 1] + t->rest[node]), true, true};
    }
    return count;
}
