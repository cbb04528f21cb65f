/* The list of constraints of a substep, and their warm start from the substep before. */
#include "base/memory.h"
#include "contact/contact.h"

#include <stddef.h>
#include <string.h>

/* ---- creation and destruction */

enum { PARTS = 10 };

static void list_arrays(contact_set *s, vbss_array arrays[PARTS])
{
    const vbss_array all[PARTS] = {
        {&s->constraints, s->capacity + 1, sizeof *s->constraints}, /* one for vbss_contact_try */
        {&s->sort_permutation, s->capacity, sizeof *s->sort_permutation},
        {&s->warm_start, s->capacity, sizeof *s->warm_start},
        {&s->checkpoint, s->capacity, sizeof *s->checkpoint},
        {&s->next_solutions, s->capacity, sizeof *s->next_solutions},
        {&s->saved_solutions, s->capacity, sizeof *s->saved_solutions},
        {&s->current, s->capacity, sizeof *s->current},
        {&s->candidate, s->capacity, sizeof *s->candidate},
        {&s->simd_batches, (s->capacity + LANES - 1) / LANES, sizeof *s->simd_batches},
        {&s->schur_indices, s->schur_index_capacity, sizeof *s->schur_indices},
    };
    memcpy(arrays, all, sizeof all);
}

vbss_result vbss_contact_create(vbss_context *context, uint32_t capacity, contact_set **set)
{
    vbss_array arrays[PARTS];
    contact_set *s = vbss_allocate(context, 1, sizeof *s, "contacts");
    *set = NULL;
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->capacity = capacity;
    s->schur_index_capacity =
        capacity * CONTACT_MAX_JACOBIAN_BLOCKS * (CONTACT_MAX_JACOBIAN_BLOCKS + 1);
    list_arrays(s, arrays);
    vbss_result result = vbss_allocate_arrays(context, arrays, PARTS, "contacts");
    if (result != VBSS_OK) {
        vbss_contact_destroy(context, s);
        return result;
    }
    *set = s;
    return VBSS_OK;
}

void vbss_contact_destroy(vbss_context *context, contact_set *set)
{
    vbss_array arrays[PARTS];
    if (set == NULL) {
        return;
    }
    list_arrays(set, arrays);
    vbss_release_arrays(context, arrays, PARTS);
    vbss_release(context, set, 1, sizeof *set);
}

/* ---- the list */

int vbss_contact_compare_keys(const contact_key *x, const contact_key *y)
{
    const uint32_t p[5] = {x->kind, x->body_a, x->feature_a, x->body_b, x->feature_b};
    const uint32_t q[5] = {y->kind, y->body_a, y->feature_a, y->body_b, y->feature_b};
    for (int i = 0; i < 5; i++) {
        if (p[i] != q[i]) {
            return p[i] < q[i] ? -1 : 1;
        }
    }
    return 0;
}

void vbss_contact_clear(contact_set *set)
{
    set->count = set->schur_index_count = 0;
}

contact_constraint *vbss_contact_add(contact_set *set, const contact_key *key)
{
    return set->count == set->capacity ? NULL : vbss_contact_try(set, key);
}

contact_constraint *vbss_contact_try(contact_set *set, const contact_key *key)
{
    contact_constraint *constraint = &set->constraints[set->count];
    constraint->key = *key; /* the Jacobian, most of the record, is not read until it is set */
    constraint->jacobian_block_count = 0;
    constraint->is_bilateral = constraint->is_sleeve = constraint->is_sliding =
        constraint->may_lag = false;
    constraint->friction = constraint->tangential_stiffness_ratio = constraint->elastic_slip_limit =
        constraint->recovery_allowance = constraint->lagged_transverse = constraint->tear_force =
            0.0;
    constraint->solution = (contact_solution){.status = CONTACT_OPEN};
    constraint->previous_force = vec3_zero();
    constraint->schur_offset = UINT32_MAX;
    constraint->geometry = set->count++;
    return constraint;
}

/* Position of the next constraint among those before it, after equal keys. */
static uint32_t find_insertion(const contact_set *set, uint32_t next)
{
    const contact_key *key = &set->constraints[next].key;
    uint32_t low = 0, high = next;
    if (next == 0 || vbss_contact_compare_keys(
                         &set->constraints[set->sort_permutation[next - 1]].key, key) <= 0) {
        return next; /* the common case: constraints come in a few sequences, each sorted */
    }
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        bool before = vbss_contact_compare_keys(
                          &set->constraints[set->sort_permutation[middle]].key, key) <= 0;
        low = before ? middle + 1 : low;
        high = before ? high : middle;
    }
    return low;
}

