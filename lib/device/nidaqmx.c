/* Instrument handles and solenoids on the host's side. All lines are opened together; the adapters
 * then exchange the newest values with the cycle (nidaqmx_cycle.c). */
#include <stdio.h>
#include <string.h>

#include "device/nidaqmx.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/number_text.h"
#include "base/stream.h"
#include "device/tuning.h"

_Static_assert(sizeof(vbss_nidaqmx_config) == VBSS_SIZE_WITH_POINTERS(vbss_nidaqmx_config, 56u, 5u),
               "no hidden padding");
_Static_assert(sizeof(vbss_nidaqmx_status) == 104, "published size");

static const vbss_nidaqmx_config config_defaults = {
    .struct_size = sizeof(vbss_nidaqmx_config),
    .handle_count = 2,
    .first_input = "Dev1/ai0",
    .second_input = "Dev1/ai1",
    .first_line = "Dev1/port0/line0",
    .second_line = "Dev1/port0/line1",
    .terminal = VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED,
    .active_low = 1,
    .own_thread = 1,
    .low = -10.0,
    .high = 10.0,
    .period = 0.002,
};
static const uint32_t config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_nidaqmx_config, 56u, 5u), 0};
static const vbss_layout config_layout = {"vbss_nidaqmx_config", &config_defaults, config_sizes};
static const uint32_t status_sizes[] = {104, 0};
static const vbss_layout status_layout = {"vbss_nidaqmx_status", NULL, status_sizes};

vbss_result vbss_nidaqmx_config_init(vbss_nidaqmx_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

/* ---- closing */

static void close_lines(nidaqmx_object *o)
{
    if (o->has_thread) {
        atomic_store_explicit(&o->stop_requested, true, memory_order_release);
        vbss_device_join_thread(&o->thread);
    }
    vbss_nidaqmx_close_tasks(o);
    vbss_device_unload_library(o->daq.library);
}

static void free_lines(vbss_context *context, void *object)
{
    nidaqmx_object *o = object;
    close_lines(o);
    /* Devices that still use an adapter then find their hardware lost. */
    for (uint32_t i = 0; i < DAQ_HANDLES; i++) {
        if (o->handles[i].is_slot_filled) {
            vbss_slot_empty(o->handles[i].slot);
        }
    }
    vbss_release(context, o, 1, sizeof *o);
}

/* Hardware cannot be restored to an earlier state, so nothing else is saved. */
static void visit_lines(vbss_stream *stream, void *object)
{
    const nidaqmx_object *o = object;
    vbss_stream_expect(stream, 1, o->handle_count);
}

static const vbss_kind kind = {
    "handle lines", VBSS_CODE('D', 'A', 'Q', 'S'), 1, free_lines, visit_lines, NULL};

/* The slot of an instrument handle owns nothing: the lines free the handle. */
static void release_nothing(vbss_context *context, void *object)
{
    (void)context;
    (void)object;
}

static void visit_handle(vbss_stream *stream, void *object)
{
    const daq_handle *h = object;
    vbss_stream_expect(stream, 1, h->handle_index);
}

static const vbss_kind handle_kind = {
    "handle line", VBSS_CODE('D', 'A', 'Q', '1'), 1, release_nothing, visit_handle, NULL};

/* ---- opening */

static vbss_result read_name(vbss_context *context, const char *from, char *to, const char *what)
{
    VBSS_TRY(vbss_check_pointer(context, from, what));
    VBSS_TRY(vbss_check_range(context, (double)strlen(from), 1.0, DAQ_NAME_BYTES - 1.0, what));
    vbss_device_copy_text(to, DAQ_NAME_BYTES, from);
    return VBSS_OK;
}

static vbss_result read_names(nidaqmx_object *o)
{
    const vbss_nidaqmx_config *c = &o->config;
    const char *const inputs[DAQ_HANDLES] = {c->first_input, c->second_input};
    const char *const lines[DAQ_HANDLES] = {c->first_line, c->second_line};
    o->handle_count = c->handle_count;
    for (uint32_t i = 0; i < o->handle_count && i < DAQ_HANDLES; i++) {
        VBSS_TRY(read_name(o->context, inputs[i], o->inputs[i], "name of an input"));
        if (lines[i] != NULL) {
            VBSS_TRY(read_name(o->context, lines[i], o->lines[i], "name of a line"));
            o->has_lines = true;
        }
    }
    return VBSS_OK;
}

static vbss_result read_config(nidaqmx_object *o, const vbss_nidaqmx_config *config)
{
    vbss_context *context = o->context;
    vbss_nidaqmx_config *c = &o->config;
    *c = config_defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, c));
    }
    VBSS_TRY(vbss_check_range(context, c->handle_count, 1.0, DAQ_HANDLES, "handle_count"));
    VBSS_TRY(vbss_check_range(context, c->terminal, VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED,
                              VBSS_NIDAQMX_TERMINAL_DIFFERENTIAL, "terminal"));
    VBSS_TRY(vbss_check_range(context, c->active_low, 0.0, 1.0, "active_low"));
    VBSS_TRY(vbss_check_range(context, c->own_thread, 0.0, 1.0, "own_thread"));
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_range(context, c->low, -10.0, 10.0, "low"));
    VBSS_TRY(vbss_check_range(context, c->high, c->low + 1e-3, 10.0, "high"));
    VBSS_TRY(vbss_check_range(context, c->period, 5e-4, 1.0, "period"));
    if (c->timeout != 0.0) {
        VBSS_TRY(vbss_check_range(context, c->timeout, 1e-3, 10.0, "timeout"));
    }
    o->timeout = c->timeout != 0.0 ? c->timeout : DEVICE_DAQ_FIRST_TIMEOUT;
    return read_names(o);
}

