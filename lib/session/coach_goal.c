/* Derives the goal from the facts: the first thing that the present phase misses. */
#include "session/session.h"
#include "session/tuning.h"

#define NO_HAND ((uint32_t)VBSS_METRICS_TOOL_NONE)

static session_goal make_goal(vbss_session_goal goal, uint32_t tool)
{
    return (session_goal){goal, tool};
}

session_goal vbss_session_current_goal(const session_object *s)
{
    return make_goal((vbss_session_goal)(s->coach.goal.value / SESSION_GOAL_TOOLS),
                     s->coach.goal.value % SESSION_GOAL_TOOLS);
}

static bool is_current(const session_object *s, vbss_session_goal goal)
{
    return vbss_session_current_goal(s).goal == goal;
}

static bool holds_needle(const session_object *s, uint32_t hand)
{
    return (s->holding_tools.value >> hand & 1u) != 0;
}

/* ---- the stitch */

static session_goal find_goal_before_entry(const session_object *s)
{
    uint32_t hand = vbss_session_limb_hand(s);
    double distance = vbss_session_mark_distance(s, vbss_session_mark_of(s, hand, SESSION_ENTRY));
    bool is_at =
        distance < (is_current(s, VBSS_SESSION_GOAL_PIERCE) ? SESSION_OFF_MARK : SESSION_AT_MARK);
    return make_goal(is_at ? VBSS_SESSION_GOAL_PIERCE : VBSS_SESSION_GOAL_REACH_MARK, hand);
}

/* The needle is in both walls, or has left the first. */
static session_goal find_goal_of_needle(const session_object *s,
                                        const session_observation *observed)
{
    const session_hole_observation *out =
        vbss_session_find_hole(observed, s->holes[SESSION_EXIT].id);
    double length = out != NULL ? out->distance_from_tip : 0.0;
    uint32_t before = NO_HAND, beyond = NO_HAND; /* hands that hold it on either side of the hole */
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        if (holds_needle(s, i)) {
            bool is_beyond = vbss_session_needle_arc(s, observed->tools[i].tip) < length;
            *(is_beyond ? &beyond : &before) = i;
        }
    }
    if (beyond != NO_HAND) {
        return before != NO_HAND ? make_goal(VBSS_SESSION_GOAL_RELEASE_NEEDLE, before)
                                 : make_goal(VBSS_SESSION_GOAL_DRAW_NEEDLE, beyond);
    }
    double margin = is_current(s, VBSS_SESSION_GOAL_TAKE_TIP) ? SESSION_TIP_OUT_MARGIN : 0.0;
    if (length < SESSION_TIP_OUT - margin) {
        return before != NO_HAND
                   ? make_goal(VBSS_SESSION_GOAL_EXPOSE_TIP, before)
                   : make_goal(VBSS_SESSION_GOAL_TAKE_NEEDLE, vbss_session_limb_hand(s));
    }
    return make_goal(VBSS_SESSION_GOAL_TAKE_TIP,
                     before != NO_HAND ? 1 - before : 1 - vbss_session_limb_hand(s));
}

/* The first throw crosses the ends over the slit, so the hand on the side of the first mark winds. True: another one has the needle. */
static bool find_goal_of_return(const session_object *s, session_goal *goal)
{
    uint32_t to = s->holes[SESSION_ENTRY].mark, from = 1 - to;
    if (s->throw_count > 0 || !holds_needle(s, from)) {
        return false;
    }
    *goal = holds_needle(s, to) ? make_goal(VBSS_SESSION_GOAL_RELEASE_NEEDLE, from)
                                : make_goal(VBSS_SESSION_GOAL_HAND_OVER, to);
    return true;
}

/* A tail that is drawn through turns may draw thread out of the drain: until it is released it is drawn on. */
static session_goal find_goal_of_tail(const session_object *s, const session_observation *observed)
{
    uint32_t hand = vbss_session_limb_hand(s);
    if (is_current(s, VBSS_SESSION_GOAL_DRAW_TAIL) && observed->tools[1 - hand].has_tail) {
        return make_goal(VBSS_SESSION_GOAL_DRAW_TAIL, 1 - hand);
    }
    session_goal goal;
    if (find_goal_of_return(s, &goal)) {
        return goal;
    }
    if (s->holding_tools.value == 0) {
        return make_goal(VBSS_SESSION_GOAL_TAKE_NEEDLE, hand);
    }
    return s->tail_length < s->config.tail_low
               ? make_goal(VBSS_SESSION_GOAL_LENGTHEN_TAIL, 1 - hand)
               : make_goal(VBSS_SESSION_GOAL_DRAW_THREAD, hand);
}

/* ---- throws, and transfers of the needle between them */

static session_goal find_goal_of_transfer(const session_object *s,
                                          const session_observation *observed)
{
    uint32_t to = vbss_session_taking_hand(s), from = 1 - to;
    if (observed->tools[to].held_arc >= 0.0) {
        return make_goal(VBSS_SESSION_GOAL_RELEASE_TAIL, to);
    }
    if (s->holding_tools.value == 3) {
        return make_goal(VBSS_SESSION_GOAL_RELEASE_NEEDLE, from);
    }
    return holds_needle(s, from) ? make_goal(VBSS_SESSION_GOAL_HAND_OVER, to)
                                 : make_goal(VBSS_SESSION_GOAL_TAKE_NEEDLE, to);
}

