/* A thread through both marks: what it takes to pull it through, that it stays where friction holds it, what it passes on. */
#include "base/elementary.h"
#include "scene/stitch_rig.h"

static stitch_rig c;

/* ---- pulled through */

/* By how much it turns from well before the hole to well behind it, rad. */
static double turn_at(const vbss_scene_hole *hole)
{
    enum { BESIDE = 3 };
    uint32_t n = 0;
    for (double left = hole->arc_length; left > c.s.rest[n]; n++) {
        left -= c.s.rest[n];
    }
    vec3 a = vec3_sub(stitch_rig_node(&c, n - BESIDE + 1), stitch_rig_node(&c, n - BESIDE));
    vec3 b = vec3_sub(stitch_rig_node(&c, n + BESIDE + 1), stitch_rig_node(&c, n + BESIDE));
    return vbss_atan2(vec3_norm(vec3_cross(a, b)), vec3_dot(a, b));
}

typedef struct pulled {
    double ratio, ideal, ripple; /* means over the second half; of the ratio */
    double work, rubbed;         /* J, of hand and tail; of holes */
} pulled;

static pulled pull_through(double friction, double degrees, double tail)
{
    enum { STEPS = 1000 };
    const double half = 0.5 * STEPS;
    const double speed = 0.02;
    pulled p = {0.0, 0.0, 0.0, 0.0, 0.0};
    stitch_rig_begin(&c);
    c.o.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    c.o.limb = 40e-3;
    c.o.rise = 0.017453292519943295 * degrees;
    c.o.thread.drag = 20.0;
    c.o.drain.hole_friction = friction;
    c.o.drain.hole_damping = 0.0;
    c.o.drain.thread_force = 1e-6;
    c.o.drain.friction = 0.0;
    stitch_rig_make(&c);
    stitch_rig_hold_marks(&c);
    stitch_rig_load_tail(&c, tail);
    double square = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double before[2] = {c.holes[0].arc_length, c.holes[1].arc_length};
        vec3 end = stitch_rig_node(&c, c.s.ends[0]);
        stitch_rig_draw(&c, 1, speed * c.h);
        stitch_rig_wait(&c, 1);
        if (i < STEPS / 2) {
            continue;
        }
        double ratio = stitch_scene_pull(&c.s, 1) / tail;
        p.ratio += ratio / half;
        square += ratio * ratio / half;
        p.ideal += vbss_exp(friction * (turn_at(&c.holes[0]) + turn_at(&c.holes[1]))) / half;
        p.work += ratio * tail * speed * c.h +
                  tail * vec3_dot(stitch_rig_outward(&c, 0),
                                  vec3_sub(stitch_rig_node(&c, c.s.ends[0]), end));
        for (int k = 0; k < 2; k++) {
            p.rubbed -= c.holes[k].friction * (c.holes[k].arc_length - before[k]);
        }
    }
    p.ripple = sqrt(fmax(square - p.ratio * p.ratio, 0.0));
    print_message("mu %.1f, %2.0f degrees, tail %g N: %.3f +- %.3f, capstan %.3f; work %.3f, "
                  "rubbed %.3f mJ\n",
                  friction, degrees, tail, p.ratio, p.ripple, p.ideal, 1e3 * p.work,
                  1e3 * p.rubbed);
    assert_int_equal(stitch_rig_statistics(&c).clamped, 0);
    stitch_rig_end(&c);
    return p;
}

static void sliding_friction_in_holes_follows_capstan_equation(void **state)
{
    (void)state;
    const double frictions[] = {0.1, 0.3, 0.5}, degrees[] = {0.0, 30.0, 60.0, 90.0};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            pulled p = pull_through(frictions[i], degrees[k], 0.2);
            expect_near(p.ideal, p.ratio, (k < 3 ? 0.015 : 0.05) * p.ideal);
            assert_true(p.ripple < 0.1 * p.ideal);
            /* What goes in is rubbed away, but for what the thread takes up and gives back. */
            expect_near(p.work, p.rubbed, (k < 3 ? 0.05 : 0.1) * p.work + 1e-5);
        }
    }
}

