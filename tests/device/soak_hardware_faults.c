/* Faults of real hardware at random moments, one a life, while a force and a solenoid are on: within 10 ms both are off, the
 * host can tell why, and no call of the whole life is illegal. */
#include <string.h>

#include "device/hardware_rig.h"

enum { LIVES = 20, KINDS = 8 };

typedef enum kind {
    UNPLUGGED,
    COMM_ERROR,
    NAN_POSE,
    WARM,
    STALLED, /* the servo: nobody puts anything out, so the next tick counts */
    SILENT,  /* the host */
    READ_TIMEOUT,
    REMOVED
} kind;

static void cause(hardware_rig *r, kind k, int on)
{
    static const stand_in_hd_fault of_arms[] = {STAND_IN_UNPLUGGED, STAND_IN_COMM_ERROR,
                                                STAND_IN_NAN_POSE, STAND_IN_WARM, STAND_IN_STALLED};
    if (k <= STALLED) {
        r->hd->set_fault(0, of_arms[k], on);
    } else if (k == SILENT) {
        r->silent = on != 0;
    } else {
        r->daq->set_fault(k == REMOVED ? STAND_IN_REMOVED : STAND_IN_READ_TIMEOUT, on);
    }
}

/* Whether somebody who looks knows. */
static bool is_reported(const hardware_rig *r, kind k)
{
    vbss_openhaptics_status arm;
    vbss_nidaqmx_status lines;
    expect_ok(vbss_openhaptics_get_status(r->openhaptics, 0, &arm, sizeof arm));
    expect_ok(vbss_nidaqmx_get_status(r->nidaqmx, &lines, sizeof lines));
    switch (k) {
    case UNPLUGGED:
    case COMM_ERROR:
        return arm.error == 0x0302 && r->inputs[0].stopped != 0;
    case WARM:
        return arm.state == VBSS_HAPTICS_STATE_REFUSING;
    case NAN_POSE:
    case STALLED:
        return r->inputs[0].status == VBSS_DEVICE_STATUS_STALE;
    case SILENT:
        return arm.silent_ticks > 0;
    case READ_TIMEOUT:
        return lines.state == VBSS_HAPTICS_STATE_REFUSING;
    case REMOVED:
        return lines.state == VBSS_HAPTICS_STATE_LOST && r->inputs[0].stopped != 0;
    }
    return false;
}

static void begin(hardware_rig *r, vbss_random *random)
{
    hardware_rig_begin(r, false);
    hardware_rig_open(r, 2);
    for (int i = 0; i < 2; i++) {
        r->couplings[i].stiffness = 50.0 + 350.0 * vbss_random_uniform(random);
        r->couplings[i].damping = vbss_random_uniform(random);
        r->commands[i].solenoid = 1;
        for (int k = 0; k < 3; k++) {
            r->couplings[i].position[k] = 0.004 * (vbss_random_uniform(random) - 0.5);
        }
    }
    hardware_rig_steps(r, 40 + (int)vbss_random_below(random, 100));
}

/* Rounding of times may leave a trace of a force. */
static bool is_safe(const hardware_rig *r, bool with_arm)
{
    return (!with_arm || hardware_rig_force(r, 0) <= 1e-9) && !hardware_rig_solenoid(r, 0);
}

/* In ten steps, ms: from when on it is safe; 11: not yet. */
static int become_safe(hardware_rig *r, bool with_arm)
{
    int unsafe = 0;
    for (int i = 1; i <= 10; i++) {
        hardware_rig_steps(r, 1);
        unsafe = is_safe(r, with_arm) ? unsafe : i;
    }
    return unsafe + 1;
}

static void live(harness_soak *soak, vbss_random *random, uint64_t *counts, int *latest)
{
    hardware_rig r;
    begin(&r, random);
    kind k = (kind)vbss_random_below(random, KINDS);
    bool pressed = hardware_rig_force(&r, 0) > 0.0 && hardware_rig_solenoid(&r, 0);
    cause(&r, k, 1);
    /* the arm of a handle that is slow goes on, and while the servo stands nobody can put a force off */
    const bool with_arm = k != READ_TIMEOUT;
    int safe = become_safe(&r, with_arm && k != STALLED);
    *latest = safe > *latest ? safe : *latest;
    bool reported = is_reported(&r, k);
    if (k == STALLED) {
        r.silent = true; /* what the host wrote last counts */
        cause(&r, k, 0);
        hardware_rig_steps(&r, 1);
    }
    if (!pressed || !is_safe(&r, with_arm) || !reported) {
        harness_soak_fail(soak, "fault %d: pressed %d, force %g, solenoid %d, told %d", (int)k,
                          pressed, hardware_rig_force(&r, 0), hardware_rig_solenoid(&r, 0),
                          reported);
    }
    counts[k]++;
    cause(&r, k, 0);
    r.silent = false;
    hardware_rig_steps(&r, (int)vbss_random_below(random, 200));
    hardware_rig_end(&r);
}

static void run(harness_soak *soak)
{
    static const char *const names[KINDS] = {"unplugged", "comm_error", "nan_pose",     "warm",
                                             "stalled",   "silent",     "read_timeout", "removed"};
    vbss_random random;
    uint64_t counts[KINDS] = {0};
    vbss_random_seed(&random, soak->seed, 41);
    int latest = 0;
    for (int i = 0; i < LIVES; i++) {
        live(soak, &random, counts, &latest);
    }
    harness_soak_figure(soak, "safe_after_ms", latest);
    for (int k = 0; k < KINDS; k++) {
        harness_soak_figure(soak, names[k], (double)counts[k]);
    }
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
