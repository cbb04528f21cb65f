/* A first view of a scene in which everything that the hands begin with is in the picture. */
#include <math.h>

#include "live.h"

#define FIELD 0.75F     /* of half of the picture's height, in which everything is */
#define FARTHEST 0.22F  /* m: from farther away, thread and needle are too small to see */
#define TOOL_SHOWN 8e-3 /* m of a tool, from its tip */

enum { POINTS = 5 };

static point3 point_of(const double p[3])
{
    return (point3){(float)p[0], (float)p[1], (float)p[2]};
}

/* The slit, and the ends of both tools. */
static vbss_result find_points(const live *l, point3 points[POINTS])
{
    points[0] = (point3){0.0F, 0.0F, 0.0F};
    for (int side = 0; side < SIDES; side++) {
        vbss_grasper_state tool;
        double shaft[3];
        TRY(vbss_grasper_get_state(l->stage.graspers[side], &tool, sizeof tool));
        v_store(shaft, v_along(v_load(tool.position), TOOL_SHOWN,
                               hand_rotate(tool.orientation, v3(0.0, 0.0, 1.0))));
        points[1 + 2 * side] = point_of(tool.position);
        points[2 + 2 * side] = point_of(shaft);
    }
    return VBSS_OK;
}

vbss_result live_show_tools(live *l)
{
    point3 points[POINTS];
    TRY(find_points(l, points));
    const live_view from = l->scene->view;
    const camera usual = camera_from(from.target, from.aside, CAMERA_DOWN, from.away);
    const camera_view v = camera_get_view(&usual, 1.0F);
    const point3 axes[3] = {v.right, v.up, point3_cross(v.up, v.right)}; /* the last: forward */
    float low[3], high[3], middle[3], away = from.away;
    for (int k = 0; k < 3; k++) {
        low[k] = high[k] = point3_dot(points[0], axes[k]);
        for (int i = 1; i < POINTS; i++) {
            low[k] = fminf(low[k], point3_dot(points[i], axes[k]));
            high[k] = fmaxf(high[k], point3_dot(points[i], axes[k]));
        }
        middle[k] = 0.5F * (low[k] + high[k]);
    }
    const float slope = FIELD * tanf(0.5F * usual.field);
    for (int i = 0; i < POINTS; i++) {
        const float x = point3_dot(points[i], axes[0]) - middle[0];
        const float y = point3_dot(points[i], axes[1]) - middle[1];
        const float z = point3_dot(points[i], axes[2]) - middle[2];
        away = fmaxf(away, hypotf(x, y) / slope - z);
    }
    l->view.away = fminf(away, FARTHEST);
    l->view.target = (point3){0.0F, 0.0F, 0.0F};
    for (int k = 0; k < 3; k++) {
        l->view.target = point3_add(l->view.target, middle[k], axes[k]);
    }
    return VBSS_OK;
}
