/**
 * @file scene.h
 * @brief A scene: threads, drains, graspers, other rigid bodies and a floor that touch, rub and are stepped together.
 *
 * Bodies are added to a scene and numbered from 1 on; body 0 is the world: the floor, and what is
 * pinned in space. A thread that was added belongs to the scene until it is removed: stepping, cutting,
 * restoring or destroying it alone is VBSS_ERROR_IN_SCENE, while attaching, moving and looking go on as
 * before; it is cut in the scene (#vbss_scene_cut_thread). So does a drain (drain.h), whose surface touches everything on
 * both of its sides, half the wall away from its middle, and itself; of method PAPER its edges alone do, and not each
 * other. Rigid bodies are sets of capsules; they are driven (move exactly as told), coupled (a proxy tied to a given pose
 * by a spring and a damper, so that what stops the thread stops the tool) or free. A grasper (grasper.h) is a coupled one
 * with jaws that hold threads, needles and walls of drains; of method PAPER a driven one. A needle (needle.h) is a free one:
 * its tip goes through the wall of a drain on which it presses hard enough, and leaves a hole that slides along it and on
 * along the thread behind (#vbss_scene_get_hole); of method PAPER it follows the first tool that has grasped it, and no force decides about holes.
 *
 * Method OURS: one system of equations for all bodies and contacts, unilateral contact with Coulomb
 * friction that sticks without creep, and a guard: no accepted step lets the axis of anything pass
 * through anything, but for a needle or a thread near its holes, what is held near the jaws that hold it, a thread near a pin on the
 * body that it is pinned to (#vbss_scene_pin_thread), and segments that are too near along a thread to touch, also across a cut until its ends have come
 * apart. Method PAPER is that of VBLaST-SS (Qi et al.
 * 2017): explicit steps, edge tests at both ends of a step, displacements as response, no friction, knots
 * held by pins: docs/paper-scene.md.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SCENE_H
#define VBLAST_SS_SCENE_H

#include <vblast_ss/base.h>
#include <vblast_ss/drain.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/needle.h>
#include <vblast_ss/thread.h>

/** A scene. */
typedef struct vbss_scene vbss_scene;

/** What to do when a step finds no acceptable state at once: a VBSS_MODE_ constant. */
typedef int32_t vbss_scene_mode;

/** The constants of #vbss_scene_mode. */
enum {
    /** A step has a limit of work and of attempts, so that it ends in time, and a call has one: see `work_limit` and
     * `slot_limit`. What is not done by then waits, and what would wait too long is counted in `paused`. Tight knots of
     * many throws slip a little early for it. */
    VBSS_MODE_REAL_TIME = 0,
    /** All the work it takes; halves as often as halving_limit allows, and is cut short only after that, which is
     * counted in `clamped`. For experiments. */
    VBSS_MODE_OFFLINE = 1
};

/** What adding a body does when the body overlaps another one or the floor: a VBSS_OVERLAP_ constant. */
typedef int32_t vbss_overlap_policy;

/** The constants of #vbss_overlap_policy. */
enum {
    VBSS_OVERLAP_WARN =
        0, /**< The body is added; a warning in the log names the other body and the depth. */
    VBSS_OVERLAP_REFUSE = 1, /**< VBSS_ERROR_OUT_OF_RANGE; nothing has changed. */
    VBSS_OVERLAP_ALLOW = 2   /**< The body is added without a check. */
};

