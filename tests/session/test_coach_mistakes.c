/* The coach names each mistake, says how to mend it, and takes it back when it is mended. */
#include <string.h>

#include "rig.h"

/* Until facts and mistakes have dwelt, but those of tensions. */
static void run(rig *r)
{
    rig_run(r, 0.4);
}

static bool is_open(const rig *r, vbss_session_mistake mistake)
{
    return (rig_coaching(r).mistakes >> mistake & 1u) != 0;
}

#define expect_mistake(r, mistake) expect_mistake_at((r), (mistake), __FILE__, __LINE__)
/* It is the newest one, with words, and there is one event of its beginning more than of its end. */
static void expect_mistake_at(const rig *r, vbss_session_mistake mistake, const char *file,
                              int line)
{
    const vbss_session_coaching c = rig_coaching(r);
    const vbss_session_status status = rig_status(r);
    int32_t begun = 0;
    for (uint64_t i = status.first_event; i < status.event_count; i++) {
        vbss_session_event e;
        expect_ok(vbss_session_get_event(r->session, i, &e, sizeof e));
        if (e.kind == VBSS_SESSION_EVENT_MISTAKE && e.number == (uint32_t)mistake) {
            begun += e.undone != 0 ? -1 : 1;
        }
    }
    if (c.mistake != mistake || !is_open(r, mistake) || begun != 1 ||
        c.mistake_sentence[0] == '\0' || c.remedy[0] == '\0') {
        print_error("mistake %d was expected, not %d (%s), begun %d\n", mistake, c.mistake,
                    c.mistake_sentence, begun);
        _fail(file, line);
    }
}

#define expect_none(r) expect_none_at((r), __FILE__, __LINE__)
static void expect_none_at(const rig *r, const char *file, int line)
{
    const vbss_session_coaching c = rig_coaching(r);
    if (c.mistake != VBSS_SESSION_MISTAKE_NONE || c.mistakes != 0) {
        print_error("no mistake was expected, not %d: %s\n", c.mistake, c.mistake_sentence);
        _fail(file, line);
    }
}

static void dropped_needle_is_taken_again(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    run(&r);
    expect_none(&r); /* it was not taken yet */
    rig_to_approach(&r);
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_NEEDLE_DROPPED);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_NEEDLE, VBSS_METRICS_TOOL_RIGHT);
    rig_take(&r, RIG_RIGHT);
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void missed_marks_are_mended_by_withdrawal(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_approach(&r);
    rig_pierce(&r, RIG_ENTRY, 1, 2e-3);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_ENTRY_MISSED);
    assert_int_equal(rig_coaching(&r).is_mendable, 1);
    rig_leave(&r, RIG_ENTRY);
    run(&r);
    assert_false(is_open(&r, VBSS_SESSION_MISTAKE_ENTRY_MISSED));
    expect_mistake(&r, VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_REACH_MARK, VBSS_METRICS_TOOL_RIGHT);
    rig_pierce(&r, 9, 1, 0.5e-3);
    run(&r);
    expect_none(&r);
    rig_pierce(&r, 10, 0, 3e-3);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_EXIT_MISSED);
    rig_pierce(&r, 11, 0, 0.0);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_STRAY_HOLE);
    rig_leave(&r, 11);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_EXIT_MISSED);
    rig_thread_through(&r, 9, 0.03);
    rig_thread_through(&r, 10, 0.02);
    rig_run(&r, 5.1); /* it is not shown for good, as nothing mends it any more */
    assert_int_equal(rig_coaching(&r).mistake, VBSS_SESSION_MISTAKE_NONE);
    assert_true(is_open(&r, VBSS_SESSION_MISTAKE_EXIT_MISSED));
    rig_end(&r);
}

static void lost_stitch_is_made_again(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_leave(&r, RIG_ENTRY);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_THREAD_PULLED_OUT);
    assert_false(is_open(&r, VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN));
    rig_end(&r);
}

static void tail_must_have_its_length(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    const double length = r.observation.thread_length;
    rig_thread_through(&r, RIG_ENTRY, length - 8e-3);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TAIL_SHORT);
    rig_thread_through(&r, RIG_ENTRY, length - 30e-3);
    run(&r);
    expect_none(&r);
    rig_wind(&r, RIG_LEFT, 1.0, 1);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TAIL_LONG);
    rig_wind(&r, RIG_LEFT, 0.0, 0);
    rig_thread_through(&r, RIG_ENTRY, length - 18e-3);
    rig_run(&r, 1.0);
    expect_none(&r);
    rig_end(&r);
}

