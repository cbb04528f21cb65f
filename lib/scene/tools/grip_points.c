/* Points of a grasped thread between the jaws. */
#include "scene/tools/tools.h"

/* Finds the point at an offset in arc length from the middle of the grasp, in m. The search
 * starts at the segment of that middle. */
static scene_grip_location location_on_thread(const thread_object *t, const scene_thread_grasp *g,
                                              double offset)
{
    scene_grip_location p = {g->segment, g->segment_offset + offset};
    while (p.fraction < 0.0 && p.segment > 0) {
        p.fraction += t->rest[--p.segment];
    }
    while (p.fraction > t->rest[p.segment] && p.segment + 2 < t->node_count) {
        p.fraction -= t->rest[p.segment++];
    }
    p.fraction /= t->rest[p.segment];
    p.fraction = p.fraction < 0.0   ? 0.0
                 : p.fraction > 1.0 ? 1.0
                                    : p.fraction; /* beyond an end of the thread */
    return p;
}

scene_grip_location vbss_scene_locate_grip_point(const thread_object *t,
                                                 const scene_thread_grasp *g, uint32_t point)
{
    double half = 0.5 * (GRASPER_THREAD_POINTS - 1) * g->point_spacing;
    return location_on_thread(t, g, g->point_spacing * point - half);
}

vec3 vbss_scene_grip_point(const scene_thread_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point)
{
    scene_grip_location p = vbss_scene_locate_grip_point(t, g, point);
    return vec3_lerp(x[p.segment], x[p.segment + 1], p.fraction);
}
