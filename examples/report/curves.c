/* Forces, speeds, paths over time, and where the tips went. */
#include <math.h>
#include <stdlib.h>

#include "report/page.h"
#include "report/plot.h"

static double largest(const double *v, size_t n)
{
    double largest_value = 0.0;
    for (size_t i = 0; i < n; i++) {
        largest_value = v[i] > largest_value ? v[i] : largest_value;
    }
    return largest_value;
}

static double *times(double begin, size_t n)
{
    double *t = calloc(n > 0 ? n : 1, sizeof *t);
    for (size_t i = 0; t != NULL && i < n; i++) {
        t[i] = begin + 0.01 * (double)i;
    }
    return t;
}

/* Both tools, a row each hundredth of a second. */
static void put_both(page *p, const facts *f, double *const rows[SIDES], const size_t *count,
                     const char *title, const char *description, const char *unit, double scale)
{
    const measured *m = &f->measured;
    double largest_value =
        fmax(largest(rows[LEFT], count[LEFT]), largest(rows[RIGHT], count[RIGHT]));
    plot d = plot_of_time(p, title, description, facts_end(f), scale * largest_value, unit);
    plot_phases(&d, f);
    for (int side = 0; side < SIDES; side++) {
        double *t = times(m->begin, count[side]);
        double *y = calloc(count[side] + 1, sizeof *y);
        for (size_t i = 0; y != NULL && i < count[side]; i++) {
            y[i] = scale * rows[side][i];
        }
        if (t != NULL && y != NULL && f->tools[side] != 0) {
            plot_curve(&d, t, y, count[side], page_side(side));
        }
        free(t);
        free(y);
    }
    plot_close(p);
}

static void put_legend(page *p)
{
    put(p,
        "<p class=\"legend\"><span class=\"key left\">left tool</span> <span class=\"key "
        "right\">right tool (dashed)</span> <span class=\"key cut\">end of a phase</span></p>\n");
}

static void put_paths(page *p, const facts *f)
{
    const measured *m = &f->measured;
    double *length[SIDES] = {NULL, NULL};
    for (int side = 0; side < SIDES; side++) {
        length[side] = calloc(m->rows[side] + 1, sizeof **length);
        double sum = 0.0;
        for (size_t i = 0; length[side] != NULL && i < m->rows[side]; i++) {
            sum += 0.01 * m->speed[side][i];
            length[side][i] = sum;
        }
    }
    if (length[LEFT] != NULL && length[RIGHT] != NULL) {
        put(p, "<figure><figcaption>Length of path</figcaption>");
        put_both(p, f, length, m->rows, "Length of the paths of both tips over time",
                 "Rises where a tip moves; the ends are the paths in the table of metrics.",
                 "path, m", 1.0);
        put(p, "</figure>\n");
    }
    free(length[LEFT]);
    free(length[RIGHT]);
}

/* ---- where the tips went, from one side, to scale */

typedef struct frame {
    double low[3], high[3];
} frame;

static frame frame_of(const facts *f)
{
    frame r = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (uint64_t i = 0; i < f->steps; i++) {
        const moment *m = &f->moments[i];
        for (int side = 0; side < SIDES; side++) {
            for (int k = 0; m->reported[side] && k < 3; k++) {
                if (fabs(m->at[side][k]) <= 1e3) {
                    r.low[k] = fmin(r.low[k], m->at[side][k]);
                    r.high[k] = fmax(r.high[k], m->at[side][k]);
                }
            }
        }
    }
    return r;
}

static void put_trace(page *p, const facts *f, int side, int across, int up, const frame *r,
                      double scale, double height)
{
    double last[2] = {HUGE_VAL, HUGE_VAL};
    bool down = false;
    put(p, "<path class=\"%s thin\" d=\"M0 0", page_side(side));
    for (uint64_t i = 0; i < f->steps; i++) {
        const moment *m = &f->moments[i];
        double x = 20.0 + scale * (m->at[side][across] - r->low[across]);
        double y = height - 30.0 - scale * (m->at[side][up] - r->low[up]);
        if (!m->reported[side] || !(fabs(x) < 1e4 && fabs(y) < 1e4) ||
            (down && fabs(x - last[0]) + fabs(y - last[1]) < 0.7)) {
            continue;
        }
        put(p, "%c%.1f %.1f", down ? 'L' : 'M', x, y);
        last[0] = x;
        last[1] = y;
        down = true;
    }
    put(p, "\"/>\n");
}

static void put_view(page *p, const facts *f, const frame *r, int up, const char *name)
{
    double wide = r->high[0] - r->low[0], tall = r->high[up] - r->low[up];
    double scale = fmin(430.0 / fmax(wide, 1e-3), 270.0 / fmax(tall, 1e-3));
    int height = (int)(scale * tall) + 60;
    double bar = plot_step(wide > 1e-3 ? wide : 1e-3, 4);
    put(p, "<figure class=\"half\"><figcaption>%s</figcaption>", name);
    plot_open(p, 470, height, name, "The ways of both tips, to scale; x to the right.");
    for (int side = 0; side < SIDES; side++) {
        if (f->tools[side] != 0) {
            put_trace(p, f, side, 0, up, r, scale, height);
        }
    }
    put(p,
        "<path class=\"scale\" d=\"M20 %dh%.1f\"/><text class=\"tick\" x=\"%.1f\" y=\"%d\">%g mm"
        "</text>\n",
        height - 12, scale * bar, 26.0 + scale * bar, height - 8, 1e3 * bar);
    plot_close(p);
    put(p, "</figure>\n");
}

static void put_traces(page *p, const facts *f)
{
    frame r = frame_of(f);
    if (r.high[0] < r.low[0]) {
        return;
    }
    put(p, "<div class=\"pair\">\n");
    put_view(p, f, &r, 1, "Ways of the tips: x across, y up");
    put_view(p, f, &r, 2, "Ways of the tips: x across, z up");
    put(p, "</div>\n");
}

void page_motion(page *p, const facts *f)
{
    const measured *m = &f->measured;
    put(p, "<section aria-labelledby=\"motion\"><h2 id=\"motion\">Forces and motion</h2>\n");
    put_legend(p);
    if (f->again.count > 0) {
        put(p, "<figure><figcaption>Force on the hands, largest in each hundredth of a "
               "second</figcaption>");
        put_both(p, f, m->force, m->force_rows, "Forces on both hands over time",
                 "From playing the log back.", "force, N", 1.0);
        put(p, "</figure>\n");
    } else {
        put(p, "<p class=\"absent\">Forces: not known, as the log does not hold them and was not "
               "played back.</p>\n");
    }
    if (f->tools[LEFT] != 0 || f->tools[RIGHT] != 0) {
        put(p, "<figure><figcaption>Speed of the tips, filtered at 10 Hz</figcaption>");
        put_both(p, f, m->speed, m->rows, "Speeds of both tips over time",
                 "As the tools were told to move.", "speed, mm/s", 1e3);
        put(p, "</figure>\n");
        put_paths(p, f);
        put_traces(p, f);
    } else {
        put(p, "<p class=\"absent\">Motion: no tool was moved in this log.</p>\n");
    }
    if (m->report.ticks_lost > 0) {
        put(p,
            "<p class=\"note\">%llu hundredths of a second were beyond the room for motion.</p>\n",
            (unsigned long long)m->report.ticks_lost);
    }
    put(p, "</section>\n");
}
