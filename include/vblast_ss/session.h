/**
 * @file session.h
 * @brief The suturing task over a scene: one stitch through two marks, a knot of three throws, both tails cut.
 *
 * A session knows which bodies of a scene are the thread, the needle, the drain and the tools. It steps the scene, looks at
 * what has become of it, and says how far the task is: a *phase*, found anew in every step from facts (the needle is held, it is
 * through the first mark, throw 2 is seated, ...), and an *event* for each fact that begins or ceases. A fact that rests on a
 * measured number changes only when that has been so for some time (`dwell`, `throw_dwell`), with another limit to go back
 * than to come; so what the geometry undoes is undone, and nothing chatters. docs/session.md has the table of phases, facts
 * and failures.
 *
 * The clock of a session runs with the hands: it adds up the lengths of the steps from the needle's appearance on. All
 * times, limits and dwells, the metrics and the score use it. A scene that exceeds its limits of work leaves out part of
 * that time. The status reports how much of it is lost and how much is simulated; above `lost_share` there is an event.
 *
 * Devices, a knot detector, metrics and a record or replay are the host's; each may be absent and then costs nothing. A step:
 *
 *     devices -> scene step -> knots -> metrics -> forces out -> record
 *
 * All of a session but its devices follows from the inputs of the scene and from the state, so that a log of the scene,
 * replayed in the place of devices, makes the same events.
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

/** A session. */
typedef struct vbss_session vbss_session;

/** How far the task is: a VBSS_SESSION_PHASE_ constant. They are the numbers of the metrics' phases, too. */
typedef int32_t vbss_session_phase;

/** The constants of #vbss_session_phase, in the order of the task. */
enum {
    VBSS_SESSION_PHASE_IDLE = 0,     /**< No step was made: the needle has not appeared. */
    VBSS_SESSION_PHASE_LOADING = 1,  /**< The needle is to be taken. */
    VBSS_SESSION_PHASE_APPROACH = 2, /**< A tool has it; on to the first mark. */
    VBSS_SESSION_PHASE_IN_DRAIN = 3, /**< Its tip is in; on to the second mark. */
    VBSS_SESSION_PHASE_PULL_THROUGH =
        4,                          /**< It is out again: thread is drawn to the tail's length. */
    VBSS_SESSION_PHASE_THROW_1 = 5, /**< The first throw is tied and seated. */
    VBSS_SESSION_PHASE_TRANSFER_1 = 6, /**< The needle is to change hands. */
    VBSS_SESSION_PHASE_THROW_2 = 7,    /**< The second throw. */
    VBSS_SESSION_PHASE_TRANSFER_2 = 8, /**< The needle is to change hands. */
    VBSS_SESSION_PHASE_THROW_3 = 9,    /**< The third throw. */
    VBSS_SESSION_PHASE_CUT = 10,       /**< Both tails are to be cut. */
    VBSS_SESSION_PHASE_DONE = 11,      /**< They are. For good. */
    VBSS_SESSION_PHASE_FAILED = 12     /**< See #vbss_session_failure. For good. */
};

/** How far a throw is: a VBSS_SESSION_STAGE_ constant. */
typedef int32_t vbss_session_stage;

/** The constants of #vbss_session_stage. */
enum {
    VBSS_SESSION_STAGE_NONE = 0,    /**< Nothing of it is there. */
    VBSS_SESSION_STAGE_WRAP = 1,    /**< The thread winds round a tool, */
    VBSS_SESSION_STAGE_GRASPED = 2, /**< and a tool holds its tail near the end; */
    VBSS_SESSION_STAGE_PASSED = 3,  /**< it is tied if the tools withdraw. */
    VBSS_SESSION_STAGE_SEATING = 4, /**< It is tied, and to be pulled down. */
    VBSS_SESSION_STAGE_SEATED = 5   /**< It lies on the tissue. */
};

/** Why the task has failed: a VBSS_SESSION_FAILURE_ constant. */
typedef int32_t vbss_session_failure;

