/* The inside of a scene, shared by the files of lib/scene.
 *
 * scene.c makes and ends scenes, bodies.c and pins.c what is in them. A step (step.c) reads
 *   tool poses -> candidates -> predict -> solve -> guard -> events -> tool forces
 * each of which is a file; the middle ones are an attempt at a part of the step, undone and halved when
 * what it finds is not accepted, and cut short in the end (clamp.c); how much of it a call does, call.c says. Method PAPER:
 * paper_step.c. */
#ifndef VBSS_SCENE_SCENE_H
#define VBSS_SCENE_SCENE_H

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
enum { SCENE_SHAPES = 4096, SCENE_THREADS = 64 };
/* Strands between two jaws that are told apart; cuts of a step. */
enum { SCENE_STRANDS = 8, SCENE_CUTS = 8 };
/* What comes out of a body, or out of jaws, does not touch it within this arc, in distances of touching: that
 * within which a thread does not touch itself. */
#define SCENE_PIN_ARC 1.6
/* Radius of a lip, the free edge of a drain, against another, in walls: what is cut is flat, and two lips meet where the
 * middles of their walls end. Not zero, or the guard could not tell on which side they are. */
#define SCENE_LIP 0.1
#define SCENE_NO_FACE UINT32_MAX

/* ---- bodies */

typedef enum body_kind { BODY_GONE, BODY_THREAD, BODY_RIGID, BODY_DRAIN } body_kind;

typedef struct scene_thread {
    vbss_slot *slot; /* of the thread's handle */
    thread_object *thread;
    uint32_t first_block; /* in the system */
    uint32_t first_node;  /* in arrays over the nodes of all threads */
    uint32_t calm;        /* steps since something was near it, up to a few */
    bool near;            /* something is, in this part */
    bool welded;          /* a node of it to a body that moves as forces say */
    bool damped;          /* this part is made by backward Euler */
    vbss_integration integration;
    thread_stage stage;
    double left;     /* how far forces left out of balance would move a node, m */
    uint32_t before; /* a piece: the body that it was cut from, until they are apart; else 0 */
    bool split;      /* that cut went through a segment, of which both have a part */
    /* before the step */
    vbss_thread_statistics kept;
    double kept_part;
    uint32_t kept_settling;
    bool kept_fresh;
} scene_thread;

typedef struct scene_drain {
    vbss_slot *slot; /* of the drain's handle */
    drain_object *drain;
    uint32_t first_block; /* in the system */
    uint8_t *marks;       /* per node: separators */
    vec3 *ways;           /* per node: how far it may move */
    double longest;       /* of them, m */
    vec3 *vertices;       /* start and end, for the search */
    /* Of a lip, which is a free edge, per side, and of a node there: a triangle beside it; else SCENE_NO_FACE. */
    uint32_t *lip_of_side, *lip_of_node;
    uint32_t *near; /* meshes.c: sides or triangles that a search has found */
    drain_stage stage;
    double moved;               /* by the last linearisation of the part, its farthest node, m */
    vbss_drain_statistics kept; /* before the step */
} scene_drain;

/* A needle in the jaws of a grasper. PAPER: jaws have closed on it; which tool it follows, it knows itself. */
typedef struct scene_hold {
    uint32_t needle; /* number; 0: none */
    double arc;      /* length, of the middle of what is held, m from the tip */
    double angle;    /* at which the jaws touch it; PAPER: 0, they are closed */
    pose
        at; /* where that place is held, outward, toward the tip, across, in the jaws' frame; PAPER: the needle's
              * principal frame, in the tool's */
    double age; /* s since it was taken */
    double slid, turned, limit;
    vec3 force, torque; /* on the needle about that place, after the last step */
    bool sliding;       /* it slid or turned in the last step */
    bool let_go;        /* not held any more, but not clear of the jaws yet */
    bool torn;          /* nor taken again before the handle has been opened, or it is clear */
} scene_hold;

/* A wall of a drain in the jaws of a grasper. */
enum { PINCH_POINTS = 3 };
typedef struct scene_pinch {
    uint32_t drain; /* number; 0: none */
    uint32_t count; /* of points */
    uint32_t triangle[PINCH_POINTS];
    double weights[PINCH_POINTS][3]; /* of its corners in a point */
    vec3 at[PINCH_POINTS];           /* where that is held, in the jaws' frame */
    double angle;                    /* at which the jaws touch it */
    double age;                      /* s since it was taken */
    double slid, limit;
    vec3 force;   /* on the drain after the last step */
    bool sliding; /* it slid in the last step */
    bool let_go;  /* not held any more, but not clear of the jaws yet */
    bool torn;    /* nor taken again before the handle has been opened, or it is clear */
} scene_pinch;

