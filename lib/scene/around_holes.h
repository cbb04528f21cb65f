/* What of a suture and of the wall round its holes does not touch: one answer for contact and guard. */
#ifndef VBSS_SCENE_AROUND_HOLES_H
#define VBSS_SCENE_AROUND_HOLES_H

#include "scene/scene.h"

/* A place of a wall, and at which share of the distance of touching a place of a thread, or of a capsule, touches it: 0 at a
 * hole that it is in, or in jaws that hold the wall. `point`: a node, or the end of a capsule; else a share of a segment.
 * `reach`: within which of a hole nothing touches. */
typedef struct scene_spot {
    vec3 now, rest;
    double time; /* of the part: 0, its begin */
} scene_spot;
scene_spot vbss_scene_spot(const scene_body *drain, uint32_t triangle, const double weights[3]);
scene_spot vbss_scene_spot_on_side(const scene_body *drain, const uint32_t node[2], double share);
scene_spot vbss_scene_spot_then(const scene_body *drain, uint32_t triangle, const double weights[3],
                                double time);
scene_spot vbss_scene_spot_on_side_then(const scene_body *drain, const uint32_t node[2],
                                        double share, double time);
double vbss_scene_share_touching(const scene_object *s, const scene_body *body, bool point,
                                 uint32_t feature, double share, const scene_body *drain,
                                 const scene_spot *spot, double reach);
double vbss_scene_share_of_row(const scene_object *s, const contact_constraint *row);
/* The axis of a needle's capsule is cut at its holes in a drain, and so is a side of that by the planes across the axis there:
 * what is left of a needle beside a hole has no end that might push the wall along. The next two pieces, farther than `reach`
 * from all holes. False: there are none. */
typedef struct scene_piece {
    bool begun;      /* false, and the first one is found */
    double arc;      /* where it ends, m from the tip */
    double at[2][2]; /* from and to which share of the capsule's axis, of the side */
} scene_piece;
bool vbss_scene_next_piece(const scene_object *s, const scene_body *needle, uint32_t capsule,
                           const scene_body *drain, uint32_t side, double reach,
                           scene_piece *piece);
static inline void scene_cut_axis(vec3 axis[2], const double piece[2])
{
    vec3 begin = axis[0];
    axis[0] = vec3_lerp(begin, axis[1], piece[0]);
    axis[1] = vec3_lerp(begin, axis[1], piece[1]);
}
bool vbss_scene_is_suture(const scene_body *b);
/* The arc length of a place on a segment of a thread or a capsule of a needle; whether that is its tip. */
double vbss_scene_arc_of(const scene_body *suture, uint32_t segment, double share);
bool vbss_scene_is_at_tip(const scene_body *needle, double arc);

#endif
