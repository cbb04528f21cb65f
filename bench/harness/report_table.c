#include "harness/report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/text_table.h"

enum { MAX_COLUMNS = 40, LEFT_COLUMNS = 2 };

/* Columns before the suite's own counters, in their order. */
static const struct {
    const char *head, *counter;
} own_columns[] = {
    {"us/ms", "us_per_ms"},
    {"median us", "median_us"},
    {"p99 us", "p99_us"},
    {"p99.9 us", "p999_us"},
    {"max us", "max_us"},
    {"wall median us", "wall_median_us"},
    {"late", "steps_over_deadline"},
    {"ns", "ns"},
    {"median ns", "median_ns"},
    {"wall ns", "wall_ns"},
    {"dt us", "dt_us"},
};

static bool has_n(const bench_case *c)
{
    return c->parts.n[0] != '\0';
}

/* By N as a number where it is one; members of one N in the order of their registration. */
static int compare_rows(const void *a, const void *b)
{
    const bench_case *x = *(const bench_case *const *)a, *y = *(const bench_case *const *)b;
    double nx = strtod(x->parts.n, NULL), ny = strtod(y->parts.n, NULL);
    if (nx < ny || nx > ny) {
        return nx < ny ? -1 : 1;
    }
    int order = strcmp(x->parts.n, y->parts.n);
    return order != 0 ? order : (x > y) - (x < y);
}

/* How much longer c takes than the reference method on the same scene and N; NaN when there is
 * nothing to compare. Methods may use steps of different length, so time per simulated time comes
 * first. */
static double ratio_to(const bench_case *c, const bench_case *reference)
{
    if (reference == NULL || c->result.failed || reference->result.failed) {
        return (double)NAN;
    }
    double mine = bench_counter_value(&c->result, "us_per_ms");
    double theirs = bench_counter_value(&reference->result, "us_per_ms");
    if (isnan(mine) || isnan(theirs)) {
        bool same_unit = strcmp(c->result.time_unit, reference->result.time_unit) == 0;
        mine = same_unit ? c->result.cpu_time : (double)NAN;
        theirs = reference->result.cpu_time;
    }
    return theirs > 0.0 ? mine / theirs : (double)NAN;
}

/* The first registered method of the row's scene, at the row's N; NULL when it has no such N. Cases
 * lie in memory in the order of their registration. */
static const bench_case *find_reference(bench_case *const *rows, size_t count, const bench_case *c)
{
    const bench_case *first = c;
    for (size_t i = 0; i < count; i++) {
        if (strcmp(rows[i]->parts.scene, c->parts.scene) == 0 && rows[i] < first) {
            first = rows[i];
        }
    }
    for (size_t i = 0; i < count; i++) {
        if (strcmp(rows[i]->parts.scene, c->parts.scene) == 0 &&
            strcmp(rows[i]->parts.method, first->parts.method) == 0 &&
            strcmp(rows[i]->parts.n, c->parts.n) == 0) {
            return rows[i];
        }
    }
    return NULL;
}

static void set_ratio(text_table *table, size_t column, const bench_case *c, double ratio)
{
    char text[TEXT_CELL_SIZE];
    if (c->result.failed) {
        text_table_set(table, column, "ERROR");
    } else if (!isnan(ratio)) {
        snprintf(text, sizeof text, ratio < 100.0 ? "%.2f" : "%.0f", ratio);
        text_table_set(table, column, text);
    }
}

static void set_row(text_table *table, const bench_case *c, bool with_scene, double ratio,
                    const char *ratio_head)
{
    const bench_result *result = &c->result;
    size_t scene_column = text_table_column(table, "scene");
    if (with_scene) {
        text_table_set(table, scene_column, c->parts.scene);
    }
    text_table_set(table, text_table_column(table, "method"), c->parts.method);
    text_table_set(table, text_table_column(table, "N"), c->parts.n);
    set_ratio(table, text_table_column(table, ratio_head), c, ratio);
    for (size_t i = 0; i < sizeof own_columns / sizeof own_columns[0]; i++) {
        text_table_set_number(table, text_table_column(table, own_columns[i].head),
                              bench_counter_value(result, own_columns[i].counter));
    }
    for (size_t i = 0; i < result->counter_count; i++) {
        const bench_counter_entry *counter = &result->counters[i];
        if (!counter->own) {
            text_table_set_number(table, text_table_column(table, counter->name), counter->value);
        }
    }
}

