/* Two scripted hands tie by devices alone: a seed is twenty hands of different speed, tremor and aim, at one kind of
 * knot. How many must tie it, after how many retries at most, and how high it may sit, stands below. */
#include <string.h>

#include "harness/harness.h"
#include "throw/trial.h"

enum { HANDS = 20, KINDS = 3, RETRIES = 2 };
#define LONGEST 40.0 /* s for a throw */
#define HIGHEST 2e-3 /* m above the cylinder */

/* The first throw is left-handed, as C goes over W's jaws, away, and comes back below; the next is the other way. */
static const struct kind {
    const char *name, *notation;
    trial_kind kind;
    uint32_t smallest;
    int handedness; /* of the last throw */
} kinds[KINDS] = {
    {"double", "2", TRIAL_DOUBLE, 18, -1},
    {"single", "1", TRIAL_SINGLE, 20, -1},
    {"throw on a double", "2=1", TRIAL_SURGEONS, 18, 1},
};

static bool is_right(const struct kind *k, const trial_outcome *o)
{
    return o->good && strcmp(o->notation, k->notation) == 0 && o->handedness == k->handedness &&
           o->retries <= RETRIES && o->height <= HIGHEST;
}

static void run(harness_soak *soak)
{
    const struct kind *k = &kinds[soak->seed % KINDS];
    uint32_t right = 0, at_once = 0;
    double highest = -1.0;
    uint64_t clamped = 0;
    for (uint64_t i = 1; i <= HANDS; i++) {
        trial_options o = {.kind = k->kind, .time_limit = LONGEST};
        trial_outcome out;
        o.seed = soak->seed / KINDS * HANDS + i;
        vbss_result result = trial_run(&o, &out);
        if (result != VBSS_OK) {
            harness_soak_fail(soak, "%s, hands %llu: %s", k->name, (unsigned long long)o.seed,
                              vbss_result_name(result));
        } else if (is_right(k, &out)) {
            right++;
            at_once += out.retries == 0 ? 1 : 0;
            highest = out.height > highest ? out.height : highest;
            clamped += out.clamped;
        }
    }
    if (right < k->smallest) {
        harness_soak_fail(soak, "%s: %u of %d", k->name, (unsigned)right, HANDS);
    }
    harness_soak_figure(soak, "right", right);
    harness_soak_figure(soak, "at_once", at_once);
    harness_soak_figure(soak, "highest_mm", 1e3 * highest);
    harness_soak_figure(soak, "clamped", (double)clamped);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
