/* The system: one linear system for all bodies and contacts of a step, and the time integration.
 *
 * Unknowns are 3x3 blocks. A body registers a chain of blocks and which of them are coupled; what it
 * adds is symmetric. Blocks in which nothing else takes part are *condensed*: eliminated once a
 * linearisation by a block LDL^T. What others take part in are *separators*: the small system that
 * is left for them is factorised by a block LU, may be unsymmetric, and may change while the
 * condensed runs stay. Knows no suture.
 *
 * One way through, each arrow a function:
 *   pattern:  begin -> add_chain, set_role, couple, couple_once -> analyse -> (places asked for)
 *             begin_again -> couple_once -> analyse -> (places asked for)
 *   numbers:  clear -> (bodies set) -> condense -> take_separators -> (contacts add) -> solve
 * where take_separators -> (contacts add) -> solve_separators may go round as often as the contacts need,
 * and finish then gives the runs their increments: solve is solve_separators and finish.
 * Nothing here allocates after vbss_system_create; nothing survives a step that is not rebuilt. */
#ifndef VBSS_SOLVER_SOLVER_H
#define VBSS_SOLVER_SOLVER_H

#include <stddef.h>

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "base/simd_dispatch.h"
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
    double velocity_factor;              /* 1/s */
    double acceleration_factor;          /* 1/s^2 */
    double x_a, x_q, v_a, v_q, a_a, a_q; /* predictions: factors of the old a and q */
} vbss_integration;
vbss_integration vbss_integration_generalised_alpha(double h, double spectral_radius);
vbss_integration vbss_integration_backward_euler(double h);
/* Below this, speeds (m/s) and accelerations (m/s^2) become zero: subnormal numbers cost time. */
#define VBSS_FLUSH_THRESHOLD 1e-30
/* Numbers one behind the other, three a node. Predictions from the state at the begin; and what follows
 * for v, a and q once the positions at the end are found. The arrays do not overlap. */
void vbss_integration_predict(const vbss_integration *integration, size_t count, const double *x,
                              const double *v, const double *a, const double *q,
                              double *x_predicted, double *v_predicted, double *a_predicted);
void vbss_integration_correct(const vbss_integration *integration, size_t count, const double *x,
                              const double *x_predicted, const double *v_predicted,
                              const double *a_predicted, double *v, double *a, double *q);

/* ---- explicit methods, those of VBLaST-SS (explicit_substeps.c, relative_damping.c) */

/* In how many equal parts a step h is made, if they are stable up to 1 / sqrt(rate). */
uint32_t vbss_explicit_substep_count(double h, double rate);
/* v <- v - share (v - rigid motion), nodes first .. last; mass 0 has no part in that motion. */
void vbss_damp_relative_motion(const double *mass, const vec3 *x, vec3 *v, uint32_t first,
                               uint32_t last, double fraction);

/* ---- the system */

typedef enum vbss_role {
    VBSS_ROLE_INTERIOR,  /* condensed */
    VBSS_ROLE_SEPARATOR, /* in the small system */
    VBSS_ROLE_PRESCRIBED /* moves as somebody else says: its increment is zero, it has no equation */
} vbss_role;

/* The coupling that swallows what is added to it: of a given block, or of none. */
#define VBSS_NO_COUPLING 0u
/* Where nothing stands: no separator, or not in the pattern. */
#define VBSS_NO_INDEX UINT32_MAX

/* An entry of the factor: the block in row `row` of a column, both counted in elimination order. */
typedef struct vbss_entry {
    uint32_t row;
    uint32_t index; /* of its numbers */
} vbss_entry;

/* Where a coupling's numbers stand: as the body sees them, or the other way round. */
typedef struct vbss_coupling {
    uint32_t high, low;     /* the blocks, high > low */
    uint32_t is_transposed; /* the low block is eliminated later */
    uint32_t next;          /* in the list of its column, while analysing */
} vbss_coupling;

