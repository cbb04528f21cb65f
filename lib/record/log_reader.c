/* Reads a log without a scene: opens it, reports its header, and reads its steps in order. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/memory.h"
#include "record/step_codec.h"

_Static_assert(sizeof(vbss_replay_info) == VBSS_SIZE_WITH_POINTERS(vbss_replay_info, 32u, 2u),
               "published size");

static const uint32_t info_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_replay_info, 32u, 2u), 0};
static const vbss_layout info_layout = {"vbss_replay_info", NULL, info_sizes};
static const uint32_t step_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_replay_logged_step, 56u, 2u),
                                      VBSS_SIZE_WITH_POINTERS(vbss_replay_logged_step, 64u, 2u), 0};
static const vbss_layout step_layout = {"vbss_replay_logged_step", NULL, step_sizes};
_Static_assert(sizeof(vbss_replay_logged_step) ==
                       VBSS_SIZE_WITH_POINTERS(vbss_replay_logged_step, 64u, 2u) &&
                   sizeof(vbss_record_input) == 128,
               "published sizes");
static const uint32_t scene_config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_scene_config, 136u, 2u),
                                              0};
static const vbss_layout scene_config_layout = {"vbss_scene_config", NULL, scene_config_sizes};

/* ---- creation and destruction */

static void free_replay(vbss_context *context, void *object)
{
    replay_object *p = object;
    vbss_replay_close_log(p);
    vbss_release(context, p, 1, sizeof *p);
}

/* The state is that of the scene; the replay itself has only its position. */
static void visit_replay(vbss_stream *stream, void *object)
{
    replay_object *p = object;
    vbss_stream_u64(stream, 1, &p->report.step, 1);
}

static const vbss_kind kind = {
    "replay", VBSS_CODE('R', 'E', 'P', 'L'), 1, free_replay, visit_replay, NULL};

/* Finds the next record and begins a stream that reads its payload. */
static vbss_result next_record(log_reader *log, log_record *found, vbss_stream *stream)
{
    VBSS_TRY(vbss_log_next(log, found));
    vbss_stream_begin_read(stream, found->payload, found->length);
    return VBSS_OK;
}

void vbss_replay_close_log(replay_object *p)
{
    vbss_log_free_header(&p->header);
    vbss_log_free_inputs(p->context, &p->step);
    vbss_log_free_events(p->context, &p->step);
    vbss_log_free_coder(p->context, p->log.coder);
    vbss_log_free_coder(p->context, p->inspection.coder);
    vbss_log_free_coder(p->context, p->scan_coder);
}

vbss_result vbss_replay_open_log(replay_object *p)
{
    log_record found;
    vbss_stream stream;
    VBSS_TRY(vbss_log_read_preamble(&p->log));
    VBSS_TRY(next_record(&p->log, &found, &stream));
    p->header.baseline = vbss_baseline_config_default();
    p->header.solver = vbss_solver_options_default();
    vbss_log_visit_header(&stream, &p->header);
    VBSS_TRY(vbss_log_check_all_read(&p->log, &found, &stream));
    VBSS_TRY(next_record(&p->log, &found, &stream));
    vbss_log_visit_snapshot(&stream, &p->first_snapshot);
    VBSS_TRY(vbss_log_check_all_read(&p->log, &found, &stream));
    if (p->first_snapshot.number != 0) {
        return vbss_log_fail_corrupt(&p->log, found.position,
                                     "the scene at the begin was expected");
    }
    p->start = p->inspection = p->log;
    VBSS_TRY(vbss_log_make_coder(p->context, p->header.input_capacity, &p->log.coder));
    VBSS_TRY(vbss_log_make_coder(p->context, p->header.input_capacity, &p->inspection.coder));
    VBSS_TRY(vbss_log_make_coder(p->context, p->header.input_capacity, &p->scan_coder));
    p->report.position = p->log.position;
    p->step.input_capacity = p->header.input_capacity;
    VBSS_TRY(vbss_log_allocate_inputs(p->context, &p->step));
    return vbss_log_allocate_events(p->context, &p->step, p->header.scene.event_capacity);
}

