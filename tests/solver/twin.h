/* A random system and its pattern, written both into the library's system and into the plain one. */
#ifndef VBSS_TESTS_TWIN_H
#define VBSS_TESTS_TWIN_H

#include "harness/harness.h"
#include "solver/plain_solve.h"
#include "solver/solver.h"

enum { TWIN_BLOCKS = 300, TWIN_COUPLINGS = 1000 };

typedef enum twin_roles {
    TWIN_RUNS,       /* everything condensed */
    TWIN_SCATTERED,  /* separators here and there, also narrower than the reach */
    TWIN_GROUPS,     /* of adjacent separators, as wide as the reach or wider */
    TWIN_GIVEN,      /* given blocks here and there */
    TWIN_SEPARATORS, /* nothing else */
    TWIN_ALL_GIVEN,
    TWIN_MIXED
} twin_roles;

typedef struct twin_coupling {
    uint32_t high, low;
    bool swapped; /* registered as (low, high) */
    mat3 m;       /* rows of high, columns of low */
    uint32_t handle;
} twin_coupling;

typedef struct twin {
    uint32_t blocks, reach, chains, couplings;
    uint32_t chain_end[4];
    bool keeps_order[4];
    vbss_role roles[TWIN_BLOCKS];
    mat3 diagonal[TWIN_BLOCKS];
    vec3 rhs[TWIN_BLOCKS];
    twin_coupling coupling[TWIN_COUPLINGS];
    double mass; /* the least a diagonal has */

    harness_memory memory;
    vbss_context *context;
    vbss_system *system;
    plain_system plain;
    double x[3 * TWIN_BLOCKS], wanted[3 * TWIN_BLOCKS];
} twin;

/* 1 .. most blocks in 1 .. 4 chains, reach 1 .. 3. */
void twin_draw_chains(twin *t, harness_source *source, uint32_t limit);
void twin_draw_roles(twin *t, harness_source *source, twin_roles kind);
/* Couplings within the reach (a few left out), and symmetric positive definite numbers. */
void twin_draw_numbers(twin *t, harness_source *source);
/* Of elements between two blocks: g g^T with the rows of both. */
void twin_add_element(twin *t, uint32_t c, vec3 of_high, vec3 of_low);

uint32_t twin_separators(const twin *t);
/* Whether runs are coupled past separators: then their columns meet more than the documented room
 * is for. */
bool twin_is_narrow(const twin *t);

/* The library's system with just the documented room, more where that is too little; or with room
 * for so much. */
void twin_begin(twin *t);
void twin_begin_with(twin *t, uint32_t blocks, uint32_t reach, uint32_t separators);
void twin_end(twin *t);
vbss_result twin_register(twin *t);
/* The numbers, after a clear. */
void twin_write(twin *t);
void twin_write_plain(twin *t);
/* Of separators, after a take: the block in a row and a column, which must be there; the right-hand side. */
block *twin_block(twin *t, uint32_t row, uint32_t column);
vec3 *twin_rhs(twin *t, uint32_t row);
/* Everything from condense on; the increments to x. */
bool twin_solve(twin *t);
/* Writes, solves, and compares with the plain band solve. */
void twin_compare(twin *t);

#endif
