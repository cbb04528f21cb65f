/* Method PAPER: algorithm 3 of VBLaST-SS (Qi et al. 2017), by which a needle enters a wall. Two points behind the tip, one and
 * two walls along the needle's first segment, make two short sub-segments. Where the plane of a triangle parts the first one,
 * the tip is on its way through it: a toggle. Where it parts the second one later, it has gone through. No force enters.
 * docs/paper-needle.md tells what the paper leaves open. */
#ifndef VBSS_SUTURE_PAPER_H
#define VBSS_SUTURE_PAPER_H

#include "suture/suture.h"

/* A tip is on its way through so many places at most that are not beside each other. */
enum { SUTURE_TOGGLES = 4 };

typedef struct suture_toggle {
    uint32_t drain; /* number in the scene; 0: none */
    uint32_t triangle;
    bool outward; /* from inside */
} suture_toggle;

/* A needle at a drain, after a step, and the holes of its scene. */
typedef struct suture_probe {
    uint32_t needle, drain; /* numbers in the scene */
    const drain_object *wall;
    vec3 points[3]; /* the tip; one wall behind it; two */
    const suture_hole *holes;
    uint32_t hole_count;
} suture_probe;

/* The tip, and the points one and two walls behind it along the needle's first segment, straight on beyond its end. */
void vbss_paper_probe_points(const needle_object *n, pose needle, double thickness, vec3 points[3]);
/* A place where the tip has gone through since it was on its way; its toggle goes. The hole has neither an id nor an arc length
 * yet. False: there is none, or no other one. */
bool vbss_paper_find_puncture(const suture_probe *probe, suture_toggle toggles[SUTURE_TOGGLES],
                              suture_hole *made);
/* Toggles of places that neither sub-segment crosses any more go; where the first one crosses, they come. */
void vbss_paper_set_toggles(const suture_probe *probe, suture_toggle toggles[SUTURE_TOGGLES]);

#endif
