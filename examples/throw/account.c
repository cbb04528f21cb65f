/* What came of a knot, and what it took. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "knots/words.h"
#include "throw/counts.h"
#include "throw/demo.h"

#define PERCENT 100.0
#define MILLI 1e3

/* ---- the knot */

/* The throws alternate; a throw alone is left-handed, as C goes over W's jaws, away, and comes back below. */
static bool is_right_handed(const demo_knot *k)
{
    bool right = k->state.throw_count > 0 && k->throws[0].handedness == -1;
    for (uint32_t i = 1; i < k->state.throw_count && i < DEMO_THROWS; i++) {
        right = right && k->throws[i].handedness == -k->throws[i - 1].handedness;
    }
    return right;
}

static bool report_cuts(const demo *d)
{
    bool good = !d->trial.cut || (d->out.cuts == 2 && d->out.kept);
    if (d->trial.cut) {
        printf("  cut: %d of 2 ends, tail left %.1f mm, long limb %.1f mm; %s the same knot%s\n",
               d->out.cuts, MILLI * d->out.left[0], MILLI * d->out.left[1],
               d->out.kept ? "still" : "no longer", good ? "" : "  NOT WHAT IT SHALL BE");
    }
    return good;
}

static bool report_knot(const demo *d)
{
    const demo_knot *k = &d->knot;
    bool hands = is_right_handed(k);
    /* With short ends a knot is slack, and may be proved no further than to be what it was. */
    bool proved = k->state.verdict == VBSS_KNOT_VERDICT_CERTIFIED || (d->trial.cut && d->out.kept);
    bool good = d->out.good && hands && proved;
    printf("%s: %s, %s (%s)%s\n", d->name, k->notation[0] != '\0' ? k->notation : "no knot",
           words_of_result(k->state.verdict), words_of_name(k->state.name),
           good ? "" : "  NOT WHAT IT SHALL BE");
    for (uint32_t i = 0; i < k->state.throw_count && i < DEMO_THROWS; i++) {
        char words[WORD_TAGS];
        words_of_throw(&k->throws[i], words);
        printf("  throw %u: %s; %u %s\n", (unsigned)i + 1, words, (unsigned)d->tries[i],
               d->tries[i] == 1 ? "try" : "tries");
    }
    if (!hands || !d->out.good) {
        printf("  %s%s %s\n", hands ? "" : "wrong-handed; ", d->out.state, d->out.why);
    }
    printf(
        "  height over the cylinder at 2 N, of the thread's contacts with itself: middle %.2f mm, "
        "lowest %.2f, highest %.2f\n",
        MILLI * d->out.height, MILLI * d->out.lowest, MILLI * d->out.highest);
    return report_cuts(d) && good;
}

/* ---- time */

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Of sorted times, the nearest rank. */
static double percentile(const demo_times *t, double percent)
{
    size_t rank = (size_t)(percent / PERCENT * (double)t->count);
    return t->steps[rank < t->count ? rank : t->count - 1];
}

static void report_time(demo *d)
{
    demo_times *t = &d->times;
    double sum = 0.0;
    if (t->count == 0) {
        return;
    }
    for (size_t i = 0; i < t->count; i++) {
        sum += 1e-6 * t->steps[i];
    }
    qsort(t->steps, t->count, sizeof t->steps[0], compare);
    printf("  %.2f s simulated in %.2f s: real-time factor %.1f; of the scene's steps alone %.1f\n",
           d->out.time, d->cpu, d->out.time / d->cpu, d->out.time / sum);
    printf("  a step of 1 ms with its log, us of this thread's CPU: median %.0f, p99 %.0f, p99.9 "
           "%.0f, most %.0f"
           " (%lu steps, one run on a shared machine)\n",
           percentile(t, 50.0), percentile(t, 99.0), percentile(t, 99.9), t->steps[t->count - 1],
           (unsigned long)t->count);
}

bool demo_report(demo *d)
{
    bool good = report_knot(d);
    report_time(d);
    counts_report_scene(&d->scene);
    counts_report_device("left device", &d->device[0], &d->output[0], d->largest[0]);
    counts_report_device("right device", &d->device[1], &d->output[1], d->largest[1]);
    return good;
}
