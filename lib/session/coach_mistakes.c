/* Derives the mistakes from the facts, debounces each of them, and emits their events.
 *
 * A mistake of the moment, such as a dropped tail, is observed from the step in which it is made until
 * the step in which it is mended, so its observation depends on whether it was observed before. */
#include "session/session.h"
#include "session/tuning.h"

#define NO_HAND ((uint32_t)VBSS_METRICS_TOOL_NONE)
#define BIT(mistake) (1ull << VBSS_SESSION_MISTAKE_##mistake)

/* What the observations of all mistakes need. */
typedef struct mistake_facts {
    const session_observation *observed;
    uint64_t before;      /* mistakes observed in the last step */
    uint32_t loop;        /* hand that has the turns on its jaws */
    bool is_throwing;     /* the phase is that of a throw */
    bool is_untied;       /* the next throw is not tied yet */
    double turns, wanted; /* turns about the loop hand's tool; their number of wraps */
} mistake_facts;

static uint64_t when(bool is_observed, uint64_t bit)
{
    return is_observed ? bit : 0;
}

/* A mistake of the moment. */
static uint64_t from_until(const mistake_facts *f, uint64_t bit, bool begins, bool ends)
{
    return when(begins || ((f->before & bit) != 0 && !ends), bit);
}

/* A mistake whose observation lasts its dwell time. Then it stays until it ends. */
static uint64_t while_until(const session_object *s, uint64_t bit, bool is_observed, bool ends)
{
    return when(is_observed || ((s->coach.open & bit) != 0 && !ends), bit);
}

/* ---- needle and stitch */

static bool is_needle_missing(const session_object *s)
{
    bool may_be_free =
        s->phase == VBSS_SESSION_PHASE_IN_DRAIN || s->phase >= VBSS_SESSION_PHASE_CUT ||
        (s->phase == VBSS_SESSION_PHASE_PULL_THROUGH && !vbss_session_is_threaded(s));
    return s->holding_tools.value == 0 && s->last_holder != NO_HAND && !may_be_free;
}

static bool is_missed(const session_object *s, uint32_t side)
{
    return s->holes[side].id != 0 && s->holes[side].deviation_mm > SESSION_MISSED_MM;
}

static uint64_t observe_stitch(const session_object *s, const mistake_facts *f)
{
    const session_coach *c = &s->coach;
    bool has_entry = s->holes[SESSION_ENTRY].id != 0, left = c->has_entry != 0 && !has_entry;
    bool was_threaded = c->entry_threaded != 0, is_stray = false;
    for (uint32_t i = 0; i < SESSION_MAX_STRAYS; i++) {
        is_stray |= s->stray_holes[i] != 0;
    }
    return when(is_needle_missing(s), BIT(NEEDLE_DROPPED)) |
           when(is_missed(s, SESSION_ENTRY), BIT(ENTRY_MISSED)) |
           when(is_missed(s, SESSION_EXIT), BIT(EXIT_MISSED)) | when(is_stray, BIT(STRAY_HOLE)) |
           from_until(f, BIT(NEEDLE_WITHDRAWN), left && !was_threaded, has_entry) |
           from_until(f, BIT(THREAD_PULLED_OUT), left && was_threaded, has_entry);
}

static uint64_t observe_tail(const session_object *s)
{
    const vbss_session_config *c = &s->config;
    bool is_untied = vbss_session_is_threaded(s) && s->throw_count == 0 && s->tail_set.value == 0;
    bool is_tying = vbss_session_is_tying(s);
    return when(is_untied && !is_tying && s->tail_length < c->tail_low - c->tail_margin,
                BIT(TAIL_SHORT)) |
           when(is_untied && is_tying && s->tail_length > c->tail_high + c->tail_margin,
                BIT(TAIL_LONG));
}

/* ---- winding, and the tail in the turns */

