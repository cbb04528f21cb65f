/* A window of a mesh: nodes around one that comes or goes are moved until each segment has the strain that it had.
 * The moves are the smallest, each weighed with its node's mass. */
#include "thread/mesh.h"

#include <string.h>

/* More would move the shape to cure what is small already. */
enum { PASSES = 3 };
/* As a share of the largest pivot: lengths that only large moves across could change are left as they are. */
#define GIVE 1e-3

/* ---- geometry: as bending.c and strain.c have it, for a few segments */

static bool is_end(const mesh_window *w, uint32_t k)
{
    return (k == 0 && w->begins) || (k + 1 == w->count && w->ends);
}

/* Of the four nodes segment - 1 .. segment + 2 in the mean curvature of a segment's arc. */
static void arc_factors(const mesh_window *w, uint32_t segment, double factor[4])
{
    memset(factor, 0, 4 * sizeof *factor);
    for (uint32_t end = 0; end < 2; end++) {
        uint32_t k = segment + end;
        if (is_end(w, k)) {
            continue;
        }
        double before = 1.0 / w->rest[k - 1], behind = 1.0 / w->rest[k];
        double share = 1.0 / (w->rest[k - 1] + w->rest[k]); /* half of each of two */
        factor[end] += share * before;
        factor[end + 1] -= share * (before + behind);
        factor[end + 2] += share * behind;
    }
}

/* Whether all that its length depends on is in the window. */
static bool is_known(const mesh_window *w, uint32_t segment)
{
    if (!w->arcs) {
        return true;
    }
    return (segment > 0 || w->begins) && (segment + 2 < w->count || w->ends);
}

/* A segment's length beyond its rest length, and how it changes with its four nodes. */
static double excess_of(const mesh_window *w, uint32_t segment, vec3 slope[4])
{
    vec3 e = vec3_sub(w->x[segment + 1], w->x[segment]), tangent = vec3_unit_or(e, vec3_zero());
    double excess = vec3_norm(e) - w->rest[segment], l = w->rest[segment];
    slope[0] = slope[3] = vec3_zero();
    slope[1] = vec3_neg(tangent);
    slope[2] = tangent;
    if (!w->arcs) {
        return excess;
    }
    double factor[4], share = l * l * l / 24.0;
    vec3 curvature = vec3_zero();
    arc_factors(w, segment, factor);
    for (uint32_t a = 0; a < 4; a++) {
        if (factor[a] != 0.0) {
            curvature = vec3_add_scaled(curvature, factor[a], w->x[segment + a - 1]);
        }
    }
    for (uint32_t a = 0; a < 4; a++) {
        slope[a] = vec3_add_scaled(slope[a], 2.0 * share * factor[a], curvature);
    }
    return excess + share * vec3_norm_squared(curvature);
}

void vbss_mesh_measure(mesh_window *w)
{
    vec3 slope[4];
    for (uint32_t i = 0; i + 1 < w->count; i++) {
        w->excess[i] = is_known(w, i) ? excess_of(w, i, slope) : (double)NAN;
    }
}

/* ---- looking */

void vbss_mesh_look(const thread_object *t, uint32_t node, mesh_window *w)
{
    uint32_t last = t->node_count - 1;
    uint32_t low = node > MESH_SIDE ? node - MESH_SIDE : 0;
    uint32_t high = last - node > MESH_SIDE ? node + MESH_SIDE : last;
    *w = (mesh_window){.arcs = t->config.bending == VBSS_BENDING_SPLINE,
                       .first = low,
                       .count = high - low + 1,
                       .begins = low == 0,
                       .ends = high == last};
    memcpy(w->x, t->now.x + low, w->count * sizeof *w->x);
    memcpy(w->rest, t->rest + low, (w->count - 1) * sizeof *w->rest);
}

/* ---- settling */

typedef struct length_row {
    uint32_t segment;
    vec3 slope[4];
    double left; /* of the excess, to be taken off; then the multiplier */
} length_row;

enum { ROWS = MESH_WINDOW };

static double weight_of(const mesh_window *w, uint32_t k)
{
    if (!w->moves[k]) {
        return 0.0;
    }
    double before = k > 0 ? w->rest[k - 1] : 0.0, behind = k + 1 < w->count ? w->rest[k] : 0.0;
    return 2.0 / (before + behind);
}

static uint32_t list_rows(const mesh_window *w, length_row rows[ROWS])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i + 1 < w->count; i++) {
        bool sees = w->moves[i] || w->moves[i + 1];
        sees = sees ||
               (w->arcs && ((i > 0 && w->moves[i - 1]) || (i + 2 < w->count && w->moves[i + 2])));
        if (sees && isfinite(w->excess[i])) {
            length_row *r = &rows[count++];
            r->segment = i;
            r->left = excess_of(w, i, r->slope) - w->excess[i];
        }
    }
    return count;
}

/* slope a . slope b over the nodes that both see, weighed by how easily these move. */
static double pair_of(const mesh_window *w, const length_row *a, const length_row *b)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < 4; i++) {
        uint32_t node = a->segment + i, k = node - b->segment; /* both one too many */
        if (node > 0 && node <= w->count && k < 4) {
            sum += weight_of(w, node - 1) * vec3_dot(a->slope[i], b->slope[k]);
        }
    }
    return sum;
}

/* The multipliers, by elimination without pivots: the matrix is positive. */
static void solve(const mesh_window *w, length_row *rows, uint32_t count)
{
    double m[ROWS][ROWS], largest = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < count; k++) {
            m[i][k] = pair_of(w, &rows[i], &rows[k]);
        }
        largest = vbss_max(m[i][i], largest);
    }
    for (uint32_t i = 0; i < count; i++) {
        m[i][i] += GIVE * largest;
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = i + 1; k < count; k++) {
            double factor = m[k][i] / m[i][i];
            for (uint32_t j = i; j < count; j++) {
                m[k][j] -= factor * m[i][j];
            }
            rows[k].left -= factor * rows[i].left;
        }
    }
    for (uint32_t i = count; i-- > 0;) {
        for (uint32_t k = i + 1; k < count; k++) {
            rows[i].left -= m[i][k] * rows[k].left;
        }
        rows[i].left /= m[i][i];
    }
}

double vbss_mesh_settle(mesh_window *w)
{
    vec3 from[MESH_WINDOW];
    length_row rows[ROWS];
    memcpy(from, w->x, sizeof from);
    for (int pass = 0; pass < PASSES; pass++) {
        uint32_t count = list_rows(w, rows);
        if (count == 0) {
            return 0.0;
        }
        solve(w, rows, count);
        for (uint32_t i = 0; i < count; i++) {
            for (uint32_t a = 0; a < 4; a++) {
                uint32_t node = rows[i].segment + a; /* one too many */
                if (node > 0 && node <= w->count) {
                    w->x[node - 1] = vec3_add_scaled(
                        w->x[node - 1], -rows[i].left * weight_of(w, node - 1), rows[i].slope[a]);
                }
            }
        }
    }
    double longest = 0.0;
    for (uint32_t k = 0; k < w->count; k++) {
        longest = vbss_max_or_nan(vec3_distance(from[k], w->x[k]), longest);
    }
    return longest;
}
