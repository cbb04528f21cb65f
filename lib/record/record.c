/* Writes a log: its start, the steps that are appended, and its end. */
#include <string.h>

#include "base/api_call.h"
#include "base/config.h"
#include "base/memory.h"
#include "record/step_codec.h"

#include "base/check.h"
#include "base/error.h"
#include "base/snapshot.h"

_Static_assert(sizeof(vbss_record_config) == VBSS_SIZE_WITH_POINTERS(vbss_record_config, 32u, 1u),
               "published size");

static const vbss_record_config defaults = {
    .struct_size = sizeof(vbss_record_config),
    .hash_interval = 1,
    .input_capacity = 64,
    .buffer_bytes = 1u << 20,
    .snapshot_interval = 2000,
};
static const uint32_t config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_record_config, 24u, 1u),
                                        VBSS_SIZE_WITH_POINTERS(vbss_record_config, 32u, 1u), 0};
static const vbss_layout config_layout = {"vbss_record_config", &defaults, config_sizes};

vbss_result vbss_record_config_init(vbss_record_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

static vbss_result check_record_config(vbss_context *context, const vbss_record_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->hash_interval, 1.0, 1e9, "hash_interval"));
    VBSS_TRY(vbss_check_range(context, c->input_capacity, 0.0, 65536.0, "input_capacity"));
    VBSS_TRY(vbss_check_range(context, c->note_bytes, 0.0, 16777216.0, "note_bytes"));
    VBSS_TRY(
        vbss_check_range(context, (double)c->buffer_bytes, 4096.0, 1073741824.0, "buffer_bytes"));
    VBSS_TRY(vbss_check_range(context, c->snapshot_interval, 0.0, 1e9, "snapshot_interval"));
    return c->note_bytes == 0 ? VBSS_OK : vbss_check_pointer(context, c->note, "note");
}

vbss_result vbss_record_read_config(vbss_context *context, const vbss_record_config *config,
                                    vbss_record_config *own)
{
    *own = defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    }
    return check_record_config(context, own);
}

/* ---- start of a log */

static vbss_result fill_header(const scene_info *scene, const vbss_record_config *c,
                               log_header *header)
{
    const char *build_info = vbss_build_info();
    header->library_version = vbss_version();
    header->hash_interval = c->hash_interval;
    header->input_capacity = c->input_capacity;
    header->scene = *scene->config;
    header->baseline = *scene->config->baseline;
    header->solver = *scene->config->solver;
    VBSS_TRY(
        vbss_log_make_blob(scene->context, &header->build_info, build_info, strlen(build_info)));
    return vbss_log_make_blob(scene->context, &header->note, c->note, c->note_bytes);
}

static size_t measure_header(log_header *header)
{
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_header(&stream, header);
    return LOG_PREAMBLE_BYTES + log_record_bytes(&stream);
}

static vbss_result write_header(log_writer *log, log_header *header)
{
    vbss_stream stream;
    vbss_log_write_preamble(log);
    vbss_log_begin_record(log, &stream);
    vbss_log_visit_header(&stream, header);
    return vbss_log_end_record(log, &stream);
}

static vbss_result write_snapshot(record_object *r, size_t count)
{
    VBSS_TRY(vbss_log_write_snapshot(r, LOG_SNAPSHOT, (const vbss_slot *)r->scene, count));
    vbss_log_reset_coder(r->coder);
    r->snapshot_is_last = true;
    return VBSS_OK;
}

static size_t measure_end(log_step *step)
{
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_end(&stream, step);
    return log_record_bytes(&stream);
}

/* ---- creation and destruction */

static void free_record(vbss_context *context, void *object)
{
    record_object *r = object;
    if (r->scene != NULL) {
        vbss_record_detach_hook(r);
    }
    vbss_log_free_inputs(context, &r->step);
    vbss_log_free_coder(context, r->coder);
    vbss_release(context, r->log.bytes, r->log.capacity, 1);
    vbss_release(context, r, 1, sizeof *r);
}

/* A log cannot be set back, so only its number of steps is serialised. */
static void visit_record(vbss_stream *stream, void *object)
{
    record_object *r = object;
    vbss_stream_u64(stream, 1, &r->step.number, 1);
}

