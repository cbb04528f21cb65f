/* The inside of a drain: what the files of lib/drain share beside the mesh (mesh.h) and the shell (shell.h).
 *
 * drain.c makes and ends drains; elimination_order.c works out, once, in which order a system eliminates their nodes; sparsity.c
 * registers them in a system, assemble.c gives it their numbers; step.c is a step of a drain that is alone. paper_step.c is
 * the paper's method, which needs no system. */
#ifndef VBSS_DRAIN_DRAIN_H
#define VBSS_DRAIN_DRAIN_H

#include <vblast_ss/drain.h>

#include "base/linear.h"
#include "base/slot.h"
#include "drain/mesh.h"
#include "drain/shell.h"
#include "solver/solver.h"

typedef struct drain_attachment {
    uint32_t id; /* 0: the place is free */
    vbss_drain_attachment_kind kind;
    uint32_t node;
    vec3 position, target; /* PIN, SPRING: now, and after the next step */
    vec3 force;            /* FORCE */
    double stiffness;      /* SPRING */
    vec3 reaction;         /* of the last step, on the drain */
    /* Of a step of its scene that waits, while it waits; else of the host: see vbss_drain_swap_targets. */
    vec3 alternate_target, alternate_force;
} drain_attachment;

/* Two nodes of a patch: a block of the system's matrix. By their places in the order, high > low. */
typedef struct drain_pair {
    uint32_t high, low;
    uint32_t coupling; /* in the system that knows the pattern */
} drain_pair;

/* The graph of the nodes that patches couple, and the order in which it is eliminated. */
typedef struct drain_elimination_order {
    uint32_t *block_index; /* node -> place in the order; anchored nodes come last */
    uint32_t *node;        /* place -> node */
    drain_pair *pairs;
    /* Of a triangle's pairs of nodes: twice its number in pairs, 1 more if the first node is the lower one; twice
     * pair_count beyond a free side. */
    uint32_t (*pair_codes)[SHELL_PAIRS];
    uint32_t *
        block_codes; /* per pair, and then of none: where its block goes, for vbss_shell_set_assembly_map */
    uint32_t pair_count, factor_entries,
        factor_products; /* the last two: of the factor, if nothing is anchored */
    uint32_t first_coupling, coupling_count; /* of pairs, in the system that knows the pattern */
} drain_elimination_order;

typedef struct drain_object {
    vbss_context *context;
    vbss_drain_config config;
    pose frame;
    vec3 gravity;
    uint64_t generation;
    uint64_t edit_generation; /* by hosts, of anything but where attachments go */
    drain_mesh mesh;
    vbss_shell shell;
    vbss_shell_group *groups;
    double *mass;            /* per node */
    double *anchor_strength; /* per anchor, N */
    drain_elimination_order order;
    vec3 *ties; /* method PAPER, per node: where its spring holds it */

    /* the state */
    vec3 *x, *v;
    uint8_t *torn; /* per anchor */
    drain_attachment *attachments;
    uint32_t last_id;
    vec3 *contact_forces; /* per node: of contacts in the last step; zero when it is alone */
    vbss_drain_statistics statistics;

    /* what follows from it */
    bool is_sparsity_valid;
    uint8_t *anchored;   /* per node */
    vbss_system *system; /* of a drain that is stepped alone */

    /* room for a step: nothing here outlives it */
    vec3 *trial, *internal_forces, *v_substep_start; /* v_before: the part under way */
    vec3 *saved_x, *saved_v;                         /* before the step */
    block *diagonal;
    /* Method PAPER, per node: mass, and what an impulse is multiplied with; zero where it is pinned. */
    double *free_mass, *mobility;

    /* views that are worked out when asked for */
    vec3 *anchor_forces;
    vec3 *view_forces; /* per node: of the shell, not those of a step that may be under way */
    double (*strains)[3], (*curvatures)[3];
    vbss_shell_response *shell_responses;
} drain_object;

extern const vbss_kind vbss_drain_kind;

/* ---- drain.c: the living drain of a handle, to look at or to change; and while nobody else has it */
vbss_result vbss_drain_open(const vbss_drain *handle, drain_object **drain);
vbss_result vbss_drain_edit(vbss_drain *handle, drain_object **drain);
vbss_result vbss_drain_edit_unowned(vbss_drain *handle, drain_object **drain);

/* ---- config.c: a configuration with defaults for what the host's does not have, checked; and of that the mesh */
vbss_result vbss_drain_read_config(vbss_context *context, const vbss_drain_config *config,
                                   vbss_drain_config *own);
drain_mesh_options vbss_drain_mesh_options_of(const vbss_drain_config *config);

/* ---- elimination_order.c: by minimum degree, made at creation */
vbss_result vbss_drain_create_elimination_order(vbss_context *context, const drain_mesh *mesh,
                                                const vbss_shell *shell,
                                                drain_elimination_order *order);
void vbss_drain_destroy_elimination_order(vbss_context *context, const drain_mesh *mesh,
                                          drain_elimination_order *order);

/* ---- anchors.c: which nodes are anchored, from what has torn; the force of one in a state whose inner forces are known; tears
 * the one that is overloaded most, if any is */
