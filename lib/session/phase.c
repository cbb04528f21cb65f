/* Updates the facts of the stitch. Derives the phase, which is that of the first missing fact. */
#include "session/session.h"

#define MILLIMETRES 1e3

/* ---- who holds the needle */

static bool is_needle_in_wall(const session_observation *observed)
{
    bool any = false;
    for (uint32_t i = 0; i < observed->hole_count; i++) {
        any |= observed->holes[i].thread == 0;
    }
    return any;
}

static void update_holder(session_object *s, const session_observation *observed)
{
    uint32_t before = s->holding_tools.value, seen = 0;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        seen |= (uint32_t)observed->tools[i].has_needle << i;
    }
    if (!vbss_session_debounce(&s->holding_tools, seen, s->time, s->config.dwell)) {
        return;
    }
    uint32_t now = s->holding_tools.value;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        if (((now ^ before) >> i & 1u) != 0) {
            (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_TAKEN, 0, ~now >> i & 1u, i);
        }
        s->last_holder = now == 1u << i ? i : s->last_holder;
    }
    if (now == 0 && s->holes[SESSION_ENTRY].id == 0 && !is_needle_in_wall(observed)) {
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_DROPPED, 0, 0, VBSS_METRICS_TOOL_NONE);
    }
}

static uint32_t holding_tool(const session_object *s)
{
    return s->holding_tools.value == 0          ? VBSS_METRICS_TOOL_NONE
           : (s->holding_tools.value & 1u) != 0 ? 0
                                                : 1;
}

/* ---- holes */

static void emit_hole_event(session_object *s, vbss_session_event_kind kind, uint32_t number,
                            uint32_t undone, const session_hole_observation *hole)
{
    vbss_session_event *e = vbss_session_emit_event(s, kind, number, undone, holding_tool(s));
    if (hole != NULL) {
        vec3_store(e->position, hole->position);
    }
}

static void undo_missing_holes(session_object *s, const session_observation *observed)
{
    for (uint32_t k = SESSION_SIDES; k-- > 0;) {
        session_hole *own = &s->holes[k];
        if (own->id == 0 || vbss_session_find_hole(observed, own->id) != NULL) {
            continue;
        }
        if (own->threaded != 0) {
            emit_hole_event(s, VBSS_SESSION_EVENT_THREADED, k, 1, NULL);
        }
        emit_hole_event(s, VBSS_SESSION_EVENT_PUNCTURE, k, 1, NULL);
        *own = (session_hole){0};
    }
    for (int i = 0; i < SESSION_MAX_STRAYS; i++) {
        if (s->stray_holes[i] != 0 && vbss_session_find_hole(observed, s->stray_holes[i]) == NULL) {
            emit_hole_event(s, VBSS_SESSION_EVENT_STRAY, s->stray_holes[i], 1, NULL);
            s->stray_holes[i] = 0;
        }
    }
}

/* Distance on the surface of the tube, as the metrics measure it. */
static double deviation_mm(const session_observation *observed, const session_hole *hole)
{
    double arc = observed->drain_radius * hole->angle;
    return MILLIMETRES * sqrt(arc * arc + hole->axial * hole->axial);
}

static void add_stray_hole(session_object *s, const session_hole_observation *hole)
{
    for (int i = 0; i < SESSION_MAX_STRAYS; i++) {
        if (s->stray_holes[i] == 0) {
            s->stray_holes[i] = hole->id;
            break;
        }
    }
    emit_hole_event(s, VBSS_SESSION_EVENT_STRAY, hole->id, 0, hole);
}

/* The first hole is the entry, at either mark. A later hole at the other mark is the exit. */
static void add_hole(session_object *s, const session_observation *observed,
                     const session_hole_observation *hole)
{
    const session_hole *in = &s->holes[SESSION_ENTRY], *out = &s->holes[SESSION_EXIT];
    bool is_in = in->id == 0, is_out = !is_in && out->id == 0 && hole->mark != in->mark;
    if (!is_in && !is_out) {
        add_stray_hole(s, hole);
        return;
    }
    uint32_t k = is_in ? SESSION_ENTRY : SESSION_EXIT, mark = hole->mark;
    s->holes[k] = (session_hole){
        .id = hole->id, .mark = mark, .angle = hole->angle[mark], .axial = hole->axial[mark]};
    s->holes[k].deviation_mm = deviation_mm(observed, &s->holes[k]);
    emit_hole_event(s, VBSS_SESSION_EVENT_PUNCTURE, k, 0, hole);
    vbss_session_event_at(s, s->event_count - 1)->amount = s->holes[k].deviation_mm;
}

/* Adds new holes in descending distance from the tip. If both holes of the stitch appear in the
 * same step, the entry thus comes first. */
static void add_new_holes(session_object *s, const session_observation *observed)
{
    const session_hole_observation *next = NULL;
    uint32_t done = 0, newest = s->newest_hole; /* done: bit per observed hole */
    do {
        next = NULL;
        for (uint32_t i = 0; i < observed->hole_count; i++) {
            const session_hole_observation *hole = &observed->holes[i];
            if (hole->id > s->newest_hole && (done >> i & 1u) == 0 &&
                (next == NULL || hole->distance_from_tip > next->distance_from_tip)) {
                next = hole;
            }
        }
        if (next != NULL) {
            done |= 1u << (uint32_t)(next - observed->holes);
            newest = next->id > newest ? next->id : newest;
            add_hole(s, observed, next);
        }
    } while (next != NULL);
    s->newest_hole = newest;
}

