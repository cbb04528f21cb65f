/* Elementary functions that hosts do not need, beside those of vblast_ss/elementary.h: the same bits
 * everywhere. Errors and methods stand in docs/elementary-functions.md. Special values as in C11
 * Annex F. */
#ifndef VBSS_BASE_ELEMENTARY_H
#define VBSS_BASE_ELEMENTARY_H

#include <vblast_ss/elementary.h>

void vbss_sincos(double x, double *sine, double *cosine);
double vbss_exp(double x);
double vbss_log(double x); /* natural logarithm */

#endif
