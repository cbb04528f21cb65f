/* Private interface of needles, for the files of lib/needle and the scene that moves them.
 *
 * config.c checks configurations; arc.c computes shape and mass; needle.c creates, destroys, moves
 * and queries needles; snapshot.c saves them. There are two frames: the needle's
 * (include/vblast_ss/needle.h), and that of its rigid body, which has its origin in the centre of
 * mass and the principal axes as axes. */
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
    vbss_rigid body;  /* in a scene, the state after the last step */
    pose body_frame;  /* frame of the rigid body in the needle's frame */
    vec3 swage;       /* end of the middle line, in the needle's frame, m */
    uint32_t body_id; /* its number in the scene; 0 outside a scene */
    uint64_t generation;
    vec3 view_points[NEEDLE_MAX_SEGMENTS + 1]; /* data of the public view */
} needle_object;

/* Needles (needle.c) */
extern const vbss_kind vbss_needle_kind;
/* The needle behind a handle, or VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_needle_open(const vbss_needle *handle, needle_object **needle);
/* Pose of the needle's frame. */
pose vbss_needle_pose(const needle_object *n);
/* Sets the motion that the scene computed, and its number in the scene; 0 when it leaves the
 * scene. */
void vbss_needle_set_motion(needle_object *n, const vbss_rigid_motion *motion, uint32_t body_id);

/* Fills `own` with the defaults and copies the caller's config over them (config.c).
 * VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE and the errors of vbss_config_read. */
vbss_result vbss_needle_read_config(vbss_context *context, const vbss_needle_config *config,
                                    vbss_needle_config *own);

/* The exact middle line in the needle's frame (arc.c): its length, the point at an arc length from
 * the tip, and the unit direction there toward the tip. Beyond its ends the line continues
 * straight. Lengths are in m. */
double vbss_needle_length(const needle_object *n);
vec3 vbss_needle_point(const needle_object *n, double arc_length);
vec3 vbss_needle_direction(const needle_object *n, double arc_length);
/* The same point and direction for a needle of which only the radius, m, and the angle of the arc,
 * rad, are known. */
vec3 vbss_needle_line_point(double radius, double arc, double arc_length);
vec3 vbss_needle_line_direction(double radius, double arc, double arc_length);
/* Arc length of the point of that line nearest to a point in the needle's frame. */
double vbss_needle_nearest_arc(const needle_object *n, vec3 point);
/* Arc length of end i of the capsules' axes, from the tip; i is 0 to segment_count. */
double vbss_needle_vertex_arc(const needle_object *n, uint32_t i);
/* Exact mass properties of a round wire with the arc as its middle line. */
vbss_rigid_mass vbss_needle_mass_properties(const vbss_needle_config *config);

/* Visits the configuration, without the initial motion (config_fields.c). */
void vbss_needle_visit_config(vbss_stream *stream, vbss_needle_config *config);

/* Visits the state; the configuration must equal the saved one (snapshot.c). */
void vbss_needle_serialise(vbss_stream *stream, void *object);

#endif
