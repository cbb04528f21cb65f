/* Writes a short log whose figures are known beforehand: the left tool goes 50 mm in 1 s as reaches of least jerk do, the
 * right one rests, a thread that nobody touches is cut twice.
 *
 *     write_session FILE NOTE [hostile | lossy]
 *
 * hostile: with the build text of the library changed into markup, and checksums that are right.
 * lossy: without cuts, and with limits of work that steps exceed. Prints the simulated time lost, s. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixtures/scene_build.h"
#include "fixtures/solver_of.h"
#include "fuzz/fuzz.h"

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* Operations in a step and in a call of a lossy scene. */
enum { LOSSY_WORK = 400, LOSSY_SLOT = 400 };
enum { STEPS = 1500, FIRST_CUT = 1000, SECOND_CUT = 1200, ROOM = 1 << 22 };

static uint8_t log_bytes[ROOM];
static size_t log_count;

static vbss_result add_tool(vbss_context *context, vbss_scene *scene, double x, uint32_t *body)
{
    const scene_build_hand hand = scene_build_upright(vec3_make(x, 0.0, 0.05));
    return scene_build_grasper(context, scene, NULL, &hand, NULL, body);
}

static vbss_result add_thread(vbss_context *context, vbss_scene *scene, uint32_t *body)
{
    vbss_thread_config config;
    TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = 12;
    config.length = 0.03;
    config.cut_capacity = 2;
    config.start[1] = -0.3; /* far from the tools */
    return scene_build_thread(context, scene, &config, NULL, body);
}

static vbss_result take(vbss_record *record)
{
    const uint8_t *bytes;
    uint64_t count;
    TRY(vbss_record_take(record, &bytes, &count));
    if (count > ROOM - log_count) {
        return VBSS_ERROR_CAPACITY;
    }
    memcpy(log_bytes + log_count, bytes, count);
    log_count += count;
    return VBSS_OK;
}

/* 0 to 1 with the least jerk; at rest before and after. */
static double reach(double t)
{
    double s = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

static double lost_time(vbss_scene *scene)
{
    vbss_scene_statistics s;
    return vbss_scene_get_statistics(scene, &s, sizeof s) == VBSS_OK ? s.time_paused : -1.0;
}

static vbss_result run(vbss_scene *scene, vbss_record *record, uint32_t thread,
                       const uint32_t tools[2], int is_lossy)
{
    vbss_grasper *graspers[2];
    uint32_t piece;
    TRY(vbss_scene_set_recorder(scene, record));
    for (int k = 0; k < 2; k++) {
        TRY(vbss_scene_get_grasper(scene, tools[k], &graspers[k]));
    }
    for (int i = 1; i <= STEPS; i++) {
        const double left[3] = {-0.05, 0.05 * reach(1e-3 * i - 0.25), 0.05};
        const double right[3] = {0.05, 0.0, 0.05};
        TRY(vbss_grasper_set_target(graspers[0], left, NULL));
        TRY(vbss_grasper_set_target(graspers[1], right, NULL));
        if (!is_lossy && (i == FIRST_CUT || i == SECOND_CUT)) {
            TRY(vbss_scene_cut_thread(scene, thread, i == FIRST_CUT ? 0.02 : 0.01, &piece));
        }
        TRY(vbss_scene_step(scene, 1e-3));
        TRY(take(record));
    }
    TRY(vbss_record_end(record));
    return take(record);
}

static vbss_result write(vbss_context *context, const char *note, int is_lossy)
{
    vbss_scene_config config;
    vbss_record_config how;
    vbss_scene *scene;
    vbss_record *record;
    uint32_t tools[2], thread;
    TRY(vbss_scene_config_init(&config, sizeof config));
    set_step_operations(&config, is_lossy ? LOSSY_WORK : step_operations(&config));
    set_call_operations(&config, is_lossy ? LOSSY_SLOT : call_operations(&config));
    TRY(vbss_scene_create(context, &config, &scene));
    TRY(add_tool(context, scene, 0.05,
                 &tools[1])); /* which is left is for the report to find out */
    TRY(add_tool(context, scene, -0.05, &tools[0]));
    TRY(add_thread(context, scene, &thread));
    TRY(vbss_record_config_init(&how, sizeof how));
    how.note = note;
    how.note_bytes = (uint32_t)strlen(note);
    TRY(vbss_record_create(scene, &how, &record));
    TRY(run(scene, record, thread, tools, is_lossy));
    if (is_lossy) {
        printf("%.17g\n", lost_time(scene));
    }
    return VBSS_OK;
}

/* In the head, which comes first. */
static int put_markup(void)
{
    static const char markup[] = "<img src=x onerror=alert(1)>\"'&";
    const char *build = vbss_build_info();
    size_t length = strlen(build);
    for (size_t i = 0; length >= sizeof markup && i + length < log_count; i++) {
        if (memcmp(log_bytes + i, build, length) == 0) {
            memcpy(log_bytes + i, markup, sizeof markup - 1);
            seal_log(log_bytes, log_count);
            return 1;
        }
    }
    return 0;
}

int main(int argc, char **argv)
{
    vbss_context *context;
    int hostile = argc == 4 && strcmp(argv[3], "hostile") == 0;
    int lossy = argc == 4 && strcmp(argv[3], "lossy") == 0;
    if ((argc != 3 && !hostile && !lossy) || vbss_context_create(NULL, &context) != VBSS_OK) {
        fprintf(stderr, "write_session FILE NOTE [hostile | lossy]\n");
        return 2;
    }
    vbss_result result = write(context, argv[2], lossy);
    if (result != VBSS_OK || (hostile && !put_markup())) {
        fprintf(stderr, "%s\n", vbss_result_name(result));
        return 1;
    }
    vbss_context_destroy(context);
    FILE *file = fopen(argv[1], "wb");
    int written = file != NULL && fwrite(log_bytes, 1, log_count, file) == log_count;
    return file != NULL && fclose(file) == 0 && written ? 0 : 1;
}
