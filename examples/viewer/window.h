/* A window with OpenGL 3.3, and what a person does in it, told as it happens. */
#ifndef VBSS_EXAMPLES_VIEWER_WINDOW_H
#define VBSS_EXAMPLES_VIEWER_WINDOW_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "show.h"

/* Who is told; places are in pixels of the picture from its upper left corner. Any may be NULL. */
typedef struct desk {
    void *user;
    void (*moved)(void *user, double right, double down, double x, double y);
    void (*wheeled)(void *user, double notches);
    void (*pressed)(void *user, int button, bool down, double x, double y);
    void (*key)(void *user, int key, bool shift); /* pressed, or repeated */
} desk;

typedef struct tick_window {
    void *handle; /* of GLFW */
    const desk *desk;
    double x, y;       /* of the pointer */
    bool known;        /* where it is */
    bool taken;        /* the pointer is the window's: it moves hands, and is not seen */
    bool resized;      /* since the last picture */
    uint64_t moves;    /* of mouse and wheel that came */
    double wheel;      /* notches that came, since the beginning, away */
    uint64_t events;   /* keys and buttons that went down or up */
    bool reports_loss; /* OpenGL tells whether its context is lost */
    bool give_up;      /* the context counts as lost */
    unsigned renewed;
    bool has_pad, lost_pad; /* a gamepad is there; was, and is no more */
} window;

/* A window and what is shown in it. False, told on standard error: there is no screen, or no OpenGL. */
bool window_begin(window *w, show *s, int width, int height, uint32_t overlays);
void window_end(window *w, show *s);
/* Tells the desk what was done; false: the window shall be closed. */
bool window_listen(window *w, const desk *d);
/* Before a picture: a context that is lost (a driver that began anew) is made anew, with all that is in it. False, told: it
 * cannot be. */
bool window_ready(window *w, show *s);
/* The picture; in its size, when that has changed. False, told: OpenGL failed. */
bool window_show(window *w, show *s);
void window_take_pointer(window *w, bool take);
bool window_is_down(const window *w, int key);
/* The first gamepad there is; false: none. */
bool window_pad(window *w, GLFWgamepadstate *state);
void window_close(window *w);
/* s, of a clock that goes on. */
double window_clock(void);

#endif
