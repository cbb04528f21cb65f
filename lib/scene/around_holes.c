/* What does not touch: suture and wall round a hole, wall and the jaws that hold it. */
#include "scene/around_holes.h"
#include "scene/holes.h"
#include "scene/tools.h"

/* A tip touches within so many radii of the wire from its end. */
#define TIP 1.0
/* Of a needle's reach. */
#define THREAD_REACHES (1.5 / SCENE_PIN_ARC)
/* What comes out of a hole at a small angle is in the wall still where it is no longer left out: over so many times that way
 * more it touches at a distance that grows from nothing to the whole, and is not felt all at once. */
#define COMES_OUT 1.0

scene_spot vbss_scene_spot(const scene_body *drain, uint32_t triangle, const double weights[3])
{
    const drain_object *d = drain->drain.drain;
    return (scene_spot){vbss_drain_point(d, d->x, triangle, weights),
                        vbss_drain_point(d, d->mesh.rest, triangle, weights), 0.0};
}

scene_spot vbss_scene_spot_on_side(const scene_body *drain, const uint32_t node[2], double share)
{
    const drain_object *d = drain->drain.drain;
    const vec3 *rest = d->mesh.rest;
    return (scene_spot){vec3_lerp(d->x[node[0]], d->x[node[1]], share),
                        vec3_lerp(rest[node[0]], rest[node[1]], share), 0.0};
}

scene_spot vbss_scene_spot_then(const scene_body *drain, uint32_t triangle, const double weights[3],
                                double time)
{
    const drain_object *d = drain->drain.drain;
    scene_spot spot = vbss_scene_spot(drain, triangle, weights);
    if (time > 0.0) {
        spot.now = vec3_lerp(spot.now, vbss_drain_point(d, d->trial, triangle, weights), time);
        spot.time = time;
    }
    return spot;
}

scene_spot vbss_scene_spot_on_side_then(const scene_body *drain, const uint32_t node[2],
                                        double share, double time)
{
    const vec3 *trial = drain->drain.drain->trial;
    scene_spot spot = vbss_scene_spot_on_side(drain, node, share);
    if (time > 0.0) {
        spot.now = vec3_lerp(spot.now, vec3_lerp(trial[node[0]], trial[node[1]], share), time);
        spot.time = time;
    }
    return spot;
}

bool vbss_scene_is_suture(const scene_body *b)
{
    return b->kind == BODY_THREAD || (b->kind == BODY_RIGID && b->rigid.needle != NULL);
}

double vbss_scene_arc_of(const scene_body *suture, uint32_t segment, double share)
{
    if (suture->kind == BODY_THREAD) {
        const thread_object *t = suture->thread.thread;
        double along = share > 0.0 ? share * t->rest[segment] : 0.0; /* the last node has none */
        return vbss_thread_arc_length(t, segment) + along;
    }
    const needle_object *n = suture->rigid.needle;
    double begin = vbss_needle_vertex_arc(n, segment);
    return begin + share * (vbss_needle_vertex_arc(n, segment + 1) - begin);
}

bool vbss_scene_is_at_tip(const scene_body *needle, double arc)
{
    return arc <= TIP * needle->rigid.needle->config.wire_radius;
}

/* Who enters aslant still has, beside its tip, the wall that it has pressed on. */
static double reach_of(const suture_hole *hole, const scene_body *suture, double arc, double reach)
{
    bool at_mouth = hole->needle != 0 && hole->arc < 0.0 && suture->kind == BODY_RIGID &&
                    vbss_scene_is_at_tip(suture, arc);
    return at_mouth ? vbss_max(reach, -SCENE_PIN_ARC * hole->entry_arc) : reach;
}

/* Within which of a hole a suture touches nothing: a thread, which turns at once, less far than a needle. */
static double own_reach(const scene_body *suture, double reach)
{
    return suture->kind == BODY_THREAD ? THREAD_REACHES * reach : reach;
}

/* Along the suture, across the swage too; INFINITY: of another. */
static double arc_from_hole(const scene_object *s, const suture_hole *hole,
                            const scene_body *suture, double arc, double time)
{
    bool thread = suture->kind == BODY_THREAD;
    const double there = hole->arc + time * hole->trial_slide;
    if (suture->number == (thread ? hole->thread : hole->needle)) {
        return fabs(there - arc);
    }
    uint32_t number = thread ? hole->needle : hole->thread;
    const scene_body *other =
        thread ? vbss_scene_needle_of(s, suture) : vbss_scene_thread_of(s, suture);
    if (number == 0 || other == NULL || other->number != number) {
        return (double)INFINITY;
    }
    const scene_body *needle = thread ? other : suture;
    double length = vbss_needle_length(needle->rigid.needle);
    return fabs(thread ? length + arc - there : length + there - arc);
}

