/**
 * @file session.h
 * @brief The suturing task over a scene: one stitch through two marks, a knot of three throws, both tails cut.
 *
 * A session knows which bodies of a scene are the thread, the needle, the drain and the tools. It
 * steps the scene and derives facts from the result: the needle is held, it has passed the first
 * mark, throw 2 is seated, and so on. In every step the *phase* of the task follows from these
 * facts alone. An *event* reports each fact that begins or ceases. A fact that the geometry undoes
 * is undone. Facts that rest on a measured number are debounced: they change only after a dwell
 * time (`dwell`, `throw_dwell`) and with hysteresis. docs/reference/session.md has the table of phases, facts
 * and failures.
 *
 * The clock of a session runs with the hands: it adds up the lengths of the steps since the
 * needle's appearance. All times, limits and dwells, the metrics and the score use it. A scene that
 * exceeds its work limits leaves out part of that time. The status reports the lost and the
 * simulated time; above `lost_share` there is an event.
 *
 * Devices, a knot detector, metrics and a record or replay belong to the host. Each is optional,
 * and costs nothing when it is absent. A step runs in this order:
 *
 *     devices, aids -> scene step -> knots -> metrics -> forces out -> record
 *
 * Everything in a session except its devices follows from the state and the inputs of the scene. A
 * replayed log of the scene, used in place of devices, therefore produces the same events.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SESSION_H
#define VBLAST_SS_SESSION_H

#include <vblast_ss/base.h>
#include <vblast_ss/device.h>
#include <vblast_ss/knot.h>
#include <vblast_ss/metrics.h>
#include <vblast_ss/record.h>
#include <vblast_ss/scene.h>
#include <vblast_ss/scene_event.h>

/** A run of the suturing task on a scene. */
typedef struct vbss_session vbss_session;

/** Phase of the task: a VBSS_SESSION_PHASE_ constant. The metrics' phases have the same numbers. */
typedef int32_t vbss_session_phase;

/** The constants of #vbss_session_phase, in the order of the task. */
enum {
    VBSS_SESSION_PHASE_IDLE = 0,     /**< No step was made; the needle has not appeared. */
    VBSS_SESSION_PHASE_LOADING = 1,  /**< A tool must take the needle. */
    VBSS_SESSION_PHASE_APPROACH = 2, /**< A tool holds the needle and approaches the first mark. */
    /** The needle's tip is in the drain, on its way to the second mark. */
    VBSS_SESSION_PHASE_IN_DRAIN = 3,
    /** The tip is out again; the thread is drawn until the tail has its length. */
    VBSS_SESSION_PHASE_PULL_THROUGH = 4,
    VBSS_SESSION_PHASE_THROW_1 = 5,    /**< The first throw must be tied and seated. */
    VBSS_SESSION_PHASE_TRANSFER_1 = 6, /**< The needle must change hands after the first throw. */
    VBSS_SESSION_PHASE_THROW_2 = 7,    /**< The second throw must be tied and seated. */
    VBSS_SESSION_PHASE_TRANSFER_2 = 8, /**< The needle must change hands after the second throw. */
    VBSS_SESSION_PHASE_THROW_3 = 9,    /**< The third throw must be tied and seated. */
    VBSS_SESSION_PHASE_CUT = 10,       /**< Both tails must be cut. */
    VBSS_SESSION_PHASE_DONE = 11,      /**< Both tails are cut; final. */
    VBSS_SESSION_PHASE_FAILED = 12 /**< The task has failed; final. See #vbss_session_failure. */
};

/** Stage of a throw: a VBSS_SESSION_STAGE_ constant. */
typedef int32_t vbss_session_stage;

/** The constants of #vbss_session_stage. */
enum {
    VBSS_SESSION_STAGE_NONE = 0, /**< The throw has not begun. */
    VBSS_SESSION_STAGE_WRAP = 1, /**< The thread winds round a tool. */
    /** The thread winds round a tool that holds the tail near its end. */
    VBSS_SESSION_STAGE_GRASPED = 2,
    VBSS_SESSION_STAGE_PASSED = 3,  /**< The throw is tied if the tools withdraw. */
    VBSS_SESSION_STAGE_SEATING = 4, /**< The throw is tied and must be pulled down. */
    VBSS_SESSION_STAGE_SEATED = 5   /**< The throw lies on the tissue. */
};

