/* The fixed scene whose steps measure the speed of the core.
 *
 * Its operations are those of the suturing task in small: a drain with its contacts on the floor and
 * at a tool, and a thread on the floor. The rod moves periodically, so all periods take nearly the same
 * work. */
#include <vblast_ss/elementary.h>

#include "base/error.h"
#include "scene/api/api.h"

/* Lengths in m, times in s. Origin: chosen. */
#define STEP 1e-3
#define FLOOR (-7e-3)         /* below the default drain */
#define ROD_SIDE 4.5e-3       /* from the slit to the side */
#define ROD_START 9e-3        /* height above the axis of the drain, clear of it */
#define ROD_PRESSED 6e-3      /* half a millimetre below contact */
#define ROD_AMPLITUDE 5e-5    /* of the periodic motion */
#define THREAD_LENGTH 0.06    /* of 100 segments */
#define THREAD_DISTANCE 30e-3 /* from the middle of the drain */
enum { THREAD_SEGMENTS = 100, DESCENT_STEPS = 8, DAMPED_STEPS = 8 };

static vbss_result create_scene(vbss_context *context, scene_reference *r)
{
    vbss_solver_options solver = vbss_solver_options_default();
    vbss_scene_config c;
    VBSS_TRY(vbss_scene_config_init(&c, sizeof c));
    c.thread_capacity = c.rigid_capacity = c.capsule_capacity = 1;
    c.node_capacity = 512;
    solver.call_budget_us = 0.0;
    c.solver = &solver;
    c.floor = 1;
    c.floor_height = FLOOR;
    scene_object *s;
    VBSS_TRY(vbss_scene_create(context, &c, &r->scene));
    VBSS_TRY(vbss_scene_open(r->scene, &s));
    s->report.is_unlogged = true; /* the rod is held back as it meets the drain */
    return VBSS_OK;
}

static vbss_result add_drain(vbss_context *context, scene_reference *r)
{
    uint32_t body;
    vbss_drain_config c;
    VBSS_TRY(vbss_drain_config_init(&c, sizeof c));
    VBSS_TRY(vbss_drain_create(context, &c, &r->drain));
    return vbss_scene_add_drain(r->scene, r->drain, &body);
}

static vbss_result add_thread(vbss_context *context, scene_reference *r)
{
    uint32_t body;
    vbss_thread_config c;
    VBSS_TRY(vbss_thread_config_init(&c, sizeof c));
    c.segment_count = THREAD_SEGMENTS;
    c.length = THREAD_LENGTH;
    c.start[0] = THREAD_DISTANCE;
    c.start[1] = FLOOR + c.radius;
    c.start[2] = -0.5 * THREAD_LENGTH;
    c.direction[0] = 0.0;
    c.direction[2] = 1.0;
    VBSS_TRY(vbss_thread_create(context, &c, &r->thread));
    return vbss_scene_add_thread(r->scene, r->thread, &body);
}

static vbss_result add_rod(scene_reference *r)
{
    static const vbss_scene_capsule rod = {{-5e-3, 0.0, 0.0}, {5e-3, 0.0, 0.0}, 1e-3};
    vbss_scene_rigid_config c;
    VBSS_TRY(vbss_scene_rigid_config_init(&c, sizeof c));
    c.capsule_count = 1;
    c.capsules = &rod;
    c.position[1] = ROD_START;
    c.position[2] = ROD_SIDE;
    return vbss_scene_add_rigid(r->scene, &c, &r->rod);
}

vbss_result vbss_scene_step_reference(scene_reference *r)
{
    static const double wave[SCENE_REFERENCE_PERIOD] = {0.0, 1.0, 0.0, -1.0};
    const double descent = vbss_min((double)r->steps / DESCENT_STEPS, 1.0);
    const double height = ROD_START + descent * (ROD_PRESSED - ROD_START) +
                          ROD_AMPLITUDE * wave[r->steps % SCENE_REFERENCE_PERIOD];
    const double position[3] = {0.0, height, ROD_SIDE};
    r->steps++;
    VBSS_TRY(vbss_scene_set_rigid_target(r->scene, r->rod, position, NULL));
    return vbss_scene_step(r->scene, STEP);
}

vbss_result vbss_scene_create_reference(vbss_context *context, scene_reference *r)
{
    *r = (scene_reference){0};
    VBSS_TRY(create_scene(context, r));
    VBSS_TRY(add_drain(context, r));
    VBSS_TRY(add_thread(context, r));
    VBSS_TRY(add_rod(r));
    for (int i = 0; i < DESCENT_STEPS + DAMPED_STEPS; i++) {
        VBSS_TRY(vbss_scene_step_reference(r));
    }
    return VBSS_OK;
}

uint64_t vbss_scene_count_reference_operations(const scene_reference *r)
{
    scene_object *s;
    return vbss_scene_open(r->scene, &s) == VBSS_OK ? s->report.statistics.operations : 0;
}

void vbss_scene_destroy_reference(scene_reference *r)
{
    (void)vbss_scene_destroy(r->scene);
    (void)vbss_thread_destroy(r->thread);
    (void)vbss_drain_destroy(r->drain);
}