/** How to make a scene. Fill it with #vbss_scene_config_init, then change what you need. */
typedef struct vbss_scene_config {
    uint32_t struct_size;      /**< Size of this struct in bytes, set by the init function. */
    vbss_method method;        /**< Default VBSS_METHOD_OURS; threads must have the same. */
    vbss_scene_mode mode;      /**< Default VBSS_MODE_REAL_TIME. */
    uint32_t thread_capacity;  /**< Most threads at a time, 0 to 64; default 4. */
    uint32_t node_capacity;    /**< Most nodes of all threads, 0 to 8192; default 1024. */
    uint32_t rigid_capacity;   /**< Most rigid bodies, graspers too, 0 to 256; default 4. */
    uint32_t capsule_capacity; /**< Most capsules of all of them, 0 to 4096; default 16. */
    uint32_t pin_capacity;     /**< Most pins at a time, 0 to 256; default 8. */
    uint32_t
        contact_capacity; /**< Most contacts that may close at a time, 0 to 65536; default 1024. */
    uint32_t candidate_capacity; /**< Most pairs looked at, 0 to 1e7; default 16384. */
    uint32_t event_capacity; /**< Most events of a step that are kept, 0 to 65536; default 256. */
    int32_t floor;           /**< 1: there is a floor, all that is above a plane; default 0. */
    double floor_normal[3];  /**< Up, of any length from 1e-100 to 1e100; default (0, 1, 0). */
    double floor_height;     /**< Of the plane along its normal, m, each at most 1e3; default 0. */
    double floor_friction;   /**< Coefficient, 0 to 10; default 0.3. */
    /** Coefficient of friction of threads with each other, 0 to 10; default 0.3 (silk on silk; the
     * literature has 0.1 to 0.4). */
    double thread_friction;
    /** Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default 2e5: 5 um at 1 N. */
    double contact_stiffness;
    /** Contacts are looked for within this distance beyond touching and what things may approach each other in the
     * step, m, 0 to 0.1; default 3e-5. More costs time, less costs retries. */
    double contact_margin;
    /** Largest stretch error that a step may leave, 1e-9 to 1e-1; default 1e-3. */
    double stretch_tolerance;
    /** Largest penetration that a step may leave, as a share of the diameter of the thinner one, 1e-3 to
     * 0.5; default 0.1. A state that has more may only have less afterwards. */
    double penetration_tolerance;
    uint32_t linearisation_limit; /**< Of an attempt, 1 to 100; default 12. */
    uint32_t
        state_limit; /**< Solves for the states of the contacts in a linearisation, 1 to 1000; default 36. */
    uint32_t halving_limit; /**< How often a step may be halved, 0 to 10; default 5. */
    /** REAL_TIME: attempts in a step after which what is left of it waits, 1 to 1000; default 3. Without a
     * work_limit nothing waits: what is left is tried once a part, and cut short where it would harm. */
    uint32_t attempt_limit;
    /** PAPER: passes of detection and response in a step, 1 to 1000; default 4. */
    uint32_t paper_pass_limit;
    /** Most places of threads in jaws at a time, 0 to 256; default 8. With them count those that jaws have let go
     * but are not clear of yet, and those that blades have cut, two ends each: without room they stay open. */
    uint32_t grasp_capacity;
    /** PAPER: distance kept beyond touching (the paper's eps_D), m, 0 to 1e-2; default 0. */
    double paper_thickness;
    /** REAL_TIME, method OURS: operations in a step after which nothing is searched for any longer. Forces of contacts
     * are taken as they have been found by then: they balance, but miss the law of contact by up to
     * vbss_scene_statistics::last_residual; lengths are found all the same, with a few solves beyond the limit. Where that
     * fails, where such forces put in more than 20 uJ that nothing has done the work for (1 mJ in a scene without
     * drains), or after attempt_limit attempts, the rest of the step is left out: everything waits for the next one, which
     * begins with smaller parts (vbss_scene_statistics::paused), and what is driven goes on from where it was stopped.
     * The first step of a scene has 32 times both limits between its attempts, because bodies may overlap as they were
     * placed; it never waits.
     * Without limit is the smallest part that halving_limit allows, until its states are not
     * found: then it is tried once more with as much for itself. Where a drain is, the smallest part has the limit as well, and what takes more
     * is halved three times more before it has none. An operation is what costs about as much as a product of
     * two 3x3 blocks; 250000 are some 0.5 ms of a core of 2.6 GHz (docs/contact.md). 0: no limit; default 250000. */
    uint32_t work_limit;
    uint32_t drain_capacity; /**< Most drains at a time, 0 to 16; default 1. */
    uint32_t
        hole_capacity; /**< Most holes of needles and threads in drains at a time, 0 to 256; default 16. */
    /** REAL_TIME with a work_limit, method OURS: operations in a call of #vbss_scene_step. A step that takes more waits
     * where it is, and the next call goes on with it, to the bits that it would have come to; with what that has left
     * it begins the next step. So bodies are up to two steps behind after a call (vbss_scene_statistics::behind), some of
     * them by a part of a step; what is farther behind is left out and counted in `paused`. Where graspers, driven bodies
     * and attachments are told to go meanwhile is for the next step. A host that changes anything else while a step waits
     * ends it, which is counted there, too, and the next 1000 do not wait. Beyond the limit a call does what follows at
     * the end of a step, and what the guard has refused. 0: a call makes its step, all of it; default 210000. */
    uint32_t slot_limit;
    /** Largest speed of any point of a driven or coupled body, or of a grasper, on the way to its target, m/s, 0 to 1e6; 0: no
     * limit; default 20. A body approaches a target that is farther away at this speed, over several steps. So a pose in the
     * wrong unit, or a device that jumps, causes no long step and no extreme force. Method OURS only. Logs and snapshots store
     * the limit, and a scene with another one rejects them. One exception: scenes without a limit and with the default limit
     * accept each other's snapshots. */
    double speed_limit;
    vbss_overlap_policy overlap; /**< Default VBSS_OVERLAP_WARN. */
    uint32_t reserved;           /**< 0. */
} vbss_scene_config;

/** The deepest overlap of a body. */
typedef struct vbss_overlap {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t body;        /**< Number of the other body; 0: the floor, or none if depth is 0. */
    double depth;         /**< How far the two surfaces are inside each other, m; 0: no overlap. */
} vbss_overlap;

