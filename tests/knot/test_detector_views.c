/* What a detector shows of itself: winding, notation, views, events, figures. */
#include "knot/detector_rig.h"
#include "fixtures/knot_body.h"

/* ---- winding */

static void winding_has_hysteresis(void **state)
{
    (void)state;
    static const struct {
        double turns;
        int32_t wrapped;
        vbss_knot_event event; /* 0: none */
    } script[] = {
        {0.5, 0, 0},   {0.74, 0, 0},  {0.76, 1, VBSS_KNOT_EVENT_WRAPPED},
        {0.6, 1, 0},   {0.51, 1, 0},  {0.49, 0, VBSS_KNOT_EVENT_UNWRAPPED},
        {0.7, 0, 0},   {-0.74, 0, 0}, {-1.6, 1, VBSS_KNOT_EVENT_WRAPPED},
        {-0.51, 1, 0}, {0.51, 1, 0},  {0.1, 0, VBSS_KNOT_EVENT_UNWRAPPED},
    };
    for (int sense = 1; sense >= -1; sense -= 2) {
        detector_rig r;
        detector_rig_begin(&r);
        detector_rig_create(&r);
        for (size_t i = 0; i < sizeof script / sizeof script[0]; i++) {
            uint32_t event[4];
            r.input.tool_count = 0;
            detector_rig_wind(&r, script[i].turns);
            r.tools[0].axis[sense > 0 ? 0 : 1][2] =
                0.1; /* the other end is up: towards the handle */
            r.tools[0].axis[sense > 0 ? 1 : 0][2] = 0.0;
            detector_rig_steps(&r, 1);
            vbss_knot_winding w = detector_rig_winding(&r, 0);
            double turns = sense * script[i].turns;
            expect_near(turns, w.turns, 1e-9);
            expect_near(turns, w.run_turns, 1e-9);
            expect_near(0.0, w.run_places[0], 1e-9);
            expect_near(99.0, w.run_places[1], 1e-9);
            expect_near(sense > 0 ? 0.03 : 0.07, w.run_heights[0], 1e-9);
            expect_near(sense > 0 ? 0.01 : 0.09, w.run_heights[1], 1e-9);
            assert_int_equal(w.runs, 1);
            assert_int_equal(w.wrapped, script[i].wrapped);
            assert_true(!w.wrapped || w.sense == sense);
            bool on = script[i].event == VBSS_KNOT_EVENT_WRAPPED;
            bool off = script[i].event == VBSS_KNOT_EVENT_UNWRAPPED;
            assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_WRAPPED, event), on);
            if (on) {
                assert_int_equal(event[1], 0);
                assert_int_equal(event[2], turns > 0.0 ? 2 : 1);
            }
            assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_UNWRAPPED, NULL), off);
            assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_WRONG_DIRECTION, NULL),
                             on && sense < 0);
        }
        detector_rig_end(&r);
    }
}

static void winding_is_of_shown_tools(void **state)
{
    (void)state;
    detector_rig r;
    vbss_knot_winding w;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_knot_detector_get_winding(r.detector, 0, &w, sizeof w));
    detector_rig_wind(&r, 1.6);
    detector_rig_steps(&r, 1);
    assert_int_equal(detector_rig_winding(&r, 0).wrapped, 1);
    vbss_knot_state s = detector_rig_state(&r);
    assert_int_equal(s.next_verdict, VBSS_KNOT_VERDICT_WRAPPING);
    assert_int_equal(s.next_wraps, 1);
    assert_int_equal(s.next_handedness, -1);
    assert_int_equal(s.next_tool, 0);
    const uint32_t none[] = {1, RIG_TOOLS, UINT32_MAX};
    for (int i = 0; i < 3; i++) {
        expect_result(VBSS_ERROR_NOT_FOUND,
                      vbss_knot_detector_get_winding(r.detector, none[i], &w, sizeof w));
    }
    r.input.tool_count = 0;
    detector_rig_steps(&r, 1);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_knot_detector_get_winding(r.detector, 0, &w, sizeof w));
    s = detector_rig_state(&r);
    assert_int_equal(s.next_verdict, VBSS_KNOT_VERDICT_NONE);
    assert_int_equal(s.next_wraps, 0);
    assert_int_equal(s.next_handedness, 0);
    r.input.tool_count = 1; /* another one, for all that is known */
    detector_rig_steps(&r, 1);
    assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_WRAPPED, NULL), 1);
    detector_rig_end(&r);
}

