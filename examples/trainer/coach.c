#include "trainer/coach.h"

#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "trainer/guide.h"
#include "trainer/hardware.h"

#define PERIOD 1e-3   /* s */
#define REHEARSED 4.0 /* s of each step that a stand-in's hand makes */
#define CORNER 0.5    /* s at each corner of its space */

enum { FAILED = 1, NOT_THERE = 3, MAX_TRIES = 5 };

static const char *const side_names[HANDS] = {"left", "right"};

typedef struct coach {
    const options *options;
    hardware hardware;
    rehearsal *rehearsal;
    double now;      /* s */
    bool rehearsed;  /* all that is guided is a stand-in */
    bool left_alone; /* Ctrl-C */
} coach;

/* ---- a stand-in's hand, in its arm's frame: x right, y up, z toward who trains */

static void obey(coach *c, int side, guide_step step, double since)
{
    double at[3] = {0.0, 0.0, 0.0};
    if (step == GUIDE_RIGHT || step == GUIDE_UP || step == GUIDE_TOWARD) {
        at[step - GUIDE_RIGHT] = 0.05;
    } else if (step == GUIDE_REACH) {
        int corner = (int)(since / CORNER);
        for (int i = 0; i < 3; i++) {
            at[i] = (corner & (1 << i)) != 0 ? 0.07 : -0.07;
        }
    }
    rehearsal_move(c->rehearsal, side, at, NULL, false);
    rehearsal_squeeze(c->rehearsal, side, step == GUIDE_CLOSE ? 0.6 : 1.2);
}

/* ---- somebody in front of the terminal */

/* 1: Enter, 0: not yet, -1: nobody is there any more. */
static int entered(void)
{
    struct pollfd in = {.fd = 0, .events = POLLIN};
    char line[16];
    if (poll(&in, 1, 0) <= 0) {
        return 0;
    }
    return fgets(line, sizeof line, stdin) != NULL ? 1 : -1;
}

static vbss_result let_time_pass(coach *c)
{
    const struct timespec period = {.tv_nsec = 1000000};
    c->now += PERIOD;
    if (!c->options->simulated) {
        c->left_alone = clock_nanosleep(CLOCK_MONOTONIC, 0, &period, NULL) != 0;
        return VBSS_OK;
    }
    if (c->hardware.nidaqmx != NULL) {
        TRY(vbss_nidaqmx_poll(c->hardware.nidaqmx, c->now));
    }
    rehearsal_tick(c->rehearsal);
    return VBSS_OK;
}

static void cause_faults(const coach *c, int side)
{
    for (uint32_t i = 0; i < c->options->fault_count; i++) {
        const fault_plan *plan = &c->options->faults[i];
        rehearsal_cause(c->rehearsal, rehearsal_fault(plan->name), side,
                        c->now >= plan->from && c->now < plan->until);
    }
}

/* Until the step was made: 1, or nobody is there: -1, or the device fails: 0. */
static int watch_step(coach *c, int side, guide *g)
{
    double begin = c->now;
    int done = 0;
    while (done == 0) {
        double since = c->now - begin;
        vbss_device_input in;
        if (c->rehearsed) {
            obey(c, side, g->step, since);
            cause_faults(c, side);
        }
        if (let_time_pass(c) != VBSS_OK ||
            vbss_device_read(c->hardware.devices[side], c->now, &in, sizeof in) != VBSS_OK ||
            in.stopped != 0) {
            return 0;
        }
        guide_see(g, &in);
        done = c->left_alone ? -1 : c->rehearsed ? since >= REHEARSED : entered();
    }
    return done;
}

/* An arm without a calibration of its own measures nothing that is worth a file. */
static const char *find_objection(const coach *c, int side, const guide *g)
{
    vbss_openhaptics_status s;
    const bool is_known =
        g->arm && vbss_openhaptics_get_status(c->hardware.openhaptics, (uint32_t)side, &s,
                                              sizeof s) == VBSS_OK;
    if (!is_known || s.state != VBSS_HAPTICS_STATE_UNCALIBRATED) {
        return NULL;
    }
    return s.is_constant != 0
               ? "the arm gives a constant pose: calibrate it with the vendor's program, "
                 "and hold it"
               : "the arm is not calibrated: put the stylus into the inkwell";
}

static bool guide_hand(coach *c, int side, guide *g)
{
    char why[256];
    for (int tries = 0; g->step != GUIDE_DONE;) {
        printf("%s hand: %s\n", side_names[side], guide_ask(g));
        fflush(stdout);
        int done = watch_step(c, side, g);
        if (done != 1) {
            hardware_explain(&c->hardware, side, why, sizeof why);
            printf("%s\n", done < 0 ? "given up" : why);
            return false;
        }
        const char *objection = find_objection(c, side, g);
        const char *again = objection != NULL ? objection : guide_next(g);
        tries = again != NULL ? tries + 1 : 0;
        if (again != NULL) {
            printf("  again: %s\n", again);
        }
        if (tries == MAX_TRIES) {
            return false;
        }
    }
    return true;
}

/* ---- both hands */

static vbss_result make_plain(calibration *plain)
{
    TRY(calibration_init(plain));
    TRY(guide_plain(&plain->hands[LEFT]));
    return guide_plain(&plain->hands[RIGHT]);
}

static bool guide_hands(coach *c, calibration *found, const stage *s)
{
    double middle[3];
    v_store(middle, s->middle);
    puts("Press Enter when each is done.");
    for (int side = 0; side < HANDS; side++) {
        guide g;
        if (!c->hardware.arm[side] && !c->hardware.handle[side]) {
            continue;
        }
        guide_begin(&g, c->hardware.arm[side], c->hardware.handle[side], &found->hands[side]);
        if (!guide_hand(c, side, &g)) {
            return false;
        }
        guide_centre(&g, middle);
        found->hands[side] = g.found;
        found->known[side] = true;
    }
    return true;
}

int coach_run(const options *o, calibration *found, rehearsal *r, const stage *s)
{
    coach c = {.options = o, .rehearsal = r};
    c.rehearsed = (o->arm_count == 0 || r->hd != NULL) && (o->handle_count == 0 || r->daq != NULL);
    calibration plain;
    char why[512];
    if (make_plain(&plain) != VBSS_OK ||
        !hardware_open(&c.hardware, o, &plain, s, NULL, why, sizeof why)) {
        printf("%s\n", why);
        return NOT_THERE;
    }
    bool good = guide_hands(&c, found, s);
    hardware_close(&c.hardware);
    if (good && !calibration_write(found, o->calibration)) {
        printf("%s: cannot be written\n", o->calibration);
        return NOT_THERE;
    }
    puts(good ? "calibrated" : "not calibrated: nothing was written");
    return good ? 0 : FAILED;
}
