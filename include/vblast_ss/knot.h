/**
 * @file knot.h
 * @brief Which knot is in a thread, and which one is being tied. Works on any polyline, with no scene.
 *
 * A detector is shown the thread as one polyline, from the end of the tail limb over the tissue to the
 * end of the long limb (the needle's), with the tools as chains of capsules, what they hold, and where
 * the thread goes into the tissue. A *place* on the polyline is a number: that of a segment plus the
 * fraction along it, from 0 to the number of points - 1.
 *
 * Method TOPOLOGY (default): the signed winding of the thread about each finite tool in every step, and,
 * spread over steps, the knot type of the thread closed at infinity: reduced by moves that are proved to
 * hit nothing, read from a projection whose crossings are certain, taken apart into twist regions (which
 * is a proof of the type) and compared with exact invariants. A throw of k wraps closes to the torus knot
 * T(2, 2 k + 1), stacked throws to the connected sum. docs/knots.md.
 *
 * Method PROJECTION is that of VBLaST-SS (Qi et al. 2017, section 5): loops in the projection along a tool
 * that an even-odd test finds closed round it, and a segment that crosses them: docs/paper-knots.md, which
 * also says when it is wrong.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_KNOT_H
#define VBLAST_SS_KNOT_H

#include <vblast_ss/base.h>

/** A knot detector. */
typedef struct vbss_knot_detector vbss_knot_detector;

/** How knots are found: a VBSS_KNOT_ method constant. */
typedef int32_t vbss_knot_method;

/** The constants of #vbss_knot_method. */
enum {
    VBSS_KNOT_TOPOLOGY = 0,  /**< Winding, then the topology of the closed thread. */
    VBSS_KNOT_PROJECTION = 1 /**< Loops in a projection, as the paper does. */
};

/** How to make a detector. Fill it with #vbss_knot_config_init, then change what you need. */
typedef struct vbss_knot_config {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    vbss_knot_method method; /**< Default VBSS_KNOT_TOPOLOGY. */
    uint32_t point_capacity; /**< Most points of the polyline, 2 to 8192; default 1024. */
    uint32_t tool_capacity;  /**< Most tools, 0 to 16; default 4. */
    uint32_t
        crossing_capacity;    /**< Most crossings that a diagram may have before it is simplified, 8
                                     to 2048; default 512. A quarter of them may be left. */
    uint32_t direction_limit; /**< Directions of projection that are tried, 1 to 64; default 6. */
    /** Directions in which the ends are closed besides straight outward, 0 to 16; default 8. */
    uint32_t closure_count;
    /** Of these the most that may contradict the outward closure, 0 to 16; default 2. With more an end lies inside
     * the knot, and the verdict is uncertain. */
    uint32_t closure_tolerance;
    /** TOPOLOGY: operations (about a nanosecond each) that a step spends on it at most, but for the last
     * indivisible piece, 100 to 1e9; default 8000. */
    uint32_t work_limit;
    /** TOPOLOGY: a new reading of the topology begins this many steps after the last one began, if that has ended;
     * 0: at events only; default 20. */
    uint32_t interval;
    uint32_t event_capacity; /**< Most events of a step that are kept, 8 to 4096; default 64. */
    uint32_t reserved;       /**< Zero. */
    /** The thread is held near its end if what hangs beyond the jaws is shorter, m, 0 to 1; default
     * 0.03. Longer, it is a bight. */
    double tail_reach;
    /** A throw can be undone by its tail slipping back if that is shorter, m, 0 to 1; default 0.003. */
    double tail_least;
    /** Signed turns about a tool from which the thread is wrapped round it, 0.1 to 2; default 0.75. It ends
     * a quarter of a turn below. */
    double wrap_turns;
    /** |slip measure| of a throw from which it is a half hitch, 0 to 1; default 0.6. */
    double slip_limit;
    /** PROJECTION: where the plane crosses the tool's axis, m from the tip towards the handle, -1 to
     * 1; default -0.002, ahead of the tip. */
    double plane_offset;
    uint64_t seed; /**< PROJECTION: of the directions of its rays; default 1. */
} vbss_knot_config;

