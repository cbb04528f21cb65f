/* What can be switched on. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "show.h"

#define JUDGED_EVERY 0.1              /* s */
#define FORCE_LENGTH 0.01             /* m/N */
#define ABSOLUTE_FORCE_TOLERANCE 5e-3 /* N: what is less is not drawn */
#define HELP_WIDE 520.0F
#define WORDS_WIDE 450.0F
#define GRAPH_TALL 70.0F
#define MAX_TIME 2000.0F /* us, at its top */
#define BUDGET 1000.0F   /* of a step in real time */

enum { MAX_LINE = 160 };

/* ---- in the scene */

typedef struct row {
    const double *point, *force;
} row;

static row row_at(const vbss_view *points, const vbss_view *forces, uint64_t i)
{
    return (row){(const double *)((const char *)points->data + i * points->stride_bytes),
                 (const double *)((const char *)forces->data + i * forces->stride_bytes)};
}

static void draw_force(show *s, const double at[3], const double force[3], pen_colour colour)
{
    float from[2], to[2];
    double end[3], square = 0.0;
    for (int i = 0; i < 3; i++) {
        end[i] = at[i] + FORCE_LENGTH * force[i];
        square += force[i] * force[i];
    }
    if (square > ABSOLUTE_FORCE_TOLERANCE * ABSOLUTE_FORCE_TOLERANCE && show_place(s, at, from) &&
        show_place(s, end, to)) {
        pen_line(&s->pen, from, to, 2.0F, colour);
        pen_box(&s->pen, to[0] - 2.5F, to[1] - 2.5F, 5.0F, 5.0F, colour);
    }
}

static void draw_contacts(show *s)
{
    vbss_view points, forces;
    if (vbss_scene_get_view(s->stage->scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &points,
                            sizeof points) != VBSS_OK ||
        vbss_scene_get_view(s->stage->scene, VBSS_SCENE_VIEW_CONTACT_FORCES, &forces,
                            sizeof forces) != VBSS_OK) {
        return;
    }
    for (uint64_t i = 0; i < points.count; i++) {
        const row r = row_at(&points, &forces, i);
        float at[2];
        if ((s->overlays & SHOW_CONTACTS) != 0 && show_place(s, r.point, at)) {
            pen_box(&s->pen, at[0] - 2.0F, at[1] - 2.0F, 4.0F, 4.0F, PEN_BLUE);
        }
        if ((s->overlays & SHOW_FORCES) != 0) {
            draw_force(s, r.point, r.force, PEN_YELLOW);
        }
    }
}

/* What a hand would feel. */
static void draw_hands(show *s)
{
    vbss_grasper_state tool;
    for (int side = 0; side < SIDES; side++) {
        if (vbss_grasper_get_state(s->stage->graspers[side], &tool, sizeof tool) == VBSS_OK) {
            draw_force(s, tool.position, tool.hand_force, PEN_GREEN);
        }
    }
}

/* ---- words */

static void put_line(show *s, float *y, pen_colour colour, const char *text)
{
    pen_text(&s->pen, SHOW_MARGIN, *y, SHOW_TEXT, colour, text);
    *y += SHOW_LINE;
}

static const char *result_of(const vbss_knot_state *k)
{
    static const char *const words[] = {"none",   "wrapping",  "passed",
                                        "formed", "certified", "uncertain"};
    const int32_t result = k->verdict;
    return result >= 0 && result < (int32_t)(sizeof words / sizeof *words) ? words[result] : "?";
}

bool overlay_judge(show *s, double time)
{
    if (s->judged && fabs(time - s->judged_at) < JUDGED_EVERY) {
        return true;
    }
    memset(&s->knot, 0, sizeof s->knot);
    s->judged = stage_judge(s->stage, &s->knot) == VBSS_OK;
    s->judged_at = time;
    return s->judged;
}

static void put_knot(show *s, float *y, double time)
{
    char line[MAX_LINE];
    if (!overlay_judge(s, time)) {
        put_line(s, y, PEN_PALE, "knot: cannot be judged");
        return;
    }
    const vbss_knot_state *k = &s->knot.state;
    snprintf(line, sizeof line, "knot: %s%s%s, throws %u, crossings %u",
             k->throw_count > 0 ? s->knot.notation : "", k->throw_count > 0 ? " " : "",
             result_of(k), (unsigned)k->throw_count, (unsigned)k->crossings);
    put_line(s, y, k->throw_count > 0 ? PEN_GREEN : PEN_WHITE, line);
}

