/* Mass, centre of mass and principal axes of solid capsules, and of thin triangles. */
#include "base/pi.h"
#include "solver/rigid.h"

/* ---- one capsule: a cylinder, and two hemispheres that together are a ball */

typedef struct capsule_mass {
    double mass;
    vec3 centre, axis;
    /* moments about the axis, and about any normal to it through the centre */
    double axial, transverse;
} capsule_mass;

static capsule_mass mass_of(const vbss_rigid_capsule *c)
{
    vec3 axis_vector = vec3_sub(c->b, c->a);
    double r = c->radius, l = vec3_norm(axis_vector), r2 = r * r, l2 = l * l;
    double cylinder = c->density * VBSS_PI * r2 * l,
           ball = c->density * VBSS_PI * (4.0 / 3.0) * r2 * r;
    capsule_mass m;
    m.mass = cylinder + ball;
    m.centre = vec3_lerp(c->a, c->b, 0.5);
    m.axis = vec3_unit_or(axis_vector, vec3_make(1.0, 0.0, 0.0));
    m.axial = r2 * (0.5 * cylinder + 0.4 * ball);
    /* The centre of mass of a hemisphere is 3/8 r from its flat side. */
    m.transverse =
        cylinder * (l2 / 12.0 + 0.25 * r2) + ball * (0.4 * r2 + 0.25 * l2 + 0.375 * r * l);
    return m;
}

/* s (|v|^2 - v v^T): the inertia of a mass s at v, or the difference s between transverse and axial
 * moments along the unit vector v. */
static mat3 offset_inertia(vec3 v, double s)
{
    double square = s * vec3_norm_squared(v);
    return mat3_add_scaled(mat3_diagonal(square, square, square), -s, mat3_outer(v, v));
}

/* Inertia about a point, in the frame of the capsules. */
static mat3 inertia_about(const capsule_mass *m, vec3 about)
{
    mat3 inertia = mat3_diagonal(m->axial, m->axial, m->axial);
    inertia = mat3_add(inertia, offset_inertia(m->axis, m->transverse - m->axial));
    return mat3_add(inertia, offset_inertia(vec3_sub(m->centre, about), m->mass));
}

/* ---- principal axes */

static mat3 inertia_in_axes(mat3 inertia, quat axes)
{
    mat3 r = quat_to_mat3(axes);
    return mat3_mul(mat3_transpose(r), mat3_mul(inertia, r));
}

/* Jacobi rotation about `axis` that removes the product of inertia of the other two axes. */
static quat jacobi_rotate(mat3 inertia, quat axes, int axis)
{
    int i = (axis + 1) % 3, j = (axis + 2) % 3;
    mat3 rotated = inertia_in_axes(inertia, axes);
    double product = 0.5 * (rotated.m[i][j] + rotated.m[j][i]);
    if (product == 0.0) {
        return axes;
    }
    double cotangent =
        (rotated.m[j][j] - rotated.m[i][i]) / (2.0 * product); /* cotangent of twice the angle */
    double tangent =
        copysign(1.0, cotangent) / (fabs(cotangent) + sqrt(1.0 + cotangent * cotangent));
    double cosine = 1.0 / sqrt(1.0 + tangent * tangent), half = sqrt(0.5 * (1.0 + cosine));
    double sine = -0.5 * tangent * cosine / half; /* sine of half the angle */
    return quat_mul(axes, quat_make(half, axis == 0 ? sine : 0.0, axis == 1 ? sine : 0.0,
                                    axis == 2 ? sine : 0.0));
}

/* Convergence is quadratic: four sweeps suffice from any start, and two more cost little here.
 * Their number is fixed so that the bits do not depend on a threshold. */
static quat principal_axes(mat3 inertia)
{
    quat axes = quat_identity();
    for (int sweep = 0; sweep < 6; sweep++) {
        for (int axis = 2; axis >= 0; axis--) {
            axes = jacobi_rotate(inertia, axes, axis);
        }
        axes = quat_unit(axes);
    }
    return axes;
}

