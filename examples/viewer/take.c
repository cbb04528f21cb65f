/* Stills, or a film, without a window. */
#include <stdio.h>
#include <stdlib.h>

#include "film.h"
#include "headless.h"
#include "modes.h"
#include "player.h"
#include "show.h"
#include "still.h"

#define STILLS_EVERY 1.0 /* s, usually */

enum { PATH_SIZE = 1024, FILM_RATE = 30 };

typedef struct taking {
    const options *o;
    show show;
    player player;
    film film;
    uint8_t *pixels;
    uint32_t frames;
} taking;

static bool write_still(const taking *t)
{
    char path[PATH_SIZE];
    int length =
        snprintf(path, sizeof path, "%s/frame-%04u.png", t->o->folder, (unsigned)t->frames);
    bool good = length > 0 && (size_t)length < sizeof path &&
                still_write(path, t->pixels, t->o->width, t->o->height);
    if (!good) {
        fprintf(stderr, "viewer: cannot write into %s\n", t->o->folder);
    }
    return good;
}

static bool take_picture(taking *t)
{
    if (!show_draw(&t->show, t->player.time) || !show_finish(&t->show)) {
        return false;
    }
    lens_read(&t->show.renderer.lens, t->pixels);
    if (!(t->o->film != NULL ? film_add(&t->film, t->pixels) : write_still(t))) {
        return false;
    }
    t->frames++;
    return true;
}

/* False: a picture or a step failed, or the session was not as it was recorded. */
static bool play(taking *t)
{
    const double usual = t->o->film != NULL ? 1.0 / FILM_RATE : STILLS_EVERY;
    const double every = t->o->every > 0.0 ? t->o->every : usual;
    do {
        if (t->player.time > t->o->to + 1e-9) { /* times are sums of steps */
            return true;
        }
        if (t->player.time >= t->o->from + every * t->frames - 1e-9 && !take_picture(t)) {
            return false;
        }
    } while (player_step(&t->player));
    if (!t->player.differs && !t->player.whole) {
        fprintf(stderr, "viewer: the log is cut off after step %llu\n",
                (unsigned long long)t->player.step);
    }
    return !t->player.differs && t->player.whole;
}

static bool take(taking *t)
{
    if (!player_open(&t->player, t->o->log) || !show_stage(&t->show, &t->player.stage)) {
        return false;
    }
    t->show.looks = t->o->looks;
    if (t->o->film == NULL) {
        return play(t);
    }
    if (!film_begin(&t->film, t->o->film, t->o->width, t->o->height, FILM_RATE)) {
        return false;
    }
    bool good = play(t);
    return film_end(&t->film) && good;
}

int mode_take(const options *o)
{
    static taking t;
    headless gl;
    t.o = o;
    if (!headless_begin(&gl) || !show_begin(&t.show, o->width, o->height)) {
        return MODE_NO_OPENGL;
    }
    t.pixels = calloc(3 * (size_t)o->width, (size_t)o->height);
    bool good = t.pixels != NULL && take(&t);
    printf("%u pictures in %s\n", (unsigned)t.frames, o->film != NULL ? o->film : o->folder);
    player_close(&t.player);
    free(t.pixels);
    show_end(&t.show);
    headless_end(&gl);
    return good ? 0 : 1;
}