static void update_holes(session_object *s, const session_observation *observed)
{
    undo_missing_holes(s, observed);
    add_new_holes(s, observed);
    for (uint32_t k = 0; k < SESSION_SIDES; k++) {
        const session_hole_observation *hole = vbss_session_find_hole(observed, s->holes[k].id);
        uint32_t threaded = hole != NULL && hole->thread == observed->thread;
        if (hole != NULL && threaded != s->holes[k].threaded) {
            s->holes[k].threaded = threaded;
            emit_hole_event(s, VBSS_SESSION_EVENT_THREADED, k, !threaded, hole);
        }
    }
}

/* ---- the tail, which is not judged once a throw is begun, because knots draw it in */

static bool is_tail_in_range(const session_object *s)
{
    const vbss_session_config *c = &s->config;
    double margin = s->tail_set.value != 0 ? c->tail_margin : 0.0;
    return s->tail_length >= c->tail_low - margin && s->tail_length <= c->tail_high + margin;
}

static void update_tail(session_object *s, const session_observation *observed)
{
    const session_hole_observation *in =
        vbss_session_find_hole(observed, s->holes[SESSION_ENTRY].id);
    bool threaded = vbss_session_is_threaded(s);
    s->tail_length =
        in != NULL && in->thread == observed->thread ? observed->thread_length - in->arc : 0.0;
    if (threaded && vbss_session_is_tying(s)) {
        return;
    }
    uint32_t seen = threaded && is_tail_in_range(s);
    if (vbss_session_debounce(&s->tail_set, seen, s->time, s->config.dwell)) {
        vbss_session_event *e =
            vbss_session_emit_event(s, VBSS_SESSION_EVENT_TAIL, 0, !seen, holding_tool(s));
        e->amount = s->tail_length;
    }
}

/* ---- the phase */

static vbss_session_phase phase_of_throws(const session_object *s)
{
    uint32_t k = s->seated_count;
    if (s->cut_limbs != 0 || k >= SESSION_REQUIRED_THROWS) {
        return VBSS_SESSION_PHASE_CUT;
    }
    bool is_throwing = s->throw_count > k || k == 0 || (s->transferred >> (k - 1) & 1u) != 0 ||
                       (s->throw_stage.value % 8u >= VBSS_SESSION_STAGE_WRAP &&
                        s->throw_stage.value % 8u <= VBSS_SESSION_STAGE_PASSED);
    int32_t throw_phase = VBSS_SESSION_PHASE_THROW_1 + 2 * (int32_t)k;
    return is_throwing ? throw_phase : throw_phase - 1;
}

static vbss_session_phase current_phase(const session_object *s)
{
    if (s->failure != VBSS_SESSION_FAILURE_NONE) {
        return VBSS_SESSION_PHASE_FAILED;
    }
    if (s->cut_limbs == 3) {
        return VBSS_SESSION_PHASE_DONE;
    }
    if (s->holes[SESSION_ENTRY].id == 0) {
        return s->holding_tools.value != 0 ? VBSS_SESSION_PHASE_APPROACH
                                           : VBSS_SESSION_PHASE_LOADING;
    }
    if (s->holes[SESSION_EXIT].id == 0) {
        return VBSS_SESSION_PHASE_IN_DRAIN;
    }
    if (!vbss_session_is_threaded(s) || (s->tail_set.value == 0 && !vbss_session_is_tying(s))) {
        return VBSS_SESSION_PHASE_PULL_THROUGH;
    }
    return phase_of_throws(s);
}

/* The events of this step get the phase after it. */
static void update_phase(session_object *s)
{
    vbss_session_phase phase = current_phase(s);
    if (phase != s->phase) {
        uint32_t undone = phase < s->phase;
        s->phase = phase;
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_PHASE, (uint32_t)phase, undone,
                                      VBSS_METRICS_TOOL_NONE);
    }
    if (vbss_session_is_over(s)) {
        s->end_time = s->time;
        s->end_time_lost = s->time_lost;
    }
    uint64_t capacity = s->config.event_capacity;
    for (uint64_t i = s->event_count;
         i-- > s->events_before_step && s->event_count - i <= capacity;) {
        vbss_session_event_at(s, i)->phase = s->phase;
    }
}

void vbss_session_update_progress(session_object *s, const session_observation *observed)
{
    if (vbss_session_is_over(s)) {
        return;
    }
    if (s->steps == 1) {
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_APPEARED, 0, 0, VBSS_METRICS_TOOL_NONE);
    }
    if (observed->has_lost_body) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_LOST);
    } else {
        vbss_session_update_cuts(s, observed);
        update_holder(s, observed);
        update_holes(s, observed);
        update_tail(s, observed);
        vbss_session_update_throws(s, observed);
        vbss_session_update_failures(s, observed);
    }
    vbss_session_update_lost_time(s);
    update_phase(s);
    vbss_session_update_exercise(s, observed);
}
