/* One hand with a tool: goes where it is told as a hand does, late, with a limited speed and a tremor. What it
 * does is measured by a device, and reaches the tool by that alone. */
#ifndef VBSS_EXAMPLES_THROW_HAND_H
#define VBSS_EXAMPLES_THROW_HAND_H

#include <stdbool.h>

#include "throw/rig.h"

#define GRASP_BEHIND 2e-3 /* of the point that the jaws grasp with, from the tip */

/* What distinguishes one trial's hands from another's. */
typedef struct hand_nature {
    double speed;                 /* of all motions, 1: usual */
    double tremor;                /* m */
    double target_at, target_end; /* errors of aim when winding, when grasping, m */
    uint64_t seed;
} hand_nature;

/* The tool as it is, in the frame of the one who ties. */
typedef struct hand_pose {
    vec tip, handle;  /* unit vector from the tip along the jaws */
    vec bend, trocar; /* points on the axis */
    vec opening;      /* unit vector: the jaws open along it */
} hand_pose;

typedef struct hand {
    throw_rig *rig;
    vbss_grasper_config shape;
    hand_nature nature;
    uint64_t random;
    double
        side; /* -1: the world is seen in a mirror, so that this hand's part is always the same */
    /* in the world, which is the scene or its mirror image: */
    bool through; /* the hand keeps the shaft on a line through `trocar` */
    vec trocar;
    double face[4], wanted_face[4];    /* w, x, y, z: how a free tool is turned, how it shall be */
    vec target_at, goal, at, velocity; /* of the tip: error, where it shall go, is */
    vec point;                         /* to where the handle's end of the jaws shall point */
    vec roll;     /* where it points now, normal to the line from tip to trocar */
    double limit; /* m/s */
    double phase[2];
    vec shake[2];
    double time;
    double opening, wanted_opening; /* of the handle */
    vbss_device_tool tool;
    /* the way to the tool */
    vec shown; /* to the device */
    double shown_orientation[4];
    vbss_mock *mock;
    vbss_device *device;
    vbss_grasper *grasper;
    uint32_t body;
    /* felt */
    bool holds;
    uint32_t held_thread, node; /* what is in the jaws */
    double place;               /* of it along the thread, in segments */
    vec pull;                   /* of the thread on the jaws, N */
    vec felt;                   /* of all on the tool, N, in the world */
} hand;

vbss_result hand_create(hand *h, throw_rig *s, const hand_nature *nature, vec trocar, vec tip,
                        vec point, double opening);
/* With a tool of that shape, which has its trocar or none. */
vbss_result hand_create_with(hand *h, throw_rig *s, const hand_nature *nature,
                             const vbss_grasper_config *shape, vec tip, vec point, double opening);
/* A shape's coupling becomes that of a hand that no arm makes buzz. */
void hand_stiffen(vbss_grasper_config *shape);

/* From 0 to 1, the next of a state: splitmix64. */
double hand_chance(uint64_t *state);

/* In the frame of the one who ties (see `side`): where the tip shall go; how fast; to where the handle's
 * end of the jaws shall point. */
void hand_go(hand *h, vec tip, double speed);
void hand_turn(hand *h, vec point);
/* Whether they do, within so many rad: a tool through a point. */
bool hand_is_turned(const hand *h, double within);
/* How a free tool shall be turned, w, x, y, z. */
void hand_face(hand *h, const double q[4]);
/* A free tool is held from now on as if its shaft went through a point, and rolled with hand_turn. */
void hand_through(hand *h, vec point);
/* 0 closed to 1 open. */
void hand_open(hand *h, double opening);
void hand_take_tool(hand *h, vbss_device_tool tool);
/* Back toward a knot that its thread comes from, slower as the pull ceases that it feels, N; `carrot` goes ahead of it. */
void hand_yield(hand *h, const hand_pose *p, vec *carrot, vec knot, double felt, double dt);
/* A new error of aim of that size. */
void hand_target(hand *h, double size);
/* Moves the tool for the coming step. */
vbss_result hand_step(hand *h, double dt);
/* Feels what the step did. */
vbss_result hand_feel(hand *h);
vbss_result hand_observe(const hand *h, hand_pose *pose);

/* The quaternion (w, x, y, z) of a frame of these axes; a vector turned by one. */
void hand_orientation(vec x, vec y, vec z, double q[4]);
vec hand_rotate(const double q[4], vec v);

static inline vec seen(const hand *h, vec world)
{
    return v3(h->side * world.x, world.y, world.z);
}

/* The same for a place or a direction in the scene; it is its own inverse, as seen() is. */
static inline vec seen_scene(const hand *h, vec scene)
{
    return seen(h, mirror_vec(h->rig->mirrored, scene));
}

/* From the tip to the bend, along the jaws. */
static inline double hand_reach(const hand *h)
{
    return h->shape.driver_length + h->shape.driver_neck;
}

#endif
