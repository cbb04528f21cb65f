/* The inside of a session, shared by the files of lib/session.
 *
 * step.c reads
 *   devices -> scene step -> knots -> metrics -> forces out -> record
 * hands.c is the first and the fifth arrow, scene.c the second, knots.c shows the thread to the detector, measure.c tells the
 * metrics, log.c writes marks and compares them. Between them look.c puts what the task can see of a step into one struct, and
 * task.c, throws.c and ends.c find from that alone which facts hold, and so the phase; events.c keeps what they tell.
 * config.c checks, session.c makes and ends, state.c saves, seek.c goes to a step of a log. */
#ifndef VBSS_SESSION_SESSION_H
#define VBSS_SESSION_SESSION_H

#include <vblast_ss/session.h>

#include "record/record.h"
#include "scene/scene.h"

enum { SESSION_HANDS = 2, SESSION_TOOLS = 3, SESSION_THROWS = 8, SESSION_STRAYS = 16 };
/* Throws of the knot; transfers between them. */
enum { SESSION_WANTED = 3, SESSION_TRANSFERS = 2 };
/* The hole in and the tail; the hole out and the needle's limb. */
enum { SESSION_IN, SESSION_OUT, SESSION_MARKS };

/* ---- what the task sees of a step, and nothing else */

typedef struct session_tool_look {
    bool has_needle, has_tail; /* the needle; the thread near the end of its tail */
    bool cuts;                 /* it is shears now */
    double held_arc;           /* of the thread where it holds it, m; below 0: it does not */
    vec3 tip, force;           /* force: on the hand */
} session_tool_look;

typedef struct session_hole_look {
    uint32_t id;     /* 0: none */
    uint32_t mark;   /* the nearer one of the drain, 0 or 1 */
    uint32_t thread; /* in it; 0: a needle */
    double way;      /* from the needle's tip to it, along needle and thread, m */
    double arc;      /* of what is in it, m */
    vec3 at, force;
    double angle[2], axial[2]; /* of each mark to it, on the drain at rest */
} session_hole_look;

/* What the detector says; kept while it looks elsewhere. */
typedef struct session_throw_look {
    int32_t wraps, handedness; /* wraps 0: no throw */
    vbss_metrics_relation relation;
} session_throw_look;

typedef struct session_knot_look {
    uint32_t count; /* of throws */
    session_throw_look throws[SESSION_THROWS];
    vbss_knot_verdict next; /* of a throw that is being tied */
    uint32_t faults;
    bool located; /* arcs: */
    double ends
        [SESSION_MARKS]; /* arc lengths of the thread at which the knot ends, tail and needle's limb, m */
} session_knot_look;

enum { SESSION_HOLES = 32 };
typedef struct session_look {
    bool lost; /* a body is gone: nothing else is told */
    session_tool_look tools[SESSION_TOOLS];
    uint32_t hole_count;
    session_hole_look holes[SESSION_HOLES]; /* ascending id */
    uint32_t thread;                        /* with the stitch */
    double length;                          /* of it, m */
    double tension[SESSION_MARKS], most_tension;
    vec3 thread_ends[SESSION_MARKS]; /* the tail's, the begin */
    double gap, gap_most, open;      /* open: the first, below 0 where the edges have crossed; m */
    vec3 lips[2];                    /* between which that is */
    double torn, radius;             /* share of the anchors; of the tube, m */
    vec3 away;                       /* into the tissue */
    session_knot_look knot;
} session_look;

/* ---- what is remembered */

/* A fact that changes only when it has been seen to be otherwise for some time. */
typedef struct session_latch {
    uint32_t value, seen;
    double since; /* s: when `seen` was seen first */
} session_latch;
/* True: it has changed. */
bool vbss_session_settle(session_latch *latch, uint32_t seen, double now, double dwell);

typedef struct session_throw {
    session_throw_look is, seen;
    double since;
} session_throw;

typedef struct session_hole {
    uint32_t id;       /* 0: none */
    uint32_t threaded; /* 1: the thread goes through it */
    uint32_t mark;     /* whose it is */
    double angle, axial, deviation_mm;
} session_hole;

