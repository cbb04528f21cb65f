#include "harness/options.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

bench_options bench_default_options(void)
{
    bench_options options = {
        .repetitions = BENCH_REPETITIONS, .seeds = BENCH_SEEDS, .batch_ns = 2e6};
    return options;
}

void bench_print_usage(FILE *to, const char *suite)
{
    fprintf(to,
            "usage: bench_%s [--out FILE] [--filter SUBSTRING] [--repetitions N] [--quick]\n"
            "                [--seeds N] [--list] [--git ID]\n"
            "  --repetitions N  by default and at least %d, with --quick %d\n"
            "  --seeds N        of suites that have some, by default %d, with --quick %d\n"
            "  --quick          a look, not a measurement: the file is marked as quick\n",
            suite, (int)BENCH_REPETITIONS, (int)BENCH_QUICK_REPETITIONS, (int)BENCH_SEEDS,
            (int)BENCH_QUICK_SEEDS);
}

static bool parse_count(const char *text, unsigned *value)
{
    char *end = NULL;
    errno = 0;
    long parsed = strtol(text, &end, 10);
    if (errno != 0 || end == text || *end != '\0' || parsed < 1 || parsed > 100000) {
        return false;
    }
    *value = (unsigned)parsed;
    return true;
}

bool bench_parse_options(int argc, char **argv, bench_options *options, FILE *complaints)
{
    unsigned repetitions = 0, seeds = 0;
    *options = bench_default_options();
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        const char **text = NULL;
        unsigned *wanted = strcmp(word, "--repetitions") == 0 ? &repetitions
                           : strcmp(word, "--seeds") == 0     ? &seeds
                                                              : NULL;
        if (strcmp(word, "--out") == 0) {
            text = &options->out;
        } else if (strcmp(word, "--filter") == 0) {
            text = &options->filter;
        } else if (strcmp(word, "--git") == 0) {
            text = &options->git;
        } else if (strcmp(word, "--quick") == 0) {
            options->quick = true;
        } else if (strcmp(word, "--list") == 0) {
            options->list = true;
        } else if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
            options->help = true;
        } else if (wanted == NULL) {
            fprintf(complaints, "unknown argument '%s'\n", word);
            return false;
        }
        if (text == NULL && wanted == NULL) {
            continue;
        }
        if (++i == argc) {
            fprintf(complaints, "%s needs a value\n", word);
            return false;
        }
        if (text != NULL) {
            *text = argv[i];
        } else if (!parse_count(argv[i], wanted)) {
            fprintf(complaints, "%s needs a number, not '%s'\n", word, argv[i]);
            return false;
        }
    }
    unsigned smallest = options->quick ? BENCH_QUICK_REPETITIONS : BENCH_REPETITIONS;
    if (repetitions != 0 && repetitions < smallest) {
        fprintf(complaints, "--repetitions must be at least %u%s\n", smallest,
                options->quick ? "" : " without --quick");
        return false;
    }
    options->repetitions = repetitions != 0 ? repetitions : smallest;
    options->seeds = seeds != 0       ? seeds
                     : options->quick ? (unsigned)BENCH_QUICK_SEEDS
                                      : (unsigned)BENCH_SEEDS;
    return true;
}