/** What a tool holds: a VBSS_KNOT_HELD_ constant. */
typedef int32_t vbss_knot_held;

/** The constants of #vbss_knot_held. */
enum {
    VBSS_KNOT_HELD_NOTHING = 0, /**< Empty jaws. */
    VBSS_KNOT_HELD_THREAD = 1,  /**< The thread, at a place. */
    VBSS_KNOT_HELD_NEEDLE = 2   /**< The needle, at the last point of the polyline. */
};

/** One tool: capsules between successive points of its axis. */
typedef struct vbss_knot_tool {
    uint32_t point_count; /**< Of the axis, 2 to 4. */
    vbss_knot_held held;  /**< What its jaws hold. */
    double axis[4][3]; /**< From the handle (or trocar) to the tip, m; successive points differ. */
    double radius[3];  /**< Of each capsule, m, 0 to 1. */
    double held_place; /**< THREAD: place on the polyline where the jaws are; otherwise ignored. */
} vbss_knot_tool;

/** What a detector is shown. Fill it with #vbss_knot_input_init, then change what you need. All of it is
 * copied. */
typedef struct vbss_knot_input {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    uint32_t point_count;  /**< 2 to point_capacity; the default 0 is refused. */
    const double *points;  /**< x, y, z of each, m, each at most 1e3; from the tail's end on. */
    uint32_t stride_bytes; /**< From one point to the next, at least 24; default 24. */
    uint32_t tool_count;   /**< 0 (default) to tool_capacity. */
    const vbss_knot_tool *tools; /**< tool_count of them; may be NULL when there are none. */
    /** 0 (default): it is not known where the thread goes through tissue; 1: at one point; 2: in at the
     * first, out at the second. Without tissue nothing is stray, and throws are told in the order in which
     * they nest. */
    uint32_t hole_count;
    /** 1: the points are given from the long limb's end on; places too count from there. Default 0. */
    uint32_t reversed;
    double holes[2][3]; /**< Where the holes are, m. */
    /** Their places on the polyline; negative (default): the nearest to `holes`. */
    double hole_places[2];
    /** Away from the knot into the tissue, of any length; zero (default): from the middle of the thread to
     * that of the holes. */
    double away[3];
    /** 1: the thread may have passed through itself or a tool since the last step (a guard has failed, or
     * there is none): read the topology anew. Default 0. */
    uint32_t may_have_passed;
    uint32_t reserved; /**< Zero. */
} vbss_knot_input;

/** How sure a throw is: a VBSS_KNOT_VERDICT_ constant. Each is revoked, with an event, when the
 * geometry no longer shows it. */
typedef int32_t vbss_knot_verdict;

/** The constants of #vbss_knot_verdict. */
enum {
    VBSS_KNOT_VERDICT_NONE = 0,      /**< There is none. */
    VBSS_KNOT_VERDICT_WRAPPING = 1,  /**< The thread winds round a tool. */
    VBSS_KNOT_VERDICT_PASSED = 2,    /**< Tied if the tools withdraw with what they hold. */
    VBSS_KNOT_VERDICT_FORMED = 3,    /**< The ends are through; invariants agree. */
    VBSS_KNOT_VERDICT_CERTIFIED = 4, /**< Its type is proved, its ends clear, its order known. */
    VBSS_KNOT_VERDICT_UNCERTAIN = 5  /**< Cannot be told; `reason` says why. */
};

/** Why a reading is uncertain: a VBSS_KNOT_REASON_ constant. */
typedef int32_t vbss_knot_reason;

