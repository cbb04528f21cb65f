#include "trainer/task.h"

#include <math.h>
#include <string.h>

#define STEP PACE_PERIOD
#define JOIN_SPEED 0.15   /* m/s, of a tool that comes to its hand */
#define JOINED 0.5e-3     /* m */
#define STIFFNESS 400.0   /* of the coupling to the hand, N/m */
#define DAMPING 1.0       /* N s/m */
#define BUTTON_SPEED 4.0  /* of the opening, 1/s */
#define LAST_SECONDS 0.05 /* after an emergency stop, so that all of it is told */

enum { CLOSES = 1, CLUTCHES = 2 }; /* buttons of an arm */

/* ---- in */

/* The tool comes to the hand; from then on it is where the hand is. */
static void lead(task_hand *h, hand_figures *f, const double to[3])
{
    double way[3], length = 0.0;
    for (int i = 0; i < 3; i++) {
        way[i] = to[i] - h->told[i];
        length += way[i] * way[i];
    }
    length = sqrt(length);
    f->joined = f->joined || length < JOINED;
    double share = f->joined || length <= JOIN_SPEED * STEP ? 1.0 : JOIN_SPEED * STEP / length;
    for (int i = 0; i < 3; i++) {
        h->told[i] += share * way[i];
    }
}

static double find_opening(task_hand *h, const vbss_device_input *in)
{
    if ((in->valid & VBSS_DEVICE_HAS_JAW) != 0) {
        return in->jaw;
    }
    double wanted = (in->buttons & h->let_go & CLOSES) != 0 ? 0.0 : 1.0, most = BUTTON_SPEED * STEP;
    h->opening += fmin(fmax(wanted - h->opening, -most), most);
    return h->opening;
}

static vbss_result read_hand(task *t, int side)
{
    hand_figures *f = &t->now.hands[side];
    task_hand *h = &t->hands[side];
    vbss_device *device = t->hardware.devices[side];
    vbss_grasper *tool = t->stage.tools[side];
    TRY(vbss_device_read(device, t->clock, &f->in, sizeof f->in));
    task_tell(t, side, &f->in);
    if (f->in.status == VBSS_DEVICE_WAITING) {
        return VBSS_OK;
    }
    h->let_go |= ~f->in.buttons;
    TRY(vbss_device_clutch(device, (f->in.buttons & h->let_go & CLUTCHES) != 0));
    lead(h, f, f->in.position);
    f->jaw = find_opening(h, &f->in);
    TRY(vbss_grasper_move(tool, h->told, f->in.orientation));
    return vbss_grasper_set_opening(tool, f->jaw);
}

/* ---- out */

static void count_pulses(task_hand *h, hand_figures *f, uint32_t wanted, uint32_t on)
{
    f->asked += h->wanted == 0 && wanted != 0;
    f->given += h->on == 0 && on != 0;
    h->wanted = wanted;
    h->on = f->solenoid = on;
}

static vbss_result write_hand(task *t, int side)
{
    hand_figures *f = &t->now.hands[side];
    vbss_output_command command;
    vbss_device_coupling coupling;
    vbss_output_result out;
    vbss_grasper_state tool;
    TRY(vbss_output_command_init(&command, sizeof command));
    TRY(vbss_device_coupling_init(&coupling, sizeof coupling));
    TRY(vbss_grasper_get_state(t->stage.tools[side], &tool, sizeof tool));
    if (f->joined) {
        command.solenoid = tool.solenoid;
        memcpy(coupling.position, tool.position, sizeof coupling.position);
        memcpy(coupling.velocity, tool.velocity, sizeof coupling.velocity);
        coupling.stiffness = STIFFNESS;
        coupling.damping = DAMPING;
        TRY(vbss_device_write_coupled(t->hardware.devices[side], t->clock, &command, &coupling,
                                      &out, sizeof out));
    } else {
        TRY(vbss_device_write(t->hardware.devices[side], t->clock, &command, &out, sizeof out));
    }
    count_pulses(&t->hands[side], f, command.solenoid, out.solenoid);
    f->force = sqrt(out.force[0] * out.force[0] + out.force[1] * out.force[1] +
                    out.force[2] * out.force[2]);
    f->most_force = fmax(f->most_force, f->force);
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
    return t->failed || atomic_load(&t->end) ||
           (stopped && t->now.time - t->stopped_since >= LAST_SECONDS) ||
           (t->duration >= 0.0 && t->now.time >= t->duration - 0.5 * STEP);
}

static void run_slot(task *t)
{
    double late = pace_wait(&t->pace), wall;
    t->now.time = (double)(t->now.slots + 1) * STEP;
    t->clock = t->pace.simulated ? t->now.time : pace_slot_time(&t->pace);
    vbss_result result = task_rehearse(t);
    pace_work_begins(&t->pace);
    result = result == VBSS_OK ? work(t) : result;
    double cpu = pace_work_ends(&t->pace, &wall);
    figures_slot(&t->now, STEP, cpu, late, t->pace.simulated ? 0.0 : wall);
    if (result != VBSS_OK) {
        note_failure(t, result);
    }
    task_judge(t);
    t->now.wall = pace_elapsed(&t->pace);
    (void)strncpy(t->now.phase, stage_phase(&t->stage), sizeof t->now.phase - 1);
    exchange_put(&t->shown, &t->now);
}

void task_init(task *t)
{
    exchange_init(&t->shown);
    atomic_init(&t->end, false);
    atomic_init(&t->ended, false);
    t->stopped_since = -1.0;
    for (int side = 0; side < HANDS; side++) {
        v_store(t->hands[side].told, t->stage.start[side]);
        t->hands[side].opening = 1.0;
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
    (void)vbss_device_stop(device);
}

void *task_run(void *user)
{
    task *t = user;
    pace_begin(&t->pace, t->options->simulated);
    while (!is_over(t)) {
        run_slot(t);
    }
    end_hand(t, LEFT);
    end_hand(t, RIGHT);
    atomic_store(&t->ended, true);
    return NULL;
}
