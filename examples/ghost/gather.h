/* A track of ghost hands while an expert works, or while the log of one is replayed. */
#ifndef VBSS_EXAMPLES_GHOST_GATHER_H
#define VBSS_EXAMPLES_GHOST_GATHER_H

#include "ghost/observe.h"

/* Every row, and what the scene was like then. */
typedef struct ghost_rows {
    ghost_track all;
    ghost_seen *seen; /* one a row */
} ghost_rows;

/* To be called every GHOST_INTERVAL. */
vbss_result ghost_gather(ghost_rows *g, const stitch *t, vbss_session *session);
/* Of a phase that was left and begun again, the longest part without a break. False: there is no memory, or no phase. The rows are
 * freed. */
bool ghost_finish(ghost_rows *g, ghost_track *t);
void ghost_rows_free(ghost_rows *g);

#endif
