/**
 * @file scene_event.h
 * @brief Events of a scene: contacts, grasps, punctures, cuts, exchanged instruments, and simulated
 *   time that was left out or has to wait.
 *
 * A scene keeps its events in a list until the host takes them with #vbss_scene_take_events. A host
 * that draws 60 frames a second and steps 16 or 17 times a frame so receives all events, if
 * `event_capacity` of #vbss_scene_config suffices for a frame. When the list is full, a new event
 * replaces the oldest one, and the call reports the number of lost events.
 *
 * Events are no part of the state: they change no hash, and a snapshot has none. Restoring a
 * snapshot empties the list. A step that fails, or the abandoned part of a suspended step, adds no
 * event. A suspended step adds its events with the call of #vbss_scene_step that completes it. So the
 * events that a suspended step has found before a snapshot are missing where that is restored.
 *
 * The fields that each kind uses. All other fields of a kind are zero. A cross means that the event has a
 * position; a cross in brackets, that it may have one.
 *
 *     kind           body_a    body_b     id           arc_length  value                   position
 *     TOUCH          body      body, or   0            0           force of the strongest    (x)
 *                              0: floor                            contact, N
 *     PART           body      body       0            0           0
 *     TRUNCATED      body      body       0            0           time left out, s
 *     PAUSED         body      body       0            0           time left out, s
 *     DEFERRED       0         0          steps that   0           time that waits, s
 *                                         wait
 *     CAUGHT_UP      0         0          0            0           0
 *     OVERDUE        0         0          0            0           0
 *     GRASP          held      grasper    triangle     of the      0                         x
 *     RELEASE        held      grasper    triangle     grasp       distance slid, m          x
 *     SLIP           held      grasper    triangle                 force, N                  x
 *     TORN           held      grasper    triangle                 force, N                  x
 *     GRASP_LOST     thread    grasper    0            of the      0                         x
 *                                                      grasp
 *     CUT            thread    piece      0            of the cut  0                         x
 *     EXCHANGED      grasper   0          new kind     0           0                         x
 *     NOT_EXCHANGED  grasper   0          wanted kind  0           0                         x
 *     PUNCTURE       needle    drain      hole         of the      force on the tip, N       x
 *     WITHDRAWN      needle    drain      hole         hole        0                         x
 *     PASSED         needle    drain      hole                     0                         x
 *     RETURNED       needle    drain      hole                     0                         x
 *     UNTHREADED     thread    drain      hole                     0                         x
 *     HOLE_LOST      needle    drain      0                        0                         x
 *     TEARING        thread    drain      hole                     force in the plane of     x
 *                                                                  the wall, N
 *     TORN_OUT       thread    drain      hole                     torn length, m            x
 *     BLOCKED        body      body       cause        0           time left out, s
 *     UNBLOCKED      body      body       cause        0           time left out since
 *                                                                  BLOCKED, s
 *
 * An arc length is that along the thread from its node 0, or along the needle from its tip; it is 0
 * for a grasp of a drain. A triangle is one of a drain that jaws hold; it is 0 for a grasp of a
 * thread or a needle. A hole is the identifier of #vbss_scene_hole.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SCENE_EVENT_H
#define VBLAST_SS_SCENE_EVENT_H

#include <vblast_ss/base.h>
#include <vblast_ss/scene.h>

/** Kind of an event: a VBSS_SCENE_EVENT_ constant. */
typedef int32_t vbss_scene_event_kind;

