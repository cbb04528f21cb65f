/* Exercises of one skill: goals, measures with their pass marks, outcome. The task sees what a script says; needle and tools
 * are those of a still scene. */
#include <math.h>
#include <string.h>

#include "base/rotation.h"
#include "rig.h"

#define DEGREE 0.017453292519943295
#define HALF 0.70710678118654752

static void begin(rig *r, vbss_session_exercise exercise)
{
    rig_make(r);
    r->scene.config.coaching = 1;
    r->scene.config.exercise = exercise;
    rig_start(r);
}

static vbss_session_exercise_state exercise_of(const rig *r)
{
    vbss_session_exercise_state state;
    expect_ok(vbss_session_get_exercise(r->session, &state, sizeof state));
    return state;
}

static vbss_session_measure measure_of(const rig *r, vbss_session_measure_kind kind)
{
    vbss_session_measure m = {.kind = 0};
    for (uint32_t i = 0; m.kind != kind; i++) {
        expect_ok(vbss_session_get_measure(r->session, i, &m, sizeof m));
        assert_string_not_equal(m.name, "");
    }
    return m;
}

/* Number of events of outcomes, and the amount of the last one. */
static uint32_t count_outcomes(const rig *r, double *amount)
{
    const vbss_session_status status = rig_status(r);
    vbss_session_event e;
    uint32_t count = 0;
    for (uint64_t i = status.first_event; i < status.event_count; i++) {
        expect_ok(vbss_session_get_event(r->session, i, &e, sizeof e));
        if (e.kind == VBSS_SESSION_EVENT_EXERCISE) {
            assert_int_equal(e.number, exercise_of(r).exercise);
            *amount = e.amount;
            count++;
        }
    }
    return count;
}

#define expect_outcome(r, outcome, missed) \
    expect_outcome_at((r), (outcome), (missed), __FILE__, __LINE__)
static void expect_outcome_at(const rig *r, vbss_session_outcome outcome, uint32_t missed,
                              const char *file, int line)
{
    const vbss_session_exercise_state state = exercise_of(r);
    double amount = -1.0;
    uint32_t count = count_outcomes(r, &amount);
    double wanted = outcome == VBSS_SESSION_OUTCOME_PASSED ? 1.0 : 0.0;
    if (state.outcome != outcome || state.missed != missed ||
        count != (outcome != VBSS_SESSION_OUTCOME_NONE) || (count > 0 && amount != wanted)) {
        print_error("outcome %d was expected, not %d with %#x missed, in %u events of amount %g\n",
                    outcome, state.outcome, state.missed, count, amount);
        for (uint32_t i = 0; i < state.measure_count; i++) {
            vbss_session_measure m;
            expect_ok(vbss_session_get_measure(r->session, i, &m, sizeof m));
            print_error("%s: %g in %g to %g\n", m.name, m.value, m.low, m.high);
        }
        _fail(file, line);
    }
}

/* ---- the needle */

/* The needle's plane is level with the jaws, which point along y, but for a tilt; so high. */
static void place_needle(rig *r, double height, double tilt)
{
    const double position[3] = {0.08, 0.08, height};
    const quat square = quat_make(HALF, -HALF, 0.0, 0.0);
    const quat turned = quat_mul(vbss_quat_from_rotation_vector(vec3_make(tilt, 0.0, 0.0)), square);
    const double orientation[4] = {turned.w, turned.x, turned.y, turned.z};
    expect_ok(
        vbss_scene_set_rigid_pose(r->scene.scene, r->scene.config.needle, position, orientation));
}

static void hold_at(rig *r, double share)
{
    r->observation.tools[RIG_RIGHT].tip =
        vbss_session_needle_point(r->s, share * vbss_session_needle_length(r->s));
}

/* Takes the needle and lifts it by 12 mm. */
static void take_up(rig *r, double share, double tilt)
{
    place_needle(r, 0.0, tilt);
    rig_start(r);
    hold_at(r, share);
    rig_take(r, RIG_RIGHT);
    rig_run(r, 0.1);
    place_needle(r, 12e-3, tilt);
    hold_at(r, share);
}

static void prepare(rig *r, vbss_session_exercise exercise)
{
    rig_make(r);
    r->scene.config.coaching = 1;
    r->scene.config.exercise = exercise;
}

