/* The triangles of the pad: two halves that share their nodes beyond the ends of the incision. */
#include <string.h>

#include "pad.h"

static const double column_x[PAD_COLUMNS] = {0.0, 2e-3, 4.5e-3, 7.5e-3, 11.5e-3, 17e-3};
static const double row_spacing = 3e-3, opening = 1.2e-3; /* m; of the incision in its middle */

static bool is_shared(uint32_t row)
{
    return row < PAD_SHARED || row >= PAD_ROWS - PAD_SHARED;
}

static double row_z(uint32_t row)
{
    return row_spacing * ((double)row - 0.5 * (PAD_ROWS - 1));
}

/* A lens, as skin gapes. */
static double half_opening(uint32_t row)
{
    const double share = row_z(row) / row_z(PAD_ROWS - PAD_SHARED);
    return is_shared(row) ? 0.0 : 0.5 * opening * (1.0 - share * share);
}

static void add_nodes(pad_sheet *s, uint32_t nodes[2][PAD_COLUMNS][PAD_ROWS])
{
    uint32_t count = 0, anchors = 0;
    for (uint32_t side = 0; side < 2; side++) {
        for (uint32_t i = 0; i < PAD_COLUMNS; i++) {
            for (uint32_t j = 0; j < PAD_ROWS; j++) {
                if (side == 1 && i == 0 && is_shared(j)) {
                    nodes[side][i][j] = nodes[0][i][j];
                    continue;
                }
                const double share = 1.0 - column_x[i] / column_x[PAD_COLUMNS - 1];
                const double x = column_x[i] + half_opening(j) * share;
                s->x[count][0] = side == 0 ? -x : x;
                s->x[count][1] = 0.0;
                s->x[count][2] = row_z(j);
                if (i == PAD_COLUMNS - 1 || j == 0 || j == PAD_ROWS - 1) {
                    s->anchors[anchors++] = count;
                }
                nodes[side][i][j] = count++;
            }
        }
    }
}

/* Counter-clockwise seen from above. */
static void add_triangles(pad_sheet *s, uint32_t nodes[2][PAD_COLUMNS][PAD_ROWS])
{
    uint32_t count = 0;
    for (uint32_t side = 0; side < 2; side++) {
        for (uint32_t i = 0; i + 1 < PAD_COLUMNS; i++) {
            for (uint32_t j = 0; j + 1 < PAD_ROWS; j++) {
                const uint32_t a = nodes[side][i][j], b = nodes[side][i + 1][j],
                               c = nodes[side][i + 1][j + 1], d = nodes[side][i][j + 1];
                const uint32_t left[2][3] = {{a, c, d}, {a, b, c}},
                               right[2][3] = {{a, d, c}, {a, c, b}};
                memcpy(s->triangles[count], side == 0 ? left : right, sizeof left);
                count += 2;
            }
        }
    }
}

void pad_make_sheet(pad_sheet *s)
{
    uint32_t nodes[2][PAD_COLUMNS][PAD_ROWS];
    add_nodes(s, nodes);
    add_triangles(s, nodes);
    for (uint32_t side = 0; side < 2; side++) {
        memcpy(s->lips[side], nodes[side][0], sizeof s->lips[side]);
    }
}
