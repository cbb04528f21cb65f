/**
 * @file session_coaching.h
 * @brief The coach of a session: the next goal of the trainee, the way to it, and mistakes.
 *
 * A session with #vbss_session_config.coaching derives a *goal* and the *mistakes* from its facts and
 * from the scene in every step. The goal is the next thing to do, for one hand. A mistake begins when it
 * is seen and ends when it is mended. Both are events of the session, so a replay gives them at the same
 * steps. #vbss_session_get_coaching adds sentences, the geometry to draw, and how far the trainee is
 * from the goal.
 *
 * Codes and numbers suffice to write the sentences in another language. docs/guides/coaching.md has a
 * table of goals, numbers and mistakes.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SESSION_COACHING_H
#define VBLAST_SS_SESSION_COACHING_H

#include <vblast_ss/session.h>

/** Goal of a trainee: a VBSS_SESSION_GOAL_ constant. */
typedef int32_t vbss_session_goal;

/** The constants of #vbss_session_goal. "The hand" is #vbss_session_coaching.tool. Each comment
 * says which geometry is given, and which numbers become zero when the goal is met. */
enum {
    VBSS_SESSION_GOAL_NONE = 0, /**< There is no goal: before the first step, or after the end. */
    /** The hand takes the needle. POINT: on the needle; DIRECTION: of the jaws. `distance` of the
     * tool's tip from the point; `angle` between jaws and direction. */
    VBSS_SESSION_GOAL_TAKE_NEEDLE = 1,
    /** The hand brings the needle's tip to mark `number` (0 left, 1 right). POINT: the mark;
     * DIRECTION: into the wall. `distance` of the tip from the mark; `angle` between tip and
     * direction. */
    VBSS_SESSION_GOAL_REACH_MARK = 2,
    /** The hand pushes the tip through the wall at mark `number`. Geometry and numbers as for REACH_MARK,
     * and ARC: the needle's own arc. */
    VBSS_SESSION_GOAL_PIERCE = 3,
    /** The hand turns the needle along its own arc to mark `number`. POINT: the mark; ARC: from the
     * tip to beside the mark. `angle` of the arc; `distance` of the tip from the mark; `offset`: how
     * far the arc misses the mark. */
    VBSS_SESSION_GOAL_DRIVE = 4,
    /** The tip is out: the hand turns the needle on until it can be taken there. ARC; `length` that
     * must still come out. */
    VBSS_SESSION_GOAL_EXPOSE_TIP = 5,
    /** The hand takes the needle beyond the second hole. POINT, DIRECTION, `distance` and `angle` as
     * for TAKE_NEEDLE. */
    VBSS_SESSION_GOAL_TAKE_TIP = 6,
    /** The hand opens its jaws and releases the needle, which the other one holds. POINT: the tool's
     * tip. */
    VBSS_SESSION_GOAL_RELEASE_NEEDLE = 7,
    /** The hand turns the needle out of the drain along its arc. ARC; `length` of needle that is
     * still in front of the second hole. */
    VBSS_SESSION_GOAL_DRAW_NEEDLE = 8,
    /** The hand draws the thread through. POINT: the second hole; DIRECTION: to pull; `length` of tail
     * beyond `tail_high`. */
    VBSS_SESSION_GOAL_DRAW_THREAD = 9,
    /** The tail is too short: the hand draws it back. POINT: on the tail, beside the first hole;
     * DIRECTION: to pull; `length` that is missing; `distance` of the tool's tip from the point. */
    VBSS_SESSION_GOAL_LENGTHEN_TAIL = 10,
    /** The hand winds the needle's limb round the other tool for throw `number` (0, 1, 2). POINT: where
     * the other tool's tip shall be, over the drain at rest; DIRECTION: in which its jaws shall point; ARC: about its jaws,
     * `arc_angle` with the turns that are missing; `turns` that are missing; `distance` of the other
     * tool's tip from the point, which need not become zero. */
    VBSS_SESSION_GOAL_WIND = 11,
    /** The hand, with the turns on its jaws, takes the tail near its end. POINT: on the tail;
     * DIRECTION: along the tail, from its end. `distance` of the tool's tip from the point. */
    VBSS_SESSION_GOAL_TAKE_TAIL = 12,
    /** The hand opens its jaws and releases the thread. POINT: the tool's tip. */
    VBSS_SESSION_GOAL_RELEASE_TAIL = 13,
    /** The hand draws the tail through the turns. POINT: the slit; DIRECTION: to pull; ARC: from the tool's
     * tip over the slit down to its own side, where the arc is no longer given; `turns` that are still on its
     * jaws. */
    VBSS_SESSION_GOAL_DRAW_TAIL = 14,
    /** Both hands pull throw `number` down, the hand in DIRECTION and the other one opposite, each with
     * `pull_force`. If the slit is open under a second or third throw that hangs loose, DIRECTION is to the
     * other hand's side: from there the throw draws the one below tight. POINT: the slit; `force` that the weaker end misses to that; `length`: gap of the
     * slit beyond `seat_gap`. */
    VBSS_SESSION_GOAL_SEAT = 15,
    /** The hand takes the needle from the other one after throw `number`. POINT, DIRECTION, `distance`
     * and `angle` as for TAKE_NEEDLE. */
    VBSS_SESSION_GOAL_HAND_OVER = 16,
    /** The hand exchanges its tool for shears. */
    VBSS_SESSION_GOAL_TAKE_SHEARS = 17,
    /** The hand cuts tail `number` (0: the short one, 1: the needle's). POINT: where to cut; DIRECTION:
     * along the tail, from the knot. `distance` of the shears' tip from the point. */
    VBSS_SESSION_GOAL_CUT = 18
};

