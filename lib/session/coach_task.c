/* Queries of the coach about the task, and its reading of the detector. */
#include "base/error.h"
#include "session/session.h"

#define NO_HAND ((uint32_t)VBSS_METRICS_TOOL_NONE)

uint32_t vbss_session_limb_hand(const session_object *s)
{
    uint32_t holding = s->holding_tools.value;
    uint32_t hand = holding == 1 ? 0 : holding == 2 ? 1 : s->last_holder;
    return hand == NO_HAND ? VBSS_METRICS_TOOL_RIGHT : hand;
}

/* The slit gapes under the newest throw, which was seated. Pulled once more such a throw comes no tighter; the next one, tied on it,
 * draws both together. The last throw has no next one. */
bool vbss_session_builds_on(const session_object *s)
{
    bool has_opened = (s->coach.observed & 1ull << VBSS_SESSION_MISTAKE_SLIT_OPENED) != 0 ||
                      s->seated_count < s->coach.seated_count;
    return s->throw_count > s->seated_count && s->throw_count <= SESSION_TRANSFERS && has_opened;
}

bool vbss_session_has_to_seat(const session_object *s)
{
    return s->throw_count > s->seated_count && !vbss_session_builds_on(s);
}

uint32_t vbss_session_next_throw(const session_object *s)
{
    return vbss_session_has_to_seat(s) ? s->throw_count - 1 : s->throw_count;
}

uint32_t vbss_session_wanted_wraps(const session_object *s)
{
    bool is_single = s->config.exercise == VBSS_SESSION_EXERCISE_SINGLE_THROW;
    return vbss_session_next_throw(s) == 0 && !is_single ? 2 : 1;
}

/* Turns w > 0 tie a left-handed throw, and handedness has to alternate. The first throw is wound over the
 * top of the tool, which is to the right of the left tool's jaws and to the left of the right one's. */
double vbss_session_wanted_sign(const session_object *s)
{
    uint32_t number = vbss_session_next_throw(s);
    int32_t before = number > 0 ? s->throws[number - 1].value.handedness : 0;
    if (before != 0) {
        return before;
    }
    return vbss_session_limb_hand(s) == VBSS_METRICS_TOOL_RIGHT ? 1.0 : -1.0;
}

uint32_t vbss_session_taking_hand(const session_object *s)
{
    uint32_t tied_by = s->throw_count > 0 ? s->tied_by[s->throw_count - 1] : NO_HAND;
    return 1 - (tied_by == NO_HAND ? vbss_session_limb_hand(s) : tied_by);
}

bool vbss_session_has_to_transfer(const session_object *s)
{
    uint32_t count = s->throw_count;
    return count > 0 && count <= SESSION_TRANSFERS && !vbss_session_has_to_seat(s) &&
           (s->transferred >> (count - 1) & 1u) == 0;
}

vbss_result vbss_session_read_winding(session_object *s)
{
    vbss_knot_state state;
    if (s->config.coaching != 0) {
        VBSS_TRY(vbss_knot_detector_get_state(s->config.knots, &state, sizeof state));
        s->coach.next_wraps = state.next_wraps;
    }
    for (uint32_t i = 0; i < SESSION_HANDS && s->config.coaching != 0; i++) {
        vbss_knot_winding w;
        VBSS_TRY(vbss_knot_detector_get_winding(s->config.knots, i, &w, sizeof w));
        s->coach.turns[i] = w.run_turns;
        s->coach.direction[i] = w.sense;
    }
    return VBSS_OK;
}
