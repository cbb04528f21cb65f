/* Newton iterations on one system of all bodies and contacts, until threads have their lengths.
 *
 *   assemble bodies -> condense -> active set -> back-substitute -> trial state -> contacts
 *
 * Where drains have moved, a correction follows: new right-hand sides, solved with the old
 * factor. */
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/tuning.h"
#include "scene/world/world.h"
#include "thread/bending_memory.h"
#include "thread/twist.h"

/* A larger number means that the iteration has diverged. */
#define DIVERGENCE_LIMIT 1e100

/* ---- one linearisation */

/* Parts of the system that an assembly computes. With ASSEMBLE_RHS the matrix is not read. */
typedef enum assembly_scope { ASSEMBLE_ALL, ASSEMBLE_RHS } assembly_scope;

/* Drains that have moved little since an earlier linearisation keep its matrix; over budget, all of them do. */
static void choose_tangents(scene_object *s)
{
    const bool is_over_budget = s->step.newton.over_budget_linearisations > 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            scene_drain *b = &s->bodies[i].drain;
            vbss_drain_choose_tangent(b->drain, b->substep.h,
                                      is_over_budget ? (double)INFINITY
                                                     : vbss_drain_tangent_distance(b->drain));
        }
    }
}

static void clear_system(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_drain *b = &s->bodies[i].drain;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            vbss_system_reuse_factor(s->system, b->first_block, b->drain->factored_in == s->system);
        }
    }
    vbss_system_clear(s->system);
}

static void assemble_drain(scene_drain *b, vbss_system *system, assembly_scope scope)
{
    if (scope == ASSEMBLE_RHS) {
        vbss_drain_assemble_rhs(b->drain, &b->substep, system, b->first_block);
    } else {
        vbss_drain_assemble(b->drain, &b->substep, system, b->first_block);
    }
}

static void assemble(scene_object *s, const scene_substep *substep, assembly_scope scope)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction,
                                  substep->end_fraction};
    vbss_system *system = s->system;
    if (scope != ASSEMBLE_RHS) {
        clear_system(s);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (scene_active_kind(b) == SCENE_BODY_THREAD) {
            if (thread_has_memory(b->thread.thread)) {
                vbss_thread_update_bending_memory(b->thread.thread,
                                                  b->thread.substep.integration->h);
            }
            if (thread_has_twist(b->thread.thread)) {
                vbss_thread_update_twist(b->thread.thread, &b->thread.substep);
            }
            VBSS_WIDE_CALL(system->wide, vbss_thread_assemble, b->thread.thread, &b->thread.substep,
                           system, b->thread.first_block);
            if (thread_has_friction_torque(b->thread.thread)) {
                vbss_scene_assemble_rolls(s, &b->thread);
            }
        } else if (scene_active_kind(b) == SCENE_BODY_RIGID &&
                   b->rigid.kind != VBSS_SCENE_RIGID_DRIVEN) {
            vbss_rigid_assemble(&b->rigid.body, &p, &b->rigid.predicted, &b->rigid.trial, system,
                                &b->rigid.blocks);
        } else if (scene_active_kind(b) == SCENE_BODY_RIGID) {
            vbss_scene_assemble_surface(s, &b->rigid);
        } else if (scene_active_kind(b) == SCENE_BODY_DRAIN) {
            assemble_drain(&b->drain, system, scope);
        }
    }
}

/* Removes stiffness of compression from threads after a negative pivot: a short bent end carries
 * less compression than a straight thread. False: no thread has such stiffness left. */
static bool drop_compression_stiffness(scene_object *s)
{
    bool has_dropped = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_thread *b = &s->bodies[i].thread;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD && b->substep.min_tension < 0.0) {
            b->substep.min_tension = 0.0;
            b->thread->statistics.softened++;
            has_dropped = true;
        }
    }
    return has_dropped;
}

/* Of an assembly of all but the matrices of drains. */
static uint32_t cost_of_rhs(const scene_object *s)
{
    uint32_t sum = SCENE_NODE_COST * s->node_count + SCENE_CONSTRAINT_COST * s->contacts->count;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            sum += SCENE_CORRECTION_COST * s->bodies[i].drain.drain->mesh.triangle_count;
        }
    }
    return sum;
}

