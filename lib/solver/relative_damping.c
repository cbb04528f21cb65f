/* Damping that conserves linear and angular momentum: it reduces the motion of particles relative
 * to their best rigid motion (Mueller et al. 2007, as in VBLaST-SS). */
#include "solver/solver.h"
#include "solver/tuning.h"

/* The angular velocity w with inertia w = momentum, by elimination with the largest diagonal first.
 * The inertia is zero about an axis that contains all mass; the component there is set to zero. */
static vec3 rotation_rate(mat3 inertia, vec3 momentum)
{
    double a[3][4];
    double largest = 0.0;
    bool used[3] = {false, false, false};
    const double b[3] = {momentum.x, momentum.y, momentum.z};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a[i][j] = inertia.m[i][j];
        }
        a[i][3] = b[i];
        largest = a[i][i] > largest ? a[i][i] : largest;
    }
    for (int step = 0; step < 3; step++) {
        int p = -1;
        for (int i = 0; i < 3; i++) {
            p = !used[i] && (p < 0 || a[i][i] > a[p][p]) ? i : p;
        }
        used[p] = true;
        bool is_singular = !(a[p][p] > SOLVER_DAMPING_MIN_PIVOT_RATIO * largest);
        for (int j = 0; j < 4; j++) {
            a[p][j] = is_singular ? (j == p ? 1.0 : 0.0) : a[p][j];
        }
        double pivot = 1.0 / a[p][p];
        for (int j = 0; j < 4; j++) {
            a[p][j] *= pivot;
        }
        for (int i = 0; i < 3; i++) {
            double factor = i == p ? 0.0 : a[i][p];
            for (int j = 0; j < 4; j++) {
                a[i][j] -= factor * a[p][j];
            }
        }
    }
    return vec3_make(a[0][3], a[1][3], a[2][3]);
}

void vbss_damp_relative_motion(const double *mass, const vec3 *x, vec3 *v, uint32_t first,
                               uint32_t last, double fraction)
{
    double total = 0.0;
    vec3 centre = vec3_zero(), mean_velocity = vec3_zero();
    for (uint32_t i = first; i <= last; i++) {
        total += mass[i];
        centre = vec3_add_scaled(centre, mass[i], x[i]);
        mean_velocity = vec3_add_scaled(mean_velocity, mass[i], v[i]);
    }
    if (!(total > 0.0)) {
        return;
    }
    centre = vec3_scale(centre, 1.0 / total);
    mean_velocity = vec3_scale(mean_velocity, 1.0 / total);
    mat3 inertia = mat3_zero();
    vec3 momentum = vec3_zero();
    for (uint32_t i = first; i <= last; i++) {
        vec3 r = vec3_sub(x[i], centre);
        double rr = vec3_norm_squared(r);
        inertia = mat3_add_scaled(inertia, mass[i],
                                  mat3_sub(mat3_diagonal(rr, rr, rr), mat3_outer(r, r)));
        vec3 relative_velocity = vec3_sub(v[i], mean_velocity);
        momentum = vec3_add_scaled(momentum, mass[i], vec3_cross(r, relative_velocity));
    }
    vec3 rate = rotation_rate(inertia, momentum);
    /* The centre of mass is rounded, and particles close to a line may rotate fast about it. Remove
     * the linear momentum that this rounding error adds. */
    vec3 mean_velocity_error = vec3_zero();
    for (uint32_t i = first; i <= last; i++) {
        mean_velocity_error = vec3_add_scaled(mean_velocity_error, mass[i] / total,
                                              vec3_cross(rate, vec3_sub(x[i], centre)));
    }
    mean_velocity = vec3_sub(mean_velocity, mean_velocity_error);
    for (uint32_t i = first; i <= last; i++) {
        vec3 rigid = vec3_add(mean_velocity, vec3_cross(rate, vec3_sub(x[i], centre)));
        v[i] = vec3_add_scaled(v[i], -fraction, vec3_sub(v[i], rigid));
    }
}
