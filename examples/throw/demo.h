/* The demonstration: a knot is tied by scripted hands, watched, measured, painted and logged, and tied once more
 * from its log. */
#ifndef VBSS_EXAMPLES_THROW_DEMO_H
#define VBSS_EXAMPLES_THROW_DEMO_H

#include <stddef.h>

#include "throw/trial.h"

enum { DEMO_THROWS = 8, DEMO_PATH = 1024 };

/* What the detector says of the thread alone, whatever the tools hold. */
typedef struct demo_knot {
    vbss_knot_state state;
    vbss_knot_throw throws[DEMO_THROWS];
    char notation[32];
} demo_knot;

/* Thread CPU time of every step, in microseconds. */
typedef struct demo_times {
    double *steps;
    size_t count, room;
} demo_times;

/* What the hands did since they began to do it. */
typedef struct demo_stage {
    const char *name; /* NULL: nothing yet */
    double force[2];  /* largest at the hands of W and C, N */
} demo_stage;

typedef struct album album;
typedef struct demo {
    trial_options trial;
    trial_outcome out;
    const char *name, *folder; /* of the knot; of all that is written */
    char log[DEMO_PATH];
    album *album;
    vbss_knot_detector *detector;
    /* time: when the watcher was left, and what was spent outside it, s */
    double left_cpu, left_wall, cpu, wall;
    bool watched;
    demo_times times;
    demo_stage stage;
    double largest[2]; /* force at the left and the right hand, N */
    uint32_t tries[DEMO_THROWS];
    /* in the end */
    bool ended; /* or the trial broke off */
    demo_knot knot;
    vbss_scene_statistics scene;
    vbss_device_statistics device[2];
    vbss_output_statistics output[2];
} demo;

/* ---- watching (watch.c) */
void demo_watch(void *user, const trial_moment *m);
vbss_result demo_judge(demo *d, const senses *s, demo_knot *k);

/* 0: the left hand, 1: the right one; W and C change between them. */
static inline uint32_t demo_side(const hand *h)
{
    return h->trocar.x > 0.0 ? 1 : 0;
}

/* ---- telling (account.c); true: the knot is what it shall be, certified and seated */
bool demo_report(demo *d);

/* ---- once more (again.c); true: to equal hashes, and what was changed is told */
bool demo_replay(const demo *d);

/* ---- pictures (album.c); of a failure the album knows, and says so in the end */
album *album_create(const char *folder, const char *name);
/* When the hands begin to do something else. */
void album_show(album *a, const trial_moment *m, const demo_knot *k);
/* Writes the sheet; also destroys. False: something could not be painted or written. */
bool album_close(album *a);

#endif
