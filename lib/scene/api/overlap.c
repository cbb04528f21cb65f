/* The deepest overlap of a body with the others and the floor, for the host; driven bodies that
 * overlap each other are in world/driven_overlaps.c. Bodies are compared segment by
 * segment; boxes keep that short. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/closest.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/tuning.h"

#include <stdio.h>

_Static_assert(sizeof(vbss_scene_overlap) == 16, "published size");

/* ---- two bodies */

static bool boxes_meet(const collision_aabb *a, const collision_aabb *b)
{
    return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] &&
           b->low[1] <= a->high[1] && a->low[2] <= b->high[2] && b->low[2] <= a->high[2];
}

/* Depth of an overlap that is more than a step may leave; 0 for a smaller one, or none. */
static double depth_of(const scene_object *s, double distance, double radius_a, double radius_b)
{
    const double depth = radius_a + radius_b - distance;
    const double thinner = 2.0 * vbss_min(radius_a, radius_b);
    return depth > s->solver.penetration_tolerance * thinner ? depth : 0.0;
}

static bool is_near(const scene_segment *g, vec3 point, double distance)
{
    return vec3_distance(g->ends[0], point) < distance ||
           vec3_distance(g->ends[1], point) < distance;
}

/* Whether the segment of a thread is at the swage of a needle: both have an end in one place. */
static bool is_at_swage(const scene_object *s, const scene_outline *thread, const scene_segment *g,
                        const scene_outline *other)
{
    const bool is_needle =
        other->needle != NULL || (other->rigid != NULL && other->rigid->needle != NULL);
    if (!is_needle || thread->thread == NULL) {
        return false;
    }
    const uint32_t last = vbss_scene_outline_segments(other) - 1;
    const scene_segment sections[2] = {vbss_scene_outline_segment(s, other, 0),
                                       vbss_scene_outline_segment(s, other, last)};
    const thread_object *t = thread->thread;
    const vec3 ends[2] = {t->now.x[0], t->now.x[t->node_count - 1]};
    const double touching = g->radius + sections[0].radius;
    for (int k = 0; k < 4; k++) {
        const vec3 swage = sections[k % 2].ends[k % 2];
        if (vec3_distance(ends[k / 2], swage) < touching &&
            is_near(g, swage, SCENE_EXCLUSION_ARC_RATIO * touching)) {
            return true;
        }
    }
    return false;
}

/* Whether the segment of a thread is at a pin to the other body. */
static bool is_at_pin(const scene_object *s, const scene_outline *thread, const scene_segment *g,
                      const scene_outline *other)
{
    for (uint32_t i = 0; thread->thread != NULL && i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->thread == thread->number && p->body == other->number &&
            is_near(g, thread->thread->now.x[p->node],
                    SCENE_EXCLUSION_ARC_RATIO * 2.0 * g->radius)) {
            return true;
        }
    }
    return false;
}

/* Whether a segment is so near to a hole of a surface that contact leaves it out, or has a shorter contact
 * distance. */
static bool is_at_hole(const scene_object *s, const scene_segment *g, const scene_outline *surface)
{
    const double reach = SCENE_EXCLUSION_ARC_RATIO * (1.0 + SCENE_EXIT_RAMP_RATIO) *
                         (g->radius + surface->surface.radius);
    const vec3 along = vec3_sub(g->ends[1], g->ends[0]);
    for (uint32_t i = 0; surface->ignores_holes && i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id == 0 || hole->wall != surface->number) {
            continue;
        }
        const scene_body *b = vbss_scene_body(s, hole->wall);
        const vec3 at =
            vec3_sub(vbss_scene_wall_point(b, hole->triangle, hole->barycentric).now, g->ends[0]);
        if (vec3_norm(vec3_add_scaled(at, -closest_on_edge(along, at), along)) < reach) {
            return true;
        }
    }
    return false;
}

static double depth_of_triangle(const scene_object *s, const scene_segment *g,
                                const scene_triangle *t)
{
    vbss_collision_closest closest;
    double segment[6], corners[9];
    for (int k = 0; k < 3; k++) {
        vec3_store(corners + 3 * (size_t)k, t->corners[k]);
    }
    vec3_store(segment, g->ends[0]);
    vec3_store(segment + 3, g->ends[1]);
    return vbss_collision_closest_segment_triangle(segment, corners, &closest, sizeof closest) ==
                   VBSS_OK
               ? depth_of(s, closest.distance, g->radius, t->radius)
               : 0.0;
}

static double depth_of_segments(const scene_object *s, const scene_segment *a,
                                const scene_segment *b)
{
    vbss_collision_closest closest;
    double first[6], second[6];
    for (int k = 0; k < 2; k++) {
        vec3_store(first + 3 * (size_t)k, a->ends[k]);
        vec3_store(second + 3 * (size_t)k, b->ends[k]);
    }
    return vbss_collision_closest_segments(first, second, &closest, sizeof closest) == VBSS_OK
               ? depth_of(s, closest.distance, a->radius, b->radius)
               : 0.0;
}

static collision_aabb triangle_box(const scene_triangle *t)
{
    const scene_segment sides[2] = {{{t->corners[0], t->corners[1]}, t->radius},
                                    {{t->corners[1], t->corners[2]}, t->radius}};
    collision_aabb box = vbss_scene_segment_box(&sides[0]);
    const collision_aabb second = vbss_scene_segment_box(&sides[1]);
    aabb_extend(&box, &second);
    return box;
}

