/* A drain: data and functions that the files of lib/drain share, except the mesh (mesh.h) and the
 * shell (shell.h). A step of the implicit method:
 *
 *   [assemble -> solve -> apply increment -> correction] -> commit
 *
 * step.c does this for a drain on its own. A scene makes these calls in each substep, with all
 * bodies in one system. */
#ifndef VBSS_DRAIN_DRAIN_H
#define VBSS_DRAIN_DRAIN_H

#include <vblast_ss/drain.h>

#include "base/linear.h"
#include "base/slot.h"
#include "drain/mesh.h"
#include "drain/shell.h"
#include "drain/tuning.h"
#include "solver/solver.h"

typedef struct drain_attachment {
    uint32_t id; /* 0: unused */
    vbss_drain_attachment_kind kind;
    uint32_t node;
    vec3 position, target; /* PIN, SPRING: current, and after the next step, m */
    vec3 force;            /* FORCE: N */
    double stiffness;      /* SPRING: N/m */
    vec3 reaction;         /* on the drain in the last step, N */
    /* While a step of the scene is suspended, its target and force; while it runs, those of the
     * host. See vbss_drain_swap_targets. */
    vec3 alternate_target, alternate_force;
} drain_attachment;

/* Two nodes that a patch couples, by their positions in the elimination order (high > low). They
 * have one block of the matrix. */
typedef struct drain_pair {
    uint32_t high, low;
    uint32_t coupling; /* in the system whose sparsity is valid */
} drain_pair;

/* The nodes in the order of elimination, and the pairs that patches couple. */
typedef struct drain_elimination_order {
    uint32_t *block_index; /* node -> position in the order; anchored nodes come last */
    uint32_t *node;        /* position -> node */
    drain_pair *pairs;
    /* Per triangle and pair of its patch: twice the index in `pairs`, plus 1 if the first node is
     * eliminated earlier. Twice pair_count if the pair reaches beyond a free edge. */
    uint32_t (*pair_codes)[SHELL_PAIRS];
    /* Per pair, and one for missing pairs: the block that it is added to, for
     * vbss_shell_set_assembly_map. */
    uint32_t *block_codes;
    /* number of pairs; entries and products of the factor if no node is anchored */
    uint32_t pair_count, factor_entries, factor_products;
    /* couplings of the pairs in the system whose sparsity is valid */
    uint32_t first_coupling, coupling_count;
} drain_elimination_order;

enum { DRAIN_TANGENTS = 3 };
/* What the matrix of a drain is of (tangent.c). */
typedef struct drain_tangent {
    vec3 *shape; /* positions of the nodes, m */
    double h;    /* length of the substep, s; 0: there is no matrix */
} drain_tangent;

typedef struct drain_object drain_object;

/* What the method of a drain does. The table is chosen once, when a drain is created. */
typedef struct drain_method {
    drain_mesh_kind (*mesh_kind)(const vbss_drain_config *config);
    /* Memory of the method, when mesh, masses and positions are there; destroy_drain follows also when this fails. */
    vbss_result (*create_drain)(drain_object *d);
    void (*destroy_drain)(vbss_context *context, drain_object *d);
    /* A step of h seconds of a drain that is alone. The caller keeps the state before, and restores it on failure. */
    vbss_result (*step_drain)(drain_object *d, double h);
    /* Adds the energies of shape, J. */
    void (*add_energies)(drain_object *d, vbss_drain_energies *energies);
    bool
        is_surface; /* walls have no thickness: a gap is measured between edges, not between lips */
} drain_method;
extern const drain_method vbss_drain_implicit; /* implicit_method.c */
extern const drain_method vbss_baseline_drain; /* defined in lib/baseline */

struct drain_object {
    const drain_method *method;
    vbss_context *context;
    vbss_drain_config config;
    vbss_baseline_config baseline_config; /* what config.baseline points to */
    vbss_drain_surface surface;           /* what config.surface points to, if there is one */
    double *triangle_thickness, *triangle_young_modulus; /* of the surface; NULL: one for all */
    uint64_t surface_hash;                               /* of its counts and arrays */
    pose frame;
    vec3 gravity;
    uint64_t generation;
    uint64_t edit_generation; /* counts edits by hosts, except new targets */
    drain_mesh mesh;
    vbss_shell shell;
    vbss_shell_group *groups;
    double *mass;            /* per node, kg */
    double *anchor_strength; /* per anchor, N */
    double anchor_load; /* the largest of the last step, relative to the strength of its anchor */
    drain_elimination_order order;

    /* state */
    vec3 *x, *v;
    uint8_t *torn; /* per anchor: 1 once it has torn */
    drain_attachment *attachments;
    uint32_t last_id;
    vec3 *contact_forces; /* per node: contact force in the last step, N; zero outside a scene */
    vbss_drain_statistics statistics;
    /* Which of them is that of the state, of the running attempt, and of the checkpoint. */
    drain_tangent tangents[DRAIN_TANGENTS];
    uint32_t tangent, attempt_tangent, saved_tangent;

