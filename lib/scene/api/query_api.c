/* Rays and nearest bodies. Both compare with all features of all bodies: the boxes of the broad
 * phase are those of the last attempt at a substep, which edits and remeshing leave behind. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/closest.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/world/world.h"

#include <vblast_ss/scene_query.h>

#include <math.h>

_Static_assert(sizeof(vbss_scene_ray_hit) == 72, "published size");
_Static_assert(sizeof(vbss_scene_nearest) == 72, "published size");

static const uint32_t hit_sizes[] = {72, 0}, nearest_sizes[] = {72, 0};
static const vbss_layout hit_layout = {"vbss_scene_ray_hit", NULL, hit_sizes},
                         nearest_layout = {"vbss_scene_nearest", NULL, nearest_sizes};

/* ---- distance of a point from a feature */

/* Nearest place of a feature. */
typedef struct place {
    double distance; /* of the surface, m */
    vec3 normal;     /* unit, outward */
} place;

/* `to` leads from the point to the middle of the feature; `otherwise` is the normal where that has no
 * direction. */
static place place_at(vec3 to, double radius, vec3 otherwise)
{
    return (place){vec3_norm(to) - radius, vec3_unit_or(vec3_neg(to), otherwise)};
}

static place place_on_segment(const scene_segment *g, vec3 point)
{
    const vec3 e = vec3_sub(g->ends[1], g->ends[0]);
    const double along = closest_on_edge(e, vec3_sub(point, g->ends[0]));
    return place_at(vec3_sub(vec3_add_scaled(g->ends[0], along, e), point), g->radius,
                    vec3_any_normal(vec3_unit_or(e, vec3_make(1.0, 0.0, 0.0))));
}

static vec3 normal_of(const scene_triangle *t)
{
    return vec3_unit_or(
        vec3_cross(vec3_sub(t->corners[1], t->corners[0]), vec3_sub(t->corners[2], t->corners[0])),
        vec3_zero());
}

static place place_on_triangle(const scene_triangle *t, vec3 point)
{
    double weights[3];
    const vec3 relative[3] = {vec3_sub(t->corners[0], point), vec3_sub(t->corners[1], point),
                              vec3_sub(t->corners[2], point)};
    return place_at(closest_on_triangle(relative, weights), t->radius, normal_of(t));
}

static place place_on_plane(scene_plane plane, vec3 point)
{
    return (place){scene_height_over(plane, point), plane.normal};
}

/* ---- rays */

typedef struct ray {
    vec3 origin, translation;
} ray;

/* Where a ray enters a feature. A fraction above 1: nowhere. */
typedef struct entry {
    double fraction;
    vec3 normal; /* unit, outward */
} entry;

static const entry no_entry = {2.0, {0.0, 0.0, 0.0}};

static entry earlier(entry a, entry b)
{
    return b.fraction < a.fraction ? b : a;
}

/* Fraction at which a point at `from`, relative to a centre, comes within `radius` of it; above 1:
 * never. It begins outside. The cross product avoids the cancellation of the textbook's formula. */
static double approach(vec3 from, vec3 translation, double radius)
{
    const double a = vec3_norm_squared(translation), b = vec3_dot(from, translation);
    const double root = a * radius * radius - vec3_norm_squared(vec3_cross(from, translation));
    if (!(b < 0.0) || !(root >= 0.0)) {
        return no_entry.fraction;
    }
    const double excess = vec3_norm(from) - radius;
    return excess * (vec3_norm(from) + radius) / (sqrt(root) - b);
}

static vec3 point_on(const ray *r, double fraction)
{
    return vec3_add_scaled(r->origin, fraction, r->translation);
}

static entry enter_ball(const ray *r, vec3 centre, double radius)
{
    const double fraction = approach(vec3_sub(r->origin, centre), r->translation, radius);
    return (entry){fraction, vec3_unit_or(vec3_sub(point_on(r, fraction), centre), vec3_zero())};
}

