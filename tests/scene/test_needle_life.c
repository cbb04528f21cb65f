/* Whose a needle is, in which order scenes, needles, tools and contexts may end, held or not, and what is refused. */
#include "base/error.h"
#include "scene/needles_rig.h"
#include "fixtures/needle_scenes.h"

static uint64_t own_hash(vbss_needle *needle)
{
    uint64_t hash = 0;
    expect_ok(vbss_needle_get_hash(needle, &hash));
    return hash;
}

static void expect_owned(vbss_needle *needle, bool owned)
{
    uint8_t bytes[2048];
    const double there[3] = {0.0, 0.0, 0.1};
    vbss_result wanted = owned ? VBSS_ERROR_IN_SCENE : VBSS_OK;
    vbss_needle_state state;
    uint64_t count, hash = own_hash(needle);
    expect_ok(vbss_needle_save(needle, bytes, sizeof bytes, &count));
    expect_ok(vbss_needle_get_state(needle, &state, sizeof state));
    assert_int_equal(state.body != 0, owned);
    expect_result(wanted, vbss_needle_step(needle, 1e-3));
    expect_result(wanted, vbss_needle_set_state(needle, there, NULL, NULL, NULL));
    expect_result(wanted, vbss_needle_restore(needle, bytes, count));
    if (owned) {
        expect_result(wanted, vbss_needle_destroy(needle));
    }
    assert_true(own_hash(needle) == hash);
}

static void needle_belongs_to_scene_until_removed(void **state)
{
    (void)state;
    for (int end = 0; end < 2; end++) {
        needles_rig r;
        vbss_scene *other;
        uint32_t body = 77;
        needles_begin_scene(&r);
        small *s = &r.tools.s;
        expect_ok(vbss_scene_create(s->context, &s->config, &other));
        r.config.gravity[2] = -9.81;
        r.config.velocity[0] = 0.1;
        needles_add(&r);
        expect_owned(r.needle, true);
        expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_needle(other, r.needle, &body));
        expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_needle(s->scene, r.needle, &body));
        assert_int_equal(body, 77);
        small_steps(s, 20, 1e-3);
        expect_owned(r.needle, true);
        vbss_needle_state before = needles_state(&r);
        if (end == 0) {
            expect_ok(vbss_scene_remove(s->scene, r.body));
            expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_remove(s->scene, r.body));
        } else {
            expect_ok(vbss_scene_destroy(s->scene));
        }
        /* It goes on from where it was, as fast. */
        vbss_needle_state after = needles_state(&r);
        before.body = 0;
        assert_memory_equal(&before, &after, sizeof before);
        expect_owned(r.needle, false);
        expect_ok(vbss_scene_add_needle(other, r.needle, &body)); /* and somebody else's */
        expect_owned(r.needle, true);
        expect_ok(vbss_scene_step(other, 1e-3));
        expect_ok(vbss_scene_remove(other, body));
        expect_ok(vbss_needle_destroy(r.needle));
        needles_end(&r);
    }
}

/* ---- refused, and nothing has changed */

static void expect_refused(small *s, vbss_result wanted, vbss_needle *needle)
{
    uint32_t body = 77;
    const char *text;
    uint64_t hash = small_hash(s), generation = small_view(s, VBSS_SCENE_VIEW_EVENTS).generation;
    uint64_t blocks = s->memory.blocks;
    expect_result(wanted, vbss_scene_add_needle(s->scene, needle, &body));
    expect_ok(vbss_context_get_last_error(s->context, NULL, &text));
    assert_true(strlen(text) > 0);
    assert_int_equal(body, 77);
    assert_int_equal(s->memory.blocks, blocks);
    assert_true(small_hash(s) == hash);
    assert_true(small_view(s, VBSS_SCENE_VIEW_EVENTS).generation == generation);
}

static void invalid_needle_is_rejected(void **state)
{
    (void)state;
    needles_rig r;
    small other;
    vbss_needle *foreign, *needle, *gone, *papers;
    uint32_t body = 77;
    needles_begin_scene(&r);
    small *s = &r.tools.s;
    small_begin(&other);
    expect_ok(vbss_needle_create(other.context, &r.config, &foreign));
    expect_ok(vbss_needle_create(s->context, &r.config, &needle));
    expect_ok(vbss_needle_create(s->context, &r.config, &gone));
    expect_ok(vbss_needle_destroy(gone));
    r.config.method = VBSS_METHOD_PAPER;
    expect_ok(vbss_needle_create(s->context, &r.config, &papers));
    expect_refused(s, VBSS_ERROR_INVALID_HANDLE, foreign);
    expect_refused(s, VBSS_ERROR_INVALID_HANDLE, gone);
    expect_refused(s, VBSS_ERROR_INVALID_HANDLE, (vbss_needle *)s->scene);
    expect_refused(s, VBSS_ERROR_OUT_OF_RANGE, papers);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_add_needle(s->scene, NULL, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_add_needle(NULL, needle, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_add_needle((vbss_scene *)needle, needle, &body));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_needle(s->scene, needle, NULL));
    assert_int_equal(body, 77);
    expect_ok(vbss_needle_step(foreign, 1e-3)); /* all of them are as free as before */
    expect_ok(vbss_needle_step(needle, 1e-3));
    expect_ok(vbss_needle_step(papers, 1e-3));
    small_end(&other);
    needles_end(&r);
}

