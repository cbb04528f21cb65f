/* The motion of a rigid body: free flight, its equations in the system, what follows for velocities. */
#include "solver/rigid.h"

#include "base/error.h"
#include "base/rotation.h"
#include "base/stream.h"

/* The most that a body turns in one part, half of what could be told from turning the other way: a
 * faster spin, met once a part, would look like a slower one, and a stiff coupling would hold it. */
#define MOST_TURN 1.5707963267948966

/* ---- turning */

/* The turn, in the world, that takes one orientation to another the shortest way. Of the difference of
 * the quaternions, so that equal ones give zero to the bit: else a body would wake up by rounding. */
static vec3 turn_between(quat from, quat to)
{
    quat difference = quat_make(to.w - from.w, to.x - from.x, to.y - from.y, to.z - from.z);
    quat turn = quat_mul(difference, quat_conjugate(from));
    turn.w += 1.0;
    return vbss_quat_to_rotation_vector(turn);
}

static quat turned(quat orientation, vec3 turn)
{
    return quat_mul(vbss_quat_from_rotation_vector(turn), orientation);
}

/* About the body's own axis. */
static quat turned_about_axis(quat orientation, int axis, double angle)
{
    vec3 turn =
        vec3_make(axis == 0 ? angle : 0.0, axis == 1 ? angle : 0.0, axis == 2 ? angle : 0.0);
    return quat_mul(orientation, vbss_quat_from_rotation_vector(turn));
}

static vec3 times(vec3 a, vec3 b)
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
        vec3 scaled = times(vec3_load(r.m[i]), rigid->inertia);
        for (int j = 0; j <= i; j++) {
            inertia.m[i][j] = inertia.m[j][i] = vec3_dot(scaled, vec3_load(r.m[j]));
        }
    }
    return inertia;
}

vec3 vbss_rigid_angular_momentum(const vbss_rigid *rigid, const vbss_rigid_motion *motion)
{
    vec3 spin = quat_rotate_back(motion->at.orientation, motion->w);
    return quat_rotate(motion->at.orientation, times(rigid->inertia, spin));
}

static vec3 without_inertia(const vbss_rigid *rigid, quat orientation, vec3 angular_momentum)
{
    vec3 own = quat_rotate_back(orientation, angular_momentum);
    return quat_rotate(orientation, times(inverse_moments(rigid), own));
}

/* With one refinement: a quaternion is unit to rounding only, and always on the same side while a body
 * turns slowly; the angular momentum would fade. */
static vec3 angular_velocity(const vbss_rigid *rigid, quat orientation, vec3 angular_momentum)
{
    vbss_rigid_motion motion = {pose_make(vec3_zero(), orientation), vec3_zero(),
                                without_inertia(rigid, orientation, angular_momentum)};
    vec3 left = vec3_sub(angular_momentum, vbss_rigid_angular_momentum(rigid, &motion));
    return vec3_add(motion.w, without_inertia(rigid, orientation, left));
}

/* ---- free flight */

/* The energy is that of a top, with the moments of two axes equal, and what one of the two has beside
 * it. Both parts alone are solved by turns: the first about the angular momentum and the top's axis, the
 * second about the other axis. Half of the second, the first, half of the second: second order, symmetric
 * in time, symplectic; a top is exact. */
static quat flown(const vbss_rigid *rigid, quat orientation, vec3 angular_momentum, double h)
{
    vec3 inverse = inverse_moments(rigid);
    const double s[3] = {inverse.x, inverse.y, inverse.z};
    int axis = 0; /* of the top: the other two are most alike */
    for (int i = 1; i < 3; i++) {
        double most_alike = fabs(s[(axis + 1) % 3] - s[(axis + 2) % 3]);
        axis = fabs(s[(i + 1) % 3] - s[(i + 2) % 3]) < most_alike ? i : axis;
    }
    int like = (axis + 1) % 3, other = (axis + 2) % 3;
    double half = 0.5 * h * (s[other] - s[like]), whole = h * (s[axis] - s[like]);
    double own[3];
    vec3_store(own, quat_rotate_back(orientation, angular_momentum));
    quat q = turned_about_axis(orientation, other, half * own[other]);
    vec3_store(own, quat_rotate_back(q, angular_momentum));
    q = turned_about_axis(q, axis, whole * own[axis]);
    q = turned(q, vec3_scale(angular_momentum, h * s[like]));
    vec3_store(own, quat_rotate_back(q, angular_momentum));
    return quat_unit(turned_about_axis(q, other, half * own[other]));
}

