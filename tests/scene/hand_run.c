#include "scene/hand_run.h"

#include <stdlib.h>

#include "base/rotation.h"
#include "scene/api/inspect.h"
#include "fixtures/scene_build.h"
#include "fixtures/step_events.h"

enum { SEGMENTS = 90 };
static const double fastest = 50.0; /* m/s */

/* ---- the scene of random hands: the drain's axis is along x, up is y */

static const vec3 down = {0.0, -9.81, 0.0};

static void add_drain(hand_run *r, const vbss_drain_config *c)
{
    expect_ok(scene_build_drain(r->context, r->scene, c, NULL, &r->config.drain));
}

/* It lies on the floor in front of the drain, its thread beyond. */
static void add_needle(hand_run *r, double floor)
{
    vbss_needle_config n;
    vbss_thread_config t;
    vbss_needle *needle;
    vbss_needle_state state;
    uint32_t pin;
    expect_ok(vbss_needle_config_init(&n, sizeof n));
    pose_store(pose_make(vec3_make(0.0, floor + n.wire_radius + 2e-4, 22e-3),
                         vbss_quat_from_rotation_vector(vec3_make(1.5707963267948966, 0.0, 0.0))),
               n.position, n.orientation);
    vec3_store(n.gravity, down);
    n.drag = 1.0;
    expect_ok(scene_build_needle(r->context, r->scene, &n, &needle, &r->config.needle));
    expect_ok(vbss_needle_get_state(needle, &state, sizeof state));
    expect_ok(vbss_thread_config_init(&t, sizeof t));
    t.segment_count = SEGMENTS;
    t.length = SEGMENTS * 1e-3;
    vec3_store(t.start, vec3_load(state.swage));
    vec3_store(t.direction, vec3_make(0.0, 0.0, 1.0));
    expect_ok(scene_build_thread(r->context, r->scene, &t, NULL, &r->config.thread));
    expect_ok(vbss_scene_pin_thread(r->scene, r->config.thread, 0, r->config.needle, NULL, &pin));
}

/* Shafts up, leaning outward; jaws open along the drain. */
static void add_tool(hand_run *r, int which, vbss_random *random, double floor)
{
    const double side = which == 0 ? -1.0 : 1.0;
    vbss_grasper_config c;
    expect_ok(vbss_grasper_config_init(&c, sizeof c));
    quat up = vbss_quat_from_rotation_vector(vec3_make(-1.5707963267948966, 0.0, 0.0));
    quat lean = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, -0.5 * side));
    const played_room room = {
        .low = vec3_make(-20e-3, floor - 3e-3, -12e-3),
        .high = vec3_make(20e-3, 25e-3, 35e-3),
        .home = pose_make(vec3_make(30e-3 * side, 20e-3, 15e-3), quat_mul(lean, up)),
        .tilt = 0.6};
    const scene_build_hand hand = {room.home.position, room.home.orientation, 1.0};
    expect_ok(scene_build_grasper(r->context, r->scene, &c, &hand, NULL, &r->config.tools[which]));
    played_hand_draw(&r->hands[which], random, &room);
}

void hand_run_begin(hand_run *r, uint64_t seed)
{
    vbss_scene_config c;
    vbss_drain_config d;
    vbss_random random;
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    r->owns_scene = true;
    expect_ok(vbss_session_config_init(&r->config, sizeof r->config));
    vbss_random_seed(&random, seed, 53);
    expect_ok(vbss_scene_config_init(&c, sizeof c));
    expect_ok(vbss_drain_config_init(&d, sizeof d));
    c.floor = 1;
    c.floor_height = -d.radius - 0.5 * d.thickness - 2e-5;
    expect_ok(vbss_scene_create(r->context, &c, &r->scene));
    add_drain(r, &d);
    add_needle(r, c.floor_height);
    for (int i = 0; i < HAND_RUN_HANDS; i++) {
        add_tool(r, i, &random, c.floor_height);
    }
}

/* ---- the scene of a log */

static void find_bodies(hand_run *r)
{
    scene_object *s;
    uint32_t tools = 0;
    expect_ok(vbss_scene_open(r->scene, &s));
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            r->config.thread = b->number;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            r->config.drain = b->number;
        } else if (b->rigid.needle != NULL) {
            r->config.needle = b->number;
        } else if (b->rigid.grasper != NULL) {
            assert_true(tools < HAND_RUN_HANDS);
            r->config.tools[tools++] = b->number;
        }
    }
    assert_int_equal(tools, HAND_RUN_HANDS);
}

