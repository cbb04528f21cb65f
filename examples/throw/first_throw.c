/* From a device's sample to a certified throw, a picture and a replay:
 *
 *     first_throw -o folder [-s seed] [single] [double] [square] [surgeons] [fls]
 *
 * ties these knots (without a name: single and double) by two scripted hands, each measured by a device; of surgeons and
 * fls they cut the ends. Says what they do, what it came to and what it took; writes <knot>.vbss (the log), <knot>.png
 * (the sheet of all key stages)
 * and <knot>-<throw>-<stage>.png into the folder, which must be there. Exits 0 if every knot is what it shall be,
 * certified and seated, and if its log replays to equal hashes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "throw/demo.h"

#define LONGEST 40.0 /* s for a throw */

static int usage(void)
{
    fprintf(stderr,
            "first_throw -o folder [-s seed] [single] [double] [square] [surgeons] [fls]\n");
    return 2;
}

/* ---- one knot */

static bool tie(int kind, uint64_t seed, const char *folder)
{
    static demo d;
    memset(&d, 0, sizeof d);
    d.name = trial_name(kind);
    d.folder = folder;
    snprintf(d.log, sizeof d.log, "%s/%s.vbss", folder, d.name);
    d.trial = (trial_options){.kind = (trial_kind)kind,
                              .seed = seed,
                              .time_limit = LONGEST,
                              .log = d.log,
                              .cut = kind == TRIAL_SURGEONS || kind == TRIAL_FLS,
                              .watch = demo_watch,
                              .user = &d};
    printf("-- %s, hands of seed %lu\n", d.name, (unsigned long)seed);
    d.album = album_create(folder, d.name);
    vbss_result result = trial_run(&d.trial, &d.out);
    bool painted = album_close(d.album), good = false;
    if (result == VBSS_OK && d.ended) {
        bool right = demo_report(&d), replayed = demo_replay(&d);
        good = right && replayed && painted;
    } else {
        printf("%s: broken off: %s\n", d.name, vbss_result_name(result));
    }
    free(d.times.steps);
    printf("%s: %s\n\n", d.name, good ? "done" : "FAILED");
    fflush(stdout);
    return good;
}

/* ---- what is asked for */

int main(int count, char **words)
{
    use_decimal_point();
    int asked[2 * TRIAL_KINDS] = {0, 1}, number = 0;
    const char *folder = NULL;
    uint64_t seed = 1;
    bool good = true;
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], "-o") == 0 && i + 1 < count) {
            folder = words[++i];
        } else if (strcmp(words[i], "-s") == 0 && i + 1 < count) {
            seed = strtoul(words[++i], NULL, 10);
        } else if (trial_kind_of(words[i]) < TRIAL_KINDS && number < 2 * TRIAL_KINDS) {
            asked[number++] = trial_kind_of(words[i]);
        } else {
            return usage();
        }
    }
    if (folder == NULL) {
        return usage();
    }
    number = number > 0 ? number : 2;
    for (int i = 0; i < number; i++) {
        good = tie(asked[i], seed, folder) && good;
    }
    return good ? 0 : 1;
}
