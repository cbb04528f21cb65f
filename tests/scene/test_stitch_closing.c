/* A throw above a stitch: limbs that are pulled shut the slit, friction keeps it shut, and without the thread it stands open as
 * before. */
#include "fixtures/solver_of.h"
#include "scene/stitch_rig.h"

static stitch_rig c;

/* ---- a double throw */

/* Instead of the default's limit of work, which `work` 0 leaves. */
#define NO_LIMIT UINT32_MAX

static void tie(double limit, uint32_t work)
{
    stitch_rig_begin(&c);
    set_step_operations(&c.o.scene, work > 0 ? work : step_operations(&c.o.scene));
    c.o.crossings = 5;
    stitch_rig_make(&c);
    stitch_rig_wait(&c, 100);
    assert_true(stitch_rig_gap(&c).gap >= 2e-3);
    stitch_rig_pull(&c, 700, 0.03, limit);
}

static void pulled_limbs_close_slit_and_throw_holds_it(void **state)
{
    (void)state;
    tie(2.0, 0);
    double first = stitch_scene_pull(&c.s, 0), tight = stitch_rig_gap(&c).gap;
    assert_true(first >= 2.0);
    assert_true(tight <= 0.5e-3);
    /* The hands are gone: what the throw gives is all that it gives. */
    expect_ok(stitch_scene_let_go(&c.s, 0));
    expect_ok(stitch_scene_let_go(&c.s, 1));
    stitch_rig_wait(&c, 500);
    vbss_drain_gap held = stitch_rig_gap(&c);
    stitch_rig_wait(&c, 1000);
    vbss_drain_gap later = stitch_rig_gap(&c);
    print_message("gap %.3f mm at %.2f N, %.3f let go, %.3f a second later; the lips %.3f apart\n",
                  1e3 * tight, first, 1e3 * held.gap, 1e3 * later.gap, 1e3 * later.opening);
    assert_true(held.gap < 1e-3);
    expect_near(held.gap, later.gap, 5e-6);
    /* The lips rise and meet: their middles are apart by nearly a wall, and nothing is open between them. */
    assert_true(later.opening <= 0.5e-3);
    assert_int_equal(stitch_rig_statistics(&c).clamped, 0);
    stitch_rig_end(&c);
}

/* What searches that are stopped miss holds beside friction: the throw gives by more without a limit, and then stays too. */
static void unlimited_budget_throw_yields_more_and_holds(void **state)
{
    (void)state;
    tie(2.0, NO_LIMIT);
    double open = stitch_rig_gap(&c).gap;
    assert_true(open <= 0.5e-3);
    expect_ok(stitch_scene_let_go(&c.s, 0));
    expect_ok(stitch_scene_let_go(&c.s, 1));
    stitch_rig_wait(&c, 500);
    double held = stitch_rig_gap(&c).gap;
    stitch_rig_wait(&c, 1000);
    print_message("without a limit of work gap %.3f mm, %.3f let go; the lips %.3f apart\n",
                  1e3 * open, 1e3 * held, 1e3 * stitch_rig_gap(&c).opening);
    assert_true(held > open && held < 1.5e-3);
    assert_true(stitch_rig_gap(&c).opening <= 0.5e-3);
    expect_near(held, stitch_rig_gap(&c).gap, 5e-6);
    stitch_rig_end(&c);
}

static void without_thread_slit_reopens(void **state)
{
    (void)state;
    vbss_drain_gap rest;
    stitch_rig_begin(&c);
    c.o.crossings = 5;
    stitch_rig_make(&c);
    rest = stitch_rig_gap(&c);
    stitch_rig_end(&c);
    tie(2.0, 0);
    expect_ok(vbss_scene_remove(c.s.scene, c.s.thread_body));
    vbss_scene_hole hole;
    assert_int_equal(vbss_scene_get_hole(c.s.scene, 0, &hole, sizeof hole), VBSS_ERROR_NOT_FOUND);
    for (int i = 0; i < 2000; i++) {
        expect_ok(vbss_scene_step(c.s.scene, c.h));
    }
    print_message("gap %.3f mm at first, %.3f after\n", 1e3 * rest.gap,
                  1e3 * stitch_rig_gap(&c).gap);
    expect_near(rest.gap, stitch_rig_gap(&c).gap, 0.1 * rest.gap);
    stitch_rig_end(&c);
}

/* ---- limbs straight up, drawn by soft springs: both alike, whatever way the thread slides */

enum { LOADS = 6, MORE = 250, REST = 350 };
#define SOFT 2.0 /* N/m */

typedef struct loading {
    double pull[LOADS], gap[LOADS];
} loading;

