/* Internal interface of sessions, shared by the files of lib/session.
 *
 * A step (step.c) does this:
 *   devices -> scene step -> knots -> metrics -> forces out -> record
 * device_io.c reads and writes the devices. log_sync.c steps the scene and keeps its log.
 * detector_feed.c runs the knot detector, and metrics_feed.c feeds the metrics.
 *
 * clock.c keeps the clocks of the task: time, and the part of it that the scene has lost.
 *
 * After the step of the scene, observe.c fills one struct, the observation. cut.c measures a limb that was cut. The
 * observation is the only input of
 * phase.c, throws.c and outcome.c, which derive the facts and the phase of the task. They share the
 * queries of task_state.c, and emit events through events.c.
 *
 * If config.coaching is set, coach.c then derives the goal (coach_goal.c) and the mistakes
 * (coach_mistakes.c) from the same observation. coach_geometry.c and coach_words.c describe them for
 * hosts. coach_task.c has the queries that they share.
 *
 * assist.c keeps the aids that a host has switched on. assist_input.c changes the input of a hand before it
 * becomes the target of its tool.
 *
 * If config.exercise is set, exercise.c measures the exercise and gives its outcome, which ends the task.
 * begin.c begins a task at a saved place.
 *
 * config.c has the configuration, session.c the handle, snapshot.c the saved state. create.c and
 * api.c have the exported functions. seek.c goes to a step of a log. A file calls only files that
 * do not call it back.
 *
 * Units are SI. Points and vectors are in world coordinates. A body number is the number that hosts
 * use; 0 means no body. A tool is an index from 0 to SESSION_TOOLS - 1; the first two are the left
 * and the right hand. Throws are counted from 0, the one next to the tissue. Arc lengths of a
 * thread are at rest, from its first node, which is at the needle until a cut. */
#ifndef VBSS_SESSION_SESSION_H
#define VBSS_SESSION_SESSION_H

#include <vblast_ss/session_assistance.h>
#include <vblast_ss/session_coaching.h>
#include <vblast_ss/session_exercise.h>

#include "record/record.h"
#include "scene/api/inspect.h"

/* Hands and tools of the task; capacities, chosen. */
enum { SESSION_HANDS = 2, SESSION_TOOLS = 3, SESSION_MAX_THROWS = 8, SESSION_MAX_STRAYS = 16 };
/* Throws of the knot; transfers between them. Published, as the task. */
enum { SESSION_REQUIRED_THROWS = 3, SESSION_TRANSFERS = 2 };
/* Indices of the two holes of the stitch, and of the two limbs of the thread that leave them: the
 * tail at the entry, the needle's limb at the exit. */
enum { SESSION_ENTRY, SESSION_EXIT, SESSION_SIDES };

/* ---- the observation: all facts of a step that the task may use */

typedef struct session_tool_observation {
    /* The tool grasps the needle; the thread, within config.tail_reach of its tail's end. */
    bool has_needle, has_tail;
    bool is_shears; /* its present kind is shears */
    /* Arc length of the grasped point of the thread that is nearest to the tail's end, m; negative:
     * the tool does not grasp the thread. */
    double held_arc;
    vec3 tip, force; /* position, m; force on the hand, N */
} session_tool_observation;

/* A hole in the wall of the drain. */
typedef struct session_hole_observation {
    uint32_t id;              /* ascending in the order of creation; 0: no hole */
    uint32_t mark;            /* the nearer mark of the drain, 0 or 1; for new holes only */
    uint32_t thread;          /* number of the thread in the hole; 0: the needle is in it */
    double distance_from_tip; /* from the needle's tip to the hole, along needle and thread, m */
    double arc;               /* from the needle's tip or the thread's first node to the hole, m */
    vec3 position;            /* m */
    /* Offset of the hole from each mark on the drain at rest: about the axis, rad, and along it, m.
     * For new holes only. */
    double angle[2], axial[2];
} session_hole_observation;

typedef struct session_throw_observation {
    int32_t wraps, handedness;      /* wraps 0: no throw; 1: right-handed, -1: left-handed */
    vbss_metrics_relation relation; /* to the throw before */
} session_throw_observation;

