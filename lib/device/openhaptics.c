/* Haptic arms on the host's side. All arms are opened together, because one servo drives them; the
 * adapters then exchange the newest values with it. */
#include <stdio.h>

#include "device/openhaptics.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"
#include "device/tuning.h"

_Static_assert(sizeof(vbss_openhaptics_config) == 16 + 6 * sizeof(void *), "no hidden padding");
_Static_assert(sizeof(vbss_openhaptics_status) == 112, "published size");

static const vbss_openhaptics_config config_defaults = {
    .struct_size = sizeof(vbss_openhaptics_config),
    .device_count = 1,
    .rate = 1000,
    .second_name = "Device2",
};
static const uint32_t config_sizes[] = {16u + 6u * (uint32_t)sizeof(void *), 0};
static const vbss_layout config_layout = {"vbss_openhaptics_config", &config_defaults,
                                          config_sizes};
static const uint32_t status_sizes[] = {112, 0};
static const vbss_layout status_layout = {"vbss_openhaptics_status", NULL, status_sizes};

vbss_result vbss_openhaptics_config_init(vbss_openhaptics_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

/* ---- closing */

/* Waits until the servo has put out zero forces, and stops it. */
static void end_servo(openhaptics_object *o)
{
    atomic_store_explicit(&o->stop_requested, true, memory_order_release);
    for (int i = 0; o->is_started && i < DEVICE_SERVO_STOP_TIME; i++) {
        if (atomic_load_explicit(&o->has_stopped, memory_order_acquire)) {
            break;
        }
        o->hd.wait_for_completion(o->callback, HD_CHECK_STATUS);
        vbss_device_sleep(1e-3);
    }
    if (o->is_started) {
        o->hd.stop_scheduler();
    }
    if (o->is_scheduled) {
        o->hd.unschedule(o->callback);
    }
}

static void close_arms(openhaptics_object *o)
{
    end_servo(o);
    for (uint32_t i = o->arm_count; i > 0; i--) {
        haptic_arm *a = &o->arms[i - 1];
        if (a->is_open) {
            o->hd.make_current_device(a->device);
            o->hd.disable(HD_FORCE_OUTPUT);
            o->hd.disable_device(a->device);
        }
    }
    /* Clears errors from closing, so that the next object does not report them. */
    if (o->arm_count > 0) {
        vbss_openhaptics_check(NULL, &o->hd, "the end");
    }
    vbss_device_unload_library(o->hd.library);
}

static void free_arms(vbss_context *context, void *object)
{
    openhaptics_object *o = object;
    close_arms(o);
    /* Devices that still use an adapter then find their hardware lost. */
    for (uint32_t i = 0; i < OPENHAPTICS_ARMS; i++) {
        if (o->arms[i].is_slot_filled) {
            vbss_slot_empty(o->arms[i].slot);
        }
    }
    vbss_release(context, object, 1, sizeof(openhaptics_object));
}

/* Hardware cannot be restored to an earlier state, so nothing else is saved. */
static void visit_arms(vbss_stream *stream, void *object)
{
    openhaptics_object *o = object;
    vbss_stream_expect(stream, 1, o->arm_count);
}

static const vbss_kind kind = {
    "haptic arms", VBSS_CODE('H', 'A', 'R', 'M'), 1, free_arms, visit_arms, NULL};

/* The slot of an arm owns nothing: the arms are freed together. */
static void release_nothing(vbss_context *context, void *object)
{
    (void)context;
    (void)object;
}

static void visit_arm(vbss_stream *stream, void *object)
{
    const haptic_arm *a = object;
    vbss_stream_expect(stream, 1, a->device);
}

static const vbss_kind arm_kind = {
    "haptic arm", VBSS_CODE('H', 'A', 'R', '1'), 1, release_nothing, visit_arm, NULL};

/* ---- opening */

static void copy_text(char *to, const char *from)
{
    vbss_device_copy_text(to, ARM_NAME_BYTES, from != NULL ? from : "");
}

static double positive_or_zero(double value, double limit)
{
    return isfinite(value) && value > 0.0 ? vbss_min(value, limit) : 0.0;
}

/* Gets name and capabilities from the vendor's library. Implausible numbers count as unknown. */
static void describe_arm(openhaptics_object *o, haptic_arm *a)
{
    double max_force = 0.0, continuous_force = 0.0, workspace_mm[6] = {0.0};
    int32_t input = 0, output = 0;
    o->hd.get_doublev(HD_NOMINAL_MAX_FORCE, &max_force);
    o->hd.get_doublev(HD_NOMINAL_MAX_CONTINUOUS_FORCE, &continuous_force);
    o->hd.get_doublev(HD_MAX_WORKSPACE_DIMENSIONS, workspace_mm);
    o->hd.get_integerv(HD_INPUT_DOF, &input);
    o->hd.get_integerv(HD_OUTPUT_DOF, &output);
    o->hd.get_integerv(HD_CALIBRATION_STYLE, &a->calibration_style);
    const char *model = o->hd.get_string(HD_DEVICE_MODEL_TYPE);
    copy_text(a->model, model);
    const char *serial = o->hd.get_string(HD_DEVICE_SERIAL_NUMBER);
    copy_text(a->serial, serial);
    const uint32_t styles = (uint32_t)a->calibration_style;
    a->calibration_style = (styles & HD_STYLE_INKWELL) != 0 ? HD_STYLE_INKWELL
                           : (styles & HD_STYLE_AUTO) != 0  ? HD_STYLE_AUTO
                                                            : HD_STYLE_ENCODER_RESET;
    a->capabilities = (vbss_device_capabilities){
        .struct_size = sizeof a->capabilities,
        .signals = DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS | VBSS_DEVICE_HAS_BUTTONS |
                   VBSS_DEVICE_HAS_TEMPERATURE,
        .outputs = VBSS_DEVICE_OUT_FORCE,
        .input_dof = (uint32_t)(input > 0 ? input : 0),
        .output_dof = (uint32_t)(output > 0 ? output : 0),
        .max_force = positive_or_zero(max_force, 1e3),
        .max_continuous_force = positive_or_zero(continuous_force, 1e3),
        .update_rate = o->config.rate,
    };
    for (int i = 0; i < 3; i++) {
        if (fabs(workspace_mm[i]) < 1e5 && workspace_mm[i + 3] > workspace_mm[i] &&
            workspace_mm[i + 3] < 1e5) {
            a->capabilities.workspace_low[i] = 1e-3 * workspace_mm[i];
            a->capabilities.workspace_high[i] = 1e-3 * workspace_mm[i + 3];
        }
    }
    const vbss_device_capabilities *c = &a->capabilities;
    vbss_output_config *l = &a->limits;
    l->max_force = c->max_force > 0.0 ? vbss_min(l->max_force, c->max_force) : l->max_force;
    l->continuous_force = c->max_continuous_force > 0.0
                              ? vbss_min(l->continuous_force, c->max_continuous_force)
                              : l->continuous_force;
}

static void init_arm(haptic_arm *a)
{
    vbss_triple_buffer_init(&a->to_servo);
    vbss_triple_buffer_init(&a->to_host);
    (void)vbss_device_sample_init(&a->sample, sizeof a->sample);
    a->sample.valid = a->capabilities.signals;
    for (int i = 0; i < 3; i++) {
        a->reports[i].sample = a->sample;
        a->reports[i].status.struct_size = sizeof a->status;
    }
    a->status.struct_size = sizeof a->status;
    vbss_output_init_state(&a->limits, &a->output);
}

/* Some drivers have no default device, but one of these names. */
static const char *const default_names[] = {NULL, "Default Device", "Default PHANToM"};
enum { DEFAULT_NAMES = sizeof default_names / sizeof default_names[0] };

/* Opens the arm by the first of some names that the driver knows. Reports the error of the first
 * name. */
static vbss_result init_device(openhaptics_object *o, haptic_arm *a, const char *const *names,
                               int count, const char *what)
{
    vbss_result first = VBSS_OK;
    for (int i = 0; i < count && !a->is_open; i++) {
        a->device = o->hd.init_device(names[i]);
        vbss_result result = vbss_openhaptics_check(i == 0 ? o->context : NULL, &o->hd, what);
        a->is_open = a->device != HD_NO_DEVICE && result == VBSS_OK;
        first = i == 0 ? result : first;
    }
    if (!a->is_open && first == VBSS_OK) {
        return vbss_fail(o->context, VBSS_ERROR_DEVICE, "OpenHaptics: %s is not there", what);
    }
    return a->is_open ? VBSS_OK : first;
}

static vbss_result open_arm(openhaptics_object *o, haptic_arm *a, const char *name)
{
    char what[DEVICE_TEXT_BYTES];
    snprintf(what, sizeof what, "device '%.80s'%s", name != NULL ? name : "default",
             name != NULL ? "" : " (nor 'Default Device', 'Default PHANToM')");
    VBSS_TRY(name != NULL ? init_device(o, a, &name, 1, what)
                          : init_device(o, a, default_names, DEFAULT_NAMES, what));
    o->hd.make_current_device(a->device);
    o->hd.enable(HD_FORCE_OUTPUT);
    describe_arm(o, a);
    init_arm(a);
    return vbss_openhaptics_check(o->context, &o->hd, what);
}

/* Opens the arms, schedules the callback, then starts the scheduler. */
static vbss_result open_arms(openhaptics_object *o)
{
    const char *const names[OPENHAPTICS_ARMS] = {o->config.first_name, o->config.second_name};
    VBSS_TRY(vbss_openhaptics_load(o->context, o->config.library, &o->hd));
    for (uint32_t i = 0; i < o->config.device_count && i < OPENHAPTICS_ARMS; i++) {
        o->arm_count++;
        VBSS_TRY(open_arm(o, &o->arms[i], names[i]));
    }
    o->hd.set_scheduler_rate(o->config.rate);
    VBSS_TRY(vbss_openhaptics_check(o->context, &o->hd, "rate of the servo"));
    o->callback = o->hd.schedule(vbss_openhaptics_tick, o, HD_MAX_PRIORITY);
    VBSS_TRY(vbss_openhaptics_check(o->context, &o->hd, "a place in the servo"));
    o->is_scheduled = true;
    o->hd.start_scheduler();
    o->is_started = true;
    return vbss_openhaptics_check(o->context, &o->hd, "begin of the servo");
}

static vbss_result read_config(openhaptics_object *wanted, const vbss_openhaptics_config *config)
{
    vbss_context *context = wanted->context;
    vbss_output_config limits;
    wanted->config = config_defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, &wanted->config));
    }
    VBSS_TRY(vbss_check_range(context, wanted->config.device_count, 1.0, OPENHAPTICS_ARMS,
                              "device_count"));
    VBSS_TRY(vbss_check_range(context, wanted->config.rate, 100.0, 8000.0, "rate"));
    VBSS_TRY(vbss_check_range(context, wanted->config.reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_output_config_init(&limits, sizeof limits));
    if (wanted->config.output != NULL) {
        VBSS_TRY(
            vbss_config_read(context, &vbss_output_config_layout, wanted->config.output, &limits));
    }
    VBSS_TRY(vbss_output_check_config(context, &limits));
    for (int i = 0; i < OPENHAPTICS_ARMS; i++) {
        wanted->arms[i].limits = limits;
    }
    return VBSS_OK;
}