    /* derived data */
    const vbss_system
        *factored_in;   /* the system that has the factor of the attempt's tangent, or NULL */
    bool keeps_tangent; /* in the last linearisation: its matrix is that of an earlier one */
    bool is_sparsity_valid;
    uint8_t *anchored;   /* per node: 1 if it is an anchor that has not torn */
    vbss_system *system; /* system of a drain that is stepped on its own */

    /* step data, which does not outlive a step */
    /* v_substep_start: before the current substep, m/s */
    vec3 *trial, *internal_forces, *v_substep_start;
    vec3 *saved_x, *saved_v; /* at the start of the step */
    block *
        diagonal; /* Per node, for the baseline method: mass, and the factor of an impulse; zero if the node
     * is pinned. */
    struct baseline_drain *baseline; /* state of lib/baseline; NULL by the implicit method */

    /* views, computed when a host asks */
    vec3 *anchor_forces;
    vec3 *view_forces; /* per node: shell force in the current state, N */
    double (*strains)[3], (*curvatures)[3];
    vbss_shell_response *shell_responses;
};

/* ---- handle.c */

/* The kind of all handles of drains. */
extern const vbss_kind vbss_drain_kind;

/* Finds the drain of a handle, for reading. Fails if the handle is invalid. */
vbss_result vbss_drain_open(const vbss_drain *handle, drain_object **drain);

/* Finds the drain of a handle, for edits that are allowed inside a scene, too. */
vbss_result vbss_drain_edit(vbss_drain *handle, drain_object **drain);

/* Finds the drain of a handle, for edits that are refused while it belongs to a scene. */
vbss_result vbss_drain_edit_unowned(vbss_drain *handle, drain_object **drain);

/* ---- drain.c */

/* Builds a drain with a checked configuration in an empty object that has its context. On failure
 * the caller frees the object. */
vbss_result vbss_drain_build(drain_object *d, const vbss_drain_config *config);

/* Frees a drain, complete or not. */
void vbss_drain_free(vbss_context *context, void *object);

/* ---- config.c */

/* Reads a configuration of any known size, fills in defaults and checks ranges. `baseline` and
 * `surface` receive what own->baseline and own->surface point to. Lengths of the mesh are checked by
 * vbss_drain_mesh_plan. */
vbss_result vbss_drain_read_config(vbss_context *context, const vbss_drain_config *config,
                                   vbss_drain_config *own, vbss_baseline_config *baseline,
                                   vbss_drain_surface *surface);

/* Options of the mesh for a configuration. */
drain_mesh_options vbss_drain_mesh_options_of(const vbss_drain_config *config,
                                              drain_mesh_kind kind);

/* ---- elimination_order.c */

/* Computes an elimination order by minimum degree, with anchored nodes last.
 * VBSS_ERROR_OUT_OF_MEMORY: the caller destroys what there is. */
vbss_result vbss_drain_create_elimination_order(vbss_context *context, const drain_mesh *mesh,
                                                const vbss_shell *shell,
                                                drain_elimination_order *order);

/* Frees the arrays of an elimination order, complete or not. */
void vbss_drain_destroy_elimination_order(vbss_context *context, const drain_mesh *mesh,
                                          drain_elimination_order *order);

/* ---- anchors.c */

/* Sets `anchored` from `torn`. */
void vbss_drain_update_anchored(drain_object *d);

/* Force of an anchor on its node, N, for given internal forces of all nodes; zero once it
 * has torn. */
vec3 vbss_drain_anchor_force(const drain_object *d, uint32_t anchor, const vec3 *forces);

/* Tears the anchor with the largest overload, if any is overloaded. */
void vbss_drain_tear_anchor(drain_object *d, const vec3 *forces);

/* ---- attachments.c */

/* Position of an attachment at a fraction 0..1 of the step, m. */
vec3 vbss_drain_attachment_position(const drain_attachment *a, double fraction);

/* The pin of a node, or NULL. */
const drain_attachment *vbss_drain_find_pin(const drain_object *d, uint32_t node);

/* Moves attachments to their targets at the end of a step. */
void vbss_drain_commit_attachments(drain_object *d);

/* A step of a scene may be suspended while hosts set targets for the next step. Copies the targets,
 * so that the suspended step keeps its own. */
void vbss_drain_save_targets(drain_object *d);

/* Swaps the targets of the suspended step and those of the host: before the step is resumed, and
 * after it is suspended or finished. */
void vbss_drain_swap_targets(drain_object *d);

/* ---- sparsity.c */

/* Adds the drain to a system as a chain of blocks, one for each node in the order of elimination;
 * `*first` gets the first block. `separators`: one flag a node, NULL: none. Fails if the system's
 * capacity is exceeded. */
vbss_result vbss_drain_add_to_system(drain_object *d, vbss_system *s, const uint8_t *separators,
                                     uint32_t *first);

/* Sets the block of the system that each pair of nodes is added to. Call it after the system was
 * analysed. The map stays valid after vbss_system_reset_separator_couplings and another analysis,
 * as couplings keep their numbers. */
void vbss_drain_set_assembly_map(drain_object *d, const vbss_system *s);

/* ---- assemble.c: backward Euler, see docs/explanation/drain.md */