/* The last result of the knot detector. An uncertain reading updates next_throw only. */
typedef struct session_knot_observation {
    uint32_t throw_count; /* throws that are tied */
    session_throw_observation throws[SESSION_MAX_THROWS];
    vbss_knot_verdict next_throw; /* verdict of the throw that is being tied */
    uint32_t faults;              /* VBSS_KNOT_FAULT_ bits */
    bool is_located;              /* end_arcs is known */
    /* Arc lengths at which the knot ends, toward the tail and toward the needle's limb, m. */
    double end_arcs[SESSION_SIDES];
} session_knot_observation;

enum { SESSION_MAX_HOLES = 32 };
typedef struct session_observation {
    bool has_lost_body; /* a body of the session has left the scene; other fields are not valid */
    session_tool_observation tools[SESSION_TOOLS];
    uint32_t hole_count;
    session_hole_observation holes[SESSION_MAX_HOLES]; /* in ascending order of ids */
    uint32_t thread;                                   /* number of the piece with the stitch */
    double thread_length;                              /* at rest, m */
    /* Largest tension of each limb, 0 without its hole, and of the whole thread, N. */
    double tension[SESSION_SIDES], max_tension;
    double
        needle_pull; /* smallest tension of the limb beside the needle: a hand pulls with so much, N */
    vec3 thread_ends[SESSION_SIDES]; /* the tail's end; the first node */
    /* In the step of a cut: free length of the limb, from the cut to the first strand that touches it, m. 0: the cut is
     * inside the knot, since the severed piece touches the rest of the thread. */
    double free_length;
    /* Gap of the slit, m: in its middle, the largest along it, and in its middle with a sign, which
     * is negative if the edges have crossed. config.gap_measure says between what. */
    double gap, max_gap, signed_gap;
    double edge_gap;      /* between the edges in the middle, with a sign, by any measure, m */
    vec3 lips[2];         /* the points that the gap in the middle is between, left and right */
    double torn_fraction; /* share of torn anchors of the drain */
    double anchor_load;   /* the largest, relative to the strength of its anchor */
    double drain_radius;  /* radius of its tube, m */
    vec3 into_tissue;     /* from the slit to the centre of the drain, m */
    session_knot_observation knot;
} session_observation;

/* ---- the state of the task */

/* A fact that changes only after the observation has differed from it for the dwell time. */
typedef struct session_debounced_value {
    uint32_t value, candidate; /* the fact; the last observation */
    double since; /* time of the session at which the candidate was first observed, s */
} session_debounced_value;

/* A throw, debounced. */
typedef struct session_throw {
    session_throw_observation value, candidate;
    double since; /* time of the session at which the candidate was first observed, s */
} session_throw;

/* The entry or the exit of the stitch. */
typedef struct session_hole {
    uint32_t id;       /* 0: the hole does not exist */
    uint32_t threaded; /* 1: the thread goes through it; 0: the needle */
    uint32_t mark;     /* 0 or 1: the mark that the hole belongs to */
    /* Offset from the mark on the drain at rest: about the axis, rad; along it, m; in all, mm. */
    double angle, axial, deviation_mm;
} session_hole;

/* ---- the state of the coach */

typedef struct session_goal {
    vbss_session_goal goal;
    uint32_t tool; /* hand that acts, or VBSS_METRICS_TOOL_NONE */
} session_goal;

typedef struct session_coach {
    /* The goal: its code times SESSION_GOAL_TOOLS plus the hand. */
    session_debounced_value goal;
    double goal_since; /* time of the session at which the goal began, s */
    /* Bit per mistake: observed in the last step; begun and not ended, which is debounced. */
    uint64_t observed, open;
    /* Per mistake: time at which its bit in `observed` last changed; at which it began, s. */
    double since[VBSS_SESSION_MISTAKE_COUNT], begun[VBSS_SESSION_MISTAKE_COUNT];
    /* Turns of the thread about each hand's tool; +1: toward the tip, -1: toward the handle, 0:
     * neither. Last result of the detector. */
    double turns[SESSION_HANDS];
    int32_t direction[SESSION_HANDS];
    int32_t next_wraps; /* of the throw that is being tied, as the detector predicts them */
    /* As of the last step: 1 if the first hole exists; 1 if the thread is in it; bit per hand that holds
     * the thread; numbers of tied and seated throws. */
    uint32_t has_entry, entry_threaded, holding_thread, throw_count, seated_count;
    uint32_t from_behind; /* bit per throw: it was seated with the hands on each other's sides */
    /* Turns in the sense and direction that the next throw needs: the largest since the last throw or
     * grasp of the tail; when the tail was grasped, or SESSION_NOT_JUDGED once the throw is tied. */
    double max_turns, grasped_turns;
} session_coach;
/* Multiplier of the code of a goal, above the number of hands and none; chosen. */
enum { SESSION_GOAL_TOOLS = 4 };
/* Turns of a grasp that is not judged: more than any winding has. Chosen. */
#define SESSION_NOT_JUDGED 1e6
/* The largest number of turns, from a mistake that must be unwound until they are off: what comes off is not
 * lost. Chosen. */
