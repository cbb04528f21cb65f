/* Motion of a rigid body: free flight, its equations in the system, and its velocities. */
#include "solver/rigid.h"

#include "base/error.h"
#include "base/pi.h"
#include "base/rotation.h"
#include "base/stream.h"

/* Largest rotation of a body in one substep: half of the largest one whose sense is unambiguous. A faster
 * spin, sampled once a substep, would look like a slower one, and a stiff coupling would hold it. Derived. */
#define MAX_TURN (0.5 * VBSS_PI)

/* ---- rotation */

/* Shortest rotation vector, in the world frame, from one orientation to another. It uses the
 * difference of the quaternions, so that equal ones give zero to the bit. Otherwise rounding would
 * set a resting body in motion. */
static vec3 rotation_between(quat from, quat to)
{
    quat difference = quat_make(to.w - from.w, to.x - from.x, to.y - from.y, to.z - from.z);
    quat rotation = quat_mul(difference, quat_conjugate(from));
    rotation.w += 1.0;
    return vbss_quat_to_rotation_vector(rotation);
}

static quat rotate_orientation(quat orientation, vec3 rotation)
{
    return quat_mul(vbss_quat_from_rotation_vector(rotation), orientation);
}

/* Rotates about one of the body's own axes. */
static quat rotate_about_body_axis(quat orientation, int axis, double angle)
{
    vec3 rotation =
        vec3_make(axis == 0 ? angle : 0.0, axis == 1 ? angle : 0.0, axis == 2 ? angle : 0.0);
    return quat_mul(orientation, vbss_quat_from_rotation_vector(rotation));
}

static vec3 multiply_components(vec3 a, vec3 b)
{
    return vec3_make(a.x * b.x, a.y * b.y, a.z * b.z);
}

static vec3 inverse_moments(const vbss_rigid *rigid)
{
    return vec3_make(1.0 / rigid->inertia.x, 1.0 / rigid->inertia.y, 1.0 / rigid->inertia.z);
}

mat3 vbss_rigid_world_inertia(const vbss_rigid *rigid, quat orientation)
{
    mat3 r = quat_to_mat3(orientation), inertia;
    for (int i = 0; i < 3; i++) {
        vec3 scaled = multiply_components(vec3_load(r.m[i]), rigid->inertia);
        for (int j = 0; j <= i; j++) {
            inertia.m[i][j] = inertia.m[j][i] = vec3_dot(scaled, vec3_load(r.m[j]));
        }
    }
    return inertia;
}

vec3 vbss_rigid_angular_momentum(const vbss_rigid *rigid, const vbss_rigid_motion *motion)
{
    vec3 spin = quat_rotate_back(motion->pose.orientation, motion->w);
    return quat_rotate(motion->pose.orientation, multiply_components(rigid->inertia, spin));
}

static vec3 apply_inverse_inertia(const vbss_rigid *rigid, quat orientation, vec3 angular_momentum)
{
    vec3 body_momentum = quat_rotate_back(orientation, angular_momentum);
    return quat_rotate(orientation, multiply_components(inverse_moments(rigid), body_momentum));
}

/* One step of iterative refinement. A quaternion has unit length only to rounding, always with the
 * same sign while a body rotates slowly, so without it the angular momentum would drift. */
static vec3 angular_velocity(const vbss_rigid *rigid, quat orientation, vec3 angular_momentum)
{
    vbss_rigid_motion motion = {pose_make(vec3_zero(), orientation), vec3_zero(),
                                apply_inverse_inertia(rigid, orientation, angular_momentum)};
    vec3 residual = vec3_sub(angular_momentum, vbss_rigid_angular_momentum(rigid, &motion));
    return vec3_add(motion.w, apply_inverse_inertia(rigid, orientation, residual));
}

/* ---- free flight */

/* Splits the energy into that of a top, with two equal moments, and the rest about one of those two
 * axes. Both parts have exact solutions: the first rotates about the angular momentum and the top's
 * axis, the second about the other axis. Half of the second, the first, and half of the second give
 * a symplectic, time-symmetric method of second order; it is exact for a top. */
