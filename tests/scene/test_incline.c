/* Coulomb friction on an inclined floor: capsules lying down the slope and straight threads stick below the
 * angle of friction without creep, and slide above it as fast as they must. */
#include <math.h>

#include "scene/rig.h"

static const double pi = 0x1.921fb54442d18p1;
static const double gravity = 9.81;

enum { MIDDLE = 15, SEGMENTS = 30 }; /* of the thread */
static const double thread_length = 0.03, capsule_length = 0.02, capsule_radius = 2.5e-3;

typedef struct slope {
    double angle, body_friction, floor_friction;
    bool is_thread;
    vec3 down, up;
    uint32_t body;
    scene_rig rig;
} slope;

static double friction_of(const slope *s)
{
    return s->is_thread ? s->floor_friction : sqrt(s->body_friction * s->floor_friction);
}

static void begin(slope *s, double speed)
{
    vbss_scene_config scene = scene_rig_incline(s->angle, s->floor_friction);
    s->down = vec3_make(cos(s->angle), -sin(s->angle), 0.0);
    s->up = vec3_make(sin(s->angle), cos(s->angle), 0.0);
    if (s->is_thread) {
        vbss_thread_config thread = rig_config(thread_length, SEGMENTS);
        vec3 velocities[SEGMENTS + 1];
        vec3_store(thread.direction, s->down);
        vec3_store(thread.start, vec3_scale(s->up, thread.radius));
        scene_rig_begin(&s->rig, &scene, &thread);
        for (int i = 0; i <= SEGMENTS; i++) {
            velocities[i] = vec3_scale(s->down, speed);
        }
        rig_place(&s->rig.thread, NULL, velocities);
        return;
    }
    scene_rig_begin(&s->rig, &scene, NULL);
    vbss_scene_capsule capsule;
    vec3 half = vec3_scale(s->down, 0.5 * capsule_length), at = vec3_scale(s->up, capsule_radius);
    vbss_scene_rigid_config body = scene_rig_capsule(
        VBSS_SCENE_RIGID_FREE, &capsule, vec3_sub(at, half), vec3_add(at, half), capsule_radius);
    body.friction = s->body_friction;
    vec3_store(body.velocity, vec3_scale(s->down, speed));
    s->body = scene_rig_add(&s->rig, &body);
}

static double place_of(slope *s)
{
    vec3 x =
        s->is_thread ? rig_position(&s->rig.thread, MIDDLE) : scene_rig_position(&s->rig, s->body);
    return vec3_dot(x, s->down);
}

static double speed_of(slope *s)
{
    vec3 v =
        s->is_thread ? rig_velocity(&s->rig.thread, MIDDLE) : scene_rig_velocity(&s->rig, s->body);
    return vec3_dot(v, s->down);
}

static slope slope_at(double degrees, double body_friction, double floor_friction, bool is_thread)
{
    slope s = {.angle = degrees * pi / 180.0,
               .body_friction = body_friction,
               .floor_friction = floor_friction,
               .is_thread = is_thread};
    return s;
}

/* ---- the threshold */

static const double frictions[][2] = {{0.3, 0.3}, {0.9, 0.1}, {0.05, 0.2}, {0.6, 0.6}};
enum { FRICTIONS = 4 };

static double angle_of_friction(const double *friction, bool is_thread)
{
    return atan(is_thread ? friction[1] : sqrt(friction[0] * friction[1])) * 180.0 / pi;
}

static void no_creep_below_friction_angle(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * FRICTIONS; i++) {
        const double *f = frictions[i / 2];
        slope s = slope_at(angle_of_friction(f, i % 2 == 1) - 0.1, f[0], f[1], i % 2 == 1);
        begin(&s, 0.0);
        scene_rig_run(&s.rig, 1e-3, 100);
        double before = place_of(&s);
        scene_rig_run(&s.rig, 1e-3, i < 2 ? 10000 : 1000);
        double crept = place_of(&s) - before;
        scene_rig_end(&s.rig);
        expect_near(0.0, crept, 1e-12);
    }
}

static void sliding_above_friction_angle(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * FRICTIONS; i++) {
        const double *f = frictions[i / 2];
        slope s = slope_at(angle_of_friction(f, i % 2 == 1) + 0.1, f[0], f[1], i % 2 == 1);
        begin(&s, 0.0);
        scene_rig_run(&s.rig, 1e-3, 1000);
        double speed = speed_of(&s);
        double wanted = gravity * (sin(s.angle) - friction_of(&s) * cos(s.angle));
        scene_rig_end(&s.rig);
        expect_near(1.0, speed / wanted, 0.01);
    }
}

/* ---- motion */

static void sliding_acceleration_follows_coulomb(void **state)
{
    (void)state;
    const double degrees[] = {5.0, 10.0, 20.0, 40.0, 70.0};
    for (int i = 0; i < 20; i++) {
        double friction = i < 10 ? 0.0 : 0.05;
        slope s = slope_at(degrees[i % 5], friction, friction, i / 5 % 2 == 1);
        begin(&s, 0.0);
        scene_rig_run(&s.rig, 1e-3, 500);
        double acceleration = speed_of(&s) / 0.5;
        double wanted = gravity * (sin(s.angle) - friction * cos(s.angle));
        scene_rig_end(&s.rig);
        expect_near(1.0, acceleration / wanted, 1e-4);
    }
}

/* What is thrown comes to rest within v^2 / (2 mu g), but for half a step, and stays there. */
static void thrown_thread_stops_in_coulomb_distance(void **state)
{
    (void)state;
    const double speed = 0.4, h = 2e-4;
    for (int i = 0; i < 2; i++) {
        slope s = slope_at(5.0, 0.3, 0.3, i == 1);
        begin(&s, speed);
        double begun = place_of(&s);
        double slowing = gravity * (0.3 * cos(s.angle) - sin(s.angle));
        scene_rig_run(&s.rig, h, (uint32_t)(1.2 * speed / (slowing * h)));
        double stopped = place_of(&s), distance = 0.5 * speed * speed / slowing;
        scene_rig_run(&s.rig, h, 1000);
        double after = place_of(&s), left = speed_of(&s);
        scene_rig_end(&s.rig);
        expect_near(distance, stopped - begun, speed * h);
        expect_near(stopped, after, 1e-12);
        expect_near(0.0, left, 1e-12);
    }
}

/* The floor bears the weight's part across it and rubs with the other, sticking or sliding. */
static void floor_force_balances(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        slope s = slope_at(i < 2 ? 10.0 : 30.0, 0.3, 0.3, i % 2 == 1);
        begin(&s, 0.0);
        scene_rig_run(&s.rig, 1e-3, 300);
        vec3 force = scene_rig_floor_force(&s.rig);
        double mass = s.is_thread ? 6.4e-5 * thread_length : 0.02, weight = mass * gravity;
        double up = vec3_dot(force, s.up), back = -vec3_dot(force, s.down);
        double rubbing = i < 2 ? sin(s.angle) : 0.3 * cos(s.angle);
        scene_rig_end(&s.rig);
        expect_near(cos(s.angle), up / weight, 1e-5);
        expect_near(rubbing, back / weight, 1e-5);
    }
}

int test_incline(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_creep_below_friction_angle),
        cmocka_unit_test(sliding_above_friction_angle),
        cmocka_unit_test(sliding_acceleration_follows_coulomb),
        cmocka_unit_test(thrown_thread_stops_in_coulomb_distance),
        cmocka_unit_test(floor_force_balances),
    };
    return cmocka_run_group_tests_name("scene.incline", tests, NULL, NULL);
}
