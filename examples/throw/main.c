/* Ties knots with two scripted hands and tells how it went. Exits 0 if all seeds are good, or as many as -g asks for, no
 * simulation failed, and each log plays back to the same hashes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "knots/words.h"
#include "throw/mistake.h"
#include "throw/replay.h"

static int usage(void)
{
    fprintf(stderr,
            "throw single|double|square|surgeons|fls [-s seed] [-n seeds] [-g seeds that must be "
            "good: all] [-l log] [-v]\n"
            "      [-k: cut both ends] [-w: wind the wrong way] [-u: draw through unchecked]\n"
            "      [-p folder for pictures] [-e seconds between them] [-c: close] [-t most "
            "seconds a throw]\n"
            "      [-m granny|handle|counter|bight|dropped|one-sided: the mistake in the last "
            "throw]\n");
    return 2;
}

static bool read_options(int count, char **words, trial_options *o, int *seeds, int *smallest)
{
    for (int i = 2; i < count; i++) {
        const char *word = words[i], *value = i + 1 < count ? words[i + 1] : "";
        if (strcmp(word, "-v") == 0) {
            o->verbose = 1;
            continue;
        }
        if (strcmp(word, "-c") == 0) {
            o->near = true;
            continue;
        }
        if (strcmp(word, "-k") == 0) {
            o->cut = true;
            continue;
        }
        if (strcmp(word, "-w") == 0) {
            o->wrong = true;
            continue;
        }
        if (strcmp(word, "-u") == 0) {
            o->unchecked = true;
            continue;
        }
        if (word[0] != '-' || strlen(word) != 2 || i + 1 == count) {
            return false;
        }
        switch (word[1]) {
        case 's':
            o->seed = strtoul(value, NULL, 10);
            break;
        case 'n':
            *seeds = atoi(value);
            break;
        case 'g':
            *smallest = atoi(value);
            break;
        case 'l':
            o->log = value;
            break;
        case 'p':
            o->folder = value;
            break;
        case 'm':
            o->mistake = mistake_named(value);
            if (o->mistake == THROW_NO_MISTAKE) {
                return false;
            }
            break;
        case 'e':
            o->every = strtod(value, NULL);
            break;
        case 't':
            o->time_limit = strtod(value, NULL);
            break;
        default:
            return false;
        }
        i++;
    }
    return *seeds >= 1 && *smallest != 0; /* atoi reads a word as 0 */
}

static void report_mistake(const trial_options *o, const trial_outcome *out)
{
    const vbss_knot_state *k = &out->knot.state, *next = &out->predicted.state;
    char faults[WORD_TAGS];
    words_of_faults(k->faults, faults);
    printf("  %s: wanted: %s\n", mistake_name(o->mistake), mistake_wanted(o->mistake));
    printf("  told: at the tail %s, %d wraps to come; in the end '%s', %s, slip %.2f; %s\n",
           words_of_result(next->next_verdict), (int)next->next_wraps, out->knot.notation,
           words_of_result(k->verdict), out->knot.slip, faults);
}

int main(int count, char **words)
{
    use_decimal_point();
    trial_options o = {.time_limit = 40.0, .every = 0.25};
    int seeds = 1, smallest = -1, good = 0, failed = 0,
        kind = count > 1 ? trial_kind_of(words[1]) : TRIAL_KINDS;
    if (kind == TRIAL_KINDS || !read_options(count, words, &o, &seeds, &smallest)) {
        return usage();
    }
    o.kind = (trial_kind)kind;
    for (int i = 0; i < seeds; i++, o.seed++) {
        trial_outcome out;
        vbss_result result = trial_run(&o, &out);
        if (result != VBSS_OK) {
            printf("%s %3lu: %s\n", trial_name(kind), (unsigned long)o.seed,
                   vbss_result_name(result));
            failed++;
            continue;
        }
        good += out.good;
        printf("%s %3lu: %s '%s' hand %+d retries %d height %5.2f mm %5.2f s cpu %4.1f s clamped "
               "%lu %s %s refused %d cuts %d left %.1f %.1f mm %s %s\n",
               trial_name(kind), (unsigned long)o.seed, out.good ? "good" : "BAD ", out.notation,
               out.handedness, out.retries, out.height * 1e3, out.time, out.cpu,
               (unsigned long)out.clamped, out.state, out.why, out.refused, out.cuts,
               out.left[0] * 1e3, out.left[1] * 1e3, out.kept ? "kept" : "",
               out.tight ? "tight" : "");
        if (o.mistake != THROW_NO_MISTAKE) {
            report_mistake(&o, &out);
        }
        if (o.log != NULL) {
            replay_finding f = replay_file(&o);
            failed += !f.equal;
            printf("replayed %lu steps of %s: %s\n", (unsigned long)f.report.step, o.log,
                   f.equal ? "the same hashes" : f.text);
        }
        fflush(stdout);
    }
    printf("%d of %d\n", good, seeds);
    return good >= (smallest < 0 ? seeds : smallest) && failed == 0 ? 0 : 1;
}
