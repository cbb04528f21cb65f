/* Rigid bodies in the system: two blocks, the increment dx of the centre of mass and the increment
 * dtheta of the rotation, in the world frame: a point at the arm r from the centre of mass moves by
 * dx + dtheta x r. Knows no suture, no contact.
 *
 * A body is free (a needle) or a *proxy*: tied by a virtual coupling, a spring and a damper in
 * translation and in rotation, to a pose that somebody else moves (a tool).
 *
 * One part of a step, each arrow a function:
 *   retarget -> register -> predict -> (assemble -> solve -> advance) until good -> commit
 * Between assemble and solve others add what they know: to the diagonals and right-hand sides of both
 * blocks (force; torque about the centre of mass), and to the coupling of the two. */
#ifndef VBSS_SOLVER_RIGID_H
#define VBSS_SOLVER_RIGID_H

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "solver/solver.h"

typedef struct vbss_stream vbss_stream;

/* ---- the body */

/* The position of a motion is the centre of mass; its orientation takes the principal axes to the world. */
typedef struct vbss_rigid_motion {
    pose pose;
    vec3 v, w; /* of the centre of mass, m/s, and angular, rad/s; both in the world */
} vbss_rigid_motion;

/* Spring and damper between the body and the given pose; all zero: the body is free. The spring of the
 * rotation pulls the shortest way, which jumps to the other side at half a turn. */
typedef struct vbss_rigid_coupling {
    double stiffness, damping;                 /* N/m, N s/m */
    double turning_stiffness, turning_damping; /* N m/rad, N m s/rad */
} vbss_rigid_coupling;

typedef struct vbss_rigid {
    double mass;
    vec3 inertia; /* principal moments, kg m^2 */
    vec3 gravity; /* m/s^2 */
    double drag;  /* both momenta decay at this rate, 1/s; 0: none */
    vbss_rigid_coupling coupling;
    vbss_rigid_motion now;
    pose target_start,
        target_end; /* the given pose (of centre of mass and principal axes) at both ends of the step */
} vbss_rigid;

/* Whether the body is one that can be stepped: finite, mass and moments positive, no moment larger than
 * the sum of the others, nothing else negative, orientations unit. */
bool vbss_rigid_is_valid(const vbss_rigid *rigid);
/* The given pose that was the end of the last step is the begin of the next. */
void vbss_rigid_set_target(vbss_rigid *rigid, pose target);

/* The part of a step that is made at once; 0 and 1 for all of it. The given pose crosses the step evenly:
 * along a straight line, and about one axis the shortest way. Between two steps it shall not turn by half a
 * turn or more. */
typedef struct vbss_rigid_substep {
    double step_length;                  /* length of the whole step, s */
    double start_fraction, end_fraction; /* shares of it */
} vbss_rigid_substep;
/* The given pose at the end of the part and its velocities: the motion of a body that is driven, whose
 * blocks have the role VBSS_ROLE_PRESCRIBED. At the end of the step it is rigid->end to the bit. */
vbss_rigid_motion vbss_rigid_target_motion(const vbss_rigid *rigid,
                                           const vbss_rigid_substep *substep);

/* About the centre of mass, in the world. */
mat3 vbss_rigid_world_inertia(const vbss_rigid *rigid, quat orientation);
vec3 vbss_rigid_angular_momentum(const vbss_rigid *rigid, const vbss_rigid_motion *motion);

/* ---- the step */

typedef struct vbss_rigid_blocks {
    uint32_t first;    /* translation; rotation is first + 1 */
    uint32_t coupling; /* of the two: rows of the one eliminated later, see vbss_system_couple */
} vbss_rigid_blocks;
/* Registers two blocks of that role and couples them. */
vbss_result vbss_rigid_register(vbss_system *system, vbss_role role, vbss_rigid_blocks *blocks);

/* Free flight over the part: gravity and drag, no coupling, nothing met. Backward Euler for translation,
 * v = (v + h g) / (1 + h drag) and x + h v; so x = x_predicted + force / inertia as in integration.c, with
 * what gravity does already in the prediction. Rotation: the angular momentum stays to rounding (but for
 * drag); the orientation is of second order, and exact for a body two of whose moments are equal; energy
 * stays bounded. The prediction is where the trial starts. */
void vbss_rigid_predict(const vbss_rigid *rigid, const vbss_rigid_substep *substep,
                        vbss_rigid_motion *predicted);
/* Velocities that belong to a trial pose at the end of the part: the predicted ones, and the way and the
 * turn from the predicted pose over the length of the part. */
vbss_rigid_motion vbss_rigid_motion_from_pose(const vbss_rigid_substep *substep,
                                              const vbss_rigid_motion *predicted,
                                              const pose *trial);
/* Sets diagonals, right-hand sides and coupling of both blocks, for increments from the trial. Symmetric
 * and positive definite: inertia, at the predicted orientation, and of the virtual coupling stiffness and
 * damping over the length of the part. Derivatives that grow with the turn from the predicted to the trial
 * or the given pose are left out: one linearisation is exact where each turn is about one axis, else a few
 * balance to rounding. Under torque the whole is of first order. */
void vbss_rigid_assemble(const vbss_rigid *rigid, const vbss_rigid_substep *substep,
                         const vbss_rigid_motion *predicted, const pose *trial, vbss_system *system,
                         const vbss_rigid_blocks *blocks);
void vbss_rigid_apply_increment(pose *trial, vec3 dx, vec3 dtheta);
/* Makes the trial the state of the body: vbss_rigid_motion_from_pose, speeds below VBSS_FLUSH_THRESHOLD zero. */
void vbss_rigid_commit(vbss_rigid *rigid, const vbss_rigid_substep *substep,
                       const vbss_rigid_motion *predicted, const pose *trial);

/* What the given pose exerts on the body in that motion at the end of the part, through the virtual
 * coupling: after a commit with rigid->now, what acted in that part. A hand that holds the given pose
 * feels the opposite. */
typedef struct vbss_rigid_wrench {
    vec3 force;  /* N, at the centre of mass */
    vec3 torque; /* N m, about the centre of mass */
} vbss_rigid_wrench;
vbss_rigid_wrench vbss_rigid_coupling_wrench(const vbss_rigid *rigid,
                                             const vbss_rigid_substep *substep,
                                             const vbss_rigid_motion *motion);

/* Visits all of the body, mass and moments as what must be the same, with tags from the first on. */
enum { VBSS_RIGID_TAGS = 12 };
void vbss_rigid_serialise(vbss_stream *stream, uint16_t first_tag, vbss_rigid *rigid);

/* ---- mass of solid capsules (rigid_capsules.c) */

/* A cylinder with half balls on its ends; with equal ends a ball. */
typedef struct vbss_rigid_capsule {
    vec3 a, b;
    double radius, density; /* m, kg/m^3 */
} vbss_rigid_capsule;
typedef struct vbss_rigid_mass {
    double mass;
    vec3 inertia; /* principal moments */
    pose frame;   /* centre of mass and principal axes, in the frame the capsules are given in */
} vbss_rigid_mass;
/* Exact for each capsule; where capsules overlap, their mass counts twice. The principal axes are as near
 * to those of the capsules' frame as turning by at most an eighth at a time goes, and those to the bit where
 * no product of inertia is left; right-handed. A moment is good to rounding of the largest. The given pose of a
 * body whose capsules' frame stands at `tool` is pose_mul(tool, frame). False, with nothing written: no
 * positive mass and moments. */
bool vbss_rigid_mass_of_capsules(const vbss_rigid_capsule *capsules, uint32_t count,
                                 vbss_rigid_mass *mass);

#endif
