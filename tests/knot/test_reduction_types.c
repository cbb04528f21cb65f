/* A reduced chain has the knot type that it had, and few vertices. */
#include <string.h>

#include "base/elementary.h"
#include "knot/reduction_rig.h"
#include "oracle/knot_type.h"
#include "fixtures/knots.h"

/* ---- knots */

enum { FINE = 6000 };
static vec3 fine[FINE];
static double rests[FINE];

/* A knot of the scenes, bent by shears that move no strand through another, as a chain with both ends far away. */
static void make_knot(knot_kind kind, uint32_t n, vbss_random *random)
{
    knot_shape shape;
    knot_shape_init(&shape, kind);
    shape.finest = shape.coarsest = 0.05e-3;
    shape.length = 0.25; /* its ends lie outside */
    knot_line line;
    expect_ok(knot_make(&shape, FINE, fine, rests, &line));
    uint32_t last = line.node_count - 1;
    for (uint32_t k = 0; k < 6; k++) {
        double amplitude = 0.4e-3 * vbss_random_normal(random);
        double u = 1e3 * vbss_random_normal(random);
        double v = 1e3 * vbss_random_normal(random);
        for (uint32_t i = 0; i <= last; i++) {
            double *x = (double *)&fine[i];
            x[k % 3] += amplitude * vbss_sin(u * x[(k + 1) % 3] + v * x[(k + 2) % 3]);
        }
    }
    reduction_start(false);
    reduction_add(vec3_make(-0.5, 0.0, 0.0), false);
    for (uint32_t i = 0; i <= n; i++) {
        reduction_add(fine[(uint64_t)last * i / n], false);
    }
    reduction_add(vec3_make(0.5, 0.0, 0.0), false);
}

static void a_knot_stays_one(harness_source *source, void *user)
{
    knot_kind kind = *(knot_kind *)user;
    vbss_random random;
    vbss_random_seed(&random, harness_draw_u64(source), 1);
    make_knot(kind, 1000, &random);
    knot_type before, after;
    assert_true(knot_type_of(reduction_r.x, reduction_r.polygon.count, &before));
    reduction_reduce();
    assert_true(knot_type_of(reduction_r.x, reduction_r.polygon.count, &after));
    assert_true(knot_type_same(before, after));
    assert_true(knot_type_same(before, knot_type_of_kind(kind, false)));
    assert_in_range(reduction_r.polygon.count, 2, 40);
}

static void knot_type_is_kept(void **state)
{
    (void)state;
    for (int kind = 0; kind < KNOT_KINDS; kind++) {
        harness_property(knot_names[kind], 20, a_knot_stays_one, &kind);
    }
}

/* Moves the other way, each with nothing in its way: a tangle that is no knot. */
static void tangle(harness_source *source, uint32_t n)
{
    reduction_start(false);
    reduction_add(vec3_make(-100.0, 0.0, 0.0), false);
    reduction_add(vec3_make(100.0, 0.1, 0.2), false);
    static reduction_plain p;
    for (uint32_t tries = 0; tries < 100 * n && reduction_r.polygon.count < n; tries++) {
        uint32_t at = 1 + harness_draw_below(source, reduction_r.polygon.count - 1);
        reduction_take(&p);
        memmove(p.x + at + 1, p.x + at, (p.count - at) * sizeof *p.x);
        p.x[at] = harness_draw_vec3(source, -2.0, 2.0);
        p.count++;
        if (reduction_is_free(&p, at)) {
            memcpy(reduction_r.x, p.x, sizeof p.x);
            reduction_add(p.x[p.count - 1], false);
        }
    }
}

static void untangles(harness_source *source, void *user)
{
    uint32_t *left = user;
    tangle(source, 60);
    assert_int_equal(60, reduction_r.polygon.count);
    knot_type type;
    reduction_reduce();
    *left += reduction_r.polygon.count - 2;
    assert_true(knot_type_of(reduction_r.x, reduction_r.polygon.count, &type));
    assert_true(knot_type_same(type, knot_type_of_throws(0, NULL, NULL)));
}

static void tangles_are_undone(void **state)
{
    (void)state;
    uint32_t left = 0;
    harness_property("tangle", 200, untangles, &left);
    assert_in_range(left, 0, 200); /* of 11600: a few get stuck */
}

int test_reduction_types(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(knot_type_is_kept),
        harness_test(tangles_are_undone),
    };
    return cmocka_run_group_tests(tests, reduction_make_rig, reduction_end_rig);
}
