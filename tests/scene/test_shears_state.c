/* Scenes whose shears cut: stepped without allocations, saved and restored around the cut, recorded and replayed. */
#include <stdlib.h>

#include "base/error.h"
#include "scene/cut_rig.h"

enum {
    EXCHANGED_AT = 3,
    CLOSED_AT = 5,
    CUT_AT = 48,
    OPENED_AT = 70,
    CLOSED_AGAIN_AT = 160,
    STEPS = 230
};

/* ---- a driver holds a thread; another tool, as shears, cuts it twice */

static vbss_result add_tool(vbss_context *context, vbss_scene *scene, vbss_method method, double y)
{
    vbss_grasper_config config;
    vbss_grasper *grasper;
    uint32_t body;
    const double tip[3] = {0.0, y, -2e-3};
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.method = method;
    config.paper_distance = 3e-3;
    VBSS_TRY(vbss_grasper_create(context, &config, &grasper));
    VBSS_TRY(vbss_grasper_move(grasper, tip, NULL));
    VBSS_TRY(vbss_grasper_set_opening(grasper, 1.0));
    return vbss_scene_add_grasper(scene, grasper, &body);
}

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    const vbss_method *method = user;
    vbss_scene_config config;
    vbss_thread_config own;
    vbss_thread *thread;
    vbss_scene *scene;
    uint32_t body, pin;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    VBSS_TRY(vbss_thread_config_init(&own, sizeof own));
    config.method = own.method = *method;
    config.node_capacity = 80;
    config.contact_capacity = 256;
    config.candidate_capacity = 2048;
    own.cut_capacity = 3;
    own.segment_count = 60;
    own.length = 0.03;
    own.start[1] = -0.015;
    own.direction[0] = 0.0;
    own.direction[1] = 1.0;
    VBSS_TRY(vbss_scene_create(context, &config, &scene));
    VBSS_TRY(vbss_thread_create(context, &own, &thread));
    VBSS_TRY(vbss_scene_add_thread(scene, thread, &body));
    VBSS_TRY(add_tool(context, scene, *method, -8e-3));
    VBSS_TRY(add_tool(context, scene, *method, 2.2e-3));
    VBSS_TRY(vbss_scene_pin_thread(scene, body, 0, 0, NULL, &pin));
    VBSS_TRY(vbss_scene_pin_thread(scene, body, 60, 0, NULL, &pin));
    *handle = scene;
    return VBSS_OK;
}

/* What hands do before a step, told to the tools or, where there is one, to the record. */
typedef struct told {
    vbss_grasper *tools[2];
    uint32_t bodies[2];
    vbss_record *record;
} told;

static vbss_result open_to(const told *t, int k, double opening)
{
    return t->record != NULL ? vbss_record_set_opening(t->record, t->bodies[k], opening)
                             : vbss_grasper_set_opening(t->tools[k], opening);
}

static vbss_result tell(const told *t, uint64_t step)
{
    const double tip[3] = {0.0, 5.3e-3, -2e-3};
    switch (step) {
    case EXCHANGED_AT:
        return t->record != NULL
                   ? vbss_record_exchange(t->record, t->bodies[1], VBSS_GRASPER_SHEARS)
                   : vbss_grasper_exchange(t->tools[1], VBSS_GRASPER_SHEARS);
    case CLOSED_AT:
        return open_to(t, 1, 0.0);
    case CLOSED_AT + 1:
        return open_to(t, 0, 0.0);
    case OPENED_AT:
        return open_to(t, 1, 1.0);
    case OPENED_AT + 50:
        return t->record != NULL ? vbss_record_move_grasper(t->record, t->bodies[1], tip, NULL)
                                 : vbss_grasper_move(t->tools[1], tip, NULL);
    case CLOSED_AGAIN_AT:
        return open_to(t, 1, 0.0);
    default:
        return VBSS_OK;
    }
}

static told tools_of(vbss_scene *scene)
{
    scene_object *s;
    told t = {.bodies = {2, 3}};
    expect_ok(vbss_scene_open(scene, &s));
    for (int k = 0; k < 2; k++) {
        t.tools[k] = (vbss_grasper *)vbss_scene_body(s, t.bodies[k])->rigid.slot;
    }
    return t;
}

static vbss_result step(void *handle)
{
    vbss_scene_statistics statistics;
    told t = tools_of(handle);
    VBSS_TRY(vbss_scene_get_statistics(handle, &statistics, sizeof statistics));
    VBSS_TRY(tell(&t, statistics.steps));
    return vbss_scene_step(handle, 1e-3);
}

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static vbss_method methods[] = {VBSS_METHOD_OURS, VBSS_METHOD_PAPER};

static harness_body body_of(int method)
{
    harness_body body = {"shears that cut", &vbss_scene_kind, create, NULL, step,
                         destroy,           &methods[method]};
    return body;
}

