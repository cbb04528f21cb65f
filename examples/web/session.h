/* What the files of the page's module share. */
#ifndef VBSS_EXAMPLES_WEB_SESSION_H
#define VBSS_EXAMPLES_WEB_SESSION_H

#include "ghost/ghost.h"
#include "viewer/camera.h"
#include "viewer/live.h"
#include "viewer/player.h"

#define PAGE_LOG "log.vbss"

typedef struct page_session {
    bool there;
    bool plays; /* a log: `player`, else `live` */
    live live;
    player player;
    vbss_result (*script)(void); /* makes a step in place of live_step; NULL: live_step makes it */
    vbss_visual *visual;
    camera camera;
    float aspect;
    uint64_t reported; /* events of the session */
    ghost ghost;       /* an expert's tools, if `has_ghost` */
    bool has_ghost, shows_ghost;
    double ghost_time; /* of the scene, s, when they moved last */
} page_session;

page_session *page_get(void);
/* Of what there is: the hands' or the log's. (page.c) */
stage *page_stage(page_session *p);
/* Ends the session, if there is one. (page.c) */
void page_clear(page_session *p);
/* After p->live was made, with what came of that: its picture. If anything failed, nothing is there. (page.c) */
vbss_result page_complete(page_session *p, vbss_result made);
/* Gives a hand back to the mouse, which begins where the tool is. (page.c) */
vbss_result page_take_mouse(page_session *p, int side);
/* Steps of a log, until it ends. (replayed.c) */
vbss_result page_play(page_session *p, int32_t count);
/* What page_room has received, which is the caller's now. (replayed.c) */
replay_log page_take_room(void);
/* Moves the ghost hands, if they are shown. (ghosts.c) */
vbss_result page_step_ghost(page_session *p, double seconds);
/* The arms of live.h. (tracked.c) */
arms *tracked_arms(void);
/* The next session has no controllers yet. (tracked.c) */
void tracked_reset(void);
/* What a controller of that hand shall make felt, N; 0: none has it. (tracked.c) */
double tracked_force(int side);

#endif
