/* Stacks of throws have the knots that are asked for, and say where the tissue is. */
#include "fixtures/throw_stack.h"

#include <string.h>

#include "harness/harness.h"
#include "oracle/knot_type.h"

static thread_line line, other;

static void expect_knot(const throw_stack *stack, const thread_line *made)
{
    knot_type type;
    assert_true(knot_type_of(made->x, made->count, &type));
    assert_true(
        knot_type_same(type, knot_type_of_throws(stack->throws, stack->wraps, stack->signs)));
}

/* Type number n of those of so many throws: six kinds each. */
static throw_stack numbered(uint32_t throws, uint32_t n)
{
    throw_stack stack;
    throw_stack_init(&stack);
    for (uint32_t i = 0; i < throws; i++, n /= 6) {
        throw_stack_add(&stack, (int)(n % 3) + 1, n % 6 < 3 ? 1 : -1);
    }
    return stack;
}

static void three_throw_types_match_names(void **state)
{
    (void)state;
    for (uint32_t throws = 0, types = 1; throws <= 3; throws++, types *= 6) {
        for (uint32_t n = 0; n < types; n++) {
            throw_stack stack = numbered(throws, n);
            stack.segments = n % 2 == 0 ? 240 : 400;
            stack.unevenness = n % 3 == 0 ? 0.0 : 0.8;
            stack.seed = n;
            assert_true(throw_stack_make(&stack, &line));
            assert_int_equal(stack.segments + 1, line.count);
            expect_knot(&stack, &line);
        }
    }
}

/* ---- the tissue's place */

/* One limb from its end to the tissue, and from there away. */
static knot_type limb_alone(const thread_line *made, bool tail)
{
    other = *made;
    if (!tail) {
        thread_line_reverse(&other);
    }
    uint32_t last = (uint32_t)ceil(other.tissue_place);
    other.x[last] = thread_line_at(&other, other.tissue_place);
    other.x[last + 1] = vec3_add_scaled(other.x[last], 1.0, other.away);
    knot_type type;
    assert_true(knot_type_of(other.x, last + 2, &type));
    return type;
}

static void each_limb_alone_is_unknot(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 216; n++) {
        throw_stack stack = numbered(3, n);
        assert_true(throw_stack_make(&stack, &line));
        knot_type none = knot_type_of_throws(0, NULL, NULL);
        assert_true(knot_type_same(none, limb_alone(&line, true)));
        assert_true(knot_type_same(none, limb_alone(&line, false)));
    }
}

/* What lies below a height, with the strands that leave it pulled out straight. */
static void cut_above(thread_line *made, double z)
{
    uint32_t first = (uint32_t)made->tissue_place, last = first + 1;
    while (made->x[first].z < z) {
        first--;
    }
    while (made->x[last].z < z) {
        last++;
    }
    made->count = last - first + 1;
    memmove(made->x, made->x + first, made->count * sizeof made->x[0]);
}

static void throws_stack_from_tissue_outward(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 216; n++) {
        throw_stack stack = numbered(3, n);
        stack.segments = 600;
        assert_true(throw_stack_make(&stack, &line));
        while (stack.throws > 1) {
            stack.throws--;
            other = line;
            cut_above(&other, (stack.throws - 0.5) * 2.9 * stack.size);
            expect_knot(&stack, &other);
        }
    }
}

static void holes_are_at_tissue_crossings(void **state)
{
    (void)state;
    throw_stack stack = numbered(3, 100);
    assert_true(throw_stack_make(&stack, &line));
    expect_near(stack.drain, vec3_distance(line.holes[0], line.holes[1]), 1e-9);
    for (int i = 0; i < 2; i++) {
        vec3 there = thread_line_at(&line, line.hole_places[i]);
        expect_near(0.0, vec3_distance(there, line.holes[i]), 1e-15);
    }
    vec3 middle = thread_line_at(&line, line.tissue_place);
    for (uint32_t i = 0; i < line.count; i++) {
        assert_true(line.x[i].z > middle.z - 1e-5);
    }
    assert_true(line.hole_places[0] < line.tissue_place && line.tissue_place < line.hole_places[1]);
}

static void limb_lengths_match(void **state)
{
    (void)state;
    throw_stack stack = numbered(1, 1);
    stack.tail = 7e-3;
    stack.limb = 100e-3;
    assert_true(throw_stack_make(&stack, &line));
    uint32_t last = line.count - 1;
    double lead = 0.6 * stack.size, half = 0.5 * 6.0 * 1.5 * stack.size; /* of two wraps */
    expect_near(-half - lead - stack.tail, line.x[0].x, 0.21 * stack.size);
    expect_near(half + lead + stack.limb, line.x[last].x, 0.21 * stack.size);
    assert_true(line.x[0].y == 0.0 && line.x[last].y == 0.0);
}

static void mirror_and_reverse_are_correct(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 216; n += 5) {
        throw_stack stack = numbered(3, n);
        assert_true(throw_stack_make(&stack, &line));
        thread_line_reverse(&line);
        expect_knot(&stack, &line);
        for (int i = 0; i < 2; i++) {
            vec3 there = thread_line_at(&line, line.hole_places[i]);
            expect_near(0.0, vec3_distance(there, line.holes[i]), 1e-12);
        }
        thread_line_mirror(&line);
        for (uint32_t i = 0; i < stack.throws; i++) {
            stack.signs[i] = -stack.signs[i];
        }
        expect_knot(&stack, &line);
    }
}

/* ---- refusals */

static void unreadable_knot_is_rejected(void **state)
{
    (void)state;
    throw_stack stack = numbered(3, 43);
    stack.segments = 30;
    assert_false(throw_stack_make(&stack, &line));
    stack = numbered(3, 43);
    stack.segments = 2001;
    assert_false(throw_stack_make(&stack, &line));
    stack = numbered(3, 43);
    stack.wraps[1] = 4;
    assert_false(throw_stack_make(&stack, &line));
    stack = numbered(3, 43);
    stack.signs[1] = 0;
    assert_false(throw_stack_make(&stack, &line));
}

static void eight_triple_throws_fit(void **state)
{
    (void)state;
    throw_stack stack = numbered(0, 0);
    for (uint32_t i = 0; i < STACK_THROWS; i++) {
        throw_stack_add(&stack, 3, i % 3 == 0 ? 1 : -1);
    }
    stack.segments = 1500;
    assert_true(throw_stack_make(&stack, &line));
    knot_type type;
    assert_true(knot_type_of(line.x, line.count, &type));
    knot_type wanted = knot_type_of_throws(stack.throws, stack.wraps, stack.signs);
    assert_int_equal(wanted.determinant, type.determinant);
}

int test_throw_stack(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_throw_types_match_names),
        cmocka_unit_test(each_limb_alone_is_unknot),
        cmocka_unit_test(throws_stack_from_tissue_outward),
        cmocka_unit_test(holes_are_at_tissue_crossings),
        cmocka_unit_test(limb_lengths_match),
        cmocka_unit_test(mirror_and_reverse_are_correct),
        cmocka_unit_test(unreadable_knot_is_rejected),
        cmocka_unit_test(eight_triple_throws_fit),
    };
    return cmocka_run_group_tests_name("throw stack", tests, NULL, NULL);
}
