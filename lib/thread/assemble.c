/* Assembly: forces and stiffness of a thread at the trial state, as its part of the system.
 *
 * The system is solved for the increment u of the trial positions x:
 *
 *   (inertia m + stiffness) u = forces(x) - inertia m (x - x_predicted)
 *
 * The stiffness is exact except for four approximations. Geometric stiffness uses the tension of
 * the last solve, at least min_tension; arcs use it only if it is positive. The reduction of
 * axial stiffness by geometric stiffness applies to the whole gradient of the length, not only to
 * the chord. Stiffness of rest curvature is left out. The result is positive unless compression
 * is large. */
#include "thread/bending_memory.h"
#include "thread/twist.h"

/* ---- one segment */

/* Gradient of a segment's length with its four nodes, segment - 1 .. segment + 2: the tangent at
 * the ends of the chord, and a part from the curvature of the arc. The segment's force is -tension
 * gradient. Its stiffness is
 *
 *   stiffness gradient gradient^T + curvature_stiffness coefficient coefficient^T
 *   + geometric_stiffness (chord) */
typedef struct segment_terms {
    lanes gradient[4], scaled_gradient[4]; /* times the axial stiffness */
    double coefficient[4];                 /* coefficients of the nodes in the arc's curvature */
    double tension, curvature_stiffness, geometric_stiffness;
} segment_terms;

static void set_segment_terms(const thread_object *t, uint32_t i, double min_tension,
                              segment_terms *p)
{
    const thread_strain *s = &t->strains[i];
    const thread_arc *arc = &t->arcs[i];
    double stiffness = t->config.axial_stiffness * t->inverse_rest[i];
    double bounded_tension = t->trial_tension[i] > min_tension ? t->trial_tension[i] : min_tension;
    double curvature_coefficient = 2.0 * arc->length_coefficient;
    lanes tangent = lanes_from(s->tangent), curvature = lanes_from(s->curvature);
    p->tension = stiffness * s->elongation;
    p->curvature_stiffness = bounded_tension > 0.0 ? curvature_coefficient * bounded_tension : 0.0;
    /* A chord that turns has the geometric stiffness tension / chord across it, not along it. So
     * that much is taken off along the whole gradient, as it is small against EA / l. */
    p->geometric_stiffness = s->chord > 0.0 ? bounded_tension / s->chord : 0.0;
    stiffness -= p->geometric_stiffness;
    for (uint32_t a = 0; a < 4; a++) {
        p->coefficient[a] = arc->coefficient[a];
        p->gradient[a] = lanes_scale(curvature_coefficient * arc->coefficient[a], curvature);
    }
    p->gradient[1] = lanes_sub(p->gradient[1], tangent);
    p->gradient[2] = lanes_add(p->gradient[2], tangent);
    for (uint32_t a = 0; a < 4; a++) {
        p->scaled_gradient[a] = lanes_scale(stiffness, p->gradient[a]);
    }
}

static const segment_terms no_segment; /* for segments beyond the ends */

/* ---- blocks */

static inline block scalar_block(double s)
{
    block b = {{lanes_make(s, 0.0, 0.0), lanes_make(0.0, s, 0.0), lanes_make(0.0, 0.0, s)}};
    return b;
}

/* b += row column^T */
static inline void add_outer(block *b, const lanes *row, const lanes *column)
{
    b->column[0] = lanes_add(b->column[0], lanes_scale(lanes_at(*column, 0), *row));
    b->column[1] = lanes_add(b->column[1], lanes_scale(lanes_at(*column, 1), *row));
    b->column[2] = lanes_add(b->column[2], lanes_scale(lanes_at(*column, 2), *row));
}

/* Four neighbouring segments, those that meet at a node. The index is the segment modulo 4. */
typedef struct segment_ring {
    segment_terms at[4];
} segment_ring;