static void hole_friction_is_proportional_to_tension(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        pulled p = pull_through(0.3, 60.0, k == 0 ? 0.05 : 1.0);
        expect_near(p.ideal, p.ratio, 0.03 * p.ideal);
    }
}

/* ---- at rest */

static void load_below_friction_does_not_creep(void **state)
{
    (void)state;
    stitch_rig_begin(&c);
    c.o.rise = 0.8;
    c.o.limb = 40e-3;
    c.o.thread.drag = 20.0;
    stitch_rig_make(&c);
    stitch_rig_hold_marks(&c);
    stitch_rig_load_tail(&c, 0.2);
    for (int i = 0; i < 400; i++) {
        stitch_rig_draw(&c, 1, 0.02 * c.h);
        stitch_rig_wait(&c, 1);
    }
    /* Back by what the thread has stretched, and less. */
    for (int i = 0; i < 50; i++) {
        stitch_rig_draw(&c, 1, -0.2e-6);
        stitch_rig_wait(&c, 1);
    }
    stitch_rig_wait(&c, 500);
    double before[2] = {c.holes[0].arc_length, c.holes[1].arc_length};
    double pull = stitch_scene_pull(&c.s, 1);
    assert_true(pull > 0.2);
    stitch_rig_wait(&c, 2000);
    for (int k = 0; k < 2; k++) {
        expect_near(before[k], c.holes[k].arc_length, 1e-9);
    }
    expect_near(pull, stitch_scene_pull(&c.s, 1), 1e-6);
    stitch_rig_end(&c);
}

static vec3 anchor_sum(void)
{
    vbss_view view;
    vec3 sum = vec3_zero();
    expect_ok(vbss_drain_get_view(c.s.drain, VBSS_DRAIN_VIEW_ANCHOR_FORCES, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        sum = vec3_add(sum, vec3_load((const double *)view.data + 3 * i));
    }
    return sum;
}

/* Hands, holes, contacts and the block: each body is in balance, and so are all. */
static void forces_transmit_from_hand_to_block(void **state)
{
    (void)state;
    stitch_rig_begin(&c);
    c.o.rise = 1.0;
    c.o.thread.drag = 20.0;
    stitch_rig_make(&c);
    for (int i = 0; i < 800; i++) {
        for (int k = 0; k < 2; k++) {
            if (stitch_scene_pull(&c.s, k) < (k == 0 ? 0.15 : 0.2)) {
                stitch_rig_draw(&c, k, 0.02 * c.h);
            }
        }
        stitch_rig_wait(&c, 1);
    }
    stitch_rig_wait(&c, 2000);
    vec3 hands = vec3_zero(), holes = vec3_zero();
    for (int k = 0; k < 2; k++) {
        vbss_thread_reaction r;
        expect_ok(vbss_thread_get_reaction(c.s.thread, c.s.hands[k], &r, sizeof r));
        hands = vec3_add(hands, vec3_load(r.force));
        holes = vec3_add(holes, vec3_load(c.holes[k].force));
    }
    vec3 block = anchor_sum();
    print_message("hands %.4f, holes %.4f, block %.4f N\n", vec3_norm(hands), vec3_norm(holes),
                  vec3_norm(block));
    assert_true(vec3_norm(hands) > 0.2);
    expect_near(0.0, vec3_norm(vec3_add(hands, block)), 1e-3 * vec3_norm(hands));
    assert_int_equal(stitch_rig_statistics(&c).contacts, 2); /* the holes */
    expect_near(0.0, vec3_norm(vec3_add(hands, holes)), 1e-3 * vec3_norm(hands));
    stitch_rig_end(&c);
}

int test_stitch(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sliding_friction_in_holes_follows_capstan_equation),
        cmocka_unit_test(hole_friction_is_proportional_to_tension),
        cmocka_unit_test(load_below_friction_does_not_creep),
        cmocka_unit_test(forces_transmit_from_hand_to_block),
    };
    return cmocka_run_group_tests_name("scene.stitch", tests, NULL, NULL);
}