/* ---- notation */

static void notation_needs_space_for_terminator(void **state)
{
    (void)state;
    static const char *const knots[] = {"", "1", "2=1=1", "1x1x1x1=1=1=1=1"};
    for (int i = 0; i < 4; i++) {
        detector_rig r;
        char text[64];
        const size_t need = strlen(knots[i]) + 1;
        detector_rig_begin(&r);
        detector_rig_create(&r);
        detector_rig_tie(&r, knots[i], 400);
        detector_rig_judge(&r);
        assert_true(need <= 32);
        for (size_t capacity = 0; capacity < sizeof text; capacity++) {
            memset(text, 0x5a, sizeof text);
            vbss_result result = vbss_knot_detector_get_notation(r.detector, text, capacity);
            expect_result(capacity < need ? VBSS_ERROR_CAPACITY : VBSS_OK, result);
            for (size_t k = capacity < need ? 0 : need; k < sizeof text; k++) {
                assert_int_equal(text[k], 0x5a);
            }
            assert_true(capacity < need || strcmp(text, knots[i]) == 0);
        }
        expect_result(VBSS_ERROR_NULL_ARGUMENT,
                      vbss_knot_detector_get_notation(r.detector, NULL, sizeof text));
        detector_rig_end(&r);
    }
}

/* ---- views */

static void view_dimensions(void **state)
{
    (void)state;
    detector_rig r;
    for (vbss_knot_method method = VBSS_KNOT_METHOD_TOPOLOGY; method <= VBSS_KNOT_METHOD_PROJECTION;
         method++) {
        detector_rig_begin(&r);
        r.config.method = method;
        detector_rig_create(&r);
        for (int i = 0; i < 2; i++) { /* of nothing, and of thread that winds round a tool */
            for (vbss_knot_field f = VBSS_KNOT_VIEW_EVENTS; f <= VBSS_KNOT_VIEW_LOOPS; f++) {
                vbss_view v = detector_rig_view(&r, f);
                assert_int_equal(v.struct_size, sizeof v);
                assert_int_equal(v.type, VBSS_VIEW_TYPE_U32);
                assert_int_equal(v.components, 4);
                assert_int_equal(v.stride_bytes, 16);
                assert_non_null(v.data);
                bool some = f == VBSS_KNOT_VIEW_EVENTS || method == VBSS_KNOT_METHOD_PROJECTION;
                assert_true((v.count > 0) == (i == 1 && some));
            }
            r.input.tool_count = 0;
            detector_rig_wind(&r, 1.7);
            detector_rig_judge(&r);
        }
        const vbss_knot_field none[] = {-1, 2, INT32_MAX, INT32_MIN};
        for (int i = 0; i < 4; i++) {
            vbss_view v;
            expect_result(VBSS_ERROR_OUT_OF_RANGE,
                          vbss_knot_detector_get_view(r.detector, none[i], &v, sizeof v));
        }
        detector_rig_end(&r);
    }
}

static uint64_t generation(const detector_rig *r)
{
    uint64_t g = detector_rig_view(r, VBSS_KNOT_VIEW_EVENTS).generation;
    assert_true(detector_rig_view(r, VBSS_KNOT_VIEW_LOOPS).generation == g);
    return g;
}

