/* Symbolic analysis: elimination order and fill, repeated when the pattern changes.
 *
 * A run is a sequence of interior blocks between separators. Its elimination proceeds towards a
 * separator, so that only the last few blocks are coupled with it. A run without separators is
 * eliminated from both ends in turn: these are two independent chains of arithmetic, which the
 * processor can overlap. Chains with natural order keep the order of their numbers. */
#include "base/bits.h"
#include "base/error.h"
#include "solver/solver.h"

#include <string.h>

/* ---- order */

typedef struct run {
    uint32_t first, last; /* blocks */
    bool separator_before, separator_after;
} run;

static void append_interior(vbss_system *s, uint32_t b)
{
    if (s->roles[b] == VBSS_ROLE_INTERIOR) {
        s->order[s->unknown_count] = b;
        s->position[b] = s->unknown_count++;
    }
}

static void append_run(vbss_system *s, run r)
{
    if (r.separator_after) {
        for (uint32_t b = r.first; b <= r.last; b++) {
            append_interior(s, b);
        }
    } else if (r.separator_before) {
        for (uint32_t b = r.last + 1; b > r.first; b--) {
            append_interior(s, b - 1);
        }
    } else {
        uint32_t low = r.first, high = r.last;
        for (; low < high; low++, high--) {
            append_interior(s, low);
            append_interior(s, high);
        }
        if (low == high) {
            append_interior(s, low);
        }
    }
}

static void append_interiors(vbss_system *s)
{
    uint32_t begin = 0;
    s->unknown_count = 0;
    for (uint32_t chain = 0; chain < s->chain_count; chain++) {
        uint32_t end = s->chain_ends[chain];
        bool before = false;
        if (s->chain_uses_natural_order[chain]) {
            for (uint32_t b = begin; b < end; b++) {
                append_interior(s, b);
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
            append_run(s, r);
            b = r.last;
        }
        begin = end;
    }
    s->interior_count = s->unknown_count;
}

static vbss_result append_separators(vbss_system *s)
{
    for (uint32_t b = 0; b < s->block_count; b++) {
        if (s->roles[b] == VBSS_ROLE_SEPARATOR) {
            if (s->unknown_count - s->interior_count == s->separator_capacity) {
                return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separators",
                                 s->separator_capacity);
            }
            s->order[s->unknown_count] = b;
            s->position[b] = s->unknown_count++;
        }
    }
    return VBSS_OK;
}

/* ---- fill: each column gets rows from the couplings of bodies and from earlier columns that have
 * an entry in it
 *
 * The rows of the current column are bits, which removes duplicates and sorts them. An interior
 * column needs only the rows of its children in the elimination tree. The lower rows of any other
 * column with an entry here are also rows of that column's parent (Liu 1990, The role of
 * elimination trees in sparse factorization). So rows come from few columns; all the others only
 * need the indices of their products. */

/* State of the analysis. Arrays are indexed by column, that is by position, except `index`. */
typedef struct symbolic {
    uint32_t *couplings; /* first coupling of each column's list, which VBSS_NO_COUPLING ends */
    /* Elimination tree of the interior columns: first child, and next child of the same parent.
     * Columns count from 1 here; 0 ends a list. */
    uint32_t *child, *sibling;
    /* Lists of earlier columns that have their next entry in this column, with the same counting.
     * next_entry is that entry; the products of eliminating the column from here on are written
     * from next_product. */
    uint32_t *pending, *next, *next_entry, *next_product;
    /* column whose rows and products follow there; VBSS_NO_INDEX for none */
    uint32_t *product_source;
    /* rows of the current column, and those of them that bodies couple */
    uint64_t *bits, *coupled_bits;
    uint32_t *index; /* row -> index of its block */
    uint32_t last_word, fill, products;
} symbolic;

static symbolic begin_symbolic(vbss_system *s)
{
    size_t n = s->block_capacity, words = s->unknown_count / BITS_PER_WORD + 1;
    uint32_t *scratch = s->symbolic_scratch;
    symbolic y = {.couplings = scratch,
                  .child = scratch + n,
                  .pending = scratch + 2 * n,
                  .sibling = scratch + 3 * n,
                  .next = scratch + 4 * n,
                  .next_entry = scratch + 5 * n,
                  .next_product = scratch + 6 * n,
                  .index = scratch + 7 * n,
                  .product_source = scratch + 8 * n,
                  .bits = s->row_bits,
                  .coupled_bits = s->row_bits + words,
                  .fill = s->body_coupling_count + 1};
    memset(y.couplings, 0, s->unknown_count * sizeof *y.couplings);
    memset(y.child, 0, s->unknown_count * sizeof *y.child);
    memset(y.pending, 0, s->unknown_count * sizeof *y.pending);
    memset(y.bits, 0, 2 * words * sizeof *y.bits);
    for (uint32_t c = s->body_coupling_count; c > 0; c--) {
        vbss_coupling *coupling = &s->couplings[c];
        uint32_t high = s->position[coupling->high], low = s->position[coupling->low];
        uint32_t column = high < low ? high : low;
        coupling->is_transposed = column == high;
        coupling->next = y.couplings[column];
        y.couplings[column] = c;
    }
    return y;
}

