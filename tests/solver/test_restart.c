/* Patterns one after another of the same bodies: begin_again against a system that begins from scratch. */
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "solver/twin.h"

enum { MAX_COUNT = 40, ONCE = 120 };

/* Large: not on the stack. The same bodies in both: one begins again, of the other only the newest pattern is
 * known. */
static twin subject, fresh;

typedef struct pairs {
    uint32_t count;
    uint32_t ends[ONCE][2];
} pairs;

/* ---- drawing */

/* Lines, and chains that keep their order and couple any two of their blocks. */
static void draw_bodies(twin *t, harness_source *source, twin_roles kind)
{
    twin_draw_chains(t, source, MAX_COUNT);
    twin_draw_roles(t, source, kind);
    twin_draw_numbers(t, source);
    for (uint32_t chain = 0; chain < t->chains; chain++) {
        t->keeps_order[chain] = harness_draw_below(source, 2) == 0;
        uint32_t begin = chain > 0 ? t->chain_end[chain - 1] : 0, end = t->chain_end[chain];
        for (uint32_t low = begin; t->keeps_order[chain] && low < end; low++) {
            for (uint32_t high = low + 4; high < end; high++) { /* beyond any line's reach */
                if (harness_draw_below(source, 6) == 0) {
                    bool swapped = harness_draw_below(source, 2) == 0;
                    t->coupling[t->couplings++] =
                        (twin_coupling){high, low, swapped, mat3_zero(), VBSS_NO_COUPLING};
                    vec3 of_high = harness_draw_vec3(source, -1.0, 1.0);
                    vec3 of_low = harness_draw_vec3(source, -1.0, 1.0);
                    twin_add_element(t, t->couplings - 1, of_high, of_low);
                }
            }
        }
    }
}

static void draw_pairs(const twin *t, harness_source *source, pairs *p)
{
    uint32_t tries = harness_draw_below(source, ONCE);
    p->count = 0;
    for (uint32_t i = 0; i < tries; i++) {
        uint32_t a = harness_draw_below(source, t->blocks);
        uint32_t b = harness_draw_below(source, t->blocks);
        bool may = t->roles[a] != VBSS_ROLE_INTERIOR && t->roles[b] != VBSS_ROLE_INTERIOR;
        if (a != b && may) { /* some of them given, coupled by bodies, or drawn before */
            p->ends[p->count][0] = a;
            p->ends[p->count++][1] = b;
        }
    }
}

static vbss_result couple(vbss_system *s, const pairs *p)
{
    for (uint32_t i = 0; i < p->count; i++) {
        VBSS_TRY(vbss_system_couple_separators(s, p->ends[i][0], p->ends[i][1]));
    }
    return vbss_system_analyse(s);
}

/* ---- comparing */

static void expect_same_memory(const void *a, const void *b, size_t count, size_t size)
{
    if (count > 0) {
        assert_memory_equal(a, b, count * size);
    }
}

static void expect_same_pattern(const vbss_system *a, const vbss_system *b)
{
    const vbss_elimination *e = &a->elimination, *f = &b->elimination;
    assert_int_equal(a->interior_count, b->interior_count);
    assert_int_equal(a->unknown_count, b->unknown_count);
    assert_int_equal(a->entry_count, b->entry_count);
    assert_int_equal(a->fill_count, b->fill_count);
    assert_int_equal(a->pair_count, b->pair_count);
    assert_int_equal(a->coupling_count, b->coupling_count);
    uint32_t n = a->unknown_count, separators = n - a->interior_count;
    expect_same_memory(a->order, b->order, n, sizeof *a->order);
    expect_same_memory(a->column_start, b->column_start, n + 1, sizeof *a->column_start);
    expect_same_memory(a->entries, b->entries, a->entry_count, sizeof *a->entries);
    expect_same_memory(a->product_start, b->product_start, a->interior_count,
                       sizeof *a->product_start);
    for (uint32_t k = 0; k < a->interior_count; k++) {
        uint32_t rows = a->column_start[k + 1] - a->column_start[k], from = a->product_start[k];
        size_t products = (size_t)rows * (rows - (rows > 0)) / 2;
        expect_same_memory(a->products + from, b->products + from, products, sizeof *a->products);
    }
    expect_same_memory(e->order, f->order, separators, sizeof *e->order);
    expect_same_memory(e->column_start, f->column_start, separators + 1, sizeof *e->column_start);
    expect_same_memory(e->rows, f->rows, e->column_start[separators], sizeof *e->rows);
    assert_true(e->product_count == f->product_count);
}

