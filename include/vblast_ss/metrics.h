/**
 * @file metrics.h
 * @brief Measures how well a suture was done: accuracy, gap, knot, time, forces, motion, and a
 *   score with its reasons. It needs no scene; any simulator can supply the events and samples.
 *
 * There are three inputs, on one clock that never runs backwards. *Samples* give the position of
 * the tools and the force on them, at 30 Hz to 2 kHz, evenly spaced or not. *Events* give a step, a
 * time, a tool, a position and a force; most can be undone. Readings of a *pull test* describe the
 * finished knot. The results are a pure function of these inputs: the same log gives the same bits.
 *
 * All times, and the score, use that clock. It should run with the hands: a session adds up the
 * lengths of its steps. A simulation that cannot keep up leaves out part of this time, and samples
 * report how much (#vbss_metrics_sample.time_lost). The report gives the time, the lost time and
 * the simulated time.
 *
 * Motion is measured on a fixed grid of 100 Hz behind a fixed low-pass filter, so that smoothness
 * does not depend on the rate of a recording. Samples that no hand can have reached are counted and
 * left out. The filter delays each tick's results by 0.26 s; #vbss_metrics_finish computes the last
 * ones. docs/explanation/metrics.md has every formula with its source and says which of them are verified and
 * which claims they support. The score is in the style of MISTELS; it is not the FLS score.
 *
 * Units are SI; names that end in `_mm` mean millimetres.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_METRICS_H
#define VBLAST_SS_METRICS_H

#include <vblast_ss/base.h>

/** The measurement of one trial. */
typedef struct vbss_metrics vbss_metrics;

/** A tool: a VBSS_METRICS_TOOL_ constant. */
typedef int32_t vbss_metrics_tool;

/** The constants of #vbss_metrics_tool. */
enum {
    VBSS_METRICS_TOOL_LEFT = 0,  /**< The left tool. */
    VBSS_METRICS_TOOL_RIGHT = 1, /**< The right tool. */
    VBSS_METRICS_TOOL_NONE = 2   /**< No tool, or an unknown one; for events only. */
};

/** Test whose verdict on tightness counts in the score: a VBSS_METRICS_TEST_ constant. */
typedef int32_t vbss_metrics_tightness_test;

/** The constants of #vbss_metrics_tightness_test. */
enum {
    VBSS_METRICS_TEST_PULL = 0,  /**< The knot bears a force for a time without slipping. */
    VBSS_METRICS_TEST_STRAIN = 1 /**< The strain of both sides (Qi et al. 2017). */
};

/** Configuration of a measurement. Fill it with #vbss_metrics_config_init, then change fields. */
typedef struct vbss_metrics_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** The test whose tightness counts in the score; default VBSS_METRICS_TEST_PULL. Both are always
     * reported. */
    vbss_metrics_tightness_test tightness_test;
    /** Largest number of throw records, undone throws included, 1 to 4096; default 64. */
    uint32_t throw_capacity;
    uint32_t phase_capacity; /**< Largest number of phase visits, 1 to 65536; default 256. */
    /** Largest number of transfers, attempts, drops and faults, 1 to 65536; default 256. */
    uint32_t incident_capacity;
    uint32_t throws_wanted; /**< Throws that the knot should have, 0 to 64; default 3. */
    double duration;        /**< Longest motion that can be stored, s, 1 to 7200; default 600. */
    /** Radius of the cylinder that carries the marks, m, 1e-4 to 1; default 6.5e-3. */
    double drain_radius;
    /** Axial stiffness EA of the thread, N, 1e-3 to 1e9; default 427 (silk, 0.25 mm). */
    double stiffness;
    double pull_force; /**< Force of the pull test, N, 1e-3 to 1e3; default 2. */
    double pull_time;  /**< Time that the knot must bear the pull, s, 0 to 1e3; default 1. */
    /** Length of tail drawn in above which the knot slips, m, 1e-6 to 1; default 1e-3. */
    double slip_limit;
    /** VBSS_METRICS_TEST_STRAIN: strain above which a knot is tight, 0 to 1; default 0, which means
     * pull_force / stiffness. */
    double strain_threshold;
    double idle_speed; /**< Speed below which a tool becomes idle, m/s, 0 to 1; default 5e-3. */
    /** Speed above which an idle tool moves again, m/s, idle_speed to 1; default 6e-3. */
    double idle_release;
    double max_time;         /**< Time from which the score is zero, s, 1e-3 to 1e6; default 600. */
    double weight_deviation; /**< Points per mm of deviation from a mark, 0 to 1e6; default 10. */
    double weight_gap;       /**< Points per mm of gap, 0 to 1e6; default 10. */
    /** Points per point of tightness (0, 10, 20), 0 to 1e6; default 1. */
    double weight_tightness;
    double weight_throw;    /**< Points per missing throw, 0 to 1e6; default 0. */
    double weight_granny;   /**< Points per throw that makes a granny, 0 to 1e6; default 0. */
    double weight_attempt;  /**< Points per puncture that was withdrawn, 0 to 1e6; default 0. */
    double weight_drop;     /**< Points per drop, 0 to 1e6; default 0. */
    double weight_transfer; /**< Points per missed needle transfer, 0 to 1e6; default 0. */
    double weight_host; /**< Factor of the points of the host's penalties, 0 to 1e6; default 1. */
    /** Largest speed of a hand, m/s, 0 to 1e6; default 2, for the upper limbs by ISO 13855. A
     * sample that is farther from the last one than this speed allows, plus 1 mm for noise, is
     * an outlier: see #vbss_metrics_add_sample. With 0 no sample is an outlier. */
    double max_speed;
    /** Share of lost time above which VBSS_METRICS_FLAG_TIME_LOST is set, 0 to 1; default 0.02. A
     * trial shorter than 1 s counts as 1 s. */
    double lost_share;
} vbss_metrics_config;

