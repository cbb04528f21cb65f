/* An adapter without hardware. Its samples come from the host or from a function of time; its
 * writes are recorded. */
#include <string.h>

#include "device/mock.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"

_Static_assert(sizeof(vbss_mock_config) == 16 + 3 * sizeof(void *), "no hidden padding");
_Static_assert(sizeof(vbss_mock_statistics) == 40, "published size");

static const vbss_mock_config config_defaults = {
    .struct_size = sizeof(vbss_mock_config), .fault_capacity = 16, .row_capacity = 1024};
static const uint32_t config_sizes[] = {16u + 3u * (uint32_t)sizeof(void *), 0};
static const vbss_layout config_layout = {"vbss_mock_config", &config_defaults, config_sizes};
static const uint32_t statistics_sizes[] = {40, 0};
static const vbss_layout statistics_layout = {"vbss_mock_statistics", NULL, statistics_sizes};

/* Similar to a haptic arm with three driven axes, but its continuous force is unknown. */
static const vbss_device_capabilities default_capabilities = {
    .struct_size = sizeof(vbss_device_capabilities),
    .signals = DEVICE_SIGNALS,
    .outputs = DEVICE_OUTPUTS,
    .input_dof = 6,
    .output_dof = 3,
    .max_force = 3.3,
    .max_stiffness = 400.0,
    .max_damping = 4.0,
    .update_rate = 1000.0,
    .workspace_low = {-0.075, -0.075, -0.075},
    .workspace_high = {0.075, 0.075, 0.075},
};

vbss_result vbss_mock_config_init(vbss_mock_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

/* ---- creation and destruction */

static void free_mock(vbss_context *context, void *object)
{
    mock_object *m = object;
    vbss_release(context, m->faults, m->config.fault_capacity, sizeof *m->faults);
    vbss_release(context, m->rows, (size_t)MOCK_ROW_NUMBERS * m->config.row_capacity,
                 sizeof *m->rows);
    vbss_release(context, m, 1, sizeof *m);
}

/* A mock acts as hardware, which cannot be restored to an earlier state; only counts are saved. */
static void visit_mock(vbss_stream *stream, void *object)
{
    mock_object *m = object;
    vbss_stream_u64(stream, 1, &m->statistics.reads, 1);
    vbss_stream_u64(stream, 2, &m->statistics.writes, 1);
}

static const vbss_kind kind = {"mock", VBSS_CODE('M', 'O', 'C', 'K'), 1, free_mock, visit_mock,
                               NULL};

static vbss_result allocate_mock(vbss_context *context, const mock_object *wanted,
                                 mock_object **mock)
{
    mock_object *m = vbss_allocate(context, 1, sizeof *m, "mock");
    if (m == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    *m = *wanted;
    const vbss_array arrays[] = {
        {&m->faults, m->config.fault_capacity, sizeof *m->faults},
        {&m->rows, (size_t)MOCK_ROW_NUMBERS * m->config.row_capacity, sizeof *m->rows}};
    vbss_result result = vbss_allocate_arrays(context, arrays, 2, "mock");
    if (result != VBSS_OK) {
        free_mock(context, m);
        return result;
    }
    *mock = m;
    return VBSS_OK;
}

static vbss_result read_config(mock_object *wanted, const vbss_mock_config *config)
{
    vbss_context *context = wanted->context;
    wanted->config = config_defaults;
    wanted->capabilities = default_capabilities;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, &wanted->config));
    }
    VBSS_TRY(
        vbss_check_range(context, wanted->config.fault_capacity, 0.0, 4096.0, "fault_capacity"));
    VBSS_TRY(
        vbss_check_range(context, wanted->config.row_capacity, 0.0, 1048576.0, "row_capacity"));
    VBSS_TRY(vbss_check_range(context, wanted->config.reserved, 0.0, 0.0, "reserved"));
    if (wanted->config.capabilities != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_device_capabilities_layout,
                                  wanted->config.capabilities, &wanted->capabilities));
    }
    wanted->config.capabilities = NULL;
    VBSS_TRY(vbss_device_sample_init(&wanted->sample, sizeof wanted->sample));
    wanted->failure = "nothing has failed yet";
    return VBSS_OK;
}

