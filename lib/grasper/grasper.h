/* Private interface of graspers, for the files of lib/grasper and the scene that moves them.
 *
 * config.c checks configurations; grasper.c creates and destroys graspers and takes the host's
 * commands; trocar.c turns the shaft through its trocar; jaws.c computes the position of the jaws
 * and their force; thread_clamp.c and needle_clamp.c let a held thread or needle slip; snapshot.c
 * saves graspers.
 *
 * There are three frames: the world; the tool's (origin at the tip, z along the shaft toward the
 * handle); and the jaws' (origin at the pivot, x across the faces, z away from the tips: points
 * between the jaws have z < 0). */
#ifndef VBSS_GRASPER_GRASPER_H
#define VBSS_GRASPER_GRASPER_H

#include <vblast_ss/grasper.h>

#include "base/linear.h"
#include "base/slot.h"
#include "grasper/tuning.h"

/* Capsules of a grasper: shaft, the jaws at +x and -x, neck. */
enum { GRASPER_CAPSULES = 4, GRASPER_SHAFT = 0, GRASPER_JAW = 1, GRASPER_NECK = 3 };

/* The jaws of a needle driver, or the blades of shears. */
typedef struct grasper_jaws {
    /* from the configuration; lengths in m, bend and opening in rad */
    double length, radius, bend, opening, neck;
} grasper_jaws;

typedef struct grasper_capsule {
    vec3 axis[2]; /* end points of the axis in the tool's frame, m */
    double radius;
} grasper_capsule;

typedef struct grasper_object {
    vbss_context *context;
    vbss_grasper_config config;
    vbss_baseline_config baseline_config; /* what config.baseline points to */
    grasper_jaws driver, shears;
    uint64_t generation;

    /* the state: commands of the host, and their execution */
    vbss_grasper_kind kind, commanded_kind;
    pose commanded_pose; /* pose of the tool's frame that the host asked for, before the trocar */
    double opening;      /* commanded opening of the handle, 0 to 1 */
    double jaw_angle;    /* angle of each jaw from the middle at the end of the last step, rad */
    double jaw_force;    /* N; 0 if nothing is held */

    bool
        has_jumped; /* a command was unlikely far away, and a warning given; not part of the state */

    /* results of the last step in the scene, for queries */
    uint32_t body_id, grasp_count, needle, drain, solenoid;
    pose tool_pose; /* pose of the tool's frame */
    vec3 velocity, angular_velocity, hand_force, hand_torque;
    double view_capsules[GRASPER_CAPSULES][7]; /* data of the public view */
} grasper_object;

/* Graspers (grasper.c) */
extern const vbss_kind vbss_grasper_kind_of_slot;
/* The grasper behind a handle, or VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_grasper_open(const vbss_grasper *handle, grasper_object **grasper);
/* Called when the grasper leaves its scene: it holds nothing, feels no force, and moves to its
 * target pose. */
void vbss_grasper_detach(grasper_object *g);
/* Fills `own` with the defaults and copies the caller's config over them (config.c).
 * VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE and the errors of vbss_config_read. */
vbss_result vbss_grasper_read_config(vbss_context *context, const vbss_grasper_config *config,
                                     vbss_grasper_config *own, vbss_baseline_config *baseline);
/* Visits the configuration and its parameters of the baseline (config_fields.c). */
void vbss_grasper_visit_config(vbss_stream *stream, vbss_grasper_config *config,
                               vbss_baseline_config *baseline);
/* Visits state and query results; the configuration must equal the saved one (snapshot.c). */
void vbss_grasper_serialise(vbss_stream *stream, void *object);

/* Turns a commanded pose so that the shaft passes through the trocar (trocar.c). Returns false if
 * the trocar is too close to the tip for bent jaws. */
bool vbss_grasper_apply_trocar(const grasper_object *g, pose commanded, pose *target);

/* Jaws of the present kind (jaws.c, as all functions up to vbss_grasper_update_view). */
const grasper_jaws *vbss_grasper_current_jaws(const grasper_object *g);
/* Frame of the jaws in the tool's frame. */
pose vbss_grasper_jaw_frame(const grasper_object *g);
/* Start of the shaft's axis in the tool's frame, m. */
vec3 vbss_grasper_bend_point(const grasper_object *g);
/* Capsules in the tool's frame for a jaw angle, rad. Closed jaws (0) touch along their length. */
void vbss_grasper_compute_capsules(const grasper_object *g, double angle,
                                   grasper_capsule capsules[GRASPER_CAPSULES]);
/* Jaw angle that the handle commands, rad. A squeezed handle gives negative angles down to
 * -closing_angle. */
