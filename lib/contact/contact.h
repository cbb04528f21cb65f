/* Contact constraints between features of bodies: unilateral contact with friction, and bilateral
 * ties.
 *
 * A constraint knows no body. Its Jacobian is a short list of blocks of the system, each with the
 * map from the block's increment to the motion of the contact point: a weight (a node), or a weight
 * and an arm (the rotation of a rigid body: u = w dtheta x arm; the roll of a thread's segment, which is one
 * component of its block: u = w d arm). u, the displacement of side a relative to side b, is the sum.
 *
 * Order of calls in a substep:
 *   vbss_contact_clear -> vbss_contact_add -> vbss_contact_sort -> vbss_contact_warm_start
 *   -> vbss_contact_register -> vbss_contact_find_schur_indices
 *   -> vbss_contact_solve_active_set until converged -> vbss_contact_store_warm_start
 *
 * constraints.c lists constraints and warm starts them; contact_law.c is the law of contact and
 * friction; active_set.c finds their status together with the increments of all blocks;
 * line_search.c chooses the step length; weld.c eliminates a node that is a point of a rigid body;
 * snapshot.c saves the warm-start entries. docs/explanation/contact.md derives the method. */
#ifndef VBSS_SCENE_CONTACT_CONTACT_H
#define VBSS_SCENE_CONTACT_CONTACT_H

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "solver/solver.h"

typedef struct vbss_stream vbss_stream;

/* ---- constraints */

/* Two features of three blocks each need 6. A hole needs 10: five nodes of the suture and two
 * blocks of the needle, because the suture may slide on over the swage, and three nodes of the
 * wall. */
enum { CONTACT_MAX_JACOBIAN_BLOCKS = 10 };

typedef struct contact_jacobian_block {
    uint32_t block;
    bool is_rotation;  /* the block is the increment of a rotation */
    bool is_roll;      /* a rotation of which one component counts, with the unit vector `arm` */
    uint8_t component; /* of a roll: 0 to 2 */
    bool is_on_side_b; /* two threads that slide: the block is a node of thread b */
    double weight;
    /* derivative of the weight, 1/m: of a sleeve as the suture slides along the normal, of two threads
     * that slide as the contact point moves along its thread */
    double weight_derivative;
    vec3 arm; /* rotation: from the centre of mass to the contact point, m */
    /* rotation of a sleeve: derivative of weight times arm as the suture slides along the normal */
    vec3 weighted_arm_derivative;
} contact_jacobian_block;

/* The pair of features: the sort key of constraints and warm-start entries. */
typedef struct contact_key {
    uint32_t kind, body_a, feature_a, body_b, feature_b;
} contact_key;
/* Negative, 0 or positive if x is before, equal to or after y. */
int vbss_contact_compare_keys(const contact_key *x, const contact_key *y);

typedef enum contact_status { CONTACT_OPEN, CONTACT_STICK, CONTACT_SLIP } contact_status;

typedef struct contact_solution {
    contact_status status;
    bool is_forward;     /* sleeve, SLIP: it slides with its force along the normal, not against */
    bool is_tear_capped; /* sleeve: it tears by max_tear_slip */
    double normal_force; /* force on a along the normal, N: on a sleeve the axial force */
    vec3
        tangential_force; /* force on a in the tangent plane, N: on a sleeve the transverse force */
    vec3 slip_direction;  /* SLIP: unit vector of the friction force */
    /* SLIP: friction bound / |augmented friction force|. Of a sleeve that tears: transverse force / its
     * elastic value. */
    double friction_ratio;
    double tear_limit; /* sleeve: transverse force above which it tears, N; 0: it does not tear */
} contact_solution;

/* Fields that each solve reads come first. Those that few constraints use come last, so that a
 * constraint is moved by its first bytes. */
