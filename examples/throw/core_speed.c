#include "throw/core_speed.h"

#include <stdbool.h>
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

static vbss_result measure(vbss_context *context, double *operations_per_us)
{
    vbss_core_speed measured;
    TRY(vbss_core_speed_measure(context, cpu_clock, NULL, &measured, sizeof measured));
    *operations_per_us = measured.operations_per_us;
    return VBSS_OK;
}

vbss_result core_speed_fit(double operations_per_us, vbss_solver_options *solver,
                           char words[CORE_SPEED_WORDS])
{
    vbss_context *context;
    const char *why = "";
    const bool is_given = operations_per_us > 0.0;
    const double smallest = 0.2 * vbss_solver_options_default().operations_per_us;
    double speed = operations_per_us;
    TRY(vbss_context_create(NULL, &context));
    const vbss_result result = is_given ? VBSS_OK : measure(context, &speed);
    if (result == VBSS_OK) {
        solver->operations_per_us = speed > smallest ? speed : smallest;
        snprintf(words, CORE_SPEED_WORDS,
                 "%.0f operations per us%s%s: budgets of %.0f us a step, %.0f us a call", speed,
                 is_given ? " (given)" : " (measured)",
                 speed < smallest ? ", too few, so calls take longer" : "", solver->step_budget_us,
                 solver->call_budget_us);
    } else {
        (void)vbss_context_get_last_error(context, NULL, &why);
        snprintf(words, CORE_SPEED_WORDS, "the speed of the core is unknown: %s", why);
    }
    (void)vbss_context_destroy(context);
    return result;
}