/** The constants of #vbss_session_failure. */
enum {
    VBSS_SESSION_FAILURE_NONE = 0,    /**< It has not. */
    VBSS_SESSION_FAILURE_TIMEOUT = 1, /**< The time is up. */
    VBSS_SESSION_FAILURE_AVULSED = 2, /**< The drain was torn off its anchors. */
    VBSS_SESSION_FAILURE_CUT_EARLY =
        3,                             /**< The thread was cut before the third throw was seated, */
    VBSS_SESSION_FAILURE_CUT_KNOT = 4, /**< or where it goes through the tissue or the knot. */
    VBSS_SESSION_FAILURE_BROKEN = 5,   /**< It bore more than it bears. */
    VBSS_SESSION_FAILURE_LOST =
        6 /**< Thread, needle, drain or a tool was removed from the scene. */
};

/** What happened: a VBSS_SESSION_EVENT_ constant. */
typedef int32_t vbss_session_event_kind;

/** The constants of #vbss_session_event_kind. Those that say "undone" come again with `undone` 1 when it is no longer so. */
enum {
    VBSS_SESSION_EVENT_APPEARED = 1, /**< The needle has appeared: the clock starts. */
    /** The phase `number` begins; undone 1: it is an earlier one than before. */
    VBSS_SESSION_EVENT_PHASE = 2,
    VBSS_SESSION_EVENT_TAKEN = 3, /**< `tool` holds the needle. Undone: it does no longer. */
    VBSS_SESSION_EVENT_DROPPED =
        4, /**< Before the stitch: nobody holds the needle, and it is in no wall. */
    /** Mark `number` (0: in, 1: out) was pierced, `amount` mm off; `position` is of the hole. Undone: the needle, or in the
     * end the thread, has left the hole. */
    VBSS_SESSION_EVENT_PUNCTURE = 5,
    VBSS_SESSION_EVENT_STRAY = 6, /**< A wall was pierced elsewhere: hole `number`. Undone. */
    /** The swage has gone through hole `number` (0, 1), the thread follows. Undone: it has come back. */
    VBSS_SESSION_EVENT_THREADED = 7,
    VBSS_SESSION_EVENT_TAIL = 8,  /**< The tail is `amount` m long, as it should. Undone. */
    VBSS_SESSION_EVENT_STAGE = 9, /**< Throw `number` (0, 1, ...) is at `stage`, whichever way. */
    /** Throw `number` is tied: `wraps`, `handedness`, `relation`; told again when these are known better. Undone: it came
     * undone. */
    VBSS_SESSION_EVENT_THROW = 10,
    VBSS_SESSION_EVENT_SEATED =
        11, /**< Throw `number` is seated; the slit gapes `amount` m. Undone. */
    VBSS_SESSION_EVENT_TRANSFER = 12, /**< After throw `number` `tool` has taken over the needle. */
    /** Throw `number` is tied, but the needle has not changed hands since the one before. Undone: with the throw. */
    VBSS_SESSION_EVENT_TRANSFER_MISSED = 13,
    /** The knot has the fault `number`, a VBSS_KNOT_FAULT_ bit, for `throw_dwell`; HITCH (a throw has capsized): for
     * 20 times `throw_dwell`, because its measure swings while a throw is drawn tight. Undone: after the same time. */
    VBSS_SESSION_EVENT_FAULT = 14,
    /** Tail `number` (0: the short one, 1: the needle's) was cut; `amount` m are left of it. */
    VBSS_SESSION_EVENT_CUT = 15,
    VBSS_SESSION_EVENT_DONE = 16,   /**< The task is complete. */
    VBSS_SESSION_EVENT_FAILED = 17, /**< It has failed: `number` is a #vbss_session_failure. */
    /** More than `lost_share` of the time is lost: `amount` s of it, since the needle appeared. Times and score do not
     * compare with those of other trials. Undone: it is less than half of that share again. */
    VBSS_SESSION_EVENT_TIME_LOST = 18
};

