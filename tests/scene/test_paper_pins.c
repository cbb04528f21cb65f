/* Method VBLAST of scenes: pins on tools, and what cannot be pinned. */
#include "base/elementary.h"
#include "scene/paper_fixture.h"

/* A ball of 2 mm, and a thread of 50 mm that hangs from its middle. Returns the ball. */
static uint32_t hang_from_tool(stage *s, vbss_scene_rigid_kind kind)
{
    vbss_thread_config t = paper_thread(10);
    const double down[3] = {0.0, -1.0, 0.0};
    begin(s);
    s->config.pin_capacity = 2;
    make(s);
    uint32_t tool = add_capsule(s->scene, kind, vec3_zero(), vec3_zero(), 2e-3);
    t.length = 0.05;
    t.attachment_capacity = 3;
    memcpy(t.direction, down, sizeof down);
    add(s, 0, &t);
    return tool;
}

static vec3 place_of(const stage *s, uint32_t node)
{
    uint32_t count;
    return places(s->threads[0], &count)[node];
}

static vec3 point_of(stage *s, uint32_t tool, const double point[3])
{
    vbss_scene_rigid_state r = rigid_of(s, tool);
    const double *q = r.orientation;
    pose at = pose_make(vec3_load(r.position), quat_make(q[0], q[1], q[2], q[3]));
    return pose_apply(at, vec3_load(point));
}

/* The node goes where its point goes, turned with the tool; the thread comes out of it without touching it; the
 * hand carries the weight. A coupled tool is as rigid as a driven one, and a free one stands still. */
static void pinned_node_moves_with_tool(void **state)
{
    (void)state;
    const vbss_scene_rigid_kind kinds[] = {VBSS_SCENE_RIGID_DRIVEN, VBSS_SCENE_RIGID_COUPLED,
                                           VBSS_SCENE_RIGID_FREE};
    for (int k = 0; k < 3; k++) {
        stage s;
        uint32_t pin, tool = hang_from_tool(&s, kinds[k]);
        const double point[3] = {5e-4, 0.0, 0.0};
        expect_ok(vbss_scene_pin_thread(s.scene, s.bodies[0], 0, tool, point, &pin));
        for (int i = 1; i <= 2000; i++) {
            int ramp = i < 500 ? i : 500;
            const double to[3] = {1e-5 * ramp, 0.0, 0.0};
            const double turn[4] = {vbss_cos(5e-4 * ramp), 0.0, 0.0, vbss_sin(5e-4 * ramp)};
            if (kinds[k] != VBSS_SCENE_RIGID_FREE) {
                expect_ok(vbss_scene_set_rigid_target(s.scene, tool, to, turn));
            }
            expect_ok(vbss_scene_step(s.scene, 1e-3));
            expect_near(0.0, vec3_distance(point_of(&s, tool, point), place_of(&s, 0)), 1e-17);
        }
        assert_int_equal(0, statistics_of(&s).contacts);
        expect_near(0.0, statistics_of(&s).penetration, 0.0);
        double weight = 9.81 * 6.4e-5 * 0.05;
        bool handed = kinds[k] != VBSS_SCENE_RIGID_FREE;
        expect_near(-weight, rigid_of(&s, tool).contact_force[1], 1e-3 * weight);
        expect_near(handed ? -weight : 0.0, rigid_of(&s, tool).hand_force[1], 1e-3 * weight);
        expect_ok(vbss_scene_unpin_thread(s.scene, pin));
        for (int i = 0; i < 50; i++) {
            expect_ok(vbss_scene_step(s.scene, 1e-3));
        }
        assert_true(place_of(&s, 0).y < -1e-3); /* it falls */
        end(&s);
    }
}

static void impossible_pins_are_rejected(void **state)
{
    (void)state;
    stage s;
    uint32_t pin, other, tool = hang_from_tool(&s, VBSS_SCENE_RIGID_DRIVEN), body = s.bodies[0];
    const double bad[3] = {0.0, harness_bad_numbers[0], 0.0}, far[3] = {0.0, 0.0, 1001.0};
    const struct {
        vbss_result result;
        uint32_t thread, node, body;
        const double *point;
    } refused[] = {{VBSS_ERROR_OUT_OF_RANGE, body, 11, 0, NULL},
                   {VBSS_ERROR_INCOMPATIBLE, tool, 0, 0, NULL},
                   {VBSS_ERROR_INCOMPATIBLE, body, 0, body, NULL},
                   {VBSS_ERROR_OUT_OF_RANGE, body, 0, tool, far},
                   {VBSS_ERROR_NOT_FINITE, body, 0, tool, bad},
                   {VBSS_ERROR_IN_USE, body, 10, 0, NULL},    /* held by the host */
                   {VBSS_ERROR_IN_USE, body, 3, tool, NULL}}; /* pinned */
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.node = 10;
    expect_ok(vbss_thread_attach(s.threads[0], &a, &other));
    expect_ok(vbss_scene_pin_thread(s.scene, body, 3, 0, NULL, &pin));
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        expect_result(refused[i].result,
                      vbss_scene_pin_thread(s.scene, refused[i].thread, refused[i].node,
                                            refused[i].body, refused[i].point, &other));
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_scene_pin_thread(s.scene, body, 0, tool, NULL, NULL));
    expect_ok(vbss_scene_pin_thread(s.scene, body, 5, tool, NULL, &other));
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_pin_thread(s.scene, body, 7, 0, NULL, &other));
    expect_ok(vbss_scene_unpin_thread(s.scene, pin));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(s.scene, pin));
    expect_ok(vbss_scene_remove(s.scene, tool)); /* with its pin */
    expect_ok(vbss_scene_pin_thread(s.scene, body, 5, 0, NULL, &other));
    end(&s);
}

/* Also where pins were to be taken along. */
static void failed_step_keeps_pins(void **state)
{
    (void)state;
    stage s;
    thread_object *t;
    uint32_t pin, tool = hang_from_tool(&s, VBSS_SCENE_RIGID_DRIVEN);
    expect_ok(vbss_scene_pin_thread(s.scene, s.bodies[0], 0, tool, NULL, &pin));
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    expect_ok(vbss_thread_open(s.threads[0], &t));
    t->now.v[8] = vec3_make(1e40, 0, 0); /* no call gives it that */
    expect_ok(vbss_scene_set_rigid_target(s.scene, tool, (const double[3]){1e-3, 0.0, 0.0}, NULL));
    uint64_t before = hash_of(s.scene);
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_scene_step(s.scene, 1e-3));
    assert_int_equal(before, hash_of(s.scene));
    end(&s);
}

int test_paper_pins(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(pinned_node_moves_with_tool),
        harness_test(impossible_pins_are_rejected),
        harness_test(failed_step_keeps_pins),
    };
    return cmocka_run_group_tests_name("scene.paper_pins", tests, NULL, NULL);
}
