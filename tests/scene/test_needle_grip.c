/* The clamp of the jaws as a spring: what a needle on it swings like; and what hangs on the needle. */
#include "base/rotation.h"
#include "scene/needles_rig.h"

/* ---- swings */

/* A tool that is as good as fast, jaws that press harder than the needle pulls. */
static void hold_fast(needles_rig *r)
{
    needles_begin_scene(r);
    r->tools.config.stiffness = r->tools.config.turning_stiffness = 1e9;
    r->tools.config.closing_force = 1000.0;
    r->tools.config.needle_torque = 100.0;
    needles_hold(r);
}

static scene_rigid *needle_of(needles_rig *r)
{
    return &vbss_scene_body(small_object(&r->tools.s), r->body)->rigid;
}

/* Of v' = -w^2 x a step of backward Euler takes x + v / (i w) times 1 / (1 + i w h): the amplitude shrinks by
 * (1 + w^2 h^2)^(-1/2), the phase goes on by atan(w h). The velocity after n steps, that at the begin being 1. */
static double velocity_after(int n, double wh)
{
    return pow(1.0 + wh * wh, -0.5 * n) * cos(n * atan(wh));
}

/* The middle of what is held and that of mass lie on the line across the faces: a push along it turns nothing, a spin
 * about it moves nothing. From a tenth of a radian a step to a hundredth. */
static void held_needle_oscillates_as_backward_euler(void **state)
{
    (void)state;
    const double steps[3] = {1e-5, 3e-6, 1e-6};
    for (int k = 0; k < 6; k++) {
        needles_rig r;
        hold_fast(&r);
        bool turns = k >= 3;
        const vbss_needle_mass m = needles_mass(&r);
        scene_rigid *n = needle_of(&r);
        double h = steps[k % 3], inertia = m.inertia[0]; /* about the middle of the arc */
        double w = turns ? sqrt(r.tools.config.needle_turning_stiffness / inertia)
                         : sqrt(r.tools.config.needle_stiffness / m.mass);
        double begin = turns ? 100.0 : 1.0, worst = 0.0;
        vec3 *speed = turns ? &n->body.now.w : &n->body.now.v;
        *speed = vec3_make(begin, 0.0, 0.0);
        for (int i = 1; i <= 400; i++) {
            small_steps(&r.tools.s, 1, h);
            worst = vbss_max(worst, fabs(speed->x / begin - velocity_after(i, w * h)));
            assert_true(hypot(speed->y, speed->z) < 1e-3 * begin);
        }
        assert_true(worst < 5e-4);
        expect_near(0.0, tools_grasp(&r.tools, 0, 0).slid, 0.0);
        needles_end(&r);
    }
}

/* About an axis in the faces it is half as stiff as about their normal: turned by its weight, which is beside the jaws. */
static void held_needle_tilts_by_weight(void **state)
{
    (void)state;
    needles_rig r;
    hold_fast(&r);
    scene_rigid *n = needle_of(&r);
    pose before = n->body.now.pose;
    vec3 held = vec3_load(tools_grasp(&r.tools, 0, 0).position);
    double arm = fabs(before.position.x - held.x), weight = 1e-3 / arm; /* 1e-3 N m */
    n->body.gravity = vec3_make(0.0, -weight / n->body.mass, 0.0);
    n->body.drag = 1e3;
    tools_steps(&r.tools, 1000);
    const scene_needle_grasp *hold =
        &vbss_scene_body(small_object(&r.tools.s), r.tools.bodies[0])->rigid.needle_grasp;
    quat q = quat_mul(n->body.now.pose.orientation, quat_conjugate(before.orientation));
    vec3 turn = vbss_quat_to_rotation_vector(q);
    double angle = 1e-3 / (0.5 * r.tools.config.needle_turning_stiffness);
    expect_near(angle, fabs(turn.z), 1e-3 * angle);
    expect_near(weight, hold->force.y, 1e-6 * weight);
    expect_near(1e-3, fabs(hold->torque.z), 1e-6);
    double sunk = held.y - tools_grasp(&r.tools, 0, 0).position[1];
    expect_near(weight / r.tools.config.needle_stiffness, sunk, 1e-3 * sunk);
    needles_end(&r);
}

