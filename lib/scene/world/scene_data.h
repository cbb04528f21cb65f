/* What a scene is made of: bodies, capsules, pins, grasps, the cursor of a step, and the scene
 * itself. Every folder of lib/scene includes this; it declares no function. */
#ifndef VBSS_SCENE_SCENE_DATA_H
#define VBSS_SCENE_SCENE_DATA_H

#include <vblast_ss/scene.h>

#include "collision/shapes.h"
#include "contact/contact.h"
#include "drain/drain.h"
#include "grasper/grasper.h"
#include "needle/needle.h"
#include "solver/rigid.h"
#include "suture/paper.h"
#include "suture/suture.h"
#include "thread/thread.h"

/* Bodies ever added, and so shapes; threads at a time. */
enum { SCENE_MAX_SHAPES = 4096, SCENE_MAX_THREADS = 64 };
/* Strands between two jaws that are told apart; cuts of a step. */
enum { SCENE_MAX_STRANDS = 8, SCENE_MAX_CUTS = 8 };
/* What comes out of a body, or out of jaws, does not touch it within this arc, in distances of touching: that
 * within which a thread does not touch itself. */
#define SCENE_EXCLUSION_ARC_RATIO 1.6
/* Radius of a lip, the free edge of a drain, against another, in walls: what is cut is flat, and two lips meet where the
 * middles of their walls end. Not zero, or the guard could not tell on which side they are. */
#define SCENE_LIP_RADIUS_RATIO 0.1
#define SCENE_NO_FACE UINT32_MAX

/* ---- bodies */

typedef enum scene_body_kind {
    SCENE_BODY_NONE,
    SCENE_BODY_THREAD,
    SCENE_BODY_RIGID,
    SCENE_BODY_DRAIN
} scene_body_kind;

typedef struct scene_thread {
    vbss_slot *slot; /* of the thread's handle */
    thread_object *thread;
    uint32_t first_block;        /* in the system */
    uint32_t first_node;         /* in arrays over the nodes of all threads */
    uint32_t contact_free_steps; /* steps since something was near it, up to a few */
    bool has_contacts;           /* something is, in this part */
    bool is_welded;              /* a node of it to a body that moves as forces say */
    bool is_damped;              /* this part is made by backward Euler */
    vbss_integration integration;
    thread_substep substep;
    double residual_displacement; /* how far forces left out of balance would move a node, m */
    uint32_t cut_from; /* a piece: the body that it was cut from, until they are apart; else 0 */
    bool has_split_segment; /* that cut went through a segment, of which both have a part */
    /* before the step */
    vbss_thread_statistics checkpoint_statistics;
    double checkpoint_previous_h;
    uint32_t checkpoint_damped_steps_left;
    bool checkpoint_needs_start_substep;
} scene_thread;

typedef struct scene_drain {
    vbss_slot *slot; /* of the drain's handle */
    drain_object *drain;
    uint32_t first_block;         /* in the system */
    uint8_t *is_separator;        /* per node: separators */
    vec3 *expected_displacements; /* per node: how far it may move */
    double max_displacement;      /* of them, m */
    vec3 *vertices;               /* start and end, for the search */
    /* Of a lip, which is a free edge, per side, and of a node there: a triangle beside it; else SCENE_NO_FACE. */
    uint32_t *lip_of_side, *lip_of_node;
    uint32_t *near_features; /* remeshing.c: sides or triangles that a search has found */
    drain_substep substep;
    double max_increment; /* by the last linearisation of the part, its farthest node, m */
    vbss_drain_statistics checkpoint_statistics; /* before the step */
} scene_drain;

/* A needle in the jaws of a grasper. PAPER: jaws have closed on it; which tool it follows, it knows itself. */
typedef struct scene_needle_grasp {
    uint32_t needle; /* number; 0: none */
    double arc;      /* length, of the middle of what is held, m from the tip */
    double angle;    /* at which the jaws touch it; PAPER: 0, they are closed */
    pose
        pose_in_jaws; /* where that place is held, outward, toward the tip, across, in the jaws' frame; PAPER: the needle's
              * principal frame, in the tool's */
    double age;       /* s since it was taken */
    double slid, turned, limit;
    vec3 force, torque;   /* on the needle about that place, after the last step */
    bool is_sliding;      /* it slid or turned in the last step */
    bool is_released;     /* not held any more, but not clear of the jaws yet */
    bool needs_reopening; /* nor taken again before the handle has been opened, or it is clear */
} scene_needle_grasp;