/** Bits for the parts of a sample. */
enum {
    VBSS_METRICS_HAS_LEFT = 1,       /**< The position of the left tool is valid. */
    VBSS_METRICS_HAS_RIGHT = 2,      /**< The position of the right tool is valid. */
    VBSS_METRICS_HAS_LEFT_FORCE = 4, /**< The force on the left tool is valid. */
    VBSS_METRICS_HAS_RIGHT_FORCE = 8 /**< The force on the right tool is valid. */
};

/** Positions of the tools and forces on them. Fill it with #vbss_metrics_sample_init, then set the
 * known parts. */
typedef struct vbss_metrics_sample {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t valid;       /**< VBSS_METRICS_HAS_ bits; default 0. */
    uint64_t step;        /**< Step number of the simulator; it is only passed on. */
    double time; /**< Time of the sample, s, at most 1e9 in magnitude, after the last sample. */
    /** Positions of the left and the right tip, m, each coordinate at most 1e3 in magnitude. */
    double position[2][3];
    /** Forces on the left and the right tool, N, each component at most 1e6 in magnitude. */
    double force[2][3];
    /** Time that the simulation has left out since its clock began, s, at most 1e9 and not less
     * than in the last sample; default 0. It is part of `time`. */
    double time_lost;
} vbss_metrics_sample;

/** Kind of an event: a VBSS_METRICS_EVENT_ constant. */
typedef int32_t vbss_metrics_event_kind;

/** The constants of #vbss_metrics_event_kind. Each says whether it can be undone. An event that is
 * reported again replaces its predecessor. */
enum {
    VBSS_METRICS_EVENT_NEEDLE_APPEARS = 1, /**< The clock starts. Can be undone. */
    VBSS_METRICS_EVENT_PHASE = 2,          /**< The phase `number` of the task begins. */
    /** The needle has passed through at mark `number` (0, 1), off by `angle` and `axial`. Undone:
     * the puncture was withdrawn and counts as an attempt. */
    VBSS_METRICS_EVENT_PUNCTURE = 3,
    VBSS_METRICS_EVENT_TAIL = 4, /**< Tail `number` (0, 1) is `amount` m long. Can be undone. */
    /** Tail `number` (0, 1) was cut; `amount` m are left. Can be undone. */
    VBSS_METRICS_EVENT_TAIL_CUT = 5,
    /** The slit gapes from `position` to `other`; its widest gap is `amount` m. Can be undone. */
    VBSS_METRICS_EVENT_GAP = 6,
    /** Throw `number` (0 next to the tissue) is tied, with `wraps`, `handedness` and `relation`. A
     * repeated event corrects them. Undone: the throw was untied. */
    VBSS_METRICS_EVENT_THROW = 7,
    VBSS_METRICS_EVENT_TRANSFER = 8, /**< `tool` took over the needle. Can be undone. */
    /** `tool` should have taken over the needle, and did not. Can be undone. */
    VBSS_METRICS_EVENT_TRANSFER_MISSED = 9,
    VBSS_METRICS_EVENT_DROP = 10, /**< The host's object `number` was dropped. Can be undone. */
    /** A penalty that the host defines: `number` identifies it, and it costs `amount` points. Can
     * be undone. */
    VBSS_METRICS_EVENT_HOST = 11,
    /** The drain was torn off. The score becomes zero. Can be undone. */
    VBSS_METRICS_EVENT_AVULSED = 12,
    /** The thread broke, or was cut early. The score becomes zero. Can be undone. */
    VBSS_METRICS_EVENT_BROKEN = 13,
    /** The trainee was assisted, by aid `number`. The score becomes zero. Can be undone. */
    VBSS_METRICS_EVENT_ASSISTED = 14
};

