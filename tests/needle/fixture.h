/* What the tests of needles share: a watched context, needles made in one line, looks at them. */
#ifndef VBSS_TESTS_NEEDLE_FIXTURE_H
#define VBSS_TESTS_NEEDLE_FIXTURE_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "needle/needle.h"

#define PI 3.14159265358979323846

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_needle_config config; /* the defaults; change it before making */
} fixture;

static inline void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_needle_config_init(&f->config, sizeof f->config));
}

static inline void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static inline vbss_needle *make(const fixture *f)
{
    vbss_needle *needle;
    expect_ok(vbss_needle_create(f->context, &f->config, &needle));
    return needle;
}

static inline needle_object *inside(const vbss_needle *needle)
{
    needle_object *n = NULL;
    expect_ok(vbss_needle_open(needle, &n));
    return n;
}

static inline vbss_needle_state get_state(vbss_needle *needle)
{
    vbss_needle_state state;
    expect_ok(vbss_needle_get_state(needle, &state, sizeof state));
    return state;
}

static inline vbss_needle_mass weigh(vbss_needle *needle)
{
    vbss_needle_mass mass;
    expect_ok(vbss_needle_get_mass(needle, &mass, sizeof mass));
    return mass;
}

static inline uint64_t hash_of(vbss_needle *needle)
{
    uint64_t hash;
    expect_ok(vbss_needle_get_hash(needle, &hash));
    return hash;
}

static inline void steps(vbss_needle *needle, double h, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_needle_step(needle, h));
    }
}

static inline void set_orientation(fixture *f, quat q)
{
    const double parts[4] = {q.w, q.x, q.y, q.z};
    memcpy(f->config.orientation, parts, sizeof parts);
}

#endif