/** Reason why the task has failed: a VBSS_SESSION_FAILURE_ constant. */
typedef int32_t vbss_session_failure;

/** The constants of #vbss_session_failure. */
enum {
    VBSS_SESSION_FAILURE_NONE = 0,    /**< The task has not failed. */
    VBSS_SESSION_FAILURE_TIMEOUT = 1, /**< The time limit has passed. */
    VBSS_SESSION_FAILURE_AVULSED = 2, /**< The drain was torn off its anchors. */
    /** The thread was cut before the third throw was seated. */
    VBSS_SESSION_FAILURE_CUT_EARLY = 3,
    /** The thread was cut inside the knot, or between the two holes. */
    VBSS_SESSION_FAILURE_CUT_KNOT = 4,
    VBSS_SESSION_FAILURE_BROKEN = 5, /**< The thread broke: its tension exceeded `break_force`. */
    VBSS_SESSION_FAILURE_LOST =
        6 /**< Thread, needle, drain or a tool was removed from the scene. */
};

/** Kind of an event: a VBSS_SESSION_EVENT_ constant. */
typedef int32_t vbss_session_event_kind;

/** The constants of #vbss_session_event_kind. A comment that says "Undone" describes the event with
 * `undone` 1, which reports that the fact has ceased. */
enum {
    VBSS_SESSION_EVENT_APPEARED = 1, /**< The needle has appeared, and the clock starts. */
    /** The phase `number` begins. Undone: the task has fallen back to this phase. */
    VBSS_SESSION_EVENT_PHASE = 2,
    /** `tool` holds the needle. Undone: it has released the needle. */
    VBSS_SESSION_EVENT_TAKEN = 3,
    /** Before the stitch: no tool holds the needle, and it is in no wall. */
    VBSS_SESSION_EVENT_DROPPED = 4,
    /** Mark `number` (0: in, 1: out) was pierced, `amount` mm off; `position` is that of the hole.
     * Undone: the needle has left the hole, or the thread's end has slipped through it. */
    VBSS_SESSION_EVENT_PUNCTURE = 5,
    /** A wall was pierced elsewhere, as hole `number`. Undone: the hole is empty again. */
    VBSS_SESSION_EVENT_STRAY = 6,
    /** The swage has passed through hole `number` (0, 1), and the thread follows. Undone: it has
     * come back. */
    VBSS_SESSION_EVENT_THREADED = 7,
    /** The tail has a permitted length, `amount` m. Undone: it no longer has. */
    VBSS_SESSION_EVENT_TAIL = 8,
    /** Throw `number` (0, 1, ...) has reached `stage`, forwards or backwards. */
    VBSS_SESSION_EVENT_STAGE = 9,
    /** Throw `number` is tied, with `wraps`, `handedness` and `relation`; a repeated event corrects
     * them. Undone: the throw came undone. */
    VBSS_SESSION_EVENT_THROW = 10,
    /** Throw `number` is seated; the slit gapes `amount` m. Undone: it is no longer seated. */
    VBSS_SESSION_EVENT_SEATED = 11,
    /** `tool` has taken over the needle after throw `number`. */
    VBSS_SESSION_EVENT_TRANSFER = 12,
    /** Throw `number` is tied, but the needle has not changed hands since the throw before. Undone:
     * the throw came undone. */
    VBSS_SESSION_EVENT_TRANSFER_MISSED = 13,
    /** The knot has had the fault `number`, a VBSS_KNOT_FAULT_ bit, for `throw_dwell`. HITCH (a
     * throw has capsized) takes 20 times `throw_dwell`, because its measure oscillates while a
     * throw is drawn tight. Undone: the fault has been absent for the same time. */
    VBSS_SESSION_EVENT_FAULT = 14,
    /** Tail `number` (0: the short one, 1: the needle's) was cut; its remaining length is `amount`
     * m. */
    VBSS_SESSION_EVENT_CUT = 15,
    VBSS_SESSION_EVENT_DONE = 16, /**< The task is complete. */
    /** The task has failed; `number` is a #vbss_session_failure. */
    VBSS_SESSION_EVENT_FAILED = 17,
    /** More than `lost_share` of the time since the needle's appearance is lost: `amount` s. Times
     * and score do not compare with those of other trials. Undone: the share has fallen below half
     * of `lost_share`. */
    VBSS_SESSION_EVENT_TIME_LOST = 18,
    /** Only with `coaching`: the goal of the hand `tool` is now `number`, a VBSS_SESSION_GOAL_
     * constant (session_coaching.h). */
    VBSS_SESSION_EVENT_GOAL = 19,
    /** Only with `coaching`: the mistake `number`, a VBSS_SESSION_MISTAKE_ constant, is made. Undone:
     * it is mended or past. */
    VBSS_SESSION_EVENT_MISTAKE = 20,
    /** The aid `number`, a VBSS_SESSION_AID_ bit, was switched on: the task is
     * assisted and gets no score. `amount` is 1 for the first time, then 0. Undone: the aid was switched
     * off. */
    VBSS_SESSION_EVENT_AID = 21,
    /** Only with `exercise`: the exercise `number` has ended; `amount` is 1 if it is passed, and 0 if it is
     * not (session_exercise.h). */
    VBSS_SESSION_EVENT_EXERCISE = 22
};

