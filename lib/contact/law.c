/* The law of a row: unilateral contact with Coulomb friction, both with a stiffness; of what ties, and of what ties up to a
 * bound.
 *
 * Normal: pressure = -stiffness gap, if that presses. Tangential: the slip
 *   v = (slid + u)_t + (rubbing - held) / stiffness
 * is what the motion since the begin of the part leaves when the elastic part is taken off; rubbing lies in
 * the disk of radius friction pressure, and is the projection of rubbing - r v to it (Alart, Curnier
 * 1991). Sticking is v = 0; slipping is linearised exactly, which makes the stiffness unsymmetric. */
#include "contact/contact.h"

/* A row that slips with all of its augmented force sticks across. */
#define LARGEST_SHARE 0.999999
/* The way of a row that has just closed is a guess, which it shall be able to leave. */
#define LARGEST_FIRST_SHARE 0.9
/* A row that has just closed rubs against its motion if that is larger than this, m; else it sticks. */
#define STARTS_TO_SLIP 1e-7

static vec3 along_plane(vec3 v, vec3 normal)
{
    return vec3_add_scaled(v, -vec3_dot(v, normal), normal);
}

vec3 vbss_contact_turn_into_plane(vec3 force, vec3 normal)
{
    double before = vec3_norm_squared(force);
    vec3 in_plane = along_plane(force, normal);
    double after = vec3_norm_squared(in_plane);
    if (!(after > 1e-12 * before)) { /* it stood on the plane */
        return vec3_zero();
    }
    return vec3_scale(in_plane, sqrt(before / after));
}

/* SLIP: stiffness across the way. */
static double stiffness_across(const contact_row *row)
{
    double r = row->augmentation, k = row->stiffness;
    /* 1 / ((1 - share) / (share r) + 1 / k) */
    return row->is.share * r * k / ((1.0 - row->is.share) * k + row->is.share * r);
}

/* STICK */
static double stiffness_along(const contact_row *row)
{
    return row->bilateral && row->along > 0.0 ? row->along * row->stiffness : row->stiffness;
}

/* ---- rows with a bound: elastic up to it, viscous beyond; along the normal alone */

static double elastic_force(const contact_row *row, double slid)
{
    return vec3_dot(row->held, row->normal) - row->stiffness * slid;
}

/* Beyond the bound, from where it is reached on. */
static double yielding_force(const contact_row *row, double slid, bool forward)
{
    double most = forward ? row->bound : -row->bound;
    double reached = (vec3_dot(row->held, row->normal) - most) / row->stiffness;
    return most - row->beyond * (slid - reached);
}

static double bounded_force(const contact_row *row, vec3 u, const contact_found *is)
{
    double slid = vec3_dot(vec3_add(row->slid, u), row->normal);
    return is->state == CONTACT_SLIP ? yielding_force(row, slid, is->share > 0.5)
                                     : elastic_force(row, slid);
}

static void next_bounded(const contact_row *row, vec3 u, contact_found *next)
{
    double elastic = elastic_force(row, vec3_dot(vec3_add(row->slid, u), row->normal));
    bool sticks = fabs(elastic) <= row->bound;
    *next = (contact_found){.state = sticks ? CONTACT_STICK : CONTACT_SLIP,
                            .share = elastic > 0.0 ? 1.0 : 0.0};
    next->pressure = bounded_force(row, u, next);
}

static void linear_bounded_law(const contact_row *row, contact_tangent *t)
{
    t->count = 1;
    t->left[0] = t->right[0] = row->normal;
    t->stiffness[0] = row->is.state == CONTACT_SLIP ? row->beyond : row->stiffness;
    t->force = vec3_scale(row->normal, bounded_force(row, vec3_zero(), &row->is));
}

/* ---- the others */

