/* A needle with its thread in two pairs of hands, the same for tests, bench and the determinism table. What hands do is
 * worked out from the number of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_NEEDLE_SCENES_H
#define VBSS_TESTS_SCENES_NEEDLE_SCENES_H

#include <vblast_ss/scene.h>

/* Steps of 1 ms: the needle falls flat on the floor; the first tool picks it up from above, by the middle of its arc, and
 * lifts it; the second takes it nearer to the tip from outside; the first lets go; the second carries it aside, turning it
 * upright, and lets it drop. */
enum { NEEDLE_SCENE_STEPS = 2200 };
typedef enum needle_scene_moment {
    NEEDLE_SCENE_LYING = 150,   /* and at rest, touched by nothing else */
    NEEDLE_SCENE_TAKEN = 400,   /* by the first, on the floor yet */
    NEEDLE_SCENE_LIFTED = 780,  /* 20 mm */
    NEEDLE_SCENE_BOTH = 1060,   /* hold it */
    NEEDLE_SCENE_HANDED = 1110, /* the first has let go, and is still round it */
    NEEDLE_SCENE_DROPPED = 2000 /* lies on the floor, beside where it was */
} needle_scene_moment;

/* Numbers of bodies, in the order in which they are added; handles end with the context. */
enum {
    NEEDLE_SCENE_NEEDLE = 1,
    NEEDLE_SCENE_THREAD = 2,
    NEEDLE_SCENE_FIRST = 3,
    NEEDLE_SCENE_SECOND = 4
};

vbss_result needle_scene_create(vbss_context *context, vbss_scene **scene);
vbss_result needle_scene_step(vbss_scene *scene);
/* Where the hand of a tool (0, 1) is at that step: its tip, m, w, x, y, z, and the opening of its handle. */
void needle_scene_hand(int tool, double step, double tip[3], double turn[4], double *opening);
/* Of its floor, gravity: along -z. How far the hands lift and carry, m. */
#define NEEDLE_SCENE_LIFT 0.02
#define NEEDLE_SCENE_CARRY 0.02

#endif
