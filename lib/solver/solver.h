/* The linear system of all bodies and contacts of a substep, and the time integration.
 *
 * Unknowns come in blocks of three. A body registers a chain of blocks and the couplings between
 * them; its contributions are symmetric. *Interior* blocks belong to one body only. Static
 * condensation eliminates them once per linearisation by a block LDL^T. *Separators* are the blocks
 * in which contacts or other bodies take part. Their small system, the Schur complement, is solved
 * by a block LU. It may be unsymmetric and may change while the condensed part stays. This file
 * knows nothing of sutures.
 *
 * Order of calls (each name starts with vbss_system_):
 *   new pattern   begin_pattern -> add_chain, set_role, couple, couple_separators -> analyse
 *   next pattern  reset_separator_couplings -> couple_separators -> analyse
 *   numbers       clear -> (bodies) -> condense -> load_schur_complement -> (contacts) -> solve
 * After analyse the schur_index functions may be called. load_schur_complement -> (contacts) ->
 * solve_separators may repeat as often as the contact iteration needs. back_substitute then gives
 * the increments of the interior blocks; solve is solve_separators and back_substitute.
 * Only vbss_system_create and vbss_system_create_with_capacity allocate. No number survives a step
 * unless it is rebuilt. */
#ifndef VBSS_SOLVER_SOLVER_H
#define VBSS_SOLVER_SOLVER_H

#include <stddef.h>

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "base/simd_dispatch.h"
#include "solver/block.h"

/* ---- time integration (integration.c)
 *
 * Generalised alpha (Chung, Hulbert 1993) with forces at both ends of the step and one unknown per
 * node, the position x at the end. With q the acceleration that balances the forces at the end,
 *     x = x_predicted + q / inertia,
 *     v = v_predicted + velocity_factor (x - x_predicted),
 *     a = a_predicted + acceleration_factor (x - x_predicted).
 * Backward Euler has the same form with other coefficients. */
typedef struct vbss_integration {
    double h;
    double inertia;             /* 1/s^2 */
    double velocity_factor;     /* 1/s */
    double acceleration_factor; /* 1/s^2 */
    /* coefficients of the old a and q in the predictions of x, v and a */
    double x_a, x_q, v_a, v_q, a_a, a_q;
} vbss_integration;
/* Coefficients for a step of h seconds. spectral_radius is that at infinite frequency, from 0
 * (strongest numerical damping) to 1 (none). */
vbss_integration vbss_integration_generalised_alpha(double h, double spectral_radius);
vbss_integration vbss_integration_backward_euler(double h);
/* Below this, speeds (m/s) and accelerations (m/s^2) become zero: subnormal numbers cost time. */
#define VBSS_FLUSH_THRESHOLD 1e-30
/* Predictions from the state at the start of the step, and the update of v, a and q from the
 * positions x at its end. Arrays hold `count` numbers, three per node, and must not overlap. */
void vbss_integration_predict(const vbss_integration *integration, size_t count, const double *x,
                              const double *v, const double *a, const double *q,
                              double *x_predicted, double *v_predicted, double *a_predicted);
void vbss_integration_correct(const vbss_integration *integration, size_t count, const double *x,
                              const double *x_predicted, const double *v_predicted,
                              const double *a_predicted, double *v, double *a, double *q);

/* ---- explicit methods of VBLaST-SS (explicit_substeps.c, relative_damping.c) */

/* v <- v - share (v - rigid motion), nodes first .. last; mass 0 has no part in that motion. */
void vbss_damp_relative_motion(const double *mass, const vec3 *x, vec3 *v, uint32_t first,
                               uint32_t last, double fraction);

/* ---- the system */

typedef enum vbss_role {
    VBSS_ROLE_INTERIOR,  /* eliminated by static condensation */
    VBSS_ROLE_SEPARATOR, /* solved in the Schur complement */
    VBSS_ROLE_PRESCRIBED /* has a given motion: its increment is zero and it has no equation */
} vbss_role;

/* The coupling of a prescribed block: numbers added to it are discarded. */
#define VBSS_NO_COUPLING 0u
/* The index of a block that does not exist: not a separator, or not in the pattern. */
#define VBSS_NO_INDEX UINT32_MAX

/* An entry of the factor. Its column is implied; row and column count in elimination order. */
typedef struct vbss_entry {
    uint32_t row;
    uint32_t index; /* index of its block in off_diagonal */
} vbss_entry;

