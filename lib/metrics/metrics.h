/* The inside of a measurement, shared by the files of lib/metrics. Knows lib/base only.
 *
 * config.c checks what is wanted; metrics.c makes and ends; samples.c, events.c and pull_test.c take what is told. Motion goes
 * samples -> smoothing.c (one fine curve, filtered) -> tracks.c (ticks of both tools) -> motion.c and spectrum.c
 * (figures of a window of ticks). penalties.c and report.c say what it comes to; snapshot.c saves. */
#ifndef VBSS_METRICS_METRICS_H
#define VBSS_METRICS_METRICS_H

#include <stddef.h>

#include <vblast_ss/metrics.h>

#include "base/linear.h"
#include "base/slot.h"

enum { METRICS_HANDS = 2 };

/* ---- the grids: fine samples of an interpolated curve, ticks of what is measured */
#define METRICS_FINE_RATE 1000.0
#define METRICS_TICK_RATE 100.0
#define METRICS_TICK_SECONDS 0.01
enum {
    METRICS_FINE_PER_TICK = 10,
    METRICS_FILTER_HALF_WIDTH = 250, /* the filter reaches so many fine samples to each side, */
    METRICS_KERNEL_HALF_WIDTH = METRICS_FILTER_HALF_WIDTH + 2, /* its third difference so many */
    METRICS_RING_SIZE = 512                                    /* of fine samples that are kept */
};
/* What is told is at most so large: all that is computed stays finite. */
#define METRICS_LARGEST_TIME 1e9
#define METRICS_LARGEST_POSITION 1e3
#define METRICS_LARGEST_FORCE 1e6
/* A tool that was not seen for longer is gone: three samples at 30 Hz. */
#define METRICS_MAX_SAMPLE_GAP 0.1

/* Differences of the filter's taps: first and third derivative from pairs of samples m apart to both sides. */
typedef struct metrics_kernel {
    double first[METRICS_KERNEL_HALF_WIDTH + 1], third[METRICS_KERNEL_HALF_WIDTH + 1];
} metrics_kernel;

/* One tool: what it did last, and its ticks. */
typedef struct metrics_hand {
    uint32_t point_count; /* of the last unbroken samples, up to 3, the newest last */
    double time[3];
    vec3 position[3];
    vec3 offset;          /* from where it is to where it would be if it had not moved unseen */
    uint64_t next_fine;   /* the next fine sample */
    uint32_t still_count; /* fine samples of one place in a row, up to METRICS_RING_SIZE */
    vec3 *ring;           /* the last fine samples, by their number modulo the ring's size, */
    uint8_t *ring_seen;   /* and whether the tool was seen there */
    uint32_t has_force;
    double force_time, force; /* the last one */
    uint32_t tick_count, force_count;
    double *speed, *jerk;   /* per tick: |v|, |jerk|^2; 0 where it was not seen */
    uint8_t *seen;          /* per tick */
    double *impulse, *peak; /* per tick: of |force| up to the next tick */
} metrics_hand;

/* ---- what was told in events */
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

/* Something that stands or stood. An event that undoes a puncture leaves one of the kind PUNCTURE: an attempt. */
typedef struct metrics_entry {
    vbss_metrics_event_kind kind;
    uint32_t number, standing;
    int32_t tool, wraps, handedness, relation;
    uint64_t step;
    double time, undone_time;
    double value[2]; /* deviation; length; gap and largest gap; points */
    vec3 position, force;
} metrics_entry;

typedef struct metrics_phase {
    uint32_t number;
    uint64_t step;
    double start_time;
} metrics_phase;

/* What the pull test has found so far. */
typedef struct metrics_pull {
    uint32_t has_readings, is_tight, has_slipped,
        is_untied;               /* 1: so; tight: borne long enough before it slipped */
    uint32_t has_reached_strain; /* the paper's threshold was reached while it was tied */
    uint32_t is_holding;
    double hold_start, longest_hold, strain, drawn_in;
    metrics_entry last_change; /* the reading that changed a verdict last */
} metrics_pull;

