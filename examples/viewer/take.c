/* Stills, or a film, without a window. */
#include <stdio.h>

#include "headless.h"
#include "modes.h"
#include "player.h"
#include "shots.h"

#define STILLS_EVERY 1.0 /* s, usually */

/* False: a picture or a step failed, or the session was not as it was recorded. */
static bool play(shots *t, player *p, double to)
{
    do {
        if (p->time > to + 1e-9) { /* times are sums of steps */
            return true;
        }
        if (!shots_step(t, p->time)) {
            return false;
        }
    } while (player_step(p));
    if (!p->differs && !p->whole) {
        fprintf(stderr, "viewer: the log is cut off after step %llu\n",
                (unsigned long long)p->step);
    }
    return !p->differs && p->whole;
}

static bool take(shots *t, player *p, const options *o)
{
    if (!player_open(p, o->log) || !shots_begin(t, &p->stage)) {
        return false;
    }
    bool good = play(t, p, o->to);
    return shots_finish(t) && good;
}

int mode_take(const options *o)
{
    static shots t;
    static player p;
    headless gl;
    const double usual = o->film != NULL ? 1.0 / SHOTS_RATE : STILLS_EVERY;
    const shots_plan plan = {.folder = o->folder,
                             .film = o->film,
                             .every = o->every > 0.0 ? o->every : usual,
                             .from = o->from,
                             .width = o->width,
                             .height = o->height,
                             .overlays = o->overlays};
    if (!headless_begin(&gl) || !shots_open(&t, &plan)) {
        return MODE_NO_OPENGL;
    }
    bool good = take(&t, &p, o);
    if (good) {
        printf("%u pictures in %s\n", (unsigned)t.count, o->film != NULL ? o->film : o->folder);
    }
    player_close(&p);
    shots_close(&t);
    headless_end(&gl);
    return good ? 0 : 1;
}
