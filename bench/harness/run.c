#include "harness/run.h"

#include <stdlib.h>
#include <string.h>

static void refuse(bench *b, const char *name, const char *problem)
{
    if (!b->failed) {
        b->failed = true;
        snprintf(b->error, sizeof b->error, "case '%s': %s", name, problem);
    }
}

bool bench_split_name(const char *suite, const char *name, bench_name *parts)
{
    char *const part[] = {parts->scene, parts->method, parts->n};
    size_t length = strlen(suite);
    memset(parts, 0, sizeof *parts);
    if (strncmp(name, suite, length) != 0 || name[length] != '/' ||
        strlen(name) >= BENCH_MAX_NAME) {
        return false;
    }
    const char *from = name + length + 1;
    for (size_t i = 0; i < 3; i++) {
        const char *end = strchr(from, '/');
        size_t size = end != NULL ? (size_t)(end - from) : strlen(from);
        if (size == 0) {
            return false;
        }
        memcpy(part[i], from, size);
        if (end == NULL) {
            return i >= 1;
        }
        from = end + 1;
    }
    return false;
}

static bench_case *add_case(bench *b, bench_kind kind, const char *name)
{
    bench_name parts;
    if (b->failed) {
        return NULL;
    }
    if (name == NULL || !bench_split_name(b->suite->name, name, &parts)) {
        refuse(b, name != NULL ? name : "(null)", "not named <suite>/<scene>/<method>[/<N>]");
        return NULL;
    }
    for (size_t i = 0; i < b->count; i++) {
        if (strcmp(b->cases[i].name, name) == 0) {
            refuse(b, name, "registered twice");
            return NULL;
        }
    }
    if (b->count == b->capacity) {
        size_t capacity = b->capacity == 0 ? 32 : 2 * b->capacity;
        bench_case *cases = realloc(b->cases, capacity * sizeof *cases);
        if (cases == NULL) {
            refuse(b, name, "out of memory");
            return NULL;
        }
        b->cases = cases;
        b->capacity = capacity;
    }
    bench_case *added = &b->cases[b->count++];
    memset(added, 0, sizeof *added);
    added->kind = kind;
    added->name = name;
    added->parts = parts;
    added->selected = b->options.filter == NULL || strstr(name, b->options.filter) != NULL;
    return added;
}

void bench_add_stepped(bench *b, const bench_stepped *stepped)
{
    bench_case *added = add_case(b, BENCH_STEPPED, stepped->name);
    if (added == NULL) {
        return;
    }
    if (stepped->step == NULL || (stepped->steps == 0 && stepped->count == NULL)) {
        refuse(b, stepped->name, "needs step, and steps or count");
        return;
    }
    added->stepped = *stepped;
}

void bench_add_batch(bench *b, const bench_batch *batch)
{
    bench_case *added = add_case(b, BENCH_BATCH, batch->name);
    if (added == NULL) {
        return;
    }
    if (batch->run == NULL || (batch->items == 0 && batch->count == NULL)) {
        refuse(b, batch->name, "needs run, and items or count");
        return;
    }
    added->batch = *batch;
}

void bench_add_growth(bench *b, const bench_growth *growth)
{
    bench_case *added = add_case(b, BENCH_GROWTH, growth->name);
    if (added != NULL) {
        added->growth = *growth;
    }
}

void bench_add_trial(bench *b, const bench_trial *trial)
{
    bench_case *added = add_case(b, BENCH_TRIAL, trial->name);
    if (added == NULL) {
        return;
    }
    if (trial->run == NULL) {
        refuse(b, trial->name, "needs run");
        return;
    }
    added->trial = *trial;
}

void bench_add_pool(bench *b, const bench_pool *pool)
{
    bench_case *added = add_case(b, BENCH_POOL, pool->name);
    if (added != NULL) {
        added->pool = *pool;
    }
}

void bench_add_skipped(bench *b, const char *name, const char *reason)
{
    bench_case *added = add_case(b, BENCH_SKIPPED, name);
    if (added != NULL) {
        added->reason = reason;
    }
}

bool bench_is_quick(const bench *b)
{
    return b->options.quick;
}

unsigned bench_seeds(const bench *b)
{
    return b->options.seeds;
}

bool bench_begin(bench *b, const bench_suite *suite, const bench_options *options,
                 const bench_clock *clock)
{
    memset(b, 0, sizeof *b);
    b->suite = suite;
    b->options = *options;
    b->clock = *clock;
    suite->add_cases(b);
    return !b->failed;
}

static void measure(bench *b, bench_case *c)
{
    switch (c->kind) {
    case BENCH_STEPPED:
        bench_measure_stepped(b, &c->stepped, &c->result);
        c->measured = true;
        break;
    case BENCH_BATCH:
        bench_measure_batch(b, &c->batch, &c->result);
        c->measured = true;
        break;
    case BENCH_GROWTH:
        c->measured = bench_fit_growth(b, &c->growth, &c->result);
        break;
    case BENCH_TRIAL:
        bench_measure_trial(&c->trial, &c->result);
        c->measured = true;
        break;
    case BENCH_POOL:
        c->measured = bench_measure_pool(b, &c->pool, &c->result);
        break;
    case BENCH_SKIPPED:
        break;
    }
}

/* It uses what other cases found out. */
static bool uses_other_cases(const bench_case *c)
{
    return c->kind == BENCH_GROWTH || c->kind == BENCH_POOL;
}

void bench_run_cases(bench *b, FILE *progress)
{
    size_t done = 0, selected = bench_selected(b);
    b->timer = bench_measure_timer(&b->clock);
    /* Those last: a family may be registered after its fit. */
    for (int back = 0; back <= 1; back++) {
        for (size_t i = 0; i < b->count; i++) {
            bench_case *c = &b->cases[i];
            if (!c->selected || c->kind == BENCH_SKIPPED || uses_other_cases(c) != (back == 1)) {
                continue;
            }
            done++;
            if (progress != NULL) {
                fprintf(progress, "[%zu/%zu] %s\n", done, selected, c->name);
                fflush(progress);
            }
            measure(b, c);
        }
    }
}

size_t bench_failures(const bench *b)
{
    size_t failures = 0;
    for (size_t i = 0; i < b->count; i++) {
        failures += b->cases[i].measured && b->cases[i].result.failed ? 1u : 0u;
    }
    return failures;
}

size_t bench_selected(const bench *b)
{
    size_t selected = 0;
    for (size_t i = 0; i < b->count; i++) {
        selected += b->cases[i].selected && b->cases[i].kind != BENCH_SKIPPED ? 1u : 0u;
    }
    return selected;
}

void bench_end(bench *b)
{
    for (size_t i = 0; i < b->count; i++) {
        bench_free_step_times(&b->cases[i].result.steps);
    }
    free(b->cases);
    b->cases = NULL;
    b->count = b->capacity = 0;
}
