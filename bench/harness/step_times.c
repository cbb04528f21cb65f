#include "harness/step_times.h"

#include <stdlib.h>

#include "harness/result.h"
#include "harness/stats.h"

bool bench_allocate_step_times(bench_step_times *times, uint32_t count)
{
    times->count = count;
    times->cpu_ns = calloc(count, sizeof *times->cpu_ns);
    times->wall_ns = calloc(count, sizeof *times->wall_ns);
    return times->cpu_ns != NULL && times->wall_ns != NULL;
}

void bench_free_step_times(bench_step_times *times)
{
    free(times->cpu_ns);
    free(times->wall_ns);
    *times = (bench_step_times){0};
}

static double sort_times(double *sorted_us, const uint64_t *times_ns, uint32_t count)
{
    double sum_us = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        sorted_us[i] = (double)times_ns[i] * 1e-3;
        sum_us += sorted_us[i];
    }
    bench_sort(sorted_us, count);
    return sum_us / (double)count;
}

void bench_report_step_times(const bench_step_times *times, double dt_us, double deadline_us,
                             bench_result *result)
{
    uint32_t n = times->count;
    double *sorted = calloc(n, sizeof *sorted);
    if (sorted == NULL) {
        bench_fail(result, "out of memory for %u steps", n);
        return;
    }

    result->mean_step_us = sort_times(sorted, times->cpu_ns, n);
    result->cpu_time = bench_percentile(sorted, n, 500);
    result->call_cpu_ns = result->cpu_time * 1e3;
    bench_own_counter(result, "median_us", result->cpu_time);
    bench_own_counter(result, "p99_us", bench_percentile(sorted, n, 990));
    bench_own_counter(result, "p999_us", bench_percentile(sorted, n, 999));
    bench_own_counter(result, "max_us", sorted[n - 1]);
    bench_own_counter(result, "mean_us", result->mean_step_us);
    if (deadline_us > 0.0) {
        uint32_t late = 0;
        while (late < n && sorted[n - 1 - late] > deadline_us) {
            late++;
        }
        bench_own_counter(result, "deadline_us", deadline_us);
        bench_own_counter(result, "steps_over_deadline", (double)late);
    }
    if (dt_us > 0.0) {
        bench_simulated_step(result, dt_us);
    }

    sort_times(sorted, times->wall_ns, n);
    result->real_time = bench_percentile(sorted, n, 500);
    result->call_wall_ns = result->real_time * 1e3;
    bench_own_counter(result, "wall_median_us", result->real_time);
    bench_own_counter(result, "wall_p99_us", bench_percentile(sorted, n, 990));
    bench_own_counter(result, "wall_p999_us", bench_percentile(sorted, n, 999));
    bench_own_counter(result, "wall_max_us", sorted[n - 1]);
    free(sorted);

    result->iterations = n;
    result->time_unit = "us";
}
