/* Hands by devices: arms and handles as the trainer has them, or a mock that does what a log's hands did. */
#ifndef VBSS_EXAMPLES_VIEWER_ARMS_H
#define VBSS_EXAMPLES_VIEWER_ARMS_H

#include <stdbool.h>
#include <stddef.h>

#include <vblast_ss/device.h>

typedef struct arms arms;

/* The trainer's words (--openhaptics, --nidaq, --calibration, --fault, ...), and a log whose hands move what has no arm; NULL:
 * none. NULL, told on standard error: they are not understood, or a file cannot be read. */
arms *arms_read(int count, char **words, const char *log);
void arms_free(arms *a);
/* For a session. False, told: something is not there. */
bool arms_open(arms *a);
/* Outputs off. */
void arms_shut(arms *a);
/* NULL: that hand has none. */
vbss_device *arms_device(const arms *a, int side);
const char *arms_name(const arms *a, int side);
/* Of the devices: real hardware has real time, a log that of the scene. */
double arms_clock(const arms *a, double simulated);
/* What hardware said last of what is wrong; empty: nothing. */
void arms_explain(const arms *a, int side, char *text, size_t bytes);

#endif