typedef struct scene_rigid {
    vbss_rigid_kind kind;
    vbss_rigid body; /* its begin and end: the target, crossed evenly in a step */
    pose told;       /* and the one of the next, if it */
    bool is_told;    /* was told while a step waited */
    pose frame;      /* of centre of mass and principal axes, in the frame the host sees */
    double friction;
    uint32_t first_capsule, capsule_count;
    vbss_rigid_blocks blocks;
    vbss_rigid_motion predicted;
    pose trial;
    vec3 force, torque;     /* of contacts and pins in the last part; about the centre of mass */
    vbss_rigid_pull pull;   /* of the coupling in the last part */
    vbss_rigid_motion kept; /* before the step */
    vbss_rigid_pull kept_pull;
    vbss_slot *slot;       /* of the handle of a grasper or a needle; else NULL */
    needle_object *needle; /* of a needle; else NULL */
    uint32_t leader;       /* PAPER: number of the tool that the needle follows; 0: it is free */
    suture_toggle toggles[SUTURE_TOGGLES]; /* PAPER: where its tip is on its way through a wall */
    /* of a tool; else NULL */
    grasper_object *grasper;
    scene_hold hold, kept_hold;
    scene_pinch pinch, kept_pinch;
    bool has_closed; /* PAPER: the jaws, in this step */
    pose kept_end;
    struct kept_jaws {
        vbss_grasper_kind kind, kind_told;
        double angle, pressure;
    } kept_jaws;
} scene_rigid;

typedef struct scene_body {
    body_kind kind;
    uint32_t number; /* in the scene */
    uint32_t shape;  /* name in the collision object */
    double
        moved; /* by its farthest node or end of a capsule, in the attempt that the guard looks at, m */
    bool
        reserved; /* for a piece: of kind BODY_GONE, but with shape and thread, until that is cut */
    scene_thread thread;
    scene_rigid rigid;
    scene_drain drain;
} scene_body;

/* In the principal frame of its body; and where its axis is. */
typedef struct scene_capsule {
    vec3 local[2];             /* where it is in the body; jaws move against it */
    vec3 local_end[2];         /* where it shall be at the end of the step */
    vec3 local_trial[2];       /* at the end of the part under way */
    vec3 kept[2], kept_end[2]; /* before the step */
    double radius, kept_radius;
    vec3 now[2], trial[2];
} scene_capsule;

typedef struct scene_pin {
    uint32_t id;                 /* 0: the place is free */
    uint32_t thread, node, body; /* numbers; body 0: the world */
    uint32_t attachment;         /* of the thread, for driven bodies and the world; 0: a weld */
    vec3 point;                  /* in the principal frame of the body, or in the world */
} scene_pin;

/* A place of a thread in the jaws of a grasper. */
typedef struct scene_grasp {
    uint32_t id;           /* 0: free */
    uint32_t thread, tool; /* numbers */
    uint32_t segment;      /* of the middle of what is held; */
    double into;           /* so far from the begin of that, unstretched, m */
    double angle;          /* at which the jaws touch it */
    double spacing;        /* of the points of the grip, m */
    grip grip;
    double slid, limit;
    vec3 force;   /* on the thread, after the last step */
    bool sliding; /* it slid in the last step */
    bool let_go;  /* not held any more, but not clear of the jaws yet */
    bool torn;    /* nor taken again before the handle has been opened */
    uint32_t pin; /* PAPER: of the node `segment`; 0: another tool leads */
} scene_grasp;

/* A place of a thread between jaws. */
typedef struct scene_strand {
    const scene_body *thread;
    uint32_t segment;
    double share; /* of it */
} scene_strand;

/* A hole before a step: its id, and the needle that was in it. */
typedef struct scene_hole_before {
    uint32_t id, needle;
} scene_hole_before;

/* What shears close on in this step. */
typedef struct scene_cut {
    uint32_t thread;
    double arc_length;
} scene_cut;

typedef struct scene_touch {
    uint32_t body_a, body_b;
} scene_touch;

/* PAPER: a pair that was responded to in the step under way. */
typedef struct scene_hit {
    contact_key key;
    vec3 normal; /* unit, from b to a */
    vec3 force;  /* of b on a, N; while there are passes mass times displacement */
    vec3 point;  /* between the surfaces */
    double gap;
} scene_hit;

/* ---- a part of a step */

/* What becomes of an attempt. */
typedef enum scene_verdict {
    VERDICT_ACCEPTED,
    VERDICT_STATES,   /* of the contacts were not found */
    VERDICT_STRETCH,  /* a thread's shape was not */
    VERDICT_DEPTH,    /* too much penetration */
    VERDICT_GUARD,    /* something would pass */
    VERDICT_SINGULAR, /* not even numbers */
    VERDICT_FULL,     /* no room: the step fails */
    VERDICT_WAITS     /* none yet: it goes on in the next call */
} scene_verdict;

typedef struct scene_part {
    double step;       /* length of the whole step, s */
    double begin, end; /* shares of it */
    double h;          /* length of the part, s */
    bool straight;     /* rows keep their normals: with new ones no shape was found */
    bool again;        /* ways are those of the attempt before */
    bool smallest;     /* it is not halved any more */
    bool stops;        /* and its searches stop: states were not found */
} scene_part;

