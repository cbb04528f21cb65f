/* Mesh of a drain: options, checks, counts and arrays. */
#include "drain/surface.h"

#include "base/check.h"
#include "base/error.h"
#include "base/pi.h"

#include <string.h>

/* The drain of VBLaST-SS (Qi et al. 2017); opening and marks are ours. */
void vbss_drain_mesh_defaults(drain_mesh_options *o)
{
    const drain_mesh_options defaults = {.kind = DRAIN_MESH_N,
                                         .divisions = 1,
                                         .axial_cells = 6,
                                         .round_cells = 12,
                                         .radius = 6.5e-3,
                                         .length = 32e-3,
                                         .slit_length = 10e-3,
                                         .opening = 3e-3,
                                         .mark_arc = 4.5e-3};
    *o = defaults;
}

/* ---- checks: within these limits no triangle folds, and no angle of a graded mesh is below
 * 2.5 degrees */

static vbss_result check_slit(vbss_context *context, const drain_mesh_options *o)
{
    double r = o->radius;
    VBSS_TRY(vbss_check_range(context, o->slit_length, r, 0.7 * o->length, "slit_length"));
    VBSS_TRY(
        vbss_check_range(context, o->opening, 0.0, vbss_min(0.4 * o->slit_length, r), "opening"));
    double low = vbss_max(0.5 * o->opening, VBSS_PI / 9.0 * r), high = 0.5 * VBSS_PI * r;
    return vbss_check_range(context, o->mark_arc, low, high,
                            "mark_arc, between opening and fixed strip,");
}

static vbss_result check_options(vbss_context *context, const drain_mesh_options *o)
{
    VBSS_TRY(vbss_check_range(context, o->kind, 0.0, DRAIN_MESH_KINDS - 1.0, "kind"));
    VBSS_TRY(vbss_check_range(context, o->radius, 1e-4, 1.0, "radius"));
    if (o->kind == DRAIN_MESH_UNIFORM) {
        VBSS_TRY(vbss_check_range(context, o->length, 1e-3 * o->radius, 1e3 * o->radius, "length"));
        return o->slit_length == 0.0 ? VBSS_OK : check_slit(context, o);
    }
    VBSS_TRY(vbss_check_range(context, o->length, 2.0 * o->radius, 7.0 * o->radius, "length"));
    VBSS_TRY(vbss_check_range(context, o->divisions, 1.0, 4.0, "divisions"));
    return check_slit(context, o);
}

/* ---- counts */

static void count_entities(drain_mesh *m)
{
    const drain_grid *g = &m->grid;
    vbss_drain_count_nodes(m);
    m->triangle_count = 2 * g->axial_cells * g->round_cells;
    /* Euler's formula: nodes - edges + triangles = 0 for a tube, and 1 less with a hole. */
    m->edge_count = m->node_count + m->triangle_count + (g->tip_rows > 0);
    uint32_t columns = 0;
    for (uint32_t j = 0; j < g->round_cells; j++) {
        columns += vbss_drain_is_anchor_column(m, j <= g->round_cells / 2 ? j : g->round_cells - j);
    }
    m->anchor_count = columns * (g->axial_cells + 1);
}

vbss_result vbss_drain_mesh_plan(vbss_context *context, const drain_mesh_options *options,
                                 drain_mesh *m)
{
    memset(m, 0, sizeof *m);
    m->options = *options;
    if (options->kind == DRAIN_MESH_SURFACE && options->surface != NULL) {
        return vbss_drain_plan_surface(context, m);
    }
    VBSS_TRY(check_options(context, options));
    if (options->kind >= DRAIN_MESH_UNIFORM) {
        VBSS_TRY(vbss_drain_plan_uniform_grid(context, m));
    } else {
        vbss_drain_plan_graded_grid(m);
    }
    count_entities(m);
    return VBSS_OK;
}

void vbss_drain_mesh_arrays(drain_mesh *m, vbss_array arrays[DRAIN_MESH_ARRAYS])
{
    size_t nodes = m->node_count, triangles = m->triangle_count, edges = m->edge_count;
    size_t lip_edges = m->slit_count > 0 ? m->slit_count - 1 : 0; /* edges of one lip */
    const vbss_array all[] = {
        {&m->rest, nodes, sizeof *m->rest},
        {&m->angle, nodes, sizeof *m->angle},
        {&m->material_coordinates, nodes, sizeof *m->material_coordinates},
        {&m->node_area, nodes, sizeof *m->node_area},
        {&m->triangles, triangles, sizeof *m->triangles},
        {&m->opposite_node, triangles, sizeof *m->opposite_node},
        {&m->angular_width, triangles, sizeof *m->angular_width},
        {&m->edges, edges, sizeof *m->edges},
        {&m->first_edge, nodes, sizeof *m->first_edge},
        {&m->next_edge, edges, sizeof *m->next_edge},
        {&m->slit_nodes[DRAIN_LEFT], m->slit_count, sizeof(uint32_t)},
        {&m->slit_nodes[DRAIN_RIGHT], m->slit_count, sizeof(uint32_t)},
        {&m->lip_triangles[DRAIN_LEFT], lip_edges, sizeof(uint32_t)},
        {&m->lip_triangles[DRAIN_RIGHT], lip_edges, sizeof(uint32_t)},
        {&m->anchors, m->anchor_count, sizeof *m->anchors},
    };
    _Static_assert(sizeof all == DRAIN_MESH_ARRAYS * sizeof(vbss_array),
                   "the table has its length");
    memcpy(arrays, all, sizeof all);
}

void vbss_drain_mesh_fill(drain_mesh *m)
{
    if (m->options.kind == DRAIN_MESH_SURFACE) {
        vbss_drain_fill_surface(m);
        vbss_drain_list_edges(m);
    } else {
        vbss_drain_compute_nodes(m);
        vbss_drain_list_triangles(m);
        vbss_drain_list_edges(m);
        vbss_drain_list_slit(m);
        vbss_drain_list_anchors(m);
    }
    vbss_drain_find_landmarks(m);
    vbss_drain_compute_areas(m);
}