static void turns_toward_the_handle_are_named(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 1.2, -1);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TOWARD_HANDLE);
    rig_wind(&r, RIG_LEFT, 1.2, 1);
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void turns_that_have_to_be_unwound_are_not_lost(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 1.8, -1);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TOWARD_HANDLE);
    rig_wind(&r, RIG_LEFT, 1.7, 1); /* seen so while they come off */
    run(&r);
    rig_wind(&r, RIG_LEFT, 0.9, 1);
    run(&r);
    expect_none(&r);
    rig_wind(&r, RIG_LEFT, 0.2, 1);
    run(&r);
    rig_wind(&r, RIG_LEFT, 1.8, 1);
    run(&r);
    expect_none(&r);
    rig_wind(&r, RIG_LEFT, 1.0, 1); /* these are */
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TURNS_LOST);
    rig_end(&r);
}

static void lost_turns_are_wound_again(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 1.8, 1);
    run(&r);
    expect_none(&r);
    rig_wind(&r, RIG_LEFT, 0.3, 1); /* or wound back */
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TURNS_LOST);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_RIGHT);
    rig_wind(&r, RIG_LEFT, 2.3, 1);
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void wrong_sense_is_named_before_it_is_tied(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_to_throw(&r, 0, RIG_RIGHT);
    rig_take(&r, RIG_LEFT);
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    const double right = vbss_session_wanted_sign(r.s);
    rig_wind(&r, RIG_RIGHT, -1.2 * right, 1);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_WRONG_SENSE);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_LEFT);
    expect_near(2.45, rig_coaching(&r).turns, 1e-12);
    rig_wind(&r, RIG_RIGHT, 1.3 * right, 1);
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void tail_is_taken_with_its_turns_and_at_its_end(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 1.4, 1);
    run(&r);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TOO_FEW_TURNS);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    expect_none(&r);
    rig_wind(&r, RIG_LEFT, 2.4, 1);
    run(&r);
    rig_wind(&r, RIG_LEFT, 2.4, -1); /* jaws that turn to the tail see them run the other way */
    rig_hold_thread(&r, RIG_LEFT, 14e-3);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_BIGHT);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    expect_none(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_end(&r);
}

static void dropped_tail_is_taken_again(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 2.4, 1);
    run(&r);
    rig_wind(&r, RIG_LEFT, 2.4, -1); /* jaws that turn to the tail see them run the other way */
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    expect_none(&r);
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TAIL_DROPPED);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void throws_are_judged_as_they_are_tied(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 2.4, 1);
    run(&r);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_wind(&r, RIG_LEFT, 0.0, 0);
    rig_pull(&r, 0.3, 2e-3);
    rig_set_throw(&r, 0, 1, 1, VBSS_METRICS_RELATION_FIRST);
    rig_run(&r, 0.7);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS);
    rig_set_throw(&r, 0, 3, 1, VBSS_METRICS_RELATION_FIRST);
    rig_run(&r, 0.5);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_TOO_MANY_WRAPS);
    assert_false(is_open(&r, VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS));
    rig_set_throw(&r, 0, 0, 0, 0);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_THROW_UNDONE);
    rig_set_throw(&r, 0, 2, 1, VBSS_METRICS_RELATION_FIRST);
    run(&r);
    expect_none(&r);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    rig_set_throw(&r, 1, 1, 1, VBSS_METRICS_RELATION_GRANNY);
    run(&r);
    assert_true(is_open(&r, VBSS_SESSION_MISTAKE_TRANSFER_MISSED));
    assert_true(is_open(&r, VBSS_SESSION_MISTAKE_GRANNY));
    rig_set_throw(&r, 1, 1, -1, VBSS_METRICS_RELATION_SQUARE);
    run(&r);
    assert_false(is_open(&r, VBSS_SESSION_MISTAKE_GRANNY));
    rig_end(&r);
}

