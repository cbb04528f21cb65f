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
    const bool mirrored = t->site.rig.mirrored;
    const pose needle = site_needle(&t->site);
    TRY(vbss_session_get_status(session, &status, sizeof status));
    seen->phase = status.phase;
    v_store(seen->scene.needle, mirror_vec(mirrored, needle.at));
    mirror_needle(mirrored, needle.q, seen->scene.needle + 3);
    for (int side = 0; side < 2; side++) {
        const vec mark = site_mark(&t->site, mirror_side(mirrored, side));
        v_store(seen->scene.marks[side], mirror_vec(mirrored, mark));
        TRY(observe_tool(stitch_hand(t, side)->grasper, seen->tips[side], &tools[side]));
    }
    return VBSS_OK;
}
