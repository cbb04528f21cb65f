/* What a thread does that the jaws hold: Coulomb friction of their faces, for a clamp of three springs.
 *
 * The springs are alike, so three anchors that all give way by d take stiffness times d from the force
 * of the clamp. Each limit is met so: by just as much as the force exceeds it, at once. Anchors give way
 * only to the force that they exert, so no yielding stores energy in the springs. */
#include "base/elementary.h"
#include "grasper/grasper.h"

/* In which a thread that was just taken comes to lie straight in the middle of the jaws, s. */
#define SETTLING 0.08
/* Of the thread's direction along the faces: one that stands steeper between them goes aside and does
 * not run through. */
#define LEAST_ALONG 0.5
/* What has no direction, N. */
#define NOTHING 1e-150

enum { FIRST, MIDDLE, LAST };

typedef struct clamp {
    grip *held;
    vec3 force[GRIP_POINTS]; /* of each on the thread, as it is by now */
    double stiffness;        /* of each, along the faces */
} clamp;

double vbss_grip_limit(const grasper_object *g, double pressure)
{
    return 2.0 * g->config.grip_friction * pressure;
}

static vec3 along_faces(vec3 a)
{
    return vec3_make(0.0, a.y, a.z);
}

static void move_anchors(grip *held, vec3 by)
{
    for (int i = 0; i < GRIP_POINTS; i++) {
        held->at[i] = vec3_add(held->at[i], by);
    }
}

static void ease(clamp *c, vec3 by)
{
    for (int i = 0; i < GRIP_POINTS; i++) {
        vec3 eased = vec3_make(GRIP_ACROSS * by.x, by.y, by.z);
        c->force[i] = vec3_add_scaled(c->force[i], -c->stiffness, eased);
    }
}

static void give_way(clamp *c, vec3 by)
{
    move_anchors(c->held, vec3_neg(by));
    ease(c, by);
}

static vec3 whole_force(const clamp *c)
{
    return vec3_add(vec3_add(c->force[FIRST], c->force[MIDDLE]), c->force[LAST]);
}

/* ---- the force */

/* Pulled from face to face harder than the jaws press, it opens them and moves between them. */
static void yield_across(clamp *c, double pressure)
{
    double force = whole_force(c).x, excess = fabs(force) - pressure;
    if (excess > 0.0) {
        give_way(c, vec3_make(copysign(excess, force) / (GRIP_POINTS * GRIP_ACROSS * c->stiffness),
                              0.0, 0.0));
    }
}

/* The force on the thread points to where the thread was held: when the held place goes on that way, the
 * thread runs the other. As it rises between the faces while it runs, so do the anchors. */
static double run_through(clamp *c, vec3 *excess, vec3 along)
{
    double share = vec3_norm(along_faces(along));
    if (!(share >= LEAST_ALONG)) {
        return 0.0;
    }
    vec3 way = vec3_scale(along_faces(along), 1.0 / share);
    double run = vec3_dot(*excess, way), slid = run / share;
    *excess = vec3_add_scaled(*excess, -run, way);
    ease(c, vec3_scale(way, run));
    move_anchors(c->held, vec3_make(slid * along.x, 0.0, 0.0));
    return slid;
}

static double yield_along_faces(clamp *c, double limit, vec3 along)
{
    vec3 force = along_faces(whole_force(c));
    double strength = vec3_norm(force);
    if (!(strength > limit) || strength <= NOTHING) {
        return 0.0;
    }
    double part = (strength - limit) / (GRIP_POINTS * c->stiffness * strength);
    vec3 excess = vec3_scale(force, part);
    double slid = run_through(c, &excess, along);
    give_way(c, excess);
    return slid;
}

/* ---- the torque about the normal of the faces */

static void turn_outer(grip *held, double angle)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    for (int i = FIRST; i <= LAST; i += LAST - FIRST) {
        vec3 arm = vec3_sub(held->at[i], held->at[MIDDLE]);
        vec3 turned =
            vec3_make(arm.x, cosine * arm.y - sine * arm.z, sine * arm.y + cosine * arm.z);
        held->at[i] = vec3_add(held->at[MIDDLE], turned);
    }
}

