/* Bending with memory: material law, and its sums over the thread.
 *
 * A cell has a signed curvature s, the norm of its curvature with the sign of the side of its plane
 * to which it bends. Plastic curvature p and viscous curvature q belong to the same plane. With
 * E = EI, H = E hardening / (1 - hardening) and B = E relaxation_ratio, its energy for a unit of
 * length is
 *
 *   E/2 (s - p)^2 + H/2 p^2 + B/2 (s - q)^2
 *
 * bending.c covers E/2 |curvature|^2, and this file adds the rest. The moment is along the
 * curvature, as without twist nothing can balance another one. */
#include "thread/bending_memory.h"
#include "base/elementary.h"
#include "thread/bending_cells.h"
#include "thread/tuning.h"

/* ---- material law */

typedef struct memory_law {
    double stiffness, hardening, branch; /* E, H, B, N m^2 */
    double yield_moment;                 /* N m; infinite without plasticity */
    /* viscous curvature after a substep: decay q + from_old s_old + from_new s_new */
    double decay, from_old, from_new;
    double relaxations; /* length of the substep in relaxation times */
} memory_law;

/* Exact for a curvature that changes at a constant rate. Series where differences would cancel. */
static memory_law make_law(const thread_object *t, double h)
{
    const vbss_thread_config *c = &t->config;
    const double x = h / c->relaxation_time;
    memory_law law = {.stiffness = c->bending_stiffness, .relaxations = x, .decay = vbss_exp(-x)};
    law.hardening = law.stiffness * c->yield_hardening / (1.0 - c->yield_hardening);
    law.branch = law.stiffness * c->relaxation_ratio;
    law.yield_moment =
        c->yield_curvature > 0.0 ? law.stiffness * c->yield_curvature : (double)INFINITY;
    if (x < THREAD_MEMORY_SERIES_LIMIT) {
        law.from_new = x * (1.0 / 2.0 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)));
        law.from_old = x * (1.0 / 2.0 - x * (1.0 / 3.0 - x * (1.0 / 8.0 - x / 30.0)));
    } else {
        const double mean_decay = (1.0 - law.decay) / x;
        law.from_new = 1.0 - mean_decay;
        law.from_old = mean_decay - law.decay;
    }
    return law;
}

typedef struct signed_curvature {
    double value;  /* 1/m */
    vec3 gradient; /* with the curvature vector; a unit vector except near zero */
} signed_curvature;

/* Near zero, where its direction says nothing, the component along the plane counts. A plane that
 * is zero is that of the curvature. */
static signed_curvature sign_curvature(vec3 curvature, vec3 plane, double straight)
{
    double along = vec3_dot(curvature, plane);
    if (vec3_norm_squared(plane) == 0.0) {
        double norm = vec3_norm(curvature);
        return (signed_curvature){norm, vec3_unit_or(curvature, vec3_zero())};
    }
    vec3 across = vec3_add_scaled(curvature, -along, plane);
    double square = along * along + straight * straight;
    double ratio = sqrt(1.0 + vec3_norm_squared(across) / square);
    double from_across = along / (square * ratio);
    double from_along = ratio - from_across * along * vec3_norm_squared(across) / square;
    vec3 gradient = vec3_add_scaled(vec3_scale(plane, from_along), from_across, across);
    return (signed_curvature){along * ratio, gradient};
}

static double straight_curvature(const bending_cell *cell)
{
    return THREAD_MEMORY_STRAIGHT_TURN / cell->length;
}

static vec3 curvature_of(const bending_cell *cell)
{
    return vec3_scale(cell->turn, 1.0 / cell->length);
}

typedef struct plastic_change {
    double curvature;   /* plastic curvature, 1/m */
    double slope;       /* of the moment with the curvature, N m^2 */
    double dissipation; /* for a unit of length, N */
} plastic_change;

/* Radial return with linear kinematic hardening. */
static plastic_change return_to_yield(const memory_law *law, double s, double old)
{
    double stress = law->stiffness * (s - old) - law->hardening * old;
    double excess = fabs(stress) - law->yield_moment;
    if (!(excess > 0.0)) {
        return (plastic_change){old, law->stiffness, 0.0};
    }
    double sum = law->stiffness + law->hardening, change = excess / sum;
    return (plastic_change){old + (stress > 0.0 ? change : -change),
                            law->stiffness * (law->hardening / sum), law->yield_moment * change};
}

