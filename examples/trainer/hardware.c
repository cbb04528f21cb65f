#include "trainer/hardware.h"

#include <stdio.h>
#include <string.h>

static const char *name_or_default(const char *name)
{
    return name[0] != '\0' ? name : NULL;
}

/* ---- opened */

static vbss_result open_arms(hardware *h, const options *o)
{
    vbss_openhaptics_config c;
    if (o->arm_count == 0) {
        return VBSS_OK;
    }
    TRY(vbss_openhaptics_config_init(&c, sizeof c));
    c.library = o->openhaptics_library;
    c.device_count = o->arm_count;
    c.first_name = name_or_default(o->arms[LEFT]);
    if (o->arms[RIGHT][0] != '\0') {
        c.second_name = o->arms[RIGHT];
    }
    return vbss_openhaptics_create(h->context, &c, &h->openhaptics);
}

static vbss_result open_lines(hardware *h, const options *o)
{
    vbss_nidaqmx_config c;
    if (o->handle_count == 0) {
        return VBSS_OK;
    }
    TRY(vbss_nidaqmx_config_init(&c, sizeof c));
    c.library = o->nidaq_library;
    c.handle_count = o->handle_count;
    c.first_input = o->inputs[LEFT];
    c.second_input = o->inputs[RIGHT];
    c.first_line = o->lines[LEFT];
    c.second_line = o->lines[RIGHT];
    c.own_thread = !o->simulated;
    return vbss_nidaqmx_create(h->context, &c, &h->nidaqmx);
}

static vbss_result add_faults(vbss_mock *mock, const options *o)
{
    for (uint32_t i = 0; i < o->fault_count; i++) {
        const fault_plan *f = &o->faults[i];
        const fault_row *row = rehearsal_fault(f->name);
        if (row != NULL && row->mock >= 0) {
            TRY(vbss_mock_add_fault(mock, row->mock, f->from, f->until, 0.0));
        }
    }
    return VBSS_OK;
}

/* What moves a hand that has no arm. Faults are the right one's. */
static vbss_result open_mock(hardware *h, int side, const options *o, vbss_device_adapter *adapter)
{
    vbss_mock_config c;
    TRY(vbss_mock_config_init(&c, sizeof c));
    c.measure = follower_measure;
    c.user = &h->followers[side];
    c.row_capacity = 0;
    TRY(vbss_mock_create(h->context, &c, &h->mocks[side]));
    if (side == RIGHT) {
        TRY(add_faults(h->mocks[side], o));
    }
    return vbss_mock_get_adapter(h->mocks[side], adapter);
}

static void name_hand(hardware *h, int side, const options *o, const score *log)
{
    const char *model = "", *serial = "";
    char *text = h->names[side];
    size_t room = sizeof h->names[side];
    if (h->arm[side]) {
        (void)vbss_openhaptics_get_identity(h->openhaptics, (uint32_t)side, &model, &serial);
        snprintf(text, room, "%.30s %.20s", model, serial);
    } else {
        snprintf(text, room, "%s", log != NULL ? "log" : "mock");
    }
    if (h->handle[side]) {
        size_t used = strlen(text);
        snprintf(text + used, room - used, ", %.30s", o->inputs[side]);
    }
}

static vbss_result open_device(hardware *h, int side, const options *o, const calibration *c,
                               const score *log)
{
    vbss_device_adapter first, second;
    vbss_device_config config;
    vbss_device_calibration one = c->hands[side];
    h->arm[side] = (uint32_t)side < o->arm_count;
    h->handle[side] = (uint32_t)side < o->handle_count;
    TRY(vbss_device_adapter_init(&first, sizeof first));
    TRY(vbss_device_adapter_init(&second, sizeof second));
    TRY(vbss_device_config_init(&config, sizeof config));
    if (h->arm[side]) {
        TRY(vbss_openhaptics_get_adapter(h->openhaptics, (uint32_t)side, &first));
    } else {
        TRY(open_mock(h, side, o, &first));
        TRY(vbss_device_calibration_init(&one, sizeof one)); /* it speaks of the world */
        one.jaw_closed = c->hands[side].jaw_closed;
        one.jaw_open = c->hands[side].jaw_open;
    }
    if (h->handle[side]) {
        TRY(vbss_nidaqmx_get_adapter(h->nidaqmx, (uint32_t)side, &second));
    }
    name_hand(h, side, o, log);
    config.calibration = &one;
    config.jaw_takeover = 1;
    return vbss_device_create(h->context, &first, h->handle[side] ? &second : NULL, &config,
                              &h->devices[side]);
}