static uint32_t cost_of_matrix(const scene_body *b)
{
    return scene_active_kind(b) == SCENE_BODY_DRAIN
               ? (SCENE_TRIANGLE_COST - SCENE_CORRECTION_COST) * b->drain.drain->mesh.triangle_count
               : 0;
}

static uint32_t cost_of_new_matrices(const scene_object *s)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        sum += s->bodies[i].kind == SCENE_BODY_DRAIN && !s->bodies[i].drain.drain->keeps_tangent
                   ? cost_of_matrix(&s->bodies[i])
                   : 0;
    }
    return sum;
}

uint32_t vbss_scene_linearisation_cost(const scene_object *s)
{
    uint32_t sum = cost_of_rhs(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        sum += cost_of_matrix(&s->bodies[i]);
    }
    return sum;
}

/* Operations that a search may use: the step budget minus one more linearisation with a solve,
 * which costs half as much. */
static uint64_t find_search_budget(const scene_object *s)
{
    uint64_t next_linearisation_cost =
        (uint64_t)vbss_scene_linearisation_cost(s) * SCENE_RESERVE_HALVES / 2;
    return s->step.budget == 0                        ? 0
           : next_linearisation_cost < s->step.budget ? s->step.budget - next_linearisation_cost
                                                      : 1;
}

/* Finds the active set of the condensed system, then the increments of all blocks. */
static scene_substep_outcome solve_active_set(scene_object *s)
{
    scene_newton_state *newton = &s->step.newton;
    const contact_active_set_options search = {
        .system = s->system,
        .welds = s->step.welds,
        .weld_count = s->step.weld_count,
        .springs = s->step.springs,
        .spring_count = s->step.spring_count,
        .max_solves = s->solver.active_set_limit,
        .relative_force_tolerance = SCENE_FORCE_TOLERANCE_RATIO,
        .absolute_force_tolerance = SCENE_FORCE_TOLERANCE,
        .overlap_tolerance = SCENE_OVERLAP_TOLERANCE,
        .max_stalled_solves = SCENE_MAX_STALLED_SOLVES,
        .loose_force_tolerance = SCENE_LOOSE_FORCE_TOLERANCE,
        .loose_overlap_tolerance = SCENE_LOOSE_OVERLAP_TOLERANCE,
        .operation_limit = newton->search_budget,
        .starts_from_current = newton->starts_from_current && s->step.budget > 0,
        .is_resumed = newton->is_suspended};
    contact_outcome outcome = vbss_contact_solve_active_set(s->contacts, &search);
    newton->is_suspended = outcome == CONTACT_SUSPENDED;
    if (outcome == CONTACT_SUSPENDED) {
        return SCENE_SUBSTEP_SUSPENDED;
    }
    if (outcome == CONTACT_SINGULAR) {
        return SCENE_SUBSTEP_SINGULAR;
    }
    for (uint32_t i = 0; i < s->step.weld_count; i++) {
        s->system->solution[s->step.welds[i].node] =
            vbss_contact_weld_increment(&s->step.welds[i], s->system);
    }
    vbss_system_back_substitute(s->system);
    return outcome == CONTACT_NOT_CONVERGED ? SCENE_SUBSTEP_NO_ACTIVE_SET : SCENE_SUBSTEP_ACCEPTED;
}

static void note_factors(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            s->bodies[i].drain.drain->factored_in = s->system;
        }
    }
}

/* Assembles and condenses the system. */
static scene_substep_outcome linearise(scene_object *s, const scene_substep *substep)
{
    scene_newton_state *newton = &s->step.newton;
    newton->search_budget = find_search_budget(s);
    newton->starts_from_current = newton->linearisations > 0;
    choose_tangents(s);
    vbss_scene_charge_budget(s, cost_of_rhs(s) + cost_of_new_matrices(s));
    assemble(s, substep, ASSEMBLE_ALL);
    vbss_scene_set_weld_arms(s);
    s->report.statistics.linearisations++;
    while (!vbss_system_condense(s->system)) {
        if (!drop_compression_stiffness(s)) {
            return SCENE_SUBSTEP_SINGULAR;
        }
        assemble(s, substep, ASSEMBLE_ALL);
        vbss_scene_set_weld_arms(s);
    }
    note_factors(s);
    return SCENE_SUBSTEP_ACCEPTED;
}

