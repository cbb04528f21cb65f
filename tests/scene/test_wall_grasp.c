/* Jaws that close on the wall of a drain hold it, draw it along, let it slide where they pull too hard, and let it go. */
#include <stdlib.h>

#include "base/elementary.h"
#include "scene/tools_rig.h"

/* From the wall's direction, rad; and how far the handle is open on the way there. */
#define PITCH 0.6
#define OPENING 0.5

typedef struct wall_rig {
    tools_rig tools;
    vbss_drain *drain;
    uint32_t body, lip; /* the lip's middle node on the right */
    vec3 ahead, tip;    /* where the jaws point; where their tip is when they straddle the wall */
    double turn[4];
} wall_rig;

static vec3 node_at(const wall_rig *r, uint32_t node)
{
    vbss_view view;
    expect_ok(vbss_drain_get_view(r->drain, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view));
    return ((const vec3 *)view.data)[node];
}

/* Over the right lip, one jaw outside, one in the lumen, 2.5 mm of wall between them. */
static void begin(wall_rig *r)
{
    drain_object *d;
    memset(r, 0, sizeof *r);
    tools_begin(&r->tools);
    r->tools.s.config.contact_capacity = 4096;
    r->tools.s.config.candidate_capacity = 65536;
    r->tools.config.stiffness = 2000.0;
    r->tools.config.damping = 10.0;
    small_create(&r->tools.s);
    r->body = small_drain(&r->tools.s, &r->drain);
    expect_ok(vbss_drain_open(r->drain, &d));
    r->lip = d->mesh.slit_middle[DRAIN_RIGHT];
    vec3 lip = node_at(r, r->lip);
    /* They come from above on the left and point down to the right, so that one goes through the slit. */
    double angle = vbss_atan2(lip.z, lip.y) + PITCH, sine, cosine;
    const double half = 0.5 * angle, quarter = sqrt(0.5);
    vbss_sincos(angle, &sine, &cosine);
    vec3 out = vec3_make(0.0, cosine, sine);
    r->ahead = vec3_cross(vec3_make(1.0, 0.0, 0.0), out);
    r->tip = vec3_add_scaled(lip, 2.5e-3, r->ahead);
    /* Shaft along z = -ahead, jaws open along x = out: y = z x x is along the drain. */
    quat axes = quat_make(0.5, 0.5, 0.5, 0.5); /* x to y, y to z, z to x */
    quat swing = quat_make(quarter, 0.0, quarter, 0.0);
    quat about = quat_make(vbss_cos(half), vbss_sin(half), 0.0, 0.0);
    quat turn = quat_mul(about, quat_mul(swing, axes));
    vec3 z = quat_rotate(turn, vec3_make(0.0, 0.0, 1.0)),
         x = quat_rotate(turn, vec3_make(1.0, 0.0, 0.0));
    expect_near(0.0, vec3_distance(z, vec3_neg(r->ahead)), 1e-12);
    expect_near(0.0, vec3_distance(x, out), 1e-12);
    r->turn[0] = turn.w;
    r->turn[1] = turn.x;
    r->turn[2] = turn.y;
    r->turn[3] = turn.z;
    vec3 from = vec3_add_scaled(r->tip, -12e-3, r->ahead);
    (void)tools_add_turned(&r->tools, from, turn);
    tools_open(&r->tools, 0, OPENING);
    tools_steps(&r->tools, 100);
    tools_move_along(&r->tools, 0, from, r->tip, 200);
}

static void pinch(wall_rig *r)
{
    begin(r);
    tools_close(&r->tools, 0);
}

static void end(wall_rig *r)
{
    tools_end(&r->tools);
}

static void jaws_grasp_wall(void **state)
{
    (void)state;
    wall_rig r;
    vbss_scene_event event = {0};
    uint32_t begun = 0;
    begin(&r);
    vec3 before = node_at(&r, r.lip);
    tools_open(&r.tools, 0, 0.0);
    for (uint32_t i = 0; i < 300; i++) {
        tools_steps(&r.tools, 1);
        begun += tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event);
    }
    assert_int_equal(begun, 1);
    assert_int_equal(event.body_a, r.body);
    assert_int_equal(event.body_b, r.tools.bodies[0]);
    vbss_grasper_state tool = tools_state(&r.tools, 0);
    assert_int_equal(tool.grasp_count, 1);
    expect_near(r.tools.config.closing_force, tool.pressure, 1e-12);
    vbss_scene_grasp grasp = tools_grasp(&r.tools, 0, 0);
    assert_int_equal(grasp.body, r.body);
    expect_near(2.0 * r.tools.config.grip_friction * tool.pressure, grasp.limit, 1e-12);
    /* They leave as much room as the wall takes, and draw it to their middle by little. */
    double depth = r.tools.config.driver_length - 3e-3;
    expect_near(asin(0.5e-3 / depth), tool.jaw_angle, 0.01);
    assert_true(vec3_distance(before, node_at(&r, r.lip)) < 1e-3);
    assert_int_equal(small_statistics(&r.tools.s).clamped, 0);
    end(&r);
}