/* A wall of a drain in the jaws of a grasper. */
enum { SCENE_WALL_GRASP_POINTS = 3 };
typedef struct scene_wall_grasp {
    uint32_t drain;       /* number; 0: none */
    uint32_t point_count; /* of points */
    uint32_t triangle[SCENE_WALL_GRASP_POINTS];
    double weights[SCENE_WALL_GRASP_POINTS][3];   /* of its corners in a point */
    vec3 points_in_jaws[SCENE_WALL_GRASP_POINTS]; /* where that is held, in the jaws' frame */
    double angle;                                 /* at which the jaws touch it */
    double age;                                   /* s since it was taken */
    double slid, limit;
    vec3 force;           /* on the drain after the last step */
    bool is_sliding;      /* it slid in the last step */
    bool is_released;     /* not held any more, but not clear of the jaws yet */
    bool needs_reopening; /* nor taken again before the handle has been opened, or it is clear */
} scene_wall_grasp;

typedef struct scene_rigid {
    vbss_rigid_kind kind;
    vbss_rigid body;         /* its begin and end: the target, crossed evenly in a step */
    pose pending_target;     /* and the one of the next, if it */
    bool has_pending_target; /* was told while a step waited */
    pose frame;              /* of centre of mass and principal axes, in the frame the host sees */
    double friction;
    uint32_t first_capsule, capsule_count;
    vbss_rigid_blocks blocks;
    vbss_rigid_motion predicted;
    pose trial;
    vec3 force, torque; /* of contacts and pins in the last part; about the centre of mass */
    vbss_rigid_wrench coupling_wrench;   /* of the coupling in the last part */
    vbss_rigid_motion checkpoint_motion; /* before the step */
    vbss_rigid_wrench checkpoint_coupling_wrench;
    vbss_slot *slot;       /* of the handle of a grasper or a needle; else NULL */
    needle_object *needle; /* of a needle; else NULL */
    uint32_t leader;       /* PAPER: number of the tool that the needle follows; 0: it is free */
    suture_toggle toggles[SUTURE_TOGGLES]; /* PAPER: where its tip is on its way through a wall */
    /* of a tool; else NULL */
    grasper_object *grasper;
    scene_needle_grasp needle_grasp, checkpoint_needle_grasp;
    scene_wall_grasp wall_grasp, checkpoint_wall_grasp;
    bool has_closed_jaws; /* PAPER: the jaws, in this step */
    pose checkpoint_end;
    struct scene_checkpoint_jaws {
        vbss_grasper_kind kind, target_kind;
        double angle, pressure;
    } checkpoint_jaws;
} scene_rigid;

typedef struct scene_body {
    scene_body_kind kind;
    uint32_t number; /* in the scene */
    uint32_t shape;  /* name in the collision object */
    double
        max_displacement; /* by its farthest node or end of a capsule, in the attempt that the guard looks at, m */
    bool
        is_reserved; /* for a piece: of kind SCENE_BODY_NONE, but with shape and thread, until that is cut */
    scene_thread thread;
    scene_rigid rigid;
    scene_drain drain;
} scene_body;

/* In the principal frame of its body; and where its axis is. */
typedef struct scene_capsule {
    vec3 local[2];       /* where it is in the body; jaws move against it */
    vec3 local_end[2];   /* where it shall be at the end of the step */
    vec3 local_trial[2]; /* at the end of the part under way */
    vec3 checkpoint_local[2], checkpoint_local_end[2]; /* before the step */
    double radius, checkpoint_radius;
    vec3 now[2], trial[2];
} scene_capsule;

typedef struct scene_pin {
    uint32_t id;                 /* 0: the place is free */
    uint32_t thread, node, body; /* numbers; body 0: the world */
    uint32_t attachment;         /* of the thread, for driven bodies and the world; 0: a weld */
    vec3 point;                  /* in the principal frame of the body, or in the world */
} scene_pin;

