/* Threads wound about one of two tools of two capsules: what each step looks at. */
#ifndef VBSS_BENCH_KNOTS_WOUND_H
#define VBSS_BENCH_KNOTS_WOUND_H

#include <vblast_ss/knot.h>

/* All alike but for where they lie; kept until the end. NULL: no memory. */
const vbss_knot_input *wound_inputs(uint32_t segments, uint32_t count);
void wound_end(void);

#endif
