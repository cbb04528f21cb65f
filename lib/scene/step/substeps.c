/* Substeps: attempts, retries and truncation, from the start of a step to its end.
 *
 * The first attempt is at the whole step. A rejected attempt is repeated, mostly at half the size.
 * At the minimum size the substep is truncated, or in real time deferred to the next step. A call
 * may suspend the step between two attempts or within one (time_slice.c). */
#include "base/error.h"
#include "scene/ccd/ccd.h"
#include "scene/solve/solve.h"
#include "scene/step/groups.h"
#include "scene/step/step.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* ---- sizes and budget */

static double find_min_size(const scene_object *s)
{
    double size = 1.0;
    for (uint32_t k = 0; k < s->solver.halving_limit; k++) {
        size *= 0.5;
    }
    return size;
}

bool vbss_scene_is_substep_size(const scene_object *s, double size)
{
    double valid_size = 1.0, min_size = SCENE_HARD_MIN_SIZE_RATIO * find_min_size(s);
    while (valid_size > min_size && valid_size != size) {
        valid_size *= 0.5;
    }
    return valid_size == size;
}

/* A substep of hard minimum size has no budget, or nothing might ever move again. If its active set
 * cycles, it is repeated with a budget for searches, and the best iterate has to do. */
static void set_step_budget(scene_object *s, const scene_substep *substep, bool is_hard_min_size)
{
    uint64_t operations_before =
        substep->has_search_budget ? s->contacts->counters.operations : s->cursor.operations_before;
    bool is_limited =
        vbss_scene_has_step_budget(s) && (substep->has_search_budget || !is_hard_min_size);
    s->step.budget = is_limited ? operations_before + s->settings.step_budget : 0;
}

/* ---- substeps */

static void record_errors(scene_object *s)
{
    double stretch = 0.0, depth = 0.0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        /* A thread that waits has the error of its attempt that failed. */
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD) {
            const thread_object *t = s->bodies[i].thread.thread;
            stretch = vbss_max(t->statistics.last_stretch_error, stretch);
        }
    }
    depth = vbss_contact_max_penetration(s->contacts);
    s->report.statistics.last_stretch_error = stretch;
    s->report.statistics.stretch_error = vbss_max(stretch, s->report.statistics.stretch_error);
    s->report.statistics.last_penetration = depth;
    s->report.statistics.penetration = vbss_max(depth, s->report.statistics.penetration);
    s->report.statistics.loose_stretch += stretch > s->solver.stretch_tolerance;
    s->report.statistics.last_residual = s->contacts->residual;
}

/* Whether attempts or operations of the group are used up. */
static bool is_step_exhausted(const scene_object *s, const scene_step_cursor *cursor)
{
    uint64_t next_attempt_cost = vbss_scene_attempt_cost(s) + vbss_scene_linearisation_cost(s);
    uint64_t operations = s->contacts->counters.operations - cursor->operations_before;
    return vbss_scene_is_beyond_step_limits(s, operations + next_attempt_cost, cursor->attempts);
}

/* Whether the substep is attempted again: with the displacements that are known now, with a search
 * budget, with fixed normals, without the island that failed, or at half the size. */
static bool prepare_retry(scene_object *s, scene_step_cursor *cursor, scene_substep_outcome outcome)
{
    bool has_attempt_limit =
        s->config.mode == VBSS_SCENE_MODE_REAL_TIME && s->settings.step_budget == 0;
    bool is_over_limit = has_attempt_limit && outcome != SCENE_SUBSTEP_OUT_OF_CAPACITY &&
                         cursor->attempts >= s->solver.attempt_limit;
    bool is_min_size = cursor->size <= cursor->min_size;
    if (outcome == SCENE_SUBSTEP_CCD_HIT && !cursor->substep.uses_trial_motion && !is_over_limit) {
        cursor->substep.uses_trial_motion = true;
        return true;
    }
    if (outcome == SCENE_SUBSTEP_NO_ACTIVE_SET && is_min_size && vbss_scene_has_step_budget(s) &&
        !cursor->substep.has_search_budget) {
        cursor->substep.has_search_budget = true;
        return true;
    }
    /* Half the size does not help where penetration is deep already. */
    if (s->step.has_updated_normals && !cursor->substep.has_fixed_normals &&
        (is_min_size || is_over_limit || s->step.is_recovering)) {
        cursor->substep.has_fixed_normals = true;
        return true;
    }
    cursor->substep.uses_trial_motion = cursor->substep.has_fixed_normals =
        cursor->substep.has_search_budget = false;
    bool can_halve = !is_min_size && !is_over_limit;
    if (vbss_scene_split_failed_island(s, outcome, can_halve ? 0.5 * cursor->size : cursor->size)) {
        return true;
    }
    if (can_halve) {
        vbss_scene_request_damping(s);
        cursor->size *= 0.5;
        return true;
    }
    return false;
}

