/* The order of elimination, and what it fills in: symbolic work, done anew when the pattern changes.
 *
 * Within a run the elimination goes toward the separators, so that only the last few blocks meet
 * them. A run without any is eliminated from both ends to the middle in turn: two chains of
 * arithmetic that do not wait for each other. Chains that are no lines bring their order. */
#include "base/bits.h"
#include "base/error.h"
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
 * The rows of the column at hand are bits, which tell them apart and ascending. A column of a run has those of all that
 * meet it once it has those of its children, the columns that meet it first: what is further down in a column is in its
 * parent too (Liu 1990, The role of elimination trees in sparse factorization). So rows come from few columns, and the
 * many others only ask for numbers. */

/* Numbers are by column, that is by position, but for index. */
typedef struct symbolic {
    uint32_t *couplings; /* the first of its list; VBSS_NO_COUPLING at its end */
    /* Of columns of runs, the first child, counted from 1, and the next of the same parent. */
    uint32_t *child, *sibling;
    /* The same of those that wait here: they are where they have the entry `at`, and what eliminating them changes in
     * columns from here on goes to `product`. */
    uint32_t *waiting, *next, *at, *product;
    uint32_t *like;            /* the column whose products follow there; VBSS_NO_PLACE: none */
    uint64_t *bits, *own_bits; /* rows; of them, those that bodies couple */
    uint32_t *index;           /* row -> of its numbers */
    uint32_t last_word, fill, products;
} symbolic;

