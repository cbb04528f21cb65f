/* The system: one linear system for all bodies and contacts of a step, and the time integration.
 *
 * Unknowns are 3x3 blocks. A body registers a chain of blocks and which of them are coupled; what it
 * adds is symmetric. Blocks in which nothing else takes part are *condensed*: eliminated once a
 * linearisation by a block LDL^T. What others take part in are *separators*: the small system that
 * is left for them is factorised by a block LU, may be unsymmetric, and may change while the
 * condensed runs stay. Knows no suture.
 *
 * One way through, each arrow a function:
 *   pattern:  begin -> add_chain, couple, set_role -> analyse
 *   numbers:  clear -> (bodies set) -> condense -> take_separators -> (contacts add) -> solve
 * Nothing here allocates after vbss_system_create; nothing survives a step that is not rebuilt. */
#ifndef VBSS_SOLVER_SOLVER_H
#define VBSS_SOLVER_SOLVER_H

#include "base/base.h"
#include "base/wide.h"
#include "solver/block.h"

/* ---- time integration (integration.c)
 *
 * Generalised alpha (Chung, Hulbert 1993) with the forces of both ends of the step, one unknown a
 * node: x at the end. With q the acceleration that balances the forces there,
 *   x = x_predicted + q / inertia,   v = v_predicted + rate (x - x_predicted),
 *   a = a_predicted + follow (x - x_predicted).
 * Backward Euler is a member of the family with other numbers. */
typedef struct vbss_integration {
    double h;
    double inertia;                      /* 1/s^2 */
    double rate;                         /* 1/s */
    double follow;                       /* 1/s^2 */
    double x_a, x_q, v_a, v_q, a_a, a_q; /* predictions: factors of the old a and q */
} vbss_integration;
vbss_integration vbss_integration_generalised_alpha(double h, double spectral_radius);
vbss_integration vbss_integration_backward_euler(double h);
/* Below this, speeds (m/s) and accelerations (m/s^2) become zero: subnormal numbers cost time. */
#define VBSS_STILL 1e-30
/* Numbers one behind the other, three a node. Predictions from the state at the begin; and what follows
 * for v, a and q once the positions at the end are found. The arrays do not overlap. */
void vbss_integration_predict(const vbss_integration *integration, size_t count, const double *x,
                              const double *v, const double *a, const double *q,
                              double *x_predicted, double *v_predicted, double *a_predicted);
void vbss_integration_follow(const vbss_integration *integration, size_t count, const double *x,
                             const double *x_predicted, const double *v_predicted,
                             const double *a_predicted, double *v, double *a, double *q);

/* ---- the system */

typedef enum vbss_role {
    VBSS_ROLE_RUN,       /* condensed */
    VBSS_ROLE_SEPARATOR, /* in the small system */
    VBSS_ROLE_GIVEN /* moves as somebody else says: its increment is zero, it has no equation */
} vbss_role;

/* The coupling that swallows what is added to it: of a given block, or of none. */
#define VBSS_NO_COUPLING 0u

/* An entry of the factor: the block in row `row` of a column, both counted in elimination order. */
typedef struct vbss_entry {
    uint32_t row;
    uint32_t index; /* of its numbers */
} vbss_entry;

/* Where a coupling's numbers stand: as the body sees them, or the other way round. */
typedef struct vbss_coupling {
    uint32_t high, low; /* the blocks, high > low */
    uint32_t flipped;   /* the low block is eliminated later */
    uint32_t next;      /* in the list of its column, while analysing */
} vbss_coupling;

/* A diagonal block as L D L^T. */
typedef struct vbss_pivot {
    double l10, l20, l21;
    double inverse[3]; /* of D */
    vec3 y;            /* right-hand side after elimination of what came before, L^-1 of it */
} vbss_pivot;

