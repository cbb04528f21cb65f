/* Bending energy of the implicit method: coefficients that are constant while rest lengths and
 * clamps are.
 *
 * Let d be the turn of the chords' directions at each node between two clamps or free ends, and A
 * the matrix of hat functions along the thread: A_ii = (l_{i-1} + l_i) / 3, A_i,i+1 = l_i / 6. The
 * cubic spline through the nodes has second derivatives M with A M = d, and the energy EI/2 d^T
 * A^-1 d. A clamp adds the turn between its direction and the first chord; a free end has M = 0.
 * The inverse is full, so it is approximated:
 *
 *   - exact at clamps, where curvature is steepest: the first two M are eliminated,
 *     and the third with an estimate of the fourth;
 *   - one term of Neumann's series elsewhere: with A = W - L, where W has the row sums,
 *     A^-1 ~ W^-1 + W^-1 L W^-1, which gives
 *       EI/2 (sum W_i |d_i / W_i|^2 + sum l_i / 6 |d_{i+1} / W_{i+1} - d_i / W_i|^2).
 *     This is positive, local, and of fourth order.
 *
 * VBSS_THREAD_BENDING_LOCAL leaves out the last sum. Both are quadratic in the positions, so coefficients
 * are constant. */
#include "thread/bending_memory.h"
#include "thread/twist.h"

#include <string.h>

/* The part of a thread between two clamps or free ends. */
typedef struct clamp_interval {
    uint32_t low, high;      /* its first and last node */
    thread_clamp *clamps[2]; /* at its two ends; NULL: a free end */
} clamp_interval;

static double reciprocal_rest(const thread_object *t, uint32_t segment)
{
    return 1.0 / t->rest[segment];
}

/* Turn of the thread at a node. */
static thread_linear_form turn_at(const thread_object *t, const clamp_interval *s, uint32_t node)
{
    thread_linear_form f = {node > s->low ? node - 1 : node, {0.0}, {0.0, 0.0}};
    uint32_t here = node - f.first_node;
    if (node < s->high) {
        f.node[here] -= reciprocal_rest(t, node);
        f.node[here + 1] += reciprocal_rest(t, node);
    } else {
        f.clamp[1] += 1.0;
    }
    if (node > s->low) {
        f.node[here] -= reciprocal_rest(t, node - 1);
        f.node[here - 1] += reciprocal_rest(t, node - 1);
    } else {
        f.clamp[0] -= 1.0;
    }
    return f;
}

/* a + factor b. The result starts at the lower of the two first nodes. */
static thread_linear_form add_forms(thread_linear_form a, double factor,
                                    const thread_linear_form *b)
{
    thread_linear_form r = {
        a.first_node < b->first_node ? a.first_node : b->first_node, {0.0}, {0.0, 0.0}};
    for (uint32_t k = 0; k < THREAD_STENCIL_NODES; k++) {
        if (a.node[k] != 0.0) {
            r.node[a.first_node - r.first_node + k] += a.node[k];
        }
        if (b->node[k] != 0.0) {
            r.node[b->first_node - r.first_node + k] += factor * b->node[k];
        }
    }
    for (int c = 0; c < 2; c++) {
        r.clamp[c] = a.clamp[c] + factor * b->clamp[c];
    }
    return r;
}

/* Adds weight/2 |form|^2 to the coefficients of the energy. */
static void add_square(thread_object *t, const clamp_interval *s, double weight,
                       const thread_linear_form *f)
{
    weight *= t->config.bending_stiffness;
    for (uint32_t i = 0; i < THREAD_STENCIL_NODES; i++) {
        for (uint32_t j = i; j < THREAD_STENCIL_NODES; j++) {
            if (f->node[i] != 0.0 && f->node[j] != 0.0) {
                t->bending_matrix[f->first_node + i][j - i] += weight * f->node[i] * f->node[j];
            }
        }
    }
    for (int c = 0; c < 2; c++) {
        thread_clamp *clamp = s->clamps[c];
        if (clamp == NULL || f->clamp[c] == 0.0) {
            continue;
        }
        clamp->own_coefficient += weight * f->clamp[c] * f->clamp[c];
        for (uint32_t i = 0; i < THREAD_STENCIL_NODES; i++) {
            if (f->node[i] != 0.0) {
                uint32_t k = f->first_node + i + THREAD_CLAMP_BANDWIDTH - clamp->node;
                clamp->coefficient[k] += weight * f->clamp[c] * f->node[i];
            }
        }
    }
    if (s->clamps[0] != NULL && s->clamps[1] != NULL) {
        s->clamps[0]->next_coefficient += weight * f->clamp[0] * f->clamp[1];
    }
}

