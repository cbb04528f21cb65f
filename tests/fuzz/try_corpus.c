/* try_corpus log|config [FILE ...]: a fuzzer without libFuzzer. It is given the files, the seeds, the seeds cut off
 * everywhere and the seeds with a few bytes changed, the same ones every time. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "fuzz/fuzz.h"

enum { CUTS = 40, CHANGES = 60 };

static unsigned long tried;

static void try_bytes(const uint8_t *bytes, size_t count)
{
    tried++;
    (void)LLVMFuzzerTestOneInput(bytes, count);
}

static void try_seed(void *user, const char *name, const uint8_t *bytes, size_t count)
{
    vbss_random *random = user;
    (void)name;
    try_bytes(bytes, count);
    for (size_t i = 0; i < CUTS; i++) {
        try_bytes(bytes, count * i / CUTS);
    }
    uint8_t *changed = malloc(count);
    MUST(changed != NULL);
    for (int i = 0; i < CHANGES; i++) {
        memcpy(changed, bytes, count);
        for (uint32_t n = 1 + vbss_random_below(random, 4); n > 0; n--) {
            size_t at = 1 + vbss_random_below(random, (uint32_t)count - 1);
            changed[at] = (uint8_t)vbss_random_below(random, 256);
        }
        try_bytes(changed, count);
    }
    free(changed);
}

static void try_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    MUST(file != NULL && fseek(file, 0, SEEK_END) == 0);
    long size = ftell(file);
    MUST(size >= 0 && fseek(file, 0, SEEK_SET) == 0);
    uint8_t *bytes = malloc((size_t)size + 1);
    MUST(bytes != NULL && fread(bytes, 1, (size_t)size, file) == (size_t)size);
    MUST(fclose(file) == 0);
    try_bytes(bytes, (size_t)size);
    free(bytes);
}

int main(int argc, char **argv)
{
    vbss_random random;
    vbss_random_seed(&random, 1, 1);
    if (argc < 2) {
        fprintf(stderr, "try_corpus log|config [FILE ...]\n");
        return 2;
    }
    for (int i = 2; i < argc; i++) {
        try_file(argv[i]);
    }
    (strcmp(argv[1], "log") == 0 ? make_log_seeds : make_config_seeds)(try_seed, &random);
    printf("%lu inputs\n", tried);
    return 0;
}