/* A place of a thread in the jaws of a grasper. */
typedef struct scene_thread_grasp {
    uint32_t id;           /* 0: free */
    uint32_t thread, tool; /* numbers */
    uint32_t segment;      /* of the middle of what is held; */
    double segment_offset; /* so far from the begin of that, unstretched, m */
    double angle;          /* at which the jaws touch it */
    double point_spacing;  /* of the points of the grip, m */
    grasper_thread_clamp grip;
    double slid, limit;
    vec3 force;           /* on the thread, after the last step */
    bool is_sliding;      /* it slid in the last step */
    bool is_released;     /* not held any more, but not clear of the jaws yet */
    bool needs_reopening; /* nor taken again before the handle has been opened */
    uint32_t pin;         /* PAPER: of the node `segment`; 0: another tool leads */
} scene_thread_grasp;

/* A place of a thread between jaws. */
typedef struct scene_strand {
    const scene_body *thread;
    uint32_t segment;
    double fraction; /* of it */
} scene_strand;

/* A hole before a step: its id, and the needle that was in it. */
typedef struct scene_previous_hole {
    uint32_t id, needle;
} scene_previous_hole;

/* What shears close on in this step. */
typedef struct scene_cut {
    uint32_t thread;
    double arc_length;
} scene_cut;

typedef struct scene_touching_pair {
    uint32_t body_a, body_b;
} scene_touching_pair;

/* PAPER: a pair that was responded to in the step under way. */
typedef struct scene_contact_record {
    contact_key key;
    vec3 normal; /* unit, from b to a */
    vec3 force;  /* of b on a, N; while there are passes mass times displacement */
    vec3 point;  /* between the surfaces */
    double gap;
} scene_contact_record;

/* ---- a part of a step */

/* What becomes of an attempt. */
typedef enum scene_substep_outcome {
    SCENE_SUBSTEP_ACCEPTED,
    SCENE_SUBSTEP_NO_ACTIVE_SET,   /* of the contacts were not found */
    SCENE_SUBSTEP_NOT_CONVERGED,   /* a thread's shape was not */
    SCENE_SUBSTEP_PENETRATION,     /* too much penetration */
    SCENE_SUBSTEP_CCD_HIT,         /* something would pass */
    SCENE_SUBSTEP_SINGULAR,        /* not even numbers */
    SCENE_SUBSTEP_OUT_OF_CAPACITY, /* no room: the step fails */
    SCENE_SUBSTEP_SUSPENDED        /* none yet: it goes on in the next call */
} scene_substep_outcome;

typedef struct scene_substep {
    double step_length;                  /* length of the whole step, s */
    double start_fraction, end_fraction; /* shares of it */
    double h;                            /* length of the part, s */
    bool has_fixed_normals; /* rows keep their normals: with new ones no shape was found */
    bool uses_trial_motion; /* ways are those of the attempt before */
    bool is_min_size;       /* it is not halved any more */
    bool has_search_budget; /* and its searches stop: states were not found */
} scene_substep;

/* How far the trial state of a part is from a shape. */
typedef struct scene_newton_state {
    enum { SCENE_NEWTON_LINEARISE, SCENE_NEWTON_ACTIVE_SET, SCENE_NEWTON_CORRECT } phase;
    bool is_suspended;       /* for the search under way to go on */
    uint32_t linearisations; /* so far */
    uint32_t normal_updates; /* that are new, so often */
    uint32_t needle_linearisations,
        over_budget_linearisations; /* linearisations for a needle that turns; after all work was spent */
    bool has_correction, has_extra_linearisation, starts_from_current;
    uint64_t search_budget; /* of the search */
    bool is_finite, is_converged;
    double stretch;
} scene_newton_state;

/* Where a step is. What of it is too much for a call of vbss_scene_step goes on in the next (step.c). */
typedef struct scene_step_cursor {
    scene_substep substep;
    double initial_size, size, min_size,
        hard_min_size; /* shares of the step; dyadic, so that parts sum to 1 exactly */
    uint32_t attempts;
    bool is_suspended;              /* the step is not at its end */
    bool is_attempt_suspended;      /* and an attempt is under way, */
    bool is_attempt_in_memory;      /* as it was left: it is not made once more */
    uint32_t checks_passed;         /* and has been let go on so often (contact_call_budget) */
    uint64_t operations_at_attempt; /* work of the step, in operations: when the attempt began; */
    uint64_t operations;            /* so far */
    uint64_t operations_left;       /* of the call, in operations */
    uint32_t steps_behind;          /* steps that have been asked for and not begun */
    uint32_t
        unsliced_steps_left; /* so many follow that do not wait: hosts have changed what waited */
    uint64_t edit_count;     /* of the bodies when it was left: what hosts change is seen by that */
} scene_step_cursor;

