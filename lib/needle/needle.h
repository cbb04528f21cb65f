/* The inside of a needle, shared by the files of lib/needle; a scene moves it.
 *
 * config.c checks what a needle shall be; arc.c knows its shape and what it weighs; needle.c makes, ends, moves and
 * shows needles; snapshot.c saves. Two frames: the needle's (needle.h of include/), and that of its rigid body: centre of
 * mass and principal axes. */
#ifndef VBSS_NEEDLE_NEEDLE_H
#define VBSS_NEEDLE_NEEDLE_H

#include <vblast_ss/needle.h>

#include "base/linear.h"
#include "base/slot.h"
#include "solver/rigid.h"

enum { NEEDLE_MAX_SEGMENTS = 64 };

typedef struct needle_object {
    vbss_context *context;
    vbss_needle_config config;
    vbss_rigid body;  /* while a scene has it, as it was after the last step */
    pose body_frame;  /* of centre of mass and principal axes, in the needle's frame */
    vec3 swage;       /* of its middle line, where it is swaged, in the needle's frame */
    uint32_t body_id; /* in its scene; 0: it is in none */
    uint64_t generation;
    vec3 view_points[NEEDLE_MAX_SEGMENTS + 1]; /* the view */
} needle_object;

/* needle.c */
extern const vbss_kind vbss_needle_kind;
vbss_result vbss_needle_open(const vbss_needle *handle, needle_object **needle);
/* Where its frame is. */
pose vbss_needle_pose(const needle_object *n);
/* Its scene has moved it, as that number; it has left the scene: 0. */
void vbss_needle_set_motion(needle_object *n, const vbss_rigid_motion *motion, uint32_t body_id);

/* config.c. The caller's over the defaults, every number checked. */
vbss_result vbss_needle_read_config(vbss_context *context, const vbss_needle_config *config,
                                    vbss_needle_config *own);

/* arc.c. Of the exact middle line, in the needle's frame: where it is at that arc length from the tip, straight beyond its
 * ends; the unit way toward the tip. */
double vbss_needle_length(const needle_object *n);
vec3 vbss_needle_point(const needle_object *n, double arc_length);
vec3 vbss_needle_direction(const needle_object *n, double arc_length);
/* The arc length of the place on that line that is nearest to a point, in the needle's frame. */
double vbss_needle_nearest_arc(const needle_object *n, vec3 point);
/* Ends of the capsules' axes, tip first: segment_count + 1. */
double vbss_needle_vertex_arc(const needle_object *n, uint32_t i); /* its arc length */
/* Exact, of a round wire whose middle line is the arc. */
vbss_rigid_mass vbss_needle_mass_properties(const vbss_needle_config *config);

/* snapshot.c. Visits the state, the configuration as what must be the same. */
void vbss_needle_serialise(vbss_stream *stream, void *object);

#endif
