/* Two scripted hands pass a needle through both marks of a drain, through devices alone:
 *
 *     pass_needle [-s seed] [-n seeds] [-g seeds that must be good: all] [-t most seconds] [-l log] [-p folder for pictures] [-v] [-k]
 *
 * The log is played back. Tells of each seed what came of it; -v also what the hands do, -k only how many were good. Exits 0 if all were, or as
 * many as -g asks for, no simulation failed, and each log plays back to the same hashes. */
#include <stdio.h>
#include <stdlib.h>

#include "decimal_point.h"
#include "needle/pass.h"

#define MILLI 1e3
#define MICRO 1e6

static int usage(void)
{
    fprintf(stderr, "pass_needle [-s seed] [-n seeds] [-g seeds that must be good: all] [-t most "
                    "seconds] [-l log] "
                    "[-p folder for pictures] [-v] [-k: quiet]\n");
    return 2;
}

typedef struct tally {
    int seeds, good, within; /* 1 mm of both marks */
    int failed;              /* simulations, and logs that do not play back */
    int again;               /* seeds that were drawn back */
    double off[2], max_off[2], wall[2];
    double min_wall[2];
} tally;

static bool read_options(int count, char **words, pass_options *o, int *seeds, int *smallest,
                         bool *quiet)
{
    for (int i = 1; i < count; i++) {
        const char *word = words[i];
        if (word[0] != '-' || word[1] == '\0' || word[2] != '\0') {
            return false;
        }
        if (word[1] == 'v') {
            o->verbose = true;
            continue;
        }
        if (word[1] == 'k') {
            *quiet = true;
            continue;
        }
        if (++i == count) {
            return false;
        }
        switch (word[1]) {
        case 's':
            o->seed = strtoul(words[i], NULL, 10);
            break;
        case 'n':
            *seeds = atoi(words[i]);
            break;
        case 'g':
            *smallest = atoi(words[i]);
            break;
        case 't':
            o->time_limit = strtod(words[i], NULL);
            break;
        case 'l':
            o->log = words[i];
            break;
        case 'p':
            o->folder = words[i];
            break;
        default:
            return false;
        }
    }
    return *seeds >= 1 && *smallest != 0; /* atoi reads a word as 0 */
}

static double quantile(const pass_outcome *out, double share)
{
    uint32_t i = (uint32_t)(share * out->count);
    return out->count == 0 ? 0.0 : MICRO * out->steps[i < out->count ? i : out->count - 1];
}

static void report(uint64_t seed, const pass_outcome *o)
{
    printf("seed %3lu: %s %s %s  %.2f s, taken at try %d, back from the left wall %d, holes %u, "
           "else %u, out %.1f mm\n",
           (unsigned long)seed, o->good ? "good" : "BAD ", o->state, o->why, o->time, o->tries,
           o->again, (unsigned)o->punctures, (unsigned)o->others, MILLI * o->out);
    printf("  right: %.2f mm off, wall %.2f N, hole %.2f N; left: %.2f mm off, wall %.2f N, hole "
           "%.2f N; hands %.2f and %.2f N; slid in the jaws %.3f mm\n",
           MILLI * o->off[1], o->wall[1], o->hole[1], MILLI * o->off[0], o->wall[0], o->hole[0],
           o->hand[1], o->hand[0], MILLI * o->slid);
    printf("  steps: %u, median %.0f us, p99 %.0f, p99.9 %.0f, longest %.0f; clamped %lu, paused "
           "%lu\n",
           (unsigned)o->count, quantile(o, 0.5), quantile(o, 0.99), quantile(o, 0.999),
           quantile(o, 1.0), (unsigned long)o->scene.clamped, (unsigned long)o->scene.paused);
    fflush(stdout);
}

static void count(tally *t, const pass_outcome *o)
{
    t->seeds++;
    t->good += o->good;
    t->again += o->again > 0;
    t->within += o->good && o->off[0] < 1e-3 && o->off[1] < 1e-3;
    for (int side = 0; o->good && side < 2; side++) {
        t->off[side] += o->off[side];
        t->max_off[side] = larger(t->max_off[side], o->off[side]);
        t->wall[side] = larger(t->wall[side], o->wall[side]);
        t->min_wall[side] =
            t->good == 1 ? o->wall[side] : smaller(t->min_wall[side], o->wall[side]);
    }
}

int main(int argc, char **argv)
{
    use_decimal_point();
    pass_options o = {.seed = 1, .time_limit = 20.0};
    static double steps[PASS_STEPS];
    pass_outcome out = {.steps = steps};
    tally t = {0};
    int seeds = 1, smallest = -1;
    bool quiet = false, painted = true;
    if (!read_options(argc, argv, &o, &seeds, &smallest, &quiet)) {
        return usage();
    }
    for (int i = 0; i < seeds; i++, o.seed++) {
        vbss_result result = pass_run(&o, &out);
        if (result != VBSS_OK) {
            printf("seed %3lu: %s\n", (unsigned long)o.seed, vbss_result_name(result));
            t.seeds++;
            t.failed++;
            continue;
        }
        count(&t, &out);
        painted = painted && out.painted;
        if (o.log != NULL) {
            bool same = pass_replay(&o);
            printf("%s, played back: %s\n", o.log, same ? "the same hashes" : "NOT THE SAME");
            t.failed += !same;
        }
        if (!quiet) {
            report(o.seed, &out);
        }
    }
    printf(
        "%d of %d through both marks, %d within 1 mm of both; drawn back from the left wall: %d\n",
        t.good, t.seeds, t.within, t.again);
    if (t.good > 0) {
        printf("off, mean and most: right %.2f, %.2f mm; left %.2f, %.2f mm; walls entered at "
               "%.2f to %.2f N and %.2f to %.2f N\n",
               MILLI * t.off[1] / t.good, MILLI * t.max_off[1], MILLI * t.off[0] / t.good,
               MILLI * t.max_off[0], t.min_wall[1], t.wall[1], t.min_wall[0], t.wall[0]);
    }
    return t.good >= (smallest < 0 ? seeds : smallest) && t.failed == 0 && painted ? 0 : 1;
}
