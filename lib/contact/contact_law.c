/* The contact law: unilateral contact with Coulomb friction, both with a stiffness; ties and
 * sleeves.
 *
 * Normal: normal force = -stiffness gap if that is positive, otherwise 0. Tangential: the slip
 *     v = (relative_displacement + u)_t + (tangential_force - previous_force) / stiffness
 * is the tangential motion since the start of the substep minus its elastic part. The tangential
 * force lies in the disk of radius friction coefficient times normal force, and is the projection
 * of (tangential_force - r v) to it (Alart, Curnier 1991). Sticking means v = 0. Slipping is
 * linearised exactly, which makes the stiffness unsymmetric. */
#include "contact/contact.h"
#include "contact/tuning.h"

static vec3 tangential_component(vec3 v, vec3 normal)
{
    return vec3_add_scaled(v, -vec3_dot(v, normal), normal);
}

/* Whether the constraint can have a force in the tangent plane. */
static bool acts_tangentially(const contact_constraint *constraint)
{
    return constraint->is_bilateral || constraint->friction != 0.0;
}

vec3 vbss_contact_rotate_to_tangent_plane(vec3 force, vec3 normal)
{
    double before = vec3_norm_squared(force);
    vec3 in_plane = tangential_component(force, normal);
    double after = vec3_norm_squared(in_plane);
    if (!(after >
          CONTACT_MIN_TANGENT_SQUARED * before)) { /* the force was normal to the new plane */
        return vec3_zero();
    }
    return vec3_scale(in_plane, sqrt(before / after));
}

/* SLIP: stiffness in the tangent plane across the slip direction. */
static double stiffness_across_slip(const contact_constraint *constraint)
{
    double r = constraint->augmentation, k = contact_tangential_stiffness(constraint);
    /* 1 / ((1 - ratio) / (ratio r) + 1 / k) */
    return constraint->solution.friction_ratio * r * k /
           ((1.0 - constraint->solution.friction_ratio) * k +
            constraint->solution.friction_ratio * r);
}

/* ---- sleeves: they hold the suture across its axis and let it slide along it with friction
 *
 * The force along the normal, the tangent of the suture, is that of a spring up to the yield limit
 *     limit = yield_force + yield_friction |transverse force|, one limit for each direction of
 *     sliding.
 * Beyond it a damper in series with the spring yields: f = limit + c v at any speed and any step
 * length (Perzyna 1966).
 *
 * Where the wall can tear, the transverse spring yields in the same manner, when the part of its
 * force in the plane of the wall reaches tear_force. */

typedef struct sleeve_force {
    vec3 transverse;
    double axial;
} sleeve_force;

static double elastic_axial_force(const contact_constraint *constraint, vec3 displacement)
{
    return vec3_dot(constraint->previous_force, constraint->normal) -
           constraint->stiffness * vec3_dot(displacement, constraint->normal);
}

/* Signed axial force beyond which the suture slides, along the normal (is_forward) or against
 * it. */
static double axial_yield_limit(const contact_constraint *constraint, bool is_forward,
                                double transverse_force)
{
    double limit = constraint->yield_force[is_forward] +
                   constraint->yield_friction[is_forward] * transverse_force;
    return is_forward ? limit : -limit;
}

static double viscoplastic_force(const contact_constraint *constraint, double elastic, double limit)
{
    return (constraint->viscous_stiffness * elastic + constraint->stiffness * limit) /
           (constraint->viscous_stiffness + constraint->stiffness);
}

/* Transverse force along a unit direction above which the wall tears, N. 0: it cannot tear. */
static double tear_limit_along(const contact_constraint *constraint, vec3 direction)
{
    if (!(constraint->tear_force > 0.0)) {
        return 0.0;
    }
    double in_plane = vec3_norm(tangential_component(direction, constraint->wall_normal));
    return in_plane >= CONTACT_MIN_TEAR_SHARE ? constraint->tear_force / in_plane : 0.0;
}

static bool is_tearing(const contact_solution *solution)
{
    return solution->tear_limit > 0.0;
}

/* Transverse force of a tearing sleeve whose spring alone would have the force `elastic`. */
static double tearing_force(const contact_constraint *constraint, const contact_solution *solution,
                            double elastic)
{
    return solution->is_tear_capped ? elastic - constraint->stiffness * constraint->max_tear_slip
                                    : viscoplastic_force(constraint, elastic, solution->tear_limit);
}

