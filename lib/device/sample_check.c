/* Checks samples. A sample with one invalid part is refused as a whole, because its other parts
 * cannot be trusted. */
#include "base/check.h"
#include "device/device.h"
#include "device/tuning.h"

static bool are_finite(const double *values, int count)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(values[i])) {
            return false;
        }
    }
    return true;
}

static bool is_finite(const vbss_device_sample *s, uint32_t valid)
{
    return ((valid & VBSS_DEVICE_HAS_POSITION) == 0 || are_finite(s->position, 3)) &&
           ((valid & VBSS_DEVICE_HAS_ORIENTATION) == 0 || are_finite(s->orientation, 4)) &&
           ((valid & VBSS_DEVICE_HAS_VELOCITY) == 0 || are_finite(s->velocity, 3)) &&
           ((valid & VBSS_DEVICE_HAS_ANGULAR_VELOCITY) == 0 ||
            are_finite(s->angular_velocity, 3)) &&
           ((valid & VBSS_DEVICE_HAS_JAW_RAW) == 0 || isfinite(s->jaw_raw)) &&
           ((valid & VBSS_DEVICE_HAS_JAW) == 0 || isfinite(s->jaw)) &&
           ((valid & VBSS_DEVICE_HAS_TEMPERATURE) == 0 || isfinite(s->temperature));
}

static bool is_in_range(const vbss_device_sample *s, uint32_t valid)
{
    return ((valid & VBSS_DEVICE_HAS_POSITION) == 0 || vbss_max_abs(s->position, 3) <= 1e3) &&
           ((valid & VBSS_DEVICE_HAS_VELOCITY) == 0 || vbss_max_abs(s->velocity, 3) <= 1e3) &&
           ((valid & VBSS_DEVICE_HAS_ANGULAR_VELOCITY) == 0 ||
            vbss_max_abs(s->angular_velocity, 3) <= 1e4) &&
           ((valid & VBSS_DEVICE_HAS_JAW_RAW) == 0 || fabs(s->jaw_raw) <= 1e6) &&
           ((valid & VBSS_DEVICE_HAS_JAW) == 0 || (s->jaw >= 0.0 && s->jaw <= 1.0)) &&
           ((valid & VBSS_DEVICE_HAS_TEMPERATURE) == 0 || fabs(s->temperature) <= 1e3) &&
           ((valid & VBSS_DEVICE_HAS_TOOL) == 0 ||
            (s->tool >= VBSS_DEVICE_TOOL_NONE && s->tool <= VBSS_DEVICE_TOOL_SHEARS));
}

/* Squares that overflow give an infinite length, which is refused as well. */
static bool is_unit(const double q[4], double tolerance)
{
    double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return fabs(length - 1.0) <= tolerance;
}

device_sample_status vbss_device_check_sample(const device_source *s,
                                              const vbss_device_sample *sample, uint32_t valid,
                                              double now, const vbss_device_config *config,
                                              bool *restarted)
{
    if (!isfinite(sample->time)) {
        return DEVICE_SAMPLE_NOT_FINITE;
    }
    if (s->has_time && sample->time >= s->time &&
        sample->time < s->time + DEVICE_MIN_SAMPLE_SPACING) {
        return DEVICE_SAMPLE_REPEATED;
    }
    bool older = s->has_time && sample->time < s->time;
    if (older && now - s->received_at <= DEVICE_CLOCK_RESTART_TIME) {
        return DEVICE_SAMPLE_OUT_OF_ORDER;
    }
    if (!is_finite(sample, valid)) {
        return DEVICE_SAMPLE_NOT_FINITE;
    }
    if (fabs(sample->time) > 1e9 || !is_in_range(sample, valid) ||
        (config->clock == VBSS_DEVICE_CLOCK_SHARED && sample->time > now + DEVICE_MAX_CLOCK_LEAD)) {
        return DEVICE_SAMPLE_OUT_OF_RANGE;
    }
    if ((valid & VBSS_DEVICE_HAS_ORIENTATION) != 0 &&
        !is_unit(sample->orientation, config->norm_tolerance)) {
        return DEVICE_SAMPLE_NOT_UNIT;
    }
    *restarted = older;
    return DEVICE_SAMPLE_ACCEPTED;
}