/** How a rigid body moves: a VBSS_RIGID_ constant. */
typedef int32_t vbss_rigid_kind;

/** The constants of #vbss_rigid_kind. */
enum {
    VBSS_RIGID_DRIVEN = 0,  /**< Exactly as told; stopped only by the guard. */
    VBSS_RIGID_COUPLED = 1, /**< A proxy, tied to the pose it is told by a virtual coupling. */
    VBSS_RIGID_FREE = 2     /**< As forces say. */
};

/** One capsule of a rigid body, in the frame of the body. */
typedef struct vbss_capsule {
    double begin[3]; /**< An end of the axis, m. */
    double end[3];   /**< The other; may be the same: a ball. */
    double radius;   /**< m, 1e-6 to 1. */
} vbss_capsule;

/** How to make a rigid body. Fill it with #vbss_rigid_config_init, then change what you need. */
typedef struct vbss_rigid_config {
    uint32_t struct_size;         /**< Size of this struct in bytes, set by the init function. */
    vbss_rigid_kind kind;         /**< Default VBSS_RIGID_DRIVEN. */
    uint32_t capsule_count;       /**< 1 to 256. */
    uint32_t reserved;            /**< Zero. */
    const vbss_capsule *capsules; /**< capsule_count of them; copied. */
    double position[3]; /**< Of the origin of the frame, m, each at most 1e3; default 0. */
    double
        orientation[4]; /**< w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0. */
    double velocity[3]; /**< Of the origin, m/s, each at most 1e5; COUPLED, FREE; default 0. */
    /** rad/s, each at most 1e6; COUPLED, FREE; default 0. A body turns by a quarter of a turn in a part of a
     * step at most: a faster one slows down. */
    double angular_velocity[3];
    /** Of the body, kg, 1e-9 to 1e3; default 0.02. It is spread over the capsules as if they were solid and
     * of one material; overlaps count twice. */
    double mass;
    double gravity[3]; /**< m/s^2, each at most 1e6; default 0: hands carry their tools. */
    double
        friction; /**< Coefficient with all others, 0 to 10; default 0.15. Of two bodies the geometric mean counts. */
    double stiffness;         /**< COUPLED: N/m, 0 to 1e9; default 2000. */
    double damping;           /**< COUPLED: N s/m, 0 to 1e6; default 5. */
    double turning_stiffness; /**< COUPLED: N m/rad, 0 to 1e9; default 2. */
    double turning_damping;   /**< COUPLED: N m s/rad, 0 to 1e6; default 0.005. */
} vbss_rigid_config;

/** Where a rigid body is and what acts on it. */
typedef struct vbss_rigid_state {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_rigid_kind kind;         /**< As it was made. */
    double position[3];           /**< Of the origin of its frame, m. */
    double orientation[4];        /**< w, x, y, z; body to world. */
    double velocity[3];           /**< Of the origin, m/s. */
    double angular_velocity[3];   /**< World frame, rad/s. */
    double target_position[3];    /**< Where it was told to be. */
    double target_orientation[4]; /**< The same. */
    /** What the hand feels, N: the opposite of the coupling's force; of a driven body the sum of its
     * contacts and pins. Zero for a free body. */
    double hand_force[3];
    double hand_torque[3];    /**< The same about the origin of its frame, N m. */
    double contact_force[3];  /**< Of all contacts and pins on it in the last step, N. */
    double contact_torque[3]; /**< The same about the origin of its frame, N m. */
} vbss_rigid_state;

/** An array of a scene: a VBSS_SCENE_VIEW_ constant. */
typedef int32_t vbss_scene_field;

/** The constants of #vbss_scene_field. Contacts are those that carried a force at the end of the last
 * step, in the order of their features; of method PAPER, those that were responded to. */
enum {
    /** x 5 uint32_t: #vbss_contact_kind, body a, feature a, body b, feature b. A feature is a segment or a
     * node of a thread, a capsule of a rigid body (times two plus its end, where an end is meant), a node, a triangle or a
     * side of a drain, 0 of the floor. Sides of a drain's triangles are numbered each once, in the order of their two
     * nodes, the lower node first. */
    VBSS_SCENE_VIEW_CONTACTS = 0,
    VBSS_SCENE_VIEW_CONTACT_POINTS = 1,  /**< x 3: between the two surfaces, m. */
    VBSS_SCENE_VIEW_CONTACT_NORMALS = 2, /**< x 3: unit, from b to a. */
    /** x 3: of b on a, N. Where a search for contact states ran out of work, those with which all bodies balance: they miss the law by
     * the residual, and may pull. */
    VBSS_SCENE_VIEW_CONTACT_FORCES = 3,
    VBSS_SCENE_VIEW_CONTACT_GAPS =
        4,                     /**< Distance of the surfaces, negative when they overlap, m. */
    VBSS_SCENE_VIEW_EVENTS = 5 /**< x 4 uint32_t: #vbss_event_kind, two bodies, a number. */
};