static bool find_sort_permutation(const contact_set *set)
{
    bool in_order = true;
    for (uint32_t i = 0; i < set->count; i++) {
        uint32_t to = find_insertion(set, i);
        memmove(&set->sort_permutation[to + 1], &set->sort_permutation[to],
                (i - to) * sizeof *set->sort_permutation);
        set->sort_permutation[to] = i;
        in_order = in_order && to == i;
    }
    return in_order;
}

void vbss_contact_move(contact_constraint *to, const contact_constraint *from)
{
    memcpy(to, from,
           offsetof(contact_constraint, jacobian) +
               from->jacobian_block_count * sizeof *from->jacobian);
}

/* Applies the permutation cycle by cycle with one temporary copy: records are large, so each moves
 * once. */
void vbss_contact_sort(contact_set *set)
{
    if (find_sort_permutation(set)) {
        return;
    }
    for (uint32_t i = 0; i < set->count; i++) {
        if (set->sort_permutation[i] == i) {
            continue;
        }
        contact_constraint first;
        vbss_contact_move(&first, &set->constraints[i]);
        uint32_t to = i;
        for (uint32_t from = set->sort_permutation[to]; from != i;
             from = set->sort_permutation[to]) {
            vbss_contact_move(&set->constraints[to], &set->constraints[from]);
            set->sort_permutation[to] = to;
            to = from;
        }
        vbss_contact_move(&set->constraints[to], &first);
        set->sort_permutation[to] = to;
    }
}

uint32_t vbss_contact_find(const contact_set *set, const contact_key *key)
{
    uint32_t low = 0, high = set->count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (vbss_contact_compare_keys(&set->constraints[middle].key, key) < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    bool is_found =
        low < set->count && vbss_contact_compare_keys(&set->constraints[low].key, key) == 0;
    return is_found ? low : UINT32_MAX;
}

double vbss_contact_max_penetration(const contact_set *set)
{
    double depth = 0.0;
    for (uint32_t i = 0; i < set->count; i++) {
        if (!set->constraints[i].is_bilateral) {
            depth =
                vbss_max(set->constraints[i].recovery_allowance - set->constraints[i].gap, depth);
        }
    }
    return depth;
}

bool vbss_contact_penetration_is_allowed(const contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        if (!constraint->is_bilateral && !(-constraint->gap <= constraint->allowed_penetration)) {
            return false;
        }
    }
    return true;
}

/* ---- warm start */

/* previous_force is already set by the module that created the sleeve. */
static void warm_start_sleeve(contact_constraint *constraint, const contact_warm_start_entry *entry)
{
    constraint->solution.tangential_force =
        vbss_contact_rotate_to_tangent_plane(entry->tangential_force, constraint->normal);
    constraint->solution.slip_direction =
        vec3_unit_or(constraint->solution.tangential_force, vec3_any_normal(constraint->normal));
    constraint->solution.is_forward = entry->is_forward;
    constraint->solution.status = (contact_status)entry->status;
    constraint->solution.normal_force = entry->normal_force;
    constraint->solution.tear_limit = 0.0;
}

static double find_tangential_stiffness_ratio(const contact_constraint *constraint,
                                              double normal_force)
{
    double max_friction = constraint->friction * normal_force,
           force_at_limit = constraint->stiffness * constraint->elastic_slip_limit;
    /* 0 means the full stiffness */
    return 0.0 < max_friction && max_friction < force_at_limit ? max_friction / force_at_limit
                                                               : 0.0;
}

static void warm_start_constraint(contact_constraint *constraint,
                                  const contact_warm_start_entry *entry)
{
    if (constraint->is_sleeve) {
        warm_start_sleeve(constraint, entry);
        return;
    }
    constraint->solution.status = (contact_status)entry->status;
    constraint->solution.normal_force = entry->normal_force;
    constraint->tangential_stiffness_ratio =
        constraint->is_bilateral ? constraint->tangential_stiffness_ratio
                                 : find_tangential_stiffness_ratio(constraint, entry->normal_force);
    constraint->previous_force = constraint->solution.tangential_force =
        vbss_contact_rotate_to_tangent_plane(entry->tangential_force, constraint->normal);
    if (constraint->solution.status == CONTACT_SLIP) {
        double size = vec3_norm(constraint->solution.tangential_force);
        constraint->solution.slip_direction =
            vec3_scale(constraint->solution.tangential_force, size > 0.0 ? 1.0 / size : 0.0);
        constraint->solution.friction_ratio = entry->friction_ratio;
        if (!(size > 0.0)) {
            constraint->solution.status = CONTACT_STICK;
        }
    }
}