static void to_tied(rig *r)
{
    rig_begin_coached(r);
    rig_to_tail(r);
    rig_wind(r, RIG_LEFT, 2.4, 1);
    run(r);
    rig_hold_thread(r, RIG_LEFT, 4e-3);
    run(r);
    rig_wind(r, RIG_LEFT, 0.0, 0);
    rig_set_throw(r, 0, 2, 1, VBSS_METRICS_RELATION_FIRST);
    rig_pull(r, 0.3, 2e-3);
    run(r);
    expect_none(r);
}

static void faults_of_the_knot_are_named(void **state)
{
    (void)state;
    rig r;
    to_tied(&r);
    r.observation.knot.faults = VBSS_KNOT_FAULT_STRAY;
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_STRAY_KNOT);
    r.observation.knot.faults = VBSS_KNOT_FAULT_HITCH;
    rig_run(&r, 2.6);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_CAPSIZED);
    r.observation.knot.faults = 0;
    rig_run(&r, 2.5);
    expect_none(&r);
    rig_end(&r);
}

/* While the tail is drawn through the turns, the detector may read one wrap or a hitch. */
static void loose_throw_is_not_judged(void **state)
{
    (void)state;
    rig r;
    to_tied(&r);
    rig_pull(&r, 0.15, 2e-3);
    rig_set_throw(&r, 0, 1, 1, VBSS_METRICS_RELATION_FIRST);
    r.observation.knot.faults = VBSS_KNOT_FAULT_HITCH;
    rig_run(&r, 3.0);
    expect_none(&r);
    rig_set_throw(&r, 0, 2, 1, VBSS_METRICS_RELATION_FIRST);
    r.observation.knot.faults = 0; /* the fault of the session lasts 2 s longer */
    rig_pull(&r, 0.3, 2e-3);
    rig_run(&r, 1.0);
    expect_none(&r);
    r.observation.knot.faults = VBSS_KNOT_FAULT_HITCH;
    rig_run(&r, 2.6);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_CAPSIZED);
    rig_pull(&r, 0.15, 2e-3); /* letting go does not mend it */
    rig_run(&r, 1.0);
    assert_true(is_open(&r, VBSS_SESSION_MISTAKE_CAPSIZED));
    rig_end(&r);
}

/* It is not to be pulled yet. */
static void a_throw_that_is_drawn_does_not_hang_loose(void **state)
{
    (void)state;
    rig r;
    to_tied(&r);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    rig_wind(&r, RIG_LEFT, 2.0, 1);
    rig_pull(&r, 0.05, 2e-3);
    rig_run(&r, 6.0);
    assert_int_equal(rig_coaching(&r).goal, VBSS_SESSION_GOAL_DRAW_TAIL);
    assert_false(is_open(&r, VBSS_SESSION_MISTAKE_SLACK));
    rig_wind(&r, RIG_LEFT, 0.0, 0);
    rig_run(&r, 5.5);
    assert_true(is_open(&r, VBSS_SESSION_MISTAKE_SLACK));
    rig_end(&r);
}

static void unequal_and_missing_pull_are_named(void **state)
{
    (void)state;
    rig r;
    to_tied(&r);
    r.observation.tension[1] = 2.0;
    rig_run(&r, 0.6);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_ONE_SIDED);
    r.observation.tension[0] = 2.0;
    rig_run(&r, 0.6);
    expect_none(&r);
    rig_pull(&r, 0.0, 2e-3);
    rig_run(&r, 4.9);
    expect_none(&r);
    rig_run(&r, 0.2);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_SLACK);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    expect_none(&r);
    r.observation.max_tension = 7.0;
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_PULLED_HARD);
    r.observation.max_tension = 1.0;
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void thread_drawn_through_the_stitch_is_a_pull_at_one_end(void **state)
{
    (void)state;
    rig r;
    to_tied(&r);
    r.observation.tension[0] = r.observation.tension[1] = 0.15; /* the other hand gives way */
    rig_thread_through(&r, RIG_ENTRY, r.observation.thread_length - 34e-3);
    rig_run(&r, 0.6);
    expect_none(&r); /* so much a throw draws */
    rig_thread_through(&r, RIG_ENTRY, r.observation.thread_length - 36e-3);
    rig_run(&r, 0.15);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_ONE_SIDED);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void slit_is_watched(void **state)
{
    (void)state;
    rig r;
    to_tied(&r);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    rig_pull(&r, 1.0, 2e-3);
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_SLIT_OPENED);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    expect_none(&r);
    r.observation.edge_gap = -2e-3;
    rig_run(&r, 0.6);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_WALLS_CROSSED);
    r.observation.edge_gap = 0.0;
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

