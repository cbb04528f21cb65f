/**
 * @file session_exercise.h
 * @brief Exercises of a session: one skill of the task, its measures, their pass marks and an outcome.
 *
 * A session with #vbss_session_config.exercise trains one skill. It ends with an *outcome* when the goal of
 * the exercise is reached, when its time is up, or when the task fails. The outcome is passed if each
 * *measure* is within its pass mark. It is an event, VBSS_SESSION_EVENT_EXERCISE, so a replay gives it at
 * the same step. After the outcome the scene can be stepped on, but the clock and the facts of the task
 * stay as they are. An exercise gets no score: its metrics start with it and miss the rest of the task.
 *
 * Exercises after the first start within the task, for example with the stitch made. Such a start is the
 * saved state of a session and of its scene at that place of the task. The host restores the scene
 * (#vbss_scene_restore) and passes the state of the session to #vbss_session_begin_at, which keeps the facts
 * and begins all else. An exercise may also be reached from an earlier place of the task.
 *
 * | exercise     | starts at                          | goal                                               |
 * |--------------|------------------------------------|----------------------------------------------------|
 * | TAKE_NEEDLE  | a new session                      | the needle held and 10 mm above its place for 1 s  |
 * | PASS_MARK    | APPROACH, a tool holds the needle  | 5 mm of the needle beyond the wall                 |
 * | SINGLE_THROW | THROW_1, the stitch made           | the first throw seated                             |
 * | DOUBLE_THROW | THROW_1, the stitch made           | the first throw seated                             |
 * | SQUARE_THROW | THROW_2, the needle changed hands  | the second throw seated                            |
 * | CUT          | CUT, three throws seated           | both tails cut                                     |
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SESSION_EXERCISE_H
#define VBLAST_SS_SESSION_EXERCISE_H

#include <vblast_ss/session.h>

/** Outcome of an exercise: a VBSS_SESSION_OUTCOME_ constant. */
typedef int32_t vbss_session_outcome;

/** The constants of #vbss_session_outcome. */
enum {
    VBSS_SESSION_OUTCOME_NONE = 0, /**< There is no exercise, or it has not ended. */
    VBSS_SESSION_OUTCOME_PASSED =
        1, /**< The goal is reached, and each measure is within its mark. */
    VBSS_SESSION_OUTCOME_FAILED = 2 /**< A measure misses its mark, or the goal was not reached. */
};

/** Kind of a measure: a VBSS_SESSION_MEASURE_ constant. */
typedef int32_t vbss_session_measure_kind;

/** The constants of #vbss_session_measure_kind. Each comment ends with the exercises and the pass mark. */
enum {
    /** Time of the exercise, s. All; TAKE_NEEDLE and CUT at most 60, PASS_MARK and throws at most 120. At
     * this time the exercise ends. */
    VBSS_SESSION_MEASURE_TIME = 1,
    /** Where the needle is held, as a share of its length from the tip. TAKE_NEEDLE: 0.47 to 0.7; courses
     * ask for half to two thirds. */
    VBSS_SESSION_MEASURE_GRASP_SHARE = 2,
    /** Angle between the jaws that hold the needle and the normal of the needle's plane, rad.
     * TAKE_NEEDLE: at most 30 degrees. */
    VBSS_SESSION_MEASURE_GRASP_ANGLE = 3,
    /** Number of times that the needle was dropped. TAKE_NEEDLE: 0. */
    VBSS_SESSION_MEASURE_DROPS = 4,
    /** Distance of the first hole from its mark on the surface of the drain, m. PASS_MARK: at most 1 mm,
     * the published accuracy of proficient trainees. */
    VBSS_SESSION_MEASURE_DEVIATION = 5,
    /** Angle between the needle's tip and the normal of the wall as the first hole is made, rad.
     * PASS_MARK: at most 30 degrees; courses ask for 0. */
    VBSS_SESSION_MEASURE_ENTRY_ANGLE = 6,
    /** Number of holes beside the stitch. PASS_MARK: 0. */
    VBSS_SESSION_MEASURE_STRAYS = 7,
    /** Wraps of the throw. SINGLE_THROW and SQUARE_THROW: 1; DOUBLE_THROW: 2. */
    VBSS_SESSION_MEASURE_WRAPS = 8,
    /** 1: the throw is square to the one before; 0: it is not, or this is not known. SQUARE_THROW: 1. */
    VBSS_SESSION_MEASURE_SQUARE = 9,
    /** Largest gap along the slit at the outcome, m. Throws: at most 1 mm. */
    VBSS_SESSION_MEASURE_GAP = 10,
    /** Largest tension of the thread during the exercise that lasts for the session's `dwell` of simulated
     * time, N: the largest of the minima of successive intervals of that length. Throws: at most 6.1 N,
     * the published maximum while experts tie on a drain. */
    VBSS_SESSION_MEASURE_TENSION = 11,
    /** Remaining length of the short tail, m. CUT: 2 to 8 mm; courses ask for 3 to 5 mm. */
    VBSS_SESSION_MEASURE_SHORT_TAIL = 12,
    /** Remaining length of the needle's tail, m. CUT: 2 to 8 mm. */
    VBSS_SESSION_MEASURE_LONG_TAIL = 13
};

