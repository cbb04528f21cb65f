/* Drain, needle, thread, floor and both tools, for a painter. */
#ifndef VBSS_EXAMPLES_NEEDLE_SHOW_H
#define VBSS_EXAMPLES_NEEDLE_SHOW_H

#include "needle/stitch.h"
#include "painter/painter.h"

bool show_add(painter *p, const stitch *t);

#endif