/* A diagonal block as L D L^T. */
typedef struct vbss_pivot {
    double l10, l20, l21;
    double inverse[3]; /* of D */
    vec3 y;            /* right-hand side after elimination of what came before, L^-1 of it */
} vbss_pivot;

/* An entry of the separators' factor, seen from its row. */
typedef struct vbss_row_entry {
    uint32_t column, entry;
} vbss_row_entry;

/* A pair of the pattern: its later row, and the place of the block in that row. */
typedef struct vbss_pair {
    uint32_t row, schur_index;
} vbss_pair;

/* Neighbours of a separator that are left, and those of them that an elimination joined last. */
typedef struct vbss_degree {
    uint32_t neighbours, joined;
} vbss_degree;

/* Elimination of the separators, in an order of its own. Separators count by block number, positions in
 * this order, both from 0 on. */
typedef struct vbss_elimination {
    uint32_t *order;             /* position -> separator */
    uint32_t *position;          /* separator -> position */
    uint32_t *column_start;      /* position -> first entry of its column; one more at the end */
    uint32_t *rows;              /* of entries: positions, ascending in a column */
    uint32_t *row_start;         /* position -> first entry of its row; one more at the end */
    vbss_row_entry *row_entries; /* entries by rows, columns ascending */
    uint32_t *pair_start;        /* position -> first pair of its column; one more at the end */
    vbss_pair *pairs;            /* what is not filled in */
    block *lower, *upper;        /* entries of L with the pivots, and of U without, transposed */
    uint64_t product_count;      /* of blocks, for all entries of L and U */
    lanes *x;                    /* right-hand sides, then increments, by position */

    /* scratch of analyse: who is coupled with whom as rows of bits, how many they are, who is next */
    uint64_t *adjacency;
    vbss_degree *degrees;
    int64_t *keys;
    uint32_t *bucket_next; /* free places of buckets */
    /* scratch of the numbers: row -> entry of the column at hand */
    uint32_t *entry_of_row;
} vbss_elimination;

typedef struct vbss_system {
    vbss_context *context;
    uint32_t block_capacity, coupling_capacity, separator_capacity, pair_capacity, entry_capacity,
        product_capacity;

    /* registered */
    uint32_t block_count, coupling_count, body_coupling_count, chain_count;
    uint8_t *roles;
    vbss_coupling *couplings; /* from 1 on: own_count of bodies, then those of couple_once */
    uint32_t *chain_ends;     /* first block after each chain */
    uint32_t *chain_of;       /* block -> chain */
    uint8_t *chain_uses_natural_order; /* its blocks are eliminated as they are numbered */
    uint8_t *chain_reuses_factor;      /* its matrix stays as condense left it */
    uint32_t *coupling_hash; /* couplings of two separators by hash, for couple_once; 0 is free */
    uint32_t coupling_hash_capacity; /* a power of two */
    uint32_t hashed_coupling_end;    /* of couplings, from 1 on: those that have been looked at */
    uint32_t *coupling_hash_buckets; /* where one stands, in the order in which they came */
    uint32_t coupling_hash_count;

    /* analysed; positions count in elimination order, runs first, then separators by block number */
    bool has_body_pattern; /* all of it but what couplings of couple_once change */
    uint32_t interior_count, unknown_count, entry_count, fill_count;
    uint32_t
        *fill_ends;  /* of the runs of each chain; then, from chain_count on, of its separators */
    uint32_t *order; /* position -> block */
    uint32_t *position;     /* block -> position */
    uint32_t *column_start; /* position -> first entry of its column; one more at the end */
    vbss_entry *entries; /* of pairs that only couple_once coupled: VBSS_NO_COUPLING, no numbers */
    uint32_t *product_start; /* run position -> first of its products */
    uint32_t *products;      /* numbers that a pair of a column's entries changes */
    /* Pairs of separators that bodies couple or runs join: separator -> first of its column, one more at the
     * end; rows are separators. */
    uint32_t *schur_column_start;
    vbss_entry *schur_pattern;
    uint64_t *row_bits; /* scratch of analyse, and the next */
    uint32_t *symbolic_scratch;

    /* numbers; block b's diagonal and right-hand side, coupling c's block */
    block *diagonal;
    block *
        off_diagonal; /* couplings of bodies, then fill; of couplings, column = what is eliminated first */
    block *scaled; /* the same of the factor, times D^-1 */
    vec3 *rhs;
    vec3 *solution; /* increments; zero for given blocks */
    vbss_pivot *pivots;

    /* the separators' system: both blocks of each pair, then diagonals; what condensing left, and the
     * copy to which others add */
    uint32_t separator_first_entry, pair_count;
    block *schur_complement, *separator_blocks;
    vec3 *schur_rhs, *separator_rhs;
    vec3 *line_search_increments; /* their increments at a place between solutions */
    vbss_elimination elimination;
    uint64_t tiny_pivots; /* met so far: each one a solve that failed */
    bool wide;            /* hot loops with AVX2 */
} vbss_system;