static double viscous_curvature(const memory_law *law, double s, const thread_bend_memory *old)
{
    return law->decay * old->viscous + law->from_old * old->curvature + law->from_new * s;
}

/* Energy that the viscous branch loses over a substep for a unit of length, N: B times the mean
 * square of its elastic part s - q over the substep, in relaxation times. Long substeps have the exact
 * integral; it would cancel in short ones, where that part is nearly linear in time. */
static double viscous_dissipation(const memory_law *law, const thread_bend_memory *old,
                                  const thread_bend_memory *new)
{
    double before = old->curvature - old->viscous, after = new->curvature - new->viscous;
    double x = law->relaxations;
    if (x < 1.0) {
        double mean = (new->viscous - old->viscous) / x, change = after - before;
        return law->branch * x * (mean * mean + change * change / 12.0);
    }
    double limit = (new->curvature - old->curvature) / x, excess = before - limit;
    return law->branch * (limit * limit * x + 2.0 * limit * excess * (1.0 - law->decay) +
                          0.5 * excess * excess * (1.0 - law->decay * law->decay));
}

/* Moment beyond that of bending.c, N m, with which a cell resists its turn. */
static vec3 extra_moment(const memory_law *law, vec3 curvature, vec3 gradient, double plastic,
                         double viscous)
{
    double set = law->stiffness * plastic + law->branch * viscous;
    return vec3_add_scaled(vec3_scale(curvature, law->branch), -set, gradient);
}

static thread_bend_response respond(const memory_law *law, const thread_bend_memory *old,
                                    const bending_cell *cell)
{
    const double straight = straight_curvature(cell);
    const vec3 curvature = curvature_of(cell);
    const signed_curvature s = sign_curvature(curvature, old->plane, straight);
    const plastic_change plastic = return_to_yield(law, s.value, old->plastic);
    const double viscous = viscous_curvature(law, s.value, old);
    const double set = law->stiffness * plastic.curvature + law->branch * viscous;
    /* Across the direction the slope is moment / curvature. Where that is negative the plane of the
     * bend is unstable, and no stiffness counts. */
    double across = law->stiffness + law->branch;
    across -= set * s.value / (s.value * s.value + straight * straight);
    return (thread_bend_response){
        .curvature = curvature,
        .moment = extra_moment(law, curvature, s.gradient, plastic.curvature, viscous),
        .direction = vec3_unit_or(s.gradient, vec3_zero()),
        .along = plastic.slope - law->stiffness + law->branch * (1.0 - law->from_new),
        .across = (across > 0.0 ? across : 0.0) - law->stiffness,
        .length = cell->length,
        .before = cell->before,
        .after = cell->after,
    };
}

/* ---- memory of a node */

/* Curvature memories belong to the two sides of a node. They are equal until a clamp separates
 * them, and after it has gone their mean counts. */
static thread_bend_memory mean_memory(const thread_bend_memory side[2])
{
    const thread_bend_memory *a = &side[0], *b = &side[1];
    thread_bend_memory mean = *a;
    if (vec3_norm_squared(vec3_sub(a->plane, b->plane)) == 0.0 && a->curvature == b->curvature &&
        a->plastic == b->plastic && a->viscous == b->viscous) {
        return mean;
    }
    const double sign = vec3_dot(a->plane, b->plane) < 0.0 ? -1.0 : 1.0;
    mean.plane = vec3_unit_or(vec3_add_scaled(a->plane, sign, b->plane), a->plane);
    mean.curvature = 0.5 * (a->curvature + sign * b->curvature);
    mean.plastic = 0.5 * (a->plastic + sign * b->plastic);
    mean.viscous = 0.5 * (a->viscous + sign * b->viscous);
    return mean;
}

static uint32_t side_of(const bending_cell *cell)
{
    return cell->before ? 0 : 1;
}

