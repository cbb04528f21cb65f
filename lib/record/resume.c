/* Continues a log: brings the scene to the last complete step, and makes a record that appends to
 * the log. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "record/record.h"

/* Finds the number of complete steps, and the position after the last of them. */
static vbss_result find_last_step(replay_object *p, uint64_t *steps, log_reader *end)
{
    log_record found = {.code = LOG_STEP}; /* a replacement without its step is cut off */
    log_snapshot snapshot;
    log_reader log = vbss_log_reader_at(&p->start, p->scan_coder);
    log_fault fault;
    vbss_result result = VBSS_OK;
    log.fault = &fault;
    *steps = 0;
    *end = log;
    while (result == VBSS_OK && found.code != LOG_END) {
        *end = found.code != LOG_REPLACEMENT ? log : *end;
        result = vbss_log_read_record(&log, *steps, &p->step, &snapshot, &found);
        *steps += result == VBSS_OK && found.code == LOG_STEP;
    }
    return result == VBSS_OK || result == VBSS_ERROR_TRUNCATED
               ? VBSS_OK
               : vbss_fail(p->context, result, "log, byte %llu of %llu: %s",
                           (unsigned long long)fault.position, (unsigned long long)log.count,
                           fault.problem);
}

static vbss_result check_compatible(const replay_object *p, const scene_info *scene)
{
    if (p->header.library_version != vbss_version()) {
        return vbss_fail(p->context, VBSS_ERROR_DATA_VERSION,
                         "the log is of library version %u, this is %u", p->header.library_version,
                         vbss_version());
    }
    return scene->config->event_capacity <= p->header.scene.event_capacity
               ? VBSS_OK
               : vbss_fail(p->context, VBSS_ERROR_CAPACITY,
                           "the scene keeps %u events of a step, the log has room for %u",
                           scene->config->event_capacity, p->header.scene.event_capacity);
}

static vbss_result replay_to_end(replay_object *p, uint64_t steps)
{
    VBSS_TRY(vbss_replay_seek_step(p, steps));
    return p->report.outcome == VBSS_REPLAY_OUTCOME_STEPPED
               ? VBSS_OK
               : vbss_fail(p->context, VBSS_ERROR_CORRUPT,
                           "the scene after step %llu is not the recorded one",
                           (unsigned long long)p->report.step);
}

static vbss_result allocate_log(record_object *r, const replay_object *p, uint64_t steps,
                                const log_reader *end, const vbss_record_config *c)
{
    r->step.number = steps;
    VBSS_TRY(vbss_record_allocate_log(r, 0, p->first_snapshot.count, c));
    r->log.checksum = end->checksum;
    r->log.format = end->format;
    return VBSS_OK;
}

vbss_result vbss_record_resume(vbss_replay *replay, const vbss_record_config *config,
                               vbss_record **record, uint64_t *position)
{
    VBSS_ENTER_WITH_RESULT(replay, record);
    replay_object *p;
    scene_info info;
    vbss_record_config own;
    uint64_t steps;
    log_reader end;
    record_object *r = NULL;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_check_pointer(p->context, record, "record"));
    VBSS_TRY(vbss_check_pointer(p->context, position, "position"));
    VBSS_TRY(vbss_record_read_config(p->context, config, &own));
    if (p->scene == NULL) {
        return vbss_fail(p->context, VBSS_ERROR_WRONG_STATE, "the replay has not begun");
    }
    VBSS_TRY(vbss_scene_inspect_for_edit(p->scene, &info));
    VBSS_TRY(check_compatible(p, &info));
    VBSS_TRY(find_last_step(p, &steps, &end));
    VBSS_TRY(replay_to_end(p, steps));
    vbss_result result =
        vbss_record_make(p->scene, p->header.hash_interval, p->header.input_capacity, &r);
    if (result == VBSS_OK) {
        result = allocate_log(r, p, steps, &end, &own);
    }
    *position = end.position;
    return vbss_record_create_handle(r, result, record);
}
