/* The coach: goal and mistakes after each step, and what hosts see of them. */
#include "session/session.h"
#include "session/tuning.h"

static void update_goal(session_object *s, const session_observation *observed)
{
    session_coach *c = &s->coach;
    session_goal now = vbss_session_find_goal(s, observed);
    uint32_t code = (uint32_t)now.goal * SESSION_GOAL_TOOLS + now.tool;
    if (vbss_session_debounce(&c->goal, code, s->time,
                              vbss_session_is_over(s) ? 0.0 : s->config.dwell)) {
        c->goal_since = s->time;
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_GOAL, (uint32_t)now.goal, 0, now.tool);
        s->coach_event_count++;
    }
}

/* Turns in the sense that the next throw needs, toward the tip. Jaws that turn to the tail see the turns in any
 * order, so at a grasp the direction does not count. */
static double useful_turns(const session_object *s, uint32_t loop, bool grasps)
{
    double turns = vbss_session_wanted_sign(s) * s->coach.turns[loop];
    return s->coach.direction[loop] < 0 && !grasps ? 0.0 : vbss_max(turns, 0.0);
}

#define UNWINDING_MISTAKES \
    (1ull << VBSS_SESSION_MISTAKE_TOWARD_HANDLE | 1ull << VBSS_SESSION_MISTAKE_WRONG_SENSE)

static void store_turns(session_object *s, bool grasps, double turns)
{
    session_coach *c = &s->coach;
    bool is_tied = vbss_session_has_to_seat(s) || s->throw_count > c->throw_count;
    bool lengthens = vbss_session_current_goal(s).goal == VBSS_SESSION_GOAL_LENGTHEN_TAIL;
    if (grasps || is_tied) {
        c->grasped_turns = is_tied || lengthens ? SESSION_NOT_JUDGED : turns;
    }
    bool restarts = grasps || s->throw_count != c->throw_count || turns < SESSION_WOUND_TURNS;
    bool keeps = (c->observed & 1ull << VBSS_SESSION_MISTAKE_TURNS_LOST) != 0 && !grasps;
    if ((c->observed & UNWINDING_MISTAKES) != 0) {
        c->max_turns = SESSION_TO_BE_UNWOUND;
    } else if (restarts && !keeps) {
        c->max_turns = turns;
    } else if (c->max_turns >= 0.0) {
        c->max_turns = vbss_max(c->max_turns, turns);
    }
}

/* The next step compares its facts with these. */
static void store_facts(session_object *s, const session_observation *observed)
{
    session_coach *c = &s->coach;
    uint32_t loop = 1 - vbss_session_limb_hand(s), holding = 0;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        holding |= (uint32_t)(observed->tools[i].held_arc >= 0.0) << i;
    }
    bool grasps = (holding & ~c->holding_thread & 1u << loop) != 0;
    store_turns(s, grasps, useful_turns(s, loop, grasps));
    c->holding_thread = holding;
    if (s->throw_count > 0 && s->throw_count == s->seated_count &&
        c->seated_count < s->seated_count) {
        uint32_t newest = 1u << (s->throw_count - 1);
        bool are_crossed = vbss_session_are_crossed(s, observed, loop);
        c->from_behind = are_crossed ? c->from_behind | newest : c->from_behind & ~newest;
    }
    c->throw_count = s->throw_count;
    c->seated_count = s->seated_count;
    c->has_entry = s->holes[SESSION_ENTRY].id != 0;
    c->entry_threaded = s->holes[SESSION_ENTRY].threaded;
}

/* The step in which the task ends has events. */
void vbss_session_update_coach(session_object *s, const session_observation *observed)
{
    bool has_ended = vbss_session_is_over(s) && s->event_count == s->events_before_step;
    if (s->config.coaching == 0 || has_ended) {
        return;
    }
    if (!observed->has_lost_body) {
        vbss_session_update_mistakes(s, observed);
    }
    update_goal(s, observed);
    if (!observed->has_lost_body) {
        store_facts(s, observed);
    }
}

/* ---- what hosts see */

