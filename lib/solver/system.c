/* Creation of the system and registration of its pattern. */
#include "base/error.h"
#include "base/memory.h"
#include "solver/solver.h"

#include <string.h>

/* ---- memory: one table lists all arrays */

enum { PARTS = 41 };
#define MAX_SEPARATORS 16384u /* the adjacency matrix takes the square of this in bits */

static void list_arrays(vbss_system *s, vbss_array arrays[PARTS])
{
    size_t blocks = s->block_capacity, entries = s->entry_capacity;
    size_t separators = s->separator_capacity, words = (separators + 63) / 64;
    size_t pairs = s->pair_capacity, factor = s->factor_capacity;
    vbss_elimination *e = &s->elimination;
    const vbss_array all[PARTS] = {
        {&s->roles, blocks, sizeof *s->roles},
        {&s->couplings, (size_t)s->coupling_capacity + 1, sizeof *s->couplings},
        {&s->chain_ends, blocks, sizeof *s->chain_ends},
        {&s->chain_of, blocks, sizeof *s->chain_of},
        {&s->chain_uses_natural_order, blocks, sizeof *s->chain_uses_natural_order},
        {&s->chain_reuses_factor, blocks, sizeof *s->chain_reuses_factor},
        {&s->fill_ends, 2 * blocks, sizeof *s->fill_ends},
        {&s->coupling_hash, s->coupling_hash_capacity, sizeof *s->coupling_hash},
        {&s->coupling_hash_buckets, s->coupling_capacity, sizeof *s->coupling_hash_buckets},
        {&s->order, blocks, sizeof *s->order},
        {&s->position, blocks, sizeof *s->position},
        {&s->column_start, blocks + 1, sizeof *s->column_start},
        {&s->entries, entries, sizeof *s->entries},
        {&s->product_start, blocks, sizeof *s->product_start},
        {&s->products, s->product_capacity, sizeof *s->products},
        {&s->schur_pattern, pairs, sizeof *s->schur_pattern},
        {&s->schur_column_start, separators + 1, sizeof *s->schur_column_start},
        {&s->row_bits, 2 * (blocks / 64 + 1), sizeof *s->row_bits},
        {&s->symbolic_scratch, 9 * blocks, sizeof *s->symbolic_scratch},
        {&s->diagonal, blocks, sizeof *s->diagonal},
        {&s->arena, s->arena_capacity, sizeof *s->arena},
        {&s->rhs, blocks, sizeof *s->rhs},
        {&s->solution, blocks, sizeof *s->solution},
        {&s->pivots, blocks, sizeof *s->pivots},
        {&s->schur_rhs, separators, sizeof *s->schur_rhs},
        {&s->separator_rhs, separators, sizeof *s->separator_rhs},
        {&s->line_search_increments, separators, sizeof *s->line_search_increments},
        {&e->order, separators, sizeof *e->order},
        {&e->position, separators, sizeof *e->position},
        {&e->column_start, separators + 1, sizeof *e->column_start},
        {&e->rows, factor, sizeof *e->rows},
        {&e->row_start, separators + 1, sizeof *e->row_start},
        {&e->row_entries, factor, sizeof *e->row_entries},
        {&e->pair_start, separators + 1, sizeof *e->pair_start},
        {&e->pairs, pairs, sizeof *e->pairs},
        {&e->x, separators, sizeof *e->x},
        {&e->adjacency, separators * words, sizeof *e->adjacency},
        {&e->degrees, separators, sizeof *e->degrees},
        {&e->keys, separators, sizeof *e->keys},
        {&e->bucket_next, separators, sizeof *e->bucket_next},
        {&e->entry_of_row, separators, sizeof *e->entry_of_row},
    };
    memcpy(arrays, all, sizeof all);
}

/* Smallest power of two of which at most half is used. */
static uint32_t hash_capacity(uint32_t couplings)
{
    uint32_t capacity = 2;
    while (capacity / 2 <= couplings && capacity <= UINT32_MAX / 2) {
        capacity *= 2;
    }
    return capacity;
}

vbss_result vbss_system_create_with_capacity(vbss_context *context,
                                             const vbss_system_capacity *capacity,
                                             vbss_system **system)
{
    *system = NULL;
    vbss_system *s = vbss_allocate(context, 1, sizeof *s, "system");
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->context = context;
    s->wide = vbss_wide_is_available();
    s->block_capacity = capacity->blocks;
    s->separator_capacity =
        capacity->separators < MAX_SEPARATORS ? capacity->separators : MAX_SEPARATORS;
    s->pair_capacity = capacity->pairs;
    s->factor_capacity = capacity->factor;
    s->coupling_capacity = capacity->couplings + capacity->pairs;
    s->entry_capacity = capacity->entries + capacity->pairs;
    s->coupling_hash_capacity = hash_capacity(s->coupling_capacity);
    s->product_capacity = capacity->products;
    s->arena_capacity = capacity->arena;
    vbss_array arrays[PARTS];
    list_arrays(s, arrays);
    vbss_result result = vbss_allocate_arrays(context, arrays, PARTS, "system");
    if (result != VBSS_OK) {
        vbss_system_destroy(context, s);
        return result;
    }
    *system = s;
    return VBSS_OK;
}

