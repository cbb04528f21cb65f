/* How far the surgeon is: on a terminal a line that is written again and again, else one every few seconds. */
#include <stdio.h>
#include <unistd.h>

#include "knots/words.h"
#include "surgeon/watch.h"

#define MILLI 1e3
#define OFTEN 0.1 /* s, simulated */
#define SELDOM 2.0
enum { NOTATION = 32 };

static void words_of_knot(const watch *w, char text[WORD_TAGS])
{
    vbss_knot_state k;
    char notation[NOTATION] = "";
    bool good =
        vbss_knot_detector_get_state(w->task.knots, &k, sizeof k) == VBSS_OK &&
        vbss_knot_detector_get_notation(w->task.knots, notation, sizeof notation) == VBSS_OK;
    if (!good || (k.throw_count == 0 && k.next_verdict == VBSS_KNOT_VERDICT_NONE)) {
        snprintf(text, WORD_TAGS, "none");
    } else if (k.next_verdict != VBSS_KNOT_VERDICT_NONE) {
        snprintf(text, WORD_TAGS, "%s%s%s", notation, notation[0] != '\0' ? ", next " : "",
                 words_of_result(k.next_verdict));
    } else {
        snprintf(text, WORD_TAGS, "%s, %s", notation, words_of_result(k.verdict));
    }
}

void watch_progress(watch *w, const surgeon *s, bool enters)
{
    const double time = s->stitch.site.rig.time;
    const bool again = isatty(STDOUT_FILENO) != 0;
    char knot[WORD_TAGS];
    if (w->verbose || w->guest != NULL ||
        (!enters && time < w->reported + (again ? OFTEN : SELDOM))) {
        return;
    }
    if (w->reported == 0.0) {
        printf("%7s%8s  %-7s %-10s%9s%9s%10s  %s\n", "s", "real s", "stage", "hands", "left, N",
               "right, N", "slit, mm", "knot");
    }
    words_of_knot(w, knot);
    printf("%s%7.2f%8.2f  %-7s %-10s%9.2f%9.2f%10.2f  %-*s%s", again ? "\r" : "", time,
           watch_wall_clock() - w->began, surgeon_stage_name(s->stage), surgeon_doing(s),
           watch_feels(stitch_hand(&s->stitch, SITE_LEFT)),
           watch_feels(stitch_hand(&s->stitch, SITE_RIGHT)), MILLI * s->gap, again ? 32 : 0, knot,
           again && !enters ? "" : "\n");
    fflush(stdout);
    w->reported = time;
}
