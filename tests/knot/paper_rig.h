/* A thread in millimetres and one tool, shown to the functions of method PROJECTION. The tool comes down the
 * z axis, tip at the origin; P is the plane z = 0. */
#ifndef VBSS_TESTS_KNOT_PAPER_RIG_H
#define VBSS_TESTS_KNOT_PAPER_RIG_H

#include "baseline/knots.h"
#include "harness/harness.h"

enum { PAPER_RIG_POINTS = 640, PAPER_RIG_TOOLS = 2 };

typedef struct paper_rig {
    vbss_knot_detector_config config;
    knot_tool tools[PAPER_RIG_TOOLS];
    vec3 points[PAPER_RIG_POINTS];
    knot_input scene;
    vbss_random random;
    baseline_loops paper;
} paper_rig;

void paper_rig_begin(paper_rig *rig);
void paper_rig_end(paper_rig *rig);
/* x, y, z of each point, mm, from the tail's end on. */
void paper_rig_show(paper_rig *rig, const double (*mm)[3], uint32_t count);
#define PAPER_SHOW(rig, ...)                                    \
    do {                                                        \
        const double mm_[][3] = {__VA_ARGS__};                  \
        paper_rig_show((rig), mm_, sizeof mm_ / sizeof mm_[0]); \
    } while (0)
/* Walked from the other end. */
void paper_rig_reverse(paper_rig *rig);
/* Loops about tool 0, with the rays of a seed; returns how many. */
uint32_t paper_rig_loops(paper_rig *rig, uint64_t seed);
/* Those with the tool inside. */
uint32_t paper_rig_inside(const paper_rig *rig);
/* The same, then the throws. */
baseline_throw paper_rig_throws(paper_rig *rig, uint64_t seed);

#endif
