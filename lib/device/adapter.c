/* Calls the functions of adapters, and defines the structs that are passed to them. */
#include <string.h>

#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_device_sample) == 160, "published size");
_Static_assert(sizeof(vbss_device_capabilities) == 128, "published size");
_Static_assert(sizeof(vbss_device_adapter) == 8 + 9 * sizeof(void *), "no hidden padding");
_Static_assert(sizeof(vbss_output_result) <= DEVICE_BUFFER_BYTES, "room for all structs");

static const vbss_device_adapter adapter_defaults = {.struct_size = sizeof(vbss_device_adapter)};
static const uint32_t adapter_sizes[] = {8u + 9u * (uint32_t)sizeof(void *), 0};
const vbss_layout vbss_device_adapter_layout = {"vbss_device_adapter", &adapter_defaults,
                                                adapter_sizes};

static const vbss_device_sample sample_defaults = {.struct_size = sizeof(vbss_device_sample),
                                                   .orientation = {1.0, 0.0, 0.0, 0.0}};
static const uint32_t sample_sizes[] = {160, 0};
const vbss_layout vbss_device_sample_layout = {"vbss_device_sample", &sample_defaults,
                                               sample_sizes};

static const vbss_device_capabilities capabilities_defaults = {
    .struct_size = sizeof(vbss_device_capabilities)};
static const uint32_t capabilities_sizes[] = {128, 0};
const vbss_layout vbss_device_capabilities_layout = {"vbss_device_capabilities",
                                                     &capabilities_defaults, capabilities_sizes};

vbss_result vbss_device_adapter_init(vbss_device_adapter *adapter, uint32_t struct_size)
{
    return vbss_config_init(&vbss_device_adapter_layout, adapter, struct_size);
}

vbss_result vbss_device_sample_init(vbss_device_sample *sample, uint32_t struct_size)
{
    return vbss_config_init(&vbss_device_sample_layout, sample, struct_size);
}

vbss_result vbss_device_capabilities_init(vbss_device_capabilities *capabilities,
                                          uint32_t struct_size)
{
    return vbss_config_init(&vbss_device_capabilities_layout, capabilities, struct_size);
}

vbss_result vbss_device_check_adapter(vbss_context *context, const vbss_device_adapter *a,
                                      bool first)
{
    VBSS_TRY(vbss_check_range(context, a->reserved, 0.0, 0.0, "reserved"));
    if (a->read == NULL && (first || a->write == NULL)) {
        return vbss_fail(context, VBSS_ERROR_NULL_ARGUMENT, "the adapter has no function 'read'");
    }
    return VBSS_OK;
}

vbss_result vbss_device_export_adapter(vbss_context *context, const vbss_device_adapter *own,
                                       vbss_device_adapter *adapter)
{
    VBSS_TRY(vbss_check_pointer(context, adapter, "adapter"));
    uint32_t struct_size = adapter->struct_size;
    VBSS_TRY(vbss_struct_write(context, &vbss_device_adapter_layout, own, adapter, struct_size));
    adapter->struct_size = struct_size;
    return VBSS_OK;
}

/* An adapter with a newer header reads zeros in fields that this library does not know. */
static void *clear_buffer(device_source *s)
{
    return memset(s->buffer, 0, DEVICE_BUFFER_BYTES);
}

/* ---- names and explanations */

void vbss_device_copy_text(char *to, size_t capacity, const char *from)
{
    size_t bytes = strlen(from);
    bytes = bytes < capacity ? bytes : capacity - 1;
    memcpy(to, from, bytes);
    to[bytes] = '\0';
}

void vbss_device_record_failure(vbss_context *context, device_source *s, vbss_result result)
{
    s->last_failure = result;
    memset(s->text, 0, sizeof s->text);
    if (s->adapter.explain != NULL) {
        bool outer = vbss_callback_begin(context);
        s->adapter.explain(s->adapter.user, s->text, DEVICE_TEXT_BYTES);
        vbss_callback_end(context, outer);
        s->text[DEVICE_TEXT_BYTES - 1] = '\0'; /* the adapter may not have terminated it */
    }
}

static vbss_result fail_source(vbss_context *context, device_source *s, vbss_result result,
                               const char *what)
{
    vbss_device_record_failure(context, s, result);
    return vbss_fail(context, VBSS_ERROR_DEVICE, "%s %s: %d, %s", s->name, what, result,
                     s->text[0] == '\0' ? "no reason is given" : s->text);
}

/* ---- opening and closing */

static vbss_result call_open(vbss_context *context, device_source *s)
{
    bool outer = vbss_callback_begin(context);
    vbss_result result = s->adapter.open(s->adapter.user);
    vbss_callback_end(context, outer);
    return result;
}

static vbss_result call_describe(vbss_context *context, device_source *s,
                                 vbss_device_capabilities *capabilities)
{
    bool outer = vbss_callback_begin(context);
    vbss_result result = s->adapter.describe(s->adapter.user, capabilities);
    vbss_callback_end(context, outer);
    return result;
}

