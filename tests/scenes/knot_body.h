/* A detector that watches a moving knot, behind the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENES_KNOT_BODY_H
#define VBSS_TESTS_SCENES_KNOT_BODY_H

#include "base/error.h"
#include "harness/harness.h"
#include "knot/knot.h"
#include "scenes/moving_knot.h"

/* What `user` of the body points to. */
typedef struct knot_body_options {
    vbss_knot_method method;
    uint32_t work_limit;
} knot_body_options;

static inline vbss_result knot_body_create(vbss_context *context, void *user, void **handle)
{
    const knot_body_options *options = user;
    vbss_knot_config config;
    vbss_knot_detector *detector = NULL;
    VBSS_TRY(moving_knot_config(&config));
    config.method = options->method;
    config.work_limit = options->work_limit;
    vbss_result result = vbss_knot_detector_create(context, &config, &detector);
    *handle = detector;
    return result;
}

static inline vbss_result knot_body_step(void *handle)
{
    return moving_knot_step(handle);
}

static inline vbss_result knot_body_destroy(void *handle)
{
    return vbss_knot_detector_destroy(handle);
}

static inline harness_body knot_body(knot_body_options *options)
{
    harness_body body = {"knot detector", &vbss_knot_kind,   knot_body_create, NULL,
                         knot_body_step,  knot_body_destroy, options};
    return body;
}

#endif