typedef struct contact_constraint {
    contact_key key;
    uint32_t jacobian_block_count;
    /* offset of its indices in schur_indices; UINT32_MAX before they are assigned */
    uint32_t schur_offset;
    /* index of its geometry in an array of the module that creates it; differs between constraints,
     * is below the capacity, and stays when the list is sorted */
    uint32_t geometry;
    /* a tie that also pulls: a grasp or a hole. It holds in the tangent plane without slip. */
    bool is_bilateral;
    bool is_sleeve;                    /* a tie that slides along its normal; see below */
    double stiffness;                  /* normal and tangential stiffness, N/m */
    double friction;                   /* unilateral: coefficient */
    double tangential_stiffness_ratio; /* tangential stiffness / stiffness; 0 for 1 */
    double augmentation;               /* augmentation parameter r of Alart and Curnier, N/m */
    vec3 normal;                       /* unit vector from b to a */
    double gap;                        /* at the trial state, m */
    /* displacement of a relative to b from the start of the substep to the trial state, m */
    vec3 relative_displacement;
    vec3 previous_force;       /* tangential force at the start of the substep, N */
    contact_solution solution; /* result of the last solve */
    /* Unilateral: at small normal forces the tangential stiffness is reduced so that the friction
     * bound is reached after this displacement, m. 0 for none. */
    double elastic_slip_limit;
    /* unilateral: part of `gap` that is overlap from before the substep, which no contact force
     * explains and which this substep does not have to remove, m */
    double recovery_allowance;
    /* unilateral: diameter of the thinner feature; largest penetration allowed at the end of the
     * substep; m */
    double thickness, allowed_penetration;
    /* A sleeve holds the suture across its axis, the normal, and lets it slide along it. It sticks below the yield force yield_force[] + yield_friction[] times the transverse
     * force, in N; index 0 is for a force against the normal, 1 along it. Either bound may be
     * negative, but not their sum. Beyond, a damper with the stiffness viscous_stiffness in this
     * substep, N/m, lets it slide. The axial force is remembered. */
    double yield_force[2], yield_friction[2], viscous_stiffness;
    /* A sleeve whose wall tears: the part of the transverse force in the plane of the wall at which it
     * yields, N; 0: it does not. As along the normal, a damper with viscous_stiffness is in series. It
     * yields by at most max_tear_slip in the substep, m. */
    double tear_force, max_tear_slip;
    vec3 wall_normal; /* with tear_force: unit normal of the wall */
    bool may_lag;     /* sleeve: its yield force may be lagged */
    /* Sleeve: transverse force from which the linearisation takes the yield force while the search cycles, N; 0:
     * that of the solution. */
    double lagged_transverse;
    vec3 curvature; /* derivative of the normal as it slides along the normal, 1/m */
    /* Two threads that slide over each other: the contact point moves along thread a and b by the
     * product of its gradient and the relative displacement. The Jacobian is that of points which are
     * ahead of those of the trial state by its lead, m. */
    bool is_sliding;
    vec3 slide_gradients[2];
    double slide_leads[2];
    vec3 sliding_force; /* on a at the start of the active-set iteration, N */
    contact_jacobian_block jacobian[CONTACT_MAX_JACOBIAN_BLOCKS];
} contact_constraint;

/* Stiffness in the tangent plane, N/m. */
static inline double contact_tangential_stiffness(const contact_constraint *constraint)
{
    return constraint->tangential_stiffness_ratio > 0.0
               ? constraint->tangential_stiffness_ratio * constraint->stiffness
               : constraint->stiffness;
}

/* Iterate of a constraint in the active-set iteration. The sides have moved by u, and all blocks
 * are in equilibrium with `force` acting on a. Only at the solution does this force satisfy the
 * contact law. */
typedef struct contact_iterate {
    vec3 u, force;
} contact_iterate;

static inline contact_iterate contact_iterate_lerp(const contact_iterate *a,
                                                   const contact_iterate *b, double fraction)
{
    return (contact_iterate){vec3_lerp(a->u, b->u, fraction),
                             vec3_lerp(a->force, b->force, fraction)};
}

/* Four constraints in SIMD lanes, with the current and the candidate iterate, for the line
 * search. */
typedef struct contact_simd_batch {
    double normal[3][LANES], relative_displacement[3][LANES], previous_force[3][LANES];
    double current_u[3][LANES], candidate_u[3][LANES], current_force[3][LANES],
        candidate_force[3][LANES];
    /* copies of the constraint's fields */
    double gap[LANES], stiffness[LANES], tangential_stiffness[LANES], friction[LANES];
    double bilateral[LANES]; /* 1.0 if bilateral */
    bool is_sleeve[LANES];
} contact_simd_batch;

/* Status and force of a constraint at the end of a substep: the initial guess in the next. */
typedef struct contact_warm_start_entry {
    contact_key key;
    uint8_t status; /* contact_status */
    bool is_forward;
    bool has_constraint; /* set by vbss_contact_warm_start: a constraint has this key */
    double normal_force, friction_ratio;
    vec3 tangential_force;
} contact_warm_start_entry;

