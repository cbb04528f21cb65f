#include <math.h>

#include "solver/twin.h"

static twin subject;

/* ---- three blocks in a row, in all roles, with one number spoiled */

static void begin_three(twin *t, uint32_t pattern)
{
    t->blocks = t->chain_end[0] = 3;
    t->reach = t->chains = 1;
    t->couplings = 2;
    for (uint32_t b = 0; b < 3; b++) {
        t->roles[b] = (pattern >> b & 1u) != 0 ? VBSS_ROLE_SEPARATOR : VBSS_ROLE_INTERIOR;
        t->diagonal[b] = mat3_diagonal(4.0, 5.0, 6.0);
        t->diagonal[b].m[0][1] = t->diagonal[b].m[1][0] = 1.0;
        t->rhs[b] = vec3_make(1.0, 2.0, 3.0);
    }
    const mat3 m = {{{0.5, -0.25, 0.0}, {0.0, 0.5, 0.25}, {0.25, 0.0, -0.5}}};
    for (uint32_t c = 0; c < 2; c++) {
        t->coupling[c] = (twin_coupling){c + 1, c, false, m, VBSS_NO_COUPLING};
    }
    twin_begin(t);
    expect_ok(twin_register(t));
}

static void expect_solved(twin *t, bool wanted)
{
    uint64_t before = t->system->tiny_pivots;
    twin_write(t);
    assert_int_equal(twin_solve(t), wanted);
    assert_int_equal(t->system->tiny_pivots, before + (wanted ? 0u : 1u));
}

static void non_finite_matrix_is_rejected(void **state)
{
    (void)state;
    twin *t = &subject;
    for (uint32_t pattern = 0; pattern < 8; pattern++) {
        begin_three(t, pattern);
        for (uint32_t spoiled = 0; spoiled < 5 * 9 * 3; spoiled++) {
            uint32_t b = spoiled / 27, i = spoiled / 9 % 3, j = spoiled / 3 % 3;
            mat3 *m = b < 3 ? &t->diagonal[b] : &t->coupling[b - 3].m;
            const mat3 good = *m;
            m->m[i][j] = harness_bad_numbers[spoiled % 3];
            if (b < 3) {
                m->m[j][i] = m->m[i][j];
            }
            expect_solved(t, false);
            *m = good;
        }
        expect_solved(t, true); /* and is fit for use again */
        twin_end(t);
    }
}

static void singular_or_indefinite_block_is_rejected(void **state)
{
    (void)state;
    twin *t = &subject;
    static const mat3 bad[] = {
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},         /* empty */
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}},         /* no stiffness in one direction */
        {{{1, 1, 0}, {1, 1, 0}, {0, 0, 1}}},         /* the same, aslant */
        {{{0.1, 0.3, 0}, {0.3, 0.9, 0}, {0, 0, 1}}}, /* the same, but for rounding */
        {{{4, 2, 6}, {2, 1, 3}, {6, 3, 9}}},         /* in two directions */
    };
    static const mat3 indefinite[] = {
        {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, /* each place of the pivot */
        {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
        {{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}}},  {{{1, 0, 2}, {0, 1, 0}, {2, 0, 1}}},
        {{{1, 0, 0}, {0, 1, 2}, {0, 2, 1}}},
    };
    for (uint32_t pattern = 0; pattern < 8; pattern++) {
        begin_three(t, pattern);
        t->coupling[0].m = t->coupling[1].m = mat3_zero();
        for (uint32_t b = 0; b < 3; b++) {
            const mat3 good = t->diagonal[b];
            for (uint32_t i = 0; i < 5; i++) {
                t->diagonal[b] = bad[i];
                expect_solved(t, false);
            }
            /* Runs need a definite matrix; separators may have any that is regular. */
            for (uint32_t i = 0; i < 6; i++) {
                t->diagonal[b] = indefinite[i];
                expect_solved(t, t->roles[b] == VBSS_ROLE_SEPARATOR);
            }
            t->diagonal[b] = good;
        }
        expect_solved(t, true);
        twin_end(t);
    }
}

/* Blocks that are good alone and bad together. */
static void couplings_making_matrix_indefinite_are_rejected(void **state)
{
    (void)state;
    twin *t = &subject;
    for (uint32_t pattern = 0; pattern < 8; pattern++) {
        begin_three(t, pattern);
        for (uint32_t b = 0; b < 3; b++) {
            t->diagonal[b] = mat3_diagonal(b == 1 ? 2.0 : 1.0, 2.0, 2.0);
        }
        t->coupling[0].m = t->coupling[1].m = mat3_diagonal(-1.0, 0.0, 0.0); /* free to move in x */
        expect_solved(t, false);
        for (uint32_t b = 0; b < 3; b++) {
            t->diagonal[b].m[0][0] += 0.5;
        }
        expect_solved(t, true);
        /* Indefinite: the second of the two has the negative pivot, which a separator may have. */
        t->coupling[0].m = mat3_diagonal(-4.0, 0.0, 0.0);
        expect_solved(t, (pattern & 3u) != 0u);
        twin_end(t);
    }
}

/* The matrix alone is judged; a broken force must not vanish. */
static void non_finite_force_propagates(void **state)
{
    (void)state;
    twin *t = &subject;
    for (uint32_t pattern = 0; pattern < 8; pattern++) {
        begin_three(t, pattern);
        for (uint32_t spoiled = 0; spoiled < 9; spoiled++) {
            t->rhs[spoiled / 3].y = harness_bad_numbers[spoiled % 3];
            twin_write(t);
            if (twin_solve(t)) {
                assert_false(vec3_is_finite(t->system->solution[spoiled / 3]));
            }
            t->rhs[spoiled / 3].y = 1.0;
        }
        twin_end(t);
    }
}

/* Any bits at all: told or solved, no crash. */
static void any_numbers(harness_source *source, void *user)
{
    (void)user;
    twin *t = &subject;
    begin_three(t, harness_draw_below(source, 8));
    uint32_t count = 1 + harness_draw_below(source, 4);
    for (uint32_t n = 0; n < count; n++) {
        uint32_t b = harness_draw_below(source, 5), i = harness_draw_below(source, 3);
        uint32_t j = harness_draw_below(source, 3);
        double value = harness_draw_any_double(source);
        mat3 *m = b < 3 ? &t->diagonal[b] : &t->coupling[b - 3].m;
        m->m[i][j] = value;
        if (b < 3) {
            m->m[j][i] = value;
        }
    }
    twin_write(t);
    twin_write_plain(t);
    bool finite = true;
    for (uint32_t i = 0; i < t->plain.n * t->plain.n; i++) {
        finite = finite && isfinite(t->plain.a[i]);
    }
    plain_end(&t->plain);
    bool solved = twin_solve(t);
    assert_true(finite || !solved);
    twin_end(t);
}

static void any_numbers_are_rejected_or_solved(void **state)
{
    (void)state;
    harness_property("any numbers", 2000, any_numbers, NULL);
}

int test_rejected_matrices(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(non_finite_matrix_is_rejected),
        harness_test(singular_or_indefinite_block_is_rejected),
        harness_test(couplings_making_matrix_indefinite_are_rejected),
        harness_test(non_finite_force_propagates),
        harness_test(any_numbers_are_rejected_or_solved),
    };
    return cmocka_run_group_tests_name("solver.rejected_matrices", tests, NULL, NULL);
}
