/* Elementary functions from + - * / sqrt: the same bits everywhere. Errors and methods stand
 * in docs/elementary-functions.md. Special values as in C11 Annex F. */
#ifndef VBSS_BASE_ELEMENTARY_H
#define VBSS_BASE_ELEMENTARY_H

double vbss_sin(double x);
double vbss_cos(double x);
void vbss_sincos(double x, double *sine, double *cosine);
double vbss_atan2(double y, double x);
double vbss_acos(double x);
double vbss_exp(double x);
double vbss_log(double x); /* natural logarithm */

#endif
