/* What the tests of the scene's physics share: a scene with at most one thread, which is a thread rig of
 * its own (held, loaded and read through it), rigid bodies of one capsule, contacts that are summed, and a
 * knot that is pulled. Through the public interface only; every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_RIG_H
#define VBSS_TESTS_SCENE_RIG_H

#include "fixtures/knots.h"
#include "thread/rig.h"

#include <vblast_ss/scene.h>

typedef struct scene_rig {
    rig thread; /* its context is that of all; its thread NULL: there is none */
    vbss_scene *scene;
    uint32_t body; /* of the thread */
} scene_rig;

vbss_scene_config scene_rig_config(void);
/* The defaults with a floor through the origin that falls by the angle (rad) toward +x. */
vbss_scene_config scene_rig_incline(double angle, double friction);
/* The rig must stay where it is until its end. NULL: without a thread. */
void scene_rig_begin(scene_rig *r, const vbss_scene_config *config,
                     const vbss_thread_config *thread);
void scene_rig_end(scene_rig *r);

/* A body of one capsule whose frame is the world's: about its middle, with gravity down -y. */
vbss_scene_rigid_config scene_rig_capsule(vbss_scene_rigid_kind kind, vbss_scene_capsule *capsule,
                                          vec3 begin, vec3 end, double radius);
uint32_t scene_rig_add(scene_rig *r, const vbss_scene_rigid_config *config);
/* Of a solid capsule: length of the axis, about the axis, and across it. */
double scene_rig_inertia_along(double mass, double length, double radius);
double scene_rig_inertia_across(double mass, double length, double radius);

void scene_rig_run(scene_rig *r, double h, uint32_t steps);

vbss_scene_rigid_state scene_rig_state(scene_rig *r, uint32_t body);
vec3 scene_rig_position(scene_rig *r, uint32_t body);
vec3 scene_rig_velocity(scene_rig *r, uint32_t body);
/* Sums over contacts: of what the floor does to all, and of the sizes of all forces along their normals. */
vec3 scene_rig_floor_force(scene_rig *r);
double scene_rig_contact_pressure(scene_rig *r);
vbss_scene_statistics scene_rig_statistics(scene_rig *r);

/* ---- the thread's ends, held and pulled apart along the line through them */

typedef struct scene_pull {
    uint32_t pins[2];
    vec3 ends[2], along;
} scene_pull;
scene_pull scene_pull_begin(scene_rig *r);
/* Steps in which either end moves outward at that speed. */
void scene_pull_run(scene_rig *r, scene_pull *p, double h, double speed, uint32_t steps);
double scene_pull_distance(const scene_pull *p);
double scene_pull_force(scene_rig *r, const scene_pull *p); /* mean of both ends */

/* Of the last steps, each of them looked at. */
typedef struct scene_pull_means {
    double force, pressure; /* of all contacts together */
    double curvature;       /* largest along the thread */
    double shortening;      /* of the thread's length against the ends' distance */
    double energy_slope;    /* elastic energy gained over distance gained */
} scene_pull_means;
scene_pull_means scene_pull_observe(scene_rig *r, scene_pull *p, double h, double speed,
                                    uint32_t steps);
/* Begins a scene with that knot, in a thread that hardly stretches, and pulls it until it bears the force;
 * returns how much of the thread it keeps, stretch taken off. */
double scene_pull_tight(scene_rig *r, const knot_shape *shape, double force);

#endif
