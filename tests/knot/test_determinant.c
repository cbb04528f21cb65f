/* Determinants of knots against tables, formulas and the matrix of colourings. */
#include <stdlib.h>
#include <string.h>

#include "knot/algebra_room.h"

static algebra_room *room;

static int begin(void **state)
{
    (void)state;
    room = algebra_room_make(CODES_MAX);
    return 0;
}

static int end(void **state)
{
    (void)state;
    algebra_room_end(room);
    return 0;
}

static int64_t determinant_of(const knot_gauss_code *code)
{
    knot_ops work = 0;
    int64_t determinant = vbss_knot_determinant(&room->algebra, code, &work);
    assert_true(work < 0);
    return determinant;
}

/* ---- what is known */

static void unknot_determinant_is_one(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    vbss_random random;
    vbss_random_seed(&random, 3, 0);
    assert_int_equal(1, determinant_of(code));
    for (int i = 0; i < 10; i++) {
        assert_true(codes_move_1(code, &random));
        assert_int_equal(1, determinant_of(code));
    }
    codes_grow(code, &random, 60);
    assert_int_equal(1, determinant_of(code));
    codes_free(code);
}

static void known_knot_determinants(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < CODES_KNOWN; i++) {
        codes_named(code, codes_table[i].name);
        assert_int_equal(codes_table[i].determinant, determinant_of(code));
    }
    codes_free(code);
}

static void torus_knot_determinants(void **state)
{
    (void)state;
    static const int pairs[][2] = {{2, 1}, {2, 3}, {2, 5},  {2, 7},  {2, 63}, {3, 2},
                                   {3, 4}, {3, 5}, {3, 7},  {4, 3},  {4, 5},  {5, 2},
                                   {5, 3}, {5, 6}, {2, -5}, {3, -4}, {5, -7}};
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        int p = pairs[i][0], q = abs(pairs[i][1]);
        codes_torus(code, p, pairs[i][1]);
        assert_int_equal(p % 2 == 0 ? q : q % 2 == 0 ? p : 1, determinant_of(code));
    }
    codes_free(code);
}

static void visit_sum(uint32_t throws, const int *wraps, const int *signs, void *user)
{
    knot_gauss_code *code = user;
    int64_t wanted = 1;
    codes_throws(code, throws, wraps, signs);
    for (uint32_t i = 0; i < throws; i++) {
        wanted *= 2 * wraps[i] + 1;
    }
    assert_int_equal(wanted, determinant_of(code));
}

static void stacked_throws_multiply(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    assert_int_equal(210, codes_each_sum(visit_sum, code));
    codes_free(code);
}

/* Closures of the braids (1, -2)^k: L(2 k) - 2, L being Lucas' numbers: up to 2^44. */
static void nonplanar_code_has_no_determinant(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    int word[64];
    int64_t lucas = 2, next = 1;
    for (int k = 1; k <= 32; k++) {
        word[2 * k - 2] = 1;
        word[2 * k - 1] = -2;
        lucas += next; /* L(2 k) */
        next += lucas;
        if (k % 3 != 0) {
            assert_true(codes_braid(code, word, 2 * (size_t)k));
            assert_int_equal(lucas - 2, determinant_of(code));
        }
    }
    assert_true(lucas > (int64_t)1 << 44);
    codes_free(code);
}

static void large_determinant_does_not_overflow(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    codes_named(code, "3_1");
    code->sign[1] = -1;
    assert_int_equal(0, determinant_of(code));
    codes_free(code);
}

/* ---- against the matrix of colourings, of up to 60 crossings, modulo another prime */

enum { OTHER_PRIME = 998244353, MAX_ROWS = 64 };

static int64_t modulo(int64_t x)
{
    return (x % OTHER_PRIME + OTHER_PRIME) % OTHER_PRIME;
}

static int64_t inverse_of(int64_t x)
{
    int64_t result = 1;
    for (int64_t power = OTHER_PRIME - 2; power > 0; power /= 2) {
        result = power % 2 != 0 ? modulo(result * x) : result;
        x = modulo(x * x);
    }
    return result;
}

