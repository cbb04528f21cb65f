/* Rigid bodies in a scene: driven, coupled, free; what hands feel; floors and other tools. */
#include "base/elementary.h"
#include "scene/small.h"

static const vec3 half = {0.0, 0.0, 3e-3};

static quat orientation_of(const vbss_scene_rigid_state *r)
{
    const double *q = r->orientation;
    return quat_make(q[0], q[1], q[2], q[3]);
}

/* ---- each kind alone */

static void driven_body_is_at_target(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    const vbss_scene_capsule two[2] = {{{0.0, 0.0, 0.0}, {5e-3, 0.0, 0.0}, 1e-3},
                                       {{5e-3, 0.0, 0.0}, {5e-3, 4e-3, 0.0}, 5e-4}};
    uint32_t body;
    s.rigid.capsules = two;
    s.rigid.capsule_count = 2;
    s.rigid.position[1] = 0.02;
    expect_ok(vbss_scene_add_rigid(s.scene, &s.rigid, &body));
    vbss_scene_rigid_state before = small_rigid(&s, body);
    for (int i = 1; i <= 100; i++) {
        double turn = 0.01 * i;
        const double p[3] = {1e-4 * i, 0.02 + 1e-5 * i * i, -5e-5 * i};
        /* Of any length: it is made unit. */
        const double q[4] = {7.0 * vbss_cos(turn), 0.0, 7.0 * vbss_sin(turn), 0.0};
        const double h = i % 2 == 0 ? 1e-3 : 2e-3;
        expect_ok(vbss_scene_set_rigid_target(s.scene, body, p, q));
        vbss_scene_rigid_state reported = small_rigid(&s, body);
        expect_near(0.0, vec3_distance(vec3_load(p), vec3_load(reported.target_position)), 1e-16);
        assert_memory_equal(reported.position, before.position,
                            sizeof reported.position); /* not yet */
        small_steps(&s, 1, h);
        vbss_scene_rigid_state now = small_rigid(&s, body);
        expect_near(0.0, vec3_distance(vec3_load(p), vec3_load(now.position)), 1e-16);
        expect_near(vbss_cos(turn), now.orientation[0], 1e-14);
        expect_near(vbss_sin(turn), now.orientation[2], 1e-14);
        vec3 displacement = vec3_sub(vec3_load(p), vec3_load(before.position));
        expect_near(0.02 / h, now.angular_velocity[1], 0.02 / h * 1e-3);
        /* Of the frame's origin: the displacement, but for the turn in the step. */
        expect_near(0.0, vec3_distance(vec3_scale(displacement, 1.0 / h), vec3_load(now.velocity)),
                    0.1);
        before = now;
    }
    small_steps(&s, 1, 1e-3); /* then it stays */
    vbss_scene_rigid_state now = small_rigid(&s, body);
    assert_memory_equal(now.position, before.position, sizeof now.position);
    expect_near(0.0, vec3_norm(vec3_load(now.velocity)), 1e-12);
    assert_int_equal(now.kind, VBSS_SCENE_RIGID_DRIVEN);
    small_end(&s);
}

/* A driven body bears anything, and takes part in no equation: also when it is moved fast. */
static void driven_bodies_ignore_each_other_and_floor(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    uint32_t a = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 0.7e-3, 0.0), half, 1e-3);
    uint32_t b = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1.5e-3, 1e-3, 0.0), half, 1e-3);
    s.thread.gravity[1] = -9.81;
    small_thread(&s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.02, 0.1, 0.0), 10, &thread);
    small_pin(&s, 3, 0, a);
    for (int i = 1; i <= 30; i++) {
        vec3 to = vec3_make(1e-5 * i, 0.7e-3 - 2e-6 * i, 0.0);
        small_move(&s, a, to);
        small_steps(&s, 1, 1e-3);
        expect_near(0.0, vec3_distance(to, small_position(&s, a)), 1e-16);
        expect_near(1.5e-3, small_position(&s, b).x, 1e-16);
    }
    assert_int_equal(small_statistics(&s).attempts, 30);
    small_end(&s);
}

