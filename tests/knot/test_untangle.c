/* Strands laid anew: fewer crossings, the same knot. */
#include "knot/diagram.h"

#include <string.h>

static diagram d;

enum { TRIES = 1000 };

static int begin(void **state)
{
    (void)state;
    diagram_begin(&d, DIAGRAM_CROSSINGS);
    return 0;
}

static int end(void **state)
{
    (void)state;
    diagram_end(&d);
    return 0;
}

static bool untangle(uint32_t tries)
{
    knot_ops work = 0;
    bool lowered = false;
    while (vbss_knot_gauss_code_untangle(&d.code, &d.spare, &tries, &work)) {
        lowered = true;
    }
    assert_true(work <= 0);
    assert_true(vbss_knot_gauss_code_is_planar(&d.code));
    return lowered;
}

static void simplify(void)
{
    knot_ops work = 0;
    vbss_knot_gauss_code_simplify(&d.code, &work);
}

static void expect_in_order(const knot_gauss_code *code)
{
    uint32_t visited = 0;
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        assert_true(code->crossing[e] <= visited);
        visited += code->crossing[e] == visited ? 1 : 0;
        assert_true(code->position[e] > (e == 0 ? 0.0 : code->position[e - 1]));
    }
    assert_int_equal(code->n, visited);
}

static void minimal_diagrams_stay(void **state)
{
    (void)state;
    diagram_set_code(&d.code, "", "");
    assert_false(untangle(TRIES));
    diagram_set_code(&d.code, "AbCaBc", "+++");
    assert_false(untangle(TRIES));
    diagram_expect_code("AbCaBc", "+++", &d.code);
    expect_same_bits(2.5, d.code.position[2]);
    diagram_set_code(&d.code, "AbCaDcBd", "+--+");
    assert_false(untangle(TRIES));
    diagram_expect_code("AbCaDcBd", "+--+", &d.code);
}

/* Moves I and II do not see it: a trefoil lies on one side of a crossing, a figure-eight on the other. */
static void loop_with_knot_is_undone(void **state)
{
    (void)state;
    static const char *const codes[] = {"AbCaDEfGeHgFhdBc", "AbCadEfGeHgFhDBc"};
    for (int i = 0; i < 4; i++) {
        diagram_set_code(&d.code, codes[i % 2], i < 2 ? "++++-++-" : "+++--++-");
        assert_true(vbss_knot_gauss_code_is_planar(&d.code));
        simplify();
        assert_int_equal(8, d.code.n);
        assert_true(untangle(TRIES));
        diagram_expect_code("AbCaDeFdGfEgBc", "+++-++-", &d.code);
        expect_in_order(&d.code);
    }
}

/* All its memory is used up to here. */
static void code_without_capacity_stays(void **state)
{
    (void)state;
    static diagram small;
    knot_ops work = 0;
    for (uint32_t capacity = 8; capacity <= 10; capacity++) {
        diagram_begin(&small, capacity);
        diagram_set_code(&small.code, "AbCaDEfGeHgFhdBc", "++++-++-");
        uint32_t tries = TRIES;
        assert_int_equal(capacity == 10,
                         vbss_knot_gauss_code_untangle(&small.code, &small.spare, &tries, &work));
        assert_int_equal(capacity == 10 ? 7 : 8, small.code.n);
        diagram_end(&small);
    }
}

static void any_code_becomes_a_smaller_one_of_the_same_knot(harness_source *source, void *user)
{
    uint32_t *lowered = user;
    diagram_random(&d, source, 8 + harness_draw_below(source, 20));
    diagram_project_plain(&d, harness_draw_below(source, 20));
    int64_t determinant = diagram_determinant(&d.code), v2 = diagram_v2(&d.code);
    simplify();
    uint32_t n = d.code.n;
    assert_false(untangle(0));
    assert_int_equal(n, d.code.n);
    memset(d.spare.scratch, (int)harness_draw_below(source, 256),
           4 * (size_t)d.spare.capacity * sizeof d.spare.scratch[0]);
    for (uint32_t e = 0; e < 2 * d.spare.capacity; e++) {
        d.spare.position[e] = 1e9; /* what was there does not matter */
    }
    bool reported = untangle(TRIES);
    assert_int_equal(d.code.n < n, reported);
    assert_true(d.code.n <= n);
    assert_int_equal(determinant, diagram_determinant(&d.code));
    assert_int_equal(v2, diagram_v2(&d.code));
    expect_in_order(&d.code);
    assert_true(d.code.n == 0 || d.code.position[2 * d.code.n - 1] < d.polygon.count);
    assert_false(untangle(TRIES)); /* nothing was left to do */
    *lowered += reported ? 1 : 0;
}

static void reduction_keeps_knot_type(void **state)
{
    (void)state;
    uint32_t lowered = 0;
    harness_property("untangled", 500, any_code_becomes_a_smaller_one_of_the_same_knot, &lowered);
    assert_true(lowered >= 100);
}

/* Of given polygons, as many as were when each strand took a shortest way. */
static void few_crossings_remain(void **state)
{
    (void)state;
    harness_source source = {0};
    uint32_t before = 0, left = 0;
    vbss_random_seed(&source.random, 11, 4);
    for (int i = 0; i < 300; i++) {
        diagram_random(&d, &source, 20);
        diagram_project_plain(&d, 0);
        simplify();
        before += d.code.n;
        untangle(TRIES);
        left += d.code.n;
    }
    assert_true(before > 4000);
    assert_true(left <= 873);
}

int test_untangle(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(minimal_diagrams_stay),       harness_test(loop_with_knot_is_undone),
        harness_test(code_without_capacity_stays), harness_test(reduction_keeps_knot_type),
        harness_test(few_crossings_remain),
    };
    return cmocka_run_group_tests_name("untangle", tests, begin, end);
}
