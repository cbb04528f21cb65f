/* Guides somebody in front of the terminal through the calibration; where the hardware is a stand-in, its hands obey. */
#ifndef VBSS_EXAMPLES_TRAINER_COACH_H
#define VBSS_EXAMPLES_TRAINER_COACH_H

#include "trainer/calibration.h"
#include "trainer/rehearsal.h"
#include "trainer/stage.h"

/* 0, or what the program ends with; `c` is written to the options' file. */
int coach_run(const options *o, calibration *c, rehearsal *r, const stage *s);

#endif
