/**
 * @file metrics.h
 * @brief How well a suture was done: accuracy, gap, knot, time, forces, motion, and a score with its reasons. Needs no
 * scene: it is fed with events and samples from any simulator.
 *
 * Three things are told, on one clock that never runs backwards: *samples* (where the tools are and what they bear, 30 Hz
 * to 2 kHz, at any times), *events* (what happened, each with step, time, tool, place and force; most can be undone), and
 * readings of a *pull test* of the finished knot. What is known is a pure function of these: the same log gives the same
 * bits.
 *
 * All times are of that clock, which hosts should run with the hands: a session adds up the lengths of its steps. The
 * score uses it, too. A simulation that cannot keep up leaves out part of this time; samples report how much
 * (#vbss_metrics_sample.time_lost), and the report gives all three: time, time lost, time simulated.
 *
 * Motion is measured on a fixed grid of 100 Hz behind a fixed low-pass filter, whatever the times of the samples, so that
 * smoothness does not hang on the rate of a recording. Samples that no hand can have reached are counted and left out. A
 * figure of a tick is known 0.26 s after it; #vbss_metrics_finish ends that. docs/metrics.md has every formula with its source, what is not verified, and what may be claimed: the score is
 * in the style of MISTELS and is not the FLS score.
 *
 * SI units; what is in mm says so.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_METRICS_H
#define VBLAST_SS_METRICS_H

#include <vblast_ss/base.h>

/** What was measured of one trial. */
typedef struct vbss_metrics vbss_metrics;

/** Which tool: a VBSS_METRICS_ tool constant. */
typedef int32_t vbss_metrics_tool;

/** The constants of #vbss_metrics_tool. */
enum {
    VBSS_METRICS_LEFT = 0,   /**< The left one, */
    VBSS_METRICS_RIGHT = 1,  /**< the right one, */
    VBSS_METRICS_NO_TOOL = 2 /**< none, or not known: in events only. */
};

/** How to measure. Fill it with #vbss_metrics_config_init, then change what you need. */
typedef struct vbss_metrics_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Whose tightness counts in the score; default VBSS_METHOD_OURS. Both are always reported. */
    vbss_method tightness_method;
    uint32_t throw_capacity;    /**< Records of throws, undone ones too, 1 to 4096; default 64. */
    uint32_t phase_capacity;    /**< Visits of phases, 1 to 65536; default 256. */
    uint32_t incident_capacity; /**< Transfers, attempts, drops, faults, 1 to 65536; default 256. */
    uint32_t throws_wanted;     /**< Throws that the knot should have, 0 to 64; default 3. */
    double duration;            /**< Of motion there is room for, s, 1 to 7200; default 600. */
    double drain_radius; /**< Of the cylinder with the marks, m, 1e-4 to 1; default 6.5e-3. */
    double stiffness;    /**< EA of the thread, N, 1e-3 to 1e9; default 427 (silk, 0.25 mm). */
    double pull_force;   /**< Of the pull test, N, 1e-3 to 1e3; default 2. */
    double pull_time;    /**< That it must be borne, s, 0 to 1e3; default 1. */
    double slip_limit;   /**< Tail drawn in from which a knot slips, m, 1e-6 to 1; default 1e-3. */
    /** PAPER: strain from which a knot is tight, 0 to 1; default 0: pull_force / stiffness. */
    double strain_threshold;
    double idle_speed;   /**< Below it a tool is idle, m/s, 0 to 1; default 5e-3, */
    double idle_release; /**< until it is faster than this, idle_speed to 1; default 6e-3. */
    double max_time;     /**< From which the score is zero, s, 1e-3 to 1e6; default 600. */
    double
        weight_deviation; /**< Points a mm from a mark; this and all weights 0 to 1e6; default 10. */
    double weight_gap;    /**< Points a mm of gap; default 10. */
    double weight_tightness; /**< Points a point of tightness (0, 10, 20); default 1. */
    double weight_throw;     /**< Points a throw that is missing; default 0. */
    double weight_granny;    /**< Points a throw that makes a granny; default 0. */
    double weight_attempt;   /**< Points a puncture that was withdrawn; default 0. */
    double weight_drop;      /**< Points a drop; default 0. */
    double weight_transfer;  /**< Points a needle transfer that was missed; default 0. */
    double weight_host;      /**< Times the points of a penalty of the host; default 1. */
    /** Largest speed of a hand, m/s, 0 to 1e6; default 2, for the upper limbs by ISO 13855. A sample that is farther from
     * the last one than this speed allows, plus 1 mm for noise, is an outlier: see #vbss_metrics_add_sample. 0: no sample
     * is an outlier. */
    double max_speed;
    /** Share of the time, 0 to 1, above which lost time sets VBSS_METRICS_TIME_LOST; default 0.02. A trial shorter than
     * 1 s counts as 1 s. */
    double lost_share;
} vbss_metrics_config;

