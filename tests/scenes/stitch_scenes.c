#include "scenes/stitch_scenes.h"

#include <string.h>

#include "base/elementary.h"
#include "base/error.h"
#include "drain/drain.h"
#include "scenes/knot_curve.h"

#define PI 3.14159265358979323846
/* m. Straight through the wall, so far on either side; of the spline's control points. */
#define OUTSIDE 2.5e-3
#define INSIDE 2.0e-3
#define SPACING 0.5e-3
/* The throw: height of its middle above the tube's top, half its length a crossing, radius; hands are lower, as they pull. */
#define ABOVE 5e-3
#define HANDS_ABOVE 0.5e-3
#define HALF_A_CROSSING 0.7e-3
#define TWIST_RADIUS 0.6e-3

vbss_result stitch_scene_init(stitch_scene_options *options)
{
    *options = (stitch_scene_options){.segment = 0.5e-3, .limb = 30e-3};
    VBSS_TRY(vbss_scene_config_init(&options->scene, sizeof options->scene));
    VBSS_TRY(vbss_drain_config_init(&options->drain, sizeof options->drain));
    VBSS_TRY(vbss_thread_config_init(&options->thread, sizeof options->thread));
    memset(options->thread.gravity, 0, sizeof options->thread.gravity);
    options->thread.drag = 2.0;
    return VBSS_OK;
}

/* ---- the line, in the plane x = 0 of the drain's frame, from the end of the limb that goes in on the left */

typedef struct twist {
    double half, radius, height, turn; /* turn: rad, all of it */
    bool other;
} twist;

/* From the left to the right; the other strand is opposite. */
static vec3 twist_at(double t, const void *user)
{
    const twist *w = user;
    double sine, cosine, side = w->other ? -1.0 : 1.0;
    vbss_sincos(-0.5 * PI + w->turn * t, &sine, &cosine);
    return vec3_make(side * w->radius * cosine, w->height + side * w->radius * sine,
                     w->half * (2.0 * t - 1.0));
}

static vec3 twist_back(double t, const void *user)
{
    return twist_at(1.0 - t, user);
}

static vec3 mark_of(const drain_object *d, int side)
{
    return d->mesh.rest[d->mesh.marks[side]];
}

static void put_line(const stitch_scene_options *o, const drain_object *d, knot_curve *curve)
{
    const vec3 left = mark_of(d, DRAIN_LEFT), right = mark_of(d, DRAIN_RIGHT);
    const vec3 out[2] = {vec3_unit_or(vec3_make(0.0, left.y, left.z), left),
                         vec3_unit_or(vec3_make(0.0, right.y, right.z), right)};
    const double top = o->drain.radius + ABOVE;
    twist w = {.half = HALF_A_CROSSING * o->crossings,
               .radius = TWIST_RADIUS,
               .height = top,
               .turn = PI * o->crossings};
    vec3 end[2];
    for (int k = 0; k < 2; k++) {
        double sine, cosine, away = w.half + o->limb, side = k == 0 ? -1.0 : 1.0;
        vbss_sincos(o->rise, &sine, &cosine);
        vec3 from = vec3_add_scaled(k == 0 ? left : right, OUTSIDE, out[k]);
        end[k] = o->crossings > 0
                     ? vec3_make(0.0, o->drain.radius + HANDS_ABOVE, side * away)
                     : vec3_add_scaled(from, o->limb, vec3_make(0.0, sine, side * cosine));
    }
    knot_curve_begin(curve, SPACING);
    vec3 from = o->crossings > 0 ? end[1] : end[0];
    if (o->crossings > 0) {
        knot_curve_straight(curve, from, twist_at(1.0, &w));
        knot_curve_piece(curve, 2.0 * w.half + w.turn * w.radius, twist_back, &w);
        from = twist_at(0.0, &w);
    }
    vec3 before = vec3_add_scaled(left, OUTSIDE, out[0]),
         in = vec3_add_scaled(left, -INSIDE, out[0]);
    knot_curve_straight(curve, from, before);
    knot_curve_straight(curve, before, in);
    vec3 out_from = vec3_add_scaled(right, -INSIDE, out[1]),
         beyond = vec3_add_scaled(right, OUTSIDE, out[1]);
    knot_curve_straight(curve, in, out_from);
    knot_curve_straight(curve, out_from, beyond);
    vec3 last = end[1], to = beyond;
    if (o->crossings > 0) {
        w.other = true;
        knot_curve_straight(curve, beyond, twist_at(1.0, &w));
        knot_curve_piece(curve, 2.0 * w.half + w.turn * w.radius, twist_back, &w);
        to = twist_at(0.0, &w);
        last = end[0];
    }
    knot_curve_straight(curve, to, last);
    knot_curve_finish(curve, last);
}

static vbss_result make_thread(vbss_context *context, const stitch_scene_options *o,
                               const drain_object *d, stitch_scene *s)
{
    static knot_curve curve;
    put_line(o, d, &curve);
    double length = knot_curve_length(&curve);
    s->node_count = (uint32_t)(length / o->segment) + 1;
    if (curve.full || s->node_count > STITCH_NODES) {
        return vbss_fail(context, VBSS_ERROR_CAPACITY, "too long a stitch");
    }
    uint32_t segments = s->node_count - 1;
    for (uint32_t i = 0; i <= segments; i++) {
        vec3_store(s->x + 3 * (size_t)i, knot_curve_at(&curve, length * i / segments));
    }
    for (uint32_t i = 0; i < segments; i++) {
        s->rest[i] =
            vec3_distance(vec3_load(s->x + 3 * (size_t)i), vec3_load(s->x + 3 * (size_t)i + 3));
    }
    vbss_thread_config c = o->thread;
    c.segment_count = segments;
    c.rest_lengths = s->rest;
    c.positions = s->x;
    return vbss_thread_create(context, &c, &s->thread);
}

