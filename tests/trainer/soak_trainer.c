/* The whole task under the trainer, with stand-ins of two arms and two handles: a surgeon makes it, and the hands of the
 * stand-ins are led through what he told his tools. They do not see, so it need not become his knot; it is the same work. Twice,
 * which has to come to the same: a slot that is late in both is late by our own time. Seeds 0 to 6 are ten simulated minutes. */
#include "harness/harness.h"
#include "trainer/led.h"

#define SLOT 1e-3 /* s */

enum { RUNS = 2 };

/* ---- what it came to */

static void judge(harness_soak *soak, const led *o)
{
    if (o->illegal != 0) {
        harness_soak_fail(soak, "%d illegal calls, first %s", o->illegal, o->first);
    }
    if (o->now.faults != 0) {
        harness_soak_fail(soak, "faults, first: %s", o->now.events[0].text);
    }
    for (int side = 0; side < HANDS; side++) {
        const hand_figures *h = &o->now.hands[side];
        if (h->asked != h->given || h->asked != o->now.pulses[side] || h->asked == 0 ||
            h->old != 0 || h->refused != 0) {
            harness_soak_fail(soak,
                              "hand %d: pulses %llu, let through %llu, on the line %llu; old poses "
                              "%llu, refused %llu",
                              side, (unsigned long long)h->asked, (unsigned long long)h->given,
                              (unsigned long long)o->now.pulses[side], (unsigned long long)h->old,
                              (unsigned long long)h->refused);
        }
    }
}

static void report(harness_soak *soak, const led o[RUNS])
{
    const figures *f = &o[0].now;
    uint64_t late = 0;
    for (uint64_t i = 0; i < f->slots && i < LED_SLOTS; i++) {
        late += o[0].times[i] > SLOT && o[1].times[i] > SLOT;
    }
    harness_soak_figure(soak, "slots", (double)f->slots);
    harness_soak_figure(soak, "late", (double)f->our_misses);
    harness_soak_figure(soak, "late_in_both", (double)late);
    harness_soak_figure(soak, "mean_us", 1e6 * f->total_work / (double)f->slots);
    harness_soak_figure(soak, "pulses", (double)(f->pulses[LEFT] + f->pulses[RIGHT]));
    harness_soak_figure(soak, "most_N", fmax(f->hands[LEFT].max_force, f->hands[RIGHT].max_force));
    harness_soak_figure(soak, "phase", o[0].status.phase);
    harness_soak_figure(soak, "tied", o[0].tied);
    harness_soak_figure(soak, "transfers", o[0].status.transfers);
    harness_soak_figure(soak, "shears", o[0].shears);
}

/* To the bit: the slit's width would tell any difference in the scene. */
static bool is_same(const vbss_session_status *a, const vbss_session_status *b)
{
    return a->phase == b->phase && a->event_count == b->event_count && a->time == b->time &&
           a->gap == b->gap && a->tail == b->tail;
}

static void run(harness_soak *soak)
{
    static led found[RUNS];
    char path[512], why[256];
    snprintf(path, sizeof path, "%s/soak-%llu.vbss", VBSS_SOAK_FOLDER,
             (unsigned long long)soak->seed);
    if (!led_write_log(soak->seed, path)) {
        harness_soak_fail(soak, "no surgeon");
        return;
    }
    for (int i = 0; i < RUNS; i++) {
        if (!led_run(path, &found[i], why, sizeof why)) {
            harness_soak_fail(soak, "%s", why);
            return;
        }
        judge(soak, &found[i]);
    }
    if (!is_same(&found[0].status, &found[1].status)) {
        harness_soak_fail(soak, "it came to something else the second time");
    }
    report(soak, found);
    (void)remove(path);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
