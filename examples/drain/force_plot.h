/* What a hand drives a needle with over the travel of the tip, on and back, beside a published range. */
#ifndef VBSS_EXAMPLES_DRAIN_FORCE_PLOT_H
#define VBSS_EXAMPLES_DRAIN_FORCE_PLOT_H

#include <stdbool.h>
#include <stddef.h>

enum { FORCE_PLOT_POINTS = 8192 };

typedef struct force_curve {
    double travel[FORCE_PLOT_POINTS], force[FORCE_PLOT_POINTS]; /* m, N */
    size_t count, turn;                                         /* from there on it goes back */
} force_curve;

typedef struct force_plot {
    const char *title;
    double low, high; /* of the range, N */
    const char *range;
} force_plot;

/* Writes an SVG, or a PNG if the path ends so. */
bool force_plot_write(const force_plot *plot, const force_curve *curve, const char *path);

#endif
