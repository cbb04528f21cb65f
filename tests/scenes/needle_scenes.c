#include "scenes/needle_scenes.h"

#include "base/error.h"
#include "base/rotation.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

enum { SEGMENTS = 40, TOOLS = 2 };
#define GRAVITY 9.81
#define RADIUS 10.5e-3
#define WIRE 0.35e-3
#define SIN_45 0.70710678118654752 /* of the place that the second takes, and its cosine */
/* A little above the floor with thin jaws: what lies on it must be above their ends. */
#define TIP 0.3e-3
#define JAW 0.25e-3

/* ---- what is in it: the middle of the needle's arc is above the origin, its way to the tip along y */

static vbss_result add_needle(vbss_context *context, vbss_scene *scene)
{
    vbss_needle_config config;
    vbss_needle *needle;
    uint32_t body;
    VBSS_TRY(vbss_needle_config_init(&config, sizeof config));
    config.radius = RADIUS;
    config.wire_radius = WIRE;
    config.drag = 1.0;
    config.gravity[2] = -GRAVITY;
    config.position[0] = -RADIUS;
    config.position[2] = 2e-3;
    config.orientation[0] = SIN_45; /* a quarter of a turn about z */
    config.orientation[3] = SIN_45;
    VBSS_TRY(vbss_needle_create(context, &config, &needle));
    return vbss_scene_add_needle(scene, needle, &body);
}

/* From the swage on, where it leaves the needle: along -x. */
static vbss_result add_thread(vbss_context *context, vbss_scene *scene)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t body, pin;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = SEGMENTS;
    config.length = 0.04;
    config.damping = 20.0;
    config.drag = 1.0;
    config.gravity[1] = 0.0;
    config.gravity[2] = -GRAVITY;
    config.start[0] = -RADIUS;
    config.start[1] = -RADIUS;
    config.start[2] = 2e-3;
    config.direction[0] = -1.0;
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    VBSS_TRY(vbss_scene_add_thread(scene, thread, &body));
    return vbss_scene_pin_thread(scene, body, 0, NEEDLE_SCENE_NEEDLE, NULL, &pin);
}

/* From 0 to 1 between two moments, beginning and ending at rest. */
static double between(double t, double begin, double end)
{
    double share = vbss_max(0.0, vbss_min((t - begin) / (end - begin), 1.0));
    return share * share * (3.0 - 2.0 * share);
}

typedef struct hand {
    vec3 tip;
    quat turn;
    double opening;
} hand;

/* From above, its jaws open along x. */
static hand first_at(double t)
{
    hand h = {vec3_make(0.0, 0.0, TIP), quat_identity(), 1.0};
    h.opening = 1.0 - between(t, 260.0, 300.0) + between(t, 1090.0, 1130.0);
    h.tip.z += 15e-3 * (1.0 - between(t, 150.0, 250.0)) +
               NEEDLE_SCENE_LIFT * between(t, 420.0, 740.0) + 40e-3 * between(t, 1180.0, 1320.0);
    return h;
}

/* From outside, in the needle's plane, its jaws open along z; then it is turned upright about the needle's way. */
static hand second_at(double t)
{
    const vec3 out = vec3_make(SIN_45, SIN_45, 0.0);
    const quat roll = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, 0.78539816339744831));
    double lying = 1.0 - between(t, 1340.0, 1640.0);
    double lean = 1.5707963267948966 * lying;
    quat down = vbss_quat_from_rotation_vector(vec3_make(-SIN_45 * lean, SIN_45 * lean, 0.0));
    hand h = {vec3_make(-RADIUS, 0.0, TIP + NEEDLE_SCENE_LIFT), quat_mul(down, roll), 1.0};
    /* The tip is 2 mm further in than the needle. */
    double away = RADIUS - 2e-3 + 30e-3 * (1.0 - between(t, 780.0, 900.0)) +
                  (2e-3 + NEEDLE_SCENE_CARRY) * between(t, 1340.0, 1640.0);
    h.tip = vec3_add_scaled(h.tip, away, out);
    h.tip.z += 6e-3 * between(t, 1340.0, 1640.0);
    h.opening = 1.0 - between(t, 910.0, 950.0) + between(t, 1680.0, 1720.0);
    return h;
}

static hand hand_at(int tool, double t)
{
    return tool == 0 ? first_at(t) : second_at(t);
}

void needle_scene_hand(int tool, double step, double tip[3], double turn[4], double *opening)
{
    const hand h = hand_at(tool, step);
    vec3_store(tip, h.tip);
    turn[0] = h.turn.w;
    turn[1] = h.turn.x;
    turn[2] = h.turn.y;
    turn[3] = h.turn.z;
    *opening = h.opening;
}

static vbss_result move(vbss_grasper *grasper, const hand *h)
{
    double tip[3];
    const double turn[4] = {h->turn.w, h->turn.x, h->turn.y, h->turn.z};
    vec3_store(tip, h->tip);
    VBSS_TRY(vbss_grasper_move(grasper, tip, turn));
    return vbss_grasper_set_opening(grasper, h->opening);
}

static vbss_result add_tool(vbss_context *context, vbss_scene *scene, int tool)
{
    vbss_grasper_config config;
    vbss_grasper *grasper;
    uint32_t body;
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.driver_radius = JAW;
    config.stiffness = 2000.0;
    config.damping = 10.0;
    VBSS_TRY(vbss_grasper_create(context, &config, &grasper));
    const hand h = hand_at(tool, 0.0);
    VBSS_TRY(move(grasper, &h));
    return vbss_scene_add_grasper(scene, grasper, &body);
}

vbss_result needle_scene_create(vbss_context *context, vbss_scene **scene)
{
    vbss_scene_config config;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.thread_capacity = 1;
    config.node_capacity = SEGMENTS + 1;
    config.rigid_capacity = 1 + TOOLS;
    config.event_capacity = 32;
    config.floor = 1;
    config.floor_normal[1] = 0.0;
    config.floor_normal[2] = 1.0;
    VBSS_TRY(vbss_scene_create(context, &config, scene));
    VBSS_TRY(add_needle(context, *scene));
    VBSS_TRY(add_thread(context, *scene));
    for (int tool = 0; tool < TOOLS; tool++) {
        VBSS_TRY(add_tool(context, *scene, tool));
    }
    return VBSS_OK;
}

vbss_result needle_scene_step(vbss_scene *scene)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    double t = (double)s->statistics.steps;
    for (int tool = 0; tool < TOOLS; tool++) {
        uint32_t body = NEEDLE_SCENE_FIRST + (uint32_t)tool;
        const hand h = hand_at(tool, t);
        VBSS_TRY(move((vbss_grasper *)vbss_scene_body(s, body)->rigid.slot, &h));
    }
    return vbss_scene_step(scene, 1e-3);
}
