/* A host as programs of version 1.0 are: a scene with thread, needle and grasper, its events and statistics; a knot in a
 * polyline; recording and replay. It prints results of each part, which every later 1.x library must give in this form. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

#define TRY(call)                                                     \
    do {                                                              \
        const vbss_result r_ = (call);                                \
        if (r_ != VBSS_OK) {                                          \
            fprintf(stderr, "%s: %s\n", #call, vbss_result_name(r_)); \
            return r_;                                                \
        }                                                             \
    } while (0)

enum { STEPS = 60, POINTS = 200, LOG_BYTES = 1 << 22, EVENTS = 64 };

typedef struct log_bytes {
    uint8_t *bytes;
    size_t count;
} log_bytes;

/* ---- a scene */

static vbss_result add_bodies(vbss_context *context, vbss_scene *scene, vbss_grasper **tool)
{
    vbss_thread_config thread_config = vbss_thread_config_default();
    vbss_needle_config needle_config = vbss_needle_config_default();
    vbss_grasper_config tool_config;
    const double tip[3] = {0.0, 0.05, 0.03};
    vbss_thread *thread;
    vbss_needle *needle;
    uint32_t body, pin;
    thread_config.segment_count = 30;
    thread_config.length = 0.06;
    thread_config.start[1] = 5e-3;
    TRY(vbss_thread_create(context, &thread_config, &thread));
    TRY(vbss_scene_add_thread(scene, thread, &body));
    TRY(vbss_scene_pin_thread(scene, body, 0, 0, NULL, &pin));
    needle_config.position[1] = 0.03;
    needle_config.position[2] = -0.05;
    TRY(vbss_needle_create(context, &needle_config, &needle));
    TRY(vbss_scene_add_needle(scene, needle, &body));
    TRY(vbss_grasper_config_init(&tool_config, sizeof tool_config));
    TRY(vbss_grasper_create(context, &tool_config, tool));
    TRY(vbss_grasper_set_target(*tool, tip, NULL));
    return vbss_scene_add_grasper(scene, *tool, &body);
}

static vbss_result take_log(vbss_record *record, log_bytes *log)
{
    const uint8_t *bytes;
    uint64_t count;
    TRY(vbss_record_take(record, &bytes, &count));
    if (count > LOG_BYTES - log->count) {
        return VBSS_ERROR_CAPACITY;
    }
    memcpy(log->bytes + log->count, bytes, (size_t)count);
    log->count += (size_t)count;
    return VBSS_OK;
}

static vbss_result run(vbss_scene *scene, vbss_grasper *tool, log_bytes *log)
{
    vbss_record *record;
    TRY(vbss_record_create(scene, NULL, &record));
    TRY(vbss_scene_set_recorder(scene, record));
    for (int i = 0; i < STEPS; i++) {
        const double tip[3] = {1e-4 * i, 0.05, 0.03};
        TRY(vbss_grasper_set_target(tool, tip, NULL));
        TRY(vbss_grasper_set_opening(tool, 1.0 - 0.01 * i));
        TRY(vbss_scene_step(scene, 1e-3));
    }
    TRY(vbss_record_end(record));
    return take_log(record, log);
}

static vbss_result report_scene(vbss_scene *scene, vbss_grasper *tool)
{
    static vbss_scene_event events[EVENTS];
    vbss_scene_statistics statistics;
    vbss_grasper_state state;
    vbss_thread_statistics thread_statistics;
    vbss_thread *thread;
    vbss_view positions;
    uint32_t count, touches = 0;
    uint64_t hash;
    TRY(vbss_scene_get_hash(scene, &hash));
    TRY(vbss_scene_get_statistics(scene, &statistics, sizeof statistics));
    TRY(vbss_grasper_get_state(tool, &state, sizeof state));
    TRY(vbss_scene_take_events(scene, events, sizeof *events, EVENTS, &count, NULL));
    for (uint32_t i = 0; i < count; i++) {
        touches += events[i].kind == VBSS_SCENE_EVENT_TOUCH;
    }
    TRY(vbss_scene_get_thread(scene, 1, &thread));
    TRY(vbss_thread_get_statistics(thread, &thread_statistics, sizeof thread_statistics));
    TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &positions, sizeof positions));
    printf("scene: hash %016" PRIx64 ", %" PRIu64
           " steps, %u touches, opening %.3f, %u nodes, %u numbers each\n",
           hash, statistics.steps, touches, state.opening, (unsigned)positions.count,
           positions.components);
    return positions.count == thread_statistics.nodes ? VBSS_OK : VBSS_ERROR_CORRUPT;
}

/* ---- a log */

static vbss_result replay_log(vbss_context *context, const log_bytes *log)
{
    vbss_replay *replay;
    vbss_scene *scene;
    vbss_replay_report report;
    vbss_replay_logged_step step;
    TRY(vbss_replay_create(context, log->bytes, log->count, &replay));
    TRY(vbss_replay_read(replay, 7, &step, sizeof step));
    TRY(vbss_replay_load_scene(replay, &scene));
    do {
        TRY(vbss_replay_step(replay, &report, sizeof report));
    } while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    printf("replay: outcome %d, %" PRIu64 " steps agree, %u inputs before step 7\n", report.outcome,
           report.agreed_step, step.input_count);
    return report.outcome == VBSS_REPLAY_OUTCOME_ENDED ? VBSS_OK : VBSS_ERROR_CORRUPT;
}

/* ---- a knot */

static vbss_result classify(vbss_context *context)
{
    static double points[POINTS][3];
    vbss_knot_detector *detector;
    vbss_knot_input input = vbss_knot_input_default();
    vbss_knot_state state;
    char notation[32];
    for (int i = 0; i < POINTS; i++) { /* an overhand knot */
        const double t = -2.2 + 4.4 * i / (POINTS - 1);
        points[i][0] = 1e-3 * (t * t * t - 3.0 * t);
        points[i][1] = 1e-3 * (t * t * t * t - 4.0 * t * t);
        points[i][2] = 0.2e-3 * (t * t * t * t * t - 10.0 * t);
    }
    TRY(vbss_knot_detector_create(context, NULL, &detector));
    input.points = points[0];
    input.point_count = POINTS;
    TRY(vbss_knot_detector_judge(detector, &input));
    TRY(vbss_knot_detector_get_state(detector, &state, sizeof state));
    TRY(vbss_knot_detector_get_notation(detector, notation, sizeof notation));
    printf("knot: \"%s\", %u crossings, determinant %" PRId64 "\n", notation, state.crossings,
           state.determinant);
    return VBSS_OK;
}

static vbss_result all(uint8_t *room)
{
    vbss_context *context;
    vbss_scene *scene;
    vbss_grasper *tool;
    vbss_scene_config config = vbss_scene_config_default();
    log_bytes log = {room, 0};
    config.floor = 1;
    TRY(vbss_context_create(NULL, &context));
    TRY(vbss_scene_create(context, &config, &scene));
    TRY(add_bodies(context, scene, &tool));
    TRY(run(scene, tool, &log));
    TRY(report_scene(scene, tool));
    TRY(replay_log(context, &log));
    TRY(classify(context));
    return vbss_context_destroy(context);
}

int main(void)
{
    uint8_t *room = malloc(LOG_BYTES);
    const int failed = room == NULL || vbss_version() < VBSS_VERSION_NUM || all(room) != VBSS_OK;
    free(room);
    return failed;
}