static const vbss_kind kind = {
    "record", VBSS_CODE('R', 'E', 'C', 'O'), 1, free_record, visit_record, NULL};

vbss_result vbss_record_make(vbss_scene *scene, uint32_t hash_interval, uint32_t input_capacity,
                             record_object **record)
{
    scene_info info;
    VBSS_TRY(vbss_scene_inspect(scene, &info));
    record_object *r = vbss_allocate(info.context, 1, sizeof *r, "record");
    if (r == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    *record = r;
    r->context = info.context;
    r->scene = scene;
    r->hash_interval = hash_interval;
    r->step.input_capacity = input_capacity;
    r->step.event_capacity = info.config->event_capacity;
    r->max_event_bytes = (size_t)info.config->event_capacity * LOG_MAX_EVENT_BYTES;
    r->known_edits = vbss_scene_inspect_edits(scene);
    VBSS_TRY(vbss_log_make_coder(r->context, input_capacity, &r->coder));
    return vbss_log_allocate_inputs(r->context, &r->step);
}

vbss_result vbss_record_allocate_log(record_object *r, size_t start_bytes, size_t snapshot_bytes,
                                     const vbss_record_config *c)
{
    r->end_bytes = measure_end(&r->step);
    r->snapshot_interval = c->snapshot_interval;
    /* twice the first size, because states grow: later snapshots then nearly always have
         * room */
    r->log.capacity =
        start_bytes + (size_t)c->buffer_bytes + r->end_bytes + r->max_event_bytes +
        (c->snapshot_interval > 0 ? 2 * vbss_log_max_snapshot_bytes(snapshot_bytes) : 0);
    r->log.bytes = vbss_allocate(r->context, r->log.capacity, 1, "log");
    return r->log.bytes == NULL ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_OK;
}

vbss_result vbss_record_create_handle(record_object *r, vbss_result result, vbss_record **record)
{
    vbss_slot *slot = NULL;
    if (result == VBSS_OK) {
        result = vbss_slot_create(r->context, &kind, r, &slot);
    }
    if (result != VBSS_OK && r != NULL) {
        free_record(r->context, r);
    }
    *record = (vbss_record *)slot;
    return result;
}

static vbss_result begin_log(record_object *r, const scene_info *scene, const vbss_record_config *c,
                             log_header *header)
{
    size_t snapshot = 0;
    VBSS_TRY(fill_header(scene, c, header));
    VBSS_TRY(vbss_snapshot_size((const vbss_slot *)r->scene, &snapshot));
    if (snapshot > LOG_MAX_SNAPSHOT_BYTES) {
        return vbss_fail(r->context, VBSS_ERROR_CAPACITY, "the scene's state is too large");
    }
    VBSS_TRY(vbss_record_allocate_log(
        r, measure_header(header) + vbss_log_max_snapshot_bytes(snapshot), snapshot, c));
    VBSS_TRY(write_header(&r->log, header));
    return write_snapshot(r, snapshot);
}

vbss_result vbss_record_create(vbss_scene *scene, const vbss_record_config *config,
                               vbss_record **record)
{
    VBSS_ENTER_WITH_RESULT(scene, record);
    scene_info info;
    vbss_record_config own;
    record_object *r = NULL;
    if (record == NULL) {
        VBSS_TRY(vbss_scene_inspect(scene, &info));
        return vbss_check_pointer(info.context, record, "record");
    }
    VBSS_TRY(vbss_scene_inspect_for_edit(scene, &info));
    VBSS_TRY(vbss_record_read_config(info.context, config, &own));
    vbss_result result = vbss_record_make(scene, own.hash_interval, own.input_capacity, &r);
    if (result == VBSS_OK) {
        log_header header = {.context = info.context};
        result = begin_log(r, &info, &own, &header);
        vbss_log_free_header(&header);
    }
    return vbss_record_create_handle(r, result, record);
}

vbss_result vbss_record_destroy(vbss_record *record)
{
    VBSS_ENTER(record);
    return vbss_slot_destroy(record, &kind);
}

vbss_result vbss_record_edit(vbss_record *handle, record_object **record)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &kind, &slot));
    *record = slot->object;
    return VBSS_OK;
}

