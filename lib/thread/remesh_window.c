/* Window of a mesh: moves the nodes around a change until each segment has its strain again. The
 * displacements are the smallest in the norm of the nodes' masses. */
#include "thread/remesh.h"
#include "thread/tuning.h"

#include <string.h>

/* ---- geometry of a few segments, by the formulas of bending.c and strain.c */

static bool is_end(const remesh_window *w, uint32_t k)
{
    return (k == 0 && w->has_thread_start) || (k + 1 == w->count && w->has_thread_end);
}

/* Coefficients of nodes segment - 1 .. segment + 2 in the mean curvature of a segment's arc. */
static void arc_coefficients(const remesh_window *w, uint32_t segment, double coefficient[4])
{
    memset(coefficient, 0, 4 * sizeof *coefficient);
    for (uint32_t end = 0; end < 2; end++) {
        uint32_t k = segment + end;
        if (is_end(w, k)) {
            continue;
        }
        double before = 1.0 / w->rest[k - 1], after = 1.0 / w->rest[k];
        double inverse_sum = 1.0 / (w->rest[k - 1] + w->rest[k]); /* half of each of two nodes */
        coefficient[end] += inverse_sum * before;
        coefficient[end + 1] -= inverse_sum * (before + after);
        coefficient[end + 2] += inverse_sum * after;
    }
}

/* Whether all nodes that its length depends on are in the window. */
static bool has_known_length(const remesh_window *w, uint32_t segment)
{
    if (!w->has_arcs) {
        return true;
    }
    return (segment > 0 || w->has_thread_start) && (segment + 2 < w->count || w->has_thread_end);
}

/* Elongation of a segment, m, and its gradient with the segment's four nodes. */
static double elongation_of(const remesh_window *w, uint32_t segment, vec3 gradient[4])
{
    vec3 e = vec3_sub(w->x[segment + 1], w->x[segment]), tangent = vec3_unit_or(e, vec3_zero());
    double elongation = vec3_norm(e) - w->rest[segment], l = w->rest[segment];
    gradient[0] = gradient[3] = vec3_zero();
    gradient[1] = vec3_neg(tangent);
    gradient[2] = tangent;
    if (!w->has_arcs) {
        return elongation;
    }
    double coefficient[4], length_coefficient = l * l * l / 24.0;
    vec3 curvature = vec3_zero();
    arc_coefficients(w, segment, coefficient);
    for (uint32_t a = 0; a < 4; a++) {
        if (coefficient[a] != 0.0) {
            curvature = vec3_add_scaled(curvature, coefficient[a], w->x[segment + a - 1]);
        }
    }
    for (uint32_t a = 0; a < 4; a++) {
        gradient[a] =
            vec3_add_scaled(gradient[a], 2.0 * length_coefficient * coefficient[a], curvature);
    }
    return elongation + length_coefficient * vec3_norm_squared(curvature);
}

void vbss_remesh_measure_window(remesh_window *w)
{
    vec3 gradient[4];
    for (uint32_t i = 0; i + 1 < w->count; i++) {
        w->elongation[i] = has_known_length(w, i) ? elongation_of(w, i, gradient) : (double)NAN;
    }
}

/* ---- extraction */

void vbss_remesh_extract_window(const thread_object *t, uint32_t node, remesh_window *w)
{
    uint32_t last = t->node_count - 1;
    uint32_t low = node > REMESH_WINDOW_SIDE ? node - REMESH_WINDOW_SIDE : 0;
    uint32_t high = last - node > REMESH_WINDOW_SIDE ? node + REMESH_WINDOW_SIDE : last;
    *w = (remesh_window){.has_arcs = t->config.bending == VBSS_THREAD_BENDING_SPLINE,
                         .first_node = low,
                         .count = high - low + 1,
                         .has_thread_start = low == 0,
                         .has_thread_end = high == last};
    memcpy(w->x, t->now.x + low, w->count * sizeof *w->x);
    memcpy(w->rest, t->rest + low, (w->count - 1) * sizeof *w->rest);
}

/* ---- projection */

