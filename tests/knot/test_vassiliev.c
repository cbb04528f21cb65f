/* Vassiliev's invariants against tables, formulas, and derivatives of Alexander's and Jones' polynomials. */
#include "knot/codes.h"

#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

static void expect_both(int64_t v2, int64_t v3, const knot_gauss_code *code)
{
    int64_t two, three;
    knot_ops work = 0;
    vbss_knot_vassiliev(code, &two, &three, &work);
    assert_int_equal(v2, two);
    assert_int_equal(v3, three);
    assert_true(work < 0);
}

/* ---- what is known */

static void unknot_invariants_are_zero(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    vbss_random random;
    vbss_random_seed(&random, 3, 0);
    expect_both(0, 0, code);
    codes_grow(code, &random, 60);
    expect_both(0, 0, code);
    codes_free(code);
}

static void known_knot_invariants(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < CODES_KNOWN; i++) {
        codes_named(code, codes_table[i].name);
        expect_both(codes_table[i].v2, codes_table[i].v3, code);
    }
    codes_free(code);
}

/* (p^2 - 1)(q^2 - 1)/24 and p q (p^2 - 1)(q^2 - 1)/144: M. Alvarez and J. M. F. Labastida, "Vassiliev
 * invariants for torus knots", Journal of Knot Theory and Its Ramifications 5 (1996). */
static void torus_knot_invariants(void **state)
{
    (void)state;
    static const int pairs[][2] = {{2, 1}, {2, 3}, {2, 9}, {2, 63}, {3, 4},  {3, 5},
                                   {4, 5}, {5, 3}, {5, 6}, {2, -7}, {3, -5}, {5, -11}};
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        int p = pairs[i][0], q = pairs[i][1], product = (p * p - 1) * (q * q - 1);
        codes_torus(code, p, q);
        expect_both(product / 24, p * q * product / 144, code);
    }
    codes_free(code);
}

static void visit_sum(uint32_t throws, const int *wraps, const int *signs, void *user)
{
    knot_gauss_code *code = user;
    int64_t v2 = 0, v3 = 0;
    codes_throws(code, throws, wraps, signs);
    for (uint32_t i = 0; i < throws; i++) {
        int k = wraps[i];
        v2 += k * (k + 1) / 2;
        v3 += signs[i] * k * (k + 1) * (2 * k + 1) / 6;
    }
    expect_both(v2, v3, code);
}

static void stacked_throw_invariants_add(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    assert_int_equal(210, codes_each_sum(visit_sum, code));
    codes_free(code);
}

/* ---- v2: Alexander's polynomial near 1, by Fox's matrix with t = 1 + e, e^3 = 0, modulo a prime */

enum { PRIME = 998244353, MAX_ROWS = 64 };

typedef struct series {
    int64_t c[3];
} series;

static int64_t modulo(int64_t x)
{
    return (x % PRIME + PRIME) % PRIME;
}

static series times(series a, series b)
{
    return (series){{modulo(a.c[0] * b.c[0]), modulo(a.c[0] * b.c[1] + a.c[1] * b.c[0]),
                     modulo(a.c[0] * b.c[2] + a.c[1] * b.c[1] % PRIME + a.c[2] * b.c[0])}};
}

static series minus(series a, series b)
{
    return (series){{modulo(a.c[0] - b.c[0]), modulo(a.c[1] - b.c[1]), modulo(a.c[2] - b.c[2])}};
}

static series inverse_of(series a)
{
    int64_t first = 1, x = a.c[0];
    for (int64_t power = PRIME - 2; power > 0; power /= 2) {
        first = power % 2 != 0 ? modulo(first * x) : first;
        x = modulo(x * x);
    }
    series result = {{first, 0, 0}}, two = {{2, 0, 0}};
    for (int i = 0; i < 2; i++) { /* Newton: twice as many coefficients */
        result = times(result, minus(two, times(a, result)));
    }
    return result;
}

