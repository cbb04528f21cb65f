/* Two devices move the tools: the needle is taken, handed over and dropped, hands feel it, and the log replays without them. */
#include "log_bytes.h"
#include "rig.h"
#include "fixtures/needle_scenes.h"

enum { STEPS = 2000, INTERVAL = 500 };

static double begun; /* of the script, on the devices' clock, s */
static bool let_go;  /* the handles are open, whatever the script says */

static void measure(void *user, double time, vbss_device_sample *sample)
{
    const int *tool = user;
    needle_scene_hand(*tool, (time - begun) / RIG_STEP, sample->position, sample->orientation,
                      &sample->jaw);
    sample->jaw = let_go ? 1.0 : sample->jaw;
    sample->valid =
        (uint32_t)(VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW);
}

static vbss_device *device_of(rig *r, const int *tool, uint32_t takeover, vbss_mock **mock)
{
    vbss_device_config c;
    vbss_mock_config m;
    vbss_device_adapter adapter;
    vbss_device *device;
    union {
        const int *in;
        void *out;
    } user = {tool};
    expect_ok(vbss_mock_config_init(&m, sizeof m));
    m.measure = measure;
    m.user = user.out;
    m.row_capacity = 2 * STEPS;
    expect_ok(vbss_mock_create(r->context, &m, mock));
    expect_ok(vbss_device_adapter_init(&adapter, sizeof adapter));
    expect_ok(vbss_mock_get_adapter(*mock, &adapter));
    expect_ok(vbss_device_config_init(&c, sizeof c));
    c.jaw_takeover = takeover;
    expect_ok(vbss_device_create(r->context, &adapter, NULL, &c, &device));
    return device;
}

static const int tools[2] = {0, 1};

static void start_with_devices(rig *r, uint32_t takeover, vbss_mock *mocks[2])
{
    begun = 0.0;
    let_go = false;
    for (int i = 0; i < 2; i++) {
        r->scene.config.devices[i] = device_of(r, &tools[i], takeover, &mocks[i]);
    }
    expect_ok(vbss_session_create(r->scene.scene, &r->scene.config, &r->session));
    expect_ok(vbss_session_open(r->session, &r->s));
}

static void expect_events(rig *r)
{
    rig_expect(r, VBSS_SESSION_EVENT_APPEARED, 0, 0);
    rig_expect_phase(r, VBSS_SESSION_PHASE_LOADING, 0);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 0)->tool, VBSS_METRICS_TOOL_LEFT);
    rig_expect_phase(r, VBSS_SESSION_PHASE_APPROACH, 0);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 0)->tool, VBSS_METRICS_TOOL_RIGHT);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 1)->tool, VBSS_METRICS_TOOL_LEFT);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 1)->tool, VBSS_METRICS_TOOL_RIGHT);
    rig_expect(r, VBSS_SESSION_EVENT_DROPPED, 0, 0);
    rig_expect_phase(r, VBSS_SESSION_PHASE_LOADING, 1);
    rig_expect_quiet(r);
}

static uint64_t hash_of(const rig *r)
{
    uint64_t hash;
    expect_ok(vbss_session_get_hash(r->session, &hash));
    return hash;
}

static void begin(rig *r)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(session_scene_floor(r->context, &r->scene));
}

static uint64_t replay(const log_bytes *log)
{
    rig r;
    begin(&r);
    expect_ok(vbss_replay_create(r.context, log->bytes, log->count, &r.scene.config.replay));
    expect_ok(vbss_replay_begin(r.scene.config.replay, r.scene.scene));
    expect_ok(vbss_session_create(r.scene.scene, &r.scene.config, &r.session));
    expect_ok(vbss_session_open(r.session, &r.s));
    for (int i = 0; i < STEPS; i++) {
        expect_ok(vbss_session_step(r.session, 0.0, 0.0));
    }
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_step(r.session, 0.0, 0.0));
    expect_events(&r);
    uint64_t hash = hash_of(&r);
    rig_end(&r);
    return hash;
}

