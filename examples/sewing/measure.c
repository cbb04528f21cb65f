/* Measures the stitch for the report. */
#include "sewing.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "scripted/crossing.h"

static const double near_hole = 2e-3; /* m: no crossing is counted there */

static vec3 host_vertex(const sewing *s, uint32_t i)
{
    const int node = s->tissue.first_surface + (int)i;
    return vec3_add(vec3_load(s->tissue.rest[node]), vec3_load(s->tissue.u[node]));
}

static vbss_result measure_holes(const sewing *s, const vec3 *x, sewing_report *r)
{
    scripted_surface surface = {.vertices = x,
                                .triangles = s->triangles,
                                .triangle_count = SEWING_TRIANGLES,
                                .near_hole = near_hole};
    vbss_scene_hole hole;
    vbss_view thread, needle;
    scripted_find_holes(s->scene, &surface);
    r->holes = surface.hole_count;
    for (uint32_t i = 0; i < r->holes && i < 2; i++) {
        VBSS_TRY(vbss_scene_get_hole(s->scene, i, &hole, sizeof hole));
        r->hole_forces[i] = vec3_norm(vec3_load(hole.force));
    }
    VBSS_TRY(vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &thread, sizeof thread));
    VBSS_TRY(vbss_needle_get_view(s->needle, VBSS_NEEDLE_VIEW_POINTS, &needle, sizeof needle));
    r->crossings =
        scripted_count_crossings(&surface, &thread) + scripted_count_crossings(&surface, &needle);
    return VBSS_OK;
}

vbss_result sewing_measure(const sewing *s, sewing_report *r)
{
    vbss_view forces, positions;
    memset(r, 0, sizeof *r);
    VBSS_TRY(vbss_scene_get_surface_view(s->scene, s->surface, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                         &forces, sizeof forces));
    VBSS_TRY(vbss_scene_get_surface_view(s->scene, s->surface, VBSS_SCENE_SURFACE_VIEW_POSITIONS,
                                         &positions, sizeof positions));
    const vec3 *f = (const vec3 *)forces.data, *x = (const vec3 *)positions.data;
    for (uint32_t i = 0; i < SEWING_VERTICES; i++) {
        double elastic[3], reaction[3];
        fem_elastic_force(&s->tissue, (int)i, elastic);
        const double u = s->tissue.u[s->tissue.first_surface + (int)i][1];
        r->force = vec3_add(r->force, f[i]);
        r->largest_force = fmax(r->largest_force, vec3_norm(f[i]));
        r->largest_residual =
            fmax(r->largest_residual, vec3_norm(vec3_add(f[i], vec3_load(elastic))));
        r->deepest = fmin(r->deepest, u);
        r->highest = fmax(r->highest, u);
        r->apart = fmax(r->apart, vec3_distance(x[i], host_vertex(s, i)));
        fem_reaction(&s->tissue, reaction);
        r->reaction = vec3_load(reaction);
    }
    if (s->tail.attachment != 0) {
        vbss_thread_reaction tail;
        VBSS_TRY(vbss_thread_get_reaction(s->thread, s->tail.attachment, &tail, sizeof tail));
        r->tail_force = vec3_norm(vec3_load(tail.force));
    }
    return measure_holes(s, x, r);
}