#define SESSION_TO_BE_UNWOUND (-1.0)

/* ---- assistance */

/* What a hand asks of its tool. */
typedef struct session_input {
    pose pose;
    double opening; /* of the handle, 0 to 1 */
} session_input;

/* The state of the aids of one hand. */
typedef struct session_aided_hand {
    /* 1: the tool makes the movements of the hand from its last input on; 0: it goes where the hand is,
     * and nothing else here is used. */
    uint32_t is_relative;
    pose input; /* of the last step */
    pose free;  /* of the tool, without the snapped roll */
    /* SNAP_ROLL: roll added to the free pose; multiple of the step, rad */
    double roll, snapped;
    double climb; /* HOVER: filtered vertical speed, m/s */
    /* AUTO_HOLD: input from which rest is measured; time since then, s; opening while it holds */
    pose rest;
    double rest_time, opening;
    /* ARC: 1 while the needle is turned about this centre, m, and unit axis */
    uint32_t is_on_arc;
    vec3 arc_centre, arc_axis;
    /* FOLLOW: time for which the hand has rested, s; 1: the pose of the other tool in the last step is known; that pose. While it goes along:
     * length from the stitch over the other tool to the needle, m, 0: it does not; unit direction from that tool to the needle. */
    double still_time;
    uint32_t knows_other;
    pose other;
    double limb_length;
    vec3 arm;
} session_aided_hand;

typedef struct session_assistance {
    vbss_session_assistance set; /* by the host */
    uint32_t aids, used;         /* aids in the last step; those that were on since the beginning */
    session_aided_hand hands[SESSION_HANDS];
} session_assistance;

/* ---- exercises */

/* Measures of an exercise; capacity, chosen. */
enum { SESSION_MAX_MEASURES = 6 };

typedef struct session_exercise {
    uint32_t outcome; /* VBSS_SESSION_OUTCOME_ */
    uint32_t known;   /* bit per measure: its value is known */
    double values[SESSION_MAX_MEASURES];
    double rest_height;   /* of the needle's middle in the first step, along up, m */
    double reached_since; /* session time since which the goal is reached, s; negative: it is not */
    /* interval over which the smallest tension is taken: its begin, s, and that tension, N */
    double interval_begin, interval_tension;
} session_exercise;

/* Input that the host has passed for the next step; not saved. */
typedef struct session_given_input {
    bool is_given;
    session_input input;
} session_given_input;

