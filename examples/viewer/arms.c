#include "arms.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "trainer/hardware.h"

enum { MAX_WORDS = 32 };

struct arms {
    options options;
    calibration calibration;
    score log;
    hardware hardware;
    double begun; /* s, of the system's clock */
};

static double system_clock(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool has_log(const arms *a)
{
    return a->log.count > 0;
}

static bool has_hardware(const arms *a)
{
    return a->options.arm_count > 0 || a->options.handle_count > 0;
}

/* ---- what is wanted */

static bool refuse(const char *what, const char *why)
{
    fprintf(stderr, "viewer: %s: %s\n", what, why);
    return false;
}

static bool knows_faults(const options *o)
{
    for (uint32_t i = 0; i < o->fault_count; i++) {
        if (rehearsal_fault(o->faults[i].name) == NULL) {
            return refuse(o->faults[i].name, "no such fault");
        }
    }
    return true;
}

/* A hand without a device is the mouse's, so that the trainer's question who moves it is answered. */
static bool read_words(arms *a, int count, char **words)
{
    static char none[] = "viewer", scripted[] = "--mock";
    char *all[MAX_WORDS + 2] = {none, scripted}, why[256];
    if (count > MAX_WORDS) {
        return refuse("devices", "too many words");
    }
    for (int i = 0; i < count; i++) {
        all[2 + i] = words[i];
    }
    return options_read(count + 2, all, &a->options, why, sizeof why) || refuse("devices", why);
}

static bool read_files(arms *a, const char *log)
{
    const char *file = a->options.calibration;
    char why[256];
    if (calibration_init(&a->calibration) != VBSS_OK) {
        return refuse("calibration", "not there");
    }
    if (file != NULL && !calibration_read(&a->calibration, file, why, sizeof why)) {
        return refuse(file, why);
    }
    return log == NULL || score_read(&a->log, log, why, sizeof why) || refuse(log, why);
}

arms *arms_read(int count, char **words, const char *log)
{
    arms *a = calloc(1, sizeof *a);
    if (a == NULL) {
        return NULL;
    }
    if (!read_words(a, count, words) || !knows_faults(&a->options) || !read_files(a, log)) {
        arms_free(a);
        return NULL;
    }
    return a;
}

void arms_free(arms *a)
{
    if (a != NULL) {
        score_free(&a->log);
        free(a);
    }
}

/* ---- used */

bool arms_open(arms *a)
{
    char why[512];
    a->begun = system_clock();
    return hardware_open(&a->hardware, &a->options, &a->calibration, NULL,
                         has_log(a) ? &a->log : NULL, why, sizeof why) ||
           refuse("devices", why);
}

void arms_shut(arms *a)
{
    hardware_close(&a->hardware);
}

vbss_device *arms_device(const arms *a, int side)
{
    return has_log(a) || a->hardware.arm[side] ? a->hardware.devices[side] : NULL;
}

const char *arms_name(const arms *a, int side)
{
    return a->hardware.names[side];
}

double arms_clock(const arms *a, double simulated)
{
    return has_hardware(a) ? system_clock() - a->begun : simulated;
}

void arms_explain(const arms *a, int side, char *text, size_t bytes)
{
    hardware_explain(&a->hardware, side, text, bytes);
}
