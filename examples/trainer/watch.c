/* Faults: those that are caused in a rehearsal, what becomes of the outputs then, and what is told of any. */
#include "trainer/task.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SAFE_WITHIN 0.0105 /* s */
#define LOOKED_AT 0.02     /* s, after a fault began */
#define AGAIN 1.0          /* s, until the same is told again */
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

void task_judge(task *t)
{
    int side = struck_side(t);
    for (uint32_t i = 0; i < t->options->fault_count; i++) {
        const fault_plan *plan = &t->options->faults[i];
        fault_finding *f = &t->now.findings[i];
        double since = t->now.time - plan->from;
        if (f->begun && since < fmin(LOOKED_AT, plan->until - plan->from) &&
            acts(t, rehearsal_fault(plan->name), side)) {
            f->safe_after = since + PACE_PERIOD;
            f->unsafe = f->unsafe || since > SAFE_WITHIN;
        }
    }
}

/* ---- the stand-ins' hands */

/* Where an arm must be so that the device says a place of the world. */
static void to_device(const vbss_device_calibration *c, vec at, double out[3])
{
    double world[3];
    v_store(world, at);
    for (int i = 0; i < 3; i++) {
        int axis = (c->axes[i] < 0 ? -c->axes[i] : c->axes[i]) - 1;
        double x = (world[i] - c->offset[i]) / c->scale;
        out[axis] = c->axes[i] < 0 ? -x : x;
    }
}

static void move_hand(task *t, int side)
{
    const vbss_device_calibration *c = &t->calibration->hands[side];
    motion w = t->stage.row->script(&t->stage, side, t->now.time);
    double at[3];
    to_device(c, w.at, at);
    if (t->hardware.arm[side] && t->now.slots == 0) {
        rehearsal_place(&t->rehearsal, side, at);
    } else if (t->hardware.arm[side]) {
        rehearsal_move(&t->rehearsal, side, at);
    }
    if (t->hardware.handle[side]) {
        rehearsal_squeeze(&t->rehearsal, side,
                          c->jaw_closed + w.opening * (c->jaw_open - c->jaw_closed));
    }
}

vbss_result task_rehearse(task *t)
{
    if (t->rehearsal.hd != NULL || t->rehearsal.daq != NULL) {
        move_hand(t, LEFT);
        move_hand(t, RIGHT);
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
        TRY(vbss_nidaqmx_pump(t->hardware.nidaqmx, t->now.time));
    }
    rehearsal_tick(&t->rehearsal);
    return VBSS_OK;
}

/* ---- events */

static const struct {
    uint32_t bit;
    bool fault;
    const char *text;
} wordings[] = {{VBSS_DEVICE_EVENT_LOST, true, "the hardware is gone"},
                {VBSS_DEVICE_EVENT_FOUND, false, "the hardware is back"},
                {VBSS_DEVICE_EVENT_STALE, true, "the pose is old: forces ramp down"},
                {VBSS_DEVICE_EVENT_JAW_STALE, true, "the handle's opening is old"},
                {VBSS_DEVICE_EVENT_REFUSED, true, "a sample was refused"},
                {VBSS_DEVICE_EVENT_FAILED, true, "a read failed"},
                {VBSS_DEVICE_EVENT_FAULT, true, "it refuses forces: all off"},
                {VBSS_DEVICE_EVENT_STOPPED, true, "emergency stop: all outputs are off"}};

void task_tell(task *t, int side, const vbss_device_input *in)
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
            figures_note(&t->now, wordings[i].fault, "%s: %s%s%s%s", side_names[side],
                         wordings[i].text, why[0] != '\0' ? " (" : "", why,
                         why[0] != '\0' ? ")" : "");
        }
        h->noted[i] = t->now.time;
    }
}
