/* Commit: the trial state of a substep becomes the state. */
#include "scene/solve/solve.h"
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"
#include "thread/tuning.h"

static void commit_thread(scene_thread *b, double h)
{
    thread_object *t = b->thread;
    vbss_thread_commit(t, &b->integration);
    t->statistics.first_order += b->is_damped;
    t->previous_h = h;
    t->is_acceleration_unknown = false;
}

void vbss_scene_notify_substep(const scene_object *s)
{
    if (s->on_substep != NULL) {
        s->on_substep(s->on_substep_data, s);
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

/* Entries between bodies that take no part in the substep stay. */
static void store_warm_start(scene_object *s)
{
    contact_set *set = s->contacts;
    if (s->cursor.group_count == 1) {
        vbss_contact_store_warm_start(set);
        return;
    }
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        const contact_key *key = &set->warm_start[i].key;
        s->scratch.keeps_entry[i] = !scene_is_active(vbss_scene_body(s, key->body_a)) &&
                                    !scene_is_active(vbss_scene_body(s, key->body_b));
    }
    vbss_contact_store_warm_start_beside(set, s->scratch.keeps_entry);
}

void vbss_scene_commit(scene_object *s, const scene_substep *substep)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction,
                                  substep->end_fraction};
    vbss_scene_notify_substep(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (scene_active_kind(b) == SCENE_BODY_THREAD) {
            commit_thread(&b->thread, substep->h);
        } else if (scene_active_kind(b) == SCENE_BODY_RIGID) {
            scene_rigid *r = &b->rigid;
            if (r->kind == VBSS_SCENE_RIGID_DRIVEN) {
                r->body.now = r->predicted;
            } else {
                vbss_rigid_commit(&r->body, &p, &r->predicted, &r->trial);
                r->coupling_wrench = vbss_rigid_coupling_wrench(&r->body, &p, &r->body.now);
            }
        } else if (scene_active_kind(b) == SCENE_BODY_DRAIN) {
            vbss_drain_commit(b->drain.drain, substep->h);
        }
    }
    vbss_scene_commit_capsules(s);
    vbss_scene_commit_host_surfaces(s, true);
    vbss_scene_commit_holes(s);
    vbss_scene_advance_holes(s);
    store_warm_start(s);
    s->report.statistics.parts++;
}

void vbss_scene_request_damping_of(scene_body *b)
{
    if (b->kind == SCENE_BODY_THREAD) {
        b->thread.thread->damped_steps_left = THREAD_DAMPED_STEPS + 1;
    }
}

void vbss_scene_request_damping(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (!s->bodies[i].is_frozen) {
            vbss_scene_request_damping_of(&s->bodies[i]);
        }
    }
}