/* Waiting helps neither against lack of capacity nor against a singular system. */
static bool is_deferrable(scene_substep_outcome outcome)
{
    return outcome != SCENE_SUBSTEP_OUT_OF_CAPACITY && outcome != SCENE_SUBSTEP_SINGULAR;
}

/* Sets coupling wrenches from the full targets of the step, so that hands feel how far their tools
 * lag behind. */
static void update_coupling_wrenches(scene_object *s, const scene_substep *substep)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction, 1.0};
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_RIGID) {
            r->coupling_wrench = vbss_rigid_coupling_wrench(&r->body, &p, &r->body.now);
        }
    }
}

static vbss_scene_blocker_cause cause_of(scene_substep_outcome outcome)
{
    switch (outcome) {
    case SCENE_SUBSTEP_CCD_HIT:
        return VBSS_SCENE_BLOCKER_COLLISION;
    case SCENE_SUBSTEP_PENETRATION:
        return VBSS_SCENE_BLOCKER_PENETRATION;
    case SCENE_SUBSTEP_NO_ACTIVE_SET:
        return VBSS_SCENE_BLOCKER_CONTACT;
    case SCENE_SUBSTEP_NOT_CONVERGED:
    case SCENE_SUBSTEP_SINGULAR:
        return VBSS_SCENE_BLOCKER_CONVERGENCE;
    default:
        return VBSS_SCENE_BLOCKER_WORK;
    }
}

/* If several groups leave out a part of the step, the largest part counts. */
static void record_pause(scene_object *s, scene_step_cursor *cursor, double fraction)
{
    vbss_scene_statistics *c = &s->report.statistics;
    double more = fraction - cursor->paused_fraction;
    c->paused += cursor->paused_fraction == 0.0;
    c->time_paused += more > 0.0 ? more * cursor->substep.step_length : 0.0;
    cursor->paused_fraction = vbss_max(fraction, cursor->paused_fraction);
}

/* Leaves out the rest of the step for the present group. Its bodies stay where they are. The next
 * step of those that failed, or of all if no pair is blamed, begins with substeps of `size`, a
 * fraction of a step. */
static void pause_step(scene_object *s, scene_step_cursor *cursor, scene_substep_outcome outcome,
                       scene_touching_pair blamed, double size)
{
    double fraction_left = 1.0 - cursor->substep.start_fraction;
    const vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_PAUSED,
                                    .body_a = blamed.body_a,
                                    .body_b = blamed.body_b,
                                    .value = fraction_left * cursor->substep.step_length};
    vbss_scene_add_event(s, &event, (uint32_t)(65536.0 * fraction_left));
    record_pause(s, cursor, fraction_left);
    vbss_scene_record_blocker(s, cause_of(outcome), blamed,
                              fraction_left * cursor->substep.step_length);
    vbss_scene_set_next_size(s, blamed, size);
    cursor->is_paused = cursor->is_behind_targets = true;
    update_coupling_wrenches(s, &cursor->substep);
}

/* Whether the motion of a failed substep is deferred to the next step, and the size of the
 * first substep there. A substep of minimum size is halved further only if it used up the
 * whole budget. */
static bool can_defer_to_next_step(const scene_object *s, const scene_step_cursor *cursor,
                                   double *size)
{
    bool is_min_size = cursor->size <= cursor->min_size;
    bool is_over_budget = s->contacts->is_stopped_early || vbss_scene_is_over_budget(s);
    *size = is_min_size && cursor->size < cursor->initial_size ? cursor->size : 0.5 * cursor->size;
    return is_step_exhausted(s, cursor) &&
           (!is_min_size || (is_over_budget && cursor->size > cursor->hard_min_size));
}

static void truncate_substep(scene_object *s, scene_step_cursor *cursor,
                             scene_substep_outcome outcome, scene_touching_pair blamed)
{
    double lost_fraction = 1.0 - vbss_scene_truncate_substep(s, outcome, &cursor->substep);
    double lost_of_step =
        lost_fraction * (cursor->substep.end_fraction - cursor->substep.start_fraction);
    vbss_scene_record_blocker(s, cause_of(outcome), blamed,
                              lost_of_step * cursor->substep.step_length);
    const vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_TRUNCATED,
                                    .body_a = blamed.body_a,
                                    .body_b = blamed.body_b,
                                    .value = lost_of_step * cursor->substep.step_length};
    vbss_scene_add_event(s, &event, (uint32_t)(65536.0 * lost_of_step));
    vbss_scene_request_damping(s);
    cursor->is_behind_targets = true;
    cursor->truncations++;
}