/* A segment of one body against all segments, or triangles, of another. */
static double segment_depth(const scene_object *s, const scene_segment *g, const scene_outline *b)
{
    const collision_aabb box = vbss_scene_segment_box(g);
    double deepest = 0.0;
    if (b->surface.triangle_count > 0) {
        for (uint32_t i = 0; i < b->surface.triangle_count; i++) {
            const scene_triangle t = vbss_scene_outline_triangle(b, i);
            const collision_aabb other = triangle_box(&t);
            if (boxes_meet(&box, &other)) {
                deepest = vbss_max(deepest, depth_of_triangle(s, g, &t));
            }
        }
        return deepest;
    }
    for (uint32_t i = 0; i < vbss_scene_outline_segments(b); i++) {
        const scene_segment segment = vbss_scene_outline_segment(s, b, i);
        const collision_aabb other = vbss_scene_segment_box(&segment);
        if (boxes_meet(&box, &other)) {
            deepest = vbss_max(deepest, depth_of_segments(s, g, &segment));
        }
    }
    return deepest;
}

/* All segments of one body against another one. */
static double outline_depth(const scene_object *s, const scene_outline *a, const scene_outline *b)
{
    const collision_aabb box = vbss_scene_outline_box(s, b);
    double deepest = 0.0;
    for (uint32_t i = 0; i < vbss_scene_outline_segments(a); i++) {
        const scene_segment g = vbss_scene_outline_segment(s, a, i);
        const collision_aabb part = vbss_scene_segment_box(&g);
        if (boxes_meet(&part, &box) && !is_at_swage(s, a, &g, b) && !is_at_pin(s, a, &g, b) &&
            !is_at_hole(s, &g, b)) {
            deepest = vbss_max(deepest, segment_depth(s, &g, b));
        }
    }
    return deepest;
}

static double depth_in_plane(const scene_object *s, scene_plane plane, const scene_outline *o)
{
    double deepest = 0.0;
    for (uint32_t i = 0; i < vbss_scene_outline_segments(o); i++) {
        const scene_segment g = vbss_scene_outline_segment(s, o, i);
        for (int k = 0; k < 2; k++) {
            const double depth = g.radius - scene_height_over(plane, g.ends[k]);
            const bool is_deep = depth > s->solver.penetration_tolerance * 2.0 * g.radius;
            deepest = is_deep ? vbss_max(deepest, depth) : deepest;
        }
    }
    return deepest;
}

/* The order of the bodies decides whose segments are excused and whose triangles are tested. */
static double pair_depth(const scene_object *s, const scene_outline *a, const scene_outline *b)
{
    if (a->is_prescribed && b->is_prescribed) {
        return 0.0;
    }
    if (a->plane != NULL || b->plane != NULL) {
        return a->plane != NULL ? depth_in_plane(s, *a->plane, b) : depth_in_plane(s, *b->plane, a);
    }
    const bool is_a_surface = a->surface.triangle_count > 0;
    if (is_a_surface && b->surface.triangle_count > 0) {
        return vbss_max(outline_depth(s, a, b), outline_depth(s, b, a));
    }
    return is_a_surface || b->thread != NULL ? outline_depth(s, b, a) : outline_depth(s, a, b);
}

/* ---- one body and all others */

static vbss_scene_overlap find_deepest(const scene_object *s, const scene_outline *o)
{
    vbss_scene_overlap found = {.struct_size = sizeof found};
    const scene_body *own = vbss_scene_body(s, o->number);
    if (s->config.floor != 0 && !o->is_prescribed &&
        (own == NULL || vbss_scene_do_collide(s, own, NULL))) {
        found.depth = depth_in_plane(s, scene_plane_of(s, NULL), o);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_NONE || b->number == o->number ||
            (own != NULL && !vbss_scene_do_collide(s, own, b))) {
            continue;
        }
        const scene_outline other = vbss_scene_outline_of(s, b);
        const double depth = pair_depth(s, o, &other);
        if (depth > found.depth) {
            found.depth = depth;
            found.body = b->number;
        }
    }
    return found;
}

static void describe(const vbss_scene_overlap *overlap, const char *name, char *text, size_t bytes)
{
    if (overlap->body == 0) {
        snprintf(text, bytes, "the %s is %g mm inside the floor", name, 1e3 * overlap->depth);
    } else {
        snprintf(text, bytes, "the %s overlaps body %u by %g mm", name, overlap->body,
                 1e3 * overlap->depth);
    }
}

vbss_result vbss_scene_check_overlap(const scene_object *s, const scene_outline *added,
                                     const char *name)
{
    char text[96];
    if (s->config.overlap == VBSS_SCENE_OVERLAP_ALLOW) {
        return VBSS_OK;
    }
    const vbss_scene_overlap found = find_deepest(s, added);
    if (found.depth == 0.0) {
        return VBSS_OK;
    }
    describe(&found, name, text, sizeof text);
    if (s->config.overlap == VBSS_SCENE_OVERLAP_REFUSE) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "%s", text);
    }
    vbss_message(s->context, VBSS_LOG_WARNING, "%s; steps may hold both back", text);
    return VBSS_OK;
}

vbss_result vbss_scene_get_overlap(vbss_scene *scene, uint32_t body, vbss_scene_overlap *overlap,
                                   uint32_t struct_size)
{
    VBSS_ENTER(scene);
    static const uint32_t sizes[] = {16, 0};
    static const vbss_layout layout = {"vbss_scene_overlap", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    const scene_outline o = vbss_scene_outline_of(s, b);
    const vbss_scene_overlap own = find_deepest(s, &o);
    return vbss_struct_write(s->context, &layout, &own, overlap, struct_size);
}
