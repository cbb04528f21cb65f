/* Contact: rows that keep features of any bodies apart, rub them against each other, or tie them.
 *
 * A row knows no body: its two sides are a short list of terms, each a block of the system and a map
 * from that block's increment to the motion of the contact point: a weight (a node), or a weight and an
 * arm (the rotation of a rigid body: u = w dtheta x arm). u, of side a relative to side b, is the sum.
 *
 *   begin -> add rows -> recall -> register, pattern -> find_places -> (solve) until good -> keep
 *
 * constraints.c lists rows and remembers them from step to step; contact_law.c is the law of contact and friction;
 * active_set.c finds their states together with the increments of all blocks, and line_search.c says how far to follow; weld.c
 * eliminates a node that is a point of a rigid body; snapshot.c saves what is remembered. docs/contact.md derives all of it. */
#ifndef VBSS_CONTACT_CONTACT_H
#define VBSS_CONTACT_CONTACT_H

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "solver/solver.h"

typedef struct vbss_stream vbss_stream;

/* ---- rows */

/* Two features of three terms each; or what is in a hole, which may slide on over the swage: five nodes and a needle that has
 * two, and three of the wall. */
enum { CONTACT_MAX_JACOBIAN_BLOCKS = 10 };

typedef struct contact_jacobian_block {
    uint32_t block;
    bool is_rotation; /* the block is a rotation increment */
    double weight;
    double
        weight_derivative; /* of a sleeve: of the weight, as what is in it slides along the normal, 1/m */
    vec3 arm;              /* turns: from the centre of mass to the contact point */
    vec3 weighted_arm_derivative; /* turns: of the weighted arm what slope is of the weight */
} contact_jacobian_block;

/* Which features: what the order of the rows, and memory, go by. */
typedef struct contact_key {
    uint32_t kind, body_a, feature_a, body_b, feature_b;
} contact_key;
int vbss_contact_compare_keys(const contact_key *x, const contact_key *y);

typedef enum contact_status { CONTACT_OPEN, CONTACT_STICK, CONTACT_SLIP } contact_status;

typedef struct contact_solution {
    contact_status status;
    double normal_force;   /* normal force on a, N */
    vec3 tangential_force; /* tangential force on a, N */
    vec3 slip_direction;   /* SLIP: unit, of the rubbing */
    double
        friction_ratio; /* SLIP: friction pressure / |augmented rubbing|; of a sleeve 1 if its force along is along
                        the normal, 0 if it is against it: its pressure is that force, its rubbing the one across */
} contact_solution;

typedef struct contact_constraint {
    contact_key key;
    uint32_t jacobian_block_count;
    contact_jacobian_block jacobian[CONTACT_MAX_JACOBIAN_BLOCKS];
    bool
        is_bilateral; /* also pulls: a grasp, a hole; with friction it holds in the plane, without slip */
    double stiffness;                  /* normal and tangential, N/m */
    double friction;                   /* coefficient */
    double tangential_stiffness_ratio; /* share of the stiffness that it has in the plane; 0: all */
    /* Where little presses it has so much less there that friction is spent after this way, m; 0: all. Not of what ties. */
    double elastic_slip_limit;
    /* Bilateral: what is in it is held across the normal and slides along it. Below `least`, N, and `grip` of what is held
     * across it sticks: against the normal, along it; either may be below 0, their sum is not. Beyond, it yields with a
     * damping, as a stiffness of the part, N/m. What it held along is remembered. */
    bool is_sleeve;
    double yield_force, yield_friction[2], viscous_stiffness;
    vec3 curvature; /* of the normal as it slides along it, 1/m */
    /* A sleeve's, for whoever makes rows: on which span it has been laid, and from which arc length on. */
    uint32_t span;
    double start_arc_length;
    double augmentation; /* r of Alart and Curnier, N/m */
    vec3 normal;         /* unit, from b to a */
    double gap;          /* at the trial state, m */
    vec3
        relative_displacement; /* of a against b from the begin of the part to the trial state, m */
    double barycentric[2];     /* where on the features: for whoever makes rows */
    double axis_interval[2]
                        [2]; /* of a segment a: from and to which share it is looked at: the same */
    uint32_t dedup_points[2], dedup_next; /* what is there: the same, while they are made */
    vec3 point;                           /* between the surfaces: the same */
    double
        contact_distance; /* m: distance of the features\' middles at which they touch: the same */
    double
        lip_thickness; /* m: of two lips, what of their distance along the normal is wall: the same */
    double overlap_allowance; /* m: how much nearer they may be, beside a hole: the same */
    double
        fold_allowance; /* m: of that, by how much more they overlap than the gap says, in a fold */
    double thickness, start_gap,
        allowed_penetration; /* m: distance of the axes, begin, end of the part: the same */

    contact_solution solution; /* found last */
    vec3 previous_force;       /* rubbing at the begin of the part: what friction remembers */

    uint32_t schur_offset; /* into the set's places; UINT32_MAX: no term has an equation */
} contact_constraint;