static void wall_follows_tool(void **state)
{
    (void)state;
    wall_rig r;
    pinch(&r);
    vec3 before = node_at(&r, r.lip), up = vec3_make(0.0, 3e-3, 0.0);
    tools_move_along(&r.tools, 0, r.tip, vec3_add(r.tip, up), 300);
    tools_steps(&r.tools, 300);
    vec3 rise = vec3_sub(node_at(&r, r.lip), before);
    assert_true(rise.y > 2e-3 && rise.y < 4e-3);
    vec3 hand = tools_hand_force(&r.tools, 0);
    vbss_scene_grasp grasp = tools_grasp(&r.tools, 0, 0);
    assert_true(grasp.force[1] > 0.05 && grasp.force[1] < 2.0);
    expect_near(-grasp.force[1], hand.y,
                0.02 * grasp.force[1]); /* what the jaws pull, the hand feels */
    expect_near(0.0, grasp.slid, 0.0);
    end(&r);
}

static void released_wall_springs_back(void **state)
{
    (void)state;
    wall_rig r;
    vbss_scene_event event;
    uint32_t let_go = 0;
    drain_object *d;
    begin(&r);
    expect_ok(vbss_drain_open(r.drain, &d));
    vec3 rest = d->mesh.rest[r.lip];
    tools_close(&r.tools, 0);
    tools_move_along(&r.tools, 0, r.tip, vec3_add(r.tip, vec3_make(0.0, 2e-3, 0.0)), 200);
    tools_open(&r.tools, 0, OPENING);
    for (uint32_t i = 0; i < 200; i++) {
        tools_steps(&r.tools, 1);
        let_go += tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event);
    }
    assert_int_equal(let_go, 1);
    vec3 back = vec3_add_scaled(vec3_add(r.tip, vec3_make(0.0, 2e-3, 0.0)), -15e-3, r.ahead);
    tools_move_along(&r.tools, 0, vec3_add(r.tip, vec3_make(0.0, 2e-3, 0.0)), back, 300);
    tools_steps(&r.tools, 500);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
    expect_near(0.0, vec3_distance(rest, node_at(&r, r.lip)), 0.05e-3);
    assert_int_equal(small_statistics(&r.tools.s).clamped, 0);
    end(&r);
}

static void wall_slides_out_of_overloaded_jaws(void **state)
{
    (void)state;
    wall_rig r;
    vbss_scene_event event;
    uint32_t slips = 0, torn = 0;
    begin(&r);
    scene_body *tool = vbss_scene_body(small_object(&r.tools.s), r.tools.bodies[0]);
    tool->rigid.grasper->config.closing_force = 0.2; /* bears 0.2 N */
    tools_close(&r.tools, 0);
    vec3 back = vec3_add_scaled(r.tip, -12e-3, r.ahead);
    for (uint32_t i = 1; i <= 600; i++) {
        tools_move(&r.tools, 0, vec3_lerp(r.tip, back, i / 600.0));
        tools_steps(&r.tools, 1);
        slips += tools_happened(&r.tools, VBSS_SCENE_EVENT_SLIP, &event);
        torn += tools_happened(&r.tools, VBSS_SCENE_EVENT_TORN, &event);
        if (tools_state(&r.tools, 0).grasp_count > 0) {
            vbss_scene_grasp grasp = tools_grasp(&r.tools, 0, 0);
            /* And what the clamp gains in a step. */
            double lag = r.tools.config.needle_stiffness * 12e-3 / 600.0;
            assert_true(vec3_norm(vec3_load(grasp.force)) < 1.1 * (grasp.limit + lag));
        }
    }
    assert_true(slips > 0);
    assert_int_equal(torn, 1);
    assert_int_equal(small_statistics(&r.tools.s).clamped, 0);
    end(&r);
}

