/* The law of a row: unilateral contact with Coulomb friction, both with a stiffness.
 *
 * Normal: pressure = -stiffness gap, if that presses. Tangential: the slip
 *   v = (slid + u)_t + (rubbing - held) / stiffness
 * is what the motion since the begin of the part leaves when the elastic part is taken off; rubbing lies in
 * the disk of radius friction pressure, and is the projection of rubbing - r v to it (Alart, Curnier
 * 1991). Sticking is v = 0; slipping is linearised exactly, which makes the stiffness unsymmetric. */
#include "contact/contact.h"

/* A row that slips with all of its augmented force would have no stiffness across. */
#define LARGEST_SHARE 0.999
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
    return row->share * r * k / ((1.0 - row->share) * k + row->share * r);
}

void vbss_contact_linear_law(const contact_row *row, contact_tangent *t)
{
    const vec3 n = row->normal;
    const double k = row->stiffness, pressure = -k * row->gap;
    t->count = 0;
    t->force = vec3_zero();
    if (row->state == CONTACT_OPEN) {
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
    if (row->state == CONTACT_STICK) {
        t->count = 3;
        t->left[1] = t->right[1] = vec3_any_normal(n);
        t->left[2] = t->right[2] = vec3_cross(n, t->left[1]);
        t->stiffness[1] = t->stiffness[2] = k;
        t->force = vec3_add(t->force, vec3_add_scaled(row->held, -k, slid));
        return;
    }
    vec3 across = vec3_cross(n, row->way);
    double kappa = stiffness_across(row);
    t->count = 2;
    t->left[0] = vec3_add_scaled(n, row->friction, row->way);
    t->left[1] = t->right[1] = across;
    t->stiffness[1] = kappa;
    t->force = vec3_add_scaled(t->force, row->friction * pressure, row->way);
    double back = vec3_dot(across, slid) - vec3_dot(across, row->held) / k;
    t->force = vec3_add_scaled(t->force, -kappa * back, across);
}

/* The tangential force by the linear law after u, and the slip that belongs to it. */
static vec3 rubbing_after(const contact_row *row, vec3 moved, double pressure, vec3 *slip)
{
    const double k = row->stiffness;
    vec3 rubbing;
    if (row->state == CONTACT_STICK) {
        *slip = vec3_zero();
        return vec3_add_scaled(row->held, -k, moved);
    }
    vec3 across = vec3_cross(row->normal, row->way);
    double back = vec3_dot(across, moved) - vec3_dot(across, row->held) / k;
    rubbing = vec3_scale(row->way, row->friction * pressure);
    rubbing = vec3_add_scaled(rubbing, -stiffness_across(row) * back, across);
    *slip = vec3_add_scaled(moved, 1.0 / k, vec3_sub(rubbing, row->held));
    return rubbing;
}

static void begin_to_slip(contact_row *row, vec3 way, double augmented)
{
    double share = row->friction * row->pressure / augmented;
    row->state = CONTACT_SLIP;
    row->way = way;
    row->share = share < LARGEST_SHARE ? share : LARGEST_SHARE;
}

/* It was open, and is closed now. */
static void close_row(contact_row *row, vec3 moved)
{
    double way = vec3_norm(moved);
    row->state = CONTACT_STICK;
    row->rubbing = vec3_zero();
    if (row->friction > 0.0 && way > STARTS_TO_SLIP) {
        vec3 back = vec3_scale(moved, -1.0 / way);
        begin_to_slip(row, back, row->friction * row->pressure + row->augmentation * way);
        row->rubbing = vec3_scale(back, row->friction * row->pressure);
    }
}

bool vbss_contact_next_state(contact_row *row, vec3 u, double *residual)
{
    const contact_state used = row->state;
    double pressure = -row->stiffness * (row->gap + vec3_dot(row->normal, u));
    *residual = 0.0;
    if (!row->bilateral && !(pressure > 0.0)) {
        row->state = CONTACT_OPEN;
        row->pressure = 0.0;
        row->rubbing = vec3_zero();
        *residual = used == CONTACT_OPEN ? 0.0 : -pressure;
        return used == CONTACT_OPEN;
    }
    row->pressure = pressure;
    vec3 moved = along_plane(vec3_add(row->slid, u), row->normal);
    if (row->bilateral) {
        row->state = CONTACT_STICK;
        row->rubbing =
            row->friction > 0.0 ? vec3_add_scaled(row->held, -row->stiffness, moved) : vec3_zero();
        return used == CONTACT_STICK;
    }
    if (used == CONTACT_OPEN) {
        *residual = pressure;
        close_row(row, moved);
        return false;
    }
    if (row->friction == 0.0) {
        row->rubbing = vec3_zero();
        return true;
    }
    vec3 slip, rubbing = rubbing_after(row, moved, pressure, &slip);
    vec3 augmented = vec3_add_scaled(rubbing, -row->augmentation, slip);
    double size = vec3_norm(augmented), most = row->friction * fabs(pressure);
    vec3 allowed = augmented;
    row->rubbing = rubbing;
    row->state = CONTACT_STICK;
    if (size > most) {
        vec3 way = vec3_scale(augmented, 1.0 / size);
        allowed = vec3_scale(way, most);
        begin_to_slip(row, way, size);
    }
    *residual = vec3_distance(rubbing, allowed);
    return row->state == used;
}
