/* The small system of the separators as others see it: places, and the copy to which they add. */
#include "solver/solver.h"

#include <string.h>

/* ---- places: two for each pair, then the diagonals */

static uint32_t diagonal_place(const vbss_system *s, uint32_t separator)
{
    return 2 * s->pair_count + separator;
}

/* The entry in a row and a column, both positions; UINT32_MAX when there is none. */
static uint32_t find(const vbss_system *s, uint32_t row, uint32_t column)
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

void vbss_system_pair_places(const vbss_system *s, uint32_t a, uint32_t b, uint32_t *ab,
                             uint32_t *ba)
{
    *ab = *ba = VBSS_NO_PLACE;
    if (s->roles[a] != VBSS_ROLE_SEPARATOR || s->roles[b] != VBSS_ROLE_SEPARATOR) {
        return;
    }
    uint32_t i = s->place[a], j = s->place[b];
    if (i == j) {
        *ab = *ba = diagonal_place(s, i - s->run_count);
        return;
    }
    uint32_t entry = i > j ? find(s, i, j) : find(s, j, i);
    if (entry != UINT32_MAX) {
        uint32_t lower = 2 * (entry - s->separator_first_entry);
        *ab = lower + (i < j);
        *ba = lower + (i > j);
    }
}

uint32_t vbss_system_place(const vbss_system *s, uint32_t row, uint32_t column)
{
    uint32_t place, other;
    vbss_system_pair_places(s, row, column, &place, &other);
    return place;
}

uint32_t vbss_system_rhs_place(const vbss_system *s, uint32_t row)
{
    return s->roles[row] == VBSS_ROLE_SEPARATOR ? s->place[row] - s->run_count : VBSS_NO_PLACE;
}

/* ---- the numbers */

void vbss_system_keep_separator_rhs(vbss_system *s)
{
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        s->separator_base_rhs[k - s->run_count] = s->rhs[s->order[k]];
    }
}

void vbss_system_keep_separators(vbss_system *s)
{
    static const block none; /* of pairs that only couple_once coupled */
    vbss_system_keep_separator_rhs(s);
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        s->separator_base[diagonal_place(s, k - s->run_count)] = s->diagonal[s->order[k]];
        for (uint32_t e = s->column_start[k]; e < s->column_start[k + 1]; e++) {
            uint32_t index = s->entries[e].index;
            const block *lower = index != VBSS_NO_COUPLING ? &s->numbers[index] : &none;
            block *pair = &s->separator_base[2 * (size_t)(e - s->separator_first_entry)];
            pair[0] = *lower;
            block_transpose(&pair[1], lower);
        }
    }
}

void vbss_system_take_separators(vbss_system *s)
{
    size_t separators = s->active_count - s->run_count,
           blocks = 2 * (size_t)s->pair_count + separators;
    memcpy(s->separator_blocks, s->separator_base, blocks * sizeof *s->separator_blocks);
    memcpy(s->separator_rhs, s->separator_base_rhs, separators * sizeof *s->separator_rhs);
}

void vbss_system_finish(vbss_system *s)
{
    for (uint32_t b = 0; b < s->block_count; b++) {
        if (s->roles[b] == VBSS_ROLE_GIVEN) {
            s->solution[b] = vec3_zero();
        }
    }
    vbss_system_return_to_runs(s);
}

bool vbss_system_solve(vbss_system *s)
{
    if (!vbss_system_solve_separators(s)) {
        return false;
    }
    vbss_system_finish(s);
    return true;
}

/* ---- a place between solutions */

void vbss_system_begin_way(vbss_system *s)
{
    memset(s->followed, 0, (s->active_count - s->run_count) * sizeof *s->followed);
}

void vbss_system_follow(vbss_system *s, double share)
{
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        vec3 *at = &s->followed[k - s->run_count], to = s->solution[s->order[k]];
        *at = share < 1.0 ? vec3_lerp(*at, to, share) : to;
    }
}

void vbss_system_stop_there(vbss_system *s)
{
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        s->solution[s->order[k]] = s->followed[k - s->run_count];
    }
}
