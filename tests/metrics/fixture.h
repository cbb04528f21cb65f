/* What the tests of metrics share: a watched context, a measurement, events and samples in one line, curves with known
 * figures. */
#ifndef VBSS_TESTS_METRICS_FIXTURE_H
#define VBSS_TESTS_METRICS_FIXTURE_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "metrics/metrics.h"

#define PI 3.14159265358979323846

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_metrics_config config; /* the defaults; change it before making */
    vbss_metrics *metrics;
} fixture;

static inline void make(fixture *f)
{
    expect_ok(vbss_metrics_create(f->context, &f->config, &f->metrics));
}

static inline void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_metrics_config_init(&f->config, sizeof f->config));
    f->metrics = NULL;
}

static inline void begin_and_make(fixture *f)
{
    begin(f);
    make(f);
}

static inline void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static inline uint64_t hash_of(vbss_metrics *metrics)
{
    uint64_t hash;
    expect_ok(vbss_metrics_get_hash(metrics, &hash));
    return hash;
}

/* ---- telling */

static inline vbss_metrics_event event_of(vbss_metrics_event_kind kind, uint32_t number,
                                          double time)
{
    vbss_metrics_event e;
    expect_ok(vbss_metrics_event_init(&e, sizeof e));
    e.kind = kind;
    e.number = number;
    e.time = time;
    e.step = (uint64_t)(1000.0 * fabs(time) + 0.5);
    return e;
}

static inline void report(const fixture *f, vbss_metrics_event_kind kind, uint32_t number,
                          double time, double amount)
{
    vbss_metrics_event e = event_of(kind, number, time);
    e.amount = amount;
    expect_ok(vbss_metrics_add_event(f->metrics, &e));
}

static inline void take_back(const fixture *f, vbss_metrics_event_kind kind, uint32_t number,
                             double time)
{
    vbss_metrics_event e = event_of(kind, number, time);
    e.undone = 1;
    expect_ok(vbss_metrics_add_event(f->metrics, &e));
}

static inline void puncture(const fixture *f, uint32_t mark, double time, double angle,
                            double axial)
{
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_PUNCTURE, mark, time);
    e.angle = angle;
    e.axial = axial;
    expect_ok(vbss_metrics_add_event(f->metrics, &e));
}

static inline void tie(const fixture *f, uint32_t number, double time,
                       vbss_metrics_relation relation)
{
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_THROW, number, time);
    e.wraps = number == 0 ? 2 : 1;
    e.handedness = number % 2 == 0 ? 1 : -1;
    e.relation = relation;
    expect_ok(vbss_metrics_add_event(f->metrics, &e));
}

static inline void show(const fixture *f, uint32_t valid, double time, vec3 left, vec3 right)
{
    vbss_metrics_sample s;
    expect_ok(vbss_metrics_sample_init(&s, sizeof s));
    s.valid = valid;
    s.time = time;
    vec3_store(s.position[0], left);
    vec3_store(s.position[1], right);
    expect_ok(vbss_metrics_add_sample(f->metrics, &s));
}

static inline void pull_at(const fixture *f, double time, double force, double strain,
                           double drawn_in, uint32_t tied)
{
    vbss_metrics_pull p;
    expect_ok(vbss_metrics_pull_init(&p, sizeof p));
    p.time = time;
    p.tied = tied;
    p.drawn_in = drawn_in;
    for (int i = 0; i < 2; i++) {
        p.force[i] = force;
        p.strain[i] = strain;
    }
    expect_ok(vbss_metrics_add_pull(f->metrics, &p));
}

/* ---- looking */

static inline vbss_metrics_report report_of(const fixture *f)
{
    vbss_metrics_report r;
    expect_ok(vbss_metrics_get_report(f->metrics, &r, sizeof r));
    return r;
}

static inline vbss_metrics_motion motion_of(const fixture *f, int32_t tool, int32_t phase)
{
    vbss_metrics_motion m;
    expect_ok(vbss_metrics_get_motion(f->metrics, tool, phase, &m, sizeof m));
    return m;
}

static inline vbss_metrics_bimanual hands_of(const fixture *f, int32_t phase)
{
    vbss_metrics_bimanual b;
    expect_ok(vbss_metrics_get_bimanual(f->metrics, phase, &b, sizeof b));
    return b;
}

static inline vbss_metrics_penalty penalty_of(const fixture *f, uint32_t index)
{
    vbss_metrics_penalty p;
    expect_ok(vbss_metrics_get_penalty(f->metrics, index, &p, sizeof p));
    return p;
}

/* ---- curves */

/* A reach from 0 to 1 in the unit of time: the smoothest by its jerk (Flash and Hogan, J Neurosci 5:1688, 1985). */
static inline double reach(double s)
{
    s = s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s;
    return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

typedef vec3 (*curve)(double time);

/* The left tool along a curve from `from` to `to`, at a rate; `jitter` parts of a period early or late. */
static inline void record(const fixture *f, curve at, double from, double to, double rate,
                          double jitter)
{
    uint64_t count = (uint64_t)((to - from) * rate + 0.5);
    vbss_random random;
    vbss_random_seed(&random, 7, 1);
    for (uint64_t i = 0; i <= count; i++) {
        double shift = jitter * (2.0 * vbss_random_uniform(&random) - 1.0);
        double time = from + ((double)i + shift) / rate;
        show(f, VBSS_METRICS_HAS_LEFT, time, at(time), vec3_zero());
    }
}

#endif