/** Mistake of a trainee: a VBSS_SESSION_MISTAKE_ constant. */
typedef int32_t vbss_session_mistake;

/** The constants of #vbss_session_mistake. "Ends" gives the condition under which a mistake ends. */
enum {
    VBSS_SESSION_MISTAKE_NONE = 0, /**< There is no mistake. */
    /** No hand holds the needle, and it is in no wall. Ends: a hand holds it. */
    VBSS_SESSION_MISTAKE_NEEDLE_DROPPED = 1,
    /** The first hole is more than 1 mm from its mark. Ends: the needle leaves the hole. */
    VBSS_SESSION_MISTAKE_ENTRY_MISSED = 2,
    /** The second hole is more than 1 mm from its mark. Ends: the needle leaves the hole. */
    VBSS_SESSION_MISTAKE_EXIT_MISSED = 3,
    /** A wall is pierced beside the stitch. Ends: that hole is empty. */
    VBSS_SESSION_MISTAKE_STRAY_HOLE = 4,
    /** The needle was drawn back out of the first hole. Ends: it is pierced again. */
    VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN = 5,
    /** The thread was pulled out of the stitch. Ends: the needle is in a wall again. */
    VBSS_SESSION_MISTAKE_THREAD_PULLED_OUT = 6,
    /** The tail is shorter than `tail_low`. Ends: it is longer, or a throw is begun. */
    VBSS_SESSION_MISTAKE_TAIL_SHORT = 7,
    /** The first throw was begun with a tail longer than `tail_high`. Ends: the turns are off. */
    VBSS_SESSION_MISTAKE_TAIL_LONG = 8,
    /** The turns progress towards the handle and tie nothing. Ends: they no longer do. */
    VBSS_SESSION_MISTAKE_TOWARD_HANDLE = 9,
    /** The limb is wound in the sense of the throw before: a granny. Ends: it is unwound. */
    VBSS_SESSION_MISTAKE_WRONG_SENSE = 10,
    /** Turns came off the jaws before the tail was taken, but for those that had to be unwound. Ends: they are wound
     * again. */
    VBSS_SESSION_MISTAKE_TURNS_LOST = 11,
    /** The tail was taken with too few turns on the jaws. Ends: it is released, or tied all the
     * same. */
    VBSS_SESSION_MISTAKE_TOO_FEW_TURNS = 12,
    /** The tail is held too far from its end, and a bight of it would be drawn through. Ends: it is
     * released, or held near its end. */
    VBSS_SESSION_MISTAKE_BIGHT = 13,
    /** The tail was dropped before the throw was tied. Ends: it is held again, or the turns are
     * off. */
    VBSS_SESSION_MISTAKE_TAIL_DROPPED = 14,
    /** A tied throw came undone. Ends: as many throws are tied again. */
    VBSS_SESSION_MISTAKE_THROW_UNDONE = 15,
    /** A throw is tied in the sense of the one before. Ends: it comes undone. */
    VBSS_SESSION_MISTAKE_GRANNY = 16,
    /** The first throw is tied with one wrap. Ends: it comes undone. */
    VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS = 17,
    /** A throw is tied with more wraps than it needs. Ends: it comes undone. */
    VBSS_SESSION_MISTAKE_TOO_MANY_WRAPS = 18,
    /** There is a knot in one limb alone. Ends: it is open. */
    VBSS_SESSION_MISTAKE_STRAY_KNOT = 19,
    /** The first throw, while it is alone, has capsized into a half hitch, which slides. Ends: it is flat
     * again. */
    VBSS_SESSION_MISTAKE_CAPSIZED = 20,
    /** One end of an unseated throw is pulled and the other is not, or gives way, so that the tail of the first throw
     * becomes 15 mm longer than `tail_high`. Ends: both or neither are, or the throw is seated. */
    VBSS_SESSION_MISTAKE_ONE_SIDED = 21,
    /** A throw has been tied for 5 s, and both of its ends are slack. Ends: both ends are tense, or the
     * throw is seated. */
    VBSS_SESSION_MISTAKE_SLACK = 22,
    /** The slit has opened under a seated throw. Ends: the throw is seated, or the next one is tied on it. */
    VBSS_SESSION_MISTAKE_SLIT_OPENED = 23,
    /** The walls of the slit have slipped past each other. Ends: they meet again. */
    VBSS_SESSION_MISTAKE_WALLS_CROSSED = 24,
    /** An anchor of the drain bears more than 0.8 of its strength. Ends: it bears less. */
    VBSS_SESSION_MISTAKE_DRAIN_TEARING = 25,
    /** The tension of the thread exceeds 6 N. Ends: it falls below. */
    VBSS_SESSION_MISTAKE_PULLED_HARD = 26,
    /** A throw is tied, and the needle has not changed hands before. Ends: it comes undone. */
    VBSS_SESSION_MISTAKE_TRANSFER_MISSED = 27,
    VBSS_SESSION_MISTAKE_TIME_UP = 28,       /**< The time limit has passed. Does not end. */
    VBSS_SESSION_MISTAKE_DRAIN_TORN = 29,    /**< The drain is torn off. Does not end. */
    VBSS_SESSION_MISTAKE_CUT_EARLY = 30,     /**< Cut before the third throw. Does not end. */
    VBSS_SESSION_MISTAKE_CUT_KNOT = 31,      /**< Cut in the knot or stitch. Does not end. */
    VBSS_SESSION_MISTAKE_THREAD_BROKEN = 32, /**< The thread has broken. Does not end. */
    VBSS_SESSION_MISTAKE_COUNT = 33          /**< One more than the largest mistake. */
};