static void soften(int hand)
{
    vbss_thread_attachment a;
    expect_ok(stitch_scene_let_go(&c.s, hand));
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_SPRING;
    a.node = c.s.ends[hand];
    a.stiffness = SOFT;
    a.damping = 0.05;
    vec3_store(a.position, c.s.at[hand]);
    expect_ok(vbss_thread_attach(c.s.thread, &a, &c.s.hands[hand]));
}

static void draw_both(double distance)
{
    for (int i = 0; i < MORE; i++) {
        stitch_rig_draw(&c, 0, distance / MORE);
        stitch_rig_draw(&c, 1, distance / MORE);
        stitch_rig_wait(&c, 1);
    }
    stitch_rig_wait(&c, REST);
}

static void note(loading *l, int i)
{
    l->pull[i] = 0.5 * (stitch_scene_pull(&c.s, 0) + stitch_scene_pull(&c.s, 1));
    l->gap[i] = stitch_rig_gap(&c).gap;
    print_message("%.4f N: %.3f mm\n", l->pull[i], 1e3 * l->gap[i]);
}

static void load_and_unload(double friction, uint32_t work, loading *on, loading *back)
{
    stitch_rig_begin(&c);
    set_step_operations(&c.o.scene, work > 0 ? work : step_operations(&c.o.scene));
    c.o.rise = 1.5707963267948966;
    c.o.limb = 20e-3;
    c.o.thread.drag = 20.0;
    c.o.scene.thread_friction = friction;
    c.o.drain.friction = friction;
    c.o.drain.hole_friction = friction;
    c.o.drain.thread_force = 1e-6;
    stitch_rig_make(&c);
    soften(0);
    soften(1);
    draw_both(0.02 / SOFT);
    for (int i = 0; i < LOADS; i++) {
        draw_both(0.02 / SOFT);
        note(on, i);
    }
    for (int i = LOADS; i-- > 0;) {
        note(back, i);
        draw_both(-0.02 / SOFT);
    }
    stitch_rig_end(&c);
}

/* On the way on, where it was with that pull. */
static double gap_at(const loading *on, double pull)
{
    int i = 1;
    while (i + 1 < LOADS && on->pull[i] < pull) {
        i++;
    }
    double share = (pull - on->pull[i - 1]) / (on->pull[i] - on->pull[i - 1]);
    return on->gap[i - 1] + share * (on->gap[i] - on->gap[i - 1]);
}

typedef struct lag {
    double mean, largest; /* by how much less the gap is on the way back */
} lag;

static lag lag_of(double friction, uint32_t work)
{
    loading on, back;
    lag l = {0.0, 0.0};
    int count = 0;
    load_and_unload(friction, work, &on, &back);
    for (int i = 0; i < LOADS; i++) {
        /* With friction the stitch may be tighter than its limbs. */
        assert_true(friction > 0.0 || i == 0 || on.gap[i] < on.gap[i - 1]);
        assert_true(friction > 0.0 || i == 0 || back.gap[i] < back.gap[i - 1]);
        if (back.pull[i] >= on.pull[0]) {
            double less = gap_at(&on, back.pull[i]) - back.gap[i];
            l.mean += less;
            l.largest = fmax(l.largest, fabs(less));
            count++;
        }
    }
    l.mean /= count;
    return l;
}

/* Searches that are stopped leave gaps of one pull that differ by more than without a limit of work. */
static void gap_decreases_with_tension_and_hysteresis_is_friction(void **state)
{
    (void)state;
    lag exact = lag_of(0.0, NO_LIMIT), none = lag_of(0.0, 0), rubs = lag_of(0.3, 0);
    print_message("less gap on the way back, without friction nor limit of work %.3f mm (at most "
                  "%.3f), with the limit %.3f (%.3f), with friction %.3f (%.3f)\n",
                  1e3 * exact.mean, 1e3 * exact.largest, 1e3 * none.mean, 1e3 * none.largest,
                  1e3 * rubs.mean, 1e3 * rubs.largest);
    assert_true(exact.largest < 0.05e-3);
    assert_true(fabs(none.mean) < 0.03e-3);
    assert_true(none.largest < 0.05e-3);
    assert_true(rubs.largest > 4.0 * none.largest);
    assert_true(rubs.mean > 4.0 * fabs(none.mean));
}

int test_stitch_closing(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pulled_limbs_close_slit_and_throw_holds_it),
        cmocka_unit_test(unlimited_budget_throw_yields_more_and_holds),
        cmocka_unit_test(without_thread_slit_reopens),
        cmocka_unit_test(gap_decreases_with_tension_and_hysteresis_is_friction),
    };
    return cmocka_run_group_tests_name("scene.stitch_closing", tests, NULL, NULL);
}
