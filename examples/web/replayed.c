/* A saved log in the page: its scene is made once more, its inputs take the hands' place, and each step is compared with it. */
#include <stdlib.h>
#include <string.h>

#include "page.h"
#include "session.h"

static replay_log room;

uint8_t *page_room(uint32_t bytes)
{
    free(room.data);
    room = (replay_log){malloc(bytes > 0 ? bytes : 1), bytes};
    return room.data;
}

/* Chosen by the bodies of the stage: a log of the scripted surgeon has a note of another form. */
static const live_scene *scene_of(const stage *s)
{
    return live_find(s->tasked != NULL ? "stitch" : s->drain != NULL ? "needle" : "throw");
}

replay_log page_take_room(void)
{
    const replay_log given = room;
    room = (replay_log){NULL, 0};
    return given;
}

int32_t page_replay(void)
{
    page_session *p = page_get();
    const replay_log log = page_take_room();
    page_clear(p);
    p->plays = true;
    const bool good = log.data != NULL && player_take(&p->player, log, "the log");
    p->live.scene = scene_of(&p->player.stage);
    return page_complete(p, good ? VBSS_OK : VBSS_ERROR_CORRUPT);
}

vbss_result page_play(page_session *p, int32_t count)
{
    for (int32_t i = 0; i < count && player_step(&p->player); i++) {
    }
    return VBSS_OK; /* what differs is in the state */
}

int32_t page_seek(uint32_t step)
{
    page_session *p = page_get();
    if (!p->there || !p->plays) {
        return VBSS_ERROR_WRONG_STATE;
    }
    p->reported = 0; /* events are reported again, from the first one that is kept */
    return player_seek(&p->player, step) ? VBSS_OK : VBSS_ERROR_OUT_OF_RANGE;
}