/* One substep of a drain. */
typedef struct drain_substep {
    double h;            /* s */
    double end_fraction; /* end of the substep, as a fraction of the step */
} drain_substep;

/* Computes internal_forces for nodes at `x`, N. */
void vbss_drain_compute_internal_forces(drain_object *d, const vec3 *x);

/* Assembles the right-hand side at the trial state, and the matrix at the shape of the tangent if the system does
 * not have its factor. Leaves the internal forces of the trial state in internal_forces. `first`: first block of
 * the drain. */
void vbss_drain_assemble(drain_object *d, const drain_substep *substep, vbss_system *s,
                         uint32_t first);

/* Assembles the right-hand side alone. Leaves the internal forces of the trial state
 * in internal_forces. */
void vbss_drain_assemble_rhs(drain_object *d, const drain_substep *substep, vbss_system *s,
                             uint32_t first);

/* ---- tangent.c */

/* Begins an attempt: its tangent is that of the state. */
void vbss_drain_begin_tangent(drain_object *d);

/* Sets keeps_tangent: the tangent is of substeps of `h` seconds, and no node of the trial state is farther than
 * `distance` (m) from its shape. If not, the tangent becomes that of the trial state. */
void vbss_drain_choose_tangent(drain_object *d, double h, double distance);

/* The distance from which on a new matrix is due, m. */
static inline double vbss_drain_tangent_distance(const drain_object *d)
{
    return DRAIN_TANGENT_RATIO * d->config.move_limit;
}

/* Makes the tangent of an attempt that of the state. */
void vbss_drain_commit_tangent(drain_object *d);

/* Before a step, and after it has failed. */
void vbss_drain_checkpoint_tangent(drain_object *d);
void vbss_drain_rollback_tangent(drain_object *d);

/* After an edit, or when an anchor has torn: the next matrix is a new one. */
void vbss_drain_drop_tangent(drain_object *d);

/* ---- reactions.c */

/* Whether any node is pinned. */
bool vbss_drain_has_pins(const drain_object *d);

/* Computes the reactions of all attachments at the end of a step; `h`: length of its last substep,
 * s. For pins, internal_forces must be those of the current state. */
void vbss_drain_update_reactions(drain_object *d, double h);

/* ---- substep.c: a part of a step, whose blocks in a system begin with `first`. */
void vbss_drain_reset_trial(drain_object *d);

/* Largest increment of a node in the system's solution, m. `first`: first block of the drain. */
double vbss_drain_largest_increment(const drain_object *d, const vbss_system *s, uint32_t first);

/* Moves the trial state by the increments in the system's solution. */
void vbss_drain_apply_increment(drain_object *d, const vbss_system *s, uint32_t first);

/* Makes the trial state the state, after a substep of `h` seconds. */
void vbss_drain_commit(drain_object *d, double h);

/* ---- drain_api.c: edits by hosts */

/* Counts an edit by a host other than a new target, and marks views as old. */
void vbss_drain_invalidate(drain_object *d);

/* ---- substep.c: end of a step */

/* Finishes the substeps of a step, the last of which took `h` seconds: moves attachments, computes
 * reactions, tears an anchor. */
void vbss_drain_finish_substeps(drain_object *d, double h);

/* Finishes a step of `h` seconds, by either method: statistics and generation. */
void vbss_drain_finish_step(drain_object *d, double h);

/* ---- step.c: a step of a drain that is alone, by the implicit method */
vbss_result vbss_drain_implicit_step(drain_object *d, double h);

/* ---- energy.c */

/* Increase of elastic, kinetic and potential energy from the state to the trial state, J, minus the
 * largest work that attachments may have done. `h`: length of the substep, s. */
double vbss_drain_energy_change(const drain_object *d, double h);

/* Replaces components of a velocity below VBSS_FLUSH_THRESHOLD by 0. */
static inline vec3 vbss_drain_flush_velocity(vec3 v)
{
    return vec3_make(fabs(v.x) < VBSS_FLUSH_THRESHOLD ? 0.0 : v.x,
                     fabs(v.y) < VBSS_FLUSH_THRESHOLD ? 0.0 : v.y,
                     fabs(v.z) < VBSS_FLUSH_THRESHOLD ? 0.0 : v.z);
}

/* Point of a triangle with given barycentric coordinates, with the nodes at `x`. */
static inline vec3 vbss_drain_point(const drain_object *d, const vec3 *x, uint32_t triangle,
                                    const double barycentric[3])
{
    const uint32_t *node = d->mesh.triangles[triangle];
    vec3 point = vec3_scale(x[node[0]], barycentric[0]);
    point = vec3_add_scaled(point, barycentric[1], x[node[1]]);
    return vec3_add_scaled(point, barycentric[2], x[node[2]]);
}

/* ---- config_fields.c */

/* Visits the configuration and its parameters of the baseline, to which it points afterwards. */
void vbss_drain_visit_config(vbss_stream *stream, vbss_drain_config *config,
                             vbss_baseline_config *baseline);

/* ---- snapshot.c */

/* Saves, hashes or restores the drain. */
void vbss_drain_serialise(vbss_stream *stream, void *object);

#endif