/* Most of everything. Entries and products are those of the runs: blocks of their factor, and what eliminating them
 * changes. Pairs: see vbss_system_create. */
typedef struct vbss_system_capacity {
    uint32_t blocks, couplings, entries, products, separators, pairs;
} vbss_system_capacity;
/* Of what vbss_system_create makes. */
vbss_system_capacity vbss_system_capacity_of_chains(uint32_t blocks, uint32_t half_bandwidth,
                                                    uint32_t separators, uint32_t pairs);
vbss_result vbss_system_create_with_capacity(vbss_context *context,
                                             const vbss_system_capacity *capacity,
                                             vbss_system **system);
/* Room for chains of `blocks` blocks in all, coupled to `reach` neighbours on either side, of which
 * `separators` (but no more than 16384) may be separators, with `pairs` of them coupled, joined by runs or filled
 * in. Separators come in groups of at least `reach` neighbours: past a narrower one a run is coupled with
 * the next, and what it fills in may not find room. */
vbss_result vbss_system_create(vbss_context *context, uint32_t blocks, uint32_t half_bandwidth,
                               uint32_t separators, uint32_t pairs, vbss_system **system);
void vbss_system_destroy(vbss_context *context, vbss_system *system);

/* The pattern. Beyond the capacity is VBSS_ERROR_CAPACITY. */
void vbss_system_begin_pattern(vbss_system *system);
vbss_result vbss_system_add_chain(vbss_system *system, uint32_t count, uint32_t *first);
/* The chain added last is no line: its runs are eliminated as they are numbered, wherever separators are. */
void vbss_system_use_natural_order(vbss_system *system);
void vbss_system_set_role(vbss_system *system, uint32_t block, vbss_role role);
/* Two different blocks; the same pair only once. VBSS_NO_COUPLING when one of them is given, so set
 * the roles first. Blocks of two chains must both be separators: else VBSS_ERROR_OUT_OF_RANGE. */
vbss_result vbss_system_couple(vbss_system *system, uint32_t a, uint32_t b, uint32_t *coupling);
/* For who only adds to the separators' system: two different separators get places there, once, however often they are
 * coupled; none when one of the two is given. After all calls of vbss_system_couple. */
vbss_result vbss_system_couple_separators(vbss_system *system, uint32_t a, uint32_t b);
vbss_result vbss_system_analyse(vbss_system *system);
/* Another pattern of the same bodies: takes back what couple_once has coupled, and nothing else. Chains, roles and
 * the couplings of bodies stay as they were registered, so analyse, which has to be called again, looks at the
 * pairs of separators only; what it finds is to the bit what it would find after begin. Couplings of bodies keep
 * their numbers and whether they are flipped. Also after an analyse that failed. */
