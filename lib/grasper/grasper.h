/* The inside of a grasper, shared by the files of lib/grasper; a scene moves it and lets it hold.
 *
 * config.c checks what a grasper shall be; grasper.c makes and ends graspers and is told where they
 * shall go; trocar.c turns the shaft through its trocar; jaws.c says where the jaws are and how hard
 * they close; thread_clamp.c what a held thread does when it is pulled, needle_clamp.c a held needle; snapshot.c saves. Three frames: the world;
 * the tool's (origin the tip, z along the shaft); the jaws'
 * (origin the pivot, x the way they open, z against the way they point: a place between them has z < 0). */
#ifndef VBSS_GRASPER_GRASPER_H
#define VBSS_GRASPER_GRASPER_H

#include <vblast_ss/grasper.h>

#include "base/linear.h"
#include "base/slot.h"

/* Shaft, jaw at +x, jaw at -x, neck. */
enum { GRASPER_CAPSULES = 4, GRASPER_SHAFT = 0, GRASPER_JAW = 1, GRASPER_NECK = 3 };

/* How far beside the middle of the round jaws may lie what they hold or cut, as a share of their radius. */
#define GRASPER_MAX_OFFSET_RATIO 0.5

/* Of a needle driver or of shears. */
typedef struct grasper_jaws {
    double length, radius, bend, opening, neck; /* as the configuration says */
} grasper_jaws;

typedef struct grasper_capsule {
    vec3 axis[2]; /* in the tool's frame */
    double radius;
} grasper_capsule;

typedef struct grasper_object {
    vbss_context *context;
    vbss_grasper_config config;
    grasper_jaws driver, shears;
    uint64_t generation;

    /* the state: what it was told, what it is */
    vbss_grasper_kind kind, commanded_kind;
    pose commanded_pose; /* tool's frame; as the host said it, before the trocar */
    double opening;      /* of the handle */
    double jaw_angle;    /* of each jaw from the middle, at the end of the last step */
    double jaw_force;    /* N; with nothing held 0 */

    /* what its scene found in the last step, to be shown */
    uint32_t body_id, grasp_count, needle, drain, solenoid;
    pose tool_pose; /* tool's frame */
    vec3 velocity, angular_velocity, hand_force, hand_torque;
    double view_capsules[GRASPER_CAPSULES][7]; /* the view */
} grasper_object;

/* grasper.c */
extern const vbss_kind vbss_grasper_kind_of_slot;
vbss_result vbss_grasper_open(const vbss_grasper *handle, grasper_object **grasper);
/* Its scene lets it go: nothing moves it or acts on it, and it is where it shall be. */
void vbss_grasper_detach(grasper_object *g);
/* config.c. The caller's over the defaults, every number checked. */
vbss_result vbss_grasper_read_config(vbss_context *context, const vbss_grasper_config *config,
                                     vbss_grasper_config *own);
/* snapshot.c. Visits the state and what is shown, the configuration as what must be the same. */
void vbss_grasper_serialise(vbss_stream *stream, void *object);

/* trocar.c: where the tool's frame shall be; false: the trocar is too near to the tip for bent jaws. */
bool vbss_grasper_apply_trocar(const grasper_object *g, pose commanded, pose *target);

/* jaws.c. The jaws that it has as the kind it is. */
const grasper_jaws *vbss_grasper_current_jaws(const grasper_object *g);
/* The jaws' frame in the tool's. */
pose vbss_grasper_jaw_frame(const grasper_object *g);
/* Where the shaft's axis begins, in the tool's frame. */
vec3 vbss_grasper_bend_point(const grasper_object *g);
/* Capsules in the tool's frame with the jaws at that angle. Closed jaws (0) touch along their length. */
void vbss_grasper_compute_capsules(const grasper_object *g, double angle,
                                   grasper_capsule capsules[GRASPER_CAPSULES]);
