/* What a finer mesh and a shorter step gain: the length that an overhand knot takes up until it bears 2 N,
 * against the same knot on a mesh finer than all. Error beside cost. The paper's knots never show the load: they are pulled
 * for as long as ours, so that their ends are where ours are, and asked whether they are knots still. */
#include <math.h>
#include <stdio.h>

#include "fixtures/baseline_of.h"
#include "contact/bench_contact.h"
#include "contact/pulled_knot.h"

#define REFERENCE_SEGMENT 0.2e-3
#define REFERENCE_STEP 0.5e-3
static const double segments[] = {2.5e-3, 1.25e-3, 0.625e-3, 0.5e-3, 0.4e-3, 0.3e-3, 0.25e-3};
static const double steps[] = {2e-3, 1e-3, 0.5e-3};
enum { SEGMENTS = sizeof segments / sizeof segments[0], STEPS = sizeof steps / sizeof steps[0] };

/* Its own are 5 mm and 1/150 s. */
static const double paper_segments[] = {5e-3, 2.5e-3, 1.25e-3, 0.625e-3};
static const double paper_steps[] = {1.0 / 150.0, 1e-3, 1e-4};
enum {
    PAPER_SEGMENTS = sizeof paper_segments / sizeof paper_segments[0],
    QUICK_PAPER_SEGMENTS = 3, /* the finest takes as long as all others */
    PAPER_STEPS = sizeof paper_steps / sizeof paper_steps[0]
};
/* A size at which the polyline of 5 mm is the knot. */
#define PAPER_SIZE 3.1e-3
#define PAPER_SECONDS 1.526
#define PAPER_DAMPING 0.01 /* or it shakes to pieces */

static pulled_knot knots[STEPS][SEGMENTS], paper_knots[PAPER_STEPS][PAPER_SEGMENTS];

static void set(pulled_knot *k, double segment, double h)
{
    pulled_knot_init(k, KNOT_OVERHAND, VBSS_METHOD_IMPLICIT);
    k->options.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    k->options.knot.finest = segment;
    k->options.knot.coarsest = vbss_max(segment, 2e-3);
    k->h = h;
}

/* Once for all cases. */
static double reference_mm(void)
{
    static double known = -1.0;
    if (known < 0.0) {
        pulled_knot k;
        set(&k, REFERENCE_SEGMENT, REFERENCE_STEP);
        known = pulled_knot_make(&k) && pulled_knot_run(&k) ? 1e3 * k.taken_up : (double)NAN;
        pulled_knot_end(&k);
    }
    return known;
}

static void add_error(bench_result *result)
{
    double reference = reference_mm();
    bench_counter(result, "reference_mm", reference);
    bench_counter(result, "taken_up_error_mm",
                  fabs(bench_counter_value(result, "taken_up_mm") - reference));
}

static void add_paper_cases(bench *b)
{
    size_t count = bench_is_quick(b) ? QUICK_PAPER_SEGMENTS : PAPER_SEGMENTS;
    for (size_t h = 0; h < PAPER_STEPS; h++) {
        for (size_t i = 0; i < count; i++) {
            pulled_knot *k = &paper_knots[h][i];
            pulled_knot_init(k, KNOT_OVERHAND, VBSS_METHOD_VBLAST);
            k->options.knot.finest = k->options.knot.coarsest = paper_segments[i];
            k->options.knot.size = PAPER_SIZE;
            baseline_of(&k->options.thread.baseline)->thread_damping = PAPER_DAMPING;
            k->h = paper_steps[h];
            k->max_steps = (uint32_t)(PAPER_SECONDS / k->h + 0.5);
            snprintf(k->name, sizeof k->name, "contact/resolution/paper-%.3gms/%g", 1e3 * k->h,
                     1e6 * paper_segments[i]);
            pulled_knot_add(b, k);
        }
    }
}

void add_resolution_cases(bench *b)
{
    for (size_t h = 0; h < STEPS; h++) {
        for (size_t i = 0; i < SEGMENTS; i++) {
            pulled_knot *k = &knots[h][i];
            set(k, segments[i], steps[h]);
            k->more = add_error;
            snprintf(k->name, sizeof k->name, "contact/resolution/ours-%gms/%g", 1e3 * steps[h],
                     1e6 * segments[i]);
            pulled_knot_add(b, k);
        }
    }
    add_paper_cases(b);
}
