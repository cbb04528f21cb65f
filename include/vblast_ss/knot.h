/**
 * @file knot.h
 * @brief Finds the knot in a thread, and the throw that is being tied. Works on any polyline,
 *   without a scene.
 *
 * The input of a detector is the thread as one polyline, from the end of the tail limb over the
 * tissue to the end of the long limb (the needle's). It also has the tools as chains of capsules,
 * the object in their jaws, and the points where the thread enters the tissue. A *place* on the
 * polyline is a number: the index of a segment plus the fraction along it, from 0 to the number of
 * points - 1.
 *
 * Method TOPOLOGY (default) computes the signed winding of the thread about each finite tool in
 * every step. Spread over several steps, it computes the knot type of the thread closed at
 * infinity. It reduces the closed curve by moves that provably hit nothing, and projects it such
 * that all crossings are certain. It then decomposes the diagram into twist regions, which proves
 * the type, and compares exact invariants. A throw of k wraps closes to the torus knot T(2, 2 k +
 * 1), and stacked throws to the connected sum. See docs/explanation/knots.md.
 *
 * Method PROJECTION is that of VBLaST-SS (Qi et al. 2017, section 5). It projects the thread along
 * a tool, finds loops round the tool by an even-odd test, and a segment that crosses them.
 * docs/explanation/paper-knots.md describes it and its errors.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_KNOT_H
#define VBLAST_SS_KNOT_H

#include <vblast_ss/base.h>

/** Finds knots in a thread, step by step. */
typedef struct vbss_knot_detector vbss_knot_detector;

/** Method of a detector: a VBSS_KNOT_METHOD_ constant. */
typedef int32_t vbss_knot_method;

/** The constants of #vbss_knot_method. */
enum {
    VBSS_KNOT_METHOD_TOPOLOGY = 0,  /**< Winding numbers, and the topology of the closed thread. */
    VBSS_KNOT_METHOD_PROJECTION = 1 /**< Loops in a projection, as in the paper. */
};

/** Configuration of a detector. Fill it with #vbss_knot_detector_config_init, then change fields. */
typedef struct vbss_knot_detector_config {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    vbss_knot_method method; /**< Method; default VBSS_KNOT_METHOD_TOPOLOGY. */
    /** Largest number of points of the polyline, 2 to 8192; default 1024. */
    uint32_t point_capacity;
    uint32_t tool_capacity; /**< Largest number of tools, 0 to 16; default 4. */
    /** Largest number of crossings of a diagram before it is simplified, 8 to 2048; default 512. A
     * quarter as many may remain afterwards. */
    uint32_t crossing_capacity;
    /** Largest number of directions of projection to try, 1 to 64; default 6. */
    uint32_t direction_limit;
    /** Number of directions in which the ends are closed besides straight outward, 0 to 16; default
     * 8. */
    uint32_t closure_count;
    /** Largest number of these closures that may contradict the outward closure, 0 to 16; default
     * 2. With more an end lies inside the knot, and the verdict is uncertain. */
    uint32_t closure_tolerance;
    /** TOPOLOGY: largest number of operations (about a nanosecond each) in a step, exceeded at most
     * by the last indivisible operation, 100 to 1e9; default 8000. */
    uint32_t step_budget;
    /** TOPOLOGY: number of steps from the start of a reading to the start of the next one, if the
     * first has ended; 0: read at events only; default 20. */
    uint32_t interval;
    /** Largest number of events of a step that are kept, 8 to 4096; default 64. */
    uint32_t event_capacity;
    uint32_t reserved; /**< Zero. */
    /** Largest length beyond the jaws with which the thread counts as held near its end, m, 0 to 1;
     * default 0.03. A longer one is a bight. */
    double tail_reach;
    /** Length below which a tail can slip back and undo its throw, m, 0 to 1; default 0.003. */
    double tail_least;
    /** Signed turns about a tool from which the thread is wrapped round it, 0.1 to 2; default 0.75.
     * The wrap ends a quarter of a turn lower. */
    double wrap_turns;
    /** Magnitude of a throw's slip measure from which it is a half hitch, 0 to 1; default 0.45. */
    double slip_limit;
    /** PROJECTION: position of the plane on the tool's axis, m from the tip towards the handle, -1
     * to 1; default -0.002, ahead of the tip. */
    double plane_offset;
    uint64_t seed; /**< PROJECTION: seed of the directions of its rays; default 1. */
} vbss_knot_detector_config;

