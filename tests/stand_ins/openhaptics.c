/* A stand-in for OpenHaptics' HD library: frames, state, forces, errors; the referee refuses what the vendor's
 * documentation does. Units as there: mm, N. */
#include <math.h>
#include <string.h>

#include "device/platform.h"
#include "stand_ins/openhaptics_world.h"

#define JITTER 1e-10 /* mm */

static const char *const names[STAND_IN_ARMS] = {"Left", "Device2"};

/* ---- the current device */

static arm *arm_of(uint32_t device)
{
    return device < STAND_IN_ARMS && world.arms[device].is_open ? &world.arms[device] : NULL;
}

/* The current device, of which the state may be asked in its frame only. */
static arm *framed(const char *call)
{
    arm *a = arm_of(world.current);
    if (a == NULL) {
        refuse(call, "there is no current device", INVALID_OPERATION);
    } else if (!a->in_frame || !in_servo()) {
        refuse(call, "outside a frame of the current device", FRAME_ERROR);
        return NULL;
    }
    return a;
}

/* ---- the vendor's functions */

STAND_IN_API uint32_t STAND_IN_CALL hdInitDevice(const char *name);
uint32_t STAND_IN_CALL hdInitDevice(const char *name)
{
    uint32_t found = NO_DEVICE;
    enter();
    for (uint32_t i = 0; i < STAND_IN_ARMS; i++) {
        if (strcmp(name != NULL ? name : names[0], names[i]) == 0) {
            found = i;
        }
    }
    if (world.arms[0].faults[STAND_IN_NO_DEFAULT]) {
        found = name == NULL ? NO_DEVICE : strcmp(name, "Default PHANToM") == 0 ? 0 : found;
    }
    if (world.running) {
        refuse("hdInitDevice", "the scheduler runs already", INVALID_OPERATION);
    }
    if (found == NO_DEVICE) {
        push(BAD_HANDLE, NO_DEVICE);
    } else if (world.arms[found].is_open) {
        refuse("hdInitDevice", "twice", ALREADY_INITIATED);
        found = NO_DEVICE;
    } else if (world.arms[found].faults[STAND_IN_UNPLUGGED]) {
        push(COMM_ERROR, NO_DEVICE);
        found = NO_DEVICE;
    } else {
        world.arms[found].is_open = true;
        world.current = found;
    }
    leave();
    return found;
}

STAND_IN_API void STAND_IN_CALL hdDisableDevice(uint32_t device);
void STAND_IN_CALL hdDisableDevice(uint32_t device)
{
    enter();
    arm *a = arm_of(device);
    if (a == NULL) {
        refuse("hdDisableDevice", "no such device", BAD_HANDLE);
    } else {
        if (world.running) {
            refuse("hdDisableDevice", "the scheduler runs", INVALID_OPERATION);
        }
        for (int i = 0; i < 3; i++) {
            if (a->now.force[i] != 0.0 && !a->faults[STAND_IN_UNPLUGGED]) {
                refuse("hdDisableDevice", "a force is on", INVALID_OPERATION);
            }
            a->now.force[i] = 0.0;
        }
        a->is_open = a->enabled = false;
    }
    leave();
}

STAND_IN_API void STAND_IN_CALL hdMakeCurrentDevice(uint32_t device);
void STAND_IN_CALL hdMakeCurrentDevice(uint32_t device)
{
    enter();
    if (arm_of(device) == NULL) {
        refuse("hdMakeCurrentDevice", "no such device", BAD_HANDLE);
    } else if (world.running && !in_servo()) {
        refuse("hdMakeCurrentDevice", "beside the servo", INVALID_OPERATION);
    } else {
        world.current = device;
    }
    leave();
}

STAND_IN_API uint32_t STAND_IN_CALL hdGetCurrentDevice(void);
uint32_t STAND_IN_CALL hdGetCurrentDevice(void)
{
    enter();
    uint32_t current = world.current;
    leave();
    return current;
}

