/* Sessions are made of what is there, refuse what is not, and keep the promises of the house. */
#include <string.h>

#include "base/error.h"
#include "rig.h"

/* ---- configurations */

static vbss_result init_config(void *config, uint32_t struct_size)
{
    return vbss_session_config_init(config, struct_size);
}

/* Beyond today's size, as the harness has it. */
enum { FURTHER = 64 };

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    static vbss_context *owner; /* of a scene that serves all calls of a test */
    static session_scene scene;
    vbss_session *session;
    uint32_t size = *(const uint32_t *)config;
    if (owner != context) {
        VBSS_TRY(session_scene_still(context, &scene));
        owner = context;
    }
    /* the numbers of the bodies come with the scene */
    union {
        vbss_session_config config;
        unsigned char bytes[sizeof(vbss_session_config) + FURTHER];
    } own = {0};
    memcpy(own.bytes, config, size < sizeof own ? size : sizeof own);
    memcpy(own.bytes, &size, sizeof size);
    vbss_session_config *c = &own.config;
    if (size >= offsetof(vbss_session_config, gap_measure)) {
        c->thread = scene.config.thread;
        c->needle = scene.config.needle;
        c->drain = scene.config.drain;
        c->tools[0] = scene.config.tools[0];
        c->tools[1] = scene.config.tools[1];
    }
    VBSS_TRY(vbss_session_create(scene.scene, c, &session));
    return vbss_session_destroy(session);
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {
        offsetof(vbss_session_config, gap_measure), /* before the slit's lips */
        offsetof(vbss_session_config, lost_share),  /* before lost time */
        offsetof(vbss_session_config, exercise),    /* before exercises */
        sizeof(vbss_session_config), 0};
    const harness_config config = {sizes, init_config, create_and_destroy};
    harness_config_protocol(&config);
}

static void expect_refused(rig *r, vbss_result wanted, const vbss_session_config *c)
{
    vbss_session *session = (vbss_session *)r->context;
    expect_result(wanted, vbss_session_create(r->scene.scene, c, &session));
    assert_null(session);
}

/* The status for a tool or another body of a session that has the number of a wrong body. */
static vbss_result refusal_of(const rig *r, uint32_t number, bool is_tool)
{
    vbss_scene_body_info info;
    if (number == 0 || vbss_scene_get_body(r->scene.scene, number, &info, sizeof info) != VBSS_OK) {
        return VBSS_ERROR_NOT_FOUND;
    }
    return is_tool && info.kind == VBSS_SCENE_BODY_GRASPER ? VBSS_ERROR_IN_USE
                                                           : VBSS_ERROR_INCOMPATIBLE;
}

static void bodies_must_have_their_kind(void **state)
{
    (void)state;
    rig r;
    rig_make(&r);
    uint32_t *const fields[] = {&r.scene.config.thread,   &r.scene.config.needle,
                                &r.scene.config.drain,    &r.scene.config.tools[0],
                                &r.scene.config.tools[1], &r.scene.config.shears};
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        uint32_t good = *fields[i];
        for (uint32_t number = 0; number < 8; number++) {
            *fields[i] = number;
            if (number != good) {
                expect_refused(&r, refusal_of(&r, number, i >= 3), &r.scene.config);
            }
        }
        *fields[i] = good;
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_session_create(r.scene.scene, &r.scene.config, NULL));
    expect_refused(&r, VBSS_ERROR_NULL_ARGUMENT, NULL);
    rig_end(&r);
}

static void bad_numbers_are_rejected(void **state)
{
    (void)state;
    rig r;
    rig_make(&r);
    vbss_session_config c = r.scene.config;
    double *const numbers[] = {&c.time_limit,   &c.dwell,       &c.throw_dwell,   &c.tail_low,
                               &c.tail_high,    &c.tail_margin, &c.tail_reach,    &c.seat_gap,
                               &c.seat_release, &c.seat_force,  &c.avulsed_share, &c.break_force,
                               &c.lost_share};
    uint32_t *const words[] = {&c.event_capacity, &c.knot_interval, &c.hash_interval};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        double good = *numbers[i];
        for (int k = 0; k < 3; k++) {
            *numbers[i] = harness_bad_numbers[k];
            expect_refused(&r, VBSS_ERROR_NOT_FINITE, &c);
        }
        *numbers[i] = -1.0;
        expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, &c);
        *numbers[i] = 2e6;
        expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, &c);
        *numbers[i] = good;
    }
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        uint32_t good = *words[i];
        *words[i] = 0;
        expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, &c);
        *words[i] = UINT32_MAX;
        expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, &c);
        *words[i] = good;
    }
    rig_end(&r);
}

