/* A tool takes a needle and turns it by the aid ARC: the needle follows its own circle, the aid is in the events, the
 * metrics and the log, and the log replays and is restored without any input of hands. */
#include <math.h>

#include "base/rotation.h"
#include "log_bytes.h"
#include "rig.h"
#include "fixtures/needle_scenes.h"

enum {
    LIFTED = NEEDLE_SCENE_LIFTED,
    DRIVEN = LIFTED + 300,
    STEPS = DRIVEN + 40,
    SAVED = LIFTED + 90
};
enum { ROOM = 1 << 21 };
#define STRIDE 5e-5 /* m a step along the direction */

typedef struct driven {
    rig r;
    double along; /* by the input, since the aid is on, m */
} driven;

static void begin(driven *d)
{
    vbss_metrics_config c;
    memset(d, 0, sizeof *d);
    d->r.context = harness_context(&d->r.memory);
    expect_ok(session_scene_floor(d->r.context, &d->r.scene));
    expect_ok(vbss_metrics_config_init(&c, sizeof c));
    c.duration = 10.0;
    expect_ok(vbss_metrics_create(d->r.context, &c, &d->r.metrics));
    d->r.scene.config.metrics = d->r.metrics;
}

static void start(driven *d)
{
    expect_ok(vbss_session_create(d->r.scene.scene, &d->r.scene.config, &d->r.session));
    expect_ok(vbss_session_open(d->r.session, &d->r.s));
}

static void switch_aids(const driven *d, uint32_t aids)
{
    vbss_session_assistance a = vbss_session_assistance_default();
    a.aids = aids;
    a.direction[1] = 1.0;
    expect_ok(vbss_session_set_assistance(d->r.session, &a));
}

/* The first tool does what the script says until the needle is lifted, then its hand goes along y. */
static void make_step(driven *d, int step)
{
    vbss_session_hand hand = vbss_session_hand_default();
    if (step == LIFTED) {
        switch_aids(d, VBSS_SESSION_AID_ARC);
    }
    if (step == DRIVEN) {
        switch_aids(d, 0);
    }
    needle_scene_hand(0, step < LIFTED ? step : LIFTED, hand.position, hand.orientation,
                      &hand.opening);
    d->along += step > LIFTED && step < DRIVEN ? STRIDE : 0.0;
    hand.position[1] += d->along;
    hand.position[0] += step > LIFTED ? 1e-3 * (step % 3 - 1) : 0.0; /* which the aid leaves out */
    expect_ok(vbss_session_move_hand(d->r.session, VBSS_METRICS_TOOL_LEFT, &hand));
    expect_ok(vbss_session_step(d->r.session, 0.0, RIG_STEP));
}

static pose needle_of(const driven *d)
{
    const scene_body_info body =
        vbss_scene_inspect_body(d->r.scene.scene, d->r.scene.config.needle);
    return vbss_scene_inspect_needle(body.needle).pose;
}

static double radius_of(const driven *d)
{
    const scene_body_info body =
        vbss_scene_inspect_body(d->r.scene.scene, d->r.scene.config.needle);
    return vbss_scene_inspect_needle(body.needle).arc_radius;
}

static uint64_t hash_of(const driven *d)
{
    uint64_t scene, session;
    expect_ok(vbss_scene_get_hash(d->r.scene.scene, &scene));
    expect_ok(vbss_session_get_hash(d->r.session, &session));
    return scene ^ session * 3;
}

/* The steps at which the aid was switched on and off, and no more. */
static void expect_events(const driven *d)
{
    vbss_session_event e;
    const vbss_session_status status = rig_status(&d->r);
    uint64_t steps[2] = {0, 0}, count = 0;
    for (uint64_t i = status.first_event; i < status.event_count; i++) {
        expect_ok(vbss_session_get_event(d->r.session, i, &e, sizeof e));
        if (e.kind == VBSS_SESSION_EVENT_AID) {
            assert_int_equal(e.number, VBSS_SESSION_AID_ARC);
            assert_int_equal(e.undone, count);
            expect_near(e.undone == 0 ? 1.0 : 0.0, e.amount, 0.0);
            steps[count++ % 2] = e.step;
        }
    }
    assert_int_equal(count, 2);
    assert_int_equal(steps[0], LIFTED + 1); /* steps count from 1 */
    assert_int_equal(steps[1], DRIVEN + 1);
    assert_int_equal(status.aids, 0);
    assert_int_equal(status.aids_used, VBSS_SESSION_AID_ARC);
}

static void expect_no_score(const driven *d)
{
    vbss_metrics_report report;
    vbss_metrics_penalty p;
    expect_ok(vbss_metrics_get_report(d->r.metrics, &report, sizeof report));
    assert_true((report.flags & (uint32_t)VBSS_METRICS_FLAG_ASSISTED) != 0);
    expect_near(0.0, report.score, 0.0);
    expect_ok(vbss_metrics_get_penalty(d->r.metrics, report.penalty_count - 1, &p, sizeof p));
    assert_int_equal(p.kind, VBSS_METRICS_PENALTY_ASSISTED);
    assert_int_equal(p.number, VBSS_SESSION_AID_ARC);
}

