/* Every bad number, count, choice and NULL that a detector is shown: its status, a text that names it, and that the
 * detector is as it was to the bit. Configurations: test_detector_config.c. */
#include <float.h>

#include "harness/float_modes.h"
#include "knot/detector_rig.h"

/* ---- in three moments of a detector's life */

typedef struct subject {
    detector_rig r;
    vbss_knot_input good;
    vbss_knot_tool good_tools[RIG_TOOLS];
    uint64_t hash, generation, events;
    vbss_knot_state state;
    vbss_knot_detector_statistics statistics;
} subject;

typedef enum moment { NOTHING_SHOWN, IN_A_READING, AFTER_A_READING, MOMENTS } moment;

static void begin_subject(subject *s, moment when)
{
    detector_rig *r = &s->r;
    detector_rig_begin(r);
    r->config.step_budget = 300;
    r->config.point_capacity = 130;
    detector_rig_create(r);
    detector_rig_tie(r, "2=1", 120);
    detector_rig_add_tools(r, 2);
    if (when == IN_A_READING) {
        detector_rig_steps(r, 9);
        assert_true(vbss_knot_job_is_active(&detector_rig_object(r)->job));
    } else if (when == AFTER_A_READING) {
        detector_rig_judge(r);
    }
    s->good = r->input;
    memcpy(s->good_tools, r->tools, sizeof s->good_tools);
    s->hash = detector_rig_hash(r);
    s->generation = detector_rig_view(r, VBSS_KNOT_VIEW_EVENTS).generation;
    s->events = detector_rig_view(r, VBSS_KNOT_VIEW_EVENTS).count;
    s->state = detector_rig_state(r);
    s->statistics = detector_rig_statistics(r);
}

static void expect_unchanged(const subject *s)
{
    vbss_knot_state state = detector_rig_state(&s->r);
    vbss_knot_detector_statistics statistics = detector_rig_statistics(&s->r);
    vbss_view events = detector_rig_view(&s->r, VBSS_KNOT_VIEW_EVENTS);
    assert_true(detector_rig_hash(&s->r) == s->hash);
    assert_memory_equal(&state, &s->state, sizeof state);
    assert_memory_equal(&statistics, &s->statistics, sizeof statistics);
    assert_int_equal(events.generation, s->generation);
    assert_int_equal(events.count, s->events);
}

/* Shows what the rig's input is now, and puts back what is good. */
static void refuse(subject *s, vbss_result wanted, const char *name)
{
    const char *text;
    expect_result(wanted, vbss_knot_detector_step(s->r.detector, &s->r.input));
    expect_ok(vbss_context_get_last_error(s->r.context, NULL, &text));
    if (strstr(text, name) == NULL) {
        fail_msg("'%s' does not name '%s'", text, name);
    }
    expect_unchanged(s);
    expect_result(wanted, vbss_knot_detector_judge(s->r.detector, &s->r.input));
    expect_unchanged(s);
    s->r.input = s->good;
    memcpy(s->r.tools, s->good_tools, sizeof s->good_tools);
}

/* A number that must be finite, and lie in a range unless that is empty. */
static void refuse_number(subject *s, double *at, double low, double high, const char *name)
{
    double kept = *at;
    for (int k = 0; k < 3; k++) {
        *at = harness_bad_numbers[k];
        refuse(s, VBSS_ERROR_NOT_FINITE, name);
    }
    for (int k = 0; k < 2 && low < high; k++) {
        *at = k == 0 ? low - 1e-9 : high + 1e-9;
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, name);
        *at = k == 0 ? -DBL_MAX : DBL_MAX;
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, name);
    }
    *at = kept;
}

static void bad_points_are_reported(subject *s)
{
    vbss_knot_input *in = &s->r.input;
    const uint32_t wrong[] = {0, 1}, strides[] = {0, 8, 23, UINT32_MAX};
    for (int k = 0; k < 2; k++) {
        in->point_count = wrong[k];
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "point_count");
    }
    in->point_count = 131;
    refuse(s, VBSS_ERROR_CAPACITY, "131 points");
    in->point_count = UINT32_MAX;
    refuse(s, VBSS_ERROR_CAPACITY, "points");
    in->points = NULL;
    refuse(s, VBSS_ERROR_NULL_ARGUMENT, "points");
    for (int k = 0; k < 4; k++) {
        in->stride_bytes = strides[k];
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "stride_bytes");
    }
    for (uint32_t i = 0; i < in->point_count; i += i < 2 ? 1 : 17) {
        for (int c = 0; c < 3; c++) {
            refuse_number(s, &s->r.points[i][c], -1e3, 1e3, "points");
        }
    }
    refuse_number(s, &s->r.points[in->point_count - 1][2], -1e3, 1e3, "points");
}

