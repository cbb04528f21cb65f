/* The trial state of a part becomes the state. */
#include "scene/attempt.h"
#include "scene/holes.h"
#include "scene/scene.h"

/* A motion that needs halving is not smooth: so many steps more are damped. */
enum { SETTLING_STEPS = 2 };

static void commit_thread(scene_thread *b, double h)
{
    thread_object *t = b->thread;
    vbss_thread_commit(t, &b->integration);
    t->statistics.first_order += b->damped;
    t->previous_h = h;
    t->is_acceleration_unknown = false;
}

void vbss_scene_show_part(const scene_object *s)
{
    if (s->watch != NULL) {
        s->watch(s->watcher, s);
    }
}

void vbss_scene_commit_capsules(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->local[0] = c->local_trial[0];
        c->local[1] = c->local_trial[1];
    }
}

void vbss_scene_commit(scene_object *s, const scene_part *part)
{
    const vbss_rigid_substep p = {part->step, part->begin, part->end};
    vbss_scene_show_part(s);
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            commit_thread(&b->thread, part->h);
        } else if (b->kind == BODY_RIGID) {
            scene_rigid *r = &b->rigid;
            if (r->kind == VBSS_RIGID_DRIVEN) {
                r->body.now = r->predicted;
            } else {
                vbss_rigid_commit(&r->body, &p, &r->predicted, &r->trial);
                r->pull = vbss_rigid_coupling_wrench(&r->body, &p, &r->body.now);
            }
        } else if (b->kind == BODY_DRAIN) {
            vbss_drain_commit(b->drain.drain, part->h);
        }
    }
    vbss_scene_commit_capsules(s);
    vbss_scene_keep_holes(s);
    vbss_scene_move_holes(s);
    vbss_contact_store_warm_start(s->contacts);
    s->statistics.parts++;
}

void vbss_scene_unsettle(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            s->bodies[i].thread.thread->damped_steps_left = SETTLING_STEPS + 1;
        }
    }
}