/* Block of nodes i and i + k: segments i + k - 2 .. i + 1 depend on both. */
static block pair_block(const segment_ring *p, uint32_t i, uint32_t k, double scalar, bool flipped)
{
    for (uint32_t a = 0; a + k < 4; a++) { /* segment i + 1 - a */
        const segment_terms *s = &p->at[(i + 1 - a) & 3u];
        scalar += s->curvature_stiffness * s->coefficient[a] * s->coefficient[a + k];
    }
    block b = scalar_block(scalar);
    for (uint32_t a = 0; a + k < 4; a++) {
        const segment_terms *s = &p->at[(i + 1 - a) & 3u];
        /* rows belong to the node that is eliminated later */
        add_outer(&b, &s->gradient[flipped ? a : a + k], &s->scaled_gradient[flipped ? a + k : a]);
    }
    return b;
}

/* ---- forces on a node */

static inline lanes load(const vec3 *v)
{
    return lanes_from(*v);
}

static lanes node_force(const thread_object *t, const vbss_integration *in, uint32_t i)
{
    lanes displacement = lanes_sub(load(&t->trial[i]), load(&t->x_predicted[i]));
    lanes velocity =
        lanes_add(load(&t->v_predicted[i]), lanes_scale(in->velocity_factor, displacement));
    lanes force = lanes_sub(load(&t->gravity), lanes_scale(in->inertia, displacement));
    force = lanes_sub(force, lanes_scale(t->config.drag, velocity));
    return lanes_scale(t->mass[i], force);
}

/* Differences are exactly opposite for the two nodes of a pair, and so are the forces. */
static lanes bending_force(const thread_object *t, uint32_t i)
{
    lanes here = load(&t->trial[i]), force = lanes_make(0.0, 0.0, 0.0);
    for (uint32_t k = 1; k <= THREAD_BANDWIDTH; k++) {
        if (i + k < t->node_count) {
            lanes e = lanes_sub(load(&t->trial[i + k]), here);
            force = lanes_sub(force, lanes_scale(t->bending_matrix[i][k], e));
        }
        if (i >= k) {
            lanes e = lanes_sub(load(&t->trial[i - k]), here);
            force = lanes_sub(force, lanes_scale(t->bending_matrix[i - k][k], e));
        }
    }
    return force;
}

static lanes stretching_force(const segment_ring *p, uint32_t i)
{
    lanes force = lanes_make(0.0, 0.0, 0.0);
    for (uint32_t a = 0; a < 4; a++) {
        const segment_terms *s = &p->at[(i + 1 - a) & 3u];
        force = lanes_sub(force, lanes_scale(s->tension, s->gradient[a]));
    }
    return force;
}

static void set_nodes(const thread_object *t, const thread_substep *substep, vbss_system *system,
                      uint32_t first)
{
    const vbss_integration *in = substep->integration;
    uint32_t n = t->node_count, bandwidth = t->config.bending == VBSS_THREAD_BENDING_SPLINE ? 3 : 2;
    segment_ring p;
    p.at[2] = p.at[3] = no_segment; /* segments -2 and -1 */
    set_segment_terms(t, 0, substep->min_tension, &p.at[0]);
    for (uint32_t i = 0; i < n; i++) {
        if (i + 2 < n) {
            set_segment_terms(t, i + 1, substep->min_tension, &p.at[(i + 1) & 3u]);
        } else {
            p.at[(i + 1) & 3u] = no_segment;
        }
        const segment_terms *before = &p.at[(i + 3) & 3u], *after = &p.at[i & 3u];
        lanes force = lanes_add(node_force(t, in, i), bending_force(t, i));
        system->rhs[first + i] = lanes_vec3(lanes_add(force, stretching_force(&p, i)));
        double scalar = t->mass[i] * (in->inertia + t->config.drag * in->velocity_factor) +
                        t->bending_matrix[i][0] + before->geometric_stiffness +
                        after->geometric_stiffness;
        system->diagonal[first + i] = pair_block(&p, i, 0, scalar, false);
        for (uint32_t k = 1; k <= bandwidth; k++) {
            uint32_t c = t->couplings[i][k - 1];
            double own = t->bending_matrix[i][k] - (k == 1 ? after->geometric_stiffness : 0.0);
            system->off_diagonal[c] = pair_block(&p, i, k, own, system->couplings[c].is_transposed);
        }
    }
}

