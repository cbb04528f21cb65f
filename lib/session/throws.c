/* Updates the facts of the knot: throws, seats, transfers of the needle, stage, faults. */
#include "knot/knot.h"
#include "session/session.h"
#include "session/tuning.h"

/* Faults of a knot that is being tied. Too few throws are not a fault yet. */
#define FAULTS                                                                           \
    ((uint32_t)(VBSS_KNOT_FAULT_FIRST | VBSS_KNOT_FAULT_LATER | VBSS_KNOT_FAULT_MANY |   \
                VBSS_KNOT_FAULT_GRANNY | VBSS_KNOT_FAULT_STRAY | VBSS_KNOT_FAULT_HITCH | \
                VBSS_KNOT_FAULT_TYPE))
#define HITCH ((uint32_t)VBSS_KNOT_FAULT_HITCH)

static void emit_knot_event(session_object *s, const session_observation *observed,
                            vbss_session_event_kind kind, uint32_t number, uint32_t undone)
{
    vbss_session_event *e = vbss_session_emit_event(s, kind, number, undone, s->last_holder);
    vec3_store(e->position, vec3_lerp(observed->lips[0], observed->lips[1], 0.5));
    e->amount = kind == VBSS_SESSION_EVENT_SEATED ? observed->gap : 0.0;
}

/* ---- throws that are tied or come undone */

static bool is_same_throw(const session_throw_observation *a, const session_throw_observation *b)
{
    return a->wraps == b->wraps && a->handedness == b->handedness && a->relation == b->relation;
}

static void emit_throw_event(session_object *s, const session_observation *observed,
                             uint32_t number, const session_throw_observation *details,
                             uint32_t undone)
{
    emit_knot_event(s, observed, VBSS_SESSION_EVENT_THROW, number, undone);
    vbss_session_event *e = vbss_session_event_at(s, s->event_count - 1);
    e->wraps = details->wraps;
    e->handedness = details->handedness;
    e->relation = details->relation;
}

static void set_transferred(session_object *s, uint32_t number, bool is_transferred)
{
    uint32_t bit = 1u << number;
    if (((s->transferred & bit) != 0) != is_transferred) {
        s->transferred ^= bit;
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_TRANSFER, number, !is_transferred,
                                      s->last_holder);
    }
}

static void add_throw(session_object *s, const session_observation *observed, uint32_t number)
{
    emit_throw_event(s, observed, number, &s->throws[number].value, 0);
    if (number < s->throw_count) {
        return; /* a correction of its details */
    }
    s->throw_count = number + 1;
    s->tied_by[number] = s->last_holder;
    s->newest_seated = (session_debounced_value){.since = s->time};
    if (number >= 1 && number <= SESSION_TRANSFERS && (s->transferred >> (number - 1) & 1u) == 0) {
        s->missed_transfers |= 1u << number;
        emit_knot_event(s, observed, VBSS_SESSION_EVENT_TRANSFER_MISSED, number, 0);
    }
}

/* The throw below counts as seated, because this one was tied on it. */
static void remove_throw(session_object *s, const session_observation *observed, uint32_t number,
                         const session_throw_observation *was)
{
    set_transferred(s, number, false);
    if ((s->missed_transfers >> number & 1u) != 0) {
        s->missed_transfers &= ~(1u << number);
        emit_knot_event(s, observed, VBSS_SESSION_EVENT_TRANSFER_MISSED, number, 1);
    }
    emit_throw_event(s, observed, number, was, 1);
    s->throw_count = number;
    s->newest_seated =
        (session_debounced_value){.value = number > 0, .candidate = number > 0, .since = s->time};
}

static void debounce_throws(session_object *s, const session_observation *observed)
{
    session_throw_observation before[SESSION_MAX_THROWS];
    for (uint32_t i = 0; i < SESSION_MAX_THROWS; i++) {
        session_throw *own = &s->throws[i];
        const session_throw_observation none = {0};
        const session_throw_observation *seen =
            i < observed->knot.throw_count ? &observed->knot.throws[i] : &none;
        before[i] = own->value;
        if (!is_same_throw(seen, &own->candidate)) {
            own->candidate = *seen;
            own->since = s->time;
        }
        if (s->time - own->since >= s->config.throw_dwell) {
            own->value = own->candidate;
        }
    }
    for (uint32_t i = SESSION_MAX_THROWS; i-- > 0;) {
        if (before[i].wraps != 0 && s->throws[i].value.wraps == 0) {
            remove_throw(s, observed, i, &before[i]);
        }
    }
    for (uint32_t i = 0; i < SESSION_MAX_THROWS; i++) {
        if (s->throws[i].value.wraps != 0 && !is_same_throw(&before[i], &s->throws[i].value)) {
            add_throw(s, observed, i);
        }
    }
}