static double length_of(const vbss_rigid_part *part)
{
    return part->step * (part->end - part->begin);
}

void vbss_rigid_predict(const vbss_rigid *rigid, const vbss_rigid_part *part,
                        vbss_rigid_motion *predicted)
{
    const vbss_rigid_motion *now = &rigid->now;
    double h = length_of(part), kept = 1.0 / (1.0 + h * rigid->drag);
    double turn = h * vec3_norm(now->w), slower = turn > MOST_TURN ? MOST_TURN / turn : 1.0;
    vec3 v = vec3_scale(vec3_add_scaled(now->v, h, rigid->gravity), kept);
    vec3 turning = vec3_scale(vbss_rigid_angular_momentum(rigid, now), kept * slower);
    quat orientation = flown(rigid, now->at.orientation, turning, h);
    predicted->at = pose_make(vec3_add_scaled(now->at.position, h, v), orientation);
    predicted->v = v;
    predicted->w = angular_velocity(rigid, orientation, turning);
}

/* Not of the angular momentum: what a turn of a thin body takes across its axis would come out as a
 * spin about it, larger by the ratio of the moments. */
vbss_rigid_motion vbss_rigid_follow(const vbss_rigid_part *part, const vbss_rigid_motion *predicted,
                                    const pose *trial)
{
    double rate = 1.0 / length_of(part);
    vec3 moved = vec3_sub(trial->position, predicted->at.position);
    vec3 turn = turn_between(predicted->at.orientation, trial->orientation);
    vbss_rigid_motion motion = {*trial, vec3_add_scaled(predicted->v, rate, moved),
                                vec3_add_scaled(predicted->w, rate, turn)};
    return motion;
}

/* ---- the given pose and the virtual coupling */

void vbss_rigid_retarget(vbss_rigid *rigid, pose end)
{
    rigid->begin = rigid->end;
    rigid->end = end;
}

vbss_rigid_motion vbss_rigid_given(const vbss_rigid *rigid, const vbss_rigid_part *part)
{
    const pose *begin = &rigid->begin, *end = &rigid->end;
    double rate = 1.0 / part->step;
    vec3 way = vec3_sub(end->position, begin->position);
    vec3 turn = turn_between(begin->orientation, end->orientation);
    vbss_rigid_motion motion = {*end, vec3_scale(way, rate), vec3_scale(turn, rate)};
    if (part->end < 1.0) {
        motion.at.position = vec3_lerp(begin->position, end->position, part->end);
        motion.at.orientation = quat_unit(turned(begin->orientation, vec3_scale(turn, part->end)));
    }
    return motion;
}

vbss_rigid_pull vbss_rigid_coupling_pull(const vbss_rigid *rigid, const vbss_rigid_part *part,
                                         const vbss_rigid_motion *motion)
{
    const vbss_rigid_coupling *c = &rigid->coupling;
    vbss_rigid_motion given = vbss_rigid_given(rigid, part);
    vec3 way = vec3_sub(given.at.position, motion->at.position);
    vec3 turn = turn_between(motion->at.orientation, given.at.orientation);
    vec3 force = vec3_scale(way, c->stiffness), torque = vec3_scale(turn, c->turning_stiffness);
    vbss_rigid_pull pull = {
        vec3_add_scaled(force, c->damping, vec3_sub(given.v, motion->v)),
        vec3_add_scaled(torque, c->turning_damping, vec3_sub(given.w, motion->w)),
    };
    return pull;
}

/* ---- the step */

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

