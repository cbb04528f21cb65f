/* Trials: run once, and timed by themselves. */
#include "harness/run.h"
#include "harness/stats.h"

static double mean_of(const double *times, uint32_t count)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        sum += times[i];
    }
    return sum / (double)count;
}

void bench_trial_steps(bench_result *result, double *cpu_us, double *wall_us, uint32_t count)
{
    if (count == 0) {
        bench_fail(result, "no step was made");
        return;
    }
    bench_sort(cpu_us, count);
    bench_sort(wall_us, count);
    result->iterations = count;
    result->time_unit = "us";
    result->mean_step_us = mean_of(cpu_us, count);
    result->cpu_time = bench_percentile(cpu_us, count, 500);
    result->real_time = bench_percentile(wall_us, count, 500);
    result->call_cpu_ns = result->cpu_time * 1e3;
    result->call_wall_ns = result->real_time * 1e3;
    bench_own_counter(result, "p50_us", result->cpu_time);
    bench_own_counter(result, "p99_us", bench_percentile(cpu_us, count, 990));
    bench_own_counter(result, "p999_us", bench_percentile(cpu_us, count, 999));
    bench_own_counter(result, "max_us", cpu_us[count - 1]);
    bench_own_counter(result, "mean_us", result->mean_step_us);
    bench_own_counter(result, "wall_p50_us", result->real_time);
    bench_own_counter(result, "wall_p99_us", bench_percentile(wall_us, count, 990));
    bench_own_counter(result, "wall_p999_us", bench_percentile(wall_us, count, 999));
    bench_own_counter(result, "wall_max_us", wall_us[count - 1]);
}

void bench_measure_trial(const bench_trial *trial, bench_result *result)
{
    trial->run(trial->user, result);
    result->repetitions = 1;
    if (result->time_unit == NULL) {
        bench_fail(result, "it has not told what its steps took");
    }
}
