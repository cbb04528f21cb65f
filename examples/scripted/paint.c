#include "scripted/paint.h"

painter_result scripted_paint_hand(painter *p, vbss_scene *scene, const scripted_hand *hand,
                                   double length)
{
    vbss_scene_rigid_state state;
    if (vbss_scene_get_rigid(scene, hand->body, &state, sizeof state) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    const quat turn = quat_make(state.orientation[0], state.orientation[1], state.orientation[2],
                                state.orientation[3]);
    const vec3 tip = vec3_load(state.position);
    const vec3 ends[2] = {tip, vec3_add(tip, quat_rotate(turn, vec3_make(0.0, 0.0, length)))};
    return painter_add_chain(p, &ends[0].x, 2, 0, 0.5e-3, PAINTER_STEEL, NULL);
}

painter_result scripted_paint_thread(painter *p, vbss_thread *thread, double radius,
                                     painter_colour colour)
{
    vbss_view x;
    if (vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    return painter_add_chain(p, x.data, (size_t)x.count, 0, radius, colour, NULL);
}

painter_result scripted_paint_needle(painter *p, vbss_needle *needle, double radius)
{
    vbss_view x;
    if (vbss_needle_get_view(needle, VBSS_NEEDLE_VIEW_POINTS, &x, sizeof x) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    return painter_add_chain(p, x.data, (size_t)x.count, 0, radius, PAINTER_BLUE, NULL);
}
