/* A thread goes straight through a sheet in the plane y = 0. Both ends of the thread are drawn along +x, so that it tears the
 * sheet at its hole. */
#ifndef VBSS_TESTS_SCENE_TEAR_RIG_H
#define VBSS_TESTS_SCENE_TEAR_RIG_H

#include "fixtures/pad.h"
#include "scene/small.h"

#define TEAR_SIDE 30e-3  /* m, of the sheet */
#define TEAR_ENERGY 1e3  /* J/m^2 */
#define TEAR_THICK 1e-3  /* m */
#define TEAR_FORCE 1.0   /* N: energy times thickness */
#define TEAR_STEP 1e-3   /* s */
#define TEAR_REACH 10e-3 /* m, of the thread on either side of the hole */
enum { TEAR_CELLS = 12, TEAR_SEGMENTS = 40 };

typedef struct tear_rig {
    small s;
    vbss_drain *drain;
    vbss_thread *thread;
    bool is_of_host; /* the sheet is a host surface; set it before tear_rig_create */
    uint32_t sheet, suture, hands[2];
    vec3 hand_positions[2];
    double work; /* of the hands, J */
} tear_rig;

/* Configurations, with a sheet that is clamped along its frame, or in the three columns of
 * nodes at its side -x only, up to x = -10 mm. Change them before
 * tear_rig_create. */
void tear_rig_begin(tear_rig *r, bool has_free_edge);
/* Scene, sheet and thread; the hole is in a triangle of this cell. */
void tear_rig_create(tear_rig *r, uint32_t column, uint32_t row);
/* The same with the slit drain in place of the sheet: the hole is at the right mark, and `direction` is the one
 * towards the slit. */
void tear_rig_create_drain(tear_rig *r, vec3 *direction);
/* Moves the hands by this velocity in a step, m/s. */
void tear_rig_step(tear_rig *r, vec3 velocity);
/* False: there is no hole any more. */
bool tear_rig_hole(const tear_rig *r, vbss_scene_hole *hole);
/* Part of the force of a hole in the plane y = 0, N. The thread is drawn within the plane z = 0, so the sheet stays
 * flat. */
double tear_rig_force(const vbss_scene_hole *hole);
/* How often the thread crosses the sheet farther than `distance` from a point, by the signs of volumes. */
uint32_t tear_rig_crossings(const tear_rig *r, vec3 point, double distance);
void tear_rig_end(tear_rig *r);

#endif
