/* The watch sees what passes through a drain, at its sides and through its triangles, and a drain that passes through
 * itself; not what is too near along the surface to touch. */
#include "scene/drain_case.h"

static drain_case c;

typedef struct tally {
    uint64_t passed, passed_drain, below;
} tally;

/* As if the scene took a part that goes from where all is now to the trial state, which the test has set. */
static tally show(void)
{
    const small_watch before = c.watch;
    scene_object *s = small_object(&c.s);
    s->on_substep(s->on_substep_data, s);
    return (tally){c.watch.passed - before.passed, c.watch.passed_drain - before.passed_drain,
                   c.watch.below - before.below};
}

static drain_object *drain_of(void)
{
    drain_object *d;
    expect_ok(vbss_drain_open(c.drain, &d));
    return d;
}

static void rest(void)
{
    scene_object *s = small_object(&c.s);
    drain_object *d = drain_of();
    memcpy(d->trial, d->x, d->mesh.node_count * sizeof *d->x);
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        s->capsules[i].trial[0] = s->capsules[i].now[0];
        s->capsules[i].trial[1] = s->capsules[i].now[1];
    }
}

static void begin(void)
{
    drain_case_begin(&c);
    c.s.config.floor = 1;
    c.s.config.floor_height = -10e-3;
    drain_case_make(&c);
}

/* Through a side or two, or through triangles with its end. */
static void tool_passing_through_wall_is_detected(void **state)
{
    (void)state;
    begin();
    (void)drain_case_tool(&c, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1e-3, 14e-3, 4e-3),
                          vec3_make(0.0, 4e-3, 0.0), 0.5e-3);
    drain_case_wait(&c, 1);
    rest();
    assert_int_equal(show().passed_drain, 0);
    vec3 *ends = small_object(&c.s)->capsules[0].trial;
    for (int k = 0; k < 2; k++) { /* along itself: its end alone meets the wall, in one triangle */
        ends[k].y -= 8e-3;
    }
    assert_int_equal(show().passed_drain, 1);
    assert_int_equal(c.watch.report.first[0].corners, 1);
    assert_int_equal(c.watch.report.first[1].corners, 3);
    rest();
    ends[0].y -= 30e-3; /* through top and bottom */
    assert_int_equal(show().passed_drain, 2);
    drain_case_end(&c);
}

static void tool_sweeping_through_sides_is_detected(void **state)
{
    (void)state;
    begin();
    (void)drain_case_tool(&c, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 9e-3, 0.0),
                          vec3_make(0.0, 0.0, 20e-3), 0.5e-3);
    drain_case_wait(&c, 1);
    rest();
    scene_object *s = small_object(&c.s);
    s->capsules[0].trial[0].y = s->capsules[0].trial[1].y = 0.0;
    tally found = show();
    assert_true(found.passed_drain > 0);
    assert_int_equal(found.passed, 0);
    assert_int_equal(c.watch.report.first[0].corners, 2);
    assert_int_equal(c.watch.report.first[1].corners, 2);
    drain_case_end(&c);
}

static void lip_passing_through_thread_is_detected(void **state)
{
    (void)state;
    begin();
    drain_case_thread(&c, vec3_make(0.0, 2e-3, 0.0), vec3_make(0.0, 12e-3, 0.0), 10);
    drain_case_wait(&c, 1);
    rest();
    thread_object *t;
    expect_ok(vbss_thread_open(c.threads[0], &t));
    memcpy(t->trial, t->now.x, t->node_count * sizeof *t->trial);
    assert_int_equal(show().passed_drain, 0); /* through the open slit */
    drain_object *d = drain_of();
    d->trial[c.places.gap_points[0]].z = 1e-3;
    assert_true(show().passed_drain > 0);
    drain_case_end(&c);
}

static void self_passage_of_drain_is_detected(void **state)
{
    (void)state;
    begin();
    drain_case_wait(&c, 1);
    rest();
    drain_object *d = drain_of();
    uint32_t mark = c.places.marks[0];
    d->trial[mark] = vec3_make(0.0, -8e-3, 0.0); /* through the bottom */
    tally found = show();
    assert_true(found.passed_drain > 0);
    assert_int_equal(found.below, 0);
    d->trial[mark].y = -11e-3;
    assert_int_equal(show().below, 1);
    drain_case_end(&c);
}

/* The lips are joined around the slit's tips only, 10 mm along the surface; not so a node and the triangles around it. */
static void folding_near_along_surface_is_allowed(void **state)
{
    (void)state;
    begin();
    drain_case_wait(&c, 1);
    rest();
    drain_object *d = drain_of();
    uint32_t lip = c.places.gap_points[0];
    d->trial[lip].z = 1.0e-3; /* 0.5 mm off the other lip's */
    assert_int_equal(show().passed_drain, 0);
    d->trial[lip].z = 2.0e-3;
    assert_true(show().passed_drain > 0);
    rest();
    uint32_t mark = c.places.marks[0];
    const vec3 inward = vec3_make(0.0, -4e-3, 2e-3);
    d->trial[mark] = vec3_add(d->x[mark], inward);
    d->trial[mark].x +=
        2e-3; /* beyond its neighbour, 1.7 mm away, and under the triangles beside it */
    assert_int_equal(show().passed_drain, 0);
    drain_case_end(&c);
}

int test_drain_passage_observer(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tool_passing_through_wall_is_detected),
        cmocka_unit_test(tool_sweeping_through_sides_is_detected),
        cmocka_unit_test(lip_passing_through_thread_is_detected),
        cmocka_unit_test(self_passage_of_drain_is_detected),
        cmocka_unit_test(folding_near_along_surface_is_allowed),
    };
    return cmocka_run_group_tests_name("scene.drain_passage_observer", tests, NULL, NULL);
}
