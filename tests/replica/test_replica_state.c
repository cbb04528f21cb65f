/* A published state has what the scene itself reports: after each step, and after bodies came and went. */
#include "rig.h"

#include <string.h>

#include "fixtures/scene_build.h"
#include "fixtures/stitch_scenes.h"
#include "fixtures/tool_run.h"

/* Tools pull at a thread, one becomes shears and cuts it. */
static void state_equals_scene_with_tools_and_cuts(void **state)
{
    (void)state;
    harness_memory memory;
    tool_run run;
    vbss_replica *replica;
    vbss_context_statistics before, after;
    vbss_context *context = harness_context(&memory);
    expect_ok(tool_run_create(context, VBSS_METHOD_IMPLICIT, &run));
    expect_ok(vbss_replica_create(run.scene, NULL, &replica));
    for (int i = 0; i < TOOL_RUN_STEPS; i++) {
        expect_ok(tool_run_step(&run));
        expect_ok(vbss_context_get_statistics(context, &before, sizeof before));
        rig_expect_equal(replica, run.scene);
        expect_ok(vbss_context_get_statistics(context, &after, sizeof after));
        assert_true(after.allocation_count == before.allocation_count);
    }
    assert_int_equal(rig_view(replica, VBSS_REPLICA_VIEW_BODIES).count, 4); /* with the piece */
    harness_context_end(context, &memory);
}

/* A thread through two holes of a drain, which hands tie. */
static void state_equals_scene_with_drain_and_holes(void **state)
{
    (void)state;
    static stitch_scene_options options;
    static stitch_scene stitch;
    harness_memory memory;
    vbss_replica *replica;
    vbss_context *context = harness_context(&memory);
    expect_ok(stitch_scene_init(&options));
    options.crossings = 1;
    expect_ok(stitch_scene_create(context, &options, &stitch));
    expect_ok(vbss_replica_create(stitch.scene, NULL, &replica));
    for (uint32_t i = 0; i < 40; i++) {
        expect_ok(stitch_scene_tie(&stitch, i, 1e-3));
        rig_expect_equal(replica, stitch.scene);
    }
    assert_int_equal(rig_view(replica, VBSS_REPLICA_VIEW_HOLES).count, 2);
    assert_true(rig_view(replica, VBSS_REPLICA_VIEW_CONTACTS).count > 0);
    harness_context_end(context, &memory);
}

/* ---- bodies that come and go */

static vbss_drain_config drain_config(double radius, uint32_t divisions)
{
    vbss_drain_config config;
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    config.radius = radius;
    config.mesh_divisions = divisions;
    return config;
}

/* Drains of other meshes take the place of others in each buffer, which keeps meshes from before. */
static void removed_and_added_bodies_are_right_at_once(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_scene_config config;
    vbss_replica_config room;
    vbss_scene *scene;
    vbss_replica *replica;
    vbss_drain *drains[2];
    uint32_t bodies[2];
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    config.drain_capacity = 2;
    config.overlap = VBSS_SCENE_OVERLAP_ALLOW;
    expect_ok(vbss_scene_create(context, &config, &scene));
    expect_ok(vbss_replica_config_init(&room, sizeof room));
    room.drain_node_capacity = 16384;
    expect_ok(vbss_replica_create(scene, &room, &replica));
    const vbss_drain_config kinds[2] = {drain_config(6.5e-3, 1), drain_config(7e-3, 2)};
    for (int k = 0; k < 2; k++) {
        expect_ok(scene_build_drain(context, scene, &kinds[k], &drains[k], &bodies[k]));
        rig_expect_equal(replica, scene);
    }
    for (int i = 0; i < 8; i++) {
        const int k = i % 2;
        expect_ok(vbss_scene_remove(scene, bodies[k]));
        expect_ok(vbss_drain_destroy(drains[k]));
        rig_expect_equal(replica, scene);
        expect_ok(scene_build_drain(context, scene, &kinds[(i / 2) % 2], &drains[k], &bodies[k]));
        for (int again = 0; again < i % 3; again++) {
            rig_expect_equal(replica, scene);
        }
    }
    rig_expect_equal(replica, scene);
    harness_context_end(context, &memory);
}

/* After a change that was published once, each buffer has the constant mesh, and a publication copies little. */
static void mesh_is_copied_once_into_each_buffer(void **state)
{
    (void)state;
    static stitch_scene_options options;
    static stitch_scene stitch;
    harness_memory memory;
    vbss_replica *replica;
    uint64_t bytes[8];
    vbss_context *context = harness_context(&memory);
    expect_ok(stitch_scene_init(&options));
    expect_ok(stitch_scene_create(context, &options, &stitch));
    expect_ok(vbss_replica_create(stitch.scene, NULL, &replica));
    for (int i = 0; i < 8; i++) {
        expect_ok(vbss_replica_publish(replica, stitch.scene));
        bytes[i] = rig_take(replica).bytes;
    }
    assert_true(bytes[0] > 2 * bytes[7]);
    for (int i = 3; i < 8; i++) {
        assert_true(bytes[i] == bytes[7]);
    }
    harness_context_end(context, &memory);
}

/* A scene that does not fit leaves the state of before. */
static void state_beyond_capacity_is_refused_and_the_last_one_stays(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_scene *scene;
    vbss_replica *replica;
    vbss_replica_state taken;
    vbss_drain *drain;
    const char *text;
    const vbss_drain_config config = drain_config(6.5e-3, 1);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_create(context, NULL, &scene));
    expect_ok(vbss_replica_create(scene, NULL, &replica)); /* before the drain: no room for nodes */
    rig_expect_equal(replica, scene);
    expect_ok(scene_build_drain(context, scene, &config, &drain, NULL));
    expect_result(VBSS_ERROR_CAPACITY, vbss_replica_publish(replica, scene));
    expect_ok(vbss_context_get_last_error(context, NULL, &text));
    assert_non_null(strstr(text, "nodes of drains"));
    expect_ok(vbss_replica_take(replica, &taken, sizeof taken));
    assert_true(taken.is_new == 0 && taken.number == 1);
    assert_int_equal(rig_view(replica, VBSS_REPLICA_VIEW_BODIES).count, 0);
    harness_context_end(context, &memory);
}

int test_replica_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(state_equals_scene_with_tools_and_cuts),
        harness_test(state_equals_scene_with_drain_and_holes),
        harness_test(removed_and_added_bodies_are_right_at_once),
        harness_test(mesh_is_copied_once_into_each_buffer),
        harness_test(state_beyond_capacity_is_refused_and_the_last_one_stays),
    };
    return cmocka_run_group_tests_name("replica.replica_state", tests, NULL, NULL);
}
