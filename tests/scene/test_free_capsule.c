/* A capsule that moves as forces say, on the floor: at rest, dropped, rolling, and on two rails. */
#include <math.h>

#include "scene/rig.h"

static const double pi = 0x1.921fb54442d18p1;
static const double gravity = 9.81, length = 0.02, radius = 2.5e-3;

/* I / (m r^2) about the axis: what rolling has to turn along. */
static double turning_share(void)
{
    return scene_rig_inertia_along(1.0, length, radius) / (radius * radius);
}

/* ---- at rest */

static uint32_t put(scene_rig *r, vec3 middle, vec3 axis, double mass, double friction)
{
    vbss_scene_capsule capsule;
    vbss_scene_rigid_config body = scene_rig_capsule(
        VBSS_SCENE_RIGID_FREE, &capsule, vec3_add_scaled(middle, -0.5 * length, axis),
        vec3_add_scaled(middle, 0.5 * length, axis), radius);
    body.mass = mass;
    body.friction = friction;
    return scene_rig_add(r, &body);
}

static void floor_carries_weight_without_jitter(void **state)
{
    (void)state;
    const double masses[] = {1e-6, 1e-4, 1e-2, 0.1, 1.0};
    for (int i = 0; i < 5; i++) {
        vbss_scene_config scene = scene_rig_incline(0.0, 0.3);
        scene_rig r;
        scene_rig_begin(&r, &scene, NULL);
        uint32_t body =
            put(&r, vec3_make(0.0, radius, 0.0), vec3_make(1.0, 0.0, 0.0), masses[i], 0.3);
        scene_rig_run(&r, 1e-3, 200);
        vec3 before = scene_rig_position(&r, body);
        for (int k = 0; k < 300; k++) {
            scene_rig_run(&r, 1e-3, 1);
            vec3 force = scene_rig_floor_force(&r), v = scene_rig_velocity(&r, body);
            expect_near(1.0, force.y / (masses[i] * gravity), 1e-9);
            expect_near(0.0, hypot(force.x, force.z) / (masses[i] * gravity), 1e-9);
            expect_near(0.0, vec3_norm(v), 1e-12);
        }
        vbss_scene_rigid_state s = scene_rig_state(&r, body);
        expect_near(1.0, s.contact_force[1] / (masses[i] * gravity), 1e-9);
        expect_near(0.0, vec3_distance(before, scene_rig_position(&r, body)), 1e-12);
        scene_rig_end(&r);
    }
}

/* Levers: three ninths and six ninths of the weight. */
static void two_rails_share_weight_by_distance(void **state)
{
    (void)state;
    const double places[2] = {-6e-3, 3e-3}, shares[2] = {1.0 / 3.0, 2.0 / 3.0}, mass = 0.01;
    vbss_scene_config scene = scene_rig_config();
    scene_rig r;
    scene_rig_begin(&r, &scene, NULL);
    uint32_t rails[2];
    for (int k = 0; k < 2; k++) {
        vbss_scene_capsule capsule;
        vbss_scene_rigid_config rail =
            scene_rig_capsule(VBSS_SCENE_RIGID_DRIVEN, &capsule, vec3_make(places[k], 0.0, -0.02),
                              vec3_make(places[k], 0.0, 0.02), 1e-3);
        rails[k] = scene_rig_add(&r, &rail);
    }
    uint32_t body =
        put(&r, vec3_make(0.0, radius + 1e-3, 0.0), vec3_make(1.0, 0.0, 0.0), mass, 0.3);
    scene_rig_run(&r, 1e-3, 1000);
    for (int k = 0; k < 2; k++) {
        vbss_scene_rigid_state rail = scene_rig_state(&r, rails[k]);
        expect_near(-shares[k], rail.hand_force[1] / (mass * gravity), 1e-3);
    }
    vbss_scene_rigid_state s = scene_rig_state(&r, body);
    expect_near(1.0, s.contact_force[1] / (mass * gravity), 1e-6);
    expect_near(0.0, vec3_norm(vec3_load(s.velocity)), 1e-9);
    scene_rig_end(&r);
}

/* ---- dropped */

static void dropped_capsule_comes_to_rest_at_any_tilt(void **state)
{
    (void)state;
    const double tilts[] = {0.0, 0.1, 0.4, 0.8, 1.2, 1.5};
    const double masses[] = {1e-5, 1e-3, 0.02, 0.1};
    for (int i = 0; i < 24; i++) {
        double tilt = tilts[i % 6], mass = masses[i / 6], height = 0.02;
        vbss_scene_config scene = scene_rig_incline(0.0, 0.3);
        scene_rig r;
        scene_rig_begin(&r, &scene, NULL);
        vec3 middle = vec3_make(0.0, height + radius + 0.5 * length * sin(tilt), 0.0);
        vec3 axis = vec3_make(0.6 * cos(tilt), sin(tilt), 0.8 * cos(tilt));
        uint32_t body = put(&r, middle, axis, mass, 0.3);
        scene_rig_run(&r, 1e-3, 600);
        vbss_scene_rigid_state s = scene_rig_state(&r, body);
        vbss_scene_statistics n = scene_rig_statistics(&r);
        expect_near(0.0, vec3_norm(vec3_load(s.velocity)), 1e-9);
        expect_near(0.0, vec3_norm(vec3_load(s.angular_velocity)), 1e-6);
        expect_near(radius, s.position[1], 5e-6);
        expect_near(1.0, scene_rig_floor_force(&r).y / (mass * gravity), 1e-6);
        assert_int_equal(0, n.clamped);
        scene_rig_end(&r);
    }
}