static quat integrate_free_rotation(const vbss_rigid *rigid, quat orientation,
                                    vec3 angular_momentum, double h)
{
    vec3 inverse = inverse_moments(rigid);
    const double s[3] = {inverse.x, inverse.y, inverse.z};
    int axis = 0; /* axis of the top: the other two moments are the most similar */
    for (int i = 1; i < 3; i++) {
        double smallest_difference = fabs(s[(axis + 1) % 3] - s[(axis + 2) % 3]);
        axis = fabs(s[(i + 1) % 3] - s[(i + 2) % 3]) < smallest_difference ? i : axis;
    }
    int like = (axis + 1) % 3, other = (axis + 2) % 3;
    double half = 0.5 * h * (s[other] - s[like]), whole = h * (s[axis] - s[like]);
    double body_momentum[3];
    vec3_store(body_momentum, quat_rotate_back(orientation, angular_momentum));
    quat q = rotate_about_body_axis(orientation, other, half * body_momentum[other]);
    vec3_store(body_momentum, quat_rotate_back(q, angular_momentum));
    q = rotate_about_body_axis(q, axis, whole * body_momentum[axis]);
    q = rotate_orientation(q, vec3_scale(angular_momentum, h * s[like]));
    vec3_store(body_momentum, quat_rotate_back(q, angular_momentum));
    return quat_unit(rotate_about_body_axis(q, other, half * body_momentum[other]));
}

static double substep_length(const vbss_rigid_substep *substep)
{
    return substep->step_length * (substep->end_fraction - substep->start_fraction);
}

static bool has_load(const vbss_rigid *rigid)
{
    return vec3_norm_squared(rigid->load.force) > 0.0 ||
           vec3_norm_squared(rigid->load.torque) > 0.0;
}

void vbss_rigid_predict(const vbss_rigid *rigid, const vbss_rigid_substep *substep,
                        vbss_rigid_motion *predicted)
{
    const vbss_rigid_motion *now = &rigid->now;
    double h = substep_length(substep), drag_factor = 1.0 / (1.0 + h * rigid->drag);
    double angle = h * vec3_norm(now->w), spin_factor = angle > MAX_TURN ? MAX_TURN / angle : 1.0;
    vec3 acceleration = rigid->gravity;
    vec3 angular_momentum =
        vec3_scale(vbss_rigid_angular_momentum(rigid, now), drag_factor * spin_factor);
    if (has_load(rigid)) { /* otherwise signs of zeros could change */
        acceleration = vec3_add_scaled(acceleration, 1.0 / rigid->mass, rigid->load.force);
        angular_momentum = vec3_add_scaled(angular_momentum, h * drag_factor, rigid->load.torque);
    }
    vec3 v = vec3_scale(vec3_add_scaled(now->v, h, acceleration), drag_factor);
    quat orientation = integrate_free_rotation(rigid, now->pose.orientation, angular_momentum, h);
    predicted->pose = pose_make(vec3_add_scaled(now->pose.position, h, v), orientation);
    predicted->v = v;
    predicted->w = angular_velocity(rigid, orientation, angular_momentum);
}

/* Does not use the angular momentum. For a thin body, rotation of a component across its axis would
 * appear as spin about it, magnified by the ratio of the moments. */
vbss_rigid_motion vbss_rigid_motion_from_pose(const vbss_rigid_substep *substep,
                                              const vbss_rigid_motion *predicted, const pose *trial)
{
    double rate = 1.0 / substep_length(substep);
    vec3 displacement = vec3_sub(trial->position, predicted->pose.position);
    vec3 rotation = rotation_between(predicted->pose.orientation, trial->orientation);
    vbss_rigid_motion motion = {*trial, vec3_add_scaled(predicted->v, rate, displacement),
                                vec3_add_scaled(predicted->w, rate, rotation)};
    return motion;
}

/* ---- the target pose and the virtual coupling */

void vbss_rigid_set_target(vbss_rigid *rigid, pose target)
{
    rigid->target_start = rigid->target_end;
    rigid->target_end = target;
}

