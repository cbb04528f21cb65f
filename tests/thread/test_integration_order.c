/* Method IMPLICIT: the integration in time, as a thread makes it: order, starts, what it does exactly. */
#include <math.h>

#include "thread/reference.h"
#include "thread/rig.h"
#include "thread/thread.h"

enum { SEGMENTS = 6, NODES = SEGMENTS + 1 };

/* ---- order: a soft thread swings from a pin, all its frequencies are followed */

typedef enum start { ONCE, NOW_AND_THEN, NEVER_SECOND_ORDER } start;

static vbss_thread_config soft_config(double spectral_radius, double stiffness)
{
    vbss_thread_config config = rig_config(0.15, SEGMENTS);
    config.spectral_radius = spectral_radius;
    config.axial_stiffness = stiffness;
    config.drag = 2.0;
    config.stretch_tolerance = config.position_tolerance = 1e-12;
    return config;
}

static void swing(const vbss_thread_config *config, start how, uint32_t steps, rig_shape *s)
{
    rig r;
    vec3 v[NODES];
    thread_object *inside;
    rig_begin(&r, config);
    expect_ok(vbss_thread_edit(r.thread, &inside));
    for (int i = 0; i < NODES; i++) {
        v[i] = vec3_make(0.0, -0.2 * i, 0.3 * sin(0.5 * i));
    }
    rig_place(&r, NULL, v);
    rig_pin_here(&r, 0);
    for (uint32_t k = 0; k < steps; k++) {
        if (how == NOW_AND_THEN && k % (steps / 5) == 0) {
            rig_place(&r, NULL, NULL); /* nothing moves, but what was known is forgotten */
        }
        if (how == NEVER_SECOND_ORDER) {
            inside->damped_steps_left = 2; /* as after a try that failed */
        }
        rig_run(&r, 0.1 / steps, 1);
    }
    *s = rig_shape_of(&r);
    vbss_thread_statistics statistics = rig_statistics(&r);
    const uint64_t first_order[] = {1, 5, statistics.substeps};
    assert_int_equal(first_order[how], statistics.first_order);
    assert_int_equal(0, statistics.rejections);
    rig_end(&r);
}

/* Orders of position, velocity, tension, from three runs. */
static vec3 orders(const vbss_thread_config *config, start how, uint32_t steps)
{
    rig_shape s[3];
    for (int k = 0; k < 3; k++) {
        swing(config, how, steps << k, &s[k]);
    }
    vec3 coarse = rig_difference(&s[0], &s[1]), fine = rig_difference(&s[1], &s[2]);
    return vec3_make(log2(coarse.x / fine.x), log2(coarse.y / fine.y), log2(coarse.z / fine.z));
}

static void generalised_alpha_is_second_order(void **state)
{
    (void)state;
    for (int k = 0; k < 6; k++) {
        vbss_thread_config config = soft_config(0.5 * (k % 3), 0.01);
        config.bending = k / 3;
        expect_near_vec3(vec3_make(2.0, 2.0, 2.0), orders(&config, ONCE, 2000), 0.15);
    }
}

static void backward_euler_is_first_order(void **state)
{
    (void)state;
    vbss_thread_config config = soft_config(0.5, 427.0);
    expect_near_vec3(vec3_make(1.0, 1.0, 1.0), orders(&config, NEVER_SECOND_ORDER, 1000), 0.1);
}

static void few_restarts_keep_order(void **state)
{
    (void)state;
    vbss_thread_config config = soft_config(0.5, 427.0);
    expect_near_vec3(vec3_make(2.0, 2.0, 2.0), orders(&config, NOW_AND_THEN, 200), 0.2);
}

/* As under a host that attaches or places something all the time: the motion is one, and what falls
 * from rest has no energy to gain. */
static void restart_in_every_step_is_harmless(void **state)
{
    (void)state;
    const double sizes[] = {1e-3, 0.5e-3, 0.25e-3, 0.125e-3};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        double h = sizes[i];
        rig once, always;
        vbss_thread_config config = rig_config(0.15, 30);
        rig_begin(&once, &config);
        rig_begin(&always, &config);
        rig_pin_here(&once, 0);
        rig_pin_here(&always, 0);
        for (int k = 0; k < 100; k++) {
            rig_place(&always, NULL, NULL);
            rig_run(&always, h, 1);
            expect_near(0.0, fmax(0.0, rig_energies(&always).total), 1e-7);
        }
        rig_run(&once, h, 100);
        expect_near(0.0, vec3_distance(rig_tip(&once), rig_tip(&always)), 2e-3);
        rig_end(&once);
        rig_end(&always);
    }
}