STAND_IN_API void STAND_IN_CALL hdBeginFrame(uint32_t device);
void STAND_IN_CALL hdBeginFrame(uint32_t device)
{
    enter();
    arm *a = arm_of(device);
    if (a == NULL) {
        refuse("hdBeginFrame", "no such device", BAD_HANDLE);
    } else if (!in_servo()) {
        refuse("hdBeginFrame", "outside the servo", ILLEGAL_BEGIN);
    } else if (a->in_frame) {
        refuse("hdBeginFrame", "twice", ILLEGAL_BEGIN);
    } else if (a->framed_at == world.tick) {
        refuse("hdBeginFrame", "a second frame in a tick", FRAME_ERROR);
    } else {
        world.current = device;
        a->in_frame = true;
        a->framed_at = world.tick;
        memset(a->staged, 0, sizeof a->staged);
        if (a->faults[STAND_IN_UNPLUGGED] || a->faults[STAND_IN_COMM_ERROR]) {
            push(COMM_ERROR, device);
        }
    }
    leave();
}

/* What the motors make of the force: nothing without power, and no more than they can. */
static void put_out(arm *a, uint32_t device)
{
    double size = sqrt(a->staged[0] * a->staged[0] + a->staged[1] * a->staged[1] +
                       a->staged[2] * a->staged[2]);
    bool dead = a->faults[STAND_IN_UNPLUGGED] || a->faults[STAND_IN_WARM] || !a->enabled;
    for (int i = 0; i < 3; i++) {
        a->now.force[i] = dead ? 0.0 : a->staged[i];
    }
    if (size > 3.3) {
        refuse("hdEndFrame", "force above its largest", EXCEEDED_MAX_FORCE);
    }
    if (a->faults[STAND_IN_UNPLUGGED] || a->faults[STAND_IN_COMM_ERROR]) {
        push(COMM_ERROR, device);
    }
    if (a->faults[STAND_IN_WARM]) {
        push(WARM_MOTORS, device);
    }
    if (a->faults[STAND_IN_TOO_FAST]) {
        push(EXCEEDED_MAX_VELOCITY, device);
    }
    a->faults[STAND_IN_COMM_ERROR] = a->faults[STAND_IN_TOO_FAST] = false;
}

STAND_IN_API void STAND_IN_CALL hdEndFrame(uint32_t device);
void STAND_IN_CALL hdEndFrame(uint32_t device)
{
    enter();
    arm *a = arm_of(device);
    if (a == NULL || !a->in_frame || !in_servo()) {
        refuse("hdEndFrame", "without begin", ILLEGAL_END);
    } else {
        a->in_frame = false;
        put_out(a, device);
    }
    leave();
}

STAND_IN_API hd_error STAND_IN_CALL hdGetError(void);
hd_error STAND_IN_CALL hdGetError(void)
{
    hd_error error = {0, 0, NO_DEVICE};
    enter();
    if (world.error_count > 0) {
        error = world.errors[--world.error_count];
    }
    leave();
    return error;
}

static void switch_capability(const char *call, uint32_t capability, bool on)
{
    enter();
    arm *a = arm_of(world.current);
    if (a == NULL) {
        refuse(call, "there is no current device", INVALID_OPERATION);
    } else if (capability == 0x4000) {
        a->enabled = on;
    } else if (capability < 0x4000 || capability > 0x4004) {
        refuse(call, "no such capability", INVALID_ENUM);
    } else if (!on) { /* limits of the vendor's: "at your own risk" */
        refuse(call, "a safety limit is switched off", INVALID_OPERATION);
    }
    leave();
}

STAND_IN_API void STAND_IN_CALL hdEnable(uint32_t capability);
void STAND_IN_CALL hdEnable(uint32_t capability)
{
    switch_capability("hdEnable", capability, true);
}

STAND_IN_API void STAND_IN_CALL hdDisable(uint32_t capability);
void STAND_IN_CALL hdDisable(uint32_t capability)
{
    switch_capability("hdDisable", capability, false);
}

/* By columns: the stylus' axes, then where it is. */
static void transform_of(const arm *a, double m[16])
{
    const double w = a->now.turn[0], *v = a->now.turn + 1;
    memset(m, 0, 16 * sizeof *m);
    m[15] = 1.0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        m[4 * i + i] = 1.0 - 2.0 * (v[j] * v[j] + v[k] * v[k]);
        m[4 * i + j] = 2.0 * (v[i] * v[j] + w * v[k]);
        m[4 * i + k] = 2.0 * (v[i] * v[k] - w * v[j]);
        m[12 + i] = 1e3 * a->now.position[i];
    }
    /* the last bits of a sensor that is held by a hand never rest */
    m[12] += (world.tick & 1u) != 0 ? JITTER : -JITTER;
    if (a->faults[STAND_IN_CONSTANT]) {
        const double constant[3] = {0.0, 35.0, -110.0};
        memcpy(m + 12, constant, sizeof constant);
    }
    if (a->faults[STAND_IN_NAN_POSE]) {
        m[13] = nan("");
    }
}

