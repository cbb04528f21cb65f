/* The gallery of knots: each is tied, watched and painted. */
#ifndef VBSS_EXAMPLES_GALLERY_H
#define VBSS_EXAMPLES_GALLERY_H

#include "scenes/tied_knot.h"

/* What is kept of a moment. */
typedef struct gallery_frame {
    uint32_t stage;
    bool shows_pegs;
    vec3 pegs[TIED_KNOT_PEGS];
    vec3 *x; /* of the nodes */
} gallery_frame;

enum { GALLERY_FRAMES = 600 };

typedef struct gallery_knot {
    /* what is wanted */
    const char *file;          /* name of the pictures, without folder and ending */
    const char *title;         /* ASCII */
    double width;              /* m, across the picture of the tight knot */
    double azimuth, elevation; /* rad, where it is seen from: 0, 0: along y */
    knot_kind kind;
    bool cylinder;
    bool tight, topology_kept; /* how it went, with all below */

    vbss_context *context;
    tied_knot knot;
    uint32_t frame_count;
    gallery_frame frames[GALLERY_FRAMES]; /* the first: loose; the last: tight and held */
    double seconds;                       /* simulated until tight */
    double median, p99;                   /* us of processor time a step until then */
    double held;                          /* us, median while it is held */
    double force;                         /* N */
    double taken_up;                      /* m */
    double penetration;                   /* m, the worst of all steps; of stretch the same */
    double stretch;
    uint64_t retries, clamped;
} gallery_knot;

/* tie.c: false, with a line on stderr, when it cannot be. All is given back by gallery_end, also then. */
bool gallery_tie(gallery_knot *g);
void gallery_end(gallery_knot *g);

/* paint.c: <folder>/<file>.png, -stages.png and .svg; false, with a line on stderr, when that fails. */
bool gallery_paint(const gallery_knot *g, const char *folder);

#endif
