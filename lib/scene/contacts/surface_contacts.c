/* Contacts with drains, static meshes and host surfaces: a point and a triangle, two edges, a node and a plane.
 *
 * A point touches a triangle only if the closest point is in the triangle's interior. If it is on
 * an edge, the contacts of that edge account for it. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

/* Expected displacements of a feature's vertices. Those of a drain or moving mesh are gathered
 * into `buffer`. A static mesh has one, of zero. */
static const vec3 *feature_displacements(const scene_object *s, const scene_body *b,
                                         const contact_key *key, bool is_b, vec3 buffer[3],
                                         uint32_t *count)
{
    uint32_t feature = is_b ? key->feature_b : key->feature_a, nodes[3];
    bool is_edge = key->kind == VBSS_SCENE_CONTACT_SIDES;
    if (b->kind == SCENE_BODY_DRAIN) {
        *count = vbss_scene_surface_feature_nodes(s, b, key->kind, is_b, feature, nodes);
        for (uint32_t k = 0; k < *count; k++) {
            buffer[k] = b->drain.expected_displacements[nodes[k]];
        }
        return buffer;
    }
    const scene_host_surface *h = scene_host_surface_of(b);
    if (h != NULL) {
        *count = vbss_scene_surface_feature_nodes(s, b, key->kind, is_b, feature, nodes);
        for (uint32_t k = 0; k < *count; k++) {
            buffer[k] = h->expected_displacements[nodes[k]];
        }
        return buffer;
    }
    if (scene_is_rigid_mesh(b)) {
        const vec3 *local = s->collision->shapes[b->shape]->posed->local;
        *count = vbss_scene_surface_feature_nodes(s, b, key->kind, is_b, feature, nodes);
        for (uint32_t k = 0; k < *count; k++) {
            buffer[k] = vec3_sub(pose_apply(b->rigid.expected, local[nodes[k]]),
                                 pose_apply(b->rigid.body.now.pose, local[nodes[k]]));
        }
        return buffer;
    }
    if (scene_is_static_mesh(b)) {
        buffer[0] = vec3_zero();
        *count = 1;
        return buffer;
    }
    *count = is_edge ? 2 : 1;
    if (b->kind == SCENE_BODY_THREAD) {
        return s->step.expected_displacements + b->thread.first_node + feature;
    }
    const vec3 *first = s->step.expected_displacements + s->config.node_capacity +
                        2 * (size_t)b->rigid.first_capsule;
    /* The two ends of a capsule are adjacent. */
    return first + (is_edge ? 2 * (size_t)feature : feature);
}

static bool add_contact(scene_object *s, const contact_key *key, const scene_body *a,
                        const scene_body *b, const collision_candidate *q)
{
    vec3 buffer_a[3], buffer_b[3];
    scene_contact_pair m = {.a = a, .b = b, .candidate = q};
    m.displacements_a = feature_displacements(s, a, key, false, buffer_a, &m.count_a);
    m.displacements_b = feature_displacements(s, b, key, true, buffer_b, &m.count_b);
    return vbss_scene_add_contact(s, key, &m);
}

bool vbss_scene_add_surface_contact(scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    if (q->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        const contact_key key = {VBSS_SCENE_CONTACT_POINT_FACE, a->number, q->a, b->number, q->b};
        return add_contact(s, &key, a, b, q);
    }
    /* Side b is a mesh if there is one, otherwise a drain. */
    bool swapped = scene_is_mesh(a) || !scene_has_triangles(b);
    const contact_key key = {VBSS_SCENE_CONTACT_SIDES, swapped ? b->number : a->number,
                             swapped ? q->b : q->a, swapped ? a->number : b->number,
                             swapped ? q->a : q->b};
    return add_contact(s, &key, swapped ? b : a, swapped ? a : b, q);
}

bool vbss_scene_add_drain_plane_contacts(scene_object *s, const scene_body *b,
                                         const scene_body *plane)
{
    const drain_object *d = b->drain.drain;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        const contact_key key = {VBSS_SCENE_CONTACT_DRAIN_FLOOR, b->number, i,
                                 plane != NULL ? plane->number : 0, 0};
        const scene_sphere sphere = {b, d->x[i], b->drain.expected_displacements[i],
                                     0.5 * d->config.thickness};
        if (!vbss_scene_add_plane_contact(s, &key, &sphere, plane)) {
            return false;
        }
    }
    return true;
}
