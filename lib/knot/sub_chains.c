/* Sub-chains of a thread: cut between throws they confirm the order; shrunk until they lose a throw they find it. */
#include "knot/knot.h"

#include <string.h>

enum { HALVINGS = 7, TRIES = 8 };

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

/* ---- the order, confirmed */

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

/* ---- shrinking */

static uint32_t throws_in(const knot_reading *r)
{
    return r->reason == VBSS_KNOT_REASON_NONE && r->throws ? r->factors.count : KNOT_THROWS + 1;
}

static void begin_level(knot_locating *l, uint32_t level)
{
    l->level = level;
    l->side = 0;
    l->halvings = l->tries = 0;
    l->low = l->cuts[0];
    l->high = l->scene->tissue_place;
    l->reading = false;
}

void vbss_knot_begin_shrinking(knot_locating *l)
{
    l->count = l->whole->factors.count;
    memset(l->throws, 0, sizeof l->throws);
    for (uint32_t i = 0; i < l->count; i++) {
        l->throws[i].wraps = l->whole->factors.factors[i].wraps;
        l->throws[i].handedness = l->whole->factors.factors[i].handedness;
        l->throws[i].ordered = l->count == 1;
    }
    l->cuts[0] = 0.0;
    l->cuts[1] = l->scene->point_count - 1.0;
    begin_level(l, l->count);
}

/* How far inside the limits of this level the next sub-chain is cut. */
static double inner_cut(const knot_locating *l, uint32_t side)
{
    return l->found[side] + 0.03 * l->tries * (l->scene->tissue_place - l->found[side]);
}

/* What the sub-chain had that `inside` has not is the throw of this level. */
static bool take_throw(knot_locating *l, const knot_reading *inside)
{
    knot_located *t = &l->throws[l->level - 1];
    for (uint32_t i = 0; i < l->level; i++) {
        const knot_located had = l->throws[i];
        uint32_t now = inside == NULL
                           ? 0
                           : vbss_knot_count_factors(&inside->factors, had.wraps, had.handedness);
        if (vbss_knot_count_found(l, l->level, had.wraps, had.handedness) != now + 1) {
            continue;
        }
        l->throws[i] = *t;
        *t = had;
        t->located = t->ordered = true;
        t->tail_places[0] = l->found[0];
        t->long_places[1] = l->found[1];
        t->tail_places[1] = inside == NULL ? l->scene->tissue_place : inner_cut(l, 0);
        t->long_places[0] = inside == NULL ? l->scene->tissue_place : inner_cut(l, 1);
        return inside == NULL || vbss_knot_has_first_throws(l, inside, l->level - 1);
    }
    return false;
}

/* Gives up what is further inside. */
void vbss_knot_leave_unordered(knot_locating *l)
{
    for (uint32_t i = 0; i < l->level; i++) {
        l->throws[i].located = l->throws[i].ordered = false;
    }
    l->stage = KNOT_LOCATE_DONE;
}

static void take_part(knot_locating *l, const knot_reading *r)
{
    uint32_t inside = throws_in(r);
    if (l->side < 2) {
        double middle = 0.5 * (l->low + l->high);
        *(inside == l->level ? &l->low : &l->high) = middle;
        if (++l->halvings == HALVINGS) {
            l->found[l->side++] = l->low;
            l->halvings = 0;
            l->low = l->cuts[1];
            l->high = l->scene->tissue_place;
        }
        return;
    }
    if (inside == l->level - 1) {
        if (!take_throw(l, r)) {
            vbss_knot_leave_unordered(l);
            return;
        }
        l->cuts[0] = inner_cut(l, 0);
        l->cuts[1] = inner_cut(l, 1);
        begin_level(l, l->level - 1);
    } else if (++l->tries == TRIES) {
        vbss_knot_leave_unordered(l);
    }
}

void vbss_knot_shrink(knot_locating *l, knot_curve *curve, knot_work *work)
{
    if (!l->shrinking) {
        l->shrinking = true;
        vbss_knot_begin_shrinking(l);
        if (!l->closing->has_tissue || l->limbs[0]->factors.count > 0 ||
            l->limbs[1]->factors.count > 0) {
            vbss_knot_leave_unordered(l);
        }
        return;
    }
    if (l->reading) {
        if (vbss_knot_curve_go_on(curve, work)) {
            l->reading = false;
            take_part(l, &curve->reading);
        }
        return;
    }
    if (l->side == 2 && l->level == 1) {
        take_throw(l, NULL);
        l->stage = KNOT_LOCATE_DONE;
        return;
    }
    double middle = 0.5 * (l->low + l->high);
    double from = l->side == 0 ? middle : l->side == 1 ? l->cuts[0] : inner_cut(l, 0);
    double until = l->side == 1 ? middle : l->side == 0 ? l->cuts[1] : inner_cut(l, 1);
    begin_part(l, curve, from, until);
    l->reading = true;
}