static session_goal find_goal_of_winding(const session_object *s, uint32_t limb, uint32_t loop)
{
    bool was_wound =
        is_current(s, VBSS_SESSION_GOAL_TAKE_TAIL) || is_current(s, VBSS_SESSION_GOAL_DRAW_TAIL);
    double turns = vbss_session_wanted_sign(s) * s->coach.turns[loop];
    /* Jaws that turn to the tail see fewer turns for a moment. */
    double beyond = was_wound ? SESSION_TURNS_BEYOND - SESSION_LOST_TURNS : SESSION_TURNS_BEYOND;
    double wanted = vbss_session_wanted_wraps(s) + beyond;
    bool ties_nothing = (s->coach.open & 1ull << VBSS_SESSION_MISTAKE_TOWARD_HANDLE) != 0;
    return turns > wanted && !ties_nothing ? make_goal(VBSS_SESSION_GOAL_TAKE_TAIL, loop)
                                           : make_goal(VBSS_SESSION_GOAL_WIND, limb);
}

static session_goal find_goal_of_throw(const session_object *s, const session_observation *observed)
{
    uint32_t limb = vbss_session_limb_hand(s), loop = 1 - limb;
    if (vbss_session_has_to_transfer(s)) {
        return find_goal_of_transfer(s, observed);
    }
    if (s->holding_tools.value == 0) {
        return make_goal(VBSS_SESSION_GOAL_TAKE_NEEDLE, limb);
    }
    bool holds_thread = observed->tools[loop].held_arc >= 0.0;
    session_goal goal;
    if (!holds_thread && find_goal_of_return(s, &goal)) {
        return goal;
    }
    /* A slit that opens meanwhile is closed by the next throw, once this is through. */
    double wound = is_current(s, VBSS_SESSION_GOAL_DRAW_TAIL) ? SESSION_THROUGH_TURNS
                   : is_current(s, VBSS_SESSION_GOAL_SEAT)    ? SESSION_REWOUND_TURNS
                                                              : SESSION_WOUND_TURNS;
    bool draws = observed->tools[loop].has_tail && fabs(s->coach.turns[loop]) > wound;
    if (vbss_session_has_to_seat(s) && !draws) {
        return holds_thread ? make_goal(VBSS_SESSION_GOAL_SEAT, loop)
                            : make_goal(VBSS_SESSION_GOAL_TAKE_TAIL, loop);
    }
    if (!holds_thread) {
        return find_goal_of_winding(s, limb, loop);
    }
    bool is_wrong = (s->coach.open & (1ull << VBSS_SESSION_MISTAKE_TOO_FEW_TURNS |
                                      1ull << VBSS_SESSION_MISTAKE_BIGHT)) != 0;
    /* The throw before was pulled once more, or the tail was made longer, without turns of the next one. */
    bool is_done =
        (is_current(s, VBSS_SESSION_GOAL_SEAT) || is_current(s, VBSS_SESSION_GOAL_RELEASE_TAIL) ||
         is_current(s, VBSS_SESSION_GOAL_LENGTHEN_TAIL)) &&
        !draws;
    return is_done || is_wrong || !observed->tools[loop].has_tail
               ? make_goal(VBSS_SESSION_GOAL_RELEASE_TAIL, loop)
               : make_goal(VBSS_SESSION_GOAL_DRAW_TAIL, loop);
}

/* The hand without the needle cuts, if it can. A throw whose tail is let go under tension springs open, so both ends get slack first. */
static session_goal find_goal_of_cut(const session_object *s, const session_observation *observed)
{
    for (uint32_t i = SESSION_TOOLS; i-- > 0;) {
        if (observed->tools[i].is_shears) {
            return make_goal(VBSS_SESSION_GOAL_CUT, i < SESSION_HANDS ? i : NO_HAND);
        }
    }
    uint32_t hand = s->holding_tools.value == 2 ? VBSS_METRICS_TOOL_LEFT : VBSS_METRICS_TOOL_RIGHT;
    bool has_tail = observed->tools[hand].held_arc >= 0.0;
    return make_goal(has_tail ? VBSS_SESSION_GOAL_RELEASE_TAIL : VBSS_SESSION_GOAL_TAKE_SHEARS,
                     hand);
}

session_goal vbss_session_find_goal(const session_object *s, const session_observation *observed)
{
    if (vbss_session_is_over(s)) {
        return make_goal(VBSS_SESSION_GOAL_NONE, NO_HAND);
    }
    switch (s->phase) {
    case VBSS_SESSION_PHASE_LOADING:
        return make_goal(VBSS_SESSION_GOAL_TAKE_NEEDLE, vbss_session_limb_hand(s));
    case VBSS_SESSION_PHASE_APPROACH:
        return find_goal_before_entry(s);
    case VBSS_SESSION_PHASE_IN_DRAIN:
        return make_goal(s->holding_tools.value == 0 ? VBSS_SESSION_GOAL_TAKE_NEEDLE
                                                     : VBSS_SESSION_GOAL_DRIVE,
                         vbss_session_limb_hand(s));
    case VBSS_SESSION_PHASE_PULL_THROUGH:
        return vbss_session_is_threaded(s) ? find_goal_of_tail(s, observed)
                                           : find_goal_of_needle(s, observed);
    case VBSS_SESSION_PHASE_THROW_1:
    case VBSS_SESSION_PHASE_THROW_2:
    case VBSS_SESSION_PHASE_THROW_3:
        return find_goal_of_throw(s, observed);
    case VBSS_SESSION_PHASE_TRANSFER_1:
    case VBSS_SESSION_PHASE_TRANSFER_2:
        return find_goal_of_transfer(s, observed);
    case VBSS_SESSION_PHASE_CUT:
        return find_goal_of_cut(s, observed);
    default:
        return make_goal(VBSS_SESSION_GOAL_NONE, NO_HAND);
    }
}
