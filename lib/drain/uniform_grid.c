/* Uniform grids: meshes of equal cells, for validation and for the baseline method. */
#include "base/check.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/pi.h"
#include "drain/mesh.h"
#include "drain/tuning.h"

/* Published, Qi et al. 2017: 7 particles along the drain, 12 round it, which leaves no line for tips and marks. */
enum { AXIAL_CELLS = 6, ROUND_CELLS = 12 };
/* Collision takes meshes of 65536 nodes; a slit doubles fewer than 512. Derived. */
#define MAX_NODES (65536.0 - 512.0)

/* The nearest line, from 1 to `last`. */
static uint32_t nearest_line(double cells, uint32_t last)
{
    double line = floor(cells + 0.5);
    return line < 1.0 ? 1 : line > last ? last : (uint32_t)line;
}

static vbss_result check_line(vbss_context *context, double cells, uint32_t line, const char *name)
{
    return fabs(cells - line) <= DRAIN_LINE_TOLERANCE
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                           "%s is %s cells: no line of equal cells is there", name,
                           vbss_format_number(cells, 9).text);
}

static vbss_result check_uniform(vbss_context *context, const drain_mesh_options *o)
{
    VBSS_TRY(vbss_check_range(context, o->axial_cells, 1.0, 512.0, "axial_cells"));
    VBSS_TRY(vbss_check_range(context, o->round_cells, 6.0, 1024.0, "round_cells"));
    if (o->round_cells % 2 != 0) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "round_cells is %u: odd, without a line at the bottom", o->round_cells);
    }
    if (o->slit_length > 0.0 && (o->axial_cells % 2 != 0 || o->axial_cells < 4)) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "axial_cells is %u: no lines at mid-length, tips and ends",
                         o->axial_cells);
    }
    VBSS_TRY(vbss_check_range(context, (o->axial_cells + 1.0) * o->round_cells, 0.0, MAX_NODES,
                              "number of nodes"));
    double cell = o->length / o->axial_cells * o->round_cells / (2.0 * VBSS_PI * o->radius);
    return vbss_check_range(context, cell, 1.0 / DRAIN_MAX_CELL_ASPECT, DRAIN_MAX_CELL_ASPECT,
                            "length of a cell over its width");
}

vbss_result vbss_drain_plan_uniform_grid(vbss_context *context, drain_mesh *m)
{
    const drain_mesh_options *o = &m->options;
    drain_grid *g = &m->grid;
    bool is_fixed = o->kind == DRAIN_MESH_6X12;
    if (!is_fixed) {
        VBSS_TRY(check_uniform(context, o));
    }
    g->axial_cells = is_fixed ? AXIAL_CELLS : o->axial_cells;
    g->round_cells = is_fixed ? ROUND_CELLS : o->round_cells;
    g->tip_rows = g->mark_column = 0;
    if (o->slit_length == 0.0) {
        return VBSS_OK;
    }
    double tip = 0.5 * o->slit_length / o->length * g->axial_cells;
    double mark = o->mark_arc / o->radius / (2.0 * VBSS_PI) * g->round_cells;
    g->tip_rows = nearest_line(tip, g->axial_cells / 2 - 1);
    g->mark_column = nearest_line(mark, g->round_cells / 2 - 1);
    if (!is_fixed) {
        VBSS_TRY(check_line(context, tip, g->tip_rows, "half of slit_length"));
        VBSS_TRY(check_line(context, mark, g->mark_column, "mark_arc"));
    }
    return VBSS_OK;
}

double vbss_drain_uniform_row_x(const drain_mesh *m, uint32_t row)
{
    double cells = m->grid.axial_cells;
    return 0.5 * m->options.length * ((2.0 * row - cells) / cells);
}

double vbss_drain_uniform_column_angle(const drain_mesh *m, uint32_t column)
{
    return VBSS_PI * (2.0 * column / m->grid.round_cells);
}
