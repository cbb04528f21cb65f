/* What the tests of the thread share: a watched context, threads made in one line, looks at them. */
#ifndef VBSS_TESTS_THREAD_FIXTURE_H
#define VBSS_TESTS_THREAD_FIXTURE_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "thread/thread.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_thread_config config; /* the defaults, of 12 segments; change it before making */
} fixture;

static inline void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_thread_config_init(&f->config, sizeof f->config));
    f->config.segment_count = 12;
}

static inline void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static inline vbss_thread *make(fixture *f)
{
    vbss_thread *thread;
    expect_ok(vbss_thread_create(f->context, &f->config, &thread));
    return thread;
}

static inline vbss_thread_attachment plain(vbss_thread_attachment_kind kind, uint32_t node)
{
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    return a;
}

static inline uint32_t attach(vbss_thread *thread, const vbss_thread_attachment *a)
{
    uint32_t id = 0;
    expect_ok(vbss_thread_attach(thread, a, &id));
    return id;
}

static inline uint32_t hold(vbss_thread *thread, vbss_thread_attachment_kind kind, uint32_t node,
                            vec3 position)
{
    vbss_thread_attachment a = plain(kind, node);
    vec3_store(a.position, position);
    return attach(thread, &a);
}

static inline void move(vbss_thread *thread, uint32_t id, vec3 target)
{
    double t[3];
    vec3_store(t, target);
    expect_ok(vbss_thread_set_attachment_target(thread, id, t, NULL));
}

static inline void steps(vbss_thread *thread, uint32_t count, double h)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_thread_step(thread, h));
    }
}

static inline uint64_t hash_of(vbss_thread *thread)
{
    uint64_t hash;
    expect_ok(vbss_thread_get_hash(thread, &hash));
    return hash;
}

static inline vbss_view view_of(vbss_thread *thread, vbss_thread_field field)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(thread, field, &view, sizeof view));
    return view;
}

static inline uint32_t nodes_of(vbss_thread *thread)
{
    return (uint32_t)view_of(thread, VBSS_THREAD_VIEW_POSITIONS).count;
}

static inline vec3 vector_at(vbss_thread *thread, vbss_thread_field field, uint32_t i)
{
    vbss_view view = view_of(thread, field);
    assert_true(i < view.count);
    double v[3];
    memcpy(v, (const char *)view.data + (size_t)i * view.stride_bytes, sizeof v);
    return vec3_load(v);
}

static inline vec3 place_of(vbss_thread *thread, uint32_t node)
{
    return vector_at(thread, VBSS_THREAD_VIEW_POSITIONS, node);
}

static inline double number_at(vbss_thread *thread, vbss_thread_field field, uint32_t i)
{
    vbss_view view = view_of(thread, field);
    double v;
    assert_true(i < view.count);
    memcpy(&v, (const char *)view.data + (size_t)i * view.stride_bytes, sizeof v);
    return v;
}

static inline double rest_length_of(vbss_thread *thread)
{
    double sum = 0.0;
    for (uint32_t i = 0; i + 1 < nodes_of(thread); i++) {
        sum += number_at(thread, VBSS_THREAD_VIEW_REST_LENGTHS, i);
    }
    return sum;
}

static inline vbss_thread_statistics statistics_of(vbss_thread *thread)
{
    vbss_thread_statistics s;
    expect_ok(vbss_thread_get_statistics(thread, &s, sizeof s));
    return s;
}

static inline vbss_thread_energies energies_of(vbss_thread *thread)
{
    vbss_thread_energies e;
    expect_ok(vbss_thread_get_energies(thread, &e, sizeof e));
    return e;
}

static inline vbss_thread_momentum momentum_of(vbss_thread *thread)
{
    vbss_thread_momentum m;
    expect_ok(vbss_thread_get_momentum(thread, &m, sizeof m));
    return m;
}

static inline vbss_thread_reaction reaction_of(vbss_thread *thread, uint32_t id)
{
    vbss_thread_reaction r;
    expect_ok(vbss_thread_get_reaction(thread, id, &r, sizeof r));
    return r;
}

/* Whether all that a thread shows is finite; through its views, as a host sees it. */
static inline bool all_finite(vbss_thread *thread)
{
    const vbss_thread_field fields[] = {VBSS_THREAD_VIEW_POSITIONS, VBSS_THREAD_VIEW_VELOCITIES,
                                        VBSS_THREAD_VIEW_LENGTHS, VBSS_THREAD_VIEW_TENSIONS,
                                        VBSS_THREAD_VIEW_CURVATURES};
    for (size_t f = 0; f < sizeof fields / sizeof fields[0]; f++) {
        vbss_view view = view_of(thread, fields[f]);
        const double *numbers = view.data; /* all of these are dense */
        for (uint64_t i = 0; i < view.count * view.components; i++) {
            if (!isfinite(numbers[i])) {
                return false;
            }
        }
    }
    return isfinite(energies_of(thread).total);
}

#endif