/** Object in the jaws of a tool: a VBSS_KNOT_HELD_ constant. */
typedef int32_t vbss_knot_held;

/** The constants of #vbss_knot_held. */
enum {
    VBSS_KNOT_HELD_NOTHING = 0, /**< The jaws are empty. */
    VBSS_KNOT_HELD_THREAD = 1,  /**< The jaws hold the thread at a place. */
    /** The jaws hold the needle, which is at the last point of the polyline. */
    VBSS_KNOT_HELD_NEEDLE = 2
};

/** A tool: a chain of capsules between successive points of its axis. */
typedef struct vbss_knot_tool {
    uint32_t point_count; /**< Number of points of the axis, 2 to 4. */
    vbss_knot_held held;  /**< Object in the jaws. */
    /** Points from the handle (or trocar) to the tip, m; successive points differ. */
    double axis[4][3];
    double radius[3];  /**< Radius of each capsule, m, 0 to 1. */
    double held_place; /**< THREAD: place of the jaws on the polyline; otherwise ignored. */
} vbss_knot_tool;

/** Input of a detector. Fill it with #vbss_knot_input_init, then set its fields. The library copies
 * all of it. */
typedef struct vbss_knot_input {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t point_count; /**< Number of points, 2 to point_capacity; the default 0 is refused. */
    /** x, y, z of each point from the tail's end on, m, each coordinate at most 1e3 in magnitude. */
    const double *points;
    /** Distance from one point to the next, bytes, at least 24; default 24. */
    uint32_t stride_bytes;
    uint32_t tool_count;         /**< Number of tools, 0 (default) to tool_capacity. */
    const vbss_knot_tool *tools; /**< Array of tool_count tools; may be NULL without tools. */
    /** Number of points where the thread goes through tissue. 0 (default): not known; 1: one point;
     * 2: in at the first, out at the second. Without tissue no throw is stray, and throws are
     * listed in the order in which they nest. */
    uint32_t hole_count;
    /** 1: the points start at the long limb's end, and places count from there; default 0. */
    uint32_t reversed;
    double holes[2][3]; /**< Positions of the holes, m. */
    /** Places of the holes on the polyline; negative (default): the place nearest to `holes`. */
    double hole_places[2];
    /** Direction away from the knot into the tissue, of any length; zero (default): from the middle
     * of the thread to the middle of the holes. */
    double away[3];
    /** 1: the thread may have passed through itself or a tool since the last step, for example
     * without a collision guard, so the topology is read again; default 0. */
    uint32_t may_have_passed;
    uint32_t reserved; /**< Zero. */
} vbss_knot_input;

/** Certainty of a throw: a VBSS_KNOT_VERDICT_ constant. Each verdict is revoked, with an event,
 * when the geometry no longer shows it. */
typedef int32_t vbss_knot_verdict;

/** The constants of #vbss_knot_verdict. */
enum {
    VBSS_KNOT_VERDICT_NONE = 0,     /**< There is no throw. */
    VBSS_KNOT_VERDICT_WRAPPING = 1, /**< The thread winds round a tool. */
    VBSS_KNOT_VERDICT_PASSED = 2,   /**< The throw is tied if the tools withdraw with their load. */
    VBSS_KNOT_VERDICT_FORMED = 3,   /**< The ends have passed through; invariants agree. */
    /** The type is proved, the ends are clear, the order is known. */
    VBSS_KNOT_VERDICT_CERTIFIED = 4,
    VBSS_KNOT_VERDICT_UNCERTAIN = 5 /**< The verdict is uncertain; `reason` says why. */
};

/** Reason for an uncertain reading: a VBSS_KNOT_REASON_ constant. */
typedef int32_t vbss_knot_reason;