static void stiff_thread_keeps_order(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        vbss_thread_config config = soft_config(0.5, 427.0);
        config.bending = k;
        expect_near_vec3(vec3_make(2.0, 2.0, 2.0), orders(&config, ONCE, 500), 0.1);
    }
}

/* Rest curvature is in the forces only, not in the system: iterated, it must not cost the order. */
static void curved_rest_shape_keeps_order(void **state)
{
    (void)state;
    const double stiffness[] = {0.01, 0.01, 427.0};
    const uint32_t steps[] = {2000, 2000, 200};
    for (int k = 0; k < 3; k++) {
        double curvature = 16.0, l = 0.15 / SEGMENTS, x[3 * NODES];
        vbss_thread_config config = soft_config(0.5, stiffness[k]);
        config.bending = k == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
        config.gravity[1] = 0.0;
        config.rest_curvature = 20.0;
        config.positions = x;
        /* Arcs, or chords, of their rest length: no waves along the thread. */
        double turn = k == 0 ? l * curvature : 2.0 * asin(0.5 * l * curvature);
        for (int i = 0; i < NODES; i++) {
            vec3_store(x + 3 * (size_t)i, on_circle(curvature, turn * i / curvature));
        }
        rig_shape s[3];
        for (uint32_t i = 0; i < 3; i++) {
            rig r;
            uint32_t count = steps[k] << i;
            rig_begin(&r, &config);
            rig_run(&r, 0.1 / count, count);
            s[i] = rig_shape_of(&r);
            rig_end(&r);
        }
        vec3 coarse = rig_difference(&s[0], &s[1]), fine = rig_difference(&s[1], &s[2]);
        expect_near(2.0, log2(coarse.x / fine.x), 0.1);
        expect_near(2.0, log2(coarse.y / fine.y), 0.1);
        expect_near(2.0, log2(coarse.z / fine.z), 0.15);
    }
}

/* ---- exactly */

/* What a start leaves: half g of the square of its first part, h / 64. */
static void free_fall_is_exact(void **state)
{
    (void)state;
    for (int k = 0; k < 6; k++) {
        rig r;
        vec3 x[NODES], v[NODES];
        vbss_thread_config config = rig_config(0.15, SEGMENTS);
        config.bending = k / 3;
        config.spectral_radius = 0.5 * (k % 3);
        rig_begin(&r, &config);
        for (uint32_t i = 0; i < NODES; i++) {
            v[i] = vec3_make(0.5, 2.0, -1.0);
        }
        rig_place(&r, NULL, v);
        double h = 1e-3, first = h / 64.0;
        for (int step = 1; step <= 400; step++) {
            double t = step * h, fallen = 0.5 * 9.81 * (t * t + first * first);
            rig_run(&r, h, 1);
            rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
            rig_read(&r, VBSS_THREAD_VIEW_VELOCITIES, v);
            for (uint32_t i = 0; i < NODES; i++) {
                vec3 wanted = vec3_make(0.15 * i / SEGMENTS + 0.5 * t, 2.0 * t - fallen, -t);
                expect_near_vec3(wanted, x[i], 2e-11);
                expect_near_vec3(vec3_make(0.5, 2.0 - 9.81 * t, -1.0), v[i], 1e-10);
            }
        }
        rig_end(&r);
    }
}

/* ---- drag: v -> g / drag, as exp(-drag t) */

static double drag_error(double h)
{
    rig r;
    double drag = 8.0, worst = 0.0;
    vbss_thread_config config = rig_config(0.15, SEGMENTS);
    config.drag = drag;
    config.spectral_radius = 0.5;
    rig_begin(&r, &config);
    rig_mass(&r, 2, 1e-4); /* falls with it, and is dragged as it is */
    for (int step = 1; step * h <= 1.0; step++) {
        double t = step * h, faded = exp(-drag * t);
        rig_run(&r, h, 1);
        double v = -9.81 / drag * (1.0 - faded);
        double y = -9.81 / drag * (t - (1.0 - faded) / drag);
        for (uint32_t i = 0; i < NODES; i++) {
            worst = fmax(worst, fabs(rig_velocity(&r, i).y - v));
            worst = fmax(worst, fabs(rig_position(&r, i).y - y));
        }
    }
    rig_run(&r, 5e-3, 1000);
    expect_near(-9.81 / drag, rig_velocity(&r, 0).y, 1e-11);
    rig_end(&r);
    return worst;
}