static vbss_result check_capabilities(vbss_context *context, const vbss_device_capabilities *c)
{
    const double limits[] = {c->max_force, c->max_continuous_force, c->max_torque,
                             c->max_continuous_torque, c->max_damping};
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        VBSS_TRY(vbss_check_range(context, limits[i], 0.0, 1e6, "a limit of the adapter"));
    }
    VBSS_TRY(vbss_check_range(context, c->max_stiffness, 0.0, 1e9, "max_stiffness"));
    VBSS_TRY(vbss_check_range(context, c->update_rate, 0.0, 1e9, "update_rate"));
    for (int i = 0; i < 3; i++) {
        VBSS_TRY(vbss_check_range(context, c->workspace_low[i], -1e3, 1e3, "workspace_low"));
        VBSS_TRY(vbss_check_range(context, c->workspace_high[i], c->workspace_low[i], 1e3,
                                  "workspace_high"));
    }
    return VBSS_OK;
}

static vbss_result describe_source(vbss_context *context, device_source *s)
{
    if (s->adapter.describe == NULL) {
        s->capabilities.signals = s->adapter.read != NULL ? DEVICE_SIGNALS : 0;
        s->capabilities.outputs = DEVICE_OUTPUTS;
    } else {
        memcpy(clear_buffer(s), &capabilities_defaults, sizeof capabilities_defaults);
        vbss_result result = call_describe(context, s, (vbss_device_capabilities *)s->buffer);
        if (result != VBSS_OK) {
            return fail_source(context, s, result, "cannot be described");
        }
        memcpy(&s->capabilities, s->buffer, sizeof s->capabilities);
    }
    s->capabilities.signals &= s->adapter.read != NULL ? DEVICE_SIGNALS : 0;
    s->capabilities.outputs &= s->adapter.write != NULL ? DEVICE_OUTPUTS : 0;
    return check_capabilities(context, &s->capabilities);
}

vbss_result vbss_device_open_source(vbss_context *context, device_source *s)
{
    vbss_device_copy_text(s->name, sizeof s->name,
                          s->adapter.name != NULL ? s->adapter.name : "device");
    if (s->adapter.open != NULL) {
        vbss_result result = call_open(context, s);
        if (result != VBSS_OK) {
            return fail_source(context, s, result, "cannot be opened");
        }
    }
    vbss_result result = describe_source(context, s);
    if (result != VBSS_OK) {
        vbss_device_close_source(context, s);
    }
    return result;
}

void vbss_device_close_source(vbss_context *context, device_source *s)
{
    if (s->adapter.close != NULL) {
        bool outer = vbss_callback_begin(context);
        s->adapter.close(s->adapter.user);
        vbss_callback_end(context, outer);
    }
}

/* ---- reading and writing */

vbss_result vbss_device_read_source(vbss_context *context, device_source *s, double now,
                                    const vbss_device_sample **sample)
{
    vbss_device_sample *received = clear_buffer(s);
    *received = sample_defaults;
    *sample = received;
    bool outer = vbss_callback_begin(context);
    vbss_result result = s->adapter.read(s->adapter.user, now, received);
    vbss_callback_end(context, outer);
    if (result != VBSS_OK) {
        vbss_device_record_failure(context, s, result);
    }
    return result;
}

static vbss_result call_write(device_source *s, double now, const vbss_device_coupling *coupling)
{
    const vbss_output_result *output = (const vbss_output_result *)s->buffer;
    return coupling == NULL ? s->adapter.write(s->adapter.user, now, output)
                            : s->adapter.couple(s->adapter.user, now, output, coupling);
}

bool vbss_device_write_source(vbss_context *context, device_source *s, double now,
                              const vbss_output_result *output,
                              const vbss_device_coupling *coupling, uint32_t outputs)
{
    if (s->adapter.write == NULL) {
        return true;
    }
    if (s->adapter.couple == NULL || (outputs & VBSS_DEVICE_OUT_FORCE) == 0) {
        coupling = NULL; /* only an adapter with forces and a servo of its own gets it */
    }
    const double zero[3] = {0.0, 0.0, 0.0};
    vbss_output_result own = *output;
    own.solenoid = (outputs & VBSS_DEVICE_OUT_SOLENOID) != 0 ? own.solenoid : 0;
    if ((outputs & VBSS_DEVICE_OUT_FORCE) == 0) {
        memcpy(own.force, zero, sizeof zero);
    }
    if ((outputs & VBSS_DEVICE_OUT_TORQUE) == 0) {
        memcpy(own.torque, zero, sizeof zero);
    }
    memcpy(clear_buffer(s), &own, sizeof own);
    bool outer = vbss_callback_begin(context);
    vbss_result result = call_write(s, now, coupling);
    vbss_callback_end(context, outer);
    if (result != VBSS_OK) {
        vbss_device_record_failure(context, s, result);
    }
    return result == VBSS_OK;
}
