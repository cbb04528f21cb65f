/* A suture thread: data and functions that the files of lib/thread share.
 *
 * A thread has nodes 0 .. n - 1 and segments 0 .. n - 2. A step of the implicit method:
 *
 *   predict -> [strains -> assemble -> solve -> apply increment] until converged -> commit
 *
 * implicit_step.c does this for a thread on its own. A scene makes these calls in each substep,
 * with all bodies in one system. */
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

/* Friction torque: the largest span whose twist is part of the matrix; the end of a span at a holder. */
enum { THREAD_EXACT_SPAN_NODES = 6 };
#define THREAD_NO_ROLL UINT32_MAX

typedef struct thread_attachment {
    uint32_t id; /* 0: unused */
    vbss_thread_attachment_kind kind;
    uint32_t node;
    vec3 position, target;            /* PIN, CLAMP, SPRING: current, and after the next step, m */
    vec3 direction, target_direction; /* CLAMP: unit, current, and after the next step */
    vec3 velocity;                    /* m/s, in the last step */
    vec3 force;                       /* FORCE: N */
    double stiffness, damping;        /* SPRING: N/m, N s/m */
    double mass;                      /* MASS: kg */
    vec3 reaction, reaction_torque;   /* on the thread in the last step, N and N m */
    /* While a step of the scene is suspended, its target, direction and force; while it runs, those
     * of the host. See vbss_thread_swap_targets. */
    vec3 alternate_target, alternate_direction, alternate_force;
    /* Twist, CLAMP and ROLL: angle about the thread, rad: current, after the next step, and alternate
     * as above */
    double roll, target_roll, alternate_roll;
    uint32_t owner; /* ROLL of a scene: a number of its pin or grasp; 0: a host's */
    quat
        owner_orientation; /* of the body that it belongs to, at the end of the step of its target_roll */
} thread_attachment;

/* What one side of a node remembers of its bends; see bending_memory.c. */
typedef struct thread_bend_memory {
    vec3 plane; /* unit, across the thread; zero: it was never bent */
    /* signed along the plane, 1/m: at the end of the last step, plastic, viscous */
    double curvature, plastic, viscous;
} thread_bend_memory;

/* Response of one side of a node to the trial state, beyond that of bending.c. */
typedef struct thread_bend_response {
    vec3 curvature;       /* 1/m */
    vec3 moment;          /* N m */
    vec3 direction;       /* unit or zero */
    double along, across; /* slopes of the moment with the curvature, N m^2 */
    double length;        /* of the cell, m; 0: there is none */
    bool before, after;   /* whether the chords on either side take part */
} thread_bend_response;

/* State of an attachment that holds the section of the thread; see twist_spans.c. */
typedef struct thread_section_frame {
    vec3 direction; /* unit: of a clamp, or of the chord beside the node */
    vec3 director;  /* unit, across it; moves with it without spin */
    double
        shape_twist; /* twist of the span from this holder to the next, without their rolls, rad */
} thread_section_frame;

/* An attachment that holds the section of the thread. */
typedef struct thread_section_holder {
    uint32_t attachment_index, node;
    bool is_clamp; /* it holds the direction, too */
    vec3
        direction; /* of a clamp, unit, at the end of the current substep; between steps the current one */
    double roll; /* the same, rad */
} thread_section_holder;

/* The thread between two holders that follow each other, in the trial or in the current state. */
typedef struct thread_twist_span {
    uint32_t low, high;       /* nodes of the holders */
    uint32_t holder_index[2]; /* in thread_object::holders; unused at the segment of a contact */
    bool is_clamped[2];       /* an end has the direction of a clamp, or that of its chord */
    vec3 direction[2],
        director[2];        /* of the holders; without clamp those at the start of the substep */
    double length;          /* at rest, m */
    double roll_difference; /* roll of the high holder minus that of the low one, rad */
    /* Friction torque: the segment of a contact at an end, THREAD_NO_ROLL at a holder; and the part of
     * roll_difference that is due to holders, rad */
    uint32_t roll_segment[2];
    double held_difference;
    double shape_twist, twist; /* without and with that difference, rad */
    double torque;             /* N m */
    /* angle between the directors, and shape_twist, at the start of the substep, rad */
    double start_angle, start_twist;
} thread_twist_span;

/* Stiffness of twist at one side of a node, N/m: second derivatives with the chords before and after it. */
typedef struct thread_twist_stiffness {
    mat3 before, mixed, after; /* mixed: rows of the chord before */
    bool has_before, has_after;
} thread_twist_stiffness;