/* Either way. */
static void needle_of_other_method_is_rejected(void **state)
{
    (void)state;
    for (int method = VBSS_METHOD_OURS; method <= VBSS_METHOD_PAPER; method++) {
        needles_rig r;
        needles_begin(&r);
        r.tools.s.config.method = VBSS_METHOD_OURS + VBSS_METHOD_PAPER - method;
        small_create(&r.tools.s);
        r.config.method = method;
        expect_ok(vbss_needle_create(r.tools.s.context, &r.config, &r.needle));
        expect_refused(&r.tools.s, VBSS_ERROR_OUT_OF_RANGE, r.needle);
        needles_end(&r);
    }
}

static void needle_needs_capacity(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) { /* for bodies, for capsules */
        needles_rig r;
        vbss_needle *one_more;
        uint32_t body = 0;
        needles_begin(&r);
        r.tools.s.config.rigid_capacity = k == 0 ? 1 : 8;
        r.tools.s.config.capsule_capacity = k == 0 ? 64 : 2 * r.config.segment_count - 1;
        small_create(&r.tools.s);
        needles_add(&r);
        r.config.position[0] = 0.1;
        expect_ok(vbss_needle_create(r.tools.s.context, &r.config, &one_more));
        expect_refused(&r.tools.s, VBSS_ERROR_CAPACITY, one_more);
        small_steps(&r.tools.s, 2, 1e-3);
        expect_refused(&r.tools.s, VBSS_ERROR_CAPACITY, one_more);
        expect_ok(vbss_scene_remove(r.tools.s.scene, r.body));
        expect_ok(vbss_scene_add_needle(r.tools.s.scene, one_more, &body));
        assert_int_equal(body, r.body + 1);
        small_steps(&r.tools.s, 2, 1e-3);
        needles_end(&r);
    }
}

/* ---- what is held goes */

/* Without an event: what is no longer there was not let go. The jaws close on. */
static void held_needle_can_be_removed(void **state)
{
    (void)state;
    needles_rig r;
    vbss_grasp grasp;
    uint32_t event[4], body;
    needles_begin_scene(&r);
    needles_hold(&r);
    small *s = &r.tools.s;
    double angle = tools_state(&r.tools, 0).jaw_angle;
    assert_true(angle > 0.02);
    expect_ok(vbss_scene_remove(s->scene, r.body));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_get_grasp(s->scene, r.tools.bodies[0], 0, &grasp, sizeof grasp));
    for (int i = 0; i < 20; i++) {
        tools_steps(&r.tools, 1);
        assert_int_equal(tools_happened(&r.tools, VBSS_EVENT_RELEASE, event), 0);
        assert_int_equal(tools_happened(&r.tools, VBSS_EVENT_TORN, event), 0);
    }
    vbss_grasper_state tool = tools_state(&r.tools, 0);
    assert_int_equal(tool.grasp_count, 0);
    expect_near(0.0, tool.jaw_angle, 0.0);
    expect_near(0.0, tool.pressure, 0.0);
    expect_ok(vbss_needle_step(r.needle, 1e-3));
    /* A needle that comes back, elsewhere, is not held. */
    const double far[3] = {0.1, 0.0, 0.0};
    expect_ok(vbss_needle_set_state(r.needle, far, NULL, NULL, NULL));
    expect_ok(vbss_scene_add_needle(s->scene, r.needle, &body));
    tools_steps(&r.tools, 20);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
    needles_end(&r);
}

static void holding_tool_can_be_removed(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    needles_hold(&r);
    expect_ok(vbss_scene_remove(r.tools.s.scene, r.tools.bodies[0]));
    expect_ok(vbss_grasper_destroy(r.tools.tools[0]));
    scene_body *b = vbss_scene_body(small_object(&r.tools.s), r.body);
    b->rigid.body.gravity = vec3_make(0.0, 0.0, -9.81);
    double before = needles_state(&r).position[2];
    tools_steps(&r.tools, 100);
    expect_near(-0.5 * 9.81 * 0.1 * 0.101, needles_state(&r).position[2] - before, 1e-5);
    needles_end(&r);
}

