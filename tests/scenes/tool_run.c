#include "scenes/tool_run.h"

#include "base/elementary.h"
#include "base/error.h"

enum { SEGMENTS = 60, NODES = SEGMENTS + 1, MIDDLE = SEGMENTS / 2 };
#define SEGMENT 0.5e-3

/* ---- what is in it */

static vbss_result add_thread(vbss_context *context, vbss_method method, tool_run *run)
{
    double x[NODES][3];
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t pin;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.method = method;
    config.segment_count = SEGMENTS;
    config.length = SEGMENTS * SEGMENT;
    config.cut_capacity = 2;
    config.attachment_capacity = 4;
    config.gravity[1] = 0.0;
    config.gravity[2] = -0.5;         /* it shall still be there when the jaws have closed */
    for (int i = 0; i < NODES; i++) { /* along y, in a shallow wave */
        x[i][0] = 0.2e-3 * vbss_sin(0.3 * i);
        x[i][1] = (i - MIDDLE) * SEGMENT;
        x[i][2] = 0.0;
    }
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    VBSS_TRY(vbss_thread_set_state(thread, x[0], NULL, NODES));
    VBSS_TRY(vbss_scene_add_thread(run->scene, thread, &run->thread));
    VBSS_TRY(vbss_scene_pin_thread(run->scene, run->thread, 0, 0, NULL, &pin));
    return vbss_scene_pin_thread(run->scene, run->thread, NODES - 1, 0, NULL, &pin);
}

/* Jaws across the thread, one tool from either side; the second squeezes less. */
static vbss_result add_tool(vbss_context *context, vbss_method method, int which, tool_run *run)
{
    vbss_grasper_config config;
    uint32_t body;
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.method = method;
    config.has_trocar = 1;
    config.trocar[1] = which == 0 ? 0.06 : -0.06; /* so jaws open across the thread */
    config.trocar[2] = 0.1;
    config.closing_force = which == 0 ? 8.0 : 0.4;
    config.paper_distance = 4e-3;
    config.exchange_distance = 0.03;
    config.exchange_centre[1] = which == 0 ? 0.0 : 5e-3;
    if (which == 0) {
        config.driver_bend = 0.3;
        config.driver_neck = 4e-3;
    }
    VBSS_TRY(vbss_grasper_create(context, &config, &run->tools[which]));
    const double tip[3] = {0.0, which == 0 ? 12e-3 : 4e-3, -3e-3};
    VBSS_TRY(vbss_grasper_move(run->tools[which], tip, NULL));
    return vbss_scene_add_grasper(run->scene, run->tools[which], &body);
}

vbss_result tool_run_create(vbss_context *context, vbss_method method, tool_run *run)
{
    vbss_scene_config config;
    *run = (tool_run){.scene = NULL};
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.method = method;
    config.floor = 1;
    config.floor_normal[1] = 0.0;
    config.floor_normal[2] = 1.0;
    config.floor_height = -0.02;
    VBSS_TRY(vbss_scene_create(context, &config, &run->scene));
    VBSS_TRY(add_thread(context, method, run));
    VBSS_TRY(add_tool(context, method, 0, run));
    return add_tool(context, method, 1, run);
}

/* ---- what the hands do */

/* From 0 to 1 between two steps. */
static double share(double step, double from, double until)
{
    double t = (step - from) / (until - from);
    return t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
}

static vbss_result lead(tool_run *run, int which, double step)
{
    bool second = which == 1;
    double pull = share(step, 80.0, 140.0), away = second ? share(step, 150.0, 190.0) : 0.0;
    double back = second ? share(step, 195.0, 235.0) : 0.0;
    double aside = away - back;
    const double tip[3] = {0.04 * aside, second ? (4.0 - 3.0 * pull + 7.0 * back) * 1e-3 : 12e-3,
                           -3e-3 + 4e-3 * pull * (second ? 1.0 - away : 1.0) + 0.03 * aside};
    bool closed = step >= 10.0 && !(second && step >= 145.0 && step < 240.0);
    VBSS_TRY(vbss_grasper_move(run->tools[which], tip, NULL));
    VBSS_TRY(vbss_grasper_set_opening(run->tools[which], closed ? 0.0 : 1.0));
    if (second && (step == 150.0 || step == 192.0)) { /* the first is refused: too near */
        return vbss_grasper_exchange(run->tools[which], VBSS_GRASPER_SHEARS);
    }
    return VBSS_OK;
}

vbss_result tool_run_step(tool_run *run)
{
    vbss_scene_statistics done;
    VBSS_TRY(vbss_scene_get_statistics(run->scene, &done, sizeof done));
    for (int which = 0; which < 2; which++) {
        VBSS_TRY(lead(run, which, (double)done.steps));
    }
    return vbss_scene_step(run->scene, 1e-3);
}
