/* A hand with mass and damping that is pressed to a stiff wall and let go, again and again, by an arm as real hardware
 * gives it: the stand-in's, driven through the adapter. What tests of passivity and the bench run. */
#ifndef VBSS_TESTS_SCENES_SERVO_WALL_H
#define VBSS_TESTS_SCENES_SERVO_WALL_H

#include <vblast_ss/base.h>

typedef enum servo_arrangement {
    SERVO_INSIDE, /* the host steps inside the servo */
    SERVO_BESIDE, /* in a thread of its own; the servo computes the coupling at its newest pose */
    SERVO_FORWARDED /* in a thread of its own; the servo puts out the force that the host has computed */
} servo_arrangement;

typedef struct servo_wall {
    servo_arrangement arrangement;
    int period,
        lag; /* of a host beside: ticks from step to step, from reading to writing; lag < period or 1 */
    double stiffness, damping; /* of the coupling, N/m, N s/m */
    double mass, arm_damping;  /* of the hand, kg, N s/m */
    double away;               /* m that the middle of the hand's way is before the wall */
    /* found */
    double gained;  /* J that the motors gave to the hand in a round of 0.5 s; less than 0: took */
    double deepest; /* m into the wall */
    double cpu_worst; /* longest callback, s of its thread */
    int illegal;      /* calls that the referee counted */
} servo_wall;

/* `library`: the stand-in for OpenHaptics. */
vbss_result servo_wall_run(vbss_context *context, const char *library, servo_wall *wall);

#endif
