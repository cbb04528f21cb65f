/* Points of a drain's wall: their positions at rest, now, and at a time within the substep. */
#include "scene/world/world.h"

scene_wall_point vbss_scene_wall_point(const scene_body *drain, uint32_t triangle,
                                       const double weights[3])
{
    const drain_object *d = drain->drain.drain;
    return (scene_wall_point){vbss_drain_point(d, d->x, triangle, weights),
                              vbss_drain_point(d, d->mesh.rest, triangle, weights), 0.0};
}

scene_wall_point vbss_scene_wall_point_on_edge(const scene_body *drain, const uint32_t node[2],
                                               double fraction)
{
    const drain_object *d = drain->drain.drain;
    const vec3 *rest = d->mesh.rest;
    return (scene_wall_point){vec3_lerp(d->x[node[0]], d->x[node[1]], fraction),
                              vec3_lerp(rest[node[0]], rest[node[1]], fraction), 0.0};
}

scene_wall_point vbss_scene_wall_point_at_time(const scene_body *drain, uint32_t triangle,
                                               const double weights[3], double time)
{
    const drain_object *d = drain->drain.drain;
    scene_wall_point wall_point = vbss_scene_wall_point(drain, triangle, weights);
    if (time > 0.0) {
        wall_point.now =
            vec3_lerp(wall_point.now, vbss_drain_point(d, d->trial, triangle, weights), time);
        wall_point.time = time;
    }
    return wall_point;
}

scene_wall_point vbss_scene_wall_point_on_edge_at_time(const scene_body *drain,
                                                       const uint32_t node[2], double fraction,
                                                       double time)
{
    const vec3 *trial = drain->drain.drain->trial;
    scene_wall_point wall_point = vbss_scene_wall_point_on_edge(drain, node, fraction);
    if (time > 0.0) {
        wall_point.now =
            vec3_lerp(wall_point.now, vec3_lerp(trial[node[0]], trial[node[1]], fraction), time);
        wall_point.time = time;
    }
    return wall_point;
}