/** Something that happened. */
typedef struct vbss_session_event {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_session_event_kind kind; /**< What. */
    vbss_metrics_tool tool;       /**< With which tool; VBSS_METRICS_NO_TOOL: none, or not known. */
    uint32_t number;              /**< As the kind says. */
    uint32_t undone;              /**< 1: it is no longer so. */
    vbss_session_stage stage;     /**< STAGE: which. */
    int32_t wraps;                /**< THROW: 1 single, 2 double, ... */
    int32_t handedness;           /**< THROW: +1 right-handed, -1 left-handed. */
    vbss_metrics_relation relation; /**< THROW: to the throw before. */
    vbss_session_phase phase;       /**< The phase after the step in which it happened. */
    uint64_t ordinal;               /**< Of the event, from 0 on. */
    uint64_t step;                  /**< Of the session, from 1 on. */
    double time;                    /**< Since the needle appeared, s, on the clock of the hands. */
    double position[3];             /**< Of the tool's tip, or where the kind says, m. */
    double force[3];                /**< On the tool's hand, N; zero without a tool. */
    double amount;                  /**< As the kind says. */
} vbss_session_event;

/**
 * A function of the host that hears of each event, at the end of the step in which it happened. It may look at everything and
 * must not change anything of the context.
 *
 * @param user   the config's `user`
 * @param event  what happened; valid during the call
 */
typedef void (*vbss_session_event_fn)(void *user, const vbss_session_event *event);

/** What the gap of the slit is between: a VBSS_SESSION_GAP_ constant. */
typedef int32_t vbss_session_gap;

/** The constants of #vbss_session_gap. */
enum {
    /** The lips, which are as high as the wall: #vbss_drain_gap.opening. A wall that rises is shut when it meets the other
     * one's face. Drains of method PAPER: EDGES. */
    VBSS_SESSION_GAP_LIPS = 0,
    /** The edges in the middle of the wall: #vbss_drain_gap.gap, the paper's measure. */
    VBSS_SESSION_GAP_EDGES = 1
};

/** How to make a session. Fill it with #vbss_session_config_init, then set the numbers of the bodies. */
typedef struct vbss_session_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Numbers in the scene. The thread's node 0 is at the swage, its last node the end of the tail. */
    uint32_t thread;
    uint32_t needle;   /**< The same of the needle, */
    uint32_t drain;    /**< the drain, */
    uint32_t tools[2]; /**< the left and the right grasper; */
    uint32_t shears;   /**< a third one that cuts. 0 (default): a tool is exchanged. */
    uint32_t
        event_capacity; /**< Most events that are kept, the newest; 8 to 65536; default 1024. */
    /** The knot detector looks every so many steps, 1 to 1000; default 4. Its work_limit bounds the work of a look. */
    uint32_t knot_interval;
    /** With a record: the task is hashed in the log every so many steps, and after those with events, for replays to compare;
     * 1 to 1e9; default 100. */
    uint32_t hash_interval;
    vbss_device *devices
        [2]; /**< Of the left and the right hand; NULL (default): the host moves that tool. */
    vbss_knot_detector *
        knots; /**< NULL (default): throws are not seen. It has room for the thread and all tools. */
    vbss_metrics *metrics; /**< NULL (default): nothing is measured. */
    vbss_record *record;   /**< Of the scene; NULL (default): nothing is written down. */
    vbss_replay *
        replay; /**< In the place of devices and record; has begun with the scene. NULL (default). */
    vbss_session_event_fn listen; /**< NULL (default): nobody. */
    void *user;                   /**< Handed to it; may be NULL. */
    double time_limit; /**< From the needle's appearing on, s, 1e-3 to 1e6; default 600. */
    double
        dwell; /**< A fact changes after it has differed for this time, s, 0 to 10; default 0.05. */
    /** The same time for throws and faults of the knot, s, 0 to 10; default 0.1. A half hitch has 20 times that. */
    double throw_dwell;
    double tail_low;  /**< Shortest tail, m, 0 to 1; default 15e-3; */
    double tail_high; /**< longest tail, tail_low to 1; default 20e-3. */
    /** So far beyond these it is not as it should any more, m, 0 to 1; default 1e-3. */
    double tail_margin;
    double tail_reach; /**< The tail is grasped within this of its end, m, 0 to 1; default 0.01. */
    /** A throw is seated when the slit gapes no more than this (edges that have crossed do not), m, 0 to 1; default 0.5e-3, */
    double seat_gap;
    double seat_release; /**< no longer from this on, seat_gap to 1; default 1e-3. */
    double seat_force;   /**< Tension of both limbs that seats it, N, 0 to 1e3; default 0.5. */
    /** Share of the anchors torn from which the drain is off, 0 to 1; default 0.5. */
    double avulsed_share;
    double
        break_force; /**< Tension at which the thread breaks, N, 0 to 1e6; default 0: it does not. */
    /** What seats throws and is told as gap, to status, events and metrics; default LIPS. */
    vbss_session_gap gap_measure;
    uint32_t reserved; /**< Zero. */
    /** Share of the time, 0 to 1, above which lost time is an event and sets `is_lossy`; default 0.02. A trial shorter
     * than 1 s counts as 1 s. */
    double lost_share;
} vbss_session_config;

