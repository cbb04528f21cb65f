/* Replays a log: applies its inputs to a scene, steps the scene and compares hashes. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "record/record.h"

_Static_assert(sizeof(vbss_replay_report) == 48, "published size");

static const uint32_t report_sizes[] = {48, 0};
static const vbss_layout report_layout = {"vbss_replay_report", NULL, report_sizes};

vbss_result vbss_replay_begin(vbss_replay *replay, vbss_scene *scene)
{
    VBSS_ENTER(replay);
    replay_object *p;
    scene_info info;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_slot_check_other(p->context, scene, "scene"));
    VBSS_TRY(vbss_scene_inspect_for_edit(scene, &info));
    VBSS_TRY(vbss_log_compare_config(&p->header, &info));
    const bool is_loaded = p->is_loaded && scene == p->scene;
    VBSS_TRY(vbss_log_restore_scene(p->context, scene, is_loaded, &p->first_snapshot));
    if (p->header.library_version != vbss_version()) {
        vbss_message(p->context, VBSS_LOG_WARNING,
                     "the log is of library version %u, this is %u: other bits are no surprise",
                     p->header.library_version, vbss_version());
    }
    p->scene = scene;
    p->is_loaded = is_loaded;
    p->log = vbss_log_reader_at(&p->start, p->log.coder);
    p->stop_result = VBSS_OK;
    const vbss_replay_report initial = {.outcome = VBSS_REPLAY_OUTCOME_STEPPED,
                                        .position = p->start.position};
    p->report = initial;
    return VBSS_OK;
}

vbss_result vbss_replay_load_scene(vbss_replay *replay, vbss_scene **scene)
{
    VBSS_ENTER_WITH_RESULT(replay, scene);
    replay_object *p;
    log_snapshot_data data;
    vbss_scene *loaded = NULL;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_check_pointer(p->context, scene, "scene"));
    VBSS_TRY(vbss_log_decompress_snapshot(p->context, &p->first_snapshot, &data));
    vbss_result result = vbss_scene_load(p->context, data.bytes, data.count, &loaded);
    vbss_log_release_snapshot(p->context, &data);
    if (result == VBSS_OK) {
        result = vbss_replay_begin(replay, loaded);
    }
    if (result != VBSS_OK) {
        (void)vbss_scene_destroy(loaded);
        return result;
    }
    p->is_loaded = true;
    *scene = loaded;
    return VBSS_OK;
}

/* ---- a step */

static vbss_result replace_state(replay_object *p, const log_snapshot *replacement)
{
    const vbss_result result =
        vbss_log_restore_scene(p->context, p->scene, p->is_loaded, replacement);
    return result != VBSS_ERROR_CORRUPT || p->is_loaded
               ? result
               : vbss_fail(p->context, result,
                           "after step %llu the host has changed the bodies of the scene: only a "
                           "scene of vbss_replay_load_scene follows",
                           (unsigned long long)p->report.step);
}

static vbss_result compare_hash(replay_object *p)
{
    vbss_replay_report *report = &p->report;
    report->recorded_hash = report->found_hash = 0;
    if (p->step.has_hash == 0) {
        return VBSS_OK;
    }
    report->recorded_hash = p->step.hash;
    VBSS_TRY(vbss_scene_get_hash(p->scene, &report->found_hash));
    if (report->found_hash == report->recorded_hash) {
        report->agreed_step = report->step;
    } else {
        report->outcome = VBSS_REPLAY_OUTCOME_DIFFERS;
    }
    return VBSS_OK;
}

static vbss_result replay_step(replay_object *p)
{
    const log_step *step = &p->step;
    if (step->replacement.bytes != NULL) {
        VBSS_TRY(replace_state(p, &step->replacement));
    }
    for (uint32_t i = 0; i < step->input_count; i++) {
        VBSS_TRY(vbss_log_apply_input(p->scene, step->kinds[i], &step->inputs[i], NULL));
    }
    VBSS_TRY(vbss_scene_step(p->scene, step->h));
    p->report.step++;
    return compare_hash(p);
}

static vbss_result replay_next(replay_object *p)
{
    bool end = false;
    VBSS_TRY(vbss_log_read_step(&p->log, p->report.step, &p->step, &end));
    p->report.position = p->log.position;
    if (!end) {
        return replay_step(p);
    }
    p->report.outcome = VBSS_REPLAY_OUTCOME_ENDED;
    return compare_hash(p);
}

/* Stores the result of a call that may have changed the scene. */
static vbss_result set_outcome(replay_object *p, vbss_result result)
{
    p->stop_result = result;
    if (result != VBSS_OK) {
        p->report.outcome = VBSS_REPLAY_OUTCOME_STOPPED;
    }
    return result;
}

