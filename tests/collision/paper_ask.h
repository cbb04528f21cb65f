/* Asking one question, and the paper's algorithm 1 as it is printed. */
#ifndef VBSS_TESTS_COLLISION_PAPER_ASK_H
#define VBSS_TESTS_COLLISION_PAPER_ASK_H

#include <math.h>
#include <string.h>

#include "fixtures/baseline_of.h"
#include "collision/collision.h"
#include "harness/harness.h"

typedef struct question {
    vbss_collision_pair_kind kind;
    double start[12], end[12];
} question;

typedef struct reported {
    vbss_collision_impact impact;
    collision_counters counters;
} reported;

/* Defaults but for the paper's unit: that of the numbers here. */
static inline vbss_collision_config rules_for(vbss_collision_method method, double thickness)
{
    vbss_collision_config config;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.method = method;
    config.thickness = thickness;
    baseline_of(&config.baseline)->collision_unit = 1.0;
    return config;
}

static inline void expect_finite(const double *values, int count)
{
    for (int i = 0; i < count; i++) {
        assert_true(isfinite(values[i]));
    }
}

/* Also sees to it that the answer is whole: finite, unit normal or none, weights that sum to 1. */
static inline reported ask_with(const vbss_collision_config *config, const question *q)
{
    reported t = {.counters = {0}};
    uint32_t limbs[COLLISION_STACK_LIMBS];
    collision_ccd_options rules = vbss_collision_ccd_options_of(config);
    rules.limbs = limbs;
    rules.limb_count = COLLISION_STACK_LIMBS;
    collision_ccd_query own = {.kind = q->kind, .thickness = config->thickness};
    collision_ccd_result answer;
    vbss_collision_set_vertices(&own, q->start, q->end);
    vbss_collision_run_ccd(&rules, &own, &answer, &t.counters);
    expect_ok(vbss_collision_write_impact(NULL, &own, &answer, &t.impact, sizeof t.impact));
    const vbss_collision_impact *i = &t.impact;
    expect_finite(&i->time,
                  (int)((sizeof *i - offsetof(vbss_collision_impact, time)) / sizeof i->time));
    double length = vec3_norm(vec3_load(i->normal));
    int of_a = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    double a = 0.0, all = 0.0;
    for (int k = 0; k < 4; k++) {
        assert_true(i->weights[k] >= 0.0 && i->weights[k] <= 1.0);
        a += k < of_a ? i->weights[k] : 0.0;
        all += i->weights[k];
    }
    if (i->hit != 0) {
        expect_near(length == 0.0 ? 0.0 : 1.0, length, 1e-15);
        expect_near(1.0, a, 1e-14);
        expect_near(2.0, all, 1e-14);
    } else {
        assert_true(i->time == 1.0 && i->distance == 0.0 && length == 0.0 && all == 0.0);
    }
    return t;
}

static inline reported ask(vbss_collision_method method, double thickness, const question *q)
{
    vbss_collision_config config = rules_for(method, thickness);
    return ask_with(&config, q);
}

static inline question exchanged(const question *q, size_t i, size_t k)
{
    question other = *q;
    memcpy(other.start + 3 * i, q->start + 3 * k, 3 * sizeof(double));
    memcpy(other.start + 3 * k, q->start + 3 * i, 3 * sizeof(double));
    memcpy(other.end + 3 * i, q->end + 3 * k, 3 * sizeof(double));
    memcpy(other.end + 3 * k, q->end + 3 * i, 3 * sizeof(double));
    return other;
}

static inline question scaled(const question *q, double factor)
{
    question other = *q;
    for (int k = 0; k < 12; k++) {
        other.start[k] *= factor;
        other.end[k] *= factor;
    }
    return other;
}

/* ---- questions drawn */

typedef enum drawn {
    DRAWN_EVENLY,   /* in a cube */
    DRAWN_INTEGERS, /* -2 to 2: many degenerate features */
    DRAWN_WILD /* integers, each times any power of ten that is allowed, up to 1e-30 and 1e30 */
} drawn;

static inline double draw_coordinate(harness_source *source, drawn how)
{
    if (how == DRAWN_EVENLY) {
        return harness_draw_real(source, -1.0, 1.0);
    }
    double x = harness_draw_below(source, 5) - 2.0;
    uint32_t power = how == DRAWN_WILD ? harness_draw_below(source, 30) : 0;
    double factor = harness_draw_below(source, 2) != 0 ? 10.0 : 0.1;
    for (uint32_t k = 0; k < power; k++) {
        x *= factor;
    }
    return x / 2.0;
}

