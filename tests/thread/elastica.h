/* The elastica: a rod that does not stretch, clamped horizontally, loaded downwards. */
#ifndef VBSS_TESTS_THREAD_ELASTICA_H
#define VBSS_TESTS_THREAD_ELASTICA_H

#include <vblast_ss/thread.h>

typedef struct elastica {
    double length, weight, load, bending; /* m; N, of all of it; N, at the tip; EI */
    double x, drop, angle, moment;        /* of the tip, m and rad downwards; N m at the clamp */
} elastica;

/* Of a thread with the config's length, weight and EI, and a load at its tip (N). */
elastica elastica_solve(const vbss_thread_config *c, double load);

#endif
