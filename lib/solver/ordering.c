/* The order of elimination, and what it fills in: symbolic work, done anew when the pattern changes.
 *
 * Within a run the elimination goes toward the separators, so that only the last few blocks meet
 * them. A run without any is eliminated from both ends to the middle in turn: two chains of
 * arithmetic that do not wait for each other. Chains that are no lines bring their order. */
#include "solver/solver.h"

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

/* ---- fill */

/* lists: heads of the couplings of each column, heads of the children of each position in the
 * elimination tree, and the next child; all ended by 0 (children are counted from 1). Of a run's column
 * that meets separators only, the first entry that was not passed on yet. */
typedef struct symbolic {
    uint32_t *coupling_head, *child_head, *child_next, *rest;
} symbolic;

static symbolic begin_symbolic(vbss_system *s)
{
    uint32_t n = s->block_capacity;
    symbolic y = {s->lists, s->lists + n, s->lists + 2 * (size_t)n, s->lists + 3 * (size_t)n};
    for (uint32_t k = 0; k < s->active_count; k++) {
        y.coupling_head[k] = y.child_head[k] = y.child_next[k] = 0;
        s->marks[k] = UINT32_MAX;
    }
    for (uint32_t c = s->coupling_count; c > 0; c--) {
        vbss_coupling *coupling = &s->couplings[c];
        uint32_t high = s->place[coupling->high], low = s->place[coupling->low];
        uint32_t column = high < low ? high : low;
        coupling->flipped = column == high;
        coupling->next = y.coupling_head[column];
        y.coupling_head[column] = c;
    }
    return y;
}

/* Inserts a row into the column that is being built, keeping rows ascending. */
static vbss_result insert(vbss_system *s, uint32_t begin, uint32_t row, uint32_t index)
{
    if (s->entry_count == s->entry_capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u blocks of factor",
                         s->entry_capacity);
    }
    uint32_t at = s->entry_count++;
    for (; at > begin && s->entries[at - 1].row > row; at--) {
        s->entries[at] = s->entries[at - 1];
    }
    s->entries[at].row = row;
    s->entries[at].index = index;
    return VBSS_OK;
}

static void hang(symbolic *y, uint32_t column, uint32_t parent)
{
    y->child_next[column] = y->child_head[parent];
    y->child_head[parent] = column + 1;
}

static vbss_result begin_column(vbss_system *s, const symbolic *y, uint32_t k)
{
    uint32_t begin = s->entry_count;
    s->column_start[k] = begin;
    for (uint32_t c = y->coupling_head[k]; c != 0; c = s->couplings[c].next) {
        uint32_t high = s->place[s->couplings[c].high], low = s->place[s->couplings[c].low];
        uint32_t row = high > low ? high : low;
        s->marks[row] = k;
        VBSS_TRY(insert(s, begin, row, c));
    }
    return VBSS_OK;
}

/* Of what stands from entry `from` on in a column that is eliminated earlier. */
static vbss_result fill_from(vbss_system *s, uint32_t k, uint32_t column, uint32_t from,
                             uint32_t *fill)
{
    for (uint32_t e = from; e < s->column_start[column + 1]; e++) {
        uint32_t row = s->entries[e].row;
        if (row != k && s->marks[row] != k) {
            s->marks[row] = k;
            VBSS_TRY(insert(s, s->column_start[k], row, (*fill)++));
        }
    }
    return VBSS_OK;
}

static vbss_result fill_run(vbss_system *s, symbolic *y, uint32_t k, uint32_t *fill)
{
    VBSS_TRY(begin_column(s, y, k));
    for (uint32_t child = y->child_head[k]; child != 0; child = y->child_next[child - 1]) {
        VBSS_TRY(fill_from(s, k, child - 1, s->column_start[child - 1], fill));
    }
    uint32_t begin = s->column_start[k];
    s->column_start[k + 1] = s->entry_count;
    y->rest[k] = begin;
    if (s->entry_count > begin) {
        hang(y, k, s->entries[begin].row);
    }
    return VBSS_OK;
}

/* A separator's column as condensing leaves it: separators are not eliminated here. A run's column that
 * meets separators only joins all of them: it is passed on from one to the next. */
static vbss_result fill_separator(vbss_system *s, symbolic *y, uint32_t k, uint32_t *fill)
{
    VBSS_TRY(begin_column(s, y, k));
    for (uint32_t child = y->child_head[k], next; child != 0; child = next) {
        uint32_t column = child - 1, rest = ++y->rest[column];
        next = y->child_next[column];
        VBSS_TRY(fill_from(s, k, column, rest, fill));
        if (rest < s->column_start[column + 1]) {
            hang(y, column, s->entries[rest].row);
        }
    }
    s->column_start[k + 1] = s->entry_count;
    return VBSS_OK;
}

/* The entry in a row and a column that must be there. */
static uint32_t find_entry(const vbss_system *s, uint32_t row, uint32_t column)
{
    uint32_t low = s->column_start[column], high = s->column_start[column + 1];
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (s->entries[middle].row <= row) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return s->entries[low].index;
}

/* What eliminating a run's column changes: for each pair of its rows the numbers at their crossing,
 * in the order in which condensing meets them. */
static vbss_result list_products(vbss_system *s)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < s->run_count; k++) {
        uint32_t begin = s->column_start[k], end = s->column_start[k + 1];
        uint32_t rows = end - begin;
        s->product_start[k] = count;
        if (rows * (rows - (rows > 0)) / 2 > s->product_capacity - count) {
            return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "system: more than %u products",
                             s->product_capacity);
        }
        for (uint32_t q = begin; q < end; q++) {
            for (uint32_t p = q + 1; p < end; p++) {
                s->products[count++] = find_entry(s, s->entries[p].row, s->entries[q].row);
            }
        }
    }
    return VBSS_OK;
}

vbss_result vbss_system_analyse(vbss_system *s)
{
    order_runs(s);
    VBSS_TRY(order_separators(s));
    symbolic y = begin_symbolic(s);
    uint32_t fill = s->coupling_count + 1;
    s->entry_count = 0;
    s->column_start[0] = 0;
    for (uint32_t k = 0; k < s->run_count; k++) {
        VBSS_TRY(fill_run(s, &y, k, &fill));
    }
    s->separator_first_entry = s->entry_count;
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        VBSS_TRY(fill_separator(s, &y, k, &fill));
    }
    s->pair_count = s->entry_count - s->separator_first_entry;
    s->fill_count = fill - (s->coupling_count + 1);
    VBSS_TRY(list_products(s));
    return vbss_system_order_separators(s);
}