double vbss_grasper_commanded_angle(const grasper_object *g);
/* Jaw angle after h seconds: it approaches the commanded angle at jaw_speed at most, but not below
 * min_angle or 0. */
double vbss_grasper_next_angle(const grasper_object *g, double h, double min_angle);
/* Force of the jaws on an object that holds them open at this angle, N. */
double vbss_grasper_jaw_force_at(const grasper_object *g, double angle);
/* Angle at which both jaws touch a round thread at this distance from the pivot, rad; lengths in
 * m. */
double vbss_grasper_touching_angle(double thread_diameter, double from_pivot);
/* Distance between the faces of the jaws at this angle and distance from the pivot, m. */
double vbss_grasper_jaw_distance(double angle, double from_pivot);
/* The point of a line segment between the jaws, in their frame, that is closest to their middle
 * plane. */
typedef struct grasper_jaw_point {
    double fraction;   /* position on the segment, 0 at its start */
    double offset;     /* from the middle plane of the jaws, m */
    double from_pivot; /* distance from the pivot, m */
} grasper_jaw_point;
/* Finds that point. Returns false if the segment does not pass between the jaws. `overhang`: length
 * beyond the tip that still counts as between them, m. */
bool vbss_grasper_find_between(const grasper_object *g, vec3 start, vec3 end, double overhang,
                               grasper_jaw_point *point);
/* Updates the data of the view: capsules in the world frame at the present pose. */
void vbss_grasper_update_view(grasper_object *g);

/* ---- thread_clamp.c: a clamp that holds a thread at three points, half a clamp length apart */

enum { GRASPER_THREAD_POINTS = 3 };
typedef struct grasper_thread_clamp {
    vec3 anchor[GRASPER_THREAD_POINTS]; /* the three points in the jaws' frame, m */
    /* time since the grasp, s; in the first moments the points move to the middle of the jaws */
    double age;
} grasper_thread_clamp;
typedef struct grasper_thread_load {
    vec3 force[GRASPER_THREAD_POINTS]; /* force of the clamp on the thread, in the jaws' frame, N */
    vec3 thread_direction;             /* unit direction of the thread toward larger arc length */
    /* arc length of each point from the middle one, m; shorter at an end of the thread */
    double arc_offset[GRASPER_THREAD_POINTS];
    double jaw_force; /* force of the jaws on this thread, N */
    double h;         /* length of the step, s */
    bool is_stacked;  /* other threads lie between this one and the middle of the jaws */
} grasper_thread_load;
typedef struct grasper_thread_slip {
    double slip;      /* change of the held arc length, m */
    bool has_escaped; /* the thread has left the jaws, between them or over their ends */
} grasper_thread_slip;
/* Largest friction of both faces at this jaw force, N. */
double vbss_grasper_friction_limit(const grasper_object *g, double jaw_force);
/* Post-step update of a clamp. Forces beyond their limits make the thread slip until they equal the
 * limit; a new grasp also moves toward the middle of the jaws. */
grasper_thread_slip vbss_grasper_yield_thread(const grasper_object *g, grasper_thread_clamp *clamp,
                                              const grasper_thread_load *load);

/* ---- needle_clamp.c: a clamp that holds position and orientation of a needle by three springs at
 * the corners of a triangle in the plane of the faces */

enum { GRASPER_NEEDLE_POINTS = 3 };
typedef struct grasper_needle_load {
    /* load of the clamp on the needle about the middle of the grasp, in the jaws' frame, N, N m */
    vec3 force, torque;
    double jaw_force; /* force of the jaws on the needle, N */
    double h;         /* length of the step, s */
} grasper_needle_load;
/* Corner i of the triangle, in the jaws' frame about the middle of the grasp, m; and the stiffness
 * of each spring, N/m. */
vec3 vbss_grasper_needle_clamp_point(const grasper_object *g, vec3 middle, uint32_t i);
double vbss_grasper_needle_clamp_stiffness(const grasper_object *g);
typedef struct grasper_needle_slip {
    double slip, rotation; /* translation of the needle in the jaws, m, and its rotation, rad */
    bool has_escaped;      /* the needle has left the jaws, between them or over their ends */
} grasper_needle_slip;
/* Post-step update of a clamp. A force or torque beyond its limit moves or rotates the grasp until
 * it equals the limit; a new grasp also moves toward the middle of the jaws. `at` is the pose of
 * the grasp in the jaws' frame, `age` the time since it started, s. */
grasper_needle_slip vbss_grasper_yield_needle(const grasper_object *g, pose *at, double *age,
                                              const grasper_needle_load *load);

#endif
