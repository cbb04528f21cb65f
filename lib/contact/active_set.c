/* Primal-dual active set: finds the status of all constraints and the increments of all separators.
 *
 * Each iteration solves with the present status of every constraint, evaluates the status that the
 * solution implies, and repeats until they agree. No solution is accepted without this evaluation.
 * If a solve overshoots, the line search accepts a fraction of it, and the next solve starts from
 * there. */
#include "contact/contact.h"
#include "contact/tuning.h"

#include <string.h>

static uint64_t solve_cost(const vbss_system *system)
{
    uint32_t separators = system->unknown_count - system->interior_count;
    return system->elimination.product_count + (uint64_t)CONTACT_SEPARATOR_COST * separators;
}

static bool solve(contact_set *set, const contact_active_set_options *options)
{
    vbss_system *system = options->system;
    vbss_system_load_schur_complement(system);
    for (uint32_t i = 0; i < options->weld_count; i++) {
        vbss_contact_eliminate_weld(&options->welds[i], system);
    }
    for (uint32_t i = 0; i < options->spring_count; i++) {
        vbss_contact_assemble_spring(&options->springs[i], system);
    }
    vbss_contact_assemble(set, system);
    set->counters.solves++;
    set->counters.operations += solve_cost(system);
    return vbss_system_solve_separators(system);
}

/* Motion of the contact point for the increment of a rotation. */
static vec3 rotate_point(const contact_jacobian_block *term, vec3 d)
{
    const double roll = term->component == 0 ? d.x : term->component == 1 ? d.y : d.z;
    return term->is_roll ? vec3_scale(term->arm, roll) : vec3_cross(d, term->arm);
}

static vec3 relative_motion(const contact_constraint *constraint, const vbss_system *system)
{
    vec3 u = vec3_zero();
    for (uint32_t p = 0; p < constraint->jacobian_block_count; p++) {
        const contact_jacobian_block *jacobian_block = &constraint->jacobian[p];
        if (system->roles[jacobian_block->block] == VBSS_ROLE_SEPARATOR) {
            vec3 d = system->solution[jacobian_block->block];
            if (jacobian_block->is_rotation) {
                d = rotate_point(jacobian_block, d);
            }
            u = vec3_add_scaled(u, jacobian_block->weight, d);
        }
    }
    return u;
}

/* ---- residual of a solve */

/* The violation of the contact law: an overlap for open constraints, a force for closed ones. */
typedef struct active_set_residual {
    double force, normal_force; /* largest values, N */
    double overlap;             /* largest value, relative to the thickness */
} active_set_residual;

static bool is_open(const contact_solution *solution)
{
    return solution->status == CONTACT_OPEN;
}

static active_set_residual evaluate_residual(contact_set *set,
                                             const contact_active_set_options *options)
{
    active_set_residual residual = {0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        contact_solution *next = &set->next_solutions[i];
        vec3 u = relative_motion(constraint, options->system);
        double violation = vbss_contact_update_solution(constraint, u, next);
        set->candidate[i] = (contact_iterate){u, vbss_contact_linearised_force(constraint, u)};
        if (is_open(&constraint->solution)) {
            double overlap = violation / (constraint->stiffness * constraint->thickness);
            /* this overlap is too small to close the contact */
            if (overlap <= options->overlap_tolerance) {
                *next = constraint->solution;
                overlap = 0.0;
            }
            residual.overlap = vbss_max_or_nan(overlap, residual.overlap);
        } else {
            residual.force = vbss_max_or_nan(violation, residual.force);
            /* The force of a tie does not measure how much a contact matters. */
            residual.normal_force = vbss_max(constraint->is_bilateral ? 0.0 : next->normal_force,
                                             residual.normal_force);
        }
    }
    return residual;
}

static void accept_solution(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        set->constraints[i].solution = set->next_solutions[i];
    }
}