static void drag_limits_fall_speed(void **state)
{
    (void)state;
    double coarse = drag_error(4e-3), fine = drag_error(2e-3);
    expect_near(0.0, fine, 1e-4);
    expect_near(2.0, log2(coarse / fine), 0.1);
}

/* ---- damping: 1 / (1 + damping h) a step, of what is not rigid */

static void damping_rate_is_exact(void **state)
{
    (void)state;
    for (uint32_t segments = 1; segments <= 2; segments++) {
        rig r;
        vbss_thread_config config = rig_config(0.15, segments);
        config.gravity[1] = 0.0;
        config.axial_stiffness = 1e-6; /* hardly any force */
        config.damping = 40.0;
        vec3 v[3] = {{1e-3, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        v[segments] = vec3_neg(v[0]);
        rig_begin(&r, &config);
        rig_place(&r, NULL, v);
        rig_run(&r, 1e-3, 20);
        /* The first step has two parts. */
        double first = (1.0 + 40.0 * 1e-3 / 64.0) * (1.0 + 40.0 * 1e-3 * 63.0 / 64.0);
        expect_near(1e-3 / (first * pow(1.04, 19.0)), rig_velocity(&r, 0).x, 2e-6);
        expect_near(-rig_velocity(&r, 0).x, rig_velocity(&r, segments).x, 1e-10);
        rig_end(&r);
    }
}

/* ---- turning */

static void spun_straight_thread_rotates_rigidly(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        rig r;
        vec3 x[NODES], v[NODES];
        vbss_thread_config config = soft_config(0.5, 427.0);
        config.bending = k;
        config.drag = 0.0;
        config.gravity[1] = 0.0;
        double rate = 20.0, l = 0.15 / SEGMENTS;
        for (int i = 0; i < NODES; i++) {
            x[i] = vec3_make((i - 0.5 * SEGMENTS) * l, 0.0, 0.0);
            v[i] = vec3_make(0.0, 0.6 * rate * x[i].x, 0.8 * rate * x[i].x);
        }
        rig_begin(&r, &config);
        rig_place(&r, x, v);
        /* v = w x r, with w = rate (0, -0.8, 0.6) */
        double inertia = 6.4e-5 * 0.15 * 0.15 * 0.15 / 12.0;
        vec3 angular = vec3_load(rig_momentum(&r).angular);
        expect_near_vec3(vec3_make(0.0, -0.8 * rate * inertia, 0.6 * rate * inertia), angular,
                         0.03 * rate * inertia);
        rig_run(&r, 0.5e-3, 2000);
        rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
        vec3 along = vec3_sub(x[SEGMENTS], x[0]);
        double turned = rate * 1.0; /* rad in 1 s */
        vec3 wanted = vec3_make(cos(turned), 0.6 * sin(turned), 0.8 * sin(turned));
        expect_near(0.0, vec3_distance(vec3_scale(wanted, 0.15), along), 2e-4);
        for (int i = 0; i < NODES; i++) {
            double place = (i - 0.5 * SEGMENTS) / SEGMENTS;
            expect_near(0.0, vec3_distance(vec3_scale(along, place), x[i]), 5e-8);
        }
        /* T = lambda w^2 (L^2 / 4 - s^2) / 2, and what it stretches: 2 / 3 of that in the middle. */
        double pull = 0.125 * 6.4e-5 * rate * rate * 0.15 * 0.15;
        double middle = pull - 0.125 * 6.4e-5 * rate * rate * l * l;
        expect_near(middle, rig_tension(&r, SEGMENTS / 2), 0.05 * middle);
        expect_near(0.15 * (1.0 + 2.0 / 3.0 * pull / 427.0), vec3_norm(along), 2e-9);
        rig_end(&r);
    }
}

int test_integration_order(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(generalised_alpha_is_second_order),
        harness_test(backward_euler_is_first_order),
        harness_test(few_restarts_keep_order),
        harness_test(restart_in_every_step_is_harmless),
        harness_test(stiff_thread_keeps_order),
        harness_test(curved_rest_shape_keeps_order),
        harness_test(free_fall_is_exact),
        harness_test(drag_limits_fall_speed),
        harness_test(damping_rate_is_exact),
        harness_test(spun_straight_thread_rotates_rigidly),
    };
    return cmocka_run_group_tests_name("thread.integration_order", tests, NULL, NULL);
}
