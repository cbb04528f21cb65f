#include "harness/report.h"

#include "harness/json.h"

static void write_context(const bench *b, const bench_environment *environment, bench_json *json)
{
    const bench_suite *suite = b->suite;
    char library[256];
    bench_copy_without_paths(library, sizeof library, suite->library != NULL ? suite->library : "");

    bench_json_open(json, "context", '{');
    bench_json_string(json, "date", environment->date);
    bench_json_string(json, "executable", suite->name);
    bench_json_string(json, "cpu_model", environment->cpu_model);
    bench_json_integer(json, "num_cpus", environment->cpu_count);
    bench_json_number(json, "mhz_per_cpu", environment->mhz);
    bench_json_open(json, "caches", '[');
    for (unsigned i = 0; i < environment->cache_count; i++) {
        const bench_cache *cache = &environment->caches[i];
        bench_json_open(json, NULL, '{');
        bench_json_string(json, "type", cache->type);
        bench_json_integer(json, "level", cache->level);
        bench_json_integer(json, "size", cache->size);
        bench_json_integer(json, "num_sharing", cache->sharing);
        bench_json_close(json, '}');
    }
    bench_json_close(json, ']');
    bench_json_open(json, "load_avg", '[');
    for (size_t i = 0; i < 3; i++) {
        bench_json_number(json, NULL, environment->load[i]);
    }
    bench_json_close(json, ']');
    bench_json_string(json, "compiler", environment->compiler);
    bench_json_string(json, "compiler_flags", environment->flags);
    bench_json_string(json, "library", library);
#if defined(NDEBUG)
    bench_json_string(json, "library_build_type", "release");
#else
    bench_json_string(json, "library_build_type", "debug");
#endif
    bench_json_string(json, "git", b->options.git != NULL ? b->options.git : "unknown");
    bench_json_boolean(json, "quick", b->options.quick);
    bench_json_string(json, "time_method",
                      "stepped cases: per step the minimum of thread CPU time over repetitions, "
                      "less that of an empty interval, then nearest-rank percentiles over steps; "
                      "batches: per item, minimum and median over repetitions; "
                      "real_time is wall time, treated alike; "
                      "pools: percentiles over the steps of several stepped cases; "
                      "trials: made once, percentiles over their steps");
    bench_json_number(json, "cpu_timer_overhead_ns", b->timer.overhead_ns);
    bench_json_number(json, "cpu_timer_resolution_ns", b->timer.resolution_ns);
    bench_json_integer(json, "cpu_timer_subtracted_ns", b->timer.empty_cpu_ns);
    bench_json_open(json, "skipped", '[');
    for (size_t i = 0; i < b->count; i++) {
        if (b->cases[i].kind == BENCH_SKIPPED && b->cases[i].selected) {
            bench_json_open(json, NULL, '{');
            bench_json_string(json, "name", b->cases[i].name);
            bench_json_string(json, "reason", b->cases[i].reason);
            bench_json_close(json, '}');
        }
    }
    bench_json_close(json, ']');
    bench_json_integer(json, "json_schema_version", 1);
    bench_json_close(json, '}');
}

static void write_case(const bench_case *c, bench_json *json)
{
    const bench_result *result = &c->result;
    bench_json_open(json, NULL, '{');
    bench_json_string(json, "name", c->name);
    bench_json_string(json, "run_name", c->name);
    if (c->kind == BENCH_GROWTH) {
        bench_json_string(json, "run_type", "aggregate");
        bench_json_string(json, "aggregate_name", "growth");
        bench_json_string(json, "aggregate_unit", "time");
    } else {
        bench_json_string(json, "run_type", "iteration");
    }
    bench_json_integer(json, "repetitions", result->repetitions);
    bench_json_integer(json, "threads", 1);
    if (result->failed) {
        bench_json_boolean(json, "error_occurred", true);
        bench_json_string(json, "error_message", result->error);
    }
    /* A case that failed before it had a time has none: zero would be read as fast. */
    if (result->time_unit != NULL) {
        bench_json_integer(json, "iterations", result->iterations);
        bench_json_number(json, "real_time", result->real_time);
        bench_json_number(json, "cpu_time", result->cpu_time);
        bench_json_string(json, "time_unit", result->time_unit);
    }
    for (size_t i = 0; i < result->counter_count; i++) {
        bench_json_number(json, result->counters[i].name, result->counters[i].value);
    }
    bench_json_close(json, '}');
}

void bench_write_json(const bench *b, const bench_environment *environment, FILE *file)
{
    bench_json json = bench_json_to(file);
    bench_json_open(&json, NULL, '{');
    write_context(b, environment, &json);
    bench_json_open(&json, "benchmarks", '[');
    for (size_t i = 0; i < b->count; i++) {
        if (b->cases[i].measured) {
            write_case(&b->cases[i], &json);
        }
    }
    bench_json_close(&json, ']');
    bench_json_close(&json, '}');
}