static vbss_result create_replay(vbss_context *context, const uint8_t *bytes, size_t count,
                                 replay_object **replay)
{
    replay_object *p = vbss_allocate(context, 1, sizeof *p, "replay");
    if (p == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    p->context = p->header.context = p->log.context = context;
    p->log.bytes = bytes;
    p->log.count = count;
    vbss_result result = vbss_replay_open_log(p);
    if (result != VBSS_OK) {
        free_replay(context, p);
        return result;
    }
    *replay = p;
    return VBSS_OK;
}

vbss_result vbss_replay_create(vbss_context *context, const uint8_t *bytes, uint64_t count,
                               vbss_replay **replay)
{
    VBSS_ENTER_WITH_RESULT(context, replay);
    replay_object *p;
    vbss_slot *slot = NULL;
    if (replay == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, replay, "replay");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, bytes, "bytes"));
    if (count > SIZE_MAX) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT, "the log is larger than any memory");
    }
    VBSS_TRY(create_replay(context, bytes, (size_t)count, &p));
    vbss_result result = vbss_slot_create(context, &kind, p, &slot);
    if (result != VBSS_OK) {
        free_replay(context, p);
        return result;
    }
    *replay = (vbss_replay *)slot;
    return VBSS_OK;
}

vbss_result vbss_replay_destroy(vbss_replay *replay)
{
    VBSS_ENTER(replay);
    return vbss_slot_destroy(replay, &kind);
}

static vbss_result open_replay(const vbss_replay *handle, replay_object **replay)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &kind, &slot));
    *replay = slot->object;
    return VBSS_OK;
}

vbss_result vbss_replay_edit(vbss_replay *handle, replay_object **replay)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &kind, &slot));
    *replay = slot->object;
    return VBSS_OK;
}

/* ---- header */

vbss_result vbss_replay_get_info(vbss_replay *replay, vbss_replay_info *info, uint32_t struct_size)
{
    VBSS_ENTER(replay);
    replay_object *p;
    VBSS_TRY(open_replay(replay, &p));
    const vbss_replay_info own = {
        .struct_size = sizeof own,
        .library_version = p->header.library_version,
        .hash_interval = p->header.hash_interval,
        .note_bytes = p->header.note.count,
        .snapshot_bytes = p->first_snapshot.count,
        .log_bytes = p->log.count,
        .build_info = (const char *)p->header.build_info.bytes,
        .note = p->header.note.bytes,
    };
    return vbss_struct_write(p->context, &info_layout, &own, info, struct_size);
}

vbss_result vbss_replay_get_scene_config(vbss_replay *replay, vbss_scene_config *config)
{
    VBSS_ENTER(replay);
    replay_object *p;
    VBSS_TRY(open_replay(replay, &p));
    VBSS_TRY(vbss_check_pointer(p->context, config, "config"));
    vbss_scene_config own = p->header.scene;
    own.struct_size = sizeof own;
    own.baseline = &p->header.baseline;
    own.solver = &p->header.solver;
    return vbss_struct_write(p->context, &scene_config_layout, &own, config, config->struct_size);
}

/* ---- steps */

log_reader vbss_log_reader_at(const log_reader *start, log_coder *coder)
{
    log_reader reader = *start;
    reader.coder = coder;
    vbss_log_reset_coder(coder);
    return reader;
}

static vbss_result decode_step(const log_reader *log, const log_record *found,
                               uint64_t steps_before, vbss_stream *stream, log_step *step)
{
    if (!found->is_coded) {
        vbss_log_visit_step(stream, step);
        vbss_log_reset_coder(log->coder);
        return vbss_log_check_all_read(log, found, stream);
    }
    const char *problem =
        vbss_log_decode(log->coder, steps_before, found->payload, found->length, step);
    return problem == NULL ? VBSS_OK : vbss_log_fail_corrupt(log, found->position, problem);
}