/* Torn out, the jaws are drawn off it, still shut, and pushed on to where they held it: once clear they touch the wall there. */
static void torn_out_wall_collides_with_jaws(void **state)
{
    (void)state;
    wall_rig r;
    vbss_scene_event event;
    uint32_t torn = 0;
    begin(&r);
    scene_body *tool = vbss_scene_body(small_object(&r.tools.s), r.tools.bodies[0]);
    tool->rigid.grasper->config.closing_force = 0.2;
    tools_close(&r.tools, 0);
    vec3 back = vec3_add_scaled(r.tip, -12e-3, r.ahead);
    for (uint32_t i = 1; i <= 600; i++) {
        tools_move(&r.tools, 0, vec3_lerp(r.tip, back, i / 600.0));
        tools_steps(&r.tools, 1);
        torn += tools_happened(&r.tools, VBSS_SCENE_EVENT_TORN, &event);
    }
    assert_int_equal(torn, 1);
    vec3 lip = node_at(&r, r.lip);
    tools_move_along(&r.tools, 0, back, vec3_add_scaled(r.tip, 1e-3, r.ahead), 600);
    assert_true(vec3_dot(r.ahead, tools_hand_force(&r.tools, 0)) < -0.05);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
    assert_true(vec3_distance(lip, node_at(&r, r.lip)) > 1e-3);
    end(&r);
}

static void restored_grasp_continues_bit_equal(void **state)
{
    (void)state;
    wall_rig r;
    pinch(&r);
    vec3 up = vec3_make(0.0, 1e-3, 0.0);
    tools_move_along(&r.tools, 0, r.tip, vec3_add(r.tip, up), 50);
    small_state saved = small_save(&r.tools.s);
    tools_steps(&r.tools, 30);
    uint64_t wanted = small_hash(&r.tools.s);
    tools_steps(&r.tools, 30);
    expect_ok(vbss_scene_restore(r.tools.s.scene, saved.bytes, saved.count));
    assert_int_equal(tools_state(&r.tools, 0).drain, r.body);
    tools_steps(&r.tools, 30);
    assert_int_equal(wanted, small_hash(&r.tools.s));
    free(saved.bytes);
    end(&r);
}

static void impossible_grasp_is_rejected(void **state)
{
    (void)state;
    const struct {
        double weights[3], depth;
        vbss_result wanted;
    } cases[] = {{{0.2, 0.3, 0.5}, 1.9, VBSS_OK},
                 {{-0.2, 0.3, 0.9}, 1.9, VBSS_ERROR_CORRUPT},
                 {{0.2, 0.3, 0.5}, 2.1, VBSS_ERROR_CORRUPT}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        wall_rig r;
        pinch(&r);
        scene_wall_grasp *p =
            &vbss_scene_body(small_object(&r.tools.s), r.tools.bodies[0])->rigid.wall_grasp;
        memcpy(p->weights[0], cases[i].weights, sizeof cases[i].weights);
        p->points_in_jaws[0] = vec3_make(0.0, 0.0, -cases[i].depth);
        small_state saved = small_save(&r.tools.s);
        assert_int_equal(vbss_scene_restore(r.tools.s.scene, saved.bytes, saved.count),
                         cases[i].wanted);
        free(saved.bytes);
        end(&r);
    }
}

/* A tool that is exchanged, removed, or whose drain is: nobody holds anything. */
static void removal_releases_wall(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        wall_rig r;
        pinch(&r);
        expect_ok(vbss_scene_remove(r.tools.s.scene, k == 0 ? r.body : r.tools.bodies[0]));
        tools_steps(&r.tools, 50);
        if (k == 0) {
            assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
            expect_near(0.0, tools_state(&r.tools, 0).jaw_angle, 0.0);
        } else {
            drain_object *d;
            expect_ok(vbss_drain_open(r.drain, &d));
            tools_steps(&r.tools, 300);
            expect_near(0.0, vec3_distance(d->mesh.rest[r.lip], node_at(&r, r.lip)), 0.02e-3);
        }
        end(&r);
    }
}

int test_wall_grasp(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(jaws_grasp_wall),
        harness_test(wall_follows_tool),
        harness_test(released_wall_springs_back),
        harness_test(wall_slides_out_of_overloaded_jaws),
        harness_test(torn_out_wall_collides_with_jaws),
        harness_test(restored_grasp_continues_bit_equal),
        harness_test(impossible_grasp_is_rejected),
        harness_test(removal_releases_wall),
    };
    return cmocka_run_group_tests_name("scene.wall_grasp", tests, NULL, NULL);
}