static vbss_result open_started(vbss_replay *replay, vbss_replay_report *report,
                                uint32_t struct_size, replay_object **opened)
{
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size));
    *opened = p;
    return p->scene != NULL
               ? VBSS_OK
               : vbss_fail(p->context, VBSS_ERROR_WRONG_STATE, "the replay has not begun");
}

vbss_result vbss_replay_step(vbss_replay *replay, vbss_replay_report *report, uint32_t struct_size)
{
    VBSS_ENTER(replay);
    replay_object *p;
    VBSS_TRY(open_started(replay, report, struct_size, &p));
    if (p->report.outcome == VBSS_REPLAY_OUTCOME_STEPPED) {
        (void)set_outcome(p, replay_next(p));
        (void)vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size);
    }
    return p->stop_result;
}

/* ---- seek */

/* A snapshot in the log, the position after it, and the hash recorded with the step before it. */
typedef struct location {
    log_reader reader;
    log_snapshot snapshot;
    uint64_t has_hash, hash;
} place;

/* Finds the newest snapshot at or before a step. Fails if the log does not have the step. */
static vbss_result find_seek_point(replay_object *p, uint64_t step, place *found)
{
    log_reader log = vbss_log_reader_at(&p->start, p->scan_coder);
    uint64_t number = 0;
    const place start = {.reader = log, .snapshot = p->first_snapshot};
    *found = start;
    while (number < step) {
        place next = {.has_hash = p->step.has_hash, .hash = p->step.hash};
        log_record record;
        VBSS_TRY(vbss_log_read_record(&log, number, &p->step, &next.snapshot, &record));
        if (record.code == LOG_END) {
            return vbss_fail(p->context, VBSS_ERROR_NOT_FOUND, "the log has no step %llu",
                             (unsigned long long)step);
        }
        if (record.code == LOG_SNAPSHOT) {
            next.reader = log;
            *found = next;
        }
        number += record.code == LOG_STEP;
    }
    /* The snapshot of the step itself follows the step. A fault there is ignored until the
         * replay reaches it. */
    log_reader probe = log;
    log_fault ignored;
    probe.fault = &ignored;
    place last = {.has_hash = p->step.has_hash, .hash = p->step.hash};
    log_record record;
    if (step > 0 &&
        vbss_log_read_record(&probe, number, &p->step, &last.snapshot, &record) == VBSS_OK &&
        record.code == LOG_SNAPSHOT) {
        last.reader = probe;
        last.reader.fault = NULL;
        *found = last;
    }
    return VBSS_OK;
}

static vbss_result replay_from(replay_object *p, const place *from, uint64_t step)
{
    const uint64_t number = from->snapshot.number;
    const vbss_replay_report initial = {.outcome = VBSS_REPLAY_OUTCOME_STEPPED,
                                        .step = number,
                                        .agreed_step = number,
                                        .position = from->reader.position};
    p->log = vbss_log_reader_at(&from->reader, p->log.coder);
    p->report = initial;
    p->step.has_hash = number > 0 ? from->has_hash : 0;
    p->step.hash = from->hash;
    VBSS_TRY(compare_hash(p));
    while (p->report.step < step && p->report.outcome == VBSS_REPLAY_OUTCOME_STEPPED) {
        VBSS_TRY(replay_next(p));
    }
    return VBSS_OK;
}

vbss_result vbss_replay_seek_step(replay_object *p, uint64_t step)
{
    place from;
    VBSS_TRY(find_seek_point(p, step, &from));
    VBSS_TRY(vbss_log_restore_scene(p->context, p->scene, p->is_loaded, &from.snapshot));
    return set_outcome(p, replay_from(p, &from, step));
}

replay_position vbss_replay_get_position(const replay_object *p)
{
    const replay_position here = {
        .log = p->log, .report = p->report, .stop_result = p->stop_result};
    return here;
}

void vbss_replay_roll_back(replay_object *p, const replay_position *before)
{
    log_reader log = vbss_log_reader_at(&p->start, p->log.coder);
    log_snapshot skipped;
    log_record found;
    uint64_t number = 0;
    /* Rebuilds the history of the coder. All these records were read before. */
    while (log.position < before->log.position &&
           vbss_log_read_record(&log, number, &p->step, &skipped, &found) == VBSS_OK) {
        number += found.code == LOG_STEP;
    }
    p->log = before->log;
    p->report = before->report;
    p->stop_result = before->stop_result;
}

vbss_result vbss_replay_seek(vbss_replay *replay, uint64_t step, vbss_replay_report *report,
                             uint32_t struct_size)
{
    VBSS_ENTER(replay);
    replay_object *p;
    VBSS_TRY(open_started(replay, report, struct_size, &p));
    vbss_result result = vbss_replay_seek_step(p, step);
    (void)vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size);
    return result;
}