/* ---- steps */

static bool knows_all_edits(const record_object *r)
{
    scene_edit_counts now = vbss_scene_inspect_edits(r->scene);
    return now.scene == r->known_edits.scene && now.threads == r->known_edits.threads &&
           now.graspers == r->known_edits.graspers && now.drains == r->known_edits.drains;
}

vbss_result vbss_record_check_ready(const record_object *r)
{
    if (r->ended) {
        return vbss_fail(r->context, VBSS_ERROR_WRONG_STATE, "the record has ended");
    }
    scene_info info;
    VBSS_TRY(vbss_scene_inspect(r->scene, &info));
    return knows_all_edits(r) ? VBSS_OK
                              : vbss_fail(r->context, VBSS_ERROR_WRONG_STATE,
                                          "the scene was changed past the record after step %llu",
                                          (unsigned long long)r->step.number);
}

/* Whether a step is written in coded form. Large steps, and steps of logs that older libraries
 * began, are written as fields. */
static bool fits_coded(const record_object *r, const log_step *step, size_t *max_bytes)
{
    *max_bytes = vbss_log_max_coded_bytes(step, step->event_count);
    return r->log.format >= LOG_FORMAT_COMPRESSED && *max_bytes <= LOG_MAX_CODED_BYTES &&
           vbss_log_can_encode(step);
}

/* Largest size of a step in either form, without its events: they are not known yet, and decide the
 * form. */
static size_t max_step_bytes(log_step *step)
{
    enum { EVENTS_HEADER = 8 };
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_step(&stream, step);
    size_t plain = log_record_bytes(&stream) + EVENTS_HEADER;
    size_t coded = LOG_CODED_PREFIX_BYTES + vbss_log_max_coded_bytes(step, 0) + LOG_CHECKSUM_BYTES;
    return plain > coded ? plain : coded;
}

static vbss_result write_step(record_object *r, log_step *step)
{
    size_t max_bytes;
    vbss_stream stream;
    if (fits_coded(r, step, &max_bytes)) {
        uint8_t *bytes = vbss_log_begin_coded_step(&r->log);
        vbss_log_end_coded_step(&r->log, vbss_log_encode(r->coder, step, bytes, max_bytes));
        return VBSS_OK;
    }
    vbss_log_begin_record(&r->log, &stream);
    vbss_log_visit_step(&stream, step);
    vbss_log_reset_coder(r->coder);
    return vbss_log_end_record(&r->log, &stream);
}

static vbss_result check_capacity(const record_object *r, log_step *next)
{
    size_t need = max_step_bytes(next) + r->max_event_bytes + r->end_bytes;
    return need <= vbss_log_free_bytes(&r->log)
               ? VBSS_OK
               : vbss_fail(
                     r->context, VBSS_ERROR_CAPACITY,
                     "the log has room for %llu bytes more, the step needs %llu: take it first",
                     (unsigned long long)vbss_log_free_bytes(&r->log), (unsigned long long)need);
}

/* Writes the snapshot that is due, if there is room for it. Otherwise it stays due. */
static void write_due_snapshot(record_object *r)
{
    size_t need = 0;
    if (vbss_snapshot_size((const vbss_slot *)r->scene, &need) == VBSS_OK &&
        need <= LOG_MAX_SNAPSHOT_BYTES &&
        vbss_log_max_snapshot_bytes(need) + r->end_bytes <= vbss_log_free_bytes(&r->log)) {
        r->snapshot_due = write_snapshot(r, need) != VBSS_OK;
    }
}

/* ---- replacements */

