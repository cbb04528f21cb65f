/* The log of a performance, played back: the scene, and its session. */
#include <stdlib.h>

#include "surgeon/watch.h"
#include "throw/replay.h"

static vbss_result play(const watch *w, stitch *t, const replay_log *log,
                        vbss_replay_report *report)
{
    vbss_replay *replay;
    task k;
    TRY(vbss_replay_create(t->site.rig.context, log->data, log->count, &replay));
    TRY(vbss_replay_begin(replay, t->site.rig.scene));
    const task_plan plan = surgeon_task_plan(&w->options);
    TRY(task_create_as(&k, t, NULL, replay, &plan));
    vbss_result result = VBSS_OK;
    while (result == VBSS_OK) {
        result = vbss_session_step(k.session, 0.0, 0.0);
    }
    TRY(result == VBSS_ERROR_WRONG_STATE ? VBSS_OK : result); /* at its end */
    return vbss_replay_step(replay, report, sizeof *report);
}

bool watch_replay(const watch *w)
{
    static stitch t; /* its hands for their tools alone */
    stitch_plan plan;
    replay_log log = replay_read(w->options.log);
    vbss_replay_report report = {.outcome = VBSS_REPLAY_OUTCOME_STOPPED};
    surgeon_plan(&w->options, &plan);
    memset(&t, 0, sizeof t);
    bool played = log.count > 0 && stitch_create(&t, w->options.seed, &plan) == VBSS_OK &&
                  play(w, &t, &log, &report) == VBSS_OK;
    free(log.data);
    throw_rig_destroy(&t.site.rig);
    return played && report.outcome == VBSS_REPLAY_OUTCOME_ENDED;
}