static void print_rows(bench_case **rows, size_t count, FILE *file)
{
    text_table table;
    char ratio_head[BENCH_MAX_NAME + 8];
    snprintf(ratio_head, sizeof ratio_head, "x %s", rows[0]->parts.method);
    qsort(rows, count, sizeof *rows, compare_rows);
    if (!text_table_create(&table, count, MAX_COLUMNS)) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        const bench_case *c = rows[i];
        bool new_n = i > 0 && strcmp(c->parts.n, rows[i - 1]->parts.n) != 0;
        bool peers = i + 1 < count && strcmp(c->parts.n, rows[i + 1]->parts.n) == 0;
        bool new_scene = i == 0 || strcmp(c->parts.scene, rows[i - 1]->parts.scene) != 0;
        text_table_row(&table, new_n && peers);
        set_row(&table, c, new_scene, ratio_to(c, find_reference(rows, count, c)), ratio_head);
    }
    text_table_print(&table, LEFT_COLUMNS, file);
    text_table_destroy(&table);
}

static void print_growth(const bench_case *c, FILE *file)
{
    const bench_result *result = &c->result;
    fprintf(file, "  %s: time grows as N^%.3f from %.0f to %.0f (%.0f points, r2 %.4f)\n", c->name,
            bench_counter_value(result, "exponent"), bench_counter_value(result, "n_min"),
            bench_counter_value(result, "n_max"), bench_counter_value(result, "points"),
            bench_counter_value(result, "fit_r2"));
}

/* Prints the block that case `first` opens, and marks its cases. A scene with N is a block of its
 * own; short ones without it, registered one after the other, share one. */
static void print_block(const bench *b, size_t first, bench_case **rows, bool *printed, FILE *file)
{
    bool shared = !has_n(&b->cases[first]);
    size_t count = 0;
    for (size_t i = first; i < b->count; i++) {
        bench_case *c = &b->cases[i];
        if (!c->measured || c->kind == BENCH_GROWTH || printed[i]) {
            continue;
        }
        if (shared && has_n(c)) {
            break;
        }
        if (shared || strcmp(c->parts.scene, b->cases[first].parts.scene) == 0) {
            printed[i] = true;
            rows[count++] = c;
        }
    }
    putc('\n', file);
    print_rows(rows, count, file);
    for (size_t i = 0; i < b->count; i++) {
        const bench_case *c = &b->cases[i];
        if (c->measured && c->kind == BENCH_GROWTH && !c->result.failed &&
            strcmp(c->parts.scene, b->cases[first].parts.scene) == 0) {
            print_growth(c, file);
        }
    }
}

static void print_head(const bench *b, const bench_environment *environment, FILE *file)
{
    fprintf(file, "suite %s   %s   %u CPUs, %.0f MHz   %s   %s%s\n", b->suite->name,
            environment->cpu_model, environment->cpu_count, environment->mhz, environment->compiler,
            environment->date, b->options.quick ? "   QUICK: not a measurement" : "");
    fprintf(file, "flags %s\n", environment->flags);
    fprintf(file,
            "CPU time of the thread, minimum over %u repetitions; empty interval of %llu ns "
            "subtracted from steps; load %.2f\n",
            b->options.repetitions, (unsigned long long)b->timer.empty_cpu_ns,
            environment->load[0]);
}

static void print_problems(const bench *b, FILE *file)
{
    for (size_t i = 0; i < b->count; i++) {
        const bench_case *c = &b->cases[i];
        if (c->kind == BENCH_SKIPPED && c->selected) {
            fprintf(file, "skipped %s: %s\n", c->name, c->reason);
        } else if (c->measured && c->result.failed) {
            fprintf(file, "ERROR %s: %s\n", c->name, c->result.error);
        }
    }
}

void bench_print_table(const bench *b, const bench_environment *environment, FILE *file)
{
    print_head(b, environment, file);
    bench_case **rows = calloc(b->count + 1, sizeof *rows);
    bool *printed = calloc(b->count + 1, sizeof *printed);
    for (size_t i = 0; rows != NULL && printed != NULL && i < b->count; i++) {
        /* A growth stands below its family, which has the same scene. */
        if (!printed[i] && b->cases[i].measured && b->cases[i].kind != BENCH_GROWTH) {
            print_block(b, i, rows, printed, file);
        }
    }
    free(rows);
    free(printed);
    putc('\n', file);
    print_problems(b, file);
}
