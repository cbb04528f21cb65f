/* Line segments of bodies, in the scene or about to be added. */
#include "scene/api/overlap.h"
#include "scene/world/world.h"

scene_surface vbss_scene_surface_of_drain(const drain_object *d)
{
    return (scene_surface){d->x, (const uint32_t(*)[3])d->mesh.triangles, d->mesh.triangle_count,
                           0.5 * d->config.thickness, false};
}

static scene_surface surface_of_mesh(const scene_object *s, const scene_body *b)
{
    const collision_shape *shape = s->collision->shapes[b->shape];
    return (scene_surface){scene_mesh_vertices(s, b).x, (const uint32_t(*)[3])shape->triangles,
                           shape->triangle_count, shape->radius, b->rigid.is_rigid_mesh};
}

scene_outline vbss_scene_outline_of(const scene_object *s, const scene_body *b)
{
    scene_outline o = {.number = b->number};
    switch (b->kind) {
    case SCENE_BODY_THREAD:
        o.thread = b->thread.thread;
        break;
    case SCENE_BODY_DRAIN:
        o.surface = vbss_scene_surface_of_drain(b->drain.drain);
        break;
    default:
        if (scene_is_mesh(b)) {
            o.surface = surface_of_mesh(s, b);
            o.at = b->rigid.body.now.pose;
        } else if (b->rigid.is_plane) {
            o.plane = &b->rigid.plane;
        } else {
            o.rigid = &b->rigid;
        }
        o.is_prescribed = b->rigid.kind == VBSS_SCENE_RIGID_DRIVEN;
    }
    return o;
}

uint32_t vbss_scene_outline_segments(const scene_outline *o)
{
    if (o->plane != NULL) {
        return 0;
    }
    if (o->thread != NULL) {
        return o->thread->node_count - 1;
    }
    if (o->surface.triangle_count > 0) {
        return 3 * o->surface.triangle_count;
    }
    if (o->needle != NULL) {
        return o->needle->config.segment_count;
    }
    if (o->grasper != NULL) {
        return GRASPER_CAPSULES;
    }
    return o->capsules != NULL ? o->capsules->capsule_count : o->rigid->capsule_count;
}

scene_triangle vbss_scene_outline_triangle(const scene_outline *o, uint32_t index)
{
    const uint32_t *n = o->surface.triangles[index];
    const scene_vertices x = {o->surface.vertices, o->surface.is_posed ? &o->at : NULL};
    return (scene_triangle){{scene_vertex(x, n[0]), scene_vertex(x, n[1]), scene_vertex(x, n[2])},
                            o->surface.radius};
}

/* An edge of a triangle. */
static scene_segment side_segment(const scene_outline *o, uint32_t index)
{
    const scene_triangle t = vbss_scene_outline_triangle(o, index / 3);
    return (scene_segment){{t.corners[index % 3], t.corners[(index + 1) % 3]}, t.radius};
}

static scene_segment placed_segment(pose at, vec3 begin, vec3 end, double radius)
{
    return (scene_segment){{pose_apply(at, begin), pose_apply(at, end)}, radius};
}

static scene_segment needle_segment(const needle_object *n, uint32_t index)
{
    return placed_segment(
        vbss_needle_pose(n), vbss_needle_point(n, vbss_needle_vertex_arc(n, index)),
        vbss_needle_point(n, vbss_needle_vertex_arc(n, index + 1)), n->config.wire_radius);
}

scene_segment vbss_scene_outline_segment(const scene_object *s, const scene_outline *o,
                                         uint32_t index)
{
    if (o->thread != NULL) {
        const thread_object *t = o->thread;
        return (scene_segment){{t->now.x[index], t->now.x[index + 1]}, t->config.radius};
    }
    if (o->surface.triangle_count > 0) {
        return side_segment(o, index);
    }
    if (o->needle != NULL) {
        return needle_segment(o->needle, index);
    }
    if (o->grasper != NULL) {
        grasper_capsule capsules[GRASPER_CAPSULES];
        vbss_grasper_compute_capsules(o->grasper, o->grasper->jaw_angle, capsules);
        const grasper_capsule *c = &capsules[index];
        return placed_segment(o->at, c->axis[0], c->axis[1], c->radius);
    }
    if (o->capsules != NULL) {
        const vbss_scene_capsule *c = &o->capsules->capsules[index];
        return placed_segment(o->at, vec3_load(c->begin), vec3_load(c->end), c->radius);
    }
    const scene_capsule *c = &s->capsules[o->rigid->first_capsule + index];
    scene_segment segment = {.radius = c->radius};
    vbss_scene_transform_capsule(c, o->rigid->body.now.pose, segment.ends);
    return segment;
}

collision_aabb vbss_scene_segment_box(const scene_segment *g)
{
    const double a[3] = {g->ends[0].x, g->ends[0].y, g->ends[0].z};
    const double b[3] = {g->ends[1].x, g->ends[1].y, g->ends[1].z};
    collision_aabb box;
    for (int k = 0; k < 3; k++) {
        box.low[k] = vbss_min(a[k], b[k]) - g->radius;
        box.high[k] = vbss_max(a[k], b[k]) + g->radius;
    }
    return box;
}

collision_aabb vbss_scene_outline_box(const scene_object *s, const scene_outline *o)
{
    collision_aabb box = aabb_empty();
    for (uint32_t i = 0; i < vbss_scene_outline_segments(o); i++) {
        const scene_segment g = vbss_scene_outline_segment(s, o, i);
        const collision_aabb part = vbss_scene_segment_box(&g);
        aabb_extend(&box, &part);
    }
    return box;
}