/** The constants of #vbss_knot_reason. */
enum {
    VBSS_KNOT_REASON_NONE = 0,       /**< It is not. */
    VBSS_KNOT_REASON_ENDS = 1,       /**< Closures differ: an end lies inside the knot. */
    VBSS_KNOT_REASON_DEGENERATE = 2, /**< The thread touches itself in every projection. */
    /** The diagram has more crossings than the detector has room for, or is too wide for the Jones polynomial that must
     * confirm the result. */
    VBSS_KNOT_REASON_CAPACITY = 3,
    VBSS_KNOT_REASON_CONFLICT = 4 /**< Twist regions and invariants differ. */
};

/** The name of a knot, the same for its mirror image: a VBSS_KNOT_NAME_ constant. */
typedef int32_t vbss_knot_name;

/** The constants of #vbss_knot_name. "=": the next throw has the other handedness; "x": the same. */
enum {
    VBSS_KNOT_NAME_NONE = 0,            /**< No knot. */
    VBSS_KNOT_NAME_SINGLE = 1,          /**< One throw of one wrap: 3_1. */
    VBSS_KNOT_NAME_DOUBLE = 2,          /**< One of two, the surgeon's first: 5_1. */
    VBSS_KNOT_NAME_TRIPLE = 3,          /**< One of three: 7_1. */
    VBSS_KNOT_NAME_SQUARE = 4,          /**< 1=1 */
    VBSS_KNOT_NAME_GRANNY = 5,          /**< 1x1 */
    VBSS_KNOT_NAME_SURGEONS = 6,        /**< 2=1 */
    VBSS_KNOT_NAME_SURGEONS_GRANNY = 7, /**< 2x1 */
    VBSS_KNOT_NAME_FLS = 8,             /**< 2=1=1 */
    VBSS_KNOT_NAME_STACK = 9,           /**< Other throws; see #vbss_knot_detector_get_notation. */
    VBSS_KNOT_NAME_OTHER = 10           /**< A knot that is no stack of throws. */
};

/** What keeps a knot from being the FLS knot 2=1=1: bits. */
enum {
    VBSS_KNOT_FAULT_FIRST = 1,      /**< The first throw has not two wraps. */
    VBSS_KNOT_FAULT_LATER = 2,      /**< A later throw has not one wrap. */
    VBSS_KNOT_FAULT_FEW = 4,        /**< Fewer than three throws. */
    VBSS_KNOT_FAULT_MANY = 8,       /**< More than three. */
    VBSS_KNOT_FAULT_GRANNY = 16,    /**< A throw of the same handedness as the one before. */
    VBSS_KNOT_FAULT_STRAY = 32,     /**< A knot in one limb alone. */
    VBSS_KNOT_FAULT_HITCH = 64,     /**< A throw turned into a half hitch, which slides. */
    VBSS_KNOT_FAULT_ORDER = 128,    /**< The order of the throws is not known. */
    VBSS_KNOT_FAULT_TYPE = 256,     /**< Not a stack of throws. */
    VBSS_KNOT_FAULT_UNCERTAIN = 512 /**< The reading is uncertain. */
};

/** Flags of a throw: bits. */
enum {
    VBSS_KNOT_THROW_LOCATED = 1, /**< Its places on the limbs are known. */
    /** Its position in the stack is known: sub-chains show it, or (in #vbss_knot_detector_step) the throws
     * were in this order when they were read before, and at most one came. */
    VBSS_KNOT_THROW_ORDERED = 2,
    VBSS_KNOT_THROW_GRANNY = 4, /**< Same handedness as the throw before. */
    VBSS_KNOT_THROW_STRAY = 8,  /**< In one limb alone: not round the other. */
    VBSS_KNOT_THROW_HITCH = 16, /**< |slip| is at least slip_limit. */
    VBSS_KNOT_THROW_REVOCABLE =
        32 /**< Its tail is shorter than tail_least, or undone if tools withdraw. */
};

