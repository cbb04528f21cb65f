/* Rigid bodies in the linear system.
 *
 * A body has two blocks of unknowns: the increment dx of its centre of mass and the increment
 * dtheta of its rotation, in the world frame. A point at arm r from the centre of mass moves by dx
 * + dtheta x r. This file knows nothing of sutures or contacts.
 *
 * A body is free (a needle) or a *proxy*: a virtual coupling, a spring and damper in translation
 * and rotation, ties it to a target pose that a tool sets.
 *
 * The calls of one substep, in order:
 *   vbss_rigid_set_target (once a step) -> vbss_rigid_register -> vbss_rigid_predict
 *   -> (vbss_rigid_assemble -> solve -> vbss_rigid_apply_increment) until converged
 *   -> vbss_rigid_commit
 * Between assemble and solve, other modules may add to the diagonals and right-hand sides of both
 * blocks (force; torque about the centre of mass) and to the coupling of the two. */
#ifndef VBSS_SOLVER_RIGID_H
#define VBSS_SOLVER_RIGID_H

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "solver/solver.h"

typedef struct vbss_stream vbss_stream;

/* ---- the body */

/* Position is the centre of mass; the orientation takes the principal axes to the world. */
typedef struct vbss_rigid_motion {
    pose pose;
    /* velocity of the centre of mass, m/s, and angular velocity, rad/s; both in the world frame */
    vec3 v, w;
} vbss_rigid_motion;

/* Virtual coupling: spring and damper between the body and its target pose. All zero for a free
 * body. The rotational spring acts along the shortest rotation, which flips to the other side at
 * half a turn. */
typedef struct vbss_rigid_coupling {
    double stiffness, damping;                 /* N/m, N s/m */
    double turning_stiffness, turning_damping; /* N m/rad, N m s/rad */
} vbss_rigid_coupling;

/* A force and a torque on a body. */
typedef struct vbss_rigid_wrench {
    vec3 force;  /* N, at the centre of mass */
    vec3 torque; /* N m, about the centre of mass */
} vbss_rigid_wrench;

typedef struct vbss_rigid {
    double mass;
    vec3 inertia; /* principal moments, kg m^2 */
    vec3 gravity; /* m/s^2 */
    double drag;  /* decay rate of both momenta, 1/s; 0 for none */
    vbss_rigid_coupling coupling;
    /* By the host, constant in the step. vbss_rigid_serialise leaves it to the owner of the
     * body. */
    vbss_rigid_wrench load;
    vbss_rigid_motion now;
    /* target pose of centre of mass and principal axes at both ends of the step */
    pose target_start, target_end;
} vbss_rigid;

/* Whether the body can be stepped. All values must be finite, mass and moments positive, and no
 * moment larger than the sum of the other two. Drag and coupling must not be negative, and
 * orientations must have unit length. */
bool vbss_rigid_is_valid(const vbss_rigid *rigid);
/* Sets the target pose at the end of the next step. The target at the end of the last step becomes
 * that at its start. */
void vbss_rigid_set_target(vbss_rigid *rigid, pose target);

/* A substep: the part of a time step that is integrated and accepted at once, from 0 to 1 for the
 * whole step. The target moves through the step at constant velocity: along a straight line, and
 * about one axis by the shortest rotation. It must rotate by less than half a turn per step. */
typedef struct vbss_rigid_substep {
    double step_length;                  /* length of the whole step, s */
    double start_fraction, end_fraction; /* fractions of it, from 0 to 1 */
} vbss_rigid_substep;
/* Target pose at the end of the substep and its velocities. This is the motion of a kinematic body,
 * whose blocks have the role VBSS_ROLE_PRESCRIBED. At the end of the step the pose equals
 * rigid->target_end to the bit. */
vbss_rigid_motion vbss_rigid_target_motion(const vbss_rigid *rigid,
                                           const vbss_rigid_substep *substep);

/* Inertia and angular momentum about the centre of mass, in the world frame, kg m^2 and kg
 * m^2/s. */
mat3 vbss_rigid_world_inertia(const vbss_rigid *rigid, quat orientation);
vec3 vbss_rigid_angular_momentum(const vbss_rigid *rigid, const vbss_rigid_motion *motion);

/* ---- the substep */

typedef struct vbss_rigid_blocks {
    uint32_t first;    /* index of the translation block; rotation is first + 1 */
    uint32_t coupling; /* coupling of the two blocks, see vbss_system_couple */
} vbss_rigid_blocks;
/* Registers the two blocks of a body with this role and couples them. Returns the errors of
 * vbss_system_add_chain and vbss_system_couple. */
vbss_result vbss_rigid_register(vbss_system *system, vbss_role role, vbss_rigid_blocks *blocks);