static void devices_hand_needle_over(void **state)
{
    (void)state;
    rig r;
    vbss_mock *mocks[2];
    log_bytes log = {NULL, 0};
    begin(&r);
    expect_ok(vbss_record_create(r.scene.scene, NULL, &r.scene.config.record));
    start_with_devices(&r, 0, mocks);
    double largest = 0.0;
    for (int i = 0; i < STEPS; i++) {
        expect_ok(vbss_session_step(r.session, i * RIG_STEP, RIG_STEP));
        if (i % INTERVAL == INTERVAL - 1) {
            log_take(&log, r.scene.config.record);
        }
    }
    for (int i = 0; i < 2; i++) {
        vbss_view rows;
        expect_ok(vbss_mock_get_view(mocks[i], VBSS_MOCK_VIEW_ROWS, &rows, sizeof rows));
        assert_int_equal(rows.count, STEPS);
        for (uint64_t k = 0; k < rows.count; k++) {
            const double *row = (const double *)rows.data + 9 * k;
            largest = vbss_max(largest, vec3_norm(vec3_load(row + 1)));
        }
    }
    assert_true(largest > 1e-3 && largest < 3.0 + 1e-9); /* N: the needle, and tools that meet */
    expect_events(&r);
    uint64_t hash = hash_of(&r);
    expect_ok(vbss_record_end(r.scene.config.record));
    log_take(&log, r.scene.config.record);
    rig_end(&r);
    assert_true(replay(&log) == hash);
    free(log.bytes);
}

static void run(rig *r, int *step, int count)
{
    for (int i = 0; i < count; i++, (*step)++) {
        expect_ok(vbss_session_step(r->session, *step * RIG_STEP, RIG_STEP));
    }
}

/* The needle is in the jaws, the hand is away from the closed handle: with the option nothing is dropped until the handle was
 * closed once. */
static void restored_session_keeps_needle(void **state)
{
    (void)state;
    enum { HELD = 450, LATER = 400, ROOM = 1 << 21 };
    static uint8_t scene[ROOM], session[ROOM];
    for (uint32_t takeover = 0; takeover < 2; takeover++) {
        rig r;
        vbss_mock *mocks[2];
        uint64_t scene_size, session_size;
        int step = 0;
        begin(&r);
        start_with_devices(&r, takeover, mocks);
        run(&r, &step, HELD);
        assert_int_equal(r.s->holding_tools.value, 1);
        expect_ok(vbss_scene_save(r.scene.scene, scene, ROOM, &scene_size));
        expect_ok(vbss_session_save(r.session, session, ROOM, &session_size));
        run(&r, &step, 40);
        expect_ok(vbss_scene_restore(r.scene.scene, scene, scene_size));
        expect_ok(vbss_session_restore(r.session, session, session_size));
        begun = 40 * RIG_STEP;
        let_go = true;
        run(&r, &step, LATER);
        assert_int_equal(r.s->holding_tools.value, takeover);
        let_go = false; /* the script's handle is closed, */
        run(&r, &step, 80);
        let_go = true; /* and opens */
        run(&r, &step, LATER);
        assert_int_equal(r.s->holding_tools.value, 0);
        rig_end(&r);
    }
}

static void wrong_clock_switches_both_hands_off(void **state)
{
    (void)state;
    rig r;
    vbss_mock *mocks[2];
    int step = 0;
    begin(&r);
    start_with_devices(&r, 0, mocks);
    run(&r, &step, 600);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_session_step(r.session, -50.0, RIG_STEP));
    for (int i = 0; i < 2; i++) {
        vbss_view rows;
        expect_ok(vbss_mock_get_view(mocks[i], VBSS_MOCK_VIEW_ROWS, &rows, sizeof rows));
        const double *row = (const double *)rows.data + 9 * (rows.count - 1);
        assert_true(rows.count == 601 && vec3_norm(vec3_load(row + 1)) == 0.0 && row[7] == 0.0);
    }
    run(&r, &step, 1);
    rig_end(&r);
}

int test_hands(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(devices_hand_needle_over),
                                       cmocka_unit_test(restored_session_keeps_needle),
                                       cmocka_unit_test(wrong_clock_switches_both_hands_off)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