/* Returns false and sets nothing unless all moments are positive and finite. */
static bool set_mass(double sum, vec3 centre, mat3 inertia, vbss_rigid_mass *mass)
{
    quat axes = principal_axes(inertia);
    mat3 rotated = inertia_in_axes(inertia, axes);
    vec3 moments = vec3_make(rotated.m[0][0], rotated.m[1][1], rotated.m[2][2]);
    bool is_valid = moments.x >= DBL_MIN && moments.y >= DBL_MIN && moments.z >= DBL_MIN;
    if (!(is_valid && vec3_is_finite(moments) && vec3_is_finite(centre))) {
        return false;
    }
    mass->mass = sum;
    mass->inertia = moments;
    mass->frame = pose_make(centre, axes);
    return true;
}

/* ---- all capsules */

bool vbss_rigid_mass_of_capsules(const vbss_rigid_capsule *capsules, uint32_t count,
                                 vbss_rigid_mass *mass)
{
    double sum = 0.0;
    vec3 moment = vec3_zero();
    for (uint32_t i = 0; i < count; i++) {
        capsule_mass m = mass_of(&capsules[i]);
        sum += m.mass;
        /* Relative to the first end: far from the origin, digits would be lost. */
        moment = vec3_add_scaled(moment, m.mass, vec3_sub(m.centre, capsules[0].a));
    }
    if (!(sum >= DBL_MIN && sum <= DBL_MAX)) {
        return false;
    }
    vec3 centre = vec3_add_scaled(capsules[0].a, 1.0 / sum, moment);
    mat3 inertia = mat3_zero();
    for (uint32_t i = 0; i < count; i++) {
        capsule_mass m = mass_of(&capsules[i]);
        inertia = mat3_add(inertia, inertia_about(&m, centre));
    }
    return set_mass(sum, centre, inertia, mass);
}

/* ---- thin triangles */

static vec3 corner_of(const vbss_rigid_triangles *t, uint32_t triangle, int k)
{
    return vec3_load(t->vertices + 3 * (size_t)t->triangles[3 * (size_t)triangle + (size_t)k]);
}

/* Twice the area. */
static double area_of(const vec3 corners[3])
{
    return vec3_norm(
        vec3_cross(vec3_sub(corners[1], corners[0]), vec3_sub(corners[2], corners[0])));
}

/* The corners of a triangle relative to a point. Returns twice its area. */
static double get_corners(const vbss_rigid_triangles *t, uint32_t triangle, vec3 about,
                          vec3 corners[3])
{
    for (int k = 0; k < 3; k++) {
        corners[k] = vec3_sub(corner_of(t, triangle, k), about);
    }
    return area_of(corners);
}

bool vbss_rigid_mass_of_triangles(const vbss_rigid_triangles *t, double mass_sum,
                                  vbss_rigid_mass *mass)
{
    const vec3 first = corner_of(t, 0, 0);
    double sum = 0.0;
    vec3 moment = vec3_zero(), corners[3];
    for (uint32_t i = 0; i < t->count; i++) {
        const double area = get_corners(t, i, first, corners);
        sum += area;
        moment = vec3_add_scaled(moment, area / 3.0,
                                 vec3_add(corners[0], vec3_add(corners[1], corners[2])));
    }
    if (!(sum >= DBL_MIN && sum <= DBL_MAX)) {
        return false;
    }
    const vec3 centre = vec3_add_scaled(first, 1.0 / sum, moment);
    mat3 inertia = mat3_zero();
    for (uint32_t i = 0; i < t->count; i++) {
        /* The middles of the sides with a third of the mass each have the moments of the triangle. */
        const double third = mass_sum * (get_corners(t, i, centre, corners) / sum) / 3.0;
        for (int k = 0; k < 3; k++) {
            const vec3 middle = vec3_lerp(corners[k], corners[(k + 1) % 3], 0.5);
            inertia = mat3_add(inertia, offset_inertia(middle, third));
        }
    }
    return set_mass(mass_sum, centre, inertia, mass);
}