/** Exercise of a session: a VBSS_SESSION_EXERCISE_ constant. */
typedef int32_t vbss_session_exercise;

/** The constants of #vbss_session_exercise. session_exercise.h has their starts, goals and measures. */
enum {
    VBSS_SESSION_EXERCISE_NONE = 0,         /**< No exercise: the whole task. */
    VBSS_SESSION_EXERCISE_TAKE_NEEDLE = 1,  /**< The needle is taken up. */
    VBSS_SESSION_EXERCISE_PASS_MARK = 2,    /**< The needle is pushed through the wall at a mark. */
    VBSS_SESSION_EXERCISE_SINGLE_THROW = 3, /**< A throw of one wrap is tied and seated. */
    VBSS_SESSION_EXERCISE_DOUBLE_THROW = 4, /**< A throw of two wraps is tied and seated. */
    /** A throw that is square to the first one is tied and seated. */
    VBSS_SESSION_EXERCISE_SQUARE_THROW = 5,
    VBSS_SESSION_EXERCISE_CUT = 6,  /**< Both tails are cut. */
    VBSS_SESSION_EXERCISE_COUNT = 7 /**< One more than the largest exercise. */
};

/** Bits of the aids (session_assistance.h). "Along the direction" means: by the component of the hand's movement along
 * #vbss_session_assistance.direction. */
