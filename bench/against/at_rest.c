/* task/at-rest: the scene in which the task begins. A thread of 300 segments and the needle lie on the floor, the drain stands
 * on it, and two tools circle in the air. */
#include "needle/site.h"
#include "against/subject.h"

enum { SEGMENTS = 300, STEPS = 1000, TOOLS = 2 };
#define PI 3.14159265358979323846

static struct {
    site site;
    vbss_grasper *tools[TOOLS];
    uint32_t steps;
} own;

static vbss_result move_tool(int tool, double time)
{
    const double turn = 2.0 * PI * time;
    const double at[3] = {(tool == 0 ? -0.03 : 0.03) + 0.01 * vbss_cos(turn), 0.01 * vbss_sin(turn),
                          0.03};
    return vbss_grasper_set_target(own.tools[tool], at, NULL);
}

static vbss_result add_tool(int tool)
{
    vbss_grasper_config config;
    uint32_t body;
    TRY(vbss_grasper_config_init(&config, sizeof config));
    TRY(vbss_grasper_create(own.site.rig.context, &config, &own.tools[tool]));
    TRY(move_tool(tool, 0.0));
    return vbss_scene_add_grasper(own.site.rig.scene, own.tools[tool], &body);
}

static vbss_result begin(uint64_t seed)
{
    const site_plan plan = {.segments = SEGMENTS};
    (void)seed;
    TRY(site_create(&own.site, v3(0.035, -0.005, 0.0), PI, &plan));
    for (int tool = 0; tool < TOOLS; tool++) {
        TRY(add_tool(tool));
    }
    return VBSS_OK;
}

static bool goes_on(void)
{
    return own.steps < STEPS;
}

static vbss_result step(void)
{
    own.steps++;
    for (int tool = 0; tool < TOOLS; tool++) {
        TRY(move_tool(tool, SUBJECT_STEP * own.steps));
    }
    return vbss_scene_step(own.site.rig.scene, SUBJECT_STEP);
}

static vbss_result hash(uint64_t *value)
{
    return vbss_scene_get_hash(own.site.rig.scene, value);
}

static vbss_scene *scene(void)
{
    return own.site.rig.scene;
}

static void end(void)
{
    throw_rig_destroy(&own.site.rig);
}

const subject scene_at_rest = {.name = "task/at-rest",
                               .begin = begin,
                               .goes_on = goes_on,
                               .step = step,
                               .hash = hash,
                               .scene = scene,
                               .end = end};
