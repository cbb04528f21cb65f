/* Elimination order and fill of the separators: symbolic work, repeated when the pattern changes.
 *
 * The next separator is the one whose elimination joins the fewest pairs of neighbours,
 * approximately. Its d neighbours form d (d - 1) ordered pairs. The last elimination next to it
 * already joined l of these neighbours; a quarter of their l (l - 1) pairs is subtracted. The
 * lowest block number breaks ties. The graph is stored as rows of bits, so an elimination is a few
 * OR operations on words. */
#include "base/bits.h"
#include "base/error.h"
#include "solver/solver.h"

#include <string.h>

/* ---- the graph */

typedef struct graph {
    uint32_t count, words; /* number of separators, and words per row */
    uint64_t *adjacency;
} graph;

static uint64_t *row_of(const graph *g, uint32_t i)
{
    return g->adjacency + (size_t)i * g->words;
}

/* Pairs that a separator would join, followed by its number: the smallest key is eliminated
 * next. */
#define KEY_INDEX_BITS 16
#define KEY_ELIMINATED INT64_MAX

static int64_t key_of(vbss_degree degree, uint32_t i)
{
    int64_t d = degree.neighbours, l = degree.joined;
    return (4 * d * (d - 1) - l * (l - 1)) << KEY_INDEX_BITS | i;
}

static uint32_t degree_of(const uint64_t *row, uint32_t words)
{
    uint32_t degree = 0;
    for (uint32_t w = 0; w < words; w++) {
        degree += count_bits(row[w]);
    }
    return degree;
}

static inline void join(const graph *g, uint32_t i, uint32_t j)
{
    row_of(g, i)[j / BITS_PER_WORD] |= bit_of(j);
    row_of(g, j)[i / BITS_PER_WORD] |= bit_of(i);
}

static graph begin_graph(vbss_system *s)
{
    vbss_elimination *e = &s->elimination;
    uint32_t n = s->unknown_count - s->interior_count;
    graph g = {n, (n + BITS_PER_WORD - 1) / BITS_PER_WORD, e->adjacency};
    memset(g.adjacency, 0, (size_t)n * g.words * sizeof *g.adjacency);
    for (uint32_t i = 0; i < n; i++) {
        for (uint32_t f = s->schur_column_start[i]; f < s->schur_column_start[i + 1]; f++) {
            join(&g, i, s->schur_pattern[f].row);
        }
    }
    for (uint32_t c = s->body_coupling_count + 1; c <= s->coupling_count; c++) {
        const vbss_coupling *coupling = &s->couplings[c];
        join(&g, s->position[coupling->high] - s->interior_count,
             s->position[coupling->low] - s->interior_count);
    }
    for (uint32_t i = 0; i < n; i++) {
        e->degrees[i] = (vbss_degree){degree_of(row_of(&g, i), g.words), 0};
        e->keys[i] = key_of(e->degrees[i], i);
    }
    return g;
}

/* ---- pairs of the graph, with the indices of those that condensation joined */

static uint32_t count_pairs(const vbss_elimination *e, uint32_t separators)
{
    uint64_t twice = 0;
    for (uint32_t i = 0; i < separators; i++) {
        twice += e->degrees[i].neighbours;
    }
    return (uint32_t)(twice / 2); /* at most half of 16384 squared */
}

static vbss_entry *list_column(const vbss_system *s, const graph *g, uint32_t i, vbss_entry *entry)
{
    const vbss_entry *joined = s->schur_pattern + s->schur_column_start[i],
                     *end = s->schur_pattern + s->schur_column_start[i + 1];
    /* bits after the diagonal, which has no bit */
    uint64_t later = ~UINT64_C(0) << i % BITS_PER_WORD;
    for (uint32_t w = i / BITS_PER_WORD; w < g->words; w++, later = ~UINT64_C(0)) {
        for (uint64_t bits = row_of(g, i)[w] & later; bits != 0; bits &= bits - 1) {
            uint32_t j = w * BITS_PER_WORD + lowest_bit(bits);
            bool was_joined = joined < end && joined->row == j;
            *entry++ =
                (vbss_entry){s->interior_count + j, was_joined ? joined->index : VBSS_NO_COUPLING};
            joined += was_joined;
        }
    }
    return entry;
}

static vbss_result list_pairs(vbss_system *s, const graph *g)
{
    s->pair_count = count_pairs(&s->elimination, g->count);
    if (s->pair_count > s->pair_capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separator pairs",
                         s->pair_capacity);
    }
    if (s->pair_count > s->entry_capacity - s->separator_first_entry) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks of factor",
                         s->entry_capacity);
    }
    vbss_entry *entry = s->entries + s->separator_first_entry;
    for (uint32_t i = 0; i < g->count; i++) {
        entry = list_column(s, g, i, entry);
        s->column_start[s->interior_count + i + 1] = (uint32_t)(entry - s->entries);
    }
    s->entry_count = s->separator_first_entry + s->pair_count;
    return VBSS_OK;
}

/* ---- elimination */

static int64_t min_key(const int64_t *keys, uint32_t count)
{
    int64_t smallest = keys[0];
    for (uint32_t i = 1; i < count; i++) {
        smallest = keys[i] < smallest ? keys[i] : smallest;
    }
    return smallest;
}

static void list_neighbours(const graph *g, uint32_t i, uint32_t *rows)
{
    for (uint32_t w = 0; w < g->words; w++) {
        for (uint64_t bits = row_of(g, i)[w]; bits != 0; bits &= bits - 1) {
            *rows++ = w * BITS_PER_WORD + lowest_bit(bits);
        }
    }
}