/* Within that reach of its swage a thread is as thick as its needle: what is left of one there touches no more than the other. */
static double reach_at_swage(const scene_object *s, const scene_body *suture, uint32_t segment,
                             const scene_body *drain, double reach)
{
    if (suture->kind != BODY_THREAD) {
        return reach;
    }
    const scene_body *needle = vbss_scene_needle_of(s, suture);
    const vbss_drain_config *wall = &drain->drain.drain->config;
    if (needle == NULL) {
        return reach;
    }
    double wire = needle->rigid.needle->config.wire_radius;
    double touching = SCENE_PIN_ARC * (wire + 0.5 * wall->thickness);
    double arc = vbss_scene_arc_of(suture, segment, 0.0);
    double more = SCENE_PIN_ARC * (wire - suture->thread.thread->config.radius);
    return arc < touching ? reach + vbss_max(more, 0.0) : reach;
}

/* The share of the distance of touching at which a place touches that is so many reaches from a hole. */
static double share_beside(const scene_body *suture, double reaches)
{
    double whole = suture->kind == BODY_THREAD ? COMES_OUT : 0.0;
    if (reaches < 1.0) {
        return 0.0;
    }
    return reaches < 1.0 + whole ? (reaches - 1.0) / whole : 1.0;
}

static vec3 hole_point_at(const suture_hole *hole, const drain_object *d, double time)
{
    const vec3 begin = vbss_hole_point(hole, d, d->x);
    return time > 0.0 ? vec3_lerp(begin, vbss_hole_point(hole, d, d->trial), time) : begin;
}

/* Two walls that lie on each other are near, but not along the wall. */
static double share_in_holes(const scene_object *s, const scene_body *suture, uint32_t segment,
                             double share, const scene_body *drain, const scene_spot *spot,
                             double reach)
{
    const drain_object *d = drain->drain.drain;
    const double own = reach_at_swage(s, suture, segment, drain, own_reach(suture, reach));
    double least = 1.0;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id == 0 || hole->drain != drain->number) {
            continue;
        }
        double now = vec3_distance(spot->now, hole_point_at(hole, d, spot->time));
        double rest = vec3_distance(spot->rest, vbss_hole_point(hole, d, d->mesh.rest));
        double most = vbss_max(own, -SCENE_PIN_ARC * hole->entry_arc);
        if (!(vbss_max(now, rest) < (1.0 + COMES_OUT) * most)) {
            continue;
        }
        double arc = vbss_scene_arc_of(suture, segment, share);
        double far = reach_of(hole, suture, arc, own);
        double away =
            vbss_max(vbss_max(now, rest), arc_from_hole(s, hole, suture, arc, spot->time));
        least = vbss_min(least, share_beside(suture, away / far));
    }
    return least;
}

double vbss_scene_share_touching(const scene_object *s, const scene_body *body, bool point,
                                 uint32_t feature, double share, const scene_body *drain,
                                 const scene_spot *spot, double reach)
{
    if (body->kind == BODY_RIGID && point) { /* the ends of capsules stand two by two */
        share = feature % 2;
        feature /= 2;
    }
    if (body->kind == BODY_RIGID && vbss_scene_is_pinched(s, drain, spot->now, body, feature)) {
        return 0.0;
    }
    bool node = point && body->kind == BODY_THREAD;
    return vbss_scene_is_suture(body)
               ? share_in_holes(s, body, feature, node ? 0.0 : share, drain, spot, reach)
               : 1.0;
}

/* ---- the axis of a needle, cut at its holes */

/* Moves `from` on to where a hole ends that is at `arc` of the needle, if it is at that; else `to` back to where it begins. True:
 * it was at it. */
static bool pass_hole(const suture_hole *hole, double arc, const scene_body *needle, double reach,
                      double *from, double *to)
{
    double begin = arc - reach, end = arc + reach;
    double mouth = arc + reach_of(hole, needle, 0.0, reach);
    end = vbss_max(end, vbss_min(TIP * needle->rigid.needle->config.wire_radius, mouth));
    bool at = begin <= *from && *from < end;
    *from = at ? end : *from;
    *to = begin > *from ? vbss_min(*to, begin) : *to;
    return at;
}

