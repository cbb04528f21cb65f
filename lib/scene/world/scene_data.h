/* The data of a scene: bodies, capsules, pins, grasps, the cursor of a step, and the scene itself.
 *
 * All folders of lib/scene share these types; this header declares no function. Units are SI.
 * Points and vectors are in world coordinates unless the comment names another frame. A body
 * number is the number that hosts use, from 1 on; 0 means the world or no body.
 *
 * Every field has one of these lifetimes. A comment such as "Substep." starts a group of fields.
 *   persistent  the state, which snapshots save, and data that follow from it until the next edit
 *   step        set when a step begins and valid to its end, also while the step is suspended
 *   substep     rebuilt by each attempt at a substep
 *   checkpoint  copies from before the step, which a rollback restores
 *   report      results of the last step for hosts
 *   scratch     meaningless outside the function that fills them */
#ifndef VBSS_SCENE_SCENE_DATA_H
#define VBSS_SCENE_SCENE_DATA_H

#include <vblast_ss/scene.h>
#include <vblast_ss/scene_event.h>

#include "base/edit_hook.h"
#include "collision/shapes.h"
#include "contact/contact.h"
#include "drain/drain.h"
#include "grasper/grasper.h"
#include "needle/needle.h"
#include "scene/tuning.h"
#include "solver/rigid.h"
#include "suture/suture.h"
#include "thread/thread.h"

/* Bodies ever added, and so shapes; threads at a time. Capacities, chosen. */
enum { SCENE_MAX_SHAPES = 4096, SCENE_MAX_THREADS = 64 };
/* Strands between two jaws that are distinguished; cuts of a step. */
enum { SCENE_MAX_STRANDS = 8, SCENE_MAX_CUTS = 8 };
/* Pairs of driven bodies that overlap since they were added. Chosen. */
enum { SCENE_MAX_OVERLAPS = 256 };
/* Vertices and triangles of a static mesh. Those of the collision module. */
enum { SCENE_MAX_MESH_VERTICES = 65536, SCENE_MAX_MESH_TRIANGLES = 131072 };
/* Default of speed_limit, m/s. Chosen: a hand is slower than 5 m/s. */
#define SCENE_DEFAULT_SPEED_LIMIT 20.0
#define SCENE_NO_FACE UINT32_MAX

/* ---- bodies */

typedef enum scene_body_kind {
    SCENE_BODY_NONE,
    SCENE_BODY_THREAD,
    SCENE_BODY_RIGID, /* graspers and needles as well */
    SCENE_BODY_DRAIN
} scene_body_kind;

/* A thread as a body of a scene. */
typedef struct scene_thread {
    /* Persistent. */
    vbss_slot *slot; /* slot of the thread's handle */
    thread_object *thread;
    /* Substep. */
    uint32_t first_block;  /* block of the thread's first node in the linear system */
    uint32_t first_spring; /* friction torque: the first of its springs, if it has rolls */
    /* Persistent. */
    uint32_t first_node;         /* its first node in arrays over the nodes of all threads */
    uint32_t contact_free_steps; /* consecutive steps without contact constraints, 0 to 16 */
    /* Substep. */
    bool has_contacts; /* the thread takes part in a contact constraint */
    bool is_welded;    /* one of its nodes is welded to a rigid body that is not driven */
    bool is_damped;    /* integrated by backward Euler; otherwise by generalised-alpha */
    vbss_integration integration;
    thread_substep substep;
    double residual_displacement; /* estimate of how far the residual would still move a node, m */
    /* Persistent; used by pieces only. */
    uint32_t cut_from;      /* number of the body it was cut from; 0 once the ends are apart */
    bool has_split_segment; /* the cut divided a segment, of which both bodies keep a part */
    /* Checkpoint; the thread has a copy of its own motion. */
    struct scene_thread_checkpoint {
        vbss_thread_statistics statistics;
        double previous_h; /* length of the last substep, s; 0: there was none */
        uint32_t damped_steps_left;
        bool needs_start_substep; /* the accelerations were unknown */
    } checkpoint;
} scene_thread;