static void failures_stay_named(void **state)
{
    (void)state;
    static const struct {
        vbss_session_mistake mistake;
        double torn;
    } rows[] = {{VBSS_SESSION_MISTAKE_DRAIN_TORN, 1.0}, {VBSS_SESSION_MISTAKE_TIME_UP, 0.0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        rig r;
        rig_make(&r);
        r.scene.config.coaching = 1;
        r.scene.config.time_limit = 2.0;
        rig_start(&r);
        r.observation.torn_fraction = rows[i].torn;
        rig_run(&r, 9.0);
        expect_mistake(&r, rows[i].mistake);
        assert_int_equal(rig_coaching(&r).is_mendable, 0);
        rig_expect_goal(&r, VBSS_SESSION_GOAL_NONE, VBSS_METRICS_TOOL_NONE);
        rig_end(&r);
    }
}

static void warning_comes_before_the_drain_tears(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    r.observation.anchor_load = 0.75;
    run(&r);
    expect_none(&r);
    r.observation.anchor_load = 0.85;
    run(&r);
    expect_mistake(&r, VBSS_SESSION_MISTAKE_DRAIN_TEARING);
    assert_int_equal(rig_coaching(&r).is_mendable, 1);
    r.observation.anchor_load = 0.5;
    run(&r);
    expect_none(&r);
    rig_end(&r);
}

/* A performance without a mistake has none. */
static void good_task_has_no_mistake(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_approach(&r);
    rig_pierce(&r, RIG_ENTRY, 1, 0.5e-3);
    run(&r);
    expect_none(&r);
    rig_pierce(&r, RIG_EXIT, 0, 0.9e-3);
    run(&r);
    rig_thread_through(&r, RIG_ENTRY, 0.02);
    rig_thread_through(&r, RIG_EXIT, 0.01);
    run(&r);
    rig_thread_through(&r, RIG_ENTRY, 0.133);
    run(&r);
    rig_wind(&r, RIG_LEFT, 2.4, 1);
    run(&r);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_wind(&r, RIG_LEFT, 0.0, 0);
    rig_set_throw(&r, 0, 2, -1, VBSS_METRICS_RELATION_FIRST);
    rig_pull(&r, 1.0, 2e-4);
    run(&r);
    rig_let_go(&r, RIG_LEFT);
    rig_pull(&r, 0.0, 2e-4);
    rig_run(&r, 6.0);
    expect_none(&r);
    rig_end(&r);
}

int test_coach_mistakes(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dropped_needle_is_taken_again),
        cmocka_unit_test(missed_marks_are_mended_by_withdrawal),
        cmocka_unit_test(lost_stitch_is_made_again),
        cmocka_unit_test(tail_must_have_its_length),
        cmocka_unit_test(turns_toward_the_handle_are_named),
        cmocka_unit_test(turns_that_have_to_be_unwound_are_not_lost),
        cmocka_unit_test(lost_turns_are_wound_again),
        cmocka_unit_test(wrong_sense_is_named_before_it_is_tied),
        cmocka_unit_test(tail_is_taken_with_its_turns_and_at_its_end),
        cmocka_unit_test(dropped_tail_is_taken_again),
        cmocka_unit_test(throws_are_judged_as_they_are_tied),
        cmocka_unit_test(faults_of_the_knot_are_named),
        cmocka_unit_test(loose_throw_is_not_judged),
        cmocka_unit_test(a_throw_that_is_drawn_does_not_hang_loose),
        cmocka_unit_test(unequal_and_missing_pull_are_named),
        cmocka_unit_test(thread_drawn_through_the_stitch_is_a_pull_at_one_end),
        cmocka_unit_test(slit_is_watched),
        cmocka_unit_test(warning_comes_before_the_drain_tears),
        cmocka_unit_test(failures_stay_named),
        cmocka_unit_test(good_task_has_no_mistake),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
