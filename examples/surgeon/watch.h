/* One who watches the surgeon: what is told and painted, and how long the steps take. */
#ifndef VBSS_EXAMPLES_SURGEON_WATCH_H
#define VBSS_EXAMPLES_SURGEON_WATCH_H

#include <stdio.h>

#include "surgeon/surgeon.h"
#include "surgeon/task.h"

enum { WATCH_STEPS = 600000 }; /* of 1 ms, at most */

typedef struct watch_step {
    double time; /* of the CPU, s */
    surgeon_stage stage;
} watch_step;

struct watch;
/* One more who looks on: is called before the first step and after each one; ends the performance unless it gives VBSS_OK. */
typedef vbss_result watch_guest(void *user, const struct watch *w, surgeon *s);

typedef struct watch {
    surgeon_options options;
    task task;                /* beside the scene */
    double time_limit, every; /* s, simulated: of a run; between pictures */
    const char *folder;       /* for pictures of all that the hands do; may be NULL */
    const char *album;        /* for those of the key stages; may be NULL */
    bool verbose;
    watch_guest *guest; /* looks on, and then tells how far they are; may be NULL */
    void *user;         /* handed to it */
    int pictures;
    bool unpainted;    /* a picture could not be made */
    double next;       /* picture, s */
    double reported;   /* s: when it was last told how far they are */
    double began;      /* by a clock that goes on, s */
    double wall;       /* s that the performance took with all that watches it */
    watch_step *steps; /* WATCH_STEPS at most */
    uint32_t count;
    surgeon_stage last; /* of the last step */
    /* of each stage: its steps, when it began first, s, most that hands feel, N */
    uint32_t counts[SURGEON_DONE];
    double begin[SURGEON_DONE];
    double left[SURGEON_DONE], right[SURGEON_DONE];
    uint32_t max_contacts;      /* at a time */
    vbss_session_status status; /* in the end */
} watch;

/* From the needle on the floor on. `steps` has room for WATCH_STEPS. */
vbss_result watch_run(watch *w, surgeon *s, watch_step *steps);
/* The whole task was asked for, and the session says that it is done. */
bool watch_complete(const watch *w);
/* The largest force on either hand, N; infinite if the metrics do not tell it. Before the rig is destroyed. */
double watch_largest_force(const watch *w);
/* Plays the log back on the same scene, its session too: true, to equal hashes. */
bool watch_replay(const watch *w);
/* The force on the hand of a tool, N. */
double watch_feels(const hand *h);

/* ---- times.c */
double watch_wall_clock(void);
/* Of sorted steps, in us: the nearest rank. */
double watch_quantile(const watch_step *steps, uint32_t count, double share);
void watch_sort(watch_step *steps, uint32_t count);
/* Stage by stage, each sorted. */
void watch_sort_stages(watch_step *steps, uint32_t count);

/* ---- progress.c: how far they are, as they go; `enters`: a stage begins */
void watch_progress(watch *w, const surgeon *s, bool enters);
/* ---- album.c: the key stages, when the hands begin to do something else */
void watch_album(watch *w, const surgeon *s, const char *doing);
/* ---- report.c: in the end, what came of it; sorts the steps */
void watch_report(watch *w, const surgeon *s, vbss_result result);
/* ---- outcome.c: the same as a line of JSON; `is_good`: what the program makes of it; false: it could not be written */
bool watch_write_outcome(FILE *out, const watch *w, const surgeon *s, vbss_result result,
                         bool is_good);
/* ---- events.c: what happened, as the session says */
void watch_report_events(const watch *w);

#endif