/* Friction torque: rolls of as many segments share a block. The blocks follow those of the nodes. */
enum { SCENE_ROLLS_PER_BLOCK = 3 };
static inline uint32_t scene_first_roll_block(const scene_thread *b)
{
    return b->first_block + b->thread->node_count;
}

/* A drain as a body of a scene. */
typedef struct scene_drain {
    /* Persistent. */
    vbss_slot *slot; /* slot of the drain's handle */
    drain_object *drain;
    double friction; /* coefficient now */
    /* Substep. */
    uint32_t first_block;         /* block of the drain's first node in the linear system */
    uint8_t *is_separator;        /* per node: nonzero if its block is a separator */
    vec3 *expected_displacements; /* per node: displacement that the broad phase allows for, m */
    double max_displacement;      /* largest norm of the expected displacements, m */
    /* Scratch. */
    vec3 *vertices; /* two per node: positions at the start and end of the substep, m */
    /* Persistent. Per side: a triangle beside it if it is a free edge. Per node: a triangle with
     * a free edge that ends there. SCENE_NO_FACE: no free edge. */
    uint32_t *lip_of_side, *lip_of_node;
    /* Scratch of remeshing.c. */
    uint32_t *near_features; /* sides or triangles whose boxes overlap that of a probe */
    /* Substep. */
    drain_substep substep;
    double max_increment; /* largest displacement of a node in the last linearisation, m */
    /* Checkpoint; the drain has a copy of its own motion. */
    struct scene_drain_checkpoint {
        vbss_drain_statistics statistics;
    } checkpoint;
} scene_drain;

/* The needle that a grasper grasps. In the baseline method its jaws have closed on the needle;
 * the needle then follows the tool that scene_rigid::leader names. Persistent. */
typedef struct scene_needle_grasp {
    uint32_t needle; /* body number; 0: no needle */
    double arc;      /* arc length from the tip to the grasped point, m */
    double angle;    /* jaw angle at which both jaws touch the needle, rad; baseline method: 0 */
    /* Pose of the needle's frame at the grasped point (x outward, y toward the tip, z along the
     * axis of the arc) in the jaws' frame. Baseline method: principal frame of the needle in
     * that of the tool. */
    pose pose_in_jaws;
    double age; /* time since the needle was grasped, s */
    /* Total slip (m) and rotation (rad) since then; limit of the jaws' friction force, N. */
    double slid, turned, limit;
    vec3 force, torque;   /* last step: on the needle, about the grasped point, N and N m */
    bool is_sliding;      /* the needle slid or turned in the last step */
    bool is_released;     /* the jaws have released the needle but still overlap it */
    bool needs_reopening; /* torn out: no new grasp before the handle opens or the jaws are clear */
} scene_needle_grasp;

enum { SCENE_WALL_GRASP_POINTS = 3 };
/* The drain's wall that a grasper grasps, at up to three points along its jaws. Persistent. */
typedef struct scene_wall_grasp {
    uint32_t drain;       /* body number; 0: no wall */
    uint32_t point_count; /* 1 to SCENE_WALL_GRASP_POINTS */
    uint32_t triangle[SCENE_WALL_GRASP_POINTS];
    double weights[SCENE_WALL_GRASP_POINTS][3];   /* barycentric coordinates in the triangle */
    vec3 points_in_jaws[SCENE_WALL_GRASP_POINTS]; /* where the jaws hold them, in their frame, m */
    double angle; /* jaw angle at which both jaws touch the wall, rad */
    double age;   /* time since the wall was grasped, s */
    /* Total slip since then, m; limit of the jaws' friction force, N. */
    double slid, limit;
    vec3 force;           /* last step: on the drain, N */
    bool is_sliding;      /* the wall slid in the last step */
    bool is_released;     /* the jaws have released the wall but still overlap it */
    bool needs_reopening; /* torn out: no new grasp before the handle opens or the jaws are clear */
} scene_wall_grasp;

/* The motion of a host surface (world/host_surface.h). */
typedef struct scene_host_surface scene_host_surface;

