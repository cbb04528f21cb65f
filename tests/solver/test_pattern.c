#include <string.h>

#include "solver/twin.h"

static twin subject;

/* ---- what is added where */

/* Chains of three so that, by roles, either block of a couple may be eliminated first. */
static void coupling_stores_rows_of_higher_block(void **state)
{
    (void)state;
    twin *t = &subject;
    const mat3 m = {{{0.0, 0.25, 0.0}, {0.0, 0.0, -0.5}, {0.125, 0.0, 0.0625}}};
    for (uint32_t pattern = 0; pattern < 16; pattern++) {
        t->blocks = t->chain_end[0] = 3;
        t->reach = t->chains = 1;
        t->couplings = 2;
        for (uint32_t b = 0; b < 3; b++) {
            t->roles[b] = (pattern >> b & 1u) != 0 ? VBSS_ROLE_SEPARATOR : VBSS_ROLE_INTERIOR;
            t->diagonal[b] = mat3_identity();
            t->rhs[b] = vec3_make(1.0 + b, -2.0, 3.0 * b);
        }
        for (uint32_t c = 0; c < 2; c++) {
            t->coupling[c] = (twin_coupling){c + 1, c, pattern >= 8, m, VBSS_NO_COUPLING};
        }
        twin_begin(t);
        expect_ok(twin_register(t));
        twin_compare(t);
        if (pattern % 8 == 7) { /* nothing condensed: what was added, as it was added */
            twin_write(t);
            assert_true(vbss_system_condense(t->system));
            vbss_system_load_schur_complement(t->system);
            const mat3 rows_of_high = block_mat3(twin_block(t, 1, 0));
            const mat3 rows_of_low = block_mat3(twin_block(t, 0, 1));
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    expect_same_bits(m.m[i][j], rows_of_high.m[i][j]);
                    expect_same_bits(m.m[i][j], rows_of_low.m[j][i]);
                }
            }
        }
        twin_end(t);
    }
}

/* ---- which pairs there are */

/* Blocks met from `from` over couplings, going on from runs only. */
static void reach_from(const twin *t, uint32_t from, bool *met)
{
    memset(met, 0, t->blocks * sizeof *met);
    met[from] = true;
    for (bool more = true; more;) {
        more = false;
        for (uint32_t c = 0; c < t->couplings; c++) {
            uint32_t ends[2] = {t->coupling[c].high, t->coupling[c].low};
            for (int i = 0; i < 2; i++) {
                uint32_t a = ends[i], b = ends[1 - i];
                bool through = a == from || t->roles[a] == VBSS_ROLE_INTERIOR;
                if (met[a] && through && !met[b] && t->roles[a] != VBSS_ROLE_PRESCRIBED &&
                    t->roles[b] != VBSS_ROLE_PRESCRIBED) {
                    met[b] = more = true;
                }
            }
        }
    }
}

static void pairs_of_separators(harness_source *source, void *user)
{
    (void)user;
    static bool met[TWIN_BLOCKS];
    static uint32_t taken[2 * TWIN_BLOCKS * TWIN_BLOCKS];
    twin *t = &subject;
    twin_draw_chains(t, source, 40);
    twin_draw_roles(t, source, TWIN_MIXED);
    twin_draw_numbers(t, source);
    twin_begin(t);
    expect_ok(twin_register(t));
    uint32_t wanted = 0, count = twin_separators(t);
    memset(taken, 0, sizeof taken);
    for (uint32_t a = 0; a < t->blocks; a++) {
        bool separator = t->roles[a] == VBSS_ROLE_SEPARATOR;
        uint32_t rhs = vbss_system_schur_rhs_index(t->system, a);
        assert_true(separator ? rhs < count : rhs == VBSS_NO_INDEX);
        reach_from(t, a, met);
        for (uint32_t b = 0; b < t->blocks; b++) {
            uint32_t place = vbss_system_schur_index(t->system, a, b);
            if (!separator || t->roles[b] != VBSS_ROLE_SEPARATOR || !met[b]) {
                assert_int_equal(place, VBSS_NO_INDEX);
            } else {
                assert_true(place < count + 2 * t->system->pair_count);
                assert_int_equal(taken[place]++, 0); /* nobody else's */
                wanted++;
            }
        }
    }
    assert_int_equal(wanted, count + 2 * t->system->pair_count);
    twin_end(t);
}

static void schur_pattern_is_coupled_or_joined(void **state)
{
    (void)state;
    harness_property("pairs of separators", 200, pairs_of_separators, NULL);
}

/* ---- the order */