/* ---- trial state */

static void advance_rigid(scene_object *s, scene_rigid *r)
{
    if (r->kind != VBSS_SCENE_RIGID_DRIVEN) {
        vbss_rigid_apply_increment(&r->trial, s->system->solution[r->blocks.first],
                                   s->system->solution[r->blocks.first + 1]);
        for (uint32_t c = 0; c < r->capsule_count; c++) {
            vbss_scene_transform_trial_capsule(&s->capsules[r->first_capsule + c], r->trial);
        }
    }
    vbss_scene_advance_surface(s, r);
}

static void set_welded_nodes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        const scene_body *thread = vbss_scene_body(s, p->thread);
        if (p->id != 0 && p->attachment == 0 && !thread->is_frozen) {
            thread_object *t = thread->thread.thread;
            const scene_rigid *r = &vbss_scene_body(s, p->body)->rigid;
            t->trial[p->node] = pose_apply(r->trial, p->point);
        }
    }
}

static void advance_trial(scene_object *s)
{
    scene_newton_state *newton = &s->step.newton;
    newton->is_finite = newton->is_converged = true;
    newton->stretch = 0.0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (scene_active_kind(b) == SCENE_BODY_THREAD) {
            b->thread.residual_displacement = vbss_thread_apply_increment(
                b->thread.thread, &b->thread.substep, s->system->solution + b->thread.first_block);
            if (thread_has_friction_torque(b->thread.thread)) {
                vbss_scene_advance_rolls(s, &b->thread);
            }
        } else if (scene_active_kind(b) == SCENE_BODY_RIGID) {
            advance_rigid(s, &b->rigid);
        } else if (scene_active_kind(b) == SCENE_BODY_DRAIN) {
            vbss_drain_apply_increment(b->drain.drain, s->system, b->drain.first_block);
        }
    }
    set_welded_nodes(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (scene_active_kind(b) != SCENE_BODY_THREAD) {
            continue;
        }
        thread_object *t = b->thread.thread;
        vbss_thread_compute_strains(t, t->trial, t->strains);
        double stretch = vbss_thread_record_stretch(t, t->trial_tension),
               residual_displacement = b->thread.residual_displacement;
        bool has_contacts = b->thread.has_contacts;
        /* The residual displacement assumes that a node is free to move, so it says nothing about a
         * thread in contact. */
        bool is_balanced = has_contacts || residual_displacement <= t->config.position_tolerance;
        double tolerance = has_contacts ? s->solver.stretch_tolerance : t->config.stretch_tolerance;
        newton->is_finite = newton->is_finite && stretch < DIVERGENCE_LIMIT;
        newton->is_converged = newton->is_converged && is_balanced && stretch <= tolerance;
        newton->stretch = vbss_max_or_nan(stretch, newton->stretch);
    }
}

/* ---- displacements of drains */

typedef struct drain_moves {
    /* `needs_correction`: some node moved beyond the tolerance; `is_too_far`: so far that the
     * substep is halved. */
    bool is_finite, needs_correction, is_too_far;
} drain_moves;

static drain_moves measure_drain_moves(scene_object *s)
{
    drain_moves m = {true, false, false};
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            const vbss_drain_config *c = &b->drain->config;
            b->max_increment = vbss_drain_largest_increment(b->drain, s->system, b->first_block);
            b->drain->statistics.linearisations++;
            m.is_finite = m.is_finite && b->max_increment < DIVERGENCE_LIMIT;
            m.needs_correction = m.needs_correction || b->max_increment > c->position_tolerance;
            m.is_too_far = m.is_too_far || b->max_increment > DRAIN_MAX_MOVE_RATIO * c->move_limit;
        }
    }
    return m;
}

