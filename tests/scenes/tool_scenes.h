/* Graspers at work, the same for tests, bench and the determinism table. What hands do is worked out from the
 * number of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_TOOL_SCENES_H
#define VBSS_TESTS_SCENES_TOOL_SCENES_H

#include <vblast_ss/record.h>
#include <vblast_ss/scene.h>

/* A round of a second: a thread that hangs from a pin is taken by the first tool, drawn aside, taken by the
 * second as well, pulled between both until it slides through the weaker, let go by one, which
 * is exchanged for shears and back. */
enum { TOOL_SCENE_ROUND = 1000 };
typedef enum tool_scene_moment {
    TOOL_SCENE_CLOSING = 70,  /* the jaws move, and touch nothing yet */
    TOOL_SCENE_TAKEN = 110,   /* by one, which settles */
    TOOL_SCENE_DRAWN = 300,   /* held by one and drawn */
    TOOL_SCENE_SLIDING = 560, /* held by two, slides through one */
    TOOL_SCENE_LET_GO = 707   /* but not clear of the jaws */
} tool_scene_moment;

/* Its thread is body 1, its tools are 2 and 3; they end with the context. */
vbss_result tool_scene_create(vbss_context *context, vbss_method method, vbss_scene **scene);
/* What hands do before the next step: through the record, or past it if NULL. */
vbss_result tool_scene_drive(vbss_scene *scene, vbss_record *record);
/* And the step, of 1 ms. */
vbss_result tool_scene_step(vbss_scene *scene);

#endif
