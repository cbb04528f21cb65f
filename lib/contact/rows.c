/* Rows of a part of a step, and what is remembered of them until the next. */
#include "base/memory.h"
#include "contact/contact.h"

#include <string.h>

/* ---- memory of the set */

enum { PARTS = 11 };

static void list_parts(contact_set *s, vbss_array parts[PARTS])
{
    const vbss_array all[PARTS] = {
        {&s->rows, s->capacity, sizeof *s->rows},
        {&s->from, s->capacity, sizeof *s->from},
        {&s->memory, s->capacity, sizeof *s->memory},
        {&s->marked, s->capacity, sizeof *s->marked},
        {&s->recalled, s->capacity, sizeof *s->recalled},
        {&s->next, s->capacity, sizeof *s->next},
        {&s->found_before, s->capacity, sizeof *s->found_before},
        {&s->here, s->capacity, sizeof *s->here},
        {&s->there, s->capacity, sizeof *s->there},
        {&s->fours, (s->capacity + LANES - 1) / LANES, sizeof *s->fours},
        {&s->places, s->place_capacity, sizeof *s->places},
    };
    memcpy(parts, all, sizeof all);
}

vbss_result vbss_contact_create(vbss_context *context, uint32_t capacity, contact_set **set)
{
    vbss_array parts[PARTS];
    contact_set *s = vbss_allocate(context, 1, sizeof *s, "contacts");
    *set = NULL;
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->capacity = capacity;
    s->place_capacity = capacity * CONTACT_TERMS * (CONTACT_TERMS + 1);
    list_parts(s, parts);
    vbss_result result = vbss_allocate_arrays(context, parts, PARTS, "contacts");
    if (result != VBSS_OK) {
        vbss_contact_destroy(context, s);
        return result;
    }
    *set = s;
    return VBSS_OK;
}

void vbss_contact_destroy(vbss_context *context, contact_set *set)
{
    vbss_array parts[PARTS];
    if (set == NULL) {
        return;
    }
    list_parts(set, parts);
    vbss_release_arrays(context, parts, PARTS);
    vbss_release(context, set, 1, sizeof *set);
}

/* ---- the list */

int vbss_contact_compare(const contact_key *x, const contact_key *y)
{
    const uint32_t p[5] = {x->kind, x->body_a, x->a, x->body_b, x->b};
    const uint32_t q[5] = {y->kind, y->body_a, y->a, y->body_b, y->b};
    for (int i = 0; i < 5; i++) {
        if (p[i] != q[i]) {
            return p[i] < q[i] ? -1 : 1;
        }
    }
    return 0;
}

void vbss_contact_begin(contact_set *set)
{
    set->count = set->place_count = 0;
}

contact_row *vbss_contact_add(contact_set *set, const contact_key *key)
{
    if (set->count == set->capacity) {
        return NULL;
    }
    contact_row *row = &set->rows[set->count++];
    row->key = *key; /* most of it, the terms, is not looked at until it is set */
    row->term_count = 0;
    row->bilateral = false;
    row->sleeve = false;
    row->along = row->spent = row->walls = row->eased = 0.0;
    row->piece[0][0] = row->piece[1][0] = 0.0;
    row->piece[0][1] = row->piece[1][1] = 1.0;
    row->is = (contact_found){.state = CONTACT_OPEN};
    row->held = vec3_zero();
    row->first_place = UINT32_MAX;
    return row;
}

/* Where the next row belongs among those before, behind its like. */
static uint32_t place_among(const contact_set *set, uint32_t next)
{
    const contact_key *key = &set->rows[next].key;
    uint32_t low = 0, high = next;
    if (next == 0 || vbss_contact_compare(&set->rows[set->from[next - 1]].key, key) <= 0) {
        return next; /* they come in a few sequences, each in order */
    }
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        bool before = vbss_contact_compare(&set->rows[set->from[middle]].key, key) <= 0;
        low = before ? middle + 1 : low;
        high = before ? high : middle;
    }
    return low;
}

static bool list_order(const contact_set *set)
{
    bool in_order = true;
    for (uint32_t i = 0; i < set->count; i++) {
        uint32_t to = place_among(set, i);
        memmove(&set->from[to + 1], &set->from[to], (i - to) * sizeof *set->from);
        set->from[to] = i;
        in_order = in_order && to == i;
    }
    return in_order;
}

/* Rows are large: each goes to its place at once, in rings of which the first waits aside. */
void vbss_contact_sort(contact_set *set)
{
    if (list_order(set)) {
        return;
    }
    for (uint32_t i = 0; i < set->count; i++) {
        if (set->from[i] == i) {
            continue;
        }
        const contact_row first = set->rows[i];
        uint32_t to = i;
        for (uint32_t from = set->from[to]; from != i; from = set->from[to]) {
            set->rows[to] = set->rows[from];
            set->from[to] = to;
            to = from;
        }
        set->rows[to] = first;
        set->from[to] = to;
    }
}

