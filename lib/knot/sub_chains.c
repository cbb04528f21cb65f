/* Sub-chains of a thread: cut between throws, they confirm the order that a diagram shows. */
#include "knot/knot.h"

static void begin_part(const knot_locating *l, knot_curve *curve, double from, double until)
{
    const knot_scene *scene = l->scene;
    vec3 first = vbss_knot_point_at(scene, from), last = vbss_knot_point_at(scene, until);
    vec3 centre = l->closing->has_tissue ? vbss_knot_point_at(scene, scene->tissue_place)
                                         : vbss_knot_point_at(scene, 0.5 * (from + until));
    const vec3 outward = vec3_sub(first, centre), onward = vec3_sub(last, centre);
    knot_way tail = vbss_knot_way_out(first, vec3_unit_or(outward, l->closing->tail_out[0]));
    knot_way end = vbss_knot_way_out(last, vec3_unit_or(onward, l->closing->long_out[0]));
    vbss_knot_close_begin(l->closing, &curve->polygon, &tail);
    vbss_knot_polygon_add_thread(&curve->polygon, scene, from, until);
    vbss_knot_close_end(l->closing, &curve->polygon, &tail, &end);
    vbss_knot_curve_begin(curve, false);
}

void vbss_knot_check_order(knot_locating *l, knot_curve *curve, knot_work *work)
{
    if (l->reading) {
        if (vbss_knot_curve_go_on(curve, work)) {
            l->reading = false;
            if (!vbss_knot_has_first_throws(l, &curve->reading, l->level)) {
                l->direction = l->direction_limit; /* another round may place them better */
                l->stage = KNOT_LOCATE_PROJECT;
            }
        }
        return;
    }
    l->level++;
    if (l->level >= l->count || !l->throws[l->level].ordered || l->throws[l->level].stray) {
        l->stage = KNOT_LOCATE_DONE;
        return;
    }
    const knot_located *inner = &l->throws[l->level - 1], *outer = &l->throws[l->level];
    double from = 0.5 * (inner->tail_places[0] + outer->tail_places[1]);
    double until = 0.5 * (inner->long_places[1] + outer->long_places[0]);
    begin_part(l, curve, from, until);
    l->reading = true;
}