/* A static mesh, rigid mesh or host surface. Its collision shape has the triangles, and the vertices of a
 * static or rigid mesh. Persistent. */
typedef struct scene_static_mesh {
    bool is_one_sided; /* nothing touches it from behind its triangles */
    double reach;      /* rigid mesh: largest distance of its surface from the centre of mass, m */
    uint64_t geometry_hash; /* of vertices, triangles, thickness and is_one_sided */
    /* vertex -> its first entry of triangles_of, one extra at the end; the triangles at each vertex */
    uint32_t *first_triangle, *triangles_of;
    /* edge -> its first two triangles in ascending order; SCENE_NO_FACE: it has fewer */
    uint32_t (*triangles_of_edge)[2];
    uint32_t *near_features; /* scratch of remeshing.c: as in scene_drain */
} scene_static_mesh;

/* A plane, which bounds a half-space. Persistent. */
typedef struct scene_plane {
    vec3 normal;   /* unit, out of the half-space */
    double height; /* along the normal, m */
} scene_plane;

/* A rigid body, grasper or needle as a body of a scene. Its principal frame has the centre of
 * mass as its origin and the principal axes as its axes. */
typedef struct scene_rigid {
    /* Persistent. */
    vbss_scene_rigid_kind kind;
    vbss_rigid body;     /* motion, mass, and the target poses at the start and end of the step */
    pose pending_target; /* target pose for the next step, if has_pending_target; principal frame */
    bool has_pending_target; /* the host set a target that no step has used yet */
    bool has_jumped;         /* a target was unlikely far away, and a warning given */
    pose frame;              /* principal frame in the frame that hosts see */
    double friction;         /* coefficient now */
    double created_friction; /* coefficient when the body was added */
    /* Sum of the forces (N) and torques about the centre of mass (N m) for the next step that
     * begins. */
    vbss_rigid_wrench pending_load;
    uint32_t first_capsule, capsule_count; /* its capsules in scene_object::capsules */
    /* Substep. */
    vbss_rigid_blocks blocks;    /* its blocks in the linear system */
    vbss_rigid_motion predicted; /* at the end of the substep, without contact */
    pose trial;                  /* at the end of the substep: the iterate; principal frame */
    /* Report; snapshots save it. */
    vec3 force, torque; /* sum of contacts and pins, about the centre of mass, N and N m */
    vbss_rigid_wrench coupling_wrench; /* by the virtual coupling in the last substep */
    /* Persistent. */
    vbss_slot *slot;       /* slot of the handle of a grasper or needle; NULL for other bodies */
    needle_object *needle; /* NULL unless the body is a needle */
    /* Persistent. */
    bool is_static_mesh;    /* the body has no capsules, and never moves */
    bool is_rigid_mesh;     /* the body has no capsules; its mesh moves with it */
    scene_static_mesh mesh; /* for static meshes, rigid meshes and host surfaces only */
    pose expected; /* substep; rigid meshes: pose at its end that the broad phase allows for */
    scene_host_surface *surface; /* NULL unless the body is a host surface */
    bool is_plane;               /* the body has no capsules, and never moves */
    scene_plane plane;           /* for planes only */
    /* Persistent; for graspers only. */
    grasper_object *grasper; /* NULL unless the body is a grasper */
    scene_needle_grasp needle_grasp;
    scene_wall_grasp wall_grasp;
    /* Checkpoint. */
    struct scene_rigid_checkpoint {
        vbss_rigid_motion motion;
        vbss_rigid_wrench coupling_wrench, load, pending_load;
        pose target_end; /* target pose at the end of the step: body.target_end */
        bool has_pending_target;
        /* For graspers only. */
        scene_needle_grasp needle_grasp;
        scene_wall_grasp wall_grasp;
        struct scene_checkpoint_jaws {
            vbss_grasper_kind kind, target_kind;
            double angle, pressure; /* jaw angle, rad; jaw force, N */
        } jaws;
    } checkpoint;
} scene_rigid;