/** Parts of a sample: bits. */
enum {
    VBSS_METRICS_HAS_LEFT = 1,       /**< Where the left tool is, */
    VBSS_METRICS_HAS_RIGHT = 2,      /**< the right one, */
    VBSS_METRICS_HAS_LEFT_FORCE = 4, /**< what the left one bears, */
    VBSS_METRICS_HAS_RIGHT_FORCE = 8 /**< the right one. */
};

/** Where the tools are. Fill it with #vbss_metrics_sample_init, then set what there is. */
typedef struct vbss_metrics_sample {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    uint32_t valid;        /**< VBSS_METRICS_HAS_ bits; default 0. */
    uint64_t step;         /**< Of the simulator; only told again. */
    double time;           /**< s, at most 1e9 in magnitude, after the last sample. */
    double position[2][3]; /**< Of the tips, left and right, m, each at most 1e3. */
    double force[2][3];    /**< On the tools, N, each at most 1e6. */
    /** Time that the simulation has left out since its clock began, s, at most 1e9 and not less than in the last sample;
     * default 0. It is part of `time`. */
    double time_lost;
} vbss_metrics_sample;

/** What happened: a VBSS_METRICS_EVENT_ constant. */
typedef int32_t vbss_metrics_event_kind;

/** The constants of #vbss_metrics_event_kind; what can be undone says so. What stands and is told again is replaced. */
enum {
    VBSS_METRICS_EVENT_NEEDLE_APPEARS = 1, /**< The clock starts. Can be undone. */
    VBSS_METRICS_EVENT_PHASE = 2,          /**< A phase of the task begins: `number` names it. */
    /** The needle has gone through at mark `number` (0, 1), off by `angle` and `axial`. Undone: it was withdrawn, which
     * is an attempt. */
    VBSS_METRICS_EVENT_PUNCTURE = 3,
    VBSS_METRICS_EVENT_TAIL = 4,     /**< Tail `number` (0, 1) is `amount` m long. Can be undone. */
    VBSS_METRICS_EVENT_TAIL_CUT = 5, /**< It was cut; `amount` m are left. Can be undone. */
    /** The slit gapes: from `position` to `other`, and by `amount` m where it gapes most. Can be undone. */
    VBSS_METRICS_EVENT_GAP = 6,
    /** Throw `number` (0 next to the tissue) is tied: `wraps`, `handedness`, `relation`. Told again: known better. Undone:
     * it is untied. */
    VBSS_METRICS_EVENT_THROW = 7,
    VBSS_METRICS_EVENT_TRANSFER = 8,        /**< `tool` took over the needle. Can be undone. */
    VBSS_METRICS_EVENT_TRANSFER_MISSED = 9, /**< It should have, and did not. Can be undone. */
    VBSS_METRICS_EVENT_DROP = 10, /**< What the host calls `number` was dropped. Can be undone. */
    /** A penalty of the host's own: it calls it `number`, and it costs `amount` points. Can be undone. */
    VBSS_METRICS_EVENT_HOST = 11,
    VBSS_METRICS_EVENT_AVULSED = 12, /**< The drain was torn off. Score zero. Can be undone. */
    VBSS_METRICS_EVENT_BROKEN =
        13 /**< The thread broke, or was cut early. Score zero. Can be undone. */
};

/** How a throw lies on the one before: a VBSS_METRICS_RELATION_ constant. */
typedef int32_t vbss_metrics_relation;

/** The constants of #vbss_metrics_relation. */
enum {
    VBSS_METRICS_RELATION_UNKNOWN = 0, /**< Not known, */
    VBSS_METRICS_RELATION_FIRST = 1,   /**< there is none before, */
    VBSS_METRICS_RELATION_SQUARE = 2,  /**< the other way round, */
    VBSS_METRICS_RELATION_GRANNY = 3   /**< the same way round. */
};

