/* Sub-chains of the thread, cut between throws, which confirm the order that a diagram shows. */
#include "knot/knot.h"

static void begin_sub_chain(const knot_locator *l, knot_curve *curve, double from, double until)
{
    const knot_input *input = l->input;
    vec3 first = vbss_knot_point_at(input, from), last = vbss_knot_point_at(input, until);
    vec3 centre = l->closure->has_tissue ? vbss_knot_point_at(input, input->tissue_place)
                                         : vbss_knot_point_at(input, 0.5 * (from + until));
    const vec3 outward = vec3_sub(first, centre), onward = vec3_sub(last, centre);
    knot_extension tail =
        vbss_knot_straight_extension(first, vec3_unit_or(outward, l->closure->tail_directions[0]));
    knot_extension end =
        vbss_knot_straight_extension(last, vec3_unit_or(onward, l->closure->long_directions[0]));
    vbss_knot_close_begin(l->closure, &curve->polygon, &tail);
    vbss_knot_polygon_add_thread(&curve->polygon, input, from, until);
    vbss_knot_close_end(l->closure, &curve->polygon, &tail, &end);
    vbss_knot_curve_begin(curve, false);
}

void vbss_knot_check_order(knot_locator *l, knot_curve *curve, knot_ops *budget)
{
    if (l->reading) {
        if (vbss_knot_curve_resume(curve, budget)) {
            l->reading = false;
            if (!vbss_knot_has_first_throws(l, &curve->reading, l->level)) {
                l->direction = l->direction_limit; /* another round may locate them better */
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
    begin_sub_chain(l, curve, from, until);
    l->reading = true;
}
