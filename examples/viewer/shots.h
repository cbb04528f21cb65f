/* Pictures of a scene at even times, without a window: stills in a folder, or a film. */
#ifndef VBSS_EXAMPLES_VIEWER_SHOTS_H
#define VBSS_EXAMPLES_VIEWER_SHOTS_H

#include "movie.h"
#include "show.h"

typedef struct shots_plan {
    const char *folder; /* of the stills; NULL: a film is made */
    const char *film;   /* its file; NULL: stills are made */
    double every, from; /* s, simulated */
    int width, height;  /* pixels */
    uint32_t overlays;  /* SHOW_ bits */
} shots_plan;

typedef struct shots {
    shots_plan plan;
    show show;
    movie movie;
    uint8_t *pixels;
    uint32_t count; /* pictures drawn */
    bool filming;   /* the encoder was started */
    bool waits;     /* the last picture is drawn and not yet read */
} shots;

enum { SHOTS_RATE = 30 }; /* pictures in a second of a film */

/* An OpenGL context must be current. False, told on standard error: it cannot draw. In either case it is to be ended. */
bool shots_open(shots *t, const shots_plan *plan);
/* What it takes pictures of. False, told. */
bool shots_begin(shots *t, stage *s);
/* Before the first step and after each one; takes a picture when it is time for one. False, told. */
bool shots_step(shots *t, double time);
/* Writes what is not written yet, and ends the film. False, told: a picture or the film is missing. */
bool shots_finish(shots *t);
void shots_close(shots *t);

#endif