static void a_needle_taken_as_courses_ask_passes(void **state)
{
    (void)state;
    static rig r;
    prepare(&r, VBSS_SESSION_EXERCISE_TAKE_NEEDLE);
    take_up(&r, 0.6, 10.0 * DEGREE);
    rig_run(&r, 0.9);
    expect_outcome(&r, VBSS_SESSION_OUTCOME_NONE, 0);
    rig_run(&r, 0.2);
    expect_outcome(&r, VBSS_SESSION_OUTCOME_PASSED, 0);
    expect_near(0.6, measure_of(&r, VBSS_SESSION_MEASURE_GRASP_SHARE).value, 1e-9);
    expect_near(10.0 * DEGREE, measure_of(&r, VBSS_SESSION_MEASURE_GRASP_ANGLE).value, 1e-9);
    assert_string_equal(exercise_of(&r).name, "take_needle");
    vbss_session_measure m;
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_session_get_measure(r.session, 0, &m, 3));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_session_get_measure(r.session, 4, &m, sizeof m));
    assert_int_equal(rig_status(&r).phase, VBSS_SESSION_PHASE_APPROACH);
    rig_end(&r);
}

static void each_measure_of_a_grasp_decides(void **state)
{
    (void)state;
    static rig r;
    static const struct {
        double share, tilt;
        bool drops;
        uint32_t missed;
    } rows[] = {
        {0.46, 0.0, false, 1}, {0.72, 0.0, false, 1}, {0.6, 32.0 * DEGREE, false, 2},
        {0.6, 0.0, true, 4},   {0.3, 1.0, true, 7},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        prepare(&r, VBSS_SESSION_EXERCISE_TAKE_NEEDLE);
        take_up(&r, rows[i].share, rows[i].tilt);
        if (rows[i].drops) {
            rig_run(&r, 0.5);
            rig_drop(&r, RIG_RIGHT);
            rig_run(&r, 0.1);
            rig_take(&r, RIG_RIGHT);
        }
        rig_run(&r, 1.2);
        expect_outcome(&r, VBSS_SESSION_OUTCOME_FAILED, rows[i].missed);
        rig_end(&r);
    }
}

static void a_needle_that_stays_on_the_floor_is_not_taken(void **state)
{
    (void)state;
    static rig r;
    prepare(&r, VBSS_SESSION_EXERCISE_TAKE_NEEDLE);
    take_up(&r, 0.6, 0.0);
    place_needle(&r, 9e-3, 0.0);
    hold_at(&r, 0.6);
    rig_run(&r, 3.0);
    expect_outcome(&r, VBSS_SESSION_OUTCOME_NONE, 0);
    place_needle(&r, 11e-3, 0.0);
    hold_at(&r, 0.6);
    rig_run(&r, 1.1);
    expect_outcome(&r, VBSS_SESSION_OUTCOME_PASSED, 0);
    rig_end(&r);
}

static void the_time_of_an_exercise_is_limited(void **state)
{
    (void)state;
    static rig r;
    begin(&r, VBSS_SESSION_EXERCISE_TAKE_NEEDLE);
    r.s->time = 59.9;
    rig_run(&r, 0.2);
    expect_outcome(&r, VBSS_SESSION_OUTCOME_FAILED, 11); /* 60 s is not within */
    assert_int_equal(rig_status(&r).failure, VBSS_SESSION_FAILURE_NONE);
    expect_near(60.0, exercise_of(&r).time, 2e-3);
    rig_end(&r);
}

/* ---- the mark */

/* The needle's tip, its local y, points into the wall at the right mark, but for a tilt. */
static void turn_needle(rig *r, double tilt)
{
    session_observation real;
    vbss_session_observe(r->s, &real);
    r->observation.into_tissue = real.into_tissue;
    const vec3 into = vec3_load(rig_coaching(r).direction);
    const vec3 from = vec3_make(0.0, 1.0, 0.0), axis = vec3_cross(from, into);
    const double angle = atan2(vec3_norm(axis), vec3_dot(from, into)) + tilt;
    const vec3 unit = vec3_unit_or(axis, vec3_make(0.0, 0.0, 1.0));
    const quat turned = vbss_quat_from_rotation_vector(vec3_scale(unit, angle));
    const double position[3] = {0.08, 0.08, 0.0},
                 orientation[4] = {turned.w, turned.x, turned.y, turned.z};
    expect_ok(
        vbss_scene_set_rigid_pose(r->scene.scene, r->scene.config.needle, position, orientation));
}

