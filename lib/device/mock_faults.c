/* Faults of a mock. They depend on time only, so they repeat to the bit. */
#include "base/check.h"
#include "base/error.h"
#include "device/mock.h"

static bool is_active(const mock_fault *f, double now)
{
    return now >= f->from && now < f->until;
}

bool vbss_mock_needs_function(vbss_mock_fault fault)
{
    return fault == VBSS_MOCK_FAULT_STALL || fault == VBSS_MOCK_FAULT_RATE ||
           fault == VBSS_MOCK_FAULT_LATE || fault == VBSS_MOCK_FAULT_SHUFFLE;
}

vbss_result vbss_mock_check_fault(vbss_context *context, const mock_fault *f)
{
    bool interval = f->kind == VBSS_MOCK_FAULT_RATE || f->kind == VBSS_MOCK_FAULT_SHUFFLE;
    VBSS_TRY(vbss_check_range(context, f->kind, VBSS_MOCK_FAULT_NAN, VBSS_MOCK_FAULT_WRITE_FAILS,
                              "fault"));
    VBSS_TRY(vbss_check_range(context, f->from, -1e9, 1e9, "from"));
    VBSS_TRY(vbss_check_range(context, f->until, f->from, 1e9, "until"));
    if (interval) {
        return vbss_check_range(context, f->value, 1e-6, 1e3, "value");
    }
    if (f->kind == VBSS_MOCK_FAULT_LATE) {
        return vbss_check_range(context, f->value, 0.0, 1e3, "value");
    }
    if (f->kind == VBSS_MOCK_FAULT_NAN) {
        return vbss_check_range(context, f->value, 0.0, 4.0, "value");
    }
    return vbss_check_range(context, f->value, -1e9, 1e9, "value");
}

/* ---- time of a sample */

static double intervals_since(const mock_fault *f, double time)
{
    return floor((time - f->from) / f->value);
}

static double faulted_time(const mock_fault *f, double time)
{
    double intervals;
    switch (f->kind) {
    case VBSS_MOCK_FAULT_STALL:
        return f->from;
    case VBSS_MOCK_FAULT_RATE:
        return f->from + intervals_since(f, time) * f->value;
    case VBSS_MOCK_FAULT_LATE:
        return time - f->value;
    case VBSS_MOCK_FAULT_SHUFFLE:
        intervals = intervals_since(f, time);
        return intervals == 2.0 * floor(0.5 * intervals) ? time : time - f->value;
    default:
        return time;
    }
}

double vbss_mock_sample_time(const mock_object *m, double now)
{
    double time = now;
    for (uint32_t i = 0; i < m->fault_count; i++) {
        if (is_active(&m->faults[i], now) && vbss_mock_needs_function(m->faults[i].kind)) {
            time = faulted_time(&m->faults[i], time);
        }
    }
    return time;
}

/* ---- contents of a sample */

static void put_nan(double which, vbss_device_sample *sample)
{
    double *const targets[] = {sample->position, sample->orientation, sample->velocity,
                               &sample->jaw_raw, &sample->time};
    *targets[(int)which] = (double)NAN;
    if (which == 3.0) {
        sample->jaw = (double)NAN;
    }
}

static void apply_fault(const mock_fault *f, vbss_device_sample *sample)
{
    switch (f->kind) {
    case VBSS_MOCK_FAULT_NAN:
        put_nan(floor(f->value), sample);
        break;
    case VBSS_MOCK_FAULT_DISCONNECT:
        sample->flags |= VBSS_DEVICE_FLAG_LOST;
        break;
    case VBSS_MOCK_FAULT_NORM:
        for (int i = 0; i < 4; i++) {
            sample->orientation[i] *= f->value;
        }
        break;
    case VBSS_MOCK_FAULT_JUMP:
        sample->position[0] += f->value;
        break;
    case VBSS_MOCK_FAULT_TEMPERATURE:
        sample->temperature = f->value;
        sample->valid |= VBSS_DEVICE_HAS_TEMPERATURE;
        break;
    case VBSS_MOCK_FAULT_JAW:
        sample->jaw_raw = f->value;
        break;
    case VBSS_MOCK_FAULT_STOP:
        sample->flags |= VBSS_DEVICE_FLAG_STOP;
        break;
    case VBSS_MOCK_FAULT_REFUSAL:
        sample->flags |= VBSS_DEVICE_FLAG_FAULT;
        break;
    default:
        break;
    }
}

void vbss_mock_apply_faults(const mock_object *m, double now, vbss_device_sample *sample)
{
    for (uint32_t i = 0; i < m->fault_count; i++) {
        if (is_active(&m->faults[i], now)) {
            apply_fault(&m->faults[i], sample);
        }
    }
}

bool vbss_mock_fails(mock_object *m, double now, bool reads)
{
    vbss_mock_fault own = reads ? VBSS_MOCK_FAULT_READ_FAILS : VBSS_MOCK_FAULT_WRITE_FAILS;
    bool fails = false;
    for (uint32_t i = 0; i < m->fault_count; i++) {
        const mock_fault *f = &m->faults[i];
        if (is_active(f, now) && (f->kind == own || f->kind == VBSS_MOCK_FAULT_DISCONNECT)) {
            m->failure = f->kind == VBSS_MOCK_FAULT_DISCONNECT ? "unplugged by a fault of the mock"
                         : reads ? "a read fails by a fault of the mock"
                                 : "a write fails by a fault of the mock";
            fails = true;
        }
    }
    return fails;
}