/** The constants of #vbss_knot_reason. */
enum {
    VBSS_KNOT_REASON_NONE = 0,       /**< The reading is certain. */
    VBSS_KNOT_REASON_ENDS = 1,       /**< Closures differ: an end lies inside the knot. */
    VBSS_KNOT_REASON_DEGENERATE = 2, /**< The thread touches itself in every projection. */
    /** The diagram has more crossings than the detector's capacity, or is too wide for the Jones
     * polynomial that must confirm the result. */
    VBSS_KNOT_REASON_CAPACITY = 3,
    VBSS_KNOT_REASON_CONFLICT = 4 /**< Twist regions and invariants differ. */
};

/** Name of a knot; its mirror image has the same name. A VBSS_KNOT_NAME_ constant. */
typedef int32_t vbss_knot_name;

/** The constants of #vbss_knot_name. Numbers are the wraps of the throws. After "=" the next throw
 * has the opposite handedness, after "x" the same one. */
enum {
    VBSS_KNOT_NAME_NONE = 0,            /**< There is no knot. */
    VBSS_KNOT_NAME_SINGLE = 1,          /**< One throw of one wrap: 3_1. */
    VBSS_KNOT_NAME_DOUBLE = 2,          /**< One throw of two wraps, the surgeon's first: 5_1. */
    VBSS_KNOT_NAME_TRIPLE = 3,          /**< One throw of three wraps: 7_1. */
    VBSS_KNOT_NAME_SQUARE = 4,          /**< Square knot, 1=1. */
    VBSS_KNOT_NAME_GRANNY = 5,          /**< Granny knot, 1x1. */
    VBSS_KNOT_NAME_SURGEONS = 6,        /**< Surgeon's knot, 2=1. */
    VBSS_KNOT_NAME_SURGEONS_GRANNY = 7, /**< Granny form of the surgeon's knot, 2x1. */
    VBSS_KNOT_NAME_FLS = 8,             /**< The FLS knot, 2=1=1. */
    /** Another stack of throws; see #vbss_knot_detector_get_notation. */
    VBSS_KNOT_NAME_STACK = 9,
    VBSS_KNOT_NAME_OTHER = 10 /**< A knot that is not a stack of throws. */
};

/** Bits for the differences of a knot from the FLS knot 2=1=1. */
enum {
    VBSS_KNOT_FAULT_FIRST = 1,      /**< The first throw does not have two wraps. */
    VBSS_KNOT_FAULT_LATER = 2,      /**< A later throw does not have one wrap. */
    VBSS_KNOT_FAULT_FEW = 4,        /**< There are fewer than three throws. */
    VBSS_KNOT_FAULT_MANY = 8,       /**< There are more than three throws. */
    VBSS_KNOT_FAULT_GRANNY = 16,    /**< A throw has the same handedness as the one before. */
    VBSS_KNOT_FAULT_STRAY = 32,     /**< There is a knot in one limb alone. */
    VBSS_KNOT_FAULT_HITCH = 64,     /**< A throw has turned into a half hitch, which slides. */
    VBSS_KNOT_FAULT_ORDER = 128,    /**< The order of the throws is not known. */
    VBSS_KNOT_FAULT_TYPE = 256,     /**< The knot is not a stack of throws. */
    VBSS_KNOT_FAULT_UNCERTAIN = 512 /**< The reading is uncertain. */
};

/** Bits of the flags of a throw. */
enum {
    VBSS_KNOT_THROW_LOCATED = 1, /**< Its places on the limbs are known. */
    /** Its position in the stack is known: sub-chains show it. In #vbss_knot_detector_step it is
     * also known if an earlier reading had the throws in this order and at most one was added. */
    VBSS_KNOT_THROW_ORDERED = 2,
    VBSS_KNOT_THROW_GRANNY = 4, /**< The throw has the same handedness as the throw before. */
    /** The throw lies in one limb alone and not round the other limb. */
    VBSS_KNOT_THROW_STRAY = 8,
    VBSS_KNOT_THROW_HITCH = 16, /**< |slip| is at least `slip_limit`. */
    /** The tail is shorter than tail_least, or the throw is undone if the tools withdraw. */
    VBSS_KNOT_THROW_REVOCABLE = 32
};

