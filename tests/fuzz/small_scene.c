#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "fuzz/fuzz.h"

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

enum { SEGMENTS = 10, THREAD = 1, TOOL = 2, BALL = 3 };

_Noreturn void fuzz_stop(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s does not hold\n", file, line, condition);
    abort();
}

static vbss_result add_thread(vbss_context *context, vbss_scene *scene)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t body, pin;
    TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = SEGMENTS;
    config.length = 0.02;
    config.damping = 20.0;
    config.cut_capacity = 1;
    config.start[1] = 0.012;
    config.direction[0] = 0.0;
    config.direction[1] = -1.0;
    TRY(vbss_thread_create(context, &config, &thread));
    TRY(vbss_scene_add_thread(scene, thread, &body));
    return vbss_scene_pin_thread(scene, body, 0, 0, NULL, &pin);
}

static vbss_result add_tools(vbss_context *context, vbss_scene *scene)
{
    vbss_grasper_config config;
    vbss_grasper *grasper;
    vbss_scene_rigid_config rigid;
    uint32_t body;
    const vbss_scene_capsule ball = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 2e-3};
    const double tip[3] = {0.0, 2e-3, -1e-3};
    TRY(vbss_grasper_config_init(&config, sizeof config));
    TRY(vbss_grasper_create(context, &config, &grasper));
    TRY(vbss_grasper_set_target(grasper, tip, NULL));
    TRY(vbss_scene_add_grasper(scene, grasper, &body));
    TRY(vbss_scene_rigid_config_init(&rigid, sizeof rigid));
    rigid.kind = VBSS_SCENE_RIGID_COUPLED;
    rigid.capsules = &ball;
    rigid.capsule_count = 1;
    rigid.position[0] = 0.01;
    return vbss_scene_add_rigid(scene, &rigid, &body);
}

static vbss_result add_needle(vbss_context *context, vbss_scene *scene)
{
    vbss_needle_config config;
    vbss_needle *needle;
    uint32_t body;
    TRY(vbss_needle_config_init(&config, sizeof config));
    config.segment_count = 2;
    config.radius = 5e-3;
    config.position[0] = -0.02;
    config.gravity[1] = -9.81;
    TRY(vbss_needle_create(context, &config, &needle));
    return vbss_scene_add_needle(scene, needle, &body);
}

vbss_result small_scene_create(vbss_context *context, vbss_scene **scene)
{
    vbss_scene_config config;
    TRY(vbss_scene_config_init(&config, sizeof config));
    config.thread_capacity = 2;
    config.node_capacity = 2 * (SEGMENTS + 4);
    config.rigid_capacity = 3;
    config.capsule_capacity = 8;
    config.pin_capacity = config.grasp_capacity = config.hole_capacity = 2;
    config.contact_capacity = 64;
    config.candidate_capacity = 512;
    config.event_capacity = 8;
    config.floor = 1;
    config.floor_height = -0.02;
    TRY(vbss_scene_create(context, &config, scene));
    TRY(add_thread(context, *scene));
    TRY(add_tools(context, *scene));
    return add_needle(context, *scene);
}

vbss_result drain_scene_create(vbss_context *context, vbss_scene **scene)
{
    vbss_scene_config config;
    vbss_drain_config own;
    vbss_drain *drain;
    uint32_t body;
    TRY(vbss_scene_config_init(&config, sizeof config));
    config.contact_capacity = 256;
    config.candidate_capacity = 4096;
    config.hole_capacity = 2;
    TRY(vbss_scene_create(context, &config, scene));
    TRY(vbss_drain_config_init(&own, sizeof own));
    TRY(vbss_drain_create(context, &own, &drain));
    TRY(vbss_scene_add_drain(*scene, drain, &body));
    return add_needle(context, *scene);
}

static vbss_result attach(vbss_scene *scene)
{
    vbss_thread_attachment a;
    vbss_thread *thread;
    uint32_t id;
    TRY(vbss_scene_get_thread(scene, THREAD, &thread));
    TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
    a.node = 5;
    a.force[2] = 1e-3;
    TRY(vbss_thread_attach(thread, &a, &id));
    return vbss_thread_set_attachment_target(thread, id, a.force, NULL);
}

vbss_result small_scene_drive(vbss_scene *scene, uint32_t step)
{
    const double t = step % 40, turned[4] = {1.0, 0.0, 0.01 * t, 0.0};
    const double tip[3] = {0.0, 2e-3 + 2e-5 * t, -1e-3}, at[3] = {0.01 - 2e-4 * t, 0.0, 0.0};
    vbss_grasper *tool;
    uint32_t name;
    TRY(vbss_scene_get_grasper(scene, TOOL, &tool));
    TRY(vbss_grasper_set_target(tool, tip, NULL));
    TRY(vbss_grasper_set_opening(tool, t < 20.0 ? fmax(0.0, 1.0 - 0.1 * t) : 1.0));
    TRY(vbss_scene_set_rigid_target(scene, BALL, at, turned));
    if (step == 5) {
        TRY(attach(scene));
    }
    if (step == 30) {
        TRY(vbss_scene_pin_thread(scene, THREAD, SEGMENTS, BALL, NULL, &name));
        TRY(vbss_scene_unpin_thread(scene, name));
        TRY(vbss_grasper_exchange(tool, VBSS_GRASPER_KIND_SHEARS));
    }
    return step == 33 ? vbss_scene_cut_thread(scene, THREAD, 0.0101, &name) : VBSS_OK;
}
