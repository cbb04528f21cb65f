/* The calls of the page's module (examples/web/page.h), natively: a script on standard input, one call a line, and the hashes
 * that it asks for on standard output. run_module.mjs does the same with the module. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "web/page.h"

enum { NUMBERS = 12, LINE = 512 };

static int fail(const char *line, int result)
{
    fprintf(stderr, "%s: result %d %s\n", line, result, page_problem());
    return 1;
}

/* Numbers after the word; what a call does not fail with is 0. */
static int call(const char *word, const double v[NUMBERS])
{
    const int32_t first = (int32_t)v[0], second = (int32_t)v[1];
    if (strcmp(word, "begin") == 0) {
        return page_begin(first, (uint32_t)v[1]);
    }
    if (strcmp(word, "exercise") == 0) {
        return page_exercise(first);
    }
    if (strcmp(word, "aids") == 0) {
        return page_set_aids((uint32_t)v[0]);
    }
    if (strcmp(word, "step") == 0) {
        return page_step(first);
    }
    if (strcmp(word, "track") == 0) {
        return page_track(first, second);
    }
    if (strcmp(word, "clutch") == 0) {
        return page_clutch(first, second);
    }
    if (strcmp(word, "exchange") == 0) {
        return page_exchange(first);
    }
    if (strcmp(word, "pose") == 0) {
        page_pose(first, v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], (int32_t)v[9], v[10]);
    } else if (strcmp(word, "move") == 0) {
        page_move(first, second, v[2], v[3], v[4]);
    } else if (strcmp(word, "pull") == 0) {
        page_pull(first, v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
    } else if (strcmp(word, "close") == 0) {
        page_close(first, second);
    } else if (strcmp(word, "camera") == 0) {
        page_set_camera(v[0], v[1], v[2], v[3]);
    } else if (strcmp(word, "hash") == 0) {
        printf("%016" PRIx64 " %016" PRIx64 "\n", page_scene_hash(), page_session_hash());
    } else if (strcmp(word, "state") == 0) {
        puts(page_state());
    } else {
        return -1;
    }
    return 0;
}

int main(void)
{
    char line[LINE];
    while (fgets(line, sizeof line, stdin) != NULL) {
        char word[16];
        double v[NUMBERS] = {0.0};
        int at = 0, more = 0;
        if (sscanf(line, "%15s%n", word, &at) != 1) {
            continue;
        }
        for (int i = 0; i < NUMBERS && sscanf(line + at, "%lf%n", &v[i], &more) == 1; i++) {
            at += more;
        }
        const int result = call(word, v);
        if (result != 0) {
            return fail(line, result);
        }
    }
    return page_end() == 0 ? 0 : 1;
}
