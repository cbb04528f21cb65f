/* Features of bodies: the axis of a segment, capsule or side, the nodes of a drain's feature,
 * and arc lengths along a suture. */
#include "scene/world/world.h"

#include <string.h>

bool vbss_scene_feature_segment(const scene_object *s, uint32_t number, uint32_t feature,
                                vec3 axis[2])
{
    const scene_body *b = vbss_scene_body(s, number);
    if (b == NULL) {
        return false;
    }
    if (b->kind == SCENE_BODY_THREAD) {
        memcpy(axis, b->thread.thread->now.x + feature, 2 * sizeof *axis);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        const uint32_t *edge = s->collision->shapes[b->shape]->edges[feature];
        axis[0] = b->drain.drain->x[edge[0]];
        axis[1] = b->drain.drain->x[edge[1]];
    } else if (scene_is_mesh(b)) {
        const collision_shape *shape = s->collision->shapes[b->shape];
        const scene_vertices x = scene_mesh_vertices(s, b);
        if (feature >=
            shape->edge_count) { /* a triangle: a mesh may have more of them than sides */
            return false;
        }
        axis[0] = scene_vertex(x, shape->edges[feature][0]);
        axis[1] = scene_vertex(x, shape->edges[feature][1]);
    } else {
        vbss_scene_transform_capsule(&s->capsules[b->rigid.first_capsule + feature],
                                     b->rigid.body.now.pose, axis);
    }
    return true;
}

uint32_t vbss_scene_surface_feature_nodes(const scene_object *s, const scene_body *surface,
                                          uint32_t kind, bool is_b, uint32_t feature,
                                          uint32_t nodes[3])
{
    const collision_shape *shape = s->collision->shapes[surface->shape];
    if (kind == VBSS_SCENE_CONTACT_SIDES) {
        nodes[0] = shape->edges[feature][0];
        nodes[1] = shape->edges[feature][1];
        return 2;
    }
    if (kind == VBSS_SCENE_CONTACT_POINT_FACE && is_b) {
        for (int k = 0; k < 3; k++) {
            nodes[k] = shape->triangles[feature][k];
        }
        return 3;
    }
    nodes[0] = feature;
    return 1;
}

bool vbss_scene_is_suture(const scene_body *b)
{
    return b->kind == SCENE_BODY_THREAD || (b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL);
}

double vbss_scene_suture_arc_length(const scene_body *suture, uint32_t segment, double fraction)
{
    if (suture->kind == SCENE_BODY_THREAD) {
        const thread_object *t = suture->thread.thread;
        double along =
            fraction > 0.0 ? fraction * t->rest[segment] : 0.0; /* the last node has no segment */
        return vbss_thread_arc_length(t, segment) + along;
    }
    const needle_object *n = suture->rigid.needle;
    double start = vbss_needle_vertex_arc(n, segment);
    return start + fraction * (vbss_needle_vertex_arc(n, segment + 1) - start);
}

bool vbss_scene_is_at_tip(const scene_body *needle, double arc)
{
    return arc <= SCENE_TIP_LENGTH_RATIO * needle->rigid.needle->config.wire_radius;
}
