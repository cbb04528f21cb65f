#include "base/error.h"
#include "tool_rig.h"

#include <stdlib.h>
#include <string.h>

static const double segment = 0.5e-3, cylinder_radius = 5e-3;
const char *const tool_meeting_names[TOOL_MEETINGS] = {"free", "wall-below", "wall-beside",
                                                       "thread-held", "thread-sliding"};

vbss_result tool_rig_begin(tool_rig *r)
{
    memset(r, 0, sizeof *r);
    VBSS_TRY(vbss_context_create(NULL, &r->context));
    VBSS_TRY(vbss_scene_create(r->context, NULL, &r->scene));
    return vbss_grasper_config_init(&r->config, sizeof r->config);
}

void tool_rig_end(tool_rig *r)
{
    vbss_context_destroy(r->context);
    free(r->saved);
    memset(r, 0, sizeof *r);
}

/* ---- what is in it */

vbss_result tool_rig_thread(tool_rig *r, uint32_t segments, tool_rig_ends pinned)
{
    vbss_thread_config config;
    uint32_t body, pin;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = segments;
    config.length = segment * segments;
    config.gravity[0] = config.gravity[1] = config.gravity[2] = 0.0;
    vec3_store(config.start, vec3_make(0.0, -0.5 * config.length, 0.0));
    vec3_store(config.direction, vec3_make(0.0, 1.0, 0.0));
    VBSS_TRY(vbss_thread_create(r->context, &config, &r->thread));
    VBSS_TRY(vbss_scene_add_thread(r->scene, r->thread, &body));
    if (pinned != TOOL_RIG_NEITHER) {
        VBSS_TRY(vbss_scene_pin_thread(r->scene, body, 0, 0, NULL, &pin));
    }
    return pinned == TOOL_RIG_BOTH ? vbss_scene_pin_thread(r->scene, body, segments, 0, NULL, &pin)
                                   : VBSS_OK;
}

vbss_result tool_rig_cylinder(tool_rig *r, vec3 middle)
{
    const vbss_scene_capsule capsule = {
        .begin = {0.0, -0.03, 0.0}, .end = {0.0, 0.03, 0.0}, .radius = cylinder_radius};
    vbss_scene_rigid_config config;
    uint32_t body;
    VBSS_TRY(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_SCENE_RIGID_DRIVEN;
    config.capsules = &capsule;
    config.capsule_count = 1;
    vec3_store(config.position, middle);
    return vbss_scene_add_rigid(r->scene, &config, &body);
}

vbss_result tool_rig_add(tool_rig *r, vec3 tip)
{
    uint32_t tool = r->count++;
    VBSS_TRY(vbss_grasper_create(r->context, &r->config, &r->tools[tool]));
    VBSS_TRY(tool_rig_move(r, tool, tip));
    return vbss_scene_add_grasper(r->scene, r->tools[tool], &r->bodies[tool]);
}

/* ---- what hands do */

vbss_result tool_rig_move(tool_rig *r, uint32_t tool, vec3 tip)
{
    double position[3];
    vec3_store(position, tip);
    return vbss_grasper_set_target(r->tools[tool], position, NULL);
}

vbss_result tool_rig_steps(tool_rig *r, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        VBSS_TRY(vbss_scene_step(r->scene, 1.0 / TOOL_RIG_ROUND));
    }
    return VBSS_OK;
}

vbss_result tool_rig_step_to(tool_rig *r, uint32_t tool, vec3 tip)
{
    VBSS_TRY(tool_rig_move(r, tool, tip));
    return tool_rig_steps(r, 1);
}

vbss_result tool_rig_close(tool_rig *r)
{
    for (uint32_t i = 0; i < r->count; i++) {
        VBSS_TRY(vbss_grasper_set_opening(r->tools[i], 0.0));
    }
    return tool_rig_steps(r, 300);
}

vbss_result tool_rig_force(const tool_rig *r, uint32_t tool, vec3 *force)
{
    vbss_grasper_state state;
    VBSS_TRY(vbss_grasper_get_state(r->tools[tool], &state, sizeof state));
    *force = vec3_load(state.hand_force);
    return VBSS_OK;
}

bool tool_rig_holds(const tool_rig *r, uint32_t tool)
{
    vbss_grasper_state state;
    return vbss_grasper_get_state(r->tools[tool], &state, sizeof state) == VBSS_OK &&
           state.grasp_count > 0;
}

double tool_rig_slid(const tool_rig *r, uint32_t tool)
{
    vbss_scene_grasp grasp;
    return vbss_scene_get_grasp(r->scene, r->bodies[tool], 0, &grasp, sizeof grasp) == VBSS_OK
               ? grasp.slid
               : 0.0;
}

/* ---- from the same state again */

vbss_result tool_rig_save(tool_rig *r)
{
    (void)vbss_scene_save(r->scene, NULL, 0, &r->saved_bytes); /* tells the size */
    free(r->saved);
    r->saved = malloc(r->saved_bytes);
    if (r->saved == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    return vbss_scene_save(r->scene, r->saved, r->saved_bytes, &r->saved_bytes);
}

vbss_result tool_rig_restore(tool_rig *r)
{
    return vbss_scene_restore(r->scene, r->saved, r->saved_bytes);
}

uint64_t tool_rig_hash(const tool_rig *r)
{
    uint64_t hash = 0;
    return vbss_scene_get_hash(r->scene, &hash) == VBSS_OK ? hash : 0;
}

/* ---- what a tool meets */

vbss_result tool_rig_meet(tool_rig *r, tool_meeting what, double stiffness, double damping,
                          vec3 *home)
{
    vec3 tip = vec3_zero(), in = vec3_zero();
    VBSS_TRY(tool_rig_begin(r));
    double jaw = r->config.driver_radius;
    r->config.stiffness = stiffness;
    r->config.damping = damping;
    if (what == TOOL_WALL_BELOW) {
        in.z = -5e-4;
        VBSS_TRY(tool_rig_cylinder(r, vec3_make(0.0, 0.0, -cylinder_radius - jaw)));
    } else if (what == TOOL_WALL_BESIDE) {
        in.x = -5e-4;
        VBSS_TRY(tool_rig_cylinder(r, vec3_make(-cylinder_radius - 2.0 * jaw, 0.0, 1e-3)));
    } else if (what != TOOL_FREE) {
        tip.z = -2e-3;
        r->config.closing_force = what == TOOL_SLIDING ? 0.5 : r->config.closing_force;
        VBSS_TRY(tool_rig_thread(r, 60, TOOL_RIG_BOTH));
    }
    VBSS_TRY(tool_rig_add(r, tip));
    VBSS_TRY(tool_rig_close(r));
    *home = vec3_add(tip, in);
    for (int i = 1; i <= 100; i++) {
        VBSS_TRY(tool_rig_step_to(r, 0, vec3_lerp(tip, *home, i / 100.0)));
    }
    return VBSS_OK;
}