/* Lets the sleeve tear if the force of its spring, in the direction slip_direction, is beyond the
 * limit. */
static void update_tear(const contact_constraint *constraint, double elastic,
                        contact_solution *next)
{
    double limit = tear_limit_along(constraint, next->slip_direction);
    if (!(limit > 0.0) || elastic <= limit) {
        return;
    }
    next->tear_limit = limit;
    next->is_tear_capped = elastic - tearing_force(constraint, next, elastic) >
                           constraint->stiffness * constraint->max_tear_slip;
    double force = tearing_force(constraint, next, elastic);
    next->friction_ratio = force / elastic;
    next->tangential_force = vec3_scale(next->slip_direction, force);
}

/* Transverse force by the linearisation of a sleeve that tears. */
static vec3 linearised_tearing_force(const contact_constraint *constraint, vec3 elastic)
{
    const contact_solution *solution = &constraint->solution;
    const vec3 direction = solution->slip_direction;
    double elastic_along = vec3_dot(elastic, direction);
    vec3 across = vec3_add_scaled(elastic, -elastic_along, direction);
    return vec3_add_scaled(vec3_scale(across, solution->friction_ratio),
                           tearing_force(constraint, solution, elastic_along), direction);
}

static bool is_lagged(const contact_constraint *constraint)
{
    return constraint->lagged_transverse > 0.0;
}

/* Force by the linearisation: with the status and the transverse direction of the present
 * solution. */
static sleeve_force linearised_sleeve_force(const contact_constraint *constraint, vec3 u)
{
    vec3 displacement = vec3_add(constraint->relative_displacement, u);
    sleeve_force f = {
        vec3_scale(tangential_component(displacement, constraint->normal), -constraint->stiffness),
        elastic_axial_force(constraint, displacement)};
    if (is_tearing(&constraint->solution)) {
        f.transverse = linearised_tearing_force(constraint, f.transverse);
    }
    if (constraint->solution.status == CONTACT_SLIP) {
        double transverse_force = is_lagged(constraint)
                                      ? constraint->lagged_transverse
                                      : vec3_dot(f.transverse, constraint->solution.slip_direction);
        f.axial = viscoplastic_force(
            constraint, f.axial,
            axial_yield_limit(constraint, constraint->solution.is_forward, transverse_force));
    }
    return f;
}

static void update_sleeve(const contact_constraint *constraint, vec3 u, contact_solution *next)
{
    vec3 displacement = vec3_add(constraint->relative_displacement, u);
    vec3 transverse =
        vec3_scale(tangential_component(displacement, constraint->normal), -constraint->stiffness);
    double elastic = elastic_axial_force(constraint, displacement),
           transverse_force = vec3_norm(transverse);
    *next = (contact_solution){.status = CONTACT_STICK,
                               .normal_force = elastic,
                               .tangential_force = transverse,
                               .slip_direction =
                                   vec3_unit_or(transverse, vec3_any_normal(constraint->normal))};
    update_tear(constraint, transverse_force, next);
    if (is_tearing(next)) {
        transverse_force *= next->friction_ratio;
    }
    double lower_limit = axial_yield_limit(constraint, false, transverse_force),
           upper_limit = axial_yield_limit(constraint, true, transverse_force);
    bool is_forward = elastic > upper_limit;
    next->is_forward = is_forward;
    if (is_forward || elastic < lower_limit) {
        next->status = CONTACT_SLIP;
        next->normal_force =
            viscoplastic_force(constraint, elastic, is_forward ? upper_limit : lower_limit);
    }
}

static double sleeve_residual(const contact_constraint *constraint, vec3 u,
                              const contact_solution *next)
{
    const sleeve_force linearised = linearised_sleeve_force(constraint, u);
    double residual = fabs(next->normal_force - linearised.axial);
    bool is_same_status = next->status == constraint->solution.status;
    if (is_tearing(next) || is_tearing(&constraint->solution)) {
        residual += vec3_distance(next->tangential_force, linearised.transverse);
        is_same_status = is_same_status && is_tearing(next) == is_tearing(&constraint->solution) &&
                         next->is_tear_capped == constraint->solution.is_tear_capped;
    }
    double size = vec3_norm(next->tangential_force) + fabs(next->normal_force);
    return is_same_status && residual <= CONTACT_SLEEVE_TOLERANCE * size ? 0.0 : residual;
}