enum {
    /** A hand that holds the needle turns it about the centre of its arc and moves it in no other way.
     * Movement along the direction drives the tip forward by the same length of arc. Turns of the hand
     * are ignored. Acts before the first throw. */
    VBSS_SESSION_AID_ARC = 1,
    /** A hand that holds the needle takes the needle's end with the thread round the jaws of the other
     * tool. Movement along the direction winds in the sense that the next throw needs. The radius,
     * between 8 mm and 45 mm, is 0.92 of the one at which the thread is taut, or stays if there is no
     * stitch. With a coach it allows for the turns on the jaws. Turns of the hand turn the tool
     * as without the aid. Acts in the phases of throws. */
    VBSS_SESSION_AID_WIND = 2,
    /** The roll of each tool about its shaft is the nearest multiple of `roll_step` from the roll in
     * which the jaws open along the slit. */
    VBSS_SESSION_AID_SNAP_ROLL = 4,
    /** Each step of the session is `time_scale` times as long as the host asks for. */
    VBSS_SESSION_AID_SLOW_MOTION = 8,
    /** A hand that sinks slower than `sink_speed` leaves its tool at the same height, for arms
     * without support. */
    VBSS_SESSION_AID_HOVER = 16,
    /** The tool and the jaws of a hand that has moved less than `hold_distance` for `hold_time` stay where
     * they are, until the hand leaves this distance. */
    VBSS_SESSION_AID_AUTO_HOLD = 32,
    /** The tool of a hand that has rested for 0.1 s follows the tool of the other hand while that one moves, for
     * inputs that move one hand at a time. It needs a coach and acts by the coach's goal, while the thread is held
     * at both ends. TAKE_TAIL, and DRAW_TAIL after the first throw, with turns on the jaws: the needle goes along
     * with them and above them, so that the thread stays as long from the slit over the jaws to the needle; it comes nearer while its end of the thread bears more than 0.05 N. SEAT, RELEASE_TAIL: the tool moves
     * opposite to the other one at its own height. It moves up to twice as far, or gives way, so that both ends bear
     * as much. The tool stays within 0.15 m of the slit. It is not turned, and its jaws do not move. */
    VBSS_SESSION_AID_FOLLOW = 64,
    VBSS_SESSION_AID_ALL = 127 /**< All aids. */
};

/** An event of a session. */
typedef struct vbss_session_event {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_session_event_kind kind; /**< Kind of the event. */
    vbss_metrics_tool tool;   /**< Tool of the event; VBSS_METRICS_TOOL_NONE: none, or not known. */
    uint32_t number;          /**< Meaning depends on the kind. */
    uint32_t undone;          /**< 1: the fact has ceased. */
    vbss_session_stage stage; /**< STAGE: the stage that the throw has reached. */
    int32_t wraps;            /**< THROW: number of wraps, 1 single, 2 double, ... */
    int32_t handedness;       /**< THROW: +1 right-handed, -1 left-handed. */
    vbss_metrics_relation relation; /**< THROW: relation to the throw before. */
    vbss_session_phase phase;       /**< The phase after the step of the event. */
    uint64_t ordinal;               /**< Ordinal number of the event, from 0 on. */
    uint64_t step;                  /**< Step of the session, from 1 on. */
    double time;        /**< Time since the needle's appearance, s, on the clock of the hands. */
    double position[3]; /**< Position of the tool's tip, or as the kind says, m. */
    double force[3];    /**< Force on the tool's hand, N; zero without a tool. */
    double amount;      /**< Meaning depends on the kind. */
} vbss_session_event;

/**
 * A function of the host that receives each event, at the end of its step. It may read all objects
 * of the context and must not change any.
 *
 * @param user   the config's `user`
 * @param event  the event; valid during the call
 */
typedef void (*vbss_session_event_fn)(void *user, const vbss_session_event *event);

/** Measure of the slit's gap: a VBSS_SESSION_GAP_ constant. */
typedef int32_t vbss_session_gap;

/** The constants of #vbss_session_gap. */
enum {
    /** Gap between the lips, which are as high as the wall: #vbss_drain_gap.opening. A wall that
     * rises counts as closed when it meets the face of the other wall. A drain of
     * VBSS_METHOD_VBLAST uses EDGES instead. */
    VBSS_SESSION_GAP_LIPS = 0,
    /** Gap between the edges in the middle of the wall: #vbss_drain_gap.gap, the paper's measure. */
    VBSS_SESSION_GAP_EDGES = 1
};

/** Configuration of a session. Fill it with #vbss_session_config_init, then set the numbers of the
 * bodies. */