/* A column an arc from one entry under to the next. */
static int fill_colourings(const knot_gauss_code *code, int64_t a[MAX_ROWS][MAX_ROWS])
{
    int n = (int)code->n, arc = 0, over[MAX_ROWS] = {0}, finishing[MAX_ROWS] = {0};
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        int *arcs = code->over[e] != 0 ? over : finishing;
        arcs[code->crossing[e]] = arc;
        arc += code->over[e] != 0 ? 0 : 1;
    }
    memset(a, 0, sizeof(int64_t[MAX_ROWS][MAX_ROWS]));
    for (int c = 0; c < n; c++) {
        a[c][over[c] % n] += 2;
        a[c][finishing[c]] -= 1;
        a[c][(finishing[c] + 1) % n] -= 1;
    }
    return n - 1;
}

/* Up to its sign, in [0, OTHER_PRIME). */
static int64_t determinant_of_colourings(const knot_gauss_code *code)
{
    int64_t a[MAX_ROWS][MAX_ROWS], product = 1;
    int size = fill_colourings(code, a);
    for (int k = 0; k < size; k++) {
        int chosen = k;
        while (chosen < size && modulo(a[chosen][k]) == 0) {
            chosen++;
        }
        if (chosen == size) {
            return 0;
        }
        for (int j = 0; j < size; j++) {
            int64_t value = a[k][j];
            a[k][j] = a[chosen][j];
            a[chosen][j] = value;
        }
        product = modulo(product * modulo(a[k][k]));
        int64_t by_pivot = inverse_of(modulo(a[k][k]));
        for (int i = k + 1; i < size; i++) {
            int64_t factor = modulo(modulo(a[i][k]) * by_pivot);
            for (int j = k; j < size; j++) {
                a[i][j] = modulo(a[i][j] - factor * modulo(a[k][j]));
            }
        }
    }
    return product;
}

static void expect_that_of_colourings(const knot_gauss_code *code)
{
    int64_t ours = determinant_of(code) % OTHER_PRIME, theirs = determinant_of_colourings(code);
    assert_true(ours == theirs || ours == modulo(-theirs));
}

static void any_braid_has_that_of_colourings(harness_source *source, void *user)
{
    knot_gauss_code *code = user;
    int word[MAX_ROWS];
    size_t letters = 3 + harness_draw_below(source, MAX_ROWS - 4);
    int strands = 2 + (int)harness_draw_below(source, 4);
    for (size_t i = 0; i < letters; i++) {
        int letter = 1 + (int)harness_draw_below(source, (uint32_t)strands - 1);
        word[i] = harness_draw_below(source, 2) == 0 ? letter : -letter;
    }
    if (codes_braid(code, word, letters)) {
        expect_that_of_colourings(code);
    }
}

static void braid_determinant_matches_colourings(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    harness_property("determinants", 2000, any_braid_has_that_of_colourings, code);
    codes_free(code);
}

/* ---- what changes nothing */

static void any_diagram_has_the_same(harness_source *source, void *user)
{
    knot_gauss_code *code = user;
    const codes_known *known = &codes_table[harness_draw_below(source, CODES_KNOWN)];
    codes_named(code, known->name);
    codes_grow(code, &source->random, 12 + harness_draw_below(source, 48));
    assert_int_equal(known->determinant, determinant_of(code));
    codes_mirror(code);
    assert_int_equal(known->determinant, determinant_of(code));
    codes_reverse(code);
    assert_int_equal(known->determinant, determinant_of(code));
    codes_rotate(code, harness_draw_below(source, 2 * code->n));
    assert_int_equal(known->determinant, determinant_of(code));
}

static void determinant_is_diagram_invariant(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    harness_property("diagrams", 300, any_diagram_has_the_same, code);
    codes_free(code);
}

int test_determinant(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(unknot_determinant_is_one),
        harness_test(known_knot_determinants),
        harness_test(torus_knot_determinants),
        harness_test(stacked_throws_multiply),
        harness_test(nonplanar_code_has_no_determinant),
        harness_test(large_determinant_does_not_overflow),
        harness_test(braid_determinant_matches_colourings),
        harness_test(determinant_is_diagram_invariant),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
