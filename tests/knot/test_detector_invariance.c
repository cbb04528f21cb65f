/* What a detector says does not depend on where a thread lies, from which end it is told, how finely, or how it is
 * seen; and a mirror shows the other hand. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"
#include "knot/derive.h"

enum { SEEDS = 6 };

static judge j;

/* Some cases of each family that has a truth. */
static family_case *cases;
static uint32_t case_count;

static void make_cases(void)
{
    for (int f = 0; f < FAMILIES; f++) {
        for (uint64_t seed = 0; seed < SEEDS; seed++) {
            family_case *made = &cases[case_count];
            uint32_t segments = seed % 2 == 0 ? 240 : 130;
            if (families[f].make(100 + 7 * seed, segments, made) && made->truth != FAMILY_OPEN) {
                case_count++;
            }
        }
    }
}

static int begin(void **state)
{
    (void)state;
    judge_begin(&j);
    cases = malloc(FAMILIES * SEEDS * sizeof *cases);
    if (cases == NULL || !judge_make(&j)) {
        return 1;
    }
    make_cases();
    return 0;
}

static int end(void **state)
{
    (void)state;
    judge_end(&j);
    free(cases);
    return 0;
}

static void hear(const family_case *c, judge_saying *saying)
{
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&j, &in, saying));
}

typedef void (*check)(const family_case *c);

static void on_all_cases(check holds)
{
    assert_true(case_count >= (FAMILIES - 1) * SEEDS * 9 / 10);
    for (uint32_t i = 0; i < case_count; i++) {
        holds(&cases[i]);
    }
}

/* ---- what stays the same */

/* Half hitches are a matter of places, which a diagram shows so or so. */
static uint32_t faults_of(const judge_saying *s)
{
    return s->state.faults & ~(uint32_t)VBSS_KNOT_FAULT_HITCH;
}

static void expect_same_knot(const judge_saying *a, const judge_saying *b, int hand)
{
    assert_false(judge_is_uncertain(a) || judge_is_uncertain(b));
    assert_true(a->state.determinant == b->state.determinant && a->state.v2 == b->state.v2);
    assert_true(a->state.v3 == hand * b->state.v3);
    assert_int_equal(a->state.signature, hand * b->state.signature);
    assert_int_equal(a->state.signature_tristram, hand * b->state.signature_tristram);
    assert_int_equal(a->state.throw_count, b->state.throw_count);
    if (!judge_is_ordered(a) || !judge_is_ordered(b)) {
        return;
    }
    assert_int_equal(a->state.name, b->state.name);
    assert_int_equal(faults_of(a), faults_of(b));
    assert_string_equal(a->notation, b->notation);
    for (uint32_t i = 0; i < a->state.throw_count; i++) {
        assert_int_equal(a->throws[i].wraps, b->throws[i].wraps);
        assert_int_equal(a->throws[i].handedness, hand * b->throws[i].handedness);
    }
}

static void expect_same_truth(const family_case *c, const derive_whole *how, int hand)
{
    static family_case other;
    judge_saying first, second;
    derive_whole_of(c, how, &other);
    hear(c, &first);
    hear(&other, &second);
    const char *fault = judge_fault(&second, &other, false);
    if (fault != NULL) {
        fail_msg("%s: \"%s\", \"%s\"", fault, first.notation, second.notation);
    }
    expect_same_knot(&first, &second, hand);
}

static void mirror(const family_case *c)
{
    derive_whole how = derive_plain();
    how.mirrored = true;
    expect_same_truth(c, &how, -1);
}

static void a_mirror_shows_the_other_hand(void **state)
{
    (void)state;
    on_all_cases(mirror);
}

static void swap_limbs(const family_case *c)
{
    derive_whole how = derive_plain();
    how.reversed = true;
    expect_same_truth(c, &how, 1);
}

static void limbs_may_change_places(void **state)
{
    (void)state;
    on_all_cases(swap_limbs);
}

static void carry_away(const family_case *c)
{
    vbss_random random;
    vbss_random_seed(&random, c->line.count, (uint64_t)(1e9 * fabs(c->line.x[0].x)));
    for (int k = 0; k < 8; k++) {
        derive_whole how = derive_draw(&random), plain = derive_plain();
        how.mirrored = how.reversed = false;
        how.inserted = 0;
        how.doubled = 0.0;
        how.scale = k == 1 ? 1e-3 : k == 2 ? 1e3 : 1.0;
        double far = k == 3 ? 1.0 : k == 4 ? 10.0 : k == 5 ? 100.0 : 0.0;
        how.shift = vec3_scale(vbss_random_direction(&random), far);
        how.turn = k == 0 ? plain.turn : how.turn;
        expect_same_truth(c, &how, 1);
    }
}

