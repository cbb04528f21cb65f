/* The script of the hands, by the clock. */
#ifndef VBSS_EXAMPLES_SEWING_SCRIPT_H
#define VBSS_EXAMPLES_SEWING_SCRIPT_H

#include "sewing.h"

/* Of the needle's circle, whose angles go in the sense of its path: down at the left, up at the right. */
#define SCRIPT_CENTRE vec3_make(0.0, 4e-3, 0.0)

/* Where hands and needle begin. */
void script_begin(sewing *s);

#endif