vbss_rigid_motion vbss_rigid_target_motion(const vbss_rigid *rigid,
                                           const vbss_rigid_substep *substep)
{
    const pose *start = &rigid->target_start, *end = &rigid->target_end;
    double rate = 1.0 / substep->step_length;
    vec3 displacement = vec3_sub(end->position, start->position);
    vec3 rotation = rotation_between(start->orientation, end->orientation);
    vbss_rigid_motion motion = {*end, vec3_scale(displacement, rate), vec3_scale(rotation, rate)};
    if (substep->end_fraction < 1.0) {
        motion.pose.position = vec3_lerp(start->position, end->position, substep->end_fraction);
        motion.pose.orientation = quat_unit(
            rotate_orientation(start->orientation, vec3_scale(rotation, substep->end_fraction)));
    }
    return motion;
}

vbss_rigid_wrench vbss_rigid_coupling_wrench(const vbss_rigid *rigid,
                                             const vbss_rigid_substep *substep,
                                             const vbss_rigid_motion *motion)
{
    const vbss_rigid_coupling *c = &rigid->coupling;
    vbss_rigid_motion target = vbss_rigid_target_motion(rigid, substep);
    vec3 displacement = vec3_sub(target.pose.position, motion->pose.position);
    vec3 rotation = rotation_between(motion->pose.orientation, target.pose.orientation);
    vec3 force = vec3_scale(displacement, c->stiffness),
         torque = vec3_scale(rotation, c->turning_stiffness);
    vbss_rigid_wrench wrench = {
        vec3_add_scaled(force, c->damping, vec3_sub(target.v, motion->v)),
        vec3_add_scaled(torque, c->turning_damping, vec3_sub(target.w, motion->w)),
    };
    return wrench;
}

/* ---- the substep */

vbss_result vbss_rigid_register(vbss_system *system, vbss_role role, vbss_rigid_blocks *blocks)
{
    VBSS_TRY(vbss_system_add_chain(system, 2, &blocks->first));
    vbss_system_set_role(system, blocks->first, role);
    vbss_system_set_role(system, blocks->first + 1, role);
    return vbss_system_couple(system, blocks->first, blocks->first + 1, &blocks->coupling);
}

static mat3 plus_identity(mat3 a, double s)
{
    return mat3_add(a, mat3_diagonal(s, s, s));
}

void vbss_rigid_assemble(const vbss_rigid *rigid, const vbss_rigid_substep *substep,
                         const vbss_rigid_motion *predicted, const pose *trial, vbss_system *system,
                         const vbss_rigid_blocks *blocks)
{
    const vbss_rigid_coupling *c = &rigid->coupling;
    double h = substep_length(substep), rate = 1.0 / h;
    double inertial = rate * rate * (1.0 + h * rigid->drag), mass = inertial * rigid->mass;
    mat3 inertia = vbss_rigid_world_inertia(rigid, predicted->pose.orientation);
    inertia = mat3_scale(inertia, inertial);
    vec3 displacement = vec3_sub(predicted->pose.position, trial->position);
    vec3 rotation = rotation_between(predicted->pose.orientation, trial->orientation);
    vbss_rigid_motion motion = vbss_rigid_motion_from_pose(substep, predicted, trial);
    vbss_rigid_wrench wrench = vbss_rigid_coupling_wrench(rigid, substep, &motion);

    block *diagonal = &system->diagonal[blocks->first];
    vec3 *rhs = &system->rhs[blocks->first];
    block_set(&diagonal[0], plus_identity(mat3_zero(), mass + c->stiffness + c->damping * rate));
    block_set(&diagonal[1],
              plus_identity(inertia, c->turning_stiffness + c->turning_damping * rate));
    rhs[0] = vec3_add_scaled(wrench.force, mass, displacement);
    rhs[1] = vec3_sub(wrench.torque, mat3_mul_vec3(inertia, rotation));
    block_set(&system->off_diagonal[blocks->coupling], mat3_zero());
}