static entry enter_cylinder(const ray *r, const scene_segment *g)
{
    const vec3 e = vec3_sub(g->ends[1], g->ends[0]), from = vec3_sub(r->origin, g->ends[0]);
    const double ee = vec3_norm_squared(e);
    if (!(ee > 0.0)) {
        return no_entry;
    }
    const vec3 translation = vec3_add_scaled(r->translation, -vec3_dot(r->translation, e) / ee, e);
    const double fraction =
        approach(vec3_add_scaled(from, -vec3_dot(from, e) / ee, e), translation, g->radius);
    const vec3 reached = vec3_sub(point_on(r, fraction), g->ends[0]);
    const double along = vec3_dot(reached, e) / ee;
    if (!(along >= 0.0 && along <= 1.0)) {
        return no_entry;
    }
    return (entry){fraction, vec3_unit_or(vec3_add_scaled(reached, -along, e), vec3_zero())};
}

/* The origin is outside. */
static entry enter_capsule(const ray *r, const scene_segment *g)
{
    entry first = enter_cylinder(r, g);
    first = earlier(first, enter_ball(r, g->ends[0], g->radius));
    return earlier(first, enter_ball(r, g->ends[1], g->radius));
}

static bool is_above(const scene_triangle *t, vec3 normal, vec3 point)
{
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        const vec3 side = vec3_sub(t->corners[(k + 1) % 3], t->corners[k]);
        inside =
            inside && vec3_dot(vec3_cross(side, vec3_sub(point, t->corners[k])), normal) >= 0.0;
    }
    return inside;
}

static entry enter_face(const ray *r, const scene_triangle *t)
{
    const vec3 normal = normal_of(t);
    const double height = vec3_dot(vec3_sub(r->origin, t->corners[0]), normal);
    const double side = height < 0.0 ? -1.0 : 1.0;
    const double speed = -side * vec3_dot(r->translation, normal);
    const double excess = fabs(height) - t->radius;
    if (!(speed > 0.0) || !(excess >= 0.0)) {
        return no_entry;
    }
    const double fraction = excess / speed;
    return fraction <= 1.0 && is_above(t, normal, point_on(r, fraction))
               ? (entry){fraction, vec3_scale(normal, side)}
               : no_entry;
}

static entry enter_triangle(const ray *r, const scene_triangle *t)
{
    entry first = enter_face(r, t);
    for (int k = 0; k < 3; k++) {
        const scene_segment side = {{t->corners[k], t->corners[(k + 1) % 3]}, t->radius};
        first = earlier(first, enter_capsule(r, &side));
    }
    return first;
}

static entry enter_plane(scene_plane plane, const ray *r)
{
    const double height = scene_height_over(plane, r->origin);
    const double fall = -vec3_dot(r->translation, plane.normal);
    if (height <= 0.0) {
        return (entry){0.0, plane.normal};
    }
    return fall > 0.0 ? (entry){height / fall, plane.normal} : no_entry;
}

/* ---- features of bodies */

static uint32_t count_features(const scene_outline *o)
{
    return o->plane != NULL                ? 1
           : o->surface.triangle_count > 0 ? o->surface.triangle_count
                                           : vbss_scene_outline_segments(o);
}

static place place_on_feature(const scene_object *s, const scene_outline *o, uint32_t feature,
                              vec3 point)
{
    if (o->plane != NULL) {
        return place_on_plane(*o->plane, point);
    }
    if (o->surface.triangle_count > 0) {
        const scene_triangle t = vbss_scene_outline_triangle(o, feature);
        return place_on_triangle(&t, point);
    }
    const scene_segment g = vbss_scene_outline_segment(s, o, feature);
    return place_on_segment(&g, point);
}

static entry enter_feature(const scene_object *s, const scene_outline *o, uint32_t feature,
                           const ray *r)
{
    if (o->plane != NULL) {
        return enter_plane(*o->plane, r);
    }
    const place start = place_on_feature(s, o, feature, r->origin);
    if (start.distance <= 0.0) {
        return (entry){0.0, start.normal};
    }
    if (o->surface.triangle_count > 0) {
        const scene_triangle t = vbss_scene_outline_triangle(o, feature);
        return enter_triangle(r, &t);
    }
    const scene_segment g = vbss_scene_outline_segment(s, o, feature);
    return enter_capsule(r, &g);
}

