/* Cases task/double-throw-drawn/<method>/<segments>: what finer threads cost while a double throw is tied, as the paper measured
 * it: the mean step, and percentiles. A thread of 150 mm in equal segments has a loose double throw (as loose as 30
 * segments can be); hands at its ends draw it tight at 25 mm/s, to 2 N. `topology_kept` tells whether it is still that knot.
 * The paper's method makes the same with steps of 1 ms, of 0.2 ms, in which 30 segments keep the knot
 * (docs/explanation/paper-scene.md), and with its own of 1/150 s; compare us/ms. */
#include <stdio.h>

#include "fixtures/baseline_of.h"
#include "contact/pulled_knot.h"
#include "task/bench_task.h"

#define THREAD_LENGTH 0.15
#define LOOSE 3.1e-3       /* a size at which a polyline of 5 mm is the knot */
#define PAPER_DAMPING 0.01 /* or it shakes to pieces */
#define DRAWN_SECONDS 2.0  /* all are tight after 1.9 */

enum { SIZES = 5, QUICK_SIZE = 120 /* of the paper's method */ };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240, 480};

static const struct {
    const char *name;
    vbss_method method;
    double h; /* s */
} methods[] = {{"ours", VBSS_METHOD_IMPLICIT, 1e-3},
               {"paper-1ms", VBSS_METHOD_VBLAST, 1e-3},
               {"paper-0.2ms", VBSS_METHOD_VBLAST, 0.2e-3},
               {"paper-6.67ms", VBSS_METHOD_VBLAST, 1.0 / 150.0}};
enum { METHODS = sizeof methods / sizeof methods[0] };

static pulled_knot knots[METHODS][SIZES];

void add_drawn_cases(bench *b)
{
    for (size_t m = 0; m < METHODS; m++) {
        for (size_t i = 0; i < SIZES; i++) {
            pulled_knot *k = &knots[m][i];
            if (m > 0 && sizes[i] > QUICK_SIZE && bench_is_quick(b)) {
                continue;
            }
            pulled_knot_init(k, KNOT_DOUBLE_OVERHAND, methods[m].method);
            k->options.knot.length = THREAD_LENGTH;
            k->options.knot.finest = k->options.knot.coarsest = THREAD_LENGTH / sizes[i];
            k->options.knot.size = LOOSE;
            baseline_of(&k->options.thread.baseline)->thread_damping = PAPER_DAMPING;
            k->h = methods[m].h;
            k->whole = true;
            k->max_steps = (uint32_t)(DRAWN_SECONDS / k->h + 0.5);
            snprintf(k->name, sizeof k->name, "task/double-throw-drawn/%s/%u", methods[m].name,
                     sizes[i]);
            pulled_knot_add(b, k);
        }
    }
    bench_add_growth(b, &(bench_growth){.name = "task/double-throw-drawn/ours-growth",
                                        .family = "task/double-throw-drawn/ours"});
}
