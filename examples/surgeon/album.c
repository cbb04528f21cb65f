/* Pictures of the key stages: each when the hands have come to it, from the front and from above. */
#include <stdio.h>
#include <string.h>

#include "surgeon/watch.h"

#define MILLI 1e3

/* What is looked at. */
typedef enum view_target { VIEW_DRAIN, VIEW_W, VIEW_SLIT } view_target;

typedef struct key {
    surgeon_stage stage;
    view_target at;
    const char *doing; /* when the hands begin to do this, */
    const char *file;  /* it is time for that picture */
    const char *words;
    double width; /* of what is seen, m */
} key;

static const key keys[] = {
    {SURGEON_PASS, VIEW_DRAIN, "draw", "1-needle-in-the-drain", "the needle is through both marks",
     0.05},
    {SURGEON_TIE, VIEW_DRAIN, "near", "2-tail-set",
     "the thread is drawn through, the tail is short", 0.06},
    {SURGEON_TIE, VIEW_W, "tail", "3-double-wrap", "the limb is wound twice round the other tool",
     0.05},
    {SURGEON_TIE, VIEW_SLIT, "lower", "4-throw-1-drawn-through", "the double throw", 0.06},
    {SURGEON_OVER, VIEW_SLIT, "ease", "5-throw-1-tight", "the double throw is pulled tight", 0.025},
    {SURGEON_SECOND, VIEW_DRAIN, "near", "6-needle-changed-hands",
     "the other tool has taken the needle over", 0.16},
    {SURGEON_SECOND, VIEW_SLIT, "lower", "7-throw-2-drawn-through", "the second throw", 0.06},
    {SURGEON_BACK, VIEW_SLIT, "ease", "8-throw-2-tight", "the second throw is pulled tight", 0.025},
    {SURGEON_THIRD, VIEW_SLIT, "lower", "9-throw-3-drawn-through", "the third throw", 0.06},
    {SURGEON_CUT, VIEW_SLIT, "ease", "a-knot-tight", "the knot is pulled tight", 0.02},
    {SURGEON_DONE, VIEW_SLIT, "done", "b-tails-cut", "both tails are cut", 0.025},
};

/* The tool that is wound about, above all else; what lies on the slit. */
static vec middle_of(const surgeon *s, view_target at)
{
    return at == VIEW_W      ? mirror_vec(s->stitch.site.rig.mirrored, s->stitch.left.at)
           : at == VIEW_SLIT ? v3(0.0, 0.0, 0.0)
                             : v3(0.0, 0.0, 5e-3);
}

void watch_album(watch *w, const surgeon *s, const char *doing)
{
    char path[1024], text[128];
    for (size_t i = 0; w->album != NULL && i < sizeof keys / sizeof keys[0]; i++) {
        const key *k = &keys[i];
        if (s->stage != k->stage || strcmp(doing, k->doing) != 0) {
            continue;
        }
        snprintf(path, sizeof path, "%s/%s.png", w->album, k->file);
        snprintf(text, sizeof text, "%.2f s: %s; slit %.2f mm", s->stitch.site.rig.time, k->words,
                 MILLI * s->gap);
        w->unpainted = !surgeon_show(s, path, text, middle_of(s, k->at), k->width) || w->unpainted;
    }
}
