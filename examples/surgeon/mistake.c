#include "surgeon/mistake.h"

#include <string.h>

#define MIN_MISSED 2.0 /* mm: 3, with what the walls give way */
#define MAX_MISSED 6.0

#define COACHED(name) VBSS_SESSION_MISTAKE_##name

static const struct {
    const char *name, *wanted;
    throw_mistake in_throw;
    vbss_session_mistake coached;
    surgeon_remedy remedy;
} mistakes[] = {
    [SURGEON_NO_MISTAKE] = {"", "", THROW_NO_MISTAKE, COACHED(NONE), REMEDY_FAILED},
    [SURGEON_WITHDRAWN] = {"withdrawn",
                           "the hole is left, an attempt, and the first mark is asked for again",
                           THROW_NO_MISTAKE, COACHED(NEEDLE_WITHDRAWN), REMEDY_WORKS},
    [SURGEON_MISSED] = {"missed", "both holes 2 to 6 mm off their marks", THROW_NO_MISTAKE,
                        COACHED(ENTRY_MISSED), REMEDY_WORKS},
    [SURGEON_TORN] = {"torn", "failed: the drain was torn off", THROW_NO_MISTAKE,
                      COACHED(DRAIN_TEARING), REMEDY_WORKS},
    [SURGEON_IDLE] = {"idle", "failed: the time is up", THROW_NO_MISTAKE, COACHED(TIME_UP),
                      REMEDY_FAILED},
    [SURGEON_SLACK] = {"slack", "throw 1 is tied and not seated, and is asked for still",
                       THROW_SLACK, COACHED(SLACK), REMEDY_WORKS},
    [SURGEON_KEPT] = {"kept", "throw 2 without the needle having changed hands", THROW_NO_MISTAKE,
                      COACHED(TRANSFER_MISSED), REMEDY_NONE},
    [SURGEON_GRANNY] = {"granny", "throw 2 is wound in the sense of throw 1", THROW_REVERSED,
                        COACHED(WRONG_SENSE), REMEDY_WORKS},
    [SURGEON_HANDLE] = {"handle", "turns that run toward the handle", THROW_TO_HANDLE,
                        COACHED(TOWARD_HANDLE), REMEDY_WORKS},
    [SURGEON_COUNTER] = {"counter", "turns that have come off", THROW_COUNTER, COACHED(TURNS_LOST),
                         REMEDY_WORKS},
    [SURGEON_BIGHT] = {"bight", "a tail that is taken far from its end", THROW_BIGHT,
                       COACHED(BIGHT), REMEDY_WORKS},
    [SURGEON_DROPPED] = {"dropped", "a tail that is let go before it is through", THROW_DROPPED,
                         COACHED(TAIL_DROPPED), REMEDY_WORKS},
    [SURGEON_ONE_SIDED] = {"one-sided", "a pull at one end alone", THROW_ONE_SIDED,
                           COACHED(ONE_SIDED), REMEDY_WORKS},
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

throw_mistake surgeon_mistake_in_throw(surgeon_mistake mistake)
{
    return mistakes[mistake].in_throw;
}

vbss_session_mistake surgeon_mistake_coached(surgeon_mistake mistake)
{
    return mistakes[mistake].coached;
}

surgeon_remedy surgeon_mistake_remedy(surgeon_mistake mistake)
{
    return mistakes[mistake].remedy;
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
    return mistake == SURGEON_SLACK ||
           (is_coached(session, s, mistakes[mistake].coached) &&
            (mistake != SURGEON_MISSED || is_coached(session, s, COACHED(EXIT_MISSED))) &&
            (mistake != SURGEON_TORN || is_coached(session, s, COACHED(DRAIN_TORN))));
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
    case SURGEON_NO_MISTAKE:
        return false;
    default:
        return true; /* only the coach gives it a name */
    }
}

bool surgeon_mistake_is_mended(surgeon_mistake mistake, vbss_session *session)
{
    vbss_session_status s;
    vbss_session_coaching c;
    const vbss_session_mistake coached = mistakes[mistake].coached;
    if (vbss_session_get_status(session, &s, sizeof s) != VBSS_OK ||
        vbss_session_get_coaching(session, &c, sizeof c) != VBSS_OK ||
        !is_coached(session, &s, coached)) {
        return false;
    }
    const bool is_open = (c.mistakes >> coached & 1u) != 0;
    const bool has_failed = s.phase == VBSS_SESSION_PHASE_FAILED;
    return mistakes[mistake].remedy == REMEDY_FAILED  ? has_failed && is_open
           : mistakes[mistake].remedy == REMEDY_WORKS ? !has_failed && !is_open
                                                      : !has_failed && is_open;
}