/* How far the trial state of a part is from a shape. */
typedef struct scene_shape {
    enum { SHAPE_LINEARISES, SHAPE_SEARCHES, SHAPE_LOOKS } phase;
    bool waits;              /* for the search under way to go on */
    uint32_t linearisations; /* so far */
    uint32_t normals;        /* that are new, so often */
    uint32_t turnings, last; /* linearisations for a needle that turns; after all work was spent */
    bool looked, went_on, goes_on;
    uint64_t most_work; /* of the search */
    bool finite, converged;
    double stretch;
} scene_shape;

/* Where a step is. What of it is too much for a call of vbss_scene_step goes on in the next (step.c). */
typedef struct scene_way {
    scene_part part;
    double begun, size, smallest,
        least; /* shares of the step; dyadic, so that parts sum to 1 exactly */
    uint32_t attempts;
    bool waits;         /* the step is not at its end */
    bool attempted;     /* and an attempt is under way, */
    bool at_hand;       /* as it was left: it is not made once more */
    uint32_t passed;    /* and has been let go on so often (contact_slot) */
    uint64_t before;    /* work of the step, in operations: when the attempt began; */
    uint64_t work;      /* so far */
    uint64_t left;      /* of the call, in operations */
    uint32_t behind;    /* steps that have been asked for and not begun */
    uint32_t undivided; /* so many follow that do not wait: hosts have changed what waited */
    uint64_t changes;   /* of the bodies when it was left: what hosts change is seen by that */
} scene_way;

typedef struct scene_object scene_object;
struct scene_object {
    vbss_context *context;
    vbss_scene_config config;
    vec3 floor_normal;

    /* what is in it */
    scene_body *bodies;
    scene_capsule *capsules;
    scene_pin *pins;
    scene_grasp *grasps, *kept_grasps;
    suture_hole *holes, *kept_holes;
    scene_hole_before *holes_before;      /* in the same places, when the step began */
    uint32_t place_count, place_capacity; /* places used so far; of bodies that may be gone */
    uint32_t node_count, node_capacity;   /* of all threads */
    uint32_t capsule_count;
    uint32_t last_number, last_pin, last_grasp, last_hole; /* the last that was given away */
    uint32_t kept_last_grasp, kept_last_hole;
    scene_cut cuts[SCENE_CUTS]; /* of the step under way */
    uint32_t cut_count;
    uint32_t contact_count; /* in the views */

    /* what a part works with: nothing here outlives it, but for what can be made again */
    collision_object *collision;
    vbss_slot collision_slot; /* its handle, nobody else's */
    uint32_t *shape_places;   /* of the body of each shape */
    contact_set *contacts;
    vbss_system *system;
    uint64_t pattern;           /* hash of what the system's pattern was made for; 0: of nothing */
    uint64_t pattern_of_bodies; /* the same without rows; while there is a pattern */
    uint8_t *marks;             /* of all nodes: separators */
    vec3 *ways;     /* of all nodes, then of both ends of all capsules: how far they may move */
    vec3 *vertices; /* of one shape, start and end */
    uint32_t *near; /* meshes.c: features that a search has found */
    contact_weld *welds;
    uint32_t weld_count;
    uint32_t
        edge_pairs; /* candidates of two edges, which come first; then a point and a triangle */
    collision_block *block;
    vbss_rigid_capsule *solids; /* to weigh a new body */
    bool recovering;            /* the part began with more penetration than is allowed */
    double part_length;         /* of the part under way, s */
    double pace, kept_pace;     /* share of a step with which the next one begins; dyadic */
    uint64_t most_work; /* of the step, in operations: nothing is begun beyond it; 0: no limit */
    scene_way way, kept_way;
    bool carries_events; /* those there were made between two calls */
    scene_shape shape;   /* of the attempt under way */
    bool turned;         /* the last attempt failed with new normals */
    bool taken;          /* rows are those of a part that was taken, not of one thrown away */
    bool lagging;        /* the last part was cut short: what is driven is behind */
    bool proved;         /* what moves little passes nothing */
    bool unlisted; /* some pairs that are near are no rows, as both sides go where they are told */
    double earliest; /* share of the part after which something would pass; 1: nothing does */

    /* Tests look at every part that is taken, while its begin and its end are both there. */
    void (*watch)(void *watcher, const struct scene_object *scene);
    void *watcher;

    scene_hit *hits; /* PAPER, ascending keys */
    uint32_t hit_count, hits_of_pass;

    /* what is left of the last step */
    scene_touch *touches, *touches_before; /* ascending */
    uint32_t touch_count;
    uint32_t (*events)[4];
    uint32_t event_count, lost_events, kept_event_count, kept_lost_events;
    uint64_t generation;
    vbss_scene_statistics statistics, kept; /* kept: before the step */

