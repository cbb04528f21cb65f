/* What is done to threads keeps their knots, as the oracle sees them too; and what would change them is refused. */
#include "fixtures/isotopy.h"

#include <string.h>

#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "fixtures/clutter.h"
#include "fixtures/swept.h"

static thread_line base, line, again;
static swept_line swept;

static const int wraps[3] = {2, 1, 1}, signs[3] = {1, -1, 1};

static void tie(uint32_t throws, double limb)
{
    throw_stack stack;
    throw_stack_init(&stack);
    for (uint32_t i = 0; i < throws; i++) {
        throw_stack_add(&stack, wraps[i], signs[i]);
    }
    stack.segments = 500;
    stack.limb = limb;
    assert_true(throw_stack_make(&stack, &base));
}

static void expect_type(knot_type wanted, const thread_line *made)
{
    knot_type type;
    assert_true(knot_type_of(made->x, made->count, &type));
    assert_true(knot_type_same(wanted, type));
}

static void expect_throws(uint32_t throws, const thread_line *made)
{
    expect_type(knot_type_of_throws(throws, wraps, signs), made);
}

/* One limb from its end to the tissue, and from there away. */
static void expect_limbs_without_knots(const thread_line *made)
{
    for (int tail = 0; tail < 2; tail++) {
        again = *made;
        if (tail == 0) {
            thread_line_reverse(&again);
        }
        uint32_t last = (uint32_t)ceil(again.tissue_place);
        again.x[last] = thread_line_at(&again, again.tissue_place);
        again.x[last + 1] = vec3_add_scaled(again.x[last], 1.0, again.away);
        again.count = last + 2;
        expect_throws(0, &again);
    }
}

static isotopy drawn(uint64_t seed)
{
    isotopy deformation;
    isotopy_init(&deformation, seed);
    deformation.strength = (double)(seed % 4) / 4.0;
    deformation.segments = 60 + 60 * (uint32_t)(seed % 5);
    deformation.jumps = seed % 7 == 0 ? 1.0 : 0.0;
    return deformation;
}

static void isotopy_keeps_knot_and_tissue(void **state)
{
    (void)state;
    uint32_t made = 0;
    tie(3, 60e-3);
    for (uint64_t seed = 0; seed < 100; seed++) {
        isotopy deformation = drawn(seed);
        if (isotopy_apply(&deformation, &base, &line)) {
            assert_int_equal(deformation.segments + 1, line.count);
            expect_throws(3, &line);
            expect_limbs_without_knots(&line);
            made++;
        }
    }
    assert_true(made >= 95);
}

static void isotopy_moves_thread_far(void **state)
{
    (void)state;
    tie(3, 60e-3);
    isotopy deformation;
    isotopy_init(&deformation, 3);
    deformation.strength = 0.9;
    deformation.turned = false;
    assert_true(isotopy_apply(&deformation, &base, &line));
    double furthest = 0.0;
    for (uint32_t i = 0; i < line.count; i++) {
        double nearest = 1.0;
        for (uint32_t k = 0; k < base.count; k++) {
            nearest = vbss_min(nearest, vec3_distance(line.x[i], base.x[k]));
        }
        furthest = vbss_max(furthest, nearest);
    }
    assert_true(furthest > 3e-3);
}

static void markers_stay_on_thread(void **state)
{
    (void)state;
    tie(2, 60e-3);
    for (uint64_t seed = 0; seed < 20; seed++) {
        isotopy deformation = drawn(seed);
        assert_true(isotopy_apply(&deformation, &base, &line));
        assert_true(line.hole_places[0] < line.tissue_place);
        assert_true(line.tissue_place < line.hole_places[1]);
        for (int i = 0; i < 2; i++) {
            vec3 there = thread_line_at(&line, line.hole_places[i]);
            expect_near(0.0, vec3_distance(there, line.holes[i]), 1e-15);
        }
        expect_near(1.0, vec3_norm(line.away), 1e-12);
    }
}

static void seed_determines_bits(void **state)
{
    (void)state;
    tie(3, 60e-3);
    isotopy deformation = drawn(11);
    assert_true(isotopy_apply(&deformation, &base, &line));
    assert_true(isotopy_apply(&deformation, &base, &again));
    assert_int_equal(line.count, again.count);
    assert_memory_equal(line.x, again.x, line.count * sizeof line.x[0]);
    deformation.seed++;
    assert_true(isotopy_apply(&deformation, &base, &again));
    assert_memory_not_equal(line.x, again.x, line.count * sizeof line.x[0]);
}

/* ---- limbs that lie about */

static void clutter_ties_no_knot(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 30; seed++) {
        clutter over = {.up = {0.0, 0.0, 1.0}, .reach = 8e-3, .slope = 0.05, .passes = 10};
        clutter aside = {
            .tail = true, .up = {-1.0, 0.0, 0.0}, .reach = 4e-3, .slope = 0.1, .passes = 4};
        tie((uint32_t)(seed % 4), 3e-3);
        uint32_t before = base.count;
        assert_true(clutter_limb(&base, &over, seed));
        assert_true(clutter_limb(&base, &aside, seed));
        assert_true(base.count > before + 100);
        expect_throws((uint32_t)(seed % 4), &base);
        expect_limbs_without_knots(&base);
    }
}

