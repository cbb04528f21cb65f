/* The devices of both hands, from what the options name: arms, handles' lines, a log, a script. */
#ifndef VBSS_EXAMPLES_TRAINER_HARDWARE_H
#define VBSS_EXAMPLES_TRAINER_HARDWARE_H

#include <vblast_ss/haptics.h>
#include <vblast_ss/mock.h>

#include "trainer/calibration.h"
#include "trainer/hands.h"
#include "trainer/rehearsal.h"

typedef struct hardware {
    vbss_context *context; /* of the devices alone; the scene has its own */
    vbss_openhaptics *openhaptics;
    vbss_nidaqmx *nidaqmx;
    vbss_mock *mocks[HANDS];
    vbss_device *devices[HANDS];
    follower followers[HANDS];
    bool arm[HANDS], handle[HANDS];
    char names[HANDS][96]; /* for the screen */
} hardware;

/* False: `why` says what is not there; nothing is open then. `simulated`: lines are pumped by the caller. */
bool hardware_open(hardware *h, const options *o, const calibration *c, const stage *s,
                   const score *log, char *why, size_t bytes);
/* What the vendor's libraries said last of a hand's arm and of the lines; empty: nothing. */
void hardware_explain(const hardware *h, int side, char *text, size_t bytes);
/* Outputs off, all closed. */
void hardware_close(hardware *h);
/* Tells on stdout what there is. False: something asked for is not there. */
bool hardware_list(const options *o);

#endif