/* Motion of a thread: an entry of x, v, a, q for each node, a tension for each segment. */
typedef struct thread_state {
    vec3 *x, *v;
    vec3 *a;         /* accelerations that the integrator carries on, m/s^2 (implicit method) */
    vec3 *q;         /* accelerations from forces at the end of the step, m/s^2 (implicit method) */
    double *tension; /* N */
    /* two entries for each node, for the sides towards lower and higher nodes; no entries without
     * memory (implicit method) */
    thread_bend_memory *bend;
    double dissipated_energy; /* by memory since creation, J */
    /* an entry for each attachment, used by those that hold the section; no entries without twist
     * (implicit method) */
    thread_section_frame *frames;
    /* friction torque; no entries without it: twist of both halves of each segment, rad, and the roll of
     * each attachment that holds the section, rad */
    double *half_twists, *held_rolls;
} thread_state;

/* Part of a clamp in the bending energy:
 *
 *   1/2 own_coefficient t.t + sum coefficient[k] x_k.t + next_coefficient t.t'
 *
 * where t is its direction, t' that of the next clamp, and x_k are the nodes around it. */
typedef struct thread_clamp {
    uint32_t attachment_index; /* index of its attachment */
    uint32_t node;
    /* coefficients of nodes `node` - THREAD_CLAMP_BANDWIDTH .. `node` + THREAD_CLAMP_BANDWIDTH */
    double coefficient[2 * THREAD_CLAMP_BANDWIDTH + 1];
    double own_coefficient, next_coefficient;
    vec3 direction; /* unit, at the end of the current substep; between steps the current one */
} thread_clamp;

/* Arc of a segment. Its length is that of the chord plus length_coefficient |curvature|^2. */
typedef struct thread_arc {
    /* Coefficients of nodes segment - 1 .. segment + 2. With clamp_curvature they give the mean
     * curvature, 1/m. */
    double coefficient[4];
    double length_coefficient;   /* rest length^3 / 24, m^3; 0: the length is that of the chord */
    vec3 clamp_curvature;        /* part of the curvature from directions of clamps, 1/m */
    double clamp_coefficient[2]; /* coefficients of the clamps at both ends */
    uint32_t clamp_index[2];     /* indices of these clamps */
} thread_arc;

/* Turn of the thread as a linear form of nodes first_node .. first_node + 4 and of the directions
 * of the clamps at both ends of its clamp interval. */
typedef struct thread_linear_form {
    uint32_t first_node;
    double node[THREAD_STENCIL_NODES];
    double clamp[2];
} thread_linear_form;

/* A spline moment (second derivative at a node) as one row of the spline's equations, while the
 * bending energy is built. */
typedef struct thread_spline_moment {
    thread_linear_form turn;
    double diagonal, off_diagonal; /* coefficients of this moment and of the next */
    double row_sum;                /* sum of the coefficients that are left after elimination */
} thread_spline_moment;

/* Geometry of a segment in a trial state. */
typedef struct thread_strain {
    vec3 tangent;      /* unit, of the chord */
    double chord;      /* length of the chord, m */
    vec3 curvature;    /* mean over the arc, 1/m */
    double elongation; /* length minus rest length, m */
} thread_strain;

/* Spare threads and handles for the pieces that later cuts create. A thread and its pieces share
 * one pool, which is freed with the last reference: threads of the family, and spares that a scene
 * has reserved. */
typedef struct thread_piece_pool {
    uint32_t reference_count, available, capacity;
    struct thread_object **pieces;
    vbss_slot **slots;
} thread_piece_pool;

typedef struct thread_object thread_object;

