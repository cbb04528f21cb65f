/* Method VBLAST: algorithm 3 of VBLaST-SS (Qi et al. 2017), by which a needle enters a wall.
 *
 * Two points behind the tip, one and two wall thicknesses along the needle's first segment, form
 * two short sub-segments with it. If the plane of a triangle separates the ends of the first one,
 * the tip is passing through it: a toggle. If the plane later separates the ends of the second one,
 * the tip has passed through. The method uses no force. docs/explanation/paper-needle.md lists the points that
 * the paper leaves open. */
#ifndef VBSS_BASELINE_PUNCTURE_H
#define VBSS_BASELINE_PUNCTURE_H

#include "suture/suture.h"

/* Largest number of separate places that one tip passes through at the same time. */
enum { BASELINE_TOGGLES = 4 };

/* A place that the tip is passing through. */
typedef struct baseline_toggle {
    uint32_t drain; /* body number; 0: unused entry */
    uint32_t triangle;
    bool outward; /* the tip passes from the inside of the drain outward */
} baseline_toggle;

/* A needle and a drain after a step, and the holes of the scene. */
typedef struct baseline_probe {
    uint32_t needle, drain; /* their numbers in the scene */
    const drain_object *wall;
    vec3 points[3]; /* the tip, and the points one and two wall thicknesses behind it */
    const suture_hole *holes;
    uint32_t hole_count;
} baseline_probe;

/* Computes the tip, and the points one and two wall thicknesses behind it on the line of the
 * needle's first segment, also beyond the end of that segment. */
void vbss_baseline_set_probe_points(const needle_object *n, pose needle, double thickness,
                                    vec3 points[3]);
/* Finds a place where the tip has passed through since its toggle was set, and clears that
 * toggle. The new hole has no id and no arc length yet. Returns false if there is no further
 * place. */
bool vbss_baseline_find_puncture(const baseline_probe *probe,
                                 baseline_toggle toggles[BASELINE_TOGGLES], suture_hole *made);
/* Clears the toggles of places that neither sub-segment crosses any longer, and sets new ones
 * where the first sub-segment crosses. */
void vbss_baseline_update_toggles(const baseline_probe *probe,
                                  baseline_toggle toggles[BASELINE_TOGGLES]);

#endif