static inline question draw_question(harness_source *source, drawn how)
{
    question q = {.kind = (vbss_collision_pair_kind)harness_draw_below(source, 2)};
    for (int k = 0; k < 12; k++) {
        q.start[k] = draw_coordinate(source, how);
        q.end[k] = draw_coordinate(source, how);
    }
    return q;
}

/* ---- algorithm 1 as printed, for numbers in the paper's unit; the private code never sees it */

typedef struct printed_lines {
    vec3 w;
    double feet[3]; /* s_i, s_j; area coordinates of a triangle */
    bool parallel;
} printed_lines;

static inline printed_lines printed_w(vbss_collision_pair_kind kind, const vec3 x[4], double eps)
{
    printed_lines p = {.parallel = false};
    if (kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        vec3 eb = vec3_sub(x[2], x[1]), ec = vec3_sub(x[3], x[1]), w0 = vec3_sub(x[0], x[1]);
        vec3 n = vec3_cross(eb, ec);
        double area = vec3_norm(n);
        n = vec3_scale(n, 1.0 / area);
        p.w = vec3_scale(n, vec3_dot(w0, n));
        p.feet[0] = vec3_dot(vec3_cross(w0, ec), n) / area;
        p.feet[1] = vec3_dot(vec3_cross(eb, w0), n) / area;
        p.feet[2] = 1.0 - p.feet[0] - p.feet[1];
        return p;
    }
    vec3 ei = vec3_sub(x[1], x[0]), ej = vec3_sub(x[3], x[2]), w0 = vec3_sub(x[0], x[2]);
    double a = vec3_dot(ei, ei), b = vec3_dot(ei, ej), c = vec3_dot(ej, ej);
    double d = vec3_dot(ei, w0), e = vec3_dot(ej, w0), determinant = a * c - b * b;
    p.parallel = determinant < eps;
    if (p.parallel) {
        p.feet[0] = 0.0;
        p.feet[1] = b == 0.0 ? (double)NAN : d / b;
        p.w = vec3_sub(w0, vec3_scale(ej, p.feet[1]));
    } else {
        vec3 n = vec3_cross(ei, ej);
        n = vec3_scale(n, 1.0 / vec3_norm(n));
        p.feet[0] = (b * e - c * d) / determinant;
        p.feet[1] = (a * e - b * d) / determinant;
        p.w = vec3_scale(n, vec3_dot(w0, n));
    }
    return p;
}

static inline void load_at(const question *q, double t, double unit, vec3 x[4])
{
    for (size_t k = 0; k < 4; k++) {
        vec3 from = vec3_load(q->start + 3 * k), to = vec3_load(q->end + 3 * k);
        x[k] = vec3_scale(vec3_lerp(from, to, t), 1.0 / unit);
    }
}

typedef struct printed_steps {
    double product, time; /* w.w' and t_c */
    bool ended;           /* by (ii a) */
    bool hit;             /* by (ii b) */
    double margin;        /* how far decisions are from turning over, the product's among them */
} printed_steps;

/* Step (ii). */
static inline printed_steps printed_crossing(const question *q, double eps, double unit)
{
    printed_steps steps = {.time = (double)NAN};
    vec3 x[4];
    load_at(q, 0.0, unit, x);
    printed_lines first = printed_w(q->kind, x, eps);
    load_at(q, 1.0, unit, x);
    printed_lines last = printed_w(q->kind, x, eps);
    steps.product = vec3_dot(first.w, last.w);
    double m = steps.product < 0.0 ? -1.0 : 1.0, w = vec3_norm(first.w), w1 = vec3_norm(last.w);
    steps.margin = w * w1 > 0.0 ? fabs(steps.product) / (w * w1) : 0.0;
    steps.ended = !(steps.product < 0.0);
    if (steps.ended) {
        return steps;
    }
    steps.time = w / (w - m * w1);
    load_at(q, steps.time, unit, x);
    printed_lines then = printed_w(q->kind, x, eps);
    int feet = q->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE ? 3 : 2;
    steps.hit = true;
    for (int k = 0; k < feet; k++) {
        double s = then.feet[k], inside = s < 1.0 - s ? s : 1.0 - s;
        steps.hit = steps.hit && s >= 0.0 && s <= 1.0;
        steps.margin = fabs(inside) < steps.margin ? fabs(inside) : steps.margin;
    }
    return steps;
}

#endif
