#include "scenes/tool_scenes.h"

#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

enum { SEGMENTS = 48, TOOLS = 2, FIRST_TOOL = 2 };

/* ---- what is in it */

static vbss_result add_thread(vbss_context *context, vbss_scene *scene, vbss_method method)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t body, pin;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.method = method;
    config.segment_count = SEGMENTS;
    config.length = 0.036;
    config.damping = 20.0;
    config.paper_damping = 0.01;
    config.start[1] = 0.018;
    config.direction[0] = 0.0;
    config.direction[1] = -1.0;
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    VBSS_TRY(vbss_scene_add_thread(scene, thread, &body));
    return vbss_scene_pin_thread(scene, body, 0, 0, NULL, &pin);
}

static vec3 home_of(int tool)
{
    return tool == 0 ? vec3_make(0.0, 5e-3, -1e-3) : vec3_make(0.0, -8e-3, -2e-3);
}

static vbss_result add_tool(vbss_context *context, vbss_scene *scene, vbss_method method, int tool)
{
    vbss_grasper_config config;
    vbss_grasper *grasper;
    uint32_t body;
    double tip[3];
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.method = method;
    config.closing_force = tool == 0 ? 4.0 : 0.3;
    config.exchange_distance = 0.03;
    VBSS_TRY(vbss_grasper_create(context, &config, &grasper));
    vec3_store(tip, home_of(tool));
    VBSS_TRY(vbss_grasper_move(grasper, tip, NULL));
    return vbss_scene_add_grasper(scene, grasper, &body);
}

vbss_result tool_scene_create(vbss_context *context, vbss_method method, vbss_scene **scene)
{
    vbss_scene_config config;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.method = method;
    config.thread_capacity = 1;
    config.node_capacity = SEGMENTS + 1;
    config.rigid_capacity = TOOLS;
    config.capsule_capacity = TOOLS * 4;
    config.contact_capacity = 1024;
    config.candidate_capacity = 16384;
    config.event_capacity = 16;
    VBSS_TRY(vbss_scene_create(context, &config, scene));
    VBSS_TRY(add_thread(context, *scene, method));
    for (int tool = 0; tool < TOOLS; tool++) {
        VBSS_TRY(add_tool(context, *scene, method, tool));
    }
    return VBSS_OK;
}

/* ---- what hands do */

/* From 0 to 1 between two moments. */
static double between(double t, double begin, double end)
{
    return vbss_max(0.0, vbss_min((t - begin) / (end - begin), 1.0));
}

typedef struct hand {
    vec3 tip;
    double opening;
    bool exchanges;
    vbss_grasper_kind kind;
} hand;

static hand hand_at(int tool, uint32_t moment)
{
    hand h = {home_of(tool), 1.0, false, VBSS_GRASPER_NEEDLE_DRIVER};
    double t = moment, begin = tool == 0 ? 60.0 : 360.0, end = tool == 0 ? 860.0 : 700.0;
    h.opening = 1.0 - between(t, begin, begin + 20.0) + between(t, end, end + 20.0);
    if (tool == 0) {
        h.tip.z += 3e-3 * (between(t, 150.0, 340.0) - between(t, 880.0, 990.0));
        h.tip.x += 1e-3 * (between(t, 150.0, 340.0) - between(t, 880.0, 990.0));
        return h;
    }
    h.tip.z += 2e-3 * (between(t, 150.0, 340.0) - between(t, 720.0, 800.0));
    h.tip.y -= 8e-3 * (between(t, 460.0, 620.0) - between(t, 900.0, 990.0));
    h.tip.z -= 60e-3 * (between(t, 740.0, 850.0) - between(t, 900.0, 990.0));
    h.exchanges = moment == 500 || moment == 870 || moment == 880;
    h.kind = moment == 880 ? VBSS_GRASPER_NEEDLE_DRIVER : VBSS_GRASPER_SHEARS;
    return h;
}

static vbss_result tell(vbss_scene *scene, vbss_record *record, uint32_t body, const hand *h)
{
    double tip[3];
    vec3_store(tip, h->tip);
    if (record != NULL) {
        VBSS_TRY(vbss_record_move_grasper(record, body, tip, NULL));
        VBSS_TRY(vbss_record_set_opening(record, body, h->opening));
        return h->exchanges ? vbss_record_exchange(record, body, h->kind) : VBSS_OK;
    }
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    vbss_grasper *grasper = (vbss_grasper *)vbss_scene_body(s, body)->rigid.slot;
    VBSS_TRY(vbss_grasper_move(grasper, tip, NULL));
    VBSS_TRY(vbss_grasper_set_opening(grasper, h->opening));
    return h->exchanges ? vbss_grasper_exchange(grasper, h->kind) : VBSS_OK;
}

vbss_result tool_scene_drive(vbss_scene *scene, vbss_record *record)
{
    vbss_scene_statistics statistics;
    VBSS_TRY(vbss_scene_get_statistics(scene, &statistics, sizeof statistics));
    uint32_t moment = (uint32_t)(statistics.steps % TOOL_SCENE_ROUND);
    for (int tool = 0; tool < TOOLS; tool++) {
        hand h = hand_at(tool, moment);
        VBSS_TRY(tell(scene, record, FIRST_TOOL + (uint32_t)tool, &h));
    }
    return VBSS_OK;
}

vbss_result tool_scene_step(vbss_scene *scene)
{
    VBSS_TRY(tool_scene_drive(scene, NULL));
    return vbss_scene_step(scene, 1e-3);
}
