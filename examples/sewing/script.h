/* The script of the hands, by the clock. */
#ifndef VBSS_EXAMPLES_SEWING_SCRIPT_H
#define VBSS_EXAMPLES_SEWING_SCRIPT_H

#include "sewing.h"

#define SCRIPT_DEGREE 0.017453292519943295 /* rad */
#define SCRIPT_RADIUS 8e-3                 /* of the needle's arc, m */
#define SCRIPT_ARC (200.0 * SCRIPT_DEGREE)
#define SCRIPT_OPENING 0.35 /* of jaws beside the needle, 0 to 1 */

/* Pose of the needle with its tip at an angle on the circle. */
pose script_needle(double turned);
/* Pose of a tool whose jaws hold the needle at their angle; `away`: from there, m. */
pose script_tool(const sewing_hand *hand, vec3 away);
/* Where hands and needle begin. */
void script_begin(sewing *s);

#endif
