/* The output stage with a handle of its own: configuration, serialisation, public functions. */
#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_output_config) == 120, "published size");
_Static_assert(sizeof(vbss_output_command) == 88, "published size");
_Static_assert(sizeof(vbss_output_result) == 96, "published size");
_Static_assert(sizeof(vbss_output_statistics) == 160, "published size");

static const vbss_output_config config_defaults = {
    .struct_size = sizeof(vbss_output_config),
    .max_force = 3.0,
    .max_torque = 0.1,
    .continuous_force = 0.88,
    .continuous_torque = 0.03,
    .load_time = 10.0,
    .warm = 0.7,
    .hot = 1.0,
    .force_rise = 500.0,
    .torque_rise = 20.0,
    .input_timeout = 0.005,
    .command_timeout = 0.005,
    .ramp_time = 0.005,
    .solenoid_time = 1.0,
    .solenoid_duty = 0.25,
};
static const uint32_t config_sizes[] = {120, 0};
const vbss_layout vbss_output_config_layout = {"vbss_output_config", &config_defaults,
                                               config_sizes};

static const vbss_output_command command_defaults = {.struct_size = sizeof(vbss_output_command)};
static const uint32_t command_sizes[] = {88, 0};
const vbss_layout vbss_output_command_layout = {"vbss_output_command", &command_defaults,
                                                command_sizes};

static const uint32_t result_sizes[] = {96, 0};
const vbss_layout vbss_output_result_layout = {"vbss_output_result", NULL, result_sizes};
static const uint32_t statistics_sizes[] = {160, 0};
const vbss_layout vbss_output_statistics_layout = {"vbss_output_statistics", NULL,
                                                   statistics_sizes};

vbss_result vbss_output_config_init(vbss_output_config *config, uint32_t struct_size)
{
    return vbss_config_init(&vbss_output_config_layout, config, struct_size);
}

vbss_result vbss_output_command_init(vbss_output_command *command, uint32_t struct_size)
{
    return vbss_config_init(&vbss_output_command_layout, command, struct_size);
}

vbss_result vbss_output_check_config(vbss_context *context, const vbss_output_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_range(context, c->max_force, 0.0, 1e3, "max_force"));
    VBSS_TRY(vbss_check_range(context, c->max_torque, 0.0, 1e3, "max_torque"));
    VBSS_TRY(vbss_check_range(context, c->continuous_force, 0.0, 1e3, "continuous_force"));
    VBSS_TRY(vbss_check_range(context, c->continuous_torque, 0.0, 1e3, "continuous_torque"));
    VBSS_TRY(vbss_check_range(context, c->load_time, 1e-3, 1e4, "load_time"));
    VBSS_TRY(vbss_check_range(context, c->warm, 0.0, 1.0, "warm"));
    VBSS_TRY(vbss_check_range(context, c->hot, c->warm + 1e-3, 2.0, "hot"));
    VBSS_TRY(vbss_check_range(context, c->force_rise, 1e-3, 1e9, "force_rise"));
    VBSS_TRY(vbss_check_range(context, c->torque_rise, 1e-3, 1e9, "torque_rise"));
    VBSS_TRY(vbss_check_range(context, c->input_timeout, 1e-4, 10.0, "input_timeout"));
    VBSS_TRY(vbss_check_range(context, c->command_timeout, 1e-4, 10.0, "command_timeout"));
    VBSS_TRY(vbss_check_range(context, c->ramp_time, 0.0, 10.0, "ramp_time"));
    VBSS_TRY(vbss_check_range(context, c->solenoid_time, 0.0, 1e4, "solenoid_time"));
    return vbss_check_range(context, c->solenoid_duty, 0.0, 0.99, "solenoid_duty");
}

vbss_result vbss_output_check_command(vbss_context *context, const vbss_output_command *c)
{
    VBSS_TRY(vbss_check_range(context, c->solenoid, 0.0, 1.0, "solenoid"));
    VBSS_TRY(vbss_check_range(context, c->fault, 0.0, 1.0, "fault"));
    return vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved");
}

