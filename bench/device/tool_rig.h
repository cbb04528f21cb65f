/* Graspers in a small scene, as the tests of graspers have them: the shaft up along z, the jaws open along x, a
 * thread along y. What a hand would feel is measured on it. */
#ifndef VBSS_BENCH_DEVICE_TOOL_RIG_H
#define VBSS_BENCH_DEVICE_TOOL_RIG_H

#include <vblast_ss/grasper.h>
#include <vblast_ss/scene.h>

#include "base/linear.h"

enum { TOOL_RIG_TOOLS = 2, TOOL_RIG_ROUND = 1000 };

typedef enum tool_rig_ends { TOOL_RIG_NEITHER, TOOL_RIG_FIRST, TOOL_RIG_BOTH } tool_rig_ends;

typedef struct tool_rig {
    vbss_context *context;
    vbss_scene *scene;
    vbss_thread *thread;
    vbss_grasper_config config; /* change it before tools are added */
    vbss_grasper *tools[TOOL_RIG_TOOLS];
    uint32_t bodies[TOOL_RIG_TOOLS], count;
    uint8_t *saved;
    uint64_t saved_bytes;
} tool_rig;

/* tool_rig_end also after a failure. */
vbss_result tool_rig_begin(tool_rig *r);
void tool_rig_end(tool_rig *r);

/* Along y through the origin, segments of 0.5 mm, weightless. */
vbss_result tool_rig_thread(tool_rig *r, uint32_t segments, tool_rig_ends pinned);
/* A driven cylinder of 10 mm along y. */
vbss_result tool_rig_cylinder(tool_rig *r, vec3 middle);
/* Its tip there, its jaws open. */
vbss_result tool_rig_add(tool_rig *r, vec3 tip);

vbss_result tool_rig_move(tool_rig *r, uint32_t tool, vec3 tip);
vbss_result tool_rig_steps(tool_rig *r, uint32_t count);
/* The tip is moved, and a step made. */
vbss_result tool_rig_step_to(tool_rig *r, uint32_t tool, vec3 tip);
/* Handles of all tools close, and what they hold comes to hang still. */
vbss_result tool_rig_close(tool_rig *r);
vbss_result tool_rig_force(const tool_rig *r, uint32_t tool, vec3 *force);
bool tool_rig_holds(const tool_rig *r, uint32_t tool);
/* Length of thread that slid through what it holds, m; 0 if nothing. */
double tool_rig_slid(const tool_rig *r, uint32_t tool);

vbss_result tool_rig_save(tool_rig *r);
vbss_result tool_rig_restore(tool_rig *r);
uint64_t tool_rig_hash(const tool_rig *r);

/* ---- what a tool meets: the walls are cylinders under its tip and beside its jaws */

typedef enum tool_meeting {
    TOOL_FREE,
    TOOL_WALL_BELOW,
    TOOL_WALL_BESIDE,
    TOOL_HOLDING, /* a thread with fixed ends */
    TOOL_SLIDING, /* the same through jaws that bear 0.5 N */
    TOOL_MEETINGS
} tool_meeting;
extern const char *const tool_meeting_names[TOOL_MEETINGS];

/* A rig with one tool; `home` is where its hand is then: 0.5 mm in the wall, or with the thread in the jaws. */
vbss_result tool_rig_meet(tool_rig *r, tool_meeting what, double stiffness, double damping,
                          vec3 *home);

#endif
