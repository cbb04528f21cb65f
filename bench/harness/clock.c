#define _POSIX_C_SOURCE 200809L
#include "harness/clock.h"

#include <time.h>

static uint64_t read_clock(clockid_t id)
{
    struct timespec now;
    if (clock_gettime(id, &now) != 0) {
        return 0;
    }
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

static uint64_t system_cpu_ns(void *user)
{
    (void)user;
    return read_clock(CLOCK_THREAD_CPUTIME_ID);
}

static uint64_t system_wall_ns(void *user)
{
    (void)user;
    return read_clock(CLOCK_MONOTONIC);
}

bench_clock bench_system_clock(void)
{
    bench_clock clock = {system_cpu_ns, system_wall_ns, NULL};
    return clock;
}

bench_interval bench_interval_begin(const bench_clock *clock)
{
    bench_interval begin;
    begin.wall_ns = clock->wall_ns(clock->user);
    begin.cpu_ns = clock->cpu_ns(clock->user);
    return begin;
}

bench_interval bench_interval_end(const bench_clock *clock, bench_interval begin)
{
    bench_interval taken;
    taken.cpu_ns = clock->cpu_ns(clock->user) - begin.cpu_ns;
    taken.wall_ns = clock->wall_ns(clock->user) - begin.wall_ns;
    return taken;
}

bench_interval bench_interval_net(bench_interval interval, bench_timer_cost cost)
{
    interval.cpu_ns -= interval.cpu_ns < cost.empty_cpu_ns ? interval.cpu_ns : cost.empty_cpu_ns;
    interval.wall_ns -=
        interval.wall_ns < cost.empty_wall_ns ? interval.wall_ns : cost.empty_wall_ns;
    return interval;
}

bench_timer_cost bench_measure_timer(const bench_clock *clock)
{
    enum { FEW_READINGS = 2000, MANY_READINGS = 200000 };
    uint64_t first = clock->cpu_ns(clock->user), previous = first, smallest = UINT64_MAX;
    uint32_t readings = 0;
    /* Where the clock ticks coarsely, a few readings may see no tick at all. */
    while (readings < FEW_READINGS || (smallest == UINT64_MAX && readings < MANY_READINGS)) {
        uint64_t now = clock->cpu_ns(clock->user);
        readings++;
        if (now > previous && now - previous < smallest) {
            smallest = now - previous;
        }
        previous = now;
    }
    bench_timer_cost cost = {.overhead_ns = (double)(previous - first) / (double)readings,
                             .resolution_ns = smallest != UINT64_MAX ? (double)smallest : 0.0,
                             .empty_cpu_ns = UINT64_MAX,
                             .empty_wall_ns = UINT64_MAX};
    for (int i = 0; i < FEW_READINGS; i++) {
        bench_interval empty = bench_interval_end(clock, bench_interval_begin(clock));
        if (empty.cpu_ns < cost.empty_cpu_ns) {
            cost.empty_cpu_ns = empty.cpu_ns;
        }
        if (empty.wall_ns < cost.empty_wall_ns) {
            cost.empty_wall_ns = empty.wall_ns;
        }
    }
    return cost;
}

double bench_timer_cost_ns(bench_timer_cost cost)
{
    double worst = cost.overhead_ns > cost.resolution_ns ? cost.overhead_ns : cost.resolution_ns;
    return worst > 1.0 ? worst : 1.0;
}
