/* The main of a soak: one seed, one line of JSON. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

void harness_soak_fail(harness_soak *soak, const char *format, ...)
{
    soak->failures++;
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "seed %llu: ", (unsigned long long)soak->seed);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
}

void harness_soak_figure(harness_soak *soak, const char *name, double value)
{
    size_t used = strlen(soak->figures);
    size_t room = sizeof soak->figures - used;
    int length = isfinite(value)
                     ? snprintf(soak->figures + used, room, ", \"%s\": %.17g", name, value)
                     : snprintf(soak->figures + used, room, ", \"%s\": null", name);
    if (length < 0 || (size_t)length >= room) {
        soak->figures[used] = '\0';
        harness_soak_fail(soak, "no room for figure %s", name);
    }
}

int harness_soak_main(int argc, char **argv, void (*run)(harness_soak *soak))
{
    if (argc != 3 || strcmp(argv[1], "--seed") != 0) {
        fprintf(stderr, "usage: %s --seed S\n", argv[0]);
        return 2;
    }
    harness_soak soak = {.seed = strtoull(argv[2], NULL, 10)};
    run(&soak);
    printf("{\"seed\": %llu, \"failures\": %llu%s}\n", (unsigned long long)soak.seed,
           (unsigned long long)soak.failures, soak.figures);
    return soak.failures == 0 ? 0 : 1;
}
