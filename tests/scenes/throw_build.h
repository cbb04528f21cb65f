/* How a throw scene begins, and where its tools stand. For throw_scenes.c. */
#ifndef VBSS_TESTS_SCENES_THROW_BUILD_H
#define VBSS_TESTS_SCENES_THROW_BUILD_H

#include "scenes/throw_scenes.h"

/* m. Tools: their frame has the tip at 0 and z to the handle; hands hold the grasp, so far behind the tip. */
#define THROW_GRASP 2e-3
/* Of the thread beside the drain. */
#define THROW_TAIL 30e-3
/* Nodes on either side of the one that is grasped. */
enum { THROW_WELDED = 1 };

/* Thread, drain, both tools; C holds the limb. */
vbss_result throw_build(vbss_context *context, throw_scene *scene);

/* W's axis, from tip to handle, when its grasp is there; the direction from it to C at an angle. */
vec3 throw_axis_of_w(vec3 grasp);
vec3 throw_from_w(const throw_scene *scene, double phi);
/* How the tools are turned, and where a tool's frame is. */
quat throw_stand_of_w(const throw_scene *scene);
quat throw_stand_of_c(const throw_scene *scene);
vec3 throw_frame_of(vec3 grasp, quat stand);
/* A tool closes its jaws on the thread. */
vbss_result throw_take(throw_scene *scene, const throw_tool *tool, uint32_t node);

#endif