/* ---- one clamp interval: elimination at the clamps, then Neumann's series */

static void set_moment(const thread_object *t, const clamp_interval *s, uint32_t node,
                       thread_spline_moment *m)
{
    double before = node > s->low ? t->rest[node - 1] : 0.0;
    double after = node < s->high ? t->rest[node] : 0.0;
    m->turn = turn_at(t, s, node);
    m->diagonal = (before + after) / 3.0;
    m->off_diagonal = after / 6.0;
}

/* Eliminates a moment exactly: adds its energy, and updates the row of its neighbour `other`,
 * if any. */
static void eliminate(thread_object *t, const clamp_interval *s, const thread_spline_moment *m,
                      double coupling, thread_spline_moment *other)
{
    double factor = coupling / m->diagonal;
    add_square(t, s, 1.0 / m->diagonal, &m->turn);
    if (other != NULL) {
        other->turn = add_forms(other->turn, -factor, &m->turn);
        other->diagonal -= factor * coupling;
    }
}

/* Eliminates the moment beside those that were eliminated exactly. The next moment is estimated as
 * its turn over its row sum, so the energy is exact for a curvature that is linear there. */
static void eliminate_with_estimate(thread_object *t, const clamp_interval *s,
                                    const thread_spline_moment *m, double coupling,
                                    const thread_spline_moment *next)
{
    thread_linear_form turn = add_forms(m->turn, -coupling / next->row_sum, &next->turn);
    add_square(t, s, 1.0 / m->diagonal, &turn);
    add_square(t, s, coupling / (next->row_sum * next->row_sum), &next->turn);
}

/* Adds the energy of moments `low` .. `high` - 1 of `count` by one term of Neumann's series. Moment
 * 0 is at `first_node`. */
static void add_neumann(thread_object *t, const clamp_interval *s, uint32_t first_node,
                        uint32_t count, uint32_t low, uint32_t high)
{
    bool spline = t->config.bending == VBSS_THREAD_BENDING_SPLINE;
    thread_spline_moment *m = t->spline_moments;
    /* A free end counts as a neighbour whose moment is zero. Eliminated moments do not count. */
    bool free_low = s->clamps[0] == NULL, free_high = s->clamps[1] == NULL;
    double first_link = low == 0 && free_low && high > 0 ? t->rest[first_node - 1] / 6.0 : 0.0;
    for (uint32_t k = low; k < high; k++) {
        double before = k > low ? m[k - 1].off_diagonal : first_link;
        bool after = k + 1 < high || (high == count && free_high);
        m[k].row_sum = m[k].diagonal + before + (after ? m[k].off_diagonal : 0.0);
    }
    bool close_low = spline && !free_low && high - low >= 2;
    bool close_high = spline && !free_high && high - low >= (close_low ? 3u : 2u);
    if (close_low) {
        eliminate_with_estimate(t, s, &m[low], m[low].off_diagonal, &m[low + 1]);
        low++;
    }
    if (close_high) {
        eliminate_with_estimate(t, s, &m[high - 1], m[high - 2].off_diagonal, &m[high - 2]);
        high--;
    }
    for (uint32_t k = low; k < high; k++) {
        double weight = 1.0 / m[k].row_sum;
        add_square(t, s, weight, &m[k].turn);
        double end_links = (k == 0 ? first_link : 0.0);
        end_links += k + 1 == count && free_high ? m[k].off_diagonal : 0.0;
        /* With rest curvature or memory a free end is curved, too: its moment equals that of its
         * neighbour. */
        if (spline && end_links > 0.0 && t->config.rest_curvature == 0.0 && !thread_has_memory(t)) {
            add_square(t, s, end_links * weight * weight, &m[k].turn);
        }
        if (spline && k + 1 < high) {
            thread_linear_form difference = {m[k].turn.first_node, {0.0}, {0.0, 0.0}};
            difference = add_forms(difference, -weight, &m[k].turn);
            difference = add_forms(difference, 1.0 / m[k + 1].row_sum, &m[k + 1].turn);
            add_square(t, s, m[k].off_diagonal, &difference);
        }
    }
}

