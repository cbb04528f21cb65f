/* A device on its run, behind the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENES_DEVICE_BODY_H
#define VBSS_TESTS_SCENES_DEVICE_BODY_H

#include "harness/harness.h"
#include "scenes/device_run.h"

static inline vbss_result device_body_create(vbss_context *context, void *user, void **handle)
{
    device_run run;
    (void)user;
    vbss_result result = device_run_create(context, &run);
    *handle = run.device; /* the mocks end with the context */
    return result;
}

static inline vbss_result device_body_step(void *handle)
{
    vbss_device_input input;
    vbss_output_result result;
    return device_run_step(handle, &input, &result);
}

static inline vbss_result device_body_destroy(void *handle)
{
    return vbss_device_destroy(handle);
}

static inline harness_body device_body(void)
{
    harness_body body = {"device", &vbss_device_kind, device_body_create,
                         NULL,     device_body_step,  device_body_destroy,
                         NULL};
    return body;
}

#endif
