/* The Schur complement of the separators: indices of its blocks, its copy for contacts, and the
 * line search. */
#include "solver/solver.h"

#include <string.h>

/* ---- indices: two for each pair, then the diagonals */

static uint32_t diagonal_index(const vbss_system *s, uint32_t separator)
{
    return 2 * s->pair_count + separator;
}

/* Entry in this row and column, both positions; UINT32_MAX if there is none. */
static uint32_t find_entry(const vbss_system *s, uint32_t row, uint32_t column)
{
    uint32_t low = s->column_start[column], end = s->column_start[column + 1], high = end;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (s->entries[middle].row < row) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < end && s->entries[low].row == row ? low : UINT32_MAX;
}

void vbss_system_schur_pair_indices(const vbss_system *s, uint32_t a, uint32_t b, uint32_t *ab,
                                    uint32_t *ba)
{
    *ab = *ba = VBSS_NO_INDEX;
    if (s->roles[a] != VBSS_ROLE_SEPARATOR || s->roles[b] != VBSS_ROLE_SEPARATOR) {
        return;
    }
    uint32_t i = s->position[a], j = s->position[b];
    if (i == j) {
        *ab = *ba = diagonal_index(s, i - s->interior_count);
        return;
    }
    uint32_t entry = i > j ? find_entry(s, i, j) : find_entry(s, j, i);
    if (entry != UINT32_MAX) {
        uint32_t lower = 2 * (entry - s->separator_first_entry);
        *ab = lower + (i < j);
        *ba = lower + (i > j);
    }
}

uint32_t vbss_system_schur_index(const vbss_system *s, uint32_t row, uint32_t column)
{
    uint32_t schur_index, other;
    vbss_system_schur_pair_indices(s, row, column, &schur_index, &other);
    return schur_index;
}

uint32_t vbss_system_schur_rhs_index(const vbss_system *s, uint32_t row)
{
    return s->roles[row] == VBSS_ROLE_SEPARATOR ? s->position[row] - s->interior_count
                                                : VBSS_NO_INDEX;
}

/* ---- the numbers */

void vbss_system_store_schur_rhs(vbss_system *s)
{
    for (uint32_t k = s->interior_count; k < s->unknown_count; k++) {
        s->schur_rhs[k - s->interior_count] = s->rhs[s->order[k]];
    }
}

void vbss_system_store_schur_complement(vbss_system *s)
{
    static const block none; /* value of pairs that only vbss_system_couple_separators coupled */
    block *pair = s->schur_complement, *diagonal = pair + s->pair_count;
    vbss_system_store_schur_rhs(s);
    for (uint32_t k = s->interior_count; k < s->unknown_count; k++) {
        *diagonal++ = s->diagonal[s->order[k]];
        for (uint32_t e = s->column_start[k]; e < s->column_start[k + 1]; e++) {
            uint32_t index = s->entries[e].index;
            *pair++ = index != VBSS_NO_COUPLING ? s->off_diagonal[index] : none;
        }
    }
}

void vbss_system_load_schur_complement(vbss_system *s)
{
    const size_t separators = s->unknown_count - s->interior_count;
    const block *pair = s->schur_complement;
    block *to = s->separator_blocks;
    for (uint32_t p = 0; p < s->pair_count; p++, to += 2) {
        to[0] = pair[p];
        block_transpose(&to[1], &pair[p]);
    }
    memcpy(to, pair + s->pair_count, separators * sizeof *to);
    memcpy(s->separator_rhs, s->schur_rhs, separators * sizeof *s->separator_rhs);
}

void vbss_system_back_substitute(vbss_system *s)
{
    for (uint32_t b = 0; b < s->block_count; b++) {
        if (s->roles[b] == VBSS_ROLE_PRESCRIBED) {
            s->solution[b] = vec3_zero();
        }
    }
    vbss_system_back_substitute_interior(s);
}

bool vbss_system_solve(vbss_system *s)
{
    if (!vbss_system_solve_separators(s)) {
        return false;
    }
    vbss_system_back_substitute(s);
    return true;
}

/* ---- line search */

void vbss_system_begin_line_search(vbss_system *s)
{
    memset(s->line_search_increments, 0,
           (s->unknown_count - s->interior_count) * sizeof *s->line_search_increments);
}

void vbss_system_advance_line_search(vbss_system *s, double fraction)
{
    for (uint32_t k = s->interior_count; k < s->unknown_count; k++) {
        vec3 *increment = &s->line_search_increments[k - s->interior_count],
             to = s->solution[s->order[k]];
        *increment = fraction < 1.0 ? vec3_lerp(*increment, to, fraction) : to;
    }
}

void vbss_system_accept_line_search(vbss_system *s)
{
    for (uint32_t k = s->interior_count; k < s->unknown_count; k++) {
        s->solution[s->order[k]] = s->line_search_increments[k - s->interior_count];
    }
}