typedef struct scene_object scene_object;
struct scene_object {
    vbss_context *context;
    vbss_scene_config config;
    vec3 floor_normal;

    /* what is in it */
    scene_body *bodies;
    scene_capsule *capsules;
    scene_pin *pins;
    scene_thread_grasp *thread_grasps, *checkpoint_thread_grasps;
    suture_hole *holes, *checkpoint_holes;
    scene_previous_hole *previous_holes; /* in the same places, when the step began */
    uint32_t body_count, body_capacity;  /* places used so far; of bodies that may be gone */
    uint32_t node_count, node_capacity;  /* of all threads */
    uint32_t capsule_count;
    uint32_t last_body_number, last_pin_id, last_grasp_id,
        last_hole_id; /* the last that was given away */
    uint32_t checkpoint_last_grasp_id, checkpoint_last_hole_id;
    scene_cut cuts[SCENE_MAX_CUTS]; /* of the step under way */
    uint32_t cut_count;
    uint32_t contact_count; /* in the views */

    /* what a part works with: nothing here outlives it, but for what can be made again */
    collision_object *collision;
    vbss_slot collision_slot; /* its handle, nobody else's */
    uint32_t *body_of_shape;  /* of the body of each shape */
    contact_set *contacts;
    vbss_system *system;
    uint64_t pattern_hash;      /* hash of what the system's pattern was made for; 0: of nothing */
    uint64_t body_pattern_hash; /* the same without rows; while there is a pattern */
    uint8_t *is_separator;      /* of all nodes: separators */
    vec3 *
        expected_displacements; /* of all nodes, then of both ends of all capsules: how far they may move */
    vec3 *vertices;             /* of one shape, start and end */
    uint32_t *near_features; /* remeshing.c: features that a search has found */
    contact_weld *welds;
    uint32_t weld_count;
    uint32_t
        edge_pair_count; /* candidates of two edges, which come first; then a point and a triangle */
    collision_block *ccd_batch;
    vbss_rigid_capsule *mass_capsules; /* to weigh a new body */
    bool is_recovering;                /* the part began with more penetration than is allowed */
    double substep_length;             /* of the part under way, s */
    double next_initial_size,
        checkpoint_next_initial_size; /* share of a step with which the next one begins; dyadic */
    uint64_t step_budget; /* of the step, in operations: nothing is begun beyond it; 0: no limit */
    scene_step_cursor cursor, checkpoint_cursor;
    bool has_pending_events;   /* those there were made between two calls */
    scene_newton_state newton; /* of the attempt under way */
    bool has_updated_normals;  /* the last attempt failed with new normals */
    bool
        has_accepted_contacts; /* rows are those of a part that was taken, not of one thrown away */
    bool is_behind_targets;    /* the last part was cut short: what is driven is behind */
    bool can_skip_slow_pairs;  /* what moves little passes nothing */
    bool
        has_unlisted_pairs; /* some pairs that are near are no rows, as both sides go where they are told */
    double time_of_impact; /* share of the part after which something would pass; 1: nothing does */

    /* Tests look at every part that is taken, while its begin and its end are both there. */
    void (*on_substep)(void *data, const struct scene_object *scene);
    void *on_substep_data;

    scene_contact_record *baseline_contacts; /* PAPER, ascending keys */
    uint32_t baseline_contact_count, baseline_responses_in_pass;

    /* what is left of the last step */
    scene_touching_pair *touching_pairs, *previous_touching_pairs; /* ascending */
    uint32_t touching_pair_count;
    uint32_t (*events)[4];
    uint32_t event_count, lost_events, checkpoint_event_count, checkpoint_lost_events;
    uint64_t generation;
    vbss_scene_statistics statistics, checkpoint_statistics; /* kept: before the step */

    /* views */
    uint32_t (*contact_features)[5];
    vec3 *contact_points, *contact_normals, *contact_forces;
    double *contact_gaps;
};

#endif
