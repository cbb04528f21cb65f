/* Elementary functions for internal use.
 *
 * The first four are the public ones without the entry of a public call.
 * Results have the same bits on every machine. Special values follow C11 Annex F.
 * docs/explanation/elementary-functions.md explains methods and errors. */
#ifndef VBSS_BASE_ELEMENTARY_H
#define VBSS_BASE_ELEMENTARY_H

#include <vblast_ss/elementary.h>

double vbss_sine(double x);
double vbss_cosine(double x);
double vbss_arc_tangent(double y, double x); /* angle of the point (x, y) */
double vbss_arc_cosine(double x);
void vbss_sincos(double x, double *sine, double *cosine);
double vbss_exp(double x);
double vbss_log(double x); /* natural logarithm */

#endif
