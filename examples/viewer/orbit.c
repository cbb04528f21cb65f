#include "orbit.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define TURNING 0.8F /* rad/s */
#define GOING 0.7F   /* of the distance, 1/s */
#define LOWEST 0.1F  /* rad: never from below, */
#define HIGHEST 1.5F /* nor from right above, where nothing is up */
#define NEAREST 0.03F
#define FARTHEST 0.3F

void orbit_begin(orbit *b, point3 target, float aside, float away)
{
    *b = (orbit){target, {aside, away}, aside, CAMERA_DOWN, away};
}

static float pull(const window *w, int more, int less)
{
    return (window_is_down(w, more) ? 1.0F : 0.0F) - (window_is_down(w, less) ? 1.0F : 0.0F);
}

bool orbit_step(orbit *b, const window *w, float seconds)
{
    const orbit before = *b;
    b->aside += TURNING * seconds * pull(w, GLFW_KEY_RIGHT, GLFW_KEY_LEFT);
    b->down += TURNING * seconds * pull(w, GLFW_KEY_UP, GLFW_KEY_DOWN);
    b->away *= 1.0F + GOING * seconds * pull(w, GLFW_KEY_PAGE_DOWN, GLFW_KEY_PAGE_UP);
    b->down = fminf(fmaxf(b->down, LOWEST), HIGHEST);
    b->away = fminf(fmaxf(b->away, NEAREST), FARTHEST);
    if (window_is_down(w, GLFW_KEY_HOME)) {
        orbit_begin(b, b->target, b->at_first[0], b->at_first[1]);
    }
    return b->aside != before.aside || b->down != before.down || b->away != before.away;
}

camera orbit_camera(const orbit *b)
{
    return camera_from(b->target, b->aside, b->down, b->away);
}