static void pass_mark(rig *r, double axial, double tilt)
{
    begin(r, VBSS_SESSION_EXERCISE_PASS_MARK);
    rig_take(r, RIG_RIGHT);
    rig_run(r, 0.2);
    assert_int_equal(rig_coaching(r).goal, VBSS_SESSION_GOAL_REACH_MARK);
    turn_needle(r, tilt);
    rig_pierce(r, RIG_ENTRY, 1, axial);
    rig_run(r, 0.1);
    expect_near(fabs(tilt), measure_of(r, VBSS_SESSION_MEASURE_ENTRY_ANGLE).value, 1e-7);
}

static void go_deep(rig *r)
{
    r->observation.holes[0].distance_from_tip = 4.9e-3;
    rig_run(r, 0.1);
    assert_int_equal(exercise_of(r).outcome, VBSS_SESSION_OUTCOME_NONE);
    r->observation.holes[0].distance_from_tip = 5.1e-3;
    rig_run(r, 0.1);
}

static void a_mark_is_passed_straight_and_near(void **state)
{
    (void)state;
    static rig r;
    static const struct {
        double axial, tilt;
        uint32_t missed;
    } rows[] = {{0.9e-3, 0.3, 0}, {1.1e-3, 0.0, 1}, {0.0, 0.6, 2}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        pass_mark(&r, rows[i].axial, rows[i].tilt);
        go_deep(&r);
        expect_outcome(
            &r, rows[i].missed == 0 ? VBSS_SESSION_OUTCOME_PASSED : VBSS_SESSION_OUTCOME_FAILED,
            rows[i].missed);
        expect_near(rows[i].axial, measure_of(&r, VBSS_SESSION_MEASURE_DEVIATION).value, 1e-9);
        rig_end(&r);
    }
}

static void a_hole_that_was_left_does_not_count_and_a_third_one_does(void **state)
{
    (void)state;
    static rig r;
    pass_mark(&r, 2e-3, 0.0);
    rig_leave(&r, RIG_ENTRY);
    rig_run(&r, 0.1);
    assert_int_equal(measure_of(&r, VBSS_SESSION_MEASURE_DEVIATION).is_known, 0);
    rig_pierce(&r, RIG_ENTRY + 5, 1, 0.2e-3);
    rig_pierce(&r, RIG_ENTRY + 6, 1, 5e-3);
    rig_run(&r, 0.1);
    go_deep(&r);
    expect_outcome(&r, VBSS_SESSION_OUTCOME_FAILED, 4);
    rig_end(&r);
}

/* ---- throws */

/* The next throw, tied with so many wraps, and seated. */
static void tie_and_seat(rig *r, uint32_t number, int32_t wraps, vbss_metrics_relation relation)
{
    rig_pull(r, 0.0, 3e-4);
    r->observation.knot.next_throw = VBSS_KNOT_VERDICT_PASSED;
    rig_run(r, 0.1);
    rig_set_throw(r, number, wraps, number == 0 ? 1 : -1, relation);
    r->observation.knot.next_throw = VBSS_KNOT_VERDICT_NONE;
    rig_run(r, 0.2);
    rig_pull(r, 1.0, 3e-4);
    r->observation.max_tension = 1.5;
    rig_run(r, 0.2);
}

static void a_throw_needs_its_wraps(void **state)
{
    (void)state;
    static rig r;
    static const struct {
        vbss_session_exercise exercise;
        int32_t wraps;
        uint32_t missed;
    } rows[] = {{VBSS_SESSION_EXERCISE_SINGLE_THROW, 1, 0},
                {VBSS_SESSION_EXERCISE_SINGLE_THROW, 2, 1},
                {VBSS_SESSION_EXERCISE_DOUBLE_THROW, 2, 0},
                {VBSS_SESSION_EXERCISE_DOUBLE_THROW, 1, 1}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        begin(&r, rows[i].exercise);
        rig_to_tail(&r);
        tie_and_seat(&r, 0, rows[i].wraps, VBSS_METRICS_RELATION_FIRST);
        expect_outcome(
            &r, rows[i].missed == 0 ? VBSS_SESSION_OUTCOME_PASSED : VBSS_SESSION_OUTCOME_FAILED,
            rows[i].missed);
        expect_near(1.5, measure_of(&r, VBSS_SESSION_MEASURE_TENSION).value, 0.0);
        expect_near(3e-4, measure_of(&r, VBSS_SESSION_MEASURE_GAP).value, 0.0);
        rig_end(&r);
    }
}

