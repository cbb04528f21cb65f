/* How detectors begin and end, what handles and structs they refuse, and where their memory goes. */
#include "knot/detector_rig.h"
#include "fixtures/knot_body.h"

/* ---- the size protocols */

/* Small ones, as hundreds are made. */
static vbss_result config_init(void *config, uint32_t struct_size)
{
    vbss_knot_detector_config *c = config;
    VBSS_TRY(vbss_knot_detector_config_init(config, struct_size));
    c->point_capacity = 8;
    c->crossing_capacity = 8;
    return VBSS_OK;
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_knot_detector *detector;
    VBSS_TRY(vbss_knot_detector_create(context, config, &detector));
    return vbss_knot_detector_destroy(detector);
}

static const double line[3][3] = {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.02, 0.01, 0.0}};

static vbss_result input_init(void *input, uint32_t struct_size)
{
    vbss_knot_input *in = input;
    VBSS_TRY(vbss_knot_input_init(input, struct_size));
    in->points = line[0];
    in->point_count = 3;
    return VBSS_OK;
}

static vbss_result show_and_destroy(vbss_context *context, const void *input)
{
    vbss_knot_detector_config config;
    vbss_knot_detector *detector;
    VBSS_TRY(config_init(&config, sizeof config));
    VBSS_TRY(vbss_knot_detector_create(context, &config, &detector));
    vbss_result result = vbss_knot_detector_step(detector, input);
    assert_int_equal(vbss_knot_detector_judge(detector, input), result);
    VBSS_TRY(vbss_knot_detector_destroy(detector));
    return result;
}

static void input_struct_size_protocol(void **state)
{
    (void)state;
    static const uint32_t config_sizes[] = {96, 0}, input_sizes[] = {136, 0};
    const harness_config config = {config_sizes, config_init, create_and_destroy};
    const harness_config input = {input_sizes, input_init, show_and_destroy};
    harness_config_protocol(&config);
    harness_config_protocol(&input);
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    detector_rig_tie(&r, "1", 60);
    detector_rig_add_tools(&r, 1);
    detector_rig_judge(&r);
    for (int which = 0; which < DETECTOR_STRUCTS; which++) {
        unsigned char out[256];
        const uint32_t own = detector_struct_sizes[which];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, detector_write_out(r.detector, which, NULL, own));
        for (uint32_t size = 0; size < own; size++) {
            expect_result(VBSS_ERROR_STRUCT_SIZE, detector_write_out(r.detector, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(detector_write_out(r.detector, which, out, 200));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, own);
        for (uint32_t i = own; i < sizeof out; i++) {
            assert_int_equal(out[i], i < 200 ? 0 : 0xff);
        }
    }
    detector_rig_end(&r);
}

/* ---- handles */

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    vbss_knot_detector *destroyed = r.detector, *none = destroyed;
    expect_ok(vbss_knot_detector_destroy(destroyed));
    harness_refuses_bad_handles(r.context, destroyed, detector_calls, DETECTOR_CALLS);
    expect_ok(vbss_knot_detector_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_knot_detector_destroy(destroyed));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_knot_detector_destroy((vbss_knot_detector *)r.context));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_knot_detector_create(NULL, &r.config, &none));
    assert_null(none);
    none = destroyed;
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_knot_detector_create((vbss_context *)destroyed, &r.config, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_knot_detector_create(NULL, &r.config, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_create(r.context, NULL, NULL));
    detector_rig_end(&r);
}

/* ---- inside callbacks */

