/* The rod behind the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENES_ROD_BODY_H
#define VBSS_TESTS_SCENES_ROD_BODY_H

#include "base/error.h"
#include "harness/harness.h"
#include "scenes/rod.h"

static inline vbss_result rod_body_create(vbss_context *context, void *user, void **handle)
{
    rod_config config;
    VBSS_TRY(rod_config_init(&config, sizeof config));
    if (user != NULL) {
        config.node_count = *(const uint32_t *)user;
    }
    rod *made = NULL;
    vbss_result result = rod_create(context, &config, &made);
    *handle = made;
    return result;
}

static inline vbss_result rod_body_step(void *handle)
{
    return rod_step(handle, 1e-3);
}

static inline vbss_result rod_body_destroy(void *handle)
{
    return rod_destroy(handle);
}

/* `user` is NULL for the default size, or a uint32_t node count. */
static inline harness_body rod_body(void *user)
{
    harness_body body = {"rod", &rod_kind, rod_body_create, NULL, rod_body_step, rod_body_destroy,
                         user};
    return body;
}

#endif
