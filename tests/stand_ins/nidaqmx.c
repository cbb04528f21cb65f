/* A stand-in for NI-DAQmx with one USB-6008: tasks, analog inputs of 11 bits, lines with pull-ups; the referee refuses
 * what the vendor's documentation does, and calls from a thread that must not wait. */
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "stand_ins/nidaqmx_base.h"
#include "stand_ins/referee.h"
#include "stand_ins/stand_ins.h"

typedef void *task_handle;

enum { TASKS = 4, NAMES = 160 };
enum {
    TIMEOUT = -200221,
    NO_SAMPLE = -200284,
    INVALID_DEVICE = -200220,
    INVALID_CHANNEL = -200170,
    INVALID_TASK = -200088,
    REMOVED = -200045,
    RESERVED = -50103,
    STOPPED = -200846,
    INVALID_ATTRIBUTE = -200077,
    INVALID_LINES = -200562,
    A_WARNING = 200015
};

typedef struct task {
    bool alive, started;
    uint64_t number; /* counts the tasks so far */
    int inputs[STAND_IN_INPUTS], input_count;
    int lines[STAND_IN_LINES], line_count;
} task;

static struct {
    pthread_mutex_t lock;
    referee judge;
    task tasks[TASKS];
    bool faults[STAND_IN_DAQ_FAULTS];
    double volts[STAND_IN_INPUTS];
    bool driven[STAND_IN_LINES];
    int levels[STAND_IN_LINES];
    uint64_t reads, writes, tasks_created;
    int32_t codes[2];       /* of reads, of writes */
    int code_counts[2];     /* how often more; -1: until the task is another */
    uint64_t code_tasks[2]; /* the newest task when the code was set */
    double call_time, waited;
    bool sleeps;
    bool forbidding;
    pthread_t forbidden;
    int32_t last_error;
} world = {.lock = PTHREAD_MUTEX_INITIALIZER};

static void enter(void)
{
    pthread_mutex_lock(&world.lock);
}

static int32_t leave(int32_t code)
{
    world.last_error = code != 0 ? code : world.last_error;
    pthread_mutex_unlock(&world.lock);
    return code;
}

static int32_t refuse(const char *call, const char *why, int32_t code)
{
    referee_refuse(&world.judge, call, why);
    return code;
}

static task *task_of(task_handle handle)
{
    for (int i = 0; i < TASKS; i++) {
        if (handle == &world.tasks[i] && world.tasks[i].alive) {
            return &world.tasks[i];
        }
    }
    return NULL;
}

static void float_lines(const task *t)
{
    for (int i = 0; i < t->line_count; i++) {
        world.driven[t->lines[i]] = false;
    }
}

/* ---- tasks */