void vbss_contact_warm_start_one(contact_set *set, uint32_t entry_index, uint32_t constraint_index)
{
    warm_start_constraint(&set->constraints[constraint_index], &set->warm_start[entry_index]);
}

void vbss_contact_warm_start_neighbour(contact_set *set, uint32_t entry_index)
{
    const contact_warm_start_entry *entry = &set->warm_start[entry_index];
    for (uint32_t da = 0; da < 3; da++) {
        /* feature 0 minus 1 wraps to a number that no feature has */
        contact_key key = entry->key;
        key.feature_a += da - 1;
        key.feature_b -= 1;
        for (uint32_t db = 0; db < 3; db++, key.feature_b++) {
            uint32_t i = vbss_contact_find(set, &key);
            if (i != UINT32_MAX && set->constraints[i].solution.status == CONTACT_OPEN) {
                warm_start_constraint(&set->constraints[i], entry);
                return;
            }
        }
    }
}

void vbss_contact_warm_start(contact_set *set)
{
    uint32_t m = 0;
    for (uint32_t i = 0; i < set->count; i++) {
        contact_constraint *constraint = &set->constraints[i];
        constraint->solution.status = constraint->is_bilateral ? CONTACT_STICK : CONTACT_OPEN;
        constraint->solution.normal_force = 0.0;
        constraint->solution.tangential_force = vec3_zero();
        constraint->previous_force =
            constraint->is_sleeve ? constraint->previous_force : vec3_zero();
        for (; m < set->warm_start_count; m++) {
            int order = vbss_contact_compare_keys(&set->warm_start[m].key, &constraint->key);
            if (order > 0) {
                break;
            }
            set->warm_start[m].has_constraint = order == 0;
            if (order == 0) {
                warm_start_constraint(constraint, &set->warm_start[m]);
            }
        }
    }
    for (; m < set->warm_start_count; m++) {
        set->warm_start[m].has_constraint = false;
    }
}

/* Moves the entries that stay to the front, and returns their number. */
static uint32_t keep_entries(contact_set *set, const uint8_t *keeps)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        if (keeps[i] != 0) {
            set->warm_start[kept++] = set->warm_start[i];
        }
    }
    return kept;
}

/* Sorts the entries by insertion: those that stayed and those after them are sorted already. */
static void sort_entries(contact_set *set)
{
    for (uint32_t i = 1; i < set->warm_start_count; i++) {
        const contact_warm_start_entry entry = set->warm_start[i];
        uint32_t to = i;
        while (to > 0 && vbss_contact_compare_keys(&set->warm_start[to - 1].key, &entry.key) > 0) {
            set->warm_start[to] = set->warm_start[to - 1];
            to--;
        }
        set->warm_start[to] = entry;
    }
}

/* Appends the constraints that carry a force. */
static void append_entries(contact_set *set)
{
    for (uint32_t i = 0; i < set->count && set->warm_start_count < set->capacity; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        if (constraint->solution.status != CONTACT_OPEN) {
            contact_warm_start_entry *entry = &set->warm_start[set->warm_start_count++];
            entry->key = constraint->key;
            entry->status = (uint8_t)constraint->solution.status;
            entry->is_forward = constraint->solution.is_forward;
            entry->normal_force = constraint->solution.normal_force;
            entry->friction_ratio = constraint->solution.friction_ratio;
            entry->tangential_force = constraint->solution.tangential_force;
        }
    }
}

void vbss_contact_store_warm_start(contact_set *set)
{
    set->warm_start_count = 0;
    append_entries(set);
}

void vbss_contact_store_warm_start_beside(contact_set *set, const uint8_t *keeps)
{
    set->warm_start_count = keep_entries(set, keeps);
    append_entries(set);
    sort_entries(set);
}

void vbss_contact_checkpoint(contact_set *set)
{
    memcpy(set->checkpoint, set->warm_start, set->warm_start_count * sizeof *set->warm_start);
    set->checkpoint_count = set->warm_start_count;
    set->checkpoint_residual = set->residual;
    set->checkpoint_counters = set->counters;
}

void vbss_contact_rollback(contact_set *set)
{
    memcpy(set->warm_start, set->checkpoint, set->checkpoint_count * sizeof *set->warm_start);
    set->warm_start_count = set->checkpoint_count;
    set->residual = set->checkpoint_residual;
    set->counters = set->checkpoint_counters;
}