/* ---- line search
 *
 * The iterates before and after a solve are in equilibrium, and so is every interpolation of both
 * with interpolated forces. The slope is the work of the residual of such a force along the step.
 * It is negative as long as the contact law drives the motion on, and zero where the contacts would
 * stop. For fixed friction bounds, the energy along the step is minimal there. */

/* False position; an end that stays twice counts half (Illinois). Where a contact closes along the step, the slope rises
 * sharply, and false position stays before it. All states would stay as they are, and the next solve would lead to the same
 * point. The search then bisects, and continues beyond. */
static double line_search(contact_set *set, bool wide, bool softened)
{
    vbss_contact_begin_line_search(set, wide);
    double low = 0.0, high = 1.0, slope_low = vbss_contact_line_search_slope(set, wide, low),
           slope_high = vbss_contact_line_search_slope(set, wide, high);
    const double initial_descent = -slope_low;
    /* friction may drive the step alone, and has no energy to minimise */
    if (!(initial_descent > 0.0)) {
        return slope_high > -initial_descent ? CONTACT_DOUBTFUL_STEP_FRACTION : 1.0;
    }
    if (!(slope_high > CONTACT_FULL_STEP_SLOPE_RATIO * initial_descent)) {
        return 1.0;
    }
    double fraction = high, slope = slope_high;
    for (int k = 0, side = 0; k < CONTACT_FALSE_POSITION_STEPS &&
                              fabs(slope) > CONTACT_SLOPE_TOLERANCE * initial_descent;
         k++) {
        fraction = low - slope_low * (high - low) / (slope_high - slope_low);
        slope = vbss_contact_line_search_slope(set, wide, fraction);
        if (slope > 0.0) {
            high = fraction;
            slope_high = slope;
            slope_low *= side > 0 ? 0.5 : 1.0;
            side = 1;
        } else {
            low = fraction;
            slope_low = slope;
            slope_high *= side < 0 ? 0.5 : 1.0;
            side = -1;
        }
    }
    if (fraction >= (softened ? CONTACT_MIN_STEP_FRACTION : CONTACT_SHORT_STEP_FRACTION) ||
        fabs(slope) <= CONTACT_SLOPE_TOLERANCE * initial_descent) {
        return vbss_max(fraction, CONTACT_MIN_STEP_FRACTION);
    }
    for (int k = 0;
         k < CONTACT_BISECTION_STEPS && fabs(slope) > CONTACT_SLOPE_TOLERANCE * initial_descent;
         k++) {
        fraction = 0.5 * (low + high);
        slope = vbss_contact_line_search_slope(set, wide, fraction);
        if (slope > 0.0) {
            high = fraction;
        } else {
            low = fraction;
        }
    }
    return vbss_max(fabs(slope) > CONTACT_SLOPE_TOLERANCE * initial_descent ? high : fraction,
                    CONTACT_MIN_STEP_FRACTION);
}

/* Moves to the iterate from which the next solve continues. The first solve has no earlier
 * iterate. */
static void advance_iterates(contact_set *set, const contact_active_set_options *options,
                             bool first, bool softened)
{
    double fraction = first ? 1.0 : line_search(set, options->system->wide, softened);
    for (uint32_t i = 0; i < set->count; i++) {
        if (fraction < 1.0) {
            set->current[i] = contact_iterate_lerp(&set->current[i], &set->candidate[i], fraction);
            vbss_contact_solution_at(&set->constraints[i], &set->current[i],
                                     &set->next_solutions[i]);
        } else {
            set->current[i] = set->candidate[i];
        }
    }
    if (options->operation_limit > 0) {
        vbss_system_advance_line_search(options->system, fraction);
    }
}

/* ---- iteration */

/* An iteration that reduces the residual with each solve continues until it has converged. */
static void track_convergence(contact_active_set_progress *progress,
                              const contact_active_set_options *options,
                              const active_set_residual *residual, bool first)
{
    double relative_residual =
        vbss_max(residual->force / (residual->normal_force + options->absolute_force_tolerance),
                 residual->overlap);
    progress->stalled_solves++;
    if (first || relative_residual <= CONTACT_PROGRESS_RATIO * progress->reference_residual) {
        progress->reference_residual = relative_residual;
        progress->stalled_solves = 0;
    }
}