/* Of the outer anchors about the middle one. Turned by an angle a it is torque cos(a) - spread sin(a), a
 * sine of the angle from where the springs are at rest: they turn to where that is the limit. */
static void yield_torque(clamp *c, double limit)
{
    double torque = 0.0, spread = 0.0;
    for (int i = FIRST; i <= LAST; i += LAST - FIRST) {
        vec3 force = c->force[i], arm = vec3_sub(c->held->at[i], c->held->at[MIDDLE]);
        vec3 from_middle = vec3_add_scaled(force, -c->stiffness, arm); /* were it held there */
        torque += arm.y * force.z - arm.z * force.y;
        spread += arm.y * from_middle.y + arm.z * from_middle.z;
    }
    double greatest = sqrt(torque * torque + spread * spread);
    if (!(fabs(torque) > limit) || greatest <= NOTHING) {
        return;
    }
    double sine = vbss_min(limit / greatest, 1.0);
    double at_limit = vbss_atan2(sine, sqrt((1.0 - sine) * (1.0 + sine)));
    turn_outer(c->held, vbss_atan2(-torque, -spread) + copysign(at_limit, torque));
}

/* ---- settling into the jaws */

static void settle(grip *held, const grip_load *load)
{
    double left = SETTLING - held->age;
    if (left > 0.0) {
        vec3 way = vec3_unit_or(along_faces(load->along), vec3_make(0.0, 1.0, 0.0));
        way = vec3_unit_or(along_faces(vec3_sub(held->at[LAST], held->at[FIRST])), way);
        vec3 middle = load->stacked ? held->at[MIDDLE] : along_faces(held->at[MIDDLE]);
        double share = vbss_min(load->h / left, 1.0);
        for (int i = 0; i < GRIP_POINTS; i++) {
            vec3 goal = vec3_add_scaled(middle, load->ahead[i], way);
            held->at[i] = vec3_lerp(held->at[i], goal, share);
        }
    }
    held->age += load->h;
}

/* Where the thread ends it is held over what there is of it: what is not there pulls at nothing. */
static void shorten(grip *held, const double ahead[GRIP_POINTS], double spacing)
{
    for (int i = FIRST; i <= LAST; i += LAST - FIRST) {
        vec3 arm = vec3_sub(held->at[i], held->at[MIDDLE]);
        double length = vec3_norm(arm), most = fabs(ahead[i]);
        if (most < spacing && length > most) {
            held->at[i] = vec3_add_scaled(held->at[MIDDLE], most / length, arm);
        }
    }
}

/* Where the jaws begin it stops; past their end, aside, or out of jaws that are pried open it is free. */
static bool stays(const grasper_object *g, grip *held)
{
    const vbss_grasper_jaws *j = vbss_grasper_jaws_now(g);
    move_anchors(held, vec3_make(0.0, 0.0, -vbss_max(held->at[MIDDLE].z, 0.0)));
    vec3 middle = held->at[MIDDLE];
    return -middle.z <= j->length + j->radius && fabs(middle.x) <= 2.0 * j->radius &&
           fabs(middle.y) <= j->radius + g->config.grip_length;
}

grip_change vbss_grip_yield(const grasper_object *g, grip *held, const grip_load *load)
{
    double limit = vbss_grip_limit(g, load->pressure);
    double arm = 0.25 * (load->ahead[LAST] - load->ahead[FIRST]);
    clamp c = {.held = held, .stiffness = g->config.grip_stiffness / GRIP_POINTS};
    for (int i = 0; i < GRIP_POINTS; i++) {
        c.force[i] = load->force[i];
    }
    grip_change change = {0.0, false};
    yield_across(&c, load->pressure);
    change.slid = yield_along_faces(&c, limit, load->along);
    yield_torque(&c, limit * arm);
    settle(held, load);
    shorten(held, load->ahead, 0.5 * g->config.grip_length);
    change.torn = !stays(g, held);
    return change;
}
