/* What the session says of a stitch. */
#include <stdio.h>

#include "surgeon/watch.h"

static void tell_measures(const watch *w)
{
    vbss_metrics_report r;
    if (vbss_metrics_get_report(w->task.metrics, &r, sizeof r) != VBSS_OK) {
        return;
    }
    printf("  measured: holes %.2f and %.2f mm off, gap %.2f mm, %u throws, %u of them square, "
           "%u drops, %u transfers; %.1f s, %.1f points in the style of MISTELS%s; tightness %s\n",
           r.deviation_mm[0], r.deviation_mm[1], r.gap_mm, (unsigned)r.throw_count,
           (unsigned)r.square_count, (unsigned)r.drops, (unsigned)r.transfers, r.time, r.score,
           (r.flags & VBSS_METRICS_FINAL) != 0 ? "" : ", provisional",
           r.tightness_ours == VBSS_METRICS_TIGHTNESS_UNKNOWN ? "not tested" : "tested");
}

/* Stages of throws come and go while hands wind: they are told to who wants all. */
static void tell_events(const watch *w, const vbss_session_status *s)
{
    for (uint64_t i = s->first_event; i < s->event_count; i++) {
        vbss_session_event e;
        char words[TASK_WORDS];
        if (vbss_session_get_event(w->task.session, i, &e, sizeof e) != VBSS_OK ||
            (e.kind == VBSS_SESSION_EVENT_STAGE && !w->verbose)) {
            continue;
        }
        task_words(&e, words);
        printf("  %7.3f s  step %6lu  %s\n", e.time, (unsigned long)e.step, words);
    }
}

void watch_tell_task(const watch *w)
{
    vbss_session_status s;
    if (w->task.session == NULL ||
        vbss_session_get_status(w->task.session, &s, sizeof s) != VBSS_OK) {
        return;
    }
    printf("  session: phase '%s' after %.2f s; %u throws tied, %u seated; %lu events\n",
           task_phase_name(s.phase), s.time, (unsigned)s.throws, (unsigned)s.seated,
           (unsigned long)s.event_count);
    tell_measures(w);
    tell_events(w, &s);
    fflush(stdout);
}
