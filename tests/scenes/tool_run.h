/* Two graspers and a thread with all that tools do, one after the other: both close on it, pull until it slides
 * through the weaker, which lets go, is exchanged for shears and cuts what the other holds. What the
 * determinism table steps. */
#ifndef VBSS_TESTS_SCENES_TOOL_RUN_H
#define VBSS_TESTS_SCENES_TOOL_RUN_H

#include <vblast_ss/grasper.h>
#include <vblast_ss/scene.h>

/* Until the cut ends have come to hang. */
enum { TOOL_RUN_STEPS = 300 };

typedef struct tool_run {
    vbss_scene *scene;
    vbss_grasper *tools[2];
    uint32_t thread;
} tool_run;
vbss_result tool_run_create(vbss_context *context, vbss_method method, tool_run *run);
/* The next step, by the scene's own count of them: so a restored scene goes on where it was. */
vbss_result tool_run_step(tool_run *run);

#endif