static void clutter_below_minimum_is_rejected(void **state)
{
    (void)state;
    clutter under = {.up = {0.0, 0.0, -1.0}, .reach = 8e-3, .slope = 0.05, .passes = 10};
    tie(1, 3e-3);
    assert_false(clutter_limb(&base, &under, 1));
}

static void limb_throw_is_a_knot(void **state)
{
    (void)state;
    for (int k = 1; k <= 3; k++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            tie(0, 10e-3);
            assert_true(clutter_throw(&base, k % 2 == 0, k, sign, 1e-3, 20e-3));
            expect_type(knot_type_of_throws(1, &k, &sign), &base);
        }
    }
}

/* ---- sweeps: a corner of a line over or under another part of it */

static void put_corner(double height)
{
    swept_begin(&swept, 1e-3);
    swept_put(&swept, vec3_make(-2.0, 0.0, 0.0), 0.0, true);
    swept_put(&swept, vec3_make(0.0, 2.0, 0.0), 0.0, false); /* vertex 1: the corner */
    swept_put(&swept, vec3_make(2.0, 0.0, 0.0), 0.0, true);
    swept_put(&swept, vec3_make(2.0, 1.0, 3.0), 0.0, true);
    swept_put(&swept, vec3_make(0.0, 1.0, height), 0.0,
              true); /* ends above or below its triangle */
    swept_finish(&swept);
}

static void corner_is_removed_only_from_free_triangle(void **state)
{
    (void)state;
    put_corner(0.1);
    assert_true(swept_remove(&swept, 1));
    put_corner(0.9e-3); /* within the margin */
    assert_false(swept_remove(&swept, 1));
    put_corner(-0.1);
    assert_false(swept_remove(&swept, 1));
    assert_int_equal(5, swept.count);
}

static void vertex_moves_only_through_free_space(void **state)
{
    (void)state;
    put_corner(-0.1);
    assert_false(swept_move(&swept, 1, vec3_make(0.0, 0.2, 0.0)));
    assert_true(swept_move(&swept, 1, vec3_make(0.0, 1.5, 0.0)));
    assert_true(swept_move(&swept, 1, vec3_make(0.0, 1.5, -1.0)));
    assert_true(swept_move(&swept, 1, vec3_make(0.0, 0.2, -1.0)));
    assert_true(swept_move(&swept, 1, vec3_make(0.0, -2.0, 0.0))); /* round the end */
    assert_true(swept_remove(&swept, 1));
}

/* The edge behind the corner's triangle goes on through it, or past it. */
static void next_edge_can_block(void **state)
{
    (void)state;
    for (int inside = 0; inside < 2; inside++) {
        put_corner(0.1);
        swept.x[3] = vec3_make(inside == 1 ? -6.0 : 2.0, 4.0, 0.0);
        swept.x[4] = vec3_add(swept.x[3], vec3_make(0.0, 0.0, 2.0));
        swept_finish(&swept);
        assert_int_equal(inside == 0, swept_remove(&swept, 1));
    }
}

static void rays_block(void **state)
{
    (void)state;
    put_corner(0.1);
    swept_put_ray(&swept, 4, vec3_make(0.0, 0.0, -1.0));
    assert_false(swept_remove(&swept, 1));
    put_corner(0.1);
    swept_put_ray(&swept, 4, vec3_make(0.0, 0.0, 1.0));
    assert_true(swept_remove(&swept, 1));
}

static void curves_closer_than_amplitude_are_rejected(void **state)
{
    (void)state;
    for (int near = 0; near < 2; near++) {
        double strays = near == 1 ? 0.06 : 0.04;
        swept_begin(&swept, 1e-3);
        swept_put(&swept, vec3_make(-2.0, 0.0, 0.0), strays, true);
        swept_put(&swept, vec3_make(2.0, 0.0, 0.0), 0.0, true);
        swept_put(&swept, vec3_make(2.0, 2.0, 0.0), 0.0, true);
        swept_put(&swept, vec3_make(0.0, 2.0, 0.1), 0.0, true);
        swept_put(&swept, vec3_make(0.0, -2.0, 0.1), 0.0, true);
        swept_finish(&swept);
        assert_int_equal(near == 0, swept_is_true(&swept));
    }
}

int test_isotopy(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isotopy_keeps_knot_and_tissue),
        cmocka_unit_test(isotopy_moves_thread_far),
        cmocka_unit_test(markers_stay_on_thread),
        cmocka_unit_test(seed_determines_bits),
        cmocka_unit_test(clutter_ties_no_knot),
        cmocka_unit_test(clutter_below_minimum_is_rejected),
        cmocka_unit_test(limb_throw_is_a_knot),
        cmocka_unit_test(corner_is_removed_only_from_free_triangle),
        cmocka_unit_test(vertex_moves_only_through_free_space),
        cmocka_unit_test(next_edge_can_block),
        cmocka_unit_test(rays_block),
        cmocka_unit_test(curves_closer_than_amplitude_are_rejected),
    };
    return cmocka_run_group_tests_name("isotopy", tests, NULL, NULL);
}
