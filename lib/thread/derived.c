/* Derived data: functions of rest lengths and attachments, computed again after one of them
 * has changed. */
#include "base/error.h"
#include "thread/twist.h"

#include <string.h>

double vbss_thread_arc_length(const thread_object *t, uint32_t node)
{
    if (t->is_derived_valid) {
        return t->rest_arc_length[node];
    }
    double arc_length = 0.0;
    for (uint32_t i = 0; i < node; i++) {
        arc_length += t->rest[i];
    }
    return arc_length;
}

/* ---- masses */

/* Moves mass between two nodes, at most half of what the donor has. Without the limit a short
 * segment beside a long one, as a cut leaves it, would get negative masses. */
static void shift_mass(thread_object *t, uint32_t from, uint32_t to, double mass)
{
    double half = 0.5 * (mass > 0.0 ? t->mass[from] : t->mass[to]);
    mass = mass > half ? half : mass < -half ? -half : mass;
    t->mass[from] -= mass;
    t->mass[to] += mass;
}

/* End correction: l^2/12 times the slope at the end, from differences over the first two
 * segments. */
static void correct_end(thread_object *t, uint32_t end, uint32_t next, uint32_t third, double l,
                        double l_next)
{
    double end_mass = t->config.linear_density * l / 12.0, ratio = l / (l + l_next);
    shift_mass(t, end, next, end_mass * (1.0 + ratio));
    shift_mass(t, third, next, end_mass * ratio * l / l_next);
}

/* A node has half the mass of its neighbouring segments, with the end corrections of the
 * trapezoidal rule. So sums over the nodes are integrals up to fourth order if the integrand is
 * smooth. For equal lengths the weights are Gregory's: 3/8, 7/6, 23/24, 1, ...; for unequal lengths
 * each node has the terms of Euler and Maclaurin. */
static void lump_mass(thread_object *t)
{
    uint32_t n = t->node_count;
    double density = t->config.linear_density;
    memset(t->mass, 0, n * sizeof *t->mass);
    t->rest_arc_length[0] = 0.0;
    t->min_rest_length = t->rest[0];
    for (uint32_t i = 0; i + 1 < n; i++) {
        t->inverse_rest[i] = 1.0 / t->rest[i];
        t->rest_arc_length[i + 1] = t->rest_arc_length[i] + t->rest[i];
        t->min_rest_length = t->rest[i] < t->min_rest_length ? t->rest[i] : t->min_rest_length;
        t->mass[i] += 0.5 * density * t->rest[i];
        t->mass[i + 1] += 0.5 * density * t->rest[i];
    }
    if (n < 3 || !t->method->corrects_masses) {
        return;
    }
    /* At a clamp the slope along the thread is zero, so there is no correction. */
    if (!vbss_thread_is_clamped(t, 0)) {
        correct_end(t, 0, 1, 2, t->rest[0], t->rest[1]);
    }
    if (!vbss_thread_is_clamped(t, n - 1)) {
        correct_end(t, n - 1, n - 2, n - 3, t->rest[n - 2], t->rest[n - 3]);
    }
    for (uint32_t i = 1; i + 1 < n; i++) {
        shift_mass(t, i - 1, i + 1, density * (t->rest[i] - t->rest[i - 1]) / 12.0);
    }
}

/* ---- attachments */

static void find_prescribed_nodes(thread_object *t)
{
    memset(t->prescribed_by, 0, t->node_count * sizeof *t->prescribed_by);
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        bool prescribes_motion =
            a->kind == VBSS_THREAD_ATTACHMENT_PIN || a->kind == VBSS_THREAD_ATTACHMENT_CLAMP;
        if (a->id != 0 && prescribes_motion) {
            t->prescribed_by[a->node] = k + 1;
        }
    }
}

static void add_attached_masses(thread_object *t)
{
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id != 0 && a->kind == VBSS_THREAD_ATTACHMENT_MASS) {
            t->mass[a->node] += a->mass;
        }
    }
}

static void find_sections(thread_object *t)
{
    t->section_count = 0;
    t->sections[t->section_count++] = 0;
    for (uint32_t i = 1; i + 1 < t->node_count; i++) {
        if (t->prescribed_by[i] != 0) {
            t->sections[t->section_count++] = i;
        }
    }
}