/* Which other bodies a body collides with (world/filters.c). Persistent. */
typedef struct scene_filter {
    uint32_t category, mask; /* bits of its categories; bits of those that it collides with */
} scene_filter;

/* Values of the configuration that hosts change at run time. Persistent. */
typedef struct scene_settings {
    double floor_friction, thread_friction, speed_limit;
    uint32_t step_budget, call_budget; /* operations; 0: no limit */
    scene_filter floor_filter;
} scene_settings;

/* An entry in the table of bodies. `kind` says which of its last three members is in use. */
typedef struct scene_body {
    /* Persistent. */
    scene_body_kind kind;
    uint32_t number; /* body number; no other body of the scene ever has it */
    uint32_t shape;  /* shape in the collision object */
    scene_filter filter;
    void *user_data; /* of the host; no part of the state */
    /* Substep. */
    double max_displacement; /* largest displacement of a vertex that the CCD tests, m */
    /* Persistent: the body's next step begins with a substep that is halved this number of times. */
    uint32_t next_halvings;
    /* Step: its group. The body is frozen while another group takes its substeps (step/groups.c). */
    uint32_t group;
    bool is_frozen;
    /* Checkpoint. */
    struct scene_body_checkpoint {
        uint32_t next_halvings, group;
    } checkpoint;
    uint32_t island; /* scratch of step/islands.c: link to a body of the same island */
    /* Persistent. The entry is for a piece of a thread. Until the cut its kind is SCENE_BODY_NONE,
     * but it has a shape and a spare thread. */
    bool is_reserved;
    union {
        scene_thread thread; /* for kind SCENE_BODY_THREAD, and a reserved entry */
        scene_rigid rigid;   /* for kind SCENE_BODY_RIGID */
        scene_drain drain;   /* for kind SCENE_BODY_DRAIN */
    };
} scene_body;

/* A capsule of a rigid body. Ends of its axis: [0] and [1]; all `local` fields are in the
 * principal frame of the body, m. Jaws move in that frame; all other capsules are at rest in it. */
typedef struct scene_capsule {
    vec3 local[2];         /* persistent: now */
    vec3 local_end[2];     /* step: at the end of the step */
    vec3 local_trial[2];   /* substep: at the end of the substep */
    double radius;         /* persistent, m */
    vec3 now[2], trial[2]; /* substep: in the world, at its start and in the trial state, m */
    struct scene_capsule_checkpoint {
        vec3 local[2], local_end[2];
        double radius;
    } checkpoint;
} scene_capsule;

/* A node of a thread that is fixed to a body or to the world. Persistent. */
typedef struct scene_pin {
    uint32_t id;                 /* 0: unused entry */
    uint32_t thread, node, body; /* numbers; body 0: the world */
    uint32_t attachment;         /* id of the thread's attachment that moves the node; 0: a weld */
    vec3 point;                  /* position of the node in the principal frame of the body, m */
    vec3 checkpoint_target;      /* checkpoint: target of the attachment, m */
} scene_pin;

/* A strand of thread between the jaws of a grasper: it is held, or excluded from contact with the
 * jaws until it is clear of them. Persistent. */
typedef struct scene_thread_grasp {
    uint32_t id;           /* 0: unused entry */
    uint32_t thread, tool; /* body numbers */
    uint32_t segment;      /* segment with the middle of the grasp; baseline method: grasped node */
    double segment_offset; /* arc length from the start of that segment to the middle, at rest, m */
    double angle;          /* jaw angle at which both jaws touch the strand, rad */
    double point_spacing;  /* arc length between grip points, m; baseline method: 0 */
    grasper_thread_clamp grip;
    /* Total slip since the thread was grasped, m; limit of the jaws' friction force, N. */
    double slid, limit;
    vec3 force;         /* last step: on the thread, N */
    bool is_sliding;    /* the thread slid in the last step */
    bool is_released;   /* the jaws have released the thread but still overlap it */
    bool is_uncuttable; /* shears cannot cut the strand, and close through it; never held */
    /* Torn out or uncuttable: the jaws take the strand no more before the handle opens or they are
     * clear. */
    bool needs_reopening;
} scene_thread_grasp;