void vbss_contact_linear_law(const contact_row *row, contact_tangent *t)
{
    const vec3 n = row->normal;
    const double k = row->stiffness, pressure = -k * row->gap;
    if (row->bound > 0.0) {
        linear_bounded_law(row, t);
        return;
    }
    t->count = 0;
    t->force = vec3_zero();
    if (row->is.state == CONTACT_OPEN) {
        return;
    }
    t->count = 1;
    t->left[0] = t->right[0] = n;
    t->stiffness[0] = k;
    t->force = vec3_scale(n, pressure);
    if (row->friction == 0.0) {
        return;
    }
    vec3 slid = along_plane(row->slid, n);
    if (row->is.state == CONTACT_STICK) {
        t->count = 3;
        t->left[1] = t->right[1] = vec3_any_normal(n);
        t->left[2] = t->right[2] = vec3_cross(n, t->left[1]);
        t->stiffness[1] = t->stiffness[2] = stiffness_along(row);
        t->force = vec3_add(t->force, vec3_add_scaled(row->held, -stiffness_along(row), slid));
        return;
    }
    vec3 across = vec3_cross(n, row->is.way);
    double kappa = stiffness_across(row);
    t->count = 2;
    t->left[0] = vec3_add_scaled(n, row->friction, row->is.way);
    t->left[1] = t->right[1] = across;
    t->stiffness[1] = kappa;
    t->force = vec3_add_scaled(t->force, row->friction * pressure, row->is.way);
    double back = vec3_dot(across, slid) - vec3_dot(across, row->held) / k;
    t->force = vec3_add_scaled(t->force, -kappa * back, across);
}

/* The tangential force by the linear law after u, and the slip that belongs to it. */
static vec3 rubbing_after(const contact_row *row, vec3 moved, double pressure, vec3 *slip)
{
    const double k = row->stiffness;
    if (row->is.state == CONTACT_STICK) {
        *slip = vec3_zero();
        return vec3_add_scaled(row->held, -stiffness_along(row), moved);
    }
    vec3 across = vec3_cross(row->normal, row->is.way);
    double back = vec3_dot(across, moved) - vec3_dot(across, row->held) / k;
    vec3 rubbing = vec3_scale(row->is.way, row->friction * pressure);
    rubbing = vec3_add_scaled(rubbing, -stiffness_across(row) * back, across);
    *slip = vec3_add_scaled(moved, 1.0 / k, vec3_sub(rubbing, row->held));
    return rubbing;
}

static void slip_along(const contact_row *row, vec3 way, double augmented, contact_found *next)
{
    double share = row->friction * next->pressure / augmented;
    next->state = CONTACT_SLIP;
    next->way = way;
    next->share = share < LARGEST_SHARE ? share : LARGEST_SHARE;
}

/* It was open, and is closed now. */
static void close_row(const contact_row *row, vec3 moved, contact_found *next)
{
    double way = vec3_norm(moved);
    next->state = CONTACT_STICK;
    if (row->friction > 0.0 && way > STARTS_TO_SLIP) {
        vec3 back = vec3_scale(moved, -1.0 / way);
        double most = row->friction * next->pressure;
        slip_along(row, back, most + row->augmentation * way, next);
        next->share = lesser(next->share, LARGEST_FIRST_SHARE);
        next->rubbing = vec3_scale(back, most);
    }
}

double vbss_contact_next_state(const contact_row *row, vec3 u, contact_found *next)
{
    if (row->bound > 0.0) {
        next_bounded(row, u, next);
        return fabs(next->pressure - bounded_force(row, u, &row->is));
    }
    double pressure = -row->stiffness * (row->gap + vec3_dot(row->normal, u));
    *next = (contact_found){.state = CONTACT_OPEN};
    vec3 moved = along_plane(vec3_add(row->slid, u), row->normal), slip;
    if (!row->bilateral && !(pressure > 0.0)) {
        if (row->is.state == CONTACT_OPEN) {
            return 0.0;
        }
        /* All that it was solved with is missed: little pressure may have gone with much rubbing. */
        vec3 rubbing =
            row->friction > 0.0 ? rubbing_after(row, moved, pressure, &slip) : vec3_zero();
        return vec3_norm(vec3_add_scaled(rubbing, pressure, row->normal));
    }
    next->pressure = pressure;
    if (row->is.state == CONTACT_OPEN) {
        close_row(row, moved, next);
        return pressure;
    }
    next->state = CONTACT_STICK;
    if (row->friction == 0.0) {
        return 0.0;
    }
    next->rubbing = rubbing_after(row, moved, pressure, &slip);
    if (row->bilateral) {
        return 0.0;
    }
    vec3 augmented = vec3_add_scaled(next->rubbing, -row->augmentation, slip);
    double size = vec3_norm(augmented), most = row->friction * pressure;
    if (size <= most) {
        return vec3_distance(next->rubbing, augmented);
    }
    vec3 way = vec3_scale(augmented, 1.0 / size);
    slip_along(row, way, size, next);
    return vec3_distance(next->rubbing, vec3_scale(way, most));
}

