#include "thread/cantilever.h"

#include <math.h>
#include <stdlib.h>

#include "harness/clock.h"

#define DAMPING_S 6.0
#define DAMPING_DRAG 8.0
/* CPU time after which the fall is not repeated again. */
#define ENOUGH_NS 2e9

/* Boundary value problem of the inextensible thread, solved to 1e-11. */
static const double static_tip[3] = {15.612192e-3, -143.708681e-3, 0.0};

uint32_t cantilever_steps(double time, double dt)
{
    return (uint32_t)lround(time / dt);
}

double cantilever_distance_mm(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return 1e3 * sqrt(x * x + y * y + z * z);
}

double cantilever_relax_mm(const cantilever_method *method, uint32_t segments, double dt)
{
    const cantilever_setup setup = {.segments = segments, .dt = dt, .drag = DAMPING_DRAG};
    uint32_t steps = cantilever_steps(DAMPING_S, dt);
    double tip[3], off = (double)NAN;
    int status = 0;
    void *thread = method->create(&setup);
    if (thread == NULL) {
        return off;
    }
    for (uint32_t i = 0; status == 0 && i < steps; i++) {
        status = method->step(thread);
    }
    if (status == 0) {
        method->tip(thread, tip);
        off = cantilever_distance_mm(tip, static_tip);
    }
    method->destroy(thread);
    return off;
}

/* Keeps the least time of each step; false when one failed. */
static bool time_steps(const cantilever_method *method, void *thread, double *min_ns,
                       uint32_t steps)
{
    bench_clock clock = bench_system_clock();
    bench_timer_cost cost = bench_measure_timer(&clock);
    for (uint32_t i = 0; i < steps; i++) {
        bench_interval begin = bench_interval_begin(&clock);
        int status = method->step(thread);
        bench_interval taken = bench_interval_net(bench_interval_end(&clock, begin), cost);
        if (status != 0) {
            return false;
        }
        min_ns[i] = fmin(min_ns[i], (double)taken.cpu_ns);
    }
    return true;
}

static double sum_of(const double *values, uint32_t count)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        sum += values[i];
    }
    return sum;
}

double cantilever_us_per_ms(const cantilever_method *method, uint32_t segments, double dt,
                            uint32_t repetitions)
{
    const cantilever_setup setup = {.segments = segments, .dt = dt};
    uint32_t steps = cantilever_steps(CANTILEVER_FALL_S, dt);
    double *min_ns = calloc(steps, sizeof *min_ns), total_ns = 0.0;
    bool good = min_ns != NULL;
    for (uint32_t i = 0; good && i < steps; i++) {
        min_ns[i] = 1e300;
    }
    for (uint32_t r = 0; good && r < repetitions && total_ns < ENOUGH_NS; r++) {
        void *thread = method->create(&setup);
        good = thread != NULL && time_steps(method, thread, min_ns, steps);
        if (thread != NULL) {
            method->destroy(thread);
        }
        total_ns += good ? sum_of(min_ns, steps) : 0.0;
    }
    double us = good ? 1e-3 * sum_of(min_ns, steps) : (double)NAN;
    free(min_ns);
    return us / (CANTILEVER_FALL_S * 1e3);
}
