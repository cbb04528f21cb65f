/* Phases, what each tool holds, and what happened, on one axis of time. */
#include <math.h>
#include <stdio.h>

#include "report/page.h"
#include "report/plot.h"

enum { WIDE = 960, LANE = 34, LANES = 4, BEGIN = 84 };

typedef struct mark {
    const char *words, *style;
    uint32_t kind;
    char shape; /* c: circle, d: diamond, t: triangle, x: cross */
} mark;

/* What is drawn first lies below. */
static const mark marks[] = {
    {"a step is cut short or paused", "m-warn", VBSS_RECORD_EVENT_TIME_LOST, 'c'},
    {"a wall is entered", "m-needle", VBSS_SCENE_EVENT_PUNCTURE, 't'},
    {"the needle is drawn back", "m-bad", VBSS_SCENE_EVENT_WITHDRAWN, 'x'},
    {"the needle is through", "m-needle", VBSS_SCENE_EVENT_PASSED, 'c'},
    {"torn out of the jaws", "m-bad", VBSS_SCENE_EVENT_TORN, 'x'},
    {"a thread is cut", "m-cut", VBSS_SCENE_EVENT_CUT, 'd'},
    {"a tool is exchanged", "m-tool", VBSS_SCENE_EVENT_EXCHANGED, 'c'},
    {"no room for a hole", "m-bad", VBSS_SCENE_EVENT_HOLE_LOST, 'x'},
};
enum { MARKS = sizeof marks / sizeof marks[0] };

/* Of the session: its kinds of events. */
static const mark reported_marks[] = {
    {"a throw is tied", "m-knot", VBSS_SESSION_EVENT_THROW, 'c'},
    {"a throw is seated", "m-knot", VBSS_SESSION_EVENT_SEATED, 'd'},
    {"the needle has changed hands", "m-tool", VBSS_SESSION_EVENT_TRANSFER, 't'},
    {"the needle is dropped", "m-bad", VBSS_SESSION_EVENT_DROPPED, 'x'},
};
enum { REPORTED_MARKS = sizeof reported_marks / sizeof reported_marks[0] };

static double at(const facts *f, double time)
{
    double end = facts_end(f);
    return BEGIN + (WIDE - BEGIN - 10.0) * (end > 0.0 ? fmin(fmax(time / end, 0.0), 1.0) : 0.0);
}

static void put_lane(page *p, int lane, const char *name)
{
    put(p, "<text class=\"lane\" x=\"0\" y=\"%d\">%s</text>", lane * LANE + 21, name);
    put(p, "<line class=\"grid\" x1=\"%d\" x2=\"%d\" y1=\"%d\" y2=\"%d\"/>\n", BEGIN, WIDE - 10,
        lane * LANE + 32, lane * LANE + 32);
}

static void put_phases(page *p, const facts *f)
{
    put_lane(p, 0, "phases");
    for (size_t i = 0; i < f->phase_count; i++) {
        const phase *h = &f->phases[i];
        double x0 = at(f, h->from), x1 = at(f, h->to);
        put(p, "<g><title>");
        put_text(p, h->name);
        put(p,
            ": %.2f s to %.2f s, %.2f s</title><rect class=\"phase p%d\" x=\"%.1f\" y=\"4\" "
            "width=\"%.1f\" height=\"24\" rx=\"3\"/>",
            h->from, h->to, h->to - h->from, (int)(i % 6), x0, fmax(x1 - x0 - 1.0, 0.5));
        put(p, "<text class=\"inphase\" x=\"%.1f\" y=\"20\" text-anchor=\"middle\">",
            0.5 * (x0 + x1));
        if (x1 - x0 > 7.0 * (double)snprintf(NULL, 0, "%s", h->name)) {
            put_text(p, h->name);
        } else if (x1 - x0 > 14.0) {
            put(p, "%d", (int)i + 1);
        }
        put(p, "</text></g>\n");
    }
}

static void put_holdings(page *p, const facts *f)
{
    put_lane(p, 1, "left holds");
    put_lane(p, 2, "right holds");
    for (size_t i = 0; i < f->holding_count; i++) {
        const holding *h = &f->holdings[i];
        double x0 = at(f, h->from), x1 = at(f, h->to);
        put(p,
            "<rect class=\"hold %s\" x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"18\" "
            "rx=\"3\"><title>%s tool holds body %u: %.2f s to %.2f s%s</title></rect>\n",
            page_side(h->side), x0, (h->side + 1) * LANE + 8, fmax(x1 - x0, 1.0),
            page_side(h->side), (unsigned)h->thing, h->from, h->to,
            h->ended == VBSS_SCENE_EVENT_TORN ? ", torn out"
            : h->ended == 0                   ? ", to the end of the log"
                                              : "");
    }
}