static inline void extend_to_row(symbolic *y, uint32_t row)
{
    y->last_word = row / BITS_PER_WORD > y->last_word ? row / BITS_PER_WORD : y->last_word;
}

static void add_coupled(const vbss_system *s, symbolic *y, uint32_t k)
{
    y->last_word = k / BITS_PER_WORD;
    for (uint32_t c = y->couplings[k]; c != VBSS_NO_COUPLING; c = s->couplings[c].next) {
        uint32_t high = s->position[s->couplings[c].high], low = s->position[s->couplings[c].low];
        uint32_t row = high > low ? high : low;
        y->bits[row / BITS_PER_WORD] |= bit_of(row);
        y->coupled_bits[row / BITS_PER_WORD] |= bit_of(row);
        y->index[row] = c;
        extend_to_row(y, row);
    }
}

/* Adds the rows of all columns of a list, below their entry in the current column. */
static void add_rows_of(const vbss_system *s, symbolic *y, uint32_t first, const uint32_t *next)
{
    for (uint32_t listed = first; listed != 0; listed = next[listed - 1]) {
        const vbss_entry *e = s->entries + y->next_entry[listed - 1] + 1;
        const vbss_entry *end = s->entries + s->column_start[listed];
        uint64_t *bits = y->bits;
        for (; e < end; e++) {
            bits[e->row / BITS_PER_WORD] |= bit_of(e->row);
        }
        extend_to_row(y, end[-1].row); /* rows are ascending */
    }
}

/* Lists the rows in ascending order, minus `from`, and numbers the fill. Returns the number of
 * rows; rows beyond the capacity are not written. */
static uint32_t list_rows(symbolic *y, uint32_t k, uint32_t from, vbss_entry *entries,
                          uint32_t capacity)
{
    uint32_t count = 0;
    for (uint32_t w = k / BITS_PER_WORD; w <= y->last_word; w++) {
        uint64_t coupled = y->coupled_bits[w];
        for (uint64_t bits = y->bits[w]; bits != 0; bits &= bits - 1) {
            uint32_t row = w * BITS_PER_WORD + lowest_bit(bits);
            bool is_fill = (coupled & bit_of(row)) == 0;
            uint32_t index = is_fill ? y->fill : y->index[row];
            y->fill += is_fill;
            y->index[row] = index;
            if (count < capacity) {
                entries[count] = (vbss_entry){row - from, index};
            }
            count++;
        }
        y->bits[w] = y->coupled_bits[w] = 0;
    }
    return count;
}

/* Appends an interior column to the list at the row of its next entry. */
static void add_to_pending(const vbss_system *s, symbolic *y, uint32_t column)
{
    uint32_t next_entry = y->next_entry[column];
    if (next_entry < s->column_start[column + 1]) {
        uint32_t row = s->entries[next_entry].row;
        y->next[column] = y->pending[row];
        y->pending[row] = column + 1;
    }
}

/* Lists the products of the pending columns in column k. If the remaining rows of a pending column
 * are exactly the `rows` rows of column k, its remaining products equal those of k. They are copied
 * later, once k's are complete. */
static void list_products(vbss_system *s, symbolic *y, uint32_t k, uint32_t rows)
{
    const uint32_t *index = y->index;
    for (uint32_t pending = y->pending[k], next; pending != 0; pending = next) {
        uint32_t column = pending - 1;
        uint32_t *product = s->products + y->next_product[column];
        const vbss_entry *e = s->entries + ++y->next_entry[column];
        const vbss_entry *end = s->entries + s->column_start[pending];
        next = y->next[column];
        if ((uint32_t)(end - e) == rows) {
            y->product_source[column] = k;
            continue;
        }
        y->next_product[column] += (uint32_t)(end - e);
        for (; e < end; e++) {
            *product++ = index[e->row];
        }
        add_to_pending(s, y, column);
    }
}

/* Copies the products of columns that continue like a later column. The loop runs backwards, so the
 * source is complete. */
static void copy_products(vbss_system *s, const symbolic *y)
{
    for (uint32_t column = s->interior_count; column > 0; column--) {
        uint32_t k = y->product_source[column - 1];
        if (k == VBSS_NO_INDEX) {
            continue;
        }
        uint32_t rows = s->column_start[k + 1] - s->column_start[k];
        const vbss_entry *e = s->entries + s->column_start[k];
        uint32_t *product = s->products + y->next_product[column - 1];
        for (uint32_t i = 0; i < rows; i++) {
            *product++ = e[i].index;
        }
        memcpy(product, s->products + s->product_start[k],
               (size_t)rows * (rows - (rows > 0)) / 2 * sizeof *product);
    }
}

