/* Shapes that clamps and rest curvature give a thread that weighs nothing, and clamps inside it. */
#include <math.h>

#include "thread/elastica.h"
#include "thread/reference.h"
#include "thread/rig.h"

static const double pi = 0x1.921fb54442d18p1;
static const double bending_stiffness = 1e-8;

static vbss_thread_config weightless(double length, uint32_t segments, vbss_thread_bending bending)
{
    vbss_thread_config c = rig_config(length, segments);
    c.bending = bending;
    c.gravity[1] = 0.0;
    c.drag = 150.0;
    c.spectral_radius = 0.0;
    return c;
}

/* ---- clamps at both ends */

/* Moves the far clamp along the ends of ever more curved arcs, to that angle. */
static void wind_up(rig *r, uint32_t clamp, double length, double angle)
{
    enum { STEPS = 40 };
    for (int k = 1; k <= STEPS; k++) {
        double turned = angle * k / STEPS, to[3];
        double direction[3] = {cos(turned), sin(turned), 0.0};
        vec3_store(to, on_circle(turned / length, length));
        expect_ok(vbss_thread_set_attachment_target(r->thread, clamp, to, direction));
        rig_run(r, 0.01, 1);
    }
    rig_relax(r, 0.02, 1e-9, 200);
}

/* A quarter of a turn to a whole one: no force, EI times the curvature at either end. */
static void opposed_clamps_make_arc(void **state)
{
    (void)state;
    const struct {
        vbss_thread_bending bending;
        double shape[4], force[4], torque[4], energy[4]; /* bounds, by quarters of a turn */
    } cases[] = {
        {VBSS_THREAD_BENDING_SPLINE,
         {3e-6, 2.5e-5, 8e-5, 2e-4},
         {1.2e-4, 6e-5, 5e-4, 1.5e-3},
         {2e-5, 1.2e-4, 9e-4, 2.5e-3},
         {2e-6, 3e-5, 1.3e-4, 4e-4}},
        {VBSS_THREAD_BENDING_LOCAL,
         {7e-4, 1.3e-3, 1.6e-3, 3e-3},
         {6e-2, 1.5e-3, 1.5e-2, 2.5e-2},
         {1.3e-2, 6e-3, 2e-3, 6e-3},
         {9e-4, 4e-3, 8e-3, 1.5e-2}},
    };
    const double length = 0.06;
    for (int i = 0; i < 8; i++) {
        int q = i % 4;
        double curvature = 0.5 * pi * (q + 1) / length;
        vbss_thread_config c = weightless(length, 16, cases[i / 4].bending);
        rig r;
        rig_begin(&r, &c);
        uint32_t near = rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        uint32_t far = rig_clamp_here(&r, 16, vec3_make(1.0, 0.0, 0.0));
        wind_up(&r, far, length, curvature * length);
        for (uint32_t n = 0; n <= 16; n++) {
            vec3 wanted = on_circle(curvature, length * n / 16.0);
            expect_near_vec3(wanted, rig_position(&r, n), length * cases[i / 4].shape[q]);
        }
        double moment = bending_stiffness * curvature, energy = 0.5 * moment * curvature * length;
        double force = vec3_norm(rig_reaction_force(&r, far)) / (moment * curvature);
        expect_near(0.0, force, cases[i / 4].force[q]);
        expect_near(-1.0, rig_reaction_torque(&r, near).z / moment, cases[i / 4].torque[q]);
        expect_near(1.0, rig_reaction_torque(&r, far).z / moment, cases[i / 4].torque[q]);
        expect_near(1.0, rig_energies(&r).bending / energy, cases[i / 4].energy[q]);
        rig_end(&r);
    }
}

/* The position a quarter along, the same after half a turn about the middle. */
static vec3 damped_s(uint32_t segments, vbss_thread_bending bending)
{
    const double length = 0.06;
    const vec3 end = {0.9 * length, 0.42 * length, 0.0};
    vbss_thread_config c = weightless(length, segments, bending);
    rig r;
    rig_begin(&r, &c);
    uint32_t near = rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    uint32_t far = rig_clamp_here(&r, segments, vec3_make(1.0, 0.0, 0.0));
    vec3 start = vec3_make(length, 0.0, 0.0);
    for (int k = 1; k <= 40; k++) {
        rig_move(&r, far, vec3_lerp(start, end, k / 40.0));
        rig_run(&r, 0.01, 1);
    }
    rig_relax(&r, 0.02, 1e-9, 400);
    for (uint32_t i = 0; i <= segments; i++) {
        vec3 opposite = vec3_sub(end, rig_position(&r, segments - i));
        expect_near_vec3(opposite, rig_position(&r, i), 1e-10);
    }
    vec3 pull = rig_reaction_force(&r, far), hold = rig_reaction_force(&r, near);
    vec3 turn = rig_reaction_torque(&r, far);
    expect_near_vec3(vec3_scale(pull, -1.0), hold, 1e-8 * vec3_norm(pull));
    expect_near_vec3(rig_reaction_torque(&r, near), turn, 1e-6 * vec3_norm(turn));
    expect_near_vec3(vec3_scale(vec3_cross(end, pull), -0.5), turn, 1e-6 * vec3_norm(turn));
    vec3 quarter = rig_position(&r, segments / 4);
    rig_end(&r);
    return vec3_scale(quarter, 1.0 / length);
}

