/* The inside of a suture thread, shared by the files of lib/thread.
 *
 * Nodes 0 .. n-1, segments 0 .. n-2. thread.c makes and ends threads; derived.c works out what follows
 * from attachments and rest lengths; a step is implicit_step.c (method OURS: predict, measure,
 * assemble, solve, commit) or paper_step.c (method PAPER). */
#ifndef VBSS_THREAD_THREAD_H
#define VBSS_THREAD_THREAD_H

#include <vblast_ss/thread.h>

#include "base/linear.h"
#include "base/slot.h"
#include "solver/solver.h"

/* Neighbours to either side that a bending energy reaches; one more from the node of a clamp. */
enum {
    THREAD_BANDWIDTH = 3,
    THREAD_CLAMP_BANDWIDTH = THREAD_BANDWIDTH + 1,
    THREAD_STENCIL_NODES = THREAD_CLAMP_BANDWIDTH + 1
};

typedef struct thread_attachment {
    uint32_t id; /* 0: the place is free */
    vbss_attachment_kind kind;
    uint32_t node;
    vec3 position, target;            /* PIN, CLAMP, SPRING: now, and after the next step */
    vec3 direction, target_direction; /* CLAMP: the same, unit */
    vec3 velocity;                    /* at which it came to position in the last step */
    vec3 force;                       /* FORCE */
    double stiffness, damping;        /* SPRING */
    double mass;                      /* MASS */
    vec3 reaction, reaction_torque;   /* of the last step, on the thread */
    /* Of a step of its scene that waits, while it waits; else of the host: see vbss_thread_swap_targets. */
    vec3 alternate_target, alternate_direction, alternate_force;
} thread_attachment;

/* What moves in a step. n of each, n - 1 tensions. */
typedef struct thread_state {
    vec3 *x, *v;
    vec3 *a; /* OURS: accelerations as the integration carries them on */
    vec3 *q; /* OURS: accelerations that balanced the forces at the end of the step */
    double *tension;
} thread_state;

/* A clamp as the bending energy knows it: 1/2 own t.t + sum factor x.t + next t.t' with the direction
 * t, the nodes around it and the next clamp's direction t'. */
typedef struct thread_clamp {
    uint32_t attachment_index; /* of its attachment */
    uint32_t node;
    double coefficient[2 * THREAD_CLAMP_BANDWIDTH + 1]; /* of nodes node - 4 .. node + 4 */
    double own_coefficient, next_coefficient;
    vec3 direction; /* at the end of the substep under way, else now */
} thread_clamp;

/* A segment's arc: length of the chord plus share |sum factor x + clamped|^2. */
typedef struct thread_arc {
    double coefficient
        [4]; /* of nodes segment - 1 .. segment + 2; the sum is the mean curvature, 1/m */
    double length_coefficient; /* rest length^3 / 24; 0: chords are lengths */
    vec3 clamp_curvature;      /* what directions of clamps contribute */
    double clamp_coefficient
        [2]; /* factors of the directions of the clamps at the ends of its stretch */
    uint32_t clamp_index[2]; /* which those are */
} thread_arc;

/* A turn of the thread as a linear form: of nodes first .. first + 4 and of the directions of the
 * clamps at the two ends of its stretch. */
typedef struct thread_linear_form {
    uint32_t first_node;
    double node[THREAD_STENCIL_NODES];
    double clamp[2];
} thread_linear_form;

/* A second derivative of the spline: its equation while the bending energy is worked out. */
typedef struct thread_spline_moment {
    thread_linear_form turn;
    double diagonal, off_diagonal; /* factors of itself and of the next */
    double row_sum;                /* of the factors of those that are left */
} thread_spline_moment;

/* Geometry of a segment in a trial state. */
typedef struct thread_strain {
    vec3 tangent; /* of the chord */
    double chord;
    vec3 curvature;    /* mean of the arc */
    double elongation; /* length - rest length */
} thread_strain;