static void generation_changes_with_every_step_and_edit(void **state)
{
    (void)state;
    detector_rig r;
    uint8_t bytes[8192];
    uint64_t written;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    detector_rig_tie(&r, "1", 60);
    uint64_t g = generation(&r);
    for (int k = 0; k < 4; k++) {
        uint64_t before = g;
        expect_ok(vbss_knot_detector_save(r.detector, bytes, sizeof bytes, &written));
        assert_true(generation(&r) == g);
        switch (k) {
        case 0:
            detector_rig_steps(&r, 1);
            break;
        case 1:
            detector_rig_judge(&r);
            break;
        case 2:
            expect_ok(vbss_knot_detector_restore(r.detector, bytes, written));
            break;
        default:
            expect_ok(vbss_knot_detector_reset(r.detector));
        }
        g = generation(&r);
        assert_true(g != before);
        for (int i = DETECTOR_EDITS; i < DETECTOR_CALLS; i++) {
            expect_ok(detector_calls[i](r.detector)); /* looking changes nothing */
        }
        expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_step(r.detector, NULL));
        expect_result(VBSS_ERROR_CORRUPT, detector_call_restore(r.detector));
        assert_true(generation(&r) == g);
    }
    detector_rig_end(&r);
}

static void events_above_capacity_are_counted(void **state)
{
    (void)state;
    detector_rig r;
    for (uint32_t capacity = 8; capacity <= 18; capacity += 2) {
        uint32_t event[4];
        detector_rig_begin(&r);
        r.config.event_capacity = capacity;
        detector_rig_create(&r);
        detector_rig_tie(&r, "1=1=1=1=1=1=1=1", 400);
        detector_rig_judge(&r);
        const uint32_t all = 8 + 8 + 1; /* formed, certified, read */
        vbss_view v = detector_rig_view(&r, VBSS_KNOT_VIEW_EVENTS);
        assert_int_equal(v.count, capacity < all ? capacity : all);
        assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_LOST, event), capacity < all);
        if (capacity < all) {
            assert_int_equal(event[1], all - (capacity - 1));
            assert_int_equal(event[2], 0);
            assert_int_equal(event[3], 0);
        }
        detector_rig_steps(&r, 1);
        assert_int_equal(detector_rig_view(&r, VBSS_KNOT_VIEW_EVENTS).count, 0);
        detector_rig_end(&r);
    }
}

/* ---- figures */

static void counters_are_monotonic_and_add_up(void **state)
{
    (void)state;
    knot_body_options options = {VBSS_KNOT_METHOD_TOPOLOGY, 15000};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *detector = NULL;
    vbss_knot_detector_statistics f = {0}, last = {0};
    uint64_t read = 0, uncertain = 0, revoked = 0;
    expect_ok(knot_body_create(context, &options, &detector));
    detector_rig r = {.context = context, .detector = detector};
    for (int i = 0; i < 3 * MOVING_KNOT_PERIOD; i++) {
        if (i % 50 == 49) { /* drops what is being read: its work was done nevertheless */
            moving_knot shown;
            expect_ok(moving_knot_show((uint64_t)i, &shown));
            expect_ok(vbss_knot_detector_judge(detector, &shown.input));
        } else {
            expect_ok(knot_body_step(detector));
        }
        f = detector_rig_statistics(&r);
        read += detector_rig_events(&r, VBSS_KNOT_EVENT_READ, NULL);
        revoked += detector_rig_events(&r, VBSS_KNOT_EVENT_REVOKED, NULL);
        uncertain += f.readings > last.readings &&
                     detector_rig_state(&r).verdict == VBSS_KNOT_VERDICT_UNCERTAIN;
        const uint64_t *now = &f.readings, *before = &last.readings;
        for (int k = 0; k < 12; k++) {
            assert_true(now[k] >= before[k]);
        }
        assert_true(f.certified <= f.closures && f.degenerate + f.overflows <= f.projections);
        assert_true(f.most_work <= f.work && f.most_step_work <= f.work);
        last = f;
    }
    assert_true(f.readings == read && f.uncertain == uncertain && f.revoked == revoked);
    assert_true(read > 20 && uncertain > 0 && revoked > 0);
    assert_true(f.closures > f.readings && f.removed > f.closures && f.work > 1000 * f.readings);
    harness_context_end(context, &memory);
}

int test_detector_views(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(winding_has_hysteresis),
        cmocka_unit_test(winding_is_of_shown_tools),
        cmocka_unit_test(notation_needs_space_for_terminator),
        cmocka_unit_test(view_dimensions),
        cmocka_unit_test(generation_changes_with_every_step_and_edit),
        cmocka_unit_test(events_above_capacity_are_counted),
        cmocka_unit_test(counters_are_monotonic_and_add_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