/** One throw of a knot, counted from the tissue outward. */
typedef struct vbss_knot_throw {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    vbss_knot_verdict verdict; /**< FORMED or CERTIFIED. */
    int32_t wraps;             /**< k, from 1 on. */
    int32_t handedness;        /**< +1 right-handed, -1 left-handed. */
    uint32_t flags;            /**< VBSS_KNOT_THROW_ bits. */
    uint32_t reserved;         /**< Zero. */
    double tail_places[2]; /**< LOCATED: from where to where it lies on the tail limb, ascending. */
    double long_places[2]; /**< The same on the long limb. */
    /** LOCATED: (kT - kL) / (kT + kL) of the total turning of both limbs inside the throw: 0 a flat half
     * knot, +1 the tail hitched round a straight long limb, -1 the reverse. */
    double slip;
    double tail_length;    /**< LOCATED: of thread between the throw and the tail's end, m. */
    uint64_t formed_step;  /**< Steps of the detector when it was first seen. */
    uint64_t reading_step; /**< Step of the input in which it was last confirmed. */
} vbss_knot_throw;

/** How the thread winds about one tool. Updated in every step, by both methods. */
typedef struct vbss_knot_winding {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    int32_t
        wrapped; /**< 1: |turns| of the longest run reached wrap_turns, and is not a quarter below. */
    /** Signed turns about the axis looking from the tip to the handle, of all thread beside the tool,
     * walking from the tail's to the long limb's end; what is beyond tip or handle does not count. */
    double turns;
    double run_turns;      /**< Of the run that winds most: thread beside the tool without a gap. */
    double run_places[2];  /**< Where it begins and ends. */
    double run_heights[2]; /**< How far from the tip that is along the axis, m. */
    /** Along the tool while it winds, from the tissue's end of the run to the other: +1 towards the
     * tip, as a throw needs; -1 towards the handle, which ties nothing; 0 neither by a thread's width, or not wrapped. */
    int32_t sense;
    uint32_t runs; /**< How many runs there are. */
} vbss_knot_winding;

/** What a detector knows. */
typedef struct vbss_knot_state {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    vbss_knot_name name;  /**< Of what is tied. */
    vbss_knot_verdict
        verdict; /**< Of the least certain throw; UNCERTAIN when the reading is; NONE: no knot. */
    vbss_knot_reason reason;        /**< Why it is uncertain. */
    uint32_t throw_count;           /**< Throws that are tied, at most 8. */
    uint32_t faults;                /**< Against the FLS knot: VBSS_KNOT_FAULT_ bits. */
    vbss_knot_verdict next_verdict; /**< Of a throw that is being tied: NONE, WRAPPING or PASSED. */
    int32_t next_wraps;      /**< Its wraps if the tools withdrew now; 0: it would tie nothing. */
    int32_t next_handedness; /**< +1, -1; 0 when there is none. */
    uint32_t next_tool;      /**< The tool that the thread winds round, from 0. */
    uint32_t loops;          /**< PROJECTION: loops round a tool that one segment crosses. */
    uint32_t undone;         /**< PROJECTION: crossings of loops that tie nothing. */
    /* Of the last finished reading by method TOPOLOGY: of the thread closed straight outward. */
    uint32_t crossings;         /**< Of the simplest diagram found. */
    int32_t certified;          /**< 1: it was taken apart into twist regions. */
    int32_t signature;          /**< sigma; right-handed 3_1: -2. */
    int32_t signature_tristram; /**< Levine-Tristram at 0.27 pi. */
    int64_t determinant;        /**< |Delta(-1)|. */
    int64_t v2;                 /**< Vassiliev invariant of degree 2 (Conway's z^2). */
    int64_t v3;                 /**< Of degree 3; right-handed 3_1: 1. */
    uint32_t closures;          /**< Other closures that were compared. */
    uint32_t closures_agreeing; /**< Of them those that gave the same. */
    int32_t ends_free;          /**< 1: both ends are outermost, so that all closures agree. */
    uint32_t reserved;          /**< Zero. */
    uint64_t steps;             /**< Steps and judgements so far. */
    uint64_t reading_step; /**< The one whose input the last reading is of; 0: there was none. */
} vbss_knot_state;

