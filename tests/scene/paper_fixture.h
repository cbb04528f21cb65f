/* What the tests of method VBLAST share: a scene in a watched context, threads and tools made in one line, looks at
 * them. */
#ifndef VBSS_TESTS_SCENE_PAPER_FIXTURE_H
#define VBSS_TESTS_SCENE_PAPER_FIXTURE_H

#include <string.h>

#include "collision/closest.h"
#include "harness/harness.h"
#include "scene/api/api.h"
#include "scene/world/world.h"
#include "fixtures/scene_build.h"

#define FRAME (1.0 / 150.0) /* of the paper, s */
#define RADIUS 0.125e-3

enum { SEGMENTS = 30, NODES = SEGMENTS + 1 };

/* ---- making */

typedef struct stage {
    harness_memory memory;
    vbss_context *context;
    vbss_scene_config config;
    vbss_scene *scene;
    vbss_thread *threads[2];
    uint32_t bodies[2];
} stage;

static inline void begin(stage *s)
{
    *s = (stage){0};
    s->context = harness_context(&s->memory);
    expect_ok(vbss_scene_config_init(&s->config, sizeof s->config));
    s->config.method = VBSS_METHOD_VBLAST;
}

static inline void make(stage *s)
{
    expect_ok(vbss_scene_create(s->context, &s->config, &s->scene));
}

static inline void end(stage *s)
{
    harness_context_end(s->context, &s->memory);
}

static inline vbss_thread_config paper_thread(uint32_t segments)
{
    vbss_thread_config c;
    expect_ok(vbss_thread_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_VBLAST;
    c.segment_count = segments;
    c.drag = 20.0;
    return c;
}

static inline void add(stage *s, int which, const vbss_thread_config *c)
{
    expect_ok(scene_build_thread(s->context, s->scene, c, &s->threads[which], &s->bodies[which]));
}

static inline uint32_t add_capsule(vbss_scene *scene, vbss_scene_rigid_kind kind, vec3 begin,
                                   vec3 end, double r)
{
    uint32_t body = 0;
    vbss_scene_rigid_config c;
    expect_ok(vbss_scene_rigid_config_init(&c, sizeof c));
    c.kind = kind;
    expect_ok(scene_build_capsule(scene, &c, scene_build_rod(begin, end, r), &body));
    return body;
}

/* Along x, its middle over the origin. */
static inline void place_over(stage *s, double y)
{
    vbss_thread_config c = paper_thread(SEGMENTS);
    const double start[3] = {-0.075, y, 0.0};
    memcpy(c.start, start, sizeof start);
    add(s, 0, &c);
}

/* ---- looking */

static inline const vec3 *places(vbss_thread *thread, uint32_t *count)
{
    vbss_view v;
    expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &v, sizeof v));
    *count = (uint32_t)v.count;
    return v.data;
}

static inline vbss_view view_of(stage *s, vbss_scene_field field)
{
    vbss_view v;
    expect_ok(vbss_scene_get_view(s->scene, field, &v, sizeof v));
    return v;
}

static inline vbss_baseline_statistics baseline_statistics_of(stage *s)
{
    vbss_baseline_statistics t;
    expect_ok(vbss_scene_get_baseline_statistics(s->scene, &t, sizeof t));
    return t;
}

static inline vbss_scene_statistics statistics_of(stage *s)
{
    vbss_scene_statistics t;
    expect_ok(vbss_scene_get_statistics(s->scene, &t, sizeof t));
    return t;
}

static inline vbss_scene_rigid_state rigid_of(stage *s, uint32_t body)
{
    vbss_scene_rigid_state r;
    expect_ok(vbss_scene_get_rigid(s->scene, body, &r, sizeof r));
    return r;
}

static inline uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

/* From the nearest point of segments p to that of segments q. */
static inline vec3 between(const vec3 *p, uint32_t n, const vec3 *q, uint32_t m)
{
    vec3 best = vec3_make(1.0, 0.0, 0.0);
    for (uint32_t i = 0; i + 1 < n; i++) {
        for (uint32_t k = 0; k + 1 < m; k++) {
            double s, u;
            vec3 apart = closest_between_edges(vec3_sub(p[i + 1], p[i]), vec3_sub(q[k + 1], q[k]),
                                               vec3_sub(q[k], p[i]), &s, &u);
            best = vec3_norm(apart) < vec3_norm(best) ? apart : best;
        }
    }
    return best;
}

static inline double distance_to_axis(stage *s, vec3 begin_of, vec3 end_of)
{
    uint32_t n;
    const vec3 axis[2] = {begin_of, end_of}, *x = places(s->threads[0], &n);
    return vec3_norm(between(x, n, axis, 2));
}

/* ---- two hands at the ends */

typedef struct hands {
    vec3 at[2];
    uint32_t ids[2];
} hands;

static inline hands hold_ends(stage *s, int which)
{
    hands h;
    uint32_t n;
    const vec3 *x = places(s->threads[which], &n);
    for (int k = 0; k < 2; k++) {
        vbss_thread_attachment a;
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.node = k == 0 ? 0 : n - 1;
        h.at[k] = x[a.node];
        vec3_store(a.position, h.at[k]);
        expect_ok(vbss_thread_attach(s->threads[which], &a, &h.ids[k]));
    }
    return h;
}

#endif
