/* Broad phase: finds pairs of features whose swept bounding boxes overlap. */
#include "base/error.h"
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

#include <string.h>

static vbss_result sweep_shape(scene_object *s, const scene_body *b)
{
    uint32_t count = 0;
    const vec3 *displacements = s->step.expected_displacements;
    vec3 *start = s->scratch.vertices;
    if (scene_is_rigid_mesh(b)) {
        return vbss_collision_set_pose_motion(s->collision, b->shape, b->rigid.body.now.pose,
                                              b->rigid.expected, SCENE_EXTRAPOLATION_RATIO);
    }
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        count = t->node_count;
        displacements += b->thread.first_node;
        memcpy(start, t->now.x, count * sizeof *start);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        count = b->drain.drain->mesh.node_count;
        displacements = b->drain.expected_displacements;
        start = b->drain.vertices;
        memcpy(start, b->drain.drain->x, count * sizeof *start);
    } else if (scene_host_surface_of(b) != NULL) {
        const scene_host_surface *h = scene_host_surface_of(b);
        count = h->vertex_count;
        displacements = h->expected_displacements;
        start = h->swept;
        memcpy(start, h->now, count * sizeof *start);
    } else {
        const scene_rigid *r = &b->rigid;
        count = 2 * r->capsule_count;
        displacements += s->config.node_capacity + 2 * (size_t)r->first_capsule;
        for (uint32_t i = 0; i < count; i++) {
            start[i] = s->capsules[r->first_capsule + i / 2].now[i % 2];
        }
    }
    vec3 *end = start + count;
    for (uint32_t i = 0; i < count; i++) {
        end[i] = vec3_add_scaled(start[i], SCENE_EXTRAPOLATION_RATIO, displacements[i]);
    }
    VBSS_TRY(vbss_collision_set_motion(scene_collision(s), b->shape, &start->x, &end->x, count));
    vbss_collision_update_displacements(s->collision->shapes[b->shape]);
    return VBSS_OK;
}

vbss_result vbss_scene_run_broad_phase(scene_object *s)
{
    VBSS_TRY(vbss_collision_find_candidates(scene_collision(s)));
    vbss_scene_filter_candidates(s);
    s->step.edge_pair_count = s->collision->candidate_count;
    while (s->step.edge_pair_count > 0 &&
           s->collision->candidates[s->step.edge_pair_count - 1].kind !=
               VBSS_COLLISION_PAIR_EDGE_EDGE) {
        s->step.edge_pair_count--;
    }
    return VBSS_OK;
}

vbss_result vbss_scene_find_candidates(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_NONE && !scene_is_static_mesh(&s->bodies[i]) &&
            !scene_is_plane(&s->bodies[i])) {
            VBSS_TRY(sweep_shape(s, &s->bodies[i]));
        }
    }
    return vbss_scene_run_broad_phase(s);
}
