/* A second throw springs open as its tail is let go:
 *
 *     sprung_throw SEED pulled    the hands see it, take the tail and pull again, before the needle changes hands
 *     sprung_throw SEED undone    they do not, it comes undone while the third is wound, and they tie it again
 *
 * Exits 0 if the third throw begins on two throws that are tied, over a slit that is shut. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "surgeon/surgeon.h"

#define STEP 1e-3
#define LONGEST 250.0 /* s */
#define SHUT 0.4e-3   /* m */

/* Until a third throw begins, after the throw was pulled or tied again; true: it did. */
static bool perform(surgeon *s, bool leaves_it)
{
    int retaken = 0;
    while (s->stage < SURGEON_CUT && s->stitch.site.rig.time < LONGEST) {
        if (leaves_it && s->returned == 0) {
            s->retaken = 100; /* as if it had been pulled often enough */
        }
        const surgeon_stage before = s->stage;
        if (surgeon_step(s, STEP) != VBSS_OK) {
            return false;
        }
        retaken += before == SURGEON_BACK && s->stage == SURGEON_SECOND;
        const bool begins = before == SURGEON_BACK && s->stage == SURGEON_THIRD;
        if (begins && (leaves_it ? s->returned : retaken) > 0) {
            return true;
        }
    }
    return false;
}

int main(int count, char **words)
{
    static surgeon s;
    surgeon_options o = {.until = SURGEON_CUT};
    if (count != 3 || (strcmp(words[2], "pulled") != 0 && strcmp(words[2], "undone") != 0)) {
        fprintf(stderr, "usage: %s SEED pulled|undone\n", words[0]);
        return 2;
    }
    o.seed = strtoul(words[1], NULL, 10);
    if (surgeon_create(&s, &o) != VBSS_OK) {
        fprintf(stderr, "no scene\n");
        return 1;
    }
    const bool again = perform(&s, strcmp(words[2], "undone") == 0);
    printf("seed %s after %.1f s: %s, %u throws, slit %.2f mm\n", words[1], s.stitch.site.rig.time,
           again ? "made good" : surgeon_doing(&s), (unsigned)s.see.throws, 1e3 * s.gap);
    const bool good = again && s.see.throws == 2 && s.gap < SHUT;
    throw_rig_destroy(&s.stitch.site.rig);
    return good ? 0 : 1;
}