/** Relation of a throw to the throw before: a VBSS_METRICS_RELATION_ constant. */
typedef int32_t vbss_metrics_relation;

/** The constants of #vbss_metrics_relation. */
enum {
    VBSS_METRICS_RELATION_UNKNOWN = 0, /**< The relation is not known. */
    VBSS_METRICS_RELATION_FIRST = 1,   /**< There is no throw before. */
    VBSS_METRICS_RELATION_SQUARE = 2,  /**< The throw has the opposite handedness. */
    VBSS_METRICS_RELATION_GRANNY = 3   /**< The throw has the same handedness. */
};

/** An event. Fill it with #vbss_metrics_event_init, then set the fields of its kind. */
typedef struct vbss_metrics_event {
    uint32_t struct_size;         /**< Size of this struct in bytes, set by the init function. */
    vbss_metrics_event_kind kind; /**< Kind of the event; the default 0 is refused. */
    vbss_metrics_tool tool;       /**< The tool that was used; default VBSS_METRICS_TOOL_NONE. */
    uint32_t number;    /**< Meaning depends on the kind; for throws 0 to 63; default 0. */
    uint32_t undone;    /**< 1: the event is undone; default 0. */
    int32_t wraps;      /**< THROW: wraps, 1 single, 2 double, at most 64; default 0: not known. */
    int32_t handedness; /**< THROW: +1 right-handed, -1 left-handed, 0 not known (default). */
    vbss_metrics_relation relation; /**< THROW: relation to the throw before; default UNKNOWN. */
    uint64_t step;                  /**< Step number of the simulator; it is only passed on. */
    double time; /**< Time, s, at most 1e9 in magnitude, not before that of the last input. */
    double position[3]; /**< Position of the event, m, each coordinate at most 1e3 in magnitude. */
    double force[3];    /**< Force at the event, N, each component at most 1e6 in magnitude. */
    /** GAP: point on the other side, m, each coordinate at most 1e3 in magnitude. */
    double other[3];
    double angle;  /**< PUNCTURE: offset about the axis, rad, -pi to pi. */
    double axial;  /**< PUNCTURE: offset along the axis, m, at most 1e3 in magnitude. */
    double amount; /**< Meaning depends on the kind; 0 to 1e6. */
} vbss_metrics_event;

/** A reading of the pull test. Fill it with #vbss_metrics_pull_init, then set its fields. */
typedef struct vbss_metrics_pull {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** 1: a new test begins, and the results of an earlier one are discarded; default 0. */
    uint32_t begins;
    uint32_t tied;     /**< 1 (default): the knot is still there; 0: its topology is lost. */
    uint32_t reserved; /**< Zero. */
    uint64_t step;     /**< Step number of the simulator; it is only passed on. */
    double time;       /**< Time, s, at most 1e9 in magnitude, not before that of the last input. */
    double strain[2];  /**< Strain of the thread between the knot and each tool, -1 to 1. */
    double force[2];   /**< Force with which each tool pulls, N, 0 to 1e6. */
    double drawn_in;   /**< Tail drawn into the knot since the test began, m, at most 1e3. */
} vbss_metrics_pull;

/** Tightness of a knot in the points of FLS: a VBSS_METRICS_TIGHTNESS_ constant. */
typedef int32_t vbss_metrics_tightness;

