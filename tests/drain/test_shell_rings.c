/* Rings and tubes against closed solutions. All linear: one step from rest under tiny loads. */
#include "base/elementary.h"
#include "drain/shell_rig.h"

#include "harness/harness.h"

static const double pi = 0x1.921fb54442d18p1;

typedef struct tube {
    double radius, length;
    uint32_t columns, rows;
} tube;

static vec3 tube_at(double u, double v, const void *user)
{
    const tube *t = user;
    double angle = 2.0 * pi * u;
    return vec3_make(t->radius * vbss_cos(angle), t->radius * vbss_sin(angle), t->length * v);
}

static void begin(shell_rig *r, const tube *t)
{
    shell_rig_mesh(r, t->columns, t->rows, true, false, tube_at, t);
}

static uint32_t node_at(const tube *t, uint32_t column, uint32_t row)
{
    return column % t->columns * (t->rows + 1) + row;
}

static double row_share(const tube *t, uint32_t row)
{
    return (row == 0 || row == t->rows ? 0.5 : 1.0) / t->rows;
}

static vec3 outward(const tube *t, uint32_t column)
{
    double angle = 2.0 * pi * column / t->columns;
    return vec3_make(vbss_cos(angle), vbss_sin(angle), 0.0);
}

/* What keeps the columns on both axes on them, and the whole in place. */
static void hold_axes(shell_rig *r, const tube *t)
{
    for (uint32_t quarter = 0; quarter < 4; quarter++) {
        uint32_t column = quarter * t->columns / 4;
        for (uint32_t k = 0; k <= t->rows; k++) {
            r->held[node_at(t, column, k)][quarter % 2 == 0 ? 1 : 0] = true;
        }
        r->held[node_at(t, column, 0)][2] = quarter < 3;
    }
}

/* ---- pulled apart at two points: (pi/4 - 2/pi) P R^3 / (E I) (Timoshenko, Strength of Materials) */

static double pulled_ratio(uint32_t columns)
{
    const tube t = {1.0, 0.2, columns, 3};
    const double force = 1e-9;
    shell_rig r;
    begin(&r, &t);
    vbss_shell_input in = shell_rig_input(&r);
    in.thickness = 1.0 / 50.0;
    shell_rig_start(&r, &in);
    hold_axes(&r, &t);
    double opened = 0.0;
    for (uint32_t k = 0; k <= t.rows; k++) {
        double share = force * row_share(&t, k);
        r.load[node_at(&t, 0, k)].x = share;
        r.load[node_at(&t, columns / 2, k)].x = -share;
    }
    assert_int_equal(1, shell_rig_solve(&r, 1));
    for (uint32_t k = 0; k <= t.rows; k++) {
        opened +=
            (r.x[node_at(&t, 0, k)].x - r.x[node_at(&t, columns / 2, k)].x - 2.0) / (t.rows + 1);
    }
    shell_rig_end(&r);
    double bending = t.length * in.thickness * in.thickness * in.thickness / 12.0;
    return opened / (0.1488 * force / bending);
}

static void pulled_ring_opens_as_theory(void **state)
{
    (void)state;
    expect_near(1.0, pulled_ratio(48), 0.025);
    expect_near(1.0, pulled_ratio(96), 0.0065);
}

/* ---- load p cos 2 theta: w = p R^4 / (9 D) (1 + 4 t^2 / (12 R^2)); the second term is what the middle
 * surface gives, docs/explanation/drain-shell.md */

