/* Any bytes as a log: checked, read, replayed, sought in and gone on with. The first byte says how: 1 with right
 * checksums, 2 as the snapshot of a scene rather than a log, 4 of one with a drain, 8 of one
 * that a session follows. Whatever comes of it is a status, the counts of all
 * readers agree, and the scene can be brought back to where it was. */
#include <stdlib.h>
#include <string.h>

#include "fuzz/fuzz.h"

enum { SEALED = 1, SNAPSHOT = 2, DRAIN = 4, FOLLOWED = 8, MAX_STEPS = 12 };

typedef struct table {
    vbss_context *context;
    vbss_scene *scene;
    uint8_t *state; /* the scene's own, to come back to */
    uint64_t state_bytes, hash;
    vbss_session_config session; /* struct_size 0: there is none */
} table;

static void keep_state(table *t)
{
    MUST(vbss_scene_save(t->scene, NULL, 0, &t->state_bytes) == VBSS_ERROR_CAPACITY);
    t->state = malloc((size_t)t->state_bytes);
    MUST(t->state != NULL);
    MUST(vbss_scene_save(t->scene, t->state, t->state_bytes, &t->state_bytes) == VBSS_OK);
    MUST(vbss_scene_get_hash(t->scene, &t->hash) == VBSS_OK);
}

static void set_table(table *t, vbss_result (*create)(vbss_context *, vbss_scene **))
{
    MUST(vbss_context_create(NULL, &t->context) == VBSS_OK);
    MUST(create(t->context, &t->scene) == VBSS_OK);
    keep_state(t);
}

static void set_followed(table *t)
{
    MUST(vbss_context_create(NULL, &t->context) == VBSS_OK);
    MUST(session_scene_create(t->context, &t->scene, &t->session) == VBSS_OK);
    keep_state(t);
}

static void come_back(const table *t)
{
    uint64_t hash;
    MUST(vbss_scene_restore(t->scene, t->state, t->state_bytes) == VBSS_OK);
    MUST(vbss_scene_get_hash(t->scene, &hash) == VBSS_OK);
    MUST(hash == t->hash);
}

static void restore_and_step(const table *t, const uint8_t *bytes, size_t count)
{
    if (vbss_scene_restore(t->scene, bytes, count) == VBSS_OK) {
        for (int i = 0; i < 3; i++) {
            (void)vbss_scene_step(t->scene, 1e-3);
        }
    }
}

static void load_and_step(const table *t, const uint8_t *bytes, size_t count)
{
    vbss_scene *scene;
    const vbss_result result = vbss_scene_load(t->context, bytes, count, &scene);
    MUST((scene == NULL) == (result != VBSS_OK));
    if (result == VBSS_OK) {
        (void)vbss_scene_step(scene, 1e-3);
    }
    MUST(vbss_scene_destroy(scene) == VBSS_OK);
}

/* ---- without a scene */

static void read_steps(vbss_replay *replay, uint64_t steps, const vbss_record_log_report *report)
{
    uint64_t inputs = 0, events = 0, number = 0;
    vbss_replay_logged_step step;
    while (vbss_replay_read(replay, number + 1, &step, sizeof step) == VBSS_OK) {
        number++;
        MUST(step.number == number);
        inputs += step.input_count;
        events += step.event_count;
    }
    MUST(number == steps && inputs == report->inputs && events == report->events);
    MUST(number == 0 || vbss_replay_read(replay, 1, &step, sizeof step) == VBSS_OK);
}

/* ---- with a scene */

static void replay_some(vbss_replay *replay, uint64_t steps)
{
    vbss_replay_report report;
    for (int i = 0; i < MAX_STEPS; i++) {
        (void)vbss_replay_step(replay, &report, sizeof report);
        MUST(report.step <= steps);
        if (report.outcome != VBSS_REPLAY_OUTCOME_STEPPED) {
            return;
        }
    }
}

static void go_on(const table *t, vbss_replay *replay, uint64_t steps)
{
    vbss_replay_report report;
    vbss_record *record;
    uint64_t position, count;
    const uint8_t *taken;
    (void)vbss_replay_seek(replay, steps / 2, &report, sizeof report);
    vbss_result result = vbss_record_resume(replay, NULL, &record, &position);
    MUST((record == NULL) == (result != VBSS_OK));
    if (result == VBSS_OK) {
        const double at[3] = {0.0, 0.0, 0.0};
        (void)vbss_scene_set_recorder(t->scene, record);
        (void)vbss_scene_set_rigid_target(t->scene, 3, at, NULL);
        (void)vbss_scene_step(t->scene, 1e-3);
        MUST(vbss_record_end(record) == VBSS_OK);
        MUST(vbss_record_take(record, &taken, &count) == VBSS_OK && count > 0);
    }
    MUST(vbss_record_destroy(record) == VBSS_OK);
}

