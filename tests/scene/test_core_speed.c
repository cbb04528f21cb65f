/* The measured speed of the core, and the budgets for which it counts. Clocks here are made up, so nothing depends on the
 * machine but the last test, which reads a real clock. */
#include <string.h>
#include <time.h>

#include <vblast_ss/core_speed.h>

#include "fixtures/solver_of.h"
#include "scene/pulled_surgeons.h"
#include "scene/small.h"

#define STEP 0x1p-11 /* s that a step takes on the usual clock; exact, and so are sums of it */
enum { TIMED_STEPS = 48 };

/* A clock that moves by a fixed time for each reading, with faults. */
typedef struct made_clock {
    double step, now;
    uint32_t readings;
    uint32_t
        late_every; /* each such reading is late, by late_by and a little more each time; 0: none */
    double late_by;
    uint32_t fault_at; /* at this reading the clock moves by fault; 0: never */
    double fault;
    double tick; /* readings are rounded down to multiples; 0: exact */
} made_clock;

static double read_made(void *user)
{
    made_clock *c = user;
    c->readings++;
    c->now += c->step;
    if (c->late_every > 0 && c->readings % c->late_every == 0) {
        c->now += c->late_by + 1e-6 * c->readings;
    }
    if (c->readings == c->fault_at) {
        c->now += c->fault;
    }
    return c->tick > 0.0 ? c->tick * floor(c->now / c->tick) : c->now;
}

static vbss_core_speed measure(vbss_context *context, made_clock clock)
{
    vbss_core_speed speed;
    expect_ok(vbss_core_speed_measure(context, read_made, &clock, &speed, sizeof speed));
    assert_int_equal(speed.steps, TIMED_STEPS);
    assert_int_equal(clock.readings, TIMED_STEPS + 1);
    return speed;
}

/* ---- the measurement */

static void slow_clock_is_a_slow_core(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const vbss_core_speed usual = measure(context, (made_clock){.step = STEP});
    const vbss_core_speed slow = measure(context, (made_clock){.step = 4.0 * STEP});
    assert_true(usual.operations_per_us > 0.0);
    expect_same_bits(usual.operations_per_us, 4.0 * slow.operations_per_us);
    expect_same_bits(TIMED_STEPS * STEP, usual.duration);
    expect_same_bits(1.0, usual.spread);
    harness_context_end(context, &memory);
}

/* Every third step is interrupted for 80 ms. */
static void interruptions_do_not_count(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const vbss_core_speed usual = measure(context, (made_clock){.step = STEP});
    const vbss_core_speed busy =
        measure(context, (made_clock){.step = STEP, .late_every = 3, .late_by = 0.08});
    assert_true(busy.duration > 1.0);
    expect_near(usual.operations_per_us, busy.operations_per_us, 1e-9 * usual.operations_per_us);
    harness_context_end(context, &memory);
}

static void expect_refused(vbss_context *context, vbss_result wanted, made_clock clock)
{
    vbss_core_speed speed, before;
    memset(&speed, 0x5a, sizeof speed);
    before = speed;
    expect_result(wanted,
                  vbss_core_speed_measure(context, read_made, &clock, &speed, sizeof speed));
    assert_memory_equal(&speed, &before, sizeof speed);
}

static void faulty_clocks_are_refused(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const uint32_t at[] = {2, 20, TIMED_STEPS + 1};
    expect_refused(context, VBSS_ERROR_CLOCK_STOPPED, (made_clock){.now = 12345.0});
    for (int i = 0; i < 3; i++) {
        const made_clock jumps[] = {{.step = STEP, .fault_at = at[i], .fault = -2.0 * STEP},
                                    {.step = STEP, .fault_at = at[i], .fault = 2.0}};
        const made_clock infinite = {.step = STEP, .fault_at = at[i], .fault = (double)INFINITY};
        expect_refused(context, VBSS_ERROR_CLOCK_JUMPED, jumps[0]);
        expect_refused(context, VBSS_ERROR_CLOCK_JUMPED, jumps[1]);
        expect_refused(context, VBSS_ERROR_NOT_FINITE, infinite);
    }
    expect_refused(context, VBSS_ERROR_NOT_FINITE, (made_clock){.step = (double)NAN});
    /* Of these ticks none is in some steps, one or two, and three or four. */
    const double ticks[] = {10.0 * STEP, 0.7 * STEP, 0.3 * STEP};
    for (int i = 0; i < 3; i++) {
        expect_refused(context, VBSS_ERROR_CLOCK_COARSE,
                       (made_clock){.step = STEP, .tick = ticks[i]});
    }
    (void)measure(context, (made_clock){.step = STEP, .tick = 0.03 * STEP});
    harness_context_end(context, &memory);
}

