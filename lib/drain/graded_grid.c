/* Graded grids: rows and columns of meshes that are fine near the slit. */
#include "base/pi.h"
#include "drain/mesh.h"

/* One half of a grid, for a drain of default size: columns in degrees from the top, rows in mm from
 * mid-length. Other drains stretch it between the lines that have a meaning. */
typedef struct half_grid {
    uint32_t columns, rows; /* cells */
    uint32_t mark_column;   /* column of the mark */
    double degrees[11], mm[6];
} half_grid;

/* Row of the tips, in all of them; lines that are stretched to where those of the drain are. Chosen. */
enum { TIP_ROW = 3 };
#define LISTED_MARK 39.67
#define LISTED_STRIP 155.0
#define LISTED_BOTTOM 180.0
#define LISTED_TIP 5.0
#define LISTED_END 16.0

static const half_grid half_grids[] = {
    [DRAIN_MESH_N] = {6,
                      5,
                      2,
                      {0.0, 23.0, LISTED_MARK, 70.0, 110.0, LISTED_STRIP, LISTED_BOTTOM},
                      {0.0, 1.7, 3.4, LISTED_TIP, 8.0, LISTED_END}},
    [DRAIN_MESH_D] = {7,
                      5,
                      2,
                      {0.0, 20.0, LISTED_MARK, 60.0, 90.0, 122.0, LISTED_STRIP, LISTED_BOTTOM},
                      {0.0, 1.7, 3.4, LISTED_TIP, 9.0, LISTED_END}},
    [DRAIN_MESH_S] = {8,
                      5,
                      3,
                      {0.0, 13.0, 26.0, LISTED_MARK, 58.0, 80.0, 115.0, LISTED_STRIP,
                       LISTED_BOTTOM},
                      {0.0, 1.7, 3.4, LISTED_TIP, 8.0, LISTED_END}},
    [DRAIN_MESH_R] = {10,
                      5,
                      3,
                      {0.0, 13.0, 26.0, LISTED_MARK, 52.0, 66.0, 82.0, 100.0, 127.0, LISTED_STRIP,
                       LISTED_BOTTOM},
                      {0.0, 1.7, 3.4, LISTED_TIP, 9.0, LISTED_END}},
};

/* Line k of a list whose cells are divided. */
static double interpolate_lines(const double *list, uint32_t k, uint32_t divisions)
{
    uint32_t cell = k / divisions, subdivision = k % divisions;
    return subdivision == 0
               ? list[cell]
               : list[cell] + (list[cell + 1] - list[cell]) * subdivision / (double)divisions;
}

/* Linear map, exact at both ends. */
static double remap(double value, const double from[2], const double to[2])
{
    double t = (value - from[0]) / (from[1] - from[0]);
    return (1.0 - t) * to[0] + t * to[1];
}

static bool is_graded(const drain_mesh *m)
{
    return m->options.kind < DRAIN_MESH_UNIFORM;
}

void vbss_drain_plan_graded_grid(drain_mesh *m)
{
    const half_grid *half = &half_grids[m->options.kind];
    uint32_t d = m->options.divisions;
    m->grid.axial_cells = 2 * half->rows * d;
    m->grid.round_cells = 2 * half->columns * d;
    m->grid.tip_rows = TIP_ROW * d;
    m->grid.mark_column = half->mark_column * d;
}

static double graded_row(const drain_mesh *m, uint32_t k)
{
    static const double from[3] = {0.0, LISTED_TIP, LISTED_END};
    const double to[3] = {0.0, 0.5 * m->options.slit_length, 0.5 * m->options.length};
    double mm = interpolate_lines(half_grids[m->options.kind].mm, k, m->options.divisions);
    int zone = mm > LISTED_TIP;
    return remap(mm, from + zone, to + zone);
}

double vbss_drain_row_x(const drain_mesh *m, uint32_t row)
{
    uint32_t middle = m->grid.axial_cells / 2;
    if (!is_graded(m)) {
        return vbss_drain_uniform_row_x(m, row);
    }
    return row < middle ? -graded_row(m, middle - row) : graded_row(m, row - middle);
}

double vbss_drain_column_angle(const drain_mesh *m, uint32_t column)
{
    static const double from[4] = {0.0, LISTED_MARK, LISTED_STRIP, LISTED_BOTTOM};
    const double to[4] = {0.0, m->options.mark_arc / m->options.radius, DRAIN_STRIP_ANGLE, VBSS_PI};
    if (!is_graded(m)) {
        return vbss_drain_uniform_column_angle(m, column);
    }
    double degrees =
        interpolate_lines(half_grids[m->options.kind].degrees, column, m->options.divisions);
    int zone = (degrees > LISTED_MARK) + (degrees > LISTED_STRIP);
    return remap(degrees, from + zone, to + zone);
}