static vbss_result open_all(nidaqmx_object *o)
{
    VBSS_TRY(vbss_nidaqmx_load(o->context, o->config.library, &o->daq));
    if (!vbss_nidaqmx_name_channel(o)) {
        return vbss_fail(o->context, VBSS_ERROR_DEVICE,
                         "NI-DAQmx Base: %s, %s are not lines 0 to 7 of one port, as in "
                         "Dev1/port0/line0",
                         o->lines[0], o->lines[1]);
    }
    const char *what = "";
    const int32_t code = vbss_nidaqmx_open_tasks(o, &what);
    VBSS_TRY(vbss_nidaqmx_check(o->context, &o->daq, code, what));
    if (o->config.own_thread == 0) {
        return VBSS_OK;
    }
    o->thread = (device_thread){.run = vbss_nidaqmx_run, .user = o};
    o->has_thread = vbss_device_start_thread(&o->thread);
    return o->has_thread ? VBSS_OK
                         : vbss_fail(o->context, VBSS_ERROR_DEVICE, "NI-DAQmx: no thread for it");
}

static void init_buffers(nidaqmx_object *o)
{
    atomic_init(&o->stop_requested, false);
    vbss_triple_buffer_init(&o->to_host);
    o->report.status.struct_size = sizeof o->report.status;
    for (int i = 0; i < 3; i++) {
        o->reports[i] = o->report;
    }
    for (uint32_t i = 0; i < DAQ_HANDLES; i++) {
        o->handles[i].owner = o;
        o->handles[i].handle_index = i;
        vbss_triple_buffer_init(&o->handles[i].to_cycle);
    }
}

static vbss_result reserve_slots(nidaqmx_object *o, vbss_slot **slot)
{
    for (uint32_t i = 0; i < o->handle_count; i++) {
        VBSS_TRY(vbss_slot_reserve(o->context, &handle_kind, &o->handles[i].slot));
    }
    /* last, because a context destroys its newest object first */
    return vbss_slot_reserve(o->context, &kind, slot);
}

