/* Ghost hands in the page. */
#include <stdlib.h>

#include "ghost/observe.h"
#include "page.h"
#include "session.h"

static ghost_track track;

int32_t page_take_ghost(void)
{
    const replay_log given = page_take_room();
    ghost_track read;
    const bool good = ghost_track_parse(&read, given.data, given.count);
    free(given.data);
    if (!good) {
        return VBSS_ERROR_CORRUPT;
    }
    ghost_track_free(&track);
    track = read;
    return VBSS_OK;
}

/* Those of a session that has begun a moment ago. */
static vbss_result create(page_session *p)
{
    const stage *s = &p->live.stage;
    const vbss_grasper_config shapes[GHOST_SIDES] = {s->tasked->left.shape, s->tasked->right.shape};
    TRY(ghost_create(&p->ghost, &track, s->context, shapes, p->visual));
    p->has_ghost = true;
    return VBSS_OK;
}

int32_t page_show_ghost(int32_t is_shown)
{
    page_session *p = page_get();
    if (!p->there || p->plays || p->live.stage.task.session == NULL || track.count == 0) {
        return VBSS_ERROR_WRONG_STATE;
    }
    if (!p->has_ghost) {
        TRY(create(p));
    }
    p->shows_ghost = is_shown != 0;
    ghost_again(&p->ghost);
    return ghost_hide(&p->ghost);
}

uint32_t page_ghost(void)
{
    return page_get()->has_ghost ? page_get()->ghost.source : 0;
}

vbss_result page_step_ghost(page_session *p, double seconds)
{
    ghost_seen seen;
    ghost_pose tools[GHOST_SIDES];
    if (!p->shows_ghost || !(seconds > 0.0)) {
        return VBSS_OK;
    }
    TRY(ghost_observe(p->live.stage.tasked, p->live.stage.task.session, &seen, tools));
    return ghost_step(&p->ghost, &seen, seconds);
}
