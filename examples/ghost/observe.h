/* What ghost hands see of a scene and its session. */
#ifndef VBSS_EXAMPLES_GHOST_OBSERVE_H
#define VBSS_EXAMPLES_GHOST_OBSERVE_H

#include "ghost/ghost.h"
#include "needle/stitch.h"

/* Both tools as they are. */
vbss_result ghost_observe(const stitch *t, vbss_session *session, ghost_seen *seen,
                          ghost_pose tools[GHOST_SIDES]);

#endif