static vec3 total_sleeve_force(const contact_constraint *constraint, sleeve_force f)
{
    return vec3_add_scaled(f.transverse, f.axial, constraint->normal);
}

static void linearise_sleeve(const contact_constraint *constraint, contact_linearisation *t)
{
    const double k = constraint->stiffness,
                 yielding = constraint->viscous_stiffness * k / (constraint->viscous_stiffness + k);
    const contact_solution *solution = &constraint->solution;
    vec3 direction = solution->status == CONTACT_SLIP || is_tearing(solution)
                         ? solution->slip_direction
                         : vec3_any_normal(constraint->normal);
    t->count = 3;
    t->left[0] = t->right[0] = constraint->normal;
    t->left[1] = t->right[1] = direction;
    t->left[2] = t->right[2] = vec3_cross(constraint->normal, direction);
    t->stiffness[0] = t->stiffness[1] = t->stiffness[2] = k;
    if (constraint->solution.status == CONTACT_SLIP) {
        bool is_forward = constraint->solution.is_forward;
        double friction =
            is_forward ? constraint->yield_friction[1] : -constraint->yield_friction[0];
        t->stiffness[0] = yielding;
        if (!is_lagged(constraint)) {
            t->left[1] = vec3_add_scaled(
                direction, friction * k / (constraint->viscous_stiffness + k), constraint->normal);
        }
    }
    if (is_tearing(solution)) {
        t->stiffness[1] = solution->is_tear_capped ? k : yielding;
        t->stiffness[2] = solution->friction_ratio * k;
    }
    t->force = total_sleeve_force(constraint, linearised_sleeve_force(constraint, vec3_zero()));
}

vec3 vbss_contact_tear_slip(const contact_constraint *constraint)
{
    contact_solution solution;
    update_sleeve(constraint, vec3_zero(), &solution);
    double stretch =
        vec3_norm(tangential_component(constraint->relative_displacement, constraint->normal));
    double slip = (1.0 - solution.friction_ratio) * stretch;
    /* The force draws the suture back. */
    return is_tearing(&solution) ? vec3_scale(solution.slip_direction, -slip) : vec3_zero();
}

/* ---- contacts and ties */

void vbss_contact_linearise(const contact_constraint *constraint, contact_linearisation *t)
{
    const vec3 n = constraint->normal;
    const double k = constraint->stiffness, normal_force = -k * constraint->gap;
    if (constraint->is_sleeve) {
        linearise_sleeve(constraint, t);
        return;
    }
    t->count = 0;
    t->force = vec3_zero();
    if (constraint->solution.status == CONTACT_OPEN) {
        return;
    }
    t->count = 1;
    t->left[0] = t->right[0] = n;
    t->stiffness[0] = k;
    t->force = vec3_scale(n, normal_force);
    if (!acts_tangentially(constraint)) {
        return;
    }
    vec3 tangential_displacement = tangential_component(constraint->relative_displacement, n);
    if (constraint->solution.status == CONTACT_STICK) {
        t->count = 3;
        t->left[1] = t->right[1] = vec3_any_normal(n);
        t->left[2] = t->right[2] = vec3_cross(n, t->left[1]);
        t->stiffness[1] = t->stiffness[2] = contact_tangential_stiffness(constraint);
        t->force = vec3_add(t->force, vec3_add_scaled(constraint->previous_force,
                                                      -contact_tangential_stiffness(constraint),
                                                      tangential_displacement));
        return;
    }
    vec3 across = vec3_cross(n, constraint->solution.slip_direction);
    double kappa = stiffness_across_slip(constraint);
    t->count = 2;
    t->left[0] = vec3_add_scaled(n, constraint->friction, constraint->solution.slip_direction);
    t->left[1] = t->right[1] = across;
    t->stiffness[1] = kappa;
    t->force = vec3_add_scaled(t->force, constraint->friction * normal_force,
                               constraint->solution.slip_direction);
    double across_displacement =
        vec3_dot(across, tangential_displacement) -
        vec3_dot(across, constraint->previous_force) / contact_tangential_stiffness(constraint);
    t->force = vec3_add_scaled(t->force, -kappa * across_displacement, across);
}