static void parallel_clamps_make_symmetric_s(void **state)
{
    (void)state;
    vec3 exact = damped_s(96, VBSS_THREAD_BENDING_SPLINE);
    expect_near(0.0, vec3_distance(exact, damped_s(24, VBSS_THREAD_BENDING_SPLINE)), 7e-5);
    expect_near(0.0, vec3_distance(exact, damped_s(24, VBSS_THREAD_BENDING_LOCAL)), 1e-3);
}

/* All nodes on a circle, clamped at the ends, 1 to 8 segments: what the shortest stretches know. */
static void short_arc_energy_is_of_its_curvature(void **state)
{
    (void)state;
    const double curvature = 20.0, segment = 0.002;
    for (uint32_t i = 0; i < 16; i++) {
        uint32_t n = 1 + i / 2;
        vbss_thread_bending bending =
            i % 2 == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
        vbss_thread_config c = weightless(segment * n, n, bending);
        c.attachment_capacity = n + 1;
        c.axial_stiffness = 1.0;
        rig r;
        rig_begin(&r, &c);
        vec3 x[9];
        for (uint32_t k = 0; k <= n; k++) {
            x[k] = on_circle(curvature, segment * k);
        }
        rig_place(&r, x, NULL);
        double angle = curvature * segment * n;
        uint32_t near = rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        uint32_t far = rig_clamp_here(&r, n, vec3_make(cos(angle), sin(angle), 0.0));
        for (uint32_t k = 1; k < n; k++) {
            rig_pin_here(&r, k);
        }
        rig_run(&r, 1e-3, 1);
        double moment = bending_stiffness * curvature;
        expect_near(1.0, rig_energies(&r).bending / (0.5 * moment * angle), 3e-4);
        expect_near(-1.0, rig_reaction_torque(&r, near).z / moment, 6e-4);
        expect_near(1.0, rig_reaction_torque(&r, far).z / moment, 6e-4);
        /* SPLINE knows that the chord is shorter than the arc, a force that neighbouring arcs share. The moment that turns
         * with the arc adds its part. */
        double stretching = i % 2 == 0 ? 0.0 : -6.67e-5;
        expect_near(stretching + moment * curvature, rig_tension(&r, 0), i % 2 == 0 ? 1e-7 : 2e-6);
        rig_end(&r);
    }
}

/* Towards the centre, one over the radius long; segments of 1 to 4 mm. */
static void curvature_of_uneven_segments_is_of_circle(void **state)
{
    (void)state;
    const double curvature = 20.0, rest_lengths[6] = {1e-3, 4e-3, 2e-3, 1e-3, 3e-3, 3e-3};
    vbss_thread_config c = weightless(1.0, 6, VBSS_THREAD_BENDING_SPLINE);
    c.rest_lengths = rest_lengths;
    rig r;
    rig_begin(&r, &c);
    vec3 x[7] = {{0.0, 0.0, 0.0}};
    double s = 0.0;
    for (uint32_t k = 1; k <= 6; k++) {
        x[k] = on_circle(curvature, s += rest_lengths[k - 1]);
    }
    rig_place(&r, x, NULL);
    rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    for (uint32_t k = 0; k < 6; k++) {
        vec3 centre = vec3_sub(vec3_make(0.0, 1.0 / curvature, 0.0), x[k]);
        vec3 wanted = vec3_scale(centre, curvature * curvature);
        expect_near_vec3(wanted, rig_curvature(&r, k), 0.03 * curvature);
    }
    expect_near_vec3(vec3_zero(), rig_curvature(&r, 6), 0.0); /* a free end */
    rig_end(&r);
}

/* ---- clamps inside */

/* F a^3 b^3 / (3 EI (a + b)^3) under a force between two clamps 2 to 8 segments apart. */
static void short_stretch_is_as_stiff_as_beam(void **state)
{
    (void)state;
    const double spline[] = {1e-6, 1e-6, 3e-6, 4e-2, 3e-2, 2e-2, 1.5e-2};
    const double local[] = {1e-6, 0.15, 0.3, 0.23, 0.18, 0.15, 0.12};
    for (uint32_t i = 0; i < 14; i++) {
        uint32_t apart = 2 + i / 2, low = 6, at = low + apart / 2;
        const double segment = 0.002, force = 1e-7;
        vbss_thread_bending bending =
            i % 2 == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
        vbss_thread_config c = weightless(20 * segment, 20, bending);
        c.drag = 3000.0;
        rig r;
        rig_begin(&r, &c);
        rig_clamp_here(&r, low, vec3_make(1.0, 0.0, 0.0));
        rig_clamp_here(&r, low + apart, vec3_make(1.0, 0.0, 0.0));
        rig_force(&r, at, vec3_make(0.0, force, 0.0));
        rig_relax(&r, 0.01, 1e-13, 400);
        double before = segment * (at - low), behind = segment * (low + apart - at);
        double sag =
            force * pow(before * behind / (before + behind), 3) / (3.0 * bending_stiffness);
        double bound = bending == VBSS_THREAD_BENDING_SPLINE ? spline[i / 2] : local[i / 2];
        expect_near(1.0, rig_position(&r, at).y / sag, bound);
        /* Nothing passes a clamp. */
        expect_near_vec3(vec3_make(20 * segment, 0.0, 0.0), rig_tip(&r), 1e-15);
        rig_end(&r);
    }
}