static bool is_queried(const scene_body *b, uint32_t mask)
{
    return b->kind != SCENE_BODY_NONE && (b->filter.category & mask) != 0;
}

static bool is_floor_queried(const scene_object *s, uint32_t mask)
{
    return s->config.floor != 0 && (s->settings.floor_filter.category & mask) != 0;
}

/* ---- a ray */

static entry cast(const scene_object *s, const ray *r, uint32_t mask, vbss_scene_ray_hit *hit)
{
    entry first = no_entry;
    if (is_floor_queried(s, mask)) {
        first = enter_plane(scene_plane_of(s, NULL), r);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (!is_queried(&s->bodies[i], mask)) {
            continue;
        }
        const scene_outline o = vbss_scene_outline_of(s, &s->bodies[i]);
        for (uint32_t k = 0; k < count_features(&o); k++) {
            const entry found = enter_feature(s, &o, k, r);
            if (found.fraction < first.fraction) {
                first = found;
                hit->body = o.number;
                hit->feature = k;
            }
        }
    }
    return first;
}

vbss_result vbss_scene_cast_ray(vbss_scene *scene, const double origin[3],
                                const double translation[3], uint32_t mask, vbss_scene_ray_hit *hit,
                                uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_ray_hit own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, origin, "origin"));
    VBSS_TRY(vbss_check_pointer(s->context, translation, "translation"));
    VBSS_TRY(vbss_check_vector(s->context, origin, 1e3, "origin"));
    VBSS_TRY(vbss_check_vector(s->context, translation, 1e4, "translation"));
    VBSS_TRY(vbss_check_range(s->context, vbss_max_abs(translation, 3), 1e-100, 1e4,
                              "largest component of translation"));
    const ray r = {vec3_load(origin), vec3_load(translation)};
    const entry first = cast(s, &r, mask, &own);
    if (first.fraction <= 1.0) {
        own.is_hit = 1;
        own.fraction = first.fraction;
        vec3_store(own.point, point_on(&r, first.fraction));
        vec3_store(own.normal, first.normal);
    } else {
        own.body = own.feature = 0;
    }
    return vbss_struct_write(s->context, &hit_layout, &own, hit, struct_size);
}

/* ---- the nearest body */

static place find_nearest(const scene_object *s, vec3 point, uint32_t mask,
                          vbss_scene_nearest *nearest)
{
    place best = {HUGE_VAL, vec3_zero()};
    if (is_floor_queried(s, mask)) {
        best = place_on_plane(scene_plane_of(s, NULL), point);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (!is_queried(&s->bodies[i], mask)) {
            continue;
        }
        const scene_outline o = vbss_scene_outline_of(s, &s->bodies[i]);
        for (uint32_t k = 0; k < count_features(&o); k++) {
            const place found = place_on_feature(s, &o, k, point);
            if (found.distance < best.distance) {
                best = found;
                nearest->body = o.number;
                nearest->feature = k;
            }
        }
    }
    return best;
}

vbss_result vbss_scene_find_nearest(vbss_scene *scene, const double point[3], double radius,
                                    uint32_t mask, vbss_scene_nearest *nearest,
                                    uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_nearest own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, point, "point"));
    VBSS_TRY(vbss_check_vector(s->context, point, 1e3, "point"));
    VBSS_TRY(vbss_check_range(s->context, radius, 0.0, 1e4, "radius"));
    const place best = find_nearest(s, vec3_load(point), mask, &own);
    if (best.distance <= radius) {
        own.is_found = 1;
        own.distance = best.distance;
        vec3_store(own.point, vec3_add_scaled(vec3_load(point), -best.distance, best.normal));
        vec3_store(own.normal, best.normal);
    } else {
        own.body = own.feature = 0;
    }
    return vbss_struct_write(s->context, &nearest_layout, &own, nearest, struct_size);
}