static void size_and_place_do_not_matter(void **state)
{
    (void)state;
    on_all_cases(carry_away);
}

static void refine(const family_case *c)
{
    derive_whole how = derive_plain();
    for (uint64_t k = 0; k < 4; k++) {
        how.seed = k;
        how.doubled = k == 0 ? 0.5 : 0.0;
        how.inserted = k == 0 ? 0 : k == 1 ? 1000 : 100;
        expect_same_truth(c, &how, 1);
    }
}

static void more_points_do_not_matter(void **state)
{
    (void)state;
    on_all_cases(refine);
}

static void coarsen(const family_case *c)
{
    static derivation d;
    judge_saying first, second;
    if (!derive_begin(&d, c)) {
        return;
    }
    vbss_random random;
    vbss_random_seed(&random, c->line.count, 5);
    hear(c, &first);
    for (int k = 0; k < 4; k++) {
        derive_move(&d, &random);
        hear(&d.from, &second);
        assert_null(judge_fault(&second, &d.from, false));
        expect_same_knot(&first, &second, 1);
    }
}

static void moves_that_are_free_change_nothing(void **state)
{
    (void)state;
    on_all_cases(coarsen);
}

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
    hear(c, &first);
    other = *c;
    thread_line_reverse(&other.line);
    vbss_knot_input in = judge_input_of(&other.line);
    in.reversed = 1;
    expect_ok(judge_hear(&j, &in, &second));
    expect_same_but_places(&first, &second, c->line.count - 1.0, true, from_the_other_end);
}

static void points_may_come_from_the_other_end(void **state)
{
    (void)state;
    on_all_cases(give_from_the_other_end);
}

/* The first of both is the point, and the way on begins with the second. */
static double of_doubled(double place, double last)
{
    double vertex = floor(place), part = place - vertex;
    return lesser(2.0 * vertex + (part > 1e-9 ? 1.0 + part : 0.0), 2.0 * last);
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
    expect_ok(judge_hear(&j, &in, &first));
    for (uint32_t i = 0; i < 2 * count; i++) {
        points[i] = c->line.x[i / 2];
    }
    in.points = &points[0].x;
    in.point_count = 2 * count;
    for (uint32_t i = 0; i < in.hole_count; i++) {
        in.hole_places[i] = of_doubled(in.hole_places[i], count);
    }
    expect_ok(judge_hear(&j, &in, &second));
    expect_same_but_places(&first, &second, count - 1.0, false, of_doubled);
}

static void points_may_be_given_twice(void **state)
{
    (void)state;
    on_all_cases(give_twice);
}

static void give_holes_by_position(const family_case *c)
{
    judge_saying first, second;
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&j, &in, &first));
    for (uint32_t i = 0; i < in.hole_count; i++) {
        in.hole_places[i] = -1.0;
    }
    expect_ok(judge_hear(&j, &in, &second));
    expect_same_but_places(&first, &second, c->line.count - 1.0, false, same);
}

static void holes_may_be_told_by_place_or_position(void **state)
{
    (void)state;
    on_all_cases(give_holes_by_position);
}

static void give_in_rows(const family_case *c)
{
    static double rows[STACK_POINTS][7];
    judge_saying first, second;
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&j, &in, &first));
    for (uint32_t i = 0; i < c->line.count; i++) {
        memset(rows[i], 0xff, sizeof rows[i]);
        vec3_store(rows[i], c->line.x[i]);
    }
    in.points = rows[0];
    in.stride_bytes = sizeof rows[0];
    expect_ok(judge_hear(&j, &in, &second));
    expect_same_but_places(&first, &second, c->line.count - 1.0, false, same);
}

static void points_may_lie_in_wider_rows(void **state)
{
    (void)state;
    on_all_cases(give_in_rows);
}

int test_detector_invariance(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(a_mirror_shows_the_other_hand),
        harness_test(limbs_may_change_places),
        harness_test(size_and_place_do_not_matter),
        harness_test(more_points_do_not_matter),
        harness_test(moves_that_are_free_change_nothing),
        harness_test(points_may_come_from_the_other_end),
        harness_test(points_may_be_given_twice),
        harness_test(holes_may_be_told_by_place_or_position),
        harness_test(points_may_lie_in_wider_rows),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
