/* The law of a row: unilateral contact with Coulomb friction, both with a stiffness; of what ties, and of what slides
 * in a sleeve.
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
    double r = row->augmentation, k = contact_stiffness_along(row);
    /* 1 / ((1 - share) / (share r) + 1 / k) */
    return row->is.share * r * k / ((1.0 - row->is.share) * k + row->is.share * r);
}

/* ---- sleeves: what is held across slides along, with friction that grows with what is held
 *
 * Along the normal, tangent of what is in the sleeve, the force is that of a spring up to
 *   most = least + grip |across|,    grip for either way of sliding,
 * beyond which a damper in series with the spring yields: f = most + c v at any speed and any step (Perzyna 1966). */

/* A direction of the force across that is off by so little changes it by its square. */
#define SLEEVE_EXACT 1e-4

typedef struct sleeve_force {
    vec3 across;
    double along;
} sleeve_force;

static double elastic_force(const contact_row *row, vec3 slid)
{
    return vec3_dot(row->held, row->normal) - row->stiffness * vec3_dot(slid, row->normal);
}

/* Beyond which it slides: `forward`, that force is along the normal; `pressed` is what is held across. */
static double most_along(const contact_row *row, bool forward, double pressed)
{
    double most = row->least + row->grip[forward] * pressed;
    return forward ? most : -most;
}

static double yielding_force(const contact_row *row, double elastic, double most)
{
    return (row->beyond * elastic + row->stiffness * most) / (row->beyond + row->stiffness);
}

/* In the state and with the direction across that the row has. */
static sleeve_force linear_sleeve(const contact_row *row, vec3 u)
{
    vec3 slid = vec3_add(row->slid, u);
    sleeve_force f = {vec3_scale(along_plane(slid, row->normal), -row->stiffness),
                      elastic_force(row, slid)};
    if (row->is.state == CONTACT_SLIP) {
        double pressed = vec3_dot(f.across, row->is.way);
        f.along = yielding_force(row, f.along, most_along(row, row->is.share > 0.5, pressed));
    }
    return f;
}

static void next_sleeve(const contact_row *row, vec3 u, contact_found *next)
{
    vec3 slid = vec3_add(row->slid, u);
    vec3 across = vec3_scale(along_plane(slid, row->normal), -row->stiffness);
    double elastic = elastic_force(row, slid), pressed = vec3_norm(across);
    double least = most_along(row, false, pressed), most = most_along(row, true, pressed);
    bool forward = elastic > most;
    *next = (contact_found){.state = CONTACT_STICK,
                            .pressure = elastic,
                            .rubbing = across,
                            .way = vec3_unit_or(across, vec3_any_normal(row->normal)),
                            .share = forward ? 1.0 : 0.0};
    if (forward || elastic < least) {
        next->state = CONTACT_SLIP;
        next->pressure = yielding_force(row, elastic, forward ? most : least);
    }
}

static double sleeve_missed(const contact_row *row, vec3 u, const contact_found *next)
{
    double missed = fabs(next->pressure - linear_sleeve(row, u).along);
    bool same = next->state == row->is.state;
    double size = vec3_norm(next->rubbing) + fabs(next->pressure);
    return same && missed <= SLEEVE_EXACT * size ? 0.0 : missed;
}

static vec3 sum_of(const contact_row *row, sleeve_force f)
{
    return vec3_add_scaled(f.across, f.along, row->normal);
}

static void linear_sleeve_law(const contact_row *row, contact_tangent *t)
{
    const double k = row->stiffness;
    vec3 way = row->is.state == CONTACT_SLIP ? row->is.way : vec3_any_normal(row->normal);
    t->count = 3;
    t->left[0] = t->right[0] = row->normal;
    t->left[1] = t->right[1] = way;
    t->left[2] = t->right[2] = vec3_cross(row->normal, way);
    t->stiffness[0] = t->stiffness[1] = t->stiffness[2] = k;
    if (row->is.state == CONTACT_SLIP) {
        bool forward = row->is.share > 0.5;
        double grip = forward ? row->grip[1] : -row->grip[0];
        t->stiffness[0] = row->beyond * k / (row->beyond + k);
        t->left[1] = vec3_add_scaled(way, grip * k / (row->beyond + k), row->normal);
    }
    t->force = sum_of(row, linear_sleeve(row, vec3_zero()));
}

/* ---- the others */

void vbss_contact_linear_law(const contact_row *row, contact_tangent *t)
{
    const vec3 n = row->normal;
    const double k = row->stiffness, pressure = -k * row->gap;
    if (row->sleeve) {
        linear_sleeve_law(row, t);
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
        t->stiffness[1] = t->stiffness[2] = contact_stiffness_along(row);
        t->force =
            vec3_add(t->force, vec3_add_scaled(row->held, -contact_stiffness_along(row), slid));
        return;
    }
    vec3 across = vec3_cross(n, row->is.way);
    double kappa = stiffness_across(row);
    t->count = 2;
    t->left[0] = vec3_add_scaled(n, row->friction, row->is.way);
    t->left[1] = t->right[1] = across;
    t->stiffness[1] = kappa;
    t->force = vec3_add_scaled(t->force, row->friction * pressure, row->is.way);
    double back =
        vec3_dot(across, slid) - vec3_dot(across, row->held) / contact_stiffness_along(row);
    t->force = vec3_add_scaled(t->force, -kappa * back, across);
}

/* The tangential force by the linear law after u, and the slip that belongs to it. */
static vec3 rubbing_after(const contact_row *row, vec3 moved, double pressure, vec3 *slip)
{
    const double k = contact_stiffness_along(row);
    if (row->is.state == CONTACT_STICK) {
        *slip = vec3_zero();
        return vec3_add_scaled(row->held, -k, moved);
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
        next->share = vbss_min(next->share, LARGEST_FIRST_SHARE);
        next->rubbing = vec3_scale(back, most);
    }
}

double vbss_contact_next_state(const contact_row *row, vec3 u, contact_found *next)
{
    if (row->sleeve) {
        next_sleeve(row, u, next);
        return sleeve_missed(row, u, next);
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
    if (row->sleeve) {
        return sum_of(row, linear_sleeve(row, u));
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
    if (row->sleeve) {
        contact_found is;
        next_sleeve(row, u, &is);
        return vec3_add_scaled(is.rubbing, is.pressure, n);
    }
    double pressure = -row->stiffness * (row->gap + vec3_dot(n, u));
    if (!row->bilateral && !(pressure > 0.0)) {
        return vec3_zero();
    }
    if (row->friction == 0.0) {
        return vec3_scale(n, pressure);
    }
    vec3 moved = along_plane(vec3_add(row->slid, u), n);
    vec3 rubbing = vec3_add_scaled(row->held, -contact_stiffness_along(row), moved);
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
    if (row->sleeve) {
        next_sleeve(row, at->u, next);
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
    const vec3 strained =
        vec3_scale(vec3_sub(next->rubbing, row->held), 1.0 / contact_stiffness_along(row));
    vec3 slip = vec3_add(moved, strained);
    vec3 augmented = vec3_add_scaled(next->rubbing, -row->augmentation, slip);
    double size = vec3_norm(augmented);
    if (size > row->friction * pressed) {
        slip_along(row, vec3_scale(augmented, 1.0 / size), size, next);
    }
}
