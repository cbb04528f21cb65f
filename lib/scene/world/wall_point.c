/* Walls of drains and host surfaces, and points of them: their positions at rest, now, and at a time within the substep. */
#include "scene/world/world.h"

suture_wall vbss_scene_wall_of(const scene_body *b)
{
    const scene_host_surface *h = scene_host_surface_of(b);
    if (h == NULL) {
        return suture_wall_of_drain(b->drain.drain);
    }
    return (suture_wall){.law = &h->law,
                         .triangles = h->shape->triangles,
                         .triangle_count = h->shape->triangle_count,
                         .edges = h->shape->edges[0],
                         .beside_edges = b->rigid.mesh.triangles_of_edge[0],
                         .edge_count = h->shape->edge_count,
                         .edge_stride = 2,
                         .now = h->now,
                         .trial = h->trial,
                         .rest = h->now};
}

scene_wall_point vbss_scene_wall_point(const scene_body *wall_body, uint32_t triangle,
                                       const double weights[3])
{
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    return (scene_wall_point){vbss_wall_point(&wall, wall.now, triangle, weights),
                              vbss_wall_point(&wall, wall.rest, triangle, weights), 0.0};
}

scene_wall_point vbss_scene_wall_point_on_edge(const scene_body *wall_body, const uint32_t node[2],
                                               double fraction)
{
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    return (scene_wall_point){vec3_lerp(wall.now[node[0]], wall.now[node[1]], fraction),
                              vec3_lerp(wall.rest[node[0]], wall.rest[node[1]], fraction), 0.0};
}

scene_wall_point vbss_scene_wall_point_at_time(const scene_body *wall_body, uint32_t triangle,
                                               const double weights[3], double time)
{
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    scene_wall_point wall_point = vbss_scene_wall_point(wall_body, triangle, weights);
    if (time > 0.0) {
        wall_point.now =
            vec3_lerp(wall_point.now, vbss_wall_point(&wall, wall.trial, triangle, weights), time);
        wall_point.time = time;
    }
    return wall_point;
}

scene_wall_point vbss_scene_wall_point_on_edge_at_time(const scene_body *wall_body,
                                                       const uint32_t node[2], double fraction,
                                                       double time)
{
    const vec3 *trial = vbss_scene_wall_of(wall_body).trial;
    scene_wall_point wall_point = vbss_scene_wall_point_on_edge(wall_body, node, fraction);
    if (time > 0.0) {
        wall_point.now =
            vec3_lerp(wall_point.now, vec3_lerp(trial[node[0]], trial[node[1]], fraction), time);
        wall_point.time = time;
    }
    return wall_point;
}