/* What the method of a thread does. The table is chosen once, when a thread is created. */
typedef struct thread_method {
    /* Memory of the method, when that of all methods is there; destroy_thread follows also when this fails. */
    vbss_result (*create_thread)(thread_object *t);
    void (*destroy_thread)(vbss_context *context, thread_object *t);
    /* One step of h seconds. On failure the state is that before the step. */
    vbss_result (*step_thread)(thread_object *t, double h);
    double (*bending_energy)(const thread_object *t); /* J, rest curvature included */
    /* At the end of the last step, at a node whose motion is prescribed: the force that holds it, N, all
     * that pulls there included; the reaction of its attachment, N and N m. */
    vec3 (*constraint_force)(const thread_object *t, uint32_t node);
    /* Axial force of each segment at the end of the last step, N; valid until the next call. */
    const double *(*axial_forces)(thread_object *t);
    vec3 (*reaction_force)(const thread_object *t, uint32_t node);
    vec3 (*reaction_torque)(const thread_object *t, uint32_t node);
    /* Counters that only this method has, part of the state; NULL: it has none. */
    vbss_baseline_statistics *(*baseline_statistics)(const thread_object *t);
    bool corrects_masses; /* lumped masses have the end corrections of derived.c */
    bool is_guarded;      /* CCD keeps the thread from passing through other bodies in a scene */
} thread_method;
extern const thread_method vbss_thread_implicit; /* implicit_method.c */
extern const thread_method vbss_baseline_thread; /* defined in lib/baseline */

struct thread_object {
    const thread_method *method;
    vbss_context *context;
    vbss_thread_config config;            /* pointers are NULL; equal for all pieces */
    vbss_baseline_config baseline_config; /* what config.baseline points to */
    uint32_t node_capacity, node_count;
    uint64_t generation;
    uint64_t edit_generation; /* counts edits by hosts, except new targets */
    vec3 gravity;
    thread_piece_pool *piece_pool;

    /* state */
    double *rest; /* rest lengths, m */
    thread_state now;
    thread_attachment *attachments; /* config.attachment_capacity entries */
    uint32_t last_id;
    bool is_acceleration_unknown; /* after creation or an edit (implicit method) */
    bool is_in_setup;             /* no step since creation or since the state was set */
    uint32_t damped_steps_left;   /* steps that still use backward Euler (implicit method) */
    double previous_h;            /* length of the last substep, s; 0: unknown (implicit method) */
    /* adaptive mesh: the first segment to check after the next step */
    uint32_t next_segment_to_check;
    vbss_thread_statistics statistics;

    /* derived data: functions of rest lengths and attachments (derived.c) */
    bool is_derived_valid, is_sparsity_valid; /* sparsity of the thread's own system */
    uint32_t *prescribed_by; /* per node: 1 + index of its PIN or CLAMP; 0: the node is free */
    uint8_t *welded;         /* per node: 1 if a body of the scene moves it */
    double *mass;            /* per node, with attached masses, kg */
    double *inverse_rest;    /* per segment, 1/m */
    double *rest_arc_length; /* per node: arc length from node 0 at rest, m */
    double min_rest_length;  /* m */
    /* first node of each section; prescribed nodes divide a thread into sections */
    uint32_t *sections;
    uint32_t section_count;
    /* row i: coefficients of x[i] .. x[i + 4], N/m (implicit method) */
    double (*bending_matrix)[THREAD_STENCIL_NODES];
    thread_spline_moment *spline_moments; /* scratch of bending.c (implicit method) */
    thread_arc *arcs;                     /* implicit method */
    thread_clamp *clamps;                 /* in the order of their nodes (implicit method) */
    uint32_t clamp_count;
    thread_section_holder
        *holders; /* holder_count, in the order of their nodes; twist (implicit method) */
    /* coupling of block i with i + 1 .. i + 3 (implicit method) */
    uint32_t (*couplings)[THREAD_BANDWIDTH];
    vbss_system *system; /* system of a thread that is stepped on its own (implicit method) */

    /* step data, which does not outlive a step */
    thread_state saved; /* the state before the step, once its first substep is committed */
    vec3 *trial;        /* positions, m */
    vec3 *x_predicted, *v_predicted, *a_predicted;
    double *trial_tension;
    vec3 *rest_curvature_forces;          /* N (implicit method) */
    thread_bend_response *bend_responses; /* as thread_state::bend (implicit method) */
    /* twist (implicit method): an entry for each pair of neighbouring holders; two for each node, of which
     * the second belongs to the span that begins there; and one for each node */
    thread_twist_span *twist_spans;
    uint32_t twist_span_count;
    uint32_t coupling_slots; /* entries of twist_couplings for a node: 2, with friction torque 3 */
    uint32_t roll_count;     /* friction torque: segments with a roll */
    uint32_t holder_count;
    thread_twist_stiffness *twist_stiffness; /* two */
    vec3 *twist_couplings;                   /* two; see twist.c */
    vec3 *twist_forces, *twist_scratch;      /* one, N */
    /* Friction torque (contact_rolls.c): for each segment whether its roll is an unknown of the substep,
     * and the trial roll, rad; for each span whether the matrix contains its twist, and then the
     * gradients of the twist with its nodes, 1/m */
    uint8_t *has_roll, *is_span_exact;
    double *roll_angles;
    vec3 (*span_gradients)[THREAD_EXACT_SPAN_NODES];
    thread_strain *strains;
    struct baseline_thread *baseline; /* state of lib/baseline; NULL by the implicit method */

