/* The system's life, and what bodies register in it. */
#include "solver/solver.h"

#include <string.h>

/* ---- memory: one table says what there is */

enum { PARTS = 21 };

static void list_parts(vbss_system *s, vbss_array parts[PARTS])
{
    size_t blocks = s->block_capacity, entries = s->entry_capacity;
    size_t numbers = entries + s->coupling_capacity + 1, separators = s->separator_capacity;
    size_t pairs = s->pair_capacity;
    const vbss_array all[PARTS] = {
        {&s->roles, blocks, sizeof *s->roles},
        {&s->couplings, (size_t)s->coupling_capacity + 1, sizeof *s->couplings},
        {&s->chain_ends, blocks, sizeof *s->chain_ends},
        {&s->order, blocks, sizeof *s->order},
        {&s->place, blocks, sizeof *s->place},
        {&s->column_start, blocks + 1, sizeof *s->column_start},
        {&s->entries, entries, sizeof *s->entries},
        {&s->product_start, blocks, sizeof *s->product_start},
        {&s->products, s->product_capacity, sizeof *s->products},
        {&s->marks, blocks, sizeof *s->marks},
        {&s->lists, 3 * blocks, sizeof *s->lists},
        {&s->diagonal, blocks, sizeof *s->diagonal},
        {&s->numbers, numbers, sizeof *s->numbers},
        {&s->scaled, numbers, sizeof *s->scaled},
        {&s->rhs, blocks, sizeof *s->rhs},
        {&s->solution, blocks, sizeof *s->solution},
        {&s->pivots, blocks, sizeof *s->pivots},
        {&s->separator_diagonal, separators, sizeof *s->separator_diagonal},
        {&s->separator_lower, pairs, sizeof *s->separator_lower},
        {&s->separator_upper, pairs, sizeof *s->separator_upper},
        {&s->separator_rhs, separators, sizeof *s->separator_rhs},
    };
    memcpy(parts, all, sizeof all);
}

vbss_result vbss_system_create(vbss_context *context, uint32_t blocks, uint32_t reach,
                               uint32_t separators, uint32_t pairs, vbss_system **system)
{
    *system = NULL;
    vbss_system *s = vbss_allocate(context, 1, sizeof *s, "system");
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    uint32_t rows = 2 * reach; /* of a run's column: neighbours ahead, separators behind */
    s->context = context;
    s->wide = vbss_wide_is_there();
    s->block_capacity = blocks;
    s->separator_capacity = separators;
    s->pair_capacity = pairs;
    s->coupling_capacity = blocks * reach + pairs;
    s->entry_capacity = blocks * rows + pairs;
    s->product_capacity = blocks * (rows * (rows - 1) / 2);
    vbss_array parts[PARTS];
    list_parts(s, parts);
    vbss_result result = vbss_allocate_arrays(context, parts, PARTS, "system");
    if (result != VBSS_OK) {
        vbss_system_destroy(context, s);
        return result;
    }
    *system = s;
    return VBSS_OK;
}

void vbss_system_destroy(vbss_context *context, vbss_system *system)
{
    if (system == NULL) {
        return;
    }
    vbss_array parts[PARTS];
    list_parts(system, parts);
    vbss_release_arrays(context, parts, PARTS);
    vbss_release(context, system, 1, sizeof *system);
}

/* ---- the pattern */

void vbss_system_begin(vbss_system *system)
{
    system->block_count = system->coupling_count = system->chain_count = 0;
    memset(&system->couplings[VBSS_NO_COUPLING], 0, sizeof *system->couplings);
}

vbss_result vbss_system_add_chain(vbss_system *system, uint32_t count, uint32_t *first)
{
    if (count == 0 || count > system->block_capacity - system->block_count) {
        return vbss_fail(system->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks",
                         system->block_capacity);
    }
    *first = system->block_count;
    memset(system->roles + system->block_count, VBSS_ROLE_RUN, count);
    system->block_count += count;
    system->chain_ends[system->chain_count++] = system->block_count;
    return VBSS_OK;
}

void vbss_system_set_role(vbss_system *system, uint32_t b, vbss_role role)
{
    system->roles[b] = (uint8_t)role;
}

vbss_result vbss_system_couple(vbss_system *system, uint32_t a, uint32_t b, uint32_t *coupling)
{
    *coupling = VBSS_NO_COUPLING;
    if (system->roles[a] == VBSS_ROLE_GIVEN || system->roles[b] == VBSS_ROLE_GIVEN) {
        return VBSS_OK;
    }
    if (system->coupling_count == system->coupling_capacity) {
        return vbss_fail(system->context, VBSS_ERROR_CAPACITY, "system: more than %u couplings",
                         system->coupling_capacity);
    }
    *coupling = ++system->coupling_count;
    vbss_coupling *c = &system->couplings[*coupling];
    c->high = a > b ? a : b;
    c->low = a > b ? b : a;
    return VBSS_OK;
}

void vbss_system_clear(vbss_system *system)
{
    /* Fill stands behind the couplings. */
    block *fill = system->numbers + system->coupling_count + 1;
    memset(fill, 0, system->fill_count * sizeof *fill);
}
