/* Time slices: one call of vbss_scene_step.
 *
 * Without a budget a call runs one whole step. With a budget a call has a limit of operations. A
 * step that exceeds it is suspended, and the next call resumes it with the same bits. Operations
 * left over go to the next step. So calls stay within their time and no work is lost. Only steps
 * that are too far behind are dropped. A step that two calls have suspended runs to its end in
 * the third if bodies beside the expensive island wait.
 *
 *   resume suspended step -> (finish it -> begin the next) within the budget -> drop overdue steps
 *
 * A snapshot stores how far an attempt was, and a restored scene replays it up to there. A host
 * that edits bodies in between ends the suspended step. */
#include "base/error.h"
#include "scene/solve/solve.h"
#include "scene/step/step.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

uint64_t vbss_scene_count_edits(const scene_object *s)
{
    uint64_t sum = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        sum += b->kind == SCENE_BODY_THREAD  ? b->thread.thread->edit_generation
               : b->kind == SCENE_BODY_DRAIN ? b->drain.drain->edit_generation
                                             : 0;
    }
    return sum;
}

static void for_each_deformable(scene_object *s, void (*on_thread)(thread_object *t),
                                void (*on_drain)(drain_object *d))
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            on_thread(b->thread.thread);
        } else if (b->kind == SCENE_BODY_DRAIN) {
            on_drain(b->drain.drain);
        }
    }
}

/* Swaps attachment targets between those of the suspended step and those that hosts have
 * set since. */
static void swap_targets(scene_object *s)
{
    for_each_deformable(s, vbss_thread_swap_targets, vbss_drain_swap_targets);
}

vbss_result vbss_scene_abandon_suspended_step(scene_object *s)
{
    if (!s->cursor.is_suspended) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_scene_checkpoint(s));
    /* The attempt in memory does not know the edits of bodies; a restored scene repeats it as well. */
    s->cursor.is_attempt_in_memory =
        s->cursor.is_attempt_in_memory && vbss_scene_count_edits(s) == s->cursor.edit_count;
    swap_targets(s);
    s->contacts->counters.operations = s->cursor.operations;
    vbss_scene_abandon_step(s);
    vbss_scene_finish_step(s);
    swap_targets(s);
    vbss_scene_publish_events(s, 0, 0.0);
    s->report.keeps_logged_events = true;
    s->cursor.unsliced_steps_left = SCENE_UNSLICED_STEPS;
    return VBSS_OK;
}

/* Cost of CCD and of the end of a step. */
static uint64_t step_end_cost(const scene_object *s)
{
    return vbss_scene_attempt_cost(s) / SCENE_STEP_END_DIVISOR;
}

/* Whether the budget lasts for one linearisation, not only for finding contacts. */
static bool can_linearise(const scene_object *s)
{
    return s->cursor.operations_left >=
           (uint64_t)vbss_scene_attempt_cost(s) + vbss_scene_linearisation_cost(s);
}

/* Whether the call begins another step. A step that the call before could not begin either begins
 * with room for its contacts alone: if that room stayed unused in each call, the scene would never
 * catch up. */
static bool can_begin_step(const scene_object *s, bool is_sliced, bool was_waiting)
{
    return is_sliced && (can_linearise(s) ||
                         (was_waiting && s->cursor.operations_left >= vbss_scene_attempt_cost(s)));
}

static void charge_call_budget(scene_step_cursor *cursor, uint64_t operations)
{
    cursor->operations_left -=
        operations < cursor->operations_left ? operations : cursor->operations_left;
}

/* Resumes the suspended step or begins the next, as far as the budget of the call allows. */
static vbss_result run_slice(scene_object *s, double h, bool is_sliced)
{
    scene_step_cursor *cursor = &s->cursor;
    const bool was_suspended = cursor->is_suspended;
    if (was_suspended) {
        s->contacts->counters.operations = cursor->operations;
        swap_targets(s);
    } else {
        cursor->suspensions = 0;
        cursor->steps_behind--;
        cursor->unsliced_steps_left -= cursor->unsliced_steps_left > 0;
        vbss_scene_begin_step(s, h);
    }
    const uint64_t operations_before = s->contacts->counters.operations;
    const bool is_overdue = is_sliced && cursor->suspensions >= SCENE_MAX_SUSPENSIONS;
    uint64_t *limit = &s->contacts->call_budget.operation_limit;
    *limit = is_sliced ? operations_before + cursor->operations_left : 0;
    vbss_result result = vbss_scene_run_substeps(s, is_overdue);
    cursor->operations = s->contacts->counters.operations;
    charge_call_budget(cursor, cursor->operations - operations_before);
    if (result == VBSS_OK && !cursor->is_suspended) {
        vbss_scene_finish_step(s);
        charge_call_budget(cursor, step_end_cost(s));
        /* after a replay, which restores statistics */
        cursor->was_overdue = is_overdue && *limit == 0;
        s->report.statistics.overdue += cursor->was_overdue;
        if (cursor->was_overdue) {
            vbss_scene_add_event(s, &(vbss_scene_event){.kind = VBSS_SCENE_EVENT_OVERDUE}, 0);
        }
        vbss_scene_publish_events(s, 0, h);
    }
    if (was_suspended) {
        swap_targets(s);
    } else if (result == VBSS_OK && cursor->is_suspended) {
        for_each_deformable(s, vbss_thread_save_targets, vbss_drain_save_targets);
    }
    return result;
}

