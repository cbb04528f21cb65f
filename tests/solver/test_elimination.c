#include <string.h>

#include "solver/contacts.h"

static twin subject;

enum { SEPARATORS = 60 };

static vbss_elimination *factor(twin *t)
{
    return &t->system->elimination;
}

static uint32_t fill(twin *t)
{
    return factor(t)->column_start[twin_separators(t)] - t->system->pair_count;
}

static void begin_knot(twin *t, harness_source *source)
{
    contacts_draw_knot(t, source, SEPARATORS);
    twin_begin_with(t, t->blocks, t->reach + twin_separators(t), twin_separators(t));
    expect_ok(twin_register(t));
    twin_write(t);
    twin_write_plain(t);
    assert_true(vbss_system_condense(t->system));
    vbss_system_load_schur_complement(t->system);
}

static void end_knot(twin *t)
{
    plain_end(&t->plain);
    twin_end(t);
}

/* Nothing that was there before is taken for a result. */
static void solve(twin *t)
{
    memset(t->system->solution, 0xff, t->blocks * sizeof *t->system->solution);
    assert_true(vbss_system_solve(t->system));
    for (uint32_t b = 0; b < t->blocks; b++) {
        vec3_store(&t->x[(size_t)3 * b], t->system->solution[b]);
    }
}

static void expect_same_solution(const twin *t, const double *x)
{
    for (uint32_t i = 0; i < 3 * t->blocks; i++) {
        expect_same_bits(x[i], t->x[i]);
    }
}

/* ---- what comes out */

static void a_knot(harness_source *source, void *user)
{
    (void)user;
    twin *t = &subject;
    begin_knot(t, source);
    contacts_add(t, source);
    solve(t);
    assert_true(plain_lu_solve(&t->plain, t->wanted));
    expect_near(0.0, plain_residual(&t->plain, t->x), 1e-14);
    expect_near(0.0, plain_difference(t->plain.n, t->x, t->wanted), 1e-14 / t->mass);
    end_knot(t);
}

static void knots_of_several_strands_are_solved(void **state)
{
    (void)state;
    harness_property("knot", 60, a_knot, NULL);
}

static void again(harness_source *source, void *user)
{
    (void)user;
    static block base[SEPARATORS * (SEPARATORS + 2)], added[SEPARATORS * (SEPARATORS + 2)];
    static vec3 added_rhs[SEPARATORS];
    static double first[3 * TWIN_BLOCKS];
    twin *t = &subject;
    begin_knot(t, source);
    vbss_system *s = t->system;
    size_t count = twin_separators(t), size = (2 * (size_t)s->pair_count + count) * sizeof *base;
    memcpy(base, s->separator_blocks, size);
    contacts_add(t, source);
    memcpy(added, s->separator_blocks, size);
    memcpy(added_rhs, s->separator_rhs, count * sizeof *added_rhs);
    solve(t);
    memcpy(first, t->x, sizeof first);
    assert_memory_equal(added, s->separator_blocks, size);
    assert_memory_equal(added_rhs, s->separator_rhs, count * sizeof *added_rhs);
    solve(t);
    expect_same_solution(t, first);
    vbss_system_load_schur_complement(s);
    assert_memory_equal(base, s->separator_blocks, size);
    solve(t);
    vbss_system_load_schur_complement(s);
    memcpy(s->separator_blocks, added, size);
    memcpy(s->separator_rhs, added_rhs, count * sizeof *added_rhs);
    solve(t);
    expect_same_solution(t, first);
    end_knot(t);
}

static void solve_is_repeatable_bit_exact(void **state)
{
    (void)state;
    harness_property("again", 40, again, NULL);
}

/* ---- what the bits depend on */

/* Registered in another order, each pair the other way round. */
static void shuffled(harness_source *source, void *user)
{
    (void)user;
    static twin other;
    twin *t = &subject;
    begin_knot(t, source);
    other = *t;
    for (uint32_t c = other.couplings; c > 1; c--) {
        uint32_t with = harness_draw_below(source, c);
        twin_coupling kept = other.coupling[c - 1];
        other.coupling[c - 1] = other.coupling[with];
        other.coupling[with] = kept;
        other.coupling[c - 1].swapped = !other.coupling[c - 1].swapped;
    }
    solve(t);
    twin_begin_with(&other, t->blocks, t->reach + twin_separators(t), twin_separators(t));
    expect_ok(twin_register(&other));
    twin_write(&other);
    assert_true(twin_solve(&other));
    uint32_t count = twin_separators(t);
    assert_memory_equal(factor(t)->order, factor(&other)->order, count * sizeof(uint32_t));
    assert_int_equal(fill(t), fill(&other));
    expect_same_solution(t, other.x);
    twin_end(&other);
    end_knot(t);
}

static void registration_order_does_not_matter(void **state)
{
    (void)state;
    harness_property("shuffled", 40, shuffled, NULL);
}

/* Where there is no wide copy, the plain one goes twice. */
static void by_both_copies(harness_source *source, void *user)
{
    (void)user;
    static double first[3 * TWIN_BLOCKS];
    static uint32_t order[SEPARATORS];
    twin *t = &subject;
    begin_knot(t, source);
    contacts_add(t, source);
    t->system->wide = false;
    expect_ok(vbss_system_order_separators(t->system));
    solve(t);
    size_t size = twin_separators(t) * sizeof *order;
    memcpy(first, t->x, sizeof first);
    memcpy(order, factor(t)->order, size);
    t->system->wide = vbss_wide_is_available();
    expect_ok(vbss_system_order_separators(t->system));
    assert_memory_equal(order, factor(t)->order, size);
    solve(t);
    expect_same_solution(t, first);
    end_knot(t);
}