/* ---- chain of blocks in a system */

uint32_t vbss_thread_bandwidth(const thread_object *t)
{
    return t->config.bending == VBSS_THREAD_BENDING_SPLINE ? THREAD_BANDWIDTH
                                                           : THREAD_BANDWIDTH - 1;
}

/* Prescribed nodes have no unknowns. A node with a spring and its neighbours are separators, in a
 * group as wide as the bandwidth. */
static void set_roles(const thread_object *t, vbss_system *s, uint32_t first,
                      const uint8_t *separators)
{
    uint32_t n = t->node_count;
    for (uint32_t i = 0; separators != NULL && i < n; i++) {
        if (separators[i] != 0) {
            vbss_system_set_role(s, first + i, VBSS_ROLE_SEPARATOR);
        }
    }
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id != 0 && a->kind == VBSS_THREAD_ATTACHMENT_SPRING) {
            uint32_t low = a->node > 0 ? a->node - 1 : 0;
            low = low + THREAD_BANDWIDTH <= n ? low
                  : n > THREAD_BANDWIDTH      ? n - THREAD_BANDWIDTH
                                              : 0;
            for (uint32_t i = low; i < low + THREAD_BANDWIDTH && i < n; i++) {
                vbss_system_set_role(s, first + i, VBSS_ROLE_SEPARATOR);
            }
        }
    }
    for (uint32_t i = 0; i < n; i++) {
        if (t->prescribed_by[i] != 0) {
            vbss_system_set_role(s, first + i, VBSS_ROLE_PRESCRIBED);
        }
    }
}

vbss_result vbss_thread_add_to_system(thread_object *t, vbss_system *s, const uint8_t *separators,
                                      uint32_t *first)
{
    uint32_t n = t->node_count, bandwidth = vbss_thread_bandwidth(t);
    VBSS_TRY(vbss_system_add_chain(s, n, first));
    set_roles(t, s, *first, separators);
    for (uint32_t i = 0; i < n; i++) {
        for (uint32_t k = 1; k <= THREAD_BANDWIDTH; k++) {
            t->couplings[i][k - 1] = VBSS_NO_COUPLING;
            if (k <= bandwidth && i + k < n) {
                VBSS_TRY(
                    vbss_system_couple(s, *first + i, *first + i + k, &t->couplings[i][k - 1]));
            }
        }
    }
    return VBSS_OK;
}

static vbss_result build_sparsity(thread_object *t)
{
    uint32_t first = 0;
    vbss_system_begin_pattern(t->system);
    VBSS_TRY(vbss_thread_add_to_system(t, t->system, NULL, &first));
    return vbss_system_analyse(t->system);
}

void vbss_thread_compute_masses(thread_object *t)
{
    find_prescribed_nodes(t);
    lump_mass(t);
    add_attached_masses(t);
}

vbss_result vbss_thread_update_derived(thread_object *t)
{
    if (t->is_derived_valid) {
        return VBSS_OK;
    }
    vbss_thread_compute_masses(t);
    find_sections(t);
    if (t->bending_matrix != NULL) {
        vbss_thread_build_bending(t);
    }
    if (thread_has_twist(t)) {
        vbss_thread_list_section_holders(t);
    }
    t->is_derived_valid = true;
    t->is_sparsity_valid = false;
    return VBSS_OK;
}

vbss_result vbss_thread_update_sparsity(thread_object *t)
{
    VBSS_TRY(vbss_thread_update_derived(t));
    if (!t->is_sparsity_valid && t->system != NULL) {
        VBSS_TRY(build_sparsity(t));
        t->is_sparsity_valid = true;
    }
    return VBSS_OK;
}

vbss_result vbss_thread_prepare_query(thread_object *t)
{
    VBSS_TRY(vbss_thread_update_derived(t));
    vbss_thread_set_clamp_directions(t, 0.0);
    return VBSS_OK;
}

void vbss_thread_invalidate(thread_object *t)
{
    t->generation++;
    t->edit_generation++;
    t->is_derived_valid = false;
    t->is_acceleration_unknown = true;
}
