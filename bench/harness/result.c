#include "harness/result.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Counters stand beside these in one flat JSON object. */
static const char *const taken_names[] = {
    "name",          "run_name",       "run_type",       "repetitions", "threads",
    "iterations",    "real_time",      "cpu_time",       "time_unit",   "error_occurred",
    "error_message", "aggregate_name", "aggregate_unit",
};

static bool is_usable_name(const char *name)
{
    if (name[0] == '\0' || strlen(name) >= BENCH_MAX_COUNTER_NAME) {
        return false;
    }
    for (size_t i = 0; i < sizeof taken_names / sizeof taken_names[0]; i++) {
        if (strcmp(name, taken_names[i]) == 0) {
            return false;
        }
    }
    return true;
}

const bench_counter_entry *bench_find_counter(const bench_result *result, const char *name)
{
    for (size_t i = 0; i < result->counter_count; i++) {
        if (strcmp(result->counters[i].name, name) == 0) {
            return &result->counters[i];
        }
    }
    return NULL;
}

static void set_counter(bench_result *result, const char *name, double value, bool own)
{
    if (!is_usable_name(name)) {
        bench_fail(result, "'%s' cannot name a counter", name);
        return;
    }
    if (!isfinite(value)) {
        bench_fail(result, "counter %s is not finite", name);
    }
    size_t i = 0;
    while (i < result->counter_count && strcmp(result->counters[i].name, name) != 0) {
        i++;
    }
    if (i == BENCH_MAX_COUNTERS) {
        bench_fail(result, "more than %d counters", (int)BENCH_MAX_COUNTERS);
        return;
    }
    if (i == result->counter_count) {
        result->counter_count++;
        memcpy(result->counters[i].name, name, strlen(name) + 1);
    }
    result->counters[i].value = value;
    result->counters[i].own = own;
}

void bench_counter(bench_result *result, const char *name, double value)
{
    set_counter(result, name, value, false);
}

void bench_own_counter(bench_result *result, const char *name, double value)
{
    set_counter(result, name, value, true);
}

double bench_counter_value(const bench_result *result, const char *name)
{
    const bench_counter_entry *entry = bench_find_counter(result, name);
    return entry != NULL ? entry->value : (double)NAN;
}

void bench_simulated_step(bench_result *result, double dt_us)
{
    bench_own_counter(result, "dt_us", dt_us);
    bench_own_counter(result, "us_per_ms", result->mean_step_us * 1000.0 / dt_us);
}

void bench_fail(bench_result *result, const char *format, ...)
{
    if (result->failed) {
        return;
    }
    result->failed = true;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(result->error, sizeof result->error, format, arguments);
    va_end(arguments);
}