static void put_shape(page *p, char shape, double x, double y, const char *style)
{
    switch (shape) {
    case 't':
        put(p, "<path class=\"%s\" d=\"M%.1f %.1fl6 11h-12z\">", style, x, y - 7.0);
        break;
    case 'd':
        put(p, "<path class=\"%s\" d=\"M%.1f %.1fl6 7-6 7-6-7z\">", style, x, y - 7.0);
        break;
    case 'x':
        put(p, "<path class=\"%s stroke\" d=\"M%.1f %.1fl10 10m0-10l-10 10\">", style, x - 5.0,
            y - 5.0);
        break;
    default:
        put(p, "<path class=\"%s\" d=\"M%.1f %.1fa4 4 0 1 0 .01 0z\">", style, x, y - 4.0);
        break;
    }
}

static void put_mark(page *p, const facts *f, const mark *m, double time, uint64_t step)
{
    put_shape(p, m->shape, at(f, time), 3 * LANE + 17.0, m->style);
    put(p, "<title>%s: %.3f s, step %llu</title></path>\n", m->words, time,
        (unsigned long long)step);
}

static void put_reported(page *p, const facts *f)
{
    const followed *t = &f->again.session;
    for (size_t i = 0; i < t->count; i++) {
        const vbss_session_event *e = &t->events[i];
        for (int k = 0; k < REPORTED_MARKS; k++) {
            if (reported_marks[k].kind == (uint32_t)e->kind && e->undone == 0 && e->step > 0 &&
                e->step <= f->steps) {
                put_mark(p, f, &reported_marks[k], f->moments[e->step - 1].time, e->step);
            }
        }
    }
}

/* What falls on one place is drawn once. */
static void put_events(page *p, const facts *f)
{
    put_lane(p, 3, "events");
    for (int k = 0; k < MARKS; k++) {
        double last = -1.0;
        for (size_t i = 0; i < f->event_count; i++) {
            const happening *e = &f->events[i];
            double x = at(f, e->time);
            if (e->kind != marks[k].kind || x - last < 1.0) {
                continue;
            }
            last = x;
            put_mark(p, f, &marks[k], e->time, e->step);
        }
    }
    put_reported(p, f);
}

static void put_axis(page *p, const facts *f)
{
    double end = facts_end(f), step = plot_step(end > 1e-6 ? end : 1.0, 10);
    for (int i = 0; i * step <= end * (1.0 + 1e-9) && i <= 20; i++) {
        put(p, "<text class=\"tick\" x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g</text>",
            at(f, i * step), LANES * LANE + 16, i * step);
    }
    put(p, "<text class=\"lane\" x=\"0\" y=\"%d\">time, s</text>\n", LANES * LANE + 16);
}

static void put_entry(page *p, const mark *m, unsigned long long count)
{
    if (count > 0) {
        put(p, "<span><svg viewBox=\"-8 -9 16 18\" width=\"14\" height=\"15\" "
               "aria-hidden=\"true\">");
        put_shape(p, m->shape, 0.0, 0.0, m->style);
        put(p, "</path></svg> %s: %llu</span> ", m->words, count);
    }
}

static unsigned long long count_reported(const followed *t, uint32_t kind)
{
    unsigned long long count = 0;
    for (size_t i = 0; i < t->count; i++) {
        count += (uint32_t)t->events[i].kind == kind && t->events[i].undone == 0;
    }
    return count;
}

static void put_legend(page *p, const facts *f)
{
    put(p, "<p class=\"legend\">");
    for (int k = 0; k < MARKS; k++) {
        put_entry(p, &marks[k], f->counts[marks[k].kind]);
    }
    for (int k = 0; k < REPORTED_MARKS; k++) {
        put_entry(p, &reported_marks[k], count_reported(&f->again.session, reported_marks[k].kind));
    }
    put(p, "</p>\n");
}

static void put_table(page *p, const facts *f)
{
    put(p,
        "<table><caption>Phases</caption><thead><tr><th scope=\"col\" class=\"n\">No.</th><th "
        "scope=\"col\">Phase</th><th scope=\"col\" class=\"n\">from, s</th><th scope=\"col\" "
        "class=\"n\">to, s</th><th scope=\"col\" class=\"n\">takes, s</th></tr></thead><tbody>\n");
    for (size_t i = 0; i < f->phase_count; i++) {
        const phase *h = &f->phases[i];
        put(p, "<tr><td class=\"n\">%d</td><th scope=\"row\">", (int)i + 1);
        put_text(p, h->name);
        put(p,
            "</th><td class=\"n\">%.2f</td><td class=\"n\">%.2f</td><td "
            "class=\"n\">%.2f</td></tr>\n",
            h->from, h->to, h->to - h->from);
    }
    put(p, "</tbody></table>\n");
}

void page_timeline(page *p, const facts *f)
{
    put(p, "<section aria-labelledby=\"timeline\"><h2 id=\"timeline\">Timeline</h2>\n<figure>");
    plot_open(p, WIDE, LANES * LANE + 22, "Phases, what the tools hold, and events over time",
              "The same numbers stand in the table of phases below.");
    put_phases(p, f);
    put_holdings(p, f);
    put_events(p, f);
    put_axis(p, f);
    plot_close(p);
    put(p, "</figure>\n");
    put_legend(p, f);
    put_table(p, f);
    put(p, "<p class=\"note\">");
    put_text(p, f->phase_source);
    put(p, "</p>\n");
    page_session(p, f);
    put(p, "</section>\n");
}
