/* Block LU of the separators, and its back substitution.
 *
 * The factor is left-looking: each column is computed from its working blocks and the earlier
 * columns. Pivoting is inside blocks only. */
#include "solver/solver.h"
#include "solver/tuning.h"

/* ---- 3x3 LU with row exchanges */

typedef struct pivoted_lu {
    double l10, l20, l21, u01, u02, u12;
    double inverse[3]; /* reciprocals of U's diagonal */
    int row[3];        /* original index of each row */
} pivoted_lu;

static inline double largest_of(const block *a)
{
    lanes largest = lanes_max(lanes_abs(a->column[0]), lanes_abs(a->column[1]));
    largest = lanes_max(largest, lanes_abs(a->column[2]));
    double x = lanes_at(largest, 0), y = lanes_at(largest, 1), z = lanes_at(largest, 2);
    double xy = x > y ? x : y;
    return xy > z ? xy : z;
}

/* Rows i, j, k: the first column selects i, the rest of the second column selects between j and k.
 * The comparisons fail for NaN. */
static bool factor_pivot(const block *a, pivoted_lu *p)
{
    double smallest = SOLVER_MIN_PIVOT_RATIO * largest_of(a), c0[LANES], c1[LANES], c2[LANES];
    lanes_store(c0, a->column[0]);
    lanes_store(c1, a->column[1]);
    lanes_store(c2, a->column[2]);
    int i = fabs(c0[1]) > fabs(c0[0]) ? 1 : 0;
    i = fabs(c0[2]) > fabs(c0[i]) ? 2 : i;
    int j = i == 1 ? 0 : 1, k = i == 2 ? 0 : 2;
    if (!(fabs(c0[i]) > smallest)) {
        return false;
    }
    p->inverse[0] = 1.0 / c0[i];
    p->u01 = c1[i];
    p->u02 = c2[i];
    double lj = c0[j] * p->inverse[0], lk = c0[k] * p->inverse[0];
    double j1 = c1[j] - lj * p->u01, k1 = c1[k] - lk * p->u01;
    double j2 = c2[j] - lj * p->u02, k2 = c2[k] - lk * p->u02;
    bool exchanged = fabs(k1) > fabs(j1);
    double u11 = exchanged ? k1 : j1;
    if (!(fabs(u11) > smallest)) {
        return false;
    }
    p->inverse[1] = 1.0 / u11;
    p->u12 = exchanged ? k2 : j2;
    p->l10 = exchanged ? lk : lj;
    p->l20 = exchanged ? lj : lk;
    p->l21 = (exchanged ? j1 : k1) * p->inverse[1];
    double u22 = (exchanged ? j2 : k2) - p->l21 * p->u12;
    if (!(fabs(u22) > smallest)) {
        return false;
    }
    p->inverse[2] = 1.0 / u22;
    p->row[0] = i;
    p->row[1] = exchanged ? k : j;
    p->row[2] = exchanged ? j : k;
    return true;
}

/* Multiplies the rows of a block by D^-1; each row is one lanes. */
static inline void solve_rows(const pivoted_lu *p, block *rows)
{
    lanes y0 = rows->column[p->row[0]];
    lanes y1 = lanes_sub(rows->column[p->row[1]], lanes_scale(p->l10, y0));
    lanes y2 = lanes_sub(rows->column[p->row[2]], lanes_scale(p->l20, y0));
    lanes z = lanes_scale(p->inverse[2], lanes_sub(y2, lanes_scale(p->l21, y1)));
    lanes y = lanes_scale(p->inverse[1], lanes_sub(y1, lanes_scale(p->u12, z)));
    lanes x = lanes_sub(y0, lanes_scale(p->u01, y));
    rows->column[0] = lanes_scale(p->inverse[0], lanes_sub(x, lanes_scale(p->u02, z)));
    rows->column[1] = y;
    rows->column[2] = z;
}

static inline lanes solve_vector(const pivoted_lu *p, lanes b)
{
    double in[LANES];
    lanes_store(in, b);
    double y0 = in[p->row[0]];
    double y1 = in[p->row[1]] - p->l10 * y0;
    double y2 = in[p->row[2]] - p->l20 * y0 - p->l21 * y1;
    double z = y2 * p->inverse[2];
    double y = (y1 - p->u12 * z) * p->inverse[1];
    double x = (y0 - p->u01 * y - p->u02 * z) * p->inverse[0];
    return lanes_make(x, y, z);
}

/* ---- products */

/* to -= from f: column i of from times f->m[i][j] is subtracted from column j of to */
static inline void subtract_product(block *to, const block *from, const block_broadcast *f)
{
    lanes a = from->column[0], b = from->column[1], c = from->column[2];
    for (int j = 0; j < 3; j++) {
        lanes t = lanes_sub(to->column[j], lanes_times(f->m[0][j], a));
        t = lanes_sub(t, lanes_times(f->m[1][j], b));
        to->column[j] = lanes_sub(t, lanes_times(f->m[2][j], c));
    }
}