typedef struct length_constraint {
    uint32_t segment;
    vec3 gradient[4];
    double multiplier; /* excess elongation, m; after the solve the multiplier */
} length_constraint;

enum { MAX_CONSTRAINTS = REMESH_WINDOW_NODES };

static double inverse_mass(const remesh_window *w, uint32_t k)
{
    if (!w->is_movable[k]) {
        return 0.0;
    }
    double before = k > 0 ? w->rest[k - 1] : 0.0, after = k + 1 < w->count ? w->rest[k] : 0.0;
    return 2.0 / (before + after);
}

static uint32_t list_constraints(const remesh_window *w,
                                 length_constraint constraints[MAX_CONSTRAINTS])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i + 1 < w->count; i++) {
        bool is_affected = w->is_movable[i] || w->is_movable[i + 1];
        is_affected = is_affected || (w->has_arcs && ((i > 0 && w->is_movable[i - 1]) ||
                                                      (i + 2 < w->count && w->is_movable[i + 2])));
        if (is_affected && isfinite(w->elongation[i])) {
            length_constraint *r = &constraints[count++];
            r->segment = i;
            r->multiplier = elongation_of(w, i, r->gradient) - w->elongation[i];
        }
    }
    return count;
}

/* gradient_a . gradient_b over the nodes of both, weighted by their inverse masses. */
static double constraint_product(const remesh_window *w, const length_constraint *a,
                                 const length_constraint *b)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < 4; i++) {
        /* Node + 1 and index + 1, as unsigned numbers. */
        uint32_t node = a->segment + i, k = node - b->segment;
        if (node > 0 && node <= w->count && k < 4) {
            sum += inverse_mass(w, node - 1) * vec3_dot(a->gradient[i], b->gradient[k]);
        }
    }
    return sum;
}

/* Solves for the multipliers by elimination without pivoting, as the matrix is positive
 * definite. */
static void solve_multipliers(const remesh_window *w, length_constraint *constraints,
                              uint32_t count)
{
    double m[MAX_CONSTRAINTS][MAX_CONSTRAINTS], largest = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < count; k++) {
            m[i][k] = constraint_product(w, &constraints[i], &constraints[k]);
        }
        largest = vbss_max(m[i][i], largest);
    }
    for (uint32_t i = 0; i < count; i++) {
        m[i][i] += REMESH_REGULARISATION * largest;
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = i + 1; k < count; k++) {
            double factor = m[k][i] / m[i][i];
            for (uint32_t j = i; j < count; j++) {
                m[k][j] -= factor * m[i][j];
            }
            constraints[k].multiplier -= factor * constraints[i].multiplier;
        }
    }
    for (uint32_t i = count; i-- > 0;) {
        for (uint32_t k = i + 1; k < count; k++) {
            constraints[i].multiplier -= m[i][k] * constraints[k].multiplier;
        }
        constraints[i].multiplier /= m[i][i];
    }
}

double vbss_remesh_project_window(remesh_window *w)
{
    vec3 initial[REMESH_WINDOW_NODES];
    length_constraint constraints[MAX_CONSTRAINTS];
    memcpy(initial, w->x, sizeof initial);
    for (int pass = 0; pass < REMESH_PROJECTION_PASSES; pass++) {
        uint32_t count = list_constraints(w, constraints);
        if (count == 0) {
            return 0.0;
        }
        solve_multipliers(w, constraints, count);
        for (uint32_t i = 0; i < count; i++) {
            for (uint32_t a = 0; a < 4; a++) {
                uint32_t node = constraints[i].segment + a; /* node + 1 */
                if (node > 0 && node <= w->count) {
                    w->x[node - 1] = vec3_add_scaled(
                        w->x[node - 1], -constraints[i].multiplier * inverse_mass(w, node - 1),
                        constraints[i].gradient[a]);
                }
            }
        }
    }
    double max_displacement = 0.0;
    for (uint32_t k = 0; k < w->count; k++) {
        max_displacement = vbss_max_or_nan(vec3_distance(initial[k], w->x[k]), max_displacement);
    }
    return max_displacement;
}
