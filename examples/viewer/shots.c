#include "shots.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "still.h"

enum { PATH_SIZE = 1024 };

bool shots_open(shots *t, const shots_plan *plan)
{
    memset(t, 0, sizeof *t);
    t->plan = *plan;
    return show_begin(&t->show, plan->width, plan->height);
}

bool shots_begin(shots *t, stage *s)
{
    t->pixels = calloc(3 * (size_t)t->plan.width, (size_t)t->plan.height);
    if (t->pixels == NULL) {
        fprintf(stderr, "viewer: no memory for pictures\n");
        return false;
    }
    if (!show_stage(&t->show, s)) {
        return false;
    }
    t->show.overlays = t->plan.overlays;
    t->filming = t->plan.film != NULL &&
                 movie_begin(&t->movie, t->plan.film, t->plan.width, t->plan.height, SHOTS_RATE);
    return t->plan.film == NULL || t->filming;
}

static bool write_still(const shots *t, uint32_t number)
{
    char path[PATH_SIZE];
    int length = snprintf(path, sizeof path, "%s/frame-%04u.png", t->plan.folder, (unsigned)number);
    bool good = length > 0 && (size_t)length < sizeof path &&
                still_write(path, t->pixels, t->plan.width, t->plan.height);
    if (!good) {
        fprintf(stderr, "viewer: cannot write into %s\n", t->plan.folder);
    }
    return good;
}

/* Waits until the picture that was drawn last is done, and writes it. */
static bool collect(shots *t)
{
    if (!t->waits) {
        return true;
    }
    t->waits = false;
    lens_read(&t->show.renderer.lens, t->pixels);
    return t->plan.film != NULL ? movie_add(&t->movie, t->pixels) : write_still(t, t->count - 1);
}

/* The picture is read when the next one is due, so that OpenGL may draw it while steps are made. */
bool shots_step(shots *t, double time)
{
    /* Times are sums of steps. */
    if (time < t->plan.from + t->plan.every * t->count - 1e-9) {
        return true;
    }
    if (!collect(t) || !show_draw(&t->show, time) || !show_finish(&t->show)) {
        return false;
    }
    glFlush();
    t->waits = true;
    t->count++;
    return true;
}

bool shots_finish(shots *t)
{
    bool good = collect(t);
    if (t->filming) {
        t->filming = false;
        good = movie_end(&t->movie) && good;
    }
    return good;
}

void shots_close(shots *t)
{
    free(t->pixels);
    t->pixels = NULL;
    show_end(&t->show);
}
