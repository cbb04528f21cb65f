/* Saves and restores a suspended step (step/time_slice.c).
 *
 * A snapshot holds the position within the step, not the iterate of the attempt. After a restore
 * the attempt is replayed up to the check at which it was suspended. */
#include "base/stream.h"
#include "scene/snapshot/snapshot.h"
#include "scene/step/groups.h"
#include "scene/step/step.h"
#include "scene/world/world.h"
#include "thread/twist.h"

/* Parts of the state that follow the cursor, as bits of its first word. */
enum {
    IS_SUSPENDED = 1,
    HAS_GROUPS = 1 << 1,
    HAS_OVERLAPS = 1 << 2,
    HAS_BLOCKERS = 1 << 3,
    HAS_LIMIT = 1 << 4,
    IS_EDITED = 1 << 5,
    SUSPENDED_AGAIN = 1 << 6, /* two bits: how often, after the first time; 3: not once */
    HAS_OVERDUE = 1 << 8,
    HAS_OWN_BUDGETS = 1 << 9, /* groups whose operations count from their start */
    WAS_OVERDUE = 1 << 10,
    IS_FREE_GROUP = 1 << 11,
    HAS_SETTINGS = 1 << 12, /* something that a host has set at run time */
    HAS_BUDGETS = 1 << 13   /* budgets that a host has set at run time */
};

static bool is_valid_cursor(const scene_object *s, const scene_step_cursor *cursor)
{
    const scene_substep *substep = &cursor->substep;
    return substep->step_length >= 1e-7 && substep->step_length <= 0.1 &&
           substep->start_fraction >= 0.0 && vbss_scene_is_substep_size(s, cursor->initial_size) &&
           vbss_scene_is_substep_size(s, cursor->size) &&
           substep->start_fraction + cursor->size <= 1.0 &&
           cursor->operations_at_attempt <= cursor->operations &&
           cursor->operations < UINT64_MAX / 2;
}

static bool is_valid_target(vec3 target, vec3 force)
{
    return vec3_is_finite(target) && vec3_is_finite(force);
}

/* Visits the targets of attachments in the suspended step; hosts may have set others since. */
static void visit_targets(vbss_stream *stream, scene_object *s)
{
    bool is_valid = true;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        thread_object *t = b->kind == SCENE_BODY_THREAD ? b->thread.thread : NULL;
        drain_object *d = b->kind == SCENE_BODY_DRAIN ? b->drain.drain : NULL;
        for (uint32_t k = 0; t != NULL && k < t->config.attachment_capacity; k++) {
            thread_attachment *a = &t->attachments[k];
            vbss_stream_f64(stream, 156, &a->alternate_target.x, 3);
            vbss_stream_f64(stream, 156, &a->alternate_direction.x, 3);
            vbss_stream_f64(stream, 156, &a->alternate_force.x, 3);
            if (thread_has_twist(t)) {
                vbss_stream_f64(stream, 156, &a->alternate_roll, 1);
            }
            bool unit = a->id == 0 || fabs(vec3_norm(a->alternate_direction) - 1.0) < 1e-6;
            is_valid = is_valid && unit && is_valid_target(a->alternate_target, a->alternate_force);
        }
        for (uint32_t k = 0; d != NULL && k < d->config.attachment_capacity; k++) {
            drain_attachment *a = &d->attachments[k];
            vbss_stream_f64(stream, 157, &a->alternate_target.x, 3);
            vbss_stream_f64(stream, 157, &a->alternate_force.x, 3);
            is_valid = is_valid && is_valid_target(a->alternate_target, a->alternate_force);
        }
    }
    if (stream->mode == VBSS_STREAM_READ && !is_valid) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such place of an attachment");
    }
}

static bool is_valid_group(const scene_object *s, const scene_waiting_group *g)
{
    return g->substep.start_fraction >= 0.0 && vbss_scene_is_substep_size(s, g->size) &&
           g->substep.start_fraction + g->size <= 1.0;
}

