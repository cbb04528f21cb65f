/* The ways in which the viewer can be used. */
#ifndef VBSS_EXAMPLES_VIEWER_MODES_H
#define VBSS_EXAMPLES_VIEWER_MODES_H

#include <stdint.h>

enum { MAX_DEVICE_WORDS = 32 };
enum { MODE_NO_OPENGL = 77 }; /* what it exits with then */

typedef struct options {
    const char *log;               /* to be played back */
    const char *live;              /* or a scene to be played in */
    const char *keep;              /* its log */
    const char *exercise;          /* one skill, in place of the whole task; */
    const char *starts, *progress; /* its files; may be NULL */
    const char *ghost;             /* an expert's tools beside the person's: a file; may be NULL */
    const char *hands;             /* a log whose hands move its tools */
    unsigned long seed;            /* of it */
    char *devices[MAX_DEVICE_WORDS]; /* words for the trainer's part */
    int device_words;
    const char *folder; /* of stills */
    const char *film;
    double every, from, to; /* s, of pictures; every 0: as it is usual, live each frame */
    int width, height;
    uint32_t overlays; /* SHOW_ bits */
    int frame_steps;   /* of each frame, however long they take; 0: as many as the clock asks */
    int report;        /* 1: a line a frame, on standard output */
    int lockstep;      /* 1: a frame for each byte on standard input, and none without */
    int renew;         /* so many frames after the begin the context counts as lost; 0: never */
} options;

/* Without a window: stills, or a film (take.c). */
int mode_take(const options *o);
/* In a window (hands.c, replay.c). */
int mode_live(const options *o);
int mode_replay(const options *o);

#endif