/* ---- the swage */

typedef struct strung {
    needles_rig rig;
    double thread_mass, length;
} strung;

static vec3 swage_of(const needles_rig *r)
{
    return vec3_load(needles_state(r).swage);
}

/* A needle in jaws, its thread hanging from the swage. */
static void begin_strung(strung *g)
{
    enum { SEGMENTS = 40 };
    needles_rig *r = &g->rig;
    uint32_t pin;
    needles_begin_scene(r);
    r->tools.config.stiffness = 2000.0;
    r->tools.config.damping = 10.0;
    needles_hold(r);
    needle_of(r)->body.gravity =
        vec3_make(0.0, 0.0, -9.81); /* or it would fall before the jaws close */
    vbss_thread_config *c = &r->tools.s.thread;
    c->gravity[2] = -9.81;
    c->damping = 20.0;
    c->drag = 5.0;
    g->length = 0.04;
    g->thread_mass = c->linear_density * g->length;
    vec3 swage = swage_of(r);
    r->tools.body =
        small_thread(&r->tools.s, swage, vec3_add(swage, vec3_make(0.0, 0.0, -g->length)), SEGMENTS,
                     &r->tools.thread);
    expect_ok(vbss_scene_pin_thread(r->tools.s.scene, r->tools.body, 0, r->body, NULL, &pin));
}

static void thread_follows_swage(void **state)
{
    (void)state;
    strung g;
    begin_strung(&g);
    needles_rig *r = &g.rig;
    double apart = 0.0, loosest = 0.0;
    vec3 before = swage_of(r);
    for (uint32_t i = 1; i <= 400; i++) {
        double share = i / 400.0, turn = 0.25 * share;
        const double to[3] = {30e-3 * share, 0.0, -2e-3 + 10e-3 * share};
        const double orientation[4] = {cos(turn), 0.0, sin(turn), 0.0};
        expect_ok(vbss_grasper_set_target(r->tools.tools[0], to, orientation));
        tools_steps(&r->tools, 1);
        apart = vbss_max(apart, vec3_distance(swage_of(r), tools_node(&r->tools, 0)));
        loosest = vbss_max(loosest, vec3_distance(swage_of(r), tools_node(&r->tools, 40)));
    }
    assert_true(apart < 1e-15);
    assert_true(vec3_distance(before, swage_of(r)) > 30e-3 &&
                vec3_distance(before, swage_of(r)) < 40e-3);
    assert_true(loosest < g.length * (1.0 + 1e-3));
    assert_int_equal(small_statistics(&r->tools.s).clamped, 0);
    needles_end(r);
}

/* At rest the clamp bears the weights of both, and about the middle of what it holds the torque of both. */
static void jaws_carry_needle_and_thread(void **state)
{
    (void)state;
    strung g;
    begin_strung(&g);
    needles_rig *r = &g.rig;
    tools_steps(&r->tools, 3000);
    const vbss_needle_mass m = needles_mass(r);
    const scene_needle_grasp *hold =
        &vbss_scene_body(small_object(&r->tools.s), r->tools.bodies[0])->rigid.needle_grasp;
    vec3 held = vec3_load(tools_grasp(&r->tools, 0, 0).position);
    vec3 centre = vbss_scene_body(small_object(&r->tools.s), r->body)->rigid.body.now.pose.position;
    vec3 down = vec3_make(0.0, 0.0, -9.81);
    vec3 of_needle = vec3_scale(down, m.mass), of_thread = vec3_scale(down, g.thread_mass);
    vec3 torque = vec3_add(vec3_cross(vec3_sub(centre, held), of_needle),
                           vec3_cross(vec3_sub(swage_of(r), held), of_thread));
    double all = vec3_norm(of_needle) + vec3_norm(of_thread);
    vec3 force = vec3_add(hold->force, vec3_add(of_needle, of_thread));
    assert_true(vec3_norm(force) < 1e-6 * all);
    assert_true(vec3_norm(vec3_add(torque, hold->torque)) < 1e-5 * vec3_norm(torque));
    vec3 seen = vec3_load(tools_grasp(&r->tools, 0, 0).force);
    expect_near(0.0, vec3_distance(seen, hold->force), 0.0);
    needles_end(r);
}