/* A pair of coupled blocks. */
typedef struct vbss_coupling {
    uint32_t high, low; /* the blocks, high > low */
    /* the low block is eliminated later, so the stored block has its rows */
    uint32_t is_transposed;
    uint32_t next; /* next in the list of its column during analysis */
} vbss_coupling;

/* L D L^T of a diagonal block. */
typedef struct vbss_pivot {
    double l10, l20, l21;
    double inverse[3]; /* reciprocals of D */
    vec3 y;            /* L^-1 times the right-hand side after elimination of all earlier blocks */
} vbss_pivot;

/* An entry of the separators' factor, listed by rows. */
typedef struct vbss_row_entry {
    uint32_t column, entry;
} vbss_row_entry;

/* A coupled pair of separators in the column of the earlier one: the later one's position, and the
 * index of the block in that row and column. */
typedef struct vbss_pair {
    uint32_t row, schur_index;
} vbss_pair;

/* Number of remaining neighbours of a separator, and how many of them the last elimination next to
 * it joined. */
typedef struct vbss_degree {
    uint32_t neighbours, joined;
} vbss_degree;

/* Elimination of the separators in minimum degree order. Separators are numbered from 0 in the
 * order of their blocks, positions from 0 in elimination order. */
typedef struct vbss_elimination {
    uint32_t *order;             /* position -> separator */
    uint32_t *position;          /* separator -> position */
    uint32_t *column_start;      /* position -> first entry of its column; one extra at the end */
    uint32_t *rows;              /* entry -> position of its row, ascending within a column */
    uint32_t *row_start;         /* position -> first entry of its row; one extra at the end */
    vbss_row_entry *row_entries; /* entries sorted by row, then by column */
    uint32_t *pair_start;        /* position -> first pair of its column; one extra at the end */
    vbss_pair *pairs;            /* the pattern without fill */
    /* blocks of L times the pivots, and transposed blocks of U without them; in the arena */
    block *lower, *upper;
    uint64_t product_count; /* block products to compute all entries of L and U */
    lanes *x;               /* right-hand sides, then increments, by position */

    /* scratch of the analysis: bits of the coupling graph row by row, degrees, elimination keys */
    uint64_t *adjacency;
    vbss_degree *degrees;
    int64_t *keys;
    uint32_t *bucket_next; /* next free index of each bucket */
    /* scratch of the factorisation: row -> entry of the current column */
    uint32_t *entry_of_row;
} vbss_elimination;

typedef struct vbss_system {
    vbss_context *context;
    uint32_t block_capacity, coupling_capacity, separator_capacity, pair_capacity, factor_capacity,
        entry_capacity, product_capacity, arena_capacity;

    /* registered pattern */
    uint32_t block_count, coupling_count, body_coupling_count, chain_count;
    uint8_t *roles;
    /* from 1 on: body_coupling_count of bodies, then those of vbss_system_couple_separators */
    vbss_coupling *couplings;
    uint32_t *chain_ends; /* chain -> first block after it */
    uint32_t *chain_of;   /* block -> chain */
    /* chain -> its blocks are eliminated in the order of their numbers */
    uint8_t *chain_uses_natural_order;
    /* chain -> it keeps the factor of the last vbss_system_condense */
    uint8_t *chain_reuses_factor;
    /* hash table of the couplings of two separators; VBSS_NO_COUPLING marks a free bucket */
    uint32_t *coupling_hash;
    uint32_t coupling_hash_capacity; /* a power of two */
    uint32_t hashed_coupling_end;    /* the last coupling that has been hashed */
    uint32_t *coupling_hash_buckets; /* occupied buckets in the order of insertion */
    uint32_t coupling_hash_count;

    /* result of the analysis. Positions count in elimination order: interior blocks first, then
     * separators by block number. */
    /* the part that does not depend on vbss_system_couple_separators is up to date */
    bool has_body_pattern;
    uint32_t interior_count, unknown_count, entry_count, fill_count;
    /* chain -> end of the fill of its interior blocks; then, from chain_count on, of its
     * separators */
    uint32_t *fill_ends;
    uint32_t *order;        /* position -> block */
    uint32_t *position;     /* block -> position */
    uint32_t *column_start; /* position -> first entry of its column; one extra at the end */
    /* a pair that only vbss_system_couple_separators coupled has the index VBSS_NO_COUPLING and no
     * block */
    vbss_entry *entries;
    uint32_t *product_start; /* interior position -> first of its products */
    uint32_t *products;      /* index of the block that a pair of a column's entries changes */
    /* Pairs of separators that bodies couple or condensation fills: separator -> first entry of its
     * column; one extra at the end. Rows are separators. */
    uint32_t *schur_column_start;
    vbss_entry *schur_pattern;
    uint64_t *row_bits; /* scratch of the analysis, with symbolic_scratch */
    uint32_t *symbolic_scratch;

    /* numbers: diagonal, rhs and solution by block, off_diagonal by coupling, pivots by position */
    block *diagonal;
    /* off_diagonal, scaled, schur_complement, separator_blocks, lower and upper, in this order and as
     * long as the pattern needs them. A block is interior or a separator, so they never need their largest
     * lengths together. */
    block *arena;
    /* couplings of bodies, then fill; the block's column is the one eliminated first; in the arena */
    block *off_diagonal;
    block *scaled; /* entry -> off_diagonal of the factor times D^-1; in the arena */
    vec3 *rhs;
    vec3 *solution; /* increments; zero for prescribed blocks */
    vbss_pivot *pivots;

    uint32_t separator_first_entry, pair_count;
    /* the Schur complement of condensation, which is symmetric: one block of each pair, then the
     * diagonals; in the arena */
    block *schur_complement;
    /* the copy to which contacts add: both blocks of each pair, then the diagonals; in the arena */
    block *separator_blocks;
    vec3 *schur_rhs, *separator_rhs;
    vec3 *line_search_increments; /* their increments at the current point of the line search */
    vbss_elimination elimination;
    uint64_t tiny_pivots; /* failed solves so far, each because of a tiny pivot */
    bool wide;            /* use the AVX2 copies of the hot loops */
} vbss_system;

