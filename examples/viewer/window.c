#include "window.h"

#include <stdio.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

static void tell_error(int code, const char *what)
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
    if (w->known && w->desk != NULL && w->desk->moved != NULL) {
        w->desk->moved(w->desk->user, x - w->x, y - w->y, x, y);
    }
    w->x = x;
    w->y = y;
    w->known = true;
}

static void on_wheel(GLFWwindow *handle, double right, double up)
{
    const window *w = glfwGetWindowUserPointer(handle);
    (void)right;
    if (w->desk != NULL && w->desk->wheeled != NULL) {
        w->desk->wheeled(w->desk->user, up);
    }
}

static void on_button(GLFWwindow *handle, int button, int action, int mods)
{
    const window *w = glfwGetWindowUserPointer(handle);
    (void)mods;
    if (w->desk != NULL && w->desk->pressed != NULL) {
        w->desk->pressed(w->desk->user, button, action == GLFW_PRESS, w->x, w->y);
    }
}

static void on_key(GLFWwindow *handle, int key, int code, int action, int mods)
{
    const window *w = glfwGetWindowUserPointer(handle);
    (void)code;
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

static bool open_window(window *w, int width, int height)
{
    *w = (window){.handle = NULL};
    glfwSetErrorCallback(tell_error);
    if (glfwInit() != GLFW_TRUE) {
        return false;
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    w->handle = glfwCreateWindow(width, height, "vblast_ss", NULL, NULL);
    if (w->handle == NULL) {
        glfwTerminate();
        return false;
    }
    glfwMakeContextCurrent(w->handle);
    glfwSwapInterval(1);
    hear(w);
    return true;
}

static void shut_window(window *w)
{
    glfwDestroyWindow(w->handle);
    glfwTerminate();
}

bool window_begin(window *w, show *s, int width, int height, uint32_t looks)
{
    if (!open_window(w, width, height)) {
        return false;
    }
    if (!show_begin(s, width, height)) {
        shut_window(w);
        return false;
    }
    w->resized = true; /* a screen of many pixels */
    s->looks = looks != 0 ? looks : SHOW_KNOT | SHOW_TASK | SHOW_HELP;
    return true;
}

void window_end(window *w, show *s)
{
    show_end(s);
    shut_window(w);
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
