/* What of a suture and of the wall round its holes does not touch: one answer for contact and guard. */
#ifndef VBSS_SCENE_HOLE_EXCLUSION_H
#define VBSS_SCENE_HOLE_EXCLUSION_H

#include "scene/scene.h"

/* A place of a wall, and at which share of the distance of touching a place of a thread, or of a capsule, touches it: 0 at a
 * hole that it is in, or in jaws that hold the wall. `point`: a node, or the end of a capsule; else a share of a segment.
 * `reach`: within which of a hole nothing touches. */
typedef struct scene_wall_point {
    vec3 now, rest;
    double time; /* of the part: 0, its begin */
} scene_wall_point;
scene_wall_point vbss_scene_wall_point(const scene_body *drain, uint32_t triangle,
                                       const double weights[3]);
scene_wall_point vbss_scene_wall_point_on_edge(const scene_body *drain, const uint32_t node[2],
                                               double fraction);
scene_wall_point vbss_scene_wall_point_at_time(const scene_body *drain, uint32_t triangle,
                                               const double weights[3], double time);
scene_wall_point vbss_scene_wall_point_on_edge_at_time(const scene_body *drain,
                                                       const uint32_t node[2], double fraction,
                                                       double time);
double vbss_scene_contact_scale_at(const scene_object *s, const scene_body *body, bool is_point,
                                   uint32_t feature, double fraction, const scene_body *drain,
                                   const scene_wall_point *wall_point, double reach);
double vbss_scene_contact_scale_of(const scene_object *s, const contact_constraint *constraint);
/* The axis of a needle's capsule is cut at its holes in a drain, and so is a side of that by the planes across the axis there:
 * what is left of a needle beside a hole has no end that might push the wall along. The next two pieces, farther than `reach`
 * from all holes. False: there are none. */
typedef struct scene_axis_interval {
    bool started;        /* false, and the first one is found */
    double end_arc;      /* where it ends, m from the tip */
    double bounds[2][2]; /* from and to which share of the capsule's axis, of the side */
} scene_axis_interval;
bool vbss_scene_next_axis_interval(const scene_object *s, const scene_body *needle,
                                   uint32_t capsule, const scene_body *drain, uint32_t edge,
                                   double reach, scene_axis_interval *interval);
static inline void scene_clip_axis(vec3 axis[2], const double interval[2])
{
    vec3 start = axis[0];
    axis[0] = vec3_lerp(start, axis[1], interval[0]);
    axis[1] = vec3_lerp(start, axis[1], interval[1]);
}
bool vbss_scene_is_suture(const scene_body *b);
/* The arc length of a place on a segment of a thread or a capsule of a needle; whether that is its tip. */
double vbss_scene_suture_arc_length(const scene_body *suture, uint32_t segment, double fraction);
bool vbss_scene_is_at_tip(const scene_body *needle, double arc);

#endif
