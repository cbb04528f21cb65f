/* Which facts of the stitch hold, and what all facts come to: the phase is that of the first fact that is missing. */
#include "session/session.h"

#define MILLIMETRES 1e3

bool vbss_session_settle(session_latch *latch, uint32_t seen, double now, double dwell)
{
    if (seen != latch->seen) {
        latch->seen = seen;
        latch->since = now;
    }
    if (seen == latch->value || now - latch->since < dwell) {
        return false;
    }
    latch->value = seen;
    return true;
}

bool vbss_session_is_over(const session_object *s)
{
    return s->phase >= VBSS_SESSION_PHASE_DONE;
}

bool vbss_session_is_threaded(const session_object *s)
{
    return s->holes[SESSION_IN].threaded != 0 && s->holes[SESSION_OUT].threaded != 0;
}

bool vbss_session_is_tying(const session_object *s)
{
    return s->throw_count > 0 || s->stage.value != VBSS_SESSION_STAGE_NONE;
}

const session_hole_look *vbss_session_find_hole(const session_look *look, uint32_t id)
{
    for (uint32_t i = 0; i < look->hole_count && id > 0; i++) {
        if (look->holes[i].id == id) {
            return &look->holes[i];
        }
    }
    return NULL;
}

/* ---- who holds the needle */

static bool is_in_wall(const session_look *look)
{
    bool any = false;
    for (uint32_t i = 0; i < look->hole_count; i++) {
        any |= look->holes[i].thread == 0;
    }
    return any;
}

static void judge_holder(session_object *s, const session_look *look)
{
    uint32_t before = s->held.value, seen = 0;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        seen |= (uint32_t)look->tools[i].has_needle << i;
    }
    if (!vbss_session_settle(&s->held, seen, s->time, s->config.dwell)) {
        return;
    }
    uint32_t now = s->held.value;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        if (((now ^ before) >> i & 1u) != 0) {
            (void)vbss_session_tell(s, VBSS_SESSION_EVENT_TAKEN, 0, ~now >> i & 1u, i);
        }
        s->holder = now == 1u << i ? i : s->holder;
    }
    if (now == 0 && s->holes[SESSION_IN].id == 0 && !is_in_wall(look)) {
        (void)vbss_session_tell(s, VBSS_SESSION_EVENT_DROPPED, 0, 0, VBSS_METRICS_NO_TOOL);
    }
}

static uint32_t holding_tool(const session_object *s)
{
    return s->held.value == 0 ? VBSS_METRICS_NO_TOOL : (s->held.value & 1u) != 0 ? 0 : 1;
}

/* ---- holes */

static void tell_hole(session_object *s, vbss_session_event_kind kind, uint32_t number,
                      uint32_t undone, const session_hole_look *hole)
{
    vbss_session_event *e = vbss_session_tell(s, kind, number, undone, holding_tool(s));
    if (hole != NULL) {
        vec3_store(e->position, hole->at);
    }
}

static void leave_holes(session_object *s, const session_look *look)
{
    for (uint32_t k = SESSION_MARKS; k-- > 0;) {
        session_hole *own = &s->holes[k];
        if (own->id == 0 || vbss_session_find_hole(look, own->id) != NULL) {
            continue;
        }
        if (own->threaded != 0) {
            tell_hole(s, VBSS_SESSION_EVENT_THREADED, k, 1, NULL);
        }
        tell_hole(s, VBSS_SESSION_EVENT_PUNCTURE, k, 1, NULL);
        *own = (session_hole){0};
    }
    for (int i = 0; i < SESSION_STRAYS; i++) {
        if (s->strays[i] != 0 && vbss_session_find_hole(look, s->strays[i]) == NULL) {
            tell_hole(s, VBSS_SESSION_EVENT_STRAY, s->strays[i], 1, NULL);
            s->strays[i] = 0;
        }
    }
}

/* Along the cylinder, as the metrics have it. */
static double deviation_mm(const session_look *look, const session_hole *hole)
{
    double arc = look->radius * hole->angle;
    return MILLIMETRES * sqrt(arc * arc + hole->axial * hole->axial);
}

static void note_stray(session_object *s, const session_hole_look *hole)
{
    for (int i = 0; i < SESSION_STRAYS; i++) {
        if (s->strays[i] == 0) {
            s->strays[i] = hole->id;
            break;
        }
    }
    tell_hole(s, VBSS_SESSION_EVENT_STRAY, hole->id, 0, hole);
}

/* The first hole is the one in, whichever mark it is at; that at the other mark is the one out. */
static void enter_hole(session_object *s, const session_look *look, const session_hole_look *hole)
{
    const session_hole *in = &s->holes[SESSION_IN], *out = &s->holes[SESSION_OUT];
    bool is_in = in->id == 0, is_out = !is_in && out->id == 0 && hole->mark != in->mark;
    if (!is_in && !is_out) {
        note_stray(s, hole);
        return;
    }
    uint32_t k = is_in ? SESSION_IN : SESSION_OUT, mark = hole->mark;
    s->holes[k] = (session_hole){
        .id = hole->id, .mark = mark, .angle = hole->angle[mark], .axial = hole->axial[mark]};
    s->holes[k].deviation_mm = deviation_mm(look, &s->holes[k]);
    tell_hole(s, VBSS_SESSION_EVENT_PUNCTURE, k, 0, hole);
    vbss_session_event_at(s, s->event_count - 1)->amount = s->holes[k].deviation_mm;
}

