/* Integer polynomials against GMP: sums and products, roots between 0 and 1, signs at roots. */
#include "known_roots.h"

static room memory;

static polynomial to_polynomial(workspace *w, mpz_t *c, int degree)
{
    polynomial p = {.degree = -1};
    for (int i = 0; i <= degree; i++) {
        p.c[i] = from_mpz(w, c[i]);
    }
    vbss_polynomial_trim(&p, degree);
    return p;
}

/* ---- roots, and signs at roots */

/* The known root that is alone between the places. */
static const surd *expect_isolated(const workspace *w, const known *k, const root *r)
{
    const surd *found = NULL;
    for (int i = 0; i < k->count; i++) {
        if (side_of(w, &k->roots[i], r->low) > 0 && side_of(w, &k->roots[i], r->high) < 0) {
            assert_null(found);
            found = &k->roots[i];
        }
    }
    assert_non_null(found);
    return found;
}

static void roots_and_signs(harness_source *source, void *user)
{
    uint64_t *reported = user; /* how many times: a sign of zero, memory that ran out */
    known k;
    mpz_t c[3];
    draw_known(source, &k);
    mpz_inits(c[0], c[1], c[2], NULL);
    bool tight = harness_draw_below(source, 4) == 0;
    room_begin(&memory, tight ? harness_draw_below(source, 3000) : ROOM_LIMBS);
    workspace *w = &memory.w;
    polynomial p = to_polynomial(w, k.c, k.degree);
    sturm s;
    root roots[3];
    int32_t inside = 0, count = w->full ? 0 : vbss_roots_between(w, &p, &s, roots);
    for (int i = 0; i < k.count; i++) {
        inside += is_between_0_and_1(&k.roots[i]) ? 1 : 0;
    }
    assert_true(w->full || count == inside);
    const surd *last = NULL;
    for (int32_t i = 0; i < count && !w->full; i++) {
        const surd *truth = expect_isolated(w, &k, &roots[i]);
        assert_true(last == NULL || side_of(w, last, roots[i].low) <= 0); /* ascending */
        for (int again = 0; again < 4 && !w->full; again++) {
            draw_second(source, &k, c);
            polynomial q = to_polynomial(w, c, 2);
            int32_t sign = w->full ? 0 : vbss_sign_at_root(w, &q, &s, &roots[i]);
            room_check(&memory);
            assert_true(w->full || sign == sign_at(c, truth));
            assert_true(w->full || expect_isolated(w, &k, &roots[i]) == truth);
            reported[0] += !w->full && sign == 0;
        }
        last = truth;
    }
    assert_true(tight || !w->full);
    reported[1] += w->full;
    room_check(&memory);
    mpz_clears(c[0], c[1], c[2], NULL);
    for_all(&k, end);
}

static void roots_and_signs_in_unit_interval(void **state)
{
    (void)state;
    uint64_t reported[2] = {0};
    harness_property("roots and signs", 4000, roots_and_signs, reported);
    print_message("%llu signs of zero, %llu times out of memory\n", (unsigned long long)reported[0],
                  (unsigned long long)reported[1]);
    assert_true(reported[0] > 500 && reported[1] > 100);
}

/* ---- arithmetic */

static void arithmetic(harness_source *source, void *user)
{
    (void)user;
    known a = {.degree = 0}, b = {.degree = 0};
    for_all(&a, begin);
    for_all(&b, begin);
    a.degree = (int)harness_draw_below(source, 4);
    b.degree = (int)harness_draw_below(source, 4 - (uint32_t)a.degree);
    room_begin(&memory, ROOM_LIMBS);
    workspace *w = &memory.w;
    for (int i = 0; i < 4; i++) {
        draw_mpz(source, i <= a.degree ? 20 : 0, a.c[i]);
        draw_mpz(source, i <= b.degree ? 20 : 0, b.c[i]);
    }
    polynomial p = to_polynomial(w, a.c, a.degree), q = to_polynomial(w, b.c, b.degree);
    polynomial sum = vbss_polynomial_add(w, &p, &q), less = vbss_polynomial_subtract(w, &p, &q);
    polynomial product = vbss_polynomial_multiply(w, &p, &q);
    uint32_t bits = harness_draw_below(source, 100);
    draw_mpz(source, 4, a.n);
    mpz_abs(a.n, a.n);
    dyadic t = {from_mpz(w, a.n), bits};
    for (int i = a.degree; i >= 0; i--) { /* Horner: 2^(bits degree) times the value */
        mpz_mul(a.d, a.d, a.n);
        mpz_mul_2exp(b.d, a.c[i], (mp_bitcnt_t)bits * (mp_bitcnt_t)(a.degree - i));
        mpz_add(a.d, a.d, b.d);
    }
    assert_int_equal(mpz_sgn(a.d), vbss_polynomial_sign_at(w, &p, t));
    for (int i = 0; i < 4; i++) {
        mpz_add(a.n, a.c[i], b.c[i]);
        expect_integer(w, a.n, i <= sum.degree ? sum.c[i] : integer_zero());
        mpz_sub(a.n, a.c[i], b.c[i]);
        expect_integer(w, a.n, i <= less.degree ? less.c[i] : integer_zero());
    }
    multiply(&a, b.c, b.degree);
    for (int i = 0; i < 4; i++) {
        expect_integer(w, a.c[i], i <= product.degree ? product.c[i] : integer_zero());
    }
    assert_true(sum.degree < 0 || sum.c[sum.degree].sign != 0);
    assert_true(product.degree < 0 || product.c[product.degree].sign != 0);
    for_all(&a, end);
    for_all(&b, end);
}

static void sums_products_and_values(void **state)
{
    (void)state;
    harness_property("polynomials", 2000, arithmetic, NULL);
}

int test_polynomials(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(sums_products_and_values),
        harness_test(roots_and_signs_in_unit_interval),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
