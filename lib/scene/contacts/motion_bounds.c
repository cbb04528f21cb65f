/* Motion bounds: the expected displacement of each node and capsule end in a substep. It is an
 * estimate from velocities and targets, or the motion of the rejected attempt before. That of a host
 * surface is exact. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

static void set_thread_displacements(scene_object *s, const scene_thread *b,
                                     const scene_substep *substep)
{
    const thread_object *t = b->thread;
    vec3 *displacements = s->step.expected_displacements + b->first_node;
    for (uint32_t i = 0; i < t->node_count; i++) {
        displacements[i] = substep->uses_trial_motion ? vec3_sub(t->trial[i], t->now.x[i])
                                                      : vec3_scale(t->now.v[i], substep->h);
    }
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id != 0 && vbss_thread_prescribes_motion(a->kind)) {
            vec3 target = vbss_thread_attachment_position(a, substep->end_fraction);
            displacements[a->node] = vec3_sub(target, t->now.x[a->node]);
        }
    }
}

static void set_rigid_displacements(scene_object *s, scene_rigid *r, const scene_substep *substep)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction,
                                  substep->end_fraction};
    vbss_rigid_motion next_motion;
    if (r->capsule_count == 0 && !r->is_rigid_mesh) { /* a static mesh or a plane */
        return;
    }
    if (r->kind == VBSS_SCENE_RIGID_DRIVEN) {
        next_motion = vbss_rigid_target_motion(&r->body, &p);
    } else {
        vbss_rigid_predict(&r->body, &p, &next_motion);
    }
    r->expected = substep->uses_trial_motion ? r->trial : next_motion.pose;
    for (uint32_t i = r->first_capsule; i < r->first_capsule + r->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        vec3 *displacements =
            s->step.expected_displacements + s->config.node_capacity + 2 * (size_t)i;
        vbss_scene_transform_capsule(c, r->body.now.pose, c->now);
        for (int k = 0; k < 2; k++) {
            vec3 target = substep->uses_trial_motion
                              ? c->trial[k]
                              : pose_apply(next_motion.pose, c->local_trial[k]);
            displacements[k] = vec3_sub(target, c->now[k]);
        }
    }
}

static void set_drain_displacements(scene_drain *b, const scene_substep *substep)
{
    const drain_object *d = b->drain;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        b->expected_displacements[i] = substep->uses_trial_motion ? vec3_sub(d->trial[i], d->x[i])
                                                                  : vec3_scale(d->v[i], substep->h);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            vec3 target = vbss_drain_attachment_position(a, substep->end_fraction);
            b->expected_displacements[a->node] = vec3_sub(target, d->x[a->node]);
        }
    }
    double max_squared = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        max_squared = vbss_max_or_nan(vec3_norm_squared(b->expected_displacements[i]), max_squared);
    }
    b->max_displacement = sqrt(max_squared);
}

/* A frozen body stays where it is, its jaws as well. */
static void set_no_displacements(scene_object *s, scene_body *b)
{
    vec3 *displacements = s->step.expected_displacements;
    uint32_t count = 0;
    if (b->kind == SCENE_BODY_THREAD) {
        displacements += b->thread.first_node;
        count = b->thread.thread->node_count;
    } else if (b->kind == SCENE_BODY_DRAIN) {
        displacements = b->drain.expected_displacements;
        count = b->drain.drain->mesh.node_count;
        b->drain.max_displacement = 0.0;
    } else if (scene_host_surface_of(b) != NULL) {
        vbss_scene_hold_host_surface(b->rigid.surface);
    } else if (b->kind == SCENE_BODY_RIGID) {
        scene_rigid *r = &b->rigid;
        r->expected = r->body.now.pose;
        displacements += s->config.node_capacity + 2 * (size_t)r->first_capsule;
        count = 2 * r->capsule_count;
        for (uint32_t i = r->first_capsule; i < r->first_capsule + r->capsule_count; i++) {
            scene_capsule *c = &s->capsules[i];
            c->local_trial[0] = c->local[0];
            c->local_trial[1] = c->local[1];
            vbss_scene_transform_capsule(c, r->body.now.pose, c->now);
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        displacements[i] = vec3_zero();
    }
}

void vbss_scene_set_bounds_at_rest(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        set_no_displacements(s, &s->bodies[i]);
    }
}

void vbss_scene_set_motion_bounds(scene_object *s, const scene_substep *substep)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].is_frozen) {
            set_no_displacements(s, &s->bodies[i]);
        } else if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            set_thread_displacements(s, &s->bodies[i].thread, substep);
        } else if (scene_host_surface_of(&s->bodies[i]) != NULL) {
            vbss_scene_advance_host_surface(s->bodies[i].rigid.surface, substep);
        } else if (s->bodies[i].kind == SCENE_BODY_RIGID) {
            set_rigid_displacements(s, &s->bodies[i].rigid, substep);
        } else if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            set_drain_displacements(&s->bodies[i].drain, substep);
        }
    }
}