typedef struct session_object {
    vbss_context *context;
    vbss_scene *scene;
    vbss_session_config config;

    /* the state */
    uint64_t steps, scene_steps; /* its own; the scene's, after them */
    double time, h;              /* since the needle appeared; of the last step */
    double end;                  /* of the task, s; 0 before */
    uint32_t thread;             /* its number: the piece with the stitch, after cuts */
    double length;               /* of it after the last step, m; 0: not seen yet */
    vbss_session_phase phase;
    vbss_session_failure failure;
    session_hole holes[SESSION_MARKS];
    uint32_t newest_hole; /* id: younger ones have not been judged */
    uint32_t strays[SESSION_STRAYS];
    session_latch held; /* bits: which tools hold the needle */
    uint32_t holder;    /* who held it last alone; VBSS_METRICS_NO_TOOL: nobody yet */
    session_latch tail, stage, seat, faults, broken;
    session_throw throws[SESSION_THROWS];
    uint32_t throw_count, seated;     /* that are tied; that are told to be seated */
    uint32_t missed;                  /* bits: of throws, before which there was no transfer */
    uint32_t tied_by[SESSION_THROWS]; /* who held the needle then */
    uint32_t transferred;             /* bits: after which throws */
    uint32_t cut;                     /* bits */
    session_knot_look knot;           /* of the last look of the detector */
    double tail_length, gap, tension[SESSION_MARKS];
    uint32_t metrics_lost;

    uint64_t event_count, step_events; /* so far; before this step */
    vbss_session_event *events;        /* a ring */

    /* room for a step */
    session_look look;
} session_object;

extern const vbss_kind vbss_session_kind;
vbss_result vbss_session_open(const vbss_session *handle, session_object **session);
vbss_result vbss_session_edit(vbss_session *handle, session_object **session);

/* config.c */
vbss_result vbss_session_read_config(vbss_context *context, const vbss_session_config *config,
                                     vbss_session_config *own);
/* Whether a record or replay is of that scene. */
vbss_result vbss_session_check_record(const session_object *s, vbss_record *record);

/* hands.c */
vbss_result vbss_session_read_hands(const session_object *s, double now);
vbss_result vbss_session_write_hands(const session_object *s, double now);

/* step.c: a step of which nobody hears. */
vbss_result vbss_session_make_step(const vbss_slot *slot, session_object *s, double now, double h);

/* log.c: the scene's step, recorded or replayed; then the mark of the session, written or compared, and its state. */
vbss_result vbss_session_step_scene(session_object *s, double h);
vbss_result vbss_session_mark(const vbss_slot *slot, session_object *s);
vbss_result vbss_session_put_state(const vbss_slot *slot, vbss_record *record); /* NULL: none */

/* look.c */
void vbss_session_look(const session_object *s, session_look *look);
/* knots.c: shows the detector what there is when it is time, and puts what it says into the look. */
vbss_result vbss_session_look_at_knot(session_object *s, session_look *look);

/* task.c: which facts hold, and what that comes to. */
void vbss_session_judge(session_object *s, const session_look *look);
bool vbss_session_is_over(const session_object *s);
/* The hole that the task calls in or out; NULL: it is not there. */
const session_hole_look *vbss_session_find_hole(const session_look *look, uint32_t id);
/* Whether a throw was begun: the tail is no longer drawn to its length. */
bool vbss_session_is_tying(const session_object *s);
bool vbss_session_is_threaded(const session_object *s);
/* throws.c */
void vbss_session_judge_throws(session_object *s, const session_look *look);
/* ends.c */
void vbss_session_judge_cuts(session_object *s, const session_look *look);
void vbss_session_judge_failures(session_object *s, const session_look *look);
void vbss_session_fail(session_object *s, vbss_session_failure failure);

/* events.c: an event of this step, which the caller fills further; tool VBSS_METRICS_NO_TOOL: none. */
vbss_session_event *vbss_session_tell(session_object *s, vbss_session_event_kind kind,
                                      uint32_t number, uint32_t undone, uint32_t tool);
vbss_session_event *vbss_session_event_at(const session_object *s, uint64_t index);
void vbss_session_announce(session_object *s);

/* measure.c */
vbss_result vbss_session_measure(session_object *s, const session_look *look);

/* state.c */
void vbss_session_serialise(vbss_stream *stream, void *object);
/* A hash of the task alone, without events, detector and metrics. */
uint64_t vbss_session_task_hash(session_object *s);

#endif
