/* Where a stitch is made: a floor, a drain on it, a needle that lies on the floor with a thread swaged to it. Lengthwise the
 * drain lies away from who stitches (y), its slit on top (z = 0), the marks at its right and left. */
#ifndef VBSS_EXAMPLES_NEEDLE_SITE_H
#define VBSS_EXAMPLES_NEEDLE_SITE_H

#include "needle/pose.h"

#define THREAD_LENGTH 0.15 /* m */

enum { SITE_LEFT = 0, SITE_RIGHT = 1 };

typedef struct site {
    throw_rig rig; /* scene, thread and log */
    vbss_needle *needle;
    vbss_drain *drain;
    uint32_t needle_body, drain_body;
    vbss_drain_places places;
    double radius, arc, wire; /* of the needle, m, rad, m */
    double tube, wall;        /* middle radius and thickness of the drain, m */
    double floor;             /* height, m */
} site;

/* Bits: what is made, and lies where it would, but is not in the scene. */
enum { SITE_NO_THREAD = 1, SITE_NO_DRAIN = 2, SITE_NO_NEEDLE = 4 };

/* Of the thread, in place of the defaults; 0: the default. */
typedef struct site_material {
    double bending_stiffness;                /* N m^2 */
    double friction;                         /* with itself */
    double yield_curvature, yield_hardening; /* 1/m; a fraction of the bending stiffness */
} site_material;

typedef struct site_plan {
    uint32_t segments;                 /* of the thread */
    const vbss_solver_options *solver; /* NULL: the defaults */
    uint32_t without;                  /* SITE_NO_ bits; who stitches needs it all */
    bool mirrored;                     /* who stitches is left-handed (throw/mirror.h) */
    site_material material;
} site_plan;

/* Needle's middle on the floor, and how far it is turned there; mirrored, if the plan says so, as all is that the hands look at. */
vbss_result site_create(site *s, vec place, double turn, const site_plan *plan);

pose site_needle(const site *s);
/* A place on the needle in its own frame, from the tip; outward from the centre there, and the way toward the tip. */
vec site_outward(const site *s, double arc_length);
vec site_forward(const site *s, double arc_length);
/* Of a mark: where it is; where it was, in the world; the wall's outer normal there at rest. */
vec site_mark(const site *s, int side);
vec site_mark_at_rest(const site *s, int side);
vec site_normal_at_rest(const site *s, int side);
/* As it is. */
vec site_normal(const site *s, int side);
/* The hole of that id, its position as the hands see it; false: there is none (any longer). */
bool site_find_hole(const site *s, uint32_t id, vbss_scene_hole *hole);
/* How far a hole is from a mark on the cylinder, m. */
double site_deviation(const site *s, const vbss_scene_hole *hole, int side);

#endif
