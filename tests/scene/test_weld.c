/* A thread whose last node is a point of a free capsule, as a needle on its thread: exact at any ratio of
 * their masses. */
#include <math.h>

#include "scene/rig.h"

enum { SEGMENTS = 20 };

static const double pi = 0x1.921fb54442d18p1;
static const double gravity = 9.81, thread_length = 0.1, length = 0.02, radius = 2.5e-3;

/* ---- making: the capsule goes on where the thread ends */

typedef struct welded {
    double node_mass, mass; /* of the thread: of a segment; of the capsule */
    vec3 direction;         /* of both */
    double gap;             /* from the capsule's surface to the node */
    double gravity, axial_stiffness, bending_stiffness;
    bool held;         /* at the thread's other end */
    vec3 flight, spin; /* at the start, of both as one: of the capsule's middle, and about it */
    /* what follows */
    uint32_t body, top; /* top: the attachment that holds node 0 */
    double arm;         /* from the node to the capsule's middle */
    scene_rig rig;
} welded;

static welded hanging(double node_mass, double mass)
{
    welded w = {.node_mass = node_mass,
                .mass = mass,
                .direction = vec3_make(0.0, -1.0, 0.0),
                .gap = 1e-3,
                .gravity = gravity,
                .axial_stiffness = 427.0,
                .bending_stiffness = 1e-8,
                .held = true};
    return w;
}

static welded tumbling(double node_mass, double mass)
{
    welded w = hanging(node_mass, mass);
    w.direction = vec3_make(1.0, 0.0, 0.0);
    w.gravity = 0.0;
    w.held = false;
    w.flight = vec3_make(0.1, -0.2, 0.05);
    w.spin = vec3_make(3.0, 5.0, 20.0);
    return w;
}

static void begin_thread(welded *w, vec3 middle)
{
    vbss_scene_config scene = scene_rig_config();
    vbss_thread_config thread = rig_config(thread_length, SEGMENTS);
    vec3_store(thread.direction, w->direction);
    thread.linear_density = w->node_mass * SEGMENTS / thread_length;
    thread.gravity[1] = -w->gravity;
    thread.axial_stiffness = w->axial_stiffness;
    thread.bending_stiffness = w->bending_stiffness;
    thread.stretch_tolerance = 1e-11;
    scene_rig_begin(&w->rig, &scene, &thread);
    vec3 velocities[SEGMENTS + 1];
    for (uint32_t i = 0; i <= SEGMENTS; i++) {
        vec3 arm = vec3_sub(rig_position(&w->rig.thread, i), middle);
        velocities[i] = vec3_add(w->flight, vec3_cross(w->spin, arm));
    }
    rig_place(&w->rig.thread, NULL, velocities);
    w->top = w->held ? rig_pin_here(&w->rig.thread, 0) : 0;
}

static void begin(welded *w)
{
    w->arm = w->gap + radius + 0.5 * length;
    vec3 middle = vec3_scale(w->direction, thread_length + w->arm);
    vec3 half = vec3_scale(w->direction, 0.5 * length);
    begin_thread(w, middle);
    vbss_scene_capsule capsule;
    vbss_scene_rigid_config body = scene_rig_capsule(
        VBSS_SCENE_RIGID_FREE, &capsule, vec3_sub(middle, half), vec3_add(middle, half), radius);
    body.mass = w->mass;
    body.gravity[1] = -w->gravity;
    vec3_store(body.velocity, w->flight);
    vec3_store(body.angular_velocity, w->spin);
    w->body = scene_rig_add(&w->rig, &body);
    double point[3];
    uint32_t pin;
    vec3_store(point, vec3_scale(w->direction, -w->arm));
    expect_ok(vbss_scene_pin_thread(w->rig.scene, w->rig.body, SEGMENTS, w->body, point, &pin));
}

static quat orientation_of(const vbss_scene_rigid_state *s)
{
    return quat_make(s->orientation[0], s->orientation[1], s->orientation[2], s->orientation[3]);
}

