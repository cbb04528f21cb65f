/* Feeds the knot detector with the thread, the holes and the tools, and reads its result. */
#include "base/error.h"
#include "knot/knot.h"
#include "session/session.h"

/* ---- conversion between arc length and place: number of a node plus a fraction of its segment */

static double polyline_parameter(const scene_thread_info *t, double arc)
{
    double segment_start = 0.0;
    uint32_t last = t->node_count - 2;
    for (uint32_t i = 0; i < last; i++) {
        if (segment_start + t->rest_lengths[i] >= arc) {
            return i + vbss_max((arc - segment_start) / t->rest_lengths[i], 0.0);
        }
        segment_start += t->rest_lengths[i];
    }
    return last + vbss_min(vbss_max((arc - segment_start) / t->rest_lengths[last], 0.0), 1.0);
}

static double arc_length_at(const scene_thread_info *t, double parameter)
{
    uint32_t segment = (uint32_t)vbss_max(parameter, 0.0);
    segment = segment > t->node_count - 2 ? t->node_count - 2 : segment;
    double segment_start = 0.0;
    for (uint32_t i = 0; i < segment; i++) {
        segment_start += t->rest_lengths[i];
    }
    return segment_start + (parameter - segment) * t->rest_lengths[segment];
}

/* ---- input of the detector */

/* Items of VBSS_GRASPER_VIEW_CAPSULES: two points of the axis, of which the second is farther from the tip, and the radius. Derived. */
enum { CAPSULE_SHAFT = 0, CAPSULE_NECK = 3, CAPSULE_END = 3, CAPSULE_RADIUS = 6 };

static vbss_knot_tool describe_tool(const scene_thread_info *t, vbss_grasper *grasper,
                                    const session_tool_observation *observed)
{
    vbss_knot_tool tool = {.point_count = 3, .held = VBSS_KNOT_HELD_NOTHING};
    vbss_view view;
    if (vbss_grasper_get_view(grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view) == VBSS_OK) {
        const double *capsules = view.data;
        const double *shaft = capsules + (size_t)CAPSULE_SHAFT * view.components;
        const double *neck = capsules + (size_t)CAPSULE_NECK * view.components;
        for (int k = 0; k < 3; k++) {
            tool.axis[0][k] = shaft[CAPSULE_END + k];
            tool.axis[1][k] = neck[CAPSULE_END + k]; /* the bend */
        }
        tool.radius[0] = shaft[CAPSULE_RADIUS];
        tool.radius[1] = neck[CAPSULE_RADIUS];
    }
    vec3_store(tool.axis[2], observed->tip);
    if (observed->has_needle) {
        tool.held = VBSS_KNOT_HELD_NEEDLE;
    } else if (observed->held_arc >= 0.0) {
        tool.held = VBSS_KNOT_HELD_THREAD;
        tool.held_place = polyline_parameter(t, observed->held_arc);
    }
    return tool;
}

static uint32_t describe_tools(const session_object *s, const scene_thread_info *t,
                               const session_observation *observed,
                               vbss_knot_tool tools[SESSION_TOOLS])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < SESSION_TOOLS; i++) {
        uint32_t number = session_tool_number(s, i);
        if (number != 0) {
            vbss_grasper *grasper = vbss_scene_inspect_body(s->scene, number).grasper;
            tools[count++] = describe_tool(t, grasper, &observed->tools[i]);
        }
    }
    return count;
}

/* Nodes are numbered from the needle, but the detector counts from the tail: hence `reversed`. */
static void fill_knot_input(const session_object *s, const session_observation *observed,
                            const scene_thread_info *t, vbss_knot_input *input)
{
    (void)vbss_knot_input_init(input, sizeof *input);
    input->points = &t->positions[0].x;
    input->stride_bytes = sizeof *t->positions;
    input->point_count = t->node_count;
    input->reversed = 1;
    input->hole_count = SESSION_SIDES;
    for (int k = 0; k < SESSION_SIDES; k++) {
        const session_hole_observation *hole = vbss_session_find_hole(observed, s->holes[k].id);
        if (hole == NULL || hole->thread != observed->thread) {
            input->hole_count = 0; /* the thread has just left it */
            continue;
        }
        vec3_store(input->holes[k], hole->position);
        input->hole_places[k] = polyline_parameter(t, hole->arc);
    }
    vec3_store(input->away, observed->into_tissue);
    input->may_have_passed = !t->is_guarded;
}

