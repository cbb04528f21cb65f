/* Chains that bring their order, and other right-hand sides for a factor. */
#include <string.h>

#include "solver/twin.h"

/* Large: not on the stack. */
static twin subject;

/* Any two blocks of a chain may be coupled: no reach. Most chains keep their order. */
static void draw_sparse(twin *t, harness_source *source, twin_roles kind)
{
    twin_draw_chains(t, source, 40);
    twin_draw_roles(t, source, kind);
    twin_draw_numbers(t, source); /* a few couplings along the chain, which go again */
    uint32_t rarely = 1 + harness_draw_below(source, 12);
    for (uint32_t b = 0; b < t->blocks; b++) {
        t->diagonal[b] = mat3_diagonal(t->mass, t->mass, t->mass);
    }
    t->couplings = 0;
    for (uint32_t chain = 0, begin = 0; chain < t->chains; begin = t->chain_end[chain++]) {
        t->keeps_order[chain] = harness_draw_below(source, 4) != 0;
        for (uint32_t low = begin; low < t->chain_end[chain]; low++) {
            for (uint32_t high = low + 1; high < t->chain_end[chain]; high++) {
                if (harness_draw_below(source, rarely) != 0) {
                    continue;
                }
                bool swapped = harness_draw_below(source, 2) == 0;
                t->coupling[t->couplings++] =
                    (twin_coupling){high, low, swapped, mat3_zero(), VBSS_NO_COUPLING};
                for (uint32_t e = harness_draw_below(source, 4); e > 0; e--) {
                    vec3 of_high = harness_draw_vec3(source, -1.0, 1.0);
                    vec3 of_low = harness_draw_vec3(source, -1.0, 1.0);
                    twin_add_element(t, t->couplings - 1, of_high, of_low);
                }
            }
        }
    }
    twin_begin_with(t, t->blocks, t->blocks, twin_separators(t));
    expect_ok(twin_register(t));
}

static void end_sparse(twin *t)
{
    memset(t->keeps_order, 0, sizeof t->keeps_order);
    twin_end(t);
}

static void of_a_kind(harness_source *source, void *user)
{
    const twin_roles *kind = user;
    draw_sparse(&subject, source, *kind);
    twin_compare(&subject);
    end_sparse(&subject);
}

static void kept_order_matches_plain_solve(void **state)
{
    (void)state;
    twin_roles kinds[] = {TWIN_RUNS,  TWIN_SCATTERED,  TWIN_GROUPS,   TWIN_GIVEN,
                          TWIN_MIXED, TWIN_SEPARATORS, TWIN_ALL_GIVEN};
    for (int k = 0; k < 7; k++) {
        harness_property("kept order", 60, of_a_kind, &kinds[k]);
    }
}

static void runs_are_eliminated_as_they_are_numbered(harness_source *source, void *user)
{
    (void)user;
    twin *t = &subject;
    draw_sparse(t, source, TWIN_MIXED);
    for (uint32_t chain = 0, begin = 0; chain < t->chains; begin = t->chain_end[chain++]) {
        uint32_t last = 0;
        for (uint32_t b = begin; b < t->chain_end[chain]; b++) {
            if (t->keeps_order[chain] && t->roles[b] == VBSS_ROLE_INTERIOR) {
                assert_true(t->system->position[b] >= last);
                last = t->system->position[b];
            }
        }
    }
    end_sparse(t);
}

static void elimination_order_is_kept(void **state)
{
    (void)state;
    harness_property("order", 200, runs_are_eliminated_as_they_are_numbered, NULL);
}

/* ---- other right-hand sides */

static void expect_same_solution(const twin *t, const double *wanted)
{
    for (uint32_t b = 0; b < t->blocks; b++) {
        expect_same_bits(wanted[(size_t)3 * b], t->system->solution[b].x);
        expect_same_bits(wanted[(size_t)3 * b + 1], t->system->solution[b].y);
        expect_same_bits(wanted[(size_t)3 * b + 2], t->system->solution[b].z);
    }
}

/* The factor stands: as often as wanted, with either copy of the loops. */
static void another_side(harness_source *source, void *user)
{
    const twin_roles *kind = user;
    static double wanted[3 * TWIN_BLOCKS];
    twin *t = &subject;
    draw_sparse(t, source, *kind);
    static vec3 sides[3][TWIN_BLOCKS];
    for (int k = 0; k < 3; k++) {
        for (uint32_t b = 0; b < t->blocks; b++) {
            sides[k][b] = harness_draw_vec3(source, -1.0, 1.0);
        }
    }
    bool has_wide = t->system->wide;
    for (int wide = 0; wide <= (has_wide ? 1 : 0); wide++) {
        for (int k = 0; k < 3; k++) {
            t->system->wide = wide == 1;
            memcpy(t->rhs, sides[k], t->blocks * sizeof *t->rhs);
            twin_write(t);
            assert_true(twin_solve(t));
            memcpy(wanted, t->x, (size_t)3 * t->blocks * sizeof *wanted);
            /* From another side's factor. */
            memcpy(t->rhs, sides[(k + 1) % 3], t->blocks * sizeof *t->rhs);
            twin_write(t);
            assert_true(twin_solve(t));
            for (int again = 0; again < 2; again++) {
                memcpy(t->system->rhs, sides[again == 0 ? (k + 2) % 3 : k],
                       t->blocks * sizeof *t->rhs);
                vbss_system_condense_rhs(t->system);
                vbss_system_load_schur_complement(t->system);
                assert_true(vbss_system_solve(t->system));
            }
            expect_same_solution(t, wanted);
        }
    }
    end_sparse(t);
}

static void new_right_hand_side_matches_new_factor(void **state)
{
    (void)state;
    twin_roles kinds[] = {TWIN_RUNS, TWIN_SCATTERED, TWIN_GIVEN, TWIN_MIXED, TWIN_SEPARATORS};
    for (int k = 0; k < 5; k++) {
        harness_property("another side", 60, another_side, &kinds[k]);
    }
}

int test_ordering_reuse(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(kept_order_matches_plain_solve),
        harness_test(elimination_order_is_kept),
        harness_test(new_right_hand_side_matches_new_factor),
    };
    return cmocka_run_group_tests_name("solver.ordering_reuse", tests, NULL, NULL);
}
