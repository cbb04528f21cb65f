/* Bent strips: plate theory, beams with free edges, and the elastica. */
#include "base/elementary.h"
#include "drain/shell_rig.h"

#include "harness/harness.h"
#include "thread/elastica.h"

typedef struct strip {
    double length, width;
} strip;

static vec3 strip_at(double u, double v, const void *user)
{
    const strip *s = user;
    return vec3_make(s->length * u, s->width * v, 0.0);
}

/* A load on all nodes of a column, shared as widths are. */
static void load_column(shell_rig *r, uint32_t column, uint32_t rows, vec3 load)
{
    for (uint32_t k = 0; k <= rows; k++) {
        double share = (k == 0 || k == rows ? 0.5 : 1.0) / rows;
        r->load[column * (rows + 1) + k] = vec3_scale(load, share);
    }
}

static vec3 column_mean(const shell_rig *r, const vec3 *of, uint32_t column, uint32_t rows)
{
    vec3 sum = vec3_zero();
    for (uint32_t k = 0; k <= rows; k++) {
        sum = vec3_add_scaled(sum, 1.0 / (rows + 1), of[column * (rows + 1) + k]);
    }
    assert_true(column * (rows + 1) + rows < r->own_count);
    return sum;
}

/* ---- rolled onto a cylinder: M11 = D k, M22 = nu D k, D k^2 / 2 of the area (Kirchhoff) */

static void rolled_plate_moment_matches_plate_theory(void **state)
{
    (void)state;
    const double nu = 0.47, radius = 20.0;
    const strip s = {8.0, 6.0};
    shell_rig r;
    shell_rig_mesh(&r, 8, 6, false, false, strip_at, &s);
    vbss_shell_input in = shell_rig_input(&r);
    in.poisson = nu;
    shell_rig_start(&r, &in);
    for (uint32_t i = 0; i < r.node_count; i++) {
        double angle = r.rest[i].x / radius;
        r.x[i] = vec3_make(radius * vbss_sin(angle), r.rest[i].y, radius * (1.0 - vbss_cos(angle)));
    }
    shell_rig_energy(&r);
    double d = 1e-3 / (12.0 * (1.0 - nu * nu)), k = 1.0 / radius;
    uint32_t inside = 0;
    for (uint32_t i = 0; i < r.triangle_count; i++) {
        const uint32_t *far = r.opposite[i];
        const vbss_shell_response *at = &r.states[i];
        if (far[0] == SHELL_NONE || far[1] == SHELL_NONE || far[2] == SHELL_NONE) {
            continue;
        }
        inside++;
        expect_near(k, at->curvature[0] + at->curvature[1], 1e-3 * k);
        expect_near((1.0 + nu) * d * k, at->bending_moment[0] + at->bending_moment[1],
                    1e-3 * d * k);
        expect_near(0.5 * d * k * k * 0.5, at->bending_energy, 1e-3 * d * k * k);
        if (i % 2 == 0) { /* whose axis 1 runs around */
            expect_near(d * k, at->bending_moment[0], 1e-3 * d * k);
            expect_near(nu * d * k, at->bending_moment[1], 1e-3 * d * k);
            expect_near(0.0, at->bending_moment[2], 1e-3 * d * k);
        }
    }
    assert_true(inside > 60);
    shell_rig_end(&r);
}

/* ---- a strip bent by a couple: its sides curl up freely, so that it is a beam, w'' = M / EI */