static void scalar_and_simd_order_and_bits_are_equal(void **state)
{
    (void)state;
    harness_property("both copies", 40, by_both_copies, NULL);
}

/* ---- what is told */

static void a_row_of_zeros(harness_source *source, void *user)
{
    (void)user;
    twin *t = &subject;
    begin_knot(t, source);
    uint32_t row = harness_draw_below(source, 3), a;
    do {
        a = harness_draw_below(source, t->blocks);
    } while (t->roles[a] != VBSS_ROLE_SEPARATOR);
    for (uint32_t b = 0; b < t->blocks; b++) {
        if (vbss_system_schur_index(t->system, a, b) != VBSS_NO_INDEX) {
            mat3 m = block_mat3(twin_block(t, a, b));
            m.m[row][0] = m.m[row][1] = m.m[row][2] = 0.0;
            block_set(twin_block(t, a, b), m);
        }
    }
    assert_int_equal(t->system->tiny_pivots, 0);
    assert_false(vbss_system_solve_separators(t->system));
    assert_int_equal(t->system->tiny_pivots, 1);
    vbss_system_load_schur_complement(t->system);
    solve(t);
    assert_int_equal(t->system->tiny_pivots, 1);
    end_knot(t);
}

static void singular_knot_is_reported_counted_and_recoverable(void **state)
{
    (void)state;
    harness_property("a row of zeros", 60, a_row_of_zeros, NULL);
}

/* So many separators, coupled as `ends` says; the system has room for so many pairs. */
static vbss_result register_pairs(twin *t, uint32_t separators, const uint32_t (*ends)[2],
                                  uint32_t count, uint32_t pairs)
{
    t->blocks = t->chain_end[0] = separators;
    t->chains = 1;
    t->couplings = count;
    for (uint32_t b = 0; b < separators; b++) {
        t->roles[b] = VBSS_ROLE_SEPARATOR;
    }
    for (uint32_t c = 0; c < count; c++) {
        t->coupling[c] =
            (twin_coupling){ends[c][1], ends[c][0], false, mat3_zero(), VBSS_NO_COUPLING};
    }
    t->context = harness_context(&t->memory);
    expect_ok(
        vbss_system_create(t->context, separators, separators, separators, pairs, &t->system));
    return twin_register(t);
}

static void fill_above_capacity_is_reported(void **state)
{
    (void)state;
    static const uint32_t ring[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}};
    for (uint32_t pairs = 0; pairs < 9; pairs++) {
        vbss_result wanted = pairs < 7 ? VBSS_ERROR_CAPACITY : VBSS_OK; /* two are filled in */
        expect_result(wanted, register_pairs(&subject, 5, ring, 5, pairs));
        twin_end(&subject);
    }
}

/* ---- the order */

static void trees_have_no_fill(void **state)
{
    (void)state;
    static const uint32_t star[][2] = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {0, 6}};
    static const uint32_t row[][2] = {{0, 3}, {3, 6}, {2, 6}, {2, 5}, {1, 5}, {1, 4}};
    static const uint32_t tree[][2] = {{0, 1}, {0, 2}, {1, 3}, {1, 4}, {2, 5}, {2, 6}};
    const uint32_t(*trees[])[2] = {star, row, tree};
    for (int i = 0; i < 3; i++) {
        expect_ok(register_pairs(&subject, 7, trees[i], 6, 6));
        assert_int_equal(fill(&subject), 0);
        twin_end(&subject);
    }
}

static void minimum_degree_ties_take_first(void **state)
{
    (void)state;
    static const uint32_t ring[][2] = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
    static const uint32_t none[][2] = {{0, 0}};
    static const uint32_t wanted[] = {0, 1, 2, 3};
    expect_ok(register_pairs(&subject, 4, ring, 4, 10));
    assert_memory_equal(factor(&subject)->order, wanted, sizeof wanted);
    twin_end(&subject);
    expect_ok(register_pairs(&subject, 4, none, 0, 0));
    assert_memory_equal(factor(&subject)->order, wanted, sizeof wanted);
    twin_end(&subject);
}

/* By block numbers, one strand after the other, nearly everything would be filled in. */
static void parallel_strands_fill_linearly(void **state)
{
    (void)state;
    enum { LENGTH = 140 };
    static uint32_t ends[4 * LENGTH][2];
    uint32_t count = 0;
    for (uint32_t i = 0; i < LENGTH; i++) {
        const uint32_t pairs[4][2] = {
            {i, i + 1}, {LENGTH + i, LENGTH + i + 1}, {i, LENGTH + i}, {i + 1, LENGTH + i}};
        for (uint32_t k = 0; k < 4; k++) {
            if (i + 1 < LENGTH || k == 2) {
                memcpy(ends[count++], pairs[k], sizeof pairs[k]);
            }
        }
    }
    expect_ok(register_pairs(&subject, 2 * LENGTH, (const uint32_t(*)[2])ends, count, 4 * count));
    assert_true(fill(&subject) < 2 * LENGTH);
    twin_end(&subject);
}

int test_elimination(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(knots_of_several_strands_are_solved),
        harness_test(solve_is_repeatable_bit_exact),
        harness_test(registration_order_does_not_matter),
        harness_test(scalar_and_simd_order_and_bits_are_equal),
        harness_test(singular_knot_is_reported_counted_and_recoverable),
        harness_test(fill_above_capacity_is_reported),
        harness_test(trees_have_no_fill),
        harness_test(minimum_degree_ties_take_first),
        harness_test(parallel_strands_fill_linearly),
    };
    return cmocka_run_group_tests_name("solver.elimination", tests, NULL, NULL);
}
