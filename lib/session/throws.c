/* Which throws are tied and seated, by whom, and how far the next one is. */
#include "knot/knot.h"
#include "session/session.h"

/* What is told of a knot while it is being tied; that there are too few throws is no fault then. */
#define FAULTS                                                                           \
    ((uint32_t)(VBSS_KNOT_FAULT_FIRST | VBSS_KNOT_FAULT_LATER | VBSS_KNOT_FAULT_MANY |   \
                VBSS_KNOT_FAULT_GRANNY | VBSS_KNOT_FAULT_STRAY | VBSS_KNOT_FAULT_HITCH | \
                VBSS_KNOT_FAULT_TYPE))

static void tell_at_knot(session_object *s, const session_look *look, vbss_session_event_kind kind,
                         uint32_t number, uint32_t undone)
{
    vbss_session_event *e = vbss_session_tell(s, kind, number, undone, s->holder);
    vec3_store(e->position, vec3_lerp(look->lips[0], look->lips[1], 0.5));
    e->amount = kind == VBSS_SESSION_EVENT_SEATED ? look->gap : 0.0;
}

/* ---- tied, and untied */

static bool is_same(const session_throw_look *a, const session_throw_look *b)
{
    return a->wraps == b->wraps && a->handedness == b->handedness && a->relation == b->relation;
}

static void tell_throw(session_object *s, const session_look *look, uint32_t number,
                       const session_throw_look *what, uint32_t undone)
{
    tell_at_knot(s, look, VBSS_SESSION_EVENT_THROW, number, undone);
    vbss_session_event *e = vbss_session_event_at(s, s->event_count - 1);
    e->wraps = what->wraps;
    e->handedness = what->handedness;
    e->relation = what->relation;
}

/* Whether the needle has changed hands after that throw. */
static void set_transferred(session_object *s, uint32_t number, bool is)
{
    uint32_t bit = 1u << number;
    if (((s->transferred & bit) != 0) != is) {
        s->transferred ^= bit;
        (void)vbss_session_tell(s, VBSS_SESSION_EVENT_TRANSFER, number, !is, s->holder);
    }
}

static void tie(session_object *s, const session_look *look, uint32_t number)
{
    tell_throw(s, look, number, &s->throws[number].is, 0);
    if (number < s->throw_count) {
        return; /* known better */
    }
    s->throw_count = number + 1;
    s->tied_by[number] = s->holder;
    s->seat = (session_latch){.since = s->time};
    if (number >= 1 && number <= SESSION_TRANSFERS && (s->transferred >> (number - 1) & 1u) == 0) {
        s->missed |= 1u << number;
        tell_at_knot(s, look, VBSS_SESSION_EVENT_TRANSFER_MISSED, number, 0);
    }
}

/* That below had been seated, or this one would not have been laid on it. */
static void untie(session_object *s, const session_look *look, uint32_t number,
                  const session_throw_look *was)
{
    set_transferred(s, number, false);
    if ((s->missed >> number & 1u) != 0) {
        s->missed &= ~(1u << number);
        tell_at_knot(s, look, VBSS_SESSION_EVENT_TRANSFER_MISSED, number, 1);
    }
    tell_throw(s, look, number, was, 1);
    s->throw_count = number;
    s->seat = (session_latch){.value = number > 0, .seen = number > 0, .since = s->time};
}

static void judge_throws(session_object *s, const session_look *look)
{
    session_throw_look before[SESSION_THROWS];
    for (uint32_t i = 0; i < SESSION_THROWS; i++) {
        session_throw *own = &s->throws[i];
        const session_throw_look none = {0};
        const session_throw_look *seen = i < look->knot.count ? &look->knot.throws[i] : &none;
        before[i] = own->is;
        if (!is_same(seen, &own->seen)) {
            own->seen = *seen;
            own->since = s->time;
        }
        if (s->time - own->since >= s->config.throw_dwell) {
            own->is = own->seen;
        }
    }
    for (uint32_t i = SESSION_THROWS; i-- > 0;) {
        if (before[i].wraps != 0 && s->throws[i].is.wraps == 0) {
            untie(s, look, i, &before[i]);
        }
    }
    for (uint32_t i = 0; i < SESSION_THROWS; i++) {
        if (s->throws[i].is.wraps != 0 && !is_same(&before[i], &s->throws[i].is)) {
            tie(s, look, i);
        }
    }
}

