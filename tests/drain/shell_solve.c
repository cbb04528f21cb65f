/* Energy, tangent and equilibrium of a small shell: L D L^T inside a skyline. */
#include <stdlib.h>
#include <string.h>

#include "drain/shell_rig.h"

#include "harness/harness.h"

double shell_rig_energy(shell_rig *r)
{
    double energy = 0.0;
    memset(r->forces, 0, r->node_count * sizeof *r->forces);
    vbss_shell_add_forces(&r->shell, r->x, r->forces);
    vbss_shell_compute_responses(&r->shell, r->x, r->states);
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        energy += r->states[i].membrane_energy + r->states[i].bending_energy;
    }
    return energy;
}

void shell_rig_tangent(shell_rig *r)
{
    memset(r->forces, 0, r->node_count * sizeof *r->forces);
    memset(r->diagonal, 0, r->node_count * sizeof *r->diagonal);
    memset(r->blocks, 0, (r->pair_count + 1) * sizeof *r->blocks);
    vbss_shell_assemble(&r->shell, r->x, r->forces, r->diagonal, r->blocks);
}

double shell_rig_stiffest(shell_rig *r)
{
    double largest = 0.0;
    shell_rig_tangent(r);
    for (uint32_t i = 0; i < r->node_count; i++) {
        mat3 m = block_mat3(&r->diagonal[i]);
        largest = vbss_max(vbss_max(m.m[0][0], m.m[1][1]), vbss_max(m.m[2][2], largest));
    }
    return largest;
}

double shell_rig_rounding(shell_rig *r)
{
    double reach = 0.0;
    for (uint32_t i = 0; i < r->node_count; i++) {
        reach = vbss_max(vec3_norm(r->x[i]), reach);
    }
    return DBL_EPSILON * reach * shell_rig_stiffest(r);
}

/* ---- the skyline: row i holds columns first[i] .. i */

typedef struct skyline {
    uint32_t n, *first;
    size_t *start;
    double *a, *b;
    int32_t (*unknown)[3]; /* of own nodes; -1: held */
} skyline;

static double *entry(const skyline *s, uint32_t i, uint32_t j)
{
    return &s->a[s->start[i] + (j - s->first[i])];
}

static double part(vec3 v, int c)
{
    return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

/* Every pair of unknowns that a block couples, with what it brings; to widen the rows or to fill them. */
static void visit_block(skyline *s, const shell_rig *r, uint32_t a, uint32_t b, const block *m)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            int32_t row = s->unknown[r->master[a]][i], column = s->unknown[r->master[b]][j];
            uint32_t low = (uint32_t)(row < column ? row : column);
            uint32_t high = (uint32_t)(row < column ? column : row);
            if (row < 0 || column < 0 || (a == b && row < column)) {
                continue;
            }
            if (m == NULL) {
                s->first[high] = low < s->first[high] ? low : s->first[high];
            } else {
                double value =
                    part(r->sign[a], i) * part(r->sign[b], j) * lanes_at(m->column[j], i);
                *entry(s, high, low) += a != b && low == high ? 2.0 * value : value;
            }
        }
    }
}

static void visit_blocks(skyline *s, const shell_rig *r, bool fill)
{
    for (uint32_t i = 0; i < r->node_count; i++) {
        visit_block(s, r, i, i, fill ? &r->diagonal[i] : NULL);
    }
    for (uint32_t p = 1; p <= r->pair_count; p++) {
        visit_block(s, r, r->pairs[p][0], r->pairs[p][1], fill ? &r->blocks[p] : NULL);
    }
}

static void skyline_begin(skyline *s, const shell_rig *r)
{
    s->n = 0;
    s->unknown = malloc(r->own_count * sizeof *s->unknown);
    for (uint32_t i = 0; i < r->own_count; i++) {
        for (int c = 0; c < 3; c++) {
            s->unknown[i][c] = r->held[i][c] ? -1 : (int32_t)s->n++;
        }
    }
    s->first = malloc((s->n + 1) * sizeof *s->first);
    s->start = malloc((s->n + 1) * sizeof *s->start);
    s->b = malloc((s->n + 1) * sizeof *s->b);
    for (uint32_t i = 0; i < s->n; i++) {
        s->first[i] = i;
    }
    visit_blocks(s, r, false);
    s->start[0] = 0;
    for (uint32_t i = 0; i < s->n; i++) {
        s->start[i + 1] = s->start[i] + (i - s->first[i] + 1);
    }
    s->a = malloc((s->start[s->n] + 1) * sizeof *s->a);
}

