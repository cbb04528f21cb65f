/* Of a pair of features, whether it is known to stay apart: without measuring it again (lib/collision/separation_cache.c). */
#ifndef VBSS_SCENE_SEPARATION_CACHE_H
#define VBSS_SCENE_SEPARATION_CACHE_H

#include "scene/scene.h"

/* Of one feature of a pair, wherever it is round; a lip is thinner. */
static inline double scene_feature_radius(const scene_object *s, const collision_candidate *q,
                                          bool is_b)
{
    const uint32_t shape = is_b ? q->shape_b : q->shape_a, feature = is_b ? q->b : q->a;
    const scene_body *b = &s->bodies[s->body_of_shape[shape]];
    if (b->kind == SCENE_BODY_RIGID) {
        bool is_point = q->kind == VBSS_PAIR_POINT_TRIANGLE; /* the end of a capsule */
        return s->capsules[b->rigid.first_capsule + (is_point ? feature / 2 : feature)].radius;
    }
    return b->kind == SCENE_BODY_THREAD ? b->thread.thread->config.radius
                                        : s->collision->shapes[shape]->radius;
}

/* Whether their surfaces stay farther apart than that while their nodes go where the shapes are moved to. */
static inline bool scene_is_known_apart(const scene_object *s, const collision_candidate *q,
                                        double distance)
{
    distance += scene_feature_radius(s, q, false) + scene_feature_radius(s, q, true);
    return vbss_collision_stays_separated(s->collision, q, distance);
}

#endif
