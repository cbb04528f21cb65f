/* Prints the hashes of a performance of the scripted surgeon, one "index hash" a line: the library, the hands and this
 * program only, so that it runs anywhere.
 *
 *     vbss_performance SEED MOST     a hash after every second, at most so many, and one at the end */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "determinism/performance.h"

enum { EVERY = 1000, ROOM = 600 };

int main(int argc, char **argv)
{
    static uint64_t hashes[ROOM];
    size_t count = 0, largest = argc == 3 ? strtoul(argv[2], NULL, 10) : 0;
    if (largest == 0 || largest > ROOM) {
        fprintf(stderr, "usage: %s SEED MOST (at most %d)\n", argv[0], ROOM);
        return 2;
    }
    vbss_result result =
        performance_run(strtoul(argv[1], NULL, 10), EVERY, hashes, largest, &count);
    for (size_t i = 0; i < count; i++) {
        printf("%zu %016" PRIx64 "\n", i, hashes[i]);
    }
    if (result != VBSS_OK) {
        fprintf(stderr, "%s\n", vbss_result_name(result));
    }
    return result == VBSS_OK ? 0 : 1;
}
