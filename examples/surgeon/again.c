/* The log of a performance, played back. */
#include <stdlib.h>

#include "surgeon/watch.h"
#include "throw/replay.h"

bool watch_replay(const watch *w)
{
    static stitch t; /* its hands for their tools alone */
    stitch_plan plan;
    replay_log log = replay_read(w->options.log);
    bool equal = false;
    surgeon_plan(&w->options, &plan);
    memset(&t, 0, sizeof t);
    if (log.count > 0 && stitch_create(&t, w->options.seed, &plan) == VBSS_OK) {
        equal = replay_on(&t.site.stand, &log).equal;
    }
    free(log.data);
    stand_destroy(&t.site.stand);
    return equal;
}