vbss_result vbss_nidaqmx_create(vbss_context *context, const vbss_nidaqmx_config *config,
                                vbss_nidaqmx **nidaqmx)
{
    VBSS_ENTER_WITH_RESULT(context, nidaqmx);
    if (nidaqmx == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, nidaqmx, "nidaqmx");
    }
    VBSS_TRY(vbss_context_edit(context));
    nidaqmx_object *o = vbss_allocate(context, 1, sizeof *o, "handle lines");
    if (o == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_slot *slot = NULL;
    o->context = context;
    init_buffers(o);
    vbss_result result = read_config(o, config);
    result = result == VBSS_OK ? reserve_slots(o, &slot) : result;
    result = result == VBSS_OK ? open_all(o) : result; /* last: acts on hardware */
    if (result != VBSS_OK) {
        free_lines(context, o);
        return result;
    }
    for (uint32_t i = 0; i < o->handle_count; i++) {
        vbss_slot_fill(o->handles[i].slot, &o->handles[i]);
        o->handles[i].is_slot_filled = true;
    }
    vbss_slot_fill(slot, o);
    *nidaqmx = (vbss_nidaqmx *)slot;
    return VBSS_OK;
}

vbss_result vbss_nidaqmx_destroy(vbss_nidaqmx *nidaqmx)
{
    VBSS_ENTER(nidaqmx);
    return vbss_slot_destroy(nidaqmx, &kind);
}

static vbss_result open_daq(const void *user, nidaqmx_object **o)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(user, &kind, &slot));
    *o = slot->object;
    return VBSS_OK;
}

/* ---- adapters
 *
 * `user` is the slot of an instrument handle. Its memory stays valid after the lines are closed,
 * so a device that still uses the adapter gets an error. */

static const daq_report *newest_report(nidaqmx_object *o)
{
    vbss_triple_buffer_fetch(&o->to_host);
    return &o->reports[o->to_host.reader];
}

static vbss_result open_handle(void *user, daq_handle **h)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(user, &handle_kind, &slot));
    *h = slot->object;
    return VBSS_OK;
}

static void send_command(daq_handle *h, bool on, double expires)
{
    h->commands[h->to_cycle.writer] = (handle_command){on, expires};
    vbss_triple_buffer_publish(&h->to_cycle);
}

static vbss_result handle_open(void *user)
{
    VBSS_ENTER(user);
    daq_handle *h;
    VBSS_TRY(open_handle(user, &h));
    if (h->is_attached) {
        vbss_device_copy_text(h->text, sizeof h->text, "another device stands on this handle");
        return VBSS_ERROR_DEVICE;
    }
    h->is_attached = true;
    return VBSS_OK;
}

static void handle_close(void *user)
{
    daq_handle *h;
    if (open_handle(user, &h) == VBSS_OK) {
        send_command(h, false, 0.0);
        h->is_attached = false;
    }
}

static vbss_result handle_describe(void *user, vbss_device_capabilities *capabilities)
{
    VBSS_ENTER(user);
    daq_handle *h;
    VBSS_TRY(open_handle(user, &h));
    capabilities->signals = VBSS_DEVICE_HAS_JAW_RAW;
    capabilities->outputs =
        h->owner->lines[h->handle_index][0] != '\0' ? VBSS_DEVICE_OUT_SOLENOID : 0u;
    capabilities->input_dof = 1;
    capabilities->update_rate = 1.0 / h->owner->config.period;
    return VBSS_OK;
}

/* Says what the last failure was and, for a timeout, what the user can do. */
static void explain_failure(daq_handle *h, const vbss_nidaqmx_status *s, bool has_late_reads)
{
    char hint[64] = "";
    const vbss_number_text timeout = vbss_format_number(1e3 * s->timeout, 3);
    if (has_late_reads && h->owner->config.timeout != 0.0) {
        snprintf(hint, sizeof hint, ": the timeout of %.9s ms is too short", timeout.text);
    } else if (has_late_reads) {
        snprintf(hint, sizeof hint, ": a call may take %.9s ms from now on", timeout.text);
    }
    snprintf(h->text, sizeof h->text, "%s (%d)%s", vbss_nidaqmx_error_name(s->error), s->error,
             hint);
}

