/* Arguments and structs from outside: checked before anything is changed. */
#include <string.h>

#include "base/base.h"

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
            return vbss_fail(context, VBSS_ERROR_NOT_FINITE, "%s[%llu] is %g", name,
                             (unsigned long long)i, values[i]);
        }
    }
    return VBSS_OK;
}

vbss_result vbss_check_range(vbss_context *context, double value, double low, double high,
                             const char *name)
{
    if (!isfinite(value)) {
        return vbss_fail(context, VBSS_ERROR_NOT_FINITE, "%s is %g", name, value);
    }
    if (value < low || value > high) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "%s is %g, outside [%g, %g]", name,
                         value, low, high);
    }
    return VBSS_OK;
}

static vbss_result check_size(vbss_context *context, const char *name, uint32_t struct_size,
                              uint32_t first_size)
{
    if (struct_size < first_size) {
        return vbss_fail(context, VBSS_ERROR_STRUCT_SIZE,
                         "%s: struct_size is %u, its first version had %u", name, struct_size,
                         first_size);
    }
    return VBSS_OK;
}

static uint32_t smaller(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

vbss_result vbss_config_init(const void *defaults, uint32_t own_size, uint32_t first_size,
                             void *config, uint32_t struct_size)
{
    VBSS_TRY(vbss_check_pointer(NULL, config, "config"));
    VBSS_TRY(check_size(NULL, "config", struct_size, first_size));
    memset(config, 0, struct_size);
    memcpy(config, defaults, smaller(own_size, struct_size));
    memcpy(config, &struct_size, sizeof struct_size);
    return VBSS_OK;
}

vbss_result vbss_config_read(vbss_context *context, const char *name, const void *config, void *own,
                             uint32_t own_size, uint32_t first_size)
{
    VBSS_TRY(vbss_check_pointer(context, config, name));
    uint32_t struct_size;
    memcpy(&struct_size, config, sizeof struct_size);
    VBSS_TRY(check_size(context, name, struct_size, first_size));
    const unsigned char *bytes = config;
    for (uint32_t i = own_size; i < struct_size; i++) {
        if (bytes[i] != 0) {
            return vbss_fail(context, VBSS_ERROR_UNKNOWN_FIELD,
                             "%s: byte %u of %u is set, this library knows %u", name, i,
                             struct_size, own_size);
        }
    }
    memcpy(own, config, smaller(own_size, struct_size));
    memcpy(own, &own_size, sizeof own_size);
    return VBSS_OK;
}

vbss_result vbss_struct_write(vbss_context *context, const char *name, const void *own,
                              uint32_t own_size, uint32_t first_size, void *out,
                              uint32_t struct_size)
{
    VBSS_TRY(vbss_check_pointer(context, out, name));
    VBSS_TRY(check_size(context, name, struct_size, first_size));
    uint32_t filled = smaller(own_size, struct_size);
    memset(out, 0, struct_size);
    memcpy(out, own, filled);
    memcpy(out, &filled, sizeof filled);
    return VBSS_OK;
}