static void gap_is_measured_between_lips_or_edges(void **state)
{
    (void)state;
    for (int i = VBSS_SESSION_GAP_LIPS; i <= VBSS_SESSION_GAP_EDGES; i++) {
        rig r;
        vbss_drain_gap gap;
        vbss_session_status status;
        rig_make(&r);
        r.scene.config.gap_measure = (vbss_session_gap)2;
        expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, &r.scene.config);
        r.scene.config.gap_measure = (vbss_session_gap)i;
        expect_ok(vbss_session_create(r.scene.scene, &r.scene.config, &r.session));
        expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
        expect_ok(vbss_session_get_status(r.session, &status, sizeof status));
        expect_ok(vbss_drain_get_gap(r.scene.drain, &gap, sizeof gap));
        assert_true(gap.opening < gap.gap - 1e-4);
        expect_near(i == VBSS_SESSION_GAP_LIPS ? gap.opening : gap.gap, status.gap, 0.0);
        rig_end(&r);
    }
}

static void parts_must_be_alive_and_of_this_context(void **state)
{
    (void)state;
    rig r, other;
    vbss_knot_detector_config small;
    rig_begin(&r);
    rig_begin(&other);
    vbss_session_config c = r.scene.config;
    c.metrics = other.metrics;
    expect_refused(&r, VBSS_ERROR_INVALID_HANDLE, &c);
    c.metrics = (vbss_metrics *)r.session;
    expect_refused(&r, VBSS_ERROR_INVALID_HANDLE, &c);
    c.metrics = NULL;
    c.devices[0] = (vbss_device *)r.session;
    expect_refused(&r, VBSS_ERROR_INVALID_HANDLE, &c);
    c.devices[0] = NULL;
    expect_ok(vbss_record_create(other.scene.scene, NULL, &c.record));
    expect_refused(&r, VBSS_ERROR_INVALID_HANDLE, &c);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_session_set_record(r.session, c.record));
    c.record = NULL;
    expect_ok(vbss_knot_detector_config_init(&small, sizeof small));
    small.point_capacity = 60;
    expect_ok(vbss_knot_detector_create(r.context, &small, &c.knots));
    expect_refused(&r, VBSS_ERROR_CAPACITY, &c);
    /* one that ends first is told */
    expect_ok(vbss_metrics_destroy(r.metrics));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_session_step(r.session, 0.0, 1e-3));
    uint64_t written;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_session_save(r.session, NULL, 0, &written));
    expect_ok(vbss_scene_destroy(r.scene.scene));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_session_step(r.session, 0.0, 1e-3));
    rig_end(&other);
    rig_end(&r);
}

static void scene_stepped_outside_session_is_detected(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    const uint64_t events = r.s->event_count;
    expect_ok(vbss_scene_step(r.scene.scene, 1e-3));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_step(r.session, 0.0, 1e-3));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_step(r.session, 0.0, -1.0));
    assert_int_equal(r.s->event_count, events);
    rig_end(&r);
}

/* ---- handles */

static vbss_result call_step(void *handle)
{
    return vbss_session_step(handle, 0.0, 1e-3);
}

static vbss_result call_set_record(void *handle)
{
    return vbss_session_set_record(handle, NULL);
}

static vbss_result call_get_status(void *handle)
{
    vbss_session_status status;
    return vbss_session_get_status(handle, &status, sizeof status);
}

static vbss_result call_get_event(void *handle)
{
    vbss_session_event event;
    return vbss_session_get_event(handle, 0, &event, sizeof event);
}

static vbss_result call_save(void *handle)
{
    uint64_t written;
    return vbss_session_save(handle, NULL, 0, &written);
}

static vbss_result call_restore(void *handle)
{
    const uint8_t bytes[8] = {0};
    return vbss_session_restore(handle, bytes, sizeof bytes);
}

static vbss_result call_get_hash(void *handle)
{
    uint64_t hash;
    return vbss_session_get_hash(handle, &hash);
}

static vbss_result call_destroy(void *handle)
{
    return handle == NULL ? VBSS_ERROR_INVALID_HANDLE : vbss_session_destroy(handle);
}

static void bad_handles_are_rejected(void **state)
{
    (void)state;
    static const harness_handle_call calls[] = {call_step,      call_set_record, call_get_status,
                                                call_get_event, call_save,       call_restore,
                                                call_get_hash,  call_destroy};
    rig r;
    rig_begin(&r);
    expect_ok(vbss_session_destroy(r.session));
    expect_ok(vbss_session_destroy(NULL));
    harness_refuses_bad_handles(r.context, r.session, calls, sizeof calls / sizeof calls[0]);
    rig_end(&r);
}

