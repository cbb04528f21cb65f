/* The inside of a session, shared by the files of lib/session.
 *
 * step.c reads
 *   devices -> scene step -> knots -> metrics -> forces out -> record
 * device_io.c is the first and the fifth arrow, log_sync.c the second and the last, detector_feed.c the third and metrics_feed.c the
 * fourth. After the scene's step observe.c collects the observation of the task in one struct. From that struct alone phase.c,
 * throws.c and outcome.c derive the facts and the phase; task_state.c answers what they share, and events.c keeps their events.
 * create.c and api.c have the exported functions, session.c has the handle, snapshot.c the saved state; seek.c goes to a step of a
 * log. A file calls only files that do not call it back. */
#ifndef VBSS_SESSION_SESSION_H
#define VBSS_SESSION_SESSION_H

#include <vblast_ss/session.h>

#include "record/record.h"
#include "scene/api/inspect.h"

enum { SESSION_HANDS = 2, SESSION_TOOLS = 3, SESSION_MAX_THROWS = 8, SESSION_MAX_STRAYS = 16 };
/* Throws of the knot; transfers between them. */
enum { SESSION_REQUIRED_THROWS = 3, SESSION_TRANSFERS = 2 };
/* The hole in and the tail; the hole out and the needle's limb. */
enum { SESSION_ENTRY, SESSION_EXIT, SESSION_SIDES };

/* ---- what the task sees of a step, and nothing else */

typedef struct session_tool_observation {
    bool has_needle, has_tail; /* the needle; the thread near the end of its tail */
    bool is_shears;            /* it is shears now */
    double held_arc;           /* of the thread where it holds it, m; below 0: it does not */
    vec3 tip, force;           /* force: on the hand */
} session_tool_observation;

typedef struct session_hole_observation {
    uint32_t id;              /* 0: none */
    uint32_t mark;            /* the nearer one of the drain, 0 or 1 */
    uint32_t thread;          /* in it; 0: a needle */
    double distance_from_tip; /* from the needle's tip to it, along needle and thread, m */
    double arc;               /* of what is in it, m */
    vec3 position, force;
    double angle[2], axial[2]; /* of each mark to it, on the drain at rest */
} session_hole_observation;

/* What the detector says; kept while it looks elsewhere. */
typedef struct session_throw_observation {
    int32_t wraps, handedness; /* wraps 0: no throw */
    vbss_metrics_relation relation;
} session_throw_observation;

typedef struct session_knot_observation {
    uint32_t throw_count; /* of throws */
    session_throw_observation throws[SESSION_MAX_THROWS];
    vbss_knot_verdict next_throw; /* of a throw that is being tied */
    uint32_t faults;
    bool is_located; /* arcs: */
    double end_arcs
        [SESSION_SIDES]; /* arc lengths of the thread at which the knot ends, tail and needle's limb, m */
} session_knot_observation;

enum { SESSION_MAX_HOLES = 32 };
typedef struct session_observation {
    bool has_lost_body; /* a body is gone: nothing else is told */
    session_tool_observation tools[SESSION_TOOLS];
    uint32_t hole_count;
    session_hole_observation holes[SESSION_MAX_HOLES]; /* ascending id */
    uint32_t thread;                                   /* with the stitch */
    double thread_length;                              /* of it, m */
    double tension[SESSION_SIDES], max_tension;
    vec3 thread_ends[SESSION_SIDES]; /* the tail's, the begin */
    double gap, max_gap, signed_gap; /* open: the first, below 0 where the edges have crossed; m */
    vec3 lips[2];                    /* between which that is */
    double torn_fraction, drain_radius; /* share of the anchors; of the tube, m */
    vec3 into_tissue;                   /* into the tissue */
    session_knot_observation knot;
} session_observation;

/* ---- what is remembered */

/* A fact that changes only when it has been seen to be otherwise for some time. */
typedef struct session_debounced_value {
    uint32_t value, candidate;
    double since; /* s: when `seen` was seen first */
} session_debounced_value;