/* Method PAPER: what a step knows of node i and of segment i. */
typedef struct thread_paper_row {
    double inverse_mass; /* of the node, resistance times dt counted as mass; 0: held */
    double resistance;   /* of the node to its velocity: drag and attached springs, N s/m */
    double inverse_rest; /* of the segment */
    double stiffness;    /* of the segment's spring, N/m */
    double multiplier;   /* of its constraint in the substep under way: tension times dt^2 */
    vec3 edge;           /* over its rest length, with its square */
    double square;
    double right,
        ratio; /* of the tridiagonal system: right-hand side, then solution; elimination */
} thread_paper_row;

/* Spare threads for the pieces of a family of cuts; the last user gives it back: the threads of the family, and
 * the spares that a scene has taken. */
typedef struct thread_piece_pool {
    uint32_t reference_count, available, capacity;
    struct thread_object **pieces;
    vbss_slot **slots;
} thread_piece_pool;

typedef struct thread_object {
    vbss_context *context;
    vbss_thread_config config; /* with its pointers NULL; the same for all pieces */
    uint32_t node_capacity, node_count;
    uint64_t generation;
    uint64_t edit_generation; /* by hosts, of anything but where attachments go */
    vec3 gravity;
    thread_piece_pool *piece_pool;

    /* the state */
    double *rest; /* rest lengths */
    thread_state now;
    thread_attachment *attachments; /* config.attachment_capacity places */
    uint32_t last_id;
    bool is_acceleration_unknown; /* OURS: nothing is known of accelerations */
    bool is_in_setup; /* being set up: no step since it was created or its state was set */
    uint32_t damped_steps_left;     /* OURS: steps still to be made by backward Euler */
    double previous_h;              /* OURS: length of the last part of a step, s; 0 when fresh */
    uint32_t next_segment_to_check; /* of an adaptive mesh: the segment that is looked at next */
    vbss_thread_statistics statistics;

    /* what follows from rest lengths and attachments (derived.c) */
    bool is_derived_valid, is_sparsity_valid; /* pattern: of its own system */
    uint32_t *prescribed_by;                  /* per node: 1 + place of its PIN or CLAMP, or 0 */
    uint8_t *welded;                          /* per node: a body of its scene holds it */
    double *mass;                             /* per node, attached masses included */
    double *inverse_rest;                     /* per segment, 1/m */
    double *rest_arc_length;                  /* per node: arc length from the begin, at rest, m */
    double min_rest_length;                   /* m */
    uint32_t *sections; /* first node of each section: held nodes and both ends divide */
    uint32_t section_count;
    double (
        *bending_matrix)[THREAD_STENCIL_NODES]; /* OURS: row i, factors of x[i] .. x[i + 4], N/m */
    thread_spline_moment *spline_moments;       /* OURS: scratch of bending.c */
    thread_arc *arcs;                           /* OURS */
    thread_clamp *clamps;                       /* OURS, by node */
    uint32_t clamp_count;
    uint32_t (*couplings)[THREAD_BANDWIDTH]; /* OURS: of block i with i + 1 .. i + 3 */
    vbss_system *system; /* OURS: the system of a thread that is stepped alone */

    /* room for a step: nothing here outlives it */
    thread_state saved; /* the state before the step, once its first part has been committed */
    vec3 *trial;        /* positions */
    vec3 *x_predicted, *v_predicted, *a_predicted;
    double *trial_tension;
    vec3 *rest_curvature_forces; /* OURS: forces of rest curvature */
    thread_strain *strains;
    thread_paper_row *paper_rows; /* PAPER */

    /* views that are worked out when asked for */
    double *lengths, *sagittas;
    vec3 *curvatures;
} thread_object;

extern const vbss_kind vbss_thread_kind;

/* thread.c: memory of a thread of that size, without a handle; and its end. */
vbss_result vbss_thread_allocate(vbss_context *context, const vbss_thread_config *config,
                                 uint32_t node_capacity, thread_object **thread);
