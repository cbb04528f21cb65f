/* What the tests of graspers share: a small scene with needle drivers, and a thread along y, whose shafts stand
 * up along z and whose jaws open along x. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_TOOLS_RIG_H
#define VBSS_TESTS_SCENE_TOOLS_RIG_H

#include "scene/small.h"

enum { TOOLS_MAX = 4, TOOLS_SEGMENTS = 60, TOOLS_NODES = TOOLS_SEGMENTS + 1 };

typedef struct tools_rig {
    small s;
    vbss_grasper_config config; /* change it before what it makes */
    vbss_grasper *tools[TOOLS_MAX];
    uint32_t bodies[TOOLS_MAX], count;
    vbss_thread *thread;
    uint32_t body, pins[2];
} tools_rig;

/* How a thread of 30 mm through the origin is held. */
typedef enum tools_ends { TOOLS_BOTH, TOOLS_FIRST, TOOLS_NEITHER } tools_ends;

void tools_begin(tools_rig *r);       /* no scene yet: change s.config, then small_create */
void tools_begin_scene(tools_rig *r); /* and one with the defaults */
void tools_end(tools_rig *r);         /* asserts that all memory came back */
/* A tool that is still where the hand is: first with open jaws, its tip there, the shaft up. */
uint32_t tools_add(tools_rig *r, vec3 tip);
uint32_t tools_add_turned(tools_rig *r, vec3 tip, quat turn);
/* Along y, from -15 mm to 15 mm, `aside` from the middle of jaws at the origin. */
void tools_thread(tools_rig *r, tools_ends ends, double aside);

void tools_move(tools_rig *r, uint32_t tool, vec3 tip);
void tools_open(tools_rig *r, uint32_t tool, double opening);
void tools_steps(tools_rig *r, uint32_t count);
/* The tip from one point to another, evenly. */
void tools_move_along(tools_rig *r, uint32_t tool, vec3 from, vec3 to, uint32_t steps);
/* Closes the handle, and waits until what is held has come to lie in the jaws and hangs still. */
void tools_close(tools_rig *r, uint32_t tool);

vbss_grasper_state tools_state(const tools_rig *r, uint32_t tool);
vec3 tools_hand_force(const tools_rig *r, uint32_t tool);
vbss_scene_grasp tools_grasp(const tools_rig *r, uint32_t tool, uint32_t index);
/* How many events of that kind since the last look, and the last of them; every step is looked at. */
uint32_t tools_happened(const tools_rig *r, vbss_scene_event_kind kind, vbss_scene_event *event);
vec3 tools_node(const tools_rig *r, uint32_t node);
vec3 tools_node_velocity(const tools_rig *r, uint32_t node);
double tools_length(const tools_rig *r); /* of the thread, at rest */
/* Of the pin that holds the first or the last node, on the thread. */
vec3 tools_pin_force(const tools_rig *r, uint32_t end);

#endif
