/* Slip of a needle in the jaws: Coulomb friction and a torque limit for a clamp of three springs at
 * the corners of a triangle.
 *
 * Each spring has a third of the stiffness k. Together they give k against translation, k a^2
 * against rotation about the normal of the faces, and half of that about axes in the faces. The arm
 * a follows from both stiffnesses. A force beyond its limit moves the grasp at once by just its
 * excess. The grasp yields only to the force that it exerts itself, so yielding never stores energy
 * in the springs. */
#include "base/rotation.h"
#include "grasper/grasper.h"
#include "grasper/tuning.h"

vec3 vbss_grasper_needle_clamp_point(const grasper_object *g, vec3 middle, uint32_t i)
{
    static const double direction[GRASPER_NEEDLE_POINTS][2] = {
        {1.0, 0.0}, {-0.5, 0.86602540378443865}, {-0.5, -0.86602540378443865}};
    double arm = sqrt(g->config.needle_turning_stiffness / g->config.needle_stiffness);
    return vec3_add(middle, vec3_make(0.0, arm * direction[i][0], arm * direction[i][1]));
}

double vbss_grasper_needle_clamp_stiffness(const grasper_object *g)
{
    return g->config.needle_stiffness / GRASPER_NEEDLE_POINTS;
}

/* Fraction of a force that is beyond its limit. */
static double excess_fraction(double size, double limit)
{
    return size > limit ? (size - limit) / size : 0.0;
}

/* A force across the faces that exceeds the jaw force opens the jaws and moves the needle between
 * them. A force along the faces that exceeds their friction makes it slide. */
static double slide(const grasper_object *g, pose *at, const grasper_needle_load *load)
{
    vec3 along = vec3_make(0.0, load->force.y, load->force.z);
    double across = load->force.x * excess_fraction(fabs(load->force.x), load->jaw_force);
    double beyond =
        excess_fraction(vec3_norm(along), vbss_grasper_friction_limit(g, load->jaw_force));
    vec3 slip = vec3_scale(along, beyond / g->config.needle_stiffness);
    slip.x = across / g->config.needle_stiffness;
    at->position = vec3_sub(at->position, slip);
    return vec3_norm(slip);
}

static double turn(const grasper_object *g, pose *at, const grasper_needle_load *load)
{
    double max_force = g->config.closing_force,
           force_fraction = max_force > 0.0 ? load->jaw_force / max_force : 0.0;
    double limit = g->config.needle_torque * force_fraction;
    double beyond = excess_fraction(vec3_norm(load->torque), limit);
    double stiffness = g->config.needle_turning_stiffness;
    vec3 rotation = vec3_make(load->torque.x, 2.0 * load->torque.y, 2.0 * load->torque.z);
    rotation = vec3_scale(rotation, beyond / stiffness);
    if (beyond > 0.0) {
        quat back = vbss_quat_from_rotation_vector(vec3_neg(rotation));
        at->orientation = quat_unit(quat_mul(back, at->orientation));
    }
    return vec3_norm(rotation);
}

static void centre_in_jaws(pose *at, double *age, double h)
{
    double remaining = GRASPER_CENTRING_TIME - *age;
    if (remaining > 0.0) {
        at->position.x *= 1.0 - vbss_min(h / remaining, 1.0);
    }
    *age += h;
}

/* The needle stops at the pivot. It is free past the end of the jaws, or if the jaws are pried
 * open. */
static bool stays_in_jaws(const grasper_object *g, pose *at)
{
    const grasper_jaws *j = vbss_grasper_current_jaws(g);
    at->position.z = vbss_min(at->position.z, 0.0);
    vec3 middle = at->position;
    return -middle.z <= j->length + j->radius && fabs(middle.x) <= 2.0 * j->radius;
}

grasper_needle_slip vbss_grasper_yield_needle(const grasper_object *g, pose *at, double *age,
                                              const grasper_needle_load *load)
{
    grasper_needle_slip change = {.slip = slide(g, at, load), .rotation = turn(g, at, load)};
    centre_in_jaws(at, age, load->h);
    change.has_escaped = !stays_in_jaws(g, at);
    return change;
}
