/* However a thread is handed over, a detector says the same to the last number, with places in the host's numbers. */
#include <math.h>
#include <string.h>

#include "knot/cases.h"

/* ---- what stays the same to the last number */

/* A place of the host's that is another one now. */
typedef double (*to_other)(double place, double last);

static void expect_same_words(const judge_saying *a, const judge_saying *b)
{
    assert_memory_equal(&a->state, &b->state, sizeof a->state);
    assert_string_equal(a->notation, b->notation);
    for (uint32_t i = 0; i < a->state.throw_count; i++) {
        const vbss_knot_throw *t = &a->throws[i], *u = &b->throws[i];
        assert_int_equal(t->verdict, u->verdict);
        assert_int_equal(t->wraps, u->wraps);
        assert_int_equal(t->handedness, u->handedness);
        assert_int_equal(t->flags, u->flags);
        expect_near(t->slip, u->slip, 1e-9);
        expect_near(t->tail_length, u->tail_length, 1e-12);
    }
}

static void expect_ranges(const double a[2], const double b[2], double last, bool backwards,
                          to_other other)
{
    for (int i = 0; i < 2; i++) {
        expect_near(other(a[backwards ? 1 - i : i], last), b[i], 1e-7);
    }
}

static void expect_same_but_places(const judge_saying *a, const judge_saying *b, double last,
                                   bool backwards, to_other other)
{
    expect_same_words(a, b);
    for (uint32_t i = 0; i < a->state.throw_count; i++) {
        if ((a->throws[i].flags & VBSS_KNOT_THROW_LOCATED) != 0) {
            expect_ranges(a->throws[i].tail_places, b->throws[i].tail_places, last, backwards,
                          other);
            expect_ranges(a->throws[i].long_places, b->throws[i].long_places, last, backwards,
                          other);
        }
    }
}

static double same(double place, double last)
{
    (void)last;
    return place;
}

static double from_the_other_end(double place, double last)
{
    return last - place;
}

static void give_from_the_other_end(const family_case *c)
{
    static family_case other;
    judge_saying first, second;
    cases_hear(c, &first);
    other = *c;
    thread_line_reverse(&other.line);
    vbss_knot_input in = judge_input_of(&other.line);
    in.reversed = 1;
    expect_ok(judge_hear(&cases_judge, &in, &second));
    expect_same_but_places(&first, &second, c->line.count - 1.0, true, from_the_other_end);
}

static void points_from_either_end(void **state)
{
    (void)state;
    on_all_cases(give_from_the_other_end);
}

/* The first of both is the point, and the way on begins with the second. */
static double of_doubled(double place, double last)
{
    double vertex = floor(place), part = place - vertex;
    return vbss_min(2.0 * vertex + (part > 1e-9 ? 1.0 + part : 0.0), 2.0 * last);
}

static void give_twice(const family_case *c)
{
    static vec3 points[2 * STACK_POINTS];
    judge_saying first, second;
    uint32_t count = c->line.count;
    if (2 * count > STACK_POINTS) {
        return;
    }
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&cases_judge, &in, &first));
    for (uint32_t i = 0; i < 2 * count; i++) {
        points[i] = c->line.x[i / 2];
    }
    in.points = &points[0].x;
    in.point_count = 2 * count;
    for (uint32_t i = 0; i < in.hole_count; i++) {
        in.hole_places[i] = of_doubled(in.hole_places[i], count);
    }
    expect_ok(judge_hear(&cases_judge, &in, &second));
    expect_same_but_places(&first, &second, count - 1.0, false, of_doubled);
}

static void duplicate_points_are_accepted(void **state)
{
    (void)state;
    on_all_cases(give_twice);
}

static void give_holes_by_position(const family_case *c)
{
    judge_saying first, second;
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&cases_judge, &in, &first));
    for (uint32_t i = 0; i < in.hole_count; i++) {
        in.hole_places[i] = -1.0;
    }
    expect_ok(judge_hear(&cases_judge, &in, &second));
    expect_same_but_places(&first, &second, c->line.count - 1.0, false, same);
}

static void holes_by_arc_or_position(void **state)
{
    (void)state;
    on_all_cases(give_holes_by_position);
}

static void give_in_rows(const family_case *c)
{
    static double rows[STACK_POINTS][7];
    judge_saying first, second;
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&cases_judge, &in, &first));
    for (uint32_t i = 0; i < c->line.count; i++) {
        memset(rows[i], 0xff, sizeof rows[i]);
        vec3_store(rows[i], c->line.x[i]);
    }
    in.points = rows[0];
    in.stride_bytes = sizeof rows[0];
    expect_ok(judge_hear(&cases_judge, &in, &second));
    expect_same_but_places(&first, &second, c->line.count - 1.0, false, same);
}

static void strided_points_are_read(void **state)
{
    (void)state;
    on_all_cases(give_in_rows);
}

int test_detector_inputs(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(points_from_either_end),
        harness_test(duplicate_points_are_accepted),
        harness_test(holes_by_arc_or_position),
        harness_test(strided_points_are_read),
    };
    return cmocka_run_group_tests(tests, begin_cases, end_cases);
}