/* Whether a needle in a hole has turned too far for one linearisation. */
static bool has_needle_turned_far(const scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        const scene_body *b = hole->id != 0 ? vbss_scene_body(s, hole->needle) : NULL;
        if (b != NULL && !b->is_frozen &&
            vec3_norm(s->system->solution[b->rigid.blocks.first + 1]) > SCENE_MAX_NEEDLE_ROTATION) {
            return true;
        }
    }
    return false;
}

/* Counts drains that moved too far in a substep that cannot be halved. */
static void count_forced(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            b->drain->statistics.forced +=
                b->max_increment > DRAIN_MAX_MOVE_RATIO * b->drain->config.move_limit;
        }
    }
}

/* Whether the correction is small enough for all drains and threads. The old factor may send a
 * thread anywhere once its segments have turned. */
static bool is_correction_acceptable(scene_object *s)
{
    bool all = true;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD) {
            const scene_thread *a = &s->bodies[i].thread;
            double missed =
                vbss_thread_linearisation_error(a->thread, s->system->solution + a->first_block);
            all = all && missed <= s->solver.stretch_tolerance;
        }
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            double correction = vbss_drain_largest_increment(b->drain, s->system, b->first_block);
            bool small = correction < DRAIN_MAX_CORRECTION_RATIO * b->max_increment ||
                         correction <= b->drain->config.position_tolerance;
            b->drain->statistics.last_correction = correction;
            b->drain->statistics.corrections_dropped += !small;
            all = all && small;
        }
    }
    return all;
}

/* Whether some drain moved so far that one more linearisation follows. */
static bool has_drain_moved_far(const scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_drain *b = &s->bodies[i].drain;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN &&
            b->max_increment > b->drain->config.move_limit) {
            return true;
        }
    }
    return false;
}

/* Starts a correction: forces at the trial state become right-hand sides for the factor of the
 * last linearisation. */
static void begin_correction(scene_object *s, const scene_substep *substep)
{
    s->step.newton.search_budget = find_search_budget(s);
    s->step.newton.starts_from_current = s->step.newton.has_correction = true;
    vbss_scene_charge_budget(s, cost_of_rhs(s));
    vbss_contact_save_solution(s->contacts);
    assemble(s, substep, ASSEMBLE_RHS);
    vbss_scene_set_weld_arms(s);
    vbss_system_condense_rhs(s->system);
}

/* Applies the correction, or drops it if it is not acceptable. */
static scene_substep_outcome end_correction(scene_object *s, scene_substep_outcome outcome)
{
    if (outcome != SCENE_SUBSTEP_ACCEPTED || !is_correction_acceptable(s)) {
        vbss_contact_restore_solution(s->contacts);
        return SCENE_SUBSTEP_ACCEPTED;
    }
    advance_trial(s);
    vbss_scene_refresh_contacts(s);
    return s->step.newton.is_finite ? SCENE_SUBSTEP_ACCEPTED : SCENE_SUBSTEP_SINGULAR;
}

/* ---- convergence */

/* Whether lengths will not converge in time. Asked only if at most one more search fits into the
 * budget, and never for a substep of minimum size, which has to converge. */
static bool is_diverging(const scene_object *s, const scene_substep *substep,
                         double previous_stretch)
{
    double stretch = s->step.newton.stretch;
    bool is_last_search =
        s->step.budget > 0 && s->contacts->counters.operations >= find_search_budget(s);
    return is_last_search && !substep->is_min_size && stretch > SCENE_DIVERGING_STRETCH &&
           stretch > SCENE_CONVERGING_RATIO * previous_stretch;
}

/* Whether the step has operations to spare for a correction. It repeats the search, and a search that
 * its limit stops is less accurate than the correction is worth. Parts of a step, which leave trouble,
 * always get theirs. */
static bool has_budget_for_correction(const scene_object *s)
{
    const uint64_t operations = s->contacts->counters.operations - s->cursor.operations_before,
                   budget = s->step.budget - s->cursor.operations_before;
    return s->step.budget == 0 || s->cursor.size < 1.0 ||
           (double)operations <= SCENE_CORRECTION_BUDGET_RATIO * (double)budget;
}

