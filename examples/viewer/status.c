/* How far the task is, as its session says, and what it is worth, as its metrics say: nothing of it is worked out here. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "show.h"

#define MEASURED_EVERY 0.1 /* s */
#define MILLI 1e3

enum { STATUS_LINE = 160, STATUS_LINES = 5 };

/* Another moment than it was measured at. */
static bool is_old(const show *s, double time)
{
    return !s->scored || fabs(time - s->scored_at) >= MEASURED_EVERY;
}

bool status_read(show *s, double time)
{
    const task *k = &s->stage->task;
    if (k->session == NULL) {
        return false;
    }
    if (is_old(s, time)) {
        s->scored = vbss_session_get_status(k->session, &s->status, sizeof s->status) == VBSS_OK &&
                    vbss_metrics_get_report(k->metrics, &s->report, sizeof s->report) == VBSS_OK;
        s->scored_at = time;
    }
    return s->scored;
}

int status_lines(const show *s)
{
    return s->stage->task.session != NULL ? STATUS_LINES : 1;
}

/* ---- words */

static void put(show *s, float *y, pen_colour colour, const char *text)
{
    pen_text(&s->pen, SHOW_MARGIN, *y, SHOW_TEXT, colour, text);
    *y += SHOW_LINE;
}

static void put_phase(show *s, float *y)
{
    const vbss_session_status *k = &s->status;
    const bool failed = k->failure != VBSS_SESSION_FAILURE_NONE;
    char line[STATUS_LINE];
    snprintf(line, sizeof line, "%s%s%s, %.1f s, events %llu", task_phase_name(k->phase),
             failed                                ? ": "
             : k->stage != VBSS_SESSION_STAGE_NONE ? ": "
                                                   : "",
             failed                                ? task_failure_name(k->failure)
             : k->stage != VBSS_SESSION_STAGE_NONE ? task_stage_name(k->stage)
                                                   : "",
             k->time, (unsigned long long)k->event_count);
    put(s, y, failed ? PEN_RED : PEN_WHITE, line);
}

static void write_mark(const vbss_session_status *k, int mark, char text[16])
{
    if ((k->punctured & (1U << mark)) != 0) {
        snprintf(text, 16, "%.2f", k->deviation_mm[mark]);
    } else {
        snprintf(text, 16, "-");
    }
}

static void put_measures(show *s, float *y)
{
    const vbss_session_status *k = &s->status;
    char line[STATUS_LINE], in[16], out[16];
    write_mark(k, 0, in);
    write_mark(k, 1, out);
    snprintf(line, sizeof line, "off the marks, mm: in %s, out %s", in, out);
    put(s, y, PEN_WHITE, line);
    snprintf(line, sizeof line, "slit %.2f mm, tail %.1f mm%s", MILLI * k->gap, MILLI * k->tail,
             k->tail_set != 0 ? ", set" : "");
    put(s, y, PEN_WHITE, line);
    snprintf(line, sizeof line, "throws %u, seated %u, hands changed %u, tails cut %u",
             (unsigned)k->throws, (unsigned)k->seated, (unsigned)k->transfers,
             (unsigned)((k->cut & 1U) + (k->cut >> 1U)));
    put(s, y, PEN_WHITE, line);
}

static void put_score(show *s, float *y)
{
    const vbss_metrics_report *m = &s->report;
    char line[STATUS_LINE];
    if ((m->flags & VBSS_METRICS_FLAG_ASSISTED) != 0) {
        put(s, y, PEN_YELLOW, "assisted: no score");
        return;
    }
    snprintf(line, sizeof line, "score as it stands %.0f, penalties %.0f, drops %u", m->score,
             m->penalties, (unsigned)m->drops);
    put(s, y, PEN_WHITE, line);
}

float status_put(show *s, float y, double time)
{
    char line[STATUS_LINE];
    if (status_read(s, time)) {
        put_phase(s, &y);
        put_measures(s, &y);
        put_score(s, &y);
        return y;
    }
    snprintf(line, sizeof line, "%.1f s", time);
    put(s, &y, PEN_WHITE, line);
    return s->stage->task.session != NULL ? y + SHOW_LINE * (STATUS_LINES - 1) : y;
}

void status_print(show *s, double time)
{
    if (status_read(s, time)) {
        printf(" task %d %d off %.4f %.4f slit %.4f tail %.3f throws %u %u score %.2f",
               (int)s->status.phase, (int)s->status.failure, s->status.deviation_mm[0],
               s->status.deviation_mm[1], MILLI * s->status.gap, MILLI * s->status.tail,
               (unsigned)s->status.throws, (unsigned)s->status.seated, s->report.score);
    }
}