/* Its thread stays, and is pinned to nothing. */
static void swaged_needle_can_be_removed(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    expect_ok(needle_scene_create(s.context, &s.scene));
    for (int i = 0; i < NEEDLE_SCENE_LIFTED; i++) {
        expect_ok(needle_scene_step(s.scene));
    }
    expect_ok(vbss_scene_remove(s.scene, NEEDLE_SCENE_NEEDLE));
    for (int i = 0; i < 200; i++) {
        expect_ok(needle_scene_step(s.scene));
    }
    const thread_object *t = vbss_scene_body(small_object(&s), NEEDLE_SCENE_THREAD)->thread.thread;
    assert_true(t->now.x[0].z < 1e-3); /* it has fallen on the floor */
    small_end(&s);
}

/* ---- ends, in any order */

static void context_end_destroys_in_any_order(void **state)
{
    (void)state;
    for (int order = 0; order < 16; order++) {
        needles_rig r;
        vbss_needle *before;
        uint32_t body;
        needles_begin(&r);
        r.config.position[2] = 0.1;
        expect_ok(vbss_needle_create(r.tools.s.context, &r.config, &before));
        small_create(&r.tools.s);
        r.config.position[2] = 0.0;
        needles_hold(&r);
        if ((order & 1) != 0) {
            expect_ok(vbss_scene_add_needle(r.tools.s.scene, before, &body));
        }
        if ((order & 2) != 0) {
            tools_open(&r.tools, 0, 1.0);
        }
        tools_steps(&r.tools, 1);
        if ((order & 4) != 0) {
            expect_ok(vbss_scene_destroy(r.tools.s.scene));
            expect_ok(vbss_needle_step(r.needle, 1e-3));
        }
        if ((order & 4) != 0 && (order & 8) != 0) {
            expect_ok(vbss_needle_destroy(r.needle));
            expect_ok(vbss_grasper_destroy(r.tools.tools[0]));
        }
        needles_end(&r);
    }
}

/* ---- memory */

static vbss_result fill(vbss_scene *scene, vbss_needle *needle)
{
    uint32_t body;
    VBSS_TRY(vbss_scene_add_needle(scene, needle, &body));
    VBSS_TRY(vbss_scene_step(scene, 1e-3));
    return vbss_scene_remove(scene, body);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    vbss_scene *scene;
    vbss_needle *needle = NULL;
    uint64_t hash;
    VBSS_TRY(vbss_scene_create(context, user, &scene));
    vbss_result result = vbss_needle_create(context, NULL, &needle);
    if (result == VBSS_OK) {
        result = fill(scene, needle);
    }
    VBSS_TRY(vbss_scene_get_hash(scene, &hash)); /* whatever failed, it is a scene */
    VBSS_TRY(vbss_scene_destroy(scene));
    VBSS_TRY(vbss_needle_destroy(needle)); /* and that is the host's */
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    config.node_capacity = 20;
    config.contact_capacity = 16;
    config.candidate_capacity = 64;
    harness_fail_every_allocation(attempt, &config);
}

static void needle_churn_does_not_grow_memory(void **state)
{
    (void)state;
    needles_rig r;
    uint64_t blocks = 0;
    needles_begin_scene(&r);
    needles_add(&r);
    for (int i = 0; i < 12; i++) {
        small_steps(&r.tools.s, 2, 1e-3);
        expect_ok(vbss_scene_remove(r.tools.s.scene, r.body));
        blocks = i == 0 ? r.tools.s.memory.blocks : blocks;
        assert_int_equal(r.tools.s.memory.blocks, blocks);
        small_steps(&r.tools.s, 1, 1e-3);
        expect_ok(vbss_scene_add_needle(r.tools.s.scene, r.needle, &r.body));
    }
    needles_end(&r);
}

int test_needle_life(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(needle_belongs_to_scene_until_removed),
        harness_test(invalid_needle_is_rejected),
        harness_test(needle_of_other_method_is_rejected),
        harness_test(needle_needs_capacity),
        harness_test(held_needle_can_be_removed),
        harness_test(holding_tool_can_be_removed),
        harness_test(swaged_needle_can_be_removed),
        harness_test(context_end_destroys_in_any_order),
        harness_test(each_failed_allocation_is_reported_without_leak),
        harness_test(needle_churn_does_not_grow_memory),
    };
    return cmocka_run_group_tests_name("scene.needle_life", tests, NULL, NULL);
}