/** Figures since creation. */
typedef struct vbss_knot_statistics {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t reserved;       /**< Zero. */
    uint64_t readings;       /**< Readings of the topology that ended. */
    uint64_t closures;       /**< Closed curves that were read. */
    uint64_t certified;      /**< Of them taken apart into twist regions. */
    uint64_t uncertain;      /**< Readings that ended uncertain. */
    uint64_t projections;    /**< Diagrams made. */
    uint64_t degenerate;     /**< Of them thrown away: a crossing was not certain. */
    uint64_t overflows;      /**< Of them thrown away: too many crossings. */
    uint64_t removed;        /**< Vertices removed by proved moves. */
    uint64_t work;           /**< Operations spent on readings. */
    uint64_t most_step_work; /**< In the step that spent most. */
    uint64_t most_work;      /**< In the reading that took most. */
    uint64_t revoked;        /**< Verdicts that were revoked. */
} vbss_knot_statistics;

/** What happened in a step: a VBSS_KNOT_EVENT_ constant. */
typedef int32_t vbss_knot_event;

/** The constants of #vbss_knot_event. In the view an event is followed by three numbers, told here. */
enum {
    VBSS_KNOT_EVENT_WRAPPED = 1,   /**< Thread winds round a tool: tool, 1 + (turns > 0), 0. */
    VBSS_KNOT_EVENT_UNWRAPPED = 2, /**< It does no longer: tool, 0, 0. */
    VBSS_KNOT_EVENT_WRONG_WAY = 3, /**< It winds towards the handle: tool, 0, 0. */
    VBSS_KNOT_EVENT_PASSED =
        4, /**< A throw is tied if the tools withdraw: tool, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_FORMED = 5,    /**< A throw: its number from 0, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_CERTIFIED = 6, /**< The same. */
    VBSS_KNOT_EVENT_REVOKED =
        7, /**< A throw is gone or no longer sure: number, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_STRAY = 8,     /**< A knot in one limb: number, wraps, 1 + (right-handed). */
    VBSS_KNOT_EVENT_UNCERTAIN = 9, /**< The reading is uncertain: #vbss_knot_reason, 0, 0. */
    VBSS_KNOT_EVENT_READ = 10,     /**< A reading of the topology ended: throws, name, verdict. */
    VBSS_KNOT_EVENT_LOST = 11      /**< Events beyond the capacity: how many, 0, 0. */
};

/** An array of a detector: a VBSS_KNOT_VIEW_ constant. */
typedef int32_t vbss_knot_field;