vbss_result vbss_mock_create(vbss_context *context, const vbss_mock_config *config,
                             vbss_mock **mock)
{
    VBSS_ENTER_WITH_RESULT(context, mock);
    if (mock == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, mock, "mock");
    }
    VBSS_TRY(vbss_context_edit(context));
    mock_object wanted = {.context = context}, *m = NULL;
    vbss_slot *slot = NULL;
    VBSS_TRY(read_config(&wanted, config));
    VBSS_TRY(allocate_mock(context, &wanted, &m));
    vbss_result result = vbss_slot_create(context, &kind, m, &slot);
    if (result != VBSS_OK) {
        free_mock(context, m);
        return result;
    }
    *mock = (vbss_mock *)slot;
    return VBSS_OK;
}

vbss_result vbss_mock_destroy(vbss_mock *mock)
{
    VBSS_ENTER(mock);
    return vbss_slot_destroy(mock, &kind);
}

static vbss_result open_mock(const void *handle, mock_object **mock)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &kind, &slot));
    *mock = slot->object;
    return VBSS_OK;
}

static vbss_result edit_mock(vbss_mock *handle, mock_object **mock)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &kind, &slot));
    *mock = slot->object;
    return VBSS_OK;
}

/* ---- adapter
 *
 * `user` is the handle. Its memory stays valid after the mock is destroyed, so a device that still
 * uses the adapter gets an error. */

static vbss_result mock_open(void *user)
{
    VBSS_ENTER(user);
    mock_object *m;
    VBSS_TRY(open_mock(user, &m));
    if (m->statistics.open != 0) {
        m->failure = "the mock is open already";
        return VBSS_ERROR_DEVICE;
    }
    m->statistics.open = 1;
    m->statistics.opens++;
    return VBSS_OK;
}

static void mock_close(void *user)
{
    mock_object *m;
    if (open_mock(user, &m) == VBSS_OK) {
        m->statistics.open = 0;
    }
}

static vbss_result mock_describe(void *user, vbss_device_capabilities *capabilities)
{
    VBSS_ENTER(user);
    mock_object *m;
    VBSS_TRY(open_mock(user, &m));
    *capabilities = m->capabilities;
    return VBSS_OK;
}

static vbss_result mock_read(void *user, double now, vbss_device_sample *sample)
{
    VBSS_ENTER(user);
    mock_object *m;
    vbss_result result = open_mock(user, &m);
    if (result != VBSS_OK) {
        sample->flags = VBSS_DEVICE_FLAG_LOST;
        return result;
    }
    m->statistics.reads++;
    if (m->config.measure != NULL) {
        sample->time = vbss_mock_sample_time(m, now);
        bool outer = vbss_callback_begin(m->context); /* the host may read without a device */
        m->config.measure(m->config.user, sample->time, sample);
        vbss_callback_end(m->context, outer);
    } else {
        *sample = m->sample;
    }
    vbss_mock_apply_faults(m, now, sample);
    return vbss_mock_fails(m, now, true) ? VBSS_ERROR_DEVICE : VBSS_OK;
}

static void append_row(mock_object *m, double now, const vbss_output_result *output)
{
    if (m->row_count == m->config.row_capacity) {
        m->statistics.rows_lost++;
        return;
    }
    double *row = m->rows + (size_t)MOCK_ROW_NUMBERS * m->row_count++;
    row[0] = now;
    memcpy(row + 1, output->force, sizeof output->force);
    memcpy(row + 4, output->torque, sizeof output->torque);
    row[7] = output->solenoid;
    row[8] = output->flags;
}

static vbss_result mock_write(void *user, double now, const vbss_output_result *output)
{
    VBSS_ENTER(user);
    mock_object *m;
    VBSS_TRY(open_mock(user, &m));
    m->statistics.writes++;
    if (vbss_mock_fails(m, now, false)) {
        return VBSS_ERROR_DEVICE;
    }
    append_row(m, now, output);
    return VBSS_OK;
}

