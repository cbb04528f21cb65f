/* The steps of a log made once more. (What is seen of them: look.c.) */
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

/* ---- with its session */

/* Where the session is not the recorded one the scene goes on without. */
static vbss_result step(again *a, stage *s, vbss_replay *replay)
{
    vbss_session_status status;
    if (s->task.session == NULL) {
        return vbss_replay_step(replay, &a->report, sizeof a->report);
    }
    vbss_result result = vbss_session_step(s->task.session, 0.0, 0.0);
    TRY(vbss_session_get_status(s->task.session, &status, sizeof status));
    if (status.steps > a->report.step) { /* the scene's step was made, and agrees */
        a->report.step++;
        a->session.agrees = result == VBSS_OK;
        return a->session.agrees ? VBSS_OK : task_destroy(&s->task);
    }
    return vbss_replay_step(replay, &a->report, sizeof a->report); /* where it is, once more */
}

/* ---- all of it */

static vbss_result play(facts *f, stage *s)
{
    again *a = &f->again;
    vbss_replay *replay;
    TRY(stage_create(s, f->info.note, f->info.note_bytes));
    TRY(vbss_replay_create(s->context, f->bytes, f->count, &replay));
    TRY(vbss_replay_begin(replay, s->scene));
    TRY(stage_follow_task(s, replay));
    TRY(facts_look_begin(f, s));
    for (;;) {
        double begin = now();
        TRY(step(a, s, replay));
        double spent = now() - begin;
        if (a->report.outcome != VBSS_REPLAY_STEPPED || a->report.step > f->steps) {
            return a->count > 0 && a->count == f->steps ? facts_look_end(f, s) : VBSS_OK;
        }
        TRY(stage_follow(s));
        TRY(facts_look(f, s, f->moments[a->report.step - 1].time, spent));
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
    vbss_result result = facts_look_at_session(f, &s);
    stage_destroy(&s);
    return result;
}