/* Visits the contacts in the views from the entry `first` on. */
static void visit_contact_views(vbss_stream *stream, scene_report *r, uint32_t first,
                                uint32_t capacity)
{
    uint32_t words = r->contact_count - first;
    vbss_stream_count(stream, 176, &words, capacity - first);
    const size_t count = stream->result == VBSS_OK ? words : 0;
    r->contact_count = first + (uint32_t)count;
    if (count > 0) {
        vbss_stream_u32(stream, 177, r->contact_features[first], 5 * count);
        vbss_stream_f64(stream, 178, &r->contact_points[first].x, 3 * count);
        vbss_stream_f64(stream, 178, &r->contact_normals[first].x, 3 * count);
        vbss_stream_f64(stream, 178, &r->contact_forces[first].x, 3 * count);
        vbss_stream_f64(stream, 178, r->contact_gaps + first, count);
    }
}

/* Visits the operations of the step after which those of the present and the waiting groups count. */
static void visit_budgets(vbss_stream *stream, scene_step_cursor *cursor)
{
    bool is_valid = true;
    for (uint32_t i = cursor->group; i < cursor->group_count; i++) {
        uint64_t *before =
            i == cursor->group ? &cursor->operations_before : &cursor->waiting[i].operations_before;
        vbss_stream_u64(stream, 184, before, 1);
        is_valid = is_valid && *before <= cursor->operations;
    }
    if (stream->mode == VBSS_STREAM_READ && !is_valid) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such budget of a group");
    }
}

/* Visits the groups of a step that is divided among some. */
static void visit_groups(vbss_stream *stream, scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    const bool reads = stream->mode == VBSS_STREAM_READ;
    bool is_valid = true;
    vbss_stream_u32(stream, 170, &cursor->group, 1);
    vbss_stream_u32(stream, 170, &cursor->group_count, 1);
    vbss_stream_f64(stream, 173, &cursor->paused_fraction, 1);
    is_valid = cursor->paused_fraction >= 0.0 && cursor->paused_fraction <= 1.0;
    if (reads && (cursor->group_count > SCENE_MAX_GROUPS || cursor->group >= cursor->group_count)) {
        is_valid = false;
        cursor->group = 0;
        cursor->group_count = 1;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        vbss_stream_u32(stream, 171, &b->group, 1);
        is_valid = is_valid && b->group < cursor->group_count;
        b->is_frozen = b->group != cursor->group;
    }
    for (uint32_t i = cursor->group + 1; i < cursor->group_count; i++) {
        scene_waiting_group *g = &cursor->waiting[i];
        uint32_t words[] = {g->attempts, g->is_behind_targets + 2u * g->is_free};
        vbss_stream_u32(stream, 172, words, 2);
        vbss_stream_f64(stream, 173, &g->substep.start_fraction, 1);
        vbss_stream_f64(stream, 173, &g->size, 1);
        g->attempts = words[0];
        g->is_behind_targets = (words[1] & 1) != 0;
        g->is_free = (words[1] & 2) != 0;
        g->substep.step_length = cursor->substep.step_length;
        is_valid = is_valid && words[1] <= 3 && is_valid_group(s, g);
    }
    if (reads && !is_valid) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such group of bodies");
    }
    /* Groups that wait still show the contacts of the step before, which do not belong to the state. */
    visit_contact_views(stream, &s->report, s->report.old_contact_count,
                        s->config.contact_capacity);
}