/** A throw of a knot. Throws are counted from the tissue outward. */
typedef struct vbss_knot_throw {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    vbss_knot_verdict verdict; /**< Certainty, FORMED or CERTIFIED. */
    int32_t wraps;             /**< Number of wraps, from 1 on. */
    int32_t handedness;        /**< +1 right-handed, -1 left-handed. */
    uint32_t flags;            /**< VBSS_KNOT_THROW_ bits. */
    uint32_t reserved;         /**< Zero. */
    double tail_places[2];     /**< LOCATED: first and last place on the tail limb, ascending. */
    double long_places[2];     /**< LOCATED: first and last place on the long limb, ascending. */
    /** LOCATED: (cT - cL) / (cT + cL), with the mean curvature cT of the tail limb and cL of the
     * long limb where the two cross, seen from all directions. 0: a flat half knot; +1: the tail is
     * hitched round a straight long limb; -1: the reverse. */
    double slip;
    double tail_length;   /**< LOCATED: length of thread between the throw and the tail's end, m. */
    uint64_t formed_step; /**< Step of the detector in which the throw was first found. */
    uint64_t reading_step; /**< Step of the input that last confirmed the throw. */
} vbss_knot_throw;

/** Winding of the thread about one tool. Both methods update it in every step. */
typedef struct vbss_knot_winding {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** 1: |turns| of the longest run has reached wrap_turns, and has not since fallen a quarter of
     * a turn below. */
    int32_t wrapped;
    /** Signed turns about the axis, seen from the tip to the handle, walking from the tail's end to
     * the long limb's. All thread beside the tool counts; thread beyond the tip or the handle does
     * not. */
    double turns;
    /** Turns of the run that winds most. A run is thread beside the tool without a gap. */
    double run_turns;
    double run_places[2];  /**< First and last place of that run. */
    double run_heights[2]; /**< Distance of these places from the tip along the axis, m. */
    /** Direction along the tool in which the run winds, from its end nearer to the tissue to the
     * other. +1: towards the tip, as a throw needs; -1: towards the handle, which ties nothing; 0:
     * less than the thread's width either way, or not wrapped. */
    int32_t sense;
    uint32_t runs; /**< Number of runs. */
} vbss_knot_winding;

/** State of a detector. */
typedef struct vbss_knot_state {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    vbss_knot_name name;  /**< Name of the knot. */
    /** Verdict of the least certain throw; UNCERTAIN when the reading is; NONE without a knot. */
    vbss_knot_verdict verdict;
    vbss_knot_reason reason; /**< Reason why the reading is uncertain. */
    uint32_t throw_count;    /**< Number of tied throws, at most 8. */
    uint32_t faults;         /**< Differences from the FLS knot: VBSS_KNOT_FAULT_ bits. */
    /** Verdict of the throw that is being tied: NONE, WRAPPING or PASSED. */
    vbss_knot_verdict next_verdict;
    int32_t next_wraps;      /**< Its wraps if the tools withdrew now; 0: no throw would be tied. */
    int32_t next_handedness; /**< Its handedness, +1 or -1; 0 without such a throw. */
    uint32_t next_tool;      /**< The tool that the thread winds round, from 0. */
    uint32_t loops;          /**< PROJECTION: loops round a tool that one segment crosses. */
    uint32_t undone;         /**< PROJECTION: number of crossings of loops that tie nothing. */
    /* The next fields describe the last finished reading by method TOPOLOGY, of the thread closed
     * straight outward. */
    uint32_t crossings;         /**< Number of crossings of the simplest diagram found. */
    int32_t certified;          /**< 1: the diagram was decomposed into twist regions. */
    int32_t signature;          /**< Signature sigma; -2 for the right-handed 3_1. */
    int32_t signature_tristram; /**< Levine-Tristram signature at 0.27 pi. */
    int64_t determinant;        /**< Determinant |Delta(-1)|. */
    /** Vassiliev invariant of degree 2 (coefficient of z^2 of the Conway polynomial). */
    int64_t v2;
    int64_t v3;                 /**< Vassiliev invariant of degree 3; 1 for the right-handed 3_1. */
    uint32_t closures;          /**< Number of other closures that were compared. */
    uint32_t closures_agreeing; /**< Number of other closures that gave the same result. */
    int32_t ends_free;          /**< 1: both ends are outermost, so that all closures agree. */
    uint32_t reserved;          /**< Zero. */
    /** Number of calls of #vbss_knot_detector_step and #vbss_knot_detector_judge. */
    uint64_t steps;
    uint64_t reading_step; /**< Step whose input the last reading used; 0: there was no reading. */
} vbss_knot_state;

