/* A needle that a hand pushes through a drain: what happens is counted, and after every step an oracle of its own looks
 * whether the needle crosses the wall anywhere but in its holes. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_NEEDLE_CASE_H
#define VBSS_TESTS_SCENE_NEEDLE_CASE_H

#include "scene/drain_case.h"

enum { NEEDLE_CASE_HOLES = 16, NEEDLE_CASE_EVENTS = VBSS_SCENE_EVENT_OVERDUE + 1 };

typedef struct needle_case {
    drain_case d; /* change it and the needle's configuration before what they make */
    vbss_needle_config config;
    vbss_needle *needle;
    uint32_t body;
    pose hand;                             /* where it has the needle's frame */
    uint32_t counts[NEEDLE_CASE_EVENTS];   /* of events so far, by kind */
    uint32_t happened[NEEDLE_CASE_EVENTS]; /* in the last step */
    double at_hole; /* crossings are so near to their hole, in distances of touching */
    double
        give; /* and farther by so much, m/N, as their hole bears across: 0, or what its stiffness gives */
    uint32_t crossings, away; /* of the last step; at no hole, of all steps */
    double farthest;          /* of all steps: from a crossing to its hole, m */
    double at_tip;            /* most of its force along the tip's direction, N */
    double push, peak; /* what the hand drives it with along its arc, N: now; most since set to 0 */
} needle_case;

void needle_case_begin(needle_case *c);
void needle_case_make(needle_case *c); /* the scene and the drain */
void needle_case_end(needle_case *c);

/* Adds the needle: its tip there, pointing in that direction; its arc's centre is on the other side of `aside`. Held by a hand; a
 * needle that is let go flies. */
void needle_case_put(needle_case *c, vec3 tip, vec3 direction, vec3 aside);
/* Out of the scene; it may be put again, then with the velocities of the configuration too. */
void needle_case_take_out(needle_case *c);
void needle_case_let_go(needle_case *c);
/* Where its frame is then; and how stiffly it is held. */
pose needle_case_pose(double radius, vec3 tip, vec3 direction, vec3 aside);
extern const vbss_rigid_coupling needle_case_coupling;
/* So far before the mark on the right, square to the wall; the edge of the slit there is pinned at its middle. */
void needle_case_at_mark(needle_case *c, double before);
void needle_case_hold_edge(needle_case *c);
/* Everything, with that mesh. */
void needle_case_begin_at_mark(needle_case *c, vbss_drain_mesh mesh, double before);

/* Where the hand has it in the next step: turned about the arc's axis, so that the tip goes on by so much; moved. */
void needle_case_turn(needle_case *c, double distance);
void needle_case_shift(needle_case *c, vec3 displacement);
void needle_case_step(needle_case *c);
void needle_case_wait(needle_case *c, uint32_t steps);
/* Turns the tip on (below 0: back) by that distance at that speed, up to the first event of that kind; 0: none is waited for.
 * Whether it came. */
bool needle_case_drive(needle_case *c, double distance, double speed, vbss_scene_event_kind until);

/* Whether an axis crosses a triangle, and where. */
bool needle_case_crosses(const vec3 axis[2], const vec3 corner[3], vec3 *there);
vbss_needle_state needle_case_state(const needle_case *c);
vec3 needle_case_hand_force(const needle_case *c); /* on the needle */
uint32_t needle_case_holes(const needle_case *c, vbss_scene_hole holes[NEEDLE_CASE_HOLES]);
/* Kinetic, of the needle; and of all the drain. */
double needle_case_energy(const needle_case *c);
/* No crossing away from holes, all finite; at most so many clamped steps. Prints counters. */
void needle_case_expect_kept(const needle_case *c, const char *name, uint32_t max_clamped);

#endif