/* A point of a thread between jaws. Scratch. */
typedef struct scene_strand {
    const scene_body *thread;
    uint32_t segment;
    double fraction; /* position on the segment, 0 to 1 */
} scene_strand;

/* What a hole was before a step. Step. */
typedef struct scene_previous_hole {
    uint32_t id, needle; /* needle: body number; 0: a thread was in the hole */
} scene_previous_hole;

/* A cut that shears make at the end of the step. Step. */
typedef struct scene_cut {
    uint32_t thread;   /* body number */
    double arc_length; /* from the first node, at rest, m */
} scene_cut;

/* Two bodies that touch, by number, or a body that touches itself; body_b 0: the floor. */
typedef struct scene_touching_pair {
    uint32_t body_a, body_b;
} scene_touching_pair;

/* A contact as the views show it. The baseline method keeps a list of them during a step. */
typedef struct scene_contact_record {
    contact_key key;
    vec3 normal; /* unit, from b to a */
    vec3 force;  /* on a by b, N; in passes of the baseline method mass times displacement */
    vec3 point;  /* between the surfaces, m */
    double gap;  /* between the surfaces, m; negative where they overlap */
} scene_contact_record;

/* Geometry of a contact constraint: what the contact law does not need. Substep. */
typedef struct scene_contact_geometry {
    /* Contact point on both features: fractions of two lines, or for a point and a triangle the
     * weights of its second and third corner. */
    double barycentric[2];
    /* Two segments: those on which the contact points are. They differ from the features of the key where the contact
     * slides on to neighbouring segments in the substep. On the key's segments, the points at the start. */
    uint32_t segments[2];
    double start_barycentric[2];
    /* Lines: interval of each axis on which contact is possible, as fractions of it. */
    double axis_interval[2][2];
    vec3 point;              /* midway between the surfaces, m */
    double contact_distance; /* distance of the axes or centres at contact, m */
    double lip_thickness;    /* contact of two lips: thickness of the wall along the normal, m */
    double
        overlap_allowance; /* overlap that is allowed without a force, at a hole or from before the substep, m */
    double start_gap; /* at the start of the substep, allowance included, m */
    /* Hole: arc length at the start of the substep, m; span of the thread along which it may
     * slide. */
    double start_arc_length;
    uint32_t span;
    /* Scratch of duplicate_contacts.c: identities of both contact points; list of a bucket. */
    uint32_t dedup_points[2], dedup_next;
} scene_contact_geometry;

/* ---- substeps */

/* Result of an attempt at a substep. */
typedef enum scene_substep_outcome {
    SCENE_SUBSTEP_ACCEPTED,
    SCENE_SUBSTEP_NO_ACTIVE_SET, /* the search for the active set did not converge */
    SCENE_SUBSTEP_NOT_CONVERGED, /* the Newton iterations did not converge */
    SCENE_SUBSTEP_PENETRATION,   /* more penetration than is allowed */
    SCENE_SUBSTEP_CCD_HIT,       /* two features would pass through each other, or come too near */
    SCENE_SUBSTEP_SINGULAR,      /* a pivot was too small, or a number is not finite */
    SCENE_SUBSTEP_OUT_OF_CAPACITY, /* too many candidates or contacts: the step fails */
    SCENE_SUBSTEP_SUSPENDED,       /* the budget of the call is exhausted; the next call resumes */
    SCENE_SUBSTEP_REGROUPED /* the group or its substep has changed: the attempt begins again */
} scene_substep_outcome;

/* The present substep, and how the next attempt at it differs from the first. Substep. */
typedef struct scene_substep {
    double step_length;                  /* length of the whole step, s */
    double start_fraction, end_fraction; /* fractions of the step, 0 to 1 */
    double h;                            /* length of the substep, s */
    bool has_fixed_normals; /* contacts keep their normals; an attempt with updated ones failed */
    bool uses_trial_motion; /* expected displacements are those of the rejected attempt */
    bool is_min_size;       /* the substep is not halved any more */
    bool has_search_budget; /* the search failed without a limit; the next one stops early */
} scene_substep;