/* Capacities of a system. */
typedef struct vbss_system_capacity {
    uint32_t blocks;
    uint32_t couplings; /* of bodies */
    /* of the interior blocks: blocks of their factor, and block updates of their elimination */
    uint32_t entries, products;
    uint32_t separators;
    uint32_t pairs;  /* of separators that are coupled, or joined by condensation */
    uint32_t factor; /* pairs with those that the separators' own elimination fills in */
    /* Blocks of numbers. A pattern takes one, and one for each coupling of bodies and each fill, one
     * for each entry, three for each pair, two for each separator, and two for each pair of the
     * factor. */
    uint32_t arena;
} vbss_system_capacity;
/* Capacities that vbss_system_create uses; its arguments are explained there. */
vbss_system_capacity vbss_system_capacity_of_chains(uint32_t blocks, uint32_t half_bandwidth,
                                                    uint32_t separators, uint32_t pairs);
vbss_result vbss_system_create_with_capacity(vbss_context *context,
                                             const vbss_system_capacity *capacity,
                                             vbss_system **system);
/* Creates a system for chains of `blocks` blocks in total, each coupled to `half_bandwidth`
 * neighbours on either side. At most `separators` blocks (16384 at most) may be separators. `pairs`
 * limits the pairs of them that are coupled, joined by condensation, or filled in.
 * Separators must come in groups of at least half_bandwidth neighbours. Across a narrower group the
 * interior blocks on both sides are coupled, and their fill may exceed the capacity.
 * VBSS_ERROR_OUT_OF_MEMORY. */
vbss_result vbss_system_create(vbss_context *context, uint32_t blocks, uint32_t half_bandwidth,
                               uint32_t separators, uint32_t pairs, vbss_system **system);
void vbss_system_destroy(vbss_context *context, vbss_system *system);

/* ---- the pattern. All functions return VBSS_ERROR_CAPACITY if the pattern exceeds the
 * capacity. */
/* Removes all chains and couplings. */
void vbss_system_begin_pattern(vbss_system *system);
/* Adds a chain of `count` blocks with the role VBSS_ROLE_INTERIOR; *first is the number of its
 * first block. */
vbss_result vbss_system_add_chain(vbss_system *system, uint32_t count, uint32_t *first);
/* Makes the chain added last eliminate its interior blocks in the order of their numbers, wherever
 * separators are: for bodies whose coupling graph is not a line. */
void vbss_system_use_natural_order(vbss_system *system);
void vbss_system_set_role(vbss_system *system, uint32_t block, vbss_role role);
/* Couples two different blocks of a body; each pair only once, and after all roles are set.
 * *coupling is VBSS_NO_COUPLING if one of them is prescribed. VBSS_ERROR_INCOMPATIBLE if the blocks
 * belong to two chains and are not both separators, VBSS_ERROR_WRONG_STATE after a call of
 * vbss_system_couple_separators. */