typedef struct session_throw {
    session_throw_observation value, candidate;
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
    double end_time;             /* of the task, s; 0 before */
    uint32_t thread;             /* its number: the piece with the stitch, after cuts */
    double thread_length;        /* of it after the last step, m; 0: not seen yet */
    vbss_session_phase phase;
    vbss_session_failure failure;
    session_hole holes[SESSION_SIDES];
    uint32_t newest_hole; /* id: younger ones have not been judged */
    uint32_t stray_holes[SESSION_MAX_STRAYS];
    session_debounced_value holding_tools; /* bits: which tools hold the needle */
    uint32_t last_holder; /* who held it last alone; VBSS_METRICS_NO_TOOL: nobody yet */
    session_debounced_value tail_set, throw_stage, newest_seated, knot_faults, broken;
    session_throw throws[SESSION_MAX_THROWS];
    uint32_t throw_count, seated_count;   /* that are tied; that are told to be seated */
    uint32_t missed_transfers;            /* bits: of throws, before which there was no transfer */
    uint32_t tied_by[SESSION_MAX_THROWS]; /* who held the needle then */
    uint32_t transferred;                 /* bits: after which throws */
    uint32_t cut_limbs;                   /* bits */
    session_knot_observation knot;        /* of the last look of the detector */
    double tail_length, gap, tension[SESSION_SIDES];
    uint32_t metrics_lost;

    uint64_t event_count, events_before_step; /* so far; before this step */
    vbss_session_event *events;               /* a ring */

    /* room for a step */
    session_observation observation;
} session_object;

/* The number in the scene of a tool, 0 to SESSION_TOOLS - 1; 0: the session has no such tool. */
static inline uint32_t session_tool_number(const session_object *s, uint32_t tool)
{
    return tool < SESSION_HANDS ? s->config.tools[tool] : s->config.shears;
}

/* session.c */
extern const vbss_kind vbss_session_kind;
vbss_result vbss_session_allocate(vbss_context *context, const vbss_session_config *config,
                                  session_object **session);
void vbss_session_free(vbss_context *context, void *object);
vbss_result vbss_session_open(const vbss_session *handle, session_object **session);
vbss_result vbss_session_edit(vbss_session *handle, session_object **session);

/* config.c */
vbss_result vbss_session_read_config(vbss_context *context, const vbss_session_config *config,
                                     vbss_session_config *own);
/* Whether a record or replay is of that scene. */
vbss_result vbss_session_check_record(const session_object *s, vbss_record *record);

/* device_io.c */
vbss_result vbss_session_read_devices(const session_object *s, double now);
vbss_result vbss_session_write_devices(const session_object *s, double now);

/* step.c: a step of which nobody hears. */
vbss_result vbss_session_advance(const vbss_slot *slot, session_object *s, double now, double h);

/* seek.c: brings the scene and the session to that step of the replayed log. */
vbss_result vbss_session_seek_step(const vbss_slot *slot, session_object *s, uint64_t step);

/* log_sync.c: the scene's step, recorded or replayed; then the mark of the session, written or compared, and its state. */
vbss_result vbss_session_step_scene(session_object *s, double h);
vbss_result vbss_session_sync_log(const vbss_slot *slot, session_object *s);
vbss_result vbss_session_record_snapshot(const vbss_slot *slot,
                                         vbss_record *record); /* NULL: none */

/* observe.c */
void vbss_session_observe(const session_object *s, session_observation *observed);
/* detector_feed.c: shows the detector what there is when it is time, and puts what it says into the look. */
vbss_result vbss_session_observe_knot(session_object *s, session_observation *observed);

/* phase.c: which facts hold, and what that comes to. */
void vbss_session_update_progress(session_object *s, const session_observation *observed);

/* task_state.c: true if the debounced value has changed. */
bool vbss_session_debounce(session_debounced_value *debounced, uint32_t candidate, double now,
                           double dwell);
bool vbss_session_is_over(const session_object *s);
/* The hole that the task calls in or out; NULL: it is not there. */
const session_hole_observation *vbss_session_find_hole(const session_observation *observed,
                                                       uint32_t id);
/* Whether a throw was begun: the tail is no longer drawn to its length. */
bool vbss_session_is_tying(const session_object *s);
bool vbss_session_is_threaded(const session_object *s);
/* throws.c */
void vbss_session_update_throws(session_object *s, const session_observation *observed);
/* outcome.c */
void vbss_session_update_cuts(session_object *s, const session_observation *observed);
void vbss_session_update_failures(session_object *s, const session_observation *observed);
void vbss_session_fail(session_object *s, vbss_session_failure failure);

/* events.c: an event of this step, which the caller fills further; tool VBSS_METRICS_NO_TOOL: none. */
vbss_session_event *vbss_session_emit_event(session_object *s, vbss_session_event_kind kind,
                                            uint32_t number, uint32_t undone, uint32_t tool);
vbss_session_event *vbss_session_event_at(const session_object *s, uint64_t index);
void vbss_session_dispatch_events(session_object *s);

/* metrics_feed.c */
vbss_result vbss_session_feed_metrics(session_object *s, const session_observation *observed);

/* snapshot.c */
void vbss_session_serialise(vbss_stream *stream, void *object);
/* A hash of the task alone, without events, detector and metrics. */
uint64_t vbss_session_task_hash(session_object *s);

#endif
