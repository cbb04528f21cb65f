/* Who looks at a session while its steps are made, and makes a file of it. */
#ifndef VBSS_EXAMPLES_DEMO_OBSERVER_H
#define VBSS_EXAMPLES_DEMO_OBSERVER_H

#include "report/stage.h"

/* The functions return false when they fail, and say why on standard error. */
typedef struct observer {
    const char *what; /* what it makes, in words */
    const char *path; /* where */
    void *user;       /* handed to its functions */
    bool (*begin)(void *user, stage *s);
    /* Before the first step (0) and after each one; `time` in s. */
    bool (*step)(void *user, stage *s, uint64_t step, double time);
    /* After the last step, while the scene is still there. */
    bool (*end)(void *user, uint64_t step);
    /* When all is known of the session; may be NULL. */
    bool (*write)(void *user, const facts *f, const char *path);
    bool failed; /* it is not called again, and the others go on */
} observer;

/* Each gives the observers that can be had here, at most `room`, and how many; what is missing is told on standard error. */
/* pictures.c: a film and stills, by OpenGL. */
size_t observe_pictures(observer *into, size_t room, const char *film, const char *folder);
void observe_pictures_end(void);
/* page.c: a page that plays the session. */
size_t observe_page(observer *into, size_t room, const char *path);
void observe_page_end(void);

#endif
