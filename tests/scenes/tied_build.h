/* What a tied knot begins with: the line, the rods, the nodes that will be taken. For tied_knot.c. */
#ifndef VBSS_TESTS_SCENES_TIED_BUILD_H
#define VBSS_TESTS_SCENES_TIED_BUILD_H

#include "scenes/tied_knot.h"

/* Thread and scene, with all that stands in it; nobody holds anything yet. */
vbss_result tied_build(vbss_context *context, tied_knot *knot);

/* Limb k goes from its end, the first node or the last, inward to the loop. */
static inline uint32_t end_node(const tied_knot *knot, int k)
{
    return k == 0 ? 0 : knot->node_count - 1;
}

static inline uint32_t next_node(int k, uint32_t node, bool inward)
{
    return (k == 0) == inward ? node + 1 : node - 1;
}

#endif