/* Of the hands, and of the scene's work. */
static void put_work(show *s, float *y)
{
    vbss_scene_statistics now;
    char line[MAX_LINE];
    if (vbss_scene_get_statistics(s->stage->scene, &now, sizeof now) == VBSS_OK) {
        snprintf(line, sizeof line, "contacts %u, clamped %llu", (unsigned)now.contacts,
                 (unsigned long long)now.clamped);
        put_line(s, y, now.clamped > 0 ? PEN_YELLOW : PEN_PALE, line);
    }
    for (int side = 0; side < SIDES; side++) {
        vbss_grasper_state tool;
        if (vbss_grasper_get_state(s->stage->graspers[side], &tool, sizeof tool) != VBSS_OK) {
            continue;
        }
        const double *f = tool.hand_force;
        snprintf(
            line, sizeof line, "%s: %.2f N%s%s%s", side == LEFT ? "left" : "right",
            sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]),
            tool.needle != 0 ? ", has the needle" : "", tool.drain != 0 ? ", has the drain" : "",
            tool.grasp_count > 0 && tool.needle == 0 && tool.drain == 0 ? ", has the thread" : "");
        put_line(s, y, PEN_PALE, line);
    }
}

static void put_times(show *s)
{
    const float right = s->wide - SHOW_MARGIN, x = right - SHOW_TIMES_KEPT;
    const float top = SHOW_MARGIN, bottom = top + GRAPH_TALL;
    float largest = 0.0F;
    char line[MAX_LINE];
    pen_box(&s->pen, x, top, SHOW_TIMES_KEPT, GRAPH_TALL, PEN_SHADE);
    for (int i = 0; i < SHOW_TIMES_KEPT; i++) {
        const float us = s->times[(s->times_next + i) % SHOW_TIMES_KEPT];
        const float tall = GRAPH_TALL * fminf(us, MAX_TIME) / MAX_TIME;
        pen_box(&s->pen, x + (float)i, bottom - tall, 1.0F, tall,
                us > BUDGET ? PEN_RED : PEN_GREEN);
        largest = fmaxf(largest, us);
    }
    pen_box(&s->pen, x, bottom - GRAPH_TALL * BUDGET / MAX_TIME, SHOW_TIMES_KEPT, 1.0F, PEN_PALE);
    snprintf(line, sizeof line, "longest step %.0f us; line: 1 ms", (double)largest);
    pen_text(&s->pen, x, bottom + SHOW_LINE, 0.8F * SHOW_TEXT, PEN_PALE, line);
}

static int count_lines(const show *s)
{
    return ((s->overlays & SHOW_KNOT) != 0) +
           ((s->overlays & SHOW_TASK) != 0 ? 3 + status_lines(s) : 0) +
           ((s->overlays & SHOW_TENSION) != 0) + ((s->overlays & SHOW_FORCES) != 0);
}

static void put_words(show *s, double time)
{
    const int lines = count_lines(s);
    float y = SHOW_MARGIN + SHOW_LINE;
    if (lines == 0) {
        return;
    }
    pen_box(&s->pen, 0.5F * SHOW_MARGIN, 0.5F * SHOW_MARGIN, WORDS_WIDE,
            SHOW_LINE * (float)lines + SHOW_MARGIN, PEN_SHADE);
    if ((s->overlays & SHOW_TASK) != 0) {
        y = status_put(s, y, time);
        put_work(s, &y);
    }
    if ((s->overlays & SHOW_KNOT) != 0) {
        put_knot(s, &y, time);
    }
    if ((s->overlays & SHOW_TENSION) != 0) {
        put_line(s, &y, PEN_PALE, "tension: blue 0, grey, yellow 1 N");
    }
    if ((s->overlays & SHOW_FORCES) != 0) {
        put_line(s, &y, PEN_PALE, "forces: 10 mm for 1 N; green: on hands");
    }
}

void overlay_draw(show *s, double time)
{
    if ((s->overlays & (SHOW_CONTACTS | SHOW_FORCES)) != 0) {
        draw_contacts(s);
    }
    if ((s->overlays & SHOW_COACH) != 0) {
        coaching_draw(s);
    }
    if ((s->overlays & SHOW_FORCES) != 0) {
        draw_hands(s);
    }
    put_words(s, time);
    if ((s->overlays & SHOW_TIMES) != 0) {
        put_times(s);
    }
}

void overlay_help(show *s, const char *const *lines, int count)
{
    const float above = 3.0F * SHOW_LINE + SHOW_MARGIN; /* the line of state, or of time */
    const float top = s->tall - SHOW_LINE * (float)count - above;
    pen_box(&s->pen, 0.5F * SHOW_MARGIN, top, HELP_WIDE, SHOW_LINE * ((float)count + 0.5F),
            PEN_SHADE);
    for (int i = 0; i < count; i++) {
        pen_text(&s->pen, SHOW_MARGIN, top + SHOW_LINE * (float)(i + 1), SHOW_TEXT, PEN_WHITE,
                 lines[i]);
    }
}