static void expect_same_couplings(const vbss_system *a, const vbss_system *b)
{
    for (uint32_t c = 1; c <= a->body_coupling_count; c++) {
        assert_int_equal(a->couplings[c].is_transposed, b->couplings[c].is_transposed);
    }
    for (uint32_t row = 0; row < a->block_count; row++) {
        assert_int_equal(vbss_system_schur_rhs_index(a, row), vbss_system_schur_rhs_index(b, row));
        for (uint32_t column = 0; column < a->block_count; column++) {
            assert_int_equal(vbss_system_schur_index(a, row, column),
                             vbss_system_schur_index(b, row, column));
        }
    }
}

/* The number of a block of the factor: of a run's column, or of a separator's as condensing leaves it. */
static uint32_t number_of(const vbss_system *s, uint32_t row, uint32_t column)
{
    bool run = column < s->interior_count;
    uint32_t separator = column - s->interior_count, from = run ? 0 : s->interior_count;
    const vbss_entry *e = run ? s->entries + s->column_start[column]
                              : s->schur_pattern + s->schur_column_start[separator];
    while (e->row + from != row) {
        e++;
    }
    return e->index;
}

/* Each pair of a column's entries changes the block where they cross, by whichever way its number was found. */
static void expect_products_where_rows_cross(const vbss_system *s)
{
    for (uint32_t k = 0; k < s->interior_count; k++) {
        const uint32_t *product = s->products + s->product_start[k];
        for (uint32_t q = s->column_start[k]; q < s->column_start[k + 1]; q++) {
            for (uint32_t p = q + 1; p < s->column_start[k + 1]; p++) {
                uint32_t number = number_of(s, s->entries[p].row, s->entries[q].row);
                assert_int_equal(*product++, number);
                assert_int_not_equal(number, VBSS_NO_COUPLING);
            }
        }
    }
}

/* What pairs of couple_once are for: unsymmetric numbers on the copy. */
static void solve(twin *t, const pairs *p, uint64_t seed)
{
    harness_source source = {0};
    vbss_random_seed(&source.random, seed, 0);
    twin_write(t);
    memset(t->system->solution, 0xff, t->blocks * sizeof *t->system->solution);
    assert_true(vbss_system_condense(t->system));
    vbss_system_load_schur_complement(t->system);
    for (uint32_t i = 0; i < 2 * p->count; i++) {
        const uint32_t *ends = p->ends[i / 2];
        vec3 a = harness_draw_vec3(&source, -0.1, 0.1), b = harness_draw_vec3(&source, -0.1, 0.1);
        uint32_t place = vbss_system_schur_index(t->system, ends[i % 2], ends[1 - i % 2]);
        if (place != VBSS_NO_INDEX) {
            block_add(&t->system->separator_blocks[place], mat3_outer(a, b));
        }
    }
    for (uint32_t b = 0; b < t->blocks; b++) { /* friction leaves a diagonal that dominates */
        if (t->roles[b] == VBSS_ROLE_SEPARATOR) {
            block_add(twin_block(t, b, b), mat3_diagonal(2.0, 2.0, 2.0));
        }
    }
    assert_true(vbss_system_solve(t->system));
}

static void expect_same_solution(const twin *a, const twin *b)
{
    for (uint32_t i = 0; i < a->blocks; i++) {
        const vec3 *x = &a->system->solution[i], *y = &b->system->solution[i];
        expect_same_bits(x->x, y->x);
        expect_same_bits(x->y, y->y);
        expect_same_bits(x->z, y->z);
    }
}

/* ---- rounds */

static uint32_t refused, accepted;

static void make_system(twin *t, uint32_t room)
{
    t->context = harness_context(&t->memory);
    expect_ok(vbss_system_create(t->context, MAX_COUNT, MAX_COUNT, MAX_COUNT, room, &t->system));
}

