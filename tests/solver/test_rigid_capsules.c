#include <math.h>
#include <string.h>

#include "solver/rigid_rig.h"

static const double pi = 3.14159265358979323846;

static vbss_rigid_mass mass_of(const vbss_rigid_capsule *capsules, uint32_t count)
{
    vbss_rigid_mass m;
    assert_true(vbss_rigid_mass_of_capsules(capsules, count, &m));
    vbss_rigid body = {.mass = m.mass,
                       .inertia = m.inertia,
                       .now.pose = m.frame,
                       .target_start = m.frame,
                       .target_end = m.frame};
    assert_true(vbss_rigid_is_valid(&body));
    return m;
}

static void expect_moments(double x, double y, double z, const vbss_rigid_mass *m, double tolerance)
{
    double largest = fmax(x, fmax(y, z));
    expect_near(x, m->inertia.x, tolerance * largest);
    expect_near(y, m->inertia.y, tolerance * largest);
    expect_near(z, m->inertia.z, tolerance * largest);
}

static void expect_axes_of_the_frame(const vbss_rigid_mass *m)
{
    const quat identity = quat_identity();
    assert_memory_equal(&identity, &m->frame.orientation, sizeof identity);
}

/* ---- known ones */

static void zero_length_capsule_is_ball(void **state)
{
    (void)state;
    vbss_rigid_capsule ball = {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, 0.02, 1000.0};
    vbss_rigid_mass m = mass_of(&ball, 1);
    double mass = 1000.0 * 4.0 / 3.0 * pi * 8e-6, moment = 0.4 * mass * 4e-4;
    expect_near(mass, m.mass, 1e-15 * mass);
    expect_moments(moment, moment, moment, &m, 1e-15);
    expect_near(0.0, vec3_distance(m.frame.position, ball.a), 0.0);
}

static void thin_capsule_is_rod(void **state)
{
    (void)state;
    vbss_rigid_capsule rod = {{-0.15, 0.0, 0.0}, {0.15, 0.0, 0.0}, 1e-5, 8000.0};
    vbss_rigid_mass m = mass_of(&rod, 1);
    double moment = m.mass * 0.3 * 0.3 / 12.0;
    expect_near(8000.0 * pi * 1e-10 * 0.3, m.mass, 1e-4 * m.mass);
    expect_moments(0.5e-10 * m.mass, moment, moment, &m, 2e-4);
    expect_near(0.5e-10 * m.mass, m.inertia.x, 1e-4 * m.inertia.x);
    expect_axes_of_the_frame(&m);
}