typedef struct metrics_object {
    vbss_context *context;
    vbss_metrics_config config;
    uint64_t tick_capacity;
    metrics_kernel *kernel;
    metrics_hand hands[METRICS_HANDS];
    uint64_t samples;
    uint32_t has_time, has_sample,
        is_finished;               /* anything was told; a sample was; no more will be */
    double origin_time;            /* time of the first sample */
    double sample_time, last_time; /* of the last sample; of what was told last */
    uint64_t last_step;            /* of what was told last */
    metrics_entry facts[METRICS_FACT_COUNT];
    metrics_entry *throws, *incidents;
    metrics_phase *phases;
    uint32_t throw_count, incident_count, phase_count;
    metrics_pull pull;
    uint64_t generation;
    double *spectrum_buffer; /* room for one */
} metrics_object;

/* metrics.c */
extern const vbss_kind vbss_metrics_kind;
vbss_result vbss_metrics_open(const vbss_metrics *handle, metrics_object **metrics);
vbss_result vbss_metrics_edit(vbss_metrics *handle, metrics_object **metrics);

/* config.c. The caller's over the defaults, every number checked. */
vbss_result vbss_metrics_read_config(vbss_context *context, const vbss_metrics_config *config,
                                     vbss_metrics_config *own);

/* samples.c. What is told now is not before what was told last, and not before the last sample. */
vbss_result vbss_metrics_check_time(const metrics_object *m, double time);
void vbss_metrics_advance_clock(metrics_object *m, double time, uint64_t step);

/* smoothing.c */
void vbss_metrics_make_kernel(metrics_kernel *kernel);
/* Speed and squared jerk of the filtered curve at a fine sample that has METRICS_KERNEL_HALF_WIDTH on both sides in the ring. */
void vbss_metrics_differentiate(const metrics_kernel *kernel, const vec3 *ring, uint64_t centre,
                                double *speed, double *jerk);
/* The curve between two samples, with slopes at its ends. */
typedef struct metrics_segment {
    double start_time, end_time;
    vec3 start, end, start_velocity, end_velocity;
} metrics_segment;
vec3 vbss_metrics_segment_at(const metrics_segment *segment, double time);
/* The slope at the middle of three samples. */
vec3 vbss_metrics_middle_velocity(const double time[3], const vec3 position[3]);

/* tracks.c */
void vbss_metrics_track_position(metrics_object *m, uint32_t hand, double time, vec3 position);
void vbss_metrics_track_force(metrics_object *m, uint32_t hand, double time, double force);
void vbss_metrics_finish_track(metrics_object *m, uint32_t hand);
/* The first tick not before a time, at most the room there is. */
uint64_t vbss_metrics_tick_from(const metrics_object *m, double time);
uint64_t vbss_metrics_ticks_lost(const metrics_object *m);

/* spectrum.c */
enum { METRICS_SPECTRUM_TICKS = 4096, METRICS_SPECTRUM_PADDING = 16 };
#define METRICS_SPECTRUM_BUFFER_LENGTH \
    ((size_t)2 * METRICS_SPECTRUM_TICKS * METRICS_SPECTRUM_PADDING)
/* SPARC of a speed profile of 2 to METRICS_SPECTRUM_TICKS ticks; false: nothing moved. `room` holds
 * METRICS_SPECTRUM_BUFFER_LENGTH numbers. */
bool vbss_metrics_sparc(const double *speed, uint32_t count, double *buffer, double *sparc);

/* pull_test.c */
vbss_metrics_tightness vbss_metrics_tightness_ours(const metrics_pull *pull);
vbss_metrics_tightness vbss_metrics_tightness_paper(const metrics_pull *pull);

/* report.c */
double vbss_metrics_stop_time(const metrics_object *m); /* both tails cut, or now */
bool vbss_metrics_is_stopped(const metrics_object *m);
double vbss_metrics_task_time(const metrics_object *m); /* of the task, s */

typedef struct metrics_score {
    double score, penalties;
    uint32_t count;
    bool is_final;
} metrics_score;
/* penalties.c. `wanted` receives the penalty with that number if there is one; may be NULL. */
metrics_score vbss_metrics_compute_score(const metrics_object *m, uint32_t number,
                                         vbss_metrics_penalty *wanted);

/* snapshot.c */
void vbss_metrics_serialise(vbss_stream *stream, void *object);

#endif