/* ---- state */

void vbss_output_visit_config(vbss_stream *stream, const vbss_output_config *c)
{
    const double numbers[] = {c->max_force,
                              c->max_torque,
                              c->continuous_force,
                              c->continuous_torque,
                              c->load_time,
                              c->warm,
                              c->hot,
                              c->force_rise,
                              c->torque_rise,
                              c->input_timeout,
                              c->command_timeout,
                              c->ramp_time,
                              c->solenoid_time,
                              c->solenoid_duty};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
}

static void visit_demand(vbss_stream *stream, output_demand *d)
{
    vbss_stream_f64(stream, 2, &d->force.x, 3);
    vbss_stream_f64(stream, 3, &d->torque.x, 3);
    vbss_stream_f64(stream, 4, &d->age, 1);
    vbss_stream_f64(stream, 5, &d->input_age, 1);
    vbss_stream_f64(stream, 6, &d->temperature, 1);
    vbss_stream_bool(stream, 7, &d->solenoid);
    vbss_stream_bool(stream, 8, &d->has_fault);
}

static void visit_statistics(vbss_stream *stream, vbss_output_statistics *f)
{
    uint64_t *const counts[] = {&f->steps,          &f->not_finite, &f->faults, &f->clamped,
                                &f->continuous,     &f->warm,       &f->slewed, &f->input_stale,
                                &f->command_stale,  &f->stopped,    &f->late,   &f->solenoid_off,
                                &f->solenoid_spent, &f->watchdogs,  &f->stops,  &f->pulses};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        vbss_stream_u64(stream, 30, counts[i], 1);
    }
    vbss_stream_f64(stream, 31, &f->largest_force, 1);
    vbss_stream_f64(stream, 32, &f->largest_torque, 1);
    vbss_stream_f64(stream, 33, &f->solenoid_on, 1);
}

/* Whether the state respects the limits. A corrupt state could put out forces above them. */
static bool is_valid_state(const vbss_output_config *c, const output_state *s)
{
    const double slack = 1.0 + 1e-9;
    return vec3_norm(s->force) <= slack * c->max_force &&
           vec3_norm(s->torque) <= slack * c->max_torque && s->force_load >= 0.0 &&
           s->torque_load >= 0.0 && s->force_load <= 1e7 && s->torque_load <= 1e7 &&
           s->last_demand.age >= 0.0 && s->last_demand.age <= OUTPUT_NEVER &&
           s->last_demand.input_age >= 0.0 && s->last_demand.input_age <= OUTPUT_NEVER &&
           s->solenoid.time_left >= 0.0 && s->solenoid.time_left <= c->solenoid_time &&
           s->ramp_force >= 0.0 && s->ramp_torque >= 0.0 &&
           !(s->solenoid.is_on && s->solenoid.is_exhausted);
}

void vbss_output_visit_state(vbss_stream *stream, const vbss_output_config *c, output_state *s)
{
    visit_demand(stream, &s->last_demand);
    vbss_stream_f64(stream, 10, &s->force.x, 3);
    vbss_stream_f64(stream, 11, &s->torque.x, 3);
    vbss_stream_f64(stream, 12, &s->force_load, 1);
    vbss_stream_f64(stream, 13, &s->torque_load, 1);
    vbss_stream_bool(stream, 14, &s->is_stopped);
    vbss_stream_bool(stream, 15, &s->is_ramping);
    vbss_stream_f64(stream, 16, &s->ramp_force, 1);
    vbss_stream_f64(stream, 17, &s->ramp_torque, 1);
    vbss_stream_bool(stream, 18, &s->solenoid.is_on);
    vbss_stream_bool(stream, 19, &s->solenoid.is_exhausted);
    vbss_stream_f64(stream, 20, &s->solenoid.time_left, 1);
    visit_statistics(stream, &s->statistics);
    if (!is_valid_state(c, s)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no output stage is like this");
    }
}