/** How far a session is. */
typedef struct vbss_session_status {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_session_phase phase;     /**< How far the task is. */
    vbss_session_stage stage;     /**< Of the throw that is under way; NONE if none is. */
    vbss_session_failure failure; /**< Why it has failed. */
    vbss_metrics_tool
        holder; /**< Who holds the needle, the first of two; VBSS_METRICS_NO_TOOL: nobody. */
    uint32_t punctured;    /**< Bits: 1, 2: the hole in, the hole out is there, */
    uint32_t threaded;     /**< and the thread goes through it. */
    uint32_t tail_set;     /**< 1: the tail is as it should. */
    uint32_t throws;       /**< Throws that are tied, */
    uint32_t seated;       /**< of them seated, counted from the tissue. */
    uint32_t transfers;    /**< Transfers between them that were made, at most two. */
    uint32_t cut;          /**< Bits: 1 the short tail, 2 the needle's. */
    uint32_t faults;       /**< Of the knot: VBSS_KNOT_FAULT_ bits, as last reported by events. */
    uint32_t metrics_lost; /**< Events for which the metrics had no room. */
    uint64_t steps;        /**< Steps so far. */
    uint64_t first_event;  /**< The oldest event that is kept; so many are lost. */
    uint64_t event_count;  /**< Events so far. */
    /** Since the needle appeared, until the end or now, s, on the clock of the hands. It includes `time_lost`. */
    double time;
    double tail;            /**< Length of the short tail, from the hole, m; 0 without. */
    double gap;             /**< Of the slit's middle, as `gap_measure` says, m. */
    double tension[2];      /**< Largest of the short limb, of the needle's, N. */
    double deviation_mm[2]; /**< Of the holes from the marks. */
    /** Part of `time` that the scene has left out, s: paused steps (vbss_scene_statistics::time_paused) and truncated
     * substeps (#VBSS_EVENT_CLAMPED), from the second step on. */
    double time_lost;
    /** `time` without `time_lost`, s. Up to two steps of it may still wait (vbss_scene_statistics::behind). */
    double time_simulated;
    uint32_t is_lossy; /**< 1: more than `lost_share` of the time is lost, with hysteresis. */
    uint32_t reserved; /**< Zero. */
} vbss_session_status;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration with the defaults; the bodies come from the host.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_config_init(vbss_session_config *config, uint32_t struct_size);