/* Visits the cursor of a suspended step, and how far its attempt had progressed for the replay. */
static void visit_suspended_step(vbss_stream *stream, scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    uint32_t words[] = {cursor->attempts,
                        cursor->is_attempt_suspended,
                        cursor->checks_passed,
                        cursor->substep.has_fixed_normals,
                        cursor->substep.has_search_budget,
                        cursor->is_behind_targets,
                        s->step.cut_count};
    double *numbers[] = {&cursor->substep.step_length, &cursor->substep.start_fraction,
                         &cursor->initial_size, &cursor->size};
    uint64_t *operations[] = {&cursor->operations_at_attempt, &cursor->operations};
    vbss_stream_u32(stream, 151, words, sizeof words / sizeof words[0]);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 152, numbers[i], 1);
    }
    for (size_t i = 0; i < sizeof operations / sizeof operations[0]; i++) {
        vbss_stream_u64(stream, 153, operations[i], 1);
    }
    if (words[1] > 1 || words[3] > 1 || words[4] > 1 || words[5] > 1 || words[6] > SCENE_MAX_CUTS) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such step");
        words[6] = 0;
    }
    cursor->attempts = words[0];
    cursor->is_attempt_suspended = words[1] != 0;
    cursor->checks_passed = words[2];
    cursor->substep.has_fixed_normals = words[3] != 0;
    cursor->substep.has_search_budget = words[4] != 0;
    cursor->is_behind_targets = words[5] != 0;
    s->step.cut_count = words[6];
    for (uint32_t i = 0; i < s->step.cut_count; i++) {
        scene_cut *cut = &s->step.cuts[i];
        vbss_stream_u32(stream, 154, &cut->thread, 1);
        vbss_stream_f64(stream, 155, &cut->arc_length, 1);
        const scene_body *b = vbss_scene_body(s, cut->thread);
        if (stream->mode == VBSS_STREAM_READ &&
            (b == NULL || b->kind != SCENE_BODY_THREAD || !isfinite(cut->arc_length))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such cut");
        }
    }
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        vbss_stream_u32(stream, 158, &s->step.previous_holes[i].id, 1);
        vbss_stream_u32(stream, 158, &s->step.previous_holes[i].needle, 1);
    }
    visit_targets(stream, s);
    if (stream->mode == VBSS_STREAM_READ && !stream->trusted && !is_valid_cursor(s, cursor)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such step");
    }
}

/* Without one, states have the same bytes as in older libraries, whose logs have their hashes. */
static bool has_own_speed_limit(const scene_object *s)
{
    return s->config.speed_limit != SCENE_DEFAULT_SPEED_LIMIT && s->config.speed_limit != 0.0;
}

static bool has_own_budgets(const scene_step_cursor *cursor)
{
    uint64_t sum = cursor->operations_before;
    for (uint32_t i = cursor->group + 1; i < cursor->group_count; i++) {
        sum |= cursor->waiting[i].operations_before;
    }
    return sum != 0;
}

static uint32_t parts_of(const scene_object *s)
{
    const scene_step_cursor *cursor = &s->cursor;
    bool has_groups = cursor->is_suspended && cursor->group_count > 1;
    bool is_edited = cursor->is_suspended && cursor->edit_count != vbss_scene_count_edits(s);
    return (cursor->is_suspended ? IS_SUSPENDED : 0) | (has_groups ? HAS_GROUPS : 0) |
           (s->overlap_count > 0 ? HAS_OVERLAPS : 0) |
           (s->report.blocker_count > 0 ? HAS_BLOCKERS : 0) |
           (has_groups && has_own_budgets(cursor) ? HAS_OWN_BUDGETS : 0) |
           (has_own_speed_limit(s) ? HAS_LIMIT : 0) | (is_edited ? IS_EDITED : 0) |
           (cursor->is_suspended ? (cursor->suspensions + 3) % 4 * SUSPENDED_AGAIN : 0) |
           (cursor->was_overdue ? WAS_OVERDUE : 0) |
           (cursor->is_suspended && cursor->is_free_group ? IS_FREE_GROUP : 0) |
           (s->report.statistics.overdue > 0 ? HAS_OVERDUE : 0) |
           (vbss_scene_has_settings(s) ? HAS_SETTINGS : 0) |
           (vbss_scene_has_budgets(s) ? HAS_BUDGETS : 0);
}

static uint32_t suspensions_of(uint32_t parts)
{
    return (parts & IS_SUSPENDED) != 0 ? (1 + parts / SUSPENDED_AGAIN) % 4 : 0;
}

