#include "solver/twin.h"

static twin subject;

/* ---- systems with contacts: separators coupled far apart, and additions to them */

enum { CONTACTS = 12 };

static bool coupled(const twin *t, uint32_t a, uint32_t b)
{
    for (uint32_t c = 0; c < t->couplings; c++) {
        const twin_coupling *k = &t->coupling[c];
        if ((k->high == a && k->low == b) || (k->high == b && k->low == a)) {
            return true;
        }
    }
    return false;
}

/* Also between chains, and from one end of a chain to the other. */
static void draw_contacts(twin *t, harness_source *source)
{
    for (uint32_t i = 0; i < CONTACTS; i++) {
        uint32_t a = harness_draw_below(source, t->blocks);
        uint32_t b = harness_draw_below(source, t->blocks);
        if (a != b && t->roles[a] == VBSS_ROLE_SEPARATOR && t->roles[b] == VBSS_ROLE_SEPARATOR &&
            !coupled(t, a, b)) {
            t->coupling[t->couplings++] = (twin_coupling){a > b ? a : b, a > b ? b : a, i % 2 == 0,
                                                          mat3_zero(), VBSS_NO_COUPLING};
        }
    }
}

static void begin_with_contacts(twin *t, harness_source *source, twin_roles kind)
{
    twin_draw_chains(t, source, 40);
    twin_draw_roles(t, source, kind);
    twin_draw_numbers(t, source);
    draw_contacts(t, source);
    /* Room for the contacts' couplings, and for runs past narrow separators. */
    twin_begin_with(t, t->blocks + CONTACTS, t->reach + twin_separators(t), twin_separators(t));
    expect_ok(twin_register(t));
    twin_write(t);
    twin_write_plain(t);
    assert_true(vbss_system_condense(t->system));
}

/* A term of one block of the matrix, into both systems. */
static void add_to_both(twin *t, uint32_t row, uint32_t column, mat3 m)
{
    block_add(twin_block(t, row, column), m);
    plain_add(&t->plain, row, column, m);
}

static mat3 draw_mat3(harness_source *source, double size)
{
    vec3 a = harness_draw_vec3(source, -size, size);
    vec3 b = harness_draw_vec3(source, -size, size);
    vec3 c = harness_draw_vec3(source, -size, size);
    return mat3_rows(a, b, c);
}

/* Like friction: what couples a and b is far from symmetric, but takes no energy away, so that
 * rows need no exchange between blocks. */
static void add_contacts(twin *t, harness_source *source)
{
    for (uint32_t a = 0; a < t->blocks; a++) {
        if (t->roles[a] != VBSS_ROLE_SEPARATOR) {
            continue;
        }
        mat3 own = mat3_add(mat3_identity(), mat3_cross(harness_draw_vec3(source, -1.0, 1.0)));
        add_to_both(t, a, a, own);
        vec3 force = harness_draw_vec3(source, -1.0, 1.0);
        vec3 *rhs = twin_rhs(t, a);
        *rhs = vec3_add(*rhs, force);
        plain_add_rhs(&t->plain, a, force);
    }
    for (uint32_t c = 0; c < t->couplings; c++) {
        const twin_coupling *k = &t->coupling[c];
        if (t->roles[k->high] == VBSS_ROLE_SEPARATOR && t->roles[k->low] == VBSS_ROLE_SEPARATOR) {
            mat3 m = draw_mat3(source, 0.5), other = draw_mat3(source, 0.01);
            add_to_both(t, k->high, k->low, m);
            add_to_both(t, k->low, k->high, mat3_sub(other, mat3_transpose(m)));
        }
    }
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
    vbss_system_take_separators(t->system);
    add_contacts(t, source);
    solve_and_compare(t);
    plain_end(&t->plain);
    twin_end(t);
}

static void what_others_add_to_separators_counts_where_it_was_added(void **state)
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
        vbss_system_take_separators(t->system);
        add_contacts(t, source);
        solve_and_compare(t);
    }
    plain_end(&t->plain);
    twin_end(t);
}

static void separators_taken_again_have_forgotten_what_was_added(void **state)
{
    (void)state;
    harness_property("separators taken again", 100, taken_twice, NULL);
}

/* ---- inside a block */

/* Separators of which none is coupled: each block's solution is known. */
static void rows_of_a_block_are_exchanged_where_its_diagonal_is_empty(void **state)
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
    vbss_system_take_separators(t->system);
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

int test_separators(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(what_others_add_to_separators_counts_where_it_was_added),
        harness_test(separators_taken_again_have_forgotten_what_was_added),
        harness_test(rows_of_a_block_are_exchanged_where_its_diagonal_is_empty),
    };
    return cmocka_run_group_tests_name("solver.separators", tests, NULL, NULL);
}