    /* views, computed when a host asks */
    double *lengths, *sagittas, *axial_forces; /* axial_forces: implicit method */
    vec3 *curvatures, *memory_curvatures[2];   /* plastic and viscous (implicit method) */
    double *twists;                            /* implicit method */
    vec3 *material_directors;                  /* implicit method */
};

/* ---- handle.c */

/* The kind of all handles of threads. */
extern const vbss_kind vbss_thread_kind;

/* Finds the thread of a handle, for reading. Fails if the handle is invalid. */
vbss_result vbss_thread_open(const vbss_thread *handle, thread_object **thread);

/* Finds the thread of a handle, for edits that are allowed inside a scene, too. */
vbss_result vbss_thread_edit(vbss_thread *handle, thread_object **thread);

/* Finds the thread of a handle, for edits that are refused while it belongs to a scene. */
vbss_result vbss_thread_edit_unowned(vbss_thread *handle, thread_object **thread);

/* ---- thread.c */

/* Refuses a configuration that is NULL or of a size that no version has. */
vbss_result vbss_thread_check_config_size(const vbss_thread_config *config);

/* Copies the configuration of a host into `own` and its parameters of the baseline into `baseline`,
 * to which own->baseline points. Sets defaults for fields that it lacks, and checks the copies. */
vbss_result vbss_thread_read_config(vbss_context *context, const vbss_thread_config *config,
                                    vbss_thread_config *own, vbss_baseline_config *baseline);

/* Allocates a thread without a handle. VBSS_ERROR_OUT_OF_MEMORY: `*thread` is NULL. */
vbss_result vbss_thread_allocate(vbss_context *context, const vbss_thread_config *config,
                                 uint32_t node_capacity, thread_object **thread);

/* Frees a thread, and its reference to the piece pool. */
void vbss_thread_free(vbss_context *context, void *object);

/* Drops one reference to a piece pool, and frees the pool with the last. */
void vbss_thread_release_piece_pool(vbss_context *context, thread_piece_pool *pool);

/* ---- cut.c */

/* A place where a thread can be cut. */
typedef struct thread_cut {
    uint32_t segment; /* the segment that is divided, or that ends at the node to be doubled */
    double fraction;  /* fraction of the segment that stays; 1: its end node is doubled */
    uint32_t first_piece_node; /* first node that moves to the piece */
    uint32_t node_shift;       /* node of the thread minus node of the piece */
} thread_cut;

/* Arc length from node 0 to a node at rest, m. */
double vbss_thread_arc_length(const thread_object *t, uint32_t node);

/* Finds where a cut at an arc length (m) goes; changes nothing. False: at an end of the thread,
 * which cannot be cut. */
bool vbss_thread_locate_cut(const thread_object *t, double arc_length, thread_cut *cut);

/* Moves nodes and attachments beyond the cut to `piece`, a thread from the same pool. */
void vbss_thread_apply_cut(thread_object *t, thread_object *piece, const thread_cut *cut);

/* Takes a spare thread and its handle slot from the pool of `t`; NULL: the pool is empty. The
 * caller keeps it as a piece or returns it. */
thread_object *vbss_thread_acquire_piece(thread_object *t, vbss_slot **slot);

/* Returns a spare thread and its handle slot to the pool. */
void vbss_thread_return_piece(thread_object *piece, vbss_slot *slot);

/* ---- finish_step.c */

/* Finishes a step of `h` seconds, alone or in a scene: attachments, reactions, statistics. */
void vbss_thread_finish_step(thread_object *t, double h);

/* ---- config_fields.c */

/* Visits the configuration and its parameters of the baseline, to which it points afterwards. */
void vbss_thread_visit_config(vbss_stream *stream, vbss_thread_config *config,
                              vbss_baseline_config *baseline);

/* ---- snapshot.c */

/* Saves, hashes or restores the thread. */
void vbss_thread_serialise(vbss_stream *stream, void *object);