/** Which features a contact is between: a VBSS_CONTACT_ constant. */
typedef int32_t vbss_contact_kind;

/** The constants of #vbss_contact_kind. */
enum {
    VBSS_CONTACT_SEGMENTS = 0,        /**< Two segments of threads. */
    VBSS_CONTACT_NODE_CAPSULE = 1,    /**< A smoothed point of a fine thread, and a capsule. */
    VBSS_CONTACT_SEGMENT_CAPSULE = 2, /**< A segment of a coarse thread, and a capsule. */
    VBSS_CONTACT_NODE_FLOOR = 3,      /**< A node of a thread, and the floor. */
    VBSS_CONTACT_CAPSULES = 4,        /**< Two capsules of different bodies. */
    VBSS_CONTACT_CAPSULE_FLOOR = 5,   /**< An end of a capsule, and the floor. */
    VBSS_CONTACT_GRASP =
        6, /**< One of the three points of a thread that a grasper holds, three times the
                            * place of the grasp among all plus which of them; or of a needle or a drain, which of them;
                            * and 0 of the grasper. */
    /** A node of a thread, an end of a capsule or a node of a drain, and a triangle of a drain. */
    VBSS_CONTACT_POINT_FACE = 7,
    /** A segment of a thread, a capsule or a side of a drain's triangle, and a side of a drain's triangle. */
    VBSS_CONTACT_SIDES = 8,
    VBSS_CONTACT_DRAIN_FLOOR = 9, /**< A node of a drain, and the floor. */
    /** A needle or a thread, the place of the hole among all; and 0 of the drain. The normal is along the suture. PAPER:
     * where particles were moved. */
    VBSS_CONTACT_HOLE = 10
};

/** What happened in a step: a VBSS_EVENT_ constant. */
typedef int32_t vbss_event_kind;

/** The constants of #vbss_event_kind. */
enum {
    VBSS_EVENT_TOUCH = 1, /**< Two bodies that did not touch do; a body with itself too. */
    VBSS_EVENT_PART = 2,  /**< Two bodies that touched do no longer. */
    VBSS_EVENT_CLAMPED =
        3, /**< A step was cut short, or paused; the number is the share of it in 1/65536 that was lost. */
    VBSS_EVENT_LOST = 4, /**< Events beyond the capacity; the number says how many. */
    /** Jaws hold a thread, a needle or a wall: that, grasper, arc length in um; of a wall a triangle that they hold. */
    VBSS_EVENT_GRASP = 5,
    VBSS_EVENT_RELEASE = 6, /**< They have opened and let it go: the same. */
    VBSS_EVENT_TORN = 7,    /**< It was pulled out of them: the same. */
    VBSS_EVENT_SLIP = 8,    /**< It begins to slide through them, or to turn in them: the same. */
    VBSS_EVENT_GRASP_LOST = 9, /**< Beyond grasp_capacity: thread, grasper; it is not held. */
    /** A thread, its new piece, and the arc length of the cut in um; 0 in place of the piece: it would have been cut,
     * but all its cuts are made. */
    VBSS_EVENT_CUT = 10,
    VBSS_EVENT_EXCHANGED = 11,     /**< A grasper, 0, and what it is now. */
    VBSS_EVENT_NOT_EXCHANGED = 12, /**< A grasper, 0, and what it was to be. */
    VBSS_EVENT_PUNCTURE =
        13, /**< A needle's tip enters a wall, PAPER: has gone through: needle, drain, id of the hole (vbss_scene_get_hole). */
    VBSS_EVENT_WITHDRAWN = 14, /**< The tip has left the hole the way it came: the same. */
    VBSS_EVENT_PASSED =
        15, /**< The needle has gone through it, swage and all; the thread follows: the same. */
    VBSS_EVENT_HOLE_LOST = 16, /**< Beyond hole_capacity the wall holds: needle, drain, 0. */
    VBSS_EVENT_RETURNED =
        17, /**< The swage has come back through it: the needle is in it again: the same. */
    VBSS_EVENT_UNTHREADED =
        18, /**< An end of a thread has left the hole: thread, drain, id of the hole. */
    /** Bodies are held back, for the first time since a while: the two bodies of #vbss_blocker, its cause. */
    VBSS_EVENT_BLOCKED = 19,
    VBSS_EVENT_UNBLOCKED = 20 /**< They have moved freely for 0.1 s: the same numbers. */
};

/** Counters since creation, and figures of the last step. Method PAPER counts its passes of detection and
 * response in `attempts`, pairs tested in `guard_pairs`, those listed last in `rows`, and steps whose last pass still
 * moved something in `loose_states`; its stretch error is max |length / rest length - 1|. */