static void get_state(arm *a, uint32_t name, double *values)
{
    if (a->faults[STAND_IN_UNPLUGGED]) {
        return; /* nothing is written */
    }
    for (int i = 0; i < 3; i++) {
        if (name == 0x2050 || name == 0x2051) {
            values[i] = 1e3 * (name == 0x2050 ? a->now.position[i] : a->now.velocity[i]);
        } else if (name == 0x2053) {
            values[i] = a->now.spin[i];
        } else if (name == 0x2605) {
            values[i] = a->faults[STAND_IN_WARM] ? 0.95 : 0.2;
        }
    }
    if (name == 0x2052) {
        transform_of(a, values);
    }
}

STAND_IN_API void STAND_IN_CALL hdGetDoublev(uint32_t name, double *values);
void STAND_IN_CALL hdGetDoublev(uint32_t name, double *values)
{
    const double box[6] = {-80.0, -60.0, -35.0, 80.0, 60.0, 35.0};
    enter();
    arm *a = arm_of(world.current);
    if (a == NULL || values == NULL) {
        refuse("hdGetDoublev", "no current device, or nowhere to write", INVALID_OPERATION);
    } else if (name == 0x2550) {
        memcpy(values, box, sizeof box);
    } else if (name == 0x2603) {
        values[0] = 3.3;
    } else if (name == 0x2604) {
        values[0] = 0.88;
    } else if ((name >= 0x2050 && name <= 0x2053) || name == 0x2605) {
        if (framed("hdGetDoublev") != NULL) {
            get_state(a, name, values);
        }
    } else if (name == 0x2000 || name == 0x2555) {
        refuse("hdGetDoublev", "a whole number", INVALID_INPUT_TYPE);
    } else {
        refuse("hdGetDoublev", "no such parameter", INVALID_ENUM);
    }
    leave();
}

STAND_IN_API void STAND_IN_CALL hdGetIntegerv(uint32_t name, int32_t *values);
void STAND_IN_CALL hdGetIntegerv(uint32_t name, int32_t *values)
{
    enter();
    arm *a = arm_of(world.current);
    if (a == NULL || values == NULL) {
        refuse("hdGetIntegerv", "no current device, or nowhere to write", INVALID_OPERATION);
    } else if (name == 0x2553) {
        values[0] = 6;
    } else if (name == 0x2554) {
        values[0] = 3;
    } else if (name == 0x2555) {
        values[0] = 4;
    } else if (name == 0x2000) {
        if (framed("hdGetIntegerv") != NULL) {
            values[0] = a->buttons;
        }
    } else {
        refuse("hdGetIntegerv", "no such whole number", INVALID_ENUM);
    }
    leave();
}

STAND_IN_API void STAND_IN_CALL hdSetDoublev(uint32_t name, const double *values);
void STAND_IN_CALL hdSetDoublev(uint32_t name, const double *values)
{
    enter();
    arm *a = framed("hdSetDoublev");
    if (a != NULL) {
        if (name != 0x2700 || values == NULL) {
            refuse("hdSetDoublev", "only forces are set here", INVALID_ENUM);
        } else if (!isfinite(values[0] + values[1] + values[2])) {
            refuse("hdSetDoublev", "a force that is no number", INVALID_VALUE);
        } else if (!a->enabled) {
            refuse("hdSetDoublev", "force output is off", INVALID_OPERATION);
        } else {
            memcpy(a->staged, values, sizeof a->staged);
        }
    }
    leave();
}

STAND_IN_API const char *STAND_IN_CALL hdGetString(uint32_t name);
const char *STAND_IN_CALL hdGetString(uint32_t name)
{
    static const char *const serials[STAND_IN_ARMS] = {"stand-in 1", "stand-in 2"};
    const char *text = NULL;
    enter();
    if (arm_of(world.current) == NULL) {
        refuse("hdGetString", "there is no current device", INVALID_OPERATION);
    } else if (name == 0x2501) {
        text = "Touch (stand-in)";
    } else if (name == 0x2504) {
        text = serials[world.current];
    } else {
        refuse("hdGetString", "no such text", INVALID_ENUM);
    }
    leave();
    return text;
}

