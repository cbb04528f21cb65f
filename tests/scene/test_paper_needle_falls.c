/* Free needles of method VBLAST: they fly as they do alone, come down on the floor without a bounce, and stay there. */
#include "fixtures/baseline_of.h"
#include "base/rotation.h"
#include "scene/needles_rig.h"

#define GRAVITY 9.81

static void begin(needles_rig *r, int32_t floor)
{
    needles_begin(r);
    r->tools.s.config.method = r->config.method = VBSS_METHOD_VBLAST;
    r->tools.s.config.capsule_capacity = 64;
    r->tools.s.config.floor = floor;
    vec3_store(r->tools.s.config.floor_normal, vec3_make(0.0, 0.0, 1.0));
    small_create(&r->tools.s);
    r->tools.config.jaw_speed = 1e3; /* closed before it falls */
    r->config.gravity[2] = -GRAVITY;
}

/* Of the lowest end of its capsules above the floor, less the radius of the wire. */
static double height(const needles_rig *r)
{
    vbss_view view;
    double smallest = DBL_MAX;
    expect_ok(vbss_needle_get_view(r->needle, VBSS_NEEDLE_VIEW_POINTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        double at[3];
        memcpy(at, (const char *)view.data + i * view.stride_bytes, sizeof at);
        smallest = vbss_min(smallest, at[2]);
    }
    return smallest - r->config.wire_radius;
}

static double speed(const needles_rig *r)
{
    vbss_needle_state s = needles_state(r);
    return vec3_norm(vec3_load(s.velocity)) + 0.02 * vec3_norm(vec3_load(s.angular_velocity));
}

/* Backward Euler: n steps of h take it down by g h^2 n (n + 1) / 2. */
static void dropped_needle_follows_ballistic_law(void **state)
{
    (void)state;
    needles_rig r;
    begin(&r, 0);
    needles_add_across(&r, 16e-3, vec3_zero());
    tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
    tools_close(&r.tools, 0);
    assert_int_equal(tools_state(&r.tools, 0).needle, r.body);
    const vbss_needle_state held = needles_state(&r);
    tools_open(&r.tools, 0, 1.0);
    tools_steps(&r.tools, 1); /* at the end of this step it is let go */
    assert_int_equal(tools_state(&r.tools, 0).needle, 0);
    expect_near(held.position[2], needles_state(&r).position[2], 1e-15);
    for (int n = 1; n <= 200; n++) {
        tools_steps(&r.tools, 1);
        double fallen = 0.5 * GRAVITY * 1e-6 * n * (n + 1);
        expect_near(-fallen, needles_state(&r).position[2] - held.position[2], 1e-14);
        expect_near(-GRAVITY * 1e-3 * n, needles_state(&r).velocity[2], 1e-12);
    }
    needles_end(&r);
}

/* Thrown: what the tool had is what it goes on with. */
static void released_needle_keeps_led_velocity(void **state)
{
    (void)state;
    needles_rig r;
    begin(&r, 0);
    r.config.gravity[2] = 0.0;
    needles_add_across(&r, 16e-3, vec3_zero());
    tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
    tools_close(&r.tools, 0);
    const double first = needles_state(&r).position[0];
    for (int i = 1; i <= 40; i++) {
        tools_move(&r.tools, 0, vec3_make(1e-4 * i, 0.0, -2e-3));
        tools_open(&r.tools, 0, i < 20 ? 0.0 : 1.0);
        tools_steps(&r.tools, 1);
        expect_near(1e-4 * i, needles_state(&r).position[0] - first, 1e-13);
    }
    expect_near(0.1, needles_state(&r).velocity[0], 1e-10);
    needles_end(&r);
}

static void free_flight_equals_standalone_bit_exact(void **state)
{
    (void)state;
    needles_rig r;
    vbss_needle *alone;
    begin(&r, 1);
    r.config.position[2] = 0.5;
    r.config.drag = 0.3;
    vec3_store(r.config.velocity, vec3_make(0.4, -0.3, 1.0));
    vec3_store(r.config.angular_velocity, vec3_make(3.0, -20.0, 5.0));
    needles_add(&r);
    expect_ok(vbss_needle_create(r.tools.s.context, &r.config, &alone));
    for (int i = 0; i < 300; i++) {
        uint64_t in_scene, own;
        tools_steps(&r.tools, 1);
        expect_ok(vbss_needle_step(alone, 1e-3));
        expect_ok(vbss_needle_get_hash(r.needle, &in_scene));
        expect_ok(vbss_needle_get_hash(alone, &own));
        assert_true(in_scene == own);
    }
    needles_end(&r);
}

/* Flat, it stops at once; however it comes down, it is never below the floor and never gains energy. */
static void falling_needle_comes_to_rest_on_floor(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 12; seed++) {
        needles_rig r;
        vbss_random random;
        vbss_random_seed(&random, seed, 3);
        begin(&r, 1);
        vec3 turn = vec3_zero();
        if (seed > 0) {
            turn.x = 6.0 * vbss_random_uniform(&random) - 3.0;
            turn.y = 6.0 * vbss_random_uniform(&random) - 3.0;
        }
        quat q = vbss_quat_from_rotation_vector(turn);
        const double orientation[4] = {q.w, q.x, q.y, q.z};
        memcpy(r.config.orientation, orientation, sizeof orientation);
        r.config.position[2] = 0.03;
        needles_add(&r);
        double before = needles_energy(&r);
        for (int i = 0; i < 3000; i++) {
            tools_steps(&r.tools, 1);
            double energy = needles_energy(&r);
            assert_true(height(&r) > -1e-10);
            assert_true(energy <= before + 1e-10);
            before = energy;
        }
        expect_near(0.0, height(&r), 1e-9);
        vbss_needle_state end = needles_state(&r); /* it lies flat, and slides and turns for ever */
        expect_near(r.config.wire_radius, end.tip[2], 1e-6);
        expect_near(r.config.wire_radius, end.swage[2], 1e-6);
        expect_near(0.0, end.velocity[2], 1e-4);
        assert_true(seed > 0 || speed(&r) < 1e-9);
        needles_end(&r);
    }
}

static void floor_keeps_distance(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin(&r);
    r.tools.s.config.method = r.config.method = VBSS_METHOD_VBLAST;
    r.tools.s.config.floor = 1;
    baseline_of(&r.tools.s.config.baseline)->scene_thickness = 1e-3;
    small_create(&r.tools.s);
    r.config.gravity[1] = -GRAVITY;
    r.config.wire_radius = 0.5e-3;
    const double lying[4] = {0.70710678118654752, 0.70710678118654752, 0.0, 0.0};
    memcpy(r.config.orientation, lying, sizeof lying);
    r.config.position[1] = 5e-3;
    needles_add(&r);
    tools_steps(&r.tools, 300);
    expect_near(1.5e-3, needles_state(&r).tip[1], 1e-9);
    expect_near(1.5e-3, needles_state(&r).swage[1], 1e-9);
    needles_end(&r);
}

int test_paper_needle_falls(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(dropped_needle_follows_ballistic_law),
        harness_test(released_needle_keeps_led_velocity),
        harness_test(free_flight_equals_standalone_bit_exact),
        harness_test(falling_needle_comes_to_rest_on_floor),
        harness_test(floor_keeps_distance),
    };
    return cmocka_run_group_tests_name("scene.paper_needle_falls", tests, NULL, NULL);
}