static vbss_result reserve(record_object *r, size_t need)
{
    log_writer *log = &r->log;
    const size_t used = log->is_handed_out ? 0 : log->used;
    if (need <= log->capacity - used) {
        return VBSS_OK;
    }
    const size_t capacity = used + need;
    uint8_t *bytes = vbss_allocate(r->context, capacity, 1, "log");
    if (bytes == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    memcpy(bytes, log->bytes, used);
    vbss_release(r->context, log->bytes, log->capacity, 1);
    log->bytes = bytes;
    log->capacity = capacity;
    return VBSS_OK;
}

static vbss_result reserve_for(record_object *r, size_t snapshot)
{
    if (snapshot > LOG_MAX_SNAPSHOT_BYTES) {
        return vbss_fail(r->context, VBSS_ERROR_CAPACITY, "the scene's state is too large");
    }
    return reserve(r,
                   2 * vbss_log_max_snapshot_bytes(snapshot) + r->max_event_bytes + r->end_bytes);
}

vbss_result vbss_record_reserve_replacement(record_object *r)
{
    /* Room for the growth of the state by an edit. Unit: bytes. Origin: a drain of its finest mesh has
     * 10 kB, a thread of the largest scene 2 MB. */
    const size_t growth = (size_t)4 << 20;
    size_t now = 0;
    VBSS_TRY(vbss_snapshot_size((const vbss_slot *)r->scene, &now));
    return reserve_for(r, now + growth);
}

vbss_result vbss_record_append_replacement(record_object *r)
{
    size_t now = 0;
    VBSS_TRY(vbss_snapshot_size((const vbss_slot *)r->scene, &now));
    VBSS_TRY(reserve_for(r, now));
    VBSS_TRY(vbss_log_write_snapshot(r, LOG_REPLACEMENT, (const vbss_slot *)r->scene, now));
    r->step.input_count = 0;
    r->snapshot_is_last = false;
    r->is_replaced = true;
    return VBSS_OK;
}

/* ---- appended steps */

static log_step next_step(const record_object *r, double h)
{
    log_step next = r->step;
    next.number++;
    next.h = h;
    return next;
}

vbss_result vbss_record_check_step(const record_object *r, double h)
{
    log_step next = next_step(r, h);
    return check_capacity(r, &next);
}

vbss_result vbss_record_append_step(record_object *r, double h)
{
    scene_info info;
    log_step next = next_step(r, h);
    next.has_hash = next.number % r->hash_interval == 0;
    next.hash = 0;
    if (next.has_hash) {
        VBSS_TRY(vbss_scene_get_hash(r->scene, &next.hash));
    }
    VBSS_TRY(vbss_scene_inspect(r->scene, &info));
    vbss_log_borrow_events(&next, &info);
    VBSS_TRY(write_step(r, &next));
    r->is_replaced = false;
    next.input_count = next.event_count = 0;
    next.events = NULL; /* the scene may be destroyed before the record */
    r->step = next;
    r->snapshot_is_last = false;
    r->snapshot_due |= r->snapshot_interval > 0 && next.number % r->snapshot_interval == 0;
    if (r->snapshot_due) {
        write_due_snapshot(r);
    }
    return VBSS_OK;
}

vbss_result vbss_record_end(vbss_record *record)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    if (r->ended) {
        return vbss_fail(r->context, VBSS_ERROR_WRONG_STATE, "the record has ended before");
    }
    /* The end has the hash of the scene if it still is in the state after the last step. */
    const vbss_slot *scene = (const vbss_slot *)r->scene;
    log_step last = r->step;
    last.hash = 0;
    last.has_hash =
        scene->object != NULL && last.input_count == 0 && !r->is_replaced && knows_all_edits(r);
    if (last.has_hash) {
        VBSS_TRY(vbss_snapshot_hash(scene, &last.hash));
    }
    vbss_stream stream;
    vbss_log_begin_record(&r->log, &stream);
    vbss_log_visit_end(&stream, &last);
    VBSS_TRY(vbss_log_end_record(&r->log, &stream));
    r->ended = true;
    vbss_record_detach_hook(r);
    return VBSS_OK;
}

vbss_result vbss_record_take(vbss_record *record, const uint8_t **bytes, uint64_t *count)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_check_pointer(r->context, bytes, "bytes"));
    VBSS_TRY(vbss_check_pointer(r->context, count, "count"));
    *bytes = r->log.bytes;
    *count = r->log.is_handed_out ? 0 : r->log.used;
    r->log.is_handed_out = true;
    return VBSS_OK;
}
