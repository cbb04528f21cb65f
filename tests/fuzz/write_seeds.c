/* write_seeds FOLDER log|config: the seeds as files, for libFuzzer to begin with. */
#include <stdio.h>
#include <string.h>

#include "fuzz/fuzz.h"

static void write_seed(void *user, const char *name, const uint8_t *bytes, size_t count)
{
    char path[4096];
    MUST(snprintf(path, sizeof path, "%s/%s", (const char *)user, name) < (int)sizeof path);
    FILE *file = fopen(path, "wb");
    MUST(file != NULL && fwrite(bytes, 1, count, file) == count);
    MUST(fclose(file) == 0);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "write_seeds FOLDER log|config\n");
        return 2;
    }
    (strcmp(argv[2], "log") == 0 ? make_log_seeds : make_config_seeds)(write_seed, argv[1]);
    return 0;
}
