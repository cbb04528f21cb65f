/* Replaying: the scene is told what it was told, stepped, and compared. */
#include "base/check.h"
#include "base/error.h"
#include "record/record.h"

_Static_assert(sizeof(vbss_replay_report) == 48, "published size");

static const uint32_t report_sizes[] = {48, 0};
static const vbss_layout report_layout = {"vbss_replay_report", NULL, report_sizes};

vbss_result vbss_replay_begin(vbss_replay *replay, vbss_scene *scene)
{
    replay_object *p;
    scene_object *s;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    if (s->context != p->context) {
        return vbss_fail(p->context, VBSS_ERROR_INVALID_HANDLE,
                         "the scene belongs to another context");
    }
    VBSS_TRY(vbss_log_compare_config(&p->head, s));
    VBSS_TRY(vbss_log_restore_scene(p->context, scene, &p->first));
    if (p->head.library_version != vbss_version()) {
        vbss_message(p->context, VBSS_LOG_WARNING,
                     "the log is of library version %u, this is %u: other bits are no surprise",
                     p->head.library_version, vbss_version());
    }
    p->scene = scene;
    p->log = vbss_log_reader_at(&p->begin, p->log.coder);
    p->stopped = VBSS_OK;
    const vbss_replay_report fresh = {.outcome = VBSS_REPLAY_STEPPED, .position = p->begin.at};
    p->report = fresh;
    return VBSS_OK;
}

/* ---- a step */

static vbss_result compare(replay_object *p)
{
    vbss_replay_report *report = &p->report;
    report->recorded_hash = report->found_hash = 0;
    if (p->step.hashed == 0) {
        return VBSS_OK;
    }
    report->recorded_hash = p->step.hash;
    VBSS_TRY(vbss_scene_get_hash(p->scene, &report->found_hash));
    if (report->found_hash == report->recorded_hash) {
        report->agreed_step = report->step;
    } else {
        report->outcome = VBSS_REPLAY_DIFFERS;
    }
    return VBSS_OK;
}

static vbss_result make_step(replay_object *p)
{
    const log_step *step = &p->step;
    for (uint32_t i = 0; i < step->input_count; i++) {
        VBSS_TRY(vbss_log_tell(p->scene, step->kinds[i], &step->inputs[i], NULL));
    }
    VBSS_TRY(vbss_scene_step(p->scene, step->h));
    p->report.step++;
    return compare(p);
}

static vbss_result go_on(replay_object *p)
{
    bool end = false;
    VBSS_TRY(vbss_check_arithmetic(p->context));
    VBSS_TRY(vbss_log_read_step(&p->log, p->report.step, &p->step, &end));
    p->report.position = p->log.at;
    if (!end) {
        return make_step(p);
    }
    p->report.outcome = VBSS_REPLAY_ENDED;
    return compare(p);
}

/* What becomes of a call that has gone on. */
static vbss_result told(replay_object *p, vbss_result result)
{
    p->stopped = result;
    if (result != VBSS_OK) {
        p->report.outcome = VBSS_REPLAY_STOPPED;
    }
    return result;
}

static vbss_result open_begun(vbss_replay *replay, vbss_replay_report *report, uint32_t struct_size,
                              replay_object **opened)
{
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size));
    *opened = p;
    return p->scene != NULL
               ? VBSS_OK
               : vbss_fail(p->context, VBSS_ERROR_OUT_OF_RANGE, "the replay has not begun");
}

vbss_result vbss_replay_step(vbss_replay *replay, vbss_replay_report *report, uint32_t struct_size)
{
    replay_object *p;
    VBSS_TRY(open_begun(replay, report, struct_size, &p));
    if (p->report.outcome == VBSS_REPLAY_STEPPED) {
        (void)told(p, go_on(p));
        (void)vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size);
    }
    return p->stopped;
}

/* ---- to a step */

/* A place of the log with a snapshot, and the hash that was recorded with the step before it. */
typedef struct location {
    log_reader after;
    log_snapshot snapshot;
    uint64_t hashed, hash;
} place;

/* The newest snapshot at or before that step, once the step itself has been found. */
static vbss_result find_place(replay_object *p, uint64_t step, place *found)
{
    log_reader log = vbss_log_reader_at(&p->begin, p->scan);
    uint64_t number = 0;
    const place begin = {.after = log, .snapshot = p->first};
    *found = begin;
    while (number < step) {
        place next = {.hashed = p->step.hashed, .hash = p->step.hash};
        log_found record;
        VBSS_TRY(vbss_log_read(&log, number, &p->step, &next.snapshot, &record));
        if (record.code == LOG_END) {
            return vbss_fail(p->context, VBSS_ERROR_OUT_OF_RANGE, "the log has no step %llu",
                             (unsigned long long)step);
        }
        if (record.code == LOG_SNAPSHOT) {
            next.after = log;
            *found = next;
        }
        number += record.code == LOG_STEP;
    }
    /* the snapshot of the step itself stands behind it; what else stands there is read when it is its turn */
    log_reader quiet = log;
    log_fault unwanted;
    quiet.fault = &unwanted;
    place last = {.hashed = p->step.hashed, .hash = p->step.hash};
    log_found record;
    if (step > 0 && vbss_log_read(&quiet, number, &p->step, &last.snapshot, &record) == VBSS_OK &&
        record.code == LOG_SNAPSHOT) {
        last.after = quiet;
        last.after.fault = NULL;
        *found = last;
    }
    return VBSS_OK;
}

static vbss_result go_from(replay_object *p, const place *from, uint64_t step)
{
    const uint64_t number = from->snapshot.number;
    const vbss_replay_report fresh = {.outcome = VBSS_REPLAY_STEPPED,
                                      .step = number,
                                      .agreed_step = number,
                                      .position = from->after.at};
    p->log = vbss_log_reader_at(&from->after, p->log.coder);
    p->report = fresh;
    p->step.hashed = number > 0 ? from->hashed : 0;
    p->step.hash = from->hash;
    VBSS_TRY(compare(p));
    while (p->report.step < step && p->report.outcome == VBSS_REPLAY_STEPPED) {
        VBSS_TRY(go_on(p));
    }
    return VBSS_OK;
}

vbss_result vbss_replay_go_to(replay_object *p, uint64_t step)
{
    place from;
    VBSS_TRY(vbss_check_arithmetic(p->context));
    VBSS_TRY(find_place(p, step, &from));
    VBSS_TRY(vbss_log_restore_scene(p->context, p->scene, &from.snapshot));
    return told(p, go_from(p, &from, step));
}

void vbss_replay_go_back(replay_object *p, const replay_object *before)
{
    log_reader log = vbss_log_reader_at(&p->begin, p->log.coder);
    log_snapshot passed;
    log_found found;
    uint64_t number = 0;
    /* the coder learns once more what stands before that place, which has all been read before */
    while (log.at < before->log.at &&
           vbss_log_read(&log, number, &p->step, &passed, &found) == VBSS_OK) {
        number += found.code == LOG_STEP;
    }
    p->log = before->log;
    p->report = before->report;
    p->stopped = before->stopped;
}

vbss_result vbss_replay_seek(vbss_replay *replay, uint64_t step, vbss_replay_report *report,
                             uint32_t struct_size)
{
    replay_object *p;
    VBSS_TRY(open_begun(replay, report, struct_size, &p));
    vbss_result result = vbss_replay_go_to(p, step);
    (void)vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size);
    return result;
}
