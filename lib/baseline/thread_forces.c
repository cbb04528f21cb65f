/* Internal forces of the baseline thread, and their stiffness.
 *
 * Bending is discrete Kirchhoff without twist. A turn by phi has the curvature binormal
 *   k = 2 t x t' / (1 + t.t'),  |k| = 2 tan(phi/2),  energy EI (|k| - k_rest)^2 / span,
 * where the span is the rest length of both neighbouring segments. The direction of a clamp is a
 * ghost segment: it turns against either neighbour over half a segment, so its span is one
 * segment. The paper's gradients of k hold lengths fixed and leave a component along the
 * segments, which the projection would cancel. The gradients here are complete and have no such
 * component. They are couples: with M the moment of a turn,
 * dE/de = t x M / |e| before it and M x t' / |e| behind it. */
#include "baseline/thread.h"
#include "thread/tuning.h"

/* |k|^2 as a function of the cosine of the turn, and its negative slope. */
typedef struct bend {
    double square, slope;
} bend;

static bend bend_of(double cosine)
{
    double c = 1.0 + cosine, beyond = 0.0;
    if (c < BASELINE_FOLD_COSINE) {
        beyond = BASELINE_FOLD_COSINE - c;
        c = BASELINE_FOLD_COSINE;
    }
    double inverse = 1.0 / c;
    c = c < 2.0 ? c : 2.0; /* the value of a straight thread, without rounding */
    bend b = {0.0, 8.0 * inverse * inverse};
    b.square = 4.0 * (2.0 - c) * inverse + b.slope * beyond;
    return b;
}

/* Returns |k_rest| of a turn. */
static double rest_bend(const thread_object *t, double span)
{
    return 0.5 * t->config.rest_curvature * span;
}

/* Returns |k|, smoothed below a thousandth of |k_rest|: a straight thread has no bending plane. */
static double smoothed(double square, double rest)
{
    return sqrt(square + BASELINE_SMOOTH_CURVATURE_SQUARED * rest * rest);
}

static vec3 moment_between(const thread_object *t, double span, vec3 before, vec3 behind)
{
    bend b = bend_of(vec3_dot(before, behind));
    double stiffness = t->config.bending_stiffness * b.slope / span;
    if (t->config.rest_curvature > 0.0) {
        double rest = rest_bend(t, span);
        stiffness *= 1.0 - rest / smoothed(b.square, rest);
    }
    return vec3_scale(vec3_cross(before, behind), stiffness);
}

static double energy_between(const thread_object *t, double span, vec3 before, vec3 behind)
{
    bend b = bend_of(vec3_dot(before, behind));
    double rest = rest_bend(t, span);
    double energy = b.square + rest * (rest - 2.0 * smoothed(b.square, rest));
    return t->config.bending_stiffness / span * energy;
}

/* Returns how many times stiffer a turn is than a straight one: (1 + u)(1 + 3 u) with u =
 * tan^2(phi/2). */
static double hardening(vec3 before, vec3 behind)
{
    double cosine = 1.0 + vec3_dot(before, behind);
    double u = (2.0 - cosine) / (cosine > BASELINE_FOLD_COSINE ? cosine : BASELINE_FOLD_COSINE);
    u = u < (2.0 - BASELINE_FOLD_COSINE) / BASELINE_FOLD_COSINE
            ? u
            : (2.0 - BASELINE_FOLD_COSINE) / BASELINE_FOLD_COSINE;
    return (1.0 + u) * (1.0 + 3.0 * u);
}

static const thread_attachment *clamp_at(const thread_object *t, uint32_t node)
{
    const thread_attachment *a =
        t->prescribed_by[node] != 0 ? &t->attachments[t->prescribed_by[node] - 1] : NULL;
    return a != NULL && a->kind == VBSS_THREAD_ATTACHMENT_CLAMP ? a : NULL;
}

/* Moments of the turns at a node, as they act on its two neighbours. They differ only at a
 * clamp. */
typedef struct moments {
    vec3 before, behind;
} moments;

static moments moments_at(const thread_object *t, uint32_t node, double part)
{
    const thread_strain *s = t->strains;
    const thread_attachment *clamp = clamp_at(t, node);
    bool first = node == 0, last = node + 1 == t->node_count;
    moments r = {vec3_zero(), vec3_zero()};
    if (clamp != NULL) {
        vec3 direction = vbss_thread_attachment_direction(clamp, part);
        if (!first) {
            r.before = moment_between(t, t->rest[node - 1], s[node - 1].tangent, direction);
        }
        if (!last) {
            r.behind = moment_between(t, t->rest[node], direction, s[node].tangent);
        }
    } else if (!first && !last) {
        r.before = moment_between(t, t->rest[node - 1] + t->rest[node], s[node - 1].tangent,
                                  s[node].tangent);
        r.behind = r.before;
    }
    return r;
}

