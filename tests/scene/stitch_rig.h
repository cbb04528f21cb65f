/* A stitch in a drain without weight, and hands that draw its limbs outward; every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_STITCH_RIG_H
#define VBSS_TESTS_SCENE_STITCH_RIG_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "fixtures/stitch_scenes.h"

typedef struct stitch_rig {
    harness_memory memory;
    vbss_context *context;
    stitch_scene_options o; /* change them between begin and make */
    stitch_scene s;
    vbss_scene_hole holes[2]; /* left, right, after the last step */
    double h;
} stitch_rig;

void stitch_rig_begin(stitch_rig *r);
void stitch_rig_make(stitch_rig *r);
void stitch_rig_end(stitch_rig *r); /* asserts that all memory came back */

/* Steps, after which both holes are still there. */
void stitch_rig_wait(stitch_rig *r, int steps);
/* The direction of a limb from its mark to its hand at first; the hand's next step along it. */
vec3 stitch_rig_outward(const stitch_rig *r, int hand);
void stitch_rig_draw(stitch_rig *r, int hand, double distance);
/* Both hands draw at a speed in so many steps, each while it pulls with less than that. */
void stitch_rig_pull(stitch_rig *r, int steps, double speed, double limit);
/* Instead of the left hand a force outward, on 1 g. */
void stitch_rig_load_tail(stitch_rig *r, double force);
/* The walls cannot give way where the holes are. */
void stitch_rig_hold_marks(stitch_rig *r);

vec3 stitch_rig_node(const stitch_rig *r, uint32_t i);
vbss_drain_gap stitch_rig_gap(const stitch_rig *r);
vbss_scene_statistics stitch_rig_statistics(const stitch_rig *r);

#endif
