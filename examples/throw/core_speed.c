#include "throw/core_speed.h"

#include <stdio.h>
#include <time.h>

#include "throw/rig.h"

double cpu_clock(void *unused)
{
    struct timespec t;
    (void)unused;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static vbss_result fit(vbss_context *context, double *speed, vbss_scene_config *scene)
{
    vbss_budget_speed measured;
    vbss_budget_config budget;
    if (*speed <= 0.0) {
        TRY(vbss_budget_measure_speed(context, cpu_clock, NULL, &measured, sizeof measured));
        *speed = measured.operations_per_microsecond;
    }
    TRY(vbss_budget_config_init(&budget, sizeof budget));
    TRY(vbss_scene_config_init(scene, sizeof *scene));
    budget.operations_per_microsecond = *speed;
    return vbss_budget_fit_scene(context, &budget, scene);
}

vbss_result core_speed_fit(double operations_per_microsecond, core_limits *limits,
                           char words[CORE_SPEED_WORDS])
{
    vbss_context *context;
    vbss_scene_config scene;
    const char *why = "";
    double speed = operations_per_microsecond;
    TRY(vbss_context_create(NULL, &context));
    const vbss_result result = fit(context, &speed, &scene);
    if (result == VBSS_OK) {
        *limits = (core_limits){(int32_t)scene.step_budget, (int32_t)scene.call_budget};
        snprintf(words, CORE_SPEED_WORDS,
                 "%.0f operations per microsecond%s: limits of work %d a step, %d a call", speed,
                 operations_per_microsecond > 0.0 ? " (given)" : " (measured)", (int)limits->work,
                 (int)limits->slot);
    } else {
        (void)vbss_context_get_last_error(context, NULL, &why);
        snprintf(words, CORE_SPEED_WORDS, "the speed of the core is unknown: %s", why);
    }
    (void)vbss_context_destroy(context);
    return result;
}
