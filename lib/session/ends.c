/* How the task ends: both tails are cut, or it has failed. */
#include "session/session.h"

/* Less than this a thread does not lose in a cut, m: blades do not slice off less than it is thick. */
#define LEAST_CUT 1e-6

void vbss_session_fail(session_object *s, vbss_session_failure failure)
{
    if (s->failure == VBSS_SESSION_FAILURE_NONE) {
        s->failure = failure;
        (void)vbss_session_tell(s, VBSS_SESSION_EVENT_FAILED, (uint32_t)failure, 0,
                                VBSS_METRICS_NO_TOOL);
    }
}

/* ---- cuts */

/* The hand whose blades are nearest to where it was cut. */
static uint32_t cutter(const session_look *look, vec3 at)
{
    uint32_t nearest = VBSS_METRICS_NO_TOOL;
    double least = 0.0;
    for (uint32_t i = 0; i < SESSION_TOOLS; i++) {
        double distance = vec3_distance(look->tools[i].tip, at);
        if (look->tools[i].cuts && (nearest == VBSS_METRICS_NO_TOOL || distance < least)) {
            nearest = i;
            least = distance;
        }
    }
    return nearest < SESSION_HANDS ? nearest : VBSS_METRICS_NO_TOOL;
}

/* Where each limb begins at the knot, or at its hole while no knot is known, on the thread before the cut, which is
 * `shift` longer at its begin. */
static double root_of(const session_object *s, const session_look *look, uint32_t limb,
                      double shift)
{
    if (s->knot.located) {
        return s->knot.ends[limb];
    }
    const session_hole_look *hole = vbss_session_find_hole(look, s->holes[limb].id);
    return hole != NULL ? hole->arc + shift : 0.0;
}

/* A cut that divides the stitch leaves its holes on two pieces. */
static bool is_parted(const session_object *s, const session_look *look)
{
    const session_hole_look *in = vbss_session_find_hole(look, s->holes[SESSION_IN].id);
    const session_hole_look *out = vbss_session_find_hole(look, s->holes[SESSION_OUT].id);
    return in != NULL && out != NULL && in->thread != 0 && out->thread != 0 &&
           in->thread != out->thread;
}

/* The tail is cut when the thread has lost its end, the needle's limb when what goes through the drain is a new piece. */
void vbss_session_judge_cuts(session_object *s, const session_look *look)
{
    double lost = s->length - look->length;
    bool is_new = look->thread != s->thread, known = s->length > 0.0;
    s->length = look->length;
    if (!known || (!is_new && lost < LEAST_CUT)) {
        return;
    }
    uint32_t limb = is_new ? SESSION_OUT : SESSION_IN;
    double shift = is_new ? lost : 0.0;
    double root = root_of(s, look, limb, shift);
    double left = is_new ? root - lost : look->length - root;
    s->thread = look->thread;
    s->knot.ends[SESSION_IN] -= shift;
    s->knot.ends[SESSION_OUT] -= shift;
    if (s->phase < VBSS_SESSION_PHASE_CUT) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_CUT_EARLY);
    } else if (left < 0.0 || is_parted(s, look)) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_CUT_KNOT);
    } else {
        vec3 at = look->thread_ends[limb];
        vbss_session_event *e =
            vbss_session_tell(s, VBSS_SESSION_EVENT_CUT, limb, 0, cutter(look, at));
        vec3_store(e->position, at);
        e->amount = left;
        s->cut |= 1u << limb;
        if (s->cut == 3) {
            (void)vbss_session_tell(s, VBSS_SESSION_EVENT_DONE, 0, 0, VBSS_METRICS_NO_TOOL);
        }
    }
}

/* ---- failures */

void vbss_session_judge_failures(session_object *s, const session_look *look)
{
    const vbss_session_config *c = &s->config;
    bool breaks = c->break_force > 0.0 && look->most_tension > c->break_force;
    (void)vbss_session_settle(&s->broken, breaks, s->time, c->dwell);
    for (int k = 0; k < SESSION_MARKS; k++) {
        s->tension[k] = look->tension[k];
    }
    s->gap = look->gap;
    if (s->cut == 3) {
        return; /* complete, in the same step */
    }
    if (s->broken.value != 0) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_BROKEN);
    } else if (look->torn > 0.0 && look->torn >= c->avulsed_share) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_AVULSED);
    } else if (s->time >= c->time_limit) {
        vbss_session_fail(s, VBSS_SESSION_FAILURE_TIMEOUT);
    }
}