vbss_result vbss_log_read_record(log_reader *log, uint64_t steps_before, log_step *step,
                                 log_snapshot *snapshot, log_record *found)
{
    log_reader next = *log;
    vbss_stream stream;
    uint64_t number = steps_before;
    VBSS_TRY(next_record(&next, found, &stream));
    if (found->code == LOG_SNAPSHOT) {
        vbss_log_visit_snapshot(&stream, snapshot);
        VBSS_TRY(vbss_log_check_all_read(log, found, &stream));
        vbss_log_reset_coder(log->coder);
        number = snapshot->number;
    } else if (found->code == LOG_REPLACEMENT) {
        vbss_log_visit_replacement(&stream, snapshot);
        VBSS_TRY(vbss_log_check_all_read(log, found, &stream));
        number = snapshot->number;
    } else if (found->code == LOG_END) {
        vbss_log_visit_end(&stream, step);
        VBSS_TRY(vbss_log_check_all_read(log, found, &stream));
        number = step->number;
    } else {
        VBSS_TRY(decode_step(log, found, steps_before, &stream, step));
        number = step->number - 1;
    }
    if (number != steps_before) {
        return vbss_log_fail_corrupt(log, found->position, "another step was expected");
    }
    if (found->code == LOG_END && next.position != next.count) {
        return vbss_log_fail_corrupt(log, next.position, "data follow the end");
    }
    *log = next;
    return VBSS_OK;
}

vbss_result vbss_log_read_step(log_reader *log, uint64_t steps_before, log_step *step, bool *end)
{
    log_reader next = *log;
    log_snapshot skipped;
    log_record found;
    step->replacement = (log_snapshot){.bytes = NULL};
    do {
        VBSS_TRY(vbss_log_read_record(&next, steps_before, step, &skipped, &found));
        step->replacement = found.code == LOG_REPLACEMENT ? skipped : step->replacement;
    } while (found.code == LOG_SNAPSHOT || found.code == LOG_REPLACEMENT);
    *end = found.code == LOG_END;
    *log = next;
    return VBSS_OK;
}

vbss_result vbss_replay_check(vbss_replay *replay, uint64_t *steps)
{
    VBSS_ENTER(replay);
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    VBSS_TRY(vbss_check_pointer(p->context, steps, "steps"));
    log_reader log = vbss_log_reader_at(&p->start, p->scan_coder);
    log_step step = p->step;
    bool end = false;
    *steps = 0;
    while (!end) {
        VBSS_TRY(vbss_log_read_step(&log, *steps, &step, &end));
        *steps += !end;
    }
    return VBSS_OK;
}

vbss_result vbss_replay_read(vbss_replay *replay, uint64_t number, vbss_replay_logged_step *step,
                             uint32_t struct_size)
{
    VBSS_ENTER(replay);
    replay_object *p;
    bool end = false;
    VBSS_TRY(vbss_replay_edit(replay, &p));
    vbss_replay_logged_step own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_struct_write(p->context, &step_layout, &own, step, struct_size));
    if (number <= p->inspected_steps) {
        p->inspection = vbss_log_reader_at(&p->start, p->inspection.coder);
        p->inspected_steps = 0;
        p->inspected_time = 0.0;
    }
    while (number > p->inspected_steps) {
        log_reader next = p->inspection;
        VBSS_TRY(vbss_log_read_step(&next, p->inspected_steps, &p->step, &end));
        if (end) {
            break;
        }
        p->inspection = next;
        p->inspected_steps++;
        p->inspected_time += p->step.h;
    }
    if (end || number == 0) {
        return vbss_fail(p->context, VBSS_ERROR_NOT_FOUND, "the log has no step %llu",
                         (unsigned long long)number);
    }
    own.position = p->inspection.position;
    own.number = number;
    own.hashed = (uint32_t)p->step.has_hash;
    own.hash = p->step.hash;
    own.h = p->step.h;
    own.time = p->inspected_time;
    own.input_count = p->step.input_count;
    own.event_count = p->step.event_count;
    own.inputs = p->step.inputs;
    own.events = p->step.events[0];
    own.time_lost = vbss_scene_inspect_lost_time(p->step.events, p->step.event_count, p->step.h);
    return vbss_struct_write(p->context, &step_layout, &own, step, struct_size);
}