/* ---- the handle */

typedef struct output_object {
    vbss_context *context;
    vbss_output_config config;
    output_state state;
} output_object;

static void free_output(vbss_context *context, void *object)
{
    vbss_release(context, object, 1, sizeof(output_object));
}

static void visit_output(vbss_stream *stream, void *object)
{
    output_object *o = object;
    vbss_output_visit_config(stream, &o->config);
    vbss_output_visit_state(stream, &o->config, &o->state);
}

const vbss_kind vbss_output_kind = {
    "output stage", VBSS_CODE('O', 'U', 'T', 'S'), 1, free_output, visit_output, NULL};

vbss_result vbss_output_create(vbss_context *context, const vbss_output_config *config,
                               vbss_output **output)
{
    VBSS_ENTER_WITH_RESULT(context, output);
    if (output == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, output, "output");
    }
    VBSS_TRY(vbss_context_edit(context));
    vbss_output_config own = config_defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_output_config_layout, config, &own));
    }
    VBSS_TRY(vbss_output_check_config(context, &own));
    vbss_slot *slot = NULL;
    output_object *o = vbss_allocate(context, 1, sizeof *o, "output stage");
    if (o == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    o->context = context;
    o->config = own;
    vbss_output_init_state(&o->config, &o->state);
    vbss_result result = vbss_slot_create(context, &vbss_output_kind, o, &slot);
    if (result != VBSS_OK) {
        free_output(context, o);
        return result;
    }
    *output = (vbss_output *)slot;
    return VBSS_OK;
}

vbss_result vbss_output_destroy(vbss_output *output)
{
    VBSS_ENTER(output);
    return vbss_slot_destroy(output, &vbss_output_kind);
}

static vbss_result edit_output(vbss_output *handle, output_object **output)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_output_kind, &slot));
    *output = slot->object;
    return VBSS_OK;
}

vbss_result vbss_output_step(vbss_output *output, double h, const vbss_output_command *command,
                             vbss_output_result *result, uint32_t struct_size)
{
    VBSS_ENTER(output);
    output_object *o;
    vbss_output_result own = {.struct_size = sizeof own};
    VBSS_TRY(edit_output(output, &o));
    VBSS_TRY(vbss_check_range(o->context, h, 0.0, 1e6, "h"));
    output_demand demand = vbss_output_repeat_demand(&o->state, h);
    if (command != NULL) {
        vbss_output_command given;
        VBSS_TRY(vbss_config_read(o->context, &vbss_output_command_layout, command, &given));
        VBSS_TRY(vbss_output_check_command(o->context, &given));
        demand = vbss_output_make_demand(&given);
    }
    VBSS_TRY(vbss_struct_write(o->context, &vbss_output_result_layout, &own, result, struct_size));
    vbss_output_store_demand(&o->state, &demand);
    uint32_t flags = vbss_output_advance(&o->config, &o->state, h, &demand);
    vbss_output_fill_result(&o->config, &o->state, flags, &own);
    return vbss_struct_write(o->context, &vbss_output_result_layout, &own, result, struct_size);
}

vbss_result vbss_output_latch_emergency_stop(vbss_output *output)
{
    VBSS_ENTER(output);
    output_object *o;
    VBSS_TRY(edit_output(output, &o));
    vbss_output_latch_stop(&o->state);
    return VBSS_OK;
}

vbss_result vbss_output_clear_emergency_stop(vbss_output *output)
{
    VBSS_ENTER(output);
    output_object *o;
    VBSS_TRY(edit_output(output, &o));
    o->state.is_stopped = false;
    return VBSS_OK;
}

vbss_result vbss_output_get_statistics(vbss_output *output, vbss_output_statistics *statistics,
                                       uint32_t struct_size)
{
    VBSS_ENTER(output);
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(output, &vbss_output_kind, &slot));
    const output_object *o = slot->object;
    return vbss_struct_write(o->context, &vbss_output_statistics_layout, &o->state.statistics,
                             statistics, struct_size);
}