/* Progress of the active-set iteration. */
typedef struct contact_active_set_progress {
    uint32_t solve_count; /* solves so far */
    double stiffness_scale;
    uint32_t solves_at_scale; /* solves with the current stiffness_scale */
    bool has_softened;        /* the stiffness has been reduced once; it will not be again */
    bool has_lagged;          /* some sleeve has a lagged yield force */
    /* relative residual when it was last halved */
    double reference_residual;
    uint32_t stalled_solves; /* solves since the residual was last halved */
} contact_active_set_progress;

/* The budget of one call. Work may be suspended before a solve or a linearisation, and the next
 * call resumes it without any change. A check precedes each of them; the number of checks passed
 * identifies the point in the attempt. */
typedef struct contact_call_budget {
    /* in the unit of contact_counters.operations; work that would exceed it is suspended. 0 for no
     * limit */
    uint64_t operation_limit;
    bool has_progress;      /* this call has done some work; until then no check suspends */
    uint32_t checks_passed; /* checks passed in this attempt */
    /* the attempt is repeated after a restore: it suspends where it did before */
    bool is_replay;
    uint32_t replay_checks; /* checks to pass before it suspends */
} contact_call_budget;

typedef struct contact_counters {
    uint64_t solves;  /* solves of the separators' system */
    uint64_t inexact; /* solutions accepted with a residual */
    /* products of 3x3 blocks, or work of equal cost, by all modules */
    uint64_t operations;
} contact_counters;

typedef struct contact_weld contact_weld;

typedef struct contact_set {
    uint32_t capacity, count, warm_start_count;
    contact_constraint *constraints; /* sorted by ascending keys */
    /* scratch of the sort: original index of each constraint */
    uint32_t *sort_permutation;
    contact_warm_start_entry *warm_start; /* sorted by ascending keys */
    /* warm-start entries at the last vbss_contact_checkpoint */
    contact_warm_start_entry *checkpoint;
    uint32_t checkpoint_count;
    contact_solution *next_solutions; /* per constraint: solution according to the last solve */
    /* per constraint: copy by vbss_contact_save_solution */
    contact_solution *saved_solutions;
    /* per constraint: current iterate, and candidate of the last solve */
    contact_iterate *current, *candidate;
    /* scratch of the line search; the last batch is padded with empty constraints */
    contact_simd_batch *simd_batches;
    /* for each constraint of n blocks: n^2 indices of its pairs, row by row, then n indices of its
     * right-hand sides */
    uint32_t *schur_indices;
    uint32_t schur_index_count, schur_index_capacity;
    double residual; /* violation of the contact law after the last solve, N */
    /* the last iteration stopped at its operation limit without a solution of the contact law */
    bool is_stopped_early;
    bool was_stopped_early;               /* saved with saved_solutions */
    contact_active_set_progress progress; /* the iteration in progress */
    contact_call_budget call_budget;
    contact_counters counters;
    /* residual and counters at the last checkpoint */
    double checkpoint_residual;
    contact_counters checkpoint_counters;
} contact_set;

/* Creates a set of at most `capacity` constraints. VBSS_ERROR_OUT_OF_MEMORY. */
vbss_result vbss_contact_create(vbss_context *context, uint32_t capacity, contact_set **set);
void vbss_contact_destroy(vbss_context *context, contact_set *set);

/* The list of constraints (constraints.c). vbss_contact_add returns NULL if the set is full. Keys
 * may come in any order; vbss_contact_sort sorts them, and no constraint is added after that. */
void vbss_contact_clear(contact_set *set);
contact_constraint *vbss_contact_add(contact_set *set, const contact_key *key);
/* Adds a constraint also to a full set: the caller removes the last one again, by `count`, if it is
 * not needed or there are more than `capacity`. Never NULL. */
contact_constraint *vbss_contact_try(contact_set *set, const contact_key *key);
void vbss_contact_sort(contact_set *set);
/* Copies a constraint, but no unused blocks of its Jacobian, which are most of the record. */
void vbss_contact_move(contact_constraint *to, const contact_constraint *from);
/* Index of the constraint with this key in a sorted list, or UINT32_MAX. */
uint32_t vbss_contact_find(const contact_set *set, const contact_key *key);
/* Warm start of the sorted constraints. Each gets status and force of the entry with its key, if
 * there is one. For an entry without one (has_constraint is false) the contact is gone or has slid on to
 * neighbouring features. vbss_contact_warm_start_neighbour passes it to the first open constraint
 * within one feature number of its own; vbss_contact_warm_start_one to a given constraint. */