void vbss_thread_free(vbss_context *context, void *object);
/* One user less. */
void vbss_thread_release_piece_pool(vbss_context *context, thread_piece_pool *pool);
/* The living thread of a handle, to look at or to change. */
vbss_result vbss_thread_open(const vbss_thread *handle, thread_object **thread);
vbss_result vbss_thread_edit(vbss_thread *handle, thread_object **thread);
/* The same for what is a scene's business while the thread belongs to one. */
vbss_result vbss_thread_edit_unowned(vbss_thread *handle, thread_object **thread);
/* cut.c: where a cut would be, which changes nothing. */
typedef struct thread_cut {
    uint32_t segment;          /* that is divided, or before the node that is doubled */
    double fraction;           /* of the segment that stays; 1: its end node is doubled */
    uint32_t first_piece_node; /* the first that goes to the piece */
    uint32_t node_shift;       /* by which its number is less there */
} thread_cut;
/* From the begin to a node, at rest, m. */
double vbss_thread_arc_length(const thread_object *t, uint32_t node);
/* False: at an end, where nothing is cut. */
bool vbss_thread_locate_cut(const thread_object *t, double arc_length, thread_cut *cut);
/* Nodes and attachments beyond the cut go to a spare thread of the same reserve. */
void vbss_thread_apply_cut(thread_object *t, thread_object *piece, const thread_cut *cut);
/* Takes a spare from the reserve of a thread, with the slot of its handle; NULL: none is left. Whoever takes one
 * keeps it as a piece, or gives it back; the reserve lives as long as anybody has one. */
thread_object *vbss_thread_acquire_piece(thread_object *t, vbss_slot **slot);
void vbss_thread_return_piece(thread_object *piece, vbss_slot *slot);

/* The end of a step of h seconds, alone or in a scene. */
void vbss_thread_finish_step(thread_object *t, double h);
/* After every change that is not a step: views are old, accelerations unknown. */
void vbss_thread_invalidate(thread_object *t);

/* snapshot.c */
void vbss_thread_serialise(vbss_stream *stream, void *object);
void vbss_thread_copy_state(const thread_object *t, thread_state *to, const thread_state *from);

/* attachments.c */
bool vbss_thread_prescribes_motion(vbss_attachment_kind kind);
thread_attachment *vbss_thread_find_attachment(thread_object *t, uint32_t id);
/* Where an attachment is after a part of the step, from 0 to 1. */
vec3 vbss_thread_attachment_position(const thread_attachment *a, double fraction);
vec3 vbss_thread_attachment_direction(const thread_attachment *a, double fraction);
/* A step of its scene may wait while hosts say where attachments go in the next. At its begin both are the same; then they change
 * places whenever the step goes on, and whenever it waits or ends. */
void vbss_thread_save_targets(thread_object *t);
void vbss_thread_swap_targets(thread_object *t);
/* At the end of a step: what was to move has arrived. */
void vbss_thread_commit_attachments(thread_object *t, double h);

/* reactions.c: at the end of a step, when attachments have arrived. */
void vbss_thread_update_reactions(thread_object *t);

/* derived.c: what follows from rest lengths and attachments; with the pattern of its own system; and for
 * looking, with clamps where they are now. */
vbss_result vbss_thread_update_derived(thread_object *t);
/* Which nodes are held, and the masses alone. */
void vbss_thread_compute_masses(thread_object *t);
vbss_result vbss_thread_update_sparsity(thread_object *t);
vbss_result vbss_thread_prepare_query(thread_object *t);
bool vbss_thread_is_clamped(const thread_object *t, uint32_t node);
/* Neighbours on either side that a node is coupled with. */
uint32_t vbss_thread_bandwidth(const thread_object *t);
/* The thread's chain in a system: a block a node, from `first` on. `separators` marks nodes in which
 * others take part, in groups as wide as the reach; may be NULL. */
vbss_result vbss_thread_add_to_system(thread_object *t, vbss_system *s, const uint8_t *separators,
                                      uint32_t *first);
/* bending.c: fills bending, clamps, arcs of method OURS. */
void vbss_thread_build_bending(thread_object *t);
/* energy.c: of bending, rest curvature included; method PAPER has its own. */
double vbss_thread_bending_energy(const thread_object *t);
/* What it has more in the trial state, h after the state, of stretch and of motion; method OURS. */
double vbss_thread_energy_change(const thread_object *t, double h);
double vbss_thread_paper_bending_energy(const thread_object *t);
/* bending.c: curvature vector at a node: turn of the chord's direction over the mean rest length; at a clamp the
 * curvature of the side toward higher nodes, else the other; zero at free ends. */
