/* What the tests of drains in scenes share: the drain that hands work on (scenes/drain_hands.h), as a small scene and behind
 * the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENE_DRAINS_RIG_H
#define VBSS_TESTS_SCENE_DRAINS_RIG_H

#include "drain/drain.h"
#include "scene/small.h"
#include "scenes/drain_hands.h"

/* That scene, in a watched context; its drain. */
static inline vbss_drain *drains_rig_begin(small *s, drain_hands *hands)
{
    small_begin(s);
    expect_ok(drain_hands_create(s->context, hands));
    s->scene = hands->scene;
    return hands->drain;
}

static inline void drains_rig_steps(small *s, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(drain_hands_step(s->scene));
    }
}

static inline uint64_t drains_rig_hash(vbss_drain *drain)
{
    uint64_t hash = 0;
    expect_ok(vbss_drain_get_hash(drain, &hash));
    return hash;
}

static inline drain_object *drains_rig_object(vbss_drain *drain)
{
    drain_object *object = NULL;
    expect_ok(vbss_drain_open(drain, &object));
    return object;
}

static inline vbss_result drains_body_create(vbss_context *context, void *user, void **handle)
{
    drain_hands hands = *(const drain_hands *)user;
    vbss_result result = drain_hands_create(context, &hands);
    *handle = hands.scene;
    return result;
}

static inline vbss_result drains_body_step(void *handle)
{
    return drain_hands_step(handle);
}

static inline vbss_result drains_body_destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static inline harness_body drains_as_body(drain_hands *hands)
{
    const harness_body body = {"drain in a scene",
                               &vbss_scene_kind,
                               drains_body_create,
                               NULL,
                               drains_body_step,
                               drains_body_destroy,
                               hands};
    return body;
}

#endif
