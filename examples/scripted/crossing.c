#include "scripted/crossing.h"

#include <math.h>
#include <stddef.h>

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

typedef struct box {
    vec3 low, high;
} box;

static box around(const vec3 *points, uint64_t count, const uint32_t *indices)
{
    box b = {points[indices == NULL ? 0 : indices[0]], points[indices == NULL ? 0 : indices[0]]};
    for (uint64_t i = 1; i < count; i++) {
        const vec3 p = points[indices == NULL ? i : indices[i]];
        b.low = vec3_make(fmin(b.low.x, p.x), fmin(b.low.y, p.y), fmin(b.low.z, p.z));
        b.high = vec3_make(fmax(b.high.x, p.x), fmax(b.high.y, p.y), fmax(b.high.z, p.z));
    }
    return b;
}

static bool overlap(box a, box b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

uint32_t scripted_count_crossings(const scripted_surface *s, const vbss_view *chain)
{
    const vec3 *p = (const vec3 *)chain->data;
    const box all = around(s->vertices, 3 * (uint64_t)s->triangle_count, s->triangles[0]);
    uint32_t count = 0;
    for (uint64_t i = 0; i + 1 < chain->count; i++) {
        const bool is_near = overlap(all, around(p + i, 2, NULL));
        for (uint32_t k = 0; k < s->triangle_count && is_near; k++) {
            const uint32_t *n = s->triangles[k];
            const vec3 corners[3] = {s->vertices[n[0]], s->vertices[n[1]], s->vertices[n[2]]};
            count += crosses_beside_holes(s, p[i], p[i + 1], corners);
        }
    }
    return count;
}
