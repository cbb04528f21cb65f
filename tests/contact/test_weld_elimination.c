/* A node that is a point of a body: the reduced system against the whole one with its constraint. */
#include "base/elementary.h"
#include "few_blocks.h"
#include "solver/plain_solve.h"

/* Nodes first, then the two blocks of each body; all separators, all numbers any. */
enum { NODES = 5, BODIES = 2, BLOCKS = NODES + 2 * BODIES, WELDS = 4 };

typedef struct welded {
    harness_memory memory;
    vbss_context *context;
    vbss_system *system;
    mat3 a[BLOCKS][BLOCKS]; /* zero: not coupled */
    vec3 b[BLOCKS];
    contact_weld welds[WELDS];
    uint32_t weld_count;
    double rod; /* of the nodes' stiffness against each other */
} welded;

static mat3 draw_matrix(harness_source *source, double size)
{
    mat3 m;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            m.m[i][k] = harness_draw_real(source, -size, size);
        }
    }
    return m;
}

/* g^T g of a spring between two blocks, or of one alone. */
static void add_spring(welded *w, uint32_t i, uint32_t k, mat3 g)
{
    mat3 gg = mat3_mul(mat3_transpose(g), g);
    w->a[i][i] = mat3_add(w->a[i][i], gg);
    if (i != k) {
        w->a[k][k] = mat3_add(w->a[k][k], gg);
        w->a[i][k] = mat3_sub(w->a[i][k], gg);
        w->a[k][i] = mat3_sub(w->a[k][i], gg);
    }
}

static void draw_system(welded *w, harness_source *source, double body_mass)
{
    memset(w, 0, sizeof *w);
    for (uint32_t i = 0; i < BLOCKS; i++) {
        double size = i < NODES ? 1.0 : sqrt(body_mass);
        add_spring(w, i, i, mat3_scale(mat3_identity(), size));
        add_spring(w, i, i, draw_matrix(source, 0.5 * size));
        w->b[i] = harness_draw_vec3(source, -1.0, 1.0);
    }
    for (uint32_t i = 0; i < NODES; i++) { /* a thread: each node with two on */
        for (uint32_t k = i + 1; k < NODES && k <= i + 2; k++) {
            add_spring(w, i, k, draw_matrix(source, 1.0));
        }
    }
    for (uint32_t body = 0; body < BODIES; body++) {
        uint32_t t = NODES + 2 * body;
        add_spring(w, t, t + 1, draw_matrix(source, 0.3 * sqrt(body_mass)));
    }
}

static void add_weld(welded *w, harness_source *source, uint32_t node, uint32_t body)
{
    contact_weld *weld = &w->welds[w->weld_count++];
    *weld = (contact_weld){.node = node,
                           .translation = NODES + 2 * body,
                           .rotation = NODES + 2 * body + 1,
                           .arm = harness_draw_vec3(source, -2.0, 2.0)};
    for (uint32_t k = 0; k < NODES; k++) {
        if (k != node && k <= node + 2 && node <= k + 2) {
            weld->neighbours[weld->neighbour_count++] = k;
        }
    }
    /* Of a neighbour that was welded before, the body: that has taken over. */
    for (const contact_weld *before = w->welds; before < weld; before++) {
        if (before->node <= node + 2 && node <= before->node + 2) {
            weld->neighbours[weld->neighbour_count++] = before->translation;
            weld->neighbours[weld->neighbour_count++] = before->rotation;
        }
    }
    assert_true(weld->neighbour_count <= CONTACT_WELD_MAX_NEIGHBOURS);
}

/* ---- by the library */

static void solve_reduced(welded *w, vec3 x[BLOCKS])
{
    uint32_t first, coupling[BLOCKS][BLOCKS] = {{0}};
    w->context = harness_context(&w->memory);
    expect_ok(vbss_system_create(w->context, BLOCKS, 2, BLOCKS, BLOCKS * BLOCKS, &w->system));
    vbss_system_begin_pattern(w->system);
    expect_ok(vbss_system_add_chain(w->system, NODES, &first));
    expect_ok(vbss_system_add_chain(w->system, BLOCKS - NODES, &first));
    for (uint32_t i = 0; i < BLOCKS; i++) {
        vbss_system_set_role(w->system, i, VBSS_ROLE_SEPARATOR);
    }
    for (uint32_t i = 0; i < BLOCKS; i++) {
        for (uint32_t k = 0; k < i; k++) {
            if (w->a[i][k].m[0][0] != 0.0) {
                expect_ok(vbss_system_couple(w->system, i, k, &coupling[i][k]));
            }
        }
    }
    for (uint32_t i = 0; i < w->weld_count; i++) {
        expect_ok(vbss_contact_register_weld(&w->welds[i], w->system));
    }
    expect_ok(vbss_system_analyse(w->system));
    vbss_system_clear(w->system);
    memset(w->system->off_diagonal, 0,
           (w->system->coupling_count + 1) * sizeof *w->system->off_diagonal);
    for (uint32_t i = 0; i < BLOCKS; i++) {
        block_set(&w->system->diagonal[i], w->a[i][i]);
        w->system->rhs[i] = w->b[i];
        for (uint32_t k = 0; k < i; k++) {
            if (coupling[i][k] != VBSS_NO_COUPLING) { /* rows of what is eliminated later */
                bool flipped = w->system->couplings[coupling[i][k]].is_transposed != 0;
                block_set(&w->system->off_diagonal[coupling[i][k]],
                          w->a[flipped ? k : i][flipped ? i : k]);
            }
        }
    }
    assert_true(vbss_system_condense(w->system));
    vbss_system_load_schur_complement(w->system);
    for (uint32_t i = 0; i < w->weld_count; i++) {
        vbss_contact_eliminate_weld(&w->welds[i], w->system);
    }
    assert_true(vbss_system_solve_separators(w->system));
    for (uint32_t i = 0; i < w->weld_count; i++) {
        vec3 *slave = &w->system->solution[w->welds[i].node];
        expect_near(0.0, vec3_norm(*slave), 0.0); /* its own equation says that nothing moves */
        *slave = vbss_contact_weld_increment(&w->welds[i], w->system);
    }
    memcpy(x, w->system->solution, BLOCKS * sizeof *x);
    vbss_system_destroy(w->context, w->system);
    harness_context_end(w->context, &w->memory);
}

