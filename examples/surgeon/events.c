/* What happened in a stitch, as its session says. */
#include <stdio.h>

#include "surgeon/watch.h"

/* Stages of throws come and go while hands wind: they are told to who wants all. */
void watch_report_events(const watch *w)
{
    const vbss_session_status *s = &w->status;
    printf("  %lu events:\n", (unsigned long)s->event_count);
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
    fflush(stdout);
}
