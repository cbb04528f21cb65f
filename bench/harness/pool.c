/* Steps of several cases as those of one. */
#include <string.h>

#include "harness/run.h"

static bool is_member(const bench_case *c, const bench_pool *pool)
{
    return c->measured && c->kind == BENCH_STEPPED && c->stepped.pool != NULL &&
           strcmp(c->stepped.pool, pool->name) == 0;
}

static void append(bench_step_times *all, const bench_step_times *some)
{
    memcpy(all->cpu_ns + all->count, some->cpu_ns, some->count * sizeof *some->cpu_ns);
    memcpy(all->wall_ns + all->count, some->wall_ns, some->count * sizeof *some->wall_ns);
    all->count += some->count;
}

static void report_all(const bench *b, const bench_pool *pool, uint32_t count, bench_result *result)
{
    bench_step_times all = {0};
    if (!bench_allocate_step_times(&all, count)) {
        bench_fail(result, "out of memory for %u steps", count);
    } else {
        all.count = 0;
        for (size_t i = 0; i < b->count; i++) {
            if (is_member(&b->cases[i], pool)) {
                append(&all, &b->cases[i].result.steps);
            }
        }
        bench_report_step_times(&all, pool->dt_us, pool->deadline_us, result);
        if (pool->finish != NULL) {
            pool->finish(pool->user, result);
        }
    }
    bench_free_step_times(&all);
}

bool bench_measure_pool(const bench *b, const bench_pool *pool, bench_result *result)
{
    uint32_t members = 0, count = 0;
    for (size_t i = 0; i < b->count; i++) {
        const bench_case *c = &b->cases[i];
        if (!is_member(c, pool)) {
            continue;
        }
        if (c->result.failed) {
            bench_fail(result, "%s failed", c->name);
        }
        members++;
        count += c->result.steps.count;
    }
    result->repetitions = b->options.repetitions;
    if (members == 0) {
        bench_fail(result, "no case is in it");
        return b->options.filter == NULL;
    }
    if (!result->failed) {
        report_all(b, pool, count, result);
    }
    return true;
}