static void compare_with_scratch(twin *t, const pairs *p, uint64_t seed)
{
    fresh = *t;
    make_system(&fresh, t->system->pair_capacity);
    (void)twin_register(&fresh); /* what bodies couple may not fit already */
    vbss_result result = couple(t->system, p);
    expect_result(result, couple(fresh.system, p));
    if (result == VBSS_OK) {
        expect_same_pattern(t->system, fresh.system);
        expect_same_couplings(t->system, fresh.system);
        expect_products_where_rows_cross(t->system);
        solve(t, p, seed);
        solve(&fresh, p, seed);
        expect_same_solution(t, &fresh);
    }
    refused += result == VBSS_ERROR_CAPACITY;
    accepted += result == VBSS_OK;
    twin_end(&fresh);
}

/* Sometimes with so little room for pairs that some patterns do not fit. */
static void rounds_of_a_kind(harness_source *source, void *user)
{
    const twin_roles *kind = user;
    static pairs p;
    twin *t = &subject;
    uint32_t all = MAX_COUNT * (MAX_COUNT - 1) / 2;
    make_system(t, harness_draw_below(source, 2) == 0 ? harness_draw_below(source, 80) : all);
    for (uint32_t bodies = 0; bodies < 2;
         bodies++) { /* the second ones know nothing of the first */
        draw_bodies(t, source, *kind);
        (void)twin_register(t);
        for (uint64_t round = 0; round < 5; round++) {
            draw_pairs(t, source, &p);
            if (round > 0) {
                vbss_system_reset_separator_couplings(t->system);
            }
            compare_with_scratch(t, &p, round);
        }
    }
    memset(t->keeps_order, 0, sizeof t->keeps_order);
    twin_end(t);
}

static void restart_is_bit_equal_to_fresh_start(void **state)
{
    (void)state;
    twin_roles kinds[] = {TWIN_RUNS,  TWIN_SCATTERED,  TWIN_GROUPS,   TWIN_GIVEN,
                          TWIN_MIXED, TWIN_SEPARATORS, TWIN_ALL_GIVEN};
    for (int k = 0; k < 7; k++) {
        harness_property("begin again", 60, rounds_of_a_kind, &kinds[k]);
    }
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL || (refused > 50 && accepted > 500));
}

/* ---- room */

static void rejected_restart_frees_coupling_capacity(void **state)
{
    (void)state;
    enum { BLOCKS = 6, ROOM = 3 };
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_system *s;
    uint32_t first;
    expect_ok(vbss_system_create(context, BLOCKS, 0, BLOCKS, ROOM, &s));
    vbss_system_begin_pattern(s);
    expect_ok(vbss_system_add_chain(s, BLOCKS, &first));
    for (uint32_t b = 0; b < BLOCKS; b++) {
        vbss_system_set_role(s, b, VBSS_ROLE_SEPARATOR);
    }
    for (uint32_t round = 0; round < 4; round++) { /* a ring, from another block on */
        for (uint32_t i = 0; i < ROOM; i++) {
            uint32_t a = (round + i) % BLOCKS;
            expect_ok(vbss_system_couple_separators(s, a, (a + 1) % BLOCKS));
        }
        uint32_t next = (round + ROOM) % BLOCKS;
        if (round % 2 == 0) {
            expect_result(VBSS_ERROR_CAPACITY,
                          vbss_system_couple_separators(s, next, (next + 1) % BLOCKS));
        }
        expect_ok(vbss_system_analyse(s));
        assert_int_equal(s->pair_count, ROOM);
        for (uint32_t b = 0; b < BLOCKS; b++) {
            bool there = (b + BLOCKS - round) % BLOCKS < ROOM;
            uint32_t place = vbss_system_schur_index(s, b, (b + 1) % BLOCKS);
            assert_int_equal(place != VBSS_NO_INDEX, there);
        }
        vbss_system_reset_separator_couplings(s);
    }
    expect_ok(vbss_system_analyse(s));
    assert_int_equal(s->pair_count, 0);
    vbss_system_destroy(context, s);
    harness_context_end(context, &memory);
}

int test_restart(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restart_is_bit_equal_to_fresh_start),
        harness_test(rejected_restart_frees_coupling_capacity),
    };
    return cmocka_run_group_tests_name("solver.restart", tests, NULL, NULL);
}