typedef struct vbss_session_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Number of the thread in the scene. Its node 0 is at the swage; its last node is the end of
     * the tail. */
    uint32_t thread;
    uint32_t needle;   /**< Number of the needle in the scene. */
    uint32_t drain;    /**< Number of the drain in the scene. */
    uint32_t tools[2]; /**< Numbers of the left and the right grasper in the scene. */
    /** Number of a third grasper, which cuts; default 0: a tool is exchanged for shears. */
    uint32_t shears;
    /** Largest number of events that are kept, the newest ones; 8 to 65536; default 1024. */
    uint32_t event_capacity;
    /** Number of steps between inputs of the knot detector, 1 to 1000; default 4. The detector's
     * own step_budget bounds the work of an input. */
    uint32_t knot_interval;
    /** Number of steps between hashes of the task in the log, for replays to compare; 1 to 1e9;
     * default 100. Steps with events are hashed too. Used only with a record. */
    uint32_t hash_interval;
    /** Devices of the left and the right hand; NULL (default): the host moves that tool. */
    vbss_device *devices[2];
    /** Knot detector, with capacity for the thread and all tools; NULL (default): throws are not
     * detected. */
    vbss_knot_detector *knots;
    vbss_metrics *metrics; /**< Metrics; NULL (default): nothing is measured. */
    /** Record of the scene; NULL (default): nothing is logged. Each step of the session attaches it
     * (#vbss_scene_set_recorder). To log edits before the first step, the host attaches it. */
    vbss_record *record;
    /** Replay that has begun with the scene, in place of devices and record; NULL (default):
     * none. */
    vbss_replay *replay;
    vbss_session_event_fn listen; /**< Function that receives the events; NULL (default): none. */
    void *user;                   /**< Pointer that `listen` receives; may be NULL. */
    /** Time limit from the needle's appearance on, s, 1e-3 to 1e6; default 600. */
    double time_limit;
    /** Time for which a fact must differ before it changes, s, 0 to 10; default 0.05. */
    double dwell;
    /** Dwell time of throws and of faults of the knot, s, 0 to 10; default 0.1. A half hitch takes
     * 20 times as long. */
    double throw_dwell;
    double tail_low;  /**< Shortest permitted tail, m, 0 to 1; default 15e-3. */
    double tail_high; /**< Longest permitted tail, m, tail_low to 1; default 20e-3. */
    /** Hysteresis of both limits: a tail that is set stays set up to this far beyond them, m, 0 to
     * 1; default 1e-3. */
    double tail_margin;
    /** Largest distance from the end at which a tail counts as grasped, m, 0 to 1; default 0.01. */
    double tail_reach;
    /** Largest gap of the slit at which a throw becomes seated, m, 0 to 1; default 0.5e-3. Edges
     * that have crossed do not gape. */
    double seat_gap;
    /** Gap at which a throw is no longer seated, m, seat_gap to 1; default 1e-3. */
    double seat_release;
    double seat_force; /**< Tension of both limbs that seats a throw, N, 0 to 1e3; default 0.5. */
    /** Share of torn anchors at which the drain counts as torn off, 0 to 1; default 0.5. */
    double avulsed_share;
    /** Tension at which the thread breaks, N, 0 to 1e6; default 0: it never breaks. */
    double break_force;
    /** Measure of the gap that seats throws and that status, events and metrics report; default
     * LIPS. */
    vbss_session_gap gap_measure;
    /** 1: the session coaches (session_coaching.h); default 0. The hashes in logs do not depend on it, but
     * the state of a session that coaches can be restored only to one that coaches, too. */
    uint32_t coaching;
    /** Share of lost time above which TIME_LOST is an event and `is_lossy` is set, 0 to 1; default
     * 0.02. A trial shorter than 1 s counts as 1 s. */
    double lost_share;
    /** Exercise that the session trains in place of the whole task (session_exercise.h); default
     * NONE. The state of an exercise can be restored only to a session with the same one. */
    vbss_session_exercise exercise;
    uint32_t reserved; /**< Zero. */
} vbss_session_config;