vbss_result vbss_system_couple(vbss_system *system, uint32_t a, uint32_t b, uint32_t *coupling);
/* Makes room in the separators' system for the blocks of a pair of different separators, for
 * contacts, which only add there. A repeated call does nothing, nor does a call with a prescribed
 * block. Requires that all calls of vbss_system_couple are done. VBSS_ERROR_INCOMPATIBLE if a block
 * is interior. */
vbss_result vbss_system_couple_separators(vbss_system *system, uint32_t a, uint32_t b);
/* Finds elimination order, fill and product lists of the pattern. */
vbss_result vbss_system_analyse(vbss_system *system);
/* Removes all couplings of vbss_system_couple_separators, for another contact pattern of the same
 * bodies.
 *
 * Chains, roles and couplings of bodies stay, so the next vbss_system_analyse only analyses pairs
 * of separators. Its result is equal to the bit to that after begin_pattern. The couplings of
 * bodies keep their numbers and is_transposed. The call is also valid after an analysis that
 * failed. */
void vbss_system_reset_separator_couplings(vbss_system *system);

/* ---- the numbers. In every linearisation, each body sets the diagonals, right-hand sides and
 * couplings that it registered; others may add to them afterwards. Diagonals are symmetric. The
 * block of a coupling has the rows of the block that is eliminated later: the higher one unless
 * is_transposed is set. It represents its transpose too. */
/* Sets the fill to zero, which no body sets. */
void vbss_system_clear(vbss_system *system);
/* Lets the chain of this block keep the factor of the last condense, or ends that. Its body then
 * sets right-hand sides only. Call it before vbss_system_clear, after a successful condense. Analyses
 * in between must have followed vbss_system_reset_separator_couplings. */
void vbss_system_reuse_factor(vbss_system *system, uint32_t block, bool reuse);

/* Eliminates the interior blocks. Returns false if a pivot is too small. */
bool vbss_system_condense(vbss_system *system);
/* Condenses new right-hand sides with the factor of the last vbss_system_condense. */
void vbss_system_condense_rhs(vbss_system *system);

/* ---- the separators' system, which may be solved many times after one condensation */
/* Index in separator_blocks of the block in the row of one separator and the column of another;
 * valid until the next analysis. VBSS_NO_INDEX if the pair is neither coupled nor joined by
 * condensation. The fill of the separators' own elimination has no index. */
uint32_t vbss_system_schur_index(const vbss_system *system, uint32_t row, uint32_t column);
/* The two indices of a pair of separators: *ab for row a and column b, *ba for row b and column a.
 * Both are the diagonal block if a = b, and VBSS_NO_INDEX if the pair has none. */
void vbss_system_schur_pair_indices(const vbss_system *system, uint32_t a, uint32_t b, uint32_t *ab,
                                    uint32_t *ba);
/* Index of a separator in separator_rhs; VBSS_NO_INDEX for any other block. */
uint32_t vbss_system_schur_rhs_index(const vbss_system *system, uint32_t row);
/* Copies the Schur complement into separator_blocks and separator_rhs, to which contacts may add.
 * The sum may be unsymmetric. */
void vbss_system_load_schur_complement(vbss_system *system);
/* Solves separator_blocks and separator_rhs, which stay unchanged, and writes the separators'
 * increments to `solution`. Returns false if a pivot is too small. */
bool vbss_system_solve_separators(vbss_system *system);
/* Line search over the separators' increments. It starts from zero; each advance moves a fraction
 * (0 to 1) of the way to the present solution; accept makes the result the solution. */
void vbss_system_begin_line_search(vbss_system *system);
void vbss_system_advance_line_search(vbss_system *system, double fraction);
void vbss_system_accept_line_search(vbss_system *system);
/* Computes the increments of all other blocks from those of the separators. */
void vbss_system_back_substitute(vbss_system *system);
/* vbss_system_solve_separators and vbss_system_back_substitute. Returns false if a pivot is too
 * small. */
bool vbss_system_solve(vbss_system *system);

/* ---- stages of the functions above */

/* Analysis: pairs of separators, their elimination order and fill. */
vbss_result vbss_system_order_separators(vbss_system *system);
/* Condensation: stores blocks and right-hand sides of the Schur complement, or the right-hand sides
 * alone. */
void vbss_system_store_schur_complement(vbss_system *system);
void vbss_system_store_schur_rhs(vbss_system *system);
/* Back substitution: increments of the interior blocks from those of the separators. */
void vbss_system_back_substitute_interior(vbss_system *system);
/* Plain and wide copies of minimum_degree.c, static_condensation.c and separator_lu.c. */
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