static double ovalled_ratio(uint32_t columns, bool corrected)
{
    const double radius = 6.5, load = 1e-9;
    const tube t = {radius, 4.0 * pi * radius / columns, columns, 2};
    shell_rig r;
    begin(&r, &t);
    vbss_shell_input in = shell_rig_input(&r);
    in.thickness = 1.0;
    for (uint32_t i = 0; i < r.triangle_count; i++) {
        r.widths[i] = 2.0 * pi / columns;
    }
    in.angular_widths = corrected ? r.widths : NULL;
    shell_rig_start(&r, &in);
    hold_axes(&r, &t);
    double share = 2.0 / columns, w = 0.0;
    for (uint32_t c = 0; c < columns; c++) {
        double wave = vbss_cos(4.0 * pi * c / columns);
        for (uint32_t k = 0; k <= t.rows; k++) {
            double force = load * t.length * row_share(&t, k) * (pi * radius * share) * wave;
            r.load[node_at(&t, c, k)] = vec3_scale(outward(&t, c), force);
        }
    }
    assert_int_equal(1, shell_rig_solve(&r, 1));
    for (uint32_t c = 0; c < columns; c++) {
        double wave = vbss_cos(4.0 * pi * c / columns);
        for (uint32_t k = 0; k <= t.rows; k++) {
            uint32_t i = node_at(&t, c, k);
            vec3 moved = vec3_sub(r.x[i], r.rest[i]);
            w += share * wave * vec3_dot(moved, outward(&t, c)) / (t.rows + 1);
        }
    }
    shell_rig_end(&r);
    double r2 = radius * radius;
    return w / (load * r2 * r2 / 9.0 * 12.0 * (1.0 + 4.0 / (12.0 * r2)));
}

static void ovalling_ring_is_accurate_on_coarse_meshes(void **state)
{
    (void)state;
    expect_near(1.0, ovalled_ratio(12, true), 0.07);
    expect_near(1.0, ovalled_ratio(24, true), 0.02);
    expect_near(1.0, ovalled_ratio(48, true), 0.005);
    expect_near(1.0, ovalled_ratio(192, true), 0.0005);
}

static void missing_correction_is_too_soft(void **state)
{
    (void)state;
    expect_near(1.345, ovalled_ratio(12, false), 0.01);
    expect_near(1.08, ovalled_ratio(24, false), 0.01);
    expect_near(1.0, ovalled_ratio(192, false), 0.002);
}

/* ---- under pressure, with open ends: hoop strain p R / (E t), and -nu of it along the axis */

static void pressurised_tube_widens_and_shortens(void **state)
{
    (void)state;
    const tube t = {1.0, 0.5, 48, 3};
    const double nu = 0.47, pressure = 1e-9;
    shell_rig r;
    begin(&r, &t);
    vbss_shell_input in = shell_rig_input(&r);
    in.poisson = nu;
    in.thickness = 0.01;
    shell_rig_start(&r, &in);
    hold_axes(&r, &t);
    double chord = 2.0 * vbss_sin(pi / t.columns) * vbss_cos(pi / t.columns);
    for (uint32_t c = 0; c < t.columns; c++) {
        for (uint32_t k = 0; k <= t.rows; k++) {
            double force = pressure * t.length * row_share(&t, k) * chord;
            r.load[node_at(&t, c, k)] = vec3_scale(outward(&t, c), force);
        }
    }
    assert_int_equal(1, shell_rig_solve(&r, 1));
    double wider = 0.0, longer = 0.0, hoop = pressure / in.thickness;
    for (uint32_t c = 0; c < t.columns; c++) {
        uint32_t low = node_at(&t, c, 0), high = node_at(&t, c, t.rows);
        longer += (r.x[high].z - r.x[low].z - t.length) / (t.length * t.columns);
        for (uint32_t k = 0; k <= t.rows; k++) {
            wider += (vec3_dot(r.x[low + k], outward(&t, c)) - 1.0) / r.own_count;
        }
    }
    expect_near(hoop, wider, 0.002 * hoop);
    expect_near(-nu * hoop, longer, 0.002 * hoop);
    shell_rig_energy(&r);
    for (uint32_t i = 0; i < r.triangle_count; i++) { /* the pull around, in any axes */
        expect_near(pressure, r.states[i].membrane_force[0] + r.states[i].membrane_force[1],
                    0.02 * pressure);
    }
    shell_rig_end(&r);
}

int test_shell_rings(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pulled_ring_opens_as_theory),
        cmocka_unit_test(ovalling_ring_is_accurate_on_coarse_meshes),
        cmocka_unit_test(missing_correction_is_too_soft),
        cmocka_unit_test(pressurised_tube_widens_and_shortens),
    };
    return cmocka_run_group_tests_name("drain.shell_rings", tests, NULL, NULL);
}