    /* views */
    uint32_t (*contact_features)[5];
    vec3 *contact_points, *contact_normals, *contact_forces;
    double *contact_gaps;
};

extern const vbss_kind vbss_scene_kind;
vbss_result vbss_scene_open(const vbss_scene *handle, scene_object **scene);
/* To change what is in it: a step that waits is given up before. */
vbss_result vbss_scene_edit(vbss_scene *handle, scene_object **scene);
/* To change nothing of that. */
vbss_result vbss_scene_tell(vbss_scene *handle, scene_object **scene);
static inline vbss_collision *scene_collision(scene_object *s)
{
    return (vbss_collision *)&s->collision_slot;
}

/* bodies.c: the living body of a number; NULL and VBSS_ERROR_OUT_OF_RANGE, told. The thread of a number; the
 * rigid body. */
scene_body *vbss_scene_find_body(const scene_object *s, uint32_t number, body_kind kind);
/* The same, untold. */
scene_body *vbss_scene_body(const scene_object *s, uint32_t number);
/* Whether there is one of that kind. */
bool vbss_scene_has(const scene_object *s, body_kind kind);
/* Where the axis of a capsule is when its body is there; and at the end of the part. */
void vbss_scene_place_capsule(const scene_capsule *capsule, pose at, vec3 axis[2]);
void vbss_scene_place_trial(scene_capsule *capsule, pose at);
/* Where a segment of a thread, the axis of a capsule or a side of a drain is; false: there is no such body. */
bool vbss_scene_axis_of(const scene_object *s, uint32_t number, uint32_t feature, vec3 axis[2]);
/* It is where it shall be. */
void vbss_scene_finish_capsule(scene_capsule *capsule);
void vbss_scene_release_thread(scene_body *body);
/* The system of a scene with one more drain, or none; what it had room for goes. */
vbss_result vbss_scene_make_system(scene_object *s, const drain_object *comer);
/* A place for one more body of that kind, or NULL, told; which then gets its number. */
scene_body *vbss_scene_new_place(scene_object *s, body_kind kind);
void vbss_scene_publish(scene_object *s, scene_body *b, body_kind kind, uint32_t shape,
                        uint32_t *number);

/* bodies.c: where a rigid body, its principal frame, shall be after the next step; while a step waits that is kept until the next begins. */
void vbss_scene_tell_rigid(scene_object *s, scene_rigid *r, pose told);
void vbss_scene_take_told(scene_object *s);

/* tools.c: what graspers were told, before a step; what became of it, after; and as it was. */
void vbss_scene_keep_tools(scene_object *s);
void vbss_scene_return_tools(scene_object *s);
void vbss_scene_take_tools(scene_object *s, double h);
void vbss_scene_aim_capsules(scene_object *s, const scene_part *part);
void vbss_scene_settle_tools(scene_object *s, double h);
/* To hosts: where tools and needles are, what they hold. */
void vbss_scene_show_tools(scene_object *s);
void vbss_scene_release_grasper(scene_body *b);

/* grasps.c: the angle of a tool's jaws after the step, stopped by what they then hold; what it lets go as it
 * opens; what happened to all that is held. */
double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h);
void vbss_scene_let_go(scene_object *s, const scene_body *tool);
void vbss_scene_settle_grasps(scene_object *s, double h);
/* Those of what was let go that is clear of the jaws. */
void vbss_scene_forget_clear_grasps(scene_object *s);
/* A place for one more, or NULL. */
scene_grasp *vbss_scene_free_grasp(const scene_object *s);
uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool);
/* An event, with the place in micrometres. */
void vbss_scene_tell_grasp(scene_object *s, vbss_event_kind kind, const scene_grasp *g);
void vbss_scene_forget_grasps_of(scene_object *s, uint32_t number);
/* Whether a segment is so near to what is held, along the thread, that the jaws do not touch it. */
bool vbss_scene_is_held_at(const scene_object *s, const scene_grasp *g, uint32_t segment,
                           double touching);

/* needles.c: the needle's frame, which the host sees, from that of its principal axes. */
pose vbss_scene_needle_at(const scene_rigid *r, pose principal);
void vbss_scene_show_needle(const scene_body *b);
void vbss_scene_release_needle(scene_body *b);
/* holds.c: whether a tool holds a needle; one that is between its jaws; which it takes, and lets go as it opens; what
 * happened to all that is held; nothing of a tool or needle is any more. */
bool vbss_scene_holds_needle(const scene_object *s, uint32_t tool);
bool vbss_scene_find_needle(const scene_object *s, const scene_body *tool, scene_hold *found);
void vbss_scene_take_needle(scene_object *s, scene_body *tool, const scene_hold *found);
void vbss_scene_let_needle_go(scene_object *s, scene_body *tool);
void vbss_scene_settle_holds(scene_object *s, double h);
void vbss_scene_forget_holds_of(scene_object *s, uint32_t number);
void vbss_scene_show_hold(const scene_object *s, const scene_body *tool, vbss_grasp *grasp);
/* Whether a segment of a needle is so near to what is held, along its arc, that it does not touch that capsule of the
 * tool. */
