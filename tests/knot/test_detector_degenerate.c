/* Threads that are no threads: flat, straight, in a point, touching themselves, closed, as long or large or small as
 * allowed. A detector says something finite, the same twice, and nothing that is not so. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"
#include "knot/judge.h"

enum { MOST = 8192 };

static judge j, twin;
static vec3 x[MOST];
static judge_saying said;

static void begin(uint32_t points, uint32_t crossings)
{
    judge *both[] = {&j, &twin};
    for (int i = 0; i < 2; i++) {
        judge_begin(both[i]);
        both[i]->config.point_capacity = points;
        both[i]->config.crossing_capacity = crossings;
        assert_true(judge_make(both[i]));
    }
}

static void end(void)
{
    judge_end(&j);
    judge_end(&twin);
}

static void expect_finite(const judge_saying *s, uint32_t count)
{
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        const vbss_knot_throw *t = &s->throws[i];
        const double places[] = {t->tail_places[0], t->tail_places[1], t->long_places[0],
                                 t->long_places[1]};
        for (int k = 0; k < 4; k++) {
            assert_true(places[k] >= 0.0 && places[k] <= count - 1.0);
        }
        assert_true(fabs(t->slip) <= 1.0);
        assert_true(t->tail_length >= 0.0 && isfinite(t->tail_length));
    }
}

/* Of `x`: the same twice. */
static void hear(uint32_t count, bool tissue)
{
    judge_saying again;
    vbss_knot_input in;
    uint64_t hash, other;
    expect_ok(vbss_knot_input_init(&in, sizeof in));
    in.points = &x[0].x;
    in.point_count = count;
    if (tissue) {
        in.hole_count = 1;
        in.hole_places[0] = 0.5 * count;
        in.away[2] = -1.0;
    }
    expect_ok(judge_hear(&j, &in, &said));
    expect_ok(judge_hear(&twin, &in, &again));
    assert_memory_equal(&said, &again, sizeof said);
    expect_ok(vbss_knot_detector_get_hash(j.detector, &hash));
    expect_ok(vbss_knot_detector_get_hash(twin.detector, &other));
    assert_true(hash == other);
    expect_finite(&said, count);
    bool uncertain = judge_is_uncertain(&said);
    assert_int_equal(uncertain, said.state.reason != VBSS_KNOT_REASON_NONE);
    assert_int_equal(uncertain, (said.state.faults & VBSS_KNOT_FAULT_UNCERTAIN) != 0);
}

static void expect_no_knot(void)
{
    assert_int_equal(said.state.verdict, VBSS_KNOT_VERDICT_NONE);
    assert_int_equal(said.state.name, VBSS_KNOT_NAME_NONE);
    assert_true(said.state.determinant == 1 && said.state.v2 == 0 && said.state.v3 == 0);
}

static void expect_uncertain(vbss_knot_reason reason)
{
    assert_int_equal(said.state.verdict, VBSS_KNOT_VERDICT_UNCERTAIN);
    assert_int_equal(said.state.reason, reason);
}

/* ---- flat */

static void a_line_has_no_knot(void **state)
{
    (void)state;
    begin(MOST, 256);
    const vec3 along[] = {vec3_make(1.0, 0.0, 0.0), vec3_make(0.0, 0.0, 1.0),
                          vec3_make(0.3, -0.7, 0.2)};
    for (int k = 0; k < 3; k++) {
        for (uint32_t count = 2; count <= 300; count += count < 10 ? 1 : 29) {
            for (uint32_t i = 0; i < count; i++) {
                x[i] = vec3_scale(along[k], 1e-3 * i);
            }
            for (int tissue = 0; tissue < 2; tissue++) {
                hear(count, tissue == 1);
                expect_no_knot();
            }
        }
    }
    end();
}

/* To and fro on one line: all of it touches. */
static void a_line_that_folds_back_ends(void **state)
{
    (void)state;
    begin(MOST, 256);
    for (uint32_t k = 1; k < 40; k++) {
        for (uint32_t i = 0; i < 60; i++) {
            x[i] = vec3_make(1e-3 * ((i * k * k) % 13), 0.0, 0.0);
        }
        hear(60, k % 2 == 0);
        assert_int_equal(said.state.throw_count, 0);
        assert_int_not_equal(said.state.name, VBSS_KNOT_NAME_OTHER);
    }
    end();
}

static void a_point_has_no_knot(void **state)
{
    (void)state;
    begin(MOST, 256);
    for (uint32_t count = 2; count < 200; count += 33) {
        for (uint32_t i = 0; i < count; i++) {
            x[i] = vec3_make(0.1, -0.2, 0.3);
        }
        for (int tissue = 0; tissue < 2; tissue++) {
            hear(count, tissue == 1);
            expect_no_knot();
        }
    }
    end();
}