static void add_interval(thread_object *t, const clamp_interval *s)
{
    bool spline = t->config.bending == VBSS_THREAD_BENDING_SPLINE;
    bool both = s->clamps[0] != NULL && s->clamps[1] != NULL;
    /* All nodes except free ends have a moment. */
    uint32_t first_node = s->low + (s->clamps[0] == NULL), end = s->high + (s->clamps[1] != NULL);
    uint32_t count = end > first_node ? end - first_node : 0;
    /* Number of moments eliminated exactly at a clamp. With five segments between two clamps, two
     * at each would reach too far. */
    uint32_t exact_count = spline && !(both && count == 6) ? 2 : 1;
    thread_spline_moment *m = t->spline_moments;
    for (uint32_t k = 0; k < count; k++) {
        set_moment(t, s, first_node + k, &m[k]);
    }
    uint32_t low = 0, high = count;
    for (uint32_t k = 0; s->clamps[0] != NULL && k < exact_count && low < high; k++, low++) {
        eliminate(t, s, &m[low], m[low].off_diagonal, low + 1 < high ? &m[low + 1] : NULL);
    }
    for (uint32_t k = 0; s->clamps[1] != NULL && k < exact_count && low < high; k++, high--) {
        bool more = high - 1 > low;
        eliminate(t, s, &m[high - 1], more ? m[high - 2].off_diagonal : 0.0,
                  more ? &m[high - 2] : NULL);
    }
    add_neumann(t, s, first_node, count, low, high);
}

/* ---- arcs of segments */

/* Curvature at an inner node; zero at the ends. */
static thread_linear_form inner_curvature(const thread_object *t, const clamp_interval *s,
                                          uint32_t node)
{
    thread_linear_form none = {node, {0.0}, {0.0, 0.0}};
    if (node == s->low || node == s->high) {
        return none;
    }
    thread_linear_form turn = turn_at(t, s, node);
    none.first_node = turn.first_node;
    return add_forms(none, 2.0 / (t->rest[node - 1] + t->rest[node]), &turn);
}

/* Curvature at any node. At a clamp it is extrapolated from the mean over the first segment,
 * located at a third of it, and the next node. */
static thread_linear_form curvature_at(const thread_object *t, const clamp_interval *s,
                                       uint32_t node)
{
    bool low = node == s->low && s->clamps[0] != NULL;
    bool high = node == s->high && s->clamps[1] != NULL;
    if (!low && !high) {
        return inner_curvature(t, s, node);
    }
    thread_linear_form turn = turn_at(t, s, node), none = {turn.first_node, {0.0}, {0.0, 0.0}};
    if (s->high == s->low + 1 && s->clamps[0] != NULL && s->clamps[1] != NULL) {
        /* No inner node: the curvature of a circle. */
        return add_forms(none, 2.0 / t->rest[s->low], &turn);
    }
    thread_linear_form next = inner_curvature(t, s, low ? node + 1 : node - 1);
    turn = add_forms(none, 3.0 / t->rest[low ? node : node - 1], &turn);
    return add_forms(turn, -0.5, &next);
}

static void add_arcs(thread_object *t, const clamp_interval *s)
{
    for (uint32_t i = s->low; i < s->high; i++) {
        thread_arc *arc = &t->arcs[i];
        double l = t->rest[i];
        thread_linear_form ends[2] = {curvature_at(t, s, i), curvature_at(t, s, i + 1)};
        *arc = (thread_arc){.length_coefficient = l * l * l / 24.0};
        for (int c = 0; c < 2; c++) {
            arc->clamp_index[c] = s->clamps[c] != NULL ? (uint32_t)(s->clamps[c] - t->clamps) : 0;
        }
        for (int end = 0; end < 2; end++) {
            for (uint32_t k = 0; k < THREAD_STENCIL_NODES; k++) {
                if (ends[end].node[k] != 0.0) {
                    arc->coefficient[ends[end].first_node + k + 1 - i] += 0.5 * ends[end].node[k];
                }
            }
            arc->clamp_coefficient[0] += 0.5 * ends[end].clamp[0];
            arc->clamp_coefficient[1] += 0.5 * ends[end].clamp[1];
        }
    }
}

