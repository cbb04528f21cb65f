/* The passivity rig: tools on haptic arms in hands (coupled_arm.h), pressed against an obstacle. It measures force, energy and
 * ripple while the hand holds still. */
#ifndef VBSS_TESTS_SCENE_HAPTIC_RIG_H
#define VBSS_TESTS_SCENE_HAPTIC_RIG_H

#include "fixtures/coupled_arm.h"
#include "scene/needles_rig.h"

typedef enum haptic_obstacle {
    HAPTIC_WALL,    /* rigid */
    HAPTIC_ELASTIC, /* a wall on a spring without damping, HAPTIC_ELASTIC_STIFFNESS */
    HAPTIC_DRAIN,
    HAPTIC_NEEDLE, /* that the other tool holds, on an arm like the first */
    HAPTIC_OBSTACLES
} haptic_obstacle;
#define HAPTIC_ELASTIC_STIFFNESS 90.0 /* N/m */

enum { HAPTIC_ARMS = 2, HAPTIC_WINDOWS = 8 };

typedef struct haptic_rig {
    needles_rig needles; /* the scene, its tools, and the needle if there is one */
    vbss_drain *drain;
    coupled_arm arms[HAPTIC_ARMS]; /* the first presses; the second holds the needle */
    uint32_t arm_count;
    vec3 into; /* unit vector, from the first tool into the obstacle */
    uint64_t step;
} haptic_rig;

/* Of both arms, as in coupled_arm; the coupling is that of the tools. */
typedef struct haptic_loop {
    double mass, stiffness, damping;             /* of the hand, kg, N/m, N s/m */
    int delay;                                   /* ms */
    bool in_device;                              /* the device computes the coupling */
    double coupling_stiffness, coupling_damping; /* N/m, N s/m */
} haptic_loop;

/* What the rig measures, the worst of its arms. Windows last 0.25 s and begin when the hand holds still. */
typedef struct haptic_measures {
    double largest_force;          /* that a device wrote, N */
    double asked;                  /* largest force of a tool on its hand, N */
    double pressed;                /* mean force on the pressing arm in the last window, N */
    double energy[HAPTIC_WINDOWS]; /* largest kinetic energy of an arm, J */
    double ripple; /* root mean square of force about its mean in the last two windows, N */
} haptic_measures;

/* The tool is 1 mm from the obstacle. */
void haptic_begin(haptic_rig *r, haptic_obstacle obstacle, const haptic_loop *loop);
void haptic_end(haptic_rig *r);
/* A step of 1 ms of devices, scene and arms. */
void haptic_step(haptic_rig *r);
/* The hand moves into the obstacle at that speed, m/s, to where it presses about that hard, N, and holds still. */
haptic_measures haptic_press(haptic_rig *r, double speed, double force);
/* Begins, presses and ends. */
haptic_measures haptic_measure(haptic_obstacle obstacle, const haptic_loop *loop, double speed);
/* Whether a window has more energy than the one before, and enough to be felt. */
bool haptic_grows(const haptic_measures *m);

/* Asserts that the force kept its limit. */
void haptic_expect_limit(const haptic_measures *m);
/* Asserts that it did, that no window gained energy, and that the ripple is below 0.02 N. */
void haptic_expect_rest(const haptic_measures *m);
/* Of a human hand of that stiffness on an arm of that mass, N s/m. */
double haptic_hand_damping(const haptic_loop *loop);
/* Of the hand, N s/m: with as much it gets no energy from any obstacle without losses, at an angular frequency (rad/s), if its
 * force comes `late` s after its pose. docs/reference/device-layer.md has the bound. */
double haptic_min_damping(const haptic_loop *loop, double frequency, double late);

#endif
