#include "scripted/crossing.h"

#include "scene/line_crossing.h"

void scripted_find_holes(vbss_scene *scene, scripted_surface *surface)
{
    vbss_scene_hole hole;
    surface->hole_count = 0;
    while (surface->hole_count < SCRIPTED_HOLES &&
           vbss_scene_get_hole(scene, surface->hole_count, &hole, sizeof hole) == VBSS_OK) {
        surface->holes[surface->hole_count++] = vec3_load(hole.position);
    }
}

static uint32_t crosses_beside_holes(const scripted_surface *s, vec3 from, vec3 to,
                                     const vec3 corners[3])
{
    double weights[3];
    if (!line_crosses_triangle(from, to, corners, weights)) {
        return 0;
    }
    vec3 at = vec3_zero();
    for (int k = 0; k < 3; k++) {
        at = vec3_add_scaled(at, weights[k], corners[k]);
    }
    for (uint32_t i = 0; i < s->hole_count; i++) {
        if (vec3_distance(at, s->holes[i]) < s->near_hole) {
            return 0;
        }
    }
    return 1;
}

uint32_t scripted_count_crossings(const scripted_surface *s, const vbss_view *chain)
{
    const vec3 *p = (const vec3 *)chain->data;
    uint32_t count = 0;
    for (uint64_t i = 0; i + 1 < chain->count; i++) {
        for (uint32_t k = 0; k < s->triangle_count; k++) {
            const uint32_t *n = s->triangles[k];
            const vec3 corners[3] = {s->vertices[n[0]], s->vertices[n[1]], s->vertices[n[2]]};
            count += crosses_beside_holes(s, p[i], p[i + 1], corners);
        }
    }
    return count;
}
