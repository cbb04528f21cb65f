/* Values of the Jones polynomial against tables and closed forms, and under moves of diagrams. */
#include "knot/algebra_room.h"
#include "knot/prime_field.h"

#include <string.h>

enum { CAPACITY = 128 };

/* The library's t, computed from its points A, t = A^-4. */
static const uint32_t points[KNOT_JONES_POINTS] = {7, 16807, 48271, 69621};

static uint32_t field_subtract(uint32_t a, uint32_t b)
{
    return field_add(a, field_negative(b));
}

static uint32_t t_of(uint32_t point)
{
    return field_inverse(field_power(points[point], 4));
}

typedef struct values {
    uint32_t at[KNOT_JONES_POINTS];
} values;

static algebra_room *room;

static int begin(void **state)
{
    (void)state;
    room = algebra_room_make(CAPACITY);
    return 0;
}

static int end(void **state)
{
    (void)state;
    algebra_room_end(room);
    return 0;
}

static bool has_jones(const knot_gauss_code *code, knot_invariants *v, knot_ops piece)
{
    const knot_ops max_begin = 1000 + 4 * CAPACITY, max_piece = 100 + CAPACITY;
    knot_ops budget = piece;
    vbss_knot_jones_begin(&room->bracket, code, &budget);
    assert_true(budget < piece && budget >= piece - max_begin);
    while (!vbss_knot_bracket_resume(&room->bracket, &budget)) {
        assert_true(budget <= 0 && budget >= -max_begin - max_piece);
        budget = piece;
    }
    *v = (knot_invariants){.known = false};
    bool is_known = vbss_knot_jones_end(&room->bracket, v);
    assert_int_equal(v->jones_known, is_known);
    return is_known;
}

static values jones_of(const knot_gauss_code *code)
{
    knot_invariants v;
    values got;
    assert_true(has_jones(code, &v, INT64_MAX));
    memcpy(got.at, v.jones, sizeof got.at);
    return got;
}

static void expect_values(const values *wanted, const knot_gauss_code *code)
{
    values got = jones_of(code);
    assert_memory_equal(wanted->at, got.at, sizeof got.at);
}

/* ---- polynomials */

enum { TERMS = 12 };

/* Coefficients of t^low, t^(low + 1), ... */
typedef struct polynomial {
    const char *name;
    int low, terms, coefficients[TERMS];
} polynomial;

/* KnotInfo, "Jones polynomial", for knots of codes_table. */
static const polynomial table[] = {
    {"3_1", 1, 4, {1, 0, 1, -1}},
    {"4_1", -2, 5, {1, -1, 1, -1, 1}},
    {"5_1", 2, 6, {1, 0, 1, -1, 1, -1}},
    {"5_2", 1, 6, {1, -1, 2, -1, 1, -1}},
    {"6_3", -3, 7, {-1, 2, -2, 3, -2, 2, -1}},
    {"7_1", 3, 8, {1, 0, 1, -1, 1, -1, 1, -1}},
    {"8_19", 3, 6, {1, 0, 1, 0, 0, -1}},
    {"10_124", 4, 7, {1, 0, 1, 0, 0, 0, -1}},
};

static uint32_t power_of_t(uint32_t point, int exponent)
{
    uint32_t t = t_of(point);
    return exponent >= 0 ? field_power(t, (uint32_t)exponent)
                         : field_power(field_inverse(t), (uint32_t)-exponent);
}

static values values_of(const polynomial *p)
{
    values v;
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        v.at[i] = 0;
        for (int k = 0; k < p->terms; k++) {
            int c = p->coefficients[k];
            uint32_t size = (uint32_t)(c < 0 ? -c : c);
            uint32_t term = field_multiply(size, power_of_t(i, p->low + k));
            v.at[i] = c < 0 ? field_subtract(v.at[i], term) : field_add(v.at[i], term);
        }
    }
    return v;
}

static void known_knots_have_known_polynomials(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        values wanted = values_of(&table[i]);
        codes_named(code, table[i].name);
        expect_values(&wanted, code);
    }
    codes_free(code);
}

/* t^((p - 1)(q - 1)/2) (1 - t^(p + 1) - t^(q + 1) + t^(p + q)) / (1 - t^2): V. F. R. Jones, "Hecke
 * algebra representations of braid groups and link polynomials", Annals of Mathematics 126 (1987).
 */
static values of_torus_knot(int p, int q)
{
    values v;
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        uint32_t sum = field_subtract(1, power_of_t(i, p + 1));
        sum = field_subtract(sum, power_of_t(i, q + 1));
        sum = field_add(sum, power_of_t(i, p + q));
        sum = field_multiply(sum, power_of_t(i, (p - 1) * (q - 1) / 2));
        v.at[i] = field_multiply(sum, field_inverse(field_subtract(1, power_of_t(i, 2))));
    }
    return v;
}