static void inner_clamp_holds_two_cantilevers(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        vbss_thread_bending bending =
            i == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
        double bound = i == 0 ? 1e-5 : 1e-3;
        vbss_thread_config c = rig_config(0.12, 60), right = rig_config(0.08, 40),
                           left = rig_config(0.04, 20);
        c.bending = bending;
        c.drag = 40.0;
        c.spectral_radius = 0.0;
        rig r;
        rig_begin(&r, &c);
        uint32_t clamp = rig_clamp_here(&r, 20, vec3_make(1.0, 0.0, 0.0));
        rig_relax(&r, 0.03, 1e-9, 300);
        elastica a = elastica_solve(&right, 0.0), b = elastica_solve(&left, 0.0);
        vec3 tip = rig_tip(&r), other = rig_position(&r, 0);
        expect_near(0.0, hypot(tip.x - 0.04 - a.x, tip.y + a.drop) / 0.08, bound);
        expect_near(0.0, hypot(0.04 - other.x - b.x, other.y + b.drop) / 0.04, bound);
        double moment = a.moment - b.moment;
        expect_near(1.0, rig_reaction_torque(&r, clamp).z / moment, i == 0 ? 3e-5 : 2.5e-3);
        expect_near(a.weight + b.weight, rig_reaction_force(&r, clamp).y, 1e-12);
        rig_end(&r);
    }
}

/* ---- curved at rest */

/* From a little less curved, as without twist a straight place may bend to any side. */
static void curved_rest_shape_becomes_circle(void **state)
{
    (void)state;
    const double length = 0.08, curvature = 60.0;
    const struct {
        vbss_thread_bending bending;
        bool clamped;
        double radius, energy, tip; /* bounds */
    } cases[] = {
        {VBSS_THREAD_BENDING_SPLINE, false, 6e-3, 4e-3, 0.0},
        {VBSS_THREAD_BENDING_LOCAL, false, 1e-6, 2e-6, 0.0},
        {VBSS_THREAD_BENDING_SPLINE, true, 6e-3, 4e-3, 7e-3},
        {VBSS_THREAD_BENDING_LOCAL, true, 3e-5, 1.2e-4, 8e-4},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        vbss_thread_config c = weightless(length, 40, cases[i].bending);
        c.rest_curvature = curvature;
        rig r;
        rig_begin(&r, &c);
        vec3 x[41];
        for (uint32_t n = 0; n <= 40; n++) {
            x[n] = on_circle(0.8 * curvature, length * n / 40.0);
        }
        rig_place(&r, x, NULL);
        if (cases[i].clamped) {
            rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        }
        /* Slowly, lest it swing through straight. */
        rig_run(&r, 1e-3, 20);
        rig_run(&r, 0.01, 50);
        rig_relax(&r, 0.1, 1e-7, 400);
        vec3 a = rig_position(&r, 0), b = rig_position(&r, 20), end = rig_tip(&r);
        double sides = vec3_distance(a, b) * vec3_distance(b, end) * vec3_distance(a, end);
        double area = vec3_norm(vec3_cross(vec3_sub(b, a), vec3_sub(end, a)));
        expect_near(1.0, curvature * sides / (2.0 * area), cases[i].radius);
        double straight = 0.5 * bending_stiffness * curvature * curvature * length;
        expect_near(0.0, rig_energies(&r).bending / straight, cases[i].energy);
        if (cases[i].clamped) {
            vec3 wanted = on_circle(curvature, length);
            expect_near(0.0, vec3_distance(wanted, end) / length, cases[i].tip);
        }
        rig_end(&r);
    }
}

int test_shapes(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opposed_clamps_make_arc),
        cmocka_unit_test(parallel_clamps_make_symmetric_s),
        cmocka_unit_test(short_arc_energy_is_of_its_curvature),
        cmocka_unit_test(curvature_of_uneven_segments_is_of_circle),
        cmocka_unit_test(short_stretch_is_as_stiff_as_beam),
        cmocka_unit_test(inner_clamp_holds_two_cantilevers),
        cmocka_unit_test(curved_rest_shape_becomes_circle),
    };
    return cmocka_run_group_tests_name("thread.shapes", tests, NULL, NULL);
}