vbss_result vbss_openhaptics_create(vbss_context *context, const vbss_openhaptics_config *config,
                                    vbss_openhaptics **openhaptics)
{
    VBSS_ENTER_WITH_RESULT(context, openhaptics);
    if (openhaptics == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, openhaptics, "openhaptics");
    }
    VBSS_TRY(vbss_context_edit(context));
    openhaptics_object *o = vbss_allocate(context, 1, sizeof *o, "haptic arms");
    if (o == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    o->context = context;
    atomic_init(&o->stop_requested, false);
    atomic_init(&o->has_stopped, false);
    vbss_slot *slot = NULL;
    vbss_result result = read_config(o, config);
    for (uint32_t i = 0; result == VBSS_OK && i < o->config.device_count && i < OPENHAPTICS_ARMS;
         i++) {
        result = vbss_slot_reserve(context, &arm_kind, &o->arms[i].slot);
    }
    if (result == VBSS_OK) { /* last, because a context destroys its newest object first */
        result = vbss_slot_reserve(context, &kind, &slot);
    }
    if (result == VBSS_OK) { /* acts on hardware, so all else comes before */
        result = open_arms(o);
    }
    /* the host may free its strings after this call */
    o->config.library = o->config.first_name = o->config.second_name = NULL;
    o->config.output = NULL;
    if (result != VBSS_OK) {
        free_arms(context, o);
        return result;
    }
    for (uint32_t i = 0; i < o->arm_count; i++) {
        vbss_slot_fill(o->arms[i].slot, &o->arms[i]);
        o->arms[i].is_slot_filled = true;
    }
    vbss_slot_fill(slot, o);
    *openhaptics = (vbss_openhaptics *)slot;
    return VBSS_OK;
}