static void torus_knots_have_closed_form(void **state)
{
    (void)state;
    static const int pairs[][2] = {{2, 1}, {2, 3},  {2, 5}, {2, 7}, {2, 9}, {2, 63}, {2, 127},
                                   {3, 2}, {3, 16}, {4, 5}, {5, 3}, {5, 8}, {6, 7}};
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        values wanted = of_torus_knot(pairs[i][0], pairs[i][1]);
        codes_torus(code, pairs[i][0], pairs[i][1]);
        expect_values(&wanted, code);
    }
    codes_free(code);
}

/* ---- throws */

static values of_throws(uint32_t throws, const int *wraps, const int *signs)
{
    knot_factors factors = {.count = throws};
    knot_invariants invariants;
    values v;
    for (uint32_t i = 0; i < throws; i++) {
        factors.factors[i] = (knot_factor){.wraps = wraps[i], .handedness = signs[i]};
    }
    vbss_knot_jones_of(&factors, &invariants);
    assert_true(invariants.jones_known);
    memcpy(v.at, invariants.jones, sizeof v.at);
    return v;
}

static void throw_has_polynomial_of_torus_knot(void **state)
{
    (void)state;
    for (int wraps = 1; wraps <= 60; wraps++) {
        const int right = 1;
        values wanted = of_torus_knot(2, 2 * wraps + 1), got = of_throws(1, &wraps, &right);
        assert_memory_equal(wanted.at, got.at, sizeof got.at);
    }
}

static void visit_sum(uint32_t throws, const int *wraps, const int *signs, void *user)
{
    values product = of_throws(0, NULL, NULL), wanted = of_throws(throws, wraps, signs);
    for (uint32_t k = 0; k < throws; k++) {
        values factor = of_throws(1, wraps + k, signs + k);
        for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
            product.at[i] = field_multiply(product.at[i], factor.at[i]);
        }
    }
    assert_memory_equal(product.at, wanted.at, sizeof wanted.at);
    codes_throws(user, throws, wraps, signs);
    if (throws > 0) {
        expect_values(&product, user);
    }
}

static void stacked_throws_have_the_product(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    assert_int_equal(210, codes_each_sum(visit_sum, code));
    codes_free(code);
}

/* ---- moves */

static values mirrored(const polynomial *p)
{
    polynomial other = {p->name, 1 - p->low - p->terms, p->terms, {0}};
    for (int k = 0; k < p->terms; k++) {
        other.coefficients[k] = p->coefficients[p->terms - 1 - k];
    }
    return values_of(&other);
}

static void moves_change_nothing_and_mirror_inverts_t(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    vbss_random random;
    vbss_random_seed(&random, 5, 1);
    for (uint32_t i = 0; i < 200; i++) {
        const polynomial *p = &table[i % (sizeof table / sizeof table[0])];
        knot_invariants v;
        codes_named(code, p->name);
        codes_grow(code, &random, code->n + vbss_random_below(&random, 14));
        codes_rotate(code, vbss_random_below(&random, 2 * code->n));
        bool is_mirrored = vbss_random_below(&random, 2) == 0;
        if (is_mirrored) {
            codes_mirror(code);
        }
        if (vbss_random_below(&random, 2) == 0) {
            codes_reverse(code);
        }
        values wanted = is_mirrored ? mirrored(p) : values_of(p);
        if (has_jones(code, &v, INT64_MAX)) {
            assert_memory_equal(wanted.at, v.jones, sizeof v.jones);
        }
    }
    codes_free(code);
}

static void unknot_has_polynomial_one(void **state)
{
    (void)state;
    const values one = of_throws(0, NULL, NULL);
    knot_gauss_code *code = codes_make();
    vbss_random random;
    vbss_random_seed(&random, 6, 1);
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        assert_int_equal(one.at[i], 1);
    }
    for (uint32_t crossings = 1; crossings < 20; crossings++) {
        code->n = 0;
        codes_grow(code, &random, crossings);
        expect_values(&one, code);
    }
    codes_free(code);
}

/* ---- work */

static void slicing_of_work_changes_nothing(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    codes_torus(code, 5, 8);
    values wanted = jones_of(code);
    for (knot_ops piece = 1; piece < 100000; piece *= 7) {
        knot_invariants v;
        assert_true(has_jones(code, &v, piece));
        assert_memory_equal(wanted.at, v.jones, sizeof v.jones);
    }
    codes_free(code);
}

/* Of eleven strands 22 arcs are open at once. */
static void wide_diagram_has_no_result(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    knot_invariants v;
    codes_torus(code, 11, 12);
    assert_true(code->n <= CAPACITY);
    assert_false(has_jones(code, &v, INT64_MAX));
    codes_free(code);
}

int test_jones(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_knots_have_known_polynomials),
        cmocka_unit_test(torus_knots_have_closed_form),
        cmocka_unit_test(throw_has_polynomial_of_torus_knot),
        cmocka_unit_test(stacked_throws_have_the_product),
        cmocka_unit_test(moves_change_nothing_and_mirror_inverts_t),
        cmocka_unit_test(unknot_has_polynomial_one),
        cmocka_unit_test(slicing_of_work_changes_nothing),
        cmocka_unit_test(wide_diagram_has_no_result),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