static void scale_stiffness(contact_set *set, contact_active_set_progress *progress, double factor)
{
    for (uint32_t i = 0; i < set->count; i++) {
        if (!set->constraints[i].is_bilateral) { /* the status of a tie is fixed */
            /* exact, because the factor is a power of two */
            set->constraints[i].stiffness *= factor;
        }
    }
    progress->stiffness_scale *= factor;
    progress->solves_at_scale = 0;
}

static void soften_or_stiffen(contact_set *set, contact_active_set_progress *progress,
                              const active_set_residual *residual, double loose_tolerance)
{
    progress->solves_at_scale++;
    if (progress->stiffness_scale < 1.0) {
        bool is_converged =
            residual->overlap <= CONTACT_SOFT_OVERLAP && residual->force <= loose_tolerance;
        if (is_converged || progress->solves_at_scale == CONTACT_SOFT_SOLVES) {
            scale_stiffness(set, progress, CONTACT_STIFFEN_FACTOR);
        }
        return;
    }
    bool is_deep = progress->solves_at_scale <= CONTACT_DEEP_SOLVES &&
                   residual->overlap > CONTACT_DEEP_OVERLAP;
    if (!progress->has_softened && (is_deep || progress->solves_at_scale == CONTACT_STUCK_SOLVES)) {
        progress->has_softened = true;
        scale_stiffness(set, progress, CONTACT_SOFT_STIFFNESS_SCALE);
    }
}

/* The yield force of a sleeve rises with its transverse force. Where that is nearly zero its direction may turn with each
 * solve, so that two solutions alternate. The linearisation then takes the mean of the last transverse forces, which
 * has no direction. */
static void lag_cycling_sleeves(contact_set *set, const contact_active_set_options *options)
{
    for (uint32_t i = 0; i < set->count; i++) {
        contact_constraint *constraint = &set->constraints[i];
        contact_solution next;
        if (constraint->is_sleeve && constraint->may_lag &&
            vbss_contact_update_solution(constraint, relative_motion(constraint, options->system),
                                         &next) > 0.0) {
            const double transverse = vec3_norm(next.tangential_force),
                         lagged = constraint->lagged_transverse;
            constraint->lagged_transverse =
                lagged == 0.0 ? transverse : 0.5 * (lagged + transverse);
        }
    }
}

static void clear_lags(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        set->constraints[i].lagged_transverse = 0.0;
    }
}

/* Classifies the last solve: converged, inexact, or not converged. */
static contact_outcome classify_outcome(const contact_active_set_options *options,
                                        const contact_active_set_progress *progress,
                                        const active_set_residual *residual)
{
    double tolerance = options->relative_force_tolerance * residual->normal_force +
                       options->absolute_force_tolerance;
    double loose_tolerance =
        options->loose_force_tolerance * residual->normal_force + options->absolute_force_tolerance;
    if (progress->stiffness_scale < 1.0) { /* solved with a reduced stiffness */
        return CONTACT_NOT_CONVERGED;
    }
    if (residual->overlap == 0.0 && residual->force <= tolerance) {
        return CONTACT_CONVERGED;
    }
    /* The status may cycle where friction and two neighbouring constraints contradict each other.
     * The residual is small then, and the next substep corrects it. */
    bool may_be_inexact =
        progress->has_softened || progress->stalled_solves + 1 >= options->max_stalled_solves;
    bool is_inexact = may_be_inexact && residual->overlap <= options->loose_overlap_tolerance &&
                      residual->force <= loose_tolerance;
    return is_inexact ? CONTACT_INEXACT : CONTACT_NOT_CONVERGED;
}

static bool is_limit_reached(const contact_set *set, const contact_active_set_options *options)
{
    return options->operation_limit > 0 &&
           set->counters.operations + solve_cost(options->system) > options->operation_limit;
}