typedef struct meddling_clock {
    vbss_context *context;
    vbss_result edit, measure;
    double now;
} meddling_clock;

static double read_meddling(void *user)
{
    meddling_clock *c = user;
    vbss_scene *scene;
    vbss_core_speed speed;
    made_clock inner = {.step = STEP};
    c->edit = vbss_scene_create(c->context, NULL, &scene);
    c->measure = vbss_core_speed_measure(c->context, read_made, &inner, &speed, sizeof speed);
    return c->now += STEP;
}

static void bad_calls_are_refused(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_core_speed speed;
    made_clock clock = {.step = STEP};
    meddling_clock meddling = {.context = context};
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_core_speed_measure(NULL, read_made, &clock, &speed, sizeof speed));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_core_speed_measure(context, NULL, NULL, &speed, sizeof speed));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_core_speed_measure(context, read_made, &clock, NULL, sizeof speed));
    expect_result(VBSS_ERROR_STRUCT_SIZE,
                  vbss_core_speed_measure(context, read_made, &clock, &speed, 12));
    expect_ok(vbss_core_speed_measure(context, read_meddling, &meddling, &speed, sizeof speed));
    assert_int_equal(meddling.edit, VBSS_ERROR_BUSY);
    assert_int_equal(meddling.measure, VBSS_ERROR_BUSY);
    for (uint64_t k = 1; k <= 64; k *= 2) {
        clock = (made_clock){.step = STEP};
        memory.fail_call = memory.calls + k;
        expect_result(VBSS_ERROR_OUT_OF_MEMORY,
                      vbss_core_speed_measure(context, read_made, &clock, &speed, sizeof speed));
    }
    memory.fail_call = 0;
    vbss_context_statistics after;
    expect_ok(vbss_context_get_statistics(context, &after, sizeof after));
    assert_int_equal(after.objects_alive, 0);
    harness_context_end(context, &memory);
}

static uint64_t run_scene(bool measures)
{
    small s;
    small_begin(&s);
    if (measures) {
        (void)measure(s.context, (made_clock){.step = STEP});
    }
    s.config.floor = 1;
    s.config.floor_height = -3e-3;
    small_create(&s);
    s.thread.gravity[1] = -9.81;
    vbss_thread *thread;
    (void)small_thread(&s, vec3_zero(), vec3_make(0.05, 0.0, 0.0), 50, &thread);
    (void)small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.02, -2e-3, 0.0),
                      vec3_make(0.0, 0.0, 5e-3), 5e-4);
    for (int i = 0; i < 4; i++) {
        small_steps(&s, 10, 1e-3);
        if (measures) {
            (void)measure(s.context, (made_clock){.step = STEP});
        }
    }
    const uint64_t hash = small_hash(&s);
    assert_true(small_statistics(&s).contacts > 0);
    small_end(&s);
    return hash;
}

static void measurement_changes_no_scene(void **state)
{
    (void)state;
    assert_true(run_scene(false) == run_scene(true));
}

/* ---- a machine of a quarter of the speed */

typedef struct simulated_run {
    double longest;       /* call, s */
    uint32_t late, calls; /* calls that are longer than the slot on the simulated core; all */
    double lost;          /* share of the time that was left out */
} simulated_run;

enum { PULLED_CALLS = 1000 };