/* ---- memory */

/* In a scene that outlives all attempts: what allocations of its own may do is for the tests of scenes. */
static vbss_result make_and_step(rig *r)
{
    vbss_session *session = (vbss_session *)r->context;
    vbss_result result = vbss_session_create(r->scene.scene, &r->scene.config, &session);
    if (result != VBSS_OK) {
        assert_null(session);
        return result;
    }
    result = vbss_session_step(session, 0.0, RIG_STEP);
    expect_ok(vbss_session_destroy(session));
    return result;
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    rig r;
    uint64_t hash, after;
    rig_make(&r);
    r.scene.config.metrics = NULL; /* none has been measured with */
    for (int ever_after = 0; ever_after < 2; ever_after++) {
        uint64_t failed = 0, before;
        do {
            before = r.memory.failures;
            const uint64_t blocks = r.memory.blocks;
            expect_ok(vbss_scene_get_hash(r.scene.scene, &hash));
            r.memory.fail_call = r.memory.calls + failed + 1;
            r.memory.fail_ever_after = ever_after == 1;
            vbss_result result = make_and_step(&r);
            r.memory.fail_call = 0;
            if (r.memory.failures > before) {
                failed++;
                expect_result(VBSS_ERROR_OUT_OF_MEMORY, result);
                expect_ok(vbss_scene_get_hash(r.scene.scene, &after));
                assert_true(hash == after);
            } else {
                expect_ok(result);
            }
            assert_int_equal(r.memory.blocks, blocks);
            assert_int_equal(r.memory.wrong_releases, 0);
        } while (r.memory.failures > before);
        print_message("%llu allocations failed\n", (unsigned long long)failed);
        assert_true(failed >= 2);
    }
    rig_end(&r);
}

/* ---- events */

static void lost_events_are_reported(void **state)
{
    (void)state;
    rig r;
    vbss_session_event e;
    rig_make(&r);
    r.scene.config.event_capacity = 8;
    rig_start(&r);
    for (uint32_t i = 0; i < 20; i++) {
        r.observation.tools[RIG_LEFT].has_needle = i % 2 == 0;
        rig_run(&r, 0.1);
    }
    const vbss_session_status status = rig_status(&r);
    assert_true(status.event_count > 40);
    assert_int_equal(status.first_event, status.event_count - 8);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_session_get_event(r.session, status.first_event - 1, &e, sizeof e));
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_session_get_event(r.session, status.event_count, &e, sizeof e));
    for (uint64_t i = status.first_event; i < status.event_count; i++) {
        expect_ok(vbss_session_get_event(r.session, i, &e, sizeof e));
        assert_int_equal(e.ordinal, i);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_session_get_event(r.session, status.first_event, NULL, sizeof e));
    rig_end(&r);
}

typedef struct heard {
    vbss_session *session;
    uint32_t count;
} heard;

static void hear(void *user, const vbss_session_event *event)
{
    heard *h = user;
    vbss_session_event same;
    assert_int_equal(event->ordinal, h->count++);
    if (h->session != NULL) {
        expect_ok(vbss_session_get_event(h->session, event->ordinal, &same, sizeof same));
        assert_int_equal(same.kind, event->kind);
        expect_result(VBSS_ERROR_BUSY, vbss_session_step(h->session, 0.0, 1e-3));
    }
}

static void listener_receives_each_event_once(void **state)
{
    (void)state;
    rig r;
    heard h = {0};
    rig_make(&r);
    r.scene.config.listen = hear;
    r.scene.config.user = &h;
    expect_ok(vbss_session_create(r.scene.scene, &r.scene.config, &r.session));
    h.session = r.session;
    for (int i = 0; i < 3; i++) {
        expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    }
    assert_int_equal(h.count, 2); /* appeared, loading */
    rig_end(&r);
}

int test_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(bodies_must_have_their_kind),
        cmocka_unit_test(bad_numbers_are_rejected),
        cmocka_unit_test(gap_is_measured_between_lips_or_edges),
        cmocka_unit_test(parts_must_be_alive_and_of_this_context),
        cmocka_unit_test(scene_stepped_outside_session_is_detected),
        cmocka_unit_test(bad_handles_are_rejected),
        cmocka_unit_test(each_failed_allocation_is_reported),
        cmocka_unit_test(lost_events_are_reported),
        cmocka_unit_test(listener_receives_each_event_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
