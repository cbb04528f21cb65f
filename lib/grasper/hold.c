/* What a needle does that the jaws hold: Coulomb friction of their faces, and what torque they bear, for a clamp of three
 * springs at the corners of a triangle.
 *
 * Each spring has a third of the stiffness, so that together they give k against sliding, k a^2 against turning about the
 * normal of the faces, and half of that about axes in them: a follows from the stiffness of both. What exceeds a limit
 * gives way by just as much as it exceeds it, at once; the place where it is held gives way only to the force that it
 * exerts, so no yielding stores energy in the springs. */
#include "base/rotation.h"
#include "grasper/grasper.h"

/* In which a needle that was just taken comes to lie in the middle of the jaws, s. */
#define SETTLING 0.08

vec3 vbss_hold_corner(const grasper_object *g, vec3 middle, uint32_t i)
{
    static const double way[HOLD_POINTS][2] = {
        {1.0, 0.0}, {-0.5, 0.86602540378443865}, {-0.5, -0.86602540378443865}};
    double arm = sqrt(g->config.needle_turning_stiffness / g->config.needle_stiffness);
    return vec3_add(middle, vec3_make(0.0, arm * way[i][0], arm * way[i][1]));
}

double vbss_hold_stiffness(const grasper_object *g)
{
    return g->config.needle_stiffness / HOLD_POINTS;
}

/* So much of it is beyond the limit. */
static double excess_of(double size, double limit)
{
    return size > limit ? (size - limit) / size : 0.0;
}

/* Pulled from face to face harder than the jaws press, it opens them and moves between them; along the faces it slides
 * beyond their friction. */
static double slide(const grasper_object *g, pose *at, const hold_load *load)
{
    vec3 along = vec3_make(0.0, load->force.y, load->force.z);
    double across = load->force.x * excess_of(fabs(load->force.x), load->pressure);
    double beyond = excess_of(vec3_norm(along), vbss_grip_limit(g, load->pressure));
    vec3 slid = vec3_scale(along, beyond / g->config.needle_stiffness);
    slid.x = across / g->config.needle_stiffness;
    at->position = vec3_sub(at->position, slid);
    return vec3_norm(slid);
}

static double turn(const grasper_object *g, pose *at, const hold_load *load)
{
    double all = g->config.closing_force, share = all > 0.0 ? load->pressure / all : 0.0;
    double limit = g->config.needle_torque * share;
    double beyond = excess_of(vec3_norm(load->torque), limit);
    double stiffness = g->config.needle_turning_stiffness;
    vec3 turned = vec3_make(load->torque.x, 2.0 * load->torque.y, 2.0 * load->torque.z);
    turned = vec3_scale(turned, beyond / stiffness);
    if (beyond > 0.0) {
        quat back = vbss_quat_from_rotation_vector(vec3_neg(turned));
        at->orientation = quat_unit(quat_mul(back, at->orientation));
    }
    return vec3_norm(turned);
}

static void settle(pose *at, double *age, double h)
{
    double left = SETTLING - *age;
    if (left > 0.0) {
        at->position.x *= 1.0 - vbss_min(h / left, 1.0);
    }
    *age += h;
}

/* Where the jaws begin it stops; past their end, or out of jaws that are pried open, it is free. */
static bool stays(const grasper_object *g, pose *at)
{
    const vbss_grasper_jaws *j = vbss_grasper_jaws_now(g);
    at->position.z = vbss_min(at->position.z, 0.0);
    vec3 middle = at->position;
    return -middle.z <= j->length + j->radius && fabs(middle.x) <= 2.0 * j->radius;
}

hold_change vbss_hold_yield(const grasper_object *g, pose *at, double *age, const hold_load *load)
{
    hold_change change = {.slid = slide(g, at, load), .turned = turn(g, at, load)};
    settle(at, age, load->h);
    change.torn = !stays(g, at);
    return change;
}
