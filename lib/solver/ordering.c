/* The order of elimination, and what it fills in: symbolic work, done anew when the pattern changes.
 *
 * Within a run the elimination goes toward the separators, so that only the last few blocks meet
 * them. A run without any is eliminated from both ends to the middle in turn: two chains of
 * arithmetic that do not wait for each other. Chains that are no lines bring their order. */
#include "solver/bits.h"
#include "solver/solver.h"

#include <string.h>

/* ---- order */

typedef struct run {
    uint32_t first, last; /* blocks */
    bool separator_before, separator_after;
} run;

static void place_block(vbss_system *s, uint32_t b)
{
    if (s->roles[b] == VBSS_ROLE_RUN) {
        s->order[s->active_count] = b;
        s->place[b] = s->active_count++;
    }
}

static void place_run(vbss_system *s, run r)
{
    if (r.separator_after) {
        for (uint32_t b = r.first; b <= r.last; b++) {
            place_block(s, b);
        }
    } else if (r.separator_before) {
        for (uint32_t b = r.last + 1; b > r.first; b--) {
            place_block(s, b - 1);
        }
    } else {
        uint32_t low = r.first, high = r.last;
        for (; low < high; low++, high--) {
            place_block(s, low);
            place_block(s, high);
        }
        if (low == high) {
            place_block(s, low);
        }
    }
}

static void order_runs(vbss_system *s)
{
    uint32_t begin = 0;
    s->active_count = 0;
    for (uint32_t chain = 0; chain < s->chain_count; chain++) {
        uint32_t end = s->chain_ends[chain];
        bool before = false;
        if (s->chain_ordered[chain]) {
            for (uint32_t b = begin; b < end; b++) {
                place_block(s, b);
            }
            begin = end;
            continue;
        }
        for (uint32_t b = begin; b < end; b++) {
            if (s->roles[b] == VBSS_ROLE_SEPARATOR) {
                before = true;
                continue;
            }
            run r = {b, b, before, false};
            while (r.last + 1 < end && s->roles[r.last + 1] != VBSS_ROLE_SEPARATOR) {
                r.last++;
            }
            r.separator_after = r.last + 1 < end;
            place_run(s, r);
            b = r.last;
        }
        begin = end;
    }
    s->run_count = s->active_count;
}

static vbss_result order_separators(vbss_system *s)
{
    for (uint32_t b = 0; b < s->block_count; b++) {
        if (s->roles[b] == VBSS_ROLE_SEPARATOR) {
            if (s->active_count - s->run_count == s->separator_capacity) {
                return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separators",
                                 s->separator_capacity);
            }
            s->order[s->active_count] = b;
            s->place[b] = s->active_count++;
        }
    }
    return VBSS_OK;
}

/* ---- fill: columns one after the other, each from what bodies couple and from the columns that are eliminated
 * before and meet it
 *
 * The rows of the column at hand are bits, which tell them apart and ascending. */

/* Numbers are by column, that is by position, but for index. */
typedef struct symbolic {
    uint32_t *couplings; /* the first of its list; VBSS_NO_COUPLING at its end */
    /* Of columns of runs, the first that waits here, counted from 1, and the next: they are where they have
     * the entry `at`, and what eliminating them changes in columns from here on goes to `product`. */
    uint32_t *waiting, *next, *at, *product;
    uint64_t *bits;
    uint32_t *index; /* row -> of its numbers, where there is a bit */
    uint32_t last_word, fill, products;
} symbolic;

static symbolic begin_symbolic(vbss_system *s)
{
    size_t n = s->block_capacity;
    uint32_t *of = s->lists;
    symbolic y = {.couplings = of,
                  .waiting = of + n,
                  .next = of + 2 * n,
                  .at = of + 3 * n,
                  .product = of + 4 * n,
                  .bits = s->row_bits,
                  .index = of + 5 * n,
                  .fill = s->own_count + 1};
    memset(y.couplings, 0, s->active_count * sizeof *y.couplings);
    memset(y.waiting, 0, s->active_count * sizeof *y.waiting);
    memset(y.bits, 0, ((size_t)s->active_count / BITS + 1) * sizeof *y.bits);
    for (uint32_t c = s->own_count; c > 0; c--) {
        vbss_coupling *coupling = &s->couplings[c];
        uint32_t high = s->place[coupling->high], low = s->place[coupling->low];
        uint32_t column = high < low ? high : low;
        coupling->flipped = column == high;
        coupling->next = y.couplings[column];
        y.couplings[column] = c;
    }
    return y;
}

static inline void add_row(symbolic *y, uint32_t row, uint32_t index)
{
    uint32_t word = row / BITS;
    y->bits[word] |= bit_of(row);
    y->index[row] = index;
    y->last_word = word > y->last_word ? word : y->last_word;
}

