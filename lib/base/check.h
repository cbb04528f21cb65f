/* Checks of arguments that the host passes.
 *
 * Each check returns VBSS_OK, or stores an error text and returns the status. The text starts with
 * `name`, the argument's name. */
#ifndef VBSS_BASE_CHECK_H
#define VBSS_BASE_CHECK_H

#include <stddef.h>

#include <vblast_ss/base.h>

#include "base/linear.h"

/* VBSS_ERROR_NULL_ARGUMENT if the pointer is NULL. */
vbss_result vbss_check_pointer(vbss_context *context, const void *pointer, const char *name);
/* VBSS_ERROR_NOT_FINITE if any of the values is a NaN or an infinity. */
vbss_result vbss_check_finite(vbss_context *context, const double *values, size_t count,
                              const char *name);
/* VBSS_ERROR_OUT_OF_RANGE unless low <= value <= high; VBSS_ERROR_NOT_FINITE for a NaN or an
 * infinity. */
vbss_result vbss_check_range(vbss_context *context, double value, double low, double high,
                             const char *name);
/* Largest absolute value of the array; ignores NaN. 0 for an empty array. */
double vbss_max_abs(const double *values, size_t count);
/* VBSS_ERROR_NOT_FINITE or VBSS_ERROR_OUT_OF_RANGE unless all three components are finite and at
 * most `bound` in magnitude. */
vbss_result vbss_check_vector(vbss_context *context, const double v[3], double bound,
                              const char *name);
/* Normalises q = (w, x, y, z). Its largest component must have a magnitude from 1e-100 to 1e100,
 * otherwise VBSS_ERROR_OUT_OF_RANGE; VBSS_ERROR_NOT_FINITE for a NaN or an infinity. */
vbss_result vbss_read_orientation(vbss_context *context, const double q[4], quat *orientation);

#endif