static double distance_of_weld(welded *w)
{
    vbss_scene_rigid_state s = scene_rig_state(&w->rig, w->body);
    vec3 point = quat_rotate(orientation_of(&s), vec3_scale(w->direction, -w->arm));
    return vec3_distance(vec3_add(vec3_load(s.position), point),
                         rig_position(&w->rig.thread, SEGMENTS));
}

/* ---- free flight */

typedef struct momenta {
    vec3 linear, angular;
} momenta;

static momenta momenta_of(welded *w)
{
    vbss_scene_rigid_state s = scene_rig_state(&w->rig, w->body);
    vbss_thread_momentum thread = rig_momentum(&w->rig.thread);
    vec3 v = vec3_load(s.velocity), spin = vec3_load(s.angular_velocity);
    vec3 axis = quat_rotate(orientation_of(&s), vec3_make(1.0, 0.0, 0.0));
    double along = scene_rig_inertia_along(w->mass, length, radius);
    double across = scene_rig_inertia_across(w->mass, length, radius);
    vec3 own =
        vec3_add_scaled(vec3_scale(spin, across), (along - across) * vec3_dot(axis, spin), axis);
    vec3 flight = vec3_scale(v, w->mass);
    momenta m = {vec3_add(vec3_load(thread.linear), flight),
                 vec3_add(vec3_load(thread.angular),
                          vec3_add(own, vec3_cross(vec3_load(s.position), flight)))};
    return m;
}

static const double ratios[] = {1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}; /* capsule over node */
enum { RATIOS = 7 };

/* Masses stay within what may be told: a heavy node where the capsule is light. */
static double node_of(double ratio)
{
    return ratio < 1.0 ? 3.2e-3 : 3.2e-7;
}

static void welded_node_stays_on_its_point(void **state)
{
    (void)state;
    for (int i = 0; i < RATIOS; i++) {
        double node = node_of(ratios[i]);
        welded w = tumbling(node, ratios[i] * node);
        begin(&w);
        for (int k = 0; k < 200; k++) {
            scene_rig_run(&w.rig, 1e-3, 1);
            expect_near(0.0, distance_of_weld(&w), 1e-12);
        }
        assert_int_equal(0, scene_rig_statistics(&w.rig).clamped);
        scene_rig_end(&w.rig);
    }
}

static vec3 lost_in_flight(double ratio, double h)
{
    welded w = tumbling(node_of(ratio), ratio * node_of(ratio));
    begin(&w);
    momenta before = momenta_of(&w);
    scene_rig_run(&w.rig, h, (uint32_t)(0.1 / h + 0.5));
    momenta after = momenta_of(&w);
    scene_rig_end(&w.rig);
    return vec3_make(vec3_distance(before.linear, after.linear) / vec3_norm(before.linear),
                     vec3_distance(before.angular, after.angular) / vec3_norm(before.angular), 0.0);
}

/* Backward Euler, which a welded thread is stepped by, loses angular momentum to first order. */
static void momentum_is_conserved_and_angular_momentum_nearly(void **state)
{
    (void)state;
    for (int i = 0; i < RATIOS; i++) {
        vec3 coarse = lost_in_flight(ratios[i], 1e-3), fine = lost_in_flight(ratios[i], 5e-4);
        expect_near(0.0, coarse.x, 1e-9);
        expect_near(0.0, coarse.y, 0.025);
        expect_near(0.5, fine.y / coarse.y, 0.1);
    }
}

/* ---- hanging */

static void thread_carries_weight(void **state)
{
    (void)state;
    const double heavier[] = {1e-3, 1.0, 1e3, 1e6};
    for (int i = 0; i < 4; i++) {
        double node = node_of(heavier[i]);
        welded w = hanging(node, heavier[i] * node);
        begin(&w);
        scene_rig_run(&w.rig, 1e-3, heavier[i] > 1e4 ? 4000 : 1000);
        double weight = w.mass * gravity, whole = weight + w.node_mass * SEGMENTS * gravity;
        vbss_scene_rigid_state s = scene_rig_state(&w.rig, w.body);
        vec3 top = rig_reaction_force(&w.rig.thread, w.top);
        expect_near(1.0, s.contact_force[1] / weight, 1e-6);
        expect_near(1.0, top.y / whole, 1e-6);
        expect_near(0.0, distance_of_weld(&w), 1e-12);
        double last = rig_tension(&w.rig.thread, SEGMENTS - 1);
        assert_true(last > weight && last < weight + w.node_mass * gravity);
        scene_rig_end(&w.rig);
    }
}

