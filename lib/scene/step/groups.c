/* Groups of bodies that take their substeps one after the other (groups.h). */
#include "scene/step/groups.h"
#include "scene/solve/solve.h"
#include "scene/world/world.h"

#include <string.h>

double vbss_scene_substep_size(uint32_t halvings)
{
    double size = 1.0;
    for (uint32_t i = 0; i < halvings; i++) {
        size *= 0.5;
    }
    return size;
}

uint32_t vbss_scene_halvings_of(double size)
{
    uint32_t halvings = 0;
    while (size < 1.0 && halvings < SCENE_MAX_HALVINGS) {
        size *= 2.0;
        halvings++;
    }
    return halvings;
}

static void freeze_other_groups(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        s->bodies[i].is_frozen = s->bodies[i].group != s->cursor.group;
    }
    s->step.pattern_hash = 0;
}

void vbss_scene_begin_first_group(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    uint32_t fewest = UINT32_MAX;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        b->group = 0;
        b->is_frozen = false;
        if (vbss_scene_is_mobile(s, b) && b->next_halvings < fewest) {
            fewest = b->next_halvings;
        }
    }
    cursor->group = cursor->attempts = cursor->truncations = 0;
    cursor->operations_before = 0;
    cursor->is_free_group = false;
    cursor->group_count = 1;
    cursor->is_behind_targets = cursor->is_paused = false;
    cursor->paused_fraction = 0.0;
    cursor->initial_size = cursor->size =
        fewest == UINT32_MAX ? 1.0 : vbss_scene_substep_size(fewest);
}

bool vbss_scene_begin_next_group(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    if (cursor->group + 1 >= cursor->group_count) {
        return false;
    }
    const scene_waiting_group *next = &cursor->waiting[++cursor->group];
    cursor->substep = next->substep;
    cursor->initial_size = cursor->size = next->size;
    cursor->attempts = next->attempts;
    cursor->truncations = 0;
    cursor->operations_before = next->operations_before;
    cursor->is_behind_targets = next->is_behind_targets;
    cursor->is_paused = cursor->is_attempt_suspended = cursor->is_attempt_in_memory = false;
    cursor->is_free_group = next->is_free;
    freeze_other_groups(s);
    return true;
}

void vbss_scene_release_groups(scene_object *s)
{
    if (s->cursor.group_count == 1) {
        return;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        s->bodies[i].is_frozen = false;
        s->bodies[i].group = 0;
    }
    s->cursor.group = 0;
    s->cursor.group_count = 1;
    s->step.pattern_hash = 0;
}

/* Whether some mobile body of the present group is not in the group `except`. */
static bool has_mobile_body_outside(const scene_object *s, uint32_t except)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].group != except && vbss_scene_is_mobile(s, &s->bodies[i])) {
            return true;
        }
    }
    return false;
}

/* Lets the bodies that have been moved to the last group wait. If no body would be left, returns
 * false, and all bodies stay in the present group. */
static bool let_last_group_wait(scene_object *s, double size)
{
    scene_step_cursor *cursor = &s->cursor;
    const uint32_t last = cursor->group_count;
    if (!has_mobile_body_outside(s, last)) {
        for (uint32_t i = 0; i < s->body_count; i++) {
            scene_body *b = &s->bodies[i];
            b->group = b->group == last ? cursor->group : b->group;
        }
        return false;
    }
    cursor->waiting[last] = (scene_waiting_group){.substep = cursor->substep,
                                                  .size = size,
                                                  .attempts = cursor->attempts,
                                                  .is_behind_targets = cursor->is_behind_targets,
                                                  .operations_before = cursor->operations_before};
    cursor->group_count++;
    freeze_other_groups(s);
    return true;
}

/* Moves the island of a body to the group that is made next. */
static void move_island(scene_object *s, const scene_body *of)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (vbss_scene_is_in_island(s, &s->bodies[i], of)) {
            s->bodies[i].group = s->cursor.group_count;
        }
    }
}

bool vbss_scene_split_slow_islands(scene_object *s, bool has_all_pairs)
{
    scene_step_cursor *cursor = &s->cursor;
    if (cursor->attempts > 0 || cursor->substep.start_fraction > 0.0 || cursor->is_free_group) {
        return false;
    }
    uint32_t max_halvings = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        max_halvings = vbss_scene_is_mobile(s, b) && b->next_halvings > max_halvings
                           ? b->next_halvings
                           : max_halvings;
    }
    const double size = vbss_scene_substep_size(max_halvings);
    if (size >= cursor->size) {
        return false;
    }
    if (cursor->group_count < SCENE_MAX_GROUPS) {
        vbss_scene_find_islands(s, has_all_pairs);
        for (uint32_t i = 0; i < s->body_count; i++) {
            const scene_body *b = &s->bodies[i];
            if (vbss_scene_substep_size(b->next_halvings) < cursor->size) {
                move_island(s, b);
            }
        }
        if (let_last_group_wait(s, size)) {
            return true;
        }
    }
    cursor->initial_size = cursor->size = size;
    return true;
}

