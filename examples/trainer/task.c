#include "trainer/task.h"

#include <math.h>
#include <string.h>

#include "decimal_point.h"

#define STEP STEP_CLOCK_PERIOD
#define LAST_SECONDS 0.05 /* after an emergency stop, so that all of it is told */

/* ---- in */

static vbss_result read_hand(task *t, int side)
{
    hand_figures *f = &t->now.hands[side];
    grip *g = &t->hands[side].grip;
    vbss_grasper *tool = t->stage.tools[side];
    bool known;
    TRY(grip_read(g, t->hardware.devices[side], t->clock, STEP, &known));
    f->in = g->in;
    f->joined = g->joined;
    f->jaw = g->jaw;
    task_report(t, side, &f->in);
    if (!known) {
        return VBSS_OK;
    }
    TRY(vbss_grasper_set_target(tool, g->reported, g->in.orientation));
    if (g->exchanges) {
        TRY(vbss_grasper_exchange(tool, g->wants));
    }
    return vbss_grasper_set_opening(tool, g->jaw);
}

/* ---- out */

static void count_pulses(task_hand *h, hand_figures *f)
{
    const grip *g = &h->grip;
    f->asked += h->wanted == 0 && g->wanted != 0;
    f->given += h->on == 0 && g->on != 0;
    h->wanted = g->wanted;
    h->on = f->solenoid = g->on;
}

static vbss_result write_hand(task *t, int side)
{
    hand_figures *f = &t->now.hands[side];
    task_hand *h = &t->hands[side];
    vbss_grasper_state tool;
    TRY(vbss_grasper_get_state(t->stage.tools[side], &tool, sizeof tool));
    double late = grip_late(t->stage.scene, STEP);
    TRY(grip_write(&h->grip, t->hardware.devices[side], t->clock, &tool, late));
    count_pulses(h, f);
    f->force = h->grip.force;
    f->max_force = larger(f->max_force, f->force);
    return VBSS_OK;
}

/* ---- a slot */

static vbss_result work(task *t)
{
    TRY(read_hand(t, LEFT));
    TRY(read_hand(t, RIGHT));
    TRY(stage_step(&t->stage, STEP));
    TRY(write_hand(t, LEFT));
    return write_hand(t, RIGHT);
}

static void note_failure(task *t, vbss_result result)
{
    const char *text = "", *of_scene = "";
    (void)vbss_context_get_last_error(t->hardware.context, NULL, &text);
    (void)vbss_context_get_last_error(t->stage.context, NULL, &of_scene);
    t->failed = true;
    figures_note(&t->now, true, "the task ends: %s: %s%s", vbss_result_name(result), text,
                 of_scene);
}

static bool is_over(task *t)
{
    bool stopped = t->now.hands[LEFT].in.stopped != 0 || t->now.hands[RIGHT].in.stopped != 0;
    if (stopped && t->stopped_since < 0.0) {
        t->stopped_since = t->now.time;
    }
    vbss_session_exercise_state e;
    return t->failed || atomic_load(&t->end) || stage_has_outcome(&t->stage, &e) ||
           (stopped && t->now.time - t->stopped_since >= LAST_SECONDS) ||
           (t->duration >= 0.0 && t->now.time >= t->duration - 0.5 * STEP);
}

static void run_slot(task *t)
{
    double late = step_clock_wait(&t->step_clock), wall;
    t->now.time = (double)(t->now.slots + 1) * STEP;
    t->clock = t->step_clock.simulated ? t->now.time : step_clock_slot_time(&t->step_clock);
    vbss_result result = task_rehearse(t);
    t->clock += task_clock_step(t);
    step_clock_work_begins(&t->step_clock);
    result = result == VBSS_OK ? work(t) : result;
    double cpu = step_clock_work_ends(&t->step_clock, &wall);
    figures_slot(&t->now, STEP, cpu, late, t->step_clock.simulated ? 0.0 : wall);
    if (t->times != NULL && t->now.slots <= t->time_count) {
        t->times[t->now.slots - 1] = cpu;
    }
    if (result != VBSS_OK) {
        note_failure(t, result);
    }
    task_judge(t);
    t->now.wall = step_clock_elapsed(&t->step_clock);
    (void)strncpy(t->now.phase, stage_phase(&t->stage), sizeof t->now.phase - 1);
    exchange_put(&t->shown, &t->now);
}

/* The handle takes over the jaws when it has passed where they are. */
static void hold_jaws(const task *t, int side)
{
    vbss_grasper_state tool;
    if (vbss_grasper_get_state(t->stage.tools[side], &tool, sizeof tool) == VBSS_OK) {
        (void)vbss_device_hold_jaw(t->hardware.devices[side], tool.opening);
    }
}

void task_init(task *t)
{
    exchange_init(&t->shown);
    atomic_init(&t->end, false);
    atomic_init(&t->ended, false);
    t->stopped_since = -1.0;
    for (int side = 0; side < HANDS; side++) {
        double at[3];
        v_store(at, t->stage.start[side]);
        grip_begin(&t->hands[side].grip, at);
        hold_jaws(t, side);
    }
}

static void end_hand(task *t, int side)
{
    vbss_device_statistics s;
    hand_figures *f = &t->now.hands[side];
    vbss_device *device = t->hardware.devices[side];
    if (vbss_device_get_statistics(device, &s, sizeof s) == VBSS_OK) {
        f->old = s.pose_stale;
        f->refused = s.out_of_order[0] + s.not_finite[0] + s.out_of_range[0] + s.not_unit[0];
    }
    (void)vbss_device_latch_emergency_stop(device);
}

void *task_run(void *user)
{
    task *t = user;
    use_decimal_point();
    step_clock_begin(&t->step_clock, t->options->simulated);
    while (!is_over(t)) {
        run_slot(t);
    }
    end_hand(t, LEFT);
    end_hand(t, RIGHT);
    atomic_store(&t->ended, true);
    return NULL;
}