/** Counts since creation or reset. */
typedef struct vbss_knot_detector_statistics {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t reserved;       /**< Zero. */
    uint64_t readings;       /**< Finished readings of the topology. */
    uint64_t closures;       /**< Closed curves that were read. */
    uint64_t certified;      /**< Closed curves that were decomposed into twist regions. */
    uint64_t uncertain;      /**< Readings that ended uncertain. */
    uint64_t projections;    /**< Diagrams that were made. */
    uint64_t degenerate;     /**< Diagrams rejected because a crossing was not certain. */
    uint64_t overflows;      /**< Diagrams rejected because of too many crossings. */
    uint64_t removed;        /**< Vertices removed by proved moves. */
    uint64_t work;           /**< Operations used by readings. */
    uint64_t most_step_work; /**< Largest number of operations in a step. */
    uint64_t most_work;      /**< Largest number of operations of a reading. */
    uint64_t revoked;        /**< Verdicts that were revoked. */
} vbss_knot_detector_statistics;

/** Kind of an event: a VBSS_KNOT_EVENT_ constant. */
typedef int32_t vbss_knot_event;

/** The constants of #vbss_knot_event. In the view three numbers follow each event; each comment
 * lists them after its colon. */
enum {
    VBSS_KNOT_EVENT_WRAPPED = 1,   /**< The thread winds round a tool: tool, 1 + (turns > 0), 0. */
    VBSS_KNOT_EVENT_UNWRAPPED = 2, /**< The thread no longer winds round a tool: tool, 0, 0. */
    VBSS_KNOT_EVENT_WRONG_DIRECTION = 3, /**< The thread winds towards the handle: tool, 0, 0. */
    /** A throw is tied as soon as the tools withdraw: tool, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_PASSED = 4,
    /** A throw is formed: its number from 0, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_FORMED = 5,
    /** A throw is certified: its number from 0, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_CERTIFIED = 6,
    /** A throw is gone or uncertain: number, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_REVOKED = 7,
    VBSS_KNOT_EVENT_STRAY = 8, /**< A knot lies in one limb: number, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_UNCERTAIN = 9, /**< The reading is uncertain: #vbss_knot_reason, 0, 0. */
    VBSS_KNOT_EVENT_READ = 10, /**< A reading of the topology has ended: throws, name, verdict. */
    VBSS_KNOT_EVENT_LOST = 11  /**< Events exceeded the capacity: number of lost events, 0, 0. */
};

/** An array of a detector: a VBSS_KNOT_VIEW_ constant. */
typedef int32_t vbss_knot_field;

