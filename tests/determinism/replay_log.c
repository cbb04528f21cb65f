/* Short logs, hashed after each step, and their replay: the library and this program only, so that they are written by
 * one build and replayed by others, also on other machines.
 *
 *     replay_log write FOLDER    <scene>.vbss of each scene below
 *     replay_log FILE            of a file of that name; prints its scene, steps made, and the first that differs or 0 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

#include "base/error.h"
#include "fuzz/fuzz.h"
#include "fixtures/stitch_scenes.h"

enum { ROOM = 1 << 22, TOOL_STEPS = 200, STITCH_STEPS = 60 };

/* ---- the scenes: what is there, and what it is told before a step */

typedef vbss_result (*maker)(vbss_context *context, vbss_scene **scene);
typedef vbss_result (*driver)(vbss_scene *scene, uint32_t step);

static stitch_scene stitch;
static uint32_t probe;

/* A throw above the slit of a drain, drawn at by both ends, and a ball that pushes the wall in beside it. */
static vbss_result make_stitch(vbss_context *context, vbss_scene **scene)
{
    const vbss_scene_capsule ball = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 2e-3};
    static stitch_scene_options options;
    vbss_scene_rigid_config c;
    VBSS_TRY(stitch_scene_init(&options));
    options.crossings = 3;
    options.segment = 1e-3;
    options.limb = 15e-3;
    VBSS_TRY(stitch_scene_create(context, &options, &stitch));
    VBSS_TRY(vbss_scene_rigid_config_init(&c, sizeof c));
    c.kind = VBSS_SCENE_RIGID_COUPLED;
    c.capsules = &ball;
    c.capsule_count = 1;
    c.position[0] = 10e-3;
    c.position[1] = 9.5e-3;
    *scene = stitch.scene;
    return vbss_scene_add_rigid(stitch.scene, &c, &probe);
}

static vbss_result drive_stitch(vbss_scene *scene, uint32_t step)
{
    const double pressed[3] = {10e-3, 9.5e-3 - 4e-5 * step, 0.0};
    for (int k = 0; k < 2; k++) {
        double target[3];
        stitch.at[k].z += (k == 0 ? -1.0 : 1.0) * 5e-5;
        vec3_store(target, stitch.at[k]);
        VBSS_TRY(vbss_thread_set_attachment_target(stitch.thread, stitch.hands[k], target, NULL));
    }
    return vbss_scene_set_rigid_target(scene, probe, pressed, NULL);
}

static const struct logged {
    const char *name;
    uint32_t steps;
    maker make;
    driver drive;
} scenes[] = {
    {"tools", TOOL_STEPS, small_scene_create, small_scene_drive},
    {"stitch", STITCH_STEPS, make_stitch, drive_stitch},
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* ---- writing */

static vbss_result append(vbss_record *record, FILE *file)
{
    const uint8_t *bytes;
    uint64_t count;
    VBSS_TRY(vbss_record_take(record, &bytes, &count));
    return fwrite(bytes, 1, count, file) == count ? VBSS_OK : VBSS_ERROR_CAPACITY;
}

static vbss_result write_one(vbss_context *context, const struct logged *s, FILE *file)
{
    vbss_record_config c;
    vbss_record *record;
    vbss_scene *scene;
    VBSS_TRY(s->make(context, &scene));
    VBSS_TRY(vbss_record_config_init(&c, sizeof c));
    c.snapshot_interval = 50;
    VBSS_TRY(vbss_record_create(scene, &c, &record));
    VBSS_TRY(vbss_scene_set_recorder(scene, record));
    for (uint32_t i = 0; i < s->steps; i++) {
        VBSS_TRY(s->drive(scene, i));
        VBSS_TRY(vbss_scene_step(scene, 1e-3));
        VBSS_TRY(append(record, file));
    }
    VBSS_TRY(vbss_record_end(record));
    return append(record, file);
}

static int report_failure(vbss_context *context, const char *name, vbss_result result)
{
    const char *text = "";
    (void)vbss_context_get_last_error(context, NULL, &text);
    fprintf(stderr, "%s: %s %s\n", name, vbss_result_name(result), text);
    return 1;
}

static int write_all(const char *folder)
{
    for (int i = 0; i < SCENES; i++) {
        vbss_context *context;
        char path[1024];
        (void)snprintf(path, sizeof path, "%s/%s.vbss", folder, scenes[i].name);
        FILE *file = fopen(path, "wb");
        if (file == NULL || vbss_context_create(NULL, &context) != VBSS_OK) {
            return 1;
        }
        vbss_result result = write_one(context, &scenes[i], file);
        if (fclose(file) != 0 || result != VBSS_OK) {
            return report_failure(context, path, result);
        }
        (void)vbss_context_destroy(context);
    }
    return 0;
}

/* ---- replaying */

static vbss_result replay(vbss_context *context, const struct logged *s, const uint8_t *bytes,
                          uint64_t count, vbss_replay_report *report)
{
    vbss_replay *replay;
    vbss_scene *scene;
    VBSS_TRY(s->make(context, &scene));
    VBSS_TRY(vbss_replay_create(context, bytes, count, &replay));
    VBSS_TRY(vbss_replay_begin(replay, scene));
    do {
        VBSS_TRY(vbss_replay_step(replay, report, sizeof *report));
    } while (report->outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    return VBSS_OK;
}

/* The last part of a path, without what follows a dot. */
static const struct logged *scene_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash != NULL ? slash + 1 : path;
    for (int i = 0; i < SCENES; i++) {
        size_t length = strlen(scenes[i].name);
        if (strncmp(name, scenes[i].name, length) == 0 && name[length] == '.') {
            return &scenes[i];
        }
    }
    return NULL;
}

static int replay_file(const char *path)
{
    static uint8_t bytes[ROOM];
    const struct logged *s = scene_of(path);
    FILE *file = fopen(path, "rb");
    vbss_replay_report report = {0};
    vbss_context *context;
    if (s == NULL || file == NULL || vbss_context_create(NULL, &context) != VBSS_OK) {
        fprintf(stderr, "%s: no log of a scene here\n", path);
        return 1;
    }
    size_t count = fread(bytes, 1, ROOM, file);
    (void)fclose(file);
    vbss_result result = replay(context, s, bytes, count, &report);
    if (result != VBSS_OK) {
        return report_failure(context, path, result);
    }
    printf("%s %" PRIu64 " %" PRIu64 "\n", s->name, report.step,
           report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS ? report.step : 0);
    (void)vbss_context_destroy(context);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "write") == 0) {
        return write_all(argv[2]);
    }
    if (argc != 2) {
        fprintf(stderr, "replay_log write FOLDER, or replay_log FILE\n");
        return 2;
    }
    return replay_file(argv[1]);
}