void vbss_baseline_add_internal_forces(const thread_object *t, double part, vec3 *forces)
{
    bool bends = t->config.bending_stiffness > 0.0;
    vec3 low = bends ? moments_at(t, 0, part).behind : vec3_zero();
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const thread_strain *s = &t->strains[i];
        vec3 force = vec3_scale(s->tangent, t->baseline->rows[i].stiffness * s->elongation);
        if (bends) {
            moments high = moments_at(t, i + 1, part);
            vec3 couple = vec3_cross(vec3_sub(low, high.before), s->tangent);
            /* A failed projection may leave a segment compressed. The rest length then keeps the
             * couple as soft as dt requires. */
            double length = s->chord > t->rest[i] ? s->chord : t->rest[i];
            force = vec3_add_scaled(force, 1.0 / length, couple);
            low = high.behind;
        }
        forces[i] = vec3_add(forces[i], force);
        forces[i + 1] = vec3_sub(forces[i + 1], force);
    }
}

double vbss_baseline_bending_energy(const thread_object *t)
{
    const thread_strain *s = t->strains;
    double energy = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        const thread_attachment *clamp = clamp_at(t, i);
        bool first = i == 0, last = i + 1 == t->node_count;
        if (clamp != NULL && !first) {
            energy += energy_between(t, t->rest[i - 1], s[i - 1].tangent, clamp->direction);
        }
        if (clamp != NULL && !last) {
            energy += energy_between(t, t->rest[i], clamp->direction, s[i].tangent);
        }
        if (clamp == NULL && !first && !last) {
            energy +=
                energy_between(t, t->rest[i - 1] + t->rest[i], s[i - 1].tangent, s[i].tangent);
        }
    }
    return energy;
}

vec3 vbss_baseline_reaction_torque(const thread_object *t, uint32_t node)
{
    const thread_attachment *clamp = clamp_at(t, node);
    const vec3 *x = t->now.x;
    vec3 torque = vec3_zero();
    if (clamp != NULL && node > 0) {
        vec3 tangent = vec3_unit_or(vec3_sub(x[node], x[node - 1]), clamp->direction);
        torque = moment_between(t, t->rest[node - 1], tangent, clamp->direction);
    }
    if (clamp != NULL && node + 1 < t->node_count) {
        vec3 tangent = vec3_unit_or(vec3_sub(x[node + 1], x[node]), clamp->direction);
        torque = vec3_sub(torque, moment_between(t, t->rest[node], clamp->direction, tangent));
    }
    return torque;
}

/* ---- stability limit of an explicit substep
 *
 * For a transverse mode, bending acts at the old positions, and tension, by the projection, at
 * the predicted ones. The amplification factor f satisfies f^2 - (1 - a) (2 - b) f + (1 - a) = 0
 * with b = (dt w_b)^2 and a = (dt w_t)^2, where w_b and w_t are the angular frequencies of
 * bending and tension. Stability requires b <= 4 and a <= 4/3. */

/* Adds a bound by Cauchy and Schwarz. A turn is a linear form b of the positions. It adds 2
 * weight |b|_1 |b_i| to the row of each node, where |b|_1 sums over nodes that are free to move. */
static void add_rate(thread_object *t, uint32_t node, bool before, bool behind, double stiffness)
{
    double low = before ? 1.0 / t->rest[node - 1] : 0.0;
    double high = behind ? 1.0 / t->rest[node] : 0.0;
    double span = (before ? t->rest[node - 1] : 0.0) + (behind ? t->rest[node] : 0.0);
    const double form[3] = {low, low + high, high};
    double sum = 0.0;
    for (uint32_t k = 0; k < 3; k++) {
        sum += form[k] > 0.0 && t->prescribed_by[node + k - 1] == 0 ? form[k] : 0.0;
    }
    double factor = 2.0 * t->config.bending_stiffness / span * stiffness * sum;
    for (uint32_t k = 0; k < 3; k++) {
        if (form[k] > 0.0) {
            t->baseline->rows[node + k - 1].right += factor * form[k];
        }
    }
}

static void add_bending_rates(thread_object *t)
{
    const thread_strain *s = t->strains;
    for (uint32_t i = 0; i < t->node_count; i++) {
        const thread_attachment *clamp = clamp_at(t, i);
        bool before = i > 0, behind = i + 1 < t->node_count;
        if (clamp != NULL && before) {
            add_rate(t, i, true, false, hardening(s[i - 1].tangent, clamp->target_direction));
        }
        if (clamp != NULL && behind) {
            add_rate(t, i, false, true, hardening(clamp->target_direction, s[i].tangent));
        }
        if (clamp == NULL && before && behind) {
            add_rate(t, i, true, true, hardening(s[i - 1].tangent, s[i].tangent));
        }
    }
}

double vbss_baseline_thread_rate(thread_object *t)
{
    baseline_thread_row *rows = t->baseline->rows;
    double largest = 0.0, pull = 0.0; /* pull: tension over length of the segment before */
    for (uint32_t i = 0; i < t->node_count; i++) {
        rows[i].right = 0.0;
    }
    add_bending_rates(t);
    for (uint32_t i = 0; i < t->node_count; i++) {
        bool taut = i + 1 < t->node_count && t->now.tension[i] > 0.0 &&
                    t->strains[i].elongation < BASELINE_MAX_STRETCH * t->rest[i];
        double next = taut ? t->now.tension[i] / t->rest[i] : 0.0;
        double bending = 0.25 * rows[i].right, tension = 0.75 * 2.0 * (pull + next);
        double rate = rows[i].inverse_mass * (bending > tension ? bending : tension);
        largest = rate > largest ? rate : largest;
        pull = next;
    }
    return largest;
}
