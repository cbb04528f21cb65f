/* What is shown of a scene: it, through the laparoscope, and what can be switched on beside it. */
#ifndef VBSS_EXAMPLES_VIEWER_SHOW_H
#define VBSS_EXAMPLES_VIEWER_SHOW_H

#include "pen.h"
#include "renderer.h"
#include "report/stage.h"

/* What can be switched on: bits. */
enum {
    SHOW_CONTACTS = 1,
    SHOW_FORCES = 2,
    SHOW_TENSION = 4, /* as the thread's colour */
    SHOW_KNOT = 8,
    SHOW_TASK = 16,
    SHOW_TIMES = 32, /* of steps */
    SHOW_HELP = 64,
    SHOW_COACH = 128, /* the next goal, and mistakes */
    SHOW_ALL = 255
};

/* Of words, in points of the pen: a capital letter, from line to line, to the border. */
#define SHOW_TEXT 11.0F
#define SHOW_LINE 20.0F
#define SHOW_MARGIN 14.0F

enum { SHOW_TIMES_KEPT = 240 };

typedef struct show {
    renderer renderer;
    pen pen;
    camera camera;
    vbss_visual *visual;
    stage *stage;
    uint32_t overlays;
    float wide, tall; /* the picture, in points of the pen */
    /* the knot, as judged last */
    reading knot;
    bool judged;
    double judged_at; /* s */
    /* the task, as it was measured last */
    vbss_session_status status;
    vbss_metrics_report report;
    bool scored;
    double scored_at; /* s */
    /* the longest step of each frame, us, and the ring's end */
    float times[SHOW_TIMES_KEPT];
    int times_next;
} show;

/* As renderer_begin. */
bool show_begin(show *s, int width, int height);
void show_end(show *s);
/* After show_end, in another context: what it shows is as it was. */
bool show_renew(show *s, int width, int height);
/* What it shows from now on; false, told: no memory. */
bool show_stage(show *s, stage *st);
/* s of work of this thread, to measure steps. */
double show_clock(void);
/* A frame's longest step. */
void show_time(show *s, float microseconds);
/* The scene as it is, and what is switched on; more may be drawn with the pen before show_finish. False, told: a frame failed. */
bool show_draw(show *s, double time);
/* Where in the picture a place of the world is, in points of the pen; false: behind the lens. */
bool show_place(const show *s, const double at[3], float place[2]);
bool show_finish(show *s);

/* ---- overlay.c */
void overlay_draw(show *s, double time);
/* Lines above the lower border. */
void overlay_help(show *s, const char *const *lines, int count);
/* Judges the knot, if it was not just done; false: there is none to judge. */
bool overlay_judge(show *s, double time);

/* ---- coaching.c */
/* The coach's sentences, numbers and geometry, if the session coaches. */
void coaching_draw(show *s);
/* For a script, on standard output. */
void coaching_print(const show *s);

/* ---- status.c */
/* Asks session and metrics, if that was not just done; false: there are none. */
bool status_read(show *s, double time);
/* Lines of them, from that height down; the height after the last. */
float status_put(show *s, float y, double time);
int status_lines(const show *s);
/* For a script, on standard output. */
void status_print(show *s, double time);

#endif