static symbolic begin_symbolic(vbss_system *s)
{
    size_t n = s->block_capacity, words = s->active_count / BITS_PER_WORD + 1;
    uint32_t *of = s->lists;
    symbolic y = {.couplings = of,
                  .child = of + n,
                  .waiting = of + 2 * n,
                  .sibling = of + 3 * n,
                  .next = of + 4 * n,
                  .at = of + 5 * n,
                  .product = of + 6 * n,
                  .index = of + 7 * n,
                  .like = of + 8 * n,
                  .bits = s->row_bits,
                  .own_bits = s->row_bits + words,
                  .fill = s->own_count + 1};
    memset(y.couplings, 0, s->active_count * sizeof *y.couplings);
    memset(y.child, 0, s->active_count * sizeof *y.child);
    memset(y.waiting, 0, s->active_count * sizeof *y.waiting);
    memset(y.bits, 0, 2 * words * sizeof *y.bits);
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

static inline void reach_row(symbolic *y, uint32_t row)
{
    y->last_word = row / BITS_PER_WORD > y->last_word ? row / BITS_PER_WORD : y->last_word;
}

static void add_coupled(const vbss_system *s, symbolic *y, uint32_t k)
{
    y->last_word = k / BITS_PER_WORD;
    for (uint32_t c = y->couplings[k]; c != VBSS_NO_COUPLING; c = s->couplings[c].next) {
        uint32_t high = s->place[s->couplings[c].high], low = s->place[s->couplings[c].low];
        uint32_t row = high > low ? high : low;
        y->bits[row / BITS_PER_WORD] |= bit_of(row);
        y->own_bits[row / BITS_PER_WORD] |= bit_of(row);
        y->index[row] = c;
        reach_row(y, row);
    }
}

/* Rows of columns in a list, counted from 1, from behind where they are. */
static void add_rows_of(const vbss_system *s, symbolic *y, uint32_t first, const uint32_t *next)
{
    for (uint32_t listed = first; listed != 0; listed = next[listed - 1]) {
        const vbss_entry *e = s->entries + y->at[listed - 1] + 1;
        const vbss_entry *end = s->entries + s->column_start[listed];
        uint64_t *bits = y->bits;
        for (; e < end; e++) {
            bits[e->row / BITS_PER_WORD] |= bit_of(e->row);
        }
        reach_row(y, end[-1].row); /* they ascend */
    }
}

/* Takes the rows ascending, counted from `from`, and gives numbers to fill. Returns how many there were: when more than
 * there is room for, these are not there. */
static uint32_t list_rows(symbolic *y, uint32_t k, uint32_t from, vbss_entry *entries,
                          uint32_t room)
{
    uint32_t count = 0;
    for (uint32_t w = k / BITS_PER_WORD; w <= y->last_word; w++) {
        uint64_t own = y->own_bits[w];
        for (uint64_t bits = y->bits[w]; bits != 0; bits &= bits - 1) {
            uint32_t row = w * BITS_PER_WORD + lowest_bit(bits);
            bool filled = (own & bit_of(row)) == 0;
            uint32_t index = filled ? y->fill : y->index[row];
            y->fill += filled;
            y->index[row] = index;
            if (count < room) {
                entries[count] = (vbss_entry){row - from, index};
            }
            count++;
        }
        y->bits[w] = y->own_bits[w] = 0;
    }
    return count;
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

/* What the columns that wait at column k change there. Of those whose other rows are all that there are in column k, a
 * run of `rows` rows, the rest is what column k changes: copied when that is known. */
static void list_products(vbss_system *s, symbolic *y, uint32_t k, uint32_t rows)
{
    const uint32_t *index = y->index;
    for (uint32_t waiting = y->waiting[k], next; waiting != 0; waiting = next) {
        uint32_t column = waiting - 1;
        uint32_t *product = s->products + y->product[column];
        const vbss_entry *e = s->entries + ++y->at[column];
        const vbss_entry *end = s->entries + s->column_start[waiting];
        next = y->next[column];
        if ((uint32_t)(end - e) == rows) {
            y->like[column] = k;
            continue;
        }
        y->product[column] += (uint32_t)(end - e);
        for (; e < end; e++) {
            *product++ = index[e->row];
        }
        hang(s, y, column);
    }
}

/* Of columns that are like a later one from somewhere on: those that it is like itself come first. */
static void copy_products(vbss_system *s, const symbolic *y)
{
    for (uint32_t column = s->run_count; column > 0; column--) {
        uint32_t k = y->like[column - 1];
        if (k == VBSS_NO_PLACE) {
            continue;
        }
        uint32_t rows = s->column_start[k + 1] - s->column_start[k];
        const vbss_entry *e = s->entries + s->column_start[k];
        uint32_t *product = s->products + y->product[column - 1];
        for (uint32_t i = 0; i < rows; i++) {
            *product++ = e[i].index;
        }
        memcpy(product, s->products + s->product_start[k],
               (size_t)rows * (rows - (rows > 0)) / 2 * sizeof *product);
    }
}

static void become_child(const vbss_system *s, symbolic *y, uint32_t column)
{
    uint32_t begin = s->column_start[column];
    y->at[column] = begin;
    if (begin < s->column_start[column + 1]) {
        uint32_t parent = s->entries[begin].row;
        y->sibling[column] = y->child[parent];
        y->child[parent] = column + 1;
    }
    hang(s, y, column);
}

static vbss_result find_run_column(vbss_system *s, symbolic *y, uint32_t k)
{
    uint32_t begin = s->column_start[k], room = s->entry_capacity - begin;
    add_coupled(s, y, k);
    add_rows_of(s, y, y->child[k], y->sibling);
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
    y->like[k] = VBSS_NO_PLACE;
    list_products(s, y, k, rows);
    become_child(s, y, k);
    return VBSS_OK;
}

/* A separator's column as condensing leaves it: separators are not eliminated here, so all that meet it are asked. */
static vbss_result find_joins(vbss_system *s, symbolic *y, uint32_t separator)
{
    uint32_t k = s->run_count + separator;
    uint32_t begin = s->join_start[separator], room = s->pair_capacity - begin;
    add_coupled(s, y, k);
    add_rows_of(s, y, y->waiting[k], y->next);
    uint32_t rows = list_rows(y, k, s->run_count, s->joins + begin, room);
    if (rows > room) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separator pairs",
                         s->pair_capacity);
    }
    s->join_start[separator + 1] = begin + rows;
    list_products(s, y, k, VBSS_NO_PLACE);
    return VBSS_OK;
}

/* All that couplings of couple_once do not change. */
static vbss_result analyse_bodies(vbss_system *s)
{
    order_runs(s);
    VBSS_TRY(order_separators(s));
    symbolic y = begin_symbolic(s);
    s->column_start[0] = s->join_start[0] = 0;
    uint32_t k = 0, *fill_end = s->fill_ends;
    for (uint32_t chain = 0; chain < s->chain_count; chain++) {
        for (; k < s->run_count && s->chain_of[s->order[k]] == chain; k++) {
            VBSS_TRY(find_run_column(s, &y, k));
        }
        *fill_end++ = y.fill - (s->own_count + 1);
    }
    s->separator_first_entry = s->column_start[k];
    for (uint32_t chain = 0; chain < s->chain_count; chain++) {
        for (; k < s->active_count && s->chain_of[s->order[k]] == chain; k++) {
            VBSS_TRY(find_joins(s, &y, k - s->run_count));
        }
        *fill_end++ = y.fill - (s->own_count + 1);
    }
    copy_products(s, &y);
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
