/* Knots and threads alone where contact is hard: fast, without friction or with much, soft and stiff, in coarse
 * steps, torn at. Each ends with nothing passed in any part, decided exactly, its knot the one it was, and
 * lengths and overlap bounded except where counted. */
#include <math.h>

#include "scene/hard_case.h"

static hard_case c;

static contact_scene_options options_of(contact_scene_kind kind)
{
    contact_scene_options o;
    expect_ok(contact_scene_init(&o, kind));
    return o;
}

static contact_scene_options knot_of(knot_kind kind, double force)
{
    contact_scene_options o = options_of(CONTACT_SCENE_PULLED);
    o.knot.kind = kind;
    o.pull.force = force;
    return o;
}

/* Pulled, held, at rest. */
static void expect_holds(const char *name, const contact_scene_options *o, double h)
{
    hard_begin(&c, name, o, h);
    assert_true(hard_pull(&c, (uint32_t)(1.0 / h)));
    hard_run(&c, (uint32_t)(0.3 / h));
    hard_expect_at_rest(&c, 100);
    hard_report(&c);
    hard_expect_kept(&c);
    hard_expect_same_knot(&c);
    hard_end(&c);
}

/* ---- how it is pulled */

static void knots_tighten_at_200_mm_per_second(void **state)
{
    (void)state;
    for (int soft = 0; soft < 2; soft++) {
        for (int kind = 0; kind < 2; kind++) {
            contact_scene_options o =
                knot_of(kind == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, 2.0);
            o.pull.speed = 0.2;
            o.pull.stiffness = soft ? 2000.0 : 0.0;
            o.thread.axial_stiffness = soft ? 4000.0 : 427.0;
            expect_holds(soft ? "200 mm/s, hands of 2 N/mm" : "200 mm/s, rigid hands", &o, 1e-3);
        }
    }
}

static void tight_knot_survives_20_newton_step(void **state)
{
    (void)state;
    contact_scene_options o = knot_of(KNOT_DOUBLE_OVERHAND, 1.0);
    o.thread.axial_stiffness = 427.0;
    o.scene.contact_stiffness = 1e6;
    hard_begin(&c, "from 1 N to 20 N in a step", &o, 1e-3);
    assert_true(hard_pull(&c, 1000));
    hard_run(&c, 50);
    for (int k = 0; k < 2; k++) {
        c.scene.hands[k].pull = (contact_pull){5.0, 20.0, 0.0};
    }
    hard_run(&c, 300);
    expect_near(20.0, contact_scene_pull_felt(&c.scene), 1.0);
    for (int k = 0; k < 2; k++) { /* and let go as fast */
        c.scene.hands[k].pull = (contact_pull){5.0, 0.1, 0.0};
    }
    hard_run(&c, 200);
    hard_expect_at_rest(&c, 100);
    hard_report(&c);
    hard_expect_kept(&c);
    hard_expect_same_knot(&c);
    hard_end(&c);
}

