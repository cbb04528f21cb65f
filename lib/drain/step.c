/* Implicit step of a drain on its own: [assemble -> solve -> correction] -> commit, at half the
 * size where a node would move too far.
 *
 * An old tangent fails once the surface has turned by 0.1 to 0.2 rad, so it is kept for less (tangent.c), and only
 * in the first linearisation: more of them serve reference solutions. The correction solves for new right-hand sides with the old factor and
 * leaves a tenth of the error. It is dropped if it is not small, as after a snap it may point
 * anywhere (docs/explanation/drain.md). */
#include "base/error.h"
#include "drain/drain.h"

static double solve_increment(drain_object *d)
{
    vbss_system_load_schur_complement(d->system);
    bool solved = vbss_system_solve(d->system);
    return solved ? vbss_drain_largest_increment(d, d->system, 0) : (double)INFINITY;
}

/* Largest increments of the first solve and of the correction, m; infinite if there is no
 * solution. */
typedef struct increment_sizes {
    double newton, correction;
} increment_sizes;

/* Assembles and solves once, with a correction if nodes have moved. False: there is no solution. */
static bool linearise(drain_object *d, const drain_substep *substep, bool is_first,
                      increment_sizes *m)
{
    *m = (increment_sizes){0.0, 0.0};
    vbss_drain_choose_tangent(d, substep->h, is_first ? vbss_drain_tangent_distance(d) : 0.0);
    vbss_system_reuse_factor(d->system, 0, d->factored_in == d->system);
    vbss_system_clear(d->system);
    vbss_drain_assemble(d, substep, d->system, 0);
    if (!vbss_system_condense(d->system)) {
        return false;
    }
    d->factored_in = d->system;
    m->newton = solve_increment(d);
    if (!(m->newton < 1e100)) {
        return false;
    }
    vbss_drain_apply_increment(d, d->system, 0);
    if (m->newton <= d->config.position_tolerance) {
        return true;
    }
    vbss_drain_assemble_rhs(d, substep, d->system, 0);
    vbss_system_condense_rhs(d->system);
    m->correction = solve_increment(d);
    if (m->correction < DRAIN_MAX_CORRECTION_RATIO * m->newton) {
        vbss_drain_apply_increment(d, d->system, 0);
    } else {
        d->statistics.corrections_dropped++;
    }
    return true;
}

/* Solves a substep. False: there is no solution. `exceeds_move_limit`: the result is useless if the
 * substep can be halved. */
static bool try_substep(drain_object *d, const drain_substep *substep, bool can_halve,
                        bool *exceeds_move_limit)
{
    increment_sizes m = {0.0, 0.0}; /* those of the last linearisation */
    uint32_t limit = d->config.iteration_limit;
    *exceeds_move_limit = false;
    vbss_drain_reset_trial(d);
    vbss_drain_begin_tangent(d);
    for (uint32_t k = 0; k < limit; k++) {
        if (!linearise(d, substep, k == 0, &m)) {
            return false;
        }
        d->statistics.linearisations++;
        if (k == 0 && m.newton > d->config.move_limit) {
            limit++;
            *exceeds_move_limit = m.newton > DRAIN_MAX_MOVE_RATIO * d->config.move_limit;
            d->statistics.forced += *exceeds_move_limit && !can_halve;
        }
        if (*exceeds_move_limit && can_halve) {
            return true;
        }
        if (m.newton <= d->config.position_tolerance) {
            break;
        }
    }
    d->statistics.last_correction = m.correction;
    return true;
}

/* Runs substeps to the end of the step. Their sizes are powers of 1/2, so they sum to 1 exactly. */
static bool run_substeps(drain_object *d, double h, drain_substep *substep)
{
    double start = 0.0, fraction = 1.0, min_fraction = 1.0;
    for (uint32_t k = 0; k < d->config.halving_limit; k++) {
        min_fraction *= 0.5;
    }
    while (start < 1.0) {
        bool exceeds_move_limit;
        *substep = (drain_substep){h * fraction, start + fraction};
        if (!try_substep(d, substep, fraction > min_fraction, &exceeds_move_limit)) {
            return false;
        }
        if (exceeds_move_limit && fraction > min_fraction) {
            fraction *= 0.5;
            continue;
        }
        vbss_drain_commit(d, substep->h);
        start += fraction;
    }
    return d->statistics.last_move < 1e100;
}

/* ---- the step */

static vbss_result update_sparsity(drain_object *d)
{
    uint32_t first;
    if (!d->is_sparsity_valid) {
        vbss_system_begin_pattern(d->system);
        d->factored_in = NULL;
        VBSS_TRY(vbss_drain_add_to_system(d, d->system, NULL, &first));
        VBSS_TRY(vbss_system_analyse(d->system));
        vbss_drain_set_assembly_map(d, d->system);
        d->is_sparsity_valid = true;
    }
    return VBSS_OK;
}

vbss_result vbss_drain_implicit_step(drain_object *d, double h)
{
    drain_substep substep = {h, 1.0}; /* after run_substeps: the last substep */
    VBSS_TRY(update_sparsity(d));
    if (!run_substeps(d, h, &substep)) {
        return vbss_fail(d->context, VBSS_ERROR_NOT_FINITE,
                         "drain step: no finite state after step %llu",
                         (unsigned long long)d->statistics.steps);
    }
    vbss_drain_finish_substeps(d, substep.h);
    return VBSS_OK;
}
