/* Columns of 30 mm of the paper's thread: when they buckle, and what they are afterwards. */
#include <math.h>

#include "thread/rig.h"

enum { MAX_NODES = 65 };

static const double pi = 0x1.921fb54442d18p1;
static const double length = 0.03, bending_stiffness = 1e-8, weight = 6.4e-5 * 9.81; /* N/m */

/* ---- growth of a small deflection: its sign tells which side of the threshold a load is */

typedef enum column {
    CLAMPED_FREE,    /* load: N, on the free end */
    PINNED,          /* load: N, by shortening between the pins */
    UNDER_OWN_WEIGHT /* load: length, m */
} column;

static double largest_aside(rig *r)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < r->nodes; i++) {
        vec3 x = rig_position(r, i);
        largest = fmax(largest, hypot(x.y, x.z));
    }
    return largest;
}

static void deflect(rig *r, column kind, double shortening)
{
    vec3 x[MAX_NODES];
    rig_read(r, VBSS_THREAD_VIEW_POSITIONS, x);
    for (uint32_t i = 0; i < r->nodes; i++) {
        double s = (double)i / (r->nodes - 1);
        double aside = 1e-9 * (kind == PINNED ? sin(pi * s) : 1.0 - cos(0.5 * pi * s));
        x[i].x *= 1.0 - shortening;
        x[i].y = 0.6 * aside;
        x[i].z = 0.8 * aside;
    }
    rig_place(r, x, NULL);
}

static bool grows(column kind, double load, uint32_t segments, vbss_thread_bending bending)
{
    vbss_thread_config c = rig_config(kind == UNDER_OWN_WEIGHT ? load : length, segments);
    c.bending = bending;
    c.drag = 150.0;
    c.spectral_radius = 0.0;
    c.gravity[0] = kind == UNDER_OWN_WEIGHT ? -9.81 : 0.0;
    c.gravity[1] = 0.0;
    c.axial_stiffness = kind == PINNED ? 10.0 : c.axial_stiffness; /* softer: the way is longer */
    rig r;
    rig_begin(&r, &c);
    deflect(&r, kind, kind == PINNED ? load / c.axial_stiffness : 0.0);
    if (kind == PINNED) {
        rig_pin_here(&r, 0);
        rig_pin_here(&r, segments);
    } else {
        rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    }
    if (kind == CLAMPED_FREE) {
        rig_force(&r, segments, vec3_make(-load, 0.0, 0.0));
    }
    rig_run(&r, 0.01, 40); /* until only the slowest mode is left */
    double before = largest_aside(&r);
    rig_run(&r, 0.01, 20);
    double after = largest_aside(&r);
    rig_end(&r);
    return after > before;
}

static double threshold(column kind, double expected, uint32_t segments,
                        vbss_thread_bending bending)
{
    double low = 0.9 * expected, high = 1.1 * expected;
    assert_false(grows(kind, low, segments, bending));
    assert_true(grows(kind, high, segments, bending));
    for (int k = 0; k < 14; k++) {
        double middle = 0.5 * (low + high);
        *(grows(kind, middle, segments, bending) ? &high : &low) = middle;
    }
    return 0.5 * (low + high);
}

static void check_threshold(column kind, double expected, double spline, double local)
{
    double with_spline = threshold(kind, expected, 16, VBSS_THREAD_BENDING_SPLINE);
    double with_local = threshold(kind, expected, 16, VBSS_THREAD_BENDING_LOCAL);
    expect_near(1.0, with_spline / expected, spline);
    expect_near(1.0, with_local / expected, local);
}

static void clamped_column_buckles_at_euler_load(void **state)
{
    (void)state;
    double euler = pi * pi * bending_stiffness / (4.0 * length * length);
    expect_near(2.7416e-5, euler, 1e-9);
    check_threshold(CLAMPED_FREE, euler, 2e-5, 1.5e-3);
}

static void pinned_column_carries_four_times_euler_load(void **state)
{
    (void)state;
    check_threshold(PINNED, pi * pi * bending_stiffness / (length * length), 3e-5, 5e-3);
}