void vbss_rigid_assemble(const vbss_rigid *rigid, const vbss_rigid_part *part,
                         const vbss_rigid_motion *predicted, const pose *trial, vbss_system *system,
                         const vbss_rigid_blocks *blocks)
{
    const vbss_rigid_coupling *c = &rigid->coupling;
    double h = length_of(part), rate = 1.0 / h;
    double inertial = rate * rate * (1.0 + h * rigid->drag), mass = inertial * rigid->mass;
    mat3 inertia = vbss_rigid_world_inertia(rigid, predicted->at.orientation);
    inertia = mat3_scale(inertia, inertial);
    vec3 way = vec3_sub(predicted->at.position, trial->position);
    vec3 turn = turn_between(predicted->at.orientation, trial->orientation);
    vbss_rigid_motion motion = vbss_rigid_follow(part, predicted, trial);
    vbss_rigid_pull pull = vbss_rigid_coupling_pull(rigid, part, &motion);

    block *diagonal = &system->diagonal[blocks->first];
    vec3 *rhs = &system->rhs[blocks->first];
    block_set(&diagonal[0], plus_identity(mat3_zero(), mass + c->stiffness + c->damping * rate));
    block_set(&diagonal[1],
              plus_identity(inertia, c->turning_stiffness + c->turning_damping * rate));
    rhs[0] = vec3_add_scaled(pull.force, mass, way);
    rhs[1] = vec3_sub(pull.torque, mat3_mul_vec3(inertia, turn));
    block_set(&system->numbers[blocks->coupling], mat3_zero());
}

void vbss_rigid_advance(pose *trial, vec3 dx, vec3 dtheta)
{
    trial->position = vec3_add(trial->position, dx);
    if (vec3_norm_squared(dtheta) != 0.0) { /* to the bit: what nothing turns flies on as it was */
        trial->orientation = quat_unit(turned(trial->orientation, dtheta));
    }
}

static vec3 settled(vec3 speed)
{
    return vec3_make(fabs(speed.x) > VBSS_STILL ? speed.x : 0.0,
                     fabs(speed.y) > VBSS_STILL ? speed.y : 0.0,
                     fabs(speed.z) > VBSS_STILL ? speed.z : 0.0);
}

void vbss_rigid_commit(vbss_rigid *rigid, const vbss_rigid_part *part,
                       const vbss_rigid_motion *predicted, const pose *trial)
{
    vbss_rigid_motion motion = vbss_rigid_follow(part, predicted, trial);
    motion.v = settled(motion.v);
    motion.w = settled(motion.w);
    rigid->now = motion;
}

/* ---- the state */

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

/* The moments of any body, to rounding. */
static bool are_moments(vec3 j)
{
    double largest = vbss_max(j.x, vbss_max(j.y, j.z));
    return is_positive(j.x) && is_positive(j.y) && is_positive(j.z) &&
           2.0 * largest <= (j.x + j.y + j.z) * (1.0 + 1e-9);
}

bool vbss_rigid_is_sound(const vbss_rigid *rigid)
{
    const vbss_rigid_coupling *c = &rigid->coupling;
    return is_positive(rigid->mass) && are_moments(rigid->inertia) &&
           vec3_is_finite(rigid->gravity) && is_not_negative(rigid->drag) &&
           is_not_negative(c->stiffness) && is_not_negative(c->damping) &&
           is_not_negative(c->turning_stiffness) && is_not_negative(c->turning_damping) &&
           is_pose(&rigid->now.at) && vec3_is_finite(rigid->now.v) &&
           vec3_is_finite(rigid->now.w) && is_pose(&rigid->begin) && is_pose(&rigid->end);
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
    visit_pose(stream, (uint16_t)(first_tag + 4), &rigid->now.at);
    vbss_stream_f64(stream, (uint16_t)(first_tag + 6), &rigid->now.v.x, 3);
    vbss_stream_f64(stream, (uint16_t)(first_tag + 7), &rigid->now.w.x, 3);
    visit_pose(stream, (uint16_t)(first_tag + 8), &rigid->begin);
    visit_pose(stream, (uint16_t)(first_tag + 10), &rigid->end);
    if (stream->mode == VBSS_STREAM_READ && !vbss_rigid_is_sound(rigid)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such rigid body");
    }
}