/** Something that happened. Fill it with #vbss_metrics_event_init, then set what the kind wants. */
typedef struct vbss_metrics_event {
    uint32_t struct_size;         /**< Size of this struct in bytes, set by the init function. */
    vbss_metrics_event_kind kind; /**< What; the default 0 is refused. */
    vbss_metrics_tool tool;       /**< With which tool; default VBSS_METRICS_NO_TOOL. */
    uint32_t number;              /**< As the kind says; throws: 0 to 63; default 0. */
    uint32_t undone;              /**< 1: it is no longer so; default 0. */
    int32_t wraps;      /**< THROW: 1 single, 2 double, ..., 0 not known (default), to 64. */
    int32_t handedness; /**< THROW: +1 right-handed, -1 left-handed, 0 not known (default). */
    vbss_metrics_relation relation; /**< THROW: to the throw before; default UNKNOWN. */
    uint64_t step;                  /**< Of the simulator; only told again. */
    double time;        /**< s, at most 1e9 in magnitude, not before what was told last. */
    double position[3]; /**< Where, m, each at most 1e3. */
    double force[3];    /**< With which force, N, each at most 1e6. */
    double other[3];    /**< GAP: the other side, m, each at most 1e3. */
    double angle;       /**< PUNCTURE: about the axis, rad, -pi to pi. */
    double axial;       /**< PUNCTURE: along the axis, m, at most 1e3. */
    double amount;      /**< As the kind says, 0 to 1e6. */
} vbss_metrics_event;

/** A reading of the pull test. Fill it with #vbss_metrics_pull_init, then set what there is. */
typedef struct vbss_metrics_pull {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t
        begins;    /**< 1: a new test begins, what an earlier one found is forgotten; default 0. */
    uint32_t tied; /**< 1 (default): the knot is still there; 0: its topology is lost. */
    uint32_t reserved; /**< Zero. */
    uint64_t step;     /**< Of the simulator; only told again. */
    double time;       /**< s, as of events. */
    double strain[2];  /**< Of the thread between knot and each tool, -1 to 1. */
    double force[2];   /**< With which each tool pulls, N, 0 to 1e6. */
    double drawn_in;   /**< Tail drawn into the knot since the test began, m, at most 1e3. */
} vbss_metrics_pull;

/** How tight a knot is, in the points of FLS: a VBSS_METRICS_TIGHTNESS_ constant. */
typedef int32_t vbss_metrics_tightness;

/** The constants of #vbss_metrics_tightness. */
enum {
    VBSS_METRICS_TIGHTNESS_UNKNOWN = -1, /**< It was not pulled, or not to an end. */
    VBSS_METRICS_TIGHTNESS_TIGHT = 0,    /**< It holds. */
    VBSS_METRICS_TIGHTNESS_SLIPS = 10,   /**< It slips. */
    VBSS_METRICS_TIGHTNESS_UNTIED = 20   /**< It comes apart. */
};

/** What a report knows: bits. */
enum {
    VBSS_METRICS_STARTED = 1,    /**< The needle has appeared. */
    VBSS_METRICS_STOPPED = 2,    /**< Both tails are cut: the time stands. */
    VBSS_METRICS_PUNCTURE_0 = 4, /**< The deviation from the first mark is known, */
    VBSS_METRICS_PUNCTURE_1 = 8, /**< from the second, */
    VBSS_METRICS_GAP = 16,       /**< the gap, */
    VBSS_METRICS_TAIL_0 = 32,    /**< the length of the first tail, */
    VBSS_METRICS_TAIL_1 = 64,    /**< of the second. */
    VBSS_METRICS_FINISHED = 128, /**< #vbss_metrics_finish was called. */
    VBSS_METRICS_AVULSED = 256,  /**< The drain was torn off. */
    VBSS_METRICS_BROKEN = 512,   /**< The thread broke. */
    VBSS_METRICS_TIMEOUT = 1024, /**< The time is up. */
    /** The score is that of a whole trial: stopped, with deviations, gap and tightness known, or zero for good. Without
     * it the score is what it would be if nothing more were found. */
    VBSS_METRICS_FINAL = 2048,
    /** More than `lost_share` of the time is lost. Time and score include it and do not compare with those of other
     * trials. */
    VBSS_METRICS_TIME_LOST = 4096
};