static void bad_tools_are_reported(subject *s)
{
    vbss_knot_input *in = &s->r.input;
    const uint32_t counts[] = {0, 1, 5, UINT32_MAX};
    const int32_t held[] = {-1, 3, INT32_MAX, INT32_MIN};
    in->tool_count = RIG_TOOLS + 1;
    refuse(s, VBSS_ERROR_CAPACITY, "4 tools");
    in->tool_count = UINT32_MAX;
    refuse(s, VBSS_ERROR_CAPACITY, "tools");
    in->tools = NULL;
    refuse(s, VBSS_ERROR_NULL_ARGUMENT, "tools");
    for (uint32_t t = 0; t < 2; t++) {
        vbss_knot_tool *tool = &s->r.tools[t];
        for (int k = 0; k < 4; k++) {
            tool->point_count = counts[k];
            refuse(s, VBSS_ERROR_OUT_OF_RANGE, "point_count");
            tool->held = held[k];
            refuse(s, VBSS_ERROR_OUT_OF_RANGE, "held");
        }
        for (int c = 0; c < 6; c++) {
            refuse_number(s, &tool->axis[0][0] + c, -1e3, 1e3, "axis");
        }
        refuse_number(s, &tool->radius[0], 0.0, 1.0, "radius");
        memcpy(tool->axis[1], tool->axis[0], sizeof tool->axis[0]);
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "axis");
    }
    refuse_number(s, &s->r.tools[0].held_place, 0.0, in->point_count - 1.0, "held_place");
    /* Of four points the last two, as well. */
    for (uint32_t i = 0; i < 2; i++) {
        vbss_knot_tool *tool = &s->r.tools[1];
        tool->point_count = 4;
        for (int k = 0; k < 4; k++) {
            tool->axis[k][0] = tool->axis[k][1] = 0.0;
            tool->axis[k][2] = k == 3 && i == 0 ? 0.2 : 0.1 * k;
        }
        tool->radius[2] = i == 0 ? 0.0 : -1e-3;
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, i == 0 ? "axis" : "radius");
    }
}

static void bad_holes_and_flags_are_reported(subject *s)
{
    vbss_knot_input *in = &s->r.input;
    const uint32_t two[] = {2, UINT32_MAX};
    for (int k = 0; k < 2; k++) {
        in->reversed = two[k];
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "reversed");
        in->may_have_passed = two[k];
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "may_have_passed");
        in->reserved = two[k] - 1;
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "reserved");
        in->hole_count = two[k] | 1u;
        refuse(s, VBSS_ERROR_OUT_OF_RANGE, "hole_count");
    }
    for (int i = 0; i < 2; i++) {
        const double wrong[] = {in->point_count - 1.0 + 1e-9, DBL_MAX};
        for (int k = 0; k < 3; k++) {
            in->hole_places[i] = harness_bad_numbers[k];
            refuse(s, VBSS_ERROR_NOT_FINITE, "hole_places");
            in->holes[i][k] = -1.001e3;
            refuse(s, VBSS_ERROR_OUT_OF_RANGE, "holes");
            for (int n = 0; n < 3; n++) {
                in->holes[i][n] = harness_bad_numbers[k];
                refuse(s, VBSS_ERROR_NOT_FINITE, "holes");
            }
        }
        for (int k = 0; k < 2; k++) {
            in->hole_places[i] = wrong[k];
            refuse(s, VBSS_ERROR_OUT_OF_RANGE, "hole_places");
        }
    }
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 3; k++) {
            in->away[c] = harness_bad_numbers[k];
            refuse(s, VBSS_ERROR_NOT_FINITE, "away");
        }
    }
}

static void bad_structs_are_reported(subject *s)
{
    vbss_knot_input *in = &s->r.input;
    struct {
        vbss_knot_input input;
        uint64_t tail[4];
    } longer = {s->good, {0}};
    for (uint32_t size = 0; size < sizeof *in; size += size < 128 ? 8 : 1) {
        in->struct_size = size;
        refuse(s, VBSS_ERROR_STRUCT_SIZE, "struct_size");
    }
    in->struct_size = 4097;
    refuse(s, VBSS_ERROR_STRUCT_SIZE, "struct_size");
    longer.input.struct_size = sizeof longer;
    longer.tail[3] = 1;
    expect_result(VBSS_ERROR_UNKNOWN_FIELD, vbss_knot_detector_step(s->r.detector, &longer.input));
    expect_unchanged(s);
    expect_result(VBSS_ERROR_UNKNOWN_FIELD, vbss_knot_detector_judge(s->r.detector, &longer.input));
    expect_unchanged(s);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_step(s->r.detector, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_judge(s->r.detector, NULL));
    expect_unchanged(s);
}