/* A column an arc from one entry under to the next: (1 - t) over, and t and -1 for those that arrive and leave. */
static int fill_fox(const knot_gauss_code *code, series a[MAX_ROWS][MAX_ROWS])
{
    const series zero = {{0, 0, 0}}, t = {{1, 1, 0}}, one = {{1, 0, 0}};
    int n = (int)code->n, arc = 0, over[MAX_ROWS] = {0}, finishing[MAX_ROWS] = {0};
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        int *arcs = code->over[e] != 0 ? over : finishing;
        arcs[code->crossing[e]] = arc;
        arc += code->over[e] != 0 ? 0 : 1;
    }
    memset(a, 0, sizeof(series[MAX_ROWS][MAX_ROWS]));
    for (int c = 0; c < n; c++) {
        bool right = code->sign[c] > 0;
        series *in = &a[c][finishing[c]], *out = &a[c][(finishing[c] + 1) % n],
               *top = &a[c][over[c] % n];
        *top = minus(*top, minus(t, one));
        *in = minus(*in, right ? one : minus(zero, t));
        *out = minus(*out, right ? minus(zero, t) : one);
    }
    return n - 1;
}

/* The determinant is a power of t, and a sign, times 1 + v2 e^2. */
static int64_t second_coefficient(const knot_gauss_code *code)
{
    series a[MAX_ROWS][MAX_ROWS], product = {{1, 0, 0}};
    int size = fill_fox(code, a);
    for (int k = 0; k < size; k++) {
        int chosen = k;
        while (chosen < size && a[chosen][k].c[0] == 0) {
            chosen++;
        }
        assert_true(chosen < size); /* Delta(1) is 1 or -1 */
        for (int j = 0; j < size; j++) {
            series value = a[k][j];
            a[k][j] = a[chosen][j];
            a[chosen][j] = value;
        }
        product = times(product, a[k][k]);
        series by_pivot = inverse_of(a[k][k]);
        for (int i = k + 1; i < size; i++) {
            series factor = times(a[i][k], by_pivot);
            for (int j = k; j < size; j++) {
                a[i][j] = minus(a[i][j], times(factor, a[k][j]));
            }
        }
    }
    int64_t unit = product.c[0] == 1 ? 1 : -1;
    int64_t power = modulo(unit * product.c[1]), second = modulo(unit * product.c[2]);
    assert_int_equal(1, modulo(unit * product.c[0]));
    power -= power > PRIME / 2 ? PRIME : 0;
    second = modulo(second - power * (power - 1) / 2);
    return second > PRIME / 2 ? second - PRIME : second;
}

static bool draw_braid(harness_source *source, uint32_t limit, knot_gauss_code *code)
{
    int word[MAX_ROWS];
    size_t letters = 3 + harness_draw_below(source, limit - 2);
    int strands = 2 + (int)harness_draw_below(source, 4);
    for (size_t i = 0; i < letters; i++) {
        int letter = 1 + (int)harness_draw_below(source, (uint32_t)strands - 1);
        word[i] = harness_draw_below(source, 2) == 0 ? letter : -letter;
    }
    return codes_braid(code, word, letters);
}

static void any_braid_has_conways_coefficient(harness_source *source, void *user)
{
    knot_gauss_code *code = user;
    if (draw_braid(source, 60, code)) {
        int64_t v2, v3;
        knot_ops work = 0;
        vbss_knot_vassiliev(code, &v2, &v3, &work);
        assert_int_equal(second_coefficient(code), v2);
    }
}

static void v2_is_conway_coefficient(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    harness_property("v2", 1000, any_braid_has_conways_coefficient, code);
    codes_free(code);
}

/* ---- both: derivatives of Jones' polynomial at 1, by Kauffman's sum over all states */

enum { STATE_CROSSINGS = 12, MAX_POWER = 64 };

static uint32_t root_of(const uint32_t *parents, uint32_t i)
{
    while (parents[i] != i) {
        i = parents[i];
    }
    return i;
}

/* Curves that are left when bit c of the state says how crossing c is cut: along the curve's direction, or
 * across. Arc e goes from entry e to the next. */
static int loops_of(const knot_gauss_code *code, uint32_t across)
{
    uint32_t entries = 2 * code->n, parents[2 * STATE_CROSSINGS], seen[STATE_CROSSINGS];
    int loops = (int)entries;
    memset(seen, 0xff, sizeof seen);
    for (uint32_t e = 0; e < entries; e++) {
        parents[e] = e;
    }
    for (uint32_t e = 0; e < entries; e++) {
        uint32_t c = code->crossing[e], mate = seen[c];
        seen[c] = e;
        if (mate == UINT32_MAX) {
            continue;
        }
        uint32_t in = (e + entries - 1) % entries, mate_in = (mate + entries - 1) % entries;
        bool cut_across = (across >> c & 1) != 0;
        const uint32_t pairs[2][2] = {{in, cut_across ? mate_in : mate},
                                      {e, cut_across ? mate : mate_in}};
        for (int i = 0; i < 2; i++) {
            uint32_t a = root_of(parents, pairs[i][0]), b = root_of(parents, pairs[i][1]);
            loops -= a != b ? 1 : 0;
            parents[a] = b;
        }
    }
    return loops;
}

