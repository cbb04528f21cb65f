/* Integers of any size against GMP: sums, products, what is kept, and memory that runs out. */
#include "gmp_integers.h"

static room memory;

/* ---- one operation each */

static void sums_and_products(harness_source *source, void *user)
{
    const uint32_t *limbs = user;
    mpz_t x, y, wanted;
    mpz_inits(x, y, wanted, NULL);
    draw_mpz(source, *limbs, x);
    draw_mpz(source, *limbs, y);
    if (harness_draw_below(source, 4) == 0) { /* what cancels, all or but for the last bit */
        mpz_neg(y, x);
        mpz_add_ui(y, y, harness_draw_below(source, 2));
    }
    room_begin(&memory, ROOM_LIMBS);
    workspace *w = &memory.w;
    integer a = from_mpz(w, x), b = from_mpz(w, y);
    expect_integer(w, x, a);
    mpz_add(wanted, x, y);
    expect_integer(w, wanted, vbss_integer_add(w, a, b));
    mpz_sub(wanted, x, y);
    expect_integer(w, wanted, vbss_integer_subtract(w, a, b));
    mpz_mul(wanted, x, y);
    expect_integer(w, wanted, vbss_integer_multiply(w, a, b));
    mpz_mul(wanted, x, x);
    expect_integer(w, wanted, vbss_integer_multiply(w, a, a));
    uint32_t bits = harness_draw_below(source, 2) != 0 ? harness_draw_below(source, 70)
                                                       : harness_draw_below(source, 40000);
    mpz_mul_2exp(wanted, x, bits);
    expect_integer(w, wanted, vbss_integer_shift(w, a, bits));
    expect_integer(w, x, a); /* none of it has changed them */
    expect_integer(w, y, b);
    assert_false(w->full);
    room_check(&memory);
    mpz_clears(x, y, wanted, NULL);
}

static void sums_products_and_shifts(void **state)
{
    (void)state;
    uint32_t few = 3, many = 200;
    harness_property("short integers", 3000, sums_and_products, &few);
    harness_property("long integers", 500, sums_and_products, &many);
}

static void making(harness_source *source, void *user)
{
    (void)user;
    static const uint64_t magnitudes[] = {
        0, 1, UINT32_MAX, UINT64_C(1) << 32, UINT64_C(1) << 63, UINT64_MAX};
    uint32_t which = harness_draw_below(source, 7), shift = harness_draw_below(source, 3000);
    uint64_t any = harness_draw_u64(source), magnitude = which < 6 ? magnitudes[which] : any;
    int sign = harness_draw_below(source, 2) != 0 ? 1 : -1;
    mpz_t wanted;
    mpz_init(wanted);
    mpz_import(wanted, 1, -1, sizeof magnitude, 0, 0, &magnitude);
    mpz_mul_2exp(wanted, wanted, shift);
    mpz_mul_si(wanted, wanted, sign);
    room_begin(&memory, ROOM_LIMBS);
    expect_integer(&memory.w, wanted, vbss_integer_make(&memory.w, magnitude, shift, sign));
    mpz_clear(wanted);
}

static void conversion_with_any_shift(void **state)
{
    (void)state;
    harness_property("making", 2000, making, NULL);
}

/* ---- what is kept */

enum { KEPT = 8 };

/* Some below the mark, some zero, some the same magnitude with another sign, in any order. */
static void keeping(harness_source *source, void *user)
{
    (void)user;
    mpz_t values[KEPT];
    integer numbers[KEPT], *kept[KEPT];
    uint32_t mark = 0, sum = 0, below = harness_draw_below(source, 3);
    room_begin(&memory, ROOM_LIMBS);
    workspace *w = &memory.w;
    for (uint32_t i = 0; i < KEPT; i++) {
        mpz_init(values[i]);
        uint32_t from = harness_draw_below(source, 3) == 0 ? harness_draw_below(source, KEPT) : i;
        if (from < i) {
            mpz_neg(values[i], values[from]);
            numbers[i] = integer_negated(numbers[from]);
        } else {
            draw_mpz(source, 5, values[i]);
            (void)vbss_integer_make(w, 1, harness_draw_below(source, 200), 1); /* a gap */
            numbers[i] = from_mpz(w, values[i]);
            sum += i < below ? 0 : numbers[i].count;
        }
        mark = i < below ? w->used : mark;
    }
    for (uint32_t i = 0; i < KEPT; i++) {
        uint32_t at = harness_draw_below(source, i + 1);
        if (at != i) {
            kept[i] = kept[at];
        }
        kept[at] = &numbers[i];
    }
    vbss_integers_compact(w, mark, kept, KEPT);
    assert_int_equal(w->used, mark + sum);
    for (uint32_t i = 0; i < KEPT; i++) {
        expect_integer(w, values[i], numbers[i]);
        mpz_clear(values[i]);
    }
    uint32_t used = w->used;
    vbss_integers_compact(w, mark, kept, KEPT); /* nothing to do */
    assert_int_equal(w->used, used);
    vbss_integers_compact(w, mark, NULL, 0); /* nothing to keep */
    assert_int_equal(w->used, mark);
}