/* State of the Newton iterations of an attempt. Substep; it outlives the call if the attempt is
 * suspended. */
typedef struct scene_newton_state {
    /* The part of an iteration that is due next. */
    enum { SCENE_NEWTON_LINEARISE, SCENE_NEWTON_ACTIVE_SET, SCENE_NEWTON_CORRECT } phase;
    bool is_suspended;       /* the active-set search is suspended and resumes where it stopped */
    uint32_t linearisations; /* in this attempt */
    uint32_t normal_updates; /* how often the contact normals were updated in this attempt */
    /* Extra linearisations because a needle in a hole turned far; linearisations over budget. */
    uint32_t needle_linearisations, over_budget_linearisations;
    /* A correction was made or is under way; a drain moved far, so that one more linearisation
     * follows; the search starts from the current active set. */
    bool has_correction, has_extra_linearisation, starts_from_current;
    uint64_t search_budget; /* operations of the step at which the search stops; 0: no limit */
    bool is_finite, is_converged; /* the trial state */
    double stretch;               /* largest stretch error of the trial state, relative */
} scene_newton_state;

/* Groups of bodies in a step; halvings of a substep, which the halving limit keeps far below.
 * Chosen. */
enum { SCENE_MAX_GROUPS = 8, SCENE_MAX_HALVINGS = 64 };
/* Where a group begins that split off from another (step/groups.c). */
typedef struct scene_waiting_group {
    scene_substep substep;
    double size;
    uint32_t attempts;
    bool is_behind_targets, is_free; /* as in the cursor; is_free: free bodies only */
    uint64_t operations_before;      /* operations of the step that do not count for the group */
} scene_waiting_group;

/* Position within a step. If a step exceeds the budget of a call of vbss_scene_step, the call
 * suspends it and the next call resumes it (step/time_slice.c). Persistent: snapshots save it. */
typedef struct scene_step_cursor {
    scene_substep substep;
    /* Sizes of substeps as fractions of the step: the first size, the present one, the smallest,
     * and the smallest for a scene with drains whose operation budget is exhausted. They are
     * powers of two, so that substeps add up to exactly 1. */
    double initial_size, size, min_size, hard_min_size;
    uint32_t attempts;    /* in this step */
    uint32_t truncations; /* of the group in this step */
    /* Groups of bodies that take their substeps one after the other: the present one, and all. */
    uint32_t group, group_count;
    scene_waiting_group waiting[SCENE_MAX_GROUPS]; /* per group that has not begun */
    bool is_behind_targets; /* driven bodies of the group lag behind, after a truncated substep */
    bool is_paused;         /* the group left out the rest of the step */
    double paused_fraction; /* largest part of the step that a group has left out */
    bool is_suspended;      /* the step has begun and is not complete */
    bool is_attempt_suspended;      /* its attempt was suspended and is not complete */
    bool is_attempt_in_memory;      /* memory holds that attempt; otherwise a replay restores it */
    uint32_t checks_passed;         /* suspension checks that the attempt has passed */
    uint64_t operations_at_attempt; /* operations of the step when the attempt began */
    uint64_t operations;            /* operations of the step so far */
    uint64_t operations_before;     /* operations of the step that do not count for the group */
    uint64_t operations_left;       /* operations that the present call may still use */
    uint32_t steps_behind;          /* steps that hosts have asked for and that have not begun */
    uint32_t unsliced_steps_left;   /* steps that must not be suspended, after an edit */
    uint32_t suspensions;           /* calls that count as suspending this step: time_slice.c */
    bool was_overdue;               /* free bodies go first, as the last step took three calls */
    bool is_free_group;             /* the present group has free bodies only; never suspended */
    uint64_t edit_count;            /* edits of all bodies when the last call ended */
} scene_step_cursor;

/* ---- the scene */