/* Without contacts: a mass, a spring and a damper, by backward Euler; the hand feels the spring. */
static void coupled_body_lags_and_pulls_hand(void **state)
{
    (void)state;
    small s;
    const double h = 1e-3, m = 0.02, k = 2000.0, c = 5.0, speed = 0.1;
    small_begin_scene(&s);
    uint32_t body = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), half, 1e-3);
    double x = 0.0, v = 0.0;
    for (int i = 1; i <= 300; i++) {
        double given = speed * h * i;
        small_move(&s, body, vec3_make(given, 0.0, 0.0));
        small_steps(&s, 1, h);
        /* m (v' - v) / h = k (g - x') + c (speed - v'), x' = x + h v' */
        v = (m / h * v + k * (given - x) + c * speed) / (m / h + k * h + c);
        x += h * v;
        vbss_scene_rigid_state r = small_rigid(&s, body);
        expect_near(x, r.position[0], 1e-13);
        expect_near(v, r.velocity[0], 1e-10);
        expect_near(-(k * (given - x) + c * (speed - v)), r.hand_force[0], 1e-9);
        expect_near(0.0, vec3_norm(vec3_load(r.contact_force)), 0.0);
        assert_true(i > 5 || r.position[0] < given); /* it lags as it starts */
        expect_near(given, r.target_position[0], 1e-16);
    }
    small_end(&s);
}

static void coupled_body_rotates_after_target(void **state)
{
    (void)state;
    small s;
    const double zero[3] = {0.0, 0.0, 0.0}, q[4] = {vbss_cos(0.15), 0.0, vbss_sin(0.15), 0.0};
    small_begin_scene(&s);
    uint32_t body = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), half, 1e-3);
    expect_ok(vbss_scene_set_rigid_target(s.scene, body, zero, q));
    small_steps(&s, 1, 1e-3);
    vbss_scene_rigid_state r = small_rigid(&s, body);
    assert_true(r.orientation[2] < vbss_sin(0.15));
    assert_true(r.hand_torque[1] < 0.0);
    small_steps(&s, 300, 1e-3);
    r = small_rigid(&s, body);
    expect_near(vbss_sin(0.15), r.orientation[2], 1e-6);
    expect_near(0.0, r.hand_torque[1], 1e-5);
    expect_near(1.0, quat_dot(orientation_of(&r), orientation_of(&r)), 1e-12);
    small_end(&s);
}

static void free_body_falls_and_spins(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    s.rigid.gravity[1] = -9.81;
    s.rigid.velocity[0] = 0.3;
    s.rigid.angular_velocity[2] = 5.0;
    uint32_t body = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 1.0, 0.0), half, 1e-3);
    for (int i = 1; i <= 100; i++) {
        small_steps(&s, 1, 1e-3);
        vbss_scene_rigid_state r = small_rigid(&s, body);
        expect_near(3e-4 * i, r.position[0], 1e-12);
        expect_near(1.0 - 9.81e-6 * 0.5 * i * (i + 1), r.position[1], 1e-12);
        expect_near(5.0, r.angular_velocity[2], 1e-9);
        expect_near(vbss_sin(2.5e-3 * i), r.orientation[3], 1e-9);
        expect_near(0.0, vec3_norm(vec3_load(r.hand_force)), 0.0);
    }
    assert_int_equal(small_statistics(&s).linearisations, 100);
    small_end(&s);
}

/* The frame's origin far from the mass: velocities given and told are the origin's. */
static void velocity_is_of_frame_origin(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    s.rigid.velocity[0] = 0.1;
    s.rigid.angular_velocity[2] = 20.0;
    uint32_t body = small_capsule(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.1, 0.0, -1e-3),
                                  vec3_make(0.1, 0.0, 1e-3), 1e-3);
    vbss_scene_rigid_state r = small_rigid(&s, body);
    expect_near(0.1, r.velocity[0], 1e-15);
    expect_near(0.0, r.velocity[1], 1e-15);
    small_steps(&s, 50, 1e-3); /* the mass flies straight at w x r = 2 m/s along y */
    r = small_rigid(&s, body);
    vec3 centre =
        pose_apply(pose_make(vec3_load(r.position), orientation_of(&r)), vec3_make(0.1, 0.0, 0.0));
    expect_near(0.1 + 0.1 * 0.05, centre.x, 1e-9);
    expect_near(2.0 * 0.05, centre.y, 1e-9);
    small_end(&s);
}

/* ---- mass: a coupled body answers a push with what it was given */

static void mass_is_independent_of_capsule_count(void **state)
{
    (void)state;
    for (uint32_t count = 1; count <= 3; count++) {
        small s;
        vbss_scene_capsule capsules[3];
        uint32_t body;
        small_begin_scene(&s);
        for (uint32_t i = 0; i < 3; i++) {
            const vbss_scene_capsule c = {{1e-3 * i, 0.0, 0.0}, {1e-3 * i, 5e-3, 0.0}, 1e-3};
            capsules[i] = c;
        }
        s.rigid.kind = VBSS_SCENE_RIGID_COUPLED;
        s.rigid.capsules = capsules;
        s.rigid.capsule_count = count;
        s.rigid.mass = 0.5;
        s.rigid.stiffness = 100.0;
        s.rigid.damping = 0.0;
        expect_ok(vbss_scene_add_rigid(s.scene, &s.rigid, &body));
        small_move(&s, body, vec3_make(0.0, 0.0, 1e-3));
        small_steps(&s, 1, 1e-3);
        /* (m / h^2 + k) x = k g */
        expect_near(0.1 / (0.5e6 + 100.0), small_position(&s, body).z, 1e-15);
        small_end(&s);
    }
}

