#include "solver/contacts.h"

static twin subject;

/* ---- systems with contacts */

enum { CONTACTS = 12 };

static void begin_with_contacts(twin *t, harness_source *source, twin_roles kind)
{
    twin_draw_chains(t, source, 40);
    twin_draw_roles(t, source, kind);
    twin_draw_numbers(t, source);
    contacts_draw(t, source, CONTACTS);
    /* Room for the contacts' couplings, and for runs past narrow separators. */
    twin_begin_with(t, t->blocks + CONTACTS, t->reach + twin_separators(t), twin_separators(t));
    expect_ok(twin_register(t));
    twin_write(t);
    twin_write_plain(t);
    assert_true(vbss_system_condense(t->system));
}

static void solve_and_compare(twin *t)
{
    assert_true(vbss_system_solve(t->system));
    for (uint32_t b = 0; b < t->blocks; b++) {
        vec3_store(&t->x[(size_t)3 * b], t->system->solution[b]);
    }
    assert_true(plain_lu_solve(&t->plain, t->wanted));
    expect_near(0.0, plain_residual(&t->plain, t->x), 1e-13);
    expect_near(0.0, plain_difference(t->plain.n, t->x, t->wanted), 1e-14 / t->mass);
}

static void with_contacts(harness_source *source, void *user)
{
    const twin_roles *kind = user;
    twin *t = &subject;
    begin_with_contacts(t, source, *kind);
    vbss_system_load_schur_complement(t->system);
    contacts_add(t, source);
    solve_and_compare(t);
    plain_end(&t->plain);
    twin_end(t);
}

static void additions_to_separators_land_in_place(void **state)
{
    (void)state;
    twin_roles kinds[] = {TWIN_SCATTERED, TWIN_GROUPS, TWIN_SEPARATORS, TWIN_MIXED};
    for (int i = 0; i < 4; i++) {
        harness_property("additions to separators", 100, with_contacts, &kinds[i]);
    }
}

/* Contacts come and go while the condensed runs stay. */
static void taken_twice(harness_source *source, void *user)
{
    (void)user;
    twin *t = &subject;
    begin_with_contacts(t, source, TWIN_MIXED);
    for (int round = 0; round < 3; round++) {
        plain_end(&t->plain);
        twin_write_plain(t);
        vbss_system_load_schur_complement(t->system);
        contacts_add(t, source);
        solve_and_compare(t);
    }
    plain_end(&t->plain);
    twin_end(t);
}

static void retaken_separators_are_cleared(void **state)
{
    (void)state;
    harness_property("separators taken again", 100, taken_twice, NULL);
}

/* ---- inside a block */