typedef struct vbss_system {
    vbss_context *context;
    uint32_t block_capacity, coupling_capacity, separator_capacity, pair_capacity, entry_capacity,
        product_capacity;

    /* registered */
    uint32_t block_count, coupling_count, chain_count;
    uint8_t *roles;
    vbss_coupling *couplings; /* from 1 on */
    uint32_t *chain_ends;     /* first block after each chain */

    /* analysed; positions count in elimination order, runs first */
    uint32_t run_count, active_count, entry_count, fill_count;
    uint32_t *order;        /* position -> block */
    uint32_t *place;        /* block -> position */
    uint32_t *column_start; /* position -> first entry of its column; one more at the end */
    vbss_entry *entries;
    uint32_t *product_start; /* run position -> first of its products */
    uint32_t *products;      /* numbers that a pair of a column's entries changes */
    uint32_t *marks, *lists; /* scratch of analyse */

    /* numbers; block b's diagonal and right-hand side, coupling c's block */
    block *diagonal;
    block *numbers; /* couplings, then fill; of couplings, column = what is eliminated first */
    block *scaled;  /* the same of the factor, times D^-1 */
    vec3 *rhs;
    vec3 *solution; /* increments; zero for given blocks */
    vbss_pivot *pivots;

    /* the separators' system: diagonals, and both blocks of each pair */
    mat3 *separator_diagonal, *separator_lower, *separator_upper;
    vec3 *separator_rhs;
    uint32_t separator_first_entry;
    uint64_t tiny_pivots; /* met so far: each one a solve that failed */
    bool wide;            /* hot loops with AVX2 */
} vbss_system;

/* Room for chains of `blocks` blocks in all, coupled to `reach` neighbours on either side, of which
 * `separators` may be separators, with `pairs` of them coupled or filled in. Separators come in groups
 * of at least `reach` neighbours: past a narrower one a run is coupled with the next, and what it fills
 * in may not find room. */
vbss_result vbss_system_create(vbss_context *context, uint32_t blocks, uint32_t reach,
                               uint32_t separators, uint32_t pairs, vbss_system **system);
void vbss_system_destroy(vbss_context *context, vbss_system *system);

/* The pattern. Beyond the capacity is VBSS_ERROR_CAPACITY. */
void vbss_system_begin(vbss_system *system);
vbss_result vbss_system_add_chain(vbss_system *system, uint32_t count, uint32_t *first);
void vbss_system_set_role(vbss_system *system, uint32_t block, vbss_role role);
/* Two different blocks; the same pair only once. VBSS_NO_COUPLING when one of them is given, so set
 * the roles first. */
vbss_result vbss_system_couple(vbss_system *system, uint32_t a, uint32_t b, uint32_t *coupling);
vbss_result vbss_system_analyse(vbss_system *system);

/* The numbers. Whoever registered a chain or a coupling sets its diagonals, right-hand sides and
 * numbers in every round; others may add to them afterwards. Diagonals are symmetric. A coupling's
 * block has the rows of the block that is eliminated later: of the higher one unless it is `flipped`;
 * its transpose is meant with it. clear prepares what nobody sets: fill. */
void vbss_system_clear(vbss_system *system);

/* Eliminates the runs. False: a pivot was too small. */
bool vbss_system_condense(vbss_system *system);
/* Copies what condensing left for the separators, where others may add to it. */
void vbss_system_take_separators(vbss_system *system);
/* From take to solve: the block in the row of separator a and the column of b, and the right-hand side
 * of a. NULL for what is not in the pattern, or no separator. */
mat3 *vbss_system_separator_block(vbss_system *system, uint32_t a, uint32_t b);
vec3 *vbss_system_separator_rhs(vbss_system *system, uint32_t a);
/* Factorises the separators' system, in place, and works out all increments. False: a pivot was too
 * small. */
bool vbss_system_solve(vbss_system *system);

/* Both copies of condense.c: elimination of the runs, and for the end of vbss_system_solve the runs'
 * increments from the separators'. */
bool vbss_system_condense_plain(vbss_system *system);
bool vbss_system_condense_wide(vbss_system *system);
void vbss_system_return_to_runs_plain(vbss_system *system);
void vbss_system_return_to_runs_wide(vbss_system *system);
void vbss_system_return_to_runs(vbss_system *system);

#endif