void vbss_contact_warm_start(contact_set *set);
void vbss_contact_warm_start_neighbour(contact_set *set, uint32_t entry_index);
void vbss_contact_warm_start_one(contact_set *set, uint32_t entry_index, uint32_t constraint_index);
/* Stores the constraints that carry a force as warm-start entries, once the substep is accepted.
 * In a substep of some of the bodies, entries with a nonzero flag in `keeps` stay beside them. */
void vbss_contact_store_warm_start(contact_set *set);
void vbss_contact_store_warm_start_beside(contact_set *set, const uint8_t *keeps);
/* Copies warm-start entries, residual and counters, and returns to that copy. */
void vbss_contact_checkpoint(contact_set *set);
void vbss_contact_rollback(contact_set *set);
/* Largest penetration of the unilateral constraints at their present gaps, m; and whether none
 * exceeds its allowed_penetration. */
double vbss_contact_max_penetration(const contact_set *set);
bool vbss_contact_penetration_is_allowed(const contact_set *set);

/* Constraints in the system (constraint_assembly.c). vbss_contact_register couples the separators
 * of each constraint; vbss_contact_find_schur_indices finds the indices of their blocks after the
 * analysis. vbss_contact_assign_schur_offsets is enough if the last list had the same keys: the
 * indices are then still valid. */
vbss_result vbss_contact_register(const contact_set *set, vbss_system *system);
void vbss_contact_find_schur_indices(contact_set *set, const vbss_system *system);
void vbss_contact_assign_schur_offsets(contact_set *set);
/* Adds stiffness and forces of all constraints, linearised in their present status, to the
 * separators' system. */
void vbss_contact_assemble(const contact_set *set, vbss_system *system);

/* ---- the law (contact_law.c) */

/* Linearised force of a constraint in its present status: force - sum over the directions of
 * stiffness * left (right . u). */
typedef struct contact_linearisation {
    uint32_t count; /* number of directions */
    vec3 left[3];   /* direction of the force */
    vec3 right[3];  /* direction of u that changes it */
    double stiffness[3];
    vec3 force; /* on a, at the trial state, N */
} contact_linearisation;
void vbss_contact_linearise(const contact_constraint *constraint,
                            contact_linearisation *linearisation);
/* Computes status and forces after a relative displacement u. Returns the violation of the contact
 * law in the present status, N. */
double vbss_contact_update_solution(const contact_constraint *constraint, vec3 u,
                                    contact_solution *next);
/* Force on a after a relative displacement u, N: by the linearisation in the present status, and by
 * the contact law. */
vec3 vbss_contact_linearised_force(const contact_constraint *constraint, vec3 u);
vec3 vbss_contact_force(const contact_constraint *constraint, vec3 u);
/* Sleeve: how far it has torn at the trial state, across its normal and with the suture, m. */
vec3 vbss_contact_tear_slip(const contact_constraint *constraint);
/* Solution with which the iteration continues from this iterate. */
void vbss_contact_solution_at(const contact_constraint *constraint, const contact_iterate *iterate,
                              contact_solution *next);
/* Rotates a remembered tangential force into the tangent plane of a new normal, with its length. */
vec3 vbss_contact_rotate_to_tangent_plane(vec3 force, vec3 normal);

/* ---- welds (weld.c): a node that is a point of a rigid body */

/* Three nodes on either side, and for those that are welded too, the blocks of their bodies. */
enum { CONTACT_WELD_MAX_NEIGHBOURS = 18 };
struct contact_weld {
    uint32_t node, translation, rotation; /* blocks */
    vec3 arm;                             /* from the centre of mass to the node, m */
    uint32_t neighbour_count;
    /* Separators that are coupled with the node; for nodes that earlier welds have eliminated, also
     * the blocks of their bodies. */
    uint32_t neighbours[CONTACT_WELD_MAX_NEIGHBOURS];
};
/* Couples the body's blocks with the node's neighbours. Requires that the neighbours are
 * registered. */
vbss_result vbss_contact_register_weld(const contact_weld *weld, vbss_system *system);
/* Moves the node's rows and columns in the separators' system to the body. The node's own equation
 * becomes trivial, with increment zero. Exact: the body's increments are those of the joined
 * system. */
