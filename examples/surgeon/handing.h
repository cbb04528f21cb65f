/* One hand takes the needle that the other holds; one lets it go. */
#ifndef VBSS_EXAMPLES_SURGEON_HANDING_H
#define VBSS_EXAMPLES_SURGEON_HANDING_H

#include "needle/hold.h"

typedef enum handing_part {
    HANDING_BEFORE, /* open jaws come to before it */
    HANDING_ONTO,   /* one on either side */
    HANDING_CLOSE
} handing_part;

typedef enum handing_result { HANDING_GOES_ON, HANDING_NEXT, HANDING_HELD } handing_result;

/* Jaws across the needle at that length from its tip; `since`: s in this part. */
handing_result handing_take(const site *s, hand *h, double arc_length, handing_part part,
                            double since);
/* The needle in the frame of what its bearer was told. */
pose handing_held(const site *s, const hand *h);
/* Opens, goes back along itself, then to where it waits; true: it is off the needle. `back` is kept for the next step. */
bool handing_leave(hand *h, double since, pose *back, vec park);

#endif