/* A spiral, a zigzag and a meander in planes of all kinds: no knot, however it is turned. */
static void flat_threads_have_no_knot(void **state)
{
    (void)state;
    begin(MOST, 256);
    vbss_random random;
    vbss_random_seed(&random, 1, 1);
    uint32_t uncertain = 0, heard = 0;
    for (uint32_t k = 0; k < 120; k++) {
        vec3 u = vbss_random_direction(&random), v = vec3_any_normal(u);
        if (k < 30) { /* one of the planes of the axes */
            u = vec3_make(k % 3 == 0, k % 3 == 1, k % 3 == 2);
            v = vec3_make(k % 3 == 1, k % 3 == 2, k % 3 == 0);
        }
        for (uint32_t i = 0; i < 200; i++) {
            double sine, cosine, a = 1e-3 * i, b = 0.0;
            vbss_sincos(0.1 * i, &sine, &cosine);
            if (k % 3 == 0) {
                b = (i % 2 == 0 ? 5e-3 : -5e-3);
            } else if (k % 3 == 1) { /* outward: its beginning lies inside */
                a = 1e-3 * (i + 1) * cosine;
                b = 1e-3 * (i + 1) * sine;
            } else {
                b = 20e-3 * sine;
                a += 5e-3 * vbss_sin(0.2 * i);
            }
            x[i] = vec3_add_scaled(vec3_scale(u, a), b, v);
        }
        hear(200, false);
        heard++;
        if (judge_is_uncertain(&said)) {
            uncertain++;
        } else {
            expect_no_knot();
        }
    }
    print_message("%u of %u flat threads uncertain\n", uncertain, heard);
    assert_true(3 * uncertain <= heard + 6); /* the spirals: a ray in the plane meets them */
    end();
}

/* ---- touching */

/* A thread that goes through a point of its own a second time, where nothing can part it. */
static void a_thread_that_touches_itself_is_uncertain(void **state)
{
    (void)state;
    static thread_line line;
    throw_stack stack;
    begin(MOST, 256);
    throw_stack_init(&stack);
    throw_stack_add(&stack, 1, 1);
    throw_stack_add(&stack, 1, -1);
    uint32_t doubted = 0, heard = 0;
    for (uint32_t n = 0; n < 40; n++) {
        assert_true(throw_stack_make(&stack, &line));
        uint32_t a = (uint32_t)line.tissue_place - 20 - n, b = (uint32_t)line.tissue_place + 20 + n;
        vec3 between = vec3_lerp(line.x[a], line.x[b], 0.5);
        line.x[a] = line.x[b] = between; /* both strands bend to the same point */
        memcpy(x, line.x, line.count * sizeof *x);
        hear(line.count, false);
        heard++;
        doubted += judge_is_uncertain(&said);
    }
    print_message("%u of %u uncertain\n", doubted, heard);
    /* What moves take away with the point in it was never part of a knot: both ways past it are the same. */
    assert_int_equal(doubted, heard);
    end();
}

static void closed_threads_end(void **state)
{
    (void)state;
    begin(MOST, 256);
    for (uint32_t k = 0; k < 20; k++) {
        uint32_t count = 40 + k;
        for (uint32_t i = 0; i < count; i++) {
            double sine, cosine, turn = 6.28318530717958648 * (i + 1 == count ? 0 : i) / (count - 1.0);
            vbss_sincos((k % 2 == 0 ? 1 : 2) * turn, &sine, &cosine);
            double r = 0.02 + 0.01 * (k % 2) * vbss_cos(3.0 * turn);
            x[i] = vec3_make(r * cosine, r * sine, -0.01 * (k % 2) * vbss_sin(3.0 * turn));
        }
        assert_true(vec3_distance(x[0], x[count - 1]) == 0.0);
        hear(count, k % 4 < 2);
        assert_true(judge_is_uncertain(&said) || said.state.throw_count <= 1);
    }
    end();
}

/* ---- symmetric: a torus knot along the axes of the coordinates */

static void put_torus(uint32_t count, int p, int q, double size)
{
    for (uint32_t i = 0; i < count; i++) {
        double a, b, c, s, t = 6.28318530717958648 * (i + 0.5) / count;
        vbss_sincos(p * t, &b, &a);
        vbss_sincos(q * t, &s, &c);
        double r = 2.0 + c;
        x[i + 1] = vec3_scale(vec3_make(r * a, r * b, -s), size);
    }
    double apart = p > 0 ? 0.5 * size : -0.5 * size;
    x[0] = vec3_add(x[1], vec3_make(4.0 * size, apart, 0.0));
    x[count + 1] = vec3_add(x[count], vec3_make(4.0 * size, -apart, 0.0));
}

static void symmetric_knots_are_told(void **state)
{
    (void)state;
    begin(MOST, 256);
    for (int q = -7; q <= 7; q += 2) {
        if (q * q == 1) {
            continue;
        }
        for (uint32_t count = 48; count <= 480; count += 144) {
            for (int way = 0; way < 2; way++) {
                put_torus(count, way == 0 ? 2 : q, way == 0 ? q : 2, 4e-3);
                hear(count + 2, false);
                assert_int_equal(said.state.throw_count, 1);
                assert_int_equal(said.throws[0].wraps, (abs(q) - 1) / 2);
                assert_int_equal(said.throws[0].handedness, q > 0 ? 1 : -1);
            }
        }
    }
    end();
}

/* ---- limits */