vbss_system_capacity vbss_system_capacity_of_chains(uint32_t blocks, uint32_t half_bandwidth,
                                                    uint32_t separators, uint32_t pairs)
{
    /* rows of an interior column: neighbours ahead, separators behind */
    uint32_t rows = 2 * half_bandwidth, entries = blocks * rows;
    /* Couplings and fill are entries or pairs. Entries may take the place of pairs. */
    return (vbss_system_capacity){.blocks = blocks,
                                  .couplings = blocks * half_bandwidth,
                                  .entries = entries,
                                  .products = blocks * (rows * (rows - 1) / 2),
                                  .separators = separators,
                                  .pairs = pairs,
                                  .factor = pairs,
                                  .arena = 1 + 2 * entries + 6 * pairs + 2 * separators};
}

vbss_result vbss_system_create(vbss_context *context, uint32_t blocks, uint32_t half_bandwidth,
                               uint32_t separators, uint32_t pairs, vbss_system **system)
{
    const vbss_system_capacity capacity =
        vbss_system_capacity_of_chains(blocks, half_bandwidth, separators, pairs);
    return vbss_system_create_with_capacity(context, &capacity, system);
}

void vbss_system_destroy(vbss_context *context, vbss_system *system)
{
    if (system == NULL) {
        return;
    }
    vbss_array arrays[PARTS];
    list_arrays(system, arrays);
    vbss_release_arrays(context, arrays, PARTS);
    vbss_release(context, system, 1, sizeof *system);
}

/* ---- the pattern */

static uint32_t first_bucket(const vbss_system *s, uint32_t high, uint32_t low)
{
    uint64_t mixed = (((uint64_t)high << 32) + low) * UINT64_C(0x9e3779b97f4a7c15);
    return (uint32_t)(mixed >> 32) & (s->coupling_hash_capacity - 1);
}

/* Removes couplings after `last` from the hash table, newest first, so that no bucket on the probe
 * path of another coupling becomes free. */
static void remove_couplings_after(vbss_system *s, uint32_t last)
{
    while (s->coupling_hash_count > 0 &&
           s->coupling_hash[s->coupling_hash_buckets[s->coupling_hash_count - 1]] > last) {
        s->coupling_hash[s->coupling_hash_buckets[--s->coupling_hash_count]] = VBSS_NO_COUPLING;
    }
    s->hashed_coupling_end = s->hashed_coupling_end < last ? s->hashed_coupling_end : last;
}

void vbss_system_begin_pattern(vbss_system *system)
{
    remove_couplings_after(system, VBSS_NO_COUPLING);
    system->block_count = system->coupling_count = system->body_coupling_count =
        system->chain_count = 0;
    system->has_body_pattern = false;
    memset(&system->couplings[VBSS_NO_COUPLING], 0, sizeof *system->couplings);
}

vbss_result vbss_system_add_chain(vbss_system *system, uint32_t count, uint32_t *first)
{
    if (count == 0 || count > system->block_capacity - system->block_count) {
        return vbss_fail(system->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks",
                         system->block_capacity);
    }
    *first = system->block_count;
    system->has_body_pattern = false;
    memset(system->roles + system->block_count, VBSS_ROLE_INTERIOR, count);
    for (uint32_t b = *first; b < *first + count; b++) {
        system->chain_of[b] = system->chain_count;
    }
    system->block_count += count;
    system->chain_uses_natural_order[system->chain_count] = false;
    system->chain_reuses_factor[system->chain_count] = false;
    system->chain_ends[system->chain_count++] = system->block_count;
    return VBSS_OK;
}

void vbss_system_use_natural_order(vbss_system *system)
{
    system->has_body_pattern = false;
    system->chain_uses_natural_order[system->chain_count - 1] = true;
}

void vbss_system_set_role(vbss_system *system, uint32_t b, vbss_role role)
{
    system->has_body_pattern = false;
    system->roles[b] = (uint8_t)role;
}

static bool either_is_prescribed(const vbss_system *system, uint32_t a, uint32_t b)
{
    return system->roles[a] == VBSS_ROLE_PRESCRIBED || system->roles[b] == VBSS_ROLE_PRESCRIBED;
}

