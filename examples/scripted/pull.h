/* A node of a thread, drawn toward a point until a hand feels a force. */
#ifndef VBSS_EXAMPLES_SCRIPTED_PULL_H
#define VBSS_EXAMPLES_SCRIPTED_PULL_H

#include <vblast_ss/vblast_ss.h>

#include "base/linear.h"

typedef struct scripted_pull {
    uint32_t attachment; /* 0: the node is free */
    uint32_t node;
    double stiffness; /* of the spring between hand and node, N/m */
    vec3 hand;        /* m */
    double force;     /* in the last step, N */
} scripted_pull;

/* Takes a node where it is. */
vbss_result scripted_take(scripted_pull *p, vbss_thread *thread, uint32_t node, double stiffness);
/* Moves the hand by `distance` or less toward the goal: slower near the wanted force, and back beyond it. */
vbss_result scripted_pull_toward(scripted_pull *p, vbss_thread *thread, vec3 goal, double wanted,
                                 double distance);
vbss_result scripted_release(scripted_pull *p, vbss_thread *thread);

#endif
