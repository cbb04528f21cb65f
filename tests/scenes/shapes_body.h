/* Moving shapes behind the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENES_SHAPES_BODY_H
#define VBSS_TESTS_SCENES_SHAPES_BODY_H

#include <stdlib.h>

#include "base/error.h"
#include "collision/shapes.h"
#include "harness/harness.h"
#include "scenes/moving_shapes.h"

static inline vbss_result shapes_body_create(vbss_context *context, void *user, void **handle)
{
    vbss_collision_config config;
    moving_shapes scene;
    VBSS_TRY(moving_shapes_config(user, &config));
    VBSS_TRY(moving_shapes_create(context, user, &config, &scene));
    free(scene.positions);
    *handle = scene.collision;
    return VBSS_OK;
}

static inline vbss_result shapes_body_step(void *handle)
{
    collision_object *c;
    VBSS_TRY(vbss_collision_edit(handle, &c));
    moving_shapes scene = {.collision = handle};
    size_t numbers = 0;
    for (uint32_t i = 0; i < c->shape_count; i++) {
        const collision_shape *s = c->shapes[i];
        numbers += 3 * (size_t)s->node_count;
        scene.options.segment_count =
            s->kind == COLLISION_SHAPE_CHAIN ? s->edge_count : scene.options.segment_count;
        scene.options.capsules = scene.options.capsules || s->kind == COLLISION_SHAPE_CAPSULES;
        scene.options.sheet = scene.options.sheet || s->kind == COLLISION_SHAPE_MESH;
    }
    scene.positions = malloc(numbers * sizeof *scene.positions);
    assert_non_null(scene.positions);
    vbss_result result = moving_shapes_step(&scene);
    free(scene.positions);
    return result;
}

static inline vbss_result shapes_body_destroy(void *handle)
{
    return vbss_collision_destroy(handle);
}

static inline harness_body shapes_body(moving_shapes_options *options)
{
    harness_body body = {"shapes", &vbss_collision_kind, shapes_body_create,
                         NULL,     shapes_body_step,     shapes_body_destroy,
                         options};
    return body;
}

#endif