/* ---- the whole thread */

static void find_clamps(thread_object *t)
{
    t->clamp_count = 0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (vbss_thread_is_clamped(t, i)) {
            t->clamps[t->clamp_count++] =
                (thread_clamp){.attachment_index = t->prescribed_by[i] - 1, .node = i};
        }
    }
}

void vbss_thread_build_bending(thread_object *t)
{
    uint32_t n = t->node_count;
    memset(t->bending_matrix, 0, n * sizeof *t->bending_matrix);
    memset(t->arcs, 0, n * sizeof *t->arcs);
    find_clamps(t);
    clamp_interval s = {0, 0, {NULL, NULL}};
    for (uint32_t c = 0; c <= t->clamp_count; c++) {
        s.clamps[1] = c < t->clamp_count ? &t->clamps[c] : NULL;
        s.high = c < t->clamp_count ? t->clamps[c].node : n - 1;
        if (s.high > s.low) {
            add_interval(t, &s);
            if (t->config.bending == VBSS_THREAD_BENDING_SPLINE) {
                add_arcs(t, &s);
            }
        }
        s.low = s.high;
        s.clamps[0] = s.clamps[1];
    }
}

static void set_clamp_curvature(thread_object *t, thread_arc *arc)
{
    arc->clamp_curvature = vec3_zero();
    for (int c = 0; c < 2; c++) {
        if (arc->clamp_coefficient[c] != 0.0) {
            arc->clamp_curvature = vec3_add_scaled(arc->clamp_curvature, arc->clamp_coefficient[c],
                                                   t->clamps[arc->clamp_index[c]].direction);
        }
    }
}

void vbss_thread_set_clamp_directions(thread_object *t, double fraction)
{
    uint32_t segments = t->node_count - 1;
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        thread_clamp *clamp = &t->clamps[c];
        clamp->direction =
            vbss_thread_attachment_direction(&t->attachments[clamp->attachment_index], fraction);
    }
    if (thread_has_twist(t)) {
        vbss_thread_set_section_holders(t, fraction);
    }
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        /* Only the two segments on either side of a clamp depend on its direction. */
        uint32_t node = t->clamps[c].node, end = node + 2 < segments ? node + 2 : segments;
        for (uint32_t i = node < 2 ? 0 : node - 2; i < end; i++) {
            set_clamp_curvature(t, &t->arcs[i]);
        }
    }
}

vec3 vbss_thread_clamp_direction(const thread_object *t, uint32_t node)
{
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        if (t->clamps[c].node == node) {
            return t->clamps[c].direction;
        }
    }
    return t->attachments[t->prescribed_by[node] - 1].direction; /* baseline method */
}

vec3 vbss_thread_curvature(const thread_object *t, const vec3 *x, uint32_t node)
{
    uint32_t n = t->node_count;
    bool clamp = vbss_thread_is_clamped(t, node);
    bool first = node == 0, last = node + 1 == n;
    if ((first || last) && !clamp) {
        return vec3_zero();
    }
    vec3 before = vec3_zero(), after = vec3_zero();
    if (!first) {
        before = vec3_scale(vec3_sub(x[node], x[node - 1]), 1.0 / t->rest[node - 1]);
    }
    if (!last) {
        after = vec3_scale(vec3_sub(x[node + 1], x[node]), 1.0 / t->rest[node]);
    }
    if (!clamp) {
        return vec3_scale(vec3_sub(after, before), 2.0 / (t->rest[node - 1] + t->rest[node]));
    }
    vec3 direction = vbss_thread_clamp_direction(t, node);
    return last ? vec3_scale(vec3_sub(direction, before), 2.0 / t->rest[node - 1])
                : vec3_scale(vec3_sub(after, direction), 2.0 / t->rest[node]);
}