static void teleported_hand(void **state)
{
    (void)state;
    static const vec3 displacements[] = {
        {-0.02, 0.0, 0.0}, {0.0, 0.02, 0.0}, {0.0, 0.0, -0.02}, {-0.01, 0.01, 0.01}};
    for (int k = 0; k < 4; k++) {
        contact_scene_options o = knot_of(KNOT_OVERHAND, 1.0);
        hard_begin(&c, "an end teleported by 20 mm", &o, 1e-3);
        assert_true(hard_pull(&c, 1000));
        contact_hand *hand = &c.scene.hands[1];
        double target[3];
        vec3_store(target, vec3_add(hard_nodes(&c, 0)[hand->node], displacements[k]));
        expect_ok(vbss_thread_set_attachment_target(hand->thread, hand->id, target, NULL));
        expect_ok(vbss_scene_step(c.scene.scene, c.h));
        hard_run(&c, 300); /* the hands pull again */
        hard_expect_at_rest(&c, 100);
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

/* A hand lets go and a weight hangs on in its place; then the other hand comes back by a millimetre at once. */
static void dead_load_on_knot(void **state)
{
    (void)state;
    for (int heavy = 0; heavy < 2; heavy++) {
        contact_scene_options o = knot_of(KNOT_OVERHAND, 0.5);
        hard_begin(&c, heavy ? "a dead load of 50 g" : "a dead load without mass", &o, 1e-3);
        assert_true(hard_pull(&c, 1000));
        vbss_thread_attachment load;
        uint32_t id, last = c.scene.nodes[0] - 1;
        expect_ok(vbss_thread_attachment_init(&load, sizeof load));
        load.node = last;
        load.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        load.force[0] = 0.5;
        expect_ok(contact_hand_release(&c.scene.hands[1]));
        expect_ok(vbss_thread_attach(c.scene.threads[0], &load, &id));
        load.kind = VBSS_THREAD_ATTACHMENT_MASS;
        load.mass = heavy ? 0.05 : 0.0;
        expect_ok(vbss_thread_attach(c.scene.threads[0], &load, &id));
        hard_run(&c, 100);
        double target[3];
        vec3_store(target, vec3_add(hard_nodes(&c, 0)[0], vec3_make(1e-3, 0.0, 0.0)));
        expect_ok(vbss_thread_set_attachment_target(c.scene.threads[0], c.scene.hands[0].id, target,
                                                    NULL));
        for (int i = 0; i < 200; i++) {
            expect_ok(vbss_scene_step(c.scene.scene, c.h));
            assert_true(hard_fastest(&c) < 10.0);
        }
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

/* ---- what it is */

/* Without friction nothing holds a knot at 2 N: steps have a bound, and nothing passes. */
static void zero_and_high_friction(void **state)
{
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        contact_scene_options o = knot_of(kind == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, 2.0);
        o.scene.thread_friction = 1.0;
        expect_holds("friction 1", &o, 1e-3);
        o.scene.thread_friction = 0.0;
        hard_begin(&c, "friction 0", &o, 1e-3);
        assert_true(hard_pull(&c, 1000));
        hard_run(&c, 300);
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

static void soft_and_stiff_axially(void **state)
{
    (void)state;
    static const double stiffness[] = {10.0, 100.0, 427.0, 4000.0, 1e4};
    for (int k = 0; k < 5; k++) {
        char name[64];
        (void)snprintf(name, sizeof name, "EA = %g N", stiffness[k]);
        contact_scene_options o = knot_of(k % 2 == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, 2.0);
        o.thread.axial_stiffness = stiffness[k];
        expect_holds(name, &o, 1e-3);
    }
}

static void limp_and_stiff_in_bending(void **state)
{
    (void)state;
    static const double stiffness[] = {0.0, 1e-12, 1e-10, 1e-9, 1e-7, 1e-6};
    for (int k = 0; k < 6; k++) {
        char name[64];
        (void)snprintf(name, sizeof name, "EI = %g N m^2", stiffness[k]);
        contact_scene_options o = knot_of(k % 2 == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, 2.0);
        o.thread.bending_stiffness = stiffness[k];
        if (stiffness[k] > 1e-7) { /* tied loosely, or it springs open */
            o.knot.size = 2e-3;
            o.knot.length = 0.12;
        }
        expect_holds(name, &o, 1e-3);
    }
}

static void short_and_long_steps(void **state)
{
    (void)state;
    static const double steps[] = {5e-4, 1e-3, 2e-3};
    for (int k = 0; k < 3; k++) {
        for (int kind = 0; kind < 2; kind++) {
            char name[64];
            (void)snprintf(name, sizeof name, "h = %g s", steps[k]);
            contact_scene_options o =
                knot_of(kind == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, 2.0);
            o.pull.speed = 0.05;
            expect_holds(name, &o, steps[k]);
        }
    }
}

static void fine_coarse_and_graded_meshes(void **state)
{
    (void)state;
    static const double finest[] = {0.2e-3, 0.5e-3, 1.25e-3};
    for (int k = 0; k < 3; k++) {
        char name[64];
        (void)snprintf(name, sizeof name, "segments of %g D", finest[k] / 0.25e-3);
        contact_scene_options o = knot_of(KNOT_OVERHAND, 2.0);
        o.knot.finest = finest[k];
        o.knot.coarsest = fmax(finest[k], 1e-3);
        expect_holds(name, &o, 1e-3);
    }
    contact_scene_options o = knot_of(KNOT_DOUBLE_OVERHAND, 2.0);
    o.thread.bending = VBSS_THREAD_BENDING_LOCAL;
    expect_holds("bending between neighbours", &o, 1e-3);
}

/* Three throws in a thread that a newton stretches by 9 %: steps take many calls, and most of the time is left out. Hands
 * that went by the reaction of a step of some calls ago pushed with 1500 N until there was no room for what is near. */
static void spring_hands_pull_at_suspended_scene(void **state)
{
    (void)state;
    contact_scene_options o = options_of(CONTACT_SCENE_TUGGED);
    o.knot.kind = KNOT_FLS;
    o.knot.length = 0.124;
    o.knot.finest = 0.27e-3;
    o.thread.axial_stiffness = 11.0;
    o.thread.bending_stiffness = 1.4e-9;
    o.scene.thread_friction = 0.17;
    o.pull = (contact_pull){1.7, 0.25, 1860.0};
    for (o.seed = 0; o.seed < 2; o.seed++) {
        double fastest = 0.0;
        hard_begin(&c, "springs tug while it waits", &o, 2e-3);
        for (uint32_t i = 0; i < 600; i++) {
            hard_run(&c, 1);
            fastest = fmax(fastest, hard_fastest(&c));
        }
        hard_report(&c);
        hard_expect_kept(&c);
        assert_true(hard_statistics(&c).deferred > 500);
        assert_true(fastest < 60.0); /* 33 m/s; 84 by the last reaction */
        hard_end(&c);
    }
}

/* ---- more than one */

static void two_interlocked_threads(void **state)
{
    (void)state;
    for (int friction = 0; friction < 2; friction++) {
        contact_scene_options o = options_of(CONTACT_SCENE_INTERLOCKED);
        o.scene.thread_friction = 0.3 * friction;
        o.pull = (contact_pull){0.05, 2.0, 0.0};
        hard_begin(&c, "two bights interlocked", &o, 1e-3);
        assert_true(hard_pull(&c, 1000));
        hard_run(&c, 300);
        hard_report(&c);
        hard_expect_kept(&c);
        /* They still hold each other: the end of each bight is beyond that of the other. */
        double largest = -1.0, smallest = 1.0;
        for (uint32_t i = 0; i < c.scene.nodes[0]; i++) {
            largest = fmax(largest, hard_nodes(&c, 0)[i].x);
            smallest = fmin(smallest, hard_nodes(&c, 1)[i].x);
        }
        assert_true(largest > smallest);
        hard_expect_at_rest(&c, 100);
        hard_end(&c);
    }
}

/* Exactly parallel, side by side, touching, overlapping, one above the other. */
static void parallel_threads(void **state)
{
    (void)state;
    static const double apart[] = {1e-3, 0.25e-3, 0.2e-3, 0.075e-3};
    for (int k = 0; k < 4; k++) {
        contact_scene_options o = options_of(CONTACT_SCENE_BESIDE);
        o.aside = vec3_make(0.0, apart[k], 0.0);
        hard_begin(&c, "parallel threads", &o, 1e-3);
        hard_run(&c, 300);
        hard_report(&c);
        hard_expect_kept(&c);
        hard_end(&c);
    }
}

/* Ends free, two rods in the loop that go apart: friction holds the knot, and nothing else does. */
static void knot_opens_only_without_friction(void **state)
{
    (void)state;
    for (int friction = 0; friction < 2; friction++) {
        contact_scene_options o = options_of(CONTACT_SCENE_PULLED_OPEN);
        o.scene.thread_friction = 0.3 * friction;
        o.tool_speed = 10e-3;
        hard_begin(&c, friction ? "pulled open, friction 0.3" : "pulled open, friction 0", &o,
                   1e-3);
        hard_run(&c, friction ? 400 : 900);
        hard_report(&c);
        hard_expect_kept(&c);
        if (friction) {
            hard_expect_same_knot(&c);
        } else {
            assert_int_equal(hard_knot(&c, 0).determinant, 1);
        }
        hard_end(&c);
    }
}

int test_knots_stress(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(knots_tighten_at_200_mm_per_second),
        cmocka_unit_test(tight_knot_survives_20_newton_step),
        cmocka_unit_test(teleported_hand),
        cmocka_unit_test(dead_load_on_knot),
        cmocka_unit_test(zero_and_high_friction),
        cmocka_unit_test(soft_and_stiff_axially),
        cmocka_unit_test(limp_and_stiff_in_bending),
        cmocka_unit_test(short_and_long_steps),
        cmocka_unit_test(fine_coarse_and_graded_meshes),
        cmocka_unit_test(spring_hands_pull_at_suspended_scene),
        cmocka_unit_test(two_interlocked_threads),
        cmocka_unit_test(parallel_threads),
        cmocka_unit_test(knot_opens_only_without_friction),
    };
    return cmocka_run_group_tests_name("scene.knots_stress", tests, NULL, NULL);
}
