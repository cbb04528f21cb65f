/* The thread, reduced once for all closed curves of a reading. All its possible extensions are
 * obstacles of the moves, so every closed curve made from the result has the knot type of the one
 * made from the thread. */
#include "knot/knot.h"

static void add_extension(knot_core *core, uint32_t *count, const knot_closure *closure,
                          const knot_extension *extension)
{
    for (uint32_t i = 0; i + 1 < extension->count; i++) {
        core->obstacles[(*count)++] = (knot_edge){extension->points[i], extension->points[i + 1]};
    }
    vec3 last = extension->points[extension->count - 1];
    core->obstacles[(*count)++] =
        (knot_edge){last, vec3_add_scaled(last, closure->far_distance, extension->direction)};
}

static uint32_t list_obstacles(knot_core *core, const knot_closure *closure,
                               const knot_input *input)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i <= closure->alternative_count; i++) {
        knot_extension tail =
            vbss_knot_straight_extension(input->points[0], closure->tail_directions[i]);
        knot_extension end = vbss_knot_straight_extension(input->points[input->point_count - 1],
                                                          closure->long_directions[i]);
        add_extension(core, &count, closure, &tail);
        add_extension(core, &count, closure, &end);
    }
    if (closure->has_tissue) {
        knot_extension away = vbss_knot_straight_extension(
            vbss_knot_point_at(input, input->tissue_place), closure->away);
        add_extension(core, &count, closure, &away);
    }
    if (closure->tail_hold >= 0.0) {
        add_extension(core, &count, closure, &closure->tail_extension);
    }
    if (closure->long_hold >= 0.0) {
        add_extension(core, &count, closure, &closure->long_extension);
    }
    return count;
}

/* The points of the thread, with fixed vertices where extensions start. */
static void list_vertices(knot_core *core, const knot_closure *closure, const knot_input *input)
{
    double fixed_places[KNOT_FIXED_VERTICES], last = input->point_count - 1.0;
    fixed_places[0] = closure->tail_hold;
    fixed_places[1] = closure->has_tissue ? input->tissue_place : -1.0;
    /* ascending, because the grasps are on either side of the tissue */
    fixed_places[2] = closure->long_hold;
    knot_polygon *p = &core->polygon;
    p->count = 0;
    p->closed = false;
    double from = 0.0;
    for (uint32_t i = 0; i < KNOT_FIXED_VERTICES; i++) {
        if (fixed_places[i] >= 0.0) {
            vbss_knot_polygon_add_thread(p, input, from, fixed_places[i]);
            p->is_fixed[p->count - 1] = true;
            from = fixed_places[i];
        }
    }
    vbss_knot_polygon_add_thread(p, input, from, last);
    p->is_fixed[0] = p->is_fixed[p->count - 1] = true;
}

void vbss_knot_core_begin(knot_core *core, const knot_closure *closure, const knot_input *input)
{
    list_vertices(core, closure, input);
    uint32_t count = list_obstacles(core, closure, input);
    vbss_knot_reduction_begin(&core->reduction, &core->polygon, core->obstacles, count);
}

bool vbss_knot_core_resume(knot_core *core, knot_ops *budget)
{
    return vbss_knot_reduction_resume(&core->reduction, budget);
}
