/* Configurations of detectors: their defaults, their ends, and every bad number and count with its status and a text
 * that names it. */
#include <float.h>

#include "knot/detector_rig.h"

/* ---- what is there */

static void defaults_match_documentation(void **state)
{
    (void)state;
    vbss_knot_detector_config c;
    vbss_knot_input in;
    memset(&c, 0xff, sizeof c);
    memset(&in, 0xff, sizeof in);
    expect_ok(vbss_knot_detector_config_init(&c, sizeof c));
    expect_ok(vbss_knot_input_init(&in, sizeof in));
    const vbss_knot_detector_config config = {.struct_size = sizeof c,
                                              .method = VBSS_KNOT_METHOD_TOPOLOGY,
                                              .point_capacity = 1024,
                                              .tool_capacity = 4,
                                              .crossing_capacity = 512,
                                              .direction_limit = 6,
                                              .closure_count = 8,
                                              .closure_tolerance = 2,
                                              .step_budget = 8000,
                                              .interval = 20,
                                              .event_capacity = 64,
                                              .tail_reach = 0.03,
                                              .tail_least = 0.003,
                                              .wrap_turns = 0.75,
                                              .slip_limit = 0.45,
                                              .plane_offset = -0.002,
                                              .seed = 1};
    const vbss_knot_input input = {
        .struct_size = sizeof in, .stride_bytes = 24, .hole_places = {-1.0, -1.0}};
    assert_memory_equal(&c, &config, sizeof c);
    assert_memory_equal(&in, &input, sizeof in);
}

static void default_detector(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    expect_ok(vbss_knot_detector_create(r.context, NULL, &r.detector));
    vbss_knot_state s = detector_rig_state(&r);
    assert_int_equal(s.steps, 0);
    assert_int_equal(s.reading_step, 0);
    assert_int_equal(s.name, VBSS_KNOT_NAME_NONE);
    assert_int_equal(s.verdict, VBSS_KNOT_VERDICT_NONE);
    assert_int_equal(s.throw_count, 0);
    detector_rig_expect_notation(&r, "");
    detector_rig_tie(&r, "2=1=1", 240);
    detector_rig_judge(&r);
    detector_rig_expect_notation(&r, "2=1=1");
    detector_rig_end(&r);
}

/* ---- capacities at their ends */

static void documented_minimum_suffices(void **state)
{
    (void)state;
    detector_rig r;
    for (vbss_knot_method method = VBSS_KNOT_METHOD_TOPOLOGY; method <= VBSS_KNOT_METHOD_PROJECTION;
         method++) {
        detector_rig_begin(&r);
        r.config.method = method;
        r.config.point_capacity = 2;
        r.config.tool_capacity = 0;
        r.config.crossing_capacity = r.config.event_capacity = 8;
        r.config.direction_limit = 1;
        r.config.closure_count = r.config.closure_tolerance = r.config.interval = 0;
        r.config.step_budget = 100;
        r.config.tail_reach = r.config.tail_least = r.config.slip_limit = 0.0;
        r.config.wrap_turns = 0.1;
        detector_rig_create(&r);
        r.input.point_count = 2;
        detector_rig_steps(&r, 30);
        detector_rig_judge(&r);
        assert_int_equal(detector_rig_state(&r).verdict, VBSS_KNOT_VERDICT_NONE);
        assert_int_equal(detector_rig_state(&r).steps, 31);
        detector_rig_end(&r);
    }
}

static void documented_maximum_is_accepted(void **state)
{
    (void)state;
    detector_rig r;
    for (vbss_knot_method method = VBSS_KNOT_METHOD_TOPOLOGY; method <= VBSS_KNOT_METHOD_PROJECTION;
         method++) {
        detector_rig_begin(&r);
        r.config.method = method;
        r.config.point_capacity = 8192;
        r.config.tool_capacity = 16;
        r.config.crossing_capacity = 2048;
        r.config.direction_limit = 64;
        r.config.closure_count = r.config.closure_tolerance = 16;
        r.config.step_budget = 1000000000;
        r.config.interval = UINT32_MAX;
        r.config.event_capacity = 4096;
        r.config.tail_reach = r.config.tail_least = r.config.slip_limit = 1.0;
        r.config.wrap_turns = 2.0;
        detector_rig_create(&r);
        detector_rig_tie(&r, "2=1", 120);
        detector_rig_add_tools(&r, 3);
        detector_rig_judge(&r);
        if (method == VBSS_KNOT_METHOD_TOPOLOGY) {
            detector_rig_expect_notation(&r, "2=1");
        }
        detector_rig_end(&r);
    }
}

