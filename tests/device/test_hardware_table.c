/* The table of hardware faults: each fault strikes while 1 N and a solenoid are on. The test measures after how many
 * milliseconds it is reported, after how many the outputs are off, and after how many they are back when it is over.
 *
 *     ctest -R device.hardware_table -V
 *
 * prints the table of docs/notebook/devices.md. */
#include <stdio.h>
#include <string.h>

#include "device/hardware_rig.h"

enum { STRIKE = 60, LASTS = 1500, COMES_BACK = 2500, SAFE_WITHIN = 10 }; /* ms */
enum { READ_CALL = 0, WRITE_CALL = 1, ONCE = 1, UNTIL_REOPENED = -1 };

typedef enum place { ARM, LINES, HOST } place;

typedef struct fault {
    const char *name;
    place where;
    int what, call,
        count; /* a fault of the stand-ins or a code of the vendor; for codes: which calls, how many */
    const char *text;   /* what the report says */
    bool needs_release; /* the emergency stop is latched */
    int detected;       /* ms until the hardware itself can be known to fail */
} fault;

enum { CLOCK_BACK = 1, CLOCK_AHEAD, CLOCK_NAN, SILENT };

static const fault faults[] = {
    {"arm: unplugged", ARM, STAND_IN_UNPLUGGED, 0, 0, "communication failed (0x0302", true, 0},
    {"arm: one failed frame", ARM, STAND_IN_COMM_ERROR, 0, 0, "communication failed", true, 0},
    {"arm: NaN in the pose", ARM, STAND_IN_NAN_POSE, 0, 0, NULL, false, 0},
    {"arm: motors warm", ARM, STAND_IN_WARM, 0, 0, "motors too warm (0x0200", false, 0},
    {"arm: moving too fast", ARM, STAND_IN_TOO_FAST, 0, 0, "moving too fast (0x0203", false, 0},
    {"arm: servo stands still", ARM, STAND_IN_STALLED, 0, 0, NULL, false, 0},
    {"arm: calibration lost (looked for every 100 ms)", ARM, STAND_IN_UNCALIBRATED, 0, 0,
     "put the stylus into the inkwell", false, 100},
    {"arm: constant pose (known after 1 s)", ARM, STAND_IN_CONSTANT, 0, 0,
     "constant pose: not calibrated", false, 1002},
    {"host: silent", HOST, SILENT, 0, 0, NULL, false, 0},
    {"host: clock steps back by 50 s", HOST, CLOCK_BACK, 0, 0, "the clock stepped back", false, 0},
    {"host: clock jumps ahead by 50 s", HOST, CLOCK_AHEAD, 0, 0, NULL, false, 0},
    {"host: clock is not a number", HOST, CLOCK_NAN, 0, 0, "now is nan", false, 0},
    {"lines: read times out, -200221", LINES, -200221, READ_CALL, ONCE, "timeout (-200221)", false,
     0},
    {"lines: read times out, -200474", LINES, -200474, READ_CALL, ONCE, "(-200474)", false, 0},
    {"lines: read times out, -200284", LINES, -200284, READ_CALL, ONCE, "(-200284)", false, 0},
    {"lines: samples overwritten, -200279", LINES, -200279, READ_CALL, ONCE, "(-200279)", false, 0},
    {"lines: write times out, -200474", LINES, -200474, WRITE_CALL, ONCE, NULL, false, 0},
    {"lines: no room for samples, -200292", LINES, -200292, WRITE_CALL, ONCE, NULL, false, 0},
    {"lines: no room for samples, -200293", LINES, -200293, WRITE_CALL, ONCE, NULL, false, 0},
    {"lines: USB transfer aborted, -50405, read", LINES, -50405, READ_CALL, UNTIL_REOPENED,
     "USB transfer aborted (-50405)", false, 0},
    {"lines: USB transfer aborted, -50405, write", LINES, -50405, WRITE_CALL, UNTIL_REOPENED, NULL,
     false, 0},
    {"lines: memory overflowed, -200361", LINES, -200361, READ_CALL, UNTIL_REOPENED, "(-200361)",
     false, 0},
    {"lines: acquisition stopped, -200222", LINES, -200222, READ_CALL, UNTIL_REOPENED, "(-200222)",
     false, 0},
    {"lines: no such task, -200088", LINES, -200088, READ_CALL, UNTIL_REOPENED, "(-200088)", false,
     0},
    {"lines: an unknown error code", LINES, -299999, READ_CALL, UNTIL_REOPENED,
     "without a name (-299999)", true, 0},
    {"lines: unplugged, -200045", LINES, STAND_IN_REMOVED, 0, 0, "device removed (-200045)", true,
     0},
};

