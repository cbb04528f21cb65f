/* What has come of a try of the whole task, in one line. */
#include <stdio.h>

#include "surgeon/task.h"
#include "trainee/trainee.h"

enum { NOTATION = 32 };

typedef struct counts {
    uint32_t mistakes, drops, strays;
} counts;

static counts count_events(vbss_session *session, const vbss_session_status *status)
{
    counts c = {0};
    for (uint64_t i = status->first_event; i < status->event_count; i++) {
        vbss_session_event e;
        if (vbss_session_get_event(session, i, &e, sizeof e) != VBSS_OK) {
            continue;
        }
        c.mistakes += e.kind == VBSS_SESSION_EVENT_MISTAKE && e.undone == 0;
        c.drops += e.kind == VBSS_SESSION_EVENT_DROPPED;
        c.strays += e.kind == VBSS_SESSION_EVENT_STRAY && e.undone == 0;
    }
    return c;
}

bool trainee_report_task(const trainee *t, uint64_t seed)
{
    const task *k = &t->live.stage.task;
    vbss_session_status s;
    char notation[NOTATION] = "";
    (void)vbss_session_get_status(k->session, &s, sizeof s);
    (void)vbss_knot_detector_get_notation(k->knots, notation, sizeof notation);
    bool is_done = s.phase == VBSS_SESSION_PHASE_DONE;
    bool is_reached = s.phase >= t->until && s.phase != VBSS_SESSION_PHASE_FAILED;
    counts c = count_events(k->session, &s);
    printf("whole_task seed %lu: %s after %.1f s, aids %u: %s, %s; holes %.2f and %.2f mm off, gap "
           "%.2f mm, knot %s, %u of %u throws seated, %u transfers; largest tension %.2f N, force "
           "%.2f N; %u mistakes, %u drops, %u stray holes\n",
           (unsigned long)seed,
           is_done      ? "done"
           : is_reached ? "so far"
                        : "NOT DONE",
           s.time, (unsigned)s.aids_used, task_phase_name(s.phase), task_failure_name(s.failure),
           s.deviation_mm[0], s.deviation_mm[1], 1e3 * s.gap, notation, (unsigned)s.seated,
           (unsigned)s.throws, (unsigned)s.transfers, t->tension, t->force, (unsigned)c.mistakes,
           (unsigned)c.drops, (unsigned)c.strays);
    fflush(stdout);
    return is_done || is_reached;
}
