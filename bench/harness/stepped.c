/* Stepped cases: for each step index the least time over all repetitions. */
#include <stdlib.h>

#include "harness/run.h"
#include "harness/stats.h"

typedef struct step_records {
    bench_step_times times;
    uint64_t *hashes;
} step_records;

static bool allocate_records(step_records *records, uint32_t steps)
{
    records->hashes = calloc(steps, sizeof *records->hashes);
    return bench_allocate_step_times(&records->times, steps) && records->hashes != NULL;
}

static void free_records(step_records *records)
{
    bench_free_step_times(&records->times);
    free(records->hashes);
}

/* The step alone is timed. */
static int time_step(const bench *b, const bench_stepped *stepped, uint32_t index,
                     bench_interval *taken)
{
    int status = stepped->before != NULL ? stepped->before(stepped->user, index) : 0;
    if (status == 0) {
        bench_interval begin = bench_interval_begin(&b->clock);
        status = stepped->step(stepped->user, index);
        *taken = bench_interval_net(bench_interval_end(&b->clock, begin), b->timer);
    }
    if (status == 0 && stepped->after != NULL) {
        status = stepped->after(stepped->user, index);
    }
    return status;
}

static bool repeat_steps(const bench *b, const bench_stepped *stepped, unsigned repetition,
                         step_records *records, bench_result *result)
{
    int status = stepped->restore != NULL ? stepped->restore(stepped->user) : 0;
    if (status != 0) {
        bench_fail(result, "restore returned %d in repetition %u", status, repetition);
        return false;
    }
    for (uint32_t i = 0; i < records->times.count; i++) {
        bench_interval taken = {0, 0};
        status = time_step(b, stepped, i, &taken);
        if (status != 0) {
            bench_fail(result, "step %u returned %d in repetition %u", i, status, repetition);
            return false;
        }
        bench_keep_minimum(records->times.cpu_ns, i, taken.cpu_ns, repetition == 0);
        bench_keep_minimum(records->times.wall_ns, i, taken.wall_ns, repetition == 0);
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
            bench_report_step_times(&records.times, stepped->dt_us, stepped->deadline_us, result);
            if (stepped->finish != NULL) {
                stepped->finish(stepped->user, result);
            }
            if (stepped->pool != NULL) {
                result->steps = records.times;
                records.times = (bench_step_times){0};
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
