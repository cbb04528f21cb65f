/* Errors of the elementary functions over many arguments: 100 seeds make the 10^7 arguments a
 * function of docs/explanation/elementary-functions.md. With `--seed S --count N` prints a table instead. */
#include <stdlib.h>

#include "base/elementary_ulp.h"
#include "harness/harness.h"

#define COUNT_A_SEED 100000u

static void run(harness_soak *soak)
{
    for (size_t i = 0; i < ELEMENTARY_FUNCTIONS; i++) {
        const elementary_function *f = &elementary_functions[i];
        elementary_argument where = {0.0, 0.0};
        double worst = worst_ulp_error(f, soak->seed, COUNT_A_SEED, &where);
        harness_soak_figure(soak, f->name, worst);
        if (!(worst <= f->bound + REFERENCE_ERROR)) {
            harness_soak_fail(soak, "%s is %.4f ulp off at x = %a, y = %a", f->name, worst, where.x,
                              where.y);
        }
    }
}

static int print_table(uint64_t seed, uint64_t count)
{
    int failed = 0;
    for (size_t i = 0; i < ELEMENTARY_FUNCTIONS; i++) {
        const elementary_function *f = &elementary_functions[i];
        elementary_argument where = {0.0, 0.0};
        double worst = worst_ulp_error(f, seed, count, &where);
        printf("%-6s %.4f ulp at x = %a, y = %a\n", f->name, worst, where.x, where.y);
        failed |= !(worst <= f->bound + REFERENCE_ERROR);
    }
    return failed;
}

int main(int argc, char **argv)
{
    if (argc == 5 && strcmp(argv[1], "--seed") == 0 && strcmp(argv[3], "--count") == 0) {
        return print_table(strtoull(argv[2], NULL, 10), strtoull(argv[4], NULL, 10));
    }
    return harness_soak_main(argc, argv, run);
}
