/* What the coach of the session says: its sentences, how far the trainee is, and where to go. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "paragraphs.h"

#define MILLI 1e3
#define DEGREES (180.0 / 3.14159265358979323846)
#define RING 2e-3   /* m, radius of the ring about a point */
#define ARROW 12e-3 /* m, of a direction */
#define FULL_TURN 6.283185307179586
#define BESIDE 0.12    /* rad, of an arc's head, at both sides of its end */
#define TOO_SMALL 1e-9 /* a smaller number is not shown */
#define BELOW 4.6F     /* lines: of hands, state and exercise */

enum { RING_SIDES = 16, ARC_SIDES = 48 };

/* ---- in the scene */

static void draw_line(show *s, const double from[3], const double to[3], pen_colour colour)
{
    float a[2], b[2];
    if (show_place(s, from, a) && show_place(s, to, b)) {
        pen_line(&s->pen, a, b, 2.5F, colour);
    }
}

static void step_along(const double from[3], double length, const double direction[3], double to[3])
{
    for (int i = 0; i < 3; i++) {
        to[i] = from[i] + length * direction[i];
    }
}

/* Across the view, whatever that is: a ring in the plane of x and z. */
static void draw_ring(show *s, const double at[3])
{
    double before[3] = {at[0] + RING, at[1], at[2]};
    for (int i = 1; i <= RING_SIDES; i++) {
        const double turn = FULL_TURN * i / RING_SIDES;
        const double next[3] = {at[0] + RING * cos(turn), at[1], at[2] + RING * sin(turn)};
        draw_line(s, before, next, PEN_GREEN);
        memcpy(before, next, sizeof before);
    }
}

/* The start of an arc, turned about its axis. */
static void turn_on_arc(const vbss_session_coaching *c, double turn, double to[3])
{
    double out[3], across[3];
    const double *a = c->arc_axis;
    for (int i = 0; i < 3; i++) {
        out[i] = c->arc_start[i] - c->arc_centre[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] = a[j] * out[k] - a[k] * out[j];
    }
    for (int i = 0; i < 3; i++) {
        to[i] = c->arc_centre[i] + cos(turn) * out[i] + sin(turn) * across[i];
    }
}

static void draw_arc(show *s, const vbss_session_coaching *c)
{
    const double angle = fmin(c->arc_angle, FULL_TURN - 4.0 * BESIDE);
    double before[3], next[3], out[3];
    turn_on_arc(c, 0.0, before);
    for (int i = 1; i <= ARC_SIDES; i++) {
        turn_on_arc(c, angle * i / ARC_SIDES, next);
        draw_line(s, before, next, PEN_YELLOW);
        memcpy(before, next, sizeof before);
    }
    turn_on_arc(c, angle - BESIDE, next); /* its head */
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < 3; i++) {
            out[i] = next[i] + side * BESIDE * (next[i] - c->arc_centre[i]);
        }
        draw_line(s, before, out, PEN_YELLOW);
    }
}

static void draw_geometry(show *s, const vbss_session_coaching *c)
{
    const uint32_t has = c->geometry;
    double to[3];
    if ((has & (uint32_t)VBSS_SESSION_GEOMETRY_ARC) != 0) {
        draw_arc(s, c);
    }
    if ((has & (uint32_t)VBSS_SESSION_GEOMETRY_POINT) == 0) {
        return;
    }
    draw_ring(s, c->point);
    if ((has & (uint32_t)VBSS_SESSION_GEOMETRY_DIRECTION) != 0) {
        step_along(c->point, ARROW, c->direction, to);
        draw_line(s, c->point, to, PEN_GREEN);
    }
    if ((has & (uint32_t)VBSS_SESSION_GEOMETRY_PULL) != 0) {
        step_along(c->point, -ARROW, c->direction, to);
        draw_line(s, c->point, to, PEN_GREEN);
    }
}

/* ---- in words */

static void add_number(char *line, size_t size, const char *format, double value)
{
    const size_t used = strlen(line);
    if (fabs(value) > TOO_SMALL && used < size) {
        (void)snprintf(line + used, size - used, format, value); /* NOLINT: a constant each time */
    }
}

static void add_numbers(paragraphs *l, size_t room, const vbss_session_coaching *c)
{
    char line[PARAGRAPHS_LINE] = "";
    add_number(line, sizeof line, "%.1f mm away   ", MILLI * c->distance);
    add_number(line, sizeof line, "%.0f degrees   ", DEGREES * c->angle);
    add_number(line, sizeof line, "off course by %.1f mm   ", MILLI * c->offset);
    add_number(line, sizeof line, "%.1f turns   ", c->turns);
    add_number(line, sizeof line, "%.1f mm to go   ", MILLI * c->length);
    add_number(line, sizeof line, "pull with %.1f N   ", c->pull_force);
    add_number(line, sizeof line, "%.1f N missing", c->force);
    paragraphs_add(l, room, PEN_PALE, line);
}

static bool read_coaching(const show *s, vbss_session_coaching *c)
{
    vbss_session *session = s->stage->task.session;
    return session != NULL && vbss_session_get_coaching(session, c, sizeof *c) == VBSS_OK;
}

void coaching_draw(show *s)
{
    vbss_session_coaching c;
    paragraphs l = {.count = 0};
    if (!read_coaching(s, &c)) {
        return;
    }
    const size_t room = paragraphs_room(s);
    draw_geometry(s, &c);
    paragraphs_add(&l, room, PEN_WHITE, c.sentence);
    add_numbers(&l, room, &c);
    if (c.mistake != VBSS_SESSION_MISTAKE_NONE) {
        paragraphs_add(&l, room, PEN_RED, c.mistake_sentence);
        paragraphs_add(&l, room, PEN_YELLOW, c.remedy);
    }
    paragraphs_put(s, &l, BELOW);
}

void coaching_print(const show *s)
{
    vbss_session_coaching c;
    if (read_coaching(s, &c)) {
        printf(" coach %d %d %d", (int)c.goal, (int)c.tool, (int)c.mistake);
    }
}
