/* Static condensation: elimination of the interior blocks by a block LDL^T, and back
 * substitution. */
#include "solver/solver.h"
#include "solver/tuning.h"

/* L D L^T of a symmetric 3x3 block. Returns false if a pivot is too small. */
static bool factor_pivot(const block *b, vbss_pivot *pivot)
{
    double m00 = lanes_at(b->column[0], 0), m10 = lanes_at(b->column[0], 1);
    double m20 = lanes_at(b->column[0], 2), m11 = lanes_at(b->column[1], 1);
    double m21 = lanes_at(b->column[1], 2), m22 = lanes_at(b->column[2], 2);
    /* The comparisons fail for NaN, and no division is by zero. */
    if (!(m00 >= DBL_MIN && m00 <= DBL_MAX)) {
        return false;
    }
    pivot->inverse[0] = 1.0 / m00;
    pivot->l10 = m10 * pivot->inverse[0];
    pivot->l20 = m20 * pivot->inverse[0];
    double d1 = m11 - pivot->l10 * m10;
    if (!(d1 >= DBL_MIN && d1 > SOLVER_MIN_PIVOT_RATIO * m11)) {
        return false;
    }
    double e21 = m21 - pivot->l20 * m10;
    pivot->inverse[1] = 1.0 / d1;
    pivot->l21 = e21 * pivot->inverse[1];
    double d2 = m22 - pivot->l20 * m20 - pivot->l21 * e21;
    if (!(d2 >= DBL_MIN && d2 > SOLVER_MIN_PIVOT_RATIO * m22)) {
        return false;
    }
    pivot->inverse[2] = 1.0 / d2;
    return true;
}

/* a - s0 v0 - s1 v1 - s2 v2, from left to right */
static inline lanes minus_three(lanes a, lanes s0, lanes v0, lanes s1, lanes v1, lanes s2, lanes v2)
{
    a = lanes_sub(a, lanes_times(s0, v0));
    a = lanes_sub(a, lanes_times(s1, v1));
    return lanes_sub(a, lanes_times(s2, v2));
}

/* Updates the block in the row and column of two entries: to -= left scaled^T, with left = A L^-T
 * of one row and scaled = A L^-T D^-1 of the other. */
static inline void subtract_product(block *to, const block_broadcast *left, const block *scaled)
{
    lanes a = scaled->column[0], b = scaled->column[1], c = scaled->column[2];
    for (int i = 0; i < 3; i++) {
        to->column[i] =
            minus_three(to->column[i], left->m[0][i], a, left->m[1][i], b, left->m[2][i], c);
    }
}

static void scale_entry(block *left, block *scaled, const vbss_pivot *p)
{
    lanes c0 = left->column[0];
    lanes c1 = lanes_sub(left->column[1], lanes_scale(p->l10, c0));
    lanes c2 = lanes_sub(left->column[2], lanes_scale(p->l20, c0));
    c2 = lanes_sub(c2, lanes_scale(p->l21, c1));
    left->column[1] = c1;
    left->column[2] = c2;
    scaled->column[0] = lanes_scale(p->inverse[0], c0);
    scaled->column[1] = lanes_scale(p->inverse[1], c1);
    scaled->column[2] = lanes_scale(p->inverse[2], c2);
}

static vec3 reduce_rhs(vec3 y, const vbss_pivot *p)
{
    y.y -= p->l10 * y.x;
    y.z -= p->l20 * y.x;
    y.z -= p->l21 * y.y;
    return y;
}

/* Subtracts the contribution of the eliminated y from a later right-hand side. */
static inline void subtract_rhs(vec3 *rhs, const block *scaled, vec3 y)
{
    lanes r = minus_three(lanes_from(*rhs), lanes_splat(y.x), scaled->column[0], lanes_splat(y.y),
                          scaled->column[1], lanes_splat(y.z), scaled->column[2]);
    *rhs = lanes_vec3(r);
}

static inline void condense_rhs_column(vbss_system *s, uint32_t k)
{
    vbss_pivot *pivot = &s->pivots[k];
    pivot->y = reduce_rhs(s->rhs[s->order[k]], pivot);
    for (uint32_t e = s->column_start[k]; e < s->column_start[k + 1]; e++) {
        subtract_rhs(&s->rhs[s->order[s->entries[e].row]], &s->scaled[e], pivot->y);
    }
}

bool VBSS_WIDE_NAME(vbss_system_condense)(vbss_system *s)
{
    for (uint32_t k = 0; k < s->interior_count; k++) {
        uint32_t b = s->order[k];
        vbss_pivot *pivot = &s->pivots[k];
        if (s->chain_reuses_factor[s->chain_of[b]]) {
            condense_rhs_column(s, k);
            continue;
        }
        if (!factor_pivot(&s->diagonal[b], pivot)) {
            s->tiny_pivots++;
            return false;
        }
        pivot->y = reduce_rhs(s->rhs[b], pivot);

        const vbss_entry *begin = s->entries + s->column_start[k];
        const vbss_entry *end = s->entries + s->column_start[k + 1];
        const uint32_t *product = s->products + s->product_start[k];
        block *scaled = s->scaled + s->column_start[k];
        const block *scaled_end = s->scaled + s->column_start[k + 1];
        for (const vbss_entry *e = begin; e < end; e++) {
            scale_entry(&s->off_diagonal[e->index], &scaled[e - begin], pivot);
        }
        for (const vbss_entry *q = begin; q < end; q++) {
            /* a copy, because for the compiler the blocks changed below could alias it */
            const block_broadcast left = block_make_broadcast(&s->off_diagonal[q->index]);
            uint32_t row = s->order[q->row];
            const block *z = &scaled[q - begin];
            subtract_product(&s->diagonal[row], &left, z);
            subtract_rhs(&s->rhs[row], z, pivot->y);
            for (const block *p = z + 1; p < scaled_end; p++) {
                subtract_product(&s->off_diagonal[*product++], &left, p);
            }
        }
    }
    return true;
}

void VBSS_WIDE_NAME(vbss_system_condense_rhs)(vbss_system *s)
{
    for (uint32_t k = 0; k < s->interior_count; k++) {
        condense_rhs_column(s, k);
    }
}

static inline double dot_lanes(lanes a, vec3 b)
{
    return lanes_at(a, 0) * b.x + lanes_at(a, 1) * b.y + lanes_at(a, 2) * b.z;
}

/* Increments of the interior blocks in reverse order of elimination; needs those of the
 * separators. */
void VBSS_WIDE_NAME(vbss_system_back_substitute_interior)(vbss_system *s)
{
    for (uint32_t k = s->interior_count; k > 0; k--) {
        const vbss_pivot *p = &s->pivots[k - 1];
        vec3 x = vec3_make(p->y.x * p->inverse[0], p->y.y * p->inverse[1], p->y.z * p->inverse[2]);
        for (uint32_t e = s->column_start[k - 1]; e < s->column_start[k]; e++) {
            const block *z = &s->scaled[e];
            vec3 later = s->solution[s->order[s->entries[e].row]];
            x.x -= dot_lanes(z->column[0], later);
            x.y -= dot_lanes(z->column[1], later);
            x.z -= dot_lanes(z->column[2], later);
        }
        x.y -= p->l21 * x.z;
        x.x -= p->l10 * x.y + p->l20 * x.z;
        s->solution[s->order[k - 1]] = x;
    }
}
