#include <math.h>
#include <string.h>

#include "solver/twin.h"

/* Large: not on the stack. */
static twin subject;

typedef struct variety {
    twin_roles roles;
    uint32_t largest;
} variety;

static void of_a_kind(harness_source *source, void *user)
{
    const variety *k = user;
    twin_draw_chains(&subject, source, k->largest);
    twin_draw_roles(&subject, source, k->roles);
    twin_draw_numbers(&subject, source);
    twin_begin(&subject);
    expect_ok(twin_register(&subject));
    twin_compare(&subject);
    twin_end(&subject);
}

static void condensed_runs_match_band_solve(void **state)
{
    (void)state;
    harness_property("runs", 150, of_a_kind, &(variety){TWIN_RUNS, 300});
}

/* Trap: fill that meets separators on both sides of a run, or past a narrow one. */
static void scattered_separators_match_band_solve(void **state)
{
    (void)state;
    harness_property("scattered separators", 200, of_a_kind, &(variety){TWIN_SCATTERED, 80});
}

static void grouped_separators_fit_documented_capacity(void **state)
{
    (void)state;
    harness_property("groups of separators", 200, of_a_kind, &(variety){TWIN_GROUPS, 300});
}

static void prescribed_blocks_have_no_equation_and_stay(void **state)
{
    (void)state;
    harness_property("given blocks", 150, of_a_kind, &(variety){TWIN_GIVEN, 300});
    harness_property("all given", 20, of_a_kind, &(variety){TWIN_ALL_GIVEN, 30});
}

static void separators_alone_are_solved(void **state)
{
    (void)state;
    harness_property("all separators", 100, of_a_kind, &(variety){TWIN_SEPARATORS, 120});
}

static void mixed_roles_match_band_solve(void **state)
{
    (void)state;
    harness_property("mixed roles", 300, of_a_kind, &(variety){TWIN_MIXED, 80});
}

/* ---- a thread: stretch far stiffer than inertia, bending in between */

enum { SEGMENTS = 120 };
#define INERTIA 1.0
#define BENDING 64.0 /* EI h^2 / (mass per length l^4) of a real suture at N = 120, h = 1 ms */

typedef struct thread {
    double stretch; /* against inertia */
    bool clamped, separators;
} thread;

/* The coupling of two blocks of the thread: each block has those to the next two. */
static uint32_t coupling_of(uint32_t high, uint32_t low)
{
    return 2 * low + (high - low - 1);
}

static void draw_thread(twin *t, harness_source *source, const thread *made, vec3 *tangents)
{
    t->blocks = t->chain_end[0] = SEGMENTS + 1;
    t->reach = 2;
    t->chains = 1;
    t->couplings = 0;
    for (uint32_t b = 0; b <= SEGMENTS; b++) {
        t->roles[b] = made->clamped && b < 2 ? VBSS_ROLE_PRESCRIBED : VBSS_ROLE_INTERIOR;
        t->diagonal[b] = mat3_diagonal(INERTIA, INERTIA, INERTIA);
        t->rhs[b] = harness_draw_vec3(source, -1.0, 1.0);
        for (uint32_t high = b + 1; high <= b + 2 && high <= SEGMENTS; high++) {
            t->coupling[t->couplings++] =
                (twin_coupling){high, b, false, mat3_zero(), VBSS_NO_COUPLING};
        }
    }
    for (uint32_t i = 0; i < 3 && made->separators; i++) {
        uint32_t at = harness_draw_below(source, SEGMENTS);
        t->roles[at] = t->roles[at + 1] = VBSS_ROLE_SEPARATOR;
    }
    vec3 e = vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(1, 0, 0));
    double root = sqrt(made->stretch);
    for (uint32_t b = 0; b < SEGMENTS; b++) {
        tangents[b] = e;
        twin_add_element(t, coupling_of(b + 1, b), vec3_scale(e, root), vec3_scale(e, -root));
        e = vec3_unit_or(vec3_add(e, harness_draw_vec3(source, -0.3, 0.3)), e);
    }
    static const double stencil[3] = {1.0, -2.0, 1.0};
    for (uint32_t b = 0; b + 2 <= SEGMENTS; b++) {
        for (uint32_t i = 0; i < 3; i++) {
            double own = BENDING * stencil[i] * stencil[i];
            t->diagonal[b + i] = mat3_add(t->diagonal[b + i], mat3_diagonal(own, own, own));
            for (uint32_t j = 0; j < i; j++) {
                double k = BENDING * stencil[i] * stencil[j];
                mat3 *m = &t->coupling[coupling_of(b + i, b + j)].m;
                *m = mat3_add(*m, mat3_diagonal(k, k, k));
            }
        }
    }
}

