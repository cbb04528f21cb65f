#include "surgeon/mistake.h"

#include <string.h>

#define MIN_MISSED 2.0 /* mm: 3, with what the walls give way */
#define MAX_MISSED 6.0

static const struct {
    const char *name, *wanted;
} mistakes[] = {
    [SURGEON_NO_MISTAKE] = {"", ""},
    [SURGEON_WITHDRAWN] = {"withdrawn",
                           "the hole is left, an attempt, and the first mark is asked for again"},
    [SURGEON_MISSED] = {"missed", "both holes 2 to 6 mm off their marks"},
    [SURGEON_TORN] = {"torn", "failed: the drain was torn off"},
    [SURGEON_IDLE] = {"idle", "failed: the time is up"},
    [SURGEON_KEPT] = {"kept", "throw 2 without the needle having changed hands"},
    [SURGEON_SLACK] = {"slack", "throw 1 is tied and not seated, and is asked for still"},
};
enum { MISTAKES = sizeof mistakes / sizeof mistakes[0] };

const char *surgeon_mistake_name(surgeon_mistake mistake)
{
    return mistakes[mistake].name;
}

const char *surgeon_mistake_wanted(surgeon_mistake mistake)
{
    return mistakes[mistake].wanted;
}

surgeon_mistake surgeon_mistake_named(const char *name)
{
    int i = 1;
    while (i < MISTAKES && strcmp(mistakes[i].name, name) != 0) {
        i++;
    }
    return i < MISTAKES ? (surgeon_mistake)i : SURGEON_NO_MISTAKE;
}

/* Whether there was an event of that kind and number. */
static bool happened(vbss_session *session, const vbss_session_status *s,
                     vbss_session_event_kind kind, uint32_t number, uint32_t undone)
{
    bool found = false;
    for (uint64_t i = s->first_event; i < s->event_count; i++) {
        vbss_session_event e;
        bool got = vbss_session_get_event(session, i, &e, sizeof e) == VBSS_OK;
        found = found || (got && e.kind == kind && e.number == number && e.undone == undone);
    }
    return found;
}

static bool is_missed(double deviation)
{
    return deviation > MIN_MISSED && deviation < MAX_MISSED;
}

static bool is_coached(vbss_session *session, const vbss_session_status *s,
                       vbss_session_mistake mistake)
{
    return happened(session, s, VBSS_SESSION_EVENT_MISTAKE, (uint32_t)mistake, 0);
}

/* The coach says so, too. It would say of a slack throw in five seconds only. */
static bool is_coached_as(surgeon_mistake mistake, vbss_session *session,
                          const vbss_session_status *s)
{
    switch (mistake) {
    case SURGEON_WITHDRAWN:
        return is_coached(session, s, VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN);
    case SURGEON_MISSED:
        return is_coached(session, s, VBSS_SESSION_MISTAKE_ENTRY_MISSED) &&
               is_coached(session, s, VBSS_SESSION_MISTAKE_EXIT_MISSED);
    case SURGEON_TORN:
        return is_coached(session, s, VBSS_SESSION_MISTAKE_DRAIN_TEARING) &&
               is_coached(session, s, VBSS_SESSION_MISTAKE_DRAIN_TORN);
    case SURGEON_IDLE:
        return is_coached(session, s, VBSS_SESSION_MISTAKE_TIME_UP);
    case SURGEON_KEPT:
        return is_coached(session, s, VBSS_SESSION_MISTAKE_TRANSFER_MISSED);
    default:
        return true;
    }
}

bool surgeon_mistake_is_reported(surgeon_mistake mistake, vbss_session *session,
                                 vbss_metrics *metrics)
{
    vbss_session_status s;
    vbss_metrics_report r;
    if (vbss_session_get_status(session, &s, sizeof s) != VBSS_OK ||
        vbss_metrics_get_report(metrics, &r, sizeof r) != VBSS_OK) {
        return false;
    }
    if (!is_coached_as(mistake, session, &s)) {
        return false;
    }
    switch (mistake) {
    case SURGEON_WITHDRAWN:
        return s.phase == VBSS_SESSION_PHASE_APPROACH && s.punctured == 0 && r.attempts[0] == 1 &&
               happened(session, &s, VBSS_SESSION_EVENT_PUNCTURE, 0, 1);
    case SURGEON_MISSED:
        return s.punctured == 3 && is_missed(s.deviation_mm[0]) && is_missed(s.deviation_mm[1]) &&
               is_missed(r.deviation_mm[0]) && is_missed(r.deviation_mm[1]);
    case SURGEON_TORN:
        return s.phase == VBSS_SESSION_PHASE_FAILED && s.failure == VBSS_SESSION_FAILURE_AVULSED &&
               r.score == 0.0;
    case SURGEON_IDLE:
        return s.phase == VBSS_SESSION_PHASE_FAILED && s.failure == VBSS_SESSION_FAILURE_TIMEOUT &&
               r.score == 0.0;
    case SURGEON_SLACK:
        return s.phase == VBSS_SESSION_PHASE_THROW_1 && s.throws == 1 && s.seated == 0 &&
               !happened(session, &s, VBSS_SESSION_EVENT_SEATED, 0, 0);
    case SURGEON_KEPT:
        return happened(session, &s, VBSS_SESSION_EVENT_TRANSFER_MISSED, 1, 0) && r.transfers == 0;
    default:
        return false;
    }
}