/** The constants of #vbss_metrics_tightness. */
enum {
    /** The knot was not pulled, or the pull test is incomplete. */
    VBSS_METRICS_TIGHTNESS_UNKNOWN = -1,
    VBSS_METRICS_TIGHTNESS_TIGHT = 0,  /**< The knot holds. */
    VBSS_METRICS_TIGHTNESS_SLIPS = 10, /**< The knot slips. */
    VBSS_METRICS_TIGHTNESS_UNTIED = 20 /**< The knot comes apart. */
};

/** Bits of the flags of a report. */
enum {
    VBSS_METRICS_FLAG_STARTED = 1,    /**< The needle has appeared. */
    VBSS_METRICS_FLAG_STOPPED = 2,    /**< Both tails are cut, and the time has stopped. */
    VBSS_METRICS_FLAG_PUNCTURE_0 = 4, /**< The deviation from the first mark is known. */
    VBSS_METRICS_FLAG_PUNCTURE_1 = 8, /**< The deviation from the second mark is known. */
    VBSS_METRICS_FLAG_GAP = 16,       /**< The gap is known. */
    VBSS_METRICS_FLAG_TAIL_0 = 32,    /**< The length of the first tail is known. */
    VBSS_METRICS_FLAG_TAIL_1 = 64,    /**< The length of the second tail is known. */
    VBSS_METRICS_FLAG_FINISHED = 128, /**< #vbss_metrics_finish was called. */
    VBSS_METRICS_FLAG_AVULSED = 256,  /**< The drain was torn off. */
    VBSS_METRICS_FLAG_BROKEN = 512,   /**< The thread broke. */
    VBSS_METRICS_FLAG_TIMEOUT = 1024, /**< The time has run out. */
    /** The score is that of a whole trial: stopped, with deviations, gap and tightness known, or
     * zero for good. Without this bit the score assumes that nothing more is found. */
    VBSS_METRICS_FLAG_FINAL = 2048,
    /** More than `lost_share` of the time is lost. Time and score include it and do not compare with those of other
     * trials. */
    VBSS_METRICS_FLAG_TIME_LOST = 4096,
    VBSS_METRICS_FLAG_ASSISTED = 8192 /**< The trainee was assisted: there is no score. */
};

/** The results of a trial so far. An unknown value is 0, and its bit is not set. */
typedef struct vbss_metrics_report {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t
        flags; /**< VBSS_METRICS_FLAG_ bits: which values are known, and how the trial ended. */
    vbss_metrics_tightness tightness_pull;   /**< Tightness by the pull test. */
    vbss_metrics_tightness tightness_strain; /**< Tightness by the strain when both tools pull. */
    uint32_t throw_count;                    /**< Number of throws in the knot. */
    uint32_t square_count;  /**< Number of throws that are square to the one before. */
    uint32_t granny_count;  /**< Number of throws that make a granny with the one before. */
    uint32_t unknown_count; /**< Number of throws whose relation is not known. */
    /** Number of records for #vbss_metrics_get_throw, undone throws included. */
    uint32_t throw_records;
    uint32_t phase_count;      /**< Number of visits for #vbss_metrics_get_phase. */
    uint32_t penalty_count;    /**< Number of penalties for #vbss_metrics_get_penalty. */
    uint32_t transfers;        /**< Number of needle transfers. */
    uint32_t transfers_missed; /**< Number of missed needle transfers. */
    uint32_t attempts[2];      /**< Number of withdrawn punctures at each mark. */
    uint32_t drops;            /**< Number of drops. */
    uint32_t host_penalties;   /**< Number of penalties of the host. */
    uint32_t reserved;         /**< Zero. */
    uint64_t samples;          /**< Number of samples accepted. */
    /** Number of ticks of motion evaluated so far, for the tool that has more of them. */
    uint64_t ticks;
    uint64_t ticks_lost; /**< Number of ticks not measured because `duration` was used up. */
    /** Time from the needle's appearance until both tails were cut, or until now, s, on the clock
     * of the hands. It includes `time_lost`. */
    double time;
    double deviation_mm[2]; /**< Deviation of each puncture from its mark, along the drain, mm. */
    double gap_mm;          /**< Gap between the two points of the event GAP, mm. */
    double gap_largest_mm;  /**< Gap where the slit gapes most, mm. */
    double tail_mm[2];      /**< Length of each tail, after the cut if it was cut, mm. */
    double pull_held;       /**< Longest time for which the knot bore the pull, s. */
    double pull_strain;     /**< Largest strain that both sides reached. */
    double drawn_in_mm;     /**< Largest length of tail drawn in, mm. */
    double score;           /**< max_time - time - penalties, not below zero. */
    double penalties;       /**< Sum of the penalties. */
    uint64_t outliers[2];   /**< Samples of the left and the right tool left out as outliers. */
    /** How often outliers lasted for more than 0.1 s, so that a new run began, for each tool. */
    uint32_t jumps[2];
    double time_lost;      /**< Part of `time` that the simulation left out, s. */
    double time_simulated; /**< Time that was simulated, s: `time` minus `time_lost`. */
} vbss_metrics_report;