static vbss_result open_all(hardware *h, const options *o, const calibration *c, const score *log)
{
    TRY(vbss_context_create(NULL, &h->context));
    TRY(open_arms(h, o));
    TRY(open_lines(h, o));
    TRY(open_device(h, LEFT, o, c, log));
    return open_device(h, RIGHT, o, c, log);
}

bool hardware_open(hardware *h, const options *o, const calibration *c, const stage *s,
                   const score *log, char *why, size_t bytes)
{
    memset(h, 0, sizeof *h);
    for (int side = 0; side < HANDS; side++) {
        h->followers[side] = (follower){.stage = s, .score = log, .side = side};
    }
    vbss_result result = open_all(h, o, c, log);
    if (result != VBSS_OK) {
        const char *text = "";
        if (h->context != NULL) {
            (void)vbss_context_get_last_error(h->context, NULL, &text);
        }
        snprintf(why, bytes, "%s: %s", vbss_result_name(result), text);
        hardware_close(h);
    }
    return result == VBSS_OK;
}

void hardware_close(hardware *h)
{
    for (int side = 0; side < HANDS; side++) {
        (void)vbss_device_destroy(h->devices[side]);
        h->devices[side] = NULL;
    }
    (void)vbss_openhaptics_destroy(h->openhaptics);
    (void)vbss_nidaqmx_destroy(h->nidaqmx);
    if (h->context != NULL) {
        (void)vbss_context_destroy(h->context);
    }
    h->openhaptics = NULL;
    h->nidaqmx = NULL;
    h->context = NULL;
}

/* ---- told */

void hardware_explain(const hardware *h, int side, char *text, size_t bytes)
{
    size_t used = 0;
    text[0] = '\0';
    for (uint32_t which = 0; which < 2; which++) {
        vbss_result result;
        const char *said;
        if (vbss_device_get_error(h->devices[side], which, &result, &said) == VBSS_OK &&
            result != VBSS_OK && used < bytes) {
            used += (size_t)snprintf(text + used, bytes - used, "%s%s", used > 0 ? "; " : "",
                                     said[0] != '\0' ? said : vbss_result_name(result));
        }
    }
}

static bool list_lines(vbss_context *context, const options *o)
{
    char text[1024];
    const char *why;
    if (vbss_nidaqmx_list_devices(context, o->nidaq_library, text, sizeof text) != VBSS_OK) {
        (void)vbss_context_get_last_error(context, NULL, &why);
        printf("lines: %s\n", why);
        return false;
    }
    printf("lines:\n%s", text);
    return true;
}

static const char *name_of_arm(const options *o, uint32_t i)
{
    return o->arms[i][0] != '\0' ? o->arms[i] : i == 0 ? "default" : "Device2";
}

/* An arm is there if it can be opened. */
static bool list_arms(hardware *h, const options *o)
{
    const char *model, *serial, *why;
    if (open_arms(h, o) != VBSS_OK) {
        (void)vbss_context_get_last_error(h->context, NULL, &why);
        printf("arms: %s\n", why);
        return false;
    }
    for (uint32_t i = 0; i < o->arm_count; i++) {
        (void)vbss_openhaptics_get_identity(h->openhaptics, i, &model, &serial);
        printf("arm: %s, %s, serial %s\n", name_of_arm(o, i), model, serial);
    }
    (void)vbss_openhaptics_destroy(h->openhaptics);
    return true;
}

bool hardware_list(const options *o)
{
    hardware h;
    bool good = true;
    memset(&h, 0, sizeof h);
    if (vbss_context_create(NULL, &h.context) != VBSS_OK) {
        return false;
    }
    if (o->arm_count > 0) {
        good = list_arms(&h, o);
    }
    if (o->handle_count > 0) {
        good = list_lines(h.context, o) && good;
    }
    (void)vbss_context_destroy(h.context);
    return good;
}