bool vbss_scene_is_in_jaws(const scene_object *s, const scene_body *needle, uint32_t segment,
                           const scene_body *tool, uint32_t capsule);
/* Three rows a hold, in a list that has begun; how one lies in the trial state. */
bool vbss_scene_add_hold_rows(scene_object *s);
void vbss_scene_lay_hold_row(scene_object *s, contact_row *row);

/* pinches.c: the same of the wall of a drain, of which `point` is one. */
bool vbss_scene_pinches(const scene_object *s, uint32_t tool);
bool vbss_scene_find_wall(const scene_object *s, const scene_body *tool, scene_pinch *found);
void vbss_scene_take_wall(scene_object *s, scene_body *tool, const scene_pinch *found);
void vbss_scene_let_wall_go(scene_object *s, scene_body *tool);
void vbss_scene_settle_pinches(scene_object *s, double h);
void vbss_scene_forget_pinches_of(scene_object *s, uint32_t number);
void vbss_scene_show_pinch(const scene_object *s, const scene_body *tool, vbss_grasp *grasp);
bool vbss_scene_is_pinched(const scene_object *s, const scene_body *drain, vec3 point,
                           const scene_body *tool, uint32_t capsule);
bool vbss_scene_add_pinch_rows(scene_object *s);
void vbss_scene_lay_pinch_row(scene_object *s, contact_row *row);
void vbss_scene_mark_pinched(const scene_object *s, const contact_row *row);

/* holes.c. A row a hole, in a list that has begun; how one lies in the trial state; its nodes are separators; what
 * rows have found, when a part is taken. */
bool vbss_scene_add_hole_rows(scene_object *s);
void vbss_scene_lay_hole_row(scene_object *s, contact_row *row);
void vbss_scene_mark_hole(const scene_object *s, const contact_row *row);
void vbss_scene_keep_holes(scene_object *s);
/* The next part has other places in them. */
void vbss_scene_move_holes(scene_object *s);
/* How far the suture has slid through them in the trial state. */
void vbss_scene_find_slides(scene_object *s);
/* punctures.c. After a step: who has left holes, who makes one. */
void vbss_scene_settle_holes(scene_object *s);
/* holes.c again: how holes are as a step begins; at its end, who has left them. */
void vbss_scene_note_holes(scene_object *s);
void vbss_scene_leave_holes(scene_object *s);
/* folds.c: makes holes of what goes through beside those that needles are entering. */
void vbss_scene_find_folds(scene_object *s);
/* Whether that place of a hole's needle, an arc length from the tip, is in another hole of the same wall. */
bool vbss_scene_is_in_other_hole(const scene_object *s, const suture_hole *hole, double arc);
/* One that has been made, if there is room for it, and the event. */
void vbss_scene_add_hole(scene_object *s, suture_hole *made);
void vbss_scene_forget_holes_of(scene_object *s, uint32_t number);
/* Where a thread is cut that is to be cut there: not in a hole, in which only one of the two ends could be. */
double vbss_scene_outside_holes(const scene_object *s, uint32_t thread, double arc_length);
/* Of a thread that was cut there. */
void vbss_scene_divide_holes(scene_object *s, uint32_t thread, uint32_t piece, double arc_length);
/* What is left of a thread is no curve any more: after cuts, and changes of meshes. */
void vbss_scene_leave_short_threads(scene_object *s);
/* The thread whose begin is swaged to a needle; the needle; or NULL. */
const scene_body *vbss_scene_thread_of(const scene_object *s, const scene_body *needle);
const scene_body *vbss_scene_needle_of(const scene_object *s, const scene_body *thread);
/* paper_holes.c: particles at holes follow their needle at the end of a pass; whether a needle's capsule and a side of a drain
 * are so near to a hole that they do not touch; where a contact of a hole is shown; after a step, who leaves a hole and who
 * makes one. */
vbss_result vbss_scene_paper_carry(scene_object *s, double h);
bool vbss_scene_paper_is_in_hole(const scene_object *s, const scene_body *needle, uint32_t capsule,
                                 const scene_body *drain, uint32_t side);
void vbss_scene_paper_lay_hole(const scene_object *s, scene_hit *hit);
void vbss_scene_paper_settle_holes(scene_object *s);
void vbss_scene_paper_forget_toggles_of(scene_object *s, uint32_t number);

/* paper_needles.c: where needles, and what is pinned to them, will be after the step; back, if it fails; then, who has let one
 * go, whom it follows, who has closed on one. */
void vbss_scene_paper_aim_needles(scene_object *s, double h);
void vbss_scene_paper_return_needles(scene_object *s);
void vbss_scene_paper_settle_needles(scene_object *s, double h);