/* Copies positions, velocities, accelerations and tensions of all nodes. */
void vbss_thread_copy_state(const thread_object *t, thread_state *to, const thread_state *from);

/* ---- attachments.c */

/* Whether attachments of this kind prescribe the motion of their node: pins and clamps. */
bool vbss_thread_prescribes_motion(vbss_thread_attachment_kind kind);

/* Whether a clamp prescribes the node. */
bool vbss_thread_is_clamped(const thread_object *t, uint32_t node);

/* Finds an attachment by its id. VBSS_ERROR_NOT_FOUND if there is none. */
vbss_result vbss_thread_find_attachment(thread_object *t, uint32_t id, thread_attachment **found);

/* Position of an attachment at a fraction 0..1 of the step, m. */
vec3 vbss_thread_attachment_position(const thread_attachment *a, double fraction);

/* Direction of a clamp at a fraction 0..1 of the step, unit. */
vec3 vbss_thread_attachment_direction(const thread_attachment *a, double fraction);

/* Copies the target, direction and force of an attachment to the alternate ones. */
void vbss_thread_save_target(thread_attachment *a);

/* A step of a scene may be suspended while hosts set targets for the next step. Copies the targets,
 * so that the suspended step keeps its own. */
void vbss_thread_save_targets(thread_object *t);

/* Swaps the targets of the suspended step and those of the host: before the step is resumed, and
 * after it is suspended or finished. */
void vbss_thread_swap_targets(thread_object *t);

/* Moves attachments to their targets at the end of a step of `h` seconds. */
void vbss_thread_commit_attachments(thread_object *t, double h);

/* ---- reactions.c */

/* Computes the reactions of all attachments at the end of a step, after
 * vbss_thread_commit_attachments. */
void vbss_thread_update_reactions(thread_object *t);

/* ---- derived.c */

/* Computes derived data if it is invalid. */
vbss_result vbss_thread_update_derived(thread_object *t);

/* Computes masses and prescribed nodes only. */
void vbss_thread_compute_masses(thread_object *t);

/* Computes derived data and the sparsity of the thread's own system if they are invalid. Fails if
 * the system's capacity is exceeded. */
vbss_result vbss_thread_update_sparsity(thread_object *t);

/* Computes derived data if it is invalid, and sets clamps to their current directions, for queries
 * between steps. */
vbss_result vbss_thread_prepare_query(thread_object *t);

/* Marks derived data, views and accelerations as invalid, after any change that is not a step. */
void vbss_thread_invalidate(thread_object *t);

/* Number of neighbours on either side that a node is coupled with. */
uint32_t vbss_thread_bandwidth(const thread_object *t);

/* Adds the thread to a system as a chain of blocks, one for each node; `*first` gets the first
 * block. `separators` (one flag a node, NULL: none) marks nodes that other constraints couple, in
 * groups as wide as the bandwidth. Fails if the system's capacity is exceeded. */
vbss_result vbss_thread_add_to_system(thread_object *t, vbss_system *s, const uint8_t *separators,
                                      uint32_t *first);

/* ---- bending.c */

/* Builds bending_matrix, clamps and arcs from rest lengths and attachments. */
void vbss_thread_build_bending(thread_object *t);

/* ---- energy.c */

/* Bending energy with rest curvature, J. */
double vbss_thread_bending_energy(const thread_object *t);

/* Increase of stretching and kinetic energy from the state to the trial state, J, for a substep of
 * `h` seconds. */
double vbss_thread_energy_change(const thread_object *t, double h);
/* ---- bending.c: curvature and clamps */

/* Curvature vector at a node, 1/m: turn of the chord's direction over the mean rest length. At a
 * clamp it is that of the side toward higher nodes, or of the other side at the last node. Zero at
 * free ends. */
vec3 vbss_thread_curvature(const thread_object *t, const vec3 *x, uint32_t node);

/* Sets the directions of clamps at a fraction 0..1 of the step, with the curvature that they give
 * to arcs. */
void vbss_thread_set_clamp_directions(thread_object *t, double fraction);

/* Direction of the clamp that prescribes the node, unit. */
vec3 vbss_thread_clamp_direction(const thread_object *t, uint32_t node);

/* ---- rest_curvature.c */

/* Part of the bending energy that rest curvature adds, J. */
double vbss_thread_rest_curvature_energy(const thread_object *t);

/* Gradient of that energy with the direction of the clamp at a node, N m. */
vec3 vbss_thread_rest_curvature_gradient(const thread_object *t, uint32_t node);