static bool has_group(const scene_object *s, uint32_t group)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].group == group) {
            return true;
        }
    }
    return false;
}

/* Whether the island of a body is the body alone, and nothing touches it in the last attempt. */
static bool is_free(const scene_object *s, const scene_body *b)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *other = &s->bodies[i];
        if (other != b && vbss_scene_is_in_island(s, other, b)) {
            return false;
        }
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_key *key = &s->contacts->constraints[i].key;
        if (key->body_a == b->number || key->body_b == b->number) {
            return false;
        }
    }
    return true;
}

bool vbss_scene_do_others_wait(scene_object *s)
{
    const scene_body *first = NULL;
    if (s->cursor.group_count > 1 || !s->cursor.is_attempt_suspended) {
        return true;
    }
    vbss_scene_find_islands(s, true);
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (vbss_scene_is_mobile(s, b)) {
            first = first == NULL ? b : first;
            if (!vbss_scene_is_in_island(s, b, first)) {
                return true;
            }
        }
    }
    return false;
}

bool vbss_scene_put_free_bodies_first(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    const uint32_t last = cursor->group_count;
    if (!cursor->was_overdue) {
        return false;
    }
    cursor->was_overdue = false;
    if (last == SCENE_MAX_GROUPS) {
        return false;
    }
    cursor->is_free_group = true;
    vbss_scene_find_islands(s, true);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (vbss_scene_is_mobile(s, b) && (b->kind == SCENE_BODY_DRAIN || !is_free(s, b))) {
            b->group = last;
        }
    }
    if (has_group(s, last) && !let_last_group_wait(s, cursor->size)) {
        cursor->is_free_group = false;
    }
    return cursor->is_free_group;
}

static void move_failed_islands(scene_object *s, scene_touching_pair blamed)
{
    vbss_scene_find_islands(s, true);
    move_island(s, vbss_scene_body(s, blamed.body_a));
    move_island(s, vbss_scene_body(s, blamed.body_b));
}

bool vbss_scene_split_failed_island(scene_object *s, scene_substep_outcome outcome, double size)
{
    const uint32_t last = s->cursor.group_count;
    if (last == SCENE_MAX_GROUPS || outcome == SCENE_SUBSTEP_OUT_OF_CAPACITY) {
        return false;
    }
    move_failed_islands(s, vbss_scene_find_blamed_pair(s, outcome));
    if (!has_group(s, last) || !let_last_group_wait(s, size)) {
        return false;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].group == last) {
            vbss_scene_request_damping_of(&s->bodies[i]);
        }
    }
    return true;
}

/* Makes the last group the next one. */
static void begin_last_group_next(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    const uint32_t next = cursor->group + 1, last = cursor->group_count - 1;
    const scene_waiting_group group = cursor->waiting[last];
    memmove(&cursor->waiting[next + 1], &cursor->waiting[next],
            (last - next) * sizeof cursor->waiting[0]);
    cursor->waiting[next] = group;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        b->group = b->group == last ? next : b->group + (b->group >= next);
    }
}

void vbss_scene_let_others_wait(scene_object *s, scene_touching_pair blamed)
{
    scene_step_cursor *cursor = &s->cursor;
    const uint32_t last = cursor->group_count;
    if (last == SCENE_MAX_GROUPS) {
        return;
    }
    move_failed_islands(s, blamed);
    const bool are_others = has_group(s, last) && has_mobile_body_outside(s, last);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (!b->is_frozen) {
            b->group = are_others && b->group != last ? last : cursor->group;
        }
    }
    if (are_others) {
        cursor->waiting[last] =
            (scene_waiting_group){.substep = cursor->substep,
                                  .size = cursor->size,
                                  .is_behind_targets = cursor->is_behind_targets,
                                  .is_free = cursor->is_free_group,
                                  .operations_before = s->contacts->counters.operations};
        cursor->group_count++;
        begin_last_group_next(s);
        freeze_other_groups(s);
    }
}

void vbss_scene_set_next_size(scene_object *s, scene_touching_pair blamed, double size)
{
    const uint32_t last = s->cursor.group_count;
    move_failed_islands(s, blamed);
    const bool is_known = has_group(s, last) && has_mobile_body_outside(s, last);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->is_frozen) {
            continue;
        }
        b->next_halvings = !is_known || b->group == last ? vbss_scene_halvings_of(size) : 0;
        b->group = s->cursor.group;
    }
}
