/* What a call of vbss_scene_step does. Without a limit of work a step, all of it. Else operations in a call have a limit, too: a step
 * that takes more waits where it is, and the next call goes on with it as if nothing had been. What a call has left then is for
 * the next step. So a host's slot is kept, and no work is lost: time is, only when steps have fallen too far behind.
 *
 *   the step that waits -> (its end -> the next step) while there is room -> what is too far behind is left out
 *
 * A saved state knows how far an attempt was, which is made again up to there. Hosts that change bodies meanwhile end the step. */
#include "base/error.h"
#include "scene/attempt.h"
#include "scene/events.h"
#include "scene/scene.h"
#include "scene/step.h"
#include "scene/tools.h"

/* More steps than these are not made up for: hands would be felt that much late. */
enum { MOST_BEHIND = 2 };
/* After a step was given up so many follow that do not wait: a host that changes bodies before each would get nowhere. */
enum { UNDIVIDED = 1000 };

uint64_t vbss_scene_count_changes(const scene_object *s)
{
    uint64_t sum = 0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        sum += b->kind == BODY_THREAD  ? b->thread.thread->edit_generation
               : b->kind == BODY_DRAIN ? b->drain.drain->edit_generation
                                       : 0;
    }
    return sum;
}

/* Where attachments go: in the step that waits, and as hosts have it. */
static void change_goals(scene_object *s, void (*of_thread)(thread_object *t),
                         void (*of_drain)(drain_object *d))
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            of_thread(b->thread.thread);
        } else if (b->kind == BODY_DRAIN) {
            of_drain(b->drain.drain);
        }
    }
}

static void exchange_goals(scene_object *s)
{
    change_goals(s, vbss_thread_swap_targets, vbss_drain_swap_targets);
}

vbss_result vbss_scene_end_waiting(scene_object *s)
{
    if (!s->way.waits) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_scene_keep(s));
    exchange_goals(s);
    s->contacts->counters.operations = s->way.work;
    vbss_scene_give_up(s);
    vbss_scene_finish_step(s);
    exchange_goals(s);
    s->carries_events = true;
    s->way.undivided = UNDIVIDED;
    return VBSS_OK;
}

/* The guard, and what follows at the end of a step. */
static uint64_t cost_of_end(const scene_object *s)
{
    return vbss_scene_attempt_cost(s) / 2;
}

/* Not only to look for what is near. */
static bool has_room(const scene_object *s, bool divided)
{
    uint64_t least = (uint64_t)vbss_scene_attempt_cost(s) + vbss_scene_linearisation_cost(s);
    return divided && s->way.left >= least;
}

static void take(scene_way *at, uint64_t work)
{
    at->left -= work < at->left ? work : at->left;
}

/* Goes on with the step that waits, or begins one, as far as the call has room. */
static vbss_result go_on(scene_object *s, double h, bool divided)
{
    scene_way *at = &s->way;
    const bool waited = at->waits;
    if (waited) {
        s->contacts->counters.operations = at->work;
        exchange_goals(s);
    } else {
        at->behind--;
        at->undivided -= at->undivided > 0;
        vbss_scene_begin_step(s, h);
    }
    const uint64_t before = s->contacts->counters.operations;
    s->contacts->call_budget.operation_limit = divided ? before + at->left : 0;
    vbss_result result = vbss_scene_go_through(s);
    at->work = s->contacts->counters.operations;
    take(at, at->work - before);
    if (result == VBSS_OK && !at->waits) {
        vbss_scene_finish_step(s);
        take(at, cost_of_end(s));
    }
    if (waited) {
        exchange_goals(s);
    } else if (result == VBSS_OK && at->waits) {
        change_goals(s, vbss_thread_save_targets, vbss_drain_save_targets);
    }
    return result;
}

/* The same; if it fails nothing of it is done. */
static vbss_result try_to_go_on(scene_object *s, double h, bool divided)
{
    VBSS_TRY(vbss_scene_keep(s));
    vbss_result result = go_on(s, h, divided);
    if (result != VBSS_OK) {
        vbss_scene_go_back(s);
    }
    return result;
}

static void leave_out(scene_object *s, double h)
{
    scene_way *at = &s->way;
    vbss_scene_statistics *c = &s->statistics;
    c->deferred += at->waits || at->behind > 0;
    while (at->behind > 0 && at->behind + at->waits > MOST_BEHIND) {
        at->behind--;
        vbss_scene_add_event(s, VBSS_EVENT_CLAMPED, 0, 0, 65536);
        c->paused++;
        c->time_paused += h;
    }
    c->behind = at->behind + at->waits;
}

vbss_result vbss_scene_ours_step(scene_object *s, double h)
{
    scene_way *at = &s->way;
    if (!s->carries_events) {
        vbss_scene_begin_events(s);
    }
    if (at->waits && vbss_scene_count_changes(s) != at->changes) {
        VBSS_TRY(vbss_scene_end_waiting(s));
    }
    const bool divided = vbss_scene_is_limited(s) && s->config.slot_limit > 0 && at->undivided == 0;
    s->contacts->call_budget.has_progress = false;
    at->left = s->config.slot_limit;
    at->behind++;
    vbss_result result = try_to_go_on(s, h, divided);
    if (result != VBSS_OK) {
        at->behind--;
        return result;
    }
    while (result == VBSS_OK && !at->waits && at->behind > 0 && has_room(s, divided)) {
        result = try_to_go_on(s, h, divided); /* the next call tells, which begins there */
    }
    if (at->waits) {
        vbss_scene_show_tools(s); /* what has been let go as it began */
    }
    leave_out(s, h);
    at->changes = vbss_scene_count_changes(s);
    s->carries_events = false;
    return VBSS_OK;
}