/* Tip deflection over the beam's; the couple is a pair of forces on the last two columns. */
static double couple_ratio(uint32_t columns, uint32_t rows, double nu, bool rule)
{
    const strip s = {1.0, 0.2};
    const double moment = 1e-12, h = 1.0 / columns;
    shell_rig r;
    shell_rig_mesh(&r, columns, rows, false, false, strip_at, &s);
    shell_rig_mirror(&r, 0, 0.0); /* clamped, yet free to curl */
    vbss_shell_input in = shell_rig_input(&r);
    in.poisson = nu;
    in.thickness = 0.02;
    in.moment_free_edges = rule;
    shell_rig_start(&r, &in);
    load_column(&r, columns, rows, vec3_make(0.0, 0.0, moment / h));
    load_column(&r, columns - 1, rows, vec3_make(0.0, 0.0, -moment / h));
    r.held[0][1] = r.held[0][2] = r.held[rows][2] = true;
    assert_int_equal(1, shell_rig_solve(&r, 1));
    double bending = s.width * in.thickness * in.thickness * in.thickness / 12.0;
    double own = column_mean(&r, r.x, columns, rows).z - column_mean(&r, r.x, 0, rows).z;
    shell_rig_end(&r);
    double beam = 0.5 * (1.0 - h) * (1.0 - h) + (1.0 - h) * h + h * h / 3.0;
    return own / (beam * moment / bending);
}

static void free_strip_bends_as_beam(void **state)
{
    (void)state;
    expect_near(1.0, couple_ratio(5, 1, 0.47, true), 0.02);
    expect_near(1.0, couple_ratio(10, 2, 0.47, true), 0.003);
    expect_near(1.0, couple_ratio(20, 4, 0.47, true), 0.001);
    expect_near(1.0, couple_ratio(20, 4, 0.0, true), 0.001);
}

/* Without the rule the moment across a free side is not zero: plane strain beside the edges. */
static void missing_free_edge_rule_is_too_stiff(void **state)
{
    (void)state;
    expect_near(0.88, couple_ratio(5, 1, 0.47, false), 0.01);
    expect_near(0.91, couple_ratio(10, 2, 0.47, false), 0.01);
    expect_near(0.945, couple_ratio(20, 4, 0.47, false), 0.01);
}

/* ---- large deflection */

/* Distance of the tip from the elastica's, for a strip of unit length and a load of `factor` EI. */
static double elastica_error(uint32_t columns, uint32_t rows, double factor)
{
    const strip s = {1.0, 0.2};
    shell_rig r;
    shell_rig_mesh(&r, columns, rows, false, false, strip_at, &s);
    shell_rig_mirror(&r, 0, 0.0);
    vbss_shell_input in = shell_rig_input(&r);
    in.thickness = 0.01;
    shell_rig_start(&r, &in);
    double bending = s.width * 1e-6 / 12.0;
    load_column(&r, columns, rows, vec3_make(0.0, 0.0, -factor * bending));
    for (uint32_t k = 0; k <= rows; k++) {
        r.held[k][2] = true;
    }
    r.held[0][1] = true;
    assert_true(shell_rig_solve(&r, 200) < 200);
    vec3 tip = column_mean(&r, r.x, columns, rows);
    shell_rig_end(&r);
    vbss_thread_config c;
    expect_ok(vbss_thread_config_init(&c, sizeof c));
    c.length = 1.0;
    c.bending_stiffness = bending;
    c.linear_density = 0.0;
    elastica e = elastica_solve(&c, factor * bending);
    return vec3_distance(tip, vec3_make(e.x, 0.5 * s.width, -e.drop));
}

static void strip_follows_elastica(void **state)
{
    (void)state;
    double coarse = elastica_error(10, 2, 4.0), fine = elastica_error(20, 4, 4.0);
    expect_near(0.0, coarse, 0.011);
    expect_near(0.0, fine, 0.0028);
    expect_near(4.0, coarse / fine, 0.4); /* second order */
    expect_near(0.0, elastica_error(20, 4, 10.0), 0.0055);
}

int test_shell_bending(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rolled_plate_moment_matches_plate_theory),
        cmocka_unit_test(free_strip_bends_as_beam),
        cmocka_unit_test(missing_free_edge_rule_is_too_stiff),
        cmocka_unit_test(strip_follows_elastica),
    };
    return cmocka_run_group_tests_name("drain.shell_bending", tests, NULL, NULL);
}