/* Those that came in this step, that farther from the tip first: in a stitch that was laid out it is the one in. */
static void enter_holes(session_object *s, const session_look *look)
{
    const session_hole_look *next = NULL;
    uint32_t done = 0, newest = s->newest_hole; /* done: bits */
    do {
        next = NULL;
        for (uint32_t i = 0; i < look->hole_count; i++) {
            const session_hole_look *hole = &look->holes[i];
            if (hole->id > s->newest_hole && (done >> i & 1u) == 0 &&
                (next == NULL || hole->way > next->way)) {
                next = hole;
            }
        }
        if (next != NULL) {
            done |= 1u << (uint32_t)(next - look->holes);
            newest = next->id > newest ? next->id : newest;
            enter_hole(s, look, next);
        }
    } while (next != NULL);
    s->newest_hole = newest;
}

static void judge_holes(session_object *s, const session_look *look)
{
    leave_holes(s, look);
    enter_holes(s, look);
    for (uint32_t k = 0; k < SESSION_MARKS; k++) {
        const session_hole_look *hole = vbss_session_find_hole(look, s->holes[k].id);
        uint32_t threaded = hole != NULL && hole->thread == look->thread;
        if (hole != NULL && threaded != s->holes[k].threaded) {
            s->holes[k].threaded = threaded;
            tell_hole(s, VBSS_SESSION_EVENT_THREADED, k, !threaded, hole);
        }
    }
}

/* ---- the tail: once a throw was begun it is what it was. */

static bool is_long_enough(const session_object *s)
{
    const vbss_session_config *c = &s->config;
    double margin = s->tail.value != 0 ? c->tail_margin : 0.0;
    return s->tail_length >= c->tail_low - margin && s->tail_length <= c->tail_high + margin;
}

static void judge_tail(session_object *s, const session_look *look)
{
    const session_hole_look *in = vbss_session_find_hole(look, s->holes[SESSION_IN].id);
    bool threaded = vbss_session_is_threaded(s);
    s->tail_length = in != NULL && in->thread == look->thread ? look->length - in->arc : 0.0;
    if (threaded && vbss_session_is_tying(s)) {
        return;
    }
    uint32_t seen = threaded && is_long_enough(s);
    if (vbss_session_settle(&s->tail, seen, s->time, s->config.dwell)) {
        vbss_session_event *e =
            vbss_session_tell(s, VBSS_SESSION_EVENT_TAIL, 0, !seen, holding_tool(s));
        e->amount = s->tail_length;
    }
}

/* ---- what it comes to */

static vbss_session_phase phase_of_throws(const session_object *s)
{
    uint32_t k = s->seated;
    if (s->cut != 0 || k >= SESSION_WANTED) {
        return VBSS_SESSION_PHASE_CUT;
    }
    bool next = s->throw_count > k || k == 0 || (s->transferred >> (k - 1) & 1u) != 0 ||
                (s->stage.value % 8u >= VBSS_SESSION_STAGE_WRAP &&
                 s->stage.value % 8u <= VBSS_SESSION_STAGE_PASSED);
    int32_t throw_phase = VBSS_SESSION_PHASE_THROW_1 + 2 * (int32_t)k;
    return next ? throw_phase : throw_phase - 1;
}

static vbss_session_phase phase_of(const session_object *s)
{
    if (s->failure != VBSS_SESSION_FAILURE_NONE) {
        return VBSS_SESSION_PHASE_FAILED;
    }
    if (s->cut == 3) {
        return VBSS_SESSION_PHASE_DONE;
    }
    if (s->holes[SESSION_IN].id == 0) {
        return s->held.value != 0 ? VBSS_SESSION_PHASE_APPROACH : VBSS_SESSION_PHASE_LOADING;
    }
    if (s->holes[SESSION_OUT].id == 0) {
        return VBSS_SESSION_PHASE_IN_DRAIN;
    }
    if (!vbss_session_is_threaded(s) || (s->tail.value == 0 && !vbss_session_is_tying(s))) {
        return VBSS_SESSION_PHASE_PULL_THROUGH;
    }
    return phase_of_throws(s);
}

static void enter_phase(session_object *s)
{
    vbss_session_phase phase = phase_of(s);
    if (phase != s->phase) {
        uint32_t undone = phase < s->phase;
        s->phase = phase;
        (void)vbss_session_tell(s, VBSS_SESSION_EVENT_PHASE, (uint32_t)phase, undone,
                                VBSS_METRICS_NO_TOOL);
    }
    if (vbss_session_is_over(s)) {
        s->end = s->time;
    }
    uint64_t capacity = s->config.event_capacity;
    for (uint64_t i = s->event_count; i-- > s->step_events && s->event_count - i <= capacity;) {
        vbss_session_event_at(s, i)->phase = s->phase;
    }
}

void vbss_session_judge(session_object *s, const session_look *look)
{
    if (vbss_session_is_over(s)) {
        return;
    }
    if (s->steps == 1) {
        (void)vbss_session_tell(s, VBSS_SESSION_EVENT_APPEARED, 0, 0, VBSS_METRICS_NO_TOOL);
    }
    if (look->lost) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_LOST);
    } else {
        vbss_session_judge_cuts(s, look);
        judge_holder(s, look);
        judge_holes(s, look);
        judge_tail(s, look);
        vbss_session_judge_throws(s, look);
        vbss_session_judge_failures(s, look);
    }
    enter_phase(s);
}
