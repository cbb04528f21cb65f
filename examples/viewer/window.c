#include "window.h"

#include <stdio.h>

#include <epoxy/gl.h>

static void report_error(int code, const char *what)
{
    fprintf(stderr, "viewer: window: %s (%d)\n", what, code);
}

/* ---- what is done in it */

/* A window may have more pixels than the screen's units. */
static void in_pixels(const window *w, double *x, double *y)
{
    int across, down, pixels_across, pixels_down;
    glfwGetWindowSize(w->handle, &across, &down);
    glfwGetFramebufferSize(w->handle, &pixels_across, &pixels_down);
    *x *= across > 0 ? (double)pixels_across / across : 1.0;
    *y *= down > 0 ? (double)pixels_down / down : 1.0;
}

static void on_move(GLFWwindow *handle, double x, double y)
{
    window *w = glfwGetWindowUserPointer(handle);
    in_pixels(w, &x, &y);
    w->moves++;
    if (w->known && w->desk != NULL && w->desk->moved != NULL) {
        w->desk->moved(w->desk->user, x - w->x, y - w->y, x, y);
    }
    w->x = x;
    w->y = y;
    w->known = true;
}

static void on_wheel(GLFWwindow *handle, double right, double up)
{
    window *w = glfwGetWindowUserPointer(handle);
    (void)right;
    w->wheel += up;
    w->moves++;
    if (w->desk != NULL && w->desk->wheeled != NULL) {
        w->desk->wheeled(w->desk->user, up);
    }
}

static void on_button(GLFWwindow *handle, int button, int action, int mods)
{
    window *w = glfwGetWindowUserPointer(handle);
    (void)mods;
    w->events++;
    if (w->desk != NULL && w->desk->pressed != NULL) {
        w->desk->pressed(w->desk->user, button, action == GLFW_PRESS, w->x, w->y);
    }
}

static void on_key(GLFWwindow *handle, int key, int code, int action, int mods)
{
    window *w = glfwGetWindowUserPointer(handle);
    (void)code;
    w->events += action != GLFW_REPEAT;
    if (action != GLFW_RELEASE && w->desk != NULL && w->desk->key != NULL) {
        w->desk->key(w->desk->user, key, (mods & GLFW_MOD_SHIFT) != 0);
    }
}

static void on_size(GLFWwindow *handle, int width, int height)
{
    window *w = glfwGetWindowUserPointer(handle);
    (void)width;
    (void)height;
    w->resized = true;
}

/* ---- made */

static void hear(window *w)
{
    glfwSetWindowUserPointer(w->handle, w);
    glfwSetCursorPosCallback(w->handle, on_move);
    glfwSetScrollCallback(w->handle, on_wheel);
    glfwSetMouseButtonCallback(w->handle, on_button);
    glfwSetKeyCallback(w->handle, on_key);
    glfwSetFramebufferSizeCallback(w->handle, on_size);
}

/* The window belongs to its context: another one of these has another one of those. */
static bool open_window(window *w, int width, int height)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    w->handle = glfwCreateWindow(width, height, "vblast_ss", NULL, NULL);
    if (w->handle == NULL) {
        return false;
    }
    glfwMakeContextCurrent(w->handle);
    glfwSwapInterval(1);
    w->reports_loss = epoxy_has_gl_extension("GL_ARB_robustness");
    w->resized = true; /* a screen of many pixels */
    hear(w);
    return true;
}

static bool begin_glfw(void)
{
    glfwSetErrorCallback(report_error);
    return glfwInit() == GLFW_TRUE;
}

bool window_begin(window *w, show *s, int width, int height, uint32_t overlays)
{
    *w = (window){.handle = NULL};
    if (!begin_glfw()) {
        return false;
    }
    if (!open_window(w, width, height) || !show_begin(s, width, height)) {
        glfwTerminate();
        return false;
    }
    s->overlays = overlays != 0 ? overlays : SHOW_KNOT | SHOW_TASK | SHOW_HELP;
    return true;
}

void window_end(window *w, show *s)
{
    if (w->handle != NULL) { /* NULL: there is no context any more */
        show_end(s);
    }
    glfwTerminate(); /* with the window */
}

/* ---- lost */

static bool is_lost(const window *w)
{
    return w->give_up || (w->reports_loss && glGetGraphicsResetStatusARB() != GL_NO_ERROR);
}

/* At the same place, and the pointer is whose it was. */
static bool renew(window *w, show *s)
{
    int x, y, width, height;
    const bool taken = w->taken;
    glfwGetWindowPos(w->handle, &x, &y);
    glfwGetWindowSize(w->handle, &width, &height);
    show_end(s);
    glfwDestroyWindow(w->handle);
    w->give_up = false;
    w->renewed++;
    fprintf(stderr, "viewer: the graphics context was lost and is made anew\n");
    if (!open_window(w, width, height) || !show_renew(s, width, height)) {
        return false;
    }
    glfwSetWindowPos(w->handle, x, y);
    window_take_pointer(w, taken);
    w->known = taken; /* where the pointer is */
    return true;
}

bool window_ready(window *w, show *s)
{
    return !is_lost(w) || renew(w, s);
}

/* ---- used */

bool window_listen(window *w, const desk *d)
{
    w->desk = d;
    glfwPollEvents();
    return glfwWindowShouldClose(w->handle) == GLFW_FALSE;
}

bool window_show(window *w, show *s)
{
    int width, height;
    glfwGetFramebufferSize(w->handle, &width, &height);
    if (!show_finish(s)) {
        return false;
    }
    lens_show(&s->renderer.lens, width, height);
    bool good = renderer_good();
    glfwSwapBuffers(w->handle);
    if (w->resized && width > 0 && height > 0) { /* 0: it is an icon now */
        w->resized = false;
        good = renderer_resize(&s->renderer, width, height) && good;
    }
    return good;
}

void window_take_pointer(window *w, bool take)
{
    w->taken = take;
    glfwSetInputMode(w->handle, GLFW_CURSOR, take ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    glfwGetCursorPos(w->handle, &w->x, &w->y);
    in_pixels(w, &w->x, &w->y);
}

bool window_pad(window *w, GLFWgamepadstate *state)
{
    const bool had = w->has_pad;
    w->has_pad = false;
    for (int i = GLFW_JOYSTICK_1; i <= GLFW_JOYSTICK_LAST && !w->has_pad; i++) {
        w->has_pad = glfwGetGamepadState(i, state) == GLFW_TRUE;
    }
    w->lost_pad = w->has_pad ? false : had || w->lost_pad;
    return w->has_pad;
}

bool window_is_down(const window *w, int key)
{
    return glfwGetKey(w->handle, key) == GLFW_PRESS;
}

void window_close(window *w)
{
    glfwSetWindowShouldClose(w->handle, GLFW_TRUE);
}

double window_clock(void)
{
    return glfwGetTime();
}