/** The constants of #vbss_scene_event_kind. */
enum {
    /** Two bodies have come into contact, or a body with itself. */
    VBSS_SCENE_EVENT_TOUCH = 1,
    VBSS_SCENE_EVENT_PART = 2, /**< Two bodies in contact have separated. */
    /** A part of a step was truncated: the bodies moved as far as the guard allows, and the rest of
     * the part was left out (vbss_scene_statistics::clamped). The two bodies are those that the guard
     * found; 0: unknown, or the floor. */
    VBSS_SCENE_EVENT_TRUNCATED = 3,
    /* 4 is in logs only: VBSS_RECORD_EVENT_LOST. */
    /** Jaws have grasped a thread, a needle or a drain. */
    VBSS_SCENE_EVENT_GRASP = 5,
    VBSS_SCENE_EVENT_RELEASE = 6, /**< Jaws have opened and released a body. */
    /** A body was pulled out of the jaws. The value is the force of the jaws on it. */
    VBSS_SCENE_EVENT_TORN = 7,
    /** A body begins to slide through the jaws, or to turn in them. The value is the force of the jaws
     * on it. */
    VBSS_SCENE_EVENT_SLIP = 8,
    /** A grasp exceeded grasp_capacity, so the thread is not held. */
    VBSS_SCENE_EVENT_GRASP_LOST = 9,
    /** A thread was cut. The piece is 0 if the thread had no cuts left and stayed whole. */
    VBSS_SCENE_EVENT_CUT = 10,
    /** An instrument was exchanged. The id is its new #vbss_grasper_kind; the position is that of the
     * grasper's frame. */
    VBSS_SCENE_EVENT_EXCHANGED = 11,
    /** An instrument was not exchanged. The id is the wanted #vbss_grasper_kind. */
    VBSS_SCENE_EVENT_NOT_EXCHANGED = 12,
    /** A needle's tip has entered a wall (VBLAST: has gone through it). The value is the force of the
     * wall along the tip; 0 with method VBLAST, and where a fold of the wall came onto the needle. */
    VBSS_SCENE_EVENT_PUNCTURE = 13,
    VBSS_SCENE_EVENT_WITHDRAWN = 14, /**< The tip has left the hole backwards. */
    /** The needle and its swage have passed through the hole, and the thread follows. */
    VBSS_SCENE_EVENT_PASSED = 15,
    /** A hole exceeded hole_capacity, so the wall is not pierced. */
    VBSS_SCENE_EVENT_HOLE_LOST = 16,
    /** The swage has come back through the hole, and the needle is in it again. */
    VBSS_SCENE_EVENT_RETURNED = 17,
    VBSS_SCENE_EVENT_UNTHREADED = 18, /**< An end of a thread has left the hole. */
    /** Two bodies hold each other back: both bodies of #vbss_scene_blocker, its cause. Reported once
     * until they have moved freely again. */
    VBSS_SCENE_EVENT_BLOCKED = 19,
    /** Two bodies have moved freely for 0.1 s after BLOCKED. */
    VBSS_SCENE_EVENT_UNBLOCKED = 20,
    /** The rest of a step was left out for the bodies that did not come to its end, or a whole step
     * because too many waited (vbss_scene_statistics::paused). The two bodies are those that hold
     * each other back; 0: unknown, or the floor. Several groups of bodies of a step may each have
     * such an event; vbss_scene_statistics::time_paused counts the longest. */
    VBSS_SCENE_EVENT_PAUSED = 21,
    /** More steps than after the call before are suspended or have not begun: work waits for a later
     * call, and no time is left out (vbss_scene_statistics::behind, and `call_budget_us`). */
    VBSS_SCENE_EVENT_DEFERRED = 22,
    VBSS_SCENE_EVENT_CAUGHT_UP = 23, /**< No step waits any more after DEFERRED. */
    /** A step that two calls had suspended was completed without the budget of a call, because other bodies
     * waited (vbss_scene_statistics::overdue). This call took longer than it should. */
    VBSS_SCENE_EVENT_OVERDUE = 24,
    /** A thread begins to tear the wall at its hole (vbss_drain_config::tear_energy). Reported again after the
     * force has fallen below half of the one that tears. */
    VBSS_SCENE_EVENT_TEARING = 25,
    /** A thread has torn out: it has cut through the wall up to a free edge and left it there, and the hole
     * is gone. */
    VBSS_SCENE_EVENT_TORN_OUT = 26
};

/** Bits of `flags` of an event. */
enum {
    VBSS_SCENE_EVENT_FLAG_POSITION = 1 /**< The event has a position. */
};

/** An event of a scene. #vbss_scene_event_kind says which fields a kind uses. All numbers are finite. */
typedef struct vbss_scene_event {
    uint32_t struct_size;       /**< Bytes of this struct that the library filled. */
    vbss_scene_event_kind kind; /**< Kind of the event. */
    uint32_t body_a;            /**< Number of the first body; 0: the floor, or none. */
    uint32_t body_b;            /**< Number of the second body; 0: the floor, or none. */
    uint32_t id;                /**< Identifier, as the kind says; 0: none. */
    uint32_t flags;             /**< VBSS_SCENE_EVENT_FLAG_ bits. */
    /** vbss_scene_statistics::steps after the call of #vbss_scene_step that reported the event. An event
     * between two steps has the number of the step before. */
    uint64_t step;
    double time;       /**< vbss_scene_statistics::time after that call, s. */
    double value;      /**< Value, in the unit of the kind; 0: the kind has none. */
    double arc_length; /**< Arc length along a thread or needle, m; 0: the kind has none. */
    /** Position in the world, m; zero without VBSS_SCENE_EVENT_FLAG_POSITION. */
    double position[3];
} vbss_scene_event;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Takes the oldest events out of the scene's list, in the order in which they happened. Events beyond
 * `capacity` stay in the list. When the call writes fewer events than `capacity`, the list is empty. The
 * call changes nothing else of the scene, and allocates nothing.
 *
 * @param scene        the scene
 * @param[out] events  receives the events, one every `struct_size` bytes; NULL with capacity 0 asks
 *         for the number of events in the list, and takes none
 * @param struct_size  `sizeof *events` as the caller was compiled
 * @param capacity     room in `events`, in events
 * @param[out] count   receives the number of events taken; with `events` NULL, of those in the list
 * @param[out] lost    receives the number of events that were lost since the last call that took
 *         events, because the list was full; NULL: not wanted, and the count goes on. A call with
 *         `events` NULL does not reset it.
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT (`count`, or `events` with a
 *         capacity), VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_take_events(vbss_scene *scene, vbss_scene_event *events,
                                            uint32_t struct_size, uint32_t capacity,
                                            uint32_t *count, uint64_t *lost);

#ifdef __cplusplus
}
#endif

#endif