typedef struct vbss_scene_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t contacts;    /**< That carry a force after the last step. */
    uint32_t rows;        /**< That might have closed in its last part. */
    uint32_t separators;  /**< Blocks of the system in its last part that contacts take part in. */
    uint64_t steps;       /**< Calls of #vbss_scene_step that succeeded. */
    uint64_t parts;       /**< Accepted parts of steps; equal to steps if none was divided. */
    uint64_t attempts;    /**< Tries, rejected ones included. */
    uint64_t linearisations;  /**< Of all attempts. */
    uint64_t state_solves;    /**< Solves of the separators' system. */
    uint64_t patterns;        /**< How often its pattern was worked out; not part of the state. */
    uint64_t rejected_states; /**< Attempts rejected: states of the contacts not found. */
    uint64_t
        rejected_stretch; /**< Stretch error or shape not converged; a node of a drain went too far. */
    uint64_t rejected_depth;    /**< Penetration. */
    uint64_t rejected_guard;    /**< Something would have passed, or come too near. */
    uint64_t rejected_singular; /**< A pivot was too small, or numbers not finite. */
    uint64_t rejected_full;     /**< More candidates or contacts than there is room for. */
    uint64_t loose_states;  /**< Attempts accepted with up to 5 % of residual in the contact law. */
    uint64_t loose_stretch; /**< Parts accepted with more stretch error than the tolerance. */
    uint64_t clamped;       /**< Parts cut short by the guard. */
    uint64_t
        recovering; /**< Parts accepted that began with too much penetration and have less now. */
    uint64_t guard_pairs; /**< Pairs that the guard has looked at: known to be apart, or tested. */
    double last_penetration;   /**< Largest after the last step, m. */
    double penetration;        /**< Largest so far, m. */
    double last_stretch_error; /**< max |length / rest length - 1 - T / EA| after the last step. */
    double stretch_error;      /**< Largest so far. */
    double last_residual;      /**< Of the contact law after the last part, N. */
    double time;               /**< Sum of the lengths of the steps, s, with `time_paused`. */
    uint64_t operations;       /**< Of all steps, as work_limit counts them; method OURS. */
    uint64_t most_operations;  /**< Of a step. */
    uint64_t paused;           /**< REAL_TIME: steps of which a part, or all, was left out. */
    double time_paused;        /**< Of those parts together, s: simulated time that was lost. */
    uint64_t deferred; /**< Calls after which a step waited, or had not begun; see slot_limit. */
    uint32_t behind;   /**< Such steps after the last call, 0 to 2. */
    uint32_t reserved; /**< Zero. */
} vbss_scene_statistics;

/** Why bodies are held back: a VBSS_BLOCKER_ constant. */
typedef int32_t vbss_blocker_cause;

/** The constants of #vbss_blocker_cause. */
enum {
    VBSS_BLOCKER_WORK = 0,      /**< The limit of work of the step was exhausted. */
    VBSS_BLOCKER_COLLISION = 1, /**< The bodies would pass through each other, or come too near. */
    VBSS_BLOCKER_PENETRATION =
        2,                       /**< The bodies penetrate each other by more than the tolerance. */
    VBSS_BLOCKER_CONTACT = 3,    /**< No contact forces were found that obey the contact law. */
    VBSS_BLOCKER_CONVERGENCE = 4 /**< The motion of the body did not converge. */
};

/** Two bodies that hold back each other, and all bodies that touch them. A step that fails is held back
 * for the bodies that are connected with them by contacts, grasps, holes or pins. All other bodies move
 * on. */
typedef struct vbss_blocker {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    vbss_blocker_cause cause; /**< Why, in the last step that held them back. */
    uint32_t body_a;          /**< Number of a body; 0: unknown. */
    uint32_t body_b;          /**< Number of the other; 0: the floor, or no second body. */
    double since;             /**< Simulated time at which they were first held back, s. */
    double lost_time;         /**< Simulated time that they have lost since then, s. */
    double depth; /**< Their deepest overlap in the last step that held them back, m; 0: none. */
} vbss_blocker;

/** A hole of a needle or a thread in a drain. */
typedef struct vbss_hole {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t id;          /**< From 1 on, in the order in which they were made; none twice. */
    uint32_t needle;      /**< Its number in the scene; 0: a thread is in it. */
    uint32_t drain;       /**< The same. */
    uint32_t triangle;    /**< Of the drain. */
    uint32_t outward;     /**< 1: the tip went through from inside; 0: from outside. */
    double weights[3];    /**< Of the triangle's nodes in the hole. */
    double
        rest_position[3]; /**< Of that point of the drain at rest, m: VBSS_DRAIN_REST_POSITIONS. */
    double position[3];   /**< Where it is, in the middle of the wall, m. */
    double direction
        [3]; /**< Unit: of the suture there, toward the needle's tip, or the thread's begin. */
    /** Of what is in it, m: of the needle from the tip (below 0 that is still before the middle), of the thread from its
     * begin. Round the swage it may be up to 0.2 mm beyond an end. */
    double arc_length;
    double friction;   /**< On the suture, along `direction`, N. */
    double force[3];   /**< On the suture, N. */
    uint32_t thread;   /**< Number of the thread that is in it; 0: a needle is. */
    uint32_t reserved; /**< Zero. */
} vbss_hole;

