#include "scenes/paper_needle_scenes.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/rotation.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

enum { SEGMENTS = 12, TOOLS = 2 };
#define GRAVITY 9.81
#define RADIUS 10.5e-3
/* Where tools hold it, from its tip; their own tips reach so far over the wire. */
static const double held[TOOLS] = {26e-3, 4e-3};
#define OVER 2e-3
/* Of the tip before the middle of the wall; how far it is turned by each tool. */
#define BEFORE 2e-3
#define FIRST_WAY 20e-3
#define SECOND_WAY 32e-3

/* ---- where the needle is: square to the wall at the right mark, then turned about the centre of its arc */

static pose first_pose(void)
{
    const double angle = 4.5e-3 / 6.5e-3; /* of the mark, from the top */
    vec3 out = vec3_make(0.0, vbss_cos(angle), vbss_sin(angle)), into = vec3_neg(out);
    vec3 aside = vec3_make(0.0, into.z, -into.y); /* from the centre of the arc to the tip */
    vec3 tip = vec3_scale(out, 6.5e-3 + BEFORE);
    quat first = quat_between(vec3_make(0.0, 1.0, 0.0), into);
    vec3 now = quat_rotate(first, vec3_make(1.0, 0.0, 0.0));
    double turn = vbss_atan2(vec3_dot(vec3_cross(now, aside), into), vec3_dot(now, aside));
    quat about = vbss_quat_from_rotation_vector(vec3_scale(into, turn));
    return pose_make(vec3_add_scaled(tip, -RADIUS, aside), quat_mul(about, first));
}

/* From 0 to 1 between two moments, beginning and ending at rest. */
static double between(double t, double begin, double end)
{
    double share = vbss_max(0.0, vbss_min((t - begin) / (end - begin), 1.0));
    return share * share * (3.0 - 2.0 * share);
}

static pose needle_at(double t)
{
    double way = FIRST_WAY * between(t, 80.0, 460.0) + SECOND_WAY * between(t, 780.0, 1560.0);
    pose at = first_pose();
    quat turn = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, way / RADIUS));
    at.orientation = quat_mul(at.orientation, turn);
    at.position.x += 30e-3 * between(t, 1590.0, 1790.0);
    return at;
}

/* ---- tools: their jaws across the needle, their shafts away from the centre of its arc */

typedef struct hand {
    pose tip;
    double opening;
} hand;

static hand hand_at(int tool, double t)
{
    double angle = -held[tool] / RADIUS, away = -OVER;
    hand h;
    quat across = vbss_quat_from_rotation_vector(vec3_make(0.0, 1.5707963267948966, 0.0));
    quat round = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, angle));
    if (tool == 0) {
        h.opening = between(t, 660.0, 700.0);
        away += 30e-3 * between(t, 710.0, 770.0);
    } else {
        h.opening = 1.0 - between(t, 570.0, 620.0) + between(t, 1810.0, 1850.0);
        away += 30e-3 * (1.0 - between(t, 470.0, 560.0)) + 30e-3 * between(t, 1880.0, 1960.0);
    }
    vec3 out = quat_rotate(round, vec3_make(1.0, 0.0, 0.0));
    pose hold = pose_make(vec3_scale(out, RADIUS + away), quat_mul(round, across));
    /* The first stays where it has let go. */
    h.tip = pose_mul(needle_at(tool == 0 ? vbss_min(t, 700.0) : t), hold);
    return h;
}

static vbss_result move(vbss_grasper *grasper, const hand *h)
{
    double tip[3], turn[4];
    pose_store(h->tip, tip, turn);
    VBSS_TRY(vbss_grasper_move(grasper, tip, turn));
    return vbss_grasper_set_opening(grasper, h->opening);
}

static vbss_result add_tool(vbss_context *context, vbss_scene *scene, int tool)
{
    vbss_grasper_config config;
    vbss_grasper *grasper;
    uint32_t body;
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_PAPER;
    config.jaw_speed = 1e3; /* they are closed before it falls */
    VBSS_TRY(vbss_grasper_create(context, &config, &grasper));
    const hand h = hand_at(tool, 0.0);
    VBSS_TRY(move(grasper, &h));
    return vbss_scene_add_grasper(scene, grasper, &body);
}

/* ---- what is in it */

static vbss_result add_drain(vbss_context *context, vbss_scene *scene)
{
    vbss_drain_config config;
    vbss_drain *drain;
    uint32_t body;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_PAPER;
    VBSS_TRY(vbss_drain_create(context, &config, &drain));
    return vbss_scene_add_drain(scene, drain, &body);
}

static vbss_result add_needle(vbss_context *context, vbss_scene *scene, vbss_needle **needle)
{
    vbss_needle_config config;
    uint32_t body;
    VBSS_TRY(vbss_needle_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_PAPER;
    config.radius = RADIUS;
    config.gravity[1] = -GRAVITY;
    pose_store(needle_at(0.0), config.position, config.orientation);
    VBSS_TRY(vbss_needle_create(context, &config, needle));
    return vbss_scene_add_needle(scene, *needle, &body);
}

/* From the swage on, where it leaves the needle. */
static vbss_result add_thread(vbss_context *context, vbss_scene *scene, vbss_needle *needle)
{
    vbss_thread_config config;
    vbss_needle_state state;
    vbss_thread *thread;
    uint32_t body, pin;
    VBSS_TRY(vbss_needle_get_state(needle, &state, sizeof state));
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_PAPER;
    config.segment_count = SEGMENTS;
    config.length = 0.06;
    config.drag = 20.0;
    config.paper_damping = 0.01;
    config.gravity[1] = -GRAVITY;
    for (int k = 0; k < 3; k++) {
        config.start[k] = state.swage[k];
        config.direction[k] = state.swage_direction[k];
    }
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    VBSS_TRY(vbss_scene_add_thread(scene, thread, &body));
    return vbss_scene_pin_thread(scene, body, 0, PAPER_NEEDLE_SCENE_NEEDLE, NULL, &pin);
}

vbss_result paper_needle_scene_create(vbss_context *context, vbss_scene **scene)
{
    vbss_scene_config config;
    vbss_needle *needle;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_PAPER;
    config.thread_capacity = 1;
    config.node_capacity = SEGMENTS + 1;
    config.rigid_capacity = 1 + TOOLS;
    config.event_capacity = 32;
    config.hole_capacity = 4;
    config.floor = 1;
    config.floor_height = PAPER_NEEDLE_SCENE_FLOOR;
    VBSS_TRY(vbss_scene_create(context, &config, scene));
    VBSS_TRY(add_drain(context, *scene));
    VBSS_TRY(add_needle(context, *scene, &needle));
    VBSS_TRY(add_thread(context, *scene, needle));
    for (int tool = 0; tool < TOOLS; tool++) {
        VBSS_TRY(add_tool(context, *scene, tool));
    }
    return VBSS_OK;
}

vbss_result paper_needle_scene_step(vbss_scene *scene)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    double t = (double)s->statistics.steps;
    for (int tool = 0; tool < TOOLS; tool++) {
        uint32_t body = PAPER_NEEDLE_SCENE_FIRST + (uint32_t)tool;
        const hand h = hand_at(tool, t);
        VBSS_TRY(move((vbss_grasper *)vbss_scene_body(s, body)->rigid.slot, &h));
    }
    return vbss_scene_step(scene, 1e-3);
}