/** Status of a session. */
typedef struct vbss_session_status {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_session_phase phase;     /**< Phase of the task. */
    vbss_session_stage stage;     /**< Stage of the throw in progress; NONE if there is none. */
    vbss_session_failure failure; /**< Reason of the failure; NONE if the task has not failed. */
    /** The tool that holds the needle, the first of two; VBSS_METRICS_TOOL_NONE: none. */
    vbss_metrics_tool holder;
    uint32_t punctured; /**< Bits: 1 the hole in exists, 2 the hole out exists. */
    uint32_t threaded;  /**< Bits: 1 the thread goes through the hole in, 2 through the hole out. */
    uint32_t tail_set;  /**< 1: the tail has a permitted length. */
    uint32_t throws;    /**< Number of tied throws. */
    uint32_t seated;    /**< Number of seated throws, counted from the tissue. */
    uint32_t transfers; /**< Number of needle transfers between throws, at most two. */
    uint32_t cut;       /**< Bits: 1 the short tail is cut, 2 the needle's tail is cut. */
    uint32_t faults; /**< Faults of the knot, VBSS_KNOT_FAULT_ bits, as last reported by events. */
    uint32_t metrics_lost; /**< Number of events that did not fit into the metrics. */
    uint64_t steps;        /**< Number of steps. */
    /** Ordinal of the oldest event that is kept; this is also the number of lost events. */
    uint64_t first_event;
    uint64_t event_count; /**< Number of events. */
    /** Time since the needle's appearance until the end or now, s, on the clock of the hands. It
     * includes `time_lost`. */
    double time;
    double tail;            /**< Length of the short tail from the hole on, m; 0 without a tail. */
    double gap;             /**< Gap of the slit's middle by `gap_measure`, m. */
    double tension[2];      /**< Largest tension of the short limb and of the needle's limb, N. */
    double deviation_mm[2]; /**< Deviation of each hole from its mark, mm. */
    /** Part of `time` that the scene has left out, s. It counts paused steps
     * (vbss_scene_statistics::time_paused) and truncated substeps (#VBSS_SCENE_EVENT_TRUNCATED), from
     * the second step on. */
    double time_lost;
    /** Time that was simulated, s: `time` minus `time_lost`. Up to two steps of it may still be
     * deferred (vbss_scene_statistics::behind). */
    double time_simulated;
    uint32_t is_lossy; /**< 1: more than `lost_share` of the time is lost, with hysteresis. */
    uint32_t reserved; /**< Zero. */
    uint32_t aids;     /**< VBSS_SESSION_AID_ bits of the aids in the last step. */
    uint32_t
        aids_used; /**< Bits of all aids that were on during the task; 0: it is not assisted. */
} vbss_session_status;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration with the defaults; the host sets the numbers of the bodies.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_config_init(vbss_session_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_session_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_session_config vbss_session_config_default(void)
{
    vbss_session_config vbss_filled;
    (void)vbss_session_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a session over a scene. The host keeps scene, devices, detector, metrics, record and
 * replay; they must live as long as the session is stepped. The call allocates all memory that
 * steps need.
 *
 * @param scene         the scene
 * @param config        the configuration; not NULL, because a session needs bodies
 * @param[out] session  the new session; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of a device, detector, metrics, record or
 *         replay, or one of another context), VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FOUND (no such body),
 *         VBSS_ERROR_INCOMPATIBLE (a body of another kind, a record or replay of another scene, or
 *         both a record and a replay), VBSS_ERROR_IN_USE (a tool is given twice),
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (the detector's capacity is too small for the
 *         thread or the tools), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_create(vbss_scene *scene, const vbss_session_config *config,
                                         vbss_session **session);

/**
 * Destroys a session; the host keeps its scene and all other objects.
 *
 * @param session  the session; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_destroy(vbss_session *session);

/**
 * Makes one step of the task. The call allocates nothing. When devices cannot be read or the scene
 * refuses the step, the task is unchanged, but tools may have new targets. Failures after the
 * scene's step (an object was destroyed or is full) are returned too, and the step counts.
 *
 * @param session  the session
 * @param now      the host's clock, s, for devices; ignored without devices
 * @param h        length of the step, s, 1e-7 to 0.1; ignored with a replay, which sets it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of a device, detector, metrics, record or
 *         replay), or a result of #vbss_device_read, #vbss_scene_set_recorder or
 *         #vbss_scene_step, #vbss_knot_detector_step, #vbss_metrics_add_sample or #vbss_device_write.
 *         VBSS_ERROR_WRONG_STATE if the scene was stepped or restored past the session. With a
 *         replay also the results of #vbss_replay_step, VBSS_ERROR_WRONG_STATE at its end,
 *         VBSS_ERROR_INCOMPATIBLE if it has begun with another scene since, and VBSS_ERROR_CORRUPT
 *         when the hash of the scene or of the session differs from the recorded one
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_step(vbss_session *session, double now, double h);

/**
 * Moves a session that follows a replay, and its scene, to just after a step of the log. The call
 * restores the newest states of both at or before the step, then replays the steps that follow with
 * the comparisons of #vbss_session_step. Later steps have the same bits as without the seek.
 * `listen` does not receive the events of the seek; kept events can be read. When the log does not
 * have the step, or no such state can be restored, session, scene and replay are unchanged.
 *
 * @param session  the session; its replay has begun with its scene
 * @param step     number of the step in the log, from 1 on; 0: the initial state
 * @return VBSS_OK, VBSS_ERROR_WRONG_STATE (the session follows no replay), VBSS_ERROR_INCOMPATIBLE
 *         (the replay has begun with another scene since), VBSS_ERROR_NOT_FOUND (the log ends
 *         before the step, or has no state of a session at or before it), or a result of
 *         #vbss_replay_seek, #vbss_session_restore or #vbss_session_step
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_seek(vbss_session *session, uint64_t step);

/**
 * Sets the record to which the session writes, for example after a replay has ended and
 * #vbss_record_resume was called. The session leaves the replay that it followed. A record that has
 * just begun receives the state of the session, so that later steps can be replayed. The call attaches
 * the record to the scene (#vbss_scene_set_recorder) in place of the session's earlier one.
 *
 * @param session  the session
 * @param record   a record of the session's scene; NULL: none
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the record or another object),
 *         VBSS_ERROR_INCOMPATIBLE (the record belongs to another scene), VBSS_ERROR_WRONG_STATE (it has
 *         ended, or does not know the state of the scene) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_set_record(vbss_session *session, vbss_record *record);

/**
 * Returns the status of a session.
 *
 * @param session      the session
 * @param[out] status  receives the status
 * @param struct_size  `sizeof *status` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_status(vbss_session *session, vbss_session_status *status,
                                             uint32_t struct_size);

/**
 * Returns an event.
 *
 * @param session      the session
 * @param index        first_event to event_count - 1
 * @param[out] event   receives the event
 * @param struct_size  `sizeof *event` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (the event has not happened yet, or is lost)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_event(vbss_session *session, uint64_t index,
                                            vbss_session_event *event, uint32_t struct_size);

/**
 * Saves the state of the task, of its knot detector and of its metrics. The host saves the scene
 * separately (#vbss_scene_save), at the same step. Devices and records are not saved.
 *
 * @param session       the session
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of `bytes`
 * @param[out] written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the detector or the metrics),
 *         VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_save(vbss_session *session, uint8_t *bytes, uint64_t capacity,
                                       uint64_t *written);

/**
 * Restores a snapshot of a session with the same configuration, completely or not at all. Restore
 * its scene first.
 *
 * @param session  the session
 * @param bytes    the snapshot
 * @param count    its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the detector or the metrics),
 *         VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT (also: the snapshot is
 *         of another session, or the scene is at another step), VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_CAPACITY (the snapshot exceeds the detector's capacity),
 *         VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on failure
 *         nothing has changed
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_restore(vbss_session *session, const uint8_t *bytes,
                                          uint64_t count);

/**
 * Returns a hash of the state that #vbss_session_save saves, but for the settings and the
 * intermediate state of aids, which a replay does not have. Equal histories give equal hashes on
 * every machine. With metrics the cost grows with the length of the trial; do not call it in every
 * step.
 *
 * @param session    the session
 * @param[out] hash  receives the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the detector or the metrics) or
 *         VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_hash(vbss_session *session, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