typedef struct session_object {
    vbss_context *context;
    vbss_scene *scene;
    vbss_session_config config;

    bool takes_over; /* in the next step the handles have to take over the jaws; not saved */
    bool begins_at;  /* a state of any exercise may be read, and its exercise is not; not saved */
    /* State. Snapshots save all of it but h. */
    uint64_t steps, scene_steps; /* steps of the session; those of the scene after the last one */
    double time, h;              /* since the needle appeared, s; length of the last step, s */
    double end_time;             /* when the task ended, s; 0: it has not ended */
    double time_lost;            /* part of `time` that the scene has left out, s */
    double end_time_lost;        /* lost part of end_time, s */
    /* Statistics of the scene after the last step: time_paused, s, and clamped. */
    double scene_time_paused;
    uint64_t scene_clamped;
    uint32_t is_lossy;    /* 1: the share of lost time exceeds its limit, with hysteresis */
    uint32_t thread;      /* number of the thread; after cuts, of the piece with the stitch */
    double thread_length; /* at rest after the last step, m; 0: before the first step */
    vbss_session_phase phase;
    vbss_session_failure failure;
    session_hole holes[SESSION_SIDES];
    uint32_t newest_hole;                     /* largest id of a hole that has been classified */
    uint32_t stray_holes[SESSION_MAX_STRAYS]; /* ids; 0: the entry is free */
    session_debounced_value holding_tools;    /* bit per hand that holds the needle */
    uint32_t last_holder; /* hand that last held it alone; VBSS_METRICS_TOOL_NONE: none yet */
    /* tail_set: 1 if the length of the tail is within its limits. throw_stage: 8 * throw plus a
     * VBSS_SESSION_STAGE_ constant. newest_seated: 1 if the newest throw is seated. knot_faults:
     * VBSS_KNOT_FAULT_ bits but for the half hitch. half_hitch: 1 if the knot has that fault.
     * broken: 1 if the tension exceeds config.break_force. */
    session_debounced_value tail_set, throw_stage, newest_seated, knot_faults, half_hitch, broken;
    session_throw throws[SESSION_MAX_THROWS];
    uint32_t throw_count, seated_count; /* tied throws; seated throws among them */
    /* Bit per throw: the needle did not change hands before it. */
    uint32_t missed_transfers;
    /* Per throw: hand that held the needle when it was tied, or VBSS_METRICS_TOOL_NONE. */
    uint32_t tied_by[SESSION_MAX_THROWS];
    uint32_t transferred;          /* bit per throw: the needle has changed hands after it */
    uint32_t cut_limbs;            /* bit per limb: it is cut */
    session_knot_observation knot; /* last result of the detector */
    double tail_length, gap, tension[SESSION_SIDES]; /* as observed in the last step; m, m, N */
    uint32_t metrics_lost;                           /* events that the metrics refused */

    uint64_t event_count, events_before_step; /* events so far; events before the last step */
    vbss_session_event *events;               /* ring of config.event_capacity events */
    /* Events among event_count that are the coach's; logs do not count them. */
    uint64_t coach_event_count;
    session_coach coach; /* used only with config.coaching */
    session_assistance assistance;
    session_exercise exercise; /* used only with config.exercise */
    session_given_input given[SESSION_HANDS];

    /* Rebuilt in each step; before it by the aid WIND. */
    session_observation observation;
} session_object;

/* Body number of a tool; 0: the session has no such tool. */
static inline uint32_t session_tool_number(const session_object *s, uint32_t tool)
{
    return tool < SESSION_HANDS ? s->config.tools[tool] : s->config.shears;
}

/* ---- session.c */

extern const vbss_kind vbss_session_kind;
/* Allocates a session with a copy of a configuration that was checked. VBSS_ERROR_OUT_OF_MEMORY. */
vbss_result vbss_session_allocate(vbss_context *context, const vbss_session_config *config,
                                  session_object **session);
/* Frees a session. This is the callback of its kind. */
void vbss_session_free(vbss_context *context, void *object);
/* Opens a handle for reading. VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_session_open(const vbss_session *handle, session_object **session);
/* Opens a handle for a change. VBSS_ERROR_INVALID_HANDLE, or VBSS_ERROR_BUSY inside a callback of
 * the context. */
vbss_result vbss_session_edit(vbss_session *handle, session_object **session);

/* ---- config.c */

/* Copies the configuration of a host into `own` and checks its numbers, but not its bodies and
 * components. VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 * VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_session_read_config(vbss_context *context, const vbss_session_config *config,
                                     vbss_session_config *own);

/* ---- assist.c */

/* The assistance of a new session. */
vbss_session_assistance vbss_session_default_assistance(void);
/* Copies the assistance of a host into `own` and checks it. Errors are those of
 * vbss_session_set_assistance. */
vbss_result vbss_session_read_assistance(vbss_context *context,
                                         const vbss_session_assistance *assistance,
                                         vbss_session_assistance *own);
/* Copies the settings of the aids to the struct of a host. VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE. */
vbss_result vbss_session_write_assistance(const session_object *s, vbss_session_assistance *out,
                                          uint32_t struct_size);
/* Stores the input of a host for the next step. Errors are those of vbss_session_move_hand. */
vbss_result vbss_session_give_input(session_object *s, uint32_t hand,
                                    const vbss_session_hand *given);
/* Whether the input of a hand has to be changed before it moves the tool. */
bool vbss_session_is_hand_assisted(const session_object *s, uint32_t hand);
/* Length of a step for which the host asks for h, s. */
double vbss_session_scaled_step(const session_object *s, double h);
/* After the step of the scene: emits events of aids that were switched. */
void vbss_session_update_aids(session_object *s);
/* Whether the state of the assistance differs from that of a new session; whether its part that a replay
 * has, too, does: the aids of the steps so far. */