/* In the plane, N/m. */
static inline double contact_tangential_stiffness(const contact_constraint *constraint)
{
    return constraint->tangential_stiffness_ratio > 0.0
               ? constraint->tangential_stiffness_ratio * constraint->stiffness
               : constraint->stiffness;
}

/* Where the search for states stands with a row: its sides have moved by u against each other, and all
 * blocks balance when `force` acts on a, which is what the law says only when the search is over. */
typedef struct contact_iterate {
    vec3 u, force;
} contact_iterate;

static inline contact_iterate contact_iterate_lerp(const contact_iterate *a,
                                                   const contact_iterate *b, double fraction)
{
    return (contact_iterate){vec3_lerp(a->u, b->u, fraction),
                             vec3_lerp(a->force, b->force, fraction)};
}

/* What the law says of four rows on the way from one stand to another. */
typedef struct contact_simd_batch {
    double normal[3][LANES], relative_displacement[3][LANES], previous_force[3][LANES];
    double current_u[3][LANES], candidate_u[3][LANES], current_force[3][LANES],
        candidate_force[3][LANES];
    double gap[LANES], stiffness[LANES], tangential_stiffness[LANES],
        friction[LANES];     /* as the rows have them */
    double bilateral[LANES]; /* 1: bilateral */
    bool is_sleeve[LANES];
} contact_simd_batch;

/* What is kept of a row with a force until the next part. */
typedef struct contact_warm_start_entry {
    contact_key key;
    uint32_t status;
    double normal_force, friction_ratio;
    vec3 tangential_force;
} contact_warm_start_entry;

/* How far a search is. */
typedef struct contact_active_set_progress {
    uint32_t solve_count; /* solves */
    double stiffness_scale;
    uint32_t solves_at_scale; /* with this softness */
    bool has_softened;        /* it has been, and will not be again */
    double
        reference_residual; /* of the law, the larger share, when it was last half of what it had been; */
    uint32_t stalled_solves; /* solves since */
} contact_active_set_progress;

/* Where work stops for now, between two solves or before a linearisation, to go on with nothing changed. It is asked before
 * each; how often it has let go on tells one place of an attempt from all others. */
typedef struct contact_call_budget {
    uint64_t operation_limit; /* nothing begins that would take work beyond; 0: there is none */
    bool has_progress;        /* something has been done in this slot: until then it lets go on */
    uint32_t checks_passed;   /* so often, in the attempt */
    bool is_replay;           /* an attempt is made once more: it stops where it has before, */
    uint32_t replay_checks;   /* after so many */
} contact_call_budget;

typedef struct contact_counters {
    uint64_t solves;  /* of the separators' system */
    uint64_t inexact; /* states taken with a residual */
    uint64_t
        operations; /* operations: what costs as much as a product of blocks; others add theirs */
} contact_counters;

typedef struct contact_weld contact_weld;