/* Tangential force by the linearisation after u, and the slip that belongs to it. */
static vec3 linearised_tangential_force(const contact_constraint *constraint,
                                        vec3 tangential_displacement, double normal_force,
                                        vec3 *slip)
{
    const double k = contact_tangential_stiffness(constraint);
    if (constraint->solution.status == CONTACT_STICK) {
        *slip = vec3_zero();
        return vec3_add_scaled(constraint->previous_force, -k, tangential_displacement);
    }
    vec3 across = vec3_cross(constraint->normal, constraint->solution.slip_direction);
    double across_displacement = vec3_dot(across, tangential_displacement) -
                                 vec3_dot(across, constraint->previous_force) / k;
    vec3 tangential_force =
        vec3_scale(constraint->solution.slip_direction, constraint->friction * normal_force);
    tangential_force = vec3_add_scaled(
        tangential_force, -stiffness_across_slip(constraint) * across_displacement, across);
    *slip = vec3_add_scaled(tangential_displacement, 1.0 / k,
                            vec3_sub(tangential_force, constraint->previous_force));
    return tangential_force;
}

static void set_slipping(const contact_constraint *constraint, vec3 direction, double augmented,
                         contact_solution *next)
{
    double friction_ratio = constraint->friction * next->normal_force / augmented;
    next->status = CONTACT_SLIP;
    next->slip_direction = direction;
    next->friction_ratio =
        friction_ratio < CONTACT_MAX_FRICTION_RATIO ? friction_ratio : CONTACT_MAX_FRICTION_RATIO;
}

/* Solution of a constraint that was open and is now closed. */
static void close_contact(const contact_constraint *constraint, vec3 tangential_displacement,
                          contact_solution *next)
{
    double slip_distance = vec3_norm(tangential_displacement);
    next->status = CONTACT_STICK;
    if (constraint->friction > 0.0 && slip_distance > CONTACT_MIN_SLIP_ON_CLOSING) {
        vec3 direction = vec3_scale(tangential_displacement, -1.0 / slip_distance);
        double max_friction = constraint->friction * next->normal_force;
        set_slipping(constraint, direction, max_friction + constraint->augmentation * slip_distance,
                     next);
        next->friction_ratio = vbss_min(next->friction_ratio, CONTACT_FIRST_FRICTION_RATIO);
        next->tangential_force = vec3_scale(direction, max_friction);
    }
}

double vbss_contact_update_solution(const contact_constraint *constraint, vec3 u,
                                    contact_solution *next)
{
    if (constraint->is_sleeve) {
        update_sleeve(constraint, u, next);
        return sleeve_residual(constraint, u, next);
    }
    double normal_force =
        -constraint->stiffness * (constraint->gap + vec3_dot(constraint->normal, u));
    *next = (contact_solution){.status = CONTACT_OPEN};
    vec3 tangential_displacement = tangential_component(
             vec3_add(constraint->relative_displacement, u), constraint->normal),
         slip;
    if (!constraint->is_bilateral && !(normal_force > 0.0)) {
        if (constraint->solution.status == CONTACT_OPEN) {
            return 0.0;
        }
        /* The whole linearised force violates the law, since a small normal force may come with a
         * large friction force. */
        vec3 tangential_force = constraint->friction > 0.0
                                    ? linearised_tangential_force(
                                          constraint, tangential_displacement, normal_force, &slip)
                                    : vec3_zero();
        return vec3_norm(vec3_add_scaled(tangential_force, normal_force, constraint->normal));
    }
    next->normal_force = normal_force;
    if (constraint->solution.status == CONTACT_OPEN) {
        close_contact(constraint, tangential_displacement, next);
        return normal_force;
    }
    next->status = CONTACT_STICK;
    if (!acts_tangentially(constraint)) {
        return 0.0;
    }
    next->tangential_force =
        linearised_tangential_force(constraint, tangential_displacement, normal_force, &slip);
    if (constraint->is_bilateral) {
        return 0.0;
    }
    vec3 augmented = vec3_add_scaled(next->tangential_force, -constraint->augmentation, slip);
    double size = vec3_norm(augmented), max_friction = constraint->friction * normal_force;
    if (size <= max_friction) {
        return vec3_distance(next->tangential_force, augmented);
    }
    vec3 direction = vec3_scale(augmented, 1.0 / size);
    set_slipping(constraint, direction, size, next);
    return vec3_distance(next->tangential_force, vec3_scale(direction, max_friction));
}