/* Largest part of b - a x across the thread, where there is no stretch to hide it. */
static double soft_defect(const twin *t, const vec3 *tangents)
{
    static double r[3 * TWIN_BLOCKS];
    double largest = 0.0;
    plain_defect(&t->plain, t->x, r);
    for (uint32_t b = 1; b < SEGMENTS; b++) {
        vec3 across =
            vec3_unit_or(vec3_cross(tangents[b - 1], tangents[b]), vec3_any_normal(tangents[b]));
        largest = fmax(largest, fabs(vec3_dot(across, vec3_load(&r[(size_t)3 * b]))));
    }
    return largest;
}

/* Loads are of size one. What is lost is rounding of the stretch, as in any elimination in doubles:
 * seen 2e-16 of k across the thread (2e-6 of the load at k = 1e10) and 1e-16 of k in the solution. */
static void stiff_thread(harness_source *source, void *user)
{
    const thread *made = user;
    vec3 tangents[SEGMENTS];
    draw_thread(&subject, source, made, tangents);
    twin_begin(&subject);
    expect_ok(twin_register(&subject));
    twin_write(&subject);
    twin_write_plain(&subject);
    assert_true(twin_solve(&subject));
    assert_true(plain_band_solve(&subject.plain, subject.wanted));
    expect_near(0.0, plain_residual(&subject.plain, subject.x), 1e-15);
    expect_near(0.0, soft_defect(&subject, tangents), 1e-15 * made->stretch);
    expect_near(0.0, plain_difference(subject.plain.n, subject.x, subject.wanted),
                3e-16 * made->stretch);
    plain_end(&subject.plain);
    twin_end(&subject);
}

static void silk_stiff_thread_is_accurate_in_soft_directions(void **state)
{
    (void)state;
    static const double stretches[] = {4e6, 2e8, 1e10};
    for (uint32_t i = 0; i < 12; i++) {
        thread made = {stretches[i % 3], (i / 3) % 2 == 1, i / 6 == 1};
        harness_property("stiff thread", 20, stiff_thread, &made);
    }
}

/* ---- nothing is left behind */

static void solve_to(double *x)
{
    twin_write(&subject);
    assert_true(twin_solve(&subject));
    memcpy(x, subject.x, (size_t)3 * subject.blocks * sizeof *x);
}

static void again_after_clear(harness_source *source, void *user)
{
    (void)user;
    static double first[3 * TWIN_BLOCKS], again[3 * TWIN_BLOCKS];
    twin_draw_chains(&subject, source, 60);
    twin_draw_roles(&subject, source, TWIN_MIXED);
    twin_draw_numbers(&subject, source);
    twin_begin(&subject);
    expect_ok(twin_register(&subject));
    solve_to(first);
    for (uint32_t b = 0; b < subject.blocks; b++) { /* other numbers in between */
        subject.diagonal[b] = mat3_scale(subject.diagonal[b], 4.0);
        subject.rhs[b] = vec3_scale(subject.rhs[b], -8.0);
    }
    solve_to(again);
    for (uint32_t b = 0; b < subject.blocks; b++) {
        subject.diagonal[b] = mat3_scale(subject.diagonal[b], 0.25);
        subject.rhs[b] = vec3_scale(subject.rhs[b], -0.125);
    }
    solve_to(again);
    for (uint32_t i = 0; i < 3 * subject.blocks; i++) {
        expect_same_bits(first[i], again[i]);
    }
    twin_end(&subject);
}

static void repeated_solve_is_bit_equal(void **state)
{
    (void)state;
    harness_property("again after clear", 100, again_after_clear, NULL);
}

int test_condensed(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(condensed_runs_match_band_solve),
        harness_test(scattered_separators_match_band_solve),
        harness_test(grouped_separators_fit_documented_capacity),
        harness_test(prescribed_blocks_have_no_equation_and_stay),
        harness_test(separators_alone_are_solved),
        harness_test(mixed_roles_match_band_solve),
        harness_test(silk_stiff_thread_is_accurate_in_soft_directions),
        harness_test(repeated_solve_is_bit_equal),
    };
    return cmocka_run_group_tests_name("solver.condensed", tests, NULL, NULL);
}
