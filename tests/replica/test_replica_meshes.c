/* A visual of a replica, in another context, draws to the bit what a visual of the scene draws. */
#include "rig.h"

#include <string.h>

#include "fixtures/needle_scenes.h"
#include "fixtures/scene_build.h"
#include "fixtures/stitch_scenes.h"
#include "fixtures/tool_run.h"

typedef struct shown {
    harness_memory memories[2];
    vbss_context *contexts[2]; /* of the scene, of the reader */
    vbss_visual *visuals[2];
    vbss_replica *replica;
} shown;

static void begin(shown *s)
{
    for (int i = 0; i < 2; i++) {
        s->contexts[i] = harness_context(&s->memories[i]);
        expect_ok(vbss_visual_create(s->contexts[i], NULL, &s->visuals[i]));
    }
}

static void show(shown *s, vbss_scene *scene)
{
    expect_ok(vbss_replica_create(scene, NULL, &s->replica));
    expect_ok(vbss_visual_add_scene(s->visuals[0], scene, NULL));
    expect_ok(vbss_visual_add_replica(s->visuals[1], s->replica, NULL));
}

static void end(shown *s)
{
    for (int i = 1; i >= 0; i--) {
        harness_context_end(s->contexts[i], &s->memories[i]);
    }
}

static void expect_equal_meshes(const shown *s, vbss_scene *scene)
{
    expect_ok(vbss_replica_publish(s->replica, scene));
    (void)rig_take(s->replica);
    expect_ok(vbss_visual_update(s->visuals[0]));
    expect_ok(vbss_visual_update(s->visuals[1]));
    for (vbss_visual_field field = 0; field < 4; field++) {
        vbss_view of_scene, of_replica;
        expect_ok(vbss_visual_get_view(s->visuals[0], field, &of_scene, sizeof of_scene));
        expect_ok(vbss_visual_get_view(s->visuals[1], field, &of_replica, sizeof of_replica));
        assert_true(of_scene.count == of_replica.count);
        assert_memory_equal(of_scene.data, of_replica.data, of_scene.count * of_scene.stride_bytes);
    }
}

static void meshes_of_tools_and_pieces_are_equal(void **state)
{
    (void)state;
    static shown s;
    tool_run run;
    begin(&s);
    expect_ok(tool_run_create(s.contexts[0], VBSS_METHOD_IMPLICIT, &run));
    show(&s, run.scene);
    for (int i = 0; i < TOOL_RUN_STEPS; i++) {
        expect_ok(tool_run_step(&run));
        expect_equal_meshes(&s, run.scene);
    }
    end(&s);
}

static void meshes_of_drain_and_holes_are_equal(void **state)
{
    (void)state;
    static stitch_scene_options options;
    static stitch_scene stitch;
    static shown s;
    begin(&s);
    expect_ok(stitch_scene_init(&options));
    options.crossings = 1;
    expect_ok(stitch_scene_create(s.contexts[0], &options, &stitch));
    show(&s, stitch.scene);
    for (uint32_t i = 0; i < 20; i++) {
        expect_ok(stitch_scene_tie(&stitch, i, 1e-3));
        expect_equal_meshes(&s, stitch.scene);
    }
    end(&s);
}

static void meshes_of_needle_and_floor_are_equal(void **state)
{
    (void)state;
    static shown s;
    vbss_scene *scene;
    begin(&s);
    expect_ok(needle_scene_create(s.contexts[0], &scene));
    show(&s, scene);
    for (int i = 0; i < 40; i++) {
        expect_ok(needle_scene_step(scene));
        expect_equal_meshes(&s, scene);
    }
    end(&s);
}

/* Capsules turn with their body. */
static void meshes_of_free_bodies_are_equal(void **state)
{
    (void)state;
    static shown s;
    vbss_scene *scene;
    vbss_scene_rigid_config config;
    begin(&s);
    expect_ok(vbss_scene_create(s.contexts[0], NULL, &scene));
    expect_ok(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_SCENE_RIGID_FREE;
    config.velocity[0] = 0.1;
    config.angular_velocity[1] = 20.0;
    expect_ok(scene_build_capsule(
        scene, &config,
        scene_build_rod(vec3_make(0.01, 0.0, 0.0), vec3_make(0.03, 0.01, 0.0), 2e-3), NULL));
    show(&s, scene);
    for (int i = 0; i < 20; i++) {
        expect_ok(vbss_scene_step(scene, 1e-3));
        expect_equal_meshes(&s, scene);
    }
    end(&s);
}

/* Before the first state, and after the replica is gone, nothing is drawn. */
static void replica_without_state_draws_nothing(void **state)
{
    (void)state;
    static shown s;
    tool_run run;
    vbss_visual_statistics statistics;
    begin(&s);
    expect_ok(tool_run_create(s.contexts[0], VBSS_METHOD_IMPLICIT, &run));
    show(&s, run.scene);
    for (int i = 0; i < 3; i++) {
        expect_ok(vbss_visual_update(s.visuals[1]));
        expect_ok(vbss_visual_get_statistics(s.visuals[1], &statistics, sizeof statistics));
        assert_true((statistics.parts > 0) == (i == 1));
        if (i == 0) {
            expect_ok(vbss_replica_publish(s.replica, run.scene));
            (void)rig_take(s.replica);
        } else {
            expect_ok(vbss_replica_destroy(i == 1 ? s.replica : NULL));
        }
    }
    end(&s);
}

int test_replica_meshes(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(meshes_of_tools_and_pieces_are_equal),
        harness_test(meshes_of_drain_and_holes_are_equal),
        harness_test(meshes_of_needle_and_floor_are_equal),
        harness_test(meshes_of_free_bodies_are_equal),
        harness_test(replica_without_state_draws_nothing),
    };
    return cmocka_run_group_tests_name("replica.replica_meshes", tests, NULL, NULL);
}