/** A place of a thread, of a needle, or of a drain, that a grasper holds. */
typedef struct vbss_grasp {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t thread;      /**< Number of the thread, the needle or the drain in the scene. */
    double
        arc_length; /**< Of the middle of what is held, along the thread, unstretched; from the needle's tip; m. */
    double position[3]; /**< Where that is, m. */
    /** Of the jaws on what they hold in the last step, N: while it slides, above the limit by what the clamp gains in
     * a step. */
    double force[3];
    double limit; /**< Largest force along their faces that they bear, N; PAPER: 0. */
    double slid;  /**< So far it has slid through them since it was taken, m. */
} vbss_grasp;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_config_init(vbss_scene_config *config, uint32_t struct_size);

/**
 * Creates a scene without bodies. All memory that steps need is allocated here.
 *
 * @param context     owner
 * @param config      how; NULL for the defaults
 * @param[out] scene  the new scene; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_create(vbss_context *context, const vbss_scene_config *config,
                                       vbss_scene **scene);

/**
 * Destroys a scene with its rigid bodies and pins; its threads, drains and graspers are the host's again.
 *
 * @param scene  the scene; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_destroy(vbss_scene *scene);

/**
 * Adds a thread of the same context, which belongs to the scene until it is removed. Its scene also has room, from
 * then on, for each piece that may yet be cut from it: that of a thread, and of two nodes. The cuts left belong to the
 * scene while a thread of the family does.
 * For an adaptive mesh there must be room for all of its node_capacity; nodes that threads added later take are no
 * longer there for it. It adapts at the very end of steps: nodes and segments beyond a change are renumbered, with
 * pins, grasps and contacts in the views (docs/adaptive.md).
 *
 * @param scene      the scene
 * @param thread     the thread, of the scene's method, with a radius above 0
 * @param[out] body  its number in the scene, from 1 on, never used again
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_OUT_OF_RANGE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY (pieces
 *         included), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_add_thread(vbss_scene *scene, vbss_thread *thread, uint32_t *body);

/**
 * Adds a drain of the same context, which belongs to the scene until it is removed. What the scene's steps need for it is
 * allocated here. Features of it that are within three walls of each other along its surface do not touch. How often a part
 * is linearised and halved is the scene's to say; the drain's limits are for steps of its own.
 *
 * @param scene      the scene
 * @param drain      the drain, of the scene's method
 * @param[out] body  its number in the scene, from 1 on, never used again
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_OUT_OF_RANGE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_add_drain(vbss_scene *scene, vbss_drain *drain, uint32_t *body);

/**
 * Fills a configuration of a rigid body with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_rigid_config_init(vbss_rigid_config *config, uint32_t struct_size);

/**
 * Adds a rigid body. A scene takes at most 4096 bodies, threads as well, in its life.
 *
 * @param scene      the scene
 * @param config     how
 * @param[out] body  its number in the scene, from 1 on, never used again
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_add_rigid(vbss_scene *scene, const vbss_rigid_config *config,
                                          uint32_t *body);

/**
 * Adds a needle, where it is and as it moves: it is free. A thread that is pinned to it (#vbss_scene_pin_thread) with its
 * first node at the swage is swaged to it. Stepping or placing it alone, restoring or destroying it is
 * VBSS_ERROR_IN_SCENE until it is removed. Method PAPER: it follows the tool whose jaws have closed on it first, exactly; a free
 * one flies, lies on the floor, and stays in the walls of drains that it goes through (docs/paper-needle.md).
 *
 * @param scene      the scene
 * @param needle     a needle of the same context and method
 * @param[out] body  its number
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_IN_SCENE, VBSS_ERROR_OUT_OF_RANGE (another method), VBSS_ERROR_CAPACITY (bodies or capsules),
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_add_needle(vbss_scene *scene, vbss_needle *needle, uint32_t *body);

/**
 * Adds a grasper of the same context, which belongs to the scene until it is removed: its tip where it was told to
 * go last, at rest. It takes the place of a rigid body with four capsules.
 *
 * @param scene      the scene
 * @param grasper    the grasper, of the scene's method
 * @param[out] body  its number in the scene, from 1 on, never used again
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_OUT_OF_RANGE (another method; the trocar is nearer to the tip than the bent jaws reach
 *         aside), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_add_grasper(vbss_scene *scene, vbss_grasper *grasper,
                                            uint32_t *body);

/**
 * A place of a thread that a grasper holds.
 *
 * @param scene        the scene
 * @param tool         number of the grasper in the scene
 * @param index        which of what it holds, from 0 on
 * @param[out] grasp   receives the numbers
 * @param struct_size  `sizeof *grasp` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (it does not hold so many)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_grasp(vbss_scene *scene, uint32_t tool, uint32_t index,
                                          vbss_grasp *grasp, uint32_t struct_size);

/**
 * A hole of a needle or a thread in a drain, as it is after the last step.
 *
 * @param scene        the scene
 * @param index        which, from 0 on; their order may change with the next step
 * @param[out] hole    receives the numbers
 * @param struct_size  `sizeof *hole` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (there are not so many)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_hole(vbss_scene *scene, uint32_t index, vbss_hole *hole,
                                         uint32_t struct_size);

/**
 * A pair of bodies that holds back others, in the order in which they began. A pair is listed until it has
 * moved freely for 0.1 s of simulated time. At most 16 are listed. Method OURS.
 *
 * @param scene         the scene
 * @param index         which, from 0 on
 * @param[out] blocker  receives the numbers
 * @param struct_size   `sizeof *blocker` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (there are not so many)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_blocker(vbss_scene *scene, uint32_t index,
                                            vbss_blocker *blocker, uint32_t struct_size);

/**
 * Makes a hole where a thread or a needle already goes through the wall of a drain: as a host lays out a stitch. From then on
 * it is as if a needle had made it.
 *
 * @param scene       the scene, of method OURS
 * @param body        the thread or the needle; a thread of three nodes at least
 * @param arc_length  of it there, m: the hole is at the place downhill from there that is nearest; 0 to its length
 * @param drain       the drain
 * @param triangle    of the drain: VBSS_DRAIN_TRIANGLES
 * @param weights     of its nodes in the hole: three, from 0 to 1, with the sum 1
 * @param[out] id     receives its name; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (a value; no such body; the
 *         suture is farther from there than it would touch the wall; a hole of the same suture is less than its
 *         diameter from there), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY
 *         (hole_capacity), VBSS_ERROR_OUT_OF_MEMORY (only while a step waits) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_make_hole(vbss_scene *scene, uint32_t body, double arc_length,
                                          uint32_t drain, uint32_t triangle, const double *weights,
                                          uint32_t *id);

/**
 * Removes a body, with its pins and grasps. A thread, drain or grasper is the host's again; a grasper is then where it was
 * told to be.
 *
 * @param scene  the scene
 * @param body   its number, not 0
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (no such body) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_remove(vbss_scene *scene, uint32_t body);

/**
 * Says where a driven or coupled body, or the pose it is tied to, shall be at the end of the next step; it
 * moves there evenly in the step, turning the shortest way, and then stays. Of several calls before a step the last
 * counts. Between two steps it shall turn by less than half a turn.
 *
 * @param scene        the scene
 * @param body         a rigid body, neither a free one nor a grasper (#vbss_grasper_move)
 * @param position     of the origin of its frame, m, each at most 1e3
 * @param orientation  w, x, y, z, of any length from 1e-100 to 1e100; NULL leaves it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (no
 *         such body, or a value), VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_move_rigid(vbss_scene *scene, uint32_t body,
                                           const double position[3], const double *orientation);

/**
 * Pins a node of a thread to a point of a body; the node is taken there within the next step and then
 * moves with the body. OURS: the node's motion is eliminated in favour of the body's, which feels its
 * force, at any ratio of masses. PAPER (to keep a knot, pin the nearest node of both strands of a crossing), driven
 * bodies and the world: the node moves as the body does.
 * The node must not be held otherwise; on driven bodies and the world it becomes the end of a section, and
 * the pin is an attachment of the thread: who detaches that has a pin that holds nothing. The thread does not
 * touch the body within 1.6 times the distance of touching of the pin, along the thread.
 *
 * @param scene     the scene
 * @param thread    number of the thread in the scene
 * @param node      0 to its number of nodes - 1
 * @param body      number of a rigid body; 0: the world
 * @param point     m, in the frame of the body, each at most 1e3; NULL: where the node is now
 * @param[out] pin  names the pin, from 1 on, never used again
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (also:
 *         the node is held already), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (pins, or the thread's
 *         attachments), VBSS_ERROR_OUT_OF_MEMORY (only while a step waits) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_pin_thread(vbss_scene *scene, uint32_t thread, uint32_t node,
                                           uint32_t body, const double *point, uint32_t *pin);

/**
 * Removes a pin.
 *
 * @param scene  the scene
 * @param pin    its name
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (no such pin) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_unpin_thread(vbss_scene *scene, uint32_t pin);

/**
 * Cuts a thread of the scene in two where it is, with its pins, attachments and contacts: the part beyond the cut
 * becomes a body of its own, with node 0 at the cut. Room for as many pieces as cut_capacity allows was taken when the
 * thread was added, so nothing is allocated, but for a copy of the state during the call if a step waits. Pieces can be cut again. A cut within 1 % of a segment, or 1e-7 m, of
 * a node goes through the node, which the thread keeps with all that holds it. A cut within 0.2 mm of a hole that
 * the thread is in is made 0.2 mm beside it, where an end has left the hole. The ends at a cut do not touch each
 * other until they have come apart. Contacts in the views keep the numbers of before the cut until the next step.
 *
 * @param scene       the scene
 * @param thread      number of the thread in the scene
 * @param arc_length  of the cut from the thread's node 0, unstretched, m, within its length and not at an end
 * @param[out] piece  number of the new body, whose handle #vbss_scene_get_thread gives; also in an event
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (no such thread, or
 *         not within it), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (no cuts left; that is an event, too),
 *         VBSS_ERROR_OUT_OF_MEMORY (only while a step waits) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_cut_thread(vbss_scene *scene, uint32_t thread, double arc_length,
                                           uint32_t *piece);

/**
 * The handle of a thread in the scene, to look at it and to attach to it. That of a piece is destroyed when a state
 * from before its cut is restored, and lives again with one from after it.
 *
 * @param scene        the scene
 * @param body         number of the thread in the scene
 * @param[out] thread  its handle; NULL when there is no such thread
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_OUT_OF_RANGE (no such thread)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_thread(vbss_scene *scene, uint32_t body, vbss_thread **thread);

/**
 * Moves everything forward in time. Nothing is allocated. On failure the scene is as it was before the
 * step, but without events. With method PAPER the step of a thread or drain that has diverged fails;
 * see #vbss_thread_step and #vbss_drain_step for the bounds. If a call has ended a suspended step, or some
 * islands of a step, and the rest fails, that result stays: the call returns VBSS_OK, `behind` counts the rest, and
 * the next call returns the failure.
 *
 * @param scene  the scene
 * @param h      s, 1e-7 to 0.1
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_CAPACITY (contacts or candidates), VBSS_ERROR_ARITHMETIC_MODE
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_step(vbss_scene *scene, double h);

/**
 * Where a rigid body is and what acts on it.
 *
 * @param scene        the scene
 * @param body         its number
 * @param[out] state   receives the numbers
 * @param struct_size  `sizeof *state` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such rigid body)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_rigid(vbss_scene *scene, uint32_t body, vbss_rigid_state *state,
                                          uint32_t struct_size);

/**
 * A look at one of the scene's arrays.
 *
 * @param scene        the scene
 * @param field        which
 * @param[out] view    receives where the array is
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_view(vbss_scene *scene, vbss_scene_field field, vbss_view *view,
                                         uint32_t struct_size);

/**
 * The scene's counters.
 *
 * @param scene            the scene
 * @param[out] statistics  receives the numbers
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_statistics(vbss_scene *scene, vbss_scene_statistics *statistics,
                                               uint32_t struct_size);

/**
 * The deepest overlap of a body with another body or the floor, where they are now. An overlap counts if it is deeper than
 * `penetration_tolerance` of the scene's configuration allows after a step. The call leaves out the places where a thread is pinned
 * to the other body or begins at the end of a needle, and the body itself. It leaves out pairs of driven bodies, which a step does
 * not test until they have come apart. Contacts in jaws and holes count. The call compares all segments of the body with all
 * others, so it is for setting up a scene.
 *
 * @param scene         the scene
 * @param body          number of the body
 * @param[out] overlap  receives the overlap
 * @param struct_size   `sizeof *overlap` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (no such body), VBSS_ERROR_NULL_ARGUMENT or
 *         VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_overlap(vbss_scene *scene, uint32_t body, vbss_overlap *overlap,
                                            uint32_t struct_size);

/**
 * Saves the state of the scene and all its bodies, to go back to it or to go on elsewhere to the same
 * bits.
 *
 * @param scene         the scene
 * @param[out] bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of the buffer
 * @param[out] written  bytes of the state, also when it does not fit
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_save(vbss_scene *scene, uint8_t *bytes, uint64_t capacity,
                                     uint64_t *written);

/**
 * Restores a saved state into this scene or one made alike: the same bodies added in the same order. Cuts are part
 * of the state: they are undone, and made, as it says; but a piece that was removed cannot be, and a body that was
 * added after a cut has another number where nothing was cut. On failure the scene is as it was.
 *
 * @param scene  the scene
 * @param bytes  the state
 * @param count  its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_restore(vbss_scene *scene, const uint8_t *bytes, uint64_t count);

/**
 * XXH64 of the state of the scene and its bodies, counters included: equal states have equal hashes, on
 * every machine.
 *
 * @param scene      the scene
 * @param[out] hash  the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_scene_get_hash(vbss_scene *scene, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