typedef struct contact_set {
    uint32_t capacity, count, warm_start_count;
    contact_constraint *constraints;      /* ascending keys */
    uint32_t *sort_permutation;           /* scratch of sort: where a row comes from */
    contact_warm_start_entry *warm_start; /* the same */
    contact_warm_start_entry *checkpoint; /* memory as it was at the last mark */
    uint32_t checkpoint_count;
    uint8_t *scratch_flags;           /* of the memory: found again */
    contact_solution *next_solutions; /* of the rows: what the last solve says */
    contact_solution
        *saved_solutions; /* what was found before a search whose outcome may be left */
    contact_iterate *current,
        *candidate; /* of the rows: where the last solve was left, where this one leads */
    contact_simd_batch
        *simd_batches; /* scratch of the way between: the rows, the last with nothing beside it */
    uint32_t
        *schur_indices; /* of each row: of its blocks row by row, then of its right-hand sides */
    uint32_t schur_index_count, schur_index_capacity;
    double residual; /* of the law after the last solve, N */
    bool
        is_stopped_early; /* the last search, by its limit of work: what the law says was not found */
    bool was_stopped_early;               /* with found_before */
    contact_active_set_progress progress; /* of the search under way */
    contact_call_budget call_budget;
    contact_counters counters;
    /* the last two at the last mark */
    double checkpoint_residual;
    contact_counters checkpoint_counters;
} contact_set;

vbss_result vbss_contact_create(vbss_context *context, uint32_t capacity, contact_set **set);
void vbss_contact_destroy(vbss_context *context, contact_set *set);

/* constraints.c. A new list, as new rows come; NULL: no more room. Keys come in any order and are sorted. */
void vbss_contact_clear(contact_set *set);
contact_constraint *vbss_contact_add(contact_set *set, const contact_key *key);
void vbss_contact_sort(contact_set *set);
/* The row of a key in a list that is sorted, or UINT32_MAX. */
uint32_t vbss_contact_find(const contact_set *set, const contact_key *key);
/* States and forces of the last part, for rows that were there. What is left of the memory (`recalled` says so) belonged to
 * contacts that are gone or have slid on to other features: to the first beside their own, by number, that has no other
 * yet; or to a row that whoever knows the features names. */
void vbss_contact_warm_start(contact_set *set);
void vbss_contact_warm_start_neighbour(contact_set *set, uint32_t entry_index);
void vbss_contact_warm_start_one(contact_set *set, uint32_t entry_index, uint32_t constraint_index);
/* Remembers the rows with a force: the part is accepted. */
void vbss_contact_store_warm_start(contact_set *set);
/* What is remembered, to come back to it. */
void vbss_contact_checkpoint(contact_set *set);
void vbss_contact_rollback(contact_set *set);
/* Largest overlap over all unilateral rows as gaps are now, m; and whether all are within what is allowed. */
double vbss_contact_max_penetration(const contact_set *set);
bool vbss_contact_penetration_is_allowed(const contact_set *set);

/* constraint_assembly.c. Couples the blocks of each row, as far as they are separators; then where they stand, or that
 * they stand where those of the last list with the same keys did. */
vbss_result vbss_contact_register(const contact_set *set, vbss_system *system);
void vbss_contact_find_schur_indices(contact_set *set, const vbss_system *system);
void vbss_contact_assign_schur_offsets(contact_set *set);
/* Adds to the separators' system what the rows say in their states: stiffness and forces. */
void vbss_contact_assemble(const contact_set *set, vbss_system *system);

/* ---- the law (contact_law.c) */

/* The force of a row in its state, and how it changes with u: the sum over the directions of
 * stiffness * left (right . u) is taken off it. */
typedef struct contact_linearisation {
    uint32_t count; /* directions */
    vec3 left[3];   /* force along these */
    vec3 right[3];  /* when u moves along those */
    double stiffness[3];
    vec3 force; /* on a, at the trial state */
} contact_linearisation;
void vbss_contact_linearise(const contact_constraint *constraint,
                            contact_linearisation *linearisation);
/* What the row's state and forces are after its sides moved by u against each other. Returns by how much the
 * law is missed in the state that it is in, N. */
double vbss_contact_update_solution(const contact_constraint *constraint, vec3 u,
                                    contact_solution *next);
