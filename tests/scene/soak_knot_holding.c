/* A square holds more than a granny, and that more than half hitches (docs/explanation/knot-holding.md): of twelve of each, tied a
 * little differently, the 95 % intervals of the medians do not overlap. Every seed has its own twelve, of a friction and
 * a load in turn. */
#include <stdlib.h>

#include "base/error.h"
#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "fixtures/held_knot.h"

/* By rank: of twelve the third and the tenth, which is 96 %. */
enum { KINDS = 3, DRAWS = 12, LOW = 2, HIGH = 9 };

static const knot_kind kinds[KINDS] = {KNOT_SQUARE, KNOT_GRANNY, KNOT_HALF_HITCHES};
static const double frictions[] = {0.3, 0.4}, forces[] = {1.0, 5.0};
/* s. At 1 ms half hitches bear half as much again as at 0.5 ms, where they have converged (docs/notebook/bends.md). */
static const double step = 0.5e-3;

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool type_kept(const held_knot *knot)
{
    const vec3 *x;
    uint32_t count;
    knot_type found, right = knot_type_of_kind(knot->options.tied.knot.kind, false);
    return held_knot_strand(knot, &x, &count) == VBSS_OK && knot_type_of(x, count, &found) &&
           knot_type_same(found, right);
}

static vbss_result hold(harness_soak *out, const held_knot_options *options, double *holds)
{
    static held_knot knot;
    vbss_context *context;
    VBSS_TRY(vbss_context_create(NULL, &context));
    VBSS_TRY(held_knot_create(context, options, &knot));
    VBSS_TRY(held_knot_run(&knot));
    const char *name = knot_names[options->tied.knot.kind];
    bool good =
        knot.end == HELD_KNOT_GREW || knot.end == HELD_KNOT_SLIPPED || knot.end == HELD_KNOT_HELD;
    if (!good || !type_kept(&knot)) {
        harness_soak_fail(out, "%s of seed %llu: %s", name, (unsigned long long)options->seed,
                          held_knot_ends[knot.end]);
    }
    *holds = knot.holds;
    return vbss_context_destroy(context);
}

/* Sorted. */
static void hold_all(harness_soak *out, knot_kind kind, double force, double friction,
                     double *holds)
{
    for (uint64_t k = 0; k < DRAWS && out->failures == 0; k++) {
        held_knot_options options;
        vbss_result result = held_knot_init(&options, kind, force, friction);
        options.step = step;
        held_knot_vary(&options, 1000 + DRAWS * out->seed + k);
        result = result != VBSS_OK ? result : hold(out, &options, &holds[k]);
        if (result != VBSS_OK) {
            harness_soak_fail(out, "%s: %s", knot_names[kind], vbss_result_name(result));
        }
    }
    qsort(holds, DRAWS, sizeof holds[0], by_size);
}

static void run(harness_soak *out)
{
    double holds[KINDS][DRAWS] = {{0.0}};
    double friction = frictions[out->seed % 2], force = forces[out->seed / 2 % 2];
    for (int i = 0; i < KINDS; i++) {
        hold_all(out, kinds[i], force, friction, holds[i]);
    }
    for (int i = 0; i + 1 < KINDS; i++) {
        if (holds[i][LOW] <= holds[i + 1][HIGH]) {
            harness_soak_fail(out, "friction %g, %g N: %s from %g N, %s to %g N", friction, force,
                              knot_names[kinds[i]], holds[i][LOW], knot_names[kinds[i + 1]],
                              holds[i + 1][HIGH]);
        }
    }
    harness_soak_figure(out, "square_low_N", holds[0][LOW]);
    harness_soak_figure(out, "granny_high_N", holds[1][HIGH]);
    harness_soak_figure(out, "granny_low_N", holds[1][LOW]);
    harness_soak_figure(out, "half_hitches_high_N", holds[2][HIGH]);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
