/* From hand to tool and back, as with a real one: a device measures the hand, the tool is told what the device
 * says, and what the tool feels goes out through the device. */
#ifndef VBSS_EXAMPLES_THROW_WIRE_H
#define VBSS_EXAMPLES_THROW_WIRE_H

#include "throw/hand.h"

/* The tool, with its tip where the hand is. */
vbss_result wire_create(hand *h);
vbss_result wire_report(hand *h);
vbss_result wire_feel(hand *h, const vbss_grasper_state *state);

#endif
