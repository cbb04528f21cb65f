/* An expert's tools beside the person's. */
#include <stdio.h>

#include "ghost/observe.h"
#include "playing.h"

bool ghosts_read(playing *p)
{
    char why[300];
    const bool good =
        p->o->ghost == NULL || ghost_track_read(&p->track, p->o->ghost, why, sizeof why);
    if (!good) {
        fprintf(stderr, "viewer: %s\n", why);
    }
    return good;
}

vbss_result ghosts_begin(playing *p)
{
    const stage *s = &p->live.stage;
    p->has_ghost = p->track.count > 0 && s->tasked != NULL && s->task.session != NULL;
    if (!p->has_ghost) {
        return VBSS_OK;
    }
    const vbss_grasper_config shapes[GHOST_SIDES] = {s->tasked->left.shape, s->tasked->right.shape};
    return ghost_create(&p->ghost, &p->track, s->context, shapes, p->show.visual);
}

vbss_result ghosts_step(playing *p, double seconds)
{
    ghost_seen seen;
    ghost_pose tools[GHOST_SIDES];
    if (!p->has_ghost || p->hides_ghost || !(seconds > 0.0)) {
        return VBSS_OK;
    }
    TRY(ghost_observe(p->live.stage.tasked, p->live.stage.task.session, &seen, tools));
    TRY(ghost_step(&p->ghost, &seen, seconds));
    p->show.renderer.ghost = p->ghost.source;
    return VBSS_OK;
}

void ghosts_toggle(playing *p)
{
    if (p->has_ghost) {
        p->hides_ghost = !p->hides_ghost;
        ghost_again(&p->ghost);
        (void)ghost_hide(&p->ghost);
    }
}