void vbss_drain_update_anchored(drain_object *d);
vec3 vbss_drain_anchor_force(const drain_object *d, uint32_t anchor, const vec3 *forces);
void vbss_drain_tear_anchor(drain_object *d, const vec3 *forces);

/* ---- attachments.c */
vec3 vbss_drain_attachment_position(const drain_attachment *a, double fraction);
const drain_attachment *vbss_drain_find_pin(const drain_object *d, uint32_t node);
void vbss_drain_commit_attachments(drain_object *d);
/* A step of its scene may wait while hosts say where attachments go in the next. At its begin both are the same; then they change
 * places whenever the step goes on, and whenever it waits or ends. */
void vbss_drain_save_targets(drain_object *d);
void vbss_drain_swap_targets(drain_object *d);

/* ---- sparsity.c: the drain's chain in a system, a block a node in the order of elimination, those marked (NULL: none) as
 * separators; and, when that has been analysed, where the shell's blocks go: whoever registers aims after the analyse that
 * follows, but need not after vbss_system_reset_separator_couplings and another one, as couplings stay what they are */
vbss_result vbss_drain_add_to_system(drain_object *d, vbss_system *s, const uint8_t *separators,
                                     uint32_t *first);
void vbss_drain_set_assembly_map(drain_object *d, const vbss_system *s);

/* ---- assemble.c: the drain's part of a system at the trial state. Backward Euler: see docs/drain.md. */
typedef struct drain_substep {
    double h;            /* of the part, s */
    double end_fraction; /* of the step, where attachments are then */
} drain_substep;
/* Inner forces there, into d->forces. */
void vbss_drain_compute_internal_forces(drain_object *d, const vec3 *x);
/* Matrix and right-hand side; the right-hand side alone. Inner forces of the trial state are left in d->forces. */
void vbss_drain_assemble(drain_object *d, const drain_substep *substep, vbss_system *s,
                         uint32_t first);
void vbss_drain_assemble_rhs(drain_object *d, const drain_substep *substep, vbss_system *s,
                             uint32_t first);

/* ---- reactions.c: of all attachments at the end of a step, whose last part had this length. Pins need the inner forces that
 * this part was made with in d->forces. */
bool vbss_drain_has_pins(const drain_object *d);
void vbss_drain_update_reactions(drain_object *d, double h);

/* ---- substep.c: a part of a step, whose blocks in a system begin with `first`. A correction that moves nothing farther than
 * DRAIN_MAX_CORRECTION_RATIO of what it corrects is believed; a part in which a node goes beyond DRAIN_MAX_MOVE_RATIO move_limits is halved,
 * beyond one it gets another linearisation. */
#define DRAIN_MAX_CORRECTION_RATIO 0.5
#define DRAIN_MAX_MOVE_RATIO 4.0
void vbss_drain_reset_trial(drain_object *d);
double vbss_drain_largest_increment(const drain_object *d, const vbss_system *s, uint32_t first);
void vbss_drain_apply_increment(drain_object *d, const vbss_system *s, uint32_t first);
void vbss_drain_commit(drain_object *d, double h);
/* drain.c: a host has changed more than where attachments go. */
void vbss_drain_invalidate(drain_object *d);
/* At the end of a step, whose last part had this length: attachments arrive, reactions are noted, an anchor may tear. */
void vbss_drain_finish_substeps(drain_object *d, double h);
/* A whole step of this length is done, by either method: it is counted, and views are of another state. */
void vbss_drain_finish_step(drain_object *d, double h);

/* ---- step.c, paper_step.c: a step of a drain that is alone, by method. Whoever asks keeps what was before, and gives it back
 * when it fails. */
vbss_result vbss_drain_implicit_step(drain_object *d, double h);
vbss_result vbss_drain_paper_step(drain_object *d, double h);
/* The same in two: all that may fail, which tells the length of its explicit steps; and what is noted at the end, where
 * contacts may have moved nodes that no pin holds. */
vbss_result vbss_drain_paper_move(drain_object *d, double h, double *part);
void vbss_drain_paper_arrive(drain_object *d, double part);
double vbss_drain_paper_energy(const drain_object *d);

/* ---- energy.c: what it has more in the trial state, h after the state, of shape, motion and height, less the most that its
 * attachments have done; method OURS */
double vbss_drain_energy_change(const drain_object *d, double h);

/* Speeds that are as good as none are none. */
static inline vec3 vbss_drain_flush_velocity(vec3 v)
{
    return vec3_make(fabs(v.x) < VBSS_FLUSH_THRESHOLD ? 0.0 : v.x,
                     fabs(v.y) < VBSS_FLUSH_THRESHOLD ? 0.0 : v.y,
                     fabs(v.z) < VBSS_FLUSH_THRESHOLD ? 0.0 : v.z);
}

/* A point of a triangle, where nodes are at x. */
static inline vec3 vbss_drain_point(const drain_object *d, const vec3 *x, uint32_t triangle,
                                    const double barycentric[3])
{
    const uint32_t *node = d->mesh.triangles[triangle];
    vec3 point = vec3_scale(x[node[0]], barycentric[0]);
    point = vec3_add_scaled(point, barycentric[1], x[node[1]]);
    return vec3_add_scaled(point, barycentric[2], x[node[2]]);
}

/* ---- snapshot.c */
void vbss_drain_serialise(vbss_stream *stream, void *object);

#endif