static void a_lasting_pull_that_was_too_hard_fails_a_throw(void **state)
{
    (void)state;
    static rig r;
    static const struct {
        double seconds;
        bool waits; /* the scene leaves the time out */
        bool fails;
    } rows[] = {{0.12, false, true}, {0.03, false, false}, {0.3, true, false}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        begin(&r, VBSS_SESSION_EXERCISE_DOUBLE_THROW);
        rig_to_tail(&r);
        r.observation.max_tension = 6.2;
        for (double t = 0.0; t < rows[i].seconds; t += RIG_STEP) {
            rig_run(&r, RIG_STEP);
            r.s->time_lost += rows[i].waits ? RIG_STEP : 0.0;
        }
        r.observation.max_tension = 1.5;
        tie_and_seat(&r, 0, 2, VBSS_METRICS_RELATION_FIRST);
        expect_outcome(&r,
                       rows[i].fails ? VBSS_SESSION_OUTCOME_FAILED : VBSS_SESSION_OUTCOME_PASSED,
                       rows[i].fails ? 4 : 0);
        expect_near(rows[i].fails ? 6.2 : 1.5, measure_of(&r, VBSS_SESSION_MEASURE_TENSION).value,
                    0.0);
        rig_end(&r);
    }
}

static void a_second_throw_has_to_be_square(void **state)
{
    (void)state;
    static rig r;
    for (int granny = 0; granny < 2; granny++) {
        begin(&r, VBSS_SESSION_EXERCISE_SQUARE_THROW);
        rig_to_tail(&r);
        rig_to_throw(&r, 0, RIG_RIGHT);
        rig_drop(&r, RIG_RIGHT);
        rig_take(&r, RIG_LEFT);
        rig_run(&r, 0.1);
        tie_and_seat(&r, 1, 1,
                     granny != 0 ? VBSS_METRICS_RELATION_GRANNY : VBSS_METRICS_RELATION_SQUARE);
        expect_outcome(&r, granny != 0 ? VBSS_SESSION_OUTCOME_FAILED : VBSS_SESSION_OUTCOME_PASSED,
                       granny != 0 ? 16 : 0);
        rig_end(&r);
    }
}

static void the_coach_asks_for_the_wraps_of_the_exercise(void **state)
{
    (void)state;
    static rig r;
    begin(&r, VBSS_SESSION_EXERCISE_SINGLE_THROW);
    rig_to_tail(&r);
    rig_run(&r, 0.1);
    vbss_session_coaching c = rig_coaching(&r);
    assert_int_equal(c.goal, VBSS_SESSION_GOAL_WIND);
    expect_near(1.25, c.turns, 1e-12);
    assert_non_null(strstr(c.sentence, "a good turn"));
    tie_and_seat(&r, 0, 1, VBSS_METRICS_RELATION_FIRST);
    c = rig_coaching(&r);
    assert_true((c.mistakes & 1ull << VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS) == 0);
    rig_end(&r);
}

/* ---- cuts */

/* What is left goes through the drain: a new piece, if the needle's limb is cut. */
static void cut(rig *r, uint32_t limb, double left)
{
    session_observation *o = &r->observation;
    if (limb == SESSION_EXIT) {
        double lost = o->holes[1].arc - left;
        o->thread = 40;
        o->thread_length -= lost;
        rig_thread_through(r, RIG_ENTRY, o->holes[0].arc - lost);
        rig_thread_through(r, RIG_EXIT, left);
    } else {
        o->thread_length = o->holes[0].arc + left;
    }
    rig_run(r, 0.1);
}