/* The node of the thread that is nearest to a mark, from the middle on to either side. */
static double arc_at(const stitch_scene *s, vec3 mark, bool second)
{
    uint32_t half = s->node_count / 2, best = second ? half : 0;
    uint32_t end = second ? s->node_count : half;
    double arc = 0.0;
    for (uint32_t i = best; i < end; i++) {
        bool nearer = vec3_distance(vec3_load(s->x + 3 * (size_t)i), mark) <
                      vec3_distance(vec3_load(s->x + 3 * (size_t)best), mark);
        best = nearer ? i : best;
    }
    for (uint32_t i = 0; i < best; i++) {
        arc += s->rest[i];
    }
    return arc;
}

static vbss_result make_hole(const drain_object *d, stitch_scene *s, int side)
{
    uint32_t node = d->mesh.marks[side];
    double arc = arc_at(s, mark_of(d, side), side == DRAIN_RIGHT);
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        double weights[3];
        for (int k = 0; k < 3; k++) {
            weights[k] = d->mesh.triangles[t][k] == node;
        }
        if (weights[0] + weights[1] + weights[2] > 0.0) {
            return vbss_scene_make_hole(s->scene, s->thread_body, arc, s->drain_body, t, weights,
                                        &s->holes[side]);
        }
    }
    return VBSS_ERROR_OUT_OF_RANGE;
}

static vbss_result take_end(stitch_scene *s, int hand)
{
    vbss_thread_attachment a;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.node = s->ends[hand];
    s->at[hand] = vec3_load(s->x + 3 * (size_t)a.node);
    vec3_store(a.position, s->at[hand]);
    return vbss_thread_attach(s->thread, &a, &s->hands[hand]);
}

vbss_result stitch_scene_create(vbss_context *context, const stitch_scene_options *options,
                                stitch_scene *made)
{
    drain_object *d;
    memset(made, 0, sizeof *made);
    VBSS_TRY(vbss_scene_create(context, &options->scene, &made->scene));
    VBSS_TRY(vbss_drain_create(context, &options->drain, &made->drain));
    VBSS_TRY(vbss_drain_open(made->drain, &d));
    VBSS_TRY(vbss_scene_add_drain(made->scene, made->drain, &made->drain_body));
    VBSS_TRY(make_thread(context, options, d, made));
    VBSS_TRY(vbss_scene_add_thread(made->scene, made->thread, &made->thread_body));
    bool swapped = options->crossings > 0;
    made->ends[swapped ? 1 : 0] = 0;
    made->ends[swapped ? 0 : 1] = made->node_count - 1;
    VBSS_TRY(make_hole(d, made, DRAIN_LEFT));
    VBSS_TRY(make_hole(d, made, DRAIN_RIGHT));
    VBSS_TRY(take_end(made, 0));
    return take_end(made, 1);
}

vbss_result stitch_scene_move(stitch_scene *s, int hand, vec3 to)
{
    double target[3];
    vec3_store(target, to);
    s->at[hand] = to;
    return vbss_thread_move(s->thread, s->hands[hand], target, NULL);
}

double stitch_scene_pull(const stitch_scene *s, int hand)
{
    vbss_thread_reaction r;
    if (vbss_thread_get_reaction(s->thread, s->hands[hand], &r, sizeof r) != VBSS_OK) {
        return 0.0;
    }
    return vec3_norm(vec3_load(r.force));
}

vbss_result stitch_scene_let_go(stitch_scene *s, int hand)
{
    return vbss_thread_detach(s->thread, s->hands[hand]);
}

/* Hands of tying: from that step on, m/s, N. */
enum { SETTLED = 100 };
#define TIE_SPEED 0.03
#define TIE_PULL 2.0

bool stitch_scene_draws(const stitch_scene *s, int hand, uint32_t step, double h, vec3 *to)
{
    double way = (hand == 0 ? -1.0 : 1.0) * TIE_SPEED * h;
    *to = vec3_add(s->at[hand], vec3_make(0.0, 0.0, way));
    return step >= SETTLED && stitch_scene_pull(s, hand) < TIE_PULL;
}

vbss_result stitch_scene_tie(stitch_scene *s, uint32_t step, double h)
{
    vec3 to;
    for (int k = 0; k < 2; k++) {
        if (stitch_scene_draws(s, k, step, h, &to)) {
            VBSS_TRY(stitch_scene_move(s, k, to));
        }
    }
    return vbss_scene_step(s->scene, h);
}

bool stitch_scene_hole(const stitch_scene *s, int side, vbss_hole *hole)
{
    for (uint32_t i = 0; vbss_scene_get_hole(s->scene, i, hole, sizeof *hole) == VBSS_OK; i++) {
        if (hole->id == s->holes[side]) {
            return true;
        }
    }
    return false;
}
