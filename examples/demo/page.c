/* The page that plays the session in a browser, if what it is bundled from is there. */
#include "demo/observer.h"

#include <stdio.h>

#ifdef DEMO_PAGE
#include "replay_page/recorder.h"

#define RATE 30.0 /* frames in a simulated second */

static recorder recorded = {.rate = RATE, .last = UINT64_MAX};

static bool begin(void *user, stage *s)
{
    (void)user;
    (void)s;
    return true;
}

static bool observe(void *user, stage *s, uint64_t step, double time)
{
    return recorder_watch(user, s, step, time) == VBSS_OK;
}

static bool end(void *user, uint64_t step)
{
    return recorder_end(user, step) == VBSS_OK;
}

static bool write(void *user, const facts *f, const char *path)
{
    return recorder_write(user, f, path);
}

size_t observe_page(observer *into, size_t room, const char *path)
{
    if (room == 0) {
        return 0;
    }
    into[0] = (observer){.what = "replay page",
                         .path = path,
                         .user = &recorded,
                         .begin = begin,
                         .step = observe,
                         .end = end,
                         .write = write};
    return 1;
}

void observe_page_end(void)
{
    recorder_free(&recorded);
}

#else

size_t observe_page(observer *into, size_t room, const char *path)
{
    (void)into;
    (void)room;
    (void)path;
    fprintf(stderr, "No replay page: built without esbuild and three.js (.ci/install-packages "
                    "demo).\n");
    return 0;
}

void observe_page_end(void)
{
}

#endif
