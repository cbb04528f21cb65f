/* Guides a hand through its calibration: asks for a motion, looks at what the device measures, goes on when told to. */
#ifndef VBSS_EXAMPLES_TRAINER_GUIDE_H
#define VBSS_EXAMPLES_TRAINER_GUIDE_H

#include "trainer/calibration.h"

typedef enum guide_step {
    GUIDE_REST,   /* where the hand begins */
    GUIDE_RIGHT,  /* which axis of the device goes to the right, */
    GUIDE_UP,     /* up, */
    GUIDE_TOWARD, /* toward who trains */
    GUIDE_POINT,  /* how the handle sits on the arm */
    GUIDE_REACH,  /* how far the hand gets */
    GUIDE_CLOSE,  /* what the handle's sensor says, closed, */
    GUIDE_OPEN,   /* open */
    GUIDE_DONE
} guide_step;

typedef struct guide {
    guide_step step;
    bool arm, handle;                            /* what there is to calibrate */
    bool seen;                                   /* anything in this step */
    double rest[3], position[3], orientation[4]; /* device's frame */
    double low[3], high[3];
    double raw, closed;
    vbss_device_calibration found;
} guide;

/* The device must be calibrated as guide_plain says, so that it tells what it measures. */
vbss_result guide_plain(vbss_device_calibration *c);
vbss_result guide_begin(guide *g, bool arm, bool handle, const vbss_device_calibration *from);
/* What the hand shall do now. */
const char *guide_ask(const guide *g);
/* A sample. */
void guide_see(guide *g, const vbss_device_input *in);
/* It is done. NULL: on to the next step; else why it must be done again. */
const char *guide_next(guide *g);
/* The middle of what the hand reaches shall be there, m. */
void guide_centre(guide *g, const double middle[3]);

#endif
