/* The system's life, and what bodies register in it. */
#include "base/error.h"
#include "base/memory.h"
#include "solver/solver.h"

#include <string.h>

/* ---- memory: one table says what there is */

enum { PARTS = 46 };
#define MOST_SEPARATORS 16384u /* who is coupled with whom takes as many bits, squared */

static void list_parts(vbss_system *s, vbss_array parts[PARTS])
{
    size_t blocks = s->block_capacity, entries = s->entry_capacity;
    size_t numbers = entries + s->coupling_capacity + 1, separators = s->separator_capacity;
    size_t pairs = s->pair_capacity, words = (separators + 63) / 64;
    size_t places = 2 * pairs + separators;
    vbss_elimination *e = &s->elimination;
    const vbss_array all[PARTS] = {
        {&s->roles, blocks, sizeof *s->roles},
        {&s->couplings, (size_t)s->coupling_capacity + 1, sizeof *s->couplings},
        {&s->chain_ends, blocks, sizeof *s->chain_ends},
        {&s->chain_of, blocks, sizeof *s->chain_of},
        {&s->chain_ordered, blocks, sizeof *s->chain_ordered},
        {&s->chain_kept, blocks, sizeof *s->chain_kept},
        {&s->fill_ends, 2 * blocks, sizeof *s->fill_ends},
        {&s->known, s->known_capacity, sizeof *s->known},
        {&s->known_places, s->coupling_capacity, sizeof *s->known_places},
        {&s->order, blocks, sizeof *s->order},
        {&s->place, blocks, sizeof *s->place},
        {&s->column_start, blocks + 1, sizeof *s->column_start},
        {&s->entries, entries, sizeof *s->entries},
        {&s->product_start, blocks, sizeof *s->product_start},
        {&s->products, s->product_capacity, sizeof *s->products},
        {&s->joins, pairs, sizeof *s->joins},
        {&s->join_start, separators + 1, sizeof *s->join_start},
        {&s->row_bits, 2 * (blocks / 64 + 1), sizeof *s->row_bits},
        {&s->lists, 9 * blocks, sizeof *s->lists},
        {&s->diagonal, blocks, sizeof *s->diagonal},
        {&s->numbers, numbers, sizeof *s->numbers},
        {&s->scaled, numbers, sizeof *s->scaled},
        {&s->rhs, blocks, sizeof *s->rhs},
        {&s->solution, blocks, sizeof *s->solution},
        {&s->pivots, blocks, sizeof *s->pivots},
        {&s->separator_base, places, sizeof *s->separator_base},
        {&s->separator_blocks, places, sizeof *s->separator_blocks},
        {&s->separator_base_rhs, separators, sizeof *s->separator_base_rhs},
        {&s->separator_rhs, separators, sizeof *s->separator_rhs},
        {&s->followed, separators, sizeof *s->followed},
        {&e->order, separators, sizeof *e->order},
        {&e->position, separators, sizeof *e->position},
        {&e->column_start, separators + 1, sizeof *e->column_start},
        {&e->rows, pairs, sizeof *e->rows},
        {&e->row_start, separators + 1, sizeof *e->row_start},
        {&e->earlier, pairs, sizeof *e->earlier},
        {&e->pair_start, separators + 1, sizeof *e->pair_start},
        {&e->pairs, pairs, sizeof *e->pairs},
        {&e->lower, pairs, sizeof *e->lower},
        {&e->upper, pairs, sizeof *e->upper},
        {&e->x, separators, sizeof *e->x},
        {&e->near, separators * words, sizeof *e->near},
        {&e->degrees, separators, sizeof *e->degrees},
        {&e->keys, separators, sizeof *e->keys},
        {&e->next, separators, sizeof *e->next},
        {&e->entry_in, separators, sizeof *e->entry_in},
    };
    memcpy(parts, all, sizeof all);
}

/* Half of it stays free. */
static uint32_t room_for_known(uint32_t couplings)
{
    uint32_t room = 2;
    while (room / 2 <= couplings && room <= UINT32_MAX / 2) {
        room *= 2;
    }
    return room;
}