/* ---- where the search stands */

vec3 vbss_contact_linear_force(const contact_row *row, vec3 u)
{
    const vec3 n = row->normal;
    if (row->bound > 0.0) {
        return vec3_scale(n, bounded_force(row, u, &row->is));
    }
    double pressure = -row->stiffness * (row->gap + vec3_dot(n, u));
    if (row->is.state == CONTACT_OPEN) {
        return vec3_zero();
    }
    if (row->friction == 0.0) {
        return vec3_scale(n, pressure);
    }
    vec3 slip, moved = along_plane(vec3_add(row->slid, u), n);
    return vec3_add_scaled(rubbing_after(row, moved, pressure, &slip), pressure, n);
}

/* Elastic, then cut back to the cone. */
vec3 vbss_contact_force(const contact_row *row, vec3 u)
{
    const vec3 n = row->normal;
    if (row->bound > 0.0) {
        contact_found is;
        next_bounded(row, u, &is);
        return vec3_scale(n, is.pressure);
    }
    double pressure = -row->stiffness * (row->gap + vec3_dot(n, u));
    if (!row->bilateral && !(pressure > 0.0)) {
        return vec3_zero();
    }
    if (row->friction == 0.0) {
        return vec3_scale(n, pressure);
    }
    vec3 moved = along_plane(vec3_add(row->slid, u), n);
    vec3 rubbing = vec3_add_scaled(row->held, -row->stiffness, moved);
    double size = vec3_norm(rubbing), most = row->friction * pressure;
    if (!row->bilateral && size > most) {
        rubbing = vec3_scale(rubbing, most / size);
    }
    return vec3_add_scaled(rubbing, pressure, n);
}

/* Whether it is closed is said by u; whether it slips, by the force with which blocks balance, as after a
 * whole solve. */
void vbss_contact_state_at(const contact_row *row, const contact_stand *at, contact_found *next)
{
    const vec3 n = row->normal;
    double pressure = -row->stiffness * (row->gap + vec3_dot(n, at->u));
    double pressed = vec3_dot(n, at->force);
    if (row->bound > 0.0) {
        next_bounded(row, at->u, next);
        return;
    }
    *next = (contact_found){.state = row->bilateral ? CONTACT_STICK : CONTACT_OPEN};
    if (row->bilateral || !(pressure > 0.0)) {
        return;
    }
    vec3 moved = along_plane(vec3_add(row->slid, at->u), n);
    if (!(pressed > 0.0)) {
        next->pressure = pressure;
        close_row(row, moved, next);
        return;
    }
    next->state = CONTACT_STICK;
    next->pressure = pressed;
    if (row->friction == 0.0) {
        return;
    }
    next->rubbing = along_plane(at->force, n);
    vec3 slip = vec3_add_scaled(moved, 1.0 / row->stiffness, vec3_sub(next->rubbing, row->held));
    vec3 augmented = vec3_add_scaled(next->rubbing, -row->augmentation, slip);
    double size = vec3_norm(augmented);
    if (size > row->friction * pressed) {
        slip_along(row, vec3_scale(augmented, 1.0 / size), size, next);
    }
}
