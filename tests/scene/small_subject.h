/* A scene that has lived, for calls that must refuse and leave it as it was to the bit. */
#ifndef VBSS_TESTS_SCENE_SMALL_SUBJECT_H
#define VBSS_TESTS_SCENE_SMALL_SUBJECT_H

#include "scene/small.h"

static inline void tiny_scene(small *s)
{
    small_begin(s);
    s->config.node_capacity = 20;
    s->config.contact_capacity = s->config.candidate_capacity = 16;
}

static const vbss_scene_capsule subject_ball = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3};

typedef struct subject {
    small s;
    vbss_thread *thread; /* of 12 segments */
    uint32_t line, driven, free, pin, weld;
    uint64_t hash, generation;
} subject;

static inline void begin_subject(subject *t)
{
    small *s = &t->s;
    tiny_scene(s);
    s->config.pin_capacity = 3;
    s->config.rigid_capacity = 3;
    s->config.capsule_capacity = 3;
    s->config.floor = 1;
    small_create(s);
    t->line =
        small_thread(s, vec3_make(0.0, 0.01, 0.0), vec3_make(0.024, 0.01, 0.0), 12, &t->thread);
    vec3 half = vec3_make(0.0, 0.0, 2e-3);
    t->driven = small_stick(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 0.01, 0.0), half, 1e-3);
    t->free = small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(0.024, 0.01, 0.0), half, 1e-3);
    t->pin = small_pin(s, t->line, 0, t->driven);
    t->weld = small_pin(s, t->line, 12, t->free);
    small_steps(s, 3, 1e-3);
    s->rigid.capsules = &subject_ball;
    s->rigid.capsule_count = 1;
    t->hash = small_hash(s);
    t->generation = small_view(s, VBSS_SCENE_VIEW_CONTACTS).generation;
}

static inline void unchanged(subject *t, vbss_result wanted, vbss_result got)
{
    const char *text;
    expect_result(wanted, got);
    expect_ok(vbss_context_get_last_error(t->s.context, NULL, &text));
    assert_true(strlen(text) > 0);
    assert_true(small_hash(&t->s) == t->hash);
    assert_true(small_view(&t->s, VBSS_SCENE_VIEW_CONTACTS).generation == t->generation);
}

#endif
