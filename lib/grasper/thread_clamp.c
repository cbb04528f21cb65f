/* Slip of a thread in the jaws: Coulomb friction of their faces for a clamp of three springs.
 *
 * The springs are equal, so moving all three anchors by d reduces the force of the clamp by three
 * times their stiffness times d. A force beyond its limit moves the anchors at once by just its
 * excess. Anchors yield only to the force that they exert themselves, so yielding never stores
 * energy in the springs. */
#include "base/elementary.h"
#include "grasper/grasper.h"
#include "grasper/tuning.h"

/* Force below which its direction is undefined, N. */
#define MIN_FORCE 1e-150

enum { FIRST, MIDDLE, LAST };

typedef struct clamp_springs {
    grasper_thread_clamp *clamp;
    /* force of each spring on the thread, updated as anchors yield */
    vec3 force[GRASPER_THREAD_POINTS];
    double stiffness; /* stiffness of each spring along the faces */
} clamp_springs;

double vbss_grasper_friction_limit(const grasper_object *g, double jaw_force)
{
    return 2.0 * g->config.grip_friction * jaw_force;
}

static vec3 in_face_plane(vec3 a)
{
    return vec3_make(0.0, a.y, a.z);
}

static void move_anchors(grasper_thread_clamp *clamp, vec3 by)
{
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        clamp->anchor[i] = vec3_add(clamp->anchor[i], by);
    }
}

static void relax_force(clamp_springs *c, vec3 by)
{
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        vec3 force_change = vec3_make(GRASPER_NORMAL_STIFFNESS_RATIO * by.x, by.y, by.z);
        c->force[i] = vec3_add_scaled(c->force[i], -c->stiffness, force_change);
    }
}

static void yield_anchors(clamp_springs *c, vec3 by)
{
    move_anchors(c->clamp, vec3_neg(by));
    relax_force(c, by);
}

static vec3 total_force(const clamp_springs *c)
{
    return vec3_add(vec3_add(c->force[FIRST], c->force[MIDDLE]), c->force[LAST]);
}

/* ---- force */

/* A force across the faces that exceeds the jaw force opens the jaws and moves the thread between
 * them. */
static void yield_across(clamp_springs *c, double jaw_force)
{
    double force = total_force(c).x, excess = fabs(force) - jaw_force;
    if (excess > 0.0) {
        yield_anchors(
            c, vec3_make(copysign(excess, force) / (GRASPER_THREAD_POINTS *
                                                    GRASPER_NORMAL_STIFFNESS_RATIO * c->stiffness),
                         0.0, 0.0));
    }
}

/* The force on the thread points to its earlier position. If the grasp moves along the thread that
 * way, the thread runs the other way. A thread that is inclined to the faces also moves the anchors
 * across them. */
static double slide_through(clamp_springs *c, vec3 *excess, vec3 along)
{
    double fraction = vec3_norm(in_face_plane(along));
    if (!(fraction >= GRASPER_MIN_ALONG_FRACTION)) {
        return 0.0;
    }
    vec3 direction = vec3_scale(in_face_plane(along), 1.0 / fraction);
    double run = vec3_dot(*excess, direction), slip = run / fraction;
    *excess = vec3_add_scaled(*excess, -run, direction);
    relax_force(c, vec3_scale(direction, run));
    move_anchors(c->clamp, vec3_make(slip * along.x, 0.0, 0.0));
    return slip;
}

static double yield_along_faces(clamp_springs *c, double limit, vec3 along)
{
    vec3 force = in_face_plane(total_force(c));
    double strength = vec3_norm(force);
    if (!(strength > limit) || strength <= MIN_FORCE) {
        return 0.0;
    }
    double excess_fraction = (strength - limit) / (GRASPER_THREAD_POINTS * c->stiffness * strength);
    vec3 excess = vec3_scale(force, excess_fraction);
    double slip = slide_through(c, &excess, along);
    yield_anchors(c, excess);
    return slip;
}

/* ---- torque about the normal of the faces */

static void rotate_outer_anchors(grasper_thread_clamp *clamp, double angle)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    for (int i = FIRST; i <= LAST; i += LAST - FIRST) {
        vec3 arm = vec3_sub(clamp->anchor[i], clamp->anchor[MIDDLE]);
        vec3 turned =
            vec3_make(arm.x, cosine * arm.y - sine * arm.z, sine * arm.y + cosine * arm.z);
        clamp->anchor[i] = vec3_add(clamp->anchor[MIDDLE], turned);
    }
}

