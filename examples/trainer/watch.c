/* Faults: those that are caused in a rehearsal, what becomes of the outputs then, and what is told of any. */
#include "trainer/task.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SAFE_WITHIN 0.0105 /* s */
#define OBSERVED 0.02      /* s, after a fault began */
#define AGAIN 1.0          /* s, until the same is told again */
#define PRESSED 0.05       /* s, that a button is held */
#define NOTHING 1e-9       /* N: what rounding of times leaves */

static const char *const side_names[HANDS] = {"left", "right"};

/* ---- faults that are caused */

static int struck_side(const task *t)
{
    return t->options->arm_count == 1 ? LEFT : RIGHT;
}

static void cause_faults(task *t)
{
    for (uint32_t i = 0; i < t->options->fault_count; i++) {
        const fault_plan *plan = &t->options->faults[i];
        const fault_row *row = rehearsal_fault(plan->name);
        fault_finding *f = &t->now.findings[i];
        int side = struck_side(t);
        const hand_figures *felt = &t->now.hands[side];
        if (!f->begun && t->now.time >= plan->from) {
            f->begun = true;
            f->acted = (row->hand_feels && felt->force > NOTHING) || felt->solenoid != 0;
            rehearsal_cause(&t->rehearsal, row, side, true);
        } else if (f->begun && t->now.time >= plan->until) {
            rehearsal_cause(&t->rehearsal, row, side, false);
        }
    }
}

/* Whether something is put out that a fault forbids. */
static bool acts(const task *t, const fault_row *row, int side)
{
    const hand_figures *felt = &t->now.hands[side];
    bool real = t->hardware.arm[side] && t->rehearsal.hd != NULL && !row->frozen;
    double force = real ? rehearsal_force(&t->rehearsal, side) : felt->force;
    bool solenoid = t->rehearsal.daq != NULL && t->hardware.handle[side]
                        ? rehearsal_solenoid(&t->rehearsal, side)
                        : felt->solenoid != 0;
    return (row->hand_feels && force > NOTHING) || solenoid;
}

double task_clock_step(const task *t)
{
    double step = 0.0;
    for (uint32_t i = 0; i < t->options->fault_count; i++) {
        const fault_plan *plan = &t->options->faults[i];
        const bool is_on = t->now.findings[i].begun && t->now.time < plan->until;
        step += is_on ? rehearsal_fault(plan->name)->clock : 0.0;
    }
    return step;
}

void task_judge(task *t)
{
    int side = struck_side(t);
    for (uint32_t i = 0; i < t->options->fault_count; i++) {
        const fault_plan *plan = &t->options->faults[i];
        fault_finding *f = &t->now.findings[i];
        const fault_row *row = rehearsal_fault(plan->name);
        double since = t->now.time - plan->from;
        /* a jump of the clock is over when the outputs have been off */
        const bool is_over = row->clock > 0.0 && since - f->safe_after > 0.5 * STEP_CLOCK_PERIOD;
        if (f->begun && !is_over && since < smaller(OBSERVED, plan->until - plan->from) &&
            acts(t, row, side)) {
            f->safe_after = since + STEP_CLOCK_PERIOD;
            f->unsafe = f->unsafe || since > SAFE_WITHIN;
        }
    }
}

/* ---- the stand-ins' hands */

/* Along the axes of the arm what is told along those of the world. */
static void to_axes(const vbss_device_calibration *c, const double world[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        int axis = (c->axes[i] < 0 ? -c->axes[i] : c->axes[i]) - 1;
        out[axis] = c->axes[i] < 0 ? -world[i] : world[i];
    }
}

/* Whether the axes are those of a mirror, in which turns change sign. */
static bool mirrors(const vbss_device_calibration *c)
{
    const double x[3] = {1.0, 0.0, 0.0}, y[3] = {0.0, 1.0, 0.0}, z[3] = {0.0, 0.0, 1.0};
    double u[3], v[3], w[3];
    to_axes(c, x, u);
    to_axes(c, y, v);
    to_axes(c, z, w);
    return v_dot(v_cross(v_load(u), v_load(v)), v_load(w)) < 0.0;
}

/* Where an arm must be, and how turned, so that the device says what is wanted of its tool. */
static void to_device(const vbss_device_calibration *c, const reported *w, double at[3],
                      double turn[4])
{
    const double unmount[4] = {c->mount[0], -c->mount[1], -c->mount[2], -c->mount[3]};
    double away[3], turned[4];
    for (int i = 0; i < 3; i++) {
        away[i] = (w->position[i] - c->offset[i]) / c->scale;
    }
    to_axes(c, away, at);
    pose_turn(w->orientation, unmount, turned);
    turn[0] = mirrors(c) ? -turned[0] : turned[0];
    to_axes(c, turned + 1, turn + 1);
}