/* Makes all neighbours of the eliminated separator neighbours of each other. */
static void join_neighbours(vbss_elimination *e, const graph *g, uint32_t eliminated,
                            const uint32_t *rows, uint32_t count)
{
    const uint64_t *from = row_of(g, eliminated);
    for (uint32_t r = 0; r < count; r++) {
        uint32_t i = rows[r];
        uint64_t *to = row_of(g, i);
        for (uint32_t w = 0; w < g->words; w++) {
            to[w] |= from[w];
        }
        to[i / BITS_PER_WORD] &= ~bit_of(i);
        e->degrees[i].neighbours = degree_of(to, g->words);
    }
}

static vbss_result find_elimination_order(vbss_system *s, const graph *g)
{
    vbss_elimination *e = &s->elimination;
    uint32_t entries = 0;
    e->product_count = 0;
    for (uint32_t k = 0; k < g->count; k++) {
        uint32_t eliminated = (uint32_t)(min_key(e->keys, g->count) & ((1 << KEY_INDEX_BITS) - 1));
        uint32_t degree = e->degrees[eliminated].neighbours;
        if (degree > s->factor_capacity - entries) {
            return vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                             "system: more than %u separator pairs with fill-in",
                             s->factor_capacity);
        }
        e->order[k] = eliminated;
        e->position[eliminated] = k;
        e->keys[eliminated] = KEY_ELIMINATED;
        e->column_start[k] = entries;
        uint32_t *rows = e->rows + entries;
        list_neighbours(g, eliminated, rows);
        if (degree > e->degrees[eliminated].joined) {
            join_neighbours(e, g, eliminated, rows, degree);
        }
        for (uint32_t r = 0; r < degree; r++) {
            uint32_t i = rows[r];
            row_of(g, i)[eliminated / BITS_PER_WORD] &= ~bit_of(eliminated);
            e->degrees[i] = (vbss_degree){e->degrees[i].neighbours - 1, degree - 1};
            e->keys[i] = key_of(e->degrees[i], i);
        }
        entries += degree;
        e->product_count += (uint64_t)degree * (degree + 1);
    }
    e->column_start[g->count] = entries;
    return VBSS_OK;
}

/* ---- the factor by columns and by rows, both ascending, sorted by two bucket passes */

/* Turns the counts in start[1 ..] into the start of each bucket. */
static void prefix_sum(uint32_t *start, uint32_t count)
{
    start[0] = 0;
    for (uint32_t k = 0; k < count; k++) {
        start[k + 1] += start[k];
    }
}

static void sort_entries(vbss_elimination *e, uint32_t count)
{
    uint32_t *next = e->bucket_next;
    memset(e->row_start, 0, ((size_t)count + 1) * sizeof *e->row_start);
    for (uint32_t f = 0; f < e->column_start[count]; f++) {
        e->rows[f] = e->position[e->rows[f]];
        e->row_start[e->rows[f] + 1]++;
    }
    prefix_sum(e->row_start, count);
    memcpy(next, e->row_start, count * sizeof *next);
    for (uint32_t k = 0; k < count; k++) {
        for (uint32_t f = e->column_start[k]; f < e->column_start[k + 1]; f++) {
            e->row_entries[next[e->rows[f]]++].column = k;
        }
    }
    memcpy(next, e->column_start, count * sizeof *next);
    for (uint32_t row = 0; row < count; row++) {
        for (uint32_t r = e->row_start[row]; r < e->row_start[row + 1]; r++) {
            uint32_t f = next[e->row_entries[r].column]++;
            e->rows[f] = row;
            e->row_entries[r].entry = f;
        }
    }
}

/* Column (a position) of a pair, given the lower separator and the entry in its column. */
static uint32_t column_of(const vbss_system *s, const vbss_elimination *e, uint32_t low,
                          uint32_t entry, vbss_pair *pair)
{
    uint32_t a = e->position[low], b = e->position[s->entries[entry].row - s->interior_count];
    pair->row = a > b ? a : b;
    pair->schur_index = 2 * (entry - s->separator_first_entry) + (b < a);
    return a > b ? b : a;
}

static void sort_pairs(const vbss_system *s, vbss_elimination *e, uint32_t count)
{
    uint32_t *next = e->bucket_next;
    const uint32_t *begin = s->column_start + s->interior_count;
    vbss_pair pair;
    memset(e->pair_start, 0, ((size_t)count + 1) * sizeof *e->pair_start);
    for (uint32_t low = 0; low < count; low++) {
        for (uint32_t f = begin[low]; f < begin[low + 1]; f++) {
            e->pair_start[column_of(s, e, low, f, &pair) + 1]++;
        }
    }
    prefix_sum(e->pair_start, count);
    memcpy(next, e->pair_start, count * sizeof *next);
    for (uint32_t low = 0; low < count; low++) {
        for (uint32_t f = begin[low]; f < begin[low + 1]; f++) {
            uint32_t column = column_of(s, e, low, f, &pair);
            e->pairs[next[column]++] = pair;
        }
    }
}

vbss_result VBSS_WIDE_NAME(vbss_system_order_separators)(vbss_system *s)
{
    graph g = begin_graph(s);
    VBSS_TRY(list_pairs(s, &g));
    VBSS_TRY(find_elimination_order(s, &g));
    sort_entries(&s->elimination, g.count);
    sort_pairs(s, &s->elimination, g.count);
    return VBSS_OK;
}
