/* The thread and the tools as the knot detector wants them, and what it says. */
#include "base/error.h"
#include "knot/knot.h"
#include "session/session.h"

/* ---- places on the thread's polyline, whose first point is at the needle */

static double place_of(const thread_object *t, double arc)
{
    double begin = 0.0;
    uint32_t last = t->node_count - 2;
    for (uint32_t i = 0; i < last; i++) {
        if (begin + t->rest[i] >= arc) {
            return i + vbss_max((arc - begin) / t->rest[i], 0.0);
        }
        begin += t->rest[i];
    }
    return last + vbss_min(vbss_max((arc - begin) / t->rest[last], 0.0), 1.0);
}

static double arc_of(const thread_object *t, double place)
{
    uint32_t i = (uint32_t)vbss_max(place, 0.0);
    i = i > t->node_count - 2 ? t->node_count - 2 : i;
    return vbss_thread_arc_length(t, i) + (place - i) * t->rest[i];
}

/* ---- what is shown */

static vbss_knot_tool show_tool(const thread_object *t, const grasper_object *g,
                                const session_tool_look *look)
{
    vbss_knot_tool tool = {.point_count = 3, .held = VBSS_KNOT_HELD_NOTHING};
    for (int k = 0; k < 3; k++) {
        tool.axis[0][k] = g->view_capsules[GRASPER_SHAFT][3 + k];
        tool.axis[1][k] = g->view_capsules[GRASPER_NECK][3 + k]; /* the bend */
    }
    vec3_store(tool.axis[2], look->tip);
    tool.radius[0] = g->config.shaft_radius;
    tool.radius[1] = g->config.neck_radius;
    if (look->has_needle) {
        tool.held = VBSS_KNOT_HELD_NEEDLE;
    } else if (look->held_arc >= 0.0) {
        tool.held = VBSS_KNOT_HELD_THREAD;
        tool.held_place = place_of(t, look->held_arc);
    }
    return tool;
}

static uint32_t show_tools(const session_object *s, const scene_object *scene,
                           const thread_object *t, const session_look *look,
                           vbss_knot_tool tools[SESSION_TOOLS])
{
    const uint32_t numbers[SESSION_TOOLS] = {s->config.tools[0], s->config.tools[1],
                                             s->config.shears};
    uint32_t count = 0;
    for (uint32_t i = 0; i < SESSION_TOOLS; i++) {
        if (numbers[i] != 0) {
            const scene_body *b = vbss_scene_body(scene, numbers[i]);
            tools[count++] = show_tool(t, b->rigid.grasper, &look->tools[i]);
        }
    }
    return count;
}

/* The needle's limb comes first, so the polyline is told from its other end. */
static void show(const session_object *s, const session_look *look, const thread_object *t,
                 vbss_knot_input *in)
{
    (void)vbss_knot_input_init(in, sizeof *in);
    in->points = &t->now.x[0].x;
    in->stride_bytes = sizeof *t->now.x;
    in->point_count = t->node_count;
    in->reversed = 1;
    in->hole_count = SESSION_MARKS;
    for (int k = 0; k < SESSION_MARKS; k++) {
        const session_hole_look *hole = vbss_session_find_hole(look, s->holes[k].id);
        if (hole == NULL || hole->thread != look->thread) {
            in->hole_count = 0; /* it has just left the hole */
            continue;
        }
        vec3_store(in->holes[k], hole->at);
        in->hole_places[k] = place_of(t, hole->arc);
    }
    vec3_store(in->away, look->away);
    in->may_have_passed = t->config.method == VBSS_METHOD_PAPER; /* it has no guard */
}

/* ---- what it says */

static vbss_metrics_relation relation_of(const vbss_knot_throw *t, uint32_t number)
{
    if (number == 0) {
        return VBSS_METRICS_RELATION_FIRST;
    }
    if ((t->flags & (uint32_t)VBSS_KNOT_THROW_ORDERED) == 0) {
        return VBSS_METRICS_RELATION_UNKNOWN;
    }
    return (t->flags & (uint32_t)VBSS_KNOT_THROW_GRANNY) != 0 ? VBSS_METRICS_RELATION_GRANNY
                                                              : VBSS_METRICS_RELATION_SQUARE;
}

static void widen(session_knot_look *knot, const thread_object *thread, const vbss_knot_throw *t)
{
    double tail = arc_of(thread, vbss_max(t->tail_places[0], t->tail_places[1]));
    double limb = arc_of(thread, vbss_min(t->long_places[0], t->long_places[1]));
    knot->ends[SESSION_IN] = knot->located ? vbss_max(knot->ends[SESSION_IN], tail) : tail;
    knot->ends[SESSION_OUT] = knot->located ? vbss_min(knot->ends[SESSION_OUT], limb) : limb;
    knot->located = true;
}

static vbss_result read_throws(vbss_knot_detector *detector, const thread_object *thread,
                               uint32_t count, session_knot_look *knot)
{
    knot->count = 0;
    knot->located = false;
    for (uint32_t i = 0; i < count && knot->count < SESSION_THROWS; i++) {
        vbss_knot_throw t;
        VBSS_TRY(vbss_knot_detector_get_throw(detector, i, &t, sizeof t));
        if ((t.flags & (uint32_t)VBSS_KNOT_THROW_STRAY) != 0) {
            continue;
        }
        knot->throws[knot->count] =
            (session_throw_look){t.wraps, t.handedness, relation_of(&t, knot->count)};
        knot->count++;
        if ((t.flags & (uint32_t)VBSS_KNOT_THROW_LOCATED) != 0) {
            widen(knot, thread, &t);
        }
    }
    return VBSS_OK;
}

/* A reading that is uncertain changes nothing that was known. */
static vbss_result read_knot(const session_object *s, const thread_object *thread,
                             session_knot_look *knot)
{
    vbss_knot_state state;
    VBSS_TRY(vbss_knot_detector_get_state(s->config.knots, &state, sizeof state));
    knot->next = state.next_verdict;
    if (state.verdict == VBSS_KNOT_VERDICT_UNCERTAIN) {
        return VBSS_OK;
    }
    knot->faults = state.faults;
    return read_throws(s->config.knots, thread, state.throw_count, knot);
}

vbss_result vbss_session_look_at_knot(session_object *s, session_look *look)
{
    const scene_object *scene = ((const vbss_slot *)s->scene)->object;
    if (s->config.knots == NULL || look->lost || s->cut != 0 || vbss_session_is_over(s)) {
        return VBSS_OK;
    }
    if (!vbss_session_is_threaded(s)) {
        look->knot = s->knot = (session_knot_look){0};
        return VBSS_OK;
    }
    if (s->steps % s->config.knot_interval != 0) {
        return VBSS_OK;
    }
    const thread_object *t = vbss_scene_body(scene, look->thread)->thread.thread;
    vbss_knot_tool tools[SESSION_TOOLS];
    vbss_knot_input in;
    show(s, look, t, &in);
    in.tool_count = show_tools(s, scene, t, look, tools);
    in.tools = tools;
    VBSS_TRY(vbss_knot_detector_step(s->config.knots, &in));
    VBSS_TRY(read_knot(s, t, &s->knot));
    look->knot = s->knot;
    return VBSS_OK;
}