/* Whether so many substeps were truncated in a step without a budget that its rest is left out. Such
 * a step would take the work of all its smallest substeps and gain next to nothing. */
static bool is_stuck(const scene_object *s, const scene_step_cursor *cursor)
{
    return cursor->truncations >= SCENE_MAX_TRUNCATED_SUBSTEPS && !vbss_scene_has_step_budget(s);
}

/* Moves the cursor to the next substep, and doubles its size where a larger one may begin. */
static void advance_cursor(scene_object *s, scene_step_cursor *cursor)
{
    record_errors(s);
    cursor->substep.uses_trial_motion = cursor->substep.has_fixed_normals =
        cursor->substep.has_search_budget = false;
    cursor->substep.start_fraction = cursor->substep.end_fraction;
    double pairs = cursor->substep.start_fraction / (2.0 * cursor->size);
    if (cursor->size < 1.0 && floor(pairs) == pairs) {
        cursor->size *= 2.0;
    }
}

static void set_substep_end(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    cursor->substep.end_fraction = cursor->substep.start_fraction + cursor->size;
    cursor->substep.h = cursor->substep.step_length * cursor->size;
    cursor->substep.is_min_size = cursor->size <= cursor->min_size;
    set_step_budget(s, &cursor->substep, cursor->size <= cursor->hard_min_size);
}

/* Begins an attempt, or resumes the suspended one. */
static scene_substep_outcome run_or_resume_attempt(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    contact_call_budget *call_budget = &s->contacts->call_budget;
    if (!cursor->is_attempt_suspended) {
        set_substep_end(s);
        cursor->operations_at_attempt = s->contacts->counters.operations;
        call_budget->checks_passed = 0;
    }
    /* An attempt that uses the displacements of the one before cannot be replayed, so it is
     * never suspended. */
    const uint64_t end = call_budget->operation_limit;
    const bool is_sliced = !cursor->substep.uses_trial_motion && !cursor->is_free_group;
    call_budget->operation_limit = is_sliced ? end : 0;
    scene_substep_outcome outcome = vbss_scene_run_attempt(s);
    call_budget->operation_limit = end;
    return outcome;
}

/* Repeats a suspended attempt that is not in memory, up to the check where it was suspended. A
 * snapshot stores only the number of checks. */
static void replay_attempt(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    contact_call_budget *call_budget = &s->contacts->call_budget;
    const contact_counters counters = s->contacts->counters;
    s->contacts->counters.operations = cursor->operations_at_attempt;
    set_substep_end(s);
    *call_budget = (contact_call_budget){.operation_limit = call_budget->operation_limit,
                                         .is_replay = true,
                                         .replay_checks = cursor->checks_passed};
    while (vbss_scene_run_attempt(s) == SCENE_SUBSTEP_REGROUPED) {
        set_substep_end(s);
    }
    call_budget->is_replay = call_budget->has_progress = false;
    s->contacts->counters = counters;
    vbss_scene_rollback_statistics(s);
}

static void accept_substep(scene_object *s)
{
    vbss_scene_commit(s, &s->cursor.substep);
    s->report.statistics.recovering += s->step.is_recovering;
    s->cursor.is_behind_targets = false;
    s->step.has_accepted_contacts = true;
}

/* Whether the rest of the step is suspended because the budget of the call has no room for
 * another attempt. */
static bool must_suspend(const scene_object *s)
{
    const contact_call_budget *call_budget = &s->contacts->call_budget;
    uint64_t operations = s->contacts->counters.operations + vbss_scene_attempt_cost(s);
    return !s->cursor.is_attempt_suspended && !s->cursor.substep.uses_trial_motion &&
           !s->cursor.is_free_group && call_budget->operation_limit > 0 &&
           call_budget->has_progress && operations > call_budget->operation_limit;
}