/* Torque of the outer anchors about the middle one. Rotated by an angle a it is torque cos(a) -
 * spread sin(a), a sine of the angle from the rest position of the springs. The anchors rotate to
 * the angle where the torque equals the limit. */
static void yield_torque(clamp_springs *c, double limit)
{
    double torque = 0.0, spread = 0.0;
    for (int i = FIRST; i <= LAST; i += LAST - FIRST) {
        vec3 force = c->force[i], arm = vec3_sub(c->clamp->anchor[i], c->clamp->anchor[MIDDLE]);
        /* the force if the anchor were at the middle one */
        vec3 from_middle = vec3_add_scaled(force, -c->stiffness, arm);
        torque += arm.y * force.z - arm.z * force.y;
        spread += arm.y * from_middle.y + arm.z * from_middle.z;
    }
    double greatest = sqrt(torque * torque + spread * spread);
    if (!(fabs(torque) > limit) || greatest <= MIN_FORCE) {
        return;
    }
    double sine = vbss_min(limit / greatest, 1.0);
    double at_limit = vbss_arc_tangent(sine, sqrt((1.0 - sine) * (1.0 + sine)));
    rotate_outer_anchors(c->clamp, vbss_arc_tangent(-torque, -spread) + copysign(at_limit, torque));
}

/* ---- centring in the jaws */

static void centre_in_jaws(grasper_thread_clamp *clamp, const grasper_thread_load *load)
{
    double remaining = GRASPER_CENTRING_TIME - clamp->age;
    if (remaining > 0.0) {
        vec3 direction =
            vec3_unit_or(in_face_plane(load->thread_direction), vec3_make(0.0, 1.0, 0.0));
        direction = vec3_unit_or(in_face_plane(vec3_sub(clamp->anchor[LAST], clamp->anchor[FIRST])),
                                 direction);
        vec3 middle =
            load->is_stacked ? clamp->anchor[MIDDLE] : in_face_plane(clamp->anchor[MIDDLE]);
        double fraction = vbss_min(load->h / remaining, 1.0);
        for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
            vec3 target = vec3_add_scaled(middle, load->arc_offset[i], direction);
            clamp->anchor[i] = vec3_lerp(clamp->anchor[i], target, fraction);
        }
    }
    clamp->age += load->h;
}

/* Near an end of the thread, moves the outer anchors to the part that exists, so that they do not
 * pull on a missing part. */
static void shorten(grasper_thread_clamp *clamp, const double arc_offset[GRASPER_THREAD_POINTS],
                    double spacing)
{
    for (int i = FIRST; i <= LAST; i += LAST - FIRST) {
        vec3 arm = vec3_sub(clamp->anchor[i], clamp->anchor[MIDDLE]);
        double length = vec3_norm(arm), max_length = fabs(arc_offset[i]);
        if (max_length < spacing && length > max_length) {
            clamp->anchor[i] = vec3_add_scaled(clamp->anchor[MIDDLE], max_length / length, arm);
        }
    }
}

/* The thread stops at the pivot. It is free past the end of the jaws, beside them, or if the jaws
 * are pried open. */
static bool stays_in_jaws(const grasper_object *g, grasper_thread_clamp *clamp)
{
    const grasper_jaws *j = vbss_grasper_current_jaws(g);
    move_anchors(clamp, vec3_make(0.0, 0.0, -vbss_max(clamp->anchor[MIDDLE].z, 0.0)));
    vec3 middle = clamp->anchor[MIDDLE];
    return -middle.z <= j->length + j->radius && fabs(middle.x) <= 2.0 * j->radius &&
           fabs(middle.y) <= j->radius + g->config.grip_length;
}

grasper_thread_slip vbss_grasper_yield_thread(const grasper_object *g, grasper_thread_clamp *clamp,
                                              const grasper_thread_load *load)
{
    double limit = vbss_grasper_friction_limit(g, load->jaw_force);
    double arm = 0.25 * (load->arc_offset[LAST] - load->arc_offset[FIRST]);
    clamp_springs c = {.clamp = clamp,
                       .stiffness = g->config.grip_stiffness / GRASPER_THREAD_POINTS};
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        c.force[i] = load->force[i];
    }
    grasper_thread_slip change = {0.0, false};
    yield_across(&c, load->jaw_force);
    change.slip = yield_along_faces(&c, limit, load->thread_direction);
    yield_torque(&c, limit * arm);
    centre_in_jaws(clamp, load);
    shorten(clamp, load->arc_offset, 0.5 * g->config.grip_length);
    change.has_escaped = !stays_in_jaws(g, clamp);
    return change;
}
