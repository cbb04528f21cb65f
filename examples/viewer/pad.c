#include "pad.h"

#include <stddef.h>

/* A trigger goes from -1 to 1; it is drawn from here on, and let go from there. */
#define DRAWN 0.0F
#define LET_GO (-0.5F)

static bool is_down(const GLFWgamepadstate *now, int button)
{
    return now->buttons[button] == GLFW_PRESS;
}

static uint32_t find_down(const pad *p, const GLFWgamepadstate *now)
{
    const float trigger = now->axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER];
    const bool drawn = trigger > ((p->down & PAD_JAWS) != 0 ? LET_GO : DRAWN);
    return (drawn || is_down(now, GLFW_GAMEPAD_BUTTON_A) ? PAD_JAWS : 0U) |
           (is_down(now, GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER) ? PAD_OTHER : 0U) |
           (is_down(now, GLFW_GAMEPAD_BUTTON_START) ? PAD_PAUSE : 0U) |
           (is_down(now, GLFW_GAMEPAD_BUTTON_BACK) ? PAD_HELP : 0U);
}

/* Sticks point down with positive numbers, and back to the user. What faces the user goes the way of a stick that turns, as it
 * does with a mouse. */
pad_wish pad_read(pad *p, const GLFWgamepadstate *now)
{
    pad_wish w = {.fine = false};
    if (now == NULL) {
        *p = (pad){.known = false};
        return w;
    }
    const double right = (double)now->axes[GLFW_GAMEPAD_AXIS_LEFT_X];
    const double down = (double)now->axes[GLFW_GAMEPAD_AXIS_LEFT_Y];
    if (is_down(now, GLFW_GAMEPAD_BUTTON_LEFT_BUMPER)) {
        w.axes[3] = down;
        w.axes[4] = right;
    } else {
        w.axes[0] = right;
        w.axes[1] = -down;
    }
    w.axes[2] = (double)now->axes[GLFW_GAMEPAD_AXIS_RIGHT_Y];
    w.axes[5] = (double)now->axes[GLFW_GAMEPAD_AXIS_RIGHT_X];
    w.fine = now->axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] > DRAWN;
    const uint32_t down_now = find_down(p, now);
    w.pressed = p->known ? down_now & ~p->down : 0U;
    p->down = down_now;
    p->known = true;
    return w;
}