/* ---- result of the detector */

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

static void extend_knot(session_knot_observation *knot, const scene_thread_info *thread,
                        const vbss_knot_throw *t)
{
    double tail = arc_length_at(thread, vbss_max(t->tail_places[0], t->tail_places[1]));
    double limb = arc_length_at(thread, vbss_min(t->long_places[0], t->long_places[1]));
    knot->end_arcs[SESSION_ENTRY] =
        knot->is_located ? vbss_max(knot->end_arcs[SESSION_ENTRY], tail) : tail;
    knot->end_arcs[SESSION_EXIT] =
        knot->is_located ? vbss_min(knot->end_arcs[SESSION_EXIT], limb) : limb;
    knot->is_located = true;
}

static vbss_result read_throws(vbss_knot_detector *detector, const scene_thread_info *thread,
                               uint32_t count, session_knot_observation *knot)
{
    knot->throw_count = 0;
    knot->is_located = false;
    for (uint32_t i = 0; i < count && knot->throw_count < SESSION_MAX_THROWS; i++) {
        vbss_knot_throw t;
        VBSS_TRY(vbss_knot_detector_get_throw(detector, i, &t, sizeof t));
        if ((t.flags & (uint32_t)VBSS_KNOT_THROW_STRAY) != 0) {
            continue;
        }
        knot->throws[knot->throw_count] =
            (session_throw_observation){t.wraps, t.handedness, relation_of(&t, knot->throw_count)};
        knot->throw_count++;
        if ((t.flags & (uint32_t)VBSS_KNOT_THROW_LOCATED) != 0) {
            extend_knot(knot, thread, &t);
        }
    }
    return VBSS_OK;
}

/* An uncertain reading keeps the throws and faults of the last certain one. */
static vbss_result read_knot(const session_object *s, const scene_thread_info *thread,
                             session_knot_observation *knot)
{
    vbss_knot_state state;
    VBSS_TRY(vbss_knot_detector_get_state(s->config.knots, &state, sizeof state));
    knot->next_throw = state.next_verdict;
    if (state.verdict == VBSS_KNOT_VERDICT_UNCERTAIN) {
        return VBSS_OK;
    }
    knot->faults = state.faults;
    return read_throws(s->config.knots, thread, state.throw_count, knot);
}

vbss_result vbss_session_observe_knot(session_object *s, session_observation *observed)
{
    if (s->config.knots == NULL || observed->has_lost_body || s->cut_limbs != 0 ||
        vbss_session_is_over(s)) {
        return VBSS_OK;
    }
    if (!vbss_session_is_threaded(s)) {
        observed->knot = s->knot = (session_knot_observation){0};
        for (int i = 0; i < SESSION_HANDS; i++) {
            s->coach.turns[i] = 0.0;
            s->coach.direction[i] = 0;
        }
        s->coach.next_wraps = 0;
        return VBSS_OK;
    }
    if (s->steps % s->config.knot_interval != 0) {
        return VBSS_OK;
    }
    const scene_thread_info t =
        vbss_scene_inspect_thread(vbss_scene_inspect_body(s->scene, observed->thread).thread);
    vbss_knot_tool tools[SESSION_TOOLS];
    vbss_knot_input input;
    fill_knot_input(s, observed, &t, &input);
    input.tool_count = describe_tools(s, &t, observed, tools);
    input.tools = tools;
    VBSS_TRY(vbss_knot_detector_step(s->config.knots, &input));
    VBSS_TRY(read_knot(s, &t, &s->knot));
    observed->knot = s->knot;
    return vbss_session_read_winding(s);
}
