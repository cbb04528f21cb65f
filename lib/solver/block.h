/* 3x3 blocks of the linear system, stored by columns in SIMD lanes. */
#ifndef VBSS_SOLVER_BLOCK_H
#define VBSS_SOLVER_BLOCK_H

#include "base/lanes.h"

/* A 3x3 matrix: column[c] holds the rows of column c. The fourth lane is padding and stays zero. */
typedef struct block {
    lanes column[3];
} block;

static inline mat3 block_mat3(const block *b)
{
    mat3 m;
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            m.m[r][c] = lanes_at(b->column[c], r);
        }
    }
    return m;
}

static inline void block_set(block *b, mat3 m)
{
    for (int c = 0; c < 3; c++) {
        b->column[c] = lanes_from(vec3_make(m.m[0][c], m.m[1][c], m.m[2][c]));
    }
}

/* *to = *from transposed; they must not be the same block. */
static inline void block_transpose(block *to, const block *from)
{
    for (int i = 0; i < 3; i++) {
        to->column[i] = lanes_make(lanes_at(from->column[0], i), lanes_at(from->column[1], i),
                                   lanes_at(from->column[2], i));
    }
}

/* b += m */
static inline void block_add(block *b, mat3 m)
{
    for (int c = 0; c < 3; c++) {
        lanes add = lanes_from(vec3_make(m.m[0][c], m.m[1][c], m.m[2][c]));
        b->column[c] = lanes_add(b->column[c], add);
    }
}

/* A block for products: m[c][r] is entry (r, c) of the block in all four lanes. */
typedef struct block_broadcast {
    lanes m[3][3];
} block_broadcast;

static inline block_broadcast block_make_broadcast(const block *b)
{
    block_broadcast f;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            f.m[i][j] = lanes_splat(lanes_at(b->column[i], j));
        }
    }
    return f;
}

#endif
