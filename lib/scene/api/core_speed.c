/* Measures how many operations per microsecond the core does, by a clock of the host.
 *
 *   create the reference scene -> time its steps -> check the clock -> quartiles of the times
 *
 * Quartiles, and no mean, because other programs interrupt some of the steps. The steps of a period
 * take different times, so each has a quartile of its own. */
#include <vblast_ss/core_speed.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/api/api.h"

#include <string.h>

_Static_assert(sizeof(vbss_core_speed) == 32, "published size");

static const uint32_t speed_sizes[] = {32, 0};
static const vbss_layout speed_layout = {"vbss_core_speed", NULL, speed_sizes};

/* Timed periods. Chosen: four times as many as must be undisturbed. */
enum { PERIODS = 12, STEPS = PERIODS * SCENE_REFERENCE_PERIOD };
/* A step takes less, s. Chosen: some 2000 times as long as a step takes. */
#define MAX_STEP_TIME 1.0
/* Times that differ by less are equal, s. Chosen: no clock resolves less. */
#define MIN_DIFFERENCE 1e-9
/* The clock resolves this share of the shortest step. Chosen. */
#define MAX_RESOLUTION 0.1

typedef struct host_clock {
    vbss_context *context;
    vbss_core_speed_clock_fn read_clock;
    void *user;
    double last; /* the last reading, s */
} host_clock;

typedef struct step_times {
    double time[SCENE_REFERENCE_PERIOD][PERIODS]; /* of each step of the period, s */
    uint64_t operations;                          /* of all steps */
} step_times;

/* ---- the clock */

static vbss_result read_host_clock(const host_clock *clock, double *now)
{
    const bool outer = vbss_callback_begin(clock->context);
    *now = clock->read_clock(clock->user);
    vbss_callback_end(clock->context, outer);
    return vbss_check_finite(clock->context, now, 1, "reading of the clock");
}

/* Time since the last reading, s. */
static vbss_result read_elapsed_time(host_clock *clock, double *elapsed)
{
    double now;
    VBSS_TRY(read_host_clock(clock, &now));
    *elapsed = now - clock->last;
    clock->last = now;
    return *elapsed >= 0.0 && *elapsed <= MAX_STEP_TIME
               ? VBSS_OK
               : vbss_fail(clock->context, VBSS_ERROR_CLOCK_JUMPED,
                           "the clock moves by %s s during a step", VBSS_NUMBER(*elapsed));
}

static vbss_result time_steps(scene_reference *reference, host_clock *clock, step_times *t)
{
    const uint64_t before = vbss_scene_count_reference_operations(reference);
    VBSS_TRY(read_host_clock(clock, &clock->last));
    for (uint32_t i = 0; i < STEPS; i++) {
        VBSS_TRY(vbss_scene_step_reference(reference));
        VBSS_TRY(read_elapsed_time(
            clock, &t->time[i % SCENE_REFERENCE_PERIOD][i / SCENE_REFERENCE_PERIOD]));
    }
    t->operations = vbss_scene_count_reference_operations(reference) - before;
    return VBSS_OK;
}

/* ---- results */

static void sort_ascending(double *values, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++) {
        const double value = values[i];
        uint32_t k = i;
        for (; k > 0 && values[k - 1] > value; k--) {
            values[k] = values[k - 1];
        }
        values[k] = value;
    }
}

/* Resolution of the clock, s: the smallest difference of two times. 0 if all times are equal. */
static double find_resolution(const double sorted[STEPS])
{
    double smallest = 0.0;
    for (uint32_t i = 1; i < STEPS; i++) {
        const double difference = sorted[i] - sorted[i - 1];
        if (difference > MIN_DIFFERENCE && (smallest == 0.0 || difference < smallest)) {
            smallest = difference;
        }
    }
    return smallest;
}

static vbss_result check_clock(const host_clock *clock, const step_times *t)
{
    double sorted[STEPS];
    memcpy(sorted, t->time, sizeof sorted);
    sort_ascending(sorted, STEPS);
    if (sorted[STEPS - 1] < MIN_DIFFERENCE) {
        return vbss_fail(clock->context, VBSS_ERROR_CLOCK_STOPPED, "the clock stays at %s s",
                         VBSS_NUMBER(clock->last));
    }
    const double resolution = find_resolution(sorted);
    return sorted[0] > MIN_DIFFERENCE && resolution <= MAX_RESOLUTION * sorted[0]
               ? VBSS_OK
               : vbss_fail(clock->context, VBSS_ERROR_CLOCK_COARSE,
                           "the clock reads %s s for the shortest step and resolves %s s",
                           VBSS_NUMBER(sorted[0]), VBSS_NUMBER(resolution));
}

static void evaluate(step_times *t, vbss_core_speed *speed)
{
    double quartiles = 0.0, medians = 0.0; /* sums over a period, s */
    for (uint32_t i = 0; i < SCENE_REFERENCE_PERIOD; i++) {
        sort_ascending(t->time[i], PERIODS);
        quartiles += t->time[i][PERIODS / 4];
        medians += t->time[i][PERIODS / 2];
        for (uint32_t k = 0; k < PERIODS; k++) {
            speed->duration += t->time[i][k];
        }
    }
    speed->steps = STEPS;
    speed->operations_per_us = 1e-6 * (double)t->operations / (PERIODS * quartiles);
    speed->spread = medians / quartiles;
}

static vbss_result measure(host_clock *clock, vbss_core_speed *speed)
{
    scene_reference reference;
    step_times times;
    vbss_result result = vbss_scene_create_reference(clock->context, &reference);
    if (result == VBSS_OK) {
        result = time_steps(&reference, clock, &times);
    }
    vbss_scene_destroy_reference(&reference);
    VBSS_TRY(result);
    VBSS_TRY(check_clock(clock, &times));
    evaluate(&times, speed);
    return VBSS_OK;
}

vbss_result vbss_core_speed_measure(vbss_context *context, vbss_core_speed_clock_fn clock,
                                    void *user, vbss_core_speed *speed, uint32_t struct_size)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    if (clock == NULL) {
        return vbss_fail(context, VBSS_ERROR_NULL_ARGUMENT, "clock is NULL");
    }
    VBSS_TRY(vbss_check_pointer(context, speed, "speed"));
    vbss_core_speed own = {.struct_size = sizeof own};
    host_clock host = {.context = context, .read_clock = clock, .user = user};
    VBSS_TRY(measure(&host, &own));
    return vbss_struct_write(context, &speed_layout, &own, speed, struct_size);
}
