/* Counts where threads and needles cross a surface away from the holes that they have in it. */
#ifndef VBSS_EXAMPLES_SCRIPTED_CROSSING_H
#define VBSS_EXAMPLES_SCRIPTED_CROSSING_H

#include <vblast_ss/vblast_ss.h>

#include "base/linear.h"

enum { SCRIPTED_HOLES = 16 };

typedef struct scripted_surface {
    const vec3 *vertices;
    const uint32_t (*triangles)[3];
    uint32_t triangle_count, hole_count;
    vec3 holes[SCRIPTED_HOLES];
    double near_hole; /* m: no crossing is counted there */
} scripted_surface;

/* Reads the positions of the holes of a scene. */
void scripted_find_holes(vbss_scene *scene, scripted_surface *surface);
/* Crossings of a chain of points with the triangles, farther than near_hole from each hole. */
uint32_t scripted_count_crossings(const scripted_surface *surface, const vbss_view *chain);

#endif