/* Runs a slice; on failure the scene is rolled back. */
static vbss_result run_slice_or_rollback(scene_object *s, double h, bool is_sliced)
{
    VBSS_TRY(vbss_scene_checkpoint(s));
    vbss_result result = run_slice(s, h, is_sliced);
    if (result != VBSS_OK) {
        vbss_scene_rollback(s);
    }
    return result;
}

/* Tells hosts when more steps wait than before, and when none waits any more. */
static void emit_backlog_event(scene_object *s, uint32_t behind, double h)
{
    const uint32_t behind_before = s->report.statistics.behind;
    if (behind > behind_before) {
        const vbss_scene_event event = {
            .kind = VBSS_SCENE_EVENT_DEFERRED, .id = behind, .value = behind * h};
        vbss_scene_add_event(s, &event, 0);
    } else if (behind == 0 && behind_before > 0) {
        vbss_scene_add_event(s, &(vbss_scene_event){.kind = VBSS_SCENE_EVENT_CAUGHT_UP}, 0);
    }
}

/* What the call itself reports is published at once, while a suspended step keeps its events. */
static void drop_overdue_steps(scene_object *s, double h)
{
    const uint32_t pending_before = s->events.pending_count;
    scene_step_cursor *cursor = &s->cursor;
    vbss_scene_statistics *c = &s->report.statistics;
    c->deferred += cursor->is_suspended || cursor->steps_behind > 0;
    while (cursor->steps_behind > 0 &&
           cursor->steps_behind + cursor->is_suspended > SCENE_MAX_STEPS_BEHIND) {
        cursor->steps_behind--;
        vbss_scene_add_event(s, &(vbss_scene_event){.kind = VBSS_SCENE_EVENT_PAUSED, .value = h},
                             65536);
        c->paused++;
        c->time_paused += h;
        vbss_scene_record_blocker(s, VBSS_SCENE_BLOCKER_WORK, (scene_touching_pair){0, 0}, h);
    }
    emit_backlog_event(s, cursor->steps_behind + cursor->is_suspended, h);
    c->behind = cursor->steps_behind + cursor->is_suspended;
    vbss_scene_publish_events(s, pending_before, h);
}

vbss_result vbss_scene_implicit_step(scene_object *s, double h)
{
    scene_step_cursor *cursor = &s->cursor;
    const bool ends_suspended =
        cursor->is_suspended && vbss_scene_count_edits(s) != cursor->edit_count;
    if (!s->report.keeps_logged_events) {
        vbss_scene_clear_logged_events(s);
    }
    if (ends_suspended) {
        VBSS_TRY(vbss_scene_abandon_suspended_step(s));
    }
    const bool can_slice = vbss_scene_has_step_budget(s) && s->settings.call_budget > 0;
    const bool is_sliced = can_slice && cursor->unsliced_steps_left == 0;
    const bool was_waiting = cursor->steps_behind > 0;
    s->contacts->call_budget.has_progress = false;
    cursor->operations_left = s->settings.call_budget;
    cursor->steps_behind++;
    /* The last step began with room for its contacts alone. Without it, it would begin in the next call. */
    bool is_early = false;
    vbss_result result = run_slice_or_rollback(s, h, is_sliced);
    if (result != VBSS_OK && !ends_suspended) {
        cursor->steps_behind--;
        return result;
    }
    /* If a step fails after another has ended, the next call fails in it and returns the error. */
    while (result == VBSS_OK && !cursor->is_suspended && cursor->steps_behind > 0 &&
           (!can_slice || can_begin_step(s, is_sliced, was_waiting))) {
        is_early = can_slice && !can_linearise(s);
        result = run_slice_or_rollback(s, h, is_sliced);
    }
    if (cursor->is_suspended) {
        cursor->suspensions += !is_early && cursor->suspensions < SCENE_MAX_SUSPENSIONS;
        vbss_scene_publish_tools(s); /* grasps may have been released when the step began */
    }
    drop_overdue_steps(s, h);
    cursor->edit_count = vbss_scene_count_edits(s);
    s->report.keeps_logged_events = false;
    return VBSS_OK;
}