/* Thrown and spinning about all axes: afterwards it may roll, but evenly. */
static void thrown_spinning_capsule_rolls_evenly(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        vbss_scene_config scene = scene_rig_incline(0.0, 0.3);
        scene_rig r;
        scene_rig_begin(&r, &scene, NULL);
        vbss_scene_capsule capsule;
        double angle = 0.5 * i;
        vec3 half = vec3_make(0.01 * cos(angle), 0.004, 0.01 * sin(angle));
        vec3 at = vec3_make(0.0, 0.02, 0.0);
        vbss_scene_rigid_config body = scene_rig_capsule(
            VBSS_SCENE_RIGID_FREE, &capsule, vec3_sub(at, half), vec3_add(at, half), radius);
        body.friction = 0.3;
        body.velocity[0] = 0.2;
        body.velocity[2] = -0.1;
        body.angular_velocity[0] = 20.0;
        body.angular_velocity[1] = 10.0 - i;
        body.angular_velocity[2] = -15.0;
        uint32_t number = scene_rig_add(&r, &body);
        scene_rig_run(&r, 1e-3, 500);
        vec3 before = scene_rig_velocity(&r, number);
        scene_rig_run(&r, 1e-3, 200);
        vec3 after = scene_rig_velocity(&r, number);
        vbss_scene_rigid_state s = scene_rig_state(&r, number);
        double turning = vec3_norm(vec3_load(s.angular_velocity));
        expect_near(0.0, vec3_distance(before, after), 1e-6);
        expect_near(vec3_norm(after), turning * radius, 1e-5);
        assert_int_equal(0, scene_rig_statistics(&r).clamped);
        scene_rig_end(&r);
    }
}

/* ---- rolling */

typedef struct rolling {
    double speed, turning; /* down the slope; radius times angular velocity */
} rolling;

static rolling roll(double angle, double friction, double speed, double h, double time)
{
    vbss_scene_config scene = scene_rig_incline(angle, friction);
    vec3 down = vec3_make(cos(angle), -sin(angle), 0.0);
    scene_rig r;
    scene_rig_begin(&r, &scene, NULL);
    vbss_scene_capsule capsule;
    vec3 at = vec3_make(radius * sin(angle), radius * cos(angle), 0.0);
    vec3 half = vec3_make(0.0, 0.0, 0.5 * length);
    vbss_scene_rigid_config body = scene_rig_capsule(
        VBSS_SCENE_RIGID_FREE, &capsule, vec3_sub(at, half), vec3_add(at, half), radius);
    body.friction = friction;
    vec3_store(body.velocity, vec3_scale(down, speed));
    uint32_t number = scene_rig_add(&r, &body);
    scene_rig_run(&r, h, (uint32_t)(time / h + 0.5));
    vbss_scene_rigid_state s = scene_rig_state(&r, number);
    rolling result = {vec3_dot(vec3_load(s.velocity), down), -radius * s.angular_velocity[2]};
    expect_near(0.0, hypot(s.angular_velocity[0], s.angular_velocity[1]), 1e-6);
    scene_rig_end(&r);
    return result;
}

static void capsule_rolls_down_without_slip(void **state)
{
    (void)state;
    const double degrees[] = {1.0, 10.0, 20.0, 40.0};
    for (int i = 0; i < 4; i++) {
        double angle = degrees[i] * pi / 180.0;
        rolling got = roll(angle, 0.3, 0.0, 1e-3, 0.3);
        double wanted = 0.3 * gravity * sin(angle) / (1.0 + turning_share());
        expect_near(1.0, got.speed / wanted, 1e-5);
        expect_near(1.0, got.turning / got.speed, 1e-3);
    }
}

/* Steeper than tan = mu (1 + m r^2 / I) friction cannot turn it fast enough. */
static void capsule_slips_and_rolls_on_steep_slope(void **state)
{
    (void)state;
    double steepest = atan(0.1 * (1.0 + 1.0 / turning_share()));
    rolling sticks = roll(steepest - 0.01, 0.1, 0.0, 1e-3, 0.3);
    rolling slips = roll(steepest + 0.1, 0.1, 0.0, 1e-3, 0.3);
    double angle = steepest + 0.1;
    expect_near(1.0, sticks.turning / sticks.speed, 1e-3);
    expect_near(1.0, slips.speed / (0.3 * gravity * (sin(angle) - 0.1 * cos(angle))), 1e-5);
    expect_near(1.0, slips.turning / (0.3 * gravity * 0.1 * cos(angle) / turning_share()), 1e-4);
}

/* Thrown without a spin: the angular momentum about the line of contact stays. */
static void sliding_capsule_starts_to_roll(void **state)
{
    (void)state;
    const double speeds[] = {0.05, 0.2, 1.0};
    for (int i = 0; i < 3; i++) {
        rolling got = roll(0.0, 0.3, speeds[i], 1e-3, 0.5);
        expect_near(1.0, got.speed * (1.0 + turning_share()) / speeds[i], 1e-3);
        expect_near(1.0, got.turning / got.speed, 1e-3);
    }
}

int test_free_capsule(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floor_carries_weight_without_jitter),
        cmocka_unit_test(two_rails_share_weight_by_distance),
        cmocka_unit_test(dropped_capsule_comes_to_rest_at_any_tilt),
        cmocka_unit_test(thrown_spinning_capsule_rolls_evenly),
        cmocka_unit_test(capsule_rolls_down_without_slip),
        cmocka_unit_test(capsule_slips_and_rolls_on_steep_slope),
        cmocka_unit_test(sliding_capsule_starts_to_roll),
    };
    return cmocka_run_group_tests_name("scene.free_capsule", tests, NULL, NULL);
}
