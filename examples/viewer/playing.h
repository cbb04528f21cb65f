/* A scene in a window under a person's hands: what the parts of it share. */
#ifndef VBSS_EXAMPLES_VIEWER_PLAYING_H
#define VBSS_EXAMPLES_VIEWER_PLAYING_H

#include "ghost/ghost.h"
#include "live.h"
#include "modes.h"
#include "orbit.h"
#include "pad.h"

typedef struct playing {
    const options *o;
    window window;
    show show;
    live live;
    arms *arms; /* NULL: there are none */
    orbit orbit;
    desk desk;
    pad pad;
    bool paused, once;       /* one frame's steps */
    bool again;              /* from the beginning */
    double clock;            /* of the last frame, s */
    double real_time_factor; /* simulated over real, smoothed */
    uint64_t frames;
    double motion[2];    /* counts that came, since the beginning */
    double next;         /* picture, s */
    uint64_t granted;    /* frames, in lockstep */
    start_states states; /* of exercises */
    ghost_track track;   /* of the ghost hands; without rows there are none */
    ghost ghost;
    bool has_ghost, hides_ghost;
    bool noted;         /* the exercise's outcome is in the file of progress */
    char progress[160]; /* whether it was saved, as a sentence */
    uint64_t reported;  /* the value that was reported last */
} playing;

/* ---- person.c: what the person does */
desk person_desk(playing *p);
mouse_hand *person_hand(playing *p);
/* Keys that are held, and a gamepad, for so long. */
vbss_result person_pull(playing *p, double seconds);

/* ---- ghosts.c: an expert's tools beside the person's */
/* From the file of the options, if they name one; false: it is wrong, and the fault was printed. */
bool ghosts_read(playing *p);
/* In the scene that has just begun. */
vbss_result ghosts_begin(playing *p);
/* After steps of so many seconds. */
vbss_result ghosts_step(playing *p, double seconds);
/* Hides them; shows them again, from the beginning of the phase. */
void ghosts_toggle(playing *p);

/* ---- captions.c: on the picture */
void captions_put(playing *p);

/* ---- reporting.c: a line a frame, for who plays by a script */
void reporting_frame(playing *p);
/* In lockstep a script grants frames: false if this one is not; what has come meanwhile is told. */
bool reporting_grants(playing *p);

#endif