static void stored_integers_round_trip(void **state)
{
    (void)state;
    harness_property("keeping", 3000, keeping, NULL);
}

/* ---- memory that runs out */

/* A row of operations on a few numbers, in memory of any size. Until it is full all are right; it is
 * never left, and stays full. */
static void running_out(harness_source *source, void *user)
{
    (void)user;
    mpz_t values[4];
    integer numbers[4];
    uint32_t capacity = harness_draw_below(source, 120);
    room_begin(&memory, capacity);
    workspace *w = &memory.w;
    for (int i = 0; i < 4; i++) {
        mpz_init(values[i]);
        numbers[i] = integer_zero();
    }
    for (int step = 0; step < 30; step++) {
        uint32_t to = harness_draw_below(source, 4), what = harness_draw_below(source, 6);
        uint32_t a = harness_draw_below(source, 4), b = harness_draw_below(source, 4);
        uint32_t bits = harness_draw_below(source, 8) == 0
                            ? UINT32_MAX - harness_draw_below(source, 70)
                            : harness_draw_below(source, 300);
        uint64_t magnitude = harness_draw_u64(source);
        bool was_full = w->full;
        if (what == 0) {
            numbers[to] = vbss_integer_make(w, magnitude, bits, -1);
        } else if (what == 1) {
            numbers[to] = vbss_integer_shift(w, numbers[a], bits);
        } else if (what == 2) {
            numbers[to] = vbss_integer_add(w, numbers[a], numbers[b]);
        } else if (what == 3) {
            numbers[to] = vbss_integer_subtract(w, numbers[a], numbers[b]);
        } else {
            numbers[to] = vbss_integer_multiply(w, numbers[a], numbers[b]);
        }
        assert_true(w->full || !was_full);
        room_check(&memory);
        if (w->full) {
            continue;
        }
        if (what == 0) {
            mpz_import(values[to], 1, -1, sizeof magnitude, 0, 0, &magnitude);
            mpz_mul_2exp(values[to], values[to], bits);
            mpz_neg(values[to], values[to]);
        } else if (what == 1) {
            mpz_mul_2exp(values[to], values[a], mpz_sgn(values[a]) == 0 ? 0 : bits);
        } else if (what == 2) {
            mpz_add(values[to], values[a], values[b]);
        } else if (what == 3) {
            mpz_sub(values[to], values[a], values[b]);
        } else {
            mpz_mul(values[to], values[a], values[b]);
        }
        expect_integer(w, values[to], numbers[to]);
    }
    for (int i = 0; i < 4; i++) {
        mpz_clear(values[i]);
    }
}

static void exhausted_memory_is_reported_and_within_bounds(void **state)
{
    (void)state;
    harness_property("running out", 4000, running_out, NULL);
}

/* Exactly as much as is taken is enough, one limb less is not. */
static void last_limb_is_used(void **state)
{
    (void)state;
    for (uint32_t capacity = 0; capacity < 12; capacity++) {
        room_begin(&memory, capacity);
        integer a = vbss_integer_make(&memory.w, UINT64_MAX, 0, 1); /* takes 3, keeps 2 */
        assert_true(memory.w.full == (capacity < 3));
        integer b = vbss_integer_multiply(&memory.w, a, a); /* takes and keeps 4 */
        assert_true(memory.w.full == (capacity < 6));
        assert_true((b.sign == 0) == memory.w.full);
        (void)vbss_integer_add(&memory.w, b, a); /* takes 5 */
        assert_true(memory.w.full == (capacity < 11));
        room_check(&memory);
    }
}

int test_integers(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(sums_products_and_shifts),
        harness_test(conversion_with_any_shift),
        harness_test(stored_integers_round_trip),
        harness_test(exhausted_memory_is_reported_and_within_bounds),
        cmocka_unit_test(last_limb_is_used),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
