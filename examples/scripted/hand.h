/* Shared by the examples that sew: hands that move by the clock, and hold a needle on its circle. */
#ifndef VBSS_EXAMPLES_SCRIPTED_HAND_H
#define VBSS_EXAMPLES_SCRIPTED_HAND_H

#include <vblast_ss/vblast_ss.h>

#include "base/linear.h"

#define SCRIPTED_DEGREE 0.017453292519943295 /* rad */
#define SCRIPTED_RADIUS 8e-3                 /* of the needle's arc, m */
#define SCRIPTED_ARC (200.0 * SCRIPTED_DEGREE)
#define SCRIPTED_OPENING 0.35 /* of jaws beside the needle, 0 to 1 */

/* A hand with its tool, whose jaws hold the needle across its arc. */
typedef struct scripted_hand {
    vbss_grasper *tool;
    uint32_t body;
    double side;  /* of the needle from which its shaft comes: 1 for +z, -1 for -z */
    double angle; /* of the jaws about the circle's axis, rad */
    double lean;  /* of the shaft from the circle's axis, away from the centre, rad */
    vec3 tip;     /* displacement from the needle, m */
    double back;  /* further displacement, along the shaft, m */
} scripted_hand;

/* Pose of the needle with its tip at an angle on a circle in a plane of constant z. Angles begin at +x. */
pose scripted_needle(vec3 centre, double turned);
/* Pose of the tool of a hand. */
pose scripted_tool(const scripted_hand *hand, vec3 centre);
/* Adds the tool of a hand; its angle, side and displacement are already set. `shaft`: radius of its shaft, m; 0: the default. */
vbss_result scripted_add_hand(vbss_context *context, vbss_scene *scene, scripted_hand *hand,
                              vec3 centre, double shaft);
/* Sets target and opening of its tool. */
vbss_result scripted_place_hand(scripted_hand *hand, vec3 centre, double opening);

#endif
