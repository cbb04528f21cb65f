/* The knot detector reads the stitch. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "tie.h"

static const double knot_reach = 3e-3; /* m: the thread of a knot is within */

/* In at the tail's, out at the limb's. */
static vbss_result show_holes(const pad_tie *t, vbss_knot_input *in)
{
    vbss_scene_hole hole;
    for (uint32_t i = 0; vbss_scene_get_hole(t->scene, i, &hole, sizeof hole) == VBSS_OK; i++) {
        if (hole.thread == t->thread.body && in->hole_count < 2) {
            memcpy(in->holes[in->hole_count], hole.position, sizeof hole.position);
            in->hole_places[in->hole_count++] = hole.arc_length / t->thread.segment;
        }
    }
    return in->hole_count == 2 ? VBSS_OK : VBSS_ERROR_NOT_FOUND;
}

static vbss_result show(const pad_tie *t, vbss_knot_input *in)
{
    VBSS_TRY(vbss_knot_input_init(in, sizeof *in));
    in->points = &t->thread.x[0].x;
    in->point_count = t->thread.count;
    in->reversed = 1;
    in->away[1] = -1.0;
    return show_holes(t, in);
}

static vbss_knot_tool as_tool(const tie_hand *h)
{
    vbss_knot_tool tool = {.point_count = 2};
    vec3_store(tool.axis[0], vec3_add_scaled(h->tip, 0.15, h->handle));
    vec3_store(tool.axis[1], h->tip);
    tool.radius[0] = 1e-3;
    tool.held = h->holds ? VBSS_KNOT_HELD_THREAD : VBSS_KNOT_HELD_NOTHING;
    tool.held_place = h->holds ? (double)h->node : 0.0;
    return tool;
}

/* ---- roots */

static vec3 middle_of(const tie_thread *s, const double places[2])
{
    return vec3_lerp(s->x[(uint32_t)places[0]], s->x[(uint32_t)places[1]], 0.5);
}

/* From an end inward until the thread comes near to the knot. */
static uint32_t first_near(const tie_thread *s, vec3 knot, uint32_t from, uint32_t to)
{
    uint32_t at = from;
    while (at != to && vec3_distance(s->x[at], knot) > knot_reach) {
        at = at < to ? at + 1 : at - 1;
    }
    return at;
}

static void find_roots(pad_tie *t, const vbss_knot_input *in)
{
    tie_thread *s = &t->thread;
    vbss_knot_throw last;
    const uint32_t tail_hole = (uint32_t)(in->hole_places[0] + 0.5),
                   limb_hole = (uint32_t)(in->hole_places[1] + 0.5);
    s->limb_root = limb_hole;
    s->tail_root = tail_hole;
    if (t->throws > 0 &&
        vbss_knot_detector_get_throw(t->detector, t->throws - 1, &last, sizeof last) == VBSS_OK &&
        (last.flags & VBSS_KNOT_THROW_LOCATED) != 0) {
        const vec3 knot =
            vec3_lerp(middle_of(s, last.tail_places), middle_of(s, last.long_places), 0.5);
        s->limb_root = first_near(s, knot, t->c.holds ? t->c.node : 0, limb_hole);
        s->tail_root = first_near(s, knot, t->w.holds ? t->w.node : s->count - 1, tail_hole);
    }
}

vbss_result tie_judge(pad_tie *t)
{
    vbss_knot_input in;
    VBSS_TRY(show(t, &in));
    VBSS_TRY(vbss_knot_detector_judge(t->detector, &in));
    VBSS_TRY(vbss_knot_detector_get_state(t->detector, &t->knot.state, sizeof t->knot.state));
    for (uint32_t i = 0; i < TIE_THROWS; i++) {
        vbss_knot_throw one;
        t->knot.handedness[i] = 0;
        if (i < t->knot.state.throw_count) {
            VBSS_TRY(vbss_knot_detector_get_throw(t->detector, i, &one, sizeof one));
            t->knot.handedness[i] = one.handedness;
        }
    }
    find_roots(t, &in);
    return vbss_knot_detector_get_notation(t->detector, t->knot.notation, sizeof t->knot.notation);
}

vbss_result tie_follow(pad_tie *t)
{
    vbss_knot_input in;
    VBSS_TRY(show(t, &in));
    VBSS_TRY(vbss_knot_detector_step(t->detector, &in));
    VBSS_TRY(vbss_knot_detector_get_state(t->detector, &t->knot.state, sizeof t->knot.state));
    return vbss_knot_detector_get_notation(t->detector, t->knot.notation, sizeof t->knot.notation);
}

vbss_result tie_count_turns(pad_tie *t, double *turns)
{
    vbss_knot_input in;
    vbss_knot_winding winding;
    const vbss_knot_tool tool = as_tool(&t->w);
    VBSS_TRY(show(t, &in));
    in.tools = &tool;
    in.tool_count = 1;
    VBSS_TRY(vbss_knot_detector_judge(t->counter, &in));
    VBSS_TRY(vbss_knot_detector_get_winding(t->counter, 0, &winding, sizeof winding));
    *turns = winding.turns;
    return VBSS_OK;
}