/* ---- what is refused */

static void expect_config(detector_rig *r, vbss_result wanted, const char *name)
{
    vbss_knot_detector *detector = (vbss_knot_detector *)r->context;
    vbss_context_statistics before, after;
    const char *text;
    expect_ok(vbss_context_get_statistics(r->context, &before, sizeof before));
    vbss_result result = vbss_knot_detector_create(r->context, &r->config, &detector);
    expect_result(wanted, result);
    if (result == VBSS_OK) { /* what can be made can be used */
        expect_ok(vbss_knot_detector_judge(detector, &r->input));
        expect_ok(vbss_knot_detector_destroy(detector));
        return;
    }
    assert_null(detector);
    expect_ok(vbss_context_get_last_error(r->context, NULL, &text));
    assert_non_null(strstr(text, name));
    expect_ok(vbss_context_get_statistics(r->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
    assert_int_equal(before.objects_created, after.objects_created);
}

#define FIELD(field, low, high)                                           \
    {                                                                     \
#field, offsetof(vbss_knot_detector_config, field), (low), (high) \
    }

static void bad_config_numbers_are_rejected(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        size_t offset;
        double low, high;
    } numbers[] = {FIELD(tail_reach, 0.0, 1.0), FIELD(tail_least, 0.0, 1.0),
                   FIELD(wrap_turns, 0.1, 2.0), FIELD(slip_limit, 0.0, 1.0),
                   FIELD(plane_offset, -1.0, 1.0)};
    detector_rig r;
    detector_rig_begin(&r);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        double *at = (double *)(void *)((char *)&r.config + numbers[i].offset), kept = *at;
        const double far[] = {numbers[i].low - 1e-9, numbers[i].high + 1e-9, -DBL_MAX, DBL_MAX};
        for (int k = 0; k < 3; k++) {
            *at = harness_bad_numbers[k];
            expect_config(&r, VBSS_ERROR_NOT_FINITE, numbers[i].name);
        }
        for (int k = 0; k < 4; k++) {
            *at = far[k];
            expect_config(&r, VBSS_ERROR_OUT_OF_RANGE, numbers[i].name);
        }
        *at = numbers[i].low;
        expect_config(&r, VBSS_OK, "");
        *at = numbers[i].high;
        expect_config(&r, VBSS_OK, "");
        *at = kept;
    }
    detector_rig_end(&r);
}

static void bad_config_counts_are_rejected(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        size_t offset;
        uint32_t low, high;
    } choices[] = {
        FIELD(method, 0, 1),
        FIELD(point_capacity, 20, 8192), /* of 20 that are shown */
        FIELD(tool_capacity, 0, 16),
        FIELD(crossing_capacity, 8, 2048),
        FIELD(direction_limit, 1, 64),
        FIELD(closure_count, 0, 16),
        FIELD(closure_tolerance, 0, 16),
        FIELD(step_budget, 100, 1000000000),
        FIELD(interval, 0, UINT32_MAX),
        FIELD(event_capacity, 8, 4096),
        FIELD(reserved, 0, 0),
    };
    detector_rig r;
    detector_rig_begin(&r);
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        uint32_t *at = (uint32_t *)(void *)((char *)&r.config + choices[i].offset), kept = *at;
        *at = choices[i].low;
        expect_config(&r, VBSS_OK, "");
        *at = choices[i].high;
        expect_config(&r, VBSS_OK, "");
        if (choices[i].high < UINT32_MAX) {
            *at = choices[i].high + 1;
            expect_config(&r, VBSS_ERROR_OUT_OF_RANGE, choices[i].name);
            *at = UINT32_MAX;
            expect_config(&r, VBSS_ERROR_OUT_OF_RANGE, choices[i].name);
        }
        if (choices[i].low > 0) {
            *at = choices[i].low == 20 ? 1 : choices[i].low - 1;
            expect_config(&r, VBSS_ERROR_OUT_OF_RANGE, choices[i].name);
            *at = 0;
            expect_config(&r, VBSS_ERROR_OUT_OF_RANGE, choices[i].name);
        }
        *at = kept;
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_create(r.context, &r.config, NULL));
    detector_rig_end(&r);
}

int test_detector_config(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_match_documentation),
        cmocka_unit_test(default_detector),
        cmocka_unit_test(documented_minimum_suffices),
        cmocka_unit_test(documented_maximum_is_accepted),
        cmocka_unit_test(bad_config_numbers_are_rejected),
        cmocka_unit_test(bad_config_counts_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
