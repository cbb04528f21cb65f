#include "solver/twin.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

/* Adds a block whose rows are those of the higher block of the two. */
static void add_to_coupling(vbss_system *system, uint32_t coupling, const block *b)
{
    block *to = &system->off_diagonal[coupling];
    if (system->couplings[coupling].is_transposed) {
        mat3 m = mat3_transpose(block_mat3(b));
        block turned;
        block_set(&turned, m);
        for (int c = 0; c < 3; c++) {
            to->column[c] = lanes_add(to->column[c], turned.column[c]);
        }
        return;
    }
    for (int c = 0; c < 3; c++) {
        to->column[c] = lanes_add(to->column[c], b->column[c]);
    }
}

/* ---- drawing */

void twin_draw_chains(twin *t, harness_source *source, uint32_t limit)
{
    /* Small ones often: there the special cases are. */
    uint32_t bound = harness_draw_below(source, 2) == 0 && limit > 12 ? 12 : limit;
    t->blocks = 1 + harness_draw_below(source, bound);
    t->reach = 1 + harness_draw_below(source, 3);
    uint32_t chains = 1 + harness_draw_below(source, 4), begin = 0;
    for (t->chains = 0; begin < t->blocks; t->chains++) {
        uint32_t rest = t->blocks - begin;
        begin += t->chains + 1 == chains ? rest : 1 + harness_draw_below(source, rest);
        t->chain_end[t->chains] = begin;
    }
    for (uint32_t b = 0; b < t->blocks; b++) {
        t->roles[b] = VBSS_ROLE_INTERIOR;
    }
    t->couplings = 0;
}

/* Groups of `width` or more, some blocks apart. */
static void draw_groups(twin *t, harness_source *source, vbss_role role, uint32_t width)
{
    uint32_t apart = 1 + harness_draw_below(source, 30);
    uint32_t b = harness_draw_below(source, apart);
    while (b < t->blocks) {
        uint32_t count = width + harness_draw_below(source, 3);
        for (uint32_t i = 0; i < count && b < t->blocks; i++) {
            t->roles[b++] = role;
        }
        b += 1 + harness_draw_below(source, apart);
    }
}

void twin_draw_roles(twin *t, harness_source *source, twin_roles kind)
{
    switch (kind) {
    case TWIN_RUNS:
        break;
    case TWIN_SCATTERED:
        draw_groups(t, source, VBSS_ROLE_SEPARATOR, 1);
        break;
    case TWIN_GROUPS:
        draw_groups(t, source, VBSS_ROLE_SEPARATOR, t->reach);
        break;
    case TWIN_GIVEN:
        draw_groups(t, source, VBSS_ROLE_PRESCRIBED, 1);
        break;
    case TWIN_MIXED:
        draw_groups(t, source, VBSS_ROLE_SEPARATOR, 1);
        draw_groups(t, source, VBSS_ROLE_PRESCRIBED, 1);
        break;
    case TWIN_SEPARATORS:
    case TWIN_ALL_GIVEN:
        for (uint32_t b = 0; b < t->blocks; b++) {
            t->roles[b] = kind == TWIN_SEPARATORS ? VBSS_ROLE_SEPARATOR : VBSS_ROLE_PRESCRIBED;
        }
        break;
    }
}

void twin_add_element(twin *t, uint32_t c, vec3 of_high, vec3 of_low)
{
    twin_coupling *k = &t->coupling[c];
    t->diagonal[k->high] = mat3_add(t->diagonal[k->high], mat3_outer(of_high, of_high));
    t->diagonal[k->low] = mat3_add(t->diagonal[k->low], mat3_outer(of_low, of_low));
    k->m = mat3_add(k->m, mat3_outer(of_high, of_low));
}

void twin_draw_numbers(twin *t, harness_source *source)
{
    t->mass = pow(10.0, harness_draw_real(source, -4.0, 0.0));
    for (uint32_t b = 0; b < t->blocks; b++) {
        t->diagonal[b] = mat3_diagonal(t->mass, t->mass, t->mass);
        t->rhs[b] = harness_draw_vec3(source, -1.0, 1.0);
    }
    t->couplings = 0;
    for (uint32_t chain = 0, begin = 0; chain < t->chains; begin = t->chain_end[chain++]) {
        for (uint32_t low = begin; low < t->chain_end[chain]; low++) {
            for (uint32_t high = low + 1; high <= low + t->reach; high++) {
                if (high >= t->chain_end[chain] || harness_draw_below(source, 8) == 0) {
                    continue;
                }
                bool swapped = harness_draw_below(source, 2) == 0;
                t->coupling[t->couplings++] =
                    (twin_coupling){high, low, swapped, mat3_zero(), VBSS_NO_COUPLING};
                uint32_t elements = harness_draw_below(source, 4);
                for (uint32_t e = 0; e < elements; e++) {
                    vec3 of_high = harness_draw_vec3(source, -1.0, 1.0);
                    vec3 of_low = harness_draw_vec3(source, -1.0, 1.0);
                    twin_add_element(t, t->couplings - 1, of_high, of_low);
                }
            }
        }
    }
}

/* ---- what the pattern is like */

uint32_t twin_separators(const twin *t)
{
    uint32_t count = 0;
    for (uint32_t b = 0; b < t->blocks; b++) {
        count += t->roles[b] == VBSS_ROLE_SEPARATOR;
    }
    return count;
}