/* Coefficients of A^(4 i) times some power of A in the bracket, where t = A^-4: v2 and v3 from moments. */
static void jones(const knot_gauss_code *code, int64_t *v2, int64_t *v3)
{
    int64_t sums[2 * MAX_POWER + 1] = {0}; /* of powers of A, MAX_POWER in the middle */
    int n = (int)code->n, writhe = 0;
    for (int c = 0; c < n; c++) {
        writhe += code->sign[c];
    }
    for (uint32_t across = 0; across < 1u << n; across++) {
        int power = 0;
        for (int c = 0; c < n; c++) { /* cut along the direction: A where right-handed */
            power += (across >> c & 1) == 0 ? code->sign[c] : -code->sign[c];
        }
        int64_t binomial = 1; /* (-A^2 - A^-2)^(loops - 1) */
        for (int loops = loops_of(code, across) - 1, i = 0; i <= loops; i++) {
            int64_t term = loops % 2 == 0 ? binomial : -binomial;
            sums[MAX_POWER + power + 2 * loops - 4 * i] += term;
            binomial = binomial * (loops - i) / (i + 1);
        }
    }
    int64_t moments[4] = {0, 0, 0, 0}; /* of coefficients of t: 1, k, k (k - 1), k (k - 1)(k - 2) */
    for (int i = 0; i <= 2 * MAX_POWER; i++) {
        int64_t power = i - MAX_POWER - 3 * writhe, k = -power / 4;
        int64_t coefficient = writhe % 2 == 0 ? sums[i] : -sums[i];
        assert_true(coefficient == 0 || power % 4 == 0);
        moments[0] += coefficient;
        moments[1] += coefficient * k;
        moments[2] += coefficient * k * (k - 1);
        moments[3] += coefficient * k * (k - 1) * (k - 2);
    }
    assert_int_equal(1, moments[0]);
    assert_int_equal(0, moments[1]);
    assert_int_equal(0, moments[2] % 6);
    assert_int_equal(0, (moments[3] + 3 * moments[2]) % 36);
    *v2 = -moments[2] / 6;
    *v3 = -(moments[3] + 3 * moments[2]) / 36;
}

static void any_braid_has_those_of_jones(harness_source *source, void *user)
{
    knot_gauss_code *code = user;
    if (draw_braid(source, 10, code)) {
        int64_t v2, v3;
        jones(code, &v2, &v3);
        expect_both(v2, v3, code);
    }
}

static void v2_and_v3_are_jones_derivatives(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    for (size_t i = 0; i < CODES_KNOWN; i++) {
        int64_t v2, v3;
        codes_named(code, codes_table[i].name);
        jones(code, &v2, &v3);
        assert_int_equal(codes_table[i].v2, v2);
        assert_int_equal(codes_table[i].v3, v3);
    }
    harness_property("jones", 300, any_braid_has_those_of_jones, code);
    codes_free(code);
}

/* ---- what changes nothing, and the mirror image */

static void any_diagram_has_the_same(harness_source *source, void *user)
{
    knot_gauss_code *code = user;
    const codes_known *known = &codes_table[harness_draw_below(source, CODES_KNOWN)];
    codes_named(code, known->name);
    codes_grow(code, &source->random, 12 + harness_draw_below(source, 48));
    expect_both(known->v2, known->v3, code);
    codes_rotate(code, harness_draw_below(source, 2 * code->n));
    expect_both(known->v2, known->v3, code);
    codes_reverse(code);
    expect_both(known->v2, known->v3, code);
    codes_mirror(code);
    expect_both(known->v2, -known->v3, code);
}

static void invariants_are_diagram_invariant(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make();
    harness_property("diagrams", 300, any_diagram_has_the_same, code);
    codes_free(code);
}

int test_vassiliev(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(unknot_invariants_are_zero),
        harness_test(known_knot_invariants),
        harness_test(torus_knot_invariants),
        harness_test(stacked_throw_invariants_add),
        harness_test(v2_is_conway_coefficient),
        harness_test(v2_and_v3_are_jones_derivatives),
        harness_test(invariants_are_diagram_invariant),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
