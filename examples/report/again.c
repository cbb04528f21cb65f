/* The steps of a log made once more. (What is seen of them: observe.c.) */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "report/stage.h"

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static vbss_result play(facts *f, stage *s)
{
    again *a = &f->again;
    vbss_replay *replay;
    TRY(stage_create(s, f->info.note, f->info.note_bytes));
    TRY(vbss_replay_create(s->context, f->bytes, f->count, &replay));
    TRY(stage_begin(s, replay, f->tools));
    TRY(stage_follow_task(s, replay));
    TRY(facts_observe_begin(f, s));
    for (;;) {
        bool agrees = true;
        double begin = now();
        TRY(stage_step(s, replay, &a->report, &agrees));
        double cpu_time = now() - begin;
        a->session.agrees = a->session.agrees && agrees;
        if (a->report.outcome != VBSS_REPLAY_OUTCOME_STEPPED || a->report.step > f->steps) {
            return VBSS_OK;
        }
        TRY(stage_follow(s));
        TRY(facts_observe(f, s, f->moments[a->report.step - 1].time, cpu_time));
        TRY(a->count == f->steps ? facts_observe_end(f, s) : VBSS_OK);
    }
}

vbss_result facts_again(facts *f)
{
    static stage s;
    again *a = &f->again;
    if (!a->asked || !stage_knows(f->info.note, f->info.note_bytes)) {
        return VBSS_OK;
    }
    a->result = play(f, &s);
    if (a->result != VBSS_OK) {
        const char *text = "";
        if (s.context != NULL) {
            (void)vbss_context_get_last_error(s.context, NULL, &text);
        }
        snprintf(a->problem, sizeof a->problem, "%s", text);
    }
    vbss_result result = facts_observe_session(f, &s);
    stage_destroy(&s);
    return result;
}