/* Applies the increments of a search to the trial state. `needs_correction`: whether a
 * correction follows. */
static scene_substep_outcome apply_increments(scene_object *s, const scene_substep *substep,
                                              bool *needs_correction)
{
    scene_newton_state *newton = &s->step.newton;
    drain_moves moves = measure_drain_moves(s);
    double previous_stretch = newton->stretch;
    bool has_needle_turned = has_needle_turned_far(s);
    advance_trial(s);
    if (!newton->is_finite || !moves.is_finite) {
        return SCENE_SUBSTEP_SINGULAR;
    }
    vbss_scene_refresh_contacts(s);
    bool is_too_far = moves.is_too_far || (has_needle_turned && newton->needle_linearisations ==
                                                                    SCENE_NEEDLE_LINEARISATIONS);
    if ((is_too_far && !substep->is_min_size) || is_diverging(s, substep, previous_stretch)) {
        return SCENE_SUBSTEP_NOT_CONVERGED;
    }
    if (!vbss_scene_may_pass_energy_check(s, substep)) {
        return SCENE_SUBSTEP_NO_ACTIVE_SET;
    }
    if (has_needle_turned && newton->needle_linearisations < SCENE_NEEDLE_LINEARISATIONS) {
        newton->is_converged = false;
        newton->needle_linearisations++;
    }
    *needs_correction = newton->is_converged && moves.needs_correction && !newton->has_correction &&
                        has_budget_for_correction(s);
    return SCENE_SUBSTEP_ACCEPTED;
}

/* Runs one linearisation with its searches, or the rest of one that was suspended. */
static scene_substep_outcome run_newton_iteration(scene_object *s, const scene_substep *substep)
{
    scene_newton_state *newton = &s->step.newton;
    scene_substep_outcome outcome;
    if (newton->phase == SCENE_NEWTON_LINEARISE) {
        if (vbss_contact_must_suspend(s->contacts, vbss_scene_linearisation_cost(s))) {
            return SCENE_SUBSTEP_SUSPENDED;
        }
        outcome = linearise(s, substep);
        if (outcome != SCENE_SUBSTEP_ACCEPTED) {
            return outcome;
        }
        newton->phase = SCENE_NEWTON_ACTIVE_SET;
    }
    if (newton->phase == SCENE_NEWTON_ACTIVE_SET) {
        bool needs_correction = false;
        outcome = solve_active_set(s);
        outcome = outcome == SCENE_SUBSTEP_ACCEPTED
                      ? apply_increments(s, substep, &needs_correction)
                      : outcome;
        if (outcome != SCENE_SUBSTEP_ACCEPTED) {
            return outcome;
        }
        if (needs_correction) {
            begin_correction(s, substep);
            newton->phase = SCENE_NEWTON_CORRECT;
        }
    }
    if (newton->phase == SCENE_NEWTON_CORRECT) {
        outcome = solve_active_set(s);
        outcome = outcome == SCENE_SUBSTEP_SUSPENDED ? outcome : end_correction(s, outcome);
        if (outcome != SCENE_SUBSTEP_ACCEPTED) {
            return outcome;
        }
    }
    /* One more linearisation, with a correction. */
    if (newton->is_converged && has_drain_moved_far(s) && !newton->has_extra_linearisation) {
        newton->is_converged = newton->has_correction = false;
        newton->has_extra_linearisation = true;
    }
    newton->phase = SCENE_NEWTON_LINEARISE;
    newton->linearisations++;
    newton->over_budget_linearisations += vbss_scene_is_over_budget(s);
    return SCENE_SUBSTEP_ACCEPTED;
}

static void reset_newton(scene_newton_state *newton)
{
    newton->phase = SCENE_NEWTON_LINEARISE;
    newton->needle_linearisations = newton->over_budget_linearisations = 0;
    newton->is_suspended = newton->has_correction = newton->has_extra_linearisation =
        newton->is_converged = false;
    newton->stretch = (double)INFINITY;
}