/* ---- seated */

/* By tension and a closed slit; it stays so while the slit stays closed. All below the newest are. */
static void judge_seat(session_object *s, const session_look *look)
{
    const vbss_session_config *c = &s->config;
    uint32_t seated = 0;
    if (s->throw_count > 0) {
        bool pulled = vbss_min(look->tension[0], look->tension[1]) >= c->seat_force;
        bool is =
            s->seat.value != 0 ? look->open < c->seat_release : look->open <= c->seat_gap && pulled;
        (void)vbss_session_settle(&s->seat, is, s->time, c->dwell);
        seated = s->throw_count - 1 + s->seat.value;
    }
    while (s->seated > seated) {
        tell_at_knot(s, look, VBSS_SESSION_EVENT_SEATED, --s->seated, 1);
    }
    while (s->seated < seated) {
        tell_at_knot(s, look, VBSS_SESSION_EVENT_SEATED, s->seated++, 0);
    }
}

static void judge_transfer(session_object *s)
{
    uint32_t newest = s->throw_count - 1;
    if (s->throw_count == 0 || newest >= SESSION_TRANSFERS) {
        return;
    }
    uint32_t *tied_by = &s->tied_by[newest];
    *tied_by = *tied_by == VBSS_METRICS_NO_TOOL ? s->holder : *tied_by;
    set_transferred(s, newest, s->holder != *tied_by);
}

/* ---- under way */

static uint32_t stage_of(const session_object *s, const session_look *look)
{
    uint32_t next = 8 * s->throw_count;
    if (s->throw_count > s->seated) {
        return next - 8 + VBSS_SESSION_STAGE_SEATING;
    }
    if (look->knot.next == VBSS_KNOT_VERDICT_PASSED) {
        return next + VBSS_SESSION_STAGE_PASSED;
    }
    if (look->knot.next == VBSS_KNOT_VERDICT_WRAPPING) {
        bool grasped = false;
        for (int i = 0; i < SESSION_HANDS; i++) {
            grasped |= look->tools[i].has_tail;
        }
        return next + (grasped ? VBSS_SESSION_STAGE_GRASPED : VBSS_SESSION_STAGE_WRAP);
    }
    return s->throw_count > 0 ? next - 8 + VBSS_SESSION_STAGE_SEATED : VBSS_SESSION_STAGE_NONE;
}

static void judge_stage(session_object *s, const session_look *look)
{
    if (vbss_session_settle(&s->stage, stage_of(s, look), s->time, s->config.dwell)) {
        tell_at_knot(s, look, VBSS_SESSION_EVENT_STAGE, s->stage.value / 8, 0);
        vbss_session_event_at(s, s->event_count - 1)->stage =
            (vbss_session_stage)(s->stage.value % 8);
    }
}

static void judge_faults(session_object *s, const session_look *look)
{
    uint32_t before = s->faults.value;
    uint32_t seen = look->knot.faults & (look->knot.count > 0 ? FAULTS : VBSS_KNOT_FAULT_STRAY);
    (void)vbss_session_settle(&s->faults, seen, s->time, s->config.throw_dwell);
    for (uint32_t bit = 1; bit <= FAULTS; bit <<= 1) {
        if (((s->faults.value ^ before) & bit) != 0) {
            tell_at_knot(s, look, VBSS_SESSION_EVENT_FAULT, bit, (s->faults.value & bit) == 0);
        }
    }
}

/* Once a tail is cut the knot is what it was. */
void vbss_session_judge_throws(session_object *s, const session_look *look)
{
    if (s->cut != 0) {
        return;
    }
    judge_throws(s, look);
    judge_seat(s, look);
    judge_transfer(s);
    judge_stage(s, look);
    judge_faults(s, look);
}
