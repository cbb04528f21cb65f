/* Growth of a family <family>/<N> as an exponent. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/run.h"
#include "harness/stats.h"

enum { MIN_POINTS = 3 };

/* The N of a member of the family within the range, 0 for any other case. */
static uint32_t member_n(const bench_growth *growth, const char *name)
{
    size_t length = strlen(growth->family);
    if (strncmp(name, growth->family, length) != 0 || name[length] != '/') {
        return 0;
    }
    const char *digits = name + length + 1;
    char *end = NULL;
    errno = 0;
    unsigned long n = strtoul(digits, &end, 10);
    if (errno != 0 || digits[0] < '0' || digits[0] > '9' || *end != '\0' || n > UINT32_MAX) {
        return 0;
    }
    bool inside = n >= growth->n_min && (growth->n_max == 0 || n <= growth->n_max);
    return inside ? (uint32_t)n : 0;
}

static void fit_points(const double *n, const double *cpu_ns, const double *wall_ns, size_t points,
                       bench_result *result)
{
    bench_power_fit cpu, wall;
    if (!bench_fit_power(n, cpu_ns, points, &cpu) || !bench_fit_power(n, wall_ns, points, &wall)) {
        bench_fail(result, "no fit: times must be positive and N must differ");
        return;
    }
    double smallest = n[0], largest = n[0];
    for (size_t i = 1; i < points; i++) {
        smallest = n[i] < smallest ? n[i] : smallest;
        largest = n[i] > largest ? n[i] : largest;
    }
    result->iterations = points;
    result->time_unit = "us";
    result->cpu_time = cpu.scale * pow(largest, cpu.exponent) * 1e-3;
    result->real_time = wall.scale * pow(largest, wall.exponent) * 1e-3;
    bench_counter(result, "exponent", cpu.exponent);
    bench_counter(result, "fit_r2", cpu.r2);
    bench_counter(result, "n_min", smallest);
    bench_counter(result, "n_max", largest);
    bench_counter(result, "points", (double)points);
}

bool bench_fit_growth(const bench *b, const bench_growth *growth, bench_result *result)
{
    double *values = calloc(3 * b->count, sizeof *values);
    if (values == NULL) {
        bench_fail(result, "out of memory");
        return true;
    }
    double *n = values, *cpu_ns = values + b->count, *wall_ns = values + 2 * b->count;
    size_t points = 0;
    bool judged = true;
    for (size_t i = 0; i < b->count; i++) {
        const bench_case *c = &b->cases[i];
        uint32_t member = c->measured && c->kind != BENCH_GROWTH ? member_n(growth, c->name) : 0;
        if (member == 0) {
            continue;
        }
        if (c->result.failed) {
            bench_fail(result, "%s failed", c->name);
        }
        n[points] = (double)member;
        cpu_ns[points] = c->result.call_cpu_ns;
        wall_ns[points] = c->result.call_wall_ns;
        points++;
    }
    result->repetitions = b->options.repetitions;
    if (points < MIN_POINTS) {
        judged = b->options.filter == NULL;
        bench_fail(result, "only %zu cases %s/<N>", points, growth->family);
    } else if (!result->failed) {
        fit_points(n, cpu_ns, wall_ns, points, result);
    }
    free(values);
    return judged;
}