static void add_coupled(const vbss_system *s, symbolic *y, uint32_t k)
{
    y->last_word = k / BITS;
    for (uint32_t c = y->couplings[k]; c != VBSS_NO_COUPLING; c = s->couplings[c].next) {
        uint32_t high = s->place[s->couplings[c].high], low = s->place[s->couplings[c].low];
        add_row(y, high > low ? high : low, c);
    }
}

/* A column of a run waits where it has its next entry. */
static void hang(const vbss_system *s, symbolic *y, uint32_t column)
{
    uint32_t at = y->at[column];
    if (at < s->column_start[column + 1]) {
        uint32_t row = s->entries[at].row;
        y->next[column] = y->waiting[row];
        y->waiting[row] = column + 1;
    }
}

/* Rows of an eliminated column below row k: what is not there yet is fill, and all of it is changed. */
static void add_filled(vbss_system *s, symbolic *y, uint32_t column)
{
    uint32_t *product = s->products + y->product[column];
    for (uint32_t e = y->at[column] + 1; e < s->column_start[column + 1]; e++) {
        uint32_t row = s->entries[e].row;
        if ((y->bits[row / BITS] & bit_of(row)) == 0) {
            add_row(y, row, y->fill++);
        }
        *product++ = y->index[row];
    }
    y->product[column] = (uint32_t)(product - s->products);
}

static void add_all_filled(vbss_system *s, symbolic *y, uint32_t k)
{
    for (uint32_t waiting = y->waiting[k], next; waiting != 0; waiting = next) {
        uint32_t column = waiting - 1;
        next = y->next[column];
        add_filled(s, y, column);
        y->at[column]++;
        hang(s, y, column);
    }
}

/* Takes the rows ascending, counted from `from`. Returns how many there were: when more than there is room for,
 * these are not there. */
static uint32_t list_rows(symbolic *y, uint32_t k, uint32_t from, vbss_entry *entries,
                          uint32_t room)
{
    uint32_t count = 0;
    for (uint32_t w = k / BITS; w <= y->last_word; w++) {
        for (uint64_t bits = y->bits[w]; bits != 0; bits &= bits - 1) {
            uint32_t row = w * BITS + lowest_bit(bits);
            if (count < room) {
                entries[count] = (vbss_entry){row - from, y->index[row]};
            }
            count++;
        }
        y->bits[w] = 0;
    }
    return count;
}

static vbss_result find_run_column(vbss_system *s, symbolic *y, uint32_t k)
{
    uint32_t begin = s->column_start[k], room = s->entry_capacity - begin;
    add_coupled(s, y, k);
    add_all_filled(s, y, k);
    uint32_t rows = list_rows(y, k, 0, s->entries + begin, room);
    if (rows > room) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks of factor",
                         s->entry_capacity);
    }
    s->column_start[k + 1] = begin + rows;
    uint64_t products = (uint64_t)rows * (rows - (rows > 0)) / 2;
    if (products > s->product_capacity - y->products) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u products",
                         s->product_capacity);
    }
    s->product_start[k] = y->product[k] = y->products;
    y->products += (uint32_t)products;
    y->at[k] = begin;
    hang(s, y, k);
    return VBSS_OK;
}

/* A separator's column as condensing leaves it: separators are not eliminated here. */
static vbss_result find_joins(vbss_system *s, symbolic *y, uint32_t separator)
{
    uint32_t k = s->run_count + separator;
    uint32_t begin = s->join_start[separator], room = s->pair_capacity - begin;
    add_coupled(s, y, k);
    add_all_filled(s, y, k);
    uint32_t rows = list_rows(y, k, s->run_count, s->joins + begin, room);
    if (rows > room) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separator pairs",
                         s->pair_capacity);
    }
    s->join_start[separator + 1] = begin + rows;
    return VBSS_OK;
}

/* All that couplings of couple_once do not change. */
static vbss_result analyse_bodies(vbss_system *s)
{
    order_runs(s);
    VBSS_TRY(order_separators(s));
    symbolic y = begin_symbolic(s);
    s->column_start[0] = s->join_start[0] = 0;
    for (uint32_t k = 0; k < s->run_count; k++) {
        VBSS_TRY(find_run_column(s, &y, k));
    }
    s->separator_first_entry = s->column_start[s->run_count];
    for (uint32_t i = 0; i < s->active_count - s->run_count; i++) {
        VBSS_TRY(find_joins(s, &y, i));
    }
    s->fill_count = y.fill - (s->own_count + 1);
    return VBSS_OK;
}

vbss_result vbss_system_analyse(vbss_system *s)
{
    if (!s->bodies_known) {
        VBSS_TRY(analyse_bodies(s));
        s->bodies_known = true;
    }
    return vbss_system_order_separators(s);
}