/* Separators of which none is coupled: each block's solution is known. */
static void zero_diagonal_block_is_pivoted(void **state)
{
    (void)state;
    static const uint8_t orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                         {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    twin *t = &subject;
    t->blocks = t->chain_end[0] = 6;
    t->reach = t->chains = 1;
    t->couplings = 0;
    for (uint32_t b = 0; b < 6; b++) {
        t->roles[b] = VBSS_ROLE_SEPARATOR;
        t->diagonal[b] = mat3_zero();
        t->rhs[b] = vec3_zero();
    }
    twin_begin(t);
    expect_ok(twin_register(t));
    twin_write(t);
    assert_true(vbss_system_condense(t->system));
    vbss_system_load_schur_complement(t->system);
    for (uint32_t b = 0; b < 6; b++) {
        double rhs[3];
        mat3 m = mat3_zero();
        for (int i = 0; i < 3; i++) { /* row i: (i + 2) x[order of i] = (i + 2) (order of i + 1) */
            m.m[i][orders[b][i]] = i + 2.0;
            rhs[i] = (i + 2.0) * (orders[b][i] + 1.0);
        }
        block_set(twin_block(t, b, b), m);
        *twin_rhs(t, b) = vec3_load(rhs);
    }
    assert_true(vbss_system_solve(t->system));
    for (uint32_t b = 0; b < 6; b++) {
        expect_near(1.0, t->system->solution[b].x, 0.0);
        expect_near(2.0, t->system->solution[b].y, 0.0);
        expect_near(3.0, t->system->solution[b].z, 0.0);
    }
    twin_end(t);
}

/* ---- many */

/* Strands of 500, each beside the next: b - A x from what stands in the places. */
static void thousands_of_separators_are_solved(void **state)
{
    (void)state;
    enum { STRANDS = 4, LENGTH = 500, ALL = STRANDS * LENGTH };
    static uint32_t ends[3 * ALL][2];
    static vec3 defect[ALL];
    harness_source source = {0};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_system *s;
    vbss_random_seed(&source.random, 1, 0);
    uint32_t first, count = 0;
    expect_ok(vbss_system_create(context, ALL, 2, ALL, 40 * ALL, &s));
    vbss_system_begin_pattern(s);
    for (uint32_t i = 0; i < STRANDS; i++) {
        expect_ok(vbss_system_add_chain(s, LENGTH, &first));
    }
    for (uint32_t b = 0; b < ALL; b++) {
        vbss_system_set_role(s, b, VBSS_ROLE_SEPARATOR);
    }
    for (uint32_t b = 0; b < ALL; b++) {
        const uint32_t others[3] = {b + 1, b + LENGTH, b + LENGTH + 1};
        for (uint32_t i = 0; i < 3; i++) {
            bool along = i == 0 && (b + 1) % LENGTH != 0, beside = i > 0 && others[i] < ALL;
            if (along || beside) {
                expect_ok(vbss_system_couple_separators(s, b, others[i]));
                ends[count][0] = b;
                ends[count++][1] = others[i];
            }
        }
    }
    expect_ok(vbss_system_analyse(s));
    vbss_system_clear(s);
    for (uint32_t b = 0; b < ALL; b++) {
        double own = harness_draw_real(&source, 8.0, 9.0);
        block_set(&s->diagonal[b], mat3_diagonal(own, own, own));
        s->rhs[b] = harness_draw_vec3(&source, -1.0, 1.0);
    }
    assert_true(vbss_system_condense(s));
    vbss_system_load_schur_complement(s);
    for (uint32_t c = 0; c < 2 * count; c++) {
        const uint32_t *pair = ends[c / 2];
        vec3 a = harness_draw_vec3(&source, -1.0, 1.0), b = harness_draw_vec3(&source, -1.0, 1.0);
        block_add(&s->separator_blocks[vbss_system_schur_index(s, pair[c % 2], pair[1 - c % 2])],
                  mat3_outer(a, b));
    }
    assert_true(vbss_system_solve(s));
    for (uint32_t b = 0; b < ALL; b++) {
        const mat3 own = block_mat3(&s->separator_blocks[vbss_system_schur_index(s, b, b)]);
        defect[b] = vec3_sub(s->separator_rhs[vbss_system_schur_rhs_index(s, b)],
                             mat3_mul_vec3(own, s->solution[b]));
    }
    for (uint32_t c = 0; c < 2 * count; c++) {
        uint32_t row = ends[c / 2][c % 2], column = ends[c / 2][1 - c % 2];
        const mat3 m = block_mat3(&s->separator_blocks[vbss_system_schur_index(s, row, column)]);
        defect[row] = vec3_sub(defect[row], mat3_mul_vec3(m, s->solution[column]));
    }
    for (uint32_t b = 0; b < ALL; b++) {
        expect_near(0.0, vec3_norm(defect[b]), 1e-14);
    }
    vbss_system_destroy(context, s);
    harness_context_end(context, &memory);
}

int test_separators(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(additions_to_separators_land_in_place),
        harness_test(retaken_separators_are_cleared),
        harness_test(thousands_of_separators_are_solved),
        harness_test(zero_diagonal_block_is_pivoted),
    };
    return cmocka_run_group_tests_name("solver.separators", tests, NULL, NULL);
}
