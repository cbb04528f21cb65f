/* Inextensibility of the baseline thread by fast projection (Goldenthal et al. 2007), one
 * section at a time.
 *
 * The constraint C_i = |e_i|^2 / l_i - l_i has the gradient +-(2 / l_i) e_i at the ends of its
 * segment. Each iteration solves the tridiagonal system (J M^-1 J^T) u = C and moves x by -M^-1
 * J^T u, until all C_i are small. Prescribed nodes have no inverse mass, so they do not move. */
#include "baseline/thread.h"
#include "thread/tuning.h"

#include <string.h>

/* Computes the edges, and C_i / l_i as right-hand sides. Returns the largest |C_i| / l_i, or a
 * value that is not finite if one is not. */
static double measure(thread_object *t, uint32_t first, uint32_t last)
{
    double largest = 0.0, sum = 0.0;
    for (uint32_t i = first; i < last; i++) {
        baseline_thread_row *row = &t->baseline->rows[i];
        row->edge = vec3_scale(vec3_sub(t->now.x[i + 1], t->now.x[i]), row->inverse_rest);
        row->square = vec3_norm_squared(row->edge);
        row->right = row->square - 1.0;
        double error = fabs(row->right);
        largest = error > largest ? error : largest;
        sum += error; /* NaN stays in a sum */
    }
    return sum < 1e100 ? largest : sum;
}

/* Solves the system for 2 u_i, scaled so that row i is C_i / l_i and its edge is e_i / l_i.
 * Returns false if a pivot is below `share` times its diagonal. */
static bool solve(thread_object *t, uint32_t first, uint32_t last, double share)
{
    baseline_thread_row *rows = t->baseline->rows;
    for (uint32_t i = first; i < last; i++) {
        baseline_thread_row *row = &rows[i];
        double over = 2.0 * row->inverse_rest;
        double diagonal = over * row->square * (row->inverse_mass + rows[i + 1].inverse_mass);
        double pivot = diagonal;
        if (i > first) {
            /* Off-diagonal entries: this row with the unknown before (lower), and the row before
             * with this unknown (ratio). */
            double pair = -vec3_dot(rows[i - 1].edge, row->edge) * row->inverse_mass;
            double lower = over * pair, ratio = rows[i - 1].ratio;
            rows[i - 1].ratio = 2.0 * rows[i - 1].inverse_rest * pair * ratio;
            pivot -= lower * rows[i - 1].ratio;
            row->right -= lower * rows[i - 1].right;
        }
        if (!(pivot > share * diagonal)) {
            return false;
        }
        row->ratio = 1.0 / pivot; /* the next row multiplies it by its off-diagonal entry */
        row->right *= row->ratio;
    }
    for (uint32_t i = last - 1; i > first; i--) {
        rows[i - 1].right -= rows[i - 1].ratio * rows[i].right;
    }
    return true;
}

static void move(thread_object *t, uint32_t first, uint32_t last)
{
    baseline_thread_row *rows = t->baseline->rows;
    for (uint32_t i = first; i < last; i++) {
        vec3 pull = vec3_scale(rows[i].edge, rows[i].right);
        rows[i].multiplier += rows[i].right * sqrt(rows[i].square);
        t->now.x[i] = vec3_add_scaled(t->now.x[i], rows[i].inverse_mass, pull);
        t->now.x[i + 1] = vec3_add_scaled(t->now.x[i + 1], -rows[i + 1].inverse_mass, pull);
    }
}

static void give_up(thread_object *t, uint32_t first, uint32_t last)
{
    memcpy(t->now.x + first, t->trial + first, (size_t)(last - first + 1) * sizeof(vec3));
    for (uint32_t i = first; i < last; i++) {
        t->baseline->rows[i].multiplier = 0.0;
    }
}

bool vbss_baseline_project_section(thread_object *t, uint32_t first, uint32_t last, double dt,
                                   vec3 *forces)
{
    baseline_thread_row *rows = t->baseline->rows;
    vec3 low = vec3_zero(), high = vec3_zero();
    memcpy(t->trial + first, t->now.x + first, (size_t)(last - first + 1) * sizeof(vec3));
    for (uint32_t i = first; i < last; i++) {
        rows[i].multiplier = 0.0;
    }
    for (uint32_t k = 0;; k++) {
        double error = measure(t, first, last);
        bool good = error <= t->config.baseline->thread_tolerance;
        if (good && k > 0) { /* at least one iteration: its multipliers are the tensions */
            break;
        }
        bool more = k < t->config.baseline->thread_iteration_limit && error < 1e100;
        if (!more || !solve(t, first, last,
                            good ? BASELINE_UNSOUND_PIVOT_RATIO : BASELINE_SINGULAR_PIVOT_RATIO)) {
            if (good) { /* no node can move */
                break;
            }
            give_up(t, first, last);
            return false;
        }
        t->baseline->counts.iterations++;
        move(t, first, last);
        low = vec3_add_scaled(low, rows[first].right, rows[first].edge);
        high = vec3_add_scaled(high, -rows[last - 1].right, rows[last - 1].edge);
    }
    double rate = 1.0 / dt;
    for (uint32_t i = first; i <= last; i++) {
        if (t->prescribed_by[i] == 0) {
            vec3 moved = vec3_sub(t->now.x[i], t->trial[i]);
            t->now.v[i] = vec3_add_scaled(t->now.v[i], rate, moved);
        }
    }
    forces[first] = vec3_add_scaled(forces[first], rate * rate, low);
    forces[last] = vec3_add_scaled(forces[last], rate * rate, high);
    return true;
}
