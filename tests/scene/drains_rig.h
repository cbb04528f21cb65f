/* What the tests of drains in scenes share: the drain that hands work on (fixtures/drain_hands.h), as a small scene and behind
 * the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENE_DRAINS_RIG_H
#define VBSS_TESTS_SCENE_DRAINS_RIG_H

#include "base/error.h"
#include "drain/drain.h"
#include "scene/small.h"
#include "fixtures/drain_hands.h"

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

static inline vbss_drain *drains_rig_of(vbss_scene *scene)
{
    scene_object *object = NULL;
    expect_ok(vbss_scene_open(scene, &object));
    assert_int_equal(object->bodies[0].kind, SCENE_BODY_DRAIN);
    return (vbss_drain *)object->bodies[0].drain.slot;
}

/* ---- as bodies that are stepped */

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

/* ---- a rod (body 2) that is told, at that step, to go through the wall at once, while a hand draws a lip along */

enum { LEAP_AT = 5 };

/* From the scene's configuration. */
static inline vbss_result leap_create(vbss_context *context, void *user, void **handle)
{
    const vbss_scene_capsule rod = {{0.0, 0.0, -8e-3}, {0.0, 0.0, 8e-3}, 1e-3};
    vbss_scene *scene = NULL;
    vbss_drain *drain;
    vbss_drain_config drain_config;
    vbss_drain_places places;
    vbss_drain_attachment a;
    vbss_scene_rigid_config config;
    uint32_t number;
    VBSS_TRY(vbss_scene_create(context, user, &scene));
    *handle = scene;
    VBSS_TRY(vbss_drain_config_init(&drain_config, sizeof drain_config));
    VBSS_TRY(vbss_drain_create(context, &drain_config, &drain));
    VBSS_TRY(vbss_scene_add_drain(scene, drain, &number));
    VBSS_TRY(vbss_drain_get_places(drain, &places, sizeof places));
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.node = places.marks[0];
    vec3_store(a.position, drains_rig_object(drain)->x[a.node]);
    VBSS_TRY(vbss_drain_attach(drain, &a, &number));
    VBSS_TRY(vbss_scene_rigid_config_init(&config, sizeof config));
    config.capsules = &rod;
    config.capsule_count = 1;
    config.position[0] = 10e-3;
    config.position[1] = 8.2e-3;
    return vbss_scene_add_rigid(scene, &config, &number);
}

static inline vbss_result leap_step(void *scene)
{
    vbss_scene_statistics s;
    VBSS_TRY(vbss_scene_get_statistics(scene, &s, sizeof s));
    drain_object *d = drains_rig_object(drains_rig_of(scene));
    uint64_t step = s.steps < 40 ? s.steps : 40;
    const vec3 rest = pose_apply(d->frame, d->mesh.rest[d->attachments[0].node]);
    double to[3] = {rest.x, rest.y, rest.z - 1e-6 * (double)((step + 1) * (step + 1))};
    if (d->attachments[0].id != 0) { /* the hand may have let go */
        VBSS_TRY(vbss_drain_set_attachment_target(drains_rig_of(scene), 1, to));
    }
    if (s.steps == LEAP_AT) {
        const double through[3] = {10e-3, -13e-3, 0.0};
        VBSS_TRY(vbss_scene_set_rigid_target(scene, 2, through, NULL));
    }
    return vbss_scene_step(scene, 1e-3);
}

static inline harness_body leap_as_body(vbss_scene_config *config)
{
    const harness_body body = {"leap",    &vbss_scene_kind,    leap_create, NULL,
                               leap_step, drains_body_destroy, config};
    return body;
}

static inline void leap_begin(small *s)
{
    void *scene = NULL;
    expect_ok(leap_create(s->context, &s->config, &scene));
    s->scene = scene;
}

#endif
