/* Measures the stitch for the report. */
#include "sewing.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "collision/closest.h"

static const double near_hole = 2e-3; /* m: no crossing is counted there */

static vec3 host_vertex(const sewing *s, uint32_t i)
{
    const int node = s->tissue.first_surface + (int)i;
    return vec3_add(vec3_load(s->tissue.rest[node]), vec3_load(s->tissue.u[node]));
}

/* Whether a segment goes through a triangle. */
static bool crosses(vec3 a, vec3 b, const vec3 t[3])
{
    const vec3 n = vec3_cross(vec3_sub(t[1], t[0]), vec3_sub(t[2], t[0])), d = vec3_sub(b, a);
    const double from = vec3_dot(vec3_sub(a, t[0]), n), to = vec3_dot(vec3_sub(b, t[0]), n);
    if ((from > 0.0) == (to > 0.0)) {
        return false;
    }
    const vec3 at = vec3_add_scaled(a, from / (from - to), d);
    for (int k = 0; k < 3; k++) {
        const vec3 side = vec3_sub(t[(k + 1) % 3], t[k]);
        if (vec3_dot(vec3_cross(side, vec3_sub(at, t[k])), n) < 0.0) {
            return false;
        }
    }
    return true;
}

static uint32_t count_crossings(const sewing *s, const vbss_view *chain, const vec3 *x,
                                const vec3 *holes, uint32_t hole_count)
{
    const vec3 *p = (const vec3 *)chain->data;
    uint32_t count = 0;
    for (uint64_t i = 0; i + 1 < chain->count; i++) {
        bool is_near = false;
        for (uint32_t h = 0; h < hole_count; h++) {
            is_near = is_near || vec3_distance(p[i], holes[h]) < near_hole;
        }
        for (uint32_t k = 0; k < SEWING_TRIANGLES && !is_near; k++) {
            const vec3 corners[3] = {x[s->triangles[k][0]], x[s->triangles[k][1]],
                                     x[s->triangles[k][2]]};
            count += crosses(p[i], p[i + 1], corners);
        }
    }
    return count;
}

static vbss_result measure_holes(const sewing *s, const vec3 *x, sewing_report *r)
{
    vbss_scene_hole hole;
    vec3 holes[8];
    vbss_view thread, needle;
    while (r->holes < 8 && vbss_scene_get_hole(s->scene, r->holes, &hole, sizeof hole) == VBSS_OK) {
        if (r->holes < 2) {
            r->hole_forces[r->holes] = vec3_norm(vec3_load(hole.force));
        }
        holes[r->holes++] = vec3_load(hole.position);
    }
    VBSS_TRY(vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &thread, sizeof thread));
    VBSS_TRY(vbss_needle_get_view(s->needle, VBSS_NEEDLE_VIEW_POINTS, &needle, sizeof needle));
    r->crossings = count_crossings(s, &thread, x, holes, r->holes) +
                   count_crossings(s, &needle, x, holes, r->holes);
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
    if (s->tail != 0) {
        vbss_thread_reaction tail;
        VBSS_TRY(vbss_thread_get_reaction(s->thread, s->tail, &tail, sizeof tail));
        r->tail_force = vec3_norm(vec3_load(tail.force));
    }
    return measure_holes(s, x, r);
}