uint32_t vbss_contact_find(const contact_set *set, const contact_key *key)
{
    uint32_t low = 0, high = set->count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (vbss_contact_compare(&set->rows[middle].key, key) < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    bool there = low < set->count && vbss_contact_compare(&set->rows[low].key, key) == 0;
    return there ? low : UINT32_MAX;
}

double vbss_contact_depth(const contact_set *set)
{
    double depth = 0.0;
    for (uint32_t i = 0; i < set->count; i++) {
        if (!set->rows[i].bilateral) {
            depth = vbss_max(set->rows[i].eased - set->rows[i].gap, depth);
        }
    }
    return depth;
}

bool vbss_contact_depth_is_allowed(const contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_row *row = &set->rows[i];
        if (!row->bilateral && !(-row->gap <= row->depth_allowed)) {
            return false;
        }
    }
    return true;
}

/* ---- memory from part to part */

/* Whoever lays it knows what it held. */
static void remind_sleeve(contact_row *row, const contact_memory *m)
{
    row->is.rubbing = vbss_contact_turn_into_plane(m->rubbing, row->normal);
    row->is.way = vec3_unit_or(row->is.rubbing, vec3_any_normal(row->normal));
    row->is.share = m->share;
    row->is.state = (contact_state)m->state;
    row->is.pressure = m->pressure;
}

static double share_along(const contact_row *row, double pressure)
{
    double most = row->friction * pressure, whole = row->stiffness * row->spent;
    return 0.0 < most && most < whole ? most / whole : 0.0; /* 0: all of it */
}

static void remind(contact_row *row, const contact_memory *m)
{
    if (row->sleeve) {
        remind_sleeve(row, m);
        return;
    }
    row->is.state = (contact_state)m->state;
    row->is.pressure = m->pressure;
    row->along = row->bilateral ? row->along : share_along(row, m->pressure);
    row->held = row->is.rubbing = vbss_contact_turn_into_plane(m->rubbing, row->normal);
    if (row->is.state == CONTACT_SLIP) {
        double size = vec3_norm(row->is.rubbing);
        row->is.way = vec3_scale(row->is.rubbing, size > 0.0 ? 1.0 / size : 0.0);
        row->is.share = m->share;
        if (!(size > 0.0)) {
            row->is.state = CONTACT_STICK;
        }
    }
}

void vbss_contact_remind(contact_set *set, uint32_t memory, uint32_t row)
{
    remind(&set->rows[row], &set->memory[memory]);
}

void vbss_contact_pass_on(contact_set *set, uint32_t memory)
{
    const contact_memory *m = &set->memory[memory];
    for (uint32_t da = 0; da < 3; da++) {
        contact_key key = m->key; /* one below the first is the largest number, which nobody has */
        key.a += da - 1;
        key.b -= 1;
        for (uint32_t db = 0; db < 3; db++, key.b++) {
            uint32_t i = vbss_contact_find(set, &key);
            if (i != UINT32_MAX && set->rows[i].is.state == CONTACT_OPEN) {
                remind(&set->rows[i], m);
                return;
            }
        }
    }
}

void vbss_contact_recall(contact_set *set)
{
    uint32_t m = 0;
    for (uint32_t i = 0; i < set->count; i++) {
        contact_row *row = &set->rows[i];
        row->is.state = row->bilateral ? CONTACT_STICK : CONTACT_OPEN;
        row->is.pressure = 0.0;
        row->is.rubbing = vec3_zero();
        row->held = row->sleeve ? row->held : vec3_zero();
        for (; m < set->memory_count; m++) {
            int order = vbss_contact_compare(&set->memory[m].key, &row->key);
            if (order > 0) {
                break;
            }
            set->recalled[m] = order == 0;
            if (order == 0) {
                remind(row, &set->memory[m]);
            }
        }
    }
    for (; m < set->memory_count; m++) {
        set->recalled[m] = 0;
    }
}

void vbss_contact_keep(contact_set *set)
{
    set->memory_count = 0;
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_row *row = &set->rows[i];
        if (row->is.state != CONTACT_OPEN) {
            contact_memory *m = &set->memory[set->memory_count++];
            m->key = row->key;
            m->state = (uint32_t)row->is.state;
            m->pressure = row->is.pressure;
            m->share = row->is.share;
            m->rubbing = row->is.rubbing;
        }
    }
}

void vbss_contact_mark(contact_set *set)
{
    memcpy(set->marked, set->memory, set->memory_count * sizeof *set->memory);
    set->marked_count = set->memory_count;
    set->marked_residual = set->residual;
    set->marked_counters = set->counters;
}

void vbss_contact_return(contact_set *set)
{
    memcpy(set->memory, set->marked, set->marked_count * sizeof *set->memory);
    set->memory_count = set->marked_count;
    set->residual = set->marked_residual;
    set->counters = set->marked_counters;
}
