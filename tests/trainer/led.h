/* The trainer with stand-ins of two arms and two handles, whose hands are led through what a surgeon told his tools. */
#ifndef VBSS_TESTS_TRAINER_LED_H
#define VBSS_TESTS_TRAINER_LED_H

#include <vblast_ss/session.h>

#include "trainer/figures.h"

enum { LED_SLOTS = 120000 };

typedef struct led {
    figures now;
    vbss_session_status status;
    uint32_t tied;   /* most throws that were tied at a time */
    uint32_t shears; /* tools that are shears in the end */
    int illegal;
    char first[160];         /* of the illegal calls */
    double times[LED_SLOTS]; /* thread CPU time of each slot, s */
} led;

/* The task by that surgeon, into a log. (led_log.c) */
bool led_write_log(uint64_t seed, const char *path);
/* False: it does not run, `why` says what is wrong. */
bool led_run(const char *log, led *found, char *why, size_t bytes);

#endif