/** What is known of a trial. What is not known is 0, and its bit is not set. */
typedef struct vbss_metrics_report {
    uint32_t struct_size;                   /**< Bytes of this struct that the library filled. */
    uint32_t flags;                         /**< VBSS_METRICS_ bits of what is known. */
    vbss_metrics_tightness tightness_ours;  /**< By the pull test, */
    vbss_metrics_tightness tightness_paper; /**< by the strain when both tools pull. */
    uint32_t throw_count;                   /**< Throws that stand, */
    uint32_t square_count;                  /**< of them square to the one before, */
    uint32_t granny_count;                  /**< granny to it, */
    uint32_t unknown_count;                 /**< not known which. */
    uint32_t throw_records;                 /**< For #vbss_metrics_get_throw: undone throws too. */
    uint32_t phase_count;                   /**< For #vbss_metrics_get_phase. */
    uint32_t penalty_count;                 /**< For #vbss_metrics_get_penalty. */
    uint32_t transfers;                     /**< The needle changed hands, */
    uint32_t transfers_missed;              /**< should have, */
    uint32_t attempts[2];                   /**< punctures that were withdrawn, at each mark, */
    uint32_t drops;                         /**< things that were dropped, */
    uint32_t host_penalties;                /**< penalties of the host. */
    uint32_t reserved;                      /**< Zero. */
    uint64_t samples;                       /**< Samples taken. */
    uint64_t ticks;      /**< Of motion that are known, of the tool of which more are. */
    uint64_t ticks_lost; /**< Beyond the room for motion: not measured. */
    /** From the needle until both tails were cut, or until now, s, on the clock of the hands. It includes `time_lost`. */
    double time;
    double deviation_mm[2]; /**< Of the punctures from their marks, along the drain. */
    double gap_mm;          /**< Between the two points, */
    double gap_largest_mm;  /**< where the slit gapes most. */
    double tail_mm[2];      /**< Of the tails, after the cut if they were. */
    double pull_held;       /**< Longest time the pull was borne, s. */
    double pull_strain;     /**< Largest strain that both sides had, */
    double drawn_in_mm;     /**< Most tail that was drawn in. */
    double score;           /**< max_time - time - penalties, not below zero. */
    double penalties;       /**< Sum of the penalties. */
    uint64_t outliers[2];   /**< Samples of the left and the right tool left out as outliers. */
    uint32_t jumps[2];      /**< Times that outliers lasted for more than 0.1 s: a new run began. */
    double time_lost;       /**< Part of `time` that the simulation left out, s. */
    double time_simulated;  /**< `time` without `time_lost`, s. */
} vbss_metrics_report;

/** A throw that was tied, in the order in which they were told. */
typedef struct vbss_metrics_throw {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    uint32_t number;                /**< Its place in the knot, 0 next to the tissue. */
    uint32_t standing;              /**< 1: it is there; 0: it was untied. */
    vbss_metrics_tool tool;         /**< With which tool. */
    int32_t wraps;                  /**< 1 single, 2 double, 0 not known. */
    int32_t handedness;             /**< +1 right-handed, -1 left-handed, 0 not known. */
    vbss_metrics_relation relation; /**< To the throw before. */
    uint32_t reserved;              /**< Zero. */
    uint64_t step;                  /**< When it was told first. */
    double time;                    /**< The same, s. */
    double undone_time;             /**< When it was untied, s; 0 while it stands. */
    double position[3];             /**< Where, m. */
    double force[3];                /**< With which force, N. */
} vbss_metrics_throw;

/** A visit of a phase, which may be entered again. */
typedef struct vbss_metrics_phase {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t number;      /**< The host's name of the phase. */
    uint32_t ended;       /**< 1: another has begun; 0: `end` is now, or the end of the trial. */
    uint32_t reserved;    /**< Zero. */
    uint64_t step;        /**< When it was entered. */
    double begin;         /**< The same, s. */
    double end;           /**< When it was left, s. */
} vbss_metrics_phase;

/** What took points: a VBSS_METRICS_PENALTY_ constant. */
typedef int32_t vbss_metrics_penalty_kind;

