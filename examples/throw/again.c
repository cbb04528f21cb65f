/* The knot once more from its log; and what is changed, in the log or in the scene, is told. */
#include <stdio.h>
#include <stdlib.h>

#include "throw/demo.h"
#include "throw/replay.h"

static bool same(const demo *d, const replay_log *log)
{
    replay_finding f = replay_run(&d->trial, log, false);
    bool good = f.equal && f.report.step == d->scene.steps && f.report.agreed_step == f.report.step;
    if (good) {
        printf("  replayed %llu steps into a fresh scene, all hashes equal (every %u steps; the "
               "last is %016llx)\n",
               (unsigned long long)f.report.step, (unsigned)f.interval,
               (unsigned long long)f.report.found_hash);
    } else {
        printf("  REPLAY DIFFERS: %llu of %llu steps: %s\n", (unsigned long long)f.report.step,
               (unsigned long long)d->scene.steps, f.text);
    }
    return good;
}

static bool reported_byte(const demo *d, const replay_log *log)
{
    size_t place = log->count / 4;
    log->data[place] ^= 1u;
    replay_finding f = replay_run(&d->trial, log, false);
    log->data[place] ^= 1u;
    printf("  one bit of byte %lu of the log changed: %s: %s\n", (unsigned long)place,
           f.equal ? "NOT TOLD" : "told", f.text);
    return !f.equal;
}

static bool reported_scene(const demo *d, const replay_log *log)
{
    replay_finding f = replay_run(&d->trial, log, true);
    bool reported = f.result == VBSS_OK && f.report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS;
    printf("  one pin of the scene taken out: %s: %s\n", reported ? "told" : "NOT TOLD", f.text);
    return reported;
}

bool demo_replay(const demo *d)
{
    replay_log log = replay_read(d->log);
    bool good = log.count > 0;
    if (!good) {
        printf("  the log %s cannot be read\n", d->log);
    } else {
        bool equal = same(d, &log), byte = reported_byte(d, &log), scene = reported_scene(d, &log);
        good = equal && byte && scene;
    }
    free(log.data);
    return good;
}
