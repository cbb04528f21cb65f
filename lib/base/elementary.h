/* Elementary functions for internal use, beside those of vblast_ss/elementary.h.
 *
 * Results have the same bits on every machine. Special values follow C11 Annex F.
 * docs/elementary-functions.md explains methods and errors. */
#ifndef VBSS_BASE_ELEMENTARY_H
#define VBSS_BASE_ELEMENTARY_H

#include <vblast_ss/elementary.h>

void vbss_sincos(double x, double *sine, double *cosine);
double vbss_exp(double x);
double vbss_log(double x); /* natural logarithm */

#endif
