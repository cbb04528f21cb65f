/* A needle in the jaws of a free tool: how it is taken, and how a hand moves it by looking at it. */
#ifndef VBSS_EXAMPLES_NEEDLE_HOLD_H
#define VBSS_EXAMPLES_NEEDLE_HOLD_H

#include "needle/site.h"

/* What the tool was told. */
pose hold_reported(const hand *h);
void hold_go(hand *h, const pose *p, double speed);
/* Of the tool when it holds the needle that far from its tip, so far behind its own, in the needle's frame: it comes
 * against the needle's axis, leaning from that toward `up`, an angle in the needle's plane. */
pose hold_grip(const site *s, double arc_length, double behind, double lean, double up);
/* The needle in the frame of what the tool was told, as it is seen, a little late: with what gives way between. */
void hold_see(pose *held, const hand *h, const site *s, double dt);
/* So that the needle comes there. */
void hold_steer(hand *h, const pose *held, const pose *needle, double speed);
/* From there to where it is: of the centre, and of the arc by what it is turned. */
double hold_off(const site *s, const pose *needle);

#endif
