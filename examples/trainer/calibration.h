/* What the guide found, in a small text file: a line a fact, `left.axes 1 -3 2`. */
#ifndef VBSS_EXAMPLES_TRAINER_CALIBRATION_H
#define VBSS_EXAMPLES_TRAINER_CALIBRATION_H

#include <vblast_ss/device.h>

#include "trainer/options.h"

typedef struct calibration {
    bool known[HANDS];
    vbss_device_calibration hands[HANDS];
} calibration;

/* As it is where nothing is known: arms as their vendor turns them, handles from 0 V closed to 1 V open. */
vbss_result calibration_init(calibration *c);
bool calibration_write(const calibration *c, const char *path);
/* All facts of a hand or none. False: `why` says what is wrong, and in which line; nothing was changed. */
bool calibration_read(calibration *c, const char *path, char *why, size_t bytes);

#endif
