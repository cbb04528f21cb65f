#include "ghost/observe.h"

#include <string.h>

static vbss_result observe_tool(vbss_grasper *grasper, double tip[3], ghost_pose *p)
{
    vbss_grasper_state now;
    TRY(vbss_grasper_get_state(grasper, &now, sizeof now));
    memcpy(tip, now.position, sizeof now.position);
    memcpy(p->position, now.position, sizeof now.position);
    memcpy(p->orientation, now.orientation, sizeof now.orientation);
    p->opening = now.opening;
    p->kind = now.kind;
    return VBSS_OK;
}

vbss_result ghost_observe(const stitch *t, vbss_session *session, ghost_seen *seen,
                          ghost_pose tools[GHOST_SIDES])
{
    vbss_session_status status;
    const pose needle = site_needle(&t->site);
    TRY(vbss_session_get_status(session, &status, sizeof status));
    seen->phase = status.phase;
    v_store(seen->scene.needle, needle.at);
    memcpy(seen->scene.needle + 3, needle.q, sizeof needle.q);
    v_store(seen->scene.marks[0], site_mark(&t->site, SITE_LEFT));
    v_store(seen->scene.marks[1], site_mark(&t->site, SITE_RIGHT));
    TRY(observe_tool(t->left.grasper, seen->tips[0], &tools[0]));
    return observe_tool(t->right.grasper, seen->tips[1], &tools[1]);
}