/* The force on a after u: as the equations have it in the row's state, and as the law has it. */
vec3 vbss_contact_linearised_force(const contact_constraint *constraint, vec3 u);
vec3 vbss_contact_force(const contact_constraint *constraint, vec3 u);
/* The state to go on with from where the search stands. */
void vbss_contact_solution_at(const contact_constraint *constraint, const contact_iterate *iterate,
                              contact_solution *next);
/* The tangential force that is remembered, turned into a row's tangent plane with its length. */
vec3 vbss_contact_rotate_to_tangent_plane(vec3 force, vec3 normal);

/* ---- welds (weld.c): a node that is a point of a rigid body */

/* Three on either side, and the bodies of those of them that are welded too. */
enum { CONTACT_WELD_MAX_NEIGHBOURS = 18 };
struct contact_weld {
    uint32_t node, translation, rotation; /* blocks */
    vec3 arm;                             /* from the centre of mass to the node */
    uint32_t neighbour_count;
    /* Separators that the node is coupled with; of those that earlier welds have eliminated, the bodies too. */
    uint32_t neighbours[CONTACT_WELD_MAX_NEIGHBOURS];
};
/* Couples the body's blocks with the node's neighbours: after these are registered. */
vbss_result vbss_contact_register_weld(const contact_weld *weld, vbss_system *system);
/* Moves the node's rows and columns in the separators' system to the body; its own equation says that
 * nothing moves. Exact: the body's increments are those of the joined system. */
void vbss_contact_eliminate_weld(const contact_weld *weld, vbss_system *system);
/* The increment of the node that follows from the body's. */
vec3 vbss_contact_weld_increment(const contact_weld *weld, const vbss_system *system);

/* ---- states (active_set.c) */

typedef struct contact_active_set_options {
    vbss_system *system; /* condensed */
    const contact_weld *welds;
    uint32_t weld_count;
    uint32_t max_solves; /* solves */
    /* What is none: a force, as a share of the largest pressure and N added; overlap of an open row, as a share
     * of the thickness. */
    double relative_force_tolerance, absolute_force_tolerance, overlap_tolerance;
    /* What may be left when so many solves have not halved what is missed. */
    uint32_t max_stalled_solves;
    double loose_force_tolerance, loose_overlap_tolerance;
    /* Beyond this work no solve begins but the first, and the search stops where it stands: all balances there, and
     * what the law is missed by has become less on the way. 0: no limit. */
    uint64_t operation_limit;
    bool
        starts_from_current; /* from the rows' forces after an earlier linearisation; with a limit only */
    bool
        is_resumed; /* where it has waited for a slot to end: nothing of set and system has changed */
} contact_active_set_options;
typedef enum contact_outcome {
    CONTACT_CONVERGED,
    CONTACT_INEXACT,
    CONTACT_NOT_CONVERGED,
    CONTACT_SINGULAR,
    CONTACT_SUSPENDED
} contact_outcome;
/* States of all rows and increments of all separators: primal-dual active set. */
contact_outcome vbss_contact_solve_active_set(contact_set *set,
                                              const contact_active_set_options *options);
/* Whether what would take so much work is for the next slot. */
bool vbss_contact_must_suspend(contact_set *set, uint64_t operations);

/* line_search.c: of the forces between those `here` and `there`, what they miss the law by does work on the way from the one to the
 * other, N m; this after a share of it. begin_work takes down the rows and both ends. */
void vbss_contact_begin_line_search(contact_set *set, bool wide);
double vbss_contact_line_search_slope(const contact_set *set, bool wide, double fraction);
/* Both copies. */
void vbss_contact_begin_line_search_plain(contact_set *set);
void vbss_contact_begin_line_search_wide(contact_set *set);
double vbss_contact_line_search_slope_plain(const contact_set *set, double fraction);
double vbss_contact_line_search_slope_wide(const contact_set *set, double fraction);

/* Notes what is found, and goes back to it. */
void vbss_contact_save_solution(contact_set *set);
void vbss_contact_restore_solution(contact_set *set);

/* snapshot.c */
void vbss_contact_serialise(vbss_stream *stream, uint16_t first_tag, contact_set *set);

#endif