STAND_IN_API int32_t STAND_IN_CALL DAQmxCreateTask(const char *name, task_handle *handle);
int32_t STAND_IN_CALL DAQmxCreateTask(const char *name, task_handle *handle)
{
    enter();
    if (name == NULL || handle == NULL) {
        return leave(refuse("DAQmxCreateTask", "no name, or nowhere to write", INVALID_ATTRIBUTE));
    }
    for (int i = 0; i < TASKS; i++) {
        if (!world.tasks[i].alive) {
            memset(&world.tasks[i], 0, sizeof world.tasks[i]);
            world.tasks[i].alive = true;
            world.tasks[i].number = ++world.tasks_created;
            *handle = &world.tasks[i];
            return leave(0);
        }
    }
    return leave(refuse("DAQmxCreateTask", "too many tasks", INVALID_ATTRIBUTE));
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxStartTask(task_handle handle);
int32_t STAND_IN_CALL DAQmxStartTask(task_handle handle)
{
    enter();
    task *t = task_of(handle);
    if (t == NULL) {
        return leave(refuse("DAQmxStartTask", "no such task", INVALID_TASK));
    }
    if (t->started) {
        return leave(refuse("DAQmxStartTask", "twice", INVALID_ATTRIBUTE));
    }
    if (t->line_count > 0) {
        return leave(refuse("DAQmxStartTask", "lines would be driven without a value", STOPPED));
    }
    if (world.faults[STAND_IN_RESERVED] || world.faults[STAND_IN_REMOVED]) {
        return leave(world.faults[STAND_IN_REMOVED] ? REMOVED : RESERVED);
    }
    t->started = true;
    return leave(0);
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxStopTask(task_handle handle);
int32_t STAND_IN_CALL DAQmxStopTask(task_handle handle)
{
    enter();
    task *t = task_of(handle);
    if (t == NULL) {
        return leave(refuse("DAQmxStopTask", "no such task", INVALID_TASK));
    }
    t->started = false;
    return leave(world.faults[STAND_IN_REMOVED] ? REMOVED : 0);
}

/* Lines keep their level on a USB-6008 that stays plugged in: a solenoid that is on would stay on. */
STAND_IN_API int32_t STAND_IN_CALL DAQmxClearTask(task_handle handle);
int32_t STAND_IN_CALL DAQmxClearTask(task_handle handle)
{
    enter();
    task *t = task_of(handle);
    if (t == NULL) {
        return leave(refuse("DAQmxClearTask", "no such task", INVALID_TASK));
    }
    t->alive = false;
    return leave(0);
}

/* ---- channels */

/* The number behind a prefix, if it is below `count`; -1: there is none. */
static int number_after(const char *name, const char *prefix, int count)
{
    size_t length = strlen(prefix);
    char *end;
    if (strncmp(name, prefix, length) != 0 || name[length] == '\0') {
        return -1;
    }
    long number = strtol(name + length, &end, 10);
    return *end == '\0' && number >= 0 && number < count ? (int)number : -1;
}

static int32_t unknown(const char *name)
{
    return strncmp(name, "Dev1/", 5) == 0 ? INVALID_CHANNEL : INVALID_DEVICE;
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxCreateAIVoltageChan(task_handle handle,
                                                            const char *physical, const char *name,
                                                            int32_t terminal, double low,
                                                            double high, int32_t units,
                                                            const char *scale);
int32_t STAND_IN_CALL DAQmxCreateAIVoltageChan(task_handle handle, const char *physical,
                                               const char *name, int32_t terminal, double low,
                                               double high, int32_t units, const char *scale)
{
    enter();
    task *t = task_of(handle);
    if (t == NULL || t->started || t->line_count > 0 || physical == NULL || name == NULL) {
        return leave(refuse("DAQmxCreateAIVoltageChan", "not to this task", INVALID_TASK));
    }
    if ((terminal != 10083 && terminal != 10106 && terminal != -1) || units != 10348 ||
        scale != NULL || !(low < high) || low < -20.0 || high > 20.0) {
        return leave(
            refuse("DAQmxCreateAIVoltageChan", "wiring, range or unit", INVALID_ATTRIBUTE));
    }
    int input = number_after(physical, "Dev1/ai", STAND_IN_INPUTS);
    if (input < 0 || world.faults[STAND_IN_REMOVED] || world.faults[STAND_IN_UNKNOWN]) {
        return leave(input < 0 ? unknown(physical) : INVALID_DEVICE);
    }
    t->inputs[t->input_count++] = input;
    return leave(0);
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxCreateDOChan(task_handle handle, const char *lines,
                                                     const char *names, int32_t grouping);
int32_t STAND_IN_CALL DAQmxCreateDOChan(task_handle handle, const char *lines, const char *names,
                                        int32_t grouping)
{
    char copy[NAMES];
    enter();
    task *t = task_of(handle);
    if (t == NULL || t->started || t->input_count > 0 || lines == NULL || names == NULL ||
        strlen(lines) >= sizeof copy || grouping < 0 || grouping > 1) {
        return leave(refuse("DAQmxCreateDOChan", "not to this task", INVALID_TASK));
    }
    memcpy(copy, lines, strlen(lines) + 1);
    for (char *name = copy, *next; name != NULL; name = next) {
        next = strchr(name, ',');
        if (next != NULL) {
            *next++ = '\0';
        }
        name += strspn(name, " ");
#ifdef STAND_IN_BASE /* the whole port */
        if (strcmp(name, "Dev1/port0") == 0) {
            for (int line = 0; line < STAND_IN_LINES; line++) {
                t->lines[t->line_count++] = line;
            }
            continue;
        }
#endif
        int line = number_after(name, "Dev1/port0/line", STAND_IN_LINES);
        if (line < 0) {
            return leave(unknown(name));
        }
        t->lines[t->line_count++] = line;
    }
    return leave(0);
}

/* ---- calls that wait */

static int32_t begin_call(const char *call, task *t, double timeout)
{
    if (world.forbidding && pthread_equal(world.forbidden, pthread_self())) {
        refuse(call, "from a thread that must not wait", 0);
    }
    if (t == NULL) {
        return refuse(call, "no such task", INVALID_TASK);
    }
    if (!(timeout > 0.0) || timeout > 10.0) {
        refuse(call, "it waits for ever, or never", 0);
    }
    return world.faults[STAND_IN_REMOVED] ? REMOVED : 0;
}

/* The code that was asked for, while there is one. */
static int32_t asked_code(const task *t, int is_write)
{
    int *count = &world.code_counts[is_write];
    if (*count == 0 || (*count < 0 && t->number > world.code_tasks[is_write])) {
        return 0;
    }
    *count -= *count > 0;
    return world.codes[is_write];
}

/* Lets a call take its time. False: it was longer than its timeout. */
static bool take_time(double timeout)
{
    enter();
    const double takes = fmin(world.call_time, timeout);
    const bool in_time = world.call_time <= timeout, sleeps = world.sleeps;
    world.waited += takes;
    leave(0);
    if (sleeps && takes > 0.0) {
        const struct timespec pause = {.tv_nsec = (long)(takes * 1e9)};
        nanosleep(&pause, NULL);
    }
    return in_time;
}

/* 11 bits over 20 V, single-ended. */
static double quantised(double volts)
{
    const double step = 20.0 / 2048.0;
    return step * floor(volts / step + 0.5);
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxReadAnalogF64(task_handle handle, int32_t samples,
                                                      double timeout, uint32_t fill, double *values,
                                                      uint32_t room, int32_t *read,
                                                      const uint32_t *reserved);
int32_t STAND_IN_CALL DAQmxReadAnalogF64(task_handle handle, int32_t samples, double timeout,
                                         uint32_t fill, double *values, uint32_t room,
                                         int32_t *read, const uint32_t *reserved)
{
    const bool in_time = take_time(timeout);
    enter();
    task *t = task_of(handle);
    int32_t code = begin_call("DAQmxReadAnalogF64", t, timeout);
    code = code == 0 ? asked_code(t, 0) : code;
    if (code != 0) {
        return leave(code);
    }
    if (t->input_count == 0 || samples != 1 || fill > 1 || values == NULL || read == NULL ||
        reserved != NULL || room < (uint32_t)t->input_count) {
        return leave(refuse("DAQmxReadAnalogF64", "its arguments", INVALID_ATTRIBUTE));
    }
    if (!t->started) { /* works, by starting and stopping at each read */
        refuse("DAQmxReadAnalogF64", "the task was not started", 0);
    }
    *read = 0;
    if (world.faults[STAND_IN_READ_TIMEOUT] || !in_time) {
        return leave(NO_SAMPLE);
    }
    for (int i = 0; i < t->input_count; i++) {
        values[i] = quantised(world.volts[t->inputs[i]]);
    }
    *read = 1;
    world.reads++;
    return leave(world.faults[STAND_IN_WARNING] ? A_WARNING : 0);
}

/* One byte for each line, or one bit of a port for NI-DAQmx Base. */
static int level_of(const uint8_t *bytes, int i)
{
#ifdef STAND_IN_BASE
    return bytes[0] >> i & 1;
#else
    return bytes[i];
#endif
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxWriteDigitalLines(task_handle handle, int32_t samples,
                                                          uint32_t auto_start, double timeout,
                                                          uint32_t layout, const uint8_t *bytes,
                                                          int32_t *written,
                                                          const uint32_t *reserved);
int32_t STAND_IN_CALL DAQmxWriteDigitalLines(task_handle handle, int32_t samples,
                                             uint32_t auto_start, double timeout, uint32_t layout,
                                             const uint8_t *bytes, int32_t *written,
                                             const uint32_t *reserved)
{
    const bool in_time = take_time(timeout);
    enter();
    task *t = task_of(handle);
    int32_t code = begin_call("DAQmxWriteDigitalLines", t, timeout);
    code = code == 0 ? asked_code(t, 1) : code;
    if (code != 0) {
        return leave(code);
    }
    if (t->line_count == 0 || samples != 1 || layout > 1 || bytes == NULL || written == NULL ||
        reserved != NULL) {
        return leave(refuse("DAQmxWriteDigitalLines", "its arguments", INVALID_ATTRIBUTE));
    }
    if (auto_start == 0 && !t->started) {
        return leave(refuse("DAQmxWriteDigitalLines", "the task is stopped", STOPPED));
    }
    *written = 0;
    for (int i = 0; i < t->line_count; i++) {
        if (level_of(bytes, i) > 1) {
            return leave(refuse("DAQmxWriteDigitalLines", "neither 0 nor 1", INVALID_LINES));
        }
    }
    if (world.faults[STAND_IN_WRITE_TIMEOUT] || !in_time || world.faults[STAND_IN_RESERVED]) {
        return leave(world.faults[STAND_IN_RESERVED] ? RESERVED : TIMEOUT);
    }
    for (int i = 0; i < t->line_count; i++) {
        world.driven[t->lines[i]] = true;
        world.levels[t->lines[i]] = level_of(bytes, i);
    }
    *written = 1;
    world.writes++;
    return leave(0);
}

/* ---- texts */

STAND_IN_API int32_t STAND_IN_CALL DAQmxGetExtendedErrorInfo(char *text, uint32_t bytes);
int32_t STAND_IN_CALL DAQmxGetExtendedErrorInfo(char *text, uint32_t bytes)
{
    enter();
    snprintf(text, bytes, "Status Code: %d\nTask Name: _unnamedTask<0>", world.last_error);
    pthread_mutex_unlock(&world.lock);
    return 0;
}

#ifndef STAND_IN_BASE /* which has no list of devices */
STAND_IN_API int32_t STAND_IN_CALL DAQmxGetSysDevNames(char *text, uint32_t bytes);
int32_t STAND_IN_CALL DAQmxGetSysDevNames(char *text, uint32_t bytes)
{
    enter();
    snprintf(text, bytes, "%s", world.faults[STAND_IN_UNKNOWN] ? "" : "Dev1, Dev2");
    return leave(0);
}

STAND_IN_API int32_t STAND_IN_CALL DAQmxGetDevProductType(const char *device, char *text,
                                                          uint32_t bytes);
int32_t STAND_IN_CALL DAQmxGetDevProductType(const char *device, char *text, uint32_t bytes)
{
    enter();
    if (strcmp(device, "Dev1") != 0 && strcmp(device, "Dev2") != 0) {
        return leave(refuse("DAQmxGetDevProductType", "no such device", INVALID_DEVICE));
    }
    snprintf(text, bytes, "%s", strcmp(device, "Dev1") == 0 ? "USB-6008" : "USB-6009");
    return leave(0);
}
#endif

/* ---- behind the scenes */

static void reset(void)
{
    enter();
    memset(&world.judge, 0, sizeof world.judge);
    memset(world.tasks, 0, sizeof world.tasks);
    memset(world.faults, 0, sizeof world.faults);
    memset(world.volts, 0, sizeof world.volts);
    memset(world.driven, 0, sizeof world.driven);
    memset(world.levels, 0, sizeof world.levels);
    memset(world.code_counts, 0, sizeof world.code_counts);
    world.call_time = world.waited = 0.0;
    world.sleeps = false;
    world.reads = world.writes = 0;
    world.forbidding = false;
    leave(0);
}

static void set_fault(stand_in_daq_fault fault, int on)
{
    enter();
    world.faults[fault] = on != 0;
    for (int i = 0; fault == STAND_IN_REMOVED && on && i < TASKS; i++) {
        float_lines(&world.tasks[i]);
    }
    leave(0);
}

static void set_volts(int input, double volts)
{
    enter();
    world.volts[input] = volts;
    leave(0);
}

static void set_code(int is_write, int32_t code, int count)
{
    enter();
    world.codes[is_write] = code;
    world.code_counts[is_write] = count;
    world.code_tasks[is_write] = world.tasks_created;
    leave(0);
}

static void set_call_time(double seconds, int sleeps)
{
    enter();
    world.call_time = seconds;
    world.sleeps = sleeps != 0;
    leave(0);
}

static double waited(void)
{
    enter();
    const double seconds = world.waited;
    world.waited = 0.0;
    leave(0);
    return seconds;
}

static int level(int line)
{
    enter();
    int high = world.driven[line] ? world.levels[line] : 1;
    leave(0);
    return high;
}

static uint64_t reads(void)
{
    enter();
    uint64_t count = world.reads;
    leave(0);
    return count;
}

static uint64_t writes(void)
{
    enter();
    uint64_t count = world.writes;
    leave(0);
    return count;
}

static void forbid_this_thread(int yes)
{
    enter();
    world.forbidding = yes != 0;
    world.forbidden = pthread_self();
    leave(0);
}

static int illegal(const char **first)
{
    enter();
    for (int i = 0; i < TASKS; i++) {
        if (world.tasks[i].alive) {
            referee_refuse(&world.judge, "end", "a task was left");
        }
    }
    *first = world.judge.first;
    int count = world.judge.count;
    leave(0);
    return count;
}

const stand_in_daq_table *stand_in_daq(void)
{
    static const stand_in_daq_table table = {
        reset, set_fault, set_volts, set_code,           set_call_time, waited,
        level, reads,     writes,    forbid_this_thread, illegal};
    return &table;
}
