/* The tangent of a shell: positive semi-definite anywhere, and the exact slope of the forces where no
 * stress is compressive and curvatures are those of rest. */
#include <string.h>

#include "drain/shell_sheet.h"

enum { MAX_COUNT = 3 * 20 };

/* ---- dense, from the blocks */

typedef struct dense {
    int n;
    double a[MAX_COUNT][MAX_COUNT];
} dense;

static void set_dense(const shell_rig *r, dense *d)
{
    memset(d, 0, sizeof *d);
    d->n = 3 * (int)r->node_count;
    assert_true(d->n <= MAX_COUNT);
    for (uint32_t p = 1; p <= r->pair_count + r->node_count; p++) {
        bool pair = p <= r->pair_count;
        uint32_t own = p - r->pair_count - 1;
        uint32_t row = pair ? r->pairs[p][0] : own, column = pair ? r->pairs[p][1] : own;
        mat3 m = block_mat3(pair ? &r->blocks[p] : &r->diagonal[own]);
        for (uint32_t i = 0; i < 3; i++) {
            for (uint32_t j = 0; j < 3; j++) {
                d->a[3 * row + i][3 * column + j] = m.m[i][j];
                d->a[3 * column + j][3 * row + i] = m.m[i][j];
            }
        }
    }
}

static double *number(shell_rig *r, int i)
{
    vec3 *x = &r->x[i / 3];
    return i % 3 == 0 ? &x->x : i % 3 == 1 ? &x->y : &x->z;
}

static double force(const shell_rig *r, int i)
{
    double f[3];
    vec3_store(f, r->forces[i / 3]);
    return f[i % 3];
}

/* Forces at -2, -1, 1, 2 times h, minus their slope against column j. */
static void check_column(shell_rig *r, const dense *d, int j, double tolerance)
{
    const double h = 1e-4;
    static const double offsets[4] = {-2.0, -1.0, 1.0, 2.0}, weights[4] = {1.0, -8.0, 8.0, -1.0};
    double slope[MAX_COUNT] = {0.0}, home = *number(r, j);
    for (int k = 0; k < 4; k++) {
        *number(r, j) = home + offsets[k] * h;
        shell_rig_energy(r);
        for (int i = 0; i < d->n; i++) {
            slope[i] -= weights[k] / (12.0 * h) * force(r, i);
        }
    }
    *number(r, j) = home;
    for (int i = 0; i < d->n; i++) {
        expect_near(slope[i], d->a[i][j], tolerance);
    }
}

static void check_all(shell_rig *r)
{
    dense d;
    double stiffest = vbss_max(shell_rig_stiffest(r), 1.0);
    set_dense(r, &d);
    for (int j = 0; j < d.n; j++) {
        check_column(r, &d, j, 1e-9 * stiffest);
    }
}

static void exact_at_rest(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    shell_sheet_start(source, &r);
    shell_sheet_deform(source, &r, 0.0);
    check_all(&r);
    shell_rig_end(&r);
}

static void tangent_at_rest_is_exact_hessian(void **state)
{
    (void)state;
    harness_property("shell tangents at rest", 20, exact_at_rest, NULL);
}

/* The rest state as it is, larger: strain in all directions, and no node leaves its neighbours' plane. */
static void exact_in_tension(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    vbss_shell_input in;
    shell_sheet_draw(source, &r, &in);
    for (uint32_t i = 0; i < r.node_count; i++) {
        r.rest[i].z = 0.0;
    }
    shell_rig_start(&r, &in);
    quat turn = harness_draw_unit_quat(source);
    for (uint32_t i = 0; i < r.node_count; i++) {
        vec3 larger = vec3_make(1.3 * r.rest[i].x, 1.2 * r.rest[i].y, 0.0);
        r.x[i] = quat_rotate(turn, larger);
    }
    check_all(&r);
    shell_rig_end(&r);
}

static void tangent_stretched_flat_is_exact_hessian(void **state)
{
    (void)state;
    harness_property("shell tangents in tension", 20, exact_in_tension, NULL);
}

/* ---- positive semi-definite: no pivot below round-off, rows and columns exchanged */

static int largest_diagonal(const dense *d, int k)
{
    int best = k;
    for (int i = k; i < d->n; i++) {
        best = d->a[i][i] > d->a[best][best] ? i : best;
    }
    return best;
}

static void exchange(dense *d, int k, int l)
{
    for (int i = 0; i < d->n; i++) {
        double kept = d->a[i][k];
        d->a[i][k] = d->a[i][l];
        d->a[i][l] = kept;
    }
    for (int i = 0; i < d->n; i++) {
        double kept = d->a[k][i];
        d->a[k][i] = d->a[l][i];
        d->a[l][i] = kept;
    }
}

static void check_positive(dense *d)
{
    double scale = d->a[largest_diagonal(d, 0)][largest_diagonal(d, 0)];
    for (int k = 0; k < d->n; k++) {
        exchange(d, k, largest_diagonal(d, k));
        double pivot = d->a[k][k];
        if (pivot <= 1e-13 * scale) { /* what is left must be nothing */
            for (int i = k; i < d->n; i++) {
                expect_near(0.0, d->a[i][i], 1e-12 * scale);
            }
            return;
        }
        for (int i = k + 1; i < d->n; i++) {
            double share = d->a[i][k] / pivot;
            for (int j = k; j < d->n; j++) {
                d->a[i][j] -= share * d->a[k][j];
            }
        }
    }
}

static void stays_positive(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    dense d;
    shell_sheet_start(source, &r);
    shell_sheet_deform(source, &r, 0.4);
    shell_rig_tangent(&r);
    set_dense(&r, &d);
    for (int i = 0; i < d.n; i++) {
        vec3 sum = vec3_zero(); /* moving all nodes alike costs nothing */
        double size = 0.0;
        for (int j = 0; j < d.n; j += 3) {
            sum = vec3_add(sum, vec3_load(&d.a[i][j]));
            size += vec3_norm(vec3_load(&d.a[i][j]));
        }
        expect_near(0.0, vec3_norm(sum), 1e-14 * size);
        for (int j = 0; j < i; j++) {
            expect_same_bits(d.a[i][j], d.a[j][i]);
        }
    }
    check_positive(&d);
    shell_rig_end(&r);
}

static void tangent_is_symmetric_positive_semidefinite(void **state)
{
    (void)state;
    harness_property("shell tangents are positive", 60, stays_positive, NULL);
}

int test_shell_tangent(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tangent_at_rest_is_exact_hessian),
        harness_test(tangent_stretched_flat_is_exact_hessian),
        harness_test(tangent_is_symmetric_positive_semidefinite),
    };
    return cmocka_run_group_tests_name("drain.shell_tangent", tests, NULL, NULL);
}