static uint64_t observe_winding(const session_object *s, const mistake_facts *f)
{
    const session_coach *c = &s->coach;
    bool is_free = f->is_throwing && f->is_untied && f->observed->tools[f->loop].held_arc < 0.0;
    double turns = vbss_max(f->turns * vbss_session_wanted_sign(s), 0.0);
    bool is_wound = is_free && fabs(f->turns) >= SESSION_WOUND_TURNS;
    bool is_square = vbss_session_next_throw(s) == 0;
    bool loses = is_free && c->max_turns >= 1.0 && turns < c->max_turns - SESSION_LOST_TURNS;
    /* Complete turns may gather in any order on the way to the tail. */
    bool is_winding = vbss_session_current_goal(s).goal == VBSS_SESSION_GOAL_WIND ||
                      (f->before & BIT(TOWARD_HANDLE)) != 0;
    return when(is_wound && is_winding && c->direction[f->loop] < 0, BIT(TOWARD_HANDLE)) |
           when(is_wound && !is_square && f->turns * vbss_session_wanted_sign(s) < 0.0,
                BIT(WRONG_SENSE)) |
           from_until(f, BIT(TURNS_LOST), loses,
                      !is_free || turns > vbss_min(f->wanted, c->max_turns - 0.1));
}

static uint64_t observe_grasp(const session_object *s, const mistake_facts *f)
{
    const session_coach *c = &s->coach;
    const session_tool_observation *tool = &f->observed->tools[f->loop];
    const session_hole_observation *in =
        vbss_session_find_hole(f->observed, s->holes[SESSION_ENTRY].id);
    bool is_tying = f->is_throwing && f->is_untied, holds = tool->held_arc >= 0.0;
    bool is_on_tail = holds && in != NULL && tool->held_arc > in->arc;
    bool held = (c->holding_thread >> f->loop & 1u) != 0;
    bool is_passed = s->knot.next_throw == VBSS_KNOT_VERDICT_PASSED; /* then wraps are certain */
    bool is_few = holds && held &&
                  (is_passed ? c->next_wraps < f->wanted
                             : c->grasped_turns <= f->wanted - SESSION_TURNS_BEYOND);
    bool drops =
        held && !holds && c->grasped_turns > f->wanted && c->grasped_turns < SESSION_NOT_JUDGED;
    return when(is_tying && is_few && tool->has_tail, BIT(TOO_FEW_TURNS)) |
           when(is_tying && is_on_tail && !tool->has_tail &&
                    fabs(f->turns) >= SESSION_WOUND_TURNS && c->grasped_turns < SESSION_NOT_JUDGED,
                BIT(BIGHT)) |
           from_until(f, BIT(TAIL_DROPPED), is_tying && drops && (f->before & BIT(BIGHT)) == 0,
                      !is_tying || holds || fabs(f->turns) < 0.5);
}

/* ---- the knot */

/* A loose throw may be a hitch, or have fewer wraps, until it is drawn up. Only pull shows what it is. */
static bool is_tightened(const session_object *s, const session_observation *observed)
{
    return vbss_max(observed->tension[0], observed->tension[1]) >=
           SESSION_TIGHT_RATIO * s->config.seat_force;
}

/* Of two throws the measure of half hitches also rises in good knots, so it counts for the first alone. The fault of
 * the session outlasts the measure, so a tightened throw needs both. */
static uint64_t observe_throws(const session_object *s, const mistake_facts *f)
{
    const session_coach *c = &s->coach;
    bool is_granny = false, is_few = false, is_many = false;
    int32_t first = s->config.exercise == VBSS_SESSION_EXERCISE_SINGLE_THROW ? 1 : 2;
    for (uint32_t i = 0; i < s->throw_count; i++) {
        const session_throw_observation *t = &s->throws[i].value;
        is_granny |= t->relation == VBSS_METRICS_RELATION_GRANNY;
        is_few |= i == 0 && t->wraps < first;
        is_many |= t->wraps > (i == 0 ? first : 1);
    }
    uint32_t faults = vbss_session_faults(s), hitch = (uint32_t)VBSS_KNOT_FAULT_HITCH;
    bool is_tight = is_tightened(s, f->observed);
    bool is_capsized = (faults & hitch) != 0 && s->throw_count == 1;
    return when(is_granny, BIT(GRANNY)) |
           while_until(s, BIT(TOO_FEW_WRAPS), is_few && is_tight, !is_few) |
           when(is_many, BIT(TOO_MANY_WRAPS)) |
           when((faults & (uint32_t)VBSS_KNOT_FAULT_STRAY) != 0, BIT(STRAY_KNOT)) |
           while_until(s, BIT(CAPSIZED),
                       is_capsized && is_tight && (f->observed->knot.faults & hitch) != 0,
                       !is_capsized) |
           when(s->missed_transfers != 0, BIT(TRANSFER_MISSED)) |
           from_until(f, BIT(THROW_UNDONE),
                      s->throw_count<c->throw_count, s->throw_count> c->throw_count) |
           from_until(f, BIT(SLIT_OPENED),
                      s->seated_count < c->seated_count && s->throw_count == c->throw_count,
                      s->seated_count > c->seated_count || s->throw_count < c->throw_count);
}