vec3 vbss_thread_curvature(const thread_object *t, const vec3 *x, uint32_t node);
/* Directions of the clamps after a part of the step, into clamps and arcs. */
void vbss_thread_set_clamp_directions(thread_object *t, double fraction);
/* Of the clamp that holds the node. */
vec3 vbss_thread_clamp_direction(const thread_object *t, uint32_t node);

/* rest_curvature.c: what rest curvature adds; the slope is of the energy with a clamp's direction. */
double vbss_thread_rest_curvature_energy(const thread_object *t);
vec3 vbss_thread_rest_curvature_gradient(const thread_object *t, uint32_t node);
void vbss_thread_add_rest_curvature_forces(const thread_object *t, const vec3 *x, vec3 *forces);
vec3 vbss_thread_rest_curvature_force(const thread_object *t, uint32_t node);

/* strain.c: geometry of the segments; and of what was measured the largest stretch and stretch error,
 * for the statistics of the last step. */
void vbss_thread_compute_strains(const thread_object *t, const vec3 *x, thread_strain *strains);
double vbss_thread_record_stretch(thread_object *t, const double *tension);

/* assemble.c, both copies: the thread's part of the system at the trial state. */
typedef struct thread_substep {
    const vbss_integration *integration;
    double step_length;   /* length of the whole step, s */
    double end_fraction;  /* of the step, where attachments are then */
    double min_tension;   /* N, not positive: most compression that the stiffness takes in */
    double buckling_load; /* N, positive: compression that surely leaves the stiffness positive */
    double
        max_acceptable_strain; /* beyond the tensions', up to which an unconverged state may be taken */
} thread_substep;
void vbss_thread_assemble_plain(const thread_object *t, const thread_substep *substep,
                                vbss_system *system, uint32_t first_block);
void vbss_thread_assemble_wide(const thread_object *t, const thread_substep *substep,
                               vbss_system *system, uint32_t first_block);

/* substep.c: the trial state of a part of a step. Predict fills it, with held nodes at the end of the part;
 * false says that this is no smooth motion. Strains are those of the trial state. */
bool vbss_thread_predict(thread_object *t, thread_substep *substep);
/* Free nodes go back to where the part began; strains are not measured. */
void vbss_thread_reset_trial(thread_object *t);
/* Moves the trial state by the increments u of the nodes. Returns the largest distance that forces left out
 * of balance would move a node: what a further linearisation could change. */
double vbss_thread_apply_increment(thread_object *t, const thread_substep *substep, const vec3 *u);
double vbss_thread_linearisation_error(const thread_object *t, const vec3 *u);
/* Where nothing sound was found: all free nodes stop where they are. False: not even that is finite. */
bool vbss_thread_freeze_trial(thread_object *t);
/* The trial state becomes the state. */
void vbss_thread_commit(thread_object *t, const vbss_integration *in);
/* The largest strain of the trial state beyond that of the tensions. */
double vbss_thread_strain_beyond_tension(const thread_object *t);
/* Whether the trial state is strained less than now, by the largest strains of either sign. */
bool vbss_thread_max_tension_decreased(const thread_object *t);
/* The compression under which a straight thread with its inertia as foundation buckles at a free end. */
double vbss_thread_buckling_load(const thread_object *t, double inertia);
/* rest_curvature.c: what rest curvature pulls in the trial state. */
void vbss_thread_update_rest_curvature_forces(thread_object *t);

/* section_damping.c: takes that share of what the free nodes of each section do beyond its rigid motion. */
void vbss_thread_damp_sections(thread_object *t, double fraction);

/* implicit_step.c, paper_step.c */
vbss_result vbss_thread_implicit_step(thread_object *t, double h);
vbss_result vbss_thread_paper_step(thread_object *t, double h);
/* The force that holds a held node at the end of the last step; constraint_force.c, paper_step.c. OURS
 * reads the strains of that step. */
vec3 vbss_thread_implicit_constraint_force(const thread_object *t, uint32_t node);
vec3 vbss_thread_paper_force(const thread_object *t, uint32_t node);
vec3 vbss_thread_paper_torque(const thread_object *t, uint32_t node);

#endif
