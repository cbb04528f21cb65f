/* Rest curvature of the implicit method: a thread that is curved at rest, in no particular
 * plane.
 *
 * The energy EI/2 (|curvature| - k)^2 l is EI/2 |curvature|^2 l, which bending.c covers, plus EI k
 * (k/2 - |curvature|) l, which this file adds. It sums over a cell around each node, or two half
 * cells at a clamp. The norm is smoothed below a thousandth of k, as a straight thread has no plane
 * to bend in. */
#include "thread/bending_cells.h"
#include "thread/tuning.h"

#include <string.h>

static double smooth_norm(vec3 turn, double angle)
{
    return sqrt(vec3_norm_squared(turn) + THREAD_SMOOTH_TURN_SQUARED * angle * angle);
}

double vbss_thread_rest_curvature_energy(const thread_object *t)
{
    double k = t->config.rest_curvature, energy = 0.0;
    bending_cell cells[2];
    for (uint32_t i = 0; k > 0.0 && i < t->node_count; i++) {
        for (int c = vbss_thread_bending_cells(t, t->now.x, i, cells) - 1; c >= 0; c--) {
            double angle = k * cells[c].length;
            double turn_norm = smooth_norm(cells[c].turn, angle);
            energy += t->config.bending_stiffness * k * (0.5 * angle - turn_norm);
        }
    }
    return energy;
}

/* Moment with which rest curvature turns a cell further, N m. */
static vec3 moment_of(const thread_object *t, const bending_cell *c)
{
    double k = t->config.rest_curvature;
    double turn_norm = smooth_norm(c->turn, k * c->length);
    /* 0 if the thread is straight and k^2 underflows */
    double strength = turn_norm > 0.0 ? t->config.bending_stiffness * k / turn_norm : 0.0;
    return vec3_scale(c->turn, strength);
}

void vbss_thread_add_rest_curvature_forces(const thread_object *t, const vec3 *x, vec3 *forces)
{
    bending_cell cells[2];
    for (uint32_t i = 0; t->config.rest_curvature > 0.0 && i < t->node_count; i++) {
        for (int c = vbss_thread_bending_cells(t, x, i, cells) - 1; c >= 0; c--) {
            vec3 moment = moment_of(t, &cells[c]);
            if (cells[c].before) {
                double coefficient = t->inverse_rest[i - 1];
                forces[i - 1] = vec3_add_scaled(forces[i - 1], coefficient, moment);
                forces[i] = vec3_add_scaled(forces[i], -coefficient, moment);
            }
            if (cells[c].after) {
                double coefficient = t->inverse_rest[i];
                forces[i + 1] = vec3_add_scaled(forces[i + 1], coefficient, moment);
                forces[i] = vec3_add_scaled(forces[i], -coefficient, moment);
            }
        }
    }
}

vec3 vbss_thread_rest_curvature_force(const thread_object *t, uint32_t node)
{
    vec3 force = vec3_zero();
    bending_cell cells[2];
    uint32_t first = node > 0 ? node - 1 : 0;
    for (uint32_t i = first; t->config.rest_curvature > 0.0 && i <= node + 1; i++) {
        for (int c = i < t->node_count ? vbss_thread_bending_cells(t, t->now.x, i, cells) - 1 : -1;
             c >= 0; c--) {
            double before = cells[c].before ? t->inverse_rest[i - 1] : 0.0;
            double after = cells[c].after ? t->inverse_rest[i] : 0.0;
            double coefficient = i == node ? -(before + after) : i > node ? before : after;
            force = vec3_add_scaled(force, coefficient, moment_of(t, &cells[c]));
        }
    }
    return force;
}

vec3 vbss_thread_rest_curvature_gradient(const thread_object *t, uint32_t node)
{
    vec3 gradient = vec3_zero();
    bending_cell cells[2];
    if (t->config.rest_curvature > 0.0) {
        for (int c = vbss_thread_bending_cells(t, t->now.x, node, cells) - 1; c >= 0; c--) {
            /* The gradient points along the turn if the cell is after the clamp, against it
             * if before. */
            double sign = cells[c].after ? 1.0 : -1.0;
            gradient = vec3_add_scaled(gradient, sign, moment_of(t, &cells[c]));
        }
    }
    return gradient;
}

void vbss_thread_update_rest_curvature_forces(thread_object *t)
{
    memset(t->rest_curvature_forces, 0, t->node_count * sizeof *t->rest_curvature_forces);
    vbss_thread_add_rest_curvature_forces(t, t->trial, t->rest_curvature_forces);
}