/* ---- a run */

typedef struct table_run {
    hardware_rig rig;
    vbss_output_config output;
    const fault *fault;
    double shift;         /* of the host's clock, s */
    bool reported;        /* in the present step */
    uint64_t write_fails; /* of the lines, before the fault */
    char text[256];       /* what was reported first */
} table_run;

static bool is_code(const fault *f)
{
    return f->where == LINES && f->what < 0;
}

static void begin_fault(table_run *t)
{
    const fault *f = t->fault;
    hardware_rig *r = &t->rig;
    if (is_code(f)) {
        r->daq->set_code(f->call, f->what, f->count);
        r->commands[0].solenoid = f->call == READ_CALL; /* a line is written when it changes */
    } else if (f->where == LINES) {
        r->daq->set_fault((stand_in_daq_fault)f->what, 1);
    } else if (f->where == ARM) {
        r->hd->set_fault(0, (stand_in_hd_fault)f->what, 1);
    }
    r->silent = f->where == HOST && f->what == SILENT;
    t->shift = f->where != HOST         ? 0.0
               : f->what == CLOCK_BACK  ? -50.0
               : f->what == CLOCK_AHEAD ? 50.0
               : f->what == CLOCK_NAN   ? harness_bad_numbers[0]
                                        : 0.0;
}

static void end_fault(table_run *t)
{
    const fault *f = t->fault;
    hardware_rig *r = &t->rig;
    if (f->where == ARM) {
        r->hd->set_fault(0, (stand_in_hd_fault)f->what, 0);
    } else if (f->where == LINES && !is_code(f)) {
        r->daq->set_fault((stand_in_daq_fault)f->what, 0);
    }
    r->silent = false;
    t->shift = f->where == HOST && f->what == CLOCK_AHEAD ? t->shift : 0.0;
    r->commands[0].solenoid = 1;
}

static void take_text(table_run *t, const char *text)
{
    if (!t->reported || t->text[0] == '\0') {
        snprintf(t->text, sizeof t->text, "%s", text);
    }
    t->reported = true;
}

/* Events and flags of the device, errors of calls, and counts of the hardware. */
static void find_report(table_run *t, vbss_result result)
{
    const uint32_t good =
        VBSS_DEVICE_EVENT_FRESH | VBSS_DEVICE_EVENT_JAW_FRESH | VBSS_DEVICE_EVENT_FOUND;
    hardware_rig *r = &t->rig;
    vbss_nidaqmx_status lines;
    vbss_openhaptics_status arm;
    const char *text = "";
    const bool of_clock = result != VBSS_OK;
    expect_ok(vbss_nidaqmx_get_status(r->nidaqmx, &lines, sizeof lines));
    expect_ok(vbss_openhaptics_get_status(r->openhaptics, 0, &arm, sizeof arm));
    const bool of_device = !r->silent && !of_clock &&
                           ((r->inputs[0].events & ~good) != 0 ||
                            (r->results[0].flags &
                             (VBSS_OUTPUT_FLAG_COMMAND_STALE | VBSS_OUTPUT_FLAG_INPUT_STALE)) != 0);
    const bool of_counts =
        (r->silent && arm.silent_ticks > 0) || lines.failed_writes > t->write_fails;
    if (of_clock) {
        expect_ok(vbss_context_get_last_error(r->context, NULL, &text));
    } else if (t->fault->where != HOST) {
        expect_ok(vbss_device_get_error(r->devices[0], t->fault->where == LINES, NULL, &text));
    }
    if (of_clock || of_device || of_counts) {
        take_text(t, text);
    }
}

