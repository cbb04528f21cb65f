/* Private interface of measurements, for the files of lib/metrics. It depends on lib/base only.
 *
 * config.c checks configurations; metrics.c creates and destroys measurements; samples.c, events.c
 * and pull_test.c take the host's input. Motion is processed in stages: samples -> outliers.c -> tracks.c (ticks
 * of both tools, by smoothing.c and, near the ends of a run, run_ends.c) -> motion.c and spectrum.c
 * (metrics of a window of ticks). penalties.c and report.c compute the results; snapshot.c saves
 * measurements. */
#ifndef VBSS_METRICS_METRICS_H
#define VBSS_METRICS_METRICS_H

#include <stddef.h>

#include <vblast_ss/metrics.h>

#include "base/linear.h"
#include "base/slot.h"
#include "metrics/tuning.h"

enum { METRICS_HANDS = 2 };

/* ---- sampling grids: fine samples of the interpolated curve, and ticks at which motion is
 * measured. Chosen; other rates give other figures. */
#define METRICS_FINE_RATE 1000.0
#define METRICS_TICK_RATE 100.0
#define METRICS_TICK_SECONDS 0.01
enum {
    METRICS_FINE_PER_TICK = 10,      /* derived */
    METRICS_FILTER_HALF_WIDTH = 250, /* chosen: half width of the filter, in fine samples */
    /* half width of the filter's third difference */
    METRICS_KERNEL_HALF_WIDTH = METRICS_FILTER_HALF_WIDTH + 2,
    /* number of fine samples that are stored */
    METRICS_RING_SIZE = 512
};
/* Bounds on all input, so that all results are finite: s, m, N. Chosen. */
#define METRICS_LARGEST_TIME 1e9
#define METRICS_LARGEST_POSITION 1e3
#define METRICS_LARGEST_FORCE 1e6

/* Differences of the filter's taps: weights for the first and third derivative, for pairs of
 * samples i to both sides. */
typedef struct metrics_kernel {
    double first[METRICS_KERNEL_HALF_WIDTH + 1], third[METRICS_KERNEL_HALF_WIDTH + 1];
} metrics_kernel;

/* One tool: its last samples and its ticks. */
typedef struct metrics_hand {
    /* number of the last points of the run below, at most 3, the newest last; a point is a sample
     * that is not an outlier */
    uint32_t point_count;
    double time[3];
    vec3 position[3];
    uint64_t run_start;   /* index of the first fine sample of the run */
    uint64_t next_fine;   /* index of the next fine sample */
    uint32_t still_count; /* number of equal fine samples in a row, at most METRICS_RING_SIZE */
    vec3 *ring;           /* ring buffer of the last fine samples */
    uint32_t has_outlier; /* the last sample was an outlier, with this time and position */
    double outlier_time;
    vec3 outlier;
    uint64_t outlier_count; /* samples that were left out */
    uint32_t jump_count;    /* runs that ended because outliers lasted */
    uint32_t has_force;
    double force_time, force; /* time and magnitude of the last force, s and N */
    uint32_t tick_count, force_count;
    /* per tick: speed, m/s, and squared jerk, m^2/s^6; 0 if the tool was not seen */
    double *speed, *jerk;
    uint8_t *seen; /* per tick */
    /* per tick: integral and maximum of the force up to the next tick, N s and N */
    double *impulse, *peak;
} metrics_hand;

/* ---- events */
/* Events of which only the last one counts, as indices of metrics_object.facts. PUNCTURE, TAIL and
 * CUT have two entries each. */
typedef enum metrics_fact {
    METRICS_APPEARED,
    METRICS_PUNCTURE,
    METRICS_TAIL = METRICS_PUNCTURE + 2,
    METRICS_CUT = METRICS_TAIL + 2,
    METRICS_GAP = METRICS_CUT + 2,
    METRICS_AVULSED,
    METRICS_BROKEN,
    METRICS_FACT_COUNT
} metrics_fact;

/* An event that is valid, or was until it was undone. Undoing a puncture leaves an entry of the
 * kind PUNCTURE among the incidents: an attempt. */
typedef struct metrics_entry {
    vbss_metrics_event_kind kind;
    uint32_t number, is_active; /* is_active: 0 once the event is undone */
    int32_t tool, wraps, handedness, relation;
    uint64_t step;
    double time, undone_time;
    double time_lost; /* metrics_object.time_lost when it arrived */
    /* deviation, mm; tail length, m; gap and largest gap, mm; or penalty points */
    double value[2];
    vec3 position, force;
} metrics_entry;

typedef struct metrics_phase {
    uint32_t number;
    uint64_t step;
    double start_time;
} metrics_phase;

/* State of the pull test. */
typedef struct metrics_pull {
    uint32_t has_readings, is_tight, has_slipped,
        is_untied;               /* 1: so; tight: borne long enough before it slipped */
    uint32_t has_reached_strain; /* the threshold of strain was reached while it was tied */
    uint32_t is_holding;
    double hold_start, longest_hold, strain, drawn_in;
    metrics_entry last_change; /* the reading that last changed the result */
} metrics_pull;

typedef struct metrics_object {
    vbss_context *context;
    vbss_metrics_config config;
    uint64_t tick_capacity;
    metrics_kernel *kernel;
    metrics_hand hands[METRICS_HANDS];
    uint64_t samples;
    /* flags: any input has arrived; a sample has arrived; no more samples are accepted */
    uint32_t has_time, has_sample, is_finished;
    double origin_time;            /* time of the first sample, s */
    double sample_time, last_time; /* times of the last sample and of the last input, s */
    double time_lost;              /* simulated time lost in all, as the last sample says, s */
    uint64_t last_step;            /* step of the last input */
    metrics_entry facts[METRICS_FACT_COUNT];
    metrics_entry *throws, *incidents;
    metrics_phase *phases;
    uint32_t throw_count, incident_count, phase_count;
    metrics_pull pull;
    uint64_t generation;
    double *spectrum_buffer; /* scratch of vbss_metrics_sparc */
} metrics_object;