vbss_result vbss_system_create_room(vbss_context *context, const vbss_system_room *room,
                                    vbss_system **system)
{
    *system = NULL;
    vbss_system *s = vbss_allocate(context, 1, sizeof *s, "system");
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->context = context;
    s->wide = vbss_wide_is_available();
    s->block_capacity = room->blocks;
    s->separator_capacity = room->separators < MOST_SEPARATORS ? room->separators : MOST_SEPARATORS;
    s->pair_capacity = room->pairs;
    s->coupling_capacity = room->couplings + room->pairs;
    s->entry_capacity = room->entries + room->pairs;
    s->known_capacity = room_for_known(s->coupling_capacity);
    s->product_capacity = room->products;
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

vbss_system_room vbss_system_room_of_lines(uint32_t blocks, uint32_t reach, uint32_t separators,
                                           uint32_t pairs)
{
    uint32_t rows = 2 * reach; /* of a run's column: neighbours ahead, separators behind */
    return (vbss_system_room){
        blocks, blocks * reach, blocks * rows, blocks * (rows * (rows - 1) / 2), separators, pairs};
}

vbss_result vbss_system_create(vbss_context *context, uint32_t blocks, uint32_t reach,
                               uint32_t separators, uint32_t pairs, vbss_system **system)
{
    const vbss_system_room room = vbss_system_room_of_lines(blocks, reach, separators, pairs);
    return vbss_system_create_room(context, &room, system);
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

static uint32_t first_place(const vbss_system *s, uint32_t high, uint32_t low)
{
    uint64_t mixed = (((uint64_t)high << 32) + low) * UINT64_C(0x9e3779b97f4a7c15);
    return (uint32_t)(mixed >> 32) & (s->known_capacity - 1);
}

/* The last to come is the first to go, so that no place on the way to another becomes empty: couplings after `last`. */
static void forget(vbss_system *s, uint32_t last)
{
    while (s->known_count > 0 && s->known[s->known_places[s->known_count - 1]] > last) {
        s->known[s->known_places[--s->known_count]] = VBSS_NO_COUPLING;
    }
    s->known_to = s->known_to < last ? s->known_to : last;
}

void vbss_system_begin(vbss_system *system)
{
    forget(system, VBSS_NO_COUPLING);
    system->block_count = system->coupling_count = system->own_count = system->chain_count = 0;
    system->bodies_known = false;
    memset(&system->couplings[VBSS_NO_COUPLING], 0, sizeof *system->couplings);
}

vbss_result vbss_system_add_chain(vbss_system *system, uint32_t count, uint32_t *first)
{
    if (count == 0 || count > system->block_capacity - system->block_count) {
        return vbss_fail(system->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks",
                         system->block_capacity);
    }
    *first = system->block_count;
    system->bodies_known = false;
    memset(system->roles + system->block_count, VBSS_ROLE_RUN, count);
    for (uint32_t b = *first; b < *first + count; b++) {
        system->chain_of[b] = system->chain_count;
    }
    system->block_count += count;
    system->chain_ordered[system->chain_count] = false;
    system->chain_kept[system->chain_count] = false;
    system->chain_ends[system->chain_count++] = system->block_count;
    return VBSS_OK;
}

void vbss_system_keep_order(vbss_system *system)
{
    system->bodies_known = false;
    system->chain_ordered[system->chain_count - 1] = true;
}

void vbss_system_set_role(vbss_system *system, uint32_t b, vbss_role role)
{
    system->bodies_known = false;
    system->roles[b] = (uint8_t)role;
}

static bool is_given(const vbss_system *system, uint32_t a, uint32_t b)
{
    return system->roles[a] == VBSS_ROLE_GIVEN || system->roles[b] == VBSS_ROLE_GIVEN;
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
    if (is_given(system, a, b)) {
        return VBSS_OK;
    }
    if (system->chain_of[a] != system->chain_of[b] && !are_separators(system, a, b)) {
        return vbss_fail(system->context, VBSS_ERROR_OUT_OF_RANGE,
                         "system: blocks %u and %u are of two chains, and not both separators", a,
                         b);
    }
    if (system->own_count != system->coupling_count) {
        return vbss_fail(system->context, VBSS_ERROR_OUT_OF_RANGE,
                         "system: bodies couple blocks %u and %u after others coupled", a, b);
    }
    VBSS_TRY(add_coupling(system, a, b));
    system->bodies_known = false;
    *coupling = system->own_count = system->coupling_count;
    return VBSS_OK;
}

/* ---- couplings by hash: open addressing, which only ever tells whether a pair is there */

/* Where the coupling of two blocks stands, or could. */
static uint32_t *known_place(vbss_system *s, uint32_t high, uint32_t low)
{
    for (uint32_t at = first_place(s, high, low);; at = (at + 1) & (s->known_capacity - 1)) {
        const vbss_coupling *c = &s->couplings[s->known[at]];
        if (s->known[at] == VBSS_NO_COUPLING || (c->high == high && c->low == low)) {
            return &s->known[at];
        }
    }
}

static void know(vbss_system *s, uint32_t coupling, uint32_t *place)
{
    *place = coupling;
    s->known_places[s->known_count++] = (uint32_t)(place - s->known);
}

/* Only who asks pays; and nobody asks for a coupling of a run. */
static void know_all(vbss_system *s)
{
    while (s->known_to < s->coupling_count) {
        const vbss_coupling *c = &s->couplings[++s->known_to];
        if (are_separators(s, c->high, c->low)) {
            know(s, s->known_to, known_place(s, c->high, c->low));
        }
    }
}

vbss_result vbss_system_couple_once(vbss_system *system, uint32_t a, uint32_t b)
{
    if (is_given(system, a, b)) {
        return VBSS_OK;
    }
    if (!are_separators(system, a, b)) {
        return vbss_fail(system->context, VBSS_ERROR_OUT_OF_RANGE,
                         "system: blocks %u and %u are not both separators", a, b);
    }
    know_all(system);
    uint32_t *known = known_place(system, a > b ? a : b, a > b ? b : a);
    if (*known == VBSS_NO_COUPLING) {
        VBSS_TRY(add_coupling(system, a, b));
        system->known_to = system->coupling_count;
        know(system, system->coupling_count, known);
    }
    return VBSS_OK;
}

void vbss_system_begin_again(vbss_system *system)
{
    forget(system, system->own_count);
    system->coupling_count = system->own_count;
}

/* ---- the numbers */

void vbss_system_keep_matrix(vbss_system *system, uint32_t b, bool kept)
{
    system->chain_kept[system->chain_of[b]] = kept;
}

void vbss_system_clear(vbss_system *system)
{
    /* Fill stands behind the couplings of bodies. */
    block *fill = system->numbers + system->own_count + 1;
    for (uint32_t i = 0, begin = 0, end; i < 2 * system->chain_count; i++, begin = end) {
        end = system->fill_ends[i];
        if (!system->chain_kept[i % system->chain_count]) {
            memset(fill + begin, 0, (end - begin) * sizeof *fill);
        }
    }
}