static void both_tails_must_have_their_length(void **state)
{
    (void)state;
    static rig r;
    static const struct {
        double left[2];
        uint32_t missed;
    } rows[] = {{{4e-3, 5e-3}, 0}, {{9e-3, 5e-3}, 1}, {{4e-3, 1e-3}, 2}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        begin(&r, VBSS_SESSION_EXERCISE_CUT);
        rig_to_cut(&r);
        cut(&r, SESSION_EXIT, rows[i].left[1]);
        expect_outcome(&r, VBSS_SESSION_OUTCOME_NONE, rows[i].missed == 2 ? 3 : 1);
        cut(&r, SESSION_ENTRY, rows[i].left[0]);
        expect_outcome(
            &r, rows[i].missed == 0 ? VBSS_SESSION_OUTCOME_PASSED : VBSS_SESSION_OUTCOME_FAILED,
            rows[i].missed);
        assert_int_equal(rig_status(&r).phase, VBSS_SESSION_PHASE_DONE);
        rig_end(&r);
    }
}

static void a_failed_task_fails_its_exercise(void **state)
{
    (void)state;
    static rig r;
    begin(&r, VBSS_SESSION_EXERCISE_DOUBLE_THROW);
    rig_to_tail(&r);
    r.observation.thread_length -= 5e-3;
    rig_run(&r, 0.1);
    assert_int_equal(rig_status(&r).failure, VBSS_SESSION_FAILURE_CUT_EARLY);
    assert_int_equal(exercise_of(&r).outcome, VBSS_SESSION_OUTCOME_FAILED);
    rig_end(&r);
}

/* ---- after the outcome, and without an exercise */

static void the_outcome_ends_the_task(void **state)
{
    (void)state;
    static rig r;
    begin(&r, VBSS_SESSION_EXERCISE_DOUBLE_THROW);
    rig_to_tail(&r);
    tie_and_seat(&r, 0, 2, VBSS_METRICS_RELATION_FIRST);
    const vbss_session_status before = rig_status(&r);
    const vbss_session_exercise_state exercise = exercise_of(&r);
    assert_int_equal(rig_coaching(&r).goal, VBSS_SESSION_GOAL_NONE);
    rig_drop(&r, RIG_RIGHT);
    rig_pull(&r, 0.0, 3e-3);
    rig_run(&r, 1.0);
    const vbss_session_status after = rig_status(&r);
    assert_int_equal(after.event_count, before.event_count);
    assert_int_equal(after.seated, 1);
    expect_near(before.time, after.time, 0.0);
    expect_near(exercise.time, exercise_of(&r).time, 0.0);
    rig_end(&r);
}

static void a_session_without_an_exercise_has_no_measures(void **state)
{
    (void)state;
    static rig r;
    rig_begin(&r);
    vbss_session_measure m;
    const vbss_session_exercise_state none = exercise_of(&r);
    assert_int_equal(none.exercise, VBSS_SESSION_EXERCISE_NONE);
    assert_int_equal(none.outcome, VBSS_SESSION_OUTCOME_NONE);
    assert_int_equal(none.measure_count, 0);
    assert_string_equal(none.name, "");
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_session_get_measure(r.session, 0, &m, sizeof m));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_session_get_exercise(r.session, NULL, sizeof none));
    for (int i = -1; i <= VBSS_SESSION_EXERCISE_COUNT; i++) {
        bool there = i > 0 && i < VBSS_SESSION_EXERCISE_COUNT;
        assert_int_equal(vbss_session_exercise_name(i)[0] != '\0', there);
        assert_int_equal(vbss_session_exercise_string(i)[0] != '\0', there);
    }
    rig_end(&r);
}

int test_exercises(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_needle_taken_as_courses_ask_passes),
        cmocka_unit_test(each_measure_of_a_grasp_decides),
        cmocka_unit_test(a_needle_that_stays_on_the_floor_is_not_taken),
        cmocka_unit_test(the_time_of_an_exercise_is_limited),
        cmocka_unit_test(a_mark_is_passed_straight_and_near),
        cmocka_unit_test(a_hole_that_was_left_does_not_count_and_a_third_one_does),
        cmocka_unit_test(a_throw_needs_its_wraps),
        cmocka_unit_test(a_lasting_pull_that_was_too_hard_fails_a_throw),
        cmocka_unit_test(a_second_throw_has_to_be_square),
        cmocka_unit_test(the_coach_asks_for_the_wraps_of_the_exercise),
        cmocka_unit_test(both_tails_must_have_their_length),
        cmocka_unit_test(a_failed_task_fails_its_exercise),
        cmocka_unit_test(the_outcome_ends_the_task),
        cmocka_unit_test(a_session_without_an_exercise_has_no_measures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