/* What a step needs until it ends. Lifetime: substep, unless the comment says step. */
typedef struct scene_step_context {
    /* Step: id and needle of each hole when the step began; config.hole_capacity entries. */
    scene_previous_hole *previous_holes;
    scene_cut cuts[SCENE_MAX_CUTS]; /* step: in descending order of arc length */
    uint32_t cut_count;             /* step */
    uint64_t budget;                /* operations of the step at which work stops; 0: no limit */
    double substep_length;          /* s */
    uint8_t *is_separator; /* per node of all threads: nonzero if its block is a separator */
    /* Displacements that the broad phase allows for, m: per node, node_capacity entries, then
     * two per capsule for its ends. */
    vec3 *expected_displacements;
    /* Geometry of contact constraints: config.contact_capacity entries; none in the baseline
     * method. */
    scene_contact_geometry *contact_geometries;
    uint32_t edge_pair_count; /* candidates of two edges, which come first */
    contact_weld *welds;      /* kept until the sparsity pattern of the bodies changes */
    uint32_t weld_count;
    /* Twist of threads with friction torque; kept until the sparsity pattern changes. No entries before such
     * a thread is added. */
    contact_spring *springs;
    uint32_t spring_count, spring_capacity;
    /* Hash of the system's sparsity pattern, 0 if there is none, and hash of the part that bodies
     * determine. Both last until the pattern is rebuilt. */
    uint64_t pattern_hash, body_pattern_hash;
    scene_newton_state newton;
    bool is_recovering;         /* the substep began with more penetration than is allowed */
    bool has_updated_normals;   /* the attempt failed after an update of contact normals */
    bool has_accepted_contacts; /* step: `contacts` are those of the last accepted substep */
    bool can_skip_slow_pairs;   /* the CCD may skip pairs that move by little */
    /* Some near pairs have no contact constraint, as both features have prescribed motion. */
    bool has_unlisted_pairs;
    double time_of_impact; /* fraction of the substep until the first CCD hit; 1: there is no hit */
    scene_touching_pair first_impact; /* the bodies of that hit */
} scene_step_context;

/* Buffers that are meaningless outside the function that fills them. */
typedef struct scene_scratch {
    vec3 *vertices;                    /* start and end positions of the vertices of one body, m */
    uint32_t *near_features;           /* for topology/remeshing.c: features near a probe */
    collision_block *ccd_batch;        /* queries of the CCD */
    vbss_rigid_capsule *mass_capsules; /* for the inertia of a new body */
    uint8_t *keeps_entry;              /* per warm-start entry: whether it stays */
    bool *is_duplicate; /* for contacts/duplicate_contacts.c: constraints to remove */
    /* For topology/cuts.c: per warm-start entry, the sides that are beyond the cut; bit 0 is side a,
     * bit 1 side b. */
    uint8_t *sides_beyond_cut;
} scene_scratch;

/* Bodies that are held back (world/blockers.c). Capacity, chosen. */
enum { SCENE_MAX_BLOCKERS = 16 };
typedef struct scene_blocker {
    scene_touching_pair bodies; /* 0: unknown, or the floor */
    vbss_scene_blocker_cause cause;
    double since, last; /* simulated time at which they were held back first and last, s */
    double lost_time;   /* s */
    double depth;       /* deepest overlap, m */
} scene_blocker;

/* Copies of the scene's own state from before the step. Those of bodies are in the bodies. */
typedef struct scene_checkpoint {
    scene_thread_grasp *thread_grasps;
    suture_hole *holes;
    uint32_t last_grasp_id, last_hole_id;
    scene_step_cursor cursor;
    uint32_t logged_event_count, lost_logged_events, pending_event_count, lost_pending_events;
    scene_blocker blockers[SCENE_MAX_BLOCKERS];
    uint32_t blocker_count;
    scene_touching_pair overlaps[SCENE_MAX_OVERLAPS];
    uint32_t overlap_count;
    vbss_scene_statistics statistics;
} scene_checkpoint;