static void step(table_run *t)
{
    hardware_rig *r = &t->rig;
    vbss_result result = VBSS_OK;
    r->now = (double)++r->step / 1000.0;
    hardware_rig_tick(r);
    if (!r->silent) {
        const double now = r->now + t->shift;
        result = vbss_device_read(r->devices[0], now, &r->inputs[0], sizeof r->inputs[0]);
        vbss_result written =
            vbss_device_write_coupled(r->devices[0], now, &r->commands[0], &r->couplings[0],
                                      &r->results[0], sizeof r->results[0]);
        result = result == VBSS_OK ? written : result;
    }
    find_report(t, result);
}

/* Motors of a servo that stands still are beyond reach: what would go out counts. */
static bool is_force_on(const table_run *t)
{
    const hardware_rig *r = &t->rig;
    return t->fault->where == ARM && t->fault->what == STAND_IN_STALLED
               ? r->results[0].force[0] != 0.0
               : hardware_rig_force(r, 0) != 0.0;
}

static bool acts(const table_run *t)
{
    const bool keeps_force = t->fault->where == LINES && !t->fault->needs_release;
    return (!keeps_force && is_force_on(t)) || hardware_rig_solenoid(&t->rig, 0);
}

static bool is_back(const table_run *t)
{
    return fabs(hardware_rig_force(&t->rig, 0) - 1.0) < 0.02 && hardware_rig_solenoid(&t->rig, 0);
}

static void begin_run(table_run *t, const fault *f)
{
    hardware_rig *r = &t->rig;
    vbss_nidaqmx_status lines;
    memset(t, 0, sizeof *t);
    t->fault = f;
    hardware_rig_begin(r, false);
    expect_ok(vbss_output_config_init(&t->output, sizeof t->output));
    t->output.solenoid_time = 100.0; /* so that nothing but a fault puts it off */
    r->config.output = &t->output;
    hardware_rig_open(r, 1);
    r->couplings[0].stiffness = 100.0;
    r->couplings[0].position[0] = 0.01;
    r->hd->set_hand(0, &(stand_in_hand){.mass = 0.1, .stiffness = 1e5, .damping = 20.0});
    r->commands[0].solenoid = 1;
    for (int i = 0; i < STRIKE; i++) {
        step(t);
    }
    assert_true(is_back(t));
    expect_ok(vbss_nidaqmx_get_status(r->nidaqmx, &lines, sizeof lines));
    t->write_fails = lines.failed_writes;
    t->reported = false;
    t->text[0] = '\0';
}

/* ms after its beginning at which the first report comes and the outputs are off for the first time. */
static void strike(table_run *t, int *reported, int *safe)
{
    *reported = *safe = -1;
    begin_fault(t);
    for (int ms = 1; ms <= LASTS && (*reported < 0 || *safe < 0); ms++) {
        step(t);
        *reported = *reported < 0 && t->reported ? ms : *reported;
        *safe = *safe < 0 && !acts(t) ? ms : *safe;
    }
}

static int come_back(table_run *t)
{
    end_fault(t);
    for (int ms = 1; ms <= COMES_BACK; ms++) {
        step(t);
        if (t->fault->needs_release && t->rig.inputs[0].status == VBSS_DEVICE_STATUS_READY) {
            expect_ok(vbss_device_clear_emergency_stop(t->rig.devices[0]));
        }
        if (is_back(t)) {
            return ms;
        }
    }
    return -1;
}

