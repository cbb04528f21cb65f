/* Knots that are symmetric, as long, as large or as small as allowed, or have too many crossings. */
#include <stdlib.h>

#include "base/elementary.h"
#include "knot/odd_thread.h"

static void expect_uncertain(vbss_knot_reason reason)
{
    assert_int_equal(odd_said.state.verdict, VBSS_KNOT_VERDICT_UNCERTAIN);
    assert_int_equal(odd_said.state.reason, reason);
}

/* ---- symmetric: a torus knot along the axes of the coordinates */

static void put_torus(uint32_t count, int p, int q, double size)
{
    for (uint32_t i = 0; i < count; i++) {
        double a, b, c, s, t = 6.28318530717958648 * (i + 0.5) / count;
        vbss_sincos(p * t, &b, &a);
        vbss_sincos(q * t, &s, &c);
        double r = 2.0 + c;
        odd_x[i + 1] = vec3_scale(vec3_make(r * a, r * b, -s), size);
    }
    double apart = p > 0 ? 0.5 * size : -0.5 * size;
    odd_x[0] = vec3_add(odd_x[1], vec3_make(4.0 * size, apart, 0.0));
    odd_x[count + 1] = vec3_add(odd_x[count], vec3_make(4.0 * size, -apart, 0.0));
}

static void symmetric_knots_are_identified(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    for (int q = -7; q <= 7; q += 2) {
        if (q * q == 1) {
            continue;
        }
        for (uint32_t count = 48; count <= 480; count += 144) {
            for (int variant = 0; variant < 2; variant++) {
                put_torus(count, variant == 0 ? 2 : q, variant == 0 ? q : 2, 4e-3);
                odd_hear(count + 2, false);
                assert_int_equal(odd_said.state.throw_count, 1);
                assert_int_equal(odd_said.throws[0].wraps, (abs(q) - 1) / 2);
                assert_int_equal(odd_said.throws[0].handedness, q > 0 ? 1 : -1);
            }
        }
    }
    odd_end();
}

/* ---- limits */

static void long_threads_are_identified(void **state)
{
    (void)state;
    static thread_line line;
    throw_stack stack;
    odd_begin(ODD_MAX, 256);
    throw_stack_init(&stack);
    throw_stack_add(&stack, 2, 1);
    throw_stack_add(&stack, 1, -1);
    throw_stack_add(&stack, 1, 1);
    stack.segments = 2000;
    assert_true(throw_stack_make(&stack, &line));
    for (uint32_t i = 0; i < ODD_MAX; i++) {
        odd_x[i] = thread_line_at(&line, 2000.0 * i / (ODD_MAX - 1.0));
    }
    odd_hear(ODD_MAX, false);
    assert_string_equal(odd_said.notation, "2=1=1");
    assert_true(odd_said.state.determinant == 45 && odd_said.state.v3 == 5);
    vbss_knot_input in = judge_input_of(&line);
    in.points = &odd_x[0].x;
    in.point_count = ODD_MAX;
    in.hole_count = 1;
    in.hole_places[0] = line.tissue_place * (ODD_MAX - 1.0) / 2000.0;
    expect_ok(judge_hear(&odd_judge, &in, &odd_said));
    assert_string_equal(odd_said.notation, "2=1=1");
    assert_int_equal(odd_said.state.verdict, VBSS_KNOT_VERDICT_CERTIFIED);
    odd_end();
}

static void too_many_crossings_are_reported(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 8);
    put_torus(200, 2, 5, 4e-3);
    odd_hear(202, false);
    assert_true(judge_is_uncertain(&odd_said) || odd_said.state.determinant == 5);
    put_torus(400, 4, 9, 4e-3);
    odd_hear(402, false);
    expect_uncertain(VBSS_KNOT_REASON_CAPACITY);
    odd_end();
}

static void scale_does_not_matter(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    double size = 1e-13;
    for (int i = 0; i < 15; i++) {
        size *= 10.0;
        put_torus(120, 2, 5, size);
        odd_hear(122, false);
        /* below a nanometre there is no thread */
        if (size > 1e-9) {
            assert_int_equal(odd_said.state.throw_count, 1);
            assert_int_equal(odd_said.throws[0].wraps, 2);
        }
    }
    const double tiny[] = {1e-13, 1e-100, 1e-200, 1e-308, 5e-324};
    for (int k = 0; k < 5; k++) {
        put_torus(120, 2, 5, tiny[k]);
        odd_hear(122, true);
        assert_true(judge_is_uncertain(&odd_said) || odd_said.state.throw_count <= 1);
        odd_x[60] = vec3_make(1.0, 0.0, 0.0); /* and one large edge */
        odd_hear(122, true);
        odd_x[60] = vec3_make(1e3, -1e3, 1e3);
        odd_hear(122, false);
    }
    odd_end();
}

int test_detector_limits(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(symmetric_knots_are_identified),
        harness_test(long_threads_are_identified),
        harness_test(too_many_crossings_are_reported),
        harness_test(scale_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