/* paper_grasps.c: what jaws have taken and let go, after a step; what the hand feels of it. */
void vbss_scene_paper_settle_grasps(scene_object *s);
vec3 vbss_scene_paper_hand_force(const scene_object *s, const scene_body *tool);

/* grasp_rows.c: three rows a grasp, in a list that has begun; how one lies in the trial state, all of it or what
 * a linearisation changes; a point of a thread that is held; the jaws' frame in the world. */
bool vbss_scene_add_grasp_rows(scene_object *s);
/* What is held is here in the trial state, and shall be there, in the jaws: a spring between the two, whose stiffness and terms
 * who calls it adds. */
void vbss_scene_lay_spring(contact_row *row, const scene_rigid *tool, vec3 here, vec3 there);
/* A row that ties two places, of whatever is held or pierced. False: no room. */
contact_row *vbss_scene_add_tie(scene_object *s, const contact_key *key);
void vbss_scene_lay_grasp_row(scene_object *s, contact_row *row);
vec3 vbss_scene_held_point(const scene_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point);
pose vbss_scene_jaws_of(const scene_rigid *r, pose principal);

/* shears.c. What cannot be cut is let through, at that angle of the blades; false: it can be, or there is no room to
 * remember it. */
bool vbss_scene_let_through(scene_object *s, uint32_t tool, const scene_strand *at, double angle);
void vbss_scene_note_cut(scene_object *s, const scene_strand *at);
void vbss_scene_make_cuts(scene_object *s);
/* Nodes of threads stand one behind the other in the order of their places. */
void vbss_scene_number_nodes(scene_object *s);

/* pieces.c: what cuts need, taken when a thread is added. Whether there is room for it and its pieces; their
 * shapes, after that of the thread, which goes as well if they cannot be made; their places. */
vbss_result vbss_scene_check_room(const scene_object *s, const thread_object *t);
vbss_result vbss_scene_make_shapes(scene_object *s, const thread_object *t, uint32_t shape);
void vbss_scene_place_spares(scene_object *s, thread_object *t, uint32_t first_shape);
/* When none of the family is left. */
void vbss_scene_return_spares(scene_object *s, const thread_reserve *family);
void vbss_scene_return_spare(scene_body *b);
/* The first place for a piece of that thread, or NULL; makes it a body, and undoes that. */
scene_body *vbss_scene_find_spare(const scene_object *s, const scene_body *thread);
void vbss_scene_make_piece(scene_object *s, scene_body *piece);
void vbss_scene_unmake_piece(scene_object *s, scene_body *piece);
/* State: whether there is a piece, and what only pieces have; then, when all bodies are read, what follows from
 * their numbers of nodes. */
void vbss_scene_visit_piece(vbss_stream *stream, scene_object *s, scene_body *b);
void vbss_scene_finish_pieces(vbss_stream *stream, scene_object *s);

/* cuts.c. Divides a thread between steps, or at the very end of one. Untold: VBSS_ERROR_OUT_OF_RANGE at an end,
 * where nothing is cut; VBSS_ERROR_CAPACITY when no cut is left, which is an event. */
vbss_result vbss_scene_cut_now(scene_object *s, scene_body *thread, double arc_length,
                               scene_body **piece);
void vbss_scene_tell_cut(scene_object *s, const scene_body *thread, const scene_body *piece,
                         double arc_length);
/* Whether two segments of threads are so near across a cut that they do not touch: the ends at a cut begin in
 * the same place. Until they have come apart, which is seen at the end of a step. */
bool vbss_scene_adjoins(const scene_object *s, const scene_body *a, uint32_t segment_a,
                        const scene_body *b, uint32_t segment_b);
void vbss_scene_part_pieces(scene_object *s);

/* meshes.c: threads refine and coarsen themselves, at the very end of a step. */
void vbss_scene_adapt_meshes(scene_object *s);
/* Whether the number of a thread's nodes may change while it is in the scene. */
static inline bool scene_thread_resizes(const thread_object *t)
{
    return t->config.cut_capacity > 0 || t->config.mesh == VBSS_MESH_ADAPTIVE;
}

/* pins.c: what the public functions do. */
vbss_result vbss_scene_pin_in_step(scene_object *s, uint32_t thread, uint32_t node, uint32_t body,
                                   uint32_t *pin);
void vbss_scene_unpin_in_step(scene_object *s, uint32_t pin);
void vbss_scene_forget_pins_of(scene_object *s, uint32_t number);
/* Whether it still holds its node: the host may have detached the attachment. */
bool vbss_scene_pin_holds(const scene_object *s, const scene_pin *pin);
/* The weld of a node, or NULL. */
const scene_pin *vbss_scene_weld_of(const scene_object *s, uint32_t thread, uint32_t node);
/* Whether a segment is so near to a pin on the body, or to the jaws' grasp, along the thread, that it does not
 * touch that capsule of it. */