/* A needle and its swage do not push each other, however deep the node sits. */
static void welded_node_has_no_contact_with_its_capsule(void **state)
{
    (void)state;
    const double gaps[] = {0.0, -1e-3, -radius};
    for (int i = 0; i < 3; i++) {
        welded w = hanging(3.2e-7, 3.2e-4);
        w.gap = gaps[i];
        begin(&w);
        scene_rig_run(&w.rig, 1e-3, 500);
        vbss_scene_rigid_state s = scene_rig_state(&w.rig, w.body);
        vbss_scene_statistics n = scene_rig_statistics(&w.rig);
        expect_near(1.0, s.contact_force[1] / (w.mass * gravity), 1e-6);
        expect_near(0.0, vec3_norm(vec3_load(s.velocity)), 1e-9);
        assert_int_equal(0, n.contacts);
        expect_near(0.0, n.penetration, 0.0);
        scene_rig_end(&w.rig);
    }
}

/* ---- swinging */

/* Of the slow mode of a capsule on a string without mass. */
static double wanted_period(const welded *w, double string)
{
    double m = w->mass, l = w->arm;
    double about = m * l * l + scene_rig_inertia_across(m, length, radius);
    double a = m * string * string * (about - m * l * l);
    double b = m * gravity * string * (about + m * string * l);
    double c = m * m * gravity * gravity * string * l;
    /* det(K - w^2 M) = 0 for the string's and the capsule's angle, over m. */
    double square = (b - sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
    return 2.0 * pi / sqrt(square);
}

static double measured_period(welded *w)
{
    double first = 0.0, last = 0.0, before = 1.0;
    int swings = 0;
    const double h = 1e-3;
    for (int k = 1; swings < 9; k++) {
        scene_rig_run(&w->rig, h, 1);
        double now = scene_rig_position(&w->rig, w->body).x;
        if (before > 0.0 && now <= 0.0) {
            last = h * (k - 1 + before / (before - now));
            first = swings == 0 ? last : first;
            swings++;
        }
        before = now;
    }
    return (last - first) / (swings - 1);
}

/* A swing of a radians takes longer by a^2 / 16. */
static void pendulum_period(void **state)
{
    (void)state;
    const double masses[] = {1e-3, 1e-2, 0.1, 0.32};
    for (int i = 0; i < 4; i++) {
        welded w = hanging(3.2e-7, masses[i]);
        const double angle = 0.03;
        w.direction = vec3_make(sin(angle), -cos(angle), 0.0);
        w.axial_stiffness = 1e6;
        w.bending_stiffness = 1e-12;
        begin(&w);
        double string = thread_length * (1.0 + w.mass * gravity / w.axial_stiffness);
        double got = measured_period(&w);
        /* The thread's own weight counts a little. */
        double light = 0.35 * SEGMENTS * w.node_mass / w.mass;
        expect_near(1.0, got / (wanted_period(&w, string) * (1.0 + angle * angle / 16.0)),
                    1e-4 + light);
        scene_rig_end(&w.rig);
    }
}

int test_weld(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(welded_node_stays_on_its_point),
        cmocka_unit_test(momentum_is_conserved_and_angular_momentum_nearly),
        cmocka_unit_test(thread_carries_weight),
        cmocka_unit_test(welded_node_has_no_contact_with_its_capsule),
        cmocka_unit_test(pendulum_period),
    };
    return cmocka_run_group_tests_name("scene.weld", tests, NULL, NULL);
}