/** The constants of #vbss_metrics_penalty_kind. */
enum {
    VBSS_METRICS_PENALTY_DEVIATION = 1, /**< A puncture off its mark, by `measure` mm. */
    VBSS_METRICS_PENALTY_GAP = 2,       /**< The slit gapes, by `measure` mm. */
    VBSS_METRICS_PENALTY_TIGHTNESS = 3, /**< The knot slips or is untied: `measure` 10 or 20. */
    VBSS_METRICS_PENALTY_THROWS = 4,    /**< Throws are missing: `measure` of them. */
    VBSS_METRICS_PENALTY_GRANNY = 5,    /**< A throw the same way round as the one before. */
    VBSS_METRICS_PENALTY_ATTEMPT = 6,   /**< A puncture was withdrawn. */
    VBSS_METRICS_PENALTY_DROP = 7,      /**< Something was dropped. */
    VBSS_METRICS_PENALTY_TRANSFER = 8,  /**< The needle did not change hands. */
    VBSS_METRICS_PENALTY_HOST = 9,      /**< A penalty of the host, of `measure` points. */
    VBSS_METRICS_PENALTY_TIMEOUT = 10,  /**< The time is up: all that was left. */
    VBSS_METRICS_PENALTY_AVULSED = 11,  /**< The drain was torn off: all that was left. */
    VBSS_METRICS_PENALTY_BROKEN = 12,   /**< The thread broke: all that was left. */
    VBSS_METRICS_PENALTY_INCOMPLETE =
        13, /**< Finished before both tails were cut: all that was left. */
    /** More than `lost_share` of the time was lost: `measure` s. It costs no points. */
    VBSS_METRICS_PENALTY_TIME_LOST = 14
};

/** One reason why the score is not max_time - time. Faults that cost nothing are told too. */
typedef struct vbss_metrics_penalty {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    vbss_metrics_penalty_kind kind; /**< What. */
    uint32_t number;                /**< Of the mark, throw, ... as in the event. */
    vbss_metrics_tool tool;         /**< With which tool. */
    uint64_t step;                  /**< When. */
    double time;                    /**< The same, s. */
    double measure;                 /**< How much, as the kind says. */
    double amount;                  /**< Points it took. */
    double position[3];             /**< Where, m. */
    double force[3];                /**< With which force, N. */
    const char *text;               /**< In words, a constant text, never NULL. */
} vbss_metrics_penalty;

/** The phase of a question that is about the whole task. */
enum {
    /** From the needle until both tails were cut; without a needle: all there is. */
    VBSS_METRICS_WHOLE = -1
};

/** What could be computed of a motion: bits. */
enum {
    VBSS_METRICS_HAS_LDJ = 1,        /**< `ldj_length`, `ldj_speed` */
    VBSS_METRICS_HAS_SPARC = 2,      /**< `sparc`: not above 40.96 s. */
    VBSS_METRICS_HAS_MOVEMENTS = 4,  /**< `movement_sparc` */
    VBSS_METRICS_HAS_CORRELATION = 8 /**< `correlation` */
};

/** How one tool moved, and what it bore. */
typedef struct vbss_metrics_motion {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t valid;          /**< VBSS_METRICS_HAS_ bits. */
    uint32_t movement_count; /**< Movements of 0.2 s to 40.96 s between rests. */
    uint32_t reserved;       /**< Zero. */
    double time;             /**< In which it was seen, s, */
    double unseen_time;      /**< and not. */
    double path_length;      /**< m */
    double mean_speed;       /**< m/s, */
    double peak_speed;       /**< m/s. */
    double idle_time;        /**< In which it rested, s, */
    double idle_share;       /**< as a part of the time. */
    double ldj_length;       /**< -ln(T^5/L^2 integral of |jerk|^2): higher is smoother, */
    double ldj_speed;        /**< -ln(T^3/v_peak^2 integral of |jerk|^2). */
    double sparc;            /**< Of all of it as one movement, */
    double movement_sparc;   /**< mean over the movements. */
    double force_peak;       /**< Largest force, N. */
    double force_integral;   /**< Of its magnitude over time, N s. */
} vbss_metrics_motion;