/* From and to which arc length the next piece of a capsule's axis goes; false: there is none. */
static bool find_piece(const scene_object *s, const scene_body *needle, const scene_body *drain,
                       double reach, double *from, double *to)
{
    const double end = *to, length = vbss_needle_length(needle->rigid.needle);
    const scene_body *thread = vbss_scene_thread_of(s, needle);
    bool moved = true;
    while (moved) { /* behind one hole may be another that was looked at before */
        moved = false;
        *to = end;
        for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
            const suture_hole *h = &s->holes[i];
            bool behind = thread != NULL && h->thread == thread->number; /* in its thread */
            bool own = h->id != 0 && (behind || h->needle == needle->number);
            double arc = behind ? length + h->arc : h->arc;
            moved =
                (own && h->drain == drain->number && pass_hole(h, arc, needle, reach, from, to)) ||
                moved;
        }
    }
    return *from < *to;
}

/* What of a side lies on that way of a plane across `along`; false: nothing. */
static bool clip_side(const vec3 side[2], vec3 point, vec3 along, double shares[2])
{
    double begin = vec3_dot(vec3_sub(side[0], point), along);
    double end = vec3_dot(vec3_sub(side[1], point), along);
    if (begin < 0.0 && end < 0.0) {
        return false;
    }
    double cut = begin != end ? begin / (begin - end) : 0.0;
    shares[0] = begin < 0.0 ? vbss_max(shares[0], cut) : shares[0];
    shares[1] = end < 0.0 ? vbss_min(shares[1], cut) : shares[1];
    return shares[0] < shares[1];
}

static bool clip_to_piece(const vec3 axis[2], const vec3 side[2], double at[2][2])
{
    vec3 along = vec3_sub(axis[1], axis[0]);
    at[1][0] = 0.0;
    at[1][1] = 1.0;
    return (at[0][0] <= 0.0 ||
            clip_side(side, vec3_lerp(axis[0], axis[1], at[0][0]), along, at[1])) &&
           (at[0][1] >= 1.0 ||
            clip_side(side, vec3_lerp(axis[0], axis[1], at[0][1]), vec3_neg(along), at[1]));
}

bool vbss_scene_next_piece(const scene_object *s, const scene_body *needle, uint32_t capsule,
                           const scene_body *drain, uint32_t side, double reach, scene_piece *piece)
{
    const uint32_t *node = s->collision->shapes[drain->shape]->edges[side];
    const vec3 *x = drain->drain.drain->x, on[2] = {x[node[0]], x[node[1]]};
    const vec3 *axis = s->capsules[needle->rigid.first_capsule + capsule].now;
    const double begin = vbss_scene_arc_of(needle, capsule, 0.0);
    const double end = vbss_scene_arc_of(needle, capsule, 1.0);
    double from = piece->begun ? piece->arc : begin, to = end;
    while (find_piece(s, needle, drain, reach, &from, &to)) {
        *piece = (scene_piece){true, to, {{(from - begin) / (end - begin)}}};
        piece->at[0][1] = to < end ? (to - begin) / (end - begin) : 1.0;
        if (clip_to_piece(axis, on, piece->at)) {
            return true;
        }
        from = to;
        to = end;
    }
    return false;
}

static scene_spot spot_of_row(const scene_object *s, const scene_body *drain,
                              const contact_constraint *row)
{
    const double weights[3] = {1.0 - row->barycentric[0] - row->barycentric[1], row->barycentric[0],
                               row->barycentric[1]};
    if (row->key.kind == VBSS_CONTACT_POINT_FACE) {
        return vbss_scene_spot(drain, row->key.feature_b, weights);
    }
    const uint32_t *side = s->collision->shapes[drain->shape]->edges[row->key.feature_b];
    return vbss_scene_spot_on_side(drain, side, row->barycentric[1]);
}

double vbss_scene_share_of_row(const scene_object *s, const contact_constraint *row)
{
    const scene_body *a = vbss_scene_body(s, row->key.body_a);
    const scene_body *b = vbss_scene_body(s, row->key.body_b);
    if (a->kind == BODY_DRAIN || b == NULL || b->kind != BODY_DRAIN) {
        return 1.0;
    }
    const scene_spot spot = spot_of_row(s, b, row);
    return vbss_scene_share_touching(s, a, row->key.kind == VBSS_CONTACT_POINT_FACE,
                                     row->key.feature_a, row->barycentric[0], b, &spot,
                                     SCENE_PIN_ARC * row->contact_distance);
}