static void bad_inputs_are_rejected_and_change_nothing(void **state)
{
    (void)state;
    for (moment when = NOTHING_SHOWN; when < MOMENTS; when++) {
        subject s;
        begin_subject(&s, when);
        bad_points_are_reported(&s);
        bad_tools_are_reported(&s);
        bad_holes_and_flags_are_reported(&s);
        bad_structs_are_reported(&s);
        detector_rig_judge(&s.r); /* and what is left is good */
        detector_rig_expect_notation(&s.r, "2=1");
        detector_rig_end(&s.r);
    }
}

/* What a detector that is refused much goes on with is what one goes on with that is not. */
static void rejected_step_leaves_no_trace(void **state)
{
    (void)state;
    subject s, plain;
    begin_subject(&s, IN_A_READING);
    begin_subject(&plain, IN_A_READING);
    for (int i = 0; i < 200; i++) {
        double kept = s.r.points[60][1];
        s.r.points[60][1] = (double)NAN;
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_knot_detector_step(s.r.detector, &s.r.input));
        s.r.points[60][1] = kept;
        detector_rig_steps(&s.r, 1);
        detector_rig_steps(&plain.r, 1);
        detectors_are_alike(s.r.detector, plain.r.detector, true);
    }
    detector_rig_end(&plain.r);
    detector_rig_end(&s.r);
}

/* What is said to be ignored may be anything. */
static void ignored_fields_may_hold_anything(void **state)
{
    (void)state;
    subject s, plain;
    begin_subject(&s, NOTHING_SHOWN);
    begin_subject(&plain, NOTHING_SHOWN);
    s.r.tools[1].held_place = (double)NAN;
    s.r.tools[0].axis[2][1] = s.r.tools[0].radius[1] = (double)INFINITY;
    s.r.tools[0].axis[3][0] = s.r.tools[0].radius[2] = -(double)INFINITY;
    for (int i = 0; i < 2; i++) {
        s.r.input.hole_count = plain.r.input.hole_count = (uint32_t)i;
        s.r.input.hole_places[1] = s.r.input.holes[1][0] = (double)NAN;
        detector_rig_judge(&s.r);
        detector_rig_judge(&plain.r);
        detectors_are_alike(s.r.detector, plain.r.detector, true);
    }
    detector_rig_end(&plain.r);
    detector_rig_end(&s.r);
}

/* ---- the floating-point mode of the host */

static void host_mode_does_not_change_a_reading(void **state)
{
    (void)state;
    subject s, plain;
    uint8_t bytes[16384];
    uint64_t count;
    begin_subject(&s, IN_A_READING);
    begin_subject(&plain, IN_A_READING);
    expect_ok(vbss_knot_detector_save(s.r.detector, bytes, sizeof bytes, &count));
    for (size_t k = 0; k < harness_mode_count; k++) {
        expect_ok(vbss_knot_detector_step(plain.r.detector, &plain.r.input));
        expect_ok(vbss_knot_detector_judge(plain.r.detector, &plain.r.input));
        harness_mode_set(k);
        vbss_result stepped = vbss_knot_detector_step(s.r.detector, &s.r.input);
        vbss_result judged = vbss_knot_detector_judge(s.r.detector, &s.r.input);
        harness_mode_end(k);
        expect_ok(stepped);
        expect_ok(judged);
        assert_true(detector_rig_hash(&s.r) == detector_rig_hash(&plain.r));
    }
    harness_mode_set(0);
    vbss_result restored =
        vbss_knot_detector_restore(s.r.detector, bytes, count); /* repeats a reading */
    harness_mode_end(0);
    expect_ok(restored);
    assert_true(detector_rig_hash(&s.r) == s.hash);
    detector_rig_end(&plain.r);
    detector_rig_end(&s.r);
}

int test_detector_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_inputs_are_rejected_and_change_nothing),
        cmocka_unit_test(rejected_step_leaves_no_trace),
        cmocka_unit_test(ignored_fields_may_hold_anything),
        cmocka_unit_test(host_mode_does_not_change_a_reading),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
