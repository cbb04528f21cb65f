/* The thread reduced once for all closed curves of a reading: whatever its ends may be continued by is in the
 * way of the moves, so every closed curve made of what is left has the type of the one made of the thread. */
#include "knot/knot.h"

static void add_way(knot_core *core, uint32_t *count, const knot_closing *closing,
                    const knot_way *way)
{
    for (uint32_t i = 0; i + 1 < way->count; i++) {
        core->obstacles[(*count)++] = (knot_edge){way->points[i], way->points[i + 1]};
    }
    vec3 last = way->points[way->count - 1];
    core->obstacles[(*count)++] = (knot_edge){last, vec3_add_scaled(last, closing->far, way->out)};
}

static uint32_t list_obstacles(knot_core *core, const knot_closing *closing,
                               const knot_scene *scene)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i <= closing->others; i++) {
        knot_way tail = vbss_knot_way_out(scene->points[0], closing->tail_out[i]);
        knot_way end =
            vbss_knot_way_out(scene->points[scene->point_count - 1], closing->long_out[i]);
        add_way(core, &count, closing, &tail);
        add_way(core, &count, closing, &end);
    }
    if (closing->has_tissue) {
        knot_way away =
            vbss_knot_way_out(vbss_knot_point_at(scene, scene->tissue_place), closing->away);
        add_way(core, &count, closing, &away);
    }
    if (closing->tail_hold >= 0.0) {
        add_way(core, &count, closing, &closing->tail_way);
    }
    if (closing->long_hold >= 0.0) {
        add_way(core, &count, closing, &closing->long_way);
    }
    return count;
}

/* The thread's points, and those where something else begins. */
static void list_vertices(knot_core *core, const knot_closing *closing, const knot_scene *scene)
{
    double marks[KNOT_FIXED], last = scene->point_count - 1.0;
    marks[0] = closing->tail_hold;
    marks[1] = closing->has_tissue ? scene->tissue_place : -1.0;
    marks[2] = closing->long_hold; /* holds lie on either side of the tissue: they ascend */
    knot_polygon *p = &core->polygon;
    p->count = 0;
    p->closed = false;
    double from = 0.0;
    for (uint32_t i = 0; i < KNOT_FIXED; i++) {
        if (marks[i] >= 0.0) {
            vbss_knot_polygon_add_thread(p, scene, from, marks[i]);
            p->stays[p->count - 1] = true;
            from = marks[i];
        }
    }
    vbss_knot_polygon_add_thread(p, scene, from, last);
    p->stays[0] = p->stays[p->count - 1] = true;
}

void vbss_knot_core_begin(knot_core *core, const knot_closing *closing, const knot_scene *scene)
{
    list_vertices(core, closing, scene);
    uint32_t count = list_obstacles(core, closing, scene);
    vbss_knot_reduction_begin(&core->reduction, &core->polygon, core->obstacles, count);
}

bool vbss_knot_core_go_on(knot_core *core, knot_work *work)
{
    return vbss_knot_reduction_go_on(&core->reduction, work);
}
