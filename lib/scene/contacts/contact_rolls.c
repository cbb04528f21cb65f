/* Contacts of threads with friction torque. A contact touches the surface of the thread, which moves across the
 * thread as its section rolls, so roll is part of the slip that friction resists. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"
#include "thread/twist.h"

/* Segments of a thread that roll with one side of a contact, by weight. */
typedef struct rolling {
    uint32_t count, segments[2];
    double weight;
} rolling;

/* A node rolls as its two segments do in the mean. */
static rolling find_rolling(const scene_object *s, const contact_constraint *constraint,
                            const thread_object *t, bool is_b)
{
    const contact_key *key = &constraint->key;
    const uint32_t feature = is_b ? key->feature_b : key->feature_a, last = t->node_count - 2;
    if (key->kind == VBSS_SCENE_CONTACT_SEGMENTS) {
        return (rolling){1, {scene_geometry_of(s, constraint)->segments[is_b ? 1 : 0], 0}, 1.0};
    }
    if (is_b || !scene_is_node_contact(key->kind)) {
        return (rolling){1, {feature, 0}, 1.0};
    }
    if (feature == 0 || feature > last) {
        return (rolling){1, {feature == 0 ? 0 : last, 0}, 1.0};
    }
    return (rolling){2, {feature - 1, feature}, 0.5};
}

/* The thread of one side of a contact, if the contact can roll it; or NULL. */
static const scene_thread *find_rolled_thread(const scene_body *b)
{
    return scene_active_kind(b) == SCENE_BODY_THREAD && thread_has_friction_torque(b->thread.thread)
               ? &b->thread
               : NULL;
}

static void choose_rolls_of_side(const scene_object *s, const contact_constraint *constraint,
                                 bool is_b)
{
    const scene_body *body =
        vbss_scene_body(s, is_b ? constraint->key.body_b : constraint->key.body_a);
    const scene_thread *b = body != NULL ? find_rolled_thread(body) : NULL;
    if (b != NULL) {
        const rolling r = find_rolling(s, constraint, b->thread, is_b);
        for (uint32_t k = 0; k < r.count; k++) {
            vbss_thread_add_contact_roll(b->thread, r.segments[k]);
        }
    }
}

void vbss_scene_choose_rolls(scene_object *s)
{
    if (s->step.spring_capacity == 0) { /* no thread has friction torque */
        return;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD &&
            thread_has_friction_torque(s->bodies[i].thread.thread)) {
            vbss_thread_clear_contact_rolls(s->bodies[i].thread.thread);
        }
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        if (!constraint->is_bilateral) {
            choose_rolls_of_side(s, constraint, false);
            choose_rolls_of_side(s, constraint, true);
        }
    }
}

/* The surface of side a is at -radius normal from the centre, and moves by normal x tangent for each metre of
 * radius times roll. Side b is opposite in both place and sign. */
void vbss_scene_add_roll_jacobian(const scene_object *s, contact_constraint *constraint,
                                  const scene_body *b, bool is_b)
{
    const scene_thread *thread = b != NULL ? find_rolled_thread(b) : NULL;
    if (thread == NULL) {
        return;
    }
    const thread_object *t = thread->thread;
    const rolling r = find_rolling(s, constraint, t, is_b);
    for (uint32_t k = 0; k < r.count; k++) {
        const uint32_t segment = r.segments[k];
        const vec3 across =
            vec3_cross(constraint->normal, vbss_thread_chord_direction(t->trial, segment));
        constraint->jacobian[constraint->jacobian_block_count++] = (contact_jacobian_block){
            .block = scene_first_roll_block(thread) + segment / SCENE_ROLLS_PER_BLOCK,
            .is_rotation = true,
            .is_roll = true,
            .component = (uint8_t)(segment % SCENE_ROLLS_PER_BLOCK),
            .weight = r.weight,
            .arm = across};
        constraint->relative_displacement =
            vec3_add_scaled(constraint->relative_displacement,
                            r.weight * t->config.radius * t->roll_angles[segment], across);
    }
}