static bool is_valid_state(const scene_object *s, const uint32_t words[3])
{
    const uint32_t parts = words[0], is_suspended = parts & IS_SUSPENDED;
    const uint32_t of_suspended = HAS_GROUPS | IS_EDITED | IS_FREE_GROUP | 3 * SUSPENDED_AGAIN;
    bool is_implicit = s->contacts != NULL; /* the baseline method never suspends a step */
    return parts < 2 * HAS_BUDGETS &&
           ((parts & HAS_OWN_BUDGETS) == 0 || (parts & HAS_GROUPS) != 0) &&
           ((parts & of_suspended) == 0 || is_suspended) &&
           suspensions_of(parts) <= SCENE_MAX_SUSPENSIONS && words[1] + is_suspended <= 2 &&
           words[1] <= 2 && (is_implicit || (is_suspended == 0 && words[1] == 0));
}

static void put_in_one_group(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        s->bodies[i].group = 0;
        s->bodies[i].is_frozen = false;
    }
}

/* Visits the driven bodies that overlap (world/driven_overlaps.c). */
static void visit_overlaps(vbss_stream *stream, scene_object *s, bool has_overlaps)
{
    s->overlap_count = has_overlaps ? s->overlap_count : 0;
    if (has_overlaps) {
        vbss_stream_count(stream, 174, &s->overlap_count, SCENE_MAX_OVERLAPS);
        vbss_stream_u32(stream, 175, &s->overlaps->body_a, 2 * (size_t)s->overlap_count);
    }
}

/* Visits the bodies that are held back (world/blockers.c). */
static void visit_blockers(vbss_stream *stream, scene_report *r, bool has_blockers)
{
    r->blocker_count = has_blockers ? r->blocker_count : 0;
    if (!has_blockers) {
        return;
    }
    vbss_stream_count(stream, 179, &r->blocker_count, SCENE_MAX_BLOCKERS);
    for (uint32_t i = 0; stream->result == VBSS_OK && i < r->blocker_count; i++) {
        scene_blocker *b = &r->blockers[i];
        uint32_t words[] = {b->bodies.body_a, b->bodies.body_b, (uint32_t)b->cause};
        double *numbers[] = {&b->since, &b->last, &b->lost_time, &b->depth};
        vbss_stream_u32(stream, 180, words, sizeof words / sizeof words[0]);
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
            vbss_stream_f64(stream, 181, numbers[k], 1);
        }
        if (words[2] > VBSS_SCENE_BLOCKER_CONVERGENCE) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such cause");
            words[2] = VBSS_SCENE_BLOCKER_WORK;
        }
        b->bodies = (scene_touching_pair){words[0], words[1]};
        b->cause = (vbss_scene_blocker_cause)words[2];
    }
}

/* Visits the speed limit. A snapshot without one is of the default limit, or of no limit as in older
 * libraries. */
static void visit_speed_limit(vbss_stream *stream, const scene_object *s, bool has_limit)
{
    if (has_limit) {
        vbss_stream_expect_f64(stream, 182, s->config.speed_limit);
    } else if (has_own_speed_limit(s)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "another speed limit");
    }
}

static void visit_overdue(vbss_stream *stream, vbss_scene_statistics *statistics, bool has_overdue)
{
    if (has_overdue) {
        vbss_stream_u32(stream, 183, &statistics->overdue, 1);
    } else {
        statistics->overdue = 0;
    }
}