/* Results of the last step, for hosts. Snapshots save the statistics, the touching pairs and the blockers. */
typedef struct scene_report {
    vbss_scene_statistics statistics;
    uint64_t generation; /* grows with every change that views show */
    /* In ascending order. The next step compares its own pairs with the first list. */
    scene_touching_pair *touching_pairs, *previous_touching_pairs;
    uint32_t touching_pair_count;
    /* Events of the last call as logs store them: kind, two bodies, a number that depends on the kind.
     * Their number; the number of those beyond config.event_capacity. */
    uint32_t (*logged_events)[4];
    uint32_t logged_event_count, lost_logged_events;
    scene_blocker blockers[SCENE_MAX_BLOCKERS]; /* snapshots save them */
    uint32_t blocker_count;
    bool is_unlogged; /* a scene of the library's own: its blockers are no warnings for the host */
    bool keeps_logged_events; /* some were added after the last call; the next keeps them */
    /* The contact views: contact_count entries, in the order of the features. */
    uint32_t contact_count;
    /* The first entries are those of the step before, of groups that wait. A restored scene has none. */
    uint32_t old_contact_count;
    uint32_t (
        *contact_features)[5]; /* vbss_scene_contact_kind, body a, feature a, body b, feature b */
    /* Points between the surfaces, m; unit, from b to a; on a by b, N. */
    vec3 *contact_points, *contact_normals, *contact_forces;
    double *contact_gaps; /* m; negative where surfaces overlap */
} scene_report;

/* Events (world/events.c). Persistent, but no part of the state: a snapshot has none. */
typedef struct scene_events {
    /* Events that hosts have not taken: a ring of config.event_capacity entries. */
    vbss_scene_event *ring;
    uint32_t first, count;
    uint64_t lost; /* since hosts took events last */
    /* Events of the step that is not complete, without step and time: config.event_capacity entries. */
    vbss_scene_event *pending;
    uint32_t pending_count, pending_lost;
} scene_events;

/* The scene: persistent state, then one member for each other lifetime. */
typedef struct scene_object scene_object;
typedef struct scene_method scene_method;
struct scene_object {
    const scene_method *method;
    struct baseline_scene *baseline; /* state of lib/baseline; NULL by the implicit method */
    vbss_context *context;
    vbss_edit_hook hook;      /* hears of all edits of the scene and its bodies */
    vbss_scene_config config; /* as the scene was created; `settings` has values that changed */
    vbss_baseline_config baseline_config; /* what config.baseline points to */
    vbss_solver_options solver;           /* what config.solver points to */
    scene_settings settings;
    vec3 floor_normal; /* unit */

    scene_body *bodies;
    scene_capsule *capsules; /* those of one rigid body are contiguous */
    scene_pin *pins;         /* config.pin_capacity entries */
    /* config.grasp_capacity grasps and config.hole_capacity holes; unused entries have id 0. */
    scene_thread_grasp *thread_grasps;
    suture_hole *holes;
    /* Driven bodies that overlap since they were added (world/driven_overlaps.c). */
    scene_touching_pair overlaps[SCENE_MAX_OVERLAPS];
    uint32_t overlap_count;
    uint32_t body_count, body_capacity; /* entries used so far, free ones included; all */
    uint32_t node_count, node_capacity; /* nodes of all threads */
    uint32_t capsule_count;
    /* The last of each number and id that the scene has assigned; 0: none yet. */
    uint32_t last_body_number, last_pin_id, last_grasp_id, last_hole_id;

    collision_object *collision; /* shapes; its candidates are those of the substep */
    vbss_slot collision_slot;    /* private handle of the collision object */
    uint32_t *body_of_shape;     /* index in `bodies` for each shape */
    uint32_t *body_of_number;    /* index in `bodies` for each body number, from 1 on */
    /* Warm start, and contact constraints of the substep; the linear system. Both are NULL in
     * the baseline method. */
    contact_set *contacts;
    vbss_system *system;

    scene_step_cursor cursor;

    scene_step_context step;
    scene_scratch scratch;
    scene_checkpoint checkpoint;
    scene_report report;
    scene_events events;

    /* Tests set this hook. It is called after an accepted substep is solved and before it is
     * committed, so that start and trial states are both available. NULL: none. */
    void (*on_substep)(void *data, const struct scene_object *scene);
    void *on_substep_data;
};

#endif