bool vbss_session_has_assistance(const session_object *s);
bool vbss_session_was_assisted(const session_object *s);
/* Visits the state of the assistance; in a hash only the part that a replay has. */
void vbss_session_visit_assistance(vbss_stream *stream, session_object *s);

/* ---- assist_input.c */

/* Changes the input of a hand as the aids demand. `h` is the time since the input before, s. */
void vbss_session_assist(session_object *s, uint32_t hand, double h, session_input *input);

/* ---- assist_follow.c */

/* FOLLOW, for the hand `number`: its tool follows the other one if its own hand `rests`. `h` is the time since the input before, s;
 * `slit` the middle of the slit; `up` the direction out of the tissue. */
void vbss_session_follow(session_object *s, uint32_t number, double h, bool rests, vec3 slit,
                         vec3 up);

/* ---- assist_wind.c */

/* From the tip of a hand's tool to the end of the needle that the thread is on, in the tool's frame, m; zero without the needle. */
vec3 vbss_session_thread_end(const session_object *s, uint32_t hand);

/* Length of the thread from the needle to the tissue or the knot, m; negative: it is in no stitch. */
double vbss_session_limb_length(const session_object *s, const session_observation *observed);
/* Radius of the circle on which the thread is nearly taut, m; without a stitch, `radius`; within the limits of WIND. A hand that
 * winds on from one turn keeps to `radius` at most. */
double vbss_session_wind_radius(const session_object *s, const session_observation *observed,
                                uint32_t loop, vec3 centre, double radius, bool winds);
/* Moves the hand `number`, which holds the needle, round the other tool by an arc of that length, m. */
void vbss_session_wind(session_object *s, session_aided_hand *hand, uint32_t number, double length);

/* ---- device_io.c
 *
 * Both functions do nothing during a replay, and skip a hand that has no device or no tool. `now`
 * is the clock of the host, s. They return the first error of a device, a tool or the record. */

/* Reads the devices and the input that the host has passed, and sets the targets, openings and kinds of
 * the tools. `h` is the time since the last input of the hands, s. */
vbss_result vbss_session_read_hands(session_object *s, double now, double h);
/* Writes the forces on the hands to the devices. */
vbss_result vbss_session_write_devices(const session_object *s, double now);

/* ---- step.c */

/* Makes one step without a call of the host's listener. `now` is the clock of the host, s; `h` is
 * the length of the step, s, which a replay replaces. Errors are those of vbss_session_step. */
vbss_result vbss_session_advance(const vbss_slot *slot, session_object *s, double now, double h);

/* ---- clock.c */

/* Starts from the present statistics of the scene. VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_session_start_clock(session_object *s);
/* Counts the step that the scene has made. VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_session_count_step(session_object *s);
/* Emits an event if the share of lost time has crossed its limit. */
void vbss_session_update_lost_time(session_object *s);

/* ---- seek.c */

/* Brings the scene and the session to a step of the replayed log. Errors are those of
 * vbss_session_seek. */
vbss_result vbss_session_seek_step(const vbss_slot *slot, session_object *s, uint64_t step);

/* ---- log_sync.c */

/* Checks that a record belongs to the session's scene; NULL is allowed. VBSS_ERROR_INVALID_HANDLE,
 * VBSS_ERROR_BUSY, or VBSS_ERROR_INCOMPATIBLE for another scene. */
vbss_result vbss_session_check_record(const session_object *s, vbss_record *record);
/* Steps the scene: from the replay, through the record, or directly. In a replay,
 * VBSS_ERROR_WRONG_STATE at the end of the log, and VBSS_ERROR_CORRUPT if the scene differs from
 * the recorded one. */
vbss_result vbss_session_step_scene(session_object *s, double h);
/* Attaches the session's record, if it has one, to the scene. */
vbss_result vbss_session_attach_record(const session_object *s);
/* After a step: writes the session hash and a snapshot to the record if they are due. In a replay,
 * compares the hash; VBSS_ERROR_CORRUPT if it differs. */
vbss_result vbss_session_sync_log(const vbss_slot *slot, session_object *s);
/* The aids that were on in the step that was replayed last, as the log says. */
uint32_t vbss_session_logged_aids(const session_object *s);
/* Writes a snapshot of the session if the record needs one and has room; NULL: does nothing. */
vbss_result vbss_session_record_snapshot(const vbss_slot *slot, vbss_record *record);

