/* Checking arguments */
#ifndef VBSS_BASE_CHECK_H
#define VBSS_BASE_CHECK_H

#include <stddef.h>

#include <vblast_ss/base.h>

#include "base/linear.h"

vbss_result vbss_check_pointer(vbss_context *context, const void *pointer, const char *name);
vbss_result vbss_check_finite(vbss_context *context, const double *values, size_t count,
                              const char *name);
/* low <= value <= high; NaN and infinities are VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_check_range(vbss_context *context, double value, double low, double high,
                             const char *name);
/* The largest absolute value; NaN counts as nothing. */
double vbss_max_abs(const double *values, size_t count);
/* Three finite numbers, none of them larger than the bound. */
vbss_result vbss_check_vector(vbss_context *context, const double v[3], double bound,
                              const char *name);

/* What every step asks first: VBSS_ERROR_ARITHMETIC_MODE, with a text. */
vbss_result vbss_check_arithmetic(vbss_context *context);
/* A unit quaternion of one of any length from 1e-100 to 1e100. */
vbss_result vbss_read_orientation(vbss_context *context, const double q[4], quat *orientation);

#endif
