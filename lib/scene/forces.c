/* What contacts and pins do to the rigid bodies, and what is shown of contacts. */
#include "scene/events.h"
#include "scene/pins.h"
#include "scene/scene.h"

static void add_force(scene_body *b, vec3 point, vec3 force)
{
    if (b != NULL && b->kind == BODY_RIGID) {
        scene_rigid *r = &b->rigid;
        vec3 arm = vec3_sub(point, r->body.now.pose.position);
        r->force = vec3_add(r->force, force);
        r->torque = vec3_add(r->torque, vec3_cross(arm, force));
    }
}

static void show_contact(scene_object *s, const scene_hit *hit)
{
    uint32_t i = s->contact_count++;
    const contact_key *key = &hit->key;
    const uint32_t features[5] = {key->kind, key->body_a, key->feature_a, key->body_b,
                                  key->feature_b};
    for (int k = 0; k < 5; k++) {
        s->contact_features[i][k] = features[k];
    }
    s->contact_points[i] = hit->point;
    s->contact_normals[i] = hit->normal;
    s->contact_forces[i] = hit->force;
    s->contact_gaps[i] = hit->gap;
}

/* The body that a block moves, or that holds it: a rigid one, by its translation or by a pin. */
static scene_body *bearer_of(scene_object *s, uint32_t b)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *body = &s->bodies[i];
        if (body->kind == BODY_RIGID && body->rigid.blocks.first == b) {
            return body;
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->attachment != 0 && vbss_scene_pin_holds(s, p) &&
            vbss_scene_body(s, p->thread)->thread.first_block + p->node == b) {
            return vbss_scene_body(s, p->body);
        }
    }
    return NULL;
}

bool vbss_scene_find_force(const contact_set *set, uint32_t i, vec3 *force)
{
    const contact_constraint *row = &set->constraints[i];
    contact_solution is = row->solution;
    if (set->is_stopped_early &&
        !row->is_bilateral) { /* what the law says of where that is nothing has felt */
        *force = set->current[i].force;
        return vec3_norm_squared(*force) > 0.0;
    }
    if (row->is_bilateral) { /* of the state itself: laid again, it knows nothing of what it held */
        (void)vbss_contact_update_solution(row, vec3_zero(), &is);
    }
    *force = vec3_add_scaled(is.tangential_force, is.normal_force, row->normal);
    return row->solution.status != CONTACT_OPEN;
}

static void add_contacts(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        vec3 force;
        if (!vbss_scene_find_force(s->contacts, i, &force)) {
            continue;
        }
        const double gap = row->gap - row->fold_allowance;
        const scene_hit hit = {row->key, row->normal, force, row->point, gap};
        show_contact(s, &hit);
        for (uint32_t k = 0; k < row->jacobian_block_count; k++) {
            const contact_jacobian_block *term = &row->jacobian[k];
            if (!term->is_rotation) {
                add_force(bearer_of(s, term->block), row->point, vec3_scale(force, term->weight));
            }
        }
    }
}

/* PAPER */
static void add_hits(scene_object *s)
{
    for (uint32_t i = 0; i < s->hit_count; i++) {
        const scene_hit *hit = &s->hits[i];
        show_contact(s, hit);
        add_force(vbss_scene_body(s, hit->key.body_a), hit->point, hit->force);
        add_force(vbss_scene_body(s, hit->key.body_b), hit->point, vec3_neg(hit->force));
    }
}

/* The body holds the node against what the thread and its inertia do. */
static void add_pins(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        scene_body *b = vbss_scene_body(s, p->body);
        if (b == NULL || !vbss_scene_pin_holds(s, p)) {
            continue;
        }
        const thread_object *t = vbss_scene_body(s, p->thread)->thread.thread;
        vec3 holding = s->config.method == VBSS_METHOD_PAPER
                           ? vbss_thread_paper_force(t, p->node)
                           : vbss_thread_implicit_constraint_force(t, p->node);
        add_force(b, t->now.x[p->node], vec3_neg(holding));
    }
}

void vbss_scene_note_forces(scene_object *s)
{
    s->contact_count = 0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        s->bodies[i].rigid.force = s->bodies[i].rigid.torque = vec3_zero();
    }
    if (s->contacts != NULL) {
        add_contacts(s);
    }
    add_hits(s);
    add_pins(s);
    s->statistics.contacts = s->contact_count;
}