/* ---- observe.c and detector_feed.c */

/* Fills the observation from the scene. The knot is the last result of the detector. */
void vbss_session_observe(const session_object *s, session_observation *observed);
/* Steps the detector if it is due, and stores its result in the observation and in the session.
 * Returns the error of the detector. */
vbss_result vbss_session_observe_knot(session_object *s, session_observation *observed);

/* ---- cut.c */

/* Value of session_observation.free_length, for the thread of the stitch, of which one limb was cut. */
double vbss_session_find_free_length(const session_object *s, uint32_t entry_count, uint32_t number,
                                     uint32_t limb);

/* ---- phase.c */

/* Derives facts and phase from the observation and emits their events. Does nothing once the task
 * is over. */
void vbss_session_update_progress(session_object *s, const session_observation *observed);

/* ---- task_state.c */

/* Debounces an observation at the time `now`, s. The value changes once the candidate has differed
 * from it for `dwell`, s. Returns true if the value has changed. */
bool vbss_session_debounce(session_debounced_value *debounced, uint32_t candidate, double now,
                           double dwell);
/* Whether the task is done or has failed, or the exercise has its outcome. */
bool vbss_session_is_over(const session_object *s);
/* The observed hole with this id; NULL: there is none, or the id is 0. */
const session_hole_observation *vbss_session_find_hole(const session_observation *observed,
                                                       uint32_t id);
/* Whether a throw is tied or begun. */
bool vbss_session_is_tying(const session_object *s);
/* Whether the thread goes through the entry and the exit. */
bool vbss_session_is_threaded(const session_object *s);

/* ---- throws.c */

/* Updates throws, seats, transfers, stage and faults of the knot. */
void vbss_session_update_throws(session_object *s, const session_observation *observed);
/* The debounced faults of the knot, VBSS_KNOT_FAULT_ bits. */
uint32_t vbss_session_faults(const session_object *s);

/* ---- outcome.c */

/* Detects a cut of the thread. A cut of the last limb completes the task; a wrong cut fails it. */
void vbss_session_update_cuts(session_object *s, const session_observation *observed);
/* Stores tension and gap, and detects the other failures. */
void vbss_session_update_failures(session_object *s, const session_observation *observed);
/* Fails the task and emits the event. Only the first failure counts. */
void vbss_session_fail(session_object *s, vbss_session_failure failure);

/* ---- events.c */

/* Adds an event of this step to the ring and returns it, so that the caller can fill in more
 * fields. If `tool` is a hand, position and force are those of its tool; otherwise zero. */
vbss_session_event *vbss_session_emit_event(session_object *s, vbss_session_event_kind kind,
                                            uint32_t number, uint32_t undone, uint32_t tool);
/* The event with an ordinal. It must still be in the ring. */
vbss_session_event *vbss_session_event_at(const session_object *s, uint64_t index);
/* Calls the host's listener with each event of the last step. */
void vbss_session_dispatch_events(session_object *s);

/* ---- coach_task.c */

/* The hand that has the long limb: it holds the needle, did so last, or is the right one. */
uint32_t vbss_session_limb_hand(const session_object *s);
/* The slit has opened under the newest throw, and the next one is to close it; the newest throw is tied and has to be pulled. */
bool vbss_session_builds_on(const session_object *s);
bool vbss_session_has_to_seat(const session_object *s);
/* Each hand is on the other one's side; the newest throw is pulled so. `loop` has the tail. */
bool vbss_session_are_crossed(const session_object *s, const session_observation *observed,
                              uint32_t loop);
bool vbss_session_pulls_from_behind(const session_object *s, const session_observation *observed,
                                    uint32_t loop);
/* Number of the throw that is tied or seated next; its wraps; the sign of its turns about the tool of the
 * other hand that a square knot needs. */
uint32_t vbss_session_next_throw(const session_object *s);
uint32_t vbss_session_wanted_wraps(const session_object *s);
double vbss_session_wanted_sign(const session_object *s);
/* Hand that has to take the needle after the newest throw. */
uint32_t vbss_session_taking_hand(const session_object *s);
/* The needle has to change hands before the next throw. The thread may still be wound about a tool then, which
 * is a phase of the next throw. */
