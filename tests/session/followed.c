#include "followed.h"

#include "base/little_endian.h"

#define STATE VBSS_CODE('s', 't', 'a', 't')

void trial_begin(session_trial *t)
{
    memset(t, 0, sizeof *t);
    t->context = harness_context(&t->memory);
    expect_ok(session_scene_tying(t->context, 5, &t->scene));
}

void trial_start(session_trial *t)
{
    expect_ok(vbss_session_create(t->scene.scene, &t->scene.config, &t->session));
}

void trial_end(session_trial *t)
{
    harness_context_end(t->context, &t->memory);
}

static void trial_note(const session_trial *t, trial_log *is, uint32_t step)
{
    expect_ok(vbss_scene_get_hash(t->scene.scene, &is->scenes[step]));
    expect_ok(vbss_session_get_hash(t->session, &is->sessions[step]));
}

void trial_expect_at(const session_trial *t, const trial_log *was, uint32_t step)
{
    static trial_log is;
    trial_note(t, &is, step);
    assert_true(is.scenes[step] == was->scenes[step]);
    assert_true(is.sessions[step] == was->sessions[step]);
}

void trial_begin_record(session_trial *t)
{
    vbss_record_config c;
    expect_ok(vbss_record_config_init(&c, sizeof c));
    c.snapshot_interval = TRIAL_SNAPSHOTS;
    expect_ok(vbss_record_create(t->scene.scene, &c, &t->scene.config.record));
}

static void record_trial(trial_log *was, bool plain)
{
    static session_trial t;
    record_object *r;
    memset(was, 0, sizeof *was);
    trial_begin(&t);
    trial_begin_record(&t);
    expect_ok(vbss_record_edit(t.scene.config.record, &r));
    r->log.format = plain ? 2 : r->log.format;
    trial_start(&t);
    log_take(&was->log, t.scene.config.record);
    was->ends[0] = was->log.count;
    trial_note(&t, was, 0);
    for (uint32_t i = 1; i <= TRIAL_STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, t.scene.config.record));
        log_take(&was->log, t.scene.config.record);
        was->ends[i] = was->log.count;
        trial_note(&t, was, i);
    }
    expect_ok(vbss_record_end(t.scene.config.record));
    log_take(&was->log, t.scene.config.record);
    trial_end(&t);
}

void trial_record(trial_log *was)
{
    record_trial(was, false);
}

void trial_record_plain(trial_log *was)
{
    record_trial(was, true);
}

void trial_follow(session_trial *t, const log_bytes *log)
{
    trial_begin(t);
    expect_ok(vbss_replay_create(t->context, log->bytes, log->count, &t->scene.config.replay));
    expect_ok(vbss_replay_begin(t->scene.config.replay, t->scene.scene));
    trial_start(t);
}

uint32_t trial_find_states(const log_bytes *log, state_place *last)
{
    uint32_t count = 0, steps = 0;
    for (size_t at = 8; at < log->count;) {
        if ((log->bytes[at + 3] & 0xc0u) == 0xc0u) { /* a coded step */
            at += 12 + (size_t)load_little_endian(log->bytes + at, 2);
            steps++;
            continue;
        }
        size_t length = (size_t)load_little_endian(log->bytes + at, 4);
        uint32_t found = (uint32_t)load_little_endian(log->bytes + at + 12, 4);
        steps += found == VBSS_CODE('S', 'T', 'E', 'P');
        if (found == STATE) {
            *last = (state_place){at + 8, length, steps};
            count++;
        }
        at += length + 16;
    }
    return count;
}