bool vbss_contact_must_suspend(contact_set *set, uint64_t operations)
{
    contact_call_budget *budget = &set->call_budget;
    bool is_exhausted = budget->operation_limit > 0 && budget->has_progress &&
                        set->counters.operations + operations > budget->operation_limit;
    if (budget->is_replay ? budget->checks_passed == budget->replay_checks : is_exhausted) {
        return true;
    }
    budget->checks_passed++;
    budget->has_progress = true;
    return false;
}

static contact_outcome iterate_active_set(contact_set *set,
                                          const contact_active_set_options *options,
                                          contact_active_set_progress *progress)
{
    while (progress->solve_count < options->max_solves) {
        if (vbss_contact_must_suspend(set, solve_cost(options->system))) {
            return CONTACT_SUSPENDED;
        }
        const bool first = progress->solve_count++ == 0;
        if (!solve(set, options)) {
            return CONTACT_SINGULAR;
        }
        const active_set_residual residual = evaluate_residual(set, options);
        track_convergence(progress, options, &residual, first);
        contact_outcome outcome = classify_outcome(options, progress, &residual);
        set->residual = residual.force;
        if (outcome == CONTACT_NOT_CONVERGED &&
            progress->stalled_solves >= CONTACT_LAG_STALLED_SOLVES) {
            lag_cycling_sleeves(set, options);
            progress->has_lagged = true;
        }
        if (outcome == CONTACT_NOT_CONVERGED) {
            advance_iterates(set, options, first && !options->starts_from_current,
                             progress->has_softened);
            if (is_limit_reached(set, options)) {
                vbss_system_accept_line_search(options->system);
                set->is_stopped_early = true;
                outcome = CONTACT_INEXACT;
            }
        } else { /* a further linearisation continues from there */
            memcpy(set->current, set->candidate, set->count * sizeof *set->current);
        }
        accept_solution(set);
        if (outcome != CONTACT_NOT_CONVERGED) {
            set->counters.inexact += outcome == CONTACT_INEXACT;
            return outcome;
        }
        soften_or_stiffen(set, progress, &residual,
                          options->loose_force_tolerance * residual.normal_force +
                              options->absolute_force_tolerance);
    }
    return CONTACT_NOT_CONVERGED;
}

static void set_sliding_forces(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        contact_constraint *constraint = &set->constraints[i];
        if (constraint->is_sliding) {
            constraint->sliding_force =
                vec3_add_scaled(constraint->solution.tangential_force,
                                constraint->solution.normal_force, constraint->normal);
        }
    }
}

/* Starts with zero displacement and the present forces. */
static void begin_line_search(contact_set *set, const contact_active_set_options *options)
{
    vbss_system_begin_line_search(options->system);
    for (uint32_t i = 0; options->starts_from_current && i < set->count; i++) {
        set->current[i].u = vec3_zero();
    }
}

contact_outcome vbss_contact_solve_active_set(contact_set *set,
                                              const contact_active_set_options *options)
{
    contact_active_set_progress *progress = &set->progress;
    if (!options->is_resumed) {
        if (progress->has_lagged) {
            clear_lags(set);
        }
        *progress = (contact_active_set_progress){.stiffness_scale = 1.0};
        set->is_stopped_early = false;
        set_sliding_forces(set);
        if (options->operation_limit > 0) {
            begin_line_search(set, options);
        }
    }
    contact_outcome result = iterate_active_set(set, options, progress);
    if (result != CONTACT_SUSPENDED) {
        scale_stiffness(set, progress, 1.0 / progress->stiffness_scale);
    }
    return result;
}

void vbss_contact_save_solution(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        set->saved_solutions[i] = set->constraints[i].solution;
    }
    set->was_stopped_early = set->is_stopped_early;
}

void vbss_contact_restore_solution(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        contact_solution *solution = &set->constraints[i].solution;
        *solution = set->saved_solutions[i];
        set->current[i].force = vec3_add_scaled(solution->tangential_force, solution->normal_force,
                                                set->constraints[i].normal);
    }
    set->is_stopped_early = set->was_stopped_early;
}