static void lead_arm(task *t, int side, const reported *w)
{
    task_hand *h = &t->hands[side];
    double at[3], turn[4];
    to_device(&t->calibration->hands[side], w, at, turn);
    rehearsal_move(&t->rehearsal, side, at, turn, t->hardware.followers[side].score != NULL);
    if (h->kind == 0) { /* it is led for the first time */
        rehearsal_place(&t->rehearsal, side, at, turn);
        h->kind = w->kind;
        h->pressed = -1.0;
    }
    if (w->kind != h->kind) {
        h->kind = w->kind;
        h->pressed = t->now.time;
    }
    rehearsal_press(&t->rehearsal, side, h->pressed >= 0.0 && t->now.time < h->pressed + PRESSED);
}

static void lead_hand(task *t, int side)
{
    const vbss_device_calibration *c = &t->calibration->hands[side];
    const reported w = follower_want(&t->hardware.followers[side], t->now.time);
    if (!w.known) {
        return;
    }
    if (t->hardware.arm[side]) {
        lead_arm(t, side, &w);
    }
    if (t->hardware.handle[side]) {
        rehearsal_squeeze(&t->rehearsal, side,
                          c->jaw_closed + w.opening * (c->jaw_open - c->jaw_closed));
    }
}

vbss_result task_rehearse(task *t)
{
    if (t->rehearsal.hd != NULL || t->rehearsal.daq != NULL) {
        lead_hand(t, LEFT);
        lead_hand(t, RIGHT);
        cause_faults(t);
        rehearsal_watch(&t->rehearsal, t->options->handle_count);
        memcpy(t->now.pulses, t->rehearsal.pulses, sizeof t->now.pulses);
    } else {
        cause_faults(t);
    }
    if (!t->options->simulated) {
        return VBSS_OK;
    }
    if (t->hardware.nidaqmx != NULL && t->now.slots % 2 == 0) { /* as its thread does */
        TRY(vbss_nidaqmx_poll(t->hardware.nidaqmx, t->now.time));
    }
    rehearsal_tick(&t->rehearsal);
    return VBSS_OK;
}

/* ---- events */

static const struct {
    uint32_t bit;
    bool fault, says_why;
    const char *text;
} wordings[] = {
    {VBSS_DEVICE_EVENT_LOST, true, true, "the hardware is gone"},
    {VBSS_DEVICE_EVENT_FOUND, false, false, "the hardware is back"},
    {VBSS_DEVICE_EVENT_STALE, true, true, "the pose is old: forces ramp down"},
    {VBSS_DEVICE_EVENT_JAW_STALE, true, true, "the handle's opening is old"},
    {VBSS_DEVICE_EVENT_REFUSED, true, true, "a sample was refused"},
    {VBSS_DEVICE_EVENT_FAILED, true, true, "a read failed"},
    {VBSS_DEVICE_EVENT_FAULT, true, true, "it refuses forces: all off"},
    {VBSS_DEVICE_EVENT_STOPPED, true, true, "emergency stop: all outputs are off"},
    {VBSS_DEVICE_EVENT_SLOW, false, true, "the handles are slow"},
    {VBSS_DEVICE_EVENT_JAW_HELD, false, false, "the jaws stay until the handle has passed them"},
    {VBSS_DEVICE_EVENT_JAW_TAKEN, false, false, "the handle has taken over the jaws"}};

void task_report(task *t, int side, const vbss_device_input *in)
{
    char why[EVENT_BYTES];
    task_hand *h = &t->hands[side];
    if (in->events == 0) {
        return;
    }
    hardware_explain(&t->hardware, side, why, sizeof why);
    for (size_t i = 0; i < sizeof wordings / sizeof *wordings; i++) {
        bool known = h->noted[i] > 0.0 && t->now.time - h->noted[i] < AGAIN;
        if ((in->events & wordings[i].bit) == 0) {
            continue;
        }
        if (!known) {
            const bool says_why = wordings[i].says_why && why[0] != '\0';
            figures_note(&t->now, wordings[i].fault, "%s: %s%s%s%s", side_names[side],
                         wordings[i].text, says_why ? " (" : "", says_why ? why : "",
                         says_why ? ")" : "");
        }
        h->noted[i] = t->now.time;
    }
}