static void print_row(const char *name, int reported, int safe, int back, bool released)
{
    printf("| %s | %d | %d | %d%s |\n", name, reported, safe, back,
           released ? ", released by the host" : "");
}

static void each_fault_is_reported_safe_and_passes(void **state)
{
    (void)state;
    printf("| kind | reported after, ms | safe after, ms | back after, ms |\n|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        const fault *f = &faults[i];
        table_run t;
        int reported, safe;
        begin_run(&t, f);
        strike(&t, &reported, &safe);
        if (f->text != NULL && strstr(t.text, f->text) == NULL) {
            fail_msg("%s: '%s' says nothing of '%s'", f->name, t.text, f->text);
        }
        const int back = come_back(&t);
        print_row(f->name, reported, safe, back, f->needs_release);
        assert_in_range(reported, 1, SAFE_WITHIN + f->detected);
        assert_in_range(safe, 1, SAFE_WITHIN + f->detected);
        assert_in_range(back, 1, COMES_BACK);
        hardware_rig_end(&t.rig);
    }
}

/* ---- slow calls */

/* Longest of some times from the host's last word to the line's end, each with another phase, ms. */
static int off_after(double call, bool *flagged, double *promised, int *reads)
{
    int longest = 0;
    for (int phase = 0; phase < 8; phase++) {
        table_run t;
        vbss_nidaqmx_status status;
        begin_run(&t, &faults[0]);
        t.rig.daq->set_call_time(call, 0);
        *flagged = false;
        for (int ms = 0; ms < 2000 + 7 * phase || !hardware_rig_solenoid(&t.rig, 0); ms++) {
            assert_true(ms < 4000);
            step(&t);
            *flagged = *flagged || (t.rig.inputs[0].events & VBSS_DEVICE_EVENT_SLOW) != 0;
        }
        expect_ok(vbss_nidaqmx_get_status(t.rig.nidaqmx, &status, sizeof status));
        const uint64_t before = t.rig.daq->reads();
        *promised = 1e3 * status.off_time;
        t.rig.silent = true;
        int took = 0;
        while (hardware_rig_solenoid(&t.rig, 0)) {
            step(&t);
            took++;
        }
        longest = took > longest ? took : longest;
        t.rig.silent = false;
        for (int ms = took; ms < 1000; ms++) {
            step(&t);
        }
        *reads = (int)(t.rig.daq->reads() - before);
        t.rig.daq->set_call_time(0.0, 0);
        hardware_rig_end(&t.rig);
    }
    return longest;
}

static void slow_calls_work_and_their_rate_is_reported(void **state)
{
    (void)state;
    const int calls[] = {1, 2, 4, 6, 12, 24}; /* ms */
    printf("| a call takes, ms | samples/s | solenoid off after, ms | the library says, ms | "
           "flagged |\n"
           "|---|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        bool flagged;
        double promised;
        int reads, took = off_after(1e-3 * calls[i], &flagged, &promised, &reads);
        printf("| %d | %d | %d | %d | %s |\n", calls[i], reads, took, (int)floor(promised + 0.5),
               flagged ? "yes" : "no");
        assert_true(reads > 500 / (2 * calls[i]));
        assert_true(took <= (int)ceil(promised) + 1 +
                                calls[i]); /* the step in which it is seen, and a write */
        assert_true(flagged || took <= SAFE_WITHIN);
    }
}