/* to -= from v, with from stored by columns */
static inline lanes minus_times(lanes to, const block *from, lanes v)
{
    to = lanes_sub(to, lanes_scale(lanes_at(v, 0), from->column[0]));
    to = lanes_sub(to, lanes_scale(lanes_at(v, 1), from->column[1]));
    return lanes_sub(to, lanes_scale(lanes_at(v, 2), from->column[2]));
}

/* ---- a column */

/* Copies lane by lane: compilers copy whole blocks in halves of lanes, and the next load of a whole
 * lane then has to wait. */
static inline void copy_block(block *to, const block *from)
{
    for (int i = 0; i < 3; i++) {
        to->column[i] = from->column[i];
    }
}

/* Fills the column with the working blocks, and with zero where elimination will fill. */
static void load_column(const vbss_system *s, vbss_elimination *e, uint32_t k)
{
    for (uint32_t f = e->column_start[k]; f < e->column_start[k + 1]; f++) {
        e->entry_of_row[e->rows[f]] = f;
        for (int i = 0; i < 3; i++) {
            e->lower[f].column[i] = e->upper[f].column[i] = lanes_splat(0.0);
        }
    }
    for (uint32_t p = e->pair_start[k]; p < e->pair_start[k + 1]; p++) {
        uint32_t f = e->entry_of_row[e->pairs[p].row];
        copy_block(&e->lower[f], &s->separator_blocks[e->pairs[p].schur_index]);
        block_transpose(&e->upper[f], &s->separator_blocks[e->pairs[p].schur_index ^ 1u]);
    }
}

/* Updates column k of L and row k of U by an earlier column. `from` is that column's first entry
 * after its entry in row k. */
static void subtract_column(vbss_elimination *e, uint32_t from, uint32_t end)
{
    const block_broadcast below = block_make_broadcast(&e->upper[from - 1]);
    for (uint32_t f = from; f < end; f++) {
        subtract_product(&e->lower[e->entry_of_row[e->rows[f]]], &e->lower[f], &below);
    }
    const block_broadcast right = block_make_broadcast(&e->lower[from - 1]);
    for (uint32_t f = from; f < end; f++) {
        subtract_product(&e->upper[e->entry_of_row[e->rows[f]]], &e->upper[f], &right);
    }
}

static bool factor_column(const vbss_system *s, vbss_elimination *e, uint32_t k)
{
    uint32_t separator = e->order[k];
    block diagonal;
    copy_block(&diagonal, &s->separator_blocks[2 * s->pair_count + separator]);
    lanes rhs = lanes_from(s->separator_rhs[separator]);
    load_column(s, e, k);
    for (uint32_t r = e->row_start[k]; r < e->row_start[k + 1]; r++) {
        uint32_t column = e->row_entries[r].column, f = e->row_entries[r].entry;
        const block_broadcast u = block_make_broadcast(&e->upper[f]);
        subtract_product(&diagonal, &e->lower[f], &u);
        rhs = minus_times(rhs, &e->lower[f], e->x[column]);
        subtract_column(e, f + 1, e->column_start[column + 1]);
    }
    pivoted_lu p;
    if (!factor_pivot(&diagonal, &p)) {
        return false;
    }
    e->x[k] = solve_vector(&p, rhs);
    for (uint32_t f = e->column_start[k]; f < e->column_start[k + 1]; f++) {
        solve_rows(&p, &e->upper[f]);
    }
    return true;
}

/* ---- the whole factor */

/* Sums products lane by lane and adds the lanes in one written order at the end. */
static lanes back_substitute(const vbss_elimination *e, uint32_t k)
{
    lanes sums[3] = {lanes_splat(0.0), lanes_splat(0.0), lanes_splat(0.0)};
    for (uint32_t f = e->column_start[k]; f < e->column_start[k + 1]; f++) {
        lanes later = e->x[e->rows[f]];
        for (int i = 0; i < 3; i++) {
            sums[i] = lanes_add(sums[i], lanes_times(e->upper[f].column[i], later));
        }
    }
    double total[3];
    for (int i = 0; i < 3; i++) {
        total[i] = lanes_at(sums[i], 0) + lanes_at(sums[i], 1) + lanes_at(sums[i], 2);
    }
    return lanes_sub(e->x[k], lanes_make(total[0], total[1], total[2]));
}

bool VBSS_WIDE_NAME(vbss_system_solve_separators)(vbss_system *s)
{
    vbss_elimination *e = &s->elimination;
    uint32_t count = s->unknown_count - s->interior_count;
    for (uint32_t k = 0; k < count; k++) {
        if (!factor_column(s, e, k)) {
            s->tiny_pivots++;
            return false;
        }
    }
    for (uint32_t k = count; k > 0; k--) {
        e->x[k - 1] = back_substitute(e, k - 1);
        s->solution[s->order[s->interior_count + e->order[k - 1]]] = lanes_vec3(e->x[k - 1]);
    }
    return true;
}
