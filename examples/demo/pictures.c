/* A film and stills through the laparoscope, if OpenGL is there. */
#include "demo/observer.h"

#include <stdio.h>

#ifdef DEMO_PICTURES
#include "viewer/headless.h"
#include "viewer/shots.h"

#define FILM_EVERY 0.2   /* s simulated: at 30 pictures a second the film is six times as fast */
#define STILLS_EVERY 4.0 /* s simulated */

enum { FILM, STILLS, KINDS };

static headless gl;
static shots taken[KINDS];
static bool drawing;

static bool begin(void *user, stage *s)
{
    return shots_begin(user, s);
}

static bool observe(void *user, stage *s, uint64_t step, double time)
{
    (void)s;
    (void)step;
    return shots_step(user, time);
}

static bool finish(void *user, uint64_t step)
{
    (void)step;
    return shots_finish(user);
}

size_t observe_pictures(observer *into, size_t room, const char *film, const char *folder)
{
    const shots_plan plans[KINDS] = {
        {.film = film, .every = FILM_EVERY, .width = 480, .height = 360},
        {.folder = folder, .every = STILLS_EVERY, .width = 640, .height = 480}};
    static const char *const names[KINDS] = {"film", "stills"};
    size_t count = 0;
    drawing = headless_begin(&gl);
    if (!drawing) {
        fprintf(stderr, "No film and no stills: OpenGL 3.3 is missing here.\n");
    } else if (!movie_possible()) {
        fprintf(stderr, "No film: ffmpeg is missing here (.ci/install-packages demo).\n");
    }
    for (int i = 0; drawing && i < KINDS && count < room; i++) {
        if (i == FILM && !movie_possible()) {
            continue;
        }
        if (shots_open(&taken[i], &plans[i])) {
            into[count++] = (observer){.what = names[i],
                                       .path = i == FILM ? film : folder,
                                       .user = &taken[i],
                                       .begin = begin,
                                       .step = observe,
                                       .end = finish};
        }
    }
    return count;
}

void observe_pictures_end(void)
{
    for (int i = 0; drawing && i < KINDS; i++) {
        (void)shots_finish(&taken[i]);
        shots_close(&taken[i]);
    }
    headless_end(&gl);
}

#else

size_t observe_pictures(observer *into, size_t room, const char *film, const char *folder)
{
    (void)into;
    (void)room;
    (void)film;
    (void)folder;
    fprintf(stderr, "No film and no stills: built without OpenGL (.ci/install-packages demo).\n");
    return 0;
}

void observe_pictures_end(void)
{
}

#endif