/* Runs the substeps of the present group to the end of the step, or until the step is suspended. */
static vbss_result run_group(scene_object *s, bool *is_complete)
{
    scene_step_cursor *cursor = &s->cursor;
    scene_substep *substep = &cursor->substep;
    *is_complete = false;
    while (substep->start_fraction < 1.0) {
        if (must_suspend(s)) {
            return VBSS_OK;
        }
        scene_substep_outcome outcome = run_or_resume_attempt(s);
        if (outcome == SCENE_SUBSTEP_SUSPENDED) {
            return VBSS_OK;
        }
        if (outcome == SCENE_SUBSTEP_REGROUPED) {
            continue;
        }
        cursor->attempts++;
        scene_touching_pair blamed = {0, 0};
        if (outcome == SCENE_SUBSTEP_ACCEPTED) {
            accept_substep(s);
        } else {
            double next_size;
            vbss_scene_count_rejection(s, outcome);
            if (can_defer_to_next_step(s, cursor, &next_size) && is_deferrable(outcome)) {
                /* The contacts of the attempt say which pair failed; the rejection rebuilds them. */
                blamed = vbss_scene_find_blamed_pair(s, outcome);
                vbss_scene_reject_substep(s);
                vbss_scene_let_others_wait(s, blamed);
                vbss_scene_request_damping(s);
                pause_step(s, cursor, outcome, blamed, next_size);
                break;
            }
            if (prepare_retry(s, cursor, outcome)) {
                continue;
            }
            /* Pairs may be missing, so there is no safe fraction to truncate to. */
            if (outcome == SCENE_SUBSTEP_OUT_OF_CAPACITY) {
                return vbss_fail(
                    s->context, VBSS_ERROR_CAPACITY,
                    "scene step: more is near than candidate_capacity %u, contact_capacity %u or "
                    "matrix_capacity has room for",
                    s->config.candidate_capacity, s->config.contact_capacity);
            }
            blamed = vbss_scene_find_blamed_pair(s, outcome);
            truncate_substep(s, cursor, outcome, blamed);
        }
        advance_cursor(s, cursor);
        if (substep->start_fraction < 1.0 && is_stuck(s, cursor)) {
            /* Only a whole step shows whether the bodies now move apart. */
            pause_step(s, cursor, outcome, blamed, 1.0);
            break;
        }
        if (substep->start_fraction < 1.0 && is_step_exhausted(s, cursor)) {
            /* this size was accepted */
            pause_step(s, cursor, SCENE_SUBSTEP_ACCEPTED, (scene_touching_pair){0, 0},
                       vbss_min(2.0 * cursor->size, 1.0));
            break;
        }
    }
    *is_complete = true;
    return VBSS_OK;
}

vbss_result vbss_scene_run_substeps(scene_object *s, bool is_overdue)
{
    scene_step_cursor *cursor = &s->cursor;
    if (cursor->is_attempt_suspended && !cursor->is_attempt_in_memory) {
        replay_attempt(s);
    }
    if (is_overdue && vbss_scene_do_others_wait(s)) {
        s->contacts->call_budget.operation_limit = 0;
    }
    cursor->is_suspended = true;
    for (bool has_finished_group = false;; has_finished_group = true) {
        bool is_complete;
        vbss_result result = run_group(s, &is_complete);
        if (result != VBSS_OK && has_finished_group) {
            /* What the other groups did stays. The next call fails in this one and returns the error. */
            vbss_scene_rollback(s);
            return VBSS_OK;
        }
        VBSS_TRY(result);
        if (!is_complete) {
            return VBSS_OK;
        }
        if (cursor->group + 1 == cursor->group_count) {
            break;
        }
        vbss_scene_finish_group(s);
        (void)vbss_scene_begin_next_group(s);
        VBSS_TRY(vbss_scene_checkpoint(s));
    }
    cursor->is_suspended = false;
    return VBSS_OK;
}

/* Abandons the substeps that the present group has left. */
static void abandon_group(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    /* Suspended between two substeps: contacts of the next are created. A restored snapshot has
     * none, and both must give the same bits. */
    if (!cursor->is_attempt_suspended) {
        cursor->operations_at_attempt = cursor->operations;
        cursor->checks_passed = 0;
    }
    if (cursor->is_attempt_in_memory) {
        vbss_scene_recompute_strains(s, &cursor->substep);
    } else {
        replay_attempt(s);
    }
    vbss_scene_request_damping(s);
    vbss_scene_reject_substep(s);
    pause_step(s, cursor, SCENE_SUBSTEP_SUSPENDED, (scene_touching_pair){0, 0}, cursor->size);
}

void vbss_scene_abandon_step(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    abandon_group(s);
    while (cursor->group + 1 < cursor->group_count) {
        vbss_scene_finish_group(s);
        (void)vbss_scene_begin_next_group(s);
        vbss_scene_checkpoint_statistics(s); /* a replay goes back to these */
        abandon_group(s);
    }
    cursor->is_suspended = cursor->is_attempt_suspended = cursor->is_attempt_in_memory = false;
}

/* ---- limits */

void vbss_scene_set_substep_limits(scene_object *s)
{
    s->cursor.min_size = find_min_size(s);
    s->cursor.hard_min_size = vbss_scene_has_body_kind(s, SCENE_BODY_DRAIN)
                                  ? SCENE_HARD_MIN_SIZE_RATIO * s->cursor.min_size
                                  : s->cursor.min_size;
}
