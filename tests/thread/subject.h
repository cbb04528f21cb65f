/* A thread that has lived, for calls that must refuse and leave it as it was to the bit. */
#ifndef VBSS_TESTS_THREAD_SUBJECT_H
#define VBSS_TESTS_THREAD_SUBJECT_H

#include "thread/fixture.h"

typedef struct subject {
    fixture f;
    vbss_thread *thread; /* of 12 segments */
    uint32_t pin, clamp, mass, force;
    uint64_t hash;
} subject;

static inline void begin_subject(subject *s)
{
    begin(&s->f);
    s->f.config.cut_capacity = 1;
    s->thread = make(&s->f);
    s->pin = hold(s->thread, VBSS_THREAD_ATTACHMENT_PIN, 3, vec3_make(0.03, 0.0, 0.0));
    s->clamp = hold(s->thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, vec3_zero());
    s->mass = hold(s->thread, VBSS_THREAD_ATTACHMENT_MASS, 5, vec3_zero());
    s->force = hold(s->thread, VBSS_THREAD_ATTACHMENT_FORCE, 5, vec3_zero());
    steps(s->thread, 3, 1e-3);
    s->hash = hash_of(s->thread);
}

static inline void end_subject(subject *s)
{
    end(&s->f);
}

static inline void unchanged(subject *s, vbss_result wanted, vbss_result got)
{
    expect_result(wanted, got);
    assert_true(hash_of(s->thread) == s->hash);
}

#endif
