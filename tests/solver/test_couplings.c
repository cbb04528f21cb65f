#include <string.h>

#include "solver/twin.h"

/* ---- couple_once */

enum { BLOCKS = 24, CHAINS = 3 };

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_system *system;
} fixture;

/* Three chains of eight separators. */
static void begin_chains(vbss_system *s)
{
    uint32_t first;
    vbss_system_begin_pattern(s);
    for (uint32_t chain = 0; chain < CHAINS; chain++) {
        expect_ok(vbss_system_add_chain(s, BLOCKS / CHAINS, &first));
    }
    for (uint32_t b = 0; b < BLOCKS; b++) {
        vbss_system_set_role(s, b, VBSS_ROLE_SEPARATOR);
    }
}

static void begin(fixture *f, uint32_t pairs)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_system_create(f->context, BLOCKS, 0, BLOCKS, pairs, &f->system));
    begin_chains(f->system);
}

static void end(fixture *f)
{
    vbss_system_destroy(f->context, f->system);
    harness_context_end(f->context, &f->memory);
}

static void expect_text(vbss_context *context, const char *wanted)
{
    vbss_result result;
    const char *text;
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    assert_non_null(strstr(text, wanted));
}

/* What bodies couple, then what others ask for, against a table. */
static void couple_often(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    begin(&f, BLOCKS * BLOCKS / 2);
    for (int round = 0; round < 3; round++) { /* each has forgotten the one before */
        bool coupled[BLOCKS][BLOCKS] = {{false}};
        uint32_t count = 0, coupling;
        uint32_t bodies = harness_draw_below(source, 60);
        begin_chains(f.system);
        for (uint32_t i = 0; i < 300; i++) {
            uint32_t a = harness_draw_below(source, BLOCKS);
            uint32_t b = harness_draw_below(source, BLOCKS);
            if (a == b || (i < bodies && coupled[a][b])) {
                continue;
            }
            count += !coupled[a][b];
            coupled[a][b] = coupled[b][a] = true;
            if (i < bodies) {
                expect_ok(vbss_system_couple(f.system, a, b, &coupling));
                assert_int_equal(coupling, count);
            } else {
                expect_ok(vbss_system_couple_separators(f.system, a, b));
            }
            assert_int_equal(f.system->coupling_count, count);
        }
        expect_ok(vbss_system_analyse(f.system));
        assert_int_equal(f.system->pair_count, count);
        for (uint32_t a = 0; a < BLOCKS; a++) {
            for (uint32_t b = 0; b < BLOCKS; b++) {
                bool is_there = vbss_system_schur_index(f.system, a, b) != VBSS_NO_INDEX;
                assert_int_equal(is_there, a == b || coupled[a][b]);
            }
        }
    }
    end(&f);
}

static void coupled_pair_is_not_coupled_again(void **state)
{
    (void)state;
    harness_property("couple once", 100, couple_often, NULL);
}

static void existing_coupling_needs_no_capacity(void **state)
{
    (void)state;
    fixture f;
    uint32_t one;
    begin(&f, 2);
    expect_ok(vbss_system_couple(f.system, 0, 8, &one));
    expect_ok(vbss_system_couple_separators(f.system, 3, 1));
    expect_ok(vbss_system_couple_separators(f.system, 8, 0));
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_couple_separators(f.system, 3, 2));
    expect_text(f.context, "more than 2 couplings");
    expect_ok(vbss_system_couple_separators(f.system, 0, 8));
    expect_ok(vbss_system_couple_separators(f.system, 1, 3));
    vbss_system_set_role(f.system, 4, VBSS_ROLE_PRESCRIBED);
    expect_ok(vbss_system_couple_separators(f.system, 4, 5));
    assert_int_equal(f.system->coupling_count, 2);
    end(&f);
}

