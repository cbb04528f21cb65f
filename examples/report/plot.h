/* Plots as SVG within the page, without a script: an axis of time, curves, spans, ticks. */
#ifndef VBSS_EXAMPLES_REPORT_PLOT_H
#define VBSS_EXAMPLES_REPORT_PLOT_H

#include "report/facts.h"
#include "report/text.h"

typedef struct plot {
    page *to;
    double x0, x1, y0, y1;           /* what is shown */
    double left, top, width, height; /* of the inner part, in units of the drawing */
} plot;

/* Title and description are read out by screen readers. */
void plot_open(page *to, int width, int height, const char *title, const char *description);
void plot_close(page *to);
/* Opens a drawing with axes: time below, from 0 to `end`, and 0 to `most` of a unit on the left. */
plot plot_of_time(page *to, const char *title, const char *description, double end, double limit,
                  const char *unit);
double plot_x(const plot *p, double x);
double plot_y(const plot *p, double y);
/* Faint lines where phases end. */
void plot_phases(const plot *p, const facts *f);
/* n points; where several fall on one place, their range is drawn. What is below 0 or no number is left out. */
void plot_curve(const plot *p, const double *x, const double *y, size_t n, const char *style);
/* A round step of which about `count` make the range. */
double plot_step(double range, int count);

#endif