/** A throw that was tied. Records are in the order of their first events. */
typedef struct vbss_metrics_throw {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    uint32_t number;                /**< Position in the knot; 0 is next to the tissue. */
    uint32_t standing;              /**< 1: the throw is tied; 0: it was untied. */
    vbss_metrics_tool tool;         /**< The tool that tied it. */
    int32_t wraps;                  /**< Number of wraps: 1 single, 2 double, 0 not known. */
    int32_t handedness;             /**< +1 right-handed, -1 left-handed, 0 not known. */
    vbss_metrics_relation relation; /**< Relation to the throw before. */
    uint32_t reserved;              /**< Zero. */
    uint64_t step;                  /**< Step of its first event. */
    double time;                    /**< Time of its first event, s. */
    double undone_time;             /**< Time at which it was untied, s; 0 while it is tied. */
    double position[3];             /**< Position of the throw, m. */
    double force[3];                /**< Force at the throw, N. */
} vbss_metrics_throw;

/** A visit of a phase. A phase may be visited more than once. */
typedef struct vbss_metrics_phase {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t number;      /**< The host's number of the phase. */
    /** 1: another phase has begun; 0: `end` is the current time, or the end of the trial. */
    uint32_t ended;
    uint32_t reserved; /**< Zero. */
    uint64_t step;     /**< Step at which the phase began. */
    double begin;      /**< Time at which the phase began, s. */
    double end;        /**< Time at which the phase ended, s. */
} vbss_metrics_phase;

/** Reason for a penalty: a VBSS_METRICS_PENALTY_ constant. */
typedef int32_t vbss_metrics_penalty_kind;

/** The constants of #vbss_metrics_penalty_kind. */
enum {
    VBSS_METRICS_PENALTY_DEVIATION = 1, /**< A puncture is off its mark by `measure` mm. */
    VBSS_METRICS_PENALTY_GAP = 2,       /**< The slit gapes by `measure` mm. */
    VBSS_METRICS_PENALTY_TIGHTNESS = 3, /**< The knot slips (`measure` is 10) or is untied (20). */
    VBSS_METRICS_PENALTY_THROWS = 4,    /**< `measure` throws are missing. */
    VBSS_METRICS_PENALTY_GRANNY = 5,    /**< A throw has the same handedness as the one before. */
    VBSS_METRICS_PENALTY_ATTEMPT = 6,   /**< A puncture was withdrawn. */
    VBSS_METRICS_PENALTY_DROP = 7,      /**< Something was dropped. */
    VBSS_METRICS_PENALTY_TRANSFER = 8,  /**< A needle transfer was missed. */
    VBSS_METRICS_PENALTY_HOST = 9,      /**< A penalty of the host of `measure` points. */
    VBSS_METRICS_PENALTY_TIMEOUT = 10,  /**< The time has run out; it costs all remaining points. */
    /** The drain was torn off; it costs all remaining points. */
    VBSS_METRICS_PENALTY_AVULSED = 11,
    VBSS_METRICS_PENALTY_BROKEN = 12, /**< The thread broke; it costs all remaining points. */
    /** The trial ended before both tails were cut; it costs all remaining points. */
    VBSS_METRICS_PENALTY_INCOMPLETE = 13,
    /** More than `lost_share` of the time was lost; `measure` is the lost time, s. It costs no
     * points. */
    VBSS_METRICS_PENALTY_TIME_LOST = 14,
    /** The trainee was assisted; it costs all remaining points. */
    VBSS_METRICS_PENALTY_ASSISTED = 15
};