/** The constants of #vbss_knot_field. */
enum {
    /** x 4 uint32_t: #vbss_knot_event and its three numbers, of the last step. */
    VBSS_KNOT_VIEW_EVENTS = 0,
    /** PROJECTION, x 4 uint32_t: tool, the two segments of the intersecting pair, 1 if the tool is
     * inside; all loops of the last step. */
    VBSS_KNOT_VIEW_LOOPS = 1
};

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
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_config_init(vbss_knot_detector_config *config,
                                                    uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_knot_detector_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_knot_detector_config vbss_knot_detector_config_default(void)
{
    vbss_knot_detector_config vbss_filled;
    (void)vbss_knot_detector_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills an input with the defaults; the host sets the points.
 *
 * @param[out] input   the input to fill
 * @param struct_size  `sizeof *input` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_input_init(vbss_knot_input *input, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_knot_input_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_knot_input vbss_knot_input_default(void)
{
    vbss_knot_input vbss_filled;
    (void)vbss_knot_input_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a detector without a history and allocates all memory that it needs.
 *
 * @param context        owner
 * @param config   configuration; NULL for the defaults
 * @param[out] detector  the new detector; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_create(vbss_context *context,
                                               const vbss_knot_detector_config *config,
                                               vbss_knot_detector **detector);

/**
 * Destroys a detector.
 *
 * @param detector  the detector; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_destroy(vbss_knot_detector *detector);

/**
 * Processes the thread and the tools of a step: updates the winding, works on the topology within
 * the work limit, begins a new reading when it is due, and reports changes as events. The call
 * allocates nothing.
 *
 * @param detector  the detector
 * @param input     the input; the same tools in the same order in every step
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY (points, tools), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; after
 *         an error the detector is unchanged
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_step(vbss_knot_detector *detector,
                                             const vbss_knot_input *input);

/**
 * Processes an input like #vbss_knot_detector_step, but without a work limit: it abandons an
 * unfinished reading and reads this input to the end.
 *
 * @param detector  the detector
 * @param input     the input
 * @return as #vbss_knot_detector_step
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_judge(vbss_knot_detector *detector,
                                              const vbss_knot_input *input);

/**
 * Resets a detector to its state after creation, with its statistics and its count of steps.
 *
 * @param detector  the detector
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_reset(vbss_knot_detector *detector);

/**
 * Returns the state of a detector.
 *
 * @param detector     the detector
 * @param[out] state   receives the state
 * @param struct_size  `sizeof *state` as the caller was compiled; fields that the library does not
 *         know become zero
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_state(vbss_knot_detector *detector,
                                                  vbss_knot_state *state, uint32_t struct_size);

/**
 * Returns one throw of the knot.
 *
 * @param detector     the detector
 * @param number       0 (nearest to the tissue) to throw_count - 1
 * @param[out] knot_throw  receives the throw
 * @param struct_size  `sizeof *knot_throw` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such throw)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_throw(vbss_knot_detector *detector, uint32_t number,
                                                  vbss_knot_throw *knot_throw,
                                                  uint32_t struct_size);

/**
 * Returns the winding of the thread about one tool.
 *
 * @param detector      the detector
 * @param tool          index of the tool, 0 to tool_count - 1 of the last input
 * @param[out] winding  receives the winding
 * @param struct_size   `sizeof *winding` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such tool)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_winding(vbss_knot_detector *detector, uint32_t tool,
                                                    vbss_knot_winding *winding,
                                                    uint32_t struct_size);

/**
 * Returns the knot in the notation of surgeons, such as "2=1=1": the wraps of each throw from the
 * tissue outward. "=" precedes a throw of opposite handedness, and "x" one of the same handedness.
 * "+" joins throws whose order is not known. "?" is a knot that is not a stack of throws, and ""
 * means that there is no knot.
 *
 * @param detector   the detector
 * @param[out] text  receives the text and a final zero
 * @param capacity   size of `text`, bytes; 32 always suffice
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_notation(vbss_knot_detector *detector, char *text,
                                                     uint64_t capacity);

/**
 * Returns a view of an array.
 *
 * @param detector     the detector
 * @param field        the array
 * @param[out] view    receives the view
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_view(vbss_knot_detector *detector,
                                                 vbss_knot_field field, vbss_view *view,
                                                 uint32_t struct_size);

/**
 * Returns counts since creation or reset.
 *
 * @param detector         the detector
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_statistics(vbss_knot_detector *detector,
                                                       vbss_knot_detector_statistics *statistics,
                                                       uint32_t struct_size);

/**
 * Saves the state of a detector, with an unfinished reading.
 *
 * @param detector      the detector
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of `bytes`
 * @param[out] written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_save(vbss_knot_detector *detector, uint8_t *bytes,
                                             uint64_t capacity, uint64_t *written);

/**
 * Restores a snapshot of a detector with the same configuration, completely or not at all. An
 * unfinished reading is repeated up to the point where it was.
 *
 * @param detector  the detector
 * @param bytes     the snapshot
 * @param count     its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: the snapshot is of another configuration),
 *         VBSS_ERROR_DATA_VERSION, VBSS_ERROR_CAPACITY (the snapshot exceeds the detector's
 *         capacity), VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on
 *         failure nothing has changed
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_restore(vbss_knot_detector *detector, const uint8_t *bytes,
                                                uint64_t count);

/**
 * Returns a hash of the detector's state; equal histories give equal hashes on every machine.
 *
 * @param detector   the detector
 * @param[out] hash  receives the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_knot_detector_get_hash(vbss_knot_detector *detector, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