/** Bits for the geometry that a goal has. */
enum {
    VBSS_SESSION_GEOMETRY_POINT = 1,     /**< `point` is given. */
    VBSS_SESSION_GEOMETRY_DIRECTION = 2, /**< `direction` is given. */
    VBSS_SESSION_GEOMETRY_ARC = 4,       /**< The fields `arc_` are given. */
    VBSS_SESSION_GEOMETRY_PULL = 8 /**< `pull_force` is given; the pull is along `direction`. */
};

/** Goal and mistakes of a session that coaches. A number that the goal does not use is zero. */
typedef struct vbss_session_coaching {
    uint32_t struct_size;   /**< Bytes of this struct that the library filled. */
    vbss_session_goal goal; /**< The next goal. */
    /** The hand that acts; NONE: no goal, or the session's third tool. */
    vbss_metrics_tool tool;
    uint32_t number; /**< Mark, throw or tail of the goal, as its comment says; otherwise 0. */
    /** The goal as an English sentence: a constant string, never NULL. */
    const char *sentence;
    /** The newest mistake that has not ended. One that cannot be mended is given for 5 s, those of a
     * failure for good. */
    vbss_session_mistake mistake;
    uint32_t is_mendable;         /**< 1: the mistake can still be mended. */
    const char *mistake_sentence; /**< The mistake as a sentence: constant, "" without one. */
    /** How to mend the mistake, or how to go on: a constant string, "" without one. */
    const char *remedy;
    uint64_t mistakes;    /**< Bit m: mistake m has not ended. */
    uint32_t geometry;    /**< VBSS_SESSION_GEOMETRY_ bits of the fields below. */
    uint32_t reserved;    /**< Zero. */
    double point[3];      /**< Where to go or to pull from, m. */
    double direction[3];  /**< Unit vector. */
    double arc_centre[3]; /**< Centre of the arc or circle to follow, m. */
    double arc_axis[3];   /**< Unit axis; the arc goes about it by the right-hand rule. */
    double arc_start[3];  /**< Where the arc starts, m. */
    double arc_radius;    /**< Radius of the arc, m. */
    double arc_angle;     /**< Angle that is left, rad, 0 or more; several turns for a winding. */
    double pull_force;    /**< Force to pull with at each end, N. */
    double distance;      /**< Distance to go, m. */
    double angle;         /**< Angle to turn by, rad. */
    double offset;        /**< DRIVE: distance by which the arc misses the mark, m. */
    double turns;         /**< Turns that are missing, or that must come off. */
    double force;         /**< Force that is missing, N. */
    double length;        /**< Length or gap that is missing, m. */
    double goal_time;     /**< Time since the goal began, s. */
    double mistake_time;  /**< Session time at which `mistake` was seen, s. */
} vbss_session_coaching;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Returns the coach's goal with its geometry, and the newest mistake, for the state after the last
 * step. The call computes the geometry from the scene. It changes nothing and allocates nothing.
 *
 * @param session        the session; its configuration has `coaching` 1
 * @param[out] coaching  receives goal, sentences, geometry and numbers
 * @param struct_size    `sizeof *coaching` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_WRONG_STATE (the session does not coach)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_coaching(vbss_session *session,
                                               vbss_session_coaching *coaching,
                                               uint32_t struct_size);

/**
 * Returns a mistake as an English sentence, for example to list the events of a session.
 *
 * @param mistake  the mistake
 * @return a constant string, never NULL; "" for NONE and for a number that is no mistake
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_session_mistake_string(vbss_session_mistake mistake);

/**
 * Returns how to mend a mistake, or how to go on after it, as an English sentence.
 *
 * @param mistake  the mistake
 * @return a constant string, never NULL; "" for NONE and for a number that is no mistake
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_session_remedy_string(vbss_session_mistake mistake);

#ifdef __cplusplus
}
#endif

#endif