static thread_bend_memory memory_of(const thread_object *t, uint32_t node, const bending_cell *cell)
{
    const thread_bend_memory *sides = t->now.bend + 2 * (size_t)node;
    return cell->before && cell->after ? mean_memory(sides) : sides[side_of(cell)];
}

static vec3 tangent_at(const vec3 *x, uint32_t node, const bending_cell *cell)
{
    uint32_t low = cell->before ? node - 1 : node, high = cell->after ? node + 1 : node;
    return vec3_unit_or(vec3_sub(x[high], x[low]), vec3_zero());
}

/* Plane of a cell at the end of a substep: that of its curvature; if it is straight, the old plane
 * turned with the tangent. */
static vec3 turn_plane(vec3 curvature, vec3 old, vec3 tangent, double straight)
{
    if (vec3_norm_squared(old) == 0.0) {
        return vec3_unit_or(curvature, vec3_zero());
    }
    if (vec3_norm_squared(curvature) > straight * straight) {
        double sign = vec3_dot(curvature, old) < 0.0 ? -1.0 : 1.0;
        return vec3_scale(vec3_unit_or(curvature, old), sign);
    }
    return vec3_unit_or(vec3_add_scaled(old, -vec3_dot(old, tangent), tangent), old);
}

/* ---- a substep */

void vbss_thread_update_bending_memory(thread_object *t, double h)
{
    const memory_law law = make_law(t, h);
    bending_cell cells[2];
    for (uint32_t i = 0; i < t->node_count; i++) {
        thread_bend_response *responses = t->bend_responses + 2 * (size_t)i;
        responses[0].length = responses[1].length = 0.0;
        for (int c = vbss_thread_bending_cells(t, t->trial, i, cells) - 1; c >= 0; c--) {
            const thread_bend_memory old = memory_of(t, i, &cells[c]);
            responses[side_of(&cells[c])] = respond(&law, &old, &cells[c]);
        }
    }
}

double vbss_thread_bending_memory_residual(const thread_object *t, const vbss_integration *in)
{
    const memory_law law = make_law(t, in->h);
    const double stiffness = 16.0 * law.stiffness,
                 foundation = in->inertia * t->config.linear_density;
    double largest = 0.0;
    bending_cell cells[2];
    for (uint32_t i = 0; i < t->node_count; i++) {
        for (int c = vbss_thread_bending_cells(t, t->trial, i, cells) - 1; c >= 0; c--) {
            const thread_bend_memory old = memory_of(t, i, &cells[c]);
            const thread_bend_response now = respond(&law, &old, &cells[c]);
            const thread_bend_response *p = &t->bend_responses[2 * (size_t)i + side_of(&cells[c])];
            vec3 change = vec3_sub(now.curvature, p->curvature);
            vec3 foreseen = vec3_add_scaled(p->moment, p->across, change);
            double along = (p->along - p->across) * vec3_dot(p->direction, change);
            foreseen = vec3_add_scaled(foreseen, along, p->direction);
            double l = now.length, square = l * l;
            double error = vec3_norm(vec3_sub(now.moment, foreseen));
            /* The node moves against its inertia and the stiffness of its neighbours. */
            largest = vbss_max_or_nan(error * square / (foundation * square * square + stiffness),
                                      largest);
        }
    }
    return largest;
}

void vbss_thread_commit_bending_memory(thread_object *t, double h)
{
    const memory_law law = make_law(t, h);
    bending_cell cells[2];
    for (uint32_t i = 0; i < t->node_count; i++) {
        thread_bend_memory *sides = t->now.bend + 2 * (size_t)i;
        for (int c = vbss_thread_bending_cells(t, t->trial, i, cells) - 1; c >= 0; c--) {
            const bending_cell *cell = &cells[c];
            const double straight = straight_curvature(cell);
            const vec3 curvature = curvature_of(cell);
            const thread_bend_memory old = memory_of(t, i, cell);
            thread_bend_memory new = old;
            new.curvature = sign_curvature(curvature, old.plane, straight).value;
            const plastic_change plastic = return_to_yield(&law, new.curvature, old.plastic);
            new.plastic = plastic.curvature;
            new.viscous = viscous_curvature(&law, new.curvature, &old);
            t->now.dissipated_energy +=
                cell->length * (plastic.dissipation + viscous_dissipation(&law, &old, &new));
            new.plane = turn_plane(curvature, old.plane, tangent_at(t->trial, i, cell), straight);
            new.curvature = sign_curvature(curvature, new.plane, straight).value;
            sides[side_of(cell)] = new;
            if (cell->before && cell->after) {
                sides[1] = new;
            }
        }
    }
}