/* The observation of the last step is not part of a saved state. */
static void describe(const session_object *s, session_goal goal, vbss_session_coaching *coaching)
{
    session_observation observed;
    vbss_session_observe(s, &observed);
    if (observed.has_lost_body) {
        return;
    }
    vbss_session_describe_goal(s, &observed, goal, coaching);
    if (goal.goal == VBSS_SESSION_GOAL_SEAT &&
        vbss_session_pulls_from_behind(s, &observed, goal.tool)) {
        coaching->sentence = vbss_session_crossing_sentence(
            goal.tool, vbss_session_are_crossed(s, &observed, goal.tool));
    }
}

void vbss_session_fill_coaching(const session_object *s, vbss_session_coaching *coaching)
{
    const session_coach *c = &s->coach;
    session_goal goal = vbss_session_current_goal(s);
    coaching->goal = goal.goal;
    coaching->tool =
        goal.goal == VBSS_SESSION_GOAL_NONE ? VBSS_METRICS_TOOL_NONE : (vbss_metrics_tool)goal.tool;
    coaching->mistake = vbss_session_shown_mistake(s);
    coaching->is_mendable = vbss_session_is_mendable(s, coaching->mistake);
    coaching->mistake_sentence = vbss_session_mistake_string(coaching->mistake);
    bool builds_on =
        coaching->mistake == VBSS_SESSION_MISTAKE_SLIT_OPENED && vbss_session_builds_on(s);
    coaching->remedy =
        builds_on ? vbss_session_building_remedy() : vbss_session_remedy_string(coaching->mistake);
    coaching->mistakes = c->open;
    coaching->goal_time = s->time - c->goal_since;
    coaching->mistake_time = coaching->mistake != 0 ? c->begun[coaching->mistake] : 0.0;
    if (goal.goal != VBSS_SESSION_GOAL_NONE) {
        describe(s, goal, coaching);
    }
    bool is_over = (goal.tool == VBSS_METRICS_TOOL_RIGHT) == (vbss_session_wanted_sign(s) > 0.0);
    if (coaching->sentence == NULL) {
        coaching->sentence = vbss_session_goal_sentence(goal, coaching->number,
                                                        vbss_session_wanted_wraps(s), is_over);
    }
}

/* ---- state */

void vbss_session_visit_coach(vbss_stream *stream, session_object *s)
{
    session_coach *c = &s->coach;
    vbss_stream_u64(stream, 80, &c->observed, 1);
    vbss_stream_u64(stream, 80, &c->open, 1);
    vbss_stream_u64(stream, 80, &s->coach_event_count, 1);
    uint32_t *const words[] = {&c->goal.value,     &c->goal.candidate, &c->has_entry,
                               &c->entry_threaded, &c->holding_thread, &c->throw_count,
                               &c->seated_count,   &c->from_behind};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        vbss_stream_u32(stream, 81, words[i], 1);
    }
    vbss_stream_f64(stream, 82, &c->goal.since, 1);
    vbss_stream_f64(stream, 83, &c->goal_since, 1);
    vbss_stream_f64(stream, 84, c->since, VBSS_SESSION_MISTAKE_COUNT);
    vbss_stream_f64(stream, 85, c->begun, VBSS_SESSION_MISTAKE_COUNT);
    vbss_stream_f64(stream, 86, c->turns, SESSION_HANDS);
    vbss_stream_i32(stream, 87, c->direction, SESSION_HANDS);
    vbss_stream_i32(stream, 87, &c->next_wraps, 1);
    vbss_stream_f64(stream, 88, &c->max_turns, 1);
    vbss_stream_f64(stream, 89, &c->grasped_turns, 1);
    bool is_wrong = c->goal.value >= (VBSS_SESSION_GOAL_CUT + 1) * SESSION_GOAL_TOOLS ||
                    c->goal.candidate >= (VBSS_SESSION_GOAL_CUT + 1) * SESSION_GOAL_TOOLS ||
                    c->open >> VBSS_SESSION_MISTAKE_COUNT != 0 ||
                    c->observed >> VBSS_SESSION_MISTAKE_COUNT != 0 ||
                    s->coach_event_count > s->event_count;
    if (is_wrong && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no coach is like this");
    }
}