bool vbss_scene_comes_from(const scene_object *s, const scene_body *thread, uint32_t segment,
                           const scene_body *rigid, uint32_t capsule, double touching);
/* Attached nodes shall be where their driven bodies will be. */
void vbss_scene_aim_pins(scene_object *s);

/* Contacts whose feature a, if it is of a thread, is a node; a segment. */
static inline bool scene_is_of_node(uint32_t kind)
{
    return kind == VBSS_CONTACT_NODE_CAPSULE || kind == VBSS_CONTACT_NODE_FLOOR ||
           kind == VBSS_CONTACT_POINT_FACE;
}

static inline bool scene_is_of_surface(uint32_t kind)
{
    return kind == VBSS_CONTACT_POINT_FACE || kind == VBSS_CONTACT_SIDES;
}

static inline bool scene_is_of_segment(uint32_t kind)
{
    return kind == VBSS_CONTACT_SEGMENTS || kind == VBSS_CONTACT_SEGMENT_CAPSULE ||
           kind == VBSS_CONTACT_SIDES;
}

/* ---- an attempt, in order */

/* Ways are taken for so much longer than a part: velocities change within it. */
#define SCENE_AHEAD 1.2
/* candidates.c: rows of what might touch. False: no room. */
bool vbss_scene_find_rows(scene_object *s, const scene_part *part);
/* All pairs of features whose boxes meet where their shapes were moved to. */
vbss_result vbss_scene_find_pairs(scene_object *s);
/* Adds that row if its features may touch in the part. What they do in it is what their vertices do. b is NULL: the floor,
 * which does nothing. False: no room. */
typedef struct scene_meeting {
    const scene_body *a, *b;
    const vec3 *ways_a, *ways_b;
    uint32_t count_a, count_b;
    const collision_candidate *pair; /* whose axes the row is about; NULL: none */
} scene_meeting;
bool vbss_scene_add_row(scene_object *s, const contact_key *key, const scene_meeting *m);
/* The same of a point with a radius and the floor. */
bool vbss_scene_add_floor_row(scene_object *s, const contact_key *key, const scene_body *b, vec3 x,
                              double radius, vec3 way);
/* The floor, a driven body, nodes that are all held: nothing about them can be changed. */
bool vbss_scene_is_given(const scene_object *s, const scene_body *b, uint32_t kind, bool is_b,
                         uint32_t feature);
/* doubles.c: of rows about the same two points, in a list that is sorted, one stays. */
void vbss_scene_remove_doubles(scene_object *s);
/* surfaces.c: rows of a pair of which one or both are of drains; of a drain and the floor. */
bool vbss_scene_add_surface_row(scene_object *s, const collision_candidate *q);
bool vbss_scene_add_drain_floor_rows(scene_object *s, const scene_body *b);
/* Nodes of a feature of a drain; returns how many. */
uint32_t vbss_scene_nodes_of(const scene_object *s, const scene_body *drain, uint32_t kind,
                             bool is_b, uint32_t feature, uint32_t nodes[3]);
/* recall.c: what the rows remember of the last part. */
void vbss_scene_recall_rows(scene_object *s, const scene_part *part);
/* drains.c: in a step, each stage of it. */
void vbss_scene_release_drain(scene_object *s, scene_body *b);
void vbss_scene_keep_drain(scene_drain *b);
void vbss_scene_return_drain(scene_drain *b);
void vbss_scene_aim_drain(scene_drain *b, const scene_part *part);
void vbss_scene_shorten_drain(scene_drain *b, double share);
void vbss_scene_arrive_drains(scene_object *s, double h);
void vbss_scene_paper_arrive_drain(scene_drain *b, double h);
/* predict.c: trial states, from where the part begins. */
void vbss_scene_predict(scene_object *s, const scene_part *part);
/* features.c: how the sides of a row lie at the begin of the part (b is NULL: the floor); false: too far apart to touch in it. */
bool vbss_scene_lay_row(const scene_object *s, contact_row *row, const scene_body *a,
                        const scene_body *b, double reach);
/* Terms of a node, and of a point of a rigid body. */
void vbss_scene_add_node_term(const scene_object *s, contact_row *row, const scene_body *b,
                              uint32_t node, double weight);
void vbss_scene_add_rigid_terms(contact_row *row, const scene_rigid *r, vec3 point, double weight);
/* All that a row is beside that, in the trial state; and what a further linearisation changes. The normal
 * stays. */