/* A wait that the host has chosen stays, and the text says that it is too short. */
static void short_timeout_is_named(void **state)
{
    (void)state;
    table_run t;
    const char *text;
    vbss_nidaqmx_status status;
    memset(&t, 0, sizeof t);
    t.fault = &faults[0];
    hardware_rig_begin(&t.rig, false);
    t.rig.lines.timeout = 0.004;
    hardware_rig_open(&t.rig, 1);
    t.rig.daq->set_call_time(0.006, 0);
    for (int ms = 0; ms < 100; ms++) {
        step(&t);
    }
    expect_ok(vbss_device_get_error(t.rig.devices[0], 1, NULL, &text));
    assert_string_equal(text, "no sample in time (-200284): the timeout of 4 ms is too short");
    expect_ok(vbss_nidaqmx_get_status(t.rig.nidaqmx, &status, sizeof status));
    assert_true(status.state == VBSS_HAPTICS_STATE_REFUSING && status.timeouts > 10);
    t.rig.daq->set_call_time(0.0, 0);
    hardware_rig_end(&t.rig);
}

/* One timeout does not lengthen the wait, so a fault after it does not delay the solenoids. */
static void single_timeout_keeps_short_wait(void **state)
{
    (void)state;
    table_run t;
    vbss_nidaqmx_status status;
    begin_run(&t, &faults[12]);
    for (int i = 0; i < 20; i++) {
        t.rig.daq->set_code(READ_CALL, -200284, ONCE);
        for (int ms = 0; ms < 20; ms++) {
            step(&t);
        }
    }
    expect_ok(vbss_nidaqmx_get_status(t.rig.nidaqmx, &status, sizeof status));
    assert_true(status.timeouts == 20 && status.timeout == 0.004);
    hardware_rig_end(&t.rig);
}

/* Errors that pass count as a loss when the device is away for more than a second. */
static void lines_that_stay_away_are_lost(void **state)
{
    (void)state;
    table_run t;
    vbss_nidaqmx_status status;
    begin_run(&t, &faults[19]);
    begin_fault(&t);
    t.rig.daq->set_fault(STAND_IN_UNKNOWN, 1); /* it does not enumerate */
    for (int ms = 0; ms < 900; ms++) {
        step(&t);
        assert_int_equal(t.rig.inputs[0].stopped, 0);
        assert_true(ms < 10 || !hardware_rig_solenoid(&t.rig, 0));
    }
    for (int ms = 0; ms < 300; ms++) {
        step(&t);
    }
    expect_ok(vbss_nidaqmx_get_status(t.rig.nidaqmx, &status, sizeof status));
    assert_int_equal(status.state, VBSS_HAPTICS_STATE_LOST);
    assert_int_equal(t.rig.inputs[0].status, VBSS_DEVICE_STATUS_LOST);
    t.rig.daq->set_fault(STAND_IN_UNKNOWN, 0);
    for (int ms = 0; ms < 100; ms++) {
        step(&t);
    }
    assert_int_equal(t.rig.inputs[0].status, VBSS_DEVICE_STATUS_READY);
    expect_ok(vbss_nidaqmx_get_status(t.rig.nidaqmx, &status, sizeof status));
    assert_true(status.reopened == 1 && status.state == VBSS_HAPTICS_STATE_RUNNING);
    hardware_rig_end(&t.rig);
}

/* The clock of the rounds is the host's where it pumps. */
static void clock_of_rounds_that_steps_back_switches_solenoids_off(void **state)
{
    (void)state;
    table_run t;
    begin_run(&t, &faults[0]);
    t.rig.silent = true;
    expect_ok(vbss_nidaqmx_poll(t.rig.nidaqmx, t.rig.now - 50.0)); /* may find the last command */
    expect_ok(vbss_nidaqmx_poll(t.rig.nidaqmx, t.rig.now - 60.0));
    assert_false(hardware_rig_solenoid(&t.rig, 0));
    hardware_rig_end(&t.rig);
}

int test_hardware_table(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_fault_is_reported_safe_and_passes),
        cmocka_unit_test(slow_calls_work_and_their_rate_is_reported),
        cmocka_unit_test(short_timeout_is_named),
        cmocka_unit_test(single_timeout_keeps_short_wait),
        cmocka_unit_test(lines_that_stay_away_are_lost),
        cmocka_unit_test(clock_of_rounds_that_steps_back_switches_solenoids_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