static void link_to_parent(const vbss_system *s, symbolic *y, uint32_t column)
{
    uint32_t begin = s->column_start[column];
    y->next_entry[column] = begin;
    if (begin < s->column_start[column + 1]) {
        uint32_t parent = s->entries[begin].row;
        y->sibling[column] = y->child[parent];
        y->child[parent] = column + 1;
    }
    add_to_pending(s, y, column);
}

static vbss_result analyse_interior_column(vbss_system *s, symbolic *y, uint32_t k)
{
    uint32_t begin = s->column_start[k], capacity = s->entry_capacity - begin;
    add_coupled(s, y, k);
    add_rows_of(s, y, y->child[k], y->sibling);
    uint32_t rows = list_rows(y, k, 0, s->entries + begin, capacity);
    if (rows > capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks of factor",
                         s->entry_capacity);
    }
    s->column_start[k + 1] = begin + rows;
    uint64_t products = (uint64_t)rows * (rows - (rows > 0)) / 2;
    if (products > s->product_capacity - y->products) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u products",
                         s->product_capacity);
    }
    s->product_start[k] = y->next_product[k] = y->products;
    y->products += (uint32_t)products;
    y->product_source[k] = VBSS_NO_INDEX;
    list_products(s, y, k, rows);
    link_to_parent(s, y, k);
    return VBSS_OK;
}

/* Analyses a separator's column of the Schur complement. Separators are not eliminated here, so it
 * has no children: all columns with an entry in it contribute rows. */
static vbss_result analyse_schur_column(vbss_system *s, symbolic *y, uint32_t separator)
{
    uint32_t k = s->interior_count + separator;
    uint32_t begin = s->schur_column_start[separator], capacity = s->pair_capacity - begin;
    add_coupled(s, y, k);
    add_rows_of(s, y, y->pending[k], y->next);
    uint32_t rows = list_rows(y, k, s->interior_count, s->schur_pattern + begin, capacity);
    if (rows > capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u separator pairs",
                         s->pair_capacity);
    }
    s->schur_column_start[separator + 1] = begin + rows;
    list_products(s, y, k, VBSS_NO_INDEX);
    return VBSS_OK;
}

/* Analyses the part of the pattern that does not depend on vbss_system_couple_separators. */
static vbss_result analyse_bodies(vbss_system *s)
{
    append_interiors(s);
    VBSS_TRY(append_separators(s));
    symbolic y = begin_symbolic(s);
    s->column_start[0] = s->schur_column_start[0] = 0;
    uint32_t k = 0, *fill_end = s->fill_ends;
    for (uint32_t chain = 0; chain < s->chain_count; chain++) {
        for (; k < s->interior_count && s->chain_of[s->order[k]] == chain; k++) {
            VBSS_TRY(analyse_interior_column(s, &y, k));
        }
        *fill_end++ = y.fill - (s->body_coupling_count + 1);
    }
    s->separator_first_entry = s->column_start[k];
    for (uint32_t chain = 0; chain < s->chain_count; chain++) {
        for (; k < s->unknown_count && s->chain_of[s->order[k]] == chain; k++) {
            VBSS_TRY(analyse_schur_column(s, &y, k - s->interior_count));
        }
        *fill_end++ = y.fill - (s->body_coupling_count + 1);
    }
    copy_products(s, &y);
    s->fill_count = y.fill - (s->body_coupling_count + 1);
    return VBSS_OK;
}

/* Places the arrays of numbers one after another. */
static vbss_result divide_arena(vbss_system *s)
{
    const uint64_t off_diagonals = UINT64_C(1) + s->body_coupling_count + s->fill_count;
    const uint64_t separators = s->unknown_count - s->interior_count;
    const uint64_t schur_blocks = s->pair_count + separators;
    const uint64_t separator_blocks = schur_blocks + s->pair_count;
    const uint64_t factor = s->elimination.column_start[separators];
    if (off_diagonals + s->separator_first_entry + schur_blocks + separator_blocks + 2 * factor >
        s->arena_capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks of numbers",
                         s->arena_capacity);
    }
    s->off_diagonal = s->arena;
    s->scaled = s->off_diagonal + off_diagonals;
    s->schur_complement = s->scaled + s->separator_first_entry;
    s->separator_blocks = s->schur_complement + schur_blocks;
    s->elimination.lower = s->separator_blocks + separator_blocks;
    s->elimination.upper = s->elimination.lower + factor;
    return VBSS_OK;
}

vbss_result vbss_system_analyse(vbss_system *s)
{
    if (!s->has_body_pattern) {
        VBSS_TRY(analyse_bodies(s));
        s->has_body_pattern = true;
    }
    VBSS_TRY(vbss_system_order_separators(s));
    return divide_arena(s);
}