/* Where the other hand gives way, the thread slides through the stitch with little force, and the
 * throw turns over within half a second. */
static bool is_drawn_through(const session_object *s)
{
    return s->throw_count == 1 && s->tail_length > s->config.tail_high + SESSION_DRAWN_LENGTH;
}

static uint64_t observe_pull(const session_object *s, const mistake_facts *f)
{
    const session_observation *o = f->observed;
    double weaker = vbss_min(o->tension[0], o->tension[1]);
    double stronger = vbss_max(o->tension[0], o->tension[1]);
    bool is_seating = vbss_session_has_to_seat(s);
    bool draws = vbss_session_current_goal(s).goal == VBSS_SESSION_GOAL_DRAW_TAIL;
    bool is_one_sided = is_drawn_through(s) || (stronger > s->config.seat_force &&
                                                weaker < SESSION_ONE_SIDED_RATIO * stronger);
    return when(is_seating && is_one_sided, BIT(ONE_SIDED)) |
           when(is_seating && !draws && stronger < SESSION_SLACK_TENSION, BIT(SLACK)) |
           when(s->throw_count > 0 && o->edge_gap < -SESSION_CROSSED_EDGES, BIT(WALLS_CROSSED)) |
           when(o->max_tension > SESSION_HARD_PULL, BIT(PULLED_HARD)) |
           when(o->anchor_load > SESSION_ANCHOR_LOAD, BIT(DRAIN_TEARING));
}

static uint64_t observe_failure(const session_object *s)
{
    switch (s->failure) {
    case VBSS_SESSION_FAILURE_TIMEOUT:
        return BIT(TIME_UP);
    case VBSS_SESSION_FAILURE_AVULSED:
        return BIT(DRAIN_TORN);
    case VBSS_SESSION_FAILURE_CUT_EARLY:
        return BIT(CUT_EARLY);
    case VBSS_SESSION_FAILURE_CUT_KNOT:
        return BIT(CUT_KNOT);
    case VBSS_SESSION_FAILURE_BROKEN:
        return BIT(THREAD_BROKEN);
    default:
        return 0;
    }
}

static bool is_throwing(const session_object *s)
{
    return !vbss_session_has_to_transfer(s) &&
           (s->phase == VBSS_SESSION_PHASE_THROW_1 || s->phase == VBSS_SESSION_PHASE_THROW_2 ||
            s->phase == VBSS_SESSION_PHASE_THROW_3);
}

static uint64_t observe_mistakes(const session_object *s, const session_observation *observed)
{
    uint32_t loop = 1 - vbss_session_limb_hand(s);
    const mistake_facts f = {.observed = observed,
                             .before = s->coach.observed,
                             .loop = loop,
                             .is_throwing = is_throwing(s),
                             .is_untied = !vbss_session_has_to_seat(s),
                             .turns = s->coach.turns[loop],
                             .wanted = vbss_session_wanted_wraps(s)};
    return observe_stitch(s, &f) | observe_tail(s) | observe_winding(s, &f) | observe_grasp(s, &f) |
           observe_throws(s, &f) | observe_pull(s, &f) | observe_failure(s);
}

/* ---- debouncing */

static double dwell_of(const session_object *s, vbss_session_mistake mistake)
{
    switch (mistake) {
    case VBSS_SESSION_MISTAKE_ONE_SIDED:
        return is_drawn_through(s) ? SESSION_MISTAKE_DWELL : SESSION_TENSION_DWELL;
    case VBSS_SESSION_MISTAKE_TOWARD_HANDLE:
    case VBSS_SESSION_MISTAKE_WRONG_SENSE:
    case VBSS_SESSION_MISTAKE_TURNS_LOST:
    case VBSS_SESSION_MISTAKE_TOO_FEW_TURNS:
    case VBSS_SESSION_MISTAKE_NEEDLE_DROPPED:
        return SESSION_WINDING_DWELL;
    case VBSS_SESSION_MISTAKE_CAPSIZED:
    case VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS:
    case VBSS_SESSION_MISTAKE_WALLS_CROSSED:
        return SESSION_TENSION_DWELL;
    case VBSS_SESSION_MISTAKE_SLACK:
        return SESSION_SLACK_DWELL;
    case VBSS_SESSION_MISTAKE_BIGHT:
    case VBSS_SESSION_MISTAKE_TAIL_DROPPED:
    case VBSS_SESSION_MISTAKE_TAIL_SHORT:
    case VBSS_SESSION_MISTAKE_DRAIN_TEARING:
    case VBSS_SESSION_MISTAKE_PULLED_HARD:
        return SESSION_MISTAKE_DWELL;
    default:
        return 0.0; /* its facts are debounced */
    }
}

