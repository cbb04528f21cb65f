/* A thread that already goes through both marks of a drain, with or without a throw above the slit; two hands at its ends.
 * The same for tests, bench and pictures. */
#ifndef VBSS_TESTS_SCENES_STITCH_SCENES_H
#define VBSS_TESTS_SCENES_STITCH_SCENES_H

#include <vblast_ss/scene.h>

#include "base/linear.h"

enum { STITCH_NODES = 512 };

typedef struct stitch_scene_options {
    vbss_scene_config scene;
    vbss_drain_config drain;
    vbss_thread_config thread; /* but for its length and nodes */
    uint32_t
        crossings; /* of the limbs above the slit, odd: 1 none, 3 a single throw, 5 a double; 0: they do not meet */
    double segment; /* m */
    double limb;    /* m, of each, beyond the wall or the throw */
    double rise;    /* rad, of limbs that do not meet, from the horizontal */
} stitch_scene_options;

typedef struct stitch_scene {
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_thread *thread;
    uint32_t drain_body, thread_body;
    uint32_t holes[2]; /* left, right */
    uint32_t hands[2]; /* attachments of the limbs that end left and right */
    uint32_t ends[2];  /* their nodes */
    vec3 at[2];        /* where hands are */
    uint32_t node_count;
    double rest[STITCH_NODES], x[3 * STITCH_NODES];
} stitch_scene;

vbss_result stitch_scene_init(stitch_scene_options *options);
/* The scene must stay where it is. */
vbss_result stitch_scene_create(vbss_context *context, const stitch_scene_options *options,
                                stitch_scene *made);
/* Where a hand is at the end of the next step. */
vbss_result stitch_scene_move(stitch_scene *s, int hand, vec3 to);
/* What it pulls with, away from the drain, N; left, right. */
double stitch_scene_pull(const stitch_scene *s, int hand);
vbss_result stitch_scene_let_go(stitch_scene *s, int hand);
/* One step of h of tying: the thread settles, then both hands draw outward while they pull with less than 2 N, and hold. */
#define STITCH_TIE_STEPS 900
vbss_result stitch_scene_tie(stitch_scene *s, uint32_t step, double h);
/* Whether that hand moves before that step of it, and where to. */
bool stitch_scene_draws(const stitch_scene *s, int hand, uint32_t step, double h, vec3 *to);
/* The hole on that side, or none: false. */
bool stitch_scene_hole(const stitch_scene *s, int side, vbss_hole *hole);

#endif