void vbss_rigid_apply_increment(pose *trial, vec3 dx, vec3 dtheta)
{
    trial->position = vec3_add(trial->position, dx);
    /* a body without torque keeps its orientation to the bit */
    if (vec3_norm_squared(dtheta) != 0.0) {
        trial->orientation = quat_unit(rotate_orientation(trial->orientation, dtheta));
    }
}

static vec3 flush_small(vec3 speed)
{
    return vec3_make(fabs(speed.x) > VBSS_FLUSH_THRESHOLD ? speed.x : 0.0,
                     fabs(speed.y) > VBSS_FLUSH_THRESHOLD ? speed.y : 0.0,
                     fabs(speed.z) > VBSS_FLUSH_THRESHOLD ? speed.z : 0.0);
}

void vbss_rigid_commit(vbss_rigid *rigid, const vbss_rigid_substep *substep,
                       const vbss_rigid_motion *predicted, const pose *trial)
{
    vbss_rigid_motion motion = vbss_rigid_motion_from_pose(substep, predicted, trial);
    motion.v = flush_small(motion.v);
    motion.w = flush_small(motion.w);
    rigid->now = motion;
}

/* ---- validity and serialisation */

static bool is_positive(double x)
{
    return x >= DBL_MIN && x <= DBL_MAX;
}

static bool is_not_negative(double x)
{
    return x >= 0.0 && x <= DBL_MAX;
}

static bool is_pose(const pose *p)
{
    return vec3_is_finite(p->position) &&
           fabs(quat_dot(p->orientation, p->orientation) - 1.0) < 1e-6;
}

/* Whether a body can have these moments, to rounding. */
static bool are_moments(vec3 j)
{
    double largest = vbss_max(j.x, vbss_max(j.y, j.z));
    return is_positive(j.x) && is_positive(j.y) && is_positive(j.z) &&
           2.0 * largest <= (j.x + j.y + j.z) * (1.0 + 1e-9);
}

bool vbss_rigid_is_valid(const vbss_rigid *rigid)
{
    const vbss_rigid_coupling *c = &rigid->coupling;
    return is_positive(rigid->mass) && are_moments(rigid->inertia) &&
           vec3_is_finite(rigid->gravity) && is_not_negative(rigid->drag) &&
           is_not_negative(c->stiffness) && is_not_negative(c->damping) &&
           is_not_negative(c->turning_stiffness) && is_not_negative(c->turning_damping) &&
           is_pose(&rigid->now.pose) && vec3_is_finite(rigid->now.v) &&
           vec3_is_finite(rigid->now.w) && is_pose(&rigid->target_start) &&
           is_pose(&rigid->target_end);
}

static void visit_pose(vbss_stream *stream, uint16_t tag, pose *p)
{
    vbss_stream_f64(stream, tag, &p->position.x, 3);
    vbss_stream_f64(stream, (uint16_t)(tag + 1), &p->orientation.w, 4);
}

void vbss_rigid_serialise(vbss_stream *stream, uint16_t first_tag, vbss_rigid *rigid)
{
    const double same[] = {rigid->mass, rigid->inertia.x, rigid->inertia.y, rigid->inertia.z};
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        vbss_stream_expect_f64(stream, first_tag, same[i]);
    }
    vbss_stream_f64(stream, (uint16_t)(first_tag + 1), &rigid->gravity.x, 3);
    vbss_stream_f64(stream, (uint16_t)(first_tag + 2), &rigid->drag, 1);
    vbss_stream_f64(stream, (uint16_t)(first_tag + 3), &rigid->coupling.stiffness, 4);
    visit_pose(stream, (uint16_t)(first_tag + 4), &rigid->now.pose);
    vbss_stream_f64(stream, (uint16_t)(first_tag + 6), &rigid->now.v.x, 3);
    vbss_stream_f64(stream, (uint16_t)(first_tag + 7), &rigid->now.w.x, 3);
    visit_pose(stream, (uint16_t)(first_tag + 8), &rigid->target_start);
    visit_pose(stream, (uint16_t)(first_tag + 10), &rigid->target_end);
    if (stream->mode == VBSS_STREAM_READ && !vbss_rigid_is_valid(rigid)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such rigid body");
    }
}