static void long_threads_are_told(void **state)
{
    (void)state;
    static thread_line line;
    throw_stack stack;
    begin(MOST, 256);
    throw_stack_init(&stack);
    throw_stack_add(&stack, 2, 1);
    throw_stack_add(&stack, 1, -1);
    throw_stack_add(&stack, 1, 1);
    stack.segments = 2000;
    assert_true(throw_stack_make(&stack, &line));
    for (uint32_t i = 0; i < MOST; i++) {
        x[i] = thread_line_at(&line, 2000.0 * i / (MOST - 1.0));
    }
    hear(MOST, false);
    assert_string_equal(said.notation, "2=1=1");
    assert_true(said.state.determinant == 45 && said.state.v3 == 5);
    vbss_knot_input in = judge_input_of(&line);
    in.points = &x[0].x;
    in.point_count = MOST;
    in.hole_count = 1;
    in.hole_places[0] = line.tissue_place * (MOST - 1.0) / 2000.0;
    expect_ok(judge_hear(&j, &in, &said));
    assert_string_equal(said.notation, "2=1=1");
    assert_int_equal(said.state.verdict, VBSS_KNOT_VERDICT_CERTIFIED);
    end();
}

static void too_many_crossings_are_told(void **state)
{
    (void)state;
    begin(MOST, 8);
    put_torus(200, 2, 5, 4e-3);
    hear(202, false);
    assert_true(judge_is_uncertain(&said) || said.state.determinant == 5);
    put_torus(400, 4, 9, 4e-3);
    hear(402, false);
    expect_uncertain(VBSS_KNOT_REASON_CAPACITY);
    end();
}

static void sizes_do_not_matter(void **state)
{
    (void)state;
    begin(MOST, 256);
    for (double size = 1e-12; size < 300.0; size *= 10.0) {
        put_torus(120, 2, 5, size);
        hear(122, false);
        /* below a nanometre there is no thread */
        if (size > 1e-9) {
            assert_int_equal(said.state.throw_count, 1);
            assert_int_equal(said.throws[0].wraps, 2);
        }
    }
    const double tiny[] = {1e-13, 1e-100, 1e-200, 1e-308, 5e-324};
    for (int k = 0; k < 5; k++) {
        put_torus(120, 2, 5, tiny[k]);
        hear(122, true);
        assert_true(judge_is_uncertain(&said) || said.state.throw_count <= 1);
        x[60] = vec3_make(1.0, 0.0, 0.0); /* and one large edge */
        hear(122, true);
        x[60] = vec3_make(1e3, -1e3, 1e3);
        hear(122, false);
    }
    end();
}

/* ---- anything at all */

static void expect_sense(harness_source *source, void *user)
{
    uint32_t *uncertain = user, count = 2 + harness_draw_below(source, 60);
    uint32_t kind = harness_draw_below(source, 6);
    for (uint32_t i = 0; i < count; i++) {
        x[i] = harness_draw_vec3(source, -0.05, 0.05);
        if (kind == 1) { /* a coarse grid: touches, doubles, overlaps */
            x[i] = vec3_make(floor(60.0 * x[i].x), floor(60.0 * x[i].y), floor(60.0 * x[i].z));
        } else if (kind == 2) {
            x[i].z = 0.0;
        } else if (kind == 3) {
            x[i] = vec3_scale(x[i], harness_draw_below(source, 3) == 0 ? 2e4 : 1e-12);
        } else if (kind == 4 && i > 1) {
            x[i] = harness_draw_below(source, 3) == 0 ? x[harness_draw_below(source, i)] : x[i];
        }
    }
    hear(count, harness_draw_below(source, 2) == 1);
    *uncertain += judge_is_uncertain(&said);
    if (!judge_is_uncertain(&said)) {
        assert_true(said.state.determinant % 2 == 1 && said.state.determinant > 0);
        assert_true(said.state.signature % 2 == 0 && said.state.signature_tristram % 2 == 0);
        /* Levine: sigma is 0 modulo 4 just when det is 1 modulo 4. */
        assert_int_equal(said.state.signature % 4 == 0, said.state.determinant % 4 == 1);
        /* Arf: v2 is even just when det is 1 or 7 modulo 8. */
        assert_int_equal(said.state.v2 % 2 == 0,
                         said.state.determinant % 8 == 1 || said.state.determinant % 8 == 7);
    }
}

static void anything_at_all_makes_sense(void **state)
{
    (void)state;
    uint32_t uncertain = 0;
    begin(MOST, 256);
    harness_property("any points", 1000, expect_sense, &uncertain);
    print_message("%u of 1000 uncertain\n", uncertain);
    end();
}

int test_detector_degenerate(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(a_line_has_no_knot),
        harness_test(a_line_that_folds_back_ends),
        harness_test(a_point_has_no_knot),
        harness_test(flat_threads_have_no_knot),
        harness_test(a_thread_that_touches_itself_is_uncertain),
        harness_test(closed_threads_end),
        harness_test(symmetric_knots_are_told),
        harness_test(long_threads_are_told),
        harness_test(too_many_crossings_are_told),
        harness_test(sizes_do_not_matter),
        harness_test(anything_at_all_makes_sense),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