static uint64_t hashes[STEPS];

static void record(log_bytes *log)
{
    static driven d;
    vbss_record_config c;
    vbss_metrics_report report;
    begin(&d);
    expect_ok(vbss_record_config_init(&c, sizeof c));
    c.snapshot_interval = 100;
    expect_ok(vbss_record_create(d.r.scene.scene, &c, &d.r.scene.config.record));
    start(&d);
    for (int i = 0; i < STEPS; i++) {
        make_step(&d, i);
        log_take(log, d.r.scene.config.record);
        hashes[i] = hash_of(&d);
        if (i == LIFTED - 1) {
            expect_ok(vbss_metrics_get_report(d.r.metrics, &report, sizeof report));
            assert_true(report.score > 500.0);
        }
    }
    expect_ok(vbss_record_end(d.r.scene.config.record));
    log_take(log, d.r.scene.config.record);
    expect_events(&d);
    expect_no_score(&d);
    rig_end(&d.r);
}

static void a_log_replays_without_the_aid(void **state)
{
    (void)state;
    static driven d;
    log_bytes log = {NULL, 0};
    record(&log);
    begin(&d);
    expect_ok(vbss_replay_create(d.r.context, log.bytes, log.count, &d.r.scene.config.replay));
    expect_ok(vbss_replay_begin(d.r.scene.config.replay, d.r.scene.scene));
    start(&d);
    for (int i = 0; i < STEPS; i++) {
        expect_ok(vbss_session_step(d.r.session, 0.0, 0.0));
        assert_true(hash_of(&d) == hashes[i]);
    }
    expect_events(&d);
    expect_no_score(&d);
    expect_ok(vbss_session_seek(d.r.session, SAVED));
    assert_true(hash_of(&d) == hashes[SAVED - 1]);
    assert_int_equal(rig_status(&d.r).aids, VBSS_SESSION_AID_ARC);
    const vbss_session_hand hand = vbss_session_hand_default();
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_set_assistance(d.r.session, NULL));
    expect_result(VBSS_ERROR_WRONG_STATE,
                  vbss_session_move_hand(d.r.session, VBSS_METRICS_TOOL_LEFT, &hand));
    rig_end(&d.r);
    free(log.bytes);
}

/* Where the needle's tip is beside the circle that the needle lay on, m. */
static double off_circle(const driven *d, pose first)
{
    const double radius = radius_of(d);
    const vec3 tip = pose_apply(needle_of(d), vec3_make(radius, 0.0, 0.0));
    const vec3 local = pose_apply_inverse(first, tip);
    const double outward = sqrt(local.x * local.x + local.y * local.y) - radius;
    return sqrt(outward * outward + local.z * local.z);
}

static void the_needle_follows_its_circle(void **state)
{
    (void)state;
    static driven d;
    static uint8_t scene[ROOM], session[ROOM];
    uint64_t scene_size, session_size;
    double along = 0.0, largest = 0.0;
    begin(&d);
    start(&d);
    for (int i = 0; i < LIFTED; i++) {
        make_step(&d, i);
    }
    assert_int_equal(d.r.s->holding_tools.value, 1);
    const pose first = needle_of(&d);
    for (int i = LIFTED; i < DRIVEN; i++) {
        make_step(&d, i);
        largest = vbss_max(largest, off_circle(&d, first));
        if (i == SAVED - 1) {
            expect_ok(vbss_scene_save(d.r.scene.scene, scene, ROOM, &scene_size));
            expect_ok(vbss_session_save(d.r.session, session, ROOM, &session_size));
            along = d.along;
        }
    }
    const quat turned = quat_mul(needle_of(&d).orientation, quat_conjugate(first.orientation));
    const double wanted = 299.0 * STRIDE / radius_of(&d);
    print_message("off its circle by %.4f mm, turned by %.4f of %.4f rad\n", 1e3 * largest,
                  vec3_norm(vbss_quat_to_rotation_vector(turned)), wanted);
    assert_true(largest < 0.2e-3);
    expect_near(wanted, vec3_norm(vbss_quat_to_rotation_vector(turned)), 0.05);
    /* A restored session goes on with the same bits. */
    const uint64_t hash = hash_of(&d);
    const pose last = needle_of(&d);
    expect_ok(vbss_scene_restore(d.r.scene.scene, scene, scene_size));
    expect_ok(vbss_session_restore(d.r.session, session, session_size));
    d.along = along;
    for (int i = SAVED; i < DRIVEN; i++) {
        make_step(&d, i);
    }
    const pose again = needle_of(&d);
    assert_memory_equal(&last, &again, sizeof last);
    assert_true(hash_of(&d) == hash);
    session[session_size / 2] ^= 1;
    assert_int_not_equal(vbss_session_restore(d.r.session, session, session_size), VBSS_OK);
    rig_end(&d.r);
}

int test_assistance_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_log_replays_without_the_aid),
        cmocka_unit_test(the_needle_follows_its_circle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