/* Adds forces of pairs beyond the bandwidth, of which one node has a clamp. */
static void add_far_pairs(const thread_object *t, uint32_t clamp, vec3 *rhs)
{
    uint32_t node = t->clamps[clamp].node;
    for (uint32_t side = 0; side < 2; side++) {
        uint32_t i = side == 0 ? node : node - THREAD_CLAMP_BANDWIDTH;
        bool exists = side == 0 ? node + THREAD_CLAMP_BANDWIDTH < t->node_count
                                : node >= THREAD_CLAMP_BANDWIDTH;
        bool is_duplicate = exists && side == 1 && clamp > 0 && t->clamps[clamp - 1].node == i;
        if (exists && !is_duplicate) {
            vec3 e = vec3_sub(t->trial[i + THREAD_CLAMP_BANDWIDTH], t->trial[i]);
            vec3 f = vec3_scale(e, t->bending_matrix[i][THREAD_CLAMP_BANDWIDTH]);
            rhs[i] = vec3_sub(rhs[i], f);
            rhs[i + THREAD_CLAMP_BANDWIDTH] = vec3_add(rhs[i + THREAD_CLAMP_BANDWIDTH], f);
        }
    }
}

static void add_clamps(const thread_object *t, vec3 *rhs)
{
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        const thread_clamp *clamp = &t->clamps[c];
        for (uint32_t k = 0; k <= 2 * THREAD_CLAMP_BANDWIDTH; k++) {
            if (clamp->coefficient[k] != 0.0) {
                uint32_t i = clamp->node + k - THREAD_CLAMP_BANDWIDTH;
                rhs[i] = vec3_add_scaled(rhs[i], -clamp->coefficient[k], clamp->direction);
            }
        }
        add_far_pairs(t, c, rhs);
    }
}

/* ---- attachments */

static void add_attachments(const thread_object *t, const thread_substep *substep,
                            vbss_system *system, uint32_t first)
{
    const vbss_integration *in = substep->integration;
    double inverse_step = 1.0 / substep->step_length; /* 1/s */
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id == 0) {
            continue;
        }
        vec3 *rhs = &system->rhs[first + a->node];
        if (a->kind == VBSS_THREAD_ATTACHMENT_FORCE) {
            *rhs = vec3_add(*rhs, a->force);
        } else if (a->kind == VBSS_THREAD_ATTACHMENT_SPRING) {
            vec3 displacement = vec3_sub(t->trial[a->node], t->x_predicted[a->node]);
            vec3 velocity =
                vec3_add_scaled(t->v_predicted[a->node], in->velocity_factor, displacement);
            vec3 end_velocity = vec3_scale(vec3_sub(a->target, a->position), inverse_step);
            vec3 extension = vec3_sub(vbss_thread_attachment_position(a, substep->end_fraction),
                                      t->trial[a->node]);
            *rhs = vec3_add_scaled(*rhs, a->stiffness, extension);
            *rhs = vec3_add_scaled(*rhs, a->damping, vec3_sub(end_velocity, velocity));
            block spring = scalar_block(a->stiffness + a->damping * in->velocity_factor);
            block *diagonal = &system->diagonal[first + a->node];
            for (int c = 0; c < 3; c++) {
                diagonal->column[c] = lanes_add(diagonal->column[c], spring.column[c]);
            }
        }
    }
}

static void add_rest_curvature_forces(const thread_object *t, vec3 *rhs)
{
    for (uint32_t i = 0; t->config.rest_curvature > 0.0 && i < t->node_count; i++) {
        rhs[i] = vec3_add(rhs[i], t->rest_curvature_forces[i]);
    }
}

/* ---- bending with memory */

/* b += weight times the tangent of a response: `along` in its direction, `across` around it. */
static void add_tangent(block *b, const thread_bend_response *p, double weight)
{
    const lanes direction = lanes_from(p->direction);
    const lanes along = lanes_scale(weight * (p->along - p->across), direction);
    const block across = scalar_block(weight * p->across);
    add_outer(b, &along, &direction);
    for (int c = 0; c < 3; c++) {
        b->column[c] = lanes_add(b->column[c], across.column[c]);
    }
}