bool vbss_session_has_to_transfer(const session_object *s);
/* Reads the winding about the tools of the hands from the detector, if the session coaches. Returns
 * the error of the detector. */
vbss_result vbss_session_read_winding(session_object *s);

/* ---- coach_geometry.c */

/* Distance from the needle's tip to a mark of the drain, m; arc length from the tip of the needle's point nearest
 * to a position, m. Both bodies must be in the scene. */
double vbss_session_mark_distance(const session_object *s, uint32_t mark);
double vbss_session_needle_arc(const session_object *s, vec3 position);
/* Mark at which a hand pierces first, and second. */
uint32_t vbss_session_mark_of(const session_object *s, uint32_t hand, uint32_t side);
/* Fills number, geometry and distances of a goal. All bodies must be in the scene. */
void vbss_session_describe_goal(const session_object *s, const session_observation *observed,
                                session_goal goal, vbss_session_coaching *coaching);

/* Point of the needle at an arc length from its tip, m. The needle must be in the scene. */
vec3 vbss_session_needle_point(const session_object *s, double arc_length);
/* Position of the stitch's thread at an arc length from its first node, m. */
vec3 vbss_session_thread_position(const session_object *s, const session_observation *observed,
                                  double arc);
/* Length of the needle, m. */
double vbss_session_needle_length(const session_object *s);

/* ---- coach_goal.c */

/* The goal that the facts of the last step ask for. */
session_goal vbss_session_find_goal(const session_object *s, const session_observation *observed);
/* The goal that was derived last. */
session_goal vbss_session_current_goal(const session_object *s);

/* ---- coach_mistakes.c */

/* Updates the mistakes from the facts of the last step and emits their events. */
void vbss_session_update_mistakes(session_object *s, const session_observation *observed);
/* The mistake to show, or VBSS_SESSION_MISTAKE_NONE; whether one can be mended. */
vbss_session_mistake vbss_session_shown_mistake(const session_object *s);
bool vbss_session_is_mendable(const session_object *s, vbss_session_mistake mistake);

/* ---- coach_words.c */

/* Of a throw that is pulled from behind, by the hand that has the tail; of a slit that the next throw is to close. */
const char *vbss_session_crossing_sentence(uint32_t loop, bool are_crossed);
const char *vbss_session_building_remedy(void);
/* A constant string, never NULL. WIND: `wraps`, 1 or 2; `is_over`: over the top of the other tool first. */
const char *vbss_session_goal_sentence(session_goal goal, uint32_t number, uint32_t wraps,
                                       bool is_over);

/* ---- coach.c */

/* Updates goal and mistakes after a step, if the session coaches. */
void vbss_session_update_coach(session_object *s, const session_observation *observed);
/* Fills what hosts see of the coach, from the present state of the scene. */
void vbss_session_fill_coaching(const session_object *s, vbss_session_coaching *coaching);
/* Visits the state of the coach. */
void vbss_session_visit_coach(vbss_stream *stream, session_object *s);

/* ---- exercise.c */

/* Before the first step. */
void vbss_session_reset_exercise(session_object *s);
/* Measures the exercise after a step, if the session has one, and emits its outcome. */
void vbss_session_update_exercise(session_object *s, const session_observation *observed);
/* Copies exercise and measure to the struct of a host. VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE;
 * VBSS_ERROR_NOT_FOUND if there is no such measure. */
vbss_result vbss_session_write_exercise(const session_object *s, vbss_session_exercise_state *out,
                                        uint32_t struct_size);
vbss_result vbss_session_write_measure(const session_object *s, uint32_t index,
                                       vbss_session_measure *out, uint32_t struct_size);
/* Visits the state of the exercise. */
void vbss_session_visit_exercise(vbss_stream *stream, session_exercise *exercise);

/* ---- metrics_feed.c */

/* Adds the step as a sample and its events to the metrics, and finishes them at the end of the
 * task. Returns the error of the metrics. Events that they refuse because of their number or range
 * are only counted. */
vbss_result vbss_session_feed_metrics(session_object *s, const session_observation *observed);

/* ---- snapshot.c */

/* Visits the whole state. This is the callback of the session's kind. */
void vbss_session_serialise(vbss_stream *stream, void *object);
/* Hashes the state of the task without events, detector and metrics. */
uint64_t vbss_session_task_hash(session_object *s);

#endif