/* ---- seats and transfers */

/* Tension of both limbs and a closed slit seat the newest throw. It stays seated while the slit is
 * closed. All throws below it count as seated. */
static void update_seat(session_object *s, const session_observation *observed)
{
    const vbss_session_config *c = &s->config;
    uint32_t seated = 0;
    if (s->throw_count > 0) {
        bool is_tensioned = vbss_min(observed->tension[0], observed->tension[1]) >= c->seat_force;
        bool is_seated = s->newest_seated.value != 0
                             ? observed->signed_gap < c->seat_release
                             : observed->signed_gap <= c->seat_gap && is_tensioned;
        (void)vbss_session_debounce(&s->newest_seated, is_seated, s->time, c->dwell);
        seated = s->throw_count - 1 + s->newest_seated.value;
    }
    while (s->seated_count > seated) {
        emit_knot_event(s, observed, VBSS_SESSION_EVENT_SEATED, --s->seated_count, 1);
    }
    while (s->seated_count < seated) {
        emit_knot_event(s, observed, VBSS_SESSION_EVENT_SEATED, s->seated_count++, 0);
    }
}

static void update_transfer(session_object *s)
{
    uint32_t newest = s->throw_count - 1;
    if (s->throw_count == 0 || newest >= SESSION_TRANSFERS) {
        return;
    }
    uint32_t *tied_by = &s->tied_by[newest];
    *tied_by = *tied_by == VBSS_METRICS_TOOL_NONE ? s->last_holder : *tied_by;
    set_transferred(s, newest, s->last_holder != *tied_by);
}

/* ---- stage and faults */

static uint32_t current_stage(const session_object *s, const session_observation *observed)
{
    uint32_t next = 8 * s->throw_count;
    if (s->throw_count > s->seated_count) {
        return next - 8 + VBSS_SESSION_STAGE_SEATING;
    }
    if (observed->knot.next_throw == VBSS_KNOT_VERDICT_PASSED) {
        return next + VBSS_SESSION_STAGE_PASSED;
    }
    if (observed->knot.next_throw == VBSS_KNOT_VERDICT_WRAPPING) {
        bool grasped = false;
        for (int i = 0; i < SESSION_HANDS; i++) {
            grasped |= observed->tools[i].has_tail;
        }
        return next + (grasped ? VBSS_SESSION_STAGE_GRASPED : VBSS_SESSION_STAGE_WRAP);
    }
    return s->throw_count > 0 ? next - 8 + VBSS_SESSION_STAGE_SEATED : VBSS_SESSION_STAGE_NONE;
}

static void update_stage(session_object *s, const session_observation *observed)
{
    if (vbss_session_debounce(&s->throw_stage, current_stage(s, observed), s->time,
                              s->config.dwell)) {
        emit_knot_event(s, observed, VBSS_SESSION_EVENT_STAGE, s->throw_stage.value / 8, 0);
        vbss_session_event_at(s, s->event_count - 1)->stage =
            (vbss_session_stage)(s->throw_stage.value % 8);
    }
}

uint32_t vbss_session_faults(const session_object *s)
{
    return s->knot_faults.value | (s->half_hitch.value != 0 ? HITCH : 0);
}

static void update_faults(session_object *s, const session_observation *observed)
{
    uint32_t before = vbss_session_faults(s);
    uint32_t seen =
        observed->knot.faults & (observed->knot.throw_count > 0 ? FAULTS : VBSS_KNOT_FAULT_STRAY);
    (void)vbss_session_debounce(&s->knot_faults, seen & ~HITCH, s->time, s->config.throw_dwell);
    (void)vbss_session_debounce(&s->half_hitch, (seen & HITCH) != 0, s->time,
                                SESSION_HITCH_DWELLS * s->config.throw_dwell);
    uint32_t now = vbss_session_faults(s);
    for (uint32_t bit = 1; bit <= FAULTS; bit <<= 1) {
        if (((now ^ before) & bit) != 0) {
            emit_knot_event(s, observed, VBSS_SESSION_EVENT_FAULT, bit, (now & bit) == 0);
        }
    }
}

/* A cut of a limb ends the updates: the knot is final. */
void vbss_session_update_throws(session_object *s, const session_observation *observed)
{
    if (s->cut_limbs != 0) {
        return;
    }
    debounce_throws(s, observed);
    update_seat(s, observed);
    update_transfer(s);
    update_stage(s, observed);
    update_faults(s, observed);
}