/* Whether another iteration follows, or the rest of one that was suspended. The state may have
 * converged already when its correction is suspended. */
static bool needs_iteration(const scene_object *s)
{
    const scene_newton_state *newton = &s->step.newton;
    bool has_time = newton->linearisations < s->solver.iteration_limit &&
                    newton->over_budget_linearisations < SCENE_OVER_BUDGET_LINEARISATIONS;
    return newton->phase != SCENE_NEWTON_LINEARISE || (has_time && !newton->is_converged);
}

/* Iterates until threads have their lengths, then checks the energy. */
static scene_substep_outcome run_newton(scene_object *s, const scene_substep *substep)
{
    scene_newton_state *newton = &s->step.newton;
    while (needs_iteration(s)) {
        scene_substep_outcome outcome = run_newton_iteration(s, substep);
        if (outcome != SCENE_SUBSTEP_ACCEPTED) {
            return outcome;
        }
    }
    count_forced(s);
    if (!vbss_scene_passes_energy_check(s, substep)) {
        return SCENE_SUBSTEP_NO_ACTIVE_SET;
    }
    bool is_converged = newton->is_converged || newton->stretch <= s->solver.stretch_tolerance;
    return is_converged ? SCENE_SUBSTEP_ACCEPTED : SCENE_SUBSTEP_NOT_CONVERGED;
}

/* Iterates again with updated normals while penetration is too deep. */
static scene_substep_outcome run_newton_with_normal_updates(scene_object *s,
                                                            const scene_substep *substep)
{
    scene_newton_state *newton = &s->step.newton;
    for (;;) {
        scene_substep_outcome outcome = run_newton(s, substep);
        if (outcome != SCENE_SUBSTEP_ACCEPTED) {
            s->step.has_updated_normals =
                outcome != SCENE_SUBSTEP_SUSPENDED && newton->normal_updates > 0;
            return outcome;
        }
        bool was_penetration_allowed = vbss_contact_penetration_is_allowed(s->contacts);
        vbss_scene_measure_gaps(s);
        if (vbss_contact_penetration_is_allowed(s->contacts)) {
            return SCENE_SUBSTEP_ACCEPTED;
        }
        if (newton->normal_updates ==
                (substep->has_fixed_normals ? 0u : (uint32_t)SCENE_MAX_NORMAL_UPDATES) ||
            vbss_scene_is_over_budget(s) || newton->linearisations >= s->solver.iteration_limit) {
            /* The next substep counts as recovering and removes the penetration that slip
             * has left. */
            s->step.has_updated_normals = !substep->has_fixed_normals;
            return was_penetration_allowed && substep->has_fixed_normals
                       ? SCENE_SUBSTEP_ACCEPTED
                       : SCENE_SUBSTEP_PENETRATION;
        }
        vbss_scene_refresh_normals(s);
        newton->normal_updates++;
        reset_newton(newton);
    }
}

scene_substep_outcome vbss_scene_solve(scene_object *s, const scene_substep *substep)
{
    s->step.newton.linearisations = s->step.newton.normal_updates = 0;
    s->step.has_updated_normals = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD &&
            s->bodies[i].thread.thread->config.rest_curvature > 0.0) {
            vbss_thread_update_rest_curvature_forces(s->bodies[i].thread.thread);
        }
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            vbss_drain_begin_tangent(s->bodies[i].drain.drain);
        }
    }
    reset_newton(&s->step.newton);
    return run_newton_with_normal_updates(s, substep);
}

void vbss_scene_recompute_strains(scene_object *s, const scene_substep *substep)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD) {
            thread_object *t = s->bodies[i].thread.thread;
            vbss_thread_set_clamp_directions(t, substep->end_fraction);
            if (thread_has_twist(t)) {
                vbss_thread_begin_twist(t);
            }
            vbss_thread_compute_strains(t, t->trial, t->strains);
        }
    }
}

scene_substep_outcome vbss_scene_resume_solve(scene_object *s, const scene_substep *substep)
{
    vbss_scene_recompute_strains(s, substep);
    return run_newton_with_normal_updates(s, substep);
}
