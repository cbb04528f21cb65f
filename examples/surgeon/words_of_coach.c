/* The coach's events in words, and what it says as the hands go on. */
#include <stdio.h>

#include "surgeon/task.h"

#define MILLI 1e3
#define DEGREES (180.0 / 3.14159265358979323846)

static const char *const goals[VBSS_SESSION_GOAL_CUT + 1] = {"none",
                                                             "take the needle",
                                                             "reach the mark",
                                                             "pierce the wall",
                                                             "drive the needle",
                                                             "expose its tip",
                                                             "take the tip",
                                                             "release the needle",
                                                             "draw the needle",
                                                             "draw the thread",
                                                             "lengthen the tail",
                                                             "wind",
                                                             "take the tail",
                                                             "release the tail",
                                                             "draw the tail",
                                                             "seat the throw",
                                                             "hand over",
                                                             "take shears",
                                                             "cut"};

static const char *const mistakes[VBSS_SESSION_MISTAKE_COUNT] = {
    "none",          "needle dropped",          "entry missed",      "exit missed",
    "stray hole",    "needle withdrawn",        "thread pulled out", "tail too short",
    "tail too long", "turns toward the handle", "wrong sense",       "turns lost",
    "too few turns", "bight of the tail",       "tail dropped",      "throw undone",
    "granny",        "too few wraps",           "too many wraps",    "stray knot",
    "capsized",      "one-sided pull",          "slack throw",       "slit opened",
    "walls crossed", "drain tearing",           "pulled too hard",   "no transfer",
    "time up",       "drain torn off",          "cut too early",     "cut in the knot",
    "thread broken"};

static const char *const hands[] = {"left", "right", "no"};

void task_words_of_coach(const vbss_session_event *e, char words[TASK_WORDS])
{
    if (e->kind == VBSS_SESSION_EVENT_GOAL) {
        snprintf(words, TASK_WORDS, "goal of the %s hand: %s", hands[e->tool], goals[e->number]);
    } else {
        snprintf(words, TASK_WORDS, "mistake%s: %s", e->undone != 0 ? " ended" : "",
                 mistakes[e->number]);
    }
}

void task_print_coaching(double time, const vbss_session_coaching *c)
{
    printf("%8.3f s  %s  [", time, c->sentence);
    if ((c->geometry & (uint32_t)VBSS_SESSION_GEOMETRY_POINT) != 0) {
        printf(" at %.1f %.1f %.1f", MILLI * c->point[0], MILLI * c->point[1], MILLI * c->point[2]);
    }
    printf(" distance %.1f mm, angle %.0f deg, off %.1f mm, turns %.2f, force %.2f N, length %.1f "
           "mm ]\n",
           MILLI * c->distance, DEGREES * c->angle, MILLI * c->offset, c->turns, c->force,
           MILLI * c->length);
    if (c->mistake != VBSS_SESSION_MISTAKE_NONE) {
        printf("            ! %s %s%s\n", c->mistake_sentence, c->remedy,
               c->is_mendable != 0 ? "" : " (cannot be mended)");
    }
    fflush(stdout);
}