/* ---- forces and solution at an iterate */

vec3 vbss_contact_linearised_force(const contact_constraint *constraint, vec3 u)
{
    const vec3 n = constraint->normal;
    if (constraint->is_sleeve) {
        return total_sleeve_force(constraint, linearised_sleeve_force(constraint, u));
    }
    double normal_force = -constraint->stiffness * (constraint->gap + vec3_dot(n, u));
    if (constraint->solution.status == CONTACT_OPEN) {
        return vec3_zero();
    }
    if (!acts_tangentially(constraint)) {
        return vec3_scale(n, normal_force);
    }
    vec3 slip, tangential_displacement =
                   tangential_component(vec3_add(constraint->relative_displacement, u), n);
    return vec3_add_scaled(
        linearised_tangential_force(constraint, tangential_displacement, normal_force, &slip),
        normal_force, n);
}

/* Elastic trial force, then projection to the friction cone. */
vec3 vbss_contact_force(const contact_constraint *constraint, vec3 u)
{
    const vec3 n = constraint->normal;
    if (constraint->is_sleeve) {
        contact_solution solution;
        update_sleeve(constraint, u, &solution);
        return vec3_add_scaled(solution.tangential_force, solution.normal_force, n);
    }
    double normal_force = -constraint->stiffness * (constraint->gap + vec3_dot(n, u));
    if (!constraint->is_bilateral && !(normal_force > 0.0)) {
        return vec3_zero();
    }
    if (!acts_tangentially(constraint)) {
        return vec3_scale(n, normal_force);
    }
    vec3 tangential_displacement =
        tangential_component(vec3_add(constraint->relative_displacement, u), n);
    vec3 tangential_force =
        vec3_add_scaled(constraint->previous_force, -contact_tangential_stiffness(constraint),
                        tangential_displacement);
    double size = vec3_norm(tangential_force), max_friction = constraint->friction * normal_force;
    if (!constraint->is_bilateral && size > max_friction) {
        tangential_force = vec3_scale(tangential_force, max_friction / size);
    }
    return vec3_add_scaled(tangential_force, normal_force, n);
}

/* u decides whether the constraint is closed. As after a complete solve, the equilibrium force
 * decides whether it slips. */
void vbss_contact_solution_at(const contact_constraint *constraint, const contact_iterate *iterate,
                              contact_solution *next)
{
    const vec3 n = constraint->normal;
    double normal_force = -constraint->stiffness * (constraint->gap + vec3_dot(n, iterate->u));
    double balancing_force = vec3_dot(n, iterate->force);
    if (constraint->is_sleeve) {
        update_sleeve(constraint, iterate->u, next);
        return;
    }
    *next = (contact_solution){.status = constraint->is_bilateral ? CONTACT_STICK : CONTACT_OPEN};
    if (constraint->is_bilateral || !(normal_force > 0.0)) {
        return;
    }
    vec3 tangential_displacement =
        tangential_component(vec3_add(constraint->relative_displacement, iterate->u), n);
    if (!(balancing_force > 0.0)) {
        next->normal_force = normal_force;
        close_contact(constraint, tangential_displacement, next);
        return;
    }
    next->status = CONTACT_STICK;
    next->normal_force = balancing_force;
    if (constraint->friction == 0.0) {
        return;
    }
    next->tangential_force = tangential_component(iterate->force, n);
    const vec3 elastic_slip =
        vec3_scale(vec3_sub(next->tangential_force, constraint->previous_force),
                   1.0 / contact_tangential_stiffness(constraint));
    vec3 slip = vec3_add(tangential_displacement, elastic_slip);
    vec3 augmented = vec3_add_scaled(next->tangential_force, -constraint->augmentation, slip);
    double size = vec3_norm(augmented);
    if (size > constraint->friction * balancing_force) {
        set_slipping(constraint, vec3_scale(augmented, 1.0 / size), size, next);
    }
}