static uint32_t cuts_of(vbss_scene *scene)
{
    vbss_view view;
    uint32_t cuts = 0;
    expect_ok(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_EVENTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        uint32_t words[4];
        memcpy(words, (const char *)view.data + i * view.stride_bytes, sizeof words);
        cuts += words[0] == VBSS_EVENT_CUT && words[2] != 0;
    }
    return cuts;
}

/* ---- */

/* The moments that the tests below are about. */
static void cuts_happen_at_expected_steps(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        void *scene = NULL;
        uint32_t cuts = 0;
        expect_ok(create(context, &methods[method], &scene));
        for (uint32_t i = 1; i <= STEPS; i++) {
            expect_ok(step(scene));
            uint32_t now = cuts_of(scene);
            cuts += now;
            assert_true(now == 0 || i == CUT_AT || i > CLOSED_AGAIN_AT);
            assert_int_equal(cuts, i < CUT_AT ? 0 : i < CLOSED_AGAIN_AT + 40 ? 1 : cuts);
        }
        assert_int_equal(cuts, 2);
        told t = tools_of(scene);
        vbss_grasper_state driver;
        expect_ok(vbss_grasper_get_state(t.tools[0], &driver, sizeof driver));
        assert_int_equal(driver.grasp_count, 1);
        harness_context_end(context, &memory);
    }
}

static void cutting_steps_do_not_allocate(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        harness_body body = body_of(method);
        assert_int_equal(harness_step_allocations(&body, STEPS), 0);
    }
}

/* Before the step that cuts, after it, while the blades close through the ends, and later. */
static void restored_scene_continues_bit_equal_across_cut(void **state)
{
    (void)state;
    const size_t moments[] = {EXCHANGED_AT, CUT_AT - 2, CUT_AT - 1,     CUT_AT,
                              CUT_AT + 1,   CUT_AT + 2, OPENED_AT + 10, CLOSED_AGAIN_AT + 42};
    for (int method = 0; method < 2; method++) {
        harness_body body = body_of(method);
        harness_save_restore_continue_at(&body, moments, sizeof moments / sizeof moments[0], 30);
    }
}

static void bad_snapshots_of_cut_scene_are_rejected(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        harness_body body = body_of(method);
        harness_refuses_bad_snapshots(&body, CUT_AT + 1);
    }
}

/* ---- recorded */

typedef struct bytes {
    uint8_t *all;
    size_t count;
} bytes;

static void take(bytes *log, vbss_record *record)
{
    const uint8_t *more;
    uint64_t count;
    expect_ok(vbss_record_take(record, &more, &count));
    log->all = realloc(log->all, log->count + count + 1);
    assert_non_null(log->all);
    memcpy(log->all + log->count, more, count);
    log->count += count;
}

static void exchange_and_cuts_replay_bit_equal(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        void *scenes[2] = {NULL, NULL};
        bytes log = {NULL, 0};
        uint32_t cuts = 0;
        uint64_t hashes[2];
        for (int k = 0; k < 2; k++) {
            expect_ok(create(context, &methods[method], &scenes[k]));
        }
        told t = tools_of(scenes[0]);
        expect_ok(vbss_record_create(scenes[0], NULL, &t.record));
        for (uint32_t i = 0; i < STEPS; i++) {
            expect_ok(tell(&t, i));
            expect_ok(vbss_record_step(t.record, 1e-3));
            cuts += cuts_of(scenes[0]);
            take(&log, t.record);
        }
        assert_int_equal(cuts, 2);
        expect_ok(vbss_record_end(t.record));
        take(&log, t.record);
        expect_ok(vbss_record_destroy(t.record));
        expect_ok(vbss_scene_get_hash(scenes[0], &hashes[0]));
        /* In a scene made alike, once more in it, and in the one that was recorded, with its cuts. */
        static const int order[] = {1, 1, 0};
        for (int k = 0; k < 3; k++) {
            vbss_replay *replay;
            vbss_replay_report report = {.outcome = VBSS_REPLAY_STEPPED};
            expect_ok(vbss_replay_create(context, log.all, log.count, &replay));
            expect_ok(vbss_replay_begin(replay, scenes[order[k]]));
            while (report.outcome == VBSS_REPLAY_STEPPED) {
                expect_ok(vbss_replay_step(replay, &report, sizeof report));
            }
            assert_int_equal(report.outcome, VBSS_REPLAY_ENDED);
            assert_int_equal(report.agreed_step, STEPS);
            expect_ok(vbss_scene_get_hash(scenes[order[k]], &hashes[1]));
            assert_true(hashes[0] == hashes[1]);
            expect_ok(vbss_replay_destroy(replay));
        }
        free(log.all);
        harness_context_end(context, &memory);
    }
}

int test_shears_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cuts_happen_at_expected_steps),
        cmocka_unit_test(cutting_steps_do_not_allocate),
        cmocka_unit_test(restored_scene_continues_bit_equal_across_cut),
        cmocka_unit_test(bad_snapshots_of_cut_scene_are_rejected),
        cmocka_unit_test(exchange_and_cuts_replay_bit_equal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