static void fifty_millimetre_thread_buckles(void **state)
{
    (void)state;
    double critical = cbrt(7.8373474 * bending_stiffness / weight);
    expect_near(0.049977, critical, 1e-6);
    check_threshold(UNDER_OWN_WEIGHT, critical, 2e-5, 2.5e-4);
}

/* ---- far beyond the threshold */

static vec3 tip_of_upright(double upright)
{
    vbss_thread_config c = rig_config(upright, 20);
    c.gravity[0] = -9.81;
    c.gravity[1] = 0.0;
    c.drag = 60.0;
    rig r;
    rig_begin(&r, &c);
    rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    uint32_t push = rig_force(&r, 20, vec3_make(0.0, 1e-6, 0.0));
    rig_run(&r, 0.01, 10);
    rig_move(&r, push, vec3_zero());
    rig_relax(&r, 0.01, 1e-7, 1500);
    vec3 tip = rig_tip(&r);
    rig_end(&r);
    return tip;
}

static void short_thread_recovers_and_long_one_falls(void **state)
{
    (void)state;
    vec3 upright = tip_of_upright(0.042), fallen = tip_of_upright(0.06);
    expect_near(0.042, upright.x, 1e-6);
    assert_true(fallen.y > 0.03);
    assert_true(fallen.x < 0.03);
}

/* Complete elliptic integrals of modulus k, by the arithmetic-geometric mean. */
static void elliptic(double k, double *first, double *second)
{
    double a = 1.0, b = sqrt(1.0 - k * k), c = k, sum = 0.5 * c * c;
    double power = 1.0;
    while (fabs(c) > 1e-17) {
        double next = 0.5 * (a + b);
        c = 0.5 * (a - b);
        b = sqrt(a * b);
        a = next;
        sum += power * c * c;
        power *= 2.0;
    }
    *first = 0.5 * pi / a;
    *second = *first * (1.0 - sum);
}

/* Euler's elastica between pins: shortening 2 (1 - E/K), load (2 K)^2, height k / K. */
static void buckled_shape_is_euler_elastica(void **state)
{
    (void)state;
    const double moduli[] = {0.2, 0.5, 0.8};
    for (int m = 0; m < 3; m++) {
        double first, second, k = moduli[m];
        elliptic(k, &first, &second);
        double distance = length * (2.0 * second / first - 1.0);
        vbss_thread_config c = rig_config(length, 32);
        c.gravity[1] = 0.0;
        c.drag = 500.0;
        c.spectral_radius = 0.0;
        rig r;
        rig_begin(&r, &c);
        vec3 x[MAX_NODES];
        for (uint32_t i = 0; i <= 32; i++) {
            double s = i / 32.0;
            x[i] = vec3_make(distance * s, length * k / first * sin(pi * s), 0.0);
        }
        rig_place(&r, x, NULL);
        rig_pin_here(&r, 0);
        uint32_t pin = rig_pin_here(&r, 32);
        rig_relax(&r, 0.01, 1e-11, 300);
        vec3 push = rig_reaction_force(&r, pin);
        double load = 4.0 * first * first * bending_stiffness / (length * length);
        vec3 middle = rig_position(&r, 16);
        expect_near(1.0, -push.x / load, 1e-4);
        expect_near(0.0, push.y / load, 1e-9);
        expect_near(0.5 * distance, middle.x, 1e-9);
        /* It may snap to the other side on its way from the sine that it starts as. */
        expect_near(1.0, fabs(middle.y) * first / (k * length), 5e-5);
        rig_end(&r);
    }
}

int test_buckling(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clamped_column_buckles_at_euler_load),
        cmocka_unit_test(pinned_column_carries_four_times_euler_load),
        cmocka_unit_test(fifty_millimetre_thread_buckles),
        cmocka_unit_test(short_thread_recovers_and_long_one_falls),
        cmocka_unit_test(buckled_shape_is_euler_elastica),
    };
    return cmocka_run_group_tests_name("thread.buckling", tests, NULL, NULL);
}
