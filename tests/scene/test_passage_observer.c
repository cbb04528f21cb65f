/* The watch sees what passes, what is below the floor, and what it was not shown. */
#include "scene/hard_case.h"

static hard_case c;

/* As if the scene took a part in which all nodes of the thread move by that displacement. */
static void show(vec3 displacement)
{
    scene_object *s = c.watch.scene;
    thread_object *t = s->bodies[0].thread.thread;
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->trial[i] = vec3_add(t->now.x[i], displacement);
    }
    for (uint32_t k = 0; k < s->capsule_count; k++) {
        s->capsules[k].trial[0] = s->capsules[k].now[0];
        s->capsules[k].trial[1] = s->capsules[k].now[1];
    }
    s->on_substep(s->on_substep_data, s);
}

static void begin(contact_scene_kind kind)
{
    contact_scene_options o;
    expect_ok(contact_scene_init(&o, kind));
    hard_begin(&c, contact_scene_names[kind], &o, 1e-3);
    hard_run(&c, 1);
    assert_int_equal(watch_faults(&c.watch), 0);
    assert_int_equal(c.watch.parts, hard_statistics(&c).parts);
    assert_int_equal(c.watch.first, 0);
}

static void thread_passing_through_tool_is_detected(void **state)
{
    (void)state;
    begin(CONTACT_SCENE_SLIDING_OFF);
    show(vec3_make(0.0, 0.0, 1e-4));
    assert_int_equal(watch_faults(&c.watch), 0);
    watch_again(&c.watch);
    show(vec3_make(0.0, 5e-3, 0.0));
    assert_true(c.watch.passed > 0);
    assert_int_equal(c.watch.below + c.watch.jumps, 0);
    assert_int_equal(c.watch.first, c.watch.parts);
    hard_end(&c);
}

static void thread_below_floor_is_detected(void **state)
{
    (void)state;
    begin(CONTACT_SCENE_DROPPED);
    watch_again(&c.watch);
    c.watch.scene->capsule_count = 0; /* no tools in the way */
    show(vec3_make(0.0, -0.03, 0.0));
    assert_true(c.watch.below > 0);
    c.watch.scene->capsule_count = 2;
    hard_end(&c);
}

static void unseen_substep_is_detected(void **state)
{
    (void)state;
    begin(CONTACT_SCENE_PULLED);
    show(vec3_make(0.0, 1e-6, 0.0)); /* to where it never goes */
    assert_int_equal(c.watch.jumps, 0);
    hard_run(&c, 1);
    assert_int_equal(c.watch.jumps, 1);
    assert_int_equal(c.watch.passed, 0);
    hard_end(&c);
}

/* A rod is shown to cross another. */
static void tools_passing_through_tools_are_detected(void **state)
{
    (void)state;
    begin(CONTACT_SCENE_TOOLS);
    scene_object *s = c.watch.scene;
    watch_again(&c.watch);
    for (uint32_t k = 0; k < s->capsule_count; k++) {
        for (int i = 0; i < 2; i++) {
            s->capsules[k].trial[i] = s->capsules[k].now[i];
            s->capsules[k].trial[i].y -= k == 0 ? 0.01 : 0.0; /* 20 mm high, above one at 13 mm */
        }
    }
    s->on_substep(s->on_substep_data, s);
    assert_int_equal(c.watch.passed, 1);
    assert_int_equal(c.watch.below, 0);
    hard_end(&c);
}

int test_passage_observer(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_passing_through_tool_is_detected),
        cmocka_unit_test(thread_below_floor_is_detected),
        cmocka_unit_test(unseen_substep_is_detected),
        cmocka_unit_test(tools_passing_through_tools_are_detected),
    };
    return cmocka_run_group_tests_name("scene.passage_observer", tests, NULL, NULL);
}