/** The exercise of a session and its outcome. */
typedef struct vbss_session_exercise_state {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    vbss_session_exercise exercise; /**< The exercise; NONE: the session runs the whole task. */
    vbss_session_outcome outcome;   /**< The outcome. */
    uint32_t measure_count;         /**< Number of measures; 0 without an exercise. */
    /** Bit i: measure i is not known yet, or is outside its pass mark. */
    uint32_t missed;
    /** VBSS_SESSION_AID_ bits of the aids that were on; 0: the exercise was not assisted. */
    uint32_t aids_used;
    const char *name;     /**< Name, such as "take_needle": a constant string, "" for NONE. */
    const char *sentence; /**< The goal as an English sentence: a constant string, "" for NONE. */
    double time;          /**< Time since the start, until the outcome or now, s. */
} vbss_session_exercise_state;

/** A measure of an exercise. It is met if it is known, and `low` <= `value` <= `high`. */
typedef struct vbss_session_measure {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    vbss_session_measure_kind kind; /**< Kind of the measure, which says its unit. */
    uint32_t is_known;              /**< 1: `value` is known; 0: not yet, and `value` is zero. */
    uint32_t is_met;                /**< 1: the value is known and within the pass mark. */
    const char *name;               /**< Short English name: a constant string, never NULL. */
    double value;                   /**< The value; its unit is that of the kind. */
    double low;                     /**< Smallest value that passes. */
    double high;                    /**< Largest value that passes. */
} vbss_session_measure;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Begins the task at the place that another session had reached. The session takes over the facts of the
 * saved state: holder, stitch, tail, throws, seats, transfers, cuts and phase. Clock, events, metrics, aids,
 * mistakes and exercise begin as in a new session. The host first restores the scene (#vbss_scene_restore) as
 * it was saved at the same step. The call comes before the first step. A session that shall be logged gets
 * its record after the call (#vbss_session_set_record).
 *
 * @param session  a session that has made no step
 * @param bytes    state of a session (#vbss_session_save); its configuration has the same values, except for
 *                 `exercise`
 * @param count    size of `bytes`
 * @return VBSS_OK, VBSS_ERROR_WRONG_STATE (the session has made a step, or has a record or a replay), or a
 *         result of #vbss_session_restore; on failure nothing has changed
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_begin_at(vbss_session *session, const uint8_t *bytes,
                                           uint64_t count);

/**
 * Returns the exercise of a session and its outcome.
 *
 * @param session      the session
 * @param[out] state   receives the exercise; all zero and "" for a session without one
 * @param struct_size  `sizeof *state` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_exercise(vbss_session *session,
                                               vbss_session_exercise_state *state,
                                               uint32_t struct_size);

/**
 * Returns a measure of the exercise, as it is now or as it was at the outcome.
 *
 * @param session       the session
 * @param index         0 to #vbss_session_exercise_state.measure_count - 1
 * @param[out] measure  receives the measure
 * @param struct_size   `sizeof *measure` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (the exercise has no such measure)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_measure(vbss_session *session, uint32_t index,
                                              vbss_session_measure *measure, uint32_t struct_size);

/**
 * Returns the name of an exercise, for command lines and files.
 *
 * @param exercise  the exercise
 * @return a constant string of lower-case letters and "_", never NULL; "" for NONE and for a number that is
 *         no exercise
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_session_exercise_name(vbss_session_exercise exercise);

/**
 * Returns the goal of an exercise as an English sentence.
 *
 * @param exercise  the exercise
 * @return a constant string, never NULL; "" for NONE and for a number that is no exercise
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_session_exercise_string(vbss_session_exercise exercise);

#ifdef __cplusplus
}
#endif

#endif