/* ---- torn out */

/* The needle is as good as fast; the jaws are drawn off it, come back shut and aside, and are pushed against it where they
 * held it: once clear of it they touch it there, and nothing goes through. */
static void torn_out_needle_collides_with_jaws(void **state)
{
    (void)state;
    needles_rig r;
    vbss_scene_event event;
    uint32_t torn = 0;
    needles_begin_scene(&r);
    r.tools.config.stiffness = 2000.0;
    r.tools.config.damping = 10.0;
    r.tools.config.closing_force = 1.0;
    needles_hold(&r);
    needle_of(&r)->body.drag = 1e7;
    const vec3 waypoints[4] = {
        {0.0, 0.0, -2e-3}, {0.0, 0.0, 28e-3}, {10e-3, 0.0, 28e-3}, {10e-3, 0.0, -4e-3}};
    for (uint32_t k = 0; k < 3; k++) {
        for (uint32_t i = 1; i <= 400; i++) {
            tools_move(&r.tools, 0, vec3_lerp(waypoints[k], waypoints[k + 1], i / 400.0));
            tools_steps(&r.tools, 1);
            torn += tools_happened(&r.tools, VBSS_SCENE_EVENT_TORN, &event);
        }
    }
    assert_int_equal(torn, 1);
    double middle = 0.5 * r.config.arc * r.config.radius;
    vec3 before = needles_place(&r, middle, NULL);
    tools_move_along(&r.tools, 0, waypoints[3], vec3_make(-5e-3, 0.0, -4e-3), 400);
    double touching = r.tools.config.driver_radius + r.config.wire_radius;
    double apart = tools_state(&r.tools, 0).position[0] - needles_place(&r, middle, NULL).x;
    assert_true(apart > touching && vec3_distance(before, needles_place(&r, middle, NULL)) < 2e-3);
    assert_true(tools_hand_force(&r.tools, 0).x > 1.0);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
    needles_end(&r);
}

/* ---- drawn along itself */

/* A long flat arc, as good as fast, along which the jaws are drawn: it slides through them until its end, whatever the
 * speed. */
static void needle_slides_through_jaws_to_its_end(void **state)
{
    (void)state;
    const double speeds[3] = {0.1, 0.5, 2.0};
    for (int k = 0; k < 3; k++) {
        needles_rig r;
        vbss_scene_event event = {0};
        uint32_t torn = 0;
        double travel = 0.0;
        needles_begin_scene(&r);
        r.tools.config.stiffness = r.tools.config.turning_stiffness = 1e6;
        r.tools.config.damping = 10.0;
        r.tools.config.closing_force = 1.0;
        r.config.radius = 0.2;
        r.config.arc = 0.2;
        needles_hold(&r);
        needle_of(&r)->body.drag = 1e9;
        for (int i = 0; torn == 0 && travel < 0.1; i++) {
            travel += speeds[k] * 1e-3;
            tools_move(&r.tools, 0, vec3_make(0.0, travel, -2e-3));
            tools_steps(&r.tools, 1);
            torn += tools_happened(&r.tools, VBSS_SCENE_EVENT_TORN, &event);
        }
        assert_int_equal(torn, 1);
        assert_true(event.arc_length == 0.0); /* over its tip */
        expect_near(0.5 * r.config.arc * r.config.radius, travel, 1e-3 + 2e-3 * speeds[k]);
        needles_end(&r);
    }
}

int test_needle_grip(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(held_needle_oscillates_as_backward_euler),
        harness_test(held_needle_tilts_by_weight),
        harness_test(thread_follows_swage),
        harness_test(jaws_carry_needle_and_thread),
        harness_test(torn_out_needle_collides_with_jaws),
        harness_test(needle_slides_through_jaws_to_its_end),
    };
    return cmocka_run_group_tests_name("scene.needle_grip", tests, NULL, NULL);
}