/* Where the handle would have the jaws, below 0 by up to closing_angle when it is squeezed. */
double vbss_grasper_commanded_angle(const grasper_object *g);
/* The angle after h seconds: toward the told one, as fast as they go, not below `least`. */
double vbss_grasper_next_angle(const grasper_object *g, double h, double min_angle);
/* Of the jaws on what holds them at an angle, N. */
double vbss_grasper_jaw_force_at(const grasper_object *g, double angle);
/* The angle at which jaws touch a round thread at that distance from the pivot from both sides. */
double vbss_grasper_touching_angle(double thread_diameter, double from_pivot);
/* Distance between the facing surfaces of the jaws there. */
double vbss_grasper_jaw_distance(double angle, double from_pivot);
/* The place between the jaws of what goes straight from begin to end, in the jaws' frame, that is nearest to their middle;
 * false: it is not between them. */
typedef struct grasper_jaw_point {
    double fraction;   /* of the way from begin to end */
    double offset;     /* from the middle of the jaws, m */
    double from_pivot; /* m */
} grasper_jaw_point;
bool vbss_grasper_find_between(const grasper_object *g, vec3 start, vec3 end,
                               grasper_jaw_point *point);
/* For the view: capsules in the world as the tool lies now. */
void vbss_grasper_update_view(grasper_object *g);

/* ---- thread_clamp.c: a clamp that holds three points of a thread, half its length apart */

enum { GRASPER_THREAD_POINTS = 3 };
/* Faces do not give way as what they rub does: the clamp is so much stiffer across them. A power of two. */
#define GRASPER_NORMAL_STIFFNESS_RATIO 64.0
typedef struct grasper_thread_clamp {
    vec3 anchor[GRASPER_THREAD_POINTS]; /* where they are held, in the jaws' frame */
    double age; /* s since it was taken: the points come to the middle of the jaws in time */
} grasper_thread_clamp;
typedef struct grasper_thread_load {
    vec3 force[GRASPER_THREAD_POINTS]; /* of the clamp on the thread, in the jaws' frame, N */
    vec3 thread_direction;             /* unit: the way of the thread toward larger arc length */
    double arc_offset
        [GRASPER_THREAD_POINTS]; /* of the middle so much arc length, m: less where the thread ends */
    double jaw_force;            /* of the jaws on this place, N */
    double h;                    /* length of the step, s */
    bool is_stacked;             /* others lie between it and the middle of the jaws */
} grasper_thread_load;
typedef struct grasper_thread_slip {
    double slip;      /* the held place goes on by so much arc length, m */
    bool has_escaped; /* it has come out between the jaws or over their end */
} grasper_thread_slip;
/* What the jaws bear along their faces with that pressure, N. */
double vbss_grasper_friction_limit(const grasper_object *g, double jaw_force);
/* After a step: what exceeds the limits slides until it does not, and the rest settles into the jaws. */
grasper_thread_slip vbss_grasper_yield_thread(const grasper_object *g, grasper_thread_clamp *clamp,
                                              const grasper_thread_load *load);

/* ---- needle_clamp.c: a clamp that holds a needle, in position and orientation, by three springs at the corners of a triangle in
 * the plane of the faces */

enum { GRASPER_NEEDLE_POINTS = 3 };
typedef struct grasper_needle_load {
    vec3 force,
        torque; /* of the clamp on the needle, about the middle of what is held, in the jaws' frame */
    double jaw_force; /* of the jaws on it, N */
    double h;         /* length of the step, s */
} grasper_needle_load;
/* Where a corner is, in the jaws' frame, round what is held there; stiffness of each spring, N/m. */
vec3 vbss_grasper_needle_clamp_point(const grasper_object *g, vec3 middle, uint32_t i);
double vbss_grasper_needle_clamp_stiffness(const grasper_object *g);
typedef struct grasper_needle_slip {
    double slip, rotation; /* m, rad */
    bool has_escaped;      /* it has come out between the jaws or over their end */
} grasper_needle_slip;
/* After a step: what exceeds the limits makes the place where it is held give way until it does not, and for the rest it
 * comes to the middle of the jaws in time. `at` is where it is held, `age` since when. */
grasper_needle_slip vbss_grasper_yield_needle(const grasper_object *g, pose *at, double *age,
                                              const grasper_needle_load *load);

#endif
