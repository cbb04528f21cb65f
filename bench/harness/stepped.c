/* Stepped cases: for each step index the least time over all repetitions. */
#include <stdlib.h>

#include "harness/run.h"
#include "harness/stats.h"

typedef struct step_records {
    uint32_t steps;
    uint64_t *cpu_ns, *wall_ns, *hashes;
    double *sorted_us;
} step_records;

static bool allocate_records(step_records *records, uint32_t steps)
{
    records->steps = steps;
    records->cpu_ns = calloc(steps, sizeof *records->cpu_ns);
    records->wall_ns = calloc(steps, sizeof *records->wall_ns);
    records->hashes = calloc(steps, sizeof *records->hashes);
    records->sorted_us = calloc(steps, sizeof *records->sorted_us);
    return records->cpu_ns != NULL && records->wall_ns != NULL && records->hashes != NULL &&
           records->sorted_us != NULL;
}

static void free_records(step_records *records)
{
    free(records->cpu_ns);
    free(records->wall_ns);
    free(records->hashes);
    free(records->sorted_us);
}

static bool repeat_steps(const bench *b, const bench_stepped *stepped, unsigned repetition,
                         step_records *records, bench_result *result)
{
    int status = stepped->restore != NULL ? stepped->restore(stepped->user) : 0;
    if (status != 0) {
        bench_fail(result, "restore returned %d in repetition %u", status, repetition);
        return false;
    }
    for (uint32_t i = 0; i < records->steps; i++) {
        bench_interval begin = bench_interval_begin(&b->clock);
        status = stepped->step(stepped->user, i);
        bench_interval taken = bench_interval_end(&b->clock, begin);
        taken = bench_interval_net(taken, b->timer);
        if (status != 0) {
            bench_fail(result, "step %u returned %d in repetition %u", i, status, repetition);
            return false;
        }
        bench_keep_minimum(records->cpu_ns, i, taken.cpu_ns, repetition == 0);
        bench_keep_minimum(records->wall_ns, i, taken.wall_ns, repetition == 0);
        if (stepped->hash == NULL) {
            continue;
        }
        uint64_t hash = stepped->hash(stepped->user);
        if (repetition == 0) {
            records->hashes[i] = hash;
        } else if (hash != records->hashes[i]) {
            bench_fail(result, "repetition %u differs from the first in state after step %u",
                       repetition, i);
            return false;
        }
    }
    return true;
}

static double sort_times(step_records *records, const uint64_t *times_ns)
{
    double sum_us = 0.0;
    for (uint32_t i = 0; i < records->steps; i++) {
        records->sorted_us[i] = (double)times_ns[i] * 1e-3;
        sum_us += records->sorted_us[i];
    }
    bench_sort(records->sorted_us, records->steps);
    return sum_us / (double)records->steps;
}

static void summarise(const bench_stepped *stepped, step_records *records, bench_result *result)
{
    const double *sorted = records->sorted_us;
    uint32_t n = records->steps;

    // NOLINTNEXTLINE(clang-analyzer-unix.Malloc): loses track of what free_records gives back
    result->mean_step_us = sort_times(records, records->cpu_ns);
    result->cpu_time = bench_percentile(sorted, n, 500);
    result->call_cpu_ns = result->cpu_time * 1e3;
    bench_own_counter(result, "median_us", result->cpu_time);
    bench_own_counter(result, "p99_us", bench_percentile(sorted, n, 990));
    bench_own_counter(result, "p999_us", bench_percentile(sorted, n, 999));
    bench_own_counter(result, "max_us", sorted[n - 1]);
    bench_own_counter(result, "mean_us", result->mean_step_us);
    if (stepped->deadline_us > 0.0) {
        uint32_t late = 0;
        while (late < n && sorted[n - 1 - late] > stepped->deadline_us) {
            late++;
        }
        bench_own_counter(result, "deadline_us", stepped->deadline_us);
        bench_own_counter(result, "steps_over_deadline", (double)late);
    }
    if (stepped->dt_us > 0.0) {
        bench_simulated_step(result, stepped->dt_us);
    }

    sort_times(records, records->wall_ns);
    result->real_time = bench_percentile(sorted, n, 500);
    result->call_wall_ns = result->real_time * 1e3;
    bench_own_counter(result, "wall_median_us", result->real_time);
    bench_own_counter(result, "wall_p99_us", bench_percentile(sorted, n, 990));
    bench_own_counter(result, "wall_p999_us", bench_percentile(sorted, n, 999));
    bench_own_counter(result, "wall_max_us", sorted[n - 1]);

    result->iterations = n;
    result->time_unit = "us";
}

static void measure_after_setup(const bench *b, const bench_stepped *stepped, bench_result *result)
{
    uint32_t steps = stepped->steps != 0 ? stepped->steps : stepped->count(stepped->user);
    step_records records = {0};
    if (steps == 0) {
        bench_fail(result, "count returned no steps");
    } else if (!allocate_records(&records, steps)) {
        bench_fail(result, "out of memory for %u steps", steps);
    } else {
        bool good = true;
        for (unsigned r = 0; good && r < b->options.repetitions; r++) {
            good = repeat_steps(b, stepped, r, &records, result);
            result->repetitions = r + 1;
        }
        if (good) {
            summarise(stepped, &records, result);
            if (stepped->finish != NULL) {
                stepped->finish(stepped->user, result);
            }
        }
    }
    free_records(&records);
}

void bench_measure_stepped(const bench *b, const bench_stepped *stepped, bench_result *result)
{
    int status = stepped->setup != NULL ? stepped->setup(stepped->user) : 0;
    if (status != 0) {
        bench_fail(result, "setup returned %d", status);
        return;
    }
    measure_after_setup(b, stepped, result);
    if (stepped->teardown != NULL) {
        stepped->teardown(stepped->user);
    }
}