void vbss_scene_set_rows(scene_object *s, const scene_part *part);
void vbss_scene_refresh_rows(scene_object *s);
/* As they lie in the trial state, with the normals that they have there. */
void vbss_scene_lay_rows_again(scene_object *s);
/* Gaps in the trial state, whatever the normals. */
void vbss_scene_measure_gaps(scene_object *s);
/* pattern.c: which blocks are separators, and the system's pattern. */
void vbss_scene_number_blocks(scene_object *s);
vbss_result vbss_scene_build_pattern(scene_object *s);
void vbss_scene_set_weld_arms(scene_object *s);
/* step.c: begins a step; goes through its parts, to the end or until the rest waits (scene_way::waits); what follows at the end. */
void vbss_scene_begin_step(scene_object *s, double h);
vbss_result vbss_scene_go_through(scene_object *s);
void vbss_scene_finish_step(scene_object *s);
/* The rest of a step that waits is left out: its end may follow. */
void vbss_scene_give_up(scene_object *s);
/* How small parts of its steps may be. */
void vbss_scene_take_parts(scene_object *s);
/* What an attempt costs before it is solved, as the last one did; whether steps have a limit of work. */
uint32_t vbss_scene_attempt_cost(const scene_object *s);
bool vbss_scene_is_limited(const scene_object *s);
/* Whether a step may be made of parts of that size. */
bool vbss_scene_is_part(const scene_object *s, double size);
/* step.c: work that is done, in products of blocks; whether no more may be. */
void vbss_scene_spend(scene_object *s, uint32_t work);
bool vbss_scene_is_spent(const scene_object *s);
/* believe.c: whether what a search that was stopped has led to may be taken. */
bool vbss_scene_believes(const scene_object *s, const scene_part *part);
/* Whether it might be, after further linearisations. */
bool vbss_scene_may_yet_believe(const scene_object *s, const scene_part *part);
/* By which a block has moved in the trial state, and what it is a node of: a thread, a drain, or neither (BODY_GONE). */
body_kind vbss_scene_find_way(const scene_object *s, uint32_t number, vec3 *way);
/* solve.c: bodies and contacts, one system; what a linearisation costs. */
uint32_t vbss_scene_linearisation_cost(const scene_object *s);
scene_verdict vbss_scene_solve(scene_object *s, const scene_part *part);
/* Goes on where that has waited; hosts may have looked at bodies meanwhile, no more. */
scene_verdict vbss_scene_solve_on(scene_object *s, const scene_part *part);
/* guard.c */
scene_verdict vbss_scene_guard(scene_object *s);
/* commit.c: shows the part to whoever watches; the trial state becomes the state; and what says that motion is not smooth. */
void vbss_scene_show_part(const scene_object *s);
void vbss_scene_commit(scene_object *s, const scene_part *part);
void vbss_scene_commit_capsules(scene_object *s);
void vbss_scene_unsettle(scene_object *s);
/* clamp.c: as much of the trial state as does no harm becomes the state. Returns the share. */
double vbss_scene_clamp(scene_object *s, scene_verdict verdict, const scene_part *part);
/* Nothing moves after an attempt that was not accepted: rows, which are shown, say what contact does where things are. */
void vbss_scene_stay(scene_object *s);

/* ---- around it */

/* state.c */
void vbss_scene_serialise(vbss_stream *stream, void *object);
/* way_state.c */
void vbss_scene_visit_way(vbss_stream *stream, scene_object *s);

/* kept.c: takes down how everything is, goes back there; counters alone. */
vbss_result vbss_scene_keep(scene_object *s);
void vbss_scene_go_back(scene_object *s);
void vbss_scene_return_statistics(scene_object *s);

/* call.c. Ends the step that waits, if one does, without what is left of it. */
vbss_result vbss_scene_end_waiting(scene_object *s);
/* Tells one state of the threads and drains from what hosts make of it. */
uint64_t vbss_scene_count_changes(const scene_object *s);
vbss_result vbss_scene_ours_step(scene_object *s, double h);
vbss_result vbss_scene_paper_step(scene_object *s, double h); /* paper_step.c */
/* paper_contacts.c: what is near; all of it once, tested and moved apart. At the end, before anything arrives:
 * where the surfaces of what was moved are, and its forces; the deepest overlap of what is near. */
vbss_result vbss_scene_paper_search(scene_object *s);
vbss_result vbss_scene_paper_pass(scene_object *s, double h);
double vbss_scene_paper_measure(scene_object *s, double h);
/* One more, or one more time, was responded to: mass times displacement of its first side. */
vbss_result vbss_scene_paper_note_hit(scene_object *s, const contact_key *key, vec3 normal,
                                      vec3 push);
/* A response of less than this share of D is rounding. */
#define SCENE_NO_DEPTH 1e-9
/* events.c: at the end of a step. */
void vbss_scene_begin_events(scene_object *s);
void vbss_scene_add_event(scene_object *s, vbss_event_kind kind, uint32_t a, uint32_t b,
                          uint32_t number);
void vbss_scene_note_touches(scene_object *s);
void vbss_scene_show_lost(scene_object *s);
/* forces.c: the force of a row on its first side, N, with which all balances, and whether it bears any; what contacts and pins do to
 * the rigid bodies; views of contacts. */
bool vbss_scene_find_force(const contact_set *set, uint32_t i, vec3 *force);
void vbss_scene_note_forces(scene_object *s);

#endif