static void add_bend_response(const thread_object *t, uint32_t node, const thread_bend_response *p,
                              vbss_system *system, uint32_t first)
{
    double before = p->before ? t->inverse_rest[node - 1] : 0.0;
    double after = p->after ? t->inverse_rest[node] : 0.0;
    /* of nodes `node` - 1 .. `node` + 1 in the turn */
    const double coefficient[3] = {before, -(before + after), after};
    const double inverse_length = 1.0 / p->length;
    for (uint32_t a = p->before ? 0 : 1; a < (p->after ? 3u : 2u); a++) {
        uint32_t i = node + a - 1;
        vec3 *rhs = &system->rhs[first + i];
        *rhs = vec3_add_scaled(*rhs, -coefficient[a], p->moment);
        add_tangent(&system->diagonal[first + i], p,
                    inverse_length * coefficient[a] * coefficient[a]);
        for (uint32_t b = a + 1; b < (p->after ? 3u : 2u); b++) {
            add_tangent(&system->off_diagonal[t->couplings[i][b - a - 1]], p,
                        inverse_length * coefficient[a] * coefficient[b]);
        }
    }
}

static void add_bending_memory(const thread_object *t, vbss_system *system, uint32_t first)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        for (uint32_t side = 0; side < 2; side++) {
            const thread_bend_response *p = &t->bend_responses[2 * (size_t)i + side];
            if (p->length > 0.0) {
                add_bend_response(t, i, p, system, first);
            }
        }
    }
}

/* ---- twist */

static void add_matrix(block *b, const mat3 *m)
{
    for (int c = 0; c < 3; c++) {
        lanes column = lanes_make(m->m[0][c], m->m[1][c], m->m[2][c]);
        b->column[c] = lanes_add(b->column[c], column);
    }
}

static void add_twist_stiffness(const thread_object *t, uint32_t node,
                                const thread_twist_stiffness *s, vbss_system *system,
                                uint32_t first)
{
    /* of nodes `node` - 1 .. `node` + 1 in the two chords */
    static const double before[3] = {-1.0, 1.0, 0.0}, after[3] = {0.0, -1.0, 1.0};
    const mat3 mixed_back = mat3_transpose(s->mixed);
    for (uint32_t a = s->has_before ? 0 : 1; a < (s->has_after ? 3u : 2u); a++) {
        const uint32_t i = node + a - 1;
        for (uint32_t b = a; b < (s->has_after ? 3u : 2u); b++) {
            /* rows of a */
            mat3 m = mat3_scale(s->before, before[a] * before[b]);
            m = mat3_add_scaled(m, before[a] * after[b], s->mixed);
            m = mat3_add_scaled(m, after[a] * before[b], mixed_back);
            m = mat3_add_scaled(m, after[a] * after[b], s->after);
            if (b == a) {
                add_matrix(&system->diagonal[first + i], &m);
            } else {
                /* rows belong to the node that is eliminated later */
                const uint32_t c = t->couplings[i][b - a - 1];
                m = system->couplings[c].is_transposed ? m : mat3_transpose(m);
                add_matrix(&system->off_diagonal[c], &m);
            }
        }
    }
}

static void add_twist(const thread_object *t, vbss_system *system, uint32_t first)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        system->rhs[first + i] = vec3_add(system->rhs[first + i], t->twist_forces[i]);
        for (size_t k = 0; k < t->coupling_slots; k++) {
            const lanes coupling = load(&t->twist_couplings[t->coupling_slots * (size_t)i + k]);
            add_outer(&system->diagonal[first + i], &coupling, &coupling);
        }
        for (size_t side = 0; side < 2; side++) {
            const thread_twist_stiffness *s = &t->twist_stiffness[2 * (size_t)i + side];
            if (s->has_before || s->has_after) {
                add_twist_stiffness(t, i, s, system, first);
            }
        }
    }
}

void VBSS_WIDE_NAME(vbss_thread_assemble)(const thread_object *t, const thread_substep *substep,
                                          vbss_system *system, uint32_t first)
{
    set_nodes(t, substep, system, first);
    add_clamps(t, system->rhs + first);
    add_rest_curvature_forces(t, system->rhs + first);
    add_attachments(t, substep, system, first);
    if (thread_has_memory(t)) {
        add_bending_memory(t, system, first);
    }
    if (thread_has_twist(t)) {
        add_twist(t, system, first);
    }
}
