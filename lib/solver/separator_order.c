/* The order in which separators are eliminated, and what it fills in: symbolic work, done anew when the
 * pattern changes.
 *
 * Minimum degree: next is always the separator that is coupled with the fewest others, by what was filled
 * in so far; of equals the one with the lowest block. The graph is kept as rows of bits, so that
 * eliminating is a few words or'ed together. */
#include "solver/solver.h"

#include <string.h>

/* ---- bits */

enum { BITS = 64 };

static uint32_t count_bits(uint64_t x)
{
    x -= x >> 1 & UINT64_C(0x5555555555555555);
    x = (x & UINT64_C(0x3333333333333333)) + (x >> 2 & UINT64_C(0x3333333333333333));
    x = (x + (x >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return (uint32_t)(x * UINT64_C(0x0101010101010101) >> 56);
}

static inline uint32_t lowest_bit(uint64_t x)
{
#if defined(__GNUC__)
    return (uint32_t)__builtin_ctzll(x);
#else
    return count_bits((x & (0 - x)) - 1);
#endif
}

static inline uint64_t bit_of(uint32_t i)
{
    return UINT64_C(1) << i % BITS;
}

/* ---- the graph */

typedef struct graph {
    uint32_t count, words; /* separators, words a row */
    uint64_t *near;
} graph;

static uint64_t *row_of(const graph *g, uint32_t i)
{
    return g->near + (size_t)i * g->words;
}

/* A key is a degree, then a separator: the least is who is next. */
#define KEY_DEGREE 16
#define KEY_NUMBER 0xffffu
#define KEY_GONE UINT32_MAX

static uint32_t key_of(const graph *g, uint32_t i)
{
    const uint64_t *row = row_of(g, i);
    uint32_t degree = 0;
    for (uint32_t w = 0; w < g->words; w++) {
        degree += count_bits(row[w]);
    }
    return degree << KEY_DEGREE | i;
}

static graph begin_graph(vbss_system *s)
{
    uint32_t n = s->active_count - s->run_count;
    graph g = {n, (n + BITS - 1) / BITS, s->elimination.near};
    memset(g.near, 0, (size_t)n * g.words * sizeof *g.near);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t k = s->run_count + i;
        for (uint32_t e = s->column_start[k]; e < s->column_start[k + 1]; e++) {
            uint32_t j = s->entries[e].row - s->run_count;
            row_of(&g, i)[j / BITS] |= bit_of(j);
            row_of(&g, j)[i / BITS] |= bit_of(i);
        }
    }
    for (uint32_t i = 0; i < n; i++) {
        s->elimination.keys[i] = key_of(&g, i);
    }
    return g;
}

/* ---- elimination */

static uint32_t least_key(const uint32_t *keys, uint32_t count)
{
    uint32_t least = keys[0];
    for (uint32_t i = 1; i < count; i++) {
        least = keys[i] < least ? keys[i] : least;
    }
    return least;
}

/* Those that a separator is coupled with, to rows; how many. */
static uint32_t list_neighbours(const graph *g, uint32_t i, uint32_t *rows)
{
    uint32_t count = 0;
    for (uint32_t w = 0; w < g->words; w++) {
        for (uint64_t bits = row_of(g, i)[w]; bits != 0; bits &= bits - 1) {
            rows[count++] = w * BITS + lowest_bit(bits);
        }
    }
    return count;
}

/* Its neighbours become neighbours of each other. */
static void join_neighbours(const graph *g, uint32_t gone, const uint32_t *rows, uint32_t count,
                            uint32_t *keys)
{
    const uint64_t *from = row_of(g, gone);
    for (uint32_t r = 0; r < count; r++) {
        uint64_t *to = row_of(g, rows[r]);
        for (uint32_t w = 0; w < g->words; w++) {
            to[w] |= from[w];
        }
        to[rows[r] / BITS] &= ~bit_of(rows[r]);
        to[gone / BITS] &= ~bit_of(gone);
        keys[rows[r]] = key_of(g, rows[r]);
    }
}

static vbss_result order_by_degree(vbss_system *s, const graph *g)
{
    vbss_elimination *e = &s->elimination;
    uint32_t entries = 0;
    for (uint32_t k = 0; k < g->count; k++) {
        uint32_t key = least_key(e->keys, g->count);
        uint32_t i = key & KEY_NUMBER, degree = key >> KEY_DEGREE;
        if (degree > s->pair_capacity - entries) {
            return vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                             "system: more than %u separator pairs", s->pair_capacity);
        }
        e->order[k] = i;
        e->position[i] = k;
        e->keys[i] = KEY_GONE;
        e->column_start[k] = entries;
        uint32_t *rows = e->rows + entries;
        list_neighbours(g, i, rows);
        join_neighbours(g, i, rows, degree, e->keys);
        entries += degree;
    }
    e->column_start[g->count] = entries;
    return VBSS_OK;
}

/* ---- the factor by columns and by rows, both ascending: sorted by two passes through buckets */

/* Turns counts in start[1 ..] into where each begins. */
static void add_up(uint32_t *start, uint32_t count)
{
    start[0] = 0;
    for (uint32_t k = 0; k < count; k++) {
        start[k + 1] += start[k];
    }
}

static void sort_entries(vbss_elimination *e, uint32_t count)
{
    uint32_t *next = e->keys;
    memset(e->row_start, 0, ((size_t)count + 1) * sizeof *e->row_start);
    for (uint32_t f = 0; f < e->column_start[count]; f++) {
        e->rows[f] = e->position[e->rows[f]];
        e->row_start[e->rows[f] + 1]++;
    }
    add_up(e->row_start, count);
    memcpy(next, e->row_start, count * sizeof *next);
    for (uint32_t k = 0; k < count; k++) {
        for (uint32_t f = e->column_start[k]; f < e->column_start[k + 1]; f++) {
            e->earlier[next[e->rows[f]]++].column = k;
        }
    }
    memcpy(next, e->column_start, count * sizeof *next);
    for (uint32_t row = 0; row < count; row++) {
        for (uint32_t r = e->row_start[row]; r < e->row_start[row + 1]; r++) {
            uint32_t f = next[e->earlier[r].column]++;
            e->rows[f] = row;
            e->earlier[r].entry = f;
        }
    }
}

/* The pattern's pairs by columns of the elimination. */
static void sort_pairs(const vbss_system *s, vbss_elimination *e, uint32_t count)
{
    uint32_t *next = e->keys;
    memset(e->pair_start, 0, ((size_t)count + 1) * sizeof *e->pair_start);
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t low = 0; low < count; low++) {
            uint32_t k = s->run_count + low, a = e->position[low];
            for (uint32_t f = s->column_start[k]; f < s->column_start[k + 1]; f++) {
                uint32_t b = e->position[s->entries[f].row - s->run_count];
                uint32_t place = 2 * (f - s->separator_first_entry) + (b < a);
                if (pass == 0) {
                    e->pair_start[(b < a ? b : a) + 1]++;
                } else {
                    e->pairs[next[b < a ? b : a]++] = (vbss_pair){b < a ? a : b, place};
                }
            }
        }
        if (pass == 0) {
            add_up(e->pair_start, count);
            memcpy(next, e->pair_start, count * sizeof *next);
        }
    }
}

vbss_result vbss_system_order_separators(vbss_system *s)
{
    if (s->pair_count > s->pair_capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separator pairs",
                         s->pair_capacity);
    }
    graph g = begin_graph(s);
    VBSS_TRY(order_by_degree(s, &g));
    sort_entries(&s->elimination, g.count);
    sort_pairs(s, &s->elimination, g.count);
    return VBSS_OK;
}
