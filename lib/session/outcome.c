/* The end of the task: both limbs are cut, or it has failed. */
#include "session/session.h"
#include "session/tuning.h"

void vbss_session_fail(session_object *s, vbss_session_failure failure)
{
    if (s->failure == VBSS_SESSION_FAILURE_NONE) {
        s->failure = failure;
        (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_FAILED, (uint32_t)failure, 0,
                                      VBSS_METRICS_TOOL_NONE);
    }
}

/* ---- cuts */

/* The hand whose shears are nearest to the cut. VBSS_METRICS_TOOL_NONE if the nearest shears are not
 * in a hand. */
static uint32_t find_cutting_tool(const session_observation *observed, vec3 cut_position)
{
    uint32_t nearest = VBSS_METRICS_TOOL_NONE;
    double min_distance = 0.0;
    for (uint32_t i = 0; i < SESSION_TOOLS; i++) {
        double distance = vec3_distance(observed->tools[i].tip, cut_position);
        if (observed->tools[i].is_shears &&
            (nearest == VBSS_METRICS_TOOL_NONE || distance < min_distance)) {
            nearest = i;
            min_distance = distance;
        }
    }
    return nearest < SESSION_HANDS ? nearest : VBSS_METRICS_TOOL_NONE;
}

/* Arc length at which the limb leaves the knot, or its hole if no knot is located, on the thread
 * before the cut, m. That thread was longer by `shift` at its first node. */
static double limb_root(const session_object *s, const session_observation *observed, uint32_t limb,
                        double shift)
{
    if (s->knot.is_located) {
        return s->knot.end_arcs[limb];
    }
    const session_hole_observation *hole = vbss_session_find_hole(observed, s->holes[limb].id);
    return hole != NULL ? hole->arc + shift : 0.0;
}

/* A cut between entry and exit leaves the two holes on different pieces. */
static bool is_stitch_divided(const session_object *s, const session_observation *observed)
{
    const session_hole_observation *in =
        vbss_session_find_hole(observed, s->holes[SESSION_ENTRY].id);
    const session_hole_observation *out =
        vbss_session_find_hole(observed, s->holes[SESSION_EXIT].id);
    return in != NULL && out != NULL && in->thread != 0 && out->thread != 0 &&
           in->thread != out->thread;
}

/* If the stitch is on a new piece, the needle's limb was cut; if the thread has become shorter, the
 * tail. */
void vbss_session_update_cuts(session_object *s, const session_observation *observed)
{
    double lost_length = s->thread_length - observed->thread_length;
    bool is_new = observed->thread != s->thread, is_length_known = s->thread_length > 0.0;
    double min_lost_length = SESSION_MIN_CUT_RATIO * s->thread_length;
    s->thread_length = observed->thread_length;
    if (!is_length_known || (!is_new && lost_length < min_lost_length)) {
        return;
    }
    uint32_t limb = is_new ? SESSION_EXIT : SESSION_ENTRY;
    double shift = is_new ? lost_length : 0.0;
    double root = limb_root(s, observed, limb, shift);
    double remaining = is_new ? root - lost_length : observed->thread_length - root;
    if (remaining < 0.0) { /* the detector may locate a crossing outside the knot */
        remaining = observed->free_length > 0.0 ? observed->free_length : remaining;
    }
    s->thread = observed->thread;
    s->knot.end_arcs[SESSION_ENTRY] -= shift;
    s->knot.end_arcs[SESSION_EXIT] -= shift;
    if (s->phase < VBSS_SESSION_PHASE_CUT) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_CUT_EARLY);
    } else if (remaining < 0.0 || is_stitch_divided(s, observed)) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_CUT_KNOT);
    } else {
        vec3 position = observed->thread_ends[limb];
        vbss_session_event *e = vbss_session_emit_event(s, VBSS_SESSION_EVENT_CUT, limb, 0,
                                                        find_cutting_tool(observed, position));
        vec3_store(e->position, position);
        e->amount = remaining;
        s->cut_limbs |= 1u << limb;
        if (s->cut_limbs == 3) {
            (void)vbss_session_emit_event(s, VBSS_SESSION_EVENT_DONE, 0, 0, VBSS_METRICS_TOOL_NONE);
        }
    }
}

/* ---- failures */

void vbss_session_update_failures(session_object *s, const session_observation *observed)
{
    const vbss_session_config *c = &s->config;
    bool is_overloaded = c->break_force > 0.0 && observed->max_tension > c->break_force;
    (void)vbss_session_debounce(&s->broken, is_overloaded, s->time, c->dwell);
    for (int k = 0; k < SESSION_SIDES; k++) {
        s->tension[k] = observed->tension[k];
    }
    s->gap = observed->gap;
    if (s->cut_limbs == 3) {
        return; /* the task was completed in this step */
    }
    if (s->broken.value != 0) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_BROKEN);
    } else if (observed->torn_fraction > 0.0 && observed->torn_fraction >= c->avulsed_share) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_AVULSED);
    } else if (s->time >= c->time_limit) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_TIMEOUT);
    }
}
