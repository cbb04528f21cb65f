/* Records a scene by attaching a record, and replays the log without the code that made the scene.
 *
 * The first half is a host as any other: it makes a scene, edits and steps it. Attaching the record is its one extra call. The
 * second half has the bytes of the log and nothing else. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

typedef struct log_bytes {
    uint8_t *bytes;
    size_t count;
} log_bytes;

#define TRY(call)                      \
    do {                               \
        const vbss_result r_ = (call); \
        if (r_ != VBSS_OK) {           \
            return r_;                 \
        }                              \
    } while (0)

/* ---- the host */

/* A host would append these bytes to its file. */
static vbss_result take(vbss_record *record, log_bytes *log)
{
    const uint8_t *bytes;
    uint64_t count;
    TRY(vbss_record_take(record, &bytes, &count));
    uint8_t *more = realloc(log->bytes, log->count + (size_t)count);
    if (more == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    memcpy(more + log->count, bytes, (size_t)count);
    log->bytes = more;
    log->count += (size_t)count;
    return VBSS_OK;
}

static vbss_result add_thread(vbss_context *context, vbss_scene *scene, uint32_t *body)
{
    vbss_thread_config config = vbss_thread_config_default();
    vbss_thread *thread;
    config.segment_count = 30;
    config.length = 0.06;
    config.start[1] = 0.02;
    config.cut_capacity = 1;
    TRY(vbss_thread_create(context, &config, &thread));
    return vbss_scene_add_thread(scene, thread, body);
}

static vbss_result add_ball(vbss_scene *scene, uint32_t *body)
{
    const vbss_scene_capsule capsule = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 2e-3};
    vbss_scene_rigid_config config = vbss_scene_rigid_config_default();
    config.kind = VBSS_SCENE_RIGID_FREE;
    config.capsule_count = 1;
    config.capsules = &capsule;
    config.position[0] = 0.03;
    config.position[1] = 0.04;
    config.gravity[1] = -9.81;
    return vbss_scene_add_rigid(scene, &config, body);
}

/* What a host does with its scene, by the functions that it uses anyway. */
static vbss_result live(vbss_scene *scene, uint32_t thread, uint32_t step)
{
    uint32_t name;
    switch (step) {
    case 20:
        TRY(add_ball(scene, &name));
        break;
    case 120:
        TRY(vbss_scene_cut_thread(scene, thread, 0.045, &name));
        TRY(vbss_scene_remove(scene, name)); /* the end is taken away */
        break;
    default:
        break;
    }
    return vbss_scene_step(scene, 1e-3);
}

static vbss_result record(log_bytes *log, uint64_t *hash)
{
    vbss_context *context;
    vbss_scene *scene;
    vbss_record *recorder;
    vbss_scene_config config = vbss_scene_config_default();
    uint32_t thread, pin;
    config.floor = 1;
    TRY(vbss_context_create(NULL, &context));
    TRY(vbss_scene_create(context, &config, &scene));
    TRY(add_thread(context, scene, &thread));
    TRY(vbss_record_create(scene, NULL, &recorder));
    TRY(vbss_scene_set_recorder(scene, recorder)); /* from here on everything is in the log */
    TRY(vbss_scene_pin_thread(scene, thread, 0, 0, NULL, &pin));
    for (uint32_t i = 0; i < 200; i++) {
        TRY(live(scene, thread, i));
        TRY(take(recorder, log));
    }
    TRY(vbss_record_end(recorder));
    TRY(take(recorder, log));
    TRY(vbss_scene_get_hash(scene, hash));
    return vbss_context_destroy(context);
}

/* ---- anywhere else */

static vbss_result replay(const log_bytes *log, uint64_t *hash)
{
    vbss_context *context;
    vbss_replay *reader;
    vbss_scene *scene;
    vbss_replay_report report;
    uint32_t bodies;
    TRY(vbss_context_create(NULL, &context));
    TRY(vbss_replay_create(context, log->bytes, log->count, &reader));
    TRY(vbss_replay_load_scene(reader, &scene));
    do {
        TRY(vbss_replay_step(reader, &report, sizeof report));
    } while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    (void)vbss_scene_get_bodies(scene, NULL, 0, &bodies);
    printf("%s after %llu steps, %u bodies\n",
           report.outcome == VBSS_REPLAY_OUTCOME_ENDED ? "agrees" : "differs",
           (unsigned long long)report.step, bodies);
    TRY(vbss_scene_get_hash(scene, hash));
    TRY(vbss_replay_destroy(reader));
    TRY(vbss_scene_destroy(scene)); /* and the bodies that it was loaded with */
    return vbss_context_destroy(context);
}

int main(void)
{
    log_bytes log = {NULL, 0};
    uint64_t recorded = 0, replayed = 1;
    vbss_result result = record(&log, &recorded);
    if (result == VBSS_OK) {
        printf("a log of %lu bytes\n", (unsigned long)log.count);
        result = replay(&log, &replayed);
    }
    free(log.bytes);
    if (result != VBSS_OK) {
        printf("%s\n", vbss_result_name(result));
    }
    return result == VBSS_OK && recorded == replayed ? EXIT_SUCCESS : EXIT_FAILURE;
}
