/* A needle with its thread that two tools of method PAPER pass through a drain, the same for tests, the determinism table and
 * pictures. What hands do is worked out from the number of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_PAPER_NEEDLE_SCENES_H
#define VBSS_TESTS_SCENES_PAPER_NEEDLE_SCENES_H

#include <vblast_ss/scene.h>

/* Steps of 1 ms: the first tool closes on the needle near its swage and turns it about the centre of its arc, square to the wall
 * into the right mark and out through the left side; the second closes on it near the tip, and waits; the first lets go; the
 * second turns it on until the swage has passed, carries it beside the drain and lets it drop on the floor. */
enum { PAPER_NEEDLE_SCENE_STEPS = 2000 };
typedef enum paper_needle_scene_moment {
    PAPER_NEEDLE_SCENE_TAKEN = 70,    /* by the first, still before the wall */
    PAPER_NEEDLE_SCENE_THROUGH = 470, /* both sides */
    PAPER_NEEDLE_SCENE_BOTH = 650,    /* have closed on it */
    PAPER_NEEDLE_SCENE_HANDED = 700,  /* the second has it */
    PAPER_NEEDLE_SCENE_PASSED = 1590,
    PAPER_NEEDLE_SCENE_DROPPED = 1990 /* and lies on the floor */
} paper_needle_scene_moment;

/* Numbers of bodies, in the order in which they are added; handles end with the context. */
enum {
    PAPER_NEEDLE_SCENE_DRAIN = 1,
    PAPER_NEEDLE_SCENE_NEEDLE = 2,
    PAPER_NEEDLE_SCENE_THREAD = 3,
    PAPER_NEEDLE_SCENE_FIRST = 4,
    PAPER_NEEDLE_SCENE_SECOND = 5
};
/* Height of the floor, whose normal is +y, m. */
#define PAPER_NEEDLE_SCENE_FLOOR (-0.015)

vbss_result paper_needle_scene_create(vbss_context *context, vbss_scene **scene);
vbss_result paper_needle_scene_step(vbss_scene *scene);

#endif
