/**
 * @file elementary.h
 * @brief Elementary functions with the same bits on every processor, compiler and system.
 *
 * The functions of libm differ in their last bits from one machine to the next. A host that moves
 * tools along computed paths uses these instead, so that its inputs are the same everywhere.
 *
 * All are pure functions: they keep no state, cannot fail, and any thread may call them at any time.
 * They take every double. A NaN as an argument gives a NaN; every NaN that they return is quiet and
 * has the bits 0x7ff8000000000000. On the processors that base.h names, the results do not depend on
 * the floating-point mode of the calling thread. Errors are in units in the last place (ulp) of the
 * result; docs/explanation/elementary-functions.md derives them.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_ELEMENTARY_H
#define VBLAST_SS_ELEMENTARY_H

#include <vblast_ss/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Sine; the error is below 0.51 ulp for every argument, however large. Odd to the bit: sin(-x) =
 * -sin(x), and a zero keeps its sign.
 *
 * @param angle  rad; any double
 * @return the sine, -1 to 1; NaN for an infinite angle
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API double vbss_sin(double angle);

/**
 * Cosine; the error is below 0.51 ulp for every argument, however large. Even to the bit: cos(-x) =
 * cos(x).
 *
 * @param angle  rad; any double
 * @return the cosine, -1 to 1; NaN for an infinite angle
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API double vbss_cos(double angle);

/**
 * The angle of a point in the plane, from the x axis towards the y axis; the error is below 0.52
 * ulp. Zeros and infinities are as in C11 Annex F: atan2(+-0, x) is +-0 for x > 0 or +0, and +-pi
 * for x < 0 or -0; two infinities denote a point on a diagonal.
 *
 * @param y  coordinate on the y axis, any unit; any double
 * @param x  coordinate on the x axis, the same unit; any double
 * @return the angle, rad, -pi to pi
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API double vbss_atan2(double y, double x);

/**
 * Arc cosine; the error is below 0.51 ulp. acos(1) is +0.
 *
 * @param cosine  -1 to 1; any other double gives NaN
 * @return the angle, rad, 0 to pi
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API double vbss_acos(double cosine);

#ifdef __cplusplus
}
#endif

#endif
