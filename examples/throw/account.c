/* What came of a knot, and what it took. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "knots/words.h"
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

static bool tell_cuts(const demo *d)
{
    bool good = !d->trial.cut || (d->out.cuts == 2 && d->out.kept);
    if (d->trial.cut) {
        printf("  cut: %d of 2 ends, tail left %.1f mm, long limb %.1f mm; %s the same knot%s\n",
               d->out.cuts, MILLI * d->out.left[0], MILLI * d->out.left[1],
               d->out.kept ? "still" : "no longer", good ? "" : "  NOT WHAT IT SHALL BE");
    }
    return good;
}

static bool tell_knot(const demo *d)
{
    const demo_knot *k = &d->knot;
    bool hands = is_right_handed(k);
    /* With short ends a knot is slack, and may be proved no further than to be what it was. */
    bool proved = k->state.verdict == VBSS_KNOT_VERDICT_CERTIFIED || (d->trial.cut && d->out.kept);
    bool good = d->out.good && hands && proved;
    printf("%s: %s, %s (%s)%s\n", d->name, k->notation[0] != '\0' ? k->notation : "no knot",
           words_of_verdict(k->state.verdict), words_of_name(k->state.name),
           good ? "" : "  NOT WHAT IT SHALL BE");
    for (uint32_t i = 0; i < k->state.throw_count && i < DEMO_THROWS; i++) {
        char words[WORDS];
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
    return tell_cuts(d) && good;
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

static void tell_time(demo *d)
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

/* ---- counts */

static unsigned long long u(uint64_t count)
{
    return count;
}

static void tell_scene(const demo *d)
{
    const vbss_scene_statistics *s = &d->scene;
    printf("  contacts at the end %u; parts of steps %llu of %llu attempts; rejected: states %llu, "
           "stretch %llu,"
           " depth %llu, guard %llu, singular %llu, full %llu\n",
           (unsigned)s->contacts, u(s->parts), u(s->attempts), u(s->rejected_states),
           u(s->rejected_stretch), u(s->rejected_depth), u(s->rejected_guard),
           u(s->rejected_singular), u(s->rejected_full));
    printf("  loose states %llu, loose stretch %llu, clamped by the guard %llu, recovering %llu; "
           "pairs the guard"
           " tested %llu\n",
           u(s->loose_states), u(s->loose_stretch), u(s->clamped), u(s->recovering),
           u(s->guard_pairs));
    printf("  deepest penetration %.1f %% of the thread's diameter; largest stretch error %.1e\n",
           PERCENT * s->penetration / (2.0 * THREAD_RADIUS), s->stretch_error);
}

static void tell_device(const demo *d, int i)
{
    const vbss_device_statistics *in = &d->device[i];
    const vbss_output_statistics *out = &d->output[i];
    printf("  %s: %llu samples read, %llu refused; %llu forces written, largest %.2f N (the "
           "tool's: %.2f N);"
           " limited %llu, slewed %llu, over the continuous load %llu, stale %llu, watchdog %llu; "
           "held at the workspace %llu\n",
           i == 0 ? "left device" : "right device", u(in->accepted[0]),
           u(in->out_of_order[0] + in->not_finite[0] + in->out_of_range[0] + in->not_unit[0] +
             in->failed_reads[0]),
           u(out->steps), out->largest_force, d->most[i], u(out->clamped), u(out->slewed),
           u(out->continuous), u(out->input_stale + out->command_stale), u(out->watchdogs),
           u(in->clamped_reads));
}

bool demo_tell(demo *d)
{
    bool good = tell_knot(d);
    tell_time(d);
    tell_scene(d);
    tell_device(d, 0);
    tell_device(d, 1);
    return good;
}