static uint32_t hand_of(const session_object *s, vbss_session_mistake mistake)
{
    switch (mistake) {
    case VBSS_SESSION_MISTAKE_TOO_FEW_TURNS:
    case VBSS_SESSION_MISTAKE_BIGHT:
    case VBSS_SESSION_MISTAKE_TAIL_DROPPED:
        return 1 - vbss_session_limb_hand(s);
    case VBSS_SESSION_MISTAKE_SLACK:
    case VBSS_SESSION_MISTAKE_STRAY_KNOT:
    case VBSS_SESSION_MISTAKE_TIME_UP:
    case VBSS_SESSION_MISTAKE_DRAIN_TEARING:
    case VBSS_SESSION_MISTAKE_DRAIN_TORN:
    case VBSS_SESSION_MISTAKE_THREAD_BROKEN:
    case VBSS_SESSION_MISTAKE_CUT_EARLY:
    case VBSS_SESSION_MISTAKE_CUT_KNOT:
        return NO_HAND;
    default:
        return vbss_session_limb_hand(s);
    }
}

/* The mistakes of a task that is over stay, so that hosts can show them. */
void vbss_session_update_mistakes(session_object *s, const session_observation *observed)
{
    session_coach *c = &s->coach;
    uint64_t now =
        vbss_session_is_over(s) ? c->observed | observe_failure(s) : observe_mistakes(s, observed);
    uint64_t changed = now ^ c->observed;
    c->observed = now;
    for (vbss_session_mistake m = 1; m < VBSS_SESSION_MISTAKE_COUNT; m++) {
        uint64_t bit = 1ull << m;
        c->since[m] = (changed & bit) != 0 ? s->time : c->since[m];
        double dwell =
            (now & bit) != 0 ? dwell_of(s, m) : vbss_min(dwell_of(s, m), SESSION_WINDING_DWELL);
        if (((now ^ c->open) & bit) == 0 || s->time - c->since[m] < dwell) {
            continue;
        }
        c->open ^= bit;
        c->begun[m] = (now & bit) != 0 ? s->time : c->begun[m];
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_MISTAKE, (uint32_t)m, (now & bit) == 0,
                                      hand_of(s, m));
        s->coach_event_count++;
    }
}

/* ---- what hosts see */

bool vbss_session_is_mendable(const session_object *s, vbss_session_mistake mistake)
{
    bool is_unseated = s->throw_count > s->seated_count;
    switch (mistake) {
    case VBSS_SESSION_MISTAKE_NONE:
    case VBSS_SESSION_MISTAKE_TRANSFER_MISSED:
        return false;
    case VBSS_SESSION_MISTAKE_ENTRY_MISSED:
        return s->holes[SESSION_ENTRY].threaded == 0;
    case VBSS_SESSION_MISTAKE_EXIT_MISSED:
        return s->holes[SESSION_EXIT].threaded == 0;
    case VBSS_SESSION_MISTAKE_GRANNY:
    case VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS:
    case VBSS_SESSION_MISTAKE_TOO_MANY_WRAPS:
        return is_unseated;
    default:
        return mistake < VBSS_SESSION_MISTAKE_TIME_UP;
    }
}

vbss_session_mistake vbss_session_shown_mistake(const session_object *s)
{
    const session_coach *c = &s->coach;
    vbss_session_mistake newest = VBSS_SESSION_MISTAKE_NONE;
    for (vbss_session_mistake m = 1; m < VBSS_SESSION_MISTAKE_COUNT; m++) {
        bool is_final = m >= VBSS_SESSION_MISTAKE_TIME_UP;
        bool is_shown = is_final || vbss_session_is_mendable(s, m) ||
                        s->time - c->begun[m] < SESSION_SHOWN_TIME;
        if ((c->open >> m & 1u) != 0 && is_shown &&
            (newest == VBSS_SESSION_MISTAKE_NONE || c->begun[m] >= c->begun[newest])) {
            newest = m;
        }
    }
    return newest;
}