/* ---- floors */

static void ball_rests_below_friction_angle(void **state)
{
    (void)state;
    const vec3 normals[] = {{0.0, 1.0, 0.0}, {0.1, 1.0, 0.0}, {0.0, 2.0, 0.4}, {-0.3, 3.0, 0.3}};
    for (int k = 0; k < 4; k++) {
        small s;
        small_begin(&s);
        s.config.floor = 1;
        s.config.floor_friction = 0.8;
        s.config.floor_height = 3e-3; /* along the unit normal */
        vec3_store(s.config.floor_normal, normals[k]);
        small_create(&s);
        s.rigid.gravity[1] = -9.81;
        s.rigid.friction = 0.8;
        vec3 up = vec3_unit_or(normals[k], vec3_zero());
        /* Three balls in a triangle stand where one would roll. */
        vec3 a = vec3_any_normal(up), b = vec3_cross(up, a);
        vbss_scene_capsule feet[3];
        for (int i = 0; i < 3; i++) {
            vec3 at = vec3_scale(i == 0 ? a : i == 1 ? b : vec3_neg(vec3_add(a, b)), 4e-3);
            vec3_store(feet[i].begin, at);
            vec3_store(feet[i].end, at);
            feet[i].radius = 1e-3;
        }
        uint32_t body;
        s.rigid.kind = VBSS_SCENE_RIGID_FREE;
        s.rigid.capsules = feet;
        s.rigid.capsule_count = 3;
        vec3_store(s.rigid.position, vec3_scale(up, 4e-3));
        expect_ok(vbss_scene_add_rigid(s.scene, &s.rigid, &body));
        small_steps(&s, 200, 1e-3);
        vec3 before = small_position(&s, body);
        small_steps(&s, 300, 1e-3);
        vbss_scene_rigid_state r = small_rigid(&s, body);
        expect_near(0.0, vec3_distance(before, vec3_load(r.position)), 1e-9);
        expect_near(4e-3, vec3_dot(up, before), 2e-6);
        expect_near(0.02 * 9.81, r.contact_force[1], 1e-5);
        expect_near(0.0, r.contact_force[0], 1e-5);
        expect_near(0.0, r.contact_force[2], 1e-5);
        assert_int_equal(small_statistics(&s).clamped, 0);
        small_end(&s);
    }
}

static void floor_pushes_back_on_tool(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 1e-3, 0.0), half, 1e-3);
    for (int i = 1; i <= 200; i++) {
        small_move(&s, tool, vec3_make(0.0, 1e-3 - vbss_min(1e-5 * i, 1e-3), 0.0));
        small_steps(&s, 1, 1e-3);
    }
    vbss_scene_rigid_state r = small_rigid(&s, tool);
    expect_near(2.0, r.contact_force[1], 0.02); /* 2000 N/m times 1 mm, less what gives way */
    expect_near(r.contact_force[1], r.hand_force[1], 1e-4);
    expect_near(1e-3, r.position[1], 1e-5);
    small_end(&s);
}

/* A stick lies on another, which is the only contact. The bounding box of a third overlaps its own. */
static void pair_that_is_apart_needs_no_room(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.contact_capacity = 1;
    small_create(&s);
    small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), vec3_make(5e-3, 0.0, 0.0), 1e-3);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -2e-3, 0.0), half, 1e-3);
    small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 1.5e-3, 0.01),
                  vec3_make(0.0, 0.018, 0.0), 1e-3);
    small_steps(&s, 3, 1e-3);
    assert_int_equal(small_statistics(&s).rows, 1);
    assert_int_equal(small_statistics(&s).rejected_full, 0);
    small_end(&s);
}

int test_scene_rigid(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(driven_body_is_at_target),
        cmocka_unit_test(driven_bodies_ignore_each_other_and_floor),
        cmocka_unit_test(coupled_body_lags_and_pulls_hand),
        cmocka_unit_test(coupled_body_rotates_after_target),
        cmocka_unit_test(free_body_falls_and_spins),
        cmocka_unit_test(velocity_is_of_frame_origin),
        cmocka_unit_test(mass_is_independent_of_capsule_count),
        cmocka_unit_test(ball_rests_below_friction_angle),
        cmocka_unit_test(floor_pushes_back_on_tool),
        cmocka_unit_test(pair_that_is_apart_needs_no_room),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