void vbss_contact_eliminate_weld(const contact_weld *weld, vbss_system *system);
/* The node's increment that follows from the body's increments, m. */
vec3 vbss_contact_weld_increment(const contact_weld *weld, const vbss_system *system);

/* ---- springs (spring.c): linear stiffness between separators, without a status */

enum { CONTACT_SPRING_BLOCKS = 8 };
/* Its elongation is the sum over the blocks of gradient . increment. Its force belongs to the bodies. */
typedef struct contact_spring {
    uint32_t count;
    uint32_t blocks[CONTACT_SPRING_BLOCKS]; /* differ */
    vec3 gradients[CONTACT_SPRING_BLOCKS];
    double stiffness; /* not negative */
    /* indices of its pairs, row by row */
    uint32_t schur_indices[CONTACT_SPRING_BLOCKS * CONTACT_SPRING_BLOCKS];
} contact_spring;
/* Couples the separators of a spring; finds the indices of its blocks after the analysis. */
vbss_result vbss_contact_register_spring(const contact_spring *spring, vbss_system *system);
void vbss_contact_find_spring_indices(contact_spring *spring, const vbss_system *system);
/* Adds its stiffness to the separators' system. */
void vbss_contact_assemble_spring(const contact_spring *spring, vbss_system *system);

/* ---- active set (active_set.c) */

typedef struct contact_active_set_options {
    vbss_system *system; /* after vbss_system_condense */
    const contact_weld *welds;
    uint32_t weld_count;
    const contact_spring *springs; /* of no welded node */
    uint32_t spring_count;
    uint32_t max_solves; /* limit of solves; CONTACT_NOT_CONVERGED beyond it */
    /* Tolerances of the contact law: on forces, relative to the largest normal force plus absolute
     * in N; on penetration of an open constraint, relative to the thickness. */
    double relative_force_tolerance, absolute_force_tolerance, overlap_tolerance;
    /* Loose tolerances, which accept an inexact solution after max_stalled_solves solves without
     * halving the residual. */
    uint32_t max_stalled_solves;
    double loose_force_tolerance, loose_overlap_tolerance;
    /* Operations beyond which no solve starts, except the first. The iteration then stops at its
     * current iterate: forces are in equilibrium, and the line search has reduced the violation. 0
     * for no limit. */
    uint64_t operation_limit;
    /* start from the constraints' forces of an earlier linearisation; only with an operation
     * limit */
    bool starts_from_current;
    /* continue a suspended iteration; set and system must be unchanged */
    bool is_resumed;
} contact_active_set_options;
typedef enum contact_outcome {
    CONTACT_CONVERGED,
    CONTACT_INEXACT,
    CONTACT_NOT_CONVERGED,
    CONTACT_SINGULAR,
    CONTACT_SUSPENDED
} contact_outcome;
/* Finds the status of all constraints and the increments of all separators by a primal-dual active
 * set. */
contact_outcome vbss_contact_solve_active_set(contact_set *set,
                                              const contact_active_set_options *options);
/* Whether work of this many operations must wait for the next call. */
bool vbss_contact_must_suspend(contact_set *set, uint64_t operations);

/* Line search between the current and the candidate iterates (line_search.c).
 * vbss_contact_begin_line_search stores constraints and both iterates. The slope at a fraction of
 * the step is the work of the residual force, the equilibrium force minus that of the contact law,
 * over the whole step, N m. */
void vbss_contact_begin_line_search(contact_set *set, bool wide);
double vbss_contact_line_search_slope(const contact_set *set, bool wide, double fraction);
/* Plain and wide copies of line_search.c. */
void vbss_contact_begin_line_search_plain(contact_set *set);
void vbss_contact_begin_line_search_wide(contact_set *set);
double vbss_contact_line_search_slope_plain(const contact_set *set, double fraction);
double vbss_contact_line_search_slope_wide(const contact_set *set, double fraction);

/* Copies the present solutions, and returns to that copy. */
void vbss_contact_save_solution(contact_set *set);
void vbss_contact_restore_solution(contact_set *set);

/* Visits warm-start entries, residual and counters with nine tags from first_tag on
 * (snapshot.c). */
void vbss_contact_serialise(vbss_stream *stream, uint16_t first_tag, contact_set *set);

#endif
