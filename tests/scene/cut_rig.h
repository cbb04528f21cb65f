/* Cutting small scenes, and what must be true after any cut. */
#ifndef VBSS_TESTS_SCENE_CUT_RIG_H
#define VBSS_TESTS_SCENE_CUT_RIG_H

#include "scene/contacts/contacts.h"
#include "scene/world/world.h"
#include "scene/small.h"

/* The number of the new piece; its handle is left out if NULL. */
static inline uint32_t cut_at(const small *s, uint32_t thread, double arc_length,
                              vbss_thread **handle)
{
    uint32_t piece = 0;
    vbss_thread *found;
    expect_ok(vbss_scene_cut_thread(s->scene, thread, arc_length, &piece));
    expect_ok(vbss_scene_get_thread(s->scene, piece, &found));
    if (handle != NULL) {
        *handle = found;
    }
    return piece;
}

static inline uint32_t cut_nodes(vbss_thread *thread)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    return (uint32_t)view.count;
}

static inline double cut_length(const thread_object *t)
{
    double length = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        length += t->rest[i];
    }
    return length;
}

static inline thread_object *cut_thread(const scene_object *s, uint32_t body)
{
    const scene_body *b = vbss_scene_body(s, body);
    assert_non_null(b);
    assert_int_equal(b->kind, SCENE_BODY_THREAD);
    return b->thread.thread;
}

/* Of all threads, J; gravity left out. */
static inline double cut_energy(const scene_object *s)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_THREAD) {
            continue;
        }
        thread_object *t = s->bodies[i].thread.thread;
        expect_ok(vbss_thread_prepare_query(t));
        sum += vbss_thread_bending_energy(t);
        for (uint32_t k = 0; k < t->node_count; k++) {
            sum += 0.5 * t->mass[k] * vec3_norm_squared(t->now.v[k]);
        }
        for (uint32_t k = 0; k + 1 < t->node_count; k++) {
            double longer = vec3_distance(t->now.x[k], t->now.x[k + 1]) - t->rest[k];
            sum += 0.5 * t->config.axial_stiffness * longer * longer / t->rest[k];
        }
    }
    return sum;
}

/* The inside agrees with itself. */
static inline void cut_expect_sound(const scene_object *s)
{
    uint32_t nodes = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_THREAD) {
            continue;
        }
        const thread_object *t = b->thread.thread;
        const collision_shape *shape = s->collision->shapes[b->shape];
        assert_int_equal(b->thread.first_node, nodes);
        assert_int_equal(shape->node_count, t->node_count);
        assert_true(shape->node_count <= shape->node_capacity);
        assert_false(shape->is_disabled);
        assert_int_equal(s->body_of_shape[b->shape], i);
        assert_ptr_equal(b->thread.slot->object, t);
        assert_ptr_equal(b->thread.slot->owner, s);
        nodes += t->node_count;
        for (uint32_t k = 0; k < t->node_count; k++) {
            bool welded = vbss_scene_find_weld(s, b->number, k) != NULL;
            assert_int_equal(t->welded[k], welded);
            assert_true(vec3_is_finite(t->now.x[k]) && vec3_is_finite(t->now.v[k]));
        }
    }
    assert_int_equal(s->node_count, nodes);
    assert_true(nodes <= s->node_capacity);
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->id != 0) {
            assert_true(p->node < cut_thread(s, p->thread)->node_count);
            assert_true(vbss_scene_pin_holds(s, p));
        }
    }
    for (uint32_t i = 1; s->contacts != NULL && i < s->contacts->warm_start_count; i++) {
        const contact_warm_start_entry *m = &s->contacts->warm_start[i];
        assert_true(vbss_contact_compare_keys(&m[-1].key, &m->key) < 0);
    }
}

#endif