/* Half balls: twice the moment of a whole one less the parallel axis is not what a half has. */
static void short_capsule_matches_closed_form(void **state)
{
    (void)state;
    /* r = 1, l = 2, density 1/pi: cylinder 2, ball 4/3. */
    vbss_rigid_capsule c = {{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 1.0, 1.0 / pi};
    vbss_rigid_mass m = mass_of(&c, 1);
    double across = 2.0 * (4.0 / 12.0 + 0.25) + 4.0 / 3.0 * (0.4 + 1.0 + 0.75);
    expect_near(10.0 / 3.0, m.mass, 1e-15);
    expect_moments(across, across, 1.0 + 1.6 / 3.0, &m, 1e-15);
    expect_axes_of_the_frame(&m);
}

static void two_capsules_make_cross(void **state)
{
    (void)state;
    vbss_rigid_capsule cross[2] = {{{-0.5, 0.2, 0.1}, {0.5, 0.2, 0.1}, 0.1, 100.0},
                                   {{0.0, -0.3, 0.1}, {0.0, 0.7, 0.1}, 0.1, 100.0}};
    vbss_rigid_mass one = mass_of(cross, 1), m = mass_of(cross, 2);
    double along = one.inertia.x, across = one.inertia.y;
    expect_near(2.0 * one.mass, m.mass, 1e-13);
    expect_moments(along + across, along + across, 2.0 * across, &m, 1e-15);
    expect_near(0.0, vec3_distance(m.frame.position, vec3_make(0.0, 0.2, 0.1)), 1e-16);
    expect_axes_of_the_frame(&m);
}

static void overlaps_count_twice(void **state)
{
    (void)state;
    vbss_rigid_capsule c = {{0.0, 0.1, 0.0}, {0.3, 0.2, 0.1}, 0.02, 700.0};
    vbss_rigid_capsule same[2] = {c, c};
    vbss_rigid_mass one = mass_of(&c, 1), two = mass_of(same, 2);
    expect_near(2.0 * one.mass, two.mass, 1e-15);
    expect_moments(2.0 * one.inertia.x, 2.0 * one.inertia.y, 2.0 * one.inertia.z, &two, 1e-14);
}

static void slender_shaft_axis_is_found(void **state)
{
    (void)state;
    vec3 direction = vec3_unit_or(vec3_make(0.3, -0.5, 0.7), vec3_zero());
    vbss_rigid_capsule shaft = {
        {0.4, 0.5, 0.6}, vec3_add_scaled(vec3_make(0.4, 0.5, 0.6), 0.3, direction), 0.0025, 7800.0};
    vbss_rigid_capsule plain = {{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, 0.0025, 7800.0};
    vbss_rigid_mass m = mass_of(&shaft, 1), wanted = mass_of(&plain, 1);
    const double moments[3] = {m.inertia.x, m.inertia.y, m.inertia.z};
    int smallest = moments[0] < moments[1] ? 0 : 1;
    smallest = moments[2] < moments[smallest] ? 2 : smallest;
    vec3 axis =
        quat_rotate(m.frame.orientation, vec3_make(smallest == 0, smallest == 1, smallest == 2));
    expect_near(1.0, fabs(vec3_dot(axis, direction)), 1e-15);
    expect_near(wanted.inertia.x, moments[smallest], 1e-12 * wanted.inertia.x);
    expect_near(wanted.inertia.y, moments[(smallest + 1) % 3], 1e-14 * wanted.inertia.y);
    expect_near(wanted.inertia.y, moments[(smallest + 2) % 3], 1e-14 * wanted.inertia.y);
}

/* ---- any, against slices: discs of thickness ds whose own moments are those of a disc */

typedef struct sums {
    double mass;
    vec3 first;
    mat3 second; /* of x x^T */
} sums;

static void add_disc(sums *s, const vbss_rigid_capsule *c, vec3 axis, double at, double weight)
{
    double l = vec3_distance(c->a, c->b);
    double beyond = at < 0.0 ? -at : at > l ? at - l : 0.0;
    double square = c->radius * c->radius - beyond * beyond;
    double mass = c->density * pi * square * weight;
    vec3 middle = vec3_add_scaled(c->a, at, axis);
    mat3 across = mat3_sub(mat3_identity(), mat3_outer(axis, axis));
    s->mass += mass;
    s->first = vec3_add_scaled(s->first, mass, middle);
    s->second = mat3_add_scaled(s->second, mass, mat3_outer(middle, middle));
    s->second = mat3_add_scaled(s->second, 0.25 * mass * square, across);
}

/* Simpson's rule over one of the three pieces. */
static void add_piece(sums *s, const vbss_rigid_capsule *c, double from, double to)
{
    enum { INTERVALS = 200 };
    vec3 axis = vec3_unit_or(vec3_sub(c->b, c->a), vec3_make(0.0, 1.0, 0.0));
    double step = (to - from) / INTERVALS;
    for (int i = 0; i <= INTERVALS; i++) {
        double weight = i == 0 || i == INTERVALS ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        add_disc(s, c, axis, from + step * i, weight * step / 3.0);
    }
}

static sums sums_of(const vbss_rigid_capsule *capsules, uint32_t count)
{
    sums s = {0.0, vec3_zero(), mat3_zero()};
    for (uint32_t i = 0; i < count; i++) {
        const vbss_rigid_capsule *c = &capsules[i];
        double l = vec3_distance(c->a, c->b);
        add_piece(&s, c, -c->radius, 0.0);
        add_piece(&s, c, 0.0, l);
        add_piece(&s, c, l, l + c->radius);
    }
    return s;
}

static void any_capsules(harness_source *source, void *user)
{
    (void)user;
    vbss_rigid_capsule capsules[4];
    uint32_t count = 1 + harness_draw_below(source, 4);
    for (uint32_t i = 0; i < count; i++) {
        vbss_rigid_capsule *c = &capsules[i];
        c->a = harness_draw_vec3(source, -0.5, 0.5);
        c->b = harness_draw_below(source, 5) == 0 ? c->a : harness_draw_vec3(source, -0.5, 0.5);
        c->radius = harness_draw_real(source, 0.01, 0.5);
        c->density = harness_draw_real(source, 1.0, 1000.0);
    }
    vbss_rigid_mass m = mass_of(capsules, count);
    sums s = sums_of(capsules, count);
    vec3 centre = vec3_scale(s.first, 1.0 / s.mass);
    expect_near(s.mass, m.mass, 1e-9 * s.mass);
    expect_near(0.0, vec3_distance(centre, m.frame.position), 1e-9);
    mat3 second = mat3_add_scaled(s.second, -s.mass, mat3_outer(centre, centre));
    double trace = second.m[0][0] + second.m[1][1] + second.m[2][2];
    mat3 wanted = mat3_sub(mat3_diagonal(trace, trace, trace), second);
    mat3 axes = quat_to_mat3(m.frame.orientation);
    mat3 seen = mat3_mul(mat3_transpose(axes), mat3_mul(wanted, axes));
    mat3 own = mat3_diagonal(m.inertia.x, m.inertia.y, m.inertia.z);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            expect_near(own.m[i][j], seen.m[i][j], 1e-9 * trace);
        }
    }
    expect_near(1.0, quat_dot(m.frame.orientation, m.frame.orientation), 1e-15);
}