/** The constants of #vbss_knot_field. */
enum {
    VBSS_KNOT_VIEW_EVENTS =
        0, /**< x 4 uint32_t: #vbss_knot_event and its numbers, of the last step. */
    /** PROJECTION, x 4 uint32_t: tool, the two segments of the intersecting pair, 1 if the tool is inside;
     * all loops of the last step. */
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
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_config_init(vbss_knot_config *config, uint32_t struct_size);

/**
 * Fills an input with the defaults; points come from the host.
 *
 * @param[out] input   the input to fill
 * @param struct_size  `sizeof *input` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_input_init(vbss_knot_input *input, uint32_t struct_size);

/**
 * Creates a detector that has seen nothing. All memory that it needs is allocated here.
 *
 * @param context        owner
 * @param config         how; NULL for the defaults
 * @param[out] detector  the new detector; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_create(vbss_context *context,
                                               const vbss_knot_config *config,
                                               vbss_knot_detector **detector);

/**
 * Destroys a detector.
 *
 * @param detector  the detector; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_destroy(vbss_knot_detector *detector);

/**
 * Shows the detector the thread and the tools of a step: updates the winding, spends at most the work limit on
 * the topology, begins a new reading when it is time, and tells what changed as events. Nothing is
 * allocated.
 *
 * @param detector  the detector
 * @param input     what there is; the same tools in the same order in every step
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY (points, tools), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; the detector is then as it was
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_step(vbss_knot_detector *detector,
                                             const vbss_knot_input *input);

/**
 * The same without a limit of work: a reading that is under way is dropped, and this input is read to the
 * end.
 *
 * @param detector  the detector
 * @param input     what there is
 * @return as #vbss_knot_detector_step
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_judge(vbss_knot_detector *detector,
                                              const vbss_knot_input *input);

/**
 * Forgets all that was seen; figures and the count of steps begin again.
 *
 * @param detector  the detector
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_reset(vbss_knot_detector *detector);

/**
 * What the detector knows.
 *
 * @param detector     the detector
 * @param[out] state   receives it
 * @param struct_size  `sizeof *state` as the caller was compiled; fields the library does not know
 *                     become zero
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_state(vbss_knot_detector *detector,
                                                  vbss_knot_state *state, uint32_t struct_size);

/**
 * One throw of the knot.
 *
 * @param detector     the detector
 * @param number       0 (nearest to the tissue) to throw_count - 1
 * @param[out] knot_throw  receives it
 * @param struct_size  `sizeof *knot_throw` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such throw)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_throw(vbss_knot_detector *detector, uint32_t number,
                                                  vbss_knot_throw *knot_throw,
                                                  uint32_t struct_size);

/**
 * How the thread winds about one tool.
 *
 * @param detector      the detector
 * @param tool          0 to tool_count of the last input - 1
 * @param[out] winding  receives it
 * @param struct_size   `sizeof *winding` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such tool)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_winding(vbss_knot_detector *detector, uint32_t tool,
                                                    vbss_knot_winding *winding,
                                                    uint32_t struct_size);

/**
 * The knot in the notation of surgeons, such as "2=1=1": wraps of each throw from the tissue outward, "=" before
 * one of the other handedness than the last, "x" before one of the same; "+" when the order is not known; "?" for a
 * knot that is no stack of throws, "" for none.
 *
 * @param detector   the detector
 * @param[out] text  receives the text and a final zero
 * @param capacity   bytes there is room for; 32 always suffice
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_notation(vbss_knot_detector *detector, char *text,
                                                     uint64_t capacity);

/**
 * Looks at an array.
 *
 * @param detector     the detector
 * @param field        which
 * @param[out] view    receives it
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_view(vbss_knot_detector *detector,
                                                 vbss_knot_field field, vbss_view *view,
                                                 uint32_t struct_size);

/**
 * Figures since creation or reset.
 *
 * @param detector         the detector
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_statistics(vbss_knot_detector *detector,
                                                       vbss_knot_statistics *statistics,
                                                       uint32_t struct_size);

/**
 * Saves what the detector knows, a reading under way included.
 *
 * @param detector      the detector
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      bytes there is room for
 * @param[out] written  bytes written or, with VBSS_ERROR_CAPACITY, wanted
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_save(vbss_knot_detector *detector, uint8_t *bytes,
                                             uint64_t capacity, uint64_t *written);

/**
 * Restores what was saved from a detector with the same configuration. All or nothing. A reading that was under
 * way is done again up to where it was.
 *
 * @param detector  the detector
 * @param bytes     the snapshot
 * @param count     its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: of another detector), VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_CAPACITY (it counts more than the detector has room for), VBSS_ERROR_OUT_OF_MEMORY,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on failure nothing has changed
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_restore(vbss_knot_detector *detector, const uint8_t *bytes,
                                                uint64_t count);

/**
 * A hash of what the detector knows: equal for equal histories, on every machine.
 *
 * @param detector   the detector
 * @param[out] hash  receives it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_knot_detector_get_hash(vbss_knot_detector *detector, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
