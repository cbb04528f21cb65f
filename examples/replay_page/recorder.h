/* Records the frames of a replay page while a session's steps are made, and writes the page. */
#ifndef VBSS_EXAMPLES_REPLAY_PAGE_RECORDER_H
#define VBSS_EXAMPLES_REPLAY_PAGE_RECORDER_H

#include "replay_page/film.h"
#include "report/stage.h"

typedef struct recorder {
    vbss_visual *visual;
    film film;
    uint64_t *steps; /* of the frames */
    size_t room;
    double rate; /* frames in a simulated second */
    uint64_t
        last; /* step of which there is a frame in any case; UINT64_MAX: not known before the end */
} recorder;

/* An again_watch. Frame n is of the first step at or after n / rate. */
vbss_result recorder_watch(void *user, struct stage *s, uint64_t step, double time);
/* After the last step, of which it takes a frame, where `last` was not known. */
vbss_result recorder_end(recorder *c, uint64_t step);
/* False: the page cannot be written. */
bool recorder_write(const recorder *c, const facts *f, const char *to);
/* Bytes of the player in each page. */
size_t recorder_player_size(void);
void recorder_free(recorder *c);

#endif
