/* From the command line to the two reports. */
#include <errno.h>
#include <locale.h>
#include <string.h>

#include "harness/report.h"
#include "harness/run.h"

enum { ALL_WELL = 0, CASE_FAILED = 1, WRONG_ARGUMENTS = 2 };

static bool write_json_file(const bench *b, const bench_environment *environment)
{
    const char *path = b->options.out;
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        fprintf(stderr, "cannot write %s: %s\n", path, strerror(errno));
        return false;
    }
    bench_write_json(b, environment, file);
    bool good = !ferror(file);
    good = fclose(file) == 0 && good;
    if (!good) {
        fprintf(stderr, "could not write all of %s\n", path);
    }
    return good;
}

static int run_and_report(bench *b)
{
    bench_environment environment;
    bench_read_environment(&environment); /* before: the load should not be our own */
    bench_run_cases(b, stderr);
    bench_print_table(b, &environment, stdout);
    bool written = b->options.out == NULL || write_json_file(b, &environment);
    return written && bench_failures(b) == 0 ? ALL_WELL : CASE_FAILED;
}

int bench_main(int argc, char **argv, const bench_suite *suite)
{
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    bench_options options;
    if (!bench_parse_options(argc, argv, &options, stderr)) {
        bench_print_usage(stderr, suite->name);
        return WRONG_ARGUMENTS;
    }
    if (options.help) {
        bench_print_usage(stdout, suite->name);
        return ALL_WELL;
    }
    bench b;
    bench_clock clock = bench_system_clock();
    int status = ALL_WELL;
    if (!bench_begin(&b, suite, &options, &clock)) {
        fprintf(stderr, "suite %s: %s\n", suite->name, b.error);
        status = CASE_FAILED;
    } else if (options.list) {
        for (size_t i = 0; i < b.count; i++) {
            if (b.cases[i].selected) {
                puts(b.cases[i].name);
            }
        }
    } else if (bench_selected(&b) == 0) {
        fprintf(stderr, "suite %s has no case%s%s\n", suite->name,
                options.filter != NULL ? " with " : "",
                options.filter != NULL ? options.filter : "");
        status = CASE_FAILED;
    } else {
        status = run_and_report(&b);
    }
    bench_end(&b);
    return status;
}
