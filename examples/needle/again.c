/* The log of a trial, played back. */
#include <stdlib.h>

#include "needle/pass.h"
#include "throw/replay.h"

static vbss_result replay(stitch *t, const pass_options *o, const replay_log *log, bool *equal)
{
    vbss_replay *replay;
    vbss_replay_report report;
    stitch_plan plan;
    stitch_plan_usual(&plan);
    TRY(stitch_create(t, o->seed, &plan)); /* its hands for their tools alone */
    TRY(vbss_replay_create(t->site.stand.context, log->data, log->count, &replay));
    TRY(vbss_replay_begin(replay, t->site.stand.scene));
    do {
        TRY(vbss_replay_step(replay, &report, sizeof report));
    } while (report.outcome == VBSS_REPLAY_STEPPED);
    *equal = report.outcome == VBSS_REPLAY_ENDED;
    return VBSS_OK;
}

bool pass_replay(const pass_options *o)
{
    static stitch t;
    replay_log log = replay_read(o->log);
    bool equal = false;
    memset(&t, 0, sizeof t);
    bool good = log.count > 0 && replay(&t, o, &log, &equal) == VBSS_OK;
    free(log.data);
    stand_destroy(&t.site.stand);
    return good && equal;
}