/* ---- the current state */

void vbss_thread_orient_bending_memory(thread_object *t)
{
    bending_cell cells[2];
    for (uint32_t i = 0; i < t->node_count; i++) {
        thread_bend_memory *sides = t->now.bend + 2 * (size_t)i;
        for (int c = vbss_thread_bending_cells(t, t->now.x, i, cells) - 1; c >= 0; c--) {
            const bending_cell *cell = &cells[c];
            const double straight = straight_curvature(cell);
            const vec3 curvature = curvature_of(cell);
            thread_bend_memory m = memory_of(t, i, cell);
            if (vec3_norm_squared(curvature) > straight * straight) {
                m.plane =
                    vec3_scale(vec3_unit_or(curvature, m.plane), m.curvature < 0.0 ? -1.0 : 1.0);
            }
            m.curvature = sign_curvature(curvature, m.plane, straight).value;
            sides[side_of(cell)] = m;
            if (cell->before && cell->after) {
                sides[1] = m;
            }
        }
    }
}

double vbss_thread_bending_memory_energy(const thread_object *t)
{
    const memory_law law = make_law(t, 0.0);
    double energy = 0.0;
    bending_cell cells[2];
    for (uint32_t i = 0; i < t->node_count; i++) {
        for (int c = vbss_thread_bending_cells(t, t->now.x, i, cells) - 1; c >= 0; c--) {
            const thread_bend_memory m = memory_of(t, i, &cells[c]);
            const vec3 curvature = curvature_of(&cells[c]);
            double s = sign_curvature(curvature, m.plane, straight_curvature(&cells[c])).value;
            double density = law.branch * (vec3_norm_squared(curvature) + m.viscous * m.viscous);
            density += (law.stiffness + law.hardening) * m.plastic * m.plastic;
            density -= 2.0 * s * (law.stiffness * m.plastic + law.branch * m.viscous);
            energy += 0.5 * cells[c].length * density;
        }
    }
    return energy;
}

static vec3 current_moment(const thread_object *t, uint32_t node, const bending_cell *cell)
{
    const memory_law law = make_law(t, 0.0);
    const thread_bend_memory m = memory_of(t, node, cell);
    const vec3 curvature = curvature_of(cell);
    const signed_curvature s = sign_curvature(curvature, m.plane, straight_curvature(cell));
    return extra_moment(&law, curvature, s.gradient, m.plastic, m.viscous);
}

vec3 vbss_thread_bending_memory_force(const thread_object *t, uint32_t node)
{
    vec3 force = vec3_zero();
    bending_cell cells[2];
    for (uint32_t i = node > 0 ? node - 1 : 0; i <= node + 1 && i < t->node_count; i++) {
        for (int c = vbss_thread_bending_cells(t, t->now.x, i, cells) - 1; c >= 0; c--) {
            double before = cells[c].before ? t->inverse_rest[i - 1] : 0.0;
            double after = cells[c].after ? t->inverse_rest[i] : 0.0;
            double coefficient = i == node ? -(before + after) : i > node ? before : after;
            force = vec3_add_scaled(force, -coefficient, current_moment(t, i, &cells[c]));
        }
    }
    return force;
}

vec3 vbss_thread_bending_memory_gradient(const thread_object *t, uint32_t node)
{
    vec3 gradient = vec3_zero();
    bending_cell cells[2];
    for (int c = vbss_thread_bending_cells(t, t->now.x, node, cells) - 1; c >= 0; c--) {
        double sign = cells[c].after ? -1.0 : 1.0;
        gradient = vec3_add_scaled(gradient, sign, current_moment(t, node, &cells[c]));
    }
    return gradient;
}
