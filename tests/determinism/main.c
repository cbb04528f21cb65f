/* Runs the golden scenes and prints "scene index hash" lines: the library and this program only, so
 * that it runs anywhere. With the argument `short`, the beginnings of the scenes. */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "determinism/scenes.h"

int main(int argc, char **argv)
{
    bool brief = argc == 2 && strcmp(argv[1], "short") == 0;
    if (argc != 1 && !brief) {
        fprintf(stderr, "usage: %s [short]\n", argv[0]);
        return 2;
    }
    for (size_t i = 0; i < golden_scene_count; i++) {
        const golden_scene *scene = &golden_scenes[i];
        size_t count = brief ? scene->short_count : scene->count;
        uint64_t *hashes = calloc(count, sizeof *hashes);
        if (hashes == NULL) {
            return 1;
        }
        scene->run(hashes, count);
        for (size_t k = 0; k < count; k++) {
            printf("%s %zu %016" PRIx64 "\n", scene->name, k, hashes[k]);
        }
        free(hashes);
    }
    return 0;
}