static void explain_report(daq_handle *h, const daq_report *r)
{
    const vbss_nidaqmx_status *s = &r->status;
    if (s->state == VBSS_HAPTICS_STATE_RUNNING && r->is_slow) {
        snprintf(h->text, sizeof h->text,
                 "rounds of %.9s ms: solenoids go off up to %.9s ms after the last command",
                 vbss_format_number(1e3 * s->round_time, 3).text,
                 vbss_format_number(1e3 * s->off_time, 3).text);
    } else if (s->state == VBSS_HAPTICS_STATE_WAITING && s->error == 0) {
        vbss_device_copy_text(h->text, sizeof h->text, "nothing was measured yet");
    } else if (s->state != VBSS_HAPTICS_STATE_RUNNING) {
        explain_failure(h, s, r->has_late_reads);
    }
}

static vbss_result handle_read(void *user, double now, vbss_device_sample *sample)
{
    VBSS_ENTER(user);
    daq_handle *h;
    (void)now;
    if (open_handle(user, &h) != VBSS_OK) {
        sample->flags = VBSS_DEVICE_FLAG_LOST;
        return VBSS_ERROR_DEVICE;
    }
    const daq_report *r = newest_report(h->owner);
    sample->valid = VBSS_DEVICE_HAS_JAW_RAW;
    sample->time = r->time;
    sample->jaw_raw = r->volts[h->handle_index];
    sample->flags = r->status.state == VBSS_HAPTICS_STATE_LOST ? VBSS_DEVICE_FLAG_LOST : 0u;
    sample->flags |= r->is_slow ? VBSS_DEVICE_FLAG_SLOW : 0u;
    explain_report(h, r);
    return r->status.state == VBSS_HAPTICS_STATE_RUNNING ? VBSS_OK : VBSS_ERROR_DEVICE;
}

static vbss_result handle_write(void *user, double now, const vbss_output_result *output)
{
    VBSS_ENTER(user);
    daq_handle *h;
    (void)now;
    VBSS_TRY(open_handle(user, &h));
    send_command(h, output->solenoid != 0, output->expires);
    return VBSS_OK;
}

static void handle_explain(void *user, char *text, uint32_t bytes)
{
    daq_handle *h;
    bool is_open = open_handle(user, &h) == VBSS_OK;
    vbss_device_copy_text(text, bytes, is_open ? h->text : "the lines were closed");
}

vbss_result vbss_nidaqmx_get_adapter(vbss_nidaqmx *nidaqmx, uint32_t which,
                                     vbss_device_adapter *adapter)
{
    VBSS_ENTER(nidaqmx);
    nidaqmx_object *o;
    VBSS_TRY(open_daq(nidaqmx, &o));
    if (which >= o->handle_count) {
        return vbss_fail(o->context, VBSS_ERROR_NOT_FOUND, "there is no handle %u", which);
    }
    const vbss_device_adapter own = {
        .struct_size = sizeof own,
        .name = "handle",
        .user = o->handles[which].slot,
        .open = handle_open,
        .close = handle_close,
        .describe = handle_describe,
        .read = handle_read,
        .write = handle_write,
        .explain = handle_explain,
    };
    return vbss_device_export_adapter(o->context, &own, adapter);
}

/* ---- public functions */

vbss_result vbss_nidaqmx_poll(vbss_nidaqmx *nidaqmx, double now)
{
    VBSS_ENTER(NULL); /* the context may be in use by another thread */
    nidaqmx_object *o;
    VBSS_TRY(open_daq(nidaqmx, &o));
    if (!isfinite(now)) {
        return VBSS_ERROR_NOT_FINITE;
    }
    if (o->has_thread) {
        return VBSS_ERROR_WRONG_STATE;
    }
    if (fabs(now) > 1e9) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    vbss_nidaqmx_cycle(o, now);
    return VBSS_OK;
}

vbss_result vbss_nidaqmx_get_status(vbss_nidaqmx *nidaqmx, vbss_nidaqmx_status *status,
                                    uint32_t struct_size)
{
    VBSS_ENTER(nidaqmx);
    nidaqmx_object *o;
    VBSS_TRY(open_daq(nidaqmx, &o));
    return vbss_struct_write(o->context, &status_layout, &newest_report(o)->status, status,
                             struct_size);
}