/* Of `each` blocks, all of them runs, with every coupling within the reach. */
static void make_chains(twin *t, uint32_t chains, uint32_t each, uint32_t reach)
{
    t->blocks = chains * each;
    t->chains = chains;
    t->reach = reach;
    t->couplings = 0;
    for (uint32_t b = 0; b < t->blocks; b++) {
        uint32_t end = t->chain_end[b / each] = (b / each + 1) * each;
        t->roles[b] = VBSS_ROLE_INTERIOR;
        for (uint32_t high = b + 1; high <= b + reach && high < end; high++) {
            t->coupling[t->couplings++] =
                (twin_coupling){high, b, false, mat3_zero(), VBSS_NO_COUPLING};
        }
    }
}

/* So a contact on a long thread costs no more than its own few blocks. */
static void runs_eliminate_toward_separators_without_fill(void **state)
{
    (void)state;
    twin *t = &subject;
    for (uint32_t at = 0; at <= 27; at += 9) { /* a group at either end, and inside */
        make_chains(t, 2, 30, 3);
        for (uint32_t b = at; b < at + 3; b++) {
            t->roles[b] = t->roles[30 + b] = VBSS_ROLE_SEPARATOR;
        }
        twin_begin(t);
        expect_ok(twin_register(t));
        assert_int_equal(t->system->entry_count, t->system->coupling_count);
        twin_end(t);
    }
}

static void runs_without_separators_eliminate_from_both_ends(void **state)
{
    (void)state;
    static const uint32_t wanted[] = {0, 4, 1, 3, 2, 5, 9, 6, 8, 7, 10, 14, 11, 13};
    twin *t = &subject;
    make_chains(t, 3, 5, 2);
    t->roles[12] = VBSS_ROLE_PRESCRIBED;
    twin_begin(t);
    expect_ok(twin_register(t));
    assert_int_equal(t->system->interior_count, 14);
    for (uint32_t k = 0; k < 14; k++) {
        assert_int_equal(t->system->order[k], wanted[k]);
    }
    twin_end(t);
}

/* ---- analysing anew */

static void new_chain_has_no_roles(void **state)
{
    (void)state;
    twin *t = &subject;
    uint32_t first;
    make_chains(t, 1, 8, 1);
    t->roles[2] = t->roles[3] = VBSS_ROLE_SEPARATOR;
    t->roles[6] = VBSS_ROLE_PRESCRIBED;
    twin_begin(t);
    expect_ok(twin_register(t));
    assert_int_equal(t->system->interior_count, 5);
    vbss_system_begin_pattern(t->system);
    expect_ok(vbss_system_add_chain(t->system, 8, &first));
    expect_ok(vbss_system_analyse(t->system));
    assert_int_equal(t->system->interior_count, 8);
    assert_int_equal(t->system->unknown_count, 8);
    twin_end(t);
}

/* Trap: fill of the pattern before. The bits are those of a system that has no past. */
static void other_roles(harness_source *source, void *user)
{
    (void)user;
    static const twin_roles kinds[] = {TWIN_MIXED,      TWIN_RUNS,      TWIN_SCATTERED,
                                       TWIN_SEPARATORS, TWIN_ALL_GIVEN, TWIN_MIXED};
    static twin fresh;
    twin *t = &subject;
    const uint32_t largest = 40;
    twin_begin_with(t, largest, 3 + largest / 2, largest);
    for (uint32_t i = 0; i < 6; i++) {
        twin_draw_chains(t, source, largest);
        twin_draw_roles(t, source, kinds[i]);
        twin_draw_numbers(t, source);
        expect_ok(twin_register(t));
        fresh = *t;
        twin_compare(t);
        twin_begin(&fresh);
        expect_ok(twin_register(&fresh));
        twin_compare(&fresh);
        twin_end(&fresh);
        for (uint32_t j = 0; j < 3 * t->blocks; j++) {
            expect_same_bits(fresh.x[j], t->x[j]);
        }
    }
    twin_end(t);
}

static void new_analysis_forgets_old_pattern(void **state)
{
    (void)state;
    harness_property("other roles", 60, other_roles, NULL);
}

int test_pattern(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(coupling_stores_rows_of_higher_block),
        harness_test(schur_pattern_is_coupled_or_joined),
        harness_test(runs_eliminate_toward_separators_without_fill),
        harness_test(runs_without_separators_eliminate_from_both_ends),
        harness_test(new_chain_has_no_roles),
        harness_test(new_analysis_forgets_old_pattern),
    };
    return cmocka_run_group_tests_name("solver.pattern", tests, NULL, NULL);
}
