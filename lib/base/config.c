/* Checks of arguments and public structs, done before the library changes anything. */
#include <string.h>

#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/linear.h"
#include "base/number_text.h"

vbss_result vbss_check_pointer(vbss_context *context, const void *pointer, const char *name)
{
    return pointer != NULL ? VBSS_OK
                           : vbss_fail(context, VBSS_ERROR_NULL_ARGUMENT, "%s is NULL", name);
}

vbss_result vbss_check_finite(vbss_context *context, const double *values, size_t count,
                              const char *name)
{
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i])) {
            return vbss_fail(context, VBSS_ERROR_NOT_FINITE, "%s[%llu] is %s", name,
                             (unsigned long long)i, VBSS_NUMBER(values[i]));
        }
    }
    return VBSS_OK;
}

vbss_result vbss_check_range(vbss_context *context, double value, double low, double high,
                             const char *name)
{
    if (!isfinite(value)) {
        return vbss_fail(context, VBSS_ERROR_NOT_FINITE, "%s is %s", name, VBSS_NUMBER(value));
    }
    if (value < low || value > high) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "%s is %s, outside [%s, %s]", name,
                         VBSS_NUMBER(value), VBSS_NUMBER(low), VBSS_NUMBER(high));
    }
    return VBSS_OK;
}

void vbss_warn_if_unlikely(vbss_context *context, double value, double likely, const char *name,
                           const char *unit, const char *small_unit)
{
    if (value > likely) {
        vbss_message(context, VBSS_LOG_WARNING,
                     "%s is %g %s, more than is likely; if it is in %s, the right value is %g %s",
                     name, value, unit, small_unit, 1e-3 * value, unit);
    }
}

double vbss_max_abs(const double *values, size_t count)
{
    double largest = 0.0;
    for (size_t i = 0; i < count; i++) {
        largest = fabs(values[i]) > largest ? fabs(values[i]) : largest;
    }
    return largest;
}

vbss_result vbss_check_vector(vbss_context *context, const double v[3], double bound,
                              const char *name)
{
    VBSS_TRY(vbss_check_finite(context, v, 3, name));
    return vbss_check_range(context, vbss_max_abs(v, 3), 0.0, bound, name);
}

vbss_result vbss_read_orientation(vbss_context *context, const double q[4], quat *orientation)
{
    VBSS_TRY(vbss_check_finite(context, q, 4, "orientation"));
    double largest = vbss_max_abs(q, 4);
    VBSS_TRY(vbss_check_range(context, largest, 1e-100, 1e100, "length of orientation"));
    double scale = 1.0 / largest;
    *orientation = quat_unit(quat_make(q[0] * scale, q[1] * scale, q[2] * scale, q[3] * scale));
    return VBSS_OK;
}

/* ---- public structs */

/* No version of a struct will be longer: a larger struct_size was never initialised. */
#define MAX_STRUCT_BYTES 4096u

static uint32_t own_size(const vbss_layout *layout)
{
    const uint32_t *size = layout->sizes;
    while (size[1] != 0) {
        size++;
    }
    return *size;
}

/* A valid size is that of a published version, or larger: a newer version. A size in between would
 * end inside a field. */
static vbss_result check_size(vbss_context *context, const vbss_layout *layout,
                              uint32_t struct_size)
{
    bool known = struct_size > own_size(layout) && struct_size <= MAX_STRUCT_BYTES;
    for (const uint32_t *size = layout->sizes; *size != 0; size++) {
        known = known || struct_size == *size;
    }
    return known
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_STRUCT_SIZE,
                           "%s: no version of the struct has struct_size %u; use the init function",
                           layout->name, struct_size);
}

static uint32_t min_u32(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

vbss_result vbss_config_init(const vbss_layout *layout, void *config, uint32_t struct_size)
{
    VBSS_TRY(vbss_check_pointer(NULL, config, layout->name));
    VBSS_TRY(check_size(NULL, layout, struct_size));
    memset(config, 0, struct_size);
    memcpy(config, layout->defaults, min_u32(own_size(layout), struct_size));
    memcpy(config, &struct_size, sizeof struct_size);
    return VBSS_OK;
}

vbss_result vbss_config_read(vbss_context *context, const vbss_layout *layout, const void *config,
                             void *own)
{
    uint32_t own_bytes = own_size(layout), struct_size;
    memcpy(own, layout->defaults, own_bytes);
    VBSS_TRY(vbss_check_pointer(context, config, layout->name));
    memcpy(&struct_size, config, sizeof struct_size);
    VBSS_TRY(check_size(context, layout, struct_size));
    const unsigned char *bytes = config;
    for (uint32_t i = own_bytes; i < struct_size; i++) {
        if (bytes[i] != 0) {
            return vbss_fail(context, VBSS_ERROR_UNKNOWN_FIELD,
                             "%s: byte %u of %u is set, this library knows %u", layout->name, i,
                             struct_size, own_bytes);
        }
    }
    memcpy(own, config, min_u32(own_bytes, struct_size));
    memcpy(own, &own_bytes, sizeof own_bytes);
    return VBSS_OK;
}

static const uint32_t view_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_view, 32u, 1u), 0};
const vbss_layout vbss_view_layout = {"vbss_view", NULL, view_sizes};

vbss_result vbss_struct_write(vbss_context *context, const vbss_layout *layout, const void *own,
                              void *out, uint32_t struct_size)
{
    VBSS_TRY(vbss_check_pointer(context, out, layout->name));
    VBSS_TRY(check_size(context, layout, struct_size));
    uint32_t filled = min_u32(own_size(layout), struct_size);
    memset(out, 0, struct_size);
    memcpy(out, own, filled);
    memcpy(out, &filled, sizeof filled);
    return VBSS_OK;
}
