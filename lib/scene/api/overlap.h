/* Overlaps of bodies where they are: when a body is added, and when a host asks. */
#ifndef VBSS_SCENE_OVERLAP_H
#define VBSS_SCENE_OVERLAP_H

#include "collision/shapes.h"
#include "scene/world/world.h"

/* The triangles of a drain or static mesh. */
typedef struct scene_surface {
    const vec3 *vertices; /* m */
    const uint32_t (*triangles)[3];
    uint32_t triangle_count; /* 0: the body is no surface */
    double radius;           /* half the thickness, m */
    bool is_posed;           /* the vertices are in the frame `at` of the outline */
} scene_surface;

typedef struct scene_triangle {
    vec3 corners[3]; /* m */
    double radius;   /* m */
} scene_triangle;

/* A body as line segments, each with a radius, and a surface as triangles too. Exactly one of the
 * first seven members is set. */
typedef struct scene_outline {
    const scene_plane *plane; /* it has no segments */
    const thread_object *thread;
    scene_surface surface;
    const needle_object *needle;             /* not yet in the scene */
    const grasper_object *grasper;           /* the same */
    const vbss_scene_rigid_config *capsules; /* the same */
    const scene_rigid *rigid;                /* in the scene: needles and graspers too */
    pose at;            /* frame of `grasper`, `capsules` or a posed surface in the world */
    uint32_t number;    /* body number; 0 before it is added */
    bool is_prescribed; /* moved by the host alone: see world/driven_overlaps.c for two of them */
    bool ignores_holes; /* a surface: parts of sutures at its holes do not overlap it */
} scene_outline;

typedef struct scene_segment {
    vec3 ends[2];  /* m */
    double radius; /* m */
} scene_segment;

/* ---- outline.c */

scene_outline vbss_scene_outline_of(const scene_object *s, const scene_body *b);
scene_surface vbss_scene_surface_of_drain(const drain_object *d);
scene_triangle vbss_scene_outline_triangle(const scene_outline *o, uint32_t index);
uint32_t vbss_scene_outline_segments(const scene_outline *o);
scene_segment vbss_scene_outline_segment(const scene_object *s, const scene_outline *o,
                                         uint32_t index);
/* Smallest box around a segment with its radius, and around all segments of a body, m. */
collision_aabb vbss_scene_segment_box(const scene_segment *g);
collision_aabb vbss_scene_outline_box(const scene_object *s, const scene_outline *o);

/* ---- overlap.c */

/* Warns, or fails with VBSS_ERROR_OUT_OF_RANGE, if a body that is about to be added overlaps another
 * one or the floor, as the configuration says. `name` is its kind in the message. */
vbss_result vbss_scene_check_overlap(const scene_object *s, const scene_outline *added,
                                     const char *name);

#endif