static void inertia_matches_slices_for_any_capsules(void **state)
{
    (void)state;
    harness_property("capsules", 200, any_capsules, NULL);
}

/* No product of inertia is left, to rounding, for the nastiest of tensors too: those with equal moments. */
static void axes_are_principal_to_rounding(harness_source *source, void *user)
{
    (void)user;
    vbss_rigid_capsule capsules[3], far[3];
    quat q = harness_draw_unit_quat(source);
    double arm = harness_draw_real(source, 0.1, 1.0);
    for (int i = 0; i < 3; i++) { /* three alike at right angles: a ball's moments */
        vec3 half = quat_rotate(q, vec3_scale(vec3_make(i == 0, i == 1, i == 2), arm));
        capsules[i] = (vbss_rigid_capsule){vec3_neg(half), half, 0.1, 100.0};
        far[i] = capsules[i];
        far[i].a = vec3_add(far[i].a, vec3_make(1000.0, -1000.0, 1000.0));
        far[i].b = vec3_add(far[i].b, vec3_make(1000.0, -1000.0, 1000.0));
    }
    vbss_rigid_mass m = mass_of(capsules, 3), there = mass_of(far, 3);
    expect_moments(m.inertia.x, m.inertia.x, m.inertia.x, &m, 1e-14);
    expect_moments(m.inertia.x, m.inertia.y, m.inertia.z, &there, 1e-11);
    assert_true(mass_of(capsules, 2).mass < m.mass);
}

static void equal_moments_are_found_in_any_pose(void **state)
{
    (void)state;
    harness_property("equal moments", 50, axes_are_principal_to_rounding, NULL);
}

/* ---- refused */

static void massless_bodies_are_rejected(void **state)
{
    (void)state;
    vbss_rigid_mass m, before;
    const vbss_rigid_capsule good = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, 0.01, 1000.0};
    memset(&m, 0x55, sizeof m);
    before = m;
    vbss_rigid_capsule bad[] = {good, good, good, good, good, good};
    bad[0].radius = 0.0;
    bad[1].density = 0.0;
    bad[2].density = -1.0;
    bad[3].radius = harness_bad_numbers[0];
    bad[4].b.y = harness_bad_numbers[0];
    bad[5].a.x = harness_bad_numbers[1];
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_false(vbss_rigid_mass_of_capsules(&bad[i], 1, &m));
    }
    assert_false(vbss_rigid_mass_of_capsules(&good, 0, &m));
    for (int axis = 0; axis < 3; axis++) { /* mass is left, but about one axis nothing to turn */
        vbss_rigid_capsule hollow[3] = {{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.1, 1000.0}};
        for (int i = 1; i < 3; i++) {
            int k = (axis + i) % 3;
            vec3 half = vec3_make(k == 0 ? 0.5 : 0.0, k == 1 ? 0.5 : 0.0, k == 2 ? 0.5 : 0.0);
            hollow[i] = (vbss_rigid_capsule){vec3_neg(half), half, 0.01, -400.0};
        }
        assert_false(vbss_rigid_mass_of_capsules(hollow, 3, &m));
    }
    assert_memory_equal(&m, &before, sizeof m);
}

int test_rigid_capsules(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(zero_length_capsule_is_ball),
        harness_test(thin_capsule_is_rod),
        harness_test(short_capsule_matches_closed_form),
        harness_test(two_capsules_make_cross),
        harness_test(overlaps_count_twice),
        harness_test(slender_shaft_axis_is_found),
        harness_test(inertia_matches_slices_for_any_capsules),
        harness_test(equal_moments_are_found_in_any_pose),
        harness_test(massless_bodies_are_rejected),
    };
    return cmocka_run_group_tests_name("solver.rigid_capsules", tests, NULL, NULL);
}
