/* Hard cases that take long: ten knots on a thread, a knot that holds 10 N for a minute, what a feasibility study
 * ran through, and meshes that lost their knots there. */
#include <math.h>

#include "scene/hard_case.h"

static hard_case c;

static contact_scene_options knot_of(knot_kind kind, double force)
{
    contact_scene_options o;
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_PULLED));
    o.knot.kind = kind;
    o.pull.force = force;
    return o;
}

static void ten_knots_on_one_thread(void **state)
{
    (void)state;
    contact_scene_options o;
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_MANY_KNOTS));
    o.pull = (contact_pull){0.2, 2.0, 2000.0};
    hard_begin(&c, "ten knots on one thread", &o, 1e-3);
    assert_true(hard_pull(&c, 1500));
    hard_run(&c, 200);
    hard_report(&c);
    hard_expect_kept(&c);
    assert_int_equal(c.type.determinant, 59049); /* 3^10 */
    hard_expect_same_knot(&c);
    hard_end(&c);
}

/* By less than a thread's radius. */
static void surgeons_knot_holds_10_newtons_for_a_minute(void **state)
{
    (void)state;
    contact_scene_options o = knot_of(KNOT_SURGEON, 10.0);
    o.knot.length = 0.1;
    o.scene.contact_stiffness = 1e6; /* 10 um at 10 N */
    o.pull.stiffness = 2000.0;
    hard_begin(&c, "a surgeon's knot at 10 N for 60 s", &o, 1e-3);
    assert_true(hard_pull(&c, 2000));
    hard_run(&c, 1000);
    uint32_t last = c.scene.nodes[0] - 1;
    double begin = vec3_distance(hard_nodes(&c, 0)[0], hard_nodes(&c, 0)[last]);
    hard_run(&c, 60000);
    double end = vec3_distance(hard_nodes(&c, 0)[0], hard_nodes(&c, 0)[last]);
    print_message("creep in 60 s: %.3g um\n", 1e6 * (end - begin));
    assert_true(fabs(end - begin) < o.thread.radius);
    hard_report(&c);
    hard_expect_kept(&c);
    hard_expect_same_knot(&c);
    hard_end(&c);
}

static void all_combinations_hold_2_newtons(void **state)
{
    (void)state;
    static const double friction[] = {0.1, 0.3, 0.6}, finest[] = {0.3e-3, 0.5e-3},
                        speed[] = {0.01, 0.05};
    for (int run = 0; run < 24; run++) {
        char name[96];
        bool twice = run % 2 == 1;
        contact_scene_options o = knot_of(twice ? KNOT_DOUBLE_OVERHAND : KNOT_OVERHAND, 2.0);
        o.scene.thread_friction = friction[run / 2 % 3];
        o.knot.finest = finest[run / 6 % 2];
        o.pull.speed = speed[run / 12];
        (void)snprintf(name, sizeof name, "%s, friction %g, l %g mm, %g mm/s",
                       knot_names[o.knot.kind], o.scene.thread_friction, 1e3 * o.knot.finest,
                       1e3 * o.pull.speed);
        hard_begin(&c, name, &o, 1e-3);
        assert_true(hard_pull(&c, 4000));
        hard_run(&c, 1000);
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

/* Five diameters a segment. */
static void coarse_meshes_keep_knots(void **state)
{
    (void)state;
    for (int run = 0; run < 16; run++) {
        char name[96];
        contact_scene_options o = knot_of(run % 2 == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, 2.0);
        o.knot.finest = o.knot.coarsest = 1.25e-3;
        o.scene.thread_friction = run / 2 % 2 == 0 ? 0.1 : 0.3;
        o.pull.speed = run / 4 % 2 == 0 ? 0.025 : 0.1;
        o.thread.axial_stiffness = run / 8 == 0 ? 427.0 : 4000.0;
        (void)snprintf(name, sizeof name, "l = 5 D, %s, friction %g, %g mm/s, EA %g N",
                       knot_names[o.knot.kind], o.scene.thread_friction, 1e3 * o.pull.speed,
                       o.thread.axial_stiffness);
        hard_begin(&c, name, &o, 1e-3);
        assert_true(hard_pull(&c, 4000));
        hard_run(&c, 500);
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

static void knots_of_all_kinds_hold_pull(void **state)
{
    (void)state;
    for (knot_kind kind = KNOT_SQUARE; kind < KNOT_KINDS; kind++) {
        contact_scene_options o = knot_of(kind, 2.0);
        o.knot.length = 0.15;
        hard_begin(&c, knot_names[kind], &o, 1e-3);
        assert_true(hard_pull(&c, 2000));
        hard_run(&c, 500);
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

int test_knots_endurance(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ten_knots_on_one_thread),
        cmocka_unit_test(surgeons_knot_holds_10_newtons_for_a_minute),
        cmocka_unit_test(all_combinations_hold_2_newtons),
        cmocka_unit_test(coarse_meshes_keep_knots),
        cmocka_unit_test(knots_of_all_kinds_hold_pull),
    };
    return cmocka_run_group_tests_name("scene.knots_endurance", tests, NULL, NULL);
}
