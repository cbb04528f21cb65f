#include "report/plot.h"

#include <math.h>

#define WIDTH 960
#define HEIGHT 200

void plot_open(page *to, int width, int height, const char *title, const char *description)
{
    put(to, "<svg viewBox=\"0 0 %d %d\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\"><title>",
        width, height);
    put_text(to, title);
    put(to, "</title><desc>");
    put_text(to, description);
    put(to, "</desc>\n");
}

void plot_close(page *to)
{
    put(to, "</svg>\n");
}

double plot_step(double range, int count)
{
    double step = pow(10.0, floor(log10(range / count)));
    double times = range / count / step;
    return step * (times > 5.0 ? 10.0 : times > 2.0 ? 5.0 : times > 1.0 ? 2.0 : 1.0);
}

double plot_x(const plot *p, double x)
{
    return p->left + p->width * (x - p->x0) / (p->x1 - p->x0);
}

double plot_y(const plot *p, double y)
{
    return p->top + p->height * (1.0 - (y - p->y0) / (p->y1 - p->y0));
}

static int decimals(double step)
{
    return step >= 1.0 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
}

static void draw_axes(const plot *p, const char *unit)
{
    double dx = plot_step(p->x1 - p->x0, 10), dy = plot_step(p->y1 - p->y0, 5);
    for (int i = 0; p->y0 + i * dy <= p->y1 * (1.0 + 1e-9); i++) {
        double y = plot_y(p, p->y0 + i * dy);
        put(p->to, "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>",
            p->left, p->left + p->width, y, y);
        put(p->to, "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%.*f</text>\n",
            p->left - 6.0, y + 4.0, decimals(dy), p->y0 + i * dy);
    }
    for (int i = 0; p->x0 + i * dx <= p->x1 * (1.0 + 1e-9); i++) {
        put(p->to,
            "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%.*f</text>\n",
            plot_x(p, p->x0 + i * dx), p->top + p->height + 16.0, decimals(dx), p->x0 + i * dx);
    }
    put(p->to, "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">time, s</text>",
        p->left + p->width, p->top + p->height + 31.0);
    put(p->to, "<text class=\"unit\" x=\"%.1f\" y=\"%.1f\">", p->left - 42.0, p->top - 8.0);
    put_text(p->to, unit);
    put(p->to, "</text>\n");
}

plot plot_of_time(page *to, const char *title, const char *description, double end, double limit,
                  const char *unit)
{
    plot p = {.to = to,
              .x1 = end > 1e-6 ? end : 1.0,
              .y1 = limit > 1e-9 ? 1.08 * limit : 1.0,
              .left = 52.0,
              .top = 24.0,
              .width = WIDTH - 62.0,
              .height = HEIGHT - 58.0};
    plot_open(to, WIDTH, HEIGHT, title, description);
    draw_axes(&p, unit);
    return p;
}

void plot_phases(const plot *p, const facts *f)
{
    for (size_t i = 1; i < f->phase_count; i++) {
        double x = plot_x(p, f->phases[i].from);
        put(p->to, "<line class=\"cut\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>\n", x, x,
            p->top, p->top + p->height);
    }
}

typedef struct pen {
    const plot *p;
    bool down, empty;               /* nothing is gathered of the place at hand */
    double column, low, high, last; /* of the place at hand */
} pen;

static void draw_column(pen *d)
{
    const plot *p = d->p;
    if (d->empty) {
        return;
    }
    put(p->to, "%c%.1f %.1f", d->down ? 'L' : 'M', p->left + d->column, plot_y(p, d->low));
    d->down = true;
    if (d->high > d->low) {
        put(p->to, "L%.1f %.1fL%.1f %.1f", p->left + d->column, plot_y(p, d->high),
            p->left + d->column, plot_y(p, d->last));
    }
    d->empty = true;
}

void plot_curve(const plot *p, const double *x, const double *y, size_t n, const char *style)
{
    pen d = {.p = p, .column = -1.0, .empty = true};
    put(p->to, "<path class=\"%s\" d=\"M%.1f %.1f", style, p->left, p->top + p->height);
    for (size_t i = 0; i < n; i++) {
        double column = floor(plot_x(p, x[i]) - p->left);
        if (!(y[i] >= 0.0 && column >= 0.0 && column <= p->width)) {
            draw_column(&d);
            d.down = false;
            continue;
        }
        if (d.empty || column > d.column) {
            draw_column(&d);
            d.column = column;
            d.low = d.high = y[i];
            d.empty = false;
        }
        d.low = fmin(d.low, y[i]);
        d.high = fmax(d.high, y[i]);
        d.last = y[i];
    }
    draw_column(&d);
    put(p->to, "\"/>\n");
}