/**
 * Creates a session over a scene. Scene, devices, detector, metrics, record and replay remain the host's, and must live as long
 * as the session is stepped. All memory that steps need is allocated here.
 *
 * @param scene         the scene
 * @param config        how
 * @param[out] session  the new session; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of a part, or one of another context), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: no such body; a record or replay
 *         of another scene, or both), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (the detector has no room for the thread or
 *         the tools), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_create(vbss_scene *scene, const vbss_session_config *config,
                                         vbss_session **session);

/**
 * Destroys a session; its scene and parts are the host's as before.
 *
 * @param session  the session; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_destroy(vbss_session *session);

/**
 * One step of the task. Nothing is allocated. When devices cannot be read or the scene refuses the step, the task is as it was;
 * tools may have been told where to go. What fails after the scene's step (a part that was destroyed or has no room) is
 * returned too, and that step of the task counts.
 *
 * @param session  the session
 * @param now      the host's clock, s, for devices; ignored without
 * @param h        s, 1e-7 to 0.1; ignored with a replay, which has its own
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of a part), what #vbss_device_read, #vbss_record_step or #vbss_scene_step,
 *         #vbss_knot_detector_step, #vbss_metrics_add_sample and #vbss_device_write return; with a replay what
 *         #vbss_replay_step returns, further VBSS_ERROR_OUT_OF_RANGE at its end, and VBSS_ERROR_CORRUPT when the scene's hash
 *         or the session's is not the recorded one
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_step(vbss_session *session, double now, double h);

/**
 * Brings a session that follows a replay, and its scene, to after a step of the log: restores the newest states of both at or
 * before it, and makes the steps from there on, comparing as #vbss_session_step does. What follows has the same bits as without.
 * Nobody hears of the events on the way; those that are kept can be read. When the log does not have the step, or no such state
 * can be restored, session, scene and replay stay as they are.
 *
 * @param session  the session; its replay has begun with its scene
 * @param step     number of the step in the log, from 1 on; 0: the begin
 * @return VBSS_OK, VBSS_ERROR_OUT_OF_RANGE (it follows no replay, the log ends before the step, or has no state of a session
 *         at or before it), what #vbss_replay_seek, #vbss_session_restore and #vbss_session_step return
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_seek(vbss_session *session, uint64_t step);

/**
 * From now on the session writes to a record, or to none, as after a replay that has ended and #vbss_record_resume.
 * A replay that it had is left. Into a record that has just begun its state is put, so that what follows can be replayed.
 *
 * @param session  the session
 * @param record   of the session's scene; NULL: none
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of the record or a part), VBSS_ERROR_OUT_OF_RANGE (of another scene) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_set_record(vbss_session *session, vbss_record *record);

/**
 * How far the session is.
 *
 * @param session      the session
 * @param[out] status  receives it
 * @param struct_size  `sizeof *status` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_get_status(vbss_session *session, vbss_session_status *status,
                                             uint32_t struct_size);

/**
 * An event.
 *
 * @param session      the session
 * @param index        first_event to event_count - 1
 * @param[out] event   receives it
 * @param struct_size  `sizeof *event` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE
 *         (there is none yet, or it is lost)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_get_event(vbss_session *session, uint64_t index,
                                            vbss_session_event *event, uint32_t struct_size);

/**
 * Saves the state of the task, with that of its knot detector and its metrics. The scene is saved by itself
 * (#vbss_scene_save), at the same time; devices and records are not saved.
 *
 * @param session       the session
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      bytes there is room for
 * @param[out] written  bytes written or, with VBSS_ERROR_CAPACITY, wanted
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of a part), VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_save(vbss_session *session, uint8_t *bytes, uint64_t capacity,
                                       uint64_t *written);

/**
 * Restores what was saved from a session made alike, after its scene was. All or nothing.
 *
 * @param session  the session
 * @param bytes    the snapshot
 * @param count    its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of a part), VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: of another session, or the scene is at another step), VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_CAPACITY (it counts more than the detector has room for), VBSS_ERROR_OUT_OF_MEMORY,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on failure nothing has changed
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_restore(vbss_session *session, const uint8_t *bytes,
                                          uint64_t count);

/**
 * A hash of what is saved: equal for equal histories, on every machine. Takes time with the length of the trial when there are
 * metrics: not for every step.
 *
 * @param session    the session
 * @param[out] hash  receives it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of a part) or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_session_get_hash(vbss_session *session, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
