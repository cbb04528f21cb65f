/* What contacts remember, by where their features are: the same before and after a cut, whatever the numbers. */
#ifndef VBSS_TESTS_SCENE_CUT_CONTACTS_H
#define VBSS_TESTS_SCENE_CUT_CONTACTS_H

#include "collision/closest.h"
#include "scene/cut_rig.h"
#include "fixtures/contact_scenes.h"

enum { CUT_CONTACTS = 1024 };

typedef struct remembered {
    contact_warm_start_entry memory;
    vec3 axes[2][2];
    bool used;
} remembered;
typedef struct remembered_list {
    uint32_t count;
    remembered all[CUT_CONTACTS];
} remembered_list;

static inline bool cut_is_node(const contact_key *key, int side)
{
    return side == 0 && (key->kind == VBSS_SCENE_CONTACT_NODE_CAPSULE ||
                         key->kind == VBSS_SCENE_CONTACT_NODE_FLOOR);
}

static inline void cut_axis(const scene_object *s, const contact_key *key, int side, vec3 axis[2])
{
    uint32_t feature = side == 0 ? key->feature_a : key->feature_b;
    const scene_body *b = vbss_scene_body(s, side == 0 ? key->body_a : key->body_b);
    axis[0] = axis[1] = vec3_zero();
    if (b == NULL) { /* the floor */
        return;
    }
    if (b->kind == SCENE_BODY_RIGID) {
        vbss_scene_transform_capsule(&s->capsules[b->rigid.first_capsule + feature],
                                     b->rigid.body.now.pose, axis);
        return;
    }
    const thread_object *t = b->thread.thread;
    assert_true(feature + !cut_is_node(key, side) < t->node_count);
    axis[0] = t->now.x[feature];
    axis[1] = t->now.x[feature + !cut_is_node(key, side)];
}

static inline void cut_remember(const scene_object *s, remembered_list *list)
{
    list->count = s->contacts->warm_start_count;
    assert_true(list->count <= CUT_CONTACTS);
    for (uint32_t i = 0; i < list->count; i++) {
        remembered *r = &list->all[i];
        r->memory = s->contacts->warm_start[i];
        r->used = false;
        cut_axis(s, &r->memory.key, 0, r->axes[0]);
        cut_axis(s, &r->memory.key, 1, r->axes[1]);
    }
}

static inline double cut_apart(const vec3 a[2], const vec3 b[2])
{
    double at[2];
    return vec3_norm(closest_between_edges(vec3_sub(a[1], a[0]), vec3_sub(b[1], b[0]),
                                           vec3_sub(b[0], a[0]), &at[0], &at[1]));
}

/* The same, or a part of it. */
static inline bool cut_within(const vec3 whole[2], const vec3 part[2])
{
    bool begin = vec3_distance(whole[0], part[0]) == 0.0;
    bool end = vec3_distance(whole[1], part[1]) == 0.0;
    double sum = vec3_distance(whole[0], part[0]) + vec3_distance(part[0], part[1]) +
                 vec3_distance(part[1], whole[1]);
    return (begin || end) && fabs(sum - vec3_distance(whole[0], whole[1])) < 1e-12;
}

/* Whether y is what became of x, with its sides as they were or the other way round. */
static inline bool cut_became(const remembered *x, const remembered *y, bool round)
{
    const contact_warm_start_entry *m = &x->memory, *n = &y->memory;
    vec3 rubbing = round ? vec3_neg(n->tangential_force) : n->tangential_force;
    return m->key.kind == n->key.kind && m->status == n->status &&
           m->normal_force == n->normal_force && m->friction_ratio == n->friction_ratio &&
           m->is_forward == n->is_forward && vec3_distance(m->tangential_force, rubbing) == 0.0 &&
           cut_within(x->axes[0], y->axes[round]) && cut_within(x->axes[1], y->axes[!round]) &&
           (m->key.body_b == 0 ||
            fabs(cut_apart(x->axes[0], x->axes[1]) - cut_apart(y->axes[0], y->axes[1])) < 1e-9);
}

/* Returns how many have turned round. */
static inline uint32_t cut_expect_same(const remembered_list *before, remembered_list *after)
{
    uint32_t turned = 0;
    assert_int_equal(before->count, after->count);
    for (uint32_t i = 0; i < before->count; i++) {
        bool found = false;
        for (uint32_t k = 0; k < after->count && !found; k++) {
            bool same = !after->all[k].used && cut_became(&before->all[i], &after->all[k], false);
            bool round = !after->all[k].used && cut_became(&before->all[i], &after->all[k], true);
            found = same || round;
            after->all[k].used = after->all[k].used || found;
            turned += round && !same;
        }
        assert_true(found);
    }
    return turned;
}

/* Hands that held what is a piece now hold that. */
static inline void cut_follow(contact_scene *c, const scene_object *s, uint32_t number)
{
    const scene_body *piece = vbss_scene_body(s, number);
    for (uint32_t i = 0; i < c->hand_count; i++) {
        contact_hand *hand = &c->hands[i];
        const vbss_slot *slot = (const vbss_slot *)hand->thread;
        thread_attachment *a;
        if (hand->id != 0 &&
            vbss_thread_find_attachment(slot->object, hand->id, &a) == VBSS_ERROR_NOT_FOUND) {
            expect_ok(vbss_thread_find_attachment(piece->thread.thread, hand->id, &a));
            hand->thread = (vbss_thread *)piece->thread.slot;
            hand->node = a->node;
        }
    }
}

#endif
