#include "scenes/drain_hands.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/linear.h"

/* A round of the tool, in steps: down, stirring, and up again. */
enum { ROUND = 300, DOWN = 180 };
#define SPEED 0.04     /* m/s, down and up */
#define DEEPEST 4.5e-3 /* of the tip from where it waits, m */
#define STIRRED 1e-3   /* m, to all sides */
#define STIR_RATE 5.0  /* Hz */
#define SHAFT 20e-3    /* m */
#define WAITS 7.9e-3   /* over the wall, which is 0.2 mm below, m */
#define HALF 16e-3     /* of the thread, m */
#define DRAWN 100      /* steps in which its ends are drawn down */
#define PI 3.14159265358979323846

vbss_result drain_hands_init(drain_hands *hands)
{
    *hands = (drain_hands){0};
    VBSS_TRY(vbss_scene_config_init(&hands->config, sizeof hands->config));
    VBSS_TRY(vbss_drain_config_init(&hands->drain_config, sizeof hands->drain_config));
    hands->config.node_capacity = 64;
    hands->config.floor = 1;
    hands->config.floor_height =
        -hands->drain_config.radius - 0.5 * hands->drain_config.thickness - 2e-5;
    return VBSS_OK;
}

/* Where the tip waits: over the wall on the right of the slit. */
static vec3 over_the_wall(void)
{
    return vec3_make(0.3e-3, WAITS, 3e-3);
}

/* An end of the thread is drawn down, and a little inward, which leaves it hardly any slack. */
static vec3 end_of_thread(uint32_t end, double share)
{
    double aside = HALF - 0.8e-3 * share;
    return vec3_make(8e-3, 7.2e-3 - 5e-3 * share, end == 0 ? -aside : aside);
}

static vbss_result hold_ends(vbss_thread *thread)
{
    for (uint32_t end = 0; end < 2; end++) {
        vbss_thread_attachment a;
        uint32_t id;
        VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
        a.node = end * (DRAIN_HANDS_NODES - 1);
        vec3_store(a.position, end_of_thread(end, 0.0));
        VBSS_TRY(vbss_thread_attach(thread, &a, &id)); /* 1 and 2 */
    }
    return VBSS_OK;
}

static vbss_result add_thread(vbss_context *context, vbss_scene *scene)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t body;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = DRAIN_HANDS_NODES - 1;
    config.length = 2.0 * HALF;
    vec3_store(config.start, end_of_thread(0, 0.0));
    vec3_store(config.direction, vec3_make(0.0, 0.0, 1.0));
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    VBSS_TRY(hold_ends(thread));
    return vbss_scene_add_thread(scene, thread, &body);
}

static vbss_result add_tool(vbss_scene *scene)
{
    const vbss_capsule shaft = {{0.0, 0.0, 0.0}, {0.0, SHAFT, 0.0}, DRAIN_HANDS_TOOL_RADIUS};
    vbss_rigid_config config;
    uint32_t body;
    VBSS_TRY(vbss_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_RIGID_COUPLED;
    config.capsules = &shaft;
    config.capsule_count = 1;
    vec3_store(config.position, over_the_wall());
    return vbss_scene_add_rigid(scene, &config, &body);
}

vbss_result drain_hands_create(vbss_context *context, drain_hands *hands)
{
    uint32_t body;
    VBSS_TRY(vbss_scene_create(context, &hands->config, &hands->scene));
    VBSS_TRY(vbss_drain_create(context, &hands->drain_config, &hands->drain));
    VBSS_TRY(vbss_scene_add_drain(hands->scene, hands->drain, &body));
    VBSS_TRY(add_thread(context, hands->scene));
    return add_tool(hands->scene);
}

static vbss_result draw_thread(vbss_scene *scene, uint64_t step)
{
    vbss_thread *thread;
    VBSS_TRY(vbss_scene_get_thread(scene, DRAIN_HANDS_THREAD, &thread));
    for (uint32_t end = 0; end < 2; end++) {
        double to[3];
        vec3_store(to, end_of_thread(end, vbss_min((double)(step + 1) / DRAWN, 1.0)));
        VBSS_TRY(vbss_thread_move(thread, end + 1, to, NULL));
    }
    return VBSS_OK;
}

static vbss_result poke(vbss_scene *scene, uint64_t since)
{
    double t = 1e-3 * (double)(since + 1), up = 1e-3 * ((double)(since + 1) - DOWN);
    double depth = vbss_max(vbss_min(SPEED * t, DEEPEST) - SPEED * vbss_max(up, 0.0), 0.0);
    double turn = 2.0 * PI * STIR_RATE * t, stirred = vbss_min(depth, STIRRED), to[3];
    vec3 aside = vec3_make(vbss_sin(turn), 0.0, vbss_cos(turn));
    vec3 tip = vec3_add_scaled(over_the_wall(), stirred, aside);
    tip.y -= depth;
    vec3_store(to, tip);
    return vbss_scene_move_rigid(scene, DRAIN_HANDS_TOOL, to, NULL);
}

vbss_result drain_hands_drive(vbss_scene *scene)
{
    vbss_scene_statistics statistics;
    VBSS_TRY(vbss_scene_get_statistics(scene, &statistics, sizeof statistics));
    VBSS_TRY(draw_thread(scene, statistics.steps));
    return poke(scene, statistics.steps % ROUND);
}

vbss_result drain_hands_step(vbss_scene *scene)
{
    VBSS_TRY(drain_hands_drive(scene));
    return vbss_scene_step(scene, 1e-3);
}