/** One reason why the score is not max_time - time. Faults that cost no points are listed too. */
typedef struct vbss_metrics_penalty {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    vbss_metrics_penalty_kind kind; /**< Kind of the penalty. */
    uint32_t number;        /**< Number of the mark, throw or other object, as in the event. */
    vbss_metrics_tool tool; /**< The tool that was used. */
    uint64_t step;          /**< Step of the penalty. */
    double time;            /**< Time of the penalty, s. */
    double measure;         /**< Size of the fault; its meaning depends on the kind. */
    double amount;          /**< Points that it costs. */
    double position[3];     /**< Position, m. */
    double force[3];        /**< Force, N. */
    const char *text;       /**< Description, a constant string; never NULL. */
} vbss_metrics_penalty;

/** The `phase` argument for the whole task. */
enum {
    /** From the needle's appearance until both tails were cut; without a needle, the whole
     * recording. */
    VBSS_METRICS_PHASE_ALL = -1
};

/** Bits for the measures of motion that could be computed. */
enum {
    VBSS_METRICS_HAS_LDJ = 1,        /**< `ldj_length` and `ldj_speed` are valid. */
    VBSS_METRICS_HAS_SPARC = 2,      /**< `sparc` is valid: the motion lasts at most 40.96 s. */
    VBSS_METRICS_HAS_MOVEMENTS = 4,  /**< `movement_sparc` is valid. */
    VBSS_METRICS_HAS_CORRELATION = 8 /**< `correlation` is valid. */
};

/** Motion of one tool, and the force on it. */
typedef struct vbss_metrics_motion {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t valid;          /**< VBSS_METRICS_HAS_ bits. */
    uint32_t movement_count; /**< Number of movements between rests that last 0.2 s to 40.96 s. */
    uint32_t reserved;       /**< Zero. */
    double time;             /**< Time in which the tool was seen, s. */
    double unseen_time;      /**< Time in which the tool was not seen, s. */
    double path_length;      /**< Length of the path, m. */
    double mean_speed;       /**< Mean speed, m/s. */
    double peak_speed;       /**< Peak speed, m/s. */
    double idle_time;        /**< Time in which the tool was idle, s. */
    double idle_share;       /**< Idle share of `time`, 0 to 1. */
    /** Log dimensionless jerk by length, -ln(T^5/L^2 integral of |jerk|^2); higher is smoother. */
    double ldj_length;
    /** Log dimensionless jerk by peak speed, -ln(T^3/v_peak^2 integral of |jerk|^2); higher is
     * smoother. */
    double ldj_speed;
    double sparc;          /**< Spectral arc length of the whole motion as one movement. */
    double movement_sparc; /**< Mean spectral arc length over the movements. */
    double force_peak;     /**< Largest force, N. */
    double force_integral; /**< Integral of the magnitude of the force over time, N s. */
} vbss_metrics_motion;

/** Joint motion of both tools. */
typedef struct vbss_metrics_bimanual {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    uint32_t valid;           /**< VBSS_METRICS_HAS_CORRELATION, or 0. */
    double time;              /**< Time in which both tools were seen, s. */
    double correlation;       /**< Pearson's correlation of their speeds, -1 to 1. */
    double both_moving_time;  /**< Time in which both tools moved, s. */
    double one_moving_time;   /**< Time in which exactly one tool moved, s. */
    double still_time;        /**< Time in which both tools were idle, s. */
    double both_moving_share; /**< `both_moving_time` as a share of `time`, 0 to 1. */
} vbss_metrics_bimanual;

/** An array: a VBSS_METRICS_VIEW_ constant. */
typedef int32_t vbss_metrics_field;

/** The constants of #vbss_metrics_field. Row i belongs to the time of the first sample plus i / 100
 * s. */