static void mock_explain(void *user, char *text, uint32_t bytes)
{
    mock_object *m;
    const char *failure = open_mock(user, &m) == VBSS_OK ? m->failure : "the mock was destroyed";
    size_t length = strlen(failure);
    length = length < bytes ? length : bytes - 1;
    memcpy(text, failure, length);
    text[length] = '\0';
}

vbss_result vbss_mock_get_adapter(vbss_mock *mock, vbss_device_adapter *adapter)
{
    VBSS_ENTER(mock);
    mock_object *m;
    VBSS_TRY(open_mock(mock, &m));
    const vbss_device_adapter own = {
        .struct_size = sizeof own,
        .name = "mock",
        .user = mock,
        .open = mock_open,
        .close = mock_close,
        .describe = mock_describe,
        .read = mock_read,
        .write = mock_write,
        .explain = mock_explain,
    };
    return vbss_device_export_adapter(m->context, &own, adapter);
}

/* ---- public functions */

vbss_result vbss_mock_set_sample(vbss_mock *mock, const vbss_device_sample *sample)
{
    VBSS_ENTER(mock);
    mock_object *m;
    vbss_device_sample own;
    VBSS_TRY(edit_mock(mock, &m));
    VBSS_TRY(vbss_config_read(m->context, &vbss_device_sample_layout, sample, &own));
    m->sample = own;
    return VBSS_OK;
}

vbss_result vbss_mock_add_fault(vbss_mock *mock, vbss_mock_fault fault, double from, double until,
                                double value)
{
    VBSS_ENTER(mock);
    mock_object *m;
    const mock_fault own = {fault, from, until, value};
    VBSS_TRY(edit_mock(mock, &m));
    VBSS_TRY(vbss_mock_check_fault(m->context, &own));
    if (m->config.measure == NULL && vbss_mock_needs_function(fault)) {
        return vbss_fail(m->context, VBSS_ERROR_INCOMPATIBLE, "fault %d needs a function of time",
                         fault);
    }
    if (m->fault_count == m->config.fault_capacity) {
        return vbss_fail(m->context, VBSS_ERROR_CAPACITY, "the mock has %u faults", m->fault_count);
    }
    m->faults[m->fault_count++] = own;
    return VBSS_OK;
}

vbss_result vbss_mock_clear_faults(vbss_mock *mock)
{
    VBSS_ENTER(mock);
    mock_object *m;
    VBSS_TRY(edit_mock(mock, &m));
    m->fault_count = 0;
    return VBSS_OK;
}

vbss_result vbss_mock_clear_rows(vbss_mock *mock)
{
    VBSS_ENTER(mock);
    mock_object *m;
    VBSS_TRY(edit_mock(mock, &m));
    m->row_count = 0;
    m->generation++;
    return VBSS_OK;
}

vbss_result vbss_mock_get_view(vbss_mock *mock, vbss_mock_field field, vbss_view *view,
                               uint32_t struct_size)
{
    VBSS_ENTER(mock);
    mock_object *m;
    VBSS_TRY(open_mock(mock, &m));
    if (field != VBSS_MOCK_VIEW_ROWS) {
        return vbss_fail(m->context, VBSS_ERROR_OUT_OF_RANGE, "a mock has no field %d", field);
    }
    const vbss_view own = {0,
                           VBSS_VIEW_TYPE_F64,
                           MOCK_ROW_NUMBERS,
                           MOCK_ROW_NUMBERS * sizeof(double),
                           m->row_count,
                           m->rows,
                           m->generation + m->statistics.writes};
    return vbss_struct_write(m->context, &vbss_view_layout, &own, view, struct_size);
}

vbss_result vbss_mock_get_statistics(vbss_mock *mock, vbss_mock_statistics *statistics,
                                     uint32_t struct_size)
{
    VBSS_ENTER(mock);
    mock_object *m;
    VBSS_TRY(open_mock(mock, &m));
    return vbss_struct_write(m->context, &statistics_layout, &m->statistics, statistics,
                             struct_size);
}