void vbss_scene_visit_cursor(vbss_stream *stream, scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    const bool reads = stream->mode == VBSS_STREAM_READ;
    uint32_t words[] = {parts_of(s), cursor->steps_behind, cursor->unsliced_steps_left};
    if (stream->version >= 6) {
        vbss_stream_u32(stream, 150, words, sizeof words / sizeof words[0]);
    } else {
        words[0] = words[1] = words[2] = 0;
    }
    if (reads && !is_valid_state(s, words)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such step");
        words[0] = words[1] = 0;
    }
    if (reads) {
        *cursor = (scene_step_cursor){.is_suspended = (words[0] & IS_SUSPENDED) != 0,
                                      .group_count = 1,
                                      .is_free_group = (words[0] & IS_FREE_GROUP) != 0,
                                      .was_overdue = (words[0] & WAS_OVERDUE) != 0,
                                      .suspensions = suspensions_of(words[0]),
                                      .steps_behind = words[1],
                                      .unsliced_steps_left = words[2]};
        put_in_one_group(s);
        s->report.contact_count = s->report.old_contact_count = 0;
    }
    if (cursor->is_suspended) {
        visit_suspended_step(stream, s);
    }
    if ((words[0] & HAS_GROUPS) != 0) {
        visit_groups(stream, s);
    }
    if ((words[0] & HAS_OWN_BUDGETS) != 0) {
        visit_budgets(stream, cursor);
    }
    visit_overlaps(stream, s, (words[0] & HAS_OVERLAPS) != 0);
    visit_blockers(stream, &s->report, (words[0] & HAS_BLOCKERS) != 0);
    visit_speed_limit(stream, s, (words[0] & HAS_LIMIT) != 0);
    visit_overdue(stream, &s->report.statistics, (words[0] & HAS_OVERDUE) != 0);
    vbss_scene_visit_settings(stream, s, (words[0] & HAS_SETTINGS) != 0);
    vbss_scene_visit_budgets(stream, s, (words[0] & HAS_BUDGETS) != 0);
    if (reads) {
        vbss_scene_set_substep_limits(s);
        s->report.keeps_logged_events = false;
        /* Another count than that of the bodies ends the suspended step. */
        cursor->edit_count = vbss_scene_count_edits(s) - ((words[0] & IS_EDITED) != 0);
    }
}

static void visit_event(vbss_stream *stream, vbss_scene_event *e)
{
    uint32_t words[] = {(uint32_t)e->kind, e->body_a, e->body_b, e->id, e->flags};
    double numbers[] = {e->time,        e->value,       e->arc_length,
                        e->position[0], e->position[1], e->position[2]};
    vbss_stream_u32(stream, 196, words, sizeof words / sizeof words[0]);
    vbss_stream_u64(stream, 197, &e->step, 1);
    vbss_stream_f64(stream, 198, numbers, sizeof numbers / sizeof numbers[0]);
    *e = (vbss_scene_event){.struct_size = sizeof *e,
                            .kind = (vbss_scene_event_kind)words[0],
                            .body_a = words[1],
                            .body_b = words[2],
                            .id = words[3],
                            .flags = words[4],
                            .step = e->step,
                            .time = numbers[0],
                            .value = numbers[1],
                            .arc_length = numbers[2],
                            .position = {numbers[3], numbers[4], numbers[5]}};
}

/* Events that hosts have not taken, and those of a suspended step. */
static void visit_events(vbss_stream *stream, scene_object *s)
{
    scene_events *events = &s->events;
    const uint32_t capacity = s->config.event_capacity;
    vbss_stream_count(stream, 199, &events->count, capacity);
    for (uint32_t i = 0; i < events->count; i++) {
        visit_event(stream, &events->ring[(uint32_t)(((uint64_t)events->first + i) % capacity)]);
    }
    vbss_stream_u64(stream, 200, &events->lost, 1);
    vbss_stream_count(stream, 201, &events->pending_count, capacity);
    for (uint32_t i = 0; i < events->pending_count; i++) {
        visit_event(stream, &events->pending[i]);
    }
    vbss_stream_u32(stream, 202, &events->pending_lost, 1);
}

void vbss_scene_visit_report(vbss_stream *stream, scene_object *s)
{
    scene_report *r = &s->report;
    vbss_stream_bool(stream, 190, &r->keeps_logged_events);
    vbss_stream_count(stream, 191, &r->logged_event_count, s->config.event_capacity);
    const size_t count = stream->result == VBSS_OK ? r->logged_event_count : 0;
    if (count > 0) {
        vbss_stream_u32(stream, 192, r->logged_events[0], 4 * count);
    }
    vbss_stream_u32(stream, 193, &r->lost_logged_events, 1);
    visit_events(stream, s);
    visit_contact_views(stream, r, 0, s->config.contact_capacity);
    vbss_stream_u32(stream, 195, &r->old_contact_count, 1);
    vbss_stream_u64(stream, 194, &r->generation, 1);
}
