/* The gallery of knots: each is tied, watched and painted. */
#ifndef VBSS_EXAMPLES_GALLERY_H
#define VBSS_EXAMPLES_GALLERY_H

#include <vblast_ss/knot.h>

#include "fixtures/tied_knot.h"

/* What is kept of a moment. */
typedef struct gallery_frame {
    uint32_t stage;
    bool shows_pegs;
    vec3 pegs[TIED_KNOT_PEGS];
    vec3 *x; /* of the nodes */
} gallery_frame;

enum { GALLERY_FRAMES = 600, GALLERY_THROWS = 8 };

/* What the detector says of one. */
typedef struct gallery_reading {
    vbss_knot_state state;
    vbss_knot_throw throws[GALLERY_THROWS]; /* state.throw_count of them */
    char notation[32];
    double us; /* of processor time */
} gallery_reading;

typedef struct gallery_knot {
    /* what is wanted */
    const char *file;          /* name of the pictures, without folder and ending */
    const char *title;         /* ASCII */
    const char *notation;      /* what the detector must say of it */
    double width;              /* m, across the picture of the tight knot */
    double azimuth, elevation; /* rad, where it is seen from: 0, 0: along y */
    knot_kind kind;
    bool cylinder;
    bool tight, topology_kept; /* how it went, with all below */

    vbss_context *context;
    tied_knot knot;
    uint32_t frame_count, frames_judged, frames_right, frames_certified; /* certified: and right */
    gallery_frame frames[GALLERY_FRAMES]; /* the first: loose; the last: tight and held */
    double seconds;                       /* simulated until tight */
    double median, p99;                   /* us of processor time a step until then */
    double held;                          /* us, median while it is held */
    double force;                         /* N */
    double taken_up;                      /* m */
    double penetration;                   /* m, the worst of all steps; of stretch the same */
    double stretch;
    uint64_t retries, clamped;
    gallery_reading loose_reading, tight_reading; /* of the first frame and of the last */
} gallery_knot;

/* tie.c: false, with a line on stderr, when it cannot be. All is given back by gallery_end, also then. */
bool gallery_tie(gallery_knot *g);
void gallery_end(gallery_knot *g);
double gallery_processor_us(void);
void gallery_complain(const gallery_knot *g, vbss_result result);

/* judge.c: asks the detector about all frames; false, with a line on stderr, when it cannot be asked. */
bool gallery_judge(gallery_knot *g);
/* report.c: on stdout; false when a frame was not told right, or the first or last is not certified. */
bool gallery_report(const gallery_knot *g);

/* paint.c: <folder>/<file>.png, -stages.png and .svg; false, with a line on stderr, when that fails. */
bool gallery_paint(const gallery_knot *g, const char *folder);
/* throws.c: <folder>/<file>-throws.png and .svg, loose and tight, in the colours of the throws. */
bool gallery_paint_throws(const gallery_knot *g, const char *folder);

#endif
