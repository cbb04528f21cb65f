#include "throw/replay.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

replay_log replay_read(const char *path)
{
    replay_log b = {NULL, 0};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return b;
    }
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    b.data = size > 0 && fseek(file, 0, SEEK_SET) == 0 ? malloc((size_t)size) : NULL;
    b.count = b.data != NULL ? fread(b.data, 1, (size_t)size, file) : 0;
    (void)fclose(file);
    return b;
}

static vbss_result play(throw_rig *s, const replay_log *log, bool changed, replay_finding *f)
{
    vbss_replay *replay;
    vbss_replay_info info;
    TRY(vbss_replay_create(s->context, log->data, log->count, &replay));
    TRY(vbss_replay_get_info(replay, &info, sizeof info));
    f->interval = info.hash_interval;
    TRY(vbss_replay_begin(replay, s->scene));
    if (changed) {
        TRY(vbss_scene_unpin_thread(s->scene, 1));
    }
    do {
        TRY(vbss_replay_step(replay, &f->report, sizeof f->report));
    } while (f->report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    f->equal = f->report.outcome == VBSS_REPLAY_OUTCOME_ENDED;
    return VBSS_OK;
}

replay_finding replay_on(throw_rig *s, const replay_log *log)
{
    replay_finding f;
    memset(&f, 0, sizeof f);
    f.result = play(s, log, false, &f);
    return f;
}

static vbss_result run(const trial_options *o, const replay_log *log, bool changed, throw_rig *s,
                       replay_finding *f)
{
    hand hands[2]; /* for their tools: the log says where these go */
    TRY(trial_set_up(o, s, hands));
    return play(s, log, changed, f);
}

replay_finding replay_run(const trial_options *o, const replay_log *log, bool changed)
{
    replay_finding f;
    throw_rig s;
    memset(&f, 0, sizeof f);
    memset(&s, 0, sizeof s);
    f.result = run(o, log, changed, &s, &f);
    if (f.result != VBSS_OK) {
        const char *text = "";
        if (s.context != NULL) {
            (void)vbss_context_get_last_error(s.context, NULL, &text);
        }
        snprintf(f.text, sizeof f.text, "%s: %s", vbss_result_name(f.result), text);
    } else if (!f.equal) {
        snprintf(f.text, sizeof f.text, "the hash after step %llu is %016llx, not %016llx",
                 (unsigned long long)f.report.step, (unsigned long long)f.report.found_hash,
                 (unsigned long long)f.report.recorded_hash);
    }
    throw_rig_destroy(&s);
    return f;
}

replay_finding replay_file(const trial_options *o)
{
    replay_log log = replay_read(o->log);
    replay_finding f = {.text = "the log cannot be read"};
    if (log.count > 0) {
        f = replay_run(o, &log, false);
    }
    free(log.data);
    return f;
}