static void read_hand(hand_run *r, vbss_replay *replay, int which, uint64_t steps)
{
    vbss_grasper_state state;
    double(*rows)[8] = calloc(steps + 1, sizeof *rows);
    assert_non_null(rows);
    vbss_grasper *grasper = vbss_scene_inspect_body(r->scene, r->config.tools[which]).grasper;
    expect_ok(vbss_grasper_get_state(grasper, &state, sizeof state));
    memcpy(rows[0], state.target_position, sizeof state.target_position);
    memcpy(rows[0] + 3, state.target_orientation, sizeof state.target_orientation);
    rows[0][7] = state.opening;
    for (uint64_t i = 1; i <= steps; i++) {
        vbss_replay_logged_step step;
        expect_ok(vbss_replay_read(replay, i, &step, sizeof step));
        played_hand_follow(&step, r->config.tools[which], rows[i - 1], rows[i]);
    }
    r->rows[which] = rows;
    r->hands[which].rows = (const double(*)[8])rows;
    r->hands[which].row_count = (uint32_t)steps + 1;
}

void hand_run_begin_log(hand_run *r, vbss_context *context, vbss_scene *scene, const uint8_t *log,
                        uint64_t bytes)
{
    vbss_replay *replay;
    uint64_t steps;
    memset(r, 0, sizeof *r);
    r->context = context;
    r->scene = scene;
    expect_ok(vbss_session_config_init(&r->config, sizeof r->config));
    expect_ok(vbss_replay_create(context, log, bytes, &replay));
    expect_ok(vbss_replay_begin(replay, scene));
    expect_ok(vbss_replay_check(replay, &steps));
    find_bodies(r);
    for (int i = 0; i < HAND_RUN_HANDS; i++) {
        read_hand(r, replay, i, steps);
    }
    expect_ok(vbss_replay_destroy(replay));
}

uint32_t hand_run_length(const hand_run *r, double speed)
{
    return (uint32_t)((double)r->hands[0].row_count / speed);
}

void hand_run_end(hand_run *r)
{
    for (int i = 0; i < HAND_RUN_HANDS; i++) {
        free(r->rows[i]);
    }
    if (r->owns_scene) {
        harness_context_end(r->context, &r->memory);
    }
}

/* ---- a run */

static void add_device(hand_run *r, int which)
{
    vbss_mock_config m;
    vbss_mock *mock;
    vbss_device_adapter adapter;
    expect_ok(vbss_mock_config_init(&m, sizeof m));
    m.measure = played_hand_measure;
    m.user = &r->hands[which];
    m.row_capacity = 0;
    expect_ok(vbss_mock_create(r->context, &m, &mock));
    expect_ok(vbss_device_adapter_init(&adapter, sizeof adapter));
    expect_ok(vbss_mock_get_adapter(mock, &adapter));
    expect_ok(vbss_device_create(r->context, &adapter, NULL, NULL, &r->config.devices[which]));
}

void hand_run_start(hand_run *r, double speed)
{
    for (int i = 0; i < HAND_RUN_HANDS; i++) {
        r->hands[i].speed = speed;
        add_device(r, i);
    }
    expect_ok(vbss_session_create(r->scene, &r->config, &r->session));
    task_watch_begin(&r->watch, r->scene);
}

static void count_grasps(hand_run *r)
{
    vbss_scene_event last;
    r->grasps += step_events_find(r->scene, VBSS_SCENE_EVENT_GRASP, &last);
}

void hand_run_steps(hand_run *r, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_session_step(r->session, 1e-3 * (double)r->steps++, 1e-3));
        count_grasps(r);
    }
    for (int i = 0; i < HAND_RUN_HANDS; i++) {
        vbss_output_statistics s;
        expect_ok(vbss_device_get_output_statistics(r->config.devices[i], &s, sizeof s));
        r->largest_force = vbss_max(r->largest_force, s.largest_force);
    }
}

void hand_run_print(const hand_run *r, const char *name, double speed)
{
    const unsigned long long passed =
        r->watch.passed + r->watch.passed_drain + r->watch.needle.passed + r->watch.below;
    print_message(
        "%s at %g times: %llu substeps, %llu grasps, fastest node %.1f m/s, largest force "
        "%.2f N, passed %llu\n",
        name, speed, (unsigned long long)r->watch.substeps, (unsigned long long)r->grasps,
        r->watch.fastest, r->largest_force, passed);
}

void hand_run_expect_kept(const hand_run *r)
{
    vbss_output_config limits;
    expect_ok(vbss_output_config_init(&limits, sizeof limits));
    task_watch_expect_nothing(&r->watch);
    assert_true(r->watch.fastest < fastest);
    assert_true(r->largest_force <= limits.max_force * (1.0 + 1e-12));
}