/* Adds the forces of rest curvature with the nodes at `x` to `forces`, N. */
void vbss_thread_add_rest_curvature_forces(const thread_object *t, const vec3 *x, vec3 *forces);

/* Force of rest curvature on one node in the current state, N. */
vec3 vbss_thread_rest_curvature_force(const thread_object *t, uint32_t node);

/* ---- strain.c */

/* Computes tangent, chord, curvature and elongation of all segments with the nodes at `x`. */
void vbss_thread_compute_strains(const thread_object *t, const vec3 *x, thread_strain *strains);

/* Records the largest stretch of `strains` in the statistics. Returns the largest stretch error:
 * the difference to the stretch that `tension` (N) gives. */
double vbss_thread_record_stretch(thread_object *t, const double *tension);

/* ---- assemble.c */

/* One substep of a thread. */
typedef struct thread_substep {
    const vbss_integration *integration;
    double step_length;   /* s, of the whole step */
    double end_fraction;  /* end of the substep, as a fraction of the step */
    double min_tension;   /* N, <= 0: compression beyond it does not reduce the stiffness */
    double buckling_load; /* N, > 0: see vbss_thread_buckling_load */
    /* Largest strain beyond that of the tensions with which an unconverged trial state
     * is acceptable. */
    double max_acceptable_strain;
} thread_substep;

/* Assembles the thread's part of matrix and right-hand side at the trial state, from strains and
 * trial tensions. One copy of the function for each instruction set. */
void vbss_thread_assemble_plain(const thread_object *t, const thread_substep *substep,
                                vbss_system *system, uint32_t first_block);
void vbss_thread_assemble_wide(const thread_object *t, const thread_substep *substep,
                               vbss_system *system, uint32_t first_block);

/* ---- substep.c */

/* Predicts the trial state: prescribed nodes are at their targets, strains are computed. False: the
 * motion is not smooth, and backward Euler has to be used. */
bool vbss_thread_predict(thread_object *t, thread_substep *substep);

/* Resets the free nodes of the trial state to the start of the substep. Strains are not updated. */
void vbss_thread_reset_trial(thread_object *t);

/* Moves the trial state by the increments `u` of the nodes, m, and sets the trial tensions. Returns
 * the residual displacement: the largest distance that unbalanced forces would move a node, m. */
double vbss_thread_apply_increment(thread_object *t, const thread_substep *substep, const vec3 *u);

/* Largest error of the linearised lengths if the trial state moved by `u`, as a strain. */
double vbss_thread_linearisation_error(const thread_object *t, const vec3 *u);

/* Freezes all free nodes where they are, after a substep found no acceptable state. False: even
 * that state is not finite. */
bool vbss_thread_freeze_trial(thread_object *t);

/* Makes the trial state the state. */
void vbss_thread_commit(thread_object *t, const vbss_integration *in);

/* Largest strain of the trial state beyond that of the tensions. */
double vbss_thread_strain_beyond_tension(const thread_object *t);

/* Whether the largest tension or compression is smaller in the trial state than in the
 * current one. */
bool vbss_thread_max_tension_decreased(const thread_object *t);

/* Buckling load, N: compression below which a straight thread keeps a positive stiffness. The
 * inertia of the integration scheme (`inertia`, 1/s^2) supports it like an elastic foundation. */
double vbss_thread_buckling_load(const thread_object *t, double inertia);

/* ---- rest_curvature.c: forces of a substep */

/* Computes rest_curvature_forces from the trial state. */
void vbss_thread_update_rest_curvature_forces(thread_object *t);

/* ---- section_damping.c */

/* Takes a fraction 0..1 from the velocities of free nodes relative to the rigid motion of
 * their section. */
void vbss_thread_damp_sections(thread_object *t, double fraction);

/* implicit_step.c */
vbss_result vbss_thread_implicit_step(thread_object *t, double h);
/* Force that holds a prescribed node at the end of the last step, N. The implicit method uses the
 * strains of that step. */
vec3 vbss_thread_implicit_constraint_force(const thread_object *t, uint32_t node);
/* axial_forces of thread_method. */
const double *vbss_thread_implicit_axial_forces(thread_object *t);
vec3 vbss_thread_implicit_reaction_force(const thread_object *t, uint32_t node);
vec3 vbss_thread_implicit_reaction_torque(const thread_object *t, uint32_t node);

#endif