vbss_result vbss_openhaptics_destroy(vbss_openhaptics *openhaptics)
{
    VBSS_ENTER(openhaptics);
    return vbss_slot_destroy(openhaptics, &kind);
}

static vbss_result open_arm_at(const void *handle, uint32_t which, openhaptics_object **o,
                               haptic_arm **a)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &kind, &slot));
    *o = slot->object;
    if (which >= (*o)->arm_count) {
        (void)vbss_fail((*o)->context, VBSS_ERROR_NOT_FOUND, "there is no arm %u", which);
        return VBSS_ERROR_NOT_FOUND;
    }
    *a = &(*o)->arms[which];
    return VBSS_OK;
}

/* ---- adapters
 *
 * `user` is the slot of an arm. Its memory stays valid after the arms are closed, so a device that
 * still uses the adapter gets an error. */

static const arm_report *newest_report(haptic_arm *a)
{
    vbss_triple_buffer_fetch(&a->to_host);
    return &a->reports[a->to_host.reader];
}

static vbss_result open_arm_handle(void *user, haptic_arm **a)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(user, &arm_kind, &slot));
    *a = slot->object;
    return VBSS_OK;
}

static void set_failure_text(haptic_arm *a, const char *text)
{
    vbss_device_copy_text(a->text, sizeof a->text, text);
}

