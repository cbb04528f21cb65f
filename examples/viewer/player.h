/* A session's log, played back: forward, and to any step of it. */
#ifndef VBSS_EXAMPLES_VIEWER_PLAYER_H
#define VBSS_EXAMPLES_VIEWER_PLAYER_H

#include "report/stage.h"
#include "throw/replay.h"

typedef struct player {
    stage stage;
    vbss_replay *replay;
    replay_log log;
    uint64_t steps; /* that the log has, and are whole */
    double length;  /* of them together, s */
    uint64_t step;  /* after which it is */
    double begin;   /* of the log, in time of the scene, s: not 0 if a state was restored */
    double time;    /* since then, s */
    bool whole;     /* the log has an end */
    bool differs;   /* the last step was not as it was recorded */
    bool jumped;    /* which thread is tied is not known then, if it was cut */
} player;

/* False, told on standard error. In either case it is to be closed. */
bool player_open(player *p, const char *path);
/* Takes a log that was read, and frees it later. Messages of failure contain the name. */
bool player_take(player *p, replay_log log, const char *name);
void player_close(player *p);
/* False: there is no such step, or it is not as it was; the latter is told. */
bool player_step(player *p);
/* To after that step, by the nearest state in the log before it. False: as player_step. */
bool player_seek(player *p, uint64_t step);

#endif