STAND_IN_API void STAND_IN_CALL hdSetSchedulerRate(unsigned long rate);
void STAND_IN_CALL hdSetSchedulerRate(unsigned long rate)
{
    enter();
    if (rate != 500 && rate != 1000 && rate != 2000) {
        push(INVALID_VALUE, NO_DEVICE);
    } else {
        world.rate = rate;
    }
    leave();
}

STAND_IN_API unsigned long STAND_IN_CALL hdScheduleAsynchronous(hd_callback callback, void *user,
                                                                uint16_t priority);
unsigned long STAND_IN_CALL hdScheduleAsynchronous(hd_callback callback, void *user,
                                                   uint16_t priority)
{
    (void)priority;
    enter();
    if (world.running) {
        refuse("hdScheduleAsynchronous", "after the start of the scheduler", INVALID_OPERATION);
    }
    if (world.callback != NULL || callback == NULL) {
        refuse("hdScheduleAsynchronous", "one callback serves all arms here", INVALID_OPERATION);
    }
    world.callback = callback;
    world.user = user;
    world.callback_done = false;
    leave();
    return 17;
}

STAND_IN_API void STAND_IN_CALL hdStartScheduler(void);
void STAND_IN_CALL hdStartScheduler(void)
{
    enter();
    if (world.running || world.callback == NULL) {
        refuse("hdStartScheduler", "it runs, or has nothing to do", INVALID_OPERATION);
    } else if (world.arms[0].faults[STAND_IN_NO_LICENCE]) {
        push(INVALID_LICENCE, NO_DEVICE);
    } else {
        world.running = true;
        world.running = !world.threaded || pthread_create(&world.servo, NULL, serve, NULL) == 0;
    }
    leave();
}

STAND_IN_API void STAND_IN_CALL hdStopScheduler(void);
void STAND_IN_CALL hdStopScheduler(void)
{
    enter();
    bool ran = world.running;
    if (in_servo()) {
        refuse("hdStopScheduler", "inside the servo", INVALID_OPERATION);
    }
    world.running = false;
    leave();
    if (ran && world.threaded) {
        pthread_join(world.servo, NULL);
    }
}

STAND_IN_API void STAND_IN_CALL hdUnschedule(unsigned long handle);
void STAND_IN_CALL hdUnschedule(unsigned long handle)
{
    enter();
    if (handle != 17 || world.callback == NULL) {
        refuse("hdUnschedule", "no such callback", BAD_HANDLE);
    }
    world.callback = NULL;
    leave();
}

/* Whoever waits lets time go on. */
STAND_IN_API uint8_t STAND_IN_CALL hdWaitForCompletion(unsigned long handle, uint32_t code);
uint8_t STAND_IN_CALL hdWaitForCompletion(unsigned long handle, uint32_t code)
{
    enter();
    if (handle != 17 || code > 1 || in_servo()) {
        refuse("hdWaitForCompletion", "no such callback, or inside the servo", INVALID_OPERATION);
    }
    bool ticks = !world.threaded;
    leave();
    if (ticks) {
        tick_once();
    }
    return 1;
}

STAND_IN_API double STAND_IN_CALL hdGetSchedulerTimeStamp(void);
double STAND_IN_CALL hdGetSchedulerTimeStamp(void)
{
    enter();
    double since = world.threaded ? vbss_device_time() - world.began : 1e-5;
    leave();
    return since;
}

STAND_IN_API uint32_t STAND_IN_CALL hdCheckCalibration(void);
uint32_t STAND_IN_CALL hdCheckCalibration(void)
{
    enter();
    const arm *a = framed("hdCheckCalibration");
    uint32_t state = a != NULL && a->faults[STAND_IN_UNCALIBRATED] ? 0x5002 : 0x5000;
    leave();
    return state;
}

STAND_IN_API void STAND_IN_CALL hdUpdateCalibration(uint32_t style);
void STAND_IN_CALL hdUpdateCalibration(uint32_t style)
{
    enter();
    if (style != 4) {
        refuse("hdUpdateCalibration", "a style the arm does not have", INVALID_VALUE);
    }
    leave();
}
