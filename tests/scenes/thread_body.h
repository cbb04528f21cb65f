/* A tugged thread behind the harness' description of a stepped body: hands, springs and a pin that
 * comes and goes move in its step, and it may be cut there. */
#ifndef VBSS_TESTS_SCENES_THREAD_BODY_H
#define VBSS_TESTS_SCENES_THREAD_BODY_H

#include "base/error.h"
#include "harness/harness.h"
#include "scenes/thread_scenes.h"
#include "thread/thread.h"

/* What `user` of the body points to. */
typedef struct thread_body_options {
    thread_scene_kind kind;
    vbss_method method;
    vbss_bending bending;
    uint32_t segment_count;
} thread_body_options;

static inline vbss_result thread_body_create(vbss_context *context, void *user, void **handle)
{
    const thread_body_options *options = user;
    vbss_thread_config config;
    thread_scene scene;
    VBSS_TRY(thread_scene_config(options->kind, &config));
    config.method = options->method;
    config.bending = options->bending;
    config.segment_count = options->segment_count;
    VBSS_TRY(thread_scene_create(context, options->kind, &config, &scene));
    *handle = scene.thread;
    return VBSS_OK;
}

static inline vbss_result thread_body_step_as(void *handle, thread_scene_kind kind)
{
    vbss_thread_statistics statistics;
    VBSS_TRY(vbss_thread_get_statistics(handle, &statistics, sizeof statistics));
    thread_scene scene = {kind, handle, NULL, statistics.steps};
    VBSS_TRY(thread_scene_step(&scene, 1e-3));
    return vbss_thread_destroy(scene.piece); /* the far part falls away at once */
}

static inline vbss_result thread_body_step(void *handle)
{
    return thread_body_step_as(handle, THREAD_SCENE_TUGGED);
}

static inline vbss_result thread_body_step_and_cut(void *handle)
{
    return thread_body_step_as(handle, THREAD_SCENE_CUT);
}

static inline vbss_result thread_body_step_released(void *handle)
{
    return thread_body_step_as(handle, THREAD_SCENE_RELEASE);
}

static inline vbss_result thread_body_destroy(void *handle)
{
    return vbss_thread_destroy(handle);
}

static inline harness_body thread_body(thread_body_options *options)
{
    harness_body body = {"thread", &vbss_thread_kind, thread_body_create,
                         NULL,     thread_body_step,  thread_body_destroy,
                         options};
    if (options->kind == THREAD_SCENE_CUT) {
        body.step = thread_body_step_and_cut;
    } else if (options->kind == THREAD_SCENE_RELEASE) {
        body.step = thread_body_step_released;
    }
    return body;
}

#endif