/* ---- the whole system, with a multiplier for each weld, in long double */

static void solve_whole(const welded *w, vec3 x[BLOCKS])
{
    plain_system p;
    double solution[3 * (BLOCKS + WELDS)];
    plain_begin(&p, BLOCKS + w->weld_count);
    for (uint32_t i = 0; i < BLOCKS; i++) {
        plain_add_rhs(&p, i, w->b[i]);
        for (uint32_t k = 0; k < BLOCKS; k++) {
            plain_add(&p, i, k, w->a[i][k]);
        }
    }
    for (uint32_t i = 0; i < w->weld_count; i++) { /* s - t - dtheta x arm = 0 */
        const contact_weld *weld = &w->welds[i];
        const uint32_t blocks[3] = {weld->node, weld->translation, weld->rotation};
        const mat3 maps[3] = {mat3_identity(), mat3_scale(mat3_identity(), -1.0),
                              mat3_cross(weld->arm)};
        for (int k = 0; k < 3; k++) {
            plain_add(&p, BLOCKS + i, blocks[k], maps[k]);
            plain_add(&p, blocks[k], BLOCKS + i, mat3_transpose(maps[k]));
        }
    }
    assert_true(plain_lu_solve(&p, solution));
    for (uint32_t i = 0; i < BLOCKS; i++) {
        x[i] = vec3_load(solution + 3 * (size_t)i);
    }
    plain_end(&p);
}

static void compare(welded *w, double tolerance)
{
    vec3 got[BLOCKS], wanted[BLOCKS];
    double scale = 0.0;
    solve_reduced(w, got);
    solve_whole(w, wanted);
    for (uint32_t i = 0; i < BLOCKS; i++) {
        scale = vbss_max(vec3_norm(wanted[i]), scale);
    }
    for (uint32_t i = 0; i < BLOCKS; i++) {
        expect_near(0.0, vec3_distance(wanted[i], got[i]), tolerance * scale);
    }
}

static double draw_mass(harness_source *source)
{
    return vbss_exp(harness_draw_real(source, -13.8, 13.8)); /* 1e-6 to 1e6 of a node's */
}

static void one_weld(harness_source *source, void *user)
{
    welded w;
    (void)user;
    draw_system(&w, source, draw_mass(source));
    uint32_t node = harness_draw_below(source, NODES);
    add_weld(&w, source, node, harness_draw_below(source, BODIES));
    compare(&w, 1e-8);
}

static void welds_apart(harness_source *source, void *user)
{
    welded w;
    (void)user;
    draw_system(&w, source, draw_mass(source));
    uint32_t body = harness_draw_below(source, BODIES);
    add_weld(&w, source, 0, body);
    add_weld(&w, source, 4, harness_draw_below(source, BODIES));
    compare(&w, 1e-8);
}

/* Nodes that are each other's neighbours, of one body or of two. */
static void welds_side_by_side(harness_source *source, void *user)
{
    welded w;
    (void)user;
    draw_system(&w, source, draw_mass(source));
    uint32_t node = harness_draw_below(source, 3), body = harness_draw_below(source, BODIES);
    add_weld(&w, source, node, body);
    add_weld(&w, source, node + 1, harness_draw_below(source, BODIES));
    if (harness_draw_below(source, 2) == 0) {
        add_weld(&w, source, node + 2, harness_draw_below(source, BODIES));
    }
    compare(&w, 1e-8);
}

static void weld_is_exact_to_rounding(void **state)
{
    (void)state;
    harness_property("one", 300, one_weld, NULL);
}

static void welds_on_one_or_two_bodies_are_exact(void **state)
{
    (void)state;
    harness_property("apart", 300, welds_apart, NULL);
}

static void adjacent_welds_are_exact(void **state)
{
    (void)state;
    harness_property("side by side", 300, welds_side_by_side, NULL);
}

int test_weld_elimination(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(weld_is_exact_to_rounding),
        harness_test(welds_on_one_or_two_bodies_are_exact),
        harness_test(adjacent_welds_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