/* A session steps and seeks; what of it fails is a status, and it can always be saved. */
static void follow(const table *t, vbss_replay *replay, uint64_t steps)
{
    vbss_session_config config = t->session;
    vbss_session *session;
    uint64_t hash;
    MUST(vbss_replay_begin(replay, t->scene) == VBSS_OK);
    config.replay = replay;
    MUST(vbss_session_create(t->scene, &config, &session) == VBSS_OK);
    const uint64_t targets[] = {steps, 0, steps / 2, steps + 1};
    for (size_t i = 0; i < sizeof targets / sizeof targets[0]; i++) {
        (void)vbss_session_seek(session, targets[i]);
        MUST(vbss_session_get_hash(session, &hash) == VBSS_OK);
        (void)vbss_session_step(session, 0.0, 0.0);
    }
    MUST(vbss_session_get_hash(session, &hash) == VBSS_OK);
    MUST(vbss_session_destroy(session) == VBSS_OK);
}

/* A scene from the log alone replays some steps, or is refused. */
static void replay_loaded(vbss_replay *replay, uint64_t steps)
{
    vbss_scene *scene;
    const vbss_result result = vbss_replay_load_scene(replay, &scene);
    MUST((scene == NULL) == (result != VBSS_OK));
    if (result == VBSS_OK) {
        replay_some(replay, steps);
    }
    MUST(vbss_scene_destroy(scene) == VBSS_OK);
}

static void try_log(const table *t, const uint8_t *bytes, size_t count)
{
    vbss_record_log_report report;
    vbss_replay *replay;
    vbss_replay_info info;
    vbss_scene_config config;
    uint64_t steps = 0;
    MUST(vbss_record_check_log(t->context, bytes, count, &report, sizeof report) == VBSS_OK);
    MUST(report.good_bytes <= count && (report.fault_count == 0) == (report.result == VBSS_OK));
    vbss_result opened = vbss_replay_create(t->context, bytes, count, &replay);
    if (opened != VBSS_OK) {
        MUST(replay == NULL && report.result == opened);
        return;
    }
    MUST(vbss_replay_get_info(replay, &info, sizeof info) == VBSS_OK);
    MUST(vbss_scene_config_init(&config, sizeof config) == VBSS_OK);
    MUST(vbss_replay_get_scene_config(replay, &config) == VBSS_OK);
    MUST(vbss_replay_check(replay, &steps) == report.result && steps == report.steps);
    read_steps(replay, steps, &report);
    if (vbss_replay_begin(replay, t->scene) == VBSS_OK) {
        replay_some(replay, steps);
        if (steps <= MAX_STEPS) {
            if (t->session.struct_size != 0) {
                follow(t, replay, steps);
            }
            go_on(t, replay, steps);
        }
    }
    replay_loaded(replay, steps);
    MUST(vbss_replay_destroy(replay) == VBSS_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static table tables[3];
    if (tables[0].context == NULL) {
        set_table(&tables[0], small_scene_create);
        set_table(&tables[1], drain_scene_create);
        set_followed(&tables[2]);
    }
    if (size == 0) {
        return 0;
    }
    const table *t = &tables[(data[0] & FOLLOWED) != 0 ? 2 : (data[0] & DRAIN) != 0];
    size_t count = size - 1;
    uint8_t *bytes =
        malloc(count > 0 ? count : 1); /* of its own, so that a read beyond its end is told */
    MUST(bytes != NULL);
    memcpy(bytes, data + 1, count);
    if ((data[0] & SNAPSHOT) != 0) {
        if ((data[0] & SEALED) != 0) {
            seal_snapshot(bytes, count);
        }
        restore_and_step(t, bytes, count);
        load_and_step(t, bytes, count);
    } else {
        if ((data[0] & SEALED) != 0) {
            seal_log(bytes, count);
        }
        try_log(t, bytes, count);
    }
    free(bytes);
    come_back(t);
    return 0;
}