static bool are_separators(const vbss_system *system, uint32_t a, uint32_t b)
{
    return system->roles[a] == VBSS_ROLE_SEPARATOR && system->roles[b] == VBSS_ROLE_SEPARATOR;
}

static vbss_result add_coupling(vbss_system *system, uint32_t a, uint32_t b)
{
    if (system->coupling_count == system->coupling_capacity) {
        return vbss_fail(system->context, VBSS_ERROR_CAPACITY, "system: more than %u couplings",
                         system->coupling_capacity);
    }
    vbss_coupling *c = &system->couplings[++system->coupling_count];
    c->high = a > b ? a : b;
    c->low = a > b ? b : a;
    return VBSS_OK;
}

vbss_result vbss_system_couple(vbss_system *system, uint32_t a, uint32_t b, uint32_t *coupling)
{
    *coupling = VBSS_NO_COUPLING;
    if (either_is_prescribed(system, a, b)) {
        return VBSS_OK;
    }
    if (system->chain_of[a] != system->chain_of[b] && !are_separators(system, a, b)) {
        return vbss_fail(system->context, VBSS_ERROR_INCOMPATIBLE,
                         "system: blocks %u and %u are of two chains, and not both separators", a,
                         b);
    }
    if (system->body_coupling_count != system->coupling_count) {
        return vbss_fail(system->context, VBSS_ERROR_WRONG_STATE,
                         "system: bodies couple blocks %u and %u after others coupled", a, b);
    }
    VBSS_TRY(add_coupling(system, a, b));
    system->has_body_pattern = false;
    *coupling = system->body_coupling_count = system->coupling_count;
    return VBSS_OK;
}

/* ---- couplings by hash: open addressing, used only to find whether a pair is present */

/* Bucket of the coupling of two blocks, or the free bucket for it. */
static uint32_t *find_bucket(vbss_system *s, uint32_t high, uint32_t low)
{
    for (uint32_t bucket = first_bucket(s, high, low);;
         bucket = (bucket + 1) & (s->coupling_hash_capacity - 1)) {
        const vbss_coupling *c = &s->couplings[s->coupling_hash[bucket]];
        if (s->coupling_hash[bucket] == VBSS_NO_COUPLING || (c->high == high && c->low == low)) {
            return &s->coupling_hash[bucket];
        }
    }
}

static void insert_coupling(vbss_system *s, uint32_t coupling, uint32_t *bucket)
{
    *bucket = coupling;
    s->coupling_hash_buckets[s->coupling_hash_count++] = (uint32_t)(bucket - s->coupling_hash);
}

/* Hashing is deferred to the first query. Couplings of interior blocks are never queried. */
static void hash_new_couplings(vbss_system *s)
{
    while (s->hashed_coupling_end < s->coupling_count) {
        const vbss_coupling *c = &s->couplings[++s->hashed_coupling_end];
        if (are_separators(s, c->high, c->low)) {
            insert_coupling(s, s->hashed_coupling_end, find_bucket(s, c->high, c->low));
        }
    }
}

vbss_result vbss_system_couple_separators(vbss_system *system, uint32_t a, uint32_t b)
{
    if (either_is_prescribed(system, a, b)) {
        return VBSS_OK;
    }
    if (!are_separators(system, a, b)) {
        return vbss_fail(system->context, VBSS_ERROR_INCOMPATIBLE,
                         "system: blocks %u and %u are not both separators", a, b);
    }
    hash_new_couplings(system);
    uint32_t *bucket = find_bucket(system, a > b ? a : b, a > b ? b : a);
    if (*bucket == VBSS_NO_COUPLING) {
        VBSS_TRY(add_coupling(system, a, b));
        system->hashed_coupling_end = system->coupling_count;
        insert_coupling(system, system->coupling_count, bucket);
    }
    return VBSS_OK;
}

void vbss_system_reset_separator_couplings(vbss_system *system)
{
    remove_couplings_after(system, system->body_coupling_count);
    system->coupling_count = system->body_coupling_count;
}

/* ---- the numbers */

void vbss_system_reuse_factor(vbss_system *system, uint32_t b, bool reuse)
{
    system->chain_reuses_factor[system->chain_of[b]] = reuse;
}

void vbss_system_clear(vbss_system *system)
{
    /* The fill follows the couplings of bodies. */
    block *fill = system->off_diagonal + system->body_coupling_count + 1;
    for (uint32_t i = 0, begin = 0, end; i < 2 * system->chain_count; i++, begin = end) {
        end = system->fill_ends[i];
        if (!system->chain_reuses_factor[i % system->chain_count]) {
            memset(fill + begin, 0, (end - begin) * sizeof *fill);
        }
    }
}