static void send_command(haptic_arm *a, const arm_command *wanted)
{
    a->commands[a->to_servo.writer] = *wanted;
    vbss_triple_buffer_publish(&a->to_servo);
}

static vbss_result arm_open(void *user)
{
    VBSS_ENTER(user);
    haptic_arm *a;
    VBSS_TRY(open_arm_handle(user, &a));
    if (a->is_attached) {
        set_failure_text(a, "another device stands on this arm");
        return VBSS_ERROR_DEVICE;
    }
    a->is_attached = true;
    return VBSS_OK;
}

static void arm_close(void *user)
{
    haptic_arm *a;
    if (open_arm_handle(user, &a) == VBSS_OK) {
        send_command(a, &(arm_command){.is_given = true});
        a->is_attached = false;
    }
}

static vbss_result arm_describe(void *user, vbss_device_capabilities *capabilities)
{
    VBSS_ENTER(user);
    haptic_arm *a;
    VBSS_TRY(open_arm_handle(user, &a));
    *capabilities = a->capabilities;
    return VBSS_OK;
}

/* Says what the user must do, or what the vendor's last error was. */
static void explain_status(haptic_arm *a, const vbss_openhaptics_status *s)
{
    if (s->ticks == 0) {
        set_failure_text(a, "the servo has not begun yet");
    } else if (s->state == VBSS_HAPTICS_STATE_UNCALIBRATED && s->is_constant != 0) {
        set_failure_text(a, "the arm gives a constant pose: not calibrated, or nobody holds it");
    } else if (s->state == VBSS_HAPTICS_STATE_UNCALIBRATED) {
        set_failure_text(a, "not calibrated: put the stylus into the inkwell");
    } else if (s->error != 0) {
        snprintf(a->text, sizeof a->text, "%s (0x%04x, %d)", vbss_openhaptics_error_name(s->error),
                 s->error, s->internal_error);
    }
}

