#include "solver/contacts.h"

/* ---- couplings */

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

static void couple_separators(twin *t, uint32_t a, uint32_t b, bool swapped)
{
    if (a != b && t->roles[a] == VBSS_ROLE_SEPARATOR && t->roles[b] == VBSS_ROLE_SEPARATOR &&
        !coupled(t, a, b)) {
        t->coupling[t->couplings++] =
            (twin_coupling){a > b ? a : b, a > b ? b : a, swapped, mat3_zero(), VBSS_NO_COUPLING};
    }
}

void contacts_draw(twin *t, harness_source *source, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t a = harness_draw_below(source, t->blocks);
        uint32_t b = harness_draw_below(source, t->blocks);
        couple_separators(t, a, b, i % 2 == 0);
    }
}

enum { ARCS = 4 };

void contacts_draw_knot(twin *t, harness_source *source, uint32_t max_separators)
{
    uint32_t arcs = 2 + harness_draw_below(source, ARCS - 1), first[ARCS];
    uint32_t each = 4 + harness_draw_below(source, max_separators / arcs - 3);
    bool apart = harness_draw_below(source, 2) == 0;
    t->reach = 1 + harness_draw_below(source, 3);
    t->blocks = t->chains = 0;
    for (uint32_t arc = 0; arc < arcs; arc++) {
        uint32_t before = harness_draw_below(source, 10), after = harness_draw_below(source, 10);
        first[arc] = t->blocks + before;
        for (uint32_t i = 0; i < before + each + after; i++) {
            bool inside = i >= before && i < before + each;
            t->roles[t->blocks++] = inside ? VBSS_ROLE_SEPARATOR : VBSS_ROLE_INTERIOR;
        }
        t->chains += apart || arc == 0;
        t->chain_end[t->chains - 1] = t->blocks;
    }
    twin_draw_numbers(t, source);
    for (uint32_t i = 0; i < arcs * each; i++) {
        uint32_t one = harness_draw_below(source, arcs);
        uint32_t other = (one + 1 + harness_draw_below(source, arcs - 1)) % arcs;
        uint32_t at = harness_draw_below(source, each - 1);
        uint32_t beside = at + harness_draw_below(source, 2); /* strands lie side by side */
        uint32_t a = first[one] + at, b = first[other] + (beside < each - 1 ? beside : at);
        for (uint32_t pair = 0; pair < 4; pair++) {
            couple_separators(t, a + pair % 2, b + pair / 2, i % 2 == 0);
        }
    }
}

/* ---- numbers */

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
void contacts_add(twin *t, harness_source *source)
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
