/* Integers of the library and GMP's side by side. */
#ifndef VBSS_TESTS_COLLISION_GMP_INTEGERS_H
#define VBSS_TESTS_COLLISION_GMP_INTEGERS_H

#include <string.h>

#include <gmp.h>

#include "collision/integers.h"
#include "harness/harness.h"

/* Memory with words behind it that nobody may change. */
enum { ROOM_LIMBS = 30000, ROOM_GUARDS = 64 };
typedef struct room {
    workspace w;
    uint32_t limbs[ROOM_LIMBS + ROOM_GUARDS];
} room;

static inline void room_begin(room *r, uint32_t capacity)
{
    memset(r->limbs, 0x5a, sizeof r->limbs);
    r->w = (workspace){.limbs = r->limbs, .capacity = capacity};
}

static inline void room_check(const room *r)
{
    assert_true(r->w.used <= r->w.capacity);
    for (uint32_t i = 0; i < ROOM_GUARDS; i++) {
        assert_int_equal(r->limbs[r->w.capacity + i], 0x5a5a5a5a);
    }
}

/* By words of 64 bits; zero for a number that found no room. */
static inline integer from_mpz(workspace *w, const mpz_t x)
{
    uint32_t mark = w->used;
    integer sum = integer_zero();
    mpz_t rest;
    mpz_init_set(rest, x);
    mpz_abs(rest, rest);
    for (uint32_t shift = 0; mpz_sgn(rest) != 0; shift += 32) {
        uint64_t word = mpz_get_ui(rest) & UINT32_MAX;
        sum = vbss_integer_add(w, sum, vbss_integer_make(w, word, shift, mpz_sgn(x)));
        sum = vbss_integer_compact(w, mark, sum);
        mpz_fdiv_q_2exp(rest, rest, 32);
    }
    mpz_clear(rest);
    return sum;
}

/* A number in its normal form. */
static inline void to_mpz(const workspace *w, integer a, mpz_t x)
{
    assert_true((a.sign == 0) == (a.count == 0));
    assert_true(a.sign >= -1 && a.sign <= 1);
    assert_true((uint32_t)a.first + a.count <= w->capacity);
    assert_true(a.count == 0 || w->limbs[a.first + a.count - 1u] != 0);
    mpz_import(x, a.count, -1, sizeof(uint32_t), 0, 0, w->limbs + a.first);
    if (a.sign < 0) {
        mpz_neg(x, x);
    }
}

static inline void expect_integer(const workspace *w, const mpz_t wanted, integer got)
{
    mpz_t x;
    mpz_init(x);
    to_mpz(w, got, x);
    bool same = mpz_cmp(x, wanted) == 0;
    mpz_clear(x);
    assert_true(same);
}

/* Up to `limbs` of 32 bits, often of ones or zeros only, so that carries go far. */
static inline void draw_mpz(harness_source *source, uint32_t limbs, mpz_t x)
{
    uint32_t count = harness_draw_below(source, limbs + 1), how = harness_draw_below(source, 4);
    mpz_set_ui(x, 0);
    for (uint32_t i = 0; i < count; i++) {
        uint64_t bits = harness_draw_u64(source);
        mpz_mul_2exp(x, x, 32);
        mpz_add_ui(x, x,
                   how == 0             ? UINT32_MAX
                   : how == 1 && i == 0 ? 1
                   : how == 1           ? 0
                                        : bits & UINT32_MAX);
    }
    if (harness_draw_below(source, 2) != 0) {
        mpz_neg(x, x);
    }
}

#endif
