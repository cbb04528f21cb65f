/* What the tests of graspers share: a watched context, graspers made in one line, looks inside. */
#ifndef VBSS_TESTS_GRASPER_FIXTURE_H
#define VBSS_TESTS_GRASPER_FIXTURE_H

#include <math.h>
#include <string.h>

#include "base/snapshot.h"
#include "grasper/grasper.h"
#include "harness/harness.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_grasper_config config; /* the defaults; change it before making */
} fixture;

static inline void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_grasper_config_init(&f->config, sizeof f->config));
}

static inline void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static inline vbss_grasper *make(fixture *f)
{
    vbss_grasper *grasper;
    expect_ok(vbss_grasper_create(f->context, &f->config, &grasper));
    return grasper;
}

static inline grasper_object *inside(vbss_grasper *grasper)
{
    grasper_object *g = NULL;
    expect_ok(vbss_grasper_open(grasper, &g));
    return g;
}

static inline vbss_grasper_state get_state(vbss_grasper *grasper)
{
    vbss_grasper_state state;
    expect_ok(vbss_grasper_get_state(grasper, &state, sizeof state));
    return state;
}

static inline uint64_t hash_of(vbss_grasper *grasper)
{
    uint64_t hash;
    expect_ok(vbss_object_hash(grasper, &vbss_grasper_kind_of_slot, &hash));
    return hash;
}

static inline vbss_result move_to(vbss_grasper *grasper, vec3 position, quat orientation)
{
    const double q[4] = {orientation.w, orientation.x, orientation.y, orientation.z};
    double p[3];
    vec3_store(p, position);
    return vbss_grasper_set_target(grasper, p, q);
}

#endif