bool twin_is_narrow(const twin *t)
{
    for (uint32_t c = 0; c < t->couplings; c++) {
        const twin_coupling *k = &t->coupling[c];
        for (uint32_t b = k->low + 1; b < k->high; b++) {
            if (t->roles[b] == VBSS_ROLE_SEPARATOR && t->roles[k->low] == VBSS_ROLE_INTERIOR &&
                t->roles[k->high] == VBSS_ROLE_INTERIOR) {
                return true;
            }
        }
    }
    return false;
}

/* ---- both systems */

void twin_begin_with(twin *t, uint32_t blocks, uint32_t reach, uint32_t separators)
{
    t->context = harness_context(&t->memory);
    expect_ok(vbss_system_create(t->context, blocks, reach, separators,
                                 separators * (separators + 1) / 2, &t->system));
}

void twin_begin(twin *t)
{
    uint32_t separators = twin_separators(t);
    uint32_t more = twin_is_narrow(t) ? (separators + 1) / 2 : 0;
    twin_begin_with(t, t->blocks, t->reach + more, separators);
}

void twin_end(twin *t)
{
    vbss_system_destroy(t->context, t->system);
    harness_context_end(t->context, &t->memory);
}

vbss_result twin_register(twin *t)
{
    vbss_system_begin_pattern(t->system);
    for (uint32_t chain = 0, begin = 0; chain < t->chains; begin = t->chain_end[chain++]) {
        uint32_t first;
        VBSS_TRY(vbss_system_add_chain(t->system, t->chain_end[chain] - begin, &first));
        assert_int_equal(first, begin);
        if (t->keeps_order[chain]) {
            vbss_system_use_natural_order(t->system);
        }
    }
    for (uint32_t b = 0; b < t->blocks; b++) {
        vbss_system_set_role(t->system, b, t->roles[b]);
    }
    for (uint32_t c = 0; c < t->couplings; c++) {
        twin_coupling *k = &t->coupling[c];
        VBSS_TRY(vbss_system_couple(t->system, k->swapped ? k->low : k->high,
                                    k->swapped ? k->high : k->low, &k->handle));
    }
    return vbss_system_analyse(t->system);
}

void twin_write(twin *t)
{
    vbss_system_clear(t->system);
    block b;
    for (uint32_t i = 0; i < t->blocks; i++) {
        /* What given blocks are told must not matter. */
        block_set(&t->system->diagonal[i], t->diagonal[i]);
        t->system->rhs[i] = t->rhs[i];
    }
    for (uint32_t c = 0; c < t->couplings; c++) {
        /* A body writes its couplings, a clear is only sure to empty fill. Then in two parts, which
         * sum to the whole without rounding. */
        block_set(&t->system->off_diagonal[t->coupling[c].handle], mat3_zero());
        block_set(&b, mat3_scale(t->coupling[c].m, 0.5));
        add_to_coupling(t->system, t->coupling[c].handle, &b);
        add_to_coupling(t->system, t->coupling[c].handle, &b);
    }
}

void twin_write_plain(twin *t)
{
    plain_begin(&t->plain, t->blocks);
    for (uint32_t b = 0; b < t->blocks; b++) {
        plain_add(&t->plain, b, b, t->diagonal[b]);
        plain_add_rhs(&t->plain, b, t->rhs[b]);
    }
    for (uint32_t c = 0; c < t->couplings; c++) {
        const twin_coupling *k = &t->coupling[c];
        plain_add(&t->plain, k->high, k->low, k->m);
        plain_add(&t->plain, k->low, k->high, mat3_transpose(k->m));
    }
    for (uint32_t b = 0; b < t->blocks; b++) {
        if (t->roles[b] == VBSS_ROLE_PRESCRIBED) {
            plain_remove(&t->plain, b);
        }
    }
}

block *twin_block(twin *t, uint32_t row, uint32_t column)
{
    uint32_t place = vbss_system_schur_index(t->system, row, column);
    assert_int_not_equal(place, VBSS_NO_INDEX);
    return &t->system->separator_blocks[place];
}

vec3 *twin_rhs(twin *t, uint32_t row)
{
    uint32_t place = vbss_system_schur_rhs_index(t->system, row);
    assert_int_not_equal(place, VBSS_NO_INDEX);
    return &t->system->separator_rhs[place];
}

bool twin_solve(twin *t)
{
    if (!vbss_system_condense(t->system)) {
        return false;
    }
    vbss_system_load_schur_complement(t->system);
    if (!vbss_system_solve(t->system)) {
        return false;
    }
    for (uint32_t b = 0; b < t->blocks; b++) {
        vec3_store(&t->x[(size_t)3 * b], t->system->solution[b]);
    }
    return true;
}

void twin_compare(twin *t)
{
    twin_write(t);
    twin_write_plain(t);
    /* NaN: all of it must be written. */
    memset(t->system->solution, 0xff, t->blocks * sizeof *t->system->solution);
    assert_true(twin_solve(t));
    assert_true(plain_band_solve(&t->plain, t->wanted));
    expect_near(0.0, plain_residual(&t->plain, t->x), 1e-15);
    double condition = plain_condition(&t->plain);
    expect_near(0.0, plain_difference(t->plain.n, t->x, t->wanted), 1e-15 * condition);
    for (uint32_t b = 0; b < t->blocks; b++) {
        for (uint32_t i = 0; i < 3 && t->roles[b] == VBSS_ROLE_PRESCRIBED; i++) {
            expect_same_bits(0.0, t->x[3 * b + i]);
        }
    }
    plain_end(&t->plain);
}