/* Nobody sets its numbers: what stood there before must not be seen. */
static void couple_once_pair_is_empty_when_taken(void **state)
{
    (void)state;
    fixture f;
    uint32_t own;
    begin(&f, 8);
    const mat3 ones = {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
    expect_ok(vbss_system_couple(f.system, 0, 1, &own));
    expect_ok(vbss_system_couple_separators(f.system, 1, 9));
    expect_ok(vbss_system_couple_separators(f.system, 1, 0));
    expect_ok(vbss_system_analyse(f.system));
    for (int round = 0; round < 2; round++) {
        vbss_system_clear(f.system);
        block_set(&f.system->off_diagonal[VBSS_NO_COUPLING], ones); /* swallowed */
        block_set(&f.system->off_diagonal[own], ones);
        for (uint32_t b = 0; b < BLOCKS; b++) {
            block_set(&f.system->diagonal[b], mat3_identity());
        }
        assert_true(vbss_system_condense(f.system));
        vbss_system_load_schur_complement(f.system);
        block *bodies = &f.system->separator_blocks[vbss_system_schur_index(f.system, 0, 1)];
        block *others = &f.system->separator_blocks[vbss_system_schur_index(f.system, 9, 1)];
        for (int i = 0; i < 9; i++) {
            expect_same_bits(1.0, block_mat3(bodies).m[i / 3][i % 3]);
            expect_same_bits(0.0, block_mat3(others).m[i / 3][i % 3]);
        }
        block_add(others, ones); /* on the copy only */
    }
    end(&f);
}

static void bodies_couple_before_others(void **state)
{
    (void)state;
    fixture f;
    uint32_t coupling = 77;
    begin(&f, 8);
    expect_ok(vbss_system_couple_separators(f.system, 1, 9));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_system_couple(f.system, 2, 3, &coupling));
    expect_text(f.context, "blocks 2 and 3");
    assert_int_equal(coupling, VBSS_NO_COUPLING);
    vbss_system_reset_separator_couplings(f.system); /* nobody has coupled any more */
    expect_ok(vbss_system_couple(f.system, 2, 3, &coupling));
    assert_int_equal(coupling, 1);
    end(&f);
}

/* ---- couplings between chains */

static void run_does_not_couple_with_other_chain(void **state)
{
    (void)state;
    fixture f;
    uint32_t coupling;
    begin(&f, 8);
    for (uint32_t roles = 0; roles < 4; roles++) {
        begin_chains(f.system);
        vbss_system_set_role(f.system, 7,
                             (roles & 1) != 0 ? VBSS_ROLE_INTERIOR : VBSS_ROLE_SEPARATOR);
        vbss_system_set_role(f.system, 8,
                             (roles & 2) != 0 ? VBSS_ROLE_INTERIOR : VBSS_ROLE_SEPARATOR);
        expect_ok(vbss_system_couple(f.system, 6, 7, &coupling)); /* of one chain: as they are */
        vbss_result wanted = roles != 0 ? VBSS_ERROR_INCOMPATIBLE : VBSS_OK;
        expect_result(wanted, vbss_system_couple(f.system, 7, 8, &coupling));
        if (roles != 0) {
            expect_text(f.context, "blocks 7 and 8");
            assert_int_equal(coupling, VBSS_NO_COUPLING);
            expect_result(wanted, vbss_system_couple_separators(f.system, 8, 7));
        }
        assert_int_equal(f.system->coupling_count, roles != 0 ? 1 : 2);
        vbss_system_set_role(f.system, 7, VBSS_ROLE_PRESCRIBED); /* has no equation */
        expect_ok(vbss_system_couple_separators(f.system, 7, 10));
    }
    end(&f);
}

int test_couplings(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(coupled_pair_is_not_coupled_again),
        harness_test(existing_coupling_needs_no_capacity),
        harness_test(couple_once_pair_is_empty_when_taken),
        harness_test(bodies_couple_before_others),
        harness_test(run_does_not_couple_with_other_chain),
    };
    return cmocka_run_group_tests_name("solver.couplings", tests, NULL, NULL);
}
