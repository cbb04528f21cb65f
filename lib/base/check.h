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
/* Warns in the log if a value is larger than is likely, as one in a unit of a thousandth is. `unit` is
 * the right one, `small_unit` that thousandth. */
void vbss_warn_if_unlikely(vbss_context *context, double value, double likely, const char *name,
                           const char *unit, const char *small_unit);
/* Largest values that are likely in surgery, SI units. They decide about warnings only. */
#define VBSS_LIKELY_LENGTH 10.0         /* a thread; distance of parts from a body's origin */
#define VBSS_LIKELY_THREAD_RADIUS 5e-3  /* ten times the thickest suture */
#define VBSS_LIKELY_LINEAR_DENSITY 2e-2 /* twenty times a steel wire of the thickest suture */
#define VBSS_LIKELY_RADIUS 0.5          /* radius of a capsule */
#define VBSS_LIKELY_GRAVITY 100.0
#define VBSS_LIKELY_JUMP 1.0 /* distance between two poses of a tool */
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