/** How both tools moved together. */
typedef struct vbss_metrics_bimanual {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    uint32_t valid;           /**< VBSS_METRICS_HAS_CORRELATION, or 0. */
    double time;              /**< In which both were seen, s. */
    double correlation;       /**< Pearson's, of their speeds. */
    double both_moving_time;  /**< In which neither rested, s, */
    double one_moving_time;   /**< in which one did, */
    double still_time;        /**< in which both did. */
    double both_moving_share; /**< The first of these as a part of the time. */
} vbss_metrics_bimanual;

/** An array: a VBSS_METRICS_VIEW_ constant. */
typedef int32_t vbss_metrics_field;

/** The constants of #vbss_metrics_field. Row i is of the time of the first sample + i / 100 s. */
enum {
    VBSS_METRICS_VIEW_LEFT_SPEED =
        0, /**< x 1 double: of the left tool, m/s; 0 where it was not seen, */
    VBSS_METRICS_VIEW_RIGHT_SPEED = 1, /**< of the right one. */
    /** x 1 double: |jerk|^2 of the left tool, m^2/s^6; 0 where it was not seen for 0.25 s without a gap, */
    VBSS_METRICS_VIEW_LEFT_JERK = 2,
    VBSS_METRICS_VIEW_RIGHT_JERK = 3, /**< of the right one. */
    VBSS_METRICS_VIEW_LEFT_FORCE =
        4, /**< x 1 double: largest |force| in that hundredth, N, of the left tool, */
    VBSS_METRICS_VIEW_RIGHT_FORCE = 5 /**< of the right one. */
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
VBSS_API vbss_result vbss_metrics_config_init(vbss_metrics_config *config, uint32_t struct_size);

/**
 * Fills a sample with the defaults: nothing is there.
 *
 * @param[out] sample  the sample to fill
 * @param struct_size  `sizeof *sample` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_sample_init(vbss_metrics_sample *sample, uint32_t struct_size);

/**
 * Fills an event with the defaults; its kind comes from the host.
 *
 * @param[out] event   the event to fill
 * @param struct_size  `sizeof *event` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_event_init(vbss_metrics_event *event, uint32_t struct_size);

/**
 * Fills a reading of the pull test with the defaults: tied, without force.
 *
 * @param[out] pull    the reading to fill
 * @param struct_size  `sizeof *pull` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_pull_init(vbss_metrics_pull *pull, uint32_t struct_size);

/**
 * Creates a measurement that knows nothing yet. All memory that it needs is allocated here.
 *
 * @param context       owner
 * @param config        how; NULL for the defaults
 * @param[out] metrics  the new measurement; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_create(vbss_context *context, const vbss_metrics_config *config,
                                         vbss_metrics **metrics);

/**
 * Destroys a measurement.
 *
 * @param metrics  the measurement; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_destroy(vbss_metrics *metrics);

/**
 * Takes a sample. A tool that is not seen for more than 0.1 s has not moved meanwhile: where it comes back is where it
 * goes on. A position that the hand cannot have reached with `max_speed` is an outlier. It is counted and left out, and
 * the curve bridges it as it does a lost sample. Later positions that are nearer to the outlier are outliers, too. After
 * 0.1 s of them the tool has jumped: it counts as not seen for that time, and goes on from there. Nothing is allocated;
 * motion beyond the room for it is counted as lost.
 *
 * @param metrics  the measurement
 * @param sample   where the tools are
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards, or the measurement is finished),
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed then
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_add_sample(vbss_metrics *metrics,
                                             const vbss_metrics_sample *sample);

/**
 * Takes an event, also after #vbss_metrics_finish.
 *
 * @param metrics  the measurement
 * @param event    what happened
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards, or what is undone does not stand),
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed
 *         then
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_add_event(vbss_metrics *metrics, const vbss_metrics_event *event);

/**
 * Takes a reading of the pull test, also after #vbss_metrics_finish.
 *
 * @param metrics  the measurement
 * @param pull     the reading
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed then
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_add_pull(vbss_metrics *metrics, const vbss_metrics_pull *pull);

/**
 * Ends the samples: motion becomes known up to the last one, and no more are taken. A second call does nothing.
 *
 * @param metrics  the measurement
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_finish(vbss_metrics *metrics);

/**
 * What is known of the trial so far.
 *
 * @param metrics      the measurement
 * @param[out] report  receives it
 * @param struct_size  `sizeof *report` as the caller was compiled; fields the library does not know
 *                     become zero
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_report(vbss_metrics *metrics, vbss_metrics_report *report,
                                             uint32_t struct_size);

/**
 * One record of a throw.
 *
 * @param metrics          the measurement
 * @param index            0 to throw_records - 1
 * @param[out] record      receives it
 * @param struct_size      `sizeof *record` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such record)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_throw(vbss_metrics *metrics, uint32_t index,
                                            vbss_metrics_throw *record, uint32_t struct_size);

/**
 * One visit of a phase.
 *
 * @param metrics      the measurement
 * @param index        0 to phase_count - 1
 * @param[out] phase   receives it
 * @param struct_size  `sizeof *phase` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such visit)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_phase(vbss_metrics *metrics, uint32_t index,
                                            vbss_metrics_phase *phase, uint32_t struct_size);

/**
 * One penalty. They sum to what the score is below max_time - time, unless that is below zero.
 *
 * @param metrics       the measurement
 * @param index         0 to penalty_count - 1
 * @param[out] penalty  receives it
 * @param struct_size   `sizeof *penalty` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such penalty)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_penalty(vbss_metrics *metrics, uint32_t index,
                                              vbss_metrics_penalty *penalty, uint32_t struct_size);

/**
 * How a tool moved. Takes time (some ms for a minute of motion): not for every step.
 *
 * @param metrics      the measurement
 * @param tool         VBSS_METRICS_LEFT or VBSS_METRICS_RIGHT
 * @param phase        index of a visit of a phase, or VBSS_METRICS_WHOLE
 * @param[out] motion  receives it
 * @param struct_size  `sizeof *motion` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE (no such tool or visit) or VBSS_ERROR_ARITHMETIC_MODE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_motion(vbss_metrics *metrics, vbss_metrics_tool tool,
                                             int32_t phase, vbss_metrics_motion *motion,
                                             uint32_t struct_size);

/**
 * How both tools moved together.
 *
 * @param metrics        the measurement
 * @param phase          index of a visit of a phase, or VBSS_METRICS_WHOLE
 * @param[out] bimanual  receives it
 * @param struct_size    `sizeof *bimanual` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE (no such visit) or VBSS_ERROR_ARITHMETIC_MODE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_bimanual(vbss_metrics *metrics, int32_t phase,
                                               vbss_metrics_bimanual *bimanual,
                                               uint32_t struct_size);

/**
 * Looks at an array.
 *
 * @param metrics      the measurement
 * @param field        which
 * @param[out] view    receives it
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_view(vbss_metrics *metrics, vbss_metrics_field field,
                                           vbss_view *view, uint32_t struct_size);

/**
 * Where a place on a cylinder is, seen from a mark on it: what a puncture's event wants.
 *
 * @param axis         any length; the axis goes through `centre`
 * @param centre       a point of the axis, m
 * @param mark         the mark, m; only its direction from the axis and its place along it count
 * @param place        the place, m; likewise
 * @param[out] angle   from mark to place about the axis, right-handed, -pi to pi, rad
 * @param[out] axial   from mark to place along the axis, m
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE, or VBSS_ERROR_OUT_OF_RANGE (numbers above 1e3, no
 *         axis, mark or place on it)
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_offset(const double axis[3], const double centre[3],
                                         const double mark[3], const double place[3], double *angle,
                                         double *axial);

/**
 * Saves all that is known.
 *
 * @param metrics       the measurement
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      bytes there is room for
 * @param[out] written  bytes written or, with VBSS_ERROR_CAPACITY, wanted
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_save(vbss_metrics *metrics, uint8_t *bytes, uint64_t capacity,
                                       uint64_t *written);

/**
 * Restores what was saved from a measurement with the same configuration. All or nothing.
 *
 * @param metrics  the measurement
 * @param bytes    the snapshot
 * @param count    its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: of another configuration), VBSS_ERROR_DATA_VERSION, VBSS_ERROR_CAPACITY,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure nothing has changed
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_restore(vbss_metrics *metrics, const uint8_t *bytes,
                                          uint64_t count);

/**
 * A hash of all that is known: equal for equal logs, on every machine. Takes time with the length of the trial: not for
 * every step.
 *
 * @param metrics    the measurement
 * @param[out] hash  receives it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_metrics_get_hash(vbss_metrics *metrics, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
