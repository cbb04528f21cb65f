/* Batch cases: a kernel called so often that the timer does not matter. */
#include <stdlib.h>

#include "harness/run.h"
#include "harness/stats.h"

/* A timed batch lasts at least this many times what the timer may be wrong by: 0.5 %. */
#define TIMER_SHARE 200.0
#define MAX_CALLS (1u << 30)

static bench_interval time_calls(const bench_clock *clock, const bench_batch *batch, uint32_t calls)
{
    bench_interval begin = bench_interval_begin(clock);
    for (uint32_t i = 0; i < calls; i++) {
        batch->run(batch->user);
        bench_keep_memory(batch->user);
    }
    return bench_interval_end(clock, begin);
}

/* 0 when no number of calls lasts long enough. */
static uint32_t find_calls(const bench *b, const bench_batch *batch)
{
    double wanted = TIMER_SHARE * bench_timer_cost_ns(b->timer);
    if (wanted < b->options.batch_ns) {
        wanted = b->options.batch_ns;
    }
    uint32_t calls = 1;
    for (;;) {
        double taken = (double)time_calls(&b->clock, batch, calls).cpu_ns;
        if (taken >= wanted) {
            return calls;
        }
        if (calls >= MAX_CALLS) {
            return 0;
        }
        /* Aim a little beyond, but do not trust a short interval for more than one decade. */
        double factor = taken > 0.0 ? 1.2 * wanted / taken : 10.0;
        factor = factor < 1.5 ? 1.5 : factor > 10.0 ? 10.0 : factor;
        double next = (double)calls * factor + 1.0;
        calls = next < (double)MAX_CALLS ? (uint32_t)next : MAX_CALLS;
    }
}

static bool measure_calls(const bench *b, const bench_batch *batch, uint32_t items,
                          bench_result *result)
{
    unsigned repetitions = b->options.repetitions;
    uint32_t calls = find_calls(b, batch);
    if (calls == 0) {
        bench_fail(result, "the clock stands still");
        return false;
    }
    double *cpu = calloc(repetitions, sizeof *cpu);
    double *wall = calloc(repetitions, sizeof *wall);
    bool good = cpu != NULL && wall != NULL;
    if (!good) {
        bench_fail(result, "out of memory");
    } else {
        double per_item = 1.0 / ((double)calls * (double)items);
        for (unsigned r = 0; r < repetitions; r++) {
            bench_interval taken = time_calls(&b->clock, batch, calls);
            cpu[r] = (double)taken.cpu_ns * per_item;
            wall[r] = (double)taken.wall_ns * per_item;
        }
        bench_sort(cpu, repetitions);
        bench_sort(wall, repetitions);
        result->repetitions = repetitions;
        result->iterations = (uint64_t)calls * items;
        result->cpu_time = cpu[0];
        result->real_time = wall[0];
        result->time_unit = "ns";
        result->call_cpu_ns = cpu[0] * (double)items;
        result->call_wall_ns = wall[0] * (double)items;
        bench_own_counter(result, "ns", cpu[0]);
        bench_own_counter(result, "median_ns", bench_percentile(cpu, repetitions, 500));
        bench_own_counter(result, "wall_ns", wall[0]);
        bench_own_counter(result, "wall_median_ns", bench_percentile(wall, repetitions, 500));
    }
    free(cpu);
    free(wall);
    return good;
}

void bench_measure_batch(const bench *b, const bench_batch *batch, bench_result *result)
{
    int status = batch->setup != NULL ? batch->setup(batch->user) : 0;
    if (status != 0) {
        bench_fail(result, "setup returned %d", status);
        return;
    }
    uint32_t items = batch->items != 0 ? batch->items : batch->count(batch->user);
    if (items == 0) {
        bench_fail(result, "count returned no items");
    } else if (measure_calls(b, batch, items, result) && batch->finish != NULL) {
        batch->finish(batch->user, result);
    }
    if (batch->teardown != NULL) {
        batch->teardown(batch->user);
    }
}