static vbss_result arm_read(void *user, double now, vbss_device_sample *sample)
{
    VBSS_ENTER(user);
    haptic_arm *a;
    (void)now;
    if (open_arm_handle(user, &a) != VBSS_OK) {
        sample->flags = VBSS_DEVICE_FLAG_LOST;
        return VBSS_ERROR_DEVICE;
    }
    const arm_report *r = newest_report(a);
    explain_status(a, &r->status);
    *sample = r->sample;
    return r->status.ticks == 0 || r->status.state == VBSS_HAPTICS_STATE_LOST ? VBSS_ERROR_DEVICE
                                                                              : VBSS_OK;
}

static vbss_result arm_write(void *user, double now, const vbss_output_result *output)
{
    VBSS_ENTER(user);
    haptic_arm *a;
    (void)now;
    VBSS_TRY(open_arm_handle(user, &a));
    send_command(a, &(arm_command){.is_given = true, .force = vec3_load(output->force)});
    return VBSS_OK;
}

static vbss_result arm_couple(void *user, double now, const vbss_output_result *output,
                              const vbss_device_coupling *coupling)
{
    VBSS_ENTER(user);
    haptic_arm *a;
    (void)now;
    VBSS_TRY(open_arm_handle(user, &a));
    send_command(a, &(arm_command){true, true, vec3_load(output->force), *coupling});
    return VBSS_OK;
}

static void arm_explain(void *user, char *text, uint32_t bytes)
{
    haptic_arm *a;
    bool is_open = open_arm_handle(user, &a) == VBSS_OK;
    vbss_device_copy_text(text, bytes, is_open ? a->text : "the arms were closed");
}

vbss_result vbss_openhaptics_get_adapter(vbss_openhaptics *openhaptics, uint32_t which,
                                         vbss_device_adapter *adapter)
{
    VBSS_ENTER(openhaptics);
    openhaptics_object *o;
    haptic_arm *a;
    VBSS_TRY(open_arm_at(openhaptics, which, &o, &a));
    const vbss_device_adapter own = {
        .struct_size = sizeof own,
        .name = "haptic arm",
        .user = a->slot,
        .open = arm_open,
        .close = arm_close,
        .describe = arm_describe,
        .read = arm_read,
        .write = arm_write,
        .explain = arm_explain,
        .couple = arm_couple,
    };
    return vbss_device_export_adapter(o->context, &own, adapter);
}

/* ---- public functions */

vbss_result vbss_openhaptics_get_status(vbss_openhaptics *openhaptics, uint32_t which,
                                        vbss_openhaptics_status *status, uint32_t struct_size)
{
    VBSS_ENTER(openhaptics);
    openhaptics_object *o;
    haptic_arm *a;
    VBSS_TRY(open_arm_at(openhaptics, which, &o, &a));
    return vbss_struct_write(o->context, &status_layout, &newest_report(a)->status, status,
                             struct_size);
}

vbss_result vbss_openhaptics_get_identity(vbss_openhaptics *openhaptics, uint32_t which,
                                          const char **model, const char **serial)
{
    VBSS_ENTER(openhaptics);
    openhaptics_object *o;
    haptic_arm *a;
    VBSS_TRY(open_arm_at(openhaptics, which, &o, &a));
    if (model != NULL) {
        *model = a->model;
    }
    if (serial != NULL) {
        *serial = a->serial;
    }
    return VBSS_OK;
}
