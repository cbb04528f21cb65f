/* Replaying: the scene is told what it was told, stepped, and compared. */
#include "record/record.h"

_Static_assert(sizeof(vbss_replay_report) == 48, "published size");

static const uint32_t report_sizes[] = {48, 0};
static const vbss_layout report_layout = {"vbss_replay_report", NULL, report_sizes};

vbss_result vbss_replay_begin(vbss_replay *replay, vbss_scene *scene)
{
    replay_object *p;
    scene_object *s;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_scene_edit(scene, &s));
    if (s->context != p->context) {
        return vbss_fail(p->context, VBSS_ERROR_INVALID_HANDLE,
                         "the scene belongs to another context");
    }
    VBSS_TRY(vbss_log_compare_config(&p->head, s));
    VBSS_TRY(vbss_scene_restore(scene, p->head.snapshot.bytes, p->head.snapshot.count));
    if (p->head.library_version != vbss_version()) {
        vbss_message(p->context, VBSS_LOG_WARNING,
                     "the log is of library version %u, this is %u: other bits are no surprise",
                     p->head.library_version, vbss_version());
    }
    p->scene = scene;
    p->log = p->begin;
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
    VBSS_TRY(vbss_log_read_step(&p->log, p->report.step, &p->step, &end));
    p->report.position = p->log.at;
    if (!end) {
        return make_step(p);
    }
    p->report.outcome = VBSS_REPLAY_ENDED;
    return compare(p);
}

vbss_result vbss_replay_step(vbss_replay *replay, vbss_replay_report *report, uint32_t struct_size)
{
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size));
    if (p->scene == NULL) {
        return vbss_fail(p->context, VBSS_ERROR_OUT_OF_RANGE, "the replay has not begun");
    }
    if (p->report.outcome == VBSS_REPLAY_STEPPED) {
        p->stopped = go_on(p);
        if (p->stopped != VBSS_OK) {
            p->report.outcome = VBSS_REPLAY_STOPPED;
        }
        (void)vbss_struct_write(p->context, &report_layout, &p->report, report, struct_size);
    }
    return p->stopped;
}
