/* A drain as galleries paint it: the slit's edges red, the marks blue. */
#ifndef VBSS_EXAMPLES_DRAIN_PORTRAIT_H
#define VBSS_EXAMPLES_DRAIN_PORTRAIT_H

#include <vblast_ss/drain.h>

#include "painter/painter.h"

painter_result paint_drain(painter *p, vbss_drain *drain);

#endif
