/**
 * @file session_assistance.h
 * @brief Assistance of a session: aids between the hands' input and the tools, and their record.
 *
 * An *aid* changes the movement of a hand before the session's step: it keeps a needle on its own arc,
 * a winding at its radius, a roll at a fixed angle, an idle tool at its place. All aids are off at first.
 * Switching one on or off is an event, VBSS_SESSION_EVENT_AID, and part of the log. A task in which an aid
 * was on is *assisted*: the status says so, and the metrics give it no score.
 *
 * Aids act on the input of the session's devices, and on that of #vbss_session_move_hand, by which a
 * host passes the pose of a hand itself. Tools that the host moves by #vbss_grasper_set_target get no
 * aid. The log has the resulting targets, so a replay needs no aid to have the same bits.
 *
 * As long as no aid has been on, a tool goes where its hand is. From then on it makes the movements of
 * its hand, as an aid has changed them, and keeps the offset that results, as after a clutch. A host with a
 * relative input, such as a mouse, can take the tool's target as the new origin
 * (#vbss_session_hand.is_origin).
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SESSION_ASSISTANCE_H
#define VBLAST_SS_SESSION_ASSISTANCE_H

#include <vblast_ss/session.h>

/** Assistance of a session. Fill it with #vbss_session_assistance_init, then change fields. */
typedef struct vbss_session_assistance {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t aids;        /**< VBSS_SESSION_AID_ bits of the aids that are on; default 0. */
    double time_scale;    /**< Simulated time per time of the host, 0.25 to 1; default 0.5. */
    /** Direction of ARC and WIND, of any length from 1e-9 to 1e3. Default 0, 0, 0: from the first mark of
     * the stitch to the second one. */
    double direction[3];
    double roll_step; /**< Step of the roll, rad, 0.01 to 3.2; default pi / 4. */
    double
        sink_speed; /**< Speed below which a hand sinks unintentionally, m/s, 0 to 1; default 4e-3. */
    double hold_distance; /**< Distance within which a hand rests, m, 0 to 1; default 2e-3. */
    double hold_time; /**< Time after which a hand that rests is idle, s, 0 to 10; default 0.7. */
} vbss_session_assistance;

/** Input of a hand. Fill it with #vbss_session_hand_init, then set its fields. */
typedef struct vbss_session_hand {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** 1: the hand is now at this pose and its tool does not move: later movements start here. `opening`
     * is ignored. Default 0. */
    uint32_t is_origin;
    double position
        [3]; /**< Position of the tool's tip, m, each coordinate at most 1e3 in magnitude. */
    /** Orientation of the tool, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0. */
    double orientation[4];
    double opening; /**< Opening of the handle, 0 (closed) to 1 (open); default 0. */
} vbss_session_hand;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a struct with the default assistance: all aids are off.
 *
 * @param[out] assistance  the struct to fill
 * @param struct_size      `sizeof *assistance` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_assistance_init(vbss_session_assistance *assistance,
                                                  uint32_t struct_size);

/**
 * Returns the default assistance that #vbss_session_assistance_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_session_assistance vbss_session_assistance_default(void)
{
    vbss_session_assistance vbss_filled;
    (void)vbss_session_assistance_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills the input of a hand with the defaults.
 *
 * @param[out] hand    the struct to fill
 * @param struct_size  `sizeof *hand` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_hand_init(vbss_session_hand *hand, uint32_t struct_size);

/**
 * Returns the default input of a hand that #vbss_session_hand_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_session_hand vbss_session_hand_default(void)
{
    vbss_session_hand vbss_filled;
    (void)vbss_session_hand_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Switches aids on and off, from the next step on.
 *
 * @param session     the session; it follows no replay
 * @param assistance  the aids and their settings; NULL switches all aids off and keeps the settings
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_WRONG_STATE (the session follows
 *         a replay) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_set_assistance(vbss_session *session,
                                                 const vbss_session_assistance *assistance);

/**
 * Returns the assistance that was set. In a replay, the aids are those of the log, and the settings
 * are the defaults.
 *
 * @param session          the session
 * @param[out] assistance  receives the aids and their settings
 * @param struct_size      `sizeof *assistance` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_get_assistance(vbss_session *session,
                                                 vbss_session_assistance *assistance,
                                                 uint32_t struct_size);

/**
 * Passes the input of a hand for the next step, which moves its tool there as the aids permit. Without
 * a call before a step the tool keeps its target. A device of the hand takes precedence. The call
 * allocates nothing.
 *
 * @param session  the session; it follows no replay
 * @param tool     VBSS_METRICS_TOOL_LEFT or VBSS_METRICS_TOOL_RIGHT
 * @param hand     the input of the hand
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_WRONG_STATE (the session follows a replay) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_session_move_hand(vbss_session *session, vbss_metrics_tool tool,
                                            const vbss_session_hand *hand);

#ifdef __cplusplus
}
#endif

#endif