static void skyline_end(skyline *s)
{
    free(s->unknown);
    free(s->first);
    free(s->start);
    free(s->a);
    free(s->b);
}

static void factor(skyline *s)
{
    for (uint32_t i = 0; i < s->n; i++) {
        double *row = entry(s, i, s->first[i]) - s->first[i];
        for (uint32_t j = s->first[i]; j < i; j++) { /* row of L D */
            const double *other = entry(s, j, s->first[j]) - s->first[j];
            double sum = row[j];
            for (uint32_t k = s->first[i] > s->first[j] ? s->first[i] : s->first[j]; k < j; k++) {
                sum -= row[k] * other[k];
            }
            row[j] = sum;
        }
        for (uint32_t j = s->first[i]; j < i; j++) {
            double scaled = row[j] / *entry(s, j, j);
            row[i] -= row[j] * scaled;
            row[j] = scaled;
        }
        assert_true(row[i] > 0.0);
    }
}

static void back_substitute(skyline *s)
{
    for (uint32_t i = 0; i < s->n; i++) {
        for (uint32_t j = s->first[i]; j < i; j++) {
            s->b[i] -= *entry(s, i, j) * s->b[j];
        }
    }
    for (uint32_t i = 0; i < s->n; i++) {
        s->b[i] /= *entry(s, i, i);
    }
    for (uint32_t i = s->n; i-- > 0;) {
        for (uint32_t j = s->first[i]; j < i; j++) {
            s->b[j] -= *entry(s, i, j) * s->b[i];
        }
    }
}

/* ---- equilibrium */

static double potential(shell_rig *r)
{
    double energy = shell_rig_energy(r);
    for (uint32_t i = 0; i < r->own_count; i++) {
        energy -= vec3_dot(r->load[i], vec3_sub(r->x[i], r->rest[i]));
    }
    return energy;
}

static void set_residual(skyline *s, const shell_rig *r)
{
    memset(s->b, 0, s->n * sizeof *s->b);
    for (uint32_t i = 0; i < r->node_count; i++) {
        for (int c = 0; c < 3; c++) {
            int32_t row = s->unknown[r->master[i]][c];
            if (row >= 0) {
                s->b[row] += part(r->sign[i], c) * (part(r->forces[i], c) + part(r->load[i], c));
            }
        }
    }
}

static void move(const skyline *s, shell_rig *r, const vec3 *from, double share)
{
    for (uint32_t i = 0; i < r->node_count; i++) {
        double by[3];
        for (int c = 0; c < 3; c++) {
            int32_t row = s->unknown[r->master[i]][c];
            by[c] = row < 0 ? 0.0 : part(r->sign[i], c) * share * s->b[row];
        }
        r->x[i] = vec3_add(from[i], vec3_load(by));
    }
}

/* Down the energy, with steps halved until they go down; ends when nothing more is gained. */
int shell_rig_solve(shell_rig *r, int limit)
{
    skyline s;
    skyline_begin(&s, r);
    vec3 *from = malloc(r->node_count * sizeof *from);
    double energy = potential(r);
    int steps = 0;
    for (bool gained = true; gained && steps < limit;) {
        memcpy(from, r->x, r->node_count * sizeof *from);
        shell_rig_tangent(r);
        memset(s.a, 0, s.start[s.n] * sizeof *s.a);
        visit_blocks(&s, r, true);
        set_residual(&s, r);
        factor(&s);
        back_substitute(&s);
        gained = false;
        double share = 1.0;
        for (int half = 0; half < 20 && !gained; half++) {
            move(&s, r, from, share);
            share *= 0.5;
            double lower = potential(r);
            gained = lower < energy - 1e-13 * fabs(energy);
            energy = gained ? lower : energy;
        }
        if (!gained) {
            move(&s, r, from, 0.0);
        }
        steps += gained;
    }
    free(from);
    skyline_end(&s);
    return steps;
}
