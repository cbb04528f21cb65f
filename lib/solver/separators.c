/* The small system of the separators: a block LU in place, pivoting inside blocks only. */
#include "solver/solver.h"

/* A pivot below this share of its block's largest number has lost its digits. */
#define SMALLEST_PIVOT 1e-15

/* ---- 3x3 with row exchanges */

typedef struct pivoted {
    double m[3][3]; /* L below the diagonal, U on and above */
    int row[3];     /* where each row came from */
} pivoted;

static bool factor(const mat3 *a, pivoted *p)
{
    double largest = 0.0;
    for (int i = 0; i < 3; i++) {
        p->row[i] = i;
        for (int j = 0; j < 3; j++) {
            p->m[i][j] = a->m[i][j];
            largest = fabs(a->m[i][j]) > largest ? fabs(a->m[i][j]) : largest;
        }
    }
    for (int k = 0; k < 3; k++) {
        int best = k;
        for (int i = k + 1; i < 3; i++) {
            best = fabs(p->m[i][k]) > fabs(p->m[best][k]) ? i : best;
        }
        for (int j = 0; j < 3; j++) {
            double kept = p->m[k][j];
            p->m[k][j] = p->m[best][j];
            p->m[best][j] = kept;
        }
        int kept = p->row[k];
        p->row[k] = p->row[best];
        p->row[best] = kept;
        if (!(fabs(p->m[k][k]) > SMALLEST_PIVOT * largest)) { /* NaN fails */
            return false;
        }
        for (int i = k + 1; i < 3; i++) {
            p->m[i][k] /= p->m[k][k];
            for (int j = k + 1; j < 3; j++) {
                p->m[i][j] -= p->m[i][k] * p->m[k][j];
            }
        }
    }
    return true;
}

static vec3 solve(const pivoted *p, vec3 b)
{
    const double in[3] = {b.x, b.y, b.z};
    double y0 = in[p->row[0]];
    double y1 = in[p->row[1]] - p->m[1][0] * y0;
    double y2 = in[p->row[2]] - p->m[2][0] * y0 - p->m[2][1] * y1;
    double z = y2 / p->m[2][2];
    double y = (y1 - p->m[1][2] * z) / p->m[1][1];
    double x = (y0 - p->m[0][1] * y - p->m[0][2] * z) / p->m[0][0];
    return vec3_make(x, y, z);
}

static mat3 solve_columns(const pivoted *p, const mat3 *b)
{
    mat3 t = mat3_transpose(*b);
    return mat3_transpose(mat3_rows(solve(p, vec3_load(t.m[0])), solve(p, vec3_load(t.m[1])),
                                    solve(p, vec3_load(t.m[2]))));
}

/* ---- the system: separators by position, pairs by entry */

static uint32_t pair_of(const vbss_system *s, uint32_t entry)
{
    return entry - s->separator_first_entry;
}

void vbss_system_take_separators(vbss_system *s)
{
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        s->separator_diagonal[k - s->run_count] = block_mat3(&s->diagonal[s->order[k]]);
        s->separator_rhs[k - s->run_count] = s->rhs[s->order[k]];
        for (uint32_t e = s->column_start[k]; e < s->column_start[k + 1]; e++) {
            mat3 lower = block_mat3(&s->numbers[s->entries[e].index]);
            s->separator_lower[pair_of(s, e)] = lower;
            s->separator_upper[pair_of(s, e)] = mat3_transpose(lower);
        }
    }
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

/* The block in a row and a column, both positions; NULL for what is not in the pattern. */
static mat3 *block_at(vbss_system *s, uint32_t row, uint32_t column)
{
    if (row == column) {
        return &s->separator_diagonal[row - s->run_count];
    }
    uint32_t entry = row > column ? find(s, row, column) : find(s, column, row);
    if (entry == UINT32_MAX) {
        return NULL;
    }
    uint32_t pair = pair_of(s, entry);
    return row > column ? &s->separator_lower[pair] : &s->separator_upper[pair];
}

mat3 *vbss_system_separator_block(vbss_system *s, uint32_t a, uint32_t b)
{
    bool both = s->roles[a] == VBSS_ROLE_SEPARATOR && s->roles[b] == VBSS_ROLE_SEPARATOR;
    return both ? block_at(s, s->place[a], s->place[b]) : NULL;
}

vec3 *vbss_system_separator_rhs(vbss_system *s, uint32_t a)
{
    return s->roles[a] == VBSS_ROLE_SEPARATOR ? &s->separator_rhs[s->place[a] - s->run_count]
                                              : NULL;
}

/* Eliminates one separator: later rows -= lower D^-1 (upper | rhs). What stays: D^-1 upper in the
 * place of upper, D^-1 rhs in the solution's. */
static bool eliminate(vbss_system *s, uint32_t k)
{
    pivoted d;
    if (!factor(&s->separator_diagonal[k - s->run_count], &d)) {
        s->tiny_pivots++;
        return false;
    }
    vec3 y = solve(&d, s->separator_rhs[k - s->run_count]);
    s->solution[s->order[k]] = y;
    uint32_t begin = s->column_start[k], end = s->column_start[k + 1];
    for (uint32_t q = begin; q < end; q++) {
        mat3 *upper = &s->separator_upper[pair_of(s, q)];
        *upper = solve_columns(&d, upper);
    }
    for (uint32_t p = begin; p < end; p++) {
        const mat3 lower = s->separator_lower[pair_of(s, p)];
        uint32_t row = s->entries[p].row;
        vec3 *rhs = &s->separator_rhs[row - s->run_count];
        *rhs = vec3_sub(*rhs, mat3_mul_vec3(lower, y));
        for (uint32_t q = begin; q < end; q++) {
            mat3 *to = block_at(s, row, s->entries[q].row); /* fill: always there */
            *to = mat3_sub(*to, mat3_mul(lower, s->separator_upper[pair_of(s, q)]));
        }
    }
    return true;
}

bool vbss_system_solve(vbss_system *s)
{
    for (uint32_t k = s->run_count; k < s->active_count; k++) {
        if (!eliminate(s, k)) {
            return false;
        }
    }
    for (uint32_t b = 0; b < s->block_count; b++) {
        if (s->roles[b] == VBSS_ROLE_GIVEN) {
            s->solution[b] = vec3_zero();
        }
    }
    for (uint32_t k = s->active_count; k > s->run_count; k--) {
        vec3 *x = &s->solution[s->order[k - 1]];
        for (uint32_t e = s->column_start[k - 1]; e < s->column_start[k]; e++) {
            vec3 later = s->solution[s->order[s->entries[e].row]];
            *x = vec3_sub(*x, mat3_mul_vec3(s->separator_upper[pair_of(s, e)], later));
        }
    }
    vbss_system_return_to_runs(s);
    return true;
}