typedef struct listener {
    vbss_context *context;
    vbss_knot_detector *detector;
    vbss_result results[DETECTOR_CALLS], created, destroyed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_knot_detector *made = NULL;
    (void)level;
    (void)message;
    if (l->heard++ > 0) {
        return;
    }
    for (int i = 0; i < DETECTOR_CALLS; i++) {
        l->results[i] = detector_calls[i](l->detector);
    }
    l->created = vbss_knot_detector_create(l->context, NULL, &made);
    l->destroyed = vbss_knot_detector_destroy(l->detector);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    detector_rig r;
    detector_rig_begin(&r);
    expect_ok(vbss_context_destroy(r.context));
    vbss_context_config config = harness_watched_config(&r.memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &r.context));
    r.config.step_budget = 300;
    detector_rig_create(&r);
    detector_rig_tie(&r, "1", 60);
    detector_rig_steps(&r, 5);
    l.context = r.context;
    l.detector = r.detector;
    uint64_t before = detector_rig_hash(&r);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_step(r.detector, NULL));
    assert_int_equal(l.heard, 1);
    for (int i = 0; i < DETECTOR_CALLS; i++) {
        expect_result(i < DETECTOR_EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    expect_result(VBSS_ERROR_BUSY, l.destroyed);
    assert_true(detector_rig_hash(&r) == before);
    /* All of these work outside; the restore has nothing to read. */
    for (int i = 0; i < DETECTOR_CALLS; i++) {
        expect_result(detector_calls[i] == detector_call_restore ? VBSS_ERROR_CORRUPT : VBSS_OK,
                      detector_calls[i](r.detector));
    }
    detector_rig_end(&r);
}

/* ---- memory */

static knot_body_options both[] = {{VBSS_KNOT_METHOD_TOPOLOGY, 300},
                                   {VBSS_KNOT_METHOD_PROJECTION, 300}};

static vbss_result live(vbss_context *context, void *user)
{
    void *detector;
    VBSS_TRY(knot_body_create(context, user, &detector));
    vbss_result result = VBSS_OK;
    for (int i = 0; i < 5 && result == VBSS_OK; i++) {
        result = knot_body_step(detector);
    }
    VBSS_TRY(knot_body_destroy(detector));
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        harness_fail_every_allocation(live, &both[i]);
    }
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        const harness_body body = knot_body(&both[i]);
        assert_int_equal(harness_step_allocations(&body, (size_t)2 * MOVING_KNOT_PERIOD), 0);
    }
    detector_rig r;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    detector_rig_tie(&r, "2=1=1", 200);
    detector_rig_add_tools(&r, 3);
    uint64_t calls = r.memory.calls;
    detector_rig_judge(&r);
    expect_ok(vbss_knot_detector_reset(r.detector));
    detector_rig_steps(&r, 50);
    assert_int_equal(r.memory.calls, calls);
    detector_rig_end(&r);
}

static void context_end_destroys_live_detectors(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    r.config.step_budget = 300;
    detector_rig_tie(&r, "2=1", 120);
    for (int i = 0; i < 3; i++) { /* never shown anything, in a reading, after it */
        detector_rig_create(&r);
        detector_rig_steps(&r, i == 1 ? 5 : 0);
        if (i == 2) {
            detector_rig_judge(&r);
        }
    }
    detector_rig_end(&r);
}

/* ---- reset */

static void try_reset(knot_body_options *options, uint64_t lived)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *fresh = NULL, *other = NULL;
    expect_ok(knot_body_create(context, options, &fresh));
    expect_ok(knot_body_create(context, options, &other));
    for (uint64_t k = 0; k < lived; k++) {
        expect_ok(knot_body_step(other));
    }
    expect_ok(vbss_knot_detector_reset(other));
    for (int k = 0; k < 60; k++) {
        detectors_are_alike(fresh, other, true);
        expect_ok(knot_body_step(fresh));
        expect_ok(knot_body_step(other));
    }
    harness_context_end(context, &memory);
}

static void reset_clears_all_state(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        for (uint64_t lived = 0; lived < MOVING_KNOT_PERIOD; lived += 1 + lived / 2) {
            try_reset(&both[i], lived);
        }
    }
}

int test_detector_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(input_struct_size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(calls_inside_callback_are_rejected),
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(context_end_destroys_live_detectors),
        cmocka_unit_test(reset_clears_all_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
