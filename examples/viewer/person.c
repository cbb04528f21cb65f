/* What a person does with mouse, keys and gamepad. */
#include <math.h>

#include "playing.h"

#define FINE 0.25       /* of a movement, with shift */
#define KEY_METRES 0.03 /* a second */

mouse_hand *person_hand(playing *p)
{
    return &p->live.hands[p->live.active];
}

/* ---- as it happens */

static double grain(const playing *p)
{
    return window_is_down(&p->window, GLFW_KEY_LEFT_SHIFT) ? FINE : 1.0;
}

static bool is_turning(const playing *p)
{
    return glfwGetMouseButton(p->window.handle, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
}

static void on_moved(void *user, double right, double down, double x, double y)
{
    playing *p = user;
    (void)x;
    (void)y;
    if (p->window.taken) {
        const double g = grain(p);
        p->motion[0] += right;
        p->motion[1] += down;
        mouse_hand_move(person_hand(p), is_turning(p), g * right, -g * down, 0.0);
    }
}

static void on_wheeled(void *user, double notches)
{
    playing *p = user;
    mouse_hand_move(person_hand(p), is_turning(p), 0.0, 0.0, grain(p) * notches);
}

static void close_or_open(playing *p)
{
    person_hand(p)->closes = !person_hand(p)->closes;
}

static void take_other(playing *p)
{
    const int other = p->live.active == LEFT ? RIGHT : LEFT;
    if (!live_by_device(&p->live, other)) {
        p->live.active = other;
    }
}

/* Emergency stops: a cause that is still there stops again. */
static void release(playing *p)
{
    for (int side = 0; side < SIDES; side++) {
        if (live_by_device(&p->live, side)) {
            (void)vbss_device_clear_emergency_stop(arms_device(p->arms, side));
        }
    }
}

static void on_pressed(void *user, int button, bool down, double x, double y)
{
    playing *p = user;
    (void)x;
    (void)y;
    if (down && !p->window.taken) {
        window_take_pointer(&p->window, true);
    } else if (down && button == GLFW_MOUSE_BUTTON_LEFT) {
        close_or_open(p);
    }
}

static void on_key(void *user, int key, bool shift)
{
    playing *p = user;
    (void)shift;
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_6) {
        p->show.overlays ^= 1U << (key - GLFW_KEY_1);
    } else if (key == GLFW_KEY_7 || key == GLFW_KEY_C) {
        p->show.overlays ^= SHOW_COACH;
    } else if (key == GLFW_KEY_F1 || key == GLFW_KEY_H) {
        p->show.overlays ^= SHOW_HELP;
    } else if (key >= GLFW_KEY_F2 && key <= GLFW_KEY_F8) {
        (void)live_toggle_aid(&p->live, 1U << (key - GLFW_KEY_F2));
    } else if (key == GLFW_KEY_X) {
        (void)live_exchange(&p->live, p->live.active); /* refused with something in the jaws */
    } else if (key == GLFW_KEY_G) {
        ghosts_toggle(p);
    } else if (key == GLFW_KEY_TAB) {
        take_other(p);
    } else if (key == GLFW_KEY_P) {
        p->paused = !p->paused;
    } else if (key == GLFW_KEY_PERIOD) {
        p->once = p->paused;
    } else if (key == GLFW_KEY_ENTER) {
        release(p);
    } else if (key == GLFW_KEY_R) {
        p->again = true;
    } else if (key == GLFW_KEY_ESCAPE) {
        if (p->window.taken) {
            window_take_pointer(&p->window, false);
        } else {
            window_close(&p->window);
        }
    }
}

desk person_desk(playing *p)
{
    return (desk){p, on_moved, on_wheeled, on_pressed, on_key};
}

/* ---- as long as it is held */

/* Keys shift as the mouse does, in its counts. */
static void move_by_keys(playing *p, double seconds)
{
    const window *w = &p->window;
    const double counts = grain(p) * KEY_METRES * seconds / person_hand(p)->mapping.mouse_metres;
    const double notches = grain(p) * KEY_METRES * seconds / person_hand(p)->mapping.mouse_depth;
    const double right = window_is_down(w, GLFW_KEY_D) - window_is_down(w, GLFW_KEY_A);
    const double up = window_is_down(w, GLFW_KEY_W) - window_is_down(w, GLFW_KEY_S);
    const double away = window_is_down(w, GLFW_KEY_E) - window_is_down(w, GLFW_KEY_Q);
    mouse_hand_move(person_hand(p), false, counts * right, counts * up, notches * away);
}

static vbss_result clutch(playing *p)
{
    const bool held = window_is_down(&p->window, GLFW_KEY_SPACE) ||
                      glfwGetMouseButton(p->window.handle, GLFW_MOUSE_BUTTON_MIDDLE) == GLFW_PRESS;
    for (int side = 0; side < SIDES; side++) {
        TRY(mouse_hand_clutch(&p->live.hands[side], held && side == p->live.active));
    }
    return VBSS_OK;
}

static void move_by_pad(playing *p)
{
    GLFWgamepadstate state;
    const bool there = window_pad(&p->window, &state);
    const pad_wish w = pad_read(&p->pad, there ? &state : NULL);
    if ((w.pressed & PAD_JAWS) != 0) {
        close_or_open(p);
    }
    if ((w.pressed & PAD_OTHER) != 0) {
        take_other(p);
    }
    if ((w.pressed & PAD_PAUSE) != 0) {
        p->paused = !p->paused;
    }
    if ((w.pressed & PAD_HELP) != 0) {
        p->show.overlays ^= SHOW_HELP;
    }
    for (int side = 0; side < SIDES; side++) {
        static const double nothing[6];
        mouse_hand_pull(&p->live.hands[side], side == p->live.active ? w.axes : nothing,
                        w.fine ? FINE : 1.0);
    }
}

vbss_result person_pull(playing *p, double seconds)
{
    move_by_keys(p, seconds);
    move_by_pad(p);
    return clutch(p);
}