/* Measurements (metrics.c) */
extern const vbss_kind vbss_metrics_kind;
/* The measurement behind a handle, for a query or for a change. VBSS_ERROR_INVALID_HANDLE; for a
 * change also VBSS_ERROR_BUSY and VBSS_ERROR_ARITHMETIC_MODE. */
vbss_result vbss_metrics_open(const vbss_metrics *handle, metrics_object **metrics);
vbss_result vbss_metrics_edit(vbss_metrics *handle, metrics_object **metrics);

/* Fills `own` with the defaults and copies the caller's config over them (config.c).
 * VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE and the errors of vbss_config_read. */
vbss_result vbss_metrics_read_config(vbss_context *context, const vbss_metrics_config *config,
                                     vbss_metrics_config *own);

/* The clock of all input (samples.c). VBSS_ERROR_OUT_OF_RANGE if a time is before that of the last
 * input. */
vbss_result vbss_metrics_check_time(const metrics_object *m, double time);
void vbss_metrics_advance_clock(metrics_object *m, double time, uint64_t step);

/* Filter and interpolation (smoothing.c) */
void vbss_metrics_make_kernel(metrics_kernel *kernel);
/* Speed, m/s, and squared jerk, m^2/s^6, of the filtered curve at a fine sample. The ring must hold
 * METRICS_KERNEL_HALF_WIDTH samples on both sides of it. */
void vbss_metrics_differentiate(const metrics_kernel *kernel, const vec3 *ring, uint64_t centre,
                                double *speed, double *jerk);
/* Cubic between two samples, with given velocities at its ends. */
typedef struct metrics_segment {
    double start_time, end_time;
    vec3 start, end, start_velocity, end_velocity;
} metrics_segment;
vec3 vbss_metrics_segment_at(const metrics_segment *segment, double time);
/* Velocity at the middle one of three samples, m/s. */
vec3 vbss_metrics_middle_velocity(const double time[3], const vec3 position[3]);

/* Speed, m/s, and squared jerk, m^2/s^6, at a fine sample of the run that is less than
 * METRICS_KERNEL_HALF_WIDTH from one of its ends (run_ends.c). */
void vbss_metrics_differentiate_end(const metrics_hand *h, uint64_t centre, double *speed,
                                    double *jerk);

/* Whether a sample is an outlier of the run; counts an outlier (outliers.c). */
bool vbss_metrics_is_outlier(const vbss_metrics_config *config, const metrics_hand *h, double time,
                             vec3 position);
void vbss_metrics_keep_outlier(metrics_hand *h, double time, vec3 position);

/* Tracks of the tools (tracks.c) */
void vbss_metrics_track_position(metrics_object *m, uint32_t hand, double time, vec3 position);
void vbss_metrics_track_force(metrics_object *m, uint32_t hand, double time, double force);
void vbss_metrics_finish_track(metrics_object *m, uint32_t hand);
/* First tick at or after a time, at most the capacity; and the number of ticks beyond the
 * capacity. */
uint64_t vbss_metrics_tick_from(const metrics_object *m, double time);
uint64_t vbss_metrics_ticks_lost(const metrics_object *m);

/* Spectrum (spectrum.c). The padding is published with the spectral arc length. */
enum { METRICS_SPECTRUM_TICKS = 4096, METRICS_SPECTRUM_PADDING = 16 };
#define METRICS_SPECTRUM_BUFFER_LENGTH \
    ((size_t)2 * METRICS_SPECTRUM_TICKS * METRICS_SPECTRUM_PADDING)
/* SPARC of a speed profile of 2 to METRICS_SPECTRUM_TICKS ticks. `buffer` is scratch of
 * METRICS_SPECTRUM_BUFFER_LENGTH numbers. Returns false if nothing moved. */
bool vbss_metrics_sparc(const double *speed, uint32_t count, double *buffer, double *sparc);

/* pull_test.c: whether a knot is tight, by the load that it bears, and by the strain that it has reached (Qi et al. 2017) */
vbss_metrics_tightness vbss_metrics_tightness_by_load(const metrics_pull *pull);
vbss_metrics_tightness vbss_metrics_tightness_by_strain(const metrics_pull *pull);

/* Clock of the task (report.c) */
/* time at which both tails were cut, or the time of the last input */
double vbss_metrics_stop_time(const metrics_object *m);
bool vbss_metrics_is_stopped(const metrics_object *m);
double vbss_metrics_task_time(const metrics_object *m);      /* duration of the task, s */
double vbss_metrics_task_time_lost(const metrics_object *m); /* its lost part, s */
/* Whether more than a share of a time was lost. Sessions use it, too. */
static inline bool vbss_metrics_is_time_lost(double lost, double time, double share)
{
    return lost > share * vbss_max(time, METRICS_LOST_TIME_WINDOW);
}

typedef struct metrics_score {
    double score, penalties;
    uint32_t count;
    bool is_final;
} metrics_score;
/* Score and penalties (penalties.c). `wanted` receives the penalty with the index `number`, if it
 * exists; it may be NULL. */
metrics_score vbss_metrics_compute_score(const metrics_object *m, uint32_t number,
                                         vbss_metrics_penalty *wanted);
/* Whether the trainee was assisted. */
bool vbss_metrics_is_assisted(const metrics_object *m);

/* Visits the state; the configuration must equal the saved one (snapshot.c). */
void vbss_metrics_serialise(vbss_stream *stream, void *object);

#endif
