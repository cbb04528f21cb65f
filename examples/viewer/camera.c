#include "camera.h"

#define DEGREE 0.017453293F
/* m */
#define NEAR 5e-3F
#define FAR 0.5F
#define LAMP_ABOVE \
    7e-3F /* of the optics' axis: the fibres' opening, a little exaggerated, for shadows that can be seen */

camera camera_from(point3 target, float aside, float down, float away)
{
    camera c = {.up = {0.0F, 0.0F, 1.0F}, .optics = 30.0F * DEGREE, .field = 56.0F * DEGREE};
    const float tube = down - c.optics, shaft = 0.1F;
    const float x = sinf(aside), y = -cosf(aside);
    c.tip = point3_add(target, away, (point3){x * cosf(down), y * cosf(down), sinf(down)});
    c.port = point3_add(c.tip, shaft, (point3){x * cosf(tube), y * cosf(tube), sinf(tube)});
    c.clear = fminf(CAMERA_CLEAR * away, CAMERA_MAX_CLEAR);
    c.gain = (away / CAMERA_AWAY) * (away / CAMERA_AWAY);
    return c;
}

camera camera_over(point3 target)
{
    return camera_from(target, CAMERA_ASIDE, CAMERA_DOWN, CAMERA_AWAY);
}

camera_view camera_get_view(const camera *c, float aspect)
{
    point3 axis = point3_unit(point3_add(c->tip, -1.0F, c->port));
    point3 right = point3_unit(point3_cross(axis, c->up));
    point3 over = point3_cross(right, axis);
    point3 forward = point3_unit(point3_add(
        point3_add((point3){0.0F, 0.0F, 0.0F}, cosf(c->optics), axis), -sinf(c->optics), over));
    point3 up = point3_cross(right, forward);
    float slope = tanf(0.5F * c->field);
    matrix4 view = matrix4_view(c->tip, right, up, forward);
    matrix4 lens = matrix4_perspective(slope, aspect, NEAR, FAR);
    camera_view v = {.eye = c->tip, .right = right, .up = up};
    v.seen = matrix4_after(&lens, &view);
    v.lamp = point3_add(point3_add(c->tip, LAMP_ABOVE, up), LAMP_ABOVE, right);
    /* It lights what is seen, and a little more. */
    view = matrix4_view(v.lamp, right, up, forward);
    lens = matrix4_perspective(1.3F * slope, aspect, NEAR, FAR);
    v.light = matrix4_after(&lens, &view);
    return v;
}