/* Operations of all work, also of the step that waits. */
static uint64_t work_of(const scene_object *s)
{
    return s->report.statistics.operations + (s->cursor.is_suspended ? s->cursor.operations : 0);
}

static simulated_run pull_knot(double operations_per_us, bool is_fitted)
{
    contact_scene_options o;
    contact_scene scene;
    vbss_context *context;
    simulated_run run = {0};
    pulled_surgeons_init(&o);
    expect_ok(vbss_context_create(NULL, &context));
    if (is_fitted) { /* a call has half its slot */
        vbss_solver_options *solver = solver_of(&o.scene);
        solver->call_budget_us = 500.0;
        solver->step_budget_us = 500.0 * 25.0 / 21.0;
        solver->operations_per_us = operations_per_us;
    }
    expect_ok(contact_scene_create(context, &o, &scene));
    expect_ok(contact_scene_step(&scene, 1e-3)); /* the first step is not limited */
    const scene_object *s = ((vbss_slot *)scene.scene)->object;
    for (; run.calls < PULLED_CALLS; run.calls++) {
        const uint64_t before = work_of(s);
        expect_ok(contact_scene_step(&scene, 1e-3));
        const double operations = (double)(work_of(s) - before);
        const double time = 1e-6 * operations / operations_per_us;
        run.longest = time > run.longest ? time : run.longest;
        run.late += time > 1e-3;
    }
    vbss_scene_statistics c;
    expect_ok(vbss_scene_get_statistics(scene.scene, &c, sizeof c));
    run.lost = c.time_paused / c.time;
    expect_ok(contact_scene_destroy(&scene));
    expect_ok(vbss_context_destroy(context));
    return run;
}

/* A core for which the default limits are right, and one of a quarter of its speed, as the clock of the measurement shows it.
 * A knot that is pulled tight takes as much work as there is. */
static void measured_speed_fits_a_slow_machine(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const double right = 420.0; /* operations per us: half a slot is a call of 210000 */
    const vbss_core_speed probe = measure(context, (made_clock){.step = STEP});
    const double step = 4.0 * STEP * probe.operations_per_us / right;
    const vbss_core_speed slow = measure(context, (made_clock){.step = step});
    harness_context_end(context, &memory);
    expect_near(0.25 * right, slow.operations_per_us, 1e-9 * right);
    const simulated_run fast = pull_knot(right, true);
    const simulated_run unfitted = pull_knot(slow.operations_per_us, false);
    const simulated_run fitted = pull_knot(slow.operations_per_us, true);
    assert_int_equal(fast.late, 0);
    assert_true(unfitted.late > PULLED_CALLS / 4);
    /* Attempts that the guard refuses are repeated without a limit: few, and none late by more than a tenth. */
    assert_in_range(fitted.late, 0, PULLED_CALLS / 100);
    assert_true(fitted.longest < 1.15e-3 && unfitted.longest > 1.9e-3);
    assert_true(fitted.lost > fast.lost); /* which the statistics report */
}

static double read_processor_time(void *user)
{
    (void)user;
    return (double)clock() / CLOCKS_PER_SEC;
}

/* The clock of the C library is real, and fine enough on every system but Windows, where a tick is 1 ms. */
static void real_clock_gives_a_speed(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_core_speed speed;
    const vbss_result result =
        vbss_core_speed_measure(context, read_processor_time, NULL, &speed, sizeof speed);
    if (result == VBSS_OK) {
        assert_true(speed.operations_per_us > 0.0 && speed.spread >= 1.0);
    } else {
        assert_int_equal(result, VBSS_ERROR_CLOCK_COARSE);
    }
    harness_context_end(context, &memory);
}

int test_core_speed(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slow_clock_is_a_slow_core),
        cmocka_unit_test(interruptions_do_not_count),
        cmocka_unit_test(faulty_clocks_are_refused),
        cmocka_unit_test(bad_calls_are_refused),
        cmocka_unit_test(measurement_changes_no_scene),
        cmocka_unit_test(measured_speed_fits_a_slow_machine),
        cmocka_unit_test(real_clock_gives_a_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