void vbss_system_reset_separator_couplings(vbss_system *system);

/* The numbers. Whoever registered a chain or a coupling sets its diagonals, right-hand sides and
 * numbers in every round; others may add to them afterwards. Diagonals are symmetric. A coupling's
 * block has the rows of the block that is eliminated later: of the higher one unless it is `flipped`;
 * its transpose is meant with it. clear empties what nobody sets: fill. */
void vbss_system_clear(vbss_system *system);
/* Before clear: from now on the chain of a block keeps the matrix that condense left, and its factor, or no longer does; its
 * body sets right-hand sides only. Not before condense has succeeded, nor across another analyse. */
void vbss_system_reuse_factor(vbss_system *system, uint32_t block, bool reuse);

/* Eliminates the runs. False: a pivot was too small. */
bool vbss_system_condense(vbss_system *system);
/* The same for other right-hand sides, set anew, with the factor that condense left. */
void vbss_system_condense_rhs(vbss_system *system);

/* ---- the separators' system, as often as wanted after one condense
 *
 * Where the block in the row of one separator and the column of another stands in separator_blocks, and
 * the right-hand side of one in separator_rhs; the same until analyse. The two blocks of a pair are two
 * places. VBSS_NO_INDEX when there is none: pairs have places that are coupled, or joined by runs; what
 * the elimination of separators fills in has none. */
uint32_t vbss_system_schur_index(const vbss_system *system, uint32_t row, uint32_t column);
/* The same for both blocks of a pair: row a and column b, row b and column a. */
void vbss_system_schur_pair_indices(const vbss_system *system, uint32_t a, uint32_t b, uint32_t *ab,
                                    uint32_t *ba);
uint32_t vbss_system_schur_rhs_index(const vbss_system *system, uint32_t row);
/* Copies what condensing left into separator_blocks and separator_rhs, where others may add to it and make
 * it unsymmetric. */
void vbss_system_load_schur_complement(vbss_system *system);
/* Factorises what stands there, which stays as it is, and puts the separators' increments into the
 * solution; those of the runs not. False: a pivot was too small. */
bool vbss_system_solve_separators(vbss_system *system);
/* Separators may stop at a place between solutions: from where nothing moves, a share of the way to each solution in
 * turn; and its increments in place of the solution's. */
void vbss_system_begin_line_search(vbss_system *system);
void vbss_system_advance_line_search(vbss_system *system, double fraction);
void vbss_system_accept_line_search(vbss_system *system);
/* Then all other increments. */
void vbss_system_back_substitute(vbss_system *system);
/* solve_separators and finish. */
bool vbss_system_solve(vbss_system *system);

/* ---- parts of the above */

/* Of analyse: the pairs of separators, the order of their elimination and what it fills in. */
vbss_result vbss_system_order_separators(vbss_system *system);
/* Of condense: what it left, in the order of places; of right-hand sides alone. */
void vbss_system_store_schur_complement(vbss_system *system);
void vbss_system_store_schur_rhs(vbss_system *system);
/* Of finish: the runs' increments from the separators'. */
void vbss_system_back_substitute_interior(vbss_system *system);
/* Both copies of minimum_degree.c, static_condensation.c and separator_lu.c. */
vbss_result vbss_system_order_separators_plain(vbss_system *system);
vbss_result vbss_system_order_separators_wide(vbss_system *system);
bool vbss_system_condense_plain(vbss_system *system);
bool vbss_system_condense_wide(vbss_system *system);
void vbss_system_condense_rhs_plain(vbss_system *system);
void vbss_system_condense_rhs_wide(vbss_system *system);
bool vbss_system_solve_separators_plain(vbss_system *system);
bool vbss_system_solve_separators_wide(vbss_system *system);
void vbss_system_back_substitute_interior_plain(vbss_system *system);
void vbss_system_back_substitute_interior_wide(vbss_system *system);

#endif
