#include "demo/bar.h"

#include <math.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define OFTEN 0.2   /* s, between two looks of a terminal's line */
#define SELDOM 10.0 /* s, between two lines where there is no terminal */
#define KNOWN 0.02  /* part of the work after which the rest can be estimated */

enum { WIDE = 30 };

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void bar_begin(bar *b, FILE *to)
{
    *b = (bar){.to = to, .terminal = isatty(fileno(to)) != 0, .began = now(), .stage = ""};
    b->shown = b->began - SELDOM;
}

static void draw(const bar *b, double part, double elapsed)
{
    char drawn[WIDE + 1], left[32] = "";
    const int full = (int)(part * WIDE);
    memset(drawn, '.', WIDE);
    memset(drawn, '#', (size_t)full);
    drawn[WIDE] = '\0';
    if (part > KNOWN) {
        const int seconds = (int)ceil(elapsed * (1.0 - part) / part);
        snprintf(left, sizeof left, "%d:%02d left", seconds / 60, seconds % 60);
    }
    fprintf(b->to, "%s[%s] %3d %%  %-11s %-34s%s", b->terminal ? "\r" : "", drawn, b->percent, left,
            b->stage, b->terminal ? "" : "\n");
    fflush(b->to);
}

void bar_show(bar *b, const char *stage, double part)
{
    const double time = now(), within = fmin(fmax(part, 0.0), 1.0);
    if (time - b->shown < (b->terminal ? OFTEN : SELDOM)) {
        return;
    }
    b->percent = (int)(100.0 * within);
    b->stage = stage;
    b->shown = time;
    draw(b, within, time - b->began);
}

void bar_end(bar *b)
{
    if (b->terminal) {
        fprintf(b->to, "\r%*s\r", WIDE + 60, "");
        fflush(b->to);
    }
}