/* Free flight over the substep under gravity, the load and drag, without coupling and contact; the initial
 * trial state.
 *
 * Translation is backward Euler: v = (v + h g) / (1 + h drag), x = x + h v. As in integration.c, x
 * = x_predicted + force / inertia, and gravity is already part of the prediction. Rotation
 * conserves angular momentum to rounding, except for drag. The orientation is of second order, and
 * exact for a body with two equal moments; energy stays bounded. */
void vbss_rigid_predict(const vbss_rigid *rigid, const vbss_rigid_substep *substep,
                        vbss_rigid_motion *predicted);
/* Velocities that belong to a trial pose at the end of the substep: the predicted ones plus
 * displacement and rotation from the predicted pose, divided by the length of the substep. */
vbss_rigid_motion vbss_rigid_motion_from_pose(const vbss_rigid_substep *substep,
                                              const vbss_rigid_motion *predicted,
                                              const pose *trial);
/* Sets the diagonals, right-hand sides and coupling of both blocks, for increments from the trial
 * pose.
 *
 * The matrix is symmetric positive definite. It holds the inertia at the predicted orientation, and
 * stiffness and damping of the virtual coupling over the substep. It omits derivatives that grow
 * with the rotation from the predicted or target pose to the trial pose. One linearisation is
 * therefore exact where each of these rotations has one axis; otherwise a few reach equilibrium to
 * rounding. Under torque the method is of first order. */
void vbss_rigid_assemble(const vbss_rigid *rigid, const vbss_rigid_substep *substep,
                         const vbss_rigid_motion *predicted, const pose *trial, vbss_system *system,
                         const vbss_rigid_blocks *blocks);
/* Moves the trial pose by dx, m, and rotates it by dtheta, rad, in the world frame. */
void vbss_rigid_apply_increment(pose *trial, vec3 dx, vec3 dtheta);
/* Makes the trial pose and its velocities (vbss_rigid_motion_from_pose) the state of the body.
 * Components of speed below VBSS_FLUSH_THRESHOLD become zero. */
void vbss_rigid_commit(vbss_rigid *rigid, const vbss_rigid_substep *substep,
                       const vbss_rigid_motion *predicted, const pose *trial);

/* Force and torque of the virtual coupling on a body with this motion at the end of the substep.
 * After a commit, rigid->now gives the wrench of that substep. A hand that holds the tool feels the
 * opposite. */
vbss_rigid_wrench vbss_rigid_coupling_wrench(const vbss_rigid *rigid,
                                             const vbss_rigid_substep *substep,
                                             const vbss_rigid_motion *motion);

/* Visits all fields with VBSS_SCENE_RIGID_TAGS tags from `first_tag` on. Mass and moments must equal
 * those of the saved state, otherwise VBSS_ERROR_CORRUPT. */
enum { VBSS_SCENE_RIGID_TAGS = 12 };
void vbss_rigid_serialise(vbss_stream *stream, uint16_t first_tag, vbss_rigid *rigid);

/* ---- mass of solid capsules, and of thin triangles (rigid_capsules.c) */

/* A cylinder with hemispherical ends; a ball if both ends are equal. */
typedef struct vbss_rigid_capsule {
    vec3 a, b;
    double radius, density; /* m, kg/m^3 */
} vbss_rigid_capsule;
typedef struct vbss_rigid_mass {
    double mass;
    vec3 inertia; /* principal moments, kg m^2 */
    pose frame;   /* centre of mass and principal axes, in the frame of the capsules */
} vbss_rigid_mass;
/* Mass, centre of mass and principal axes of solid capsules. Exact for each capsule; where capsules
 * overlap, their mass counts twice.
 *
 * The principal axes are right-handed and close to the axes of the capsules' frame: each rotation
 * is by an eighth of a turn at most. They equal those axes to the bit if all products of inertia
 * are zero. The error of a moment is a rounding error of the largest moment. If the capsules' frame
 * has the pose `tool`, the target pose of the body is pose_mul(tool, frame). Returns false and
 * writes nothing unless mass and moments are positive and finite. */
bool vbss_rigid_mass_of_capsules(const vbss_rigid_capsule *capsules, uint32_t count,
                                 vbss_rigid_mass *mass);

/* Triangles: three coordinates (m) a vertex, three valid indices of vertices a triangle; at least one. */
typedef struct vbss_rigid_triangles {
    const double *vertices;
    const uint32_t *triangles;
    uint32_t count;
} vbss_rigid_triangles;
/* The same for a mass, kg, that is spread evenly over the area of triangles. Exact for flat triangles. */
bool vbss_rigid_mass_of_triangles(const vbss_rigid_triangles *triangles, double mass_sum,
                                  vbss_rigid_mass *mass);

#endif
