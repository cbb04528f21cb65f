#include "portrait.h"

#include "base/linear.h"

static painter_result paint_edge(painter *p, const vbss_drain *drain, const vbss_view *x,
                                 vbss_drain_field edge)
{
    vbss_view nodes;
    double points[3 * 64];
    size_t count = 0;
    if (vbss_drain_get_view((vbss_drain *)drain, edge, &nodes, sizeof nodes) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    for (; count < nodes.count && count < 64; count++) {
        vec3_store(points + 3 * count,
                   ((const vec3 *)x->data)[((const uint32_t *)nodes.data)[count]]);
    }
    return painter_add_chain(p, points, count, 0, 0.12e-3, PAINTER_VERMILION, NULL);
}

painter_result paint_drain(painter *p, vbss_drain *drain)
{
    vbss_view x, triangles;
    vbss_drain_places places;
    if (vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x) != VBSS_OK ||
        vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_TRIANGLES, &triangles, sizeof triangles) !=
            VBSS_OK ||
        vbss_drain_get_places(drain, &places, sizeof places) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    painter_result result = painter_add_triangles(p, x.data, (size_t)x.count, 0, triangles.data,
                                                  (size_t)triangles.count, PAINTER_TISSUE);
    if (result == PAINTER_OK) {
        result = paint_edge(p, drain, &x, VBSS_DRAIN_VIEW_SLIT_LEFT);
    }
    if (result == PAINTER_OK) {
        result = paint_edge(p, drain, &x, VBSS_DRAIN_VIEW_SLIT_RIGHT);
    }
    for (int side = 0; result == PAINTER_OK && side < 2; side++) {
        double at[3];
        vec3_store(at, ((const vec3 *)x.data)[places.marks[side]]);
        result = painter_add_capsule(p, at, at, 0.35e-3, PAINTER_BLUE);
    }
    return result;
}