enum {
    /** x 1 double: speed of the left tool, m/s; 0 where it was not seen. */
    VBSS_METRICS_VIEW_LEFT_SPEED = 0,
    /** x 1 double: speed of the right tool, m/s; 0 where it was not seen. */
    VBSS_METRICS_VIEW_RIGHT_SPEED = 1,
    /** x 1 double: |jerk|^2 of the left tool, m^2/s^6; 0 where it was not seen for 0.25 s without a
     * gap. */
    VBSS_METRICS_VIEW_LEFT_JERK = 2,
    /** x 1 double: |jerk|^2 of the right tool, m^2/s^6; 0 where it was not seen for 0.25 s without
     * a gap. */
    VBSS_METRICS_VIEW_RIGHT_JERK = 3,
    /** x 1 double: largest |force| on the left tool in that hundredth of a second, N. */
    VBSS_METRICS_VIEW_LEFT_FORCE = 4,
    /** x 1 double: largest |force| on the right tool in that hundredth of a second, N. */
    VBSS_METRICS_VIEW_RIGHT_FORCE = 5
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
VBSS_API vbss_result vbss_metrics_config_init(vbss_metrics_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_metrics_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_metrics_config vbss_metrics_config_default(void)
{
    vbss_metrics_config vbss_filled;
    (void)vbss_metrics_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a sample with the defaults: no part is valid.
 *
 * @param[out] sample  the sample to fill
 * @param struct_size  `sizeof *sample` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_sample_init(vbss_metrics_sample *sample, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_metrics_sample_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_metrics_sample vbss_metrics_sample_default(void)
{
    vbss_metrics_sample vbss_filled;
    (void)vbss_metrics_sample_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills an event with the defaults; the host sets its kind.
 *
 * @param[out] event   the event to fill
 * @param struct_size  `sizeof *event` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_event_init(vbss_metrics_event *event, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_metrics_event_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_metrics_event vbss_metrics_event_default(void)
{
    vbss_metrics_event vbss_filled;
    (void)vbss_metrics_event_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a reading of the pull test with the defaults: tied, without force.
 *
 * @param[out] pull    the reading to fill
 * @param struct_size  `sizeof *pull` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_pull_init(vbss_metrics_pull *pull, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_metrics_pull_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_metrics_pull vbss_metrics_pull_default(void)
{
    vbss_metrics_pull vbss_filled;
    (void)vbss_metrics_pull_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates an empty measurement and allocates all memory that it needs.
 *
 * @param context       owner
 * @param config        configuration; NULL for the defaults
 * @param[out] metrics  the new measurement; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_create(vbss_context *context, const vbss_metrics_config *config,
                                         vbss_metrics **metrics);

/**
 * Destroys a measurement.
 *
 * @param metrics  the measurement; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_destroy(vbss_metrics *metrics);

/**
 * Adds a sample. A tool that was not seen for more than 0.1 s starts a new run where it reappears;
 * the gap adds no path. A position that the hand cannot have reached with `max_speed` is an
 * outlier. It is counted and left out, and the curve bridges it like a lost sample. Later positions
 * that are nearer to the outlier are outliers, too. After 0.1 s of outliers the tool has jumped: it
 * counts as not seen for that time, and a new run starts at its position. The call allocates
 * nothing; motion beyond `duration` is counted as lost.
 *
 * @param metrics  the measurement
 * @param sample   the sample
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards),
 *         VBSS_ERROR_WRONG_STATE (the measurement has finished), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed then
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_add_sample(vbss_metrics *metrics,
                                             const vbss_metrics_sample *sample);

/**
 * Adds an event, also after #vbss_metrics_finish.
 *
 * @param metrics  the measurement
 * @param event    the event
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards),
 *         VBSS_ERROR_NOT_FOUND (the event to undo is not in force), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed
 *         then
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_add_event(vbss_metrics *metrics, const vbss_metrics_event *event);

/**
 * Adds a reading of the pull test, also after #vbss_metrics_finish.
 *
 * @param metrics  the measurement
 * @param pull     the reading
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed then
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_add_pull(vbss_metrics *metrics, const vbss_metrics_pull *pull);

/**
 * Ends the samples: computes the motion up to the last one and refuses further samples. A second
 * call does nothing.
 *
 * @param metrics  the measurement
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_finish(vbss_metrics *metrics);

/**
 * Returns the results of the trial so far.
 *
 * @param metrics      the measurement
 * @param[out] report  receives the report
 * @param struct_size  `sizeof *report` as the caller was compiled; fields that the library does not
 *         know become zero
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_report(vbss_metrics *metrics, vbss_metrics_report *report,
                                             uint32_t struct_size);

/**
 * Returns one record of a throw.
 *
 * @param metrics          the measurement
 * @param index            0 to throw_records - 1
 * @param[out] record      receives the record
 * @param struct_size      `sizeof *record` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such record)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_throw(vbss_metrics *metrics, uint32_t index,
                                            vbss_metrics_throw *record, uint32_t struct_size);

/**
 * Returns one visit of a phase.
 *
 * @param metrics      the measurement
 * @param index        0 to phase_count - 1
 * @param[out] phase   receives the visit
 * @param struct_size  `sizeof *phase` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such visit)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_phase(vbss_metrics *metrics, uint32_t index,
                                            vbss_metrics_phase *phase, uint32_t struct_size);

/**
 * Returns one penalty. Their sum is max_time - time - score, unless it exceeds max_time - time; the
 * score is zero then.
 *
 * @param metrics       the measurement
 * @param index         0 to penalty_count - 1
 * @param[out] penalty  receives the penalty
 * @param struct_size   `sizeof *penalty` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such penalty)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_penalty(vbss_metrics *metrics, uint32_t index,
                                              vbss_metrics_penalty *penalty, uint32_t struct_size);

/**
 * Returns the motion of a tool. The call takes some ms for a minute of motion; do not call it in
 * every step.
 *
 * @param metrics      the measurement
 * @param tool         VBSS_METRICS_TOOL_LEFT or VBSS_METRICS_TOOL_RIGHT
 * @param phase        index of a visit of a phase, or VBSS_METRICS_PHASE_ALL
 * @param[out] motion  receives the motion
 * @param struct_size  `sizeof *motion` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE (no such tool), VBSS_ERROR_NOT_FOUND (no such visit) or
 *         VBSS_ERROR_ARITHMETIC_MODE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_motion(vbss_metrics *metrics, vbss_metrics_tool tool,
                                             int32_t phase, vbss_metrics_motion *motion,
                                             uint32_t struct_size);

/**
 * Returns the joint motion of both tools.
 *
 * @param metrics        the measurement
 * @param phase          index of a visit of a phase, or VBSS_METRICS_PHASE_ALL
 * @param[out] bimanual  receives the joint motion
 * @param struct_size    `sizeof *bimanual` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_NOT_FOUND (no such visit) or VBSS_ERROR_ARITHMETIC_MODE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_bimanual(vbss_metrics *metrics, int32_t phase,
                                               vbss_metrics_bimanual *bimanual,
                                               uint32_t struct_size);

/**
 * Returns a view of an array.
 *
 * @param metrics      the measurement
 * @param field        the array
 * @param[out] view    receives the view
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_view(vbss_metrics *metrics, vbss_metrics_field field,
                                           vbss_view *view, uint32_t struct_size);

/**
 * Computes the offset of a place on a cylinder from a mark on it, as the event of a puncture needs
 * it.
 *
 * @param axis         direction of the axis through `centre`, of any length
 * @param centre       a point on the axis, m
 * @param mark         the mark, m; only its direction from the axis and its position along it
 *         matter
 * @param place        the place, m; only its direction from the axis and its position along it
 *         matter
 * @param[out] angle   from mark to place about the axis, right-handed, -pi to pi, rad
 * @param[out] axial   from mark to place along the axis, m
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE, or VBSS_ERROR_OUT_OF_RANGE (numbers above 1e3, no
 *         axis, mark or place on it)
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_offset(const double axis[3], const double centre[3],
                                             const double mark[3], const double place[3],
                                             double *angle, double *axial);

/**
 * Saves the whole measurement.
 *
 * @param metrics       the measurement
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of `bytes`
 * @param[out] written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_save(vbss_metrics *metrics, uint8_t *bytes, uint64_t capacity,
                                       uint64_t *written);

/**
 * Restores a snapshot of a measurement with the same configuration, completely or not at all.
 *
 * @param metrics  the measurement
 * @param bytes    the snapshot
 * @param count    its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: the snapshot has another configuration),
 *         VBSS_ERROR_DATA_VERSION, VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY; on failure nothing has changed
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_restore(vbss_metrics *metrics, const uint8_t *bytes,
                                          uint64_t count);

/**
 * Returns a hash of the whole measurement; equal logs give equal hashes on every machine. The cost
 * grows with the length of the trial; do not call it in every step.
 *
 * @param metrics    the measurement
 * @param[out] hash  receives the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_metrics_get_hash(vbss_metrics *metrics, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
