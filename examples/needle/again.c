/* The log of a trial, played back. */
#include <stdlib.h>

#include "needle/pass.h"
#include "throw/replay.h"

bool pass_replay(const pass_options *o)
{
    static stitch t;
    replay_log log = replay_read(o->log);
    bool equal = false;
    stitch_plan plan;
    stitch_plan_usual(&plan);
    memset(&t, 0, sizeof t);
    /* its hands for their tools alone */
    if (log.count > 0 && stitch_create(&t, o->seed, &plan) == VBSS_OK) {
        equal = replay_on(&t.site.rig, &log).equal;
    }
    free(log.data);
    throw_rig_destroy(&t.site.rig);
    return equal;
}
