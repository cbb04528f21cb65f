/* Moves of a host surface in a log: a replay repeats them to the bit, without the host's model. */
#include "fixture.h"

#include <math.h>

#include <vblast_ss/scene_surface.h>

enum { STEPS = 40, CELLS = 4, ROW = CELLS + 1 };

typedef struct rocking {
    harness_memory memory;
    vbss_context *context;
    vbss_scene *scene;
    uint32_t surface;
} rocking;

static void place_vertices(uint32_t step, double x[ROW * ROW][3])
{
    for (int i = 0; i < ROW * ROW; i++) {
        const int row = i / ROW;
        x[i][0] = 10e-3 * row - 20e-3;
        x[i][2] = 10e-3 * (i % ROW) - 20e-3;
        x[i][1] = -1e-3 + 0.02 * x[i][0] * sin(0.2 * step) + 0.5e-3 * sin(0.3 * step);
    }
}

static void begin(rocking *r)
{
    vbss_scene_config config = vbss_scene_config_default();
    vbss_thread_config own = vbss_thread_config_default();
    vbss_scene_surface_config surface = vbss_scene_surface_config_default();
    vbss_thread *thread;
    uint32_t triangles[2 * CELLS * CELLS][3], body, count = 0;
    double x[ROW * ROW][3];
    *r = (rocking){.context = NULL};
    r->context = harness_context(&r->memory);
    config.node_capacity = 60;
    own.segment_count = 30;
    own.length = 0.03;
    own.gravity[1] = -9.81;
    for (uint32_t i = 0; i < CELLS * CELLS; i++, count += 2) {
        const uint32_t a = i / CELLS * ROW + i % CELLS, b = a + ROW;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[count], cell, sizeof cell);
    }
    place_vertices(0, x);
    surface.vertex_count = ROW * ROW;
    surface.triangle_count = count;
    surface.vertices = x[0];
    surface.triangles = triangles[0];
    expect_ok(vbss_scene_create(r->context, &config, &r->scene));
    expect_ok(vbss_scene_add_surface(r->scene, &surface, &r->surface));
    expect_ok(vbss_thread_create(r->context, &own, &thread));
    expect_ok(vbss_scene_add_thread(r->scene, thread, &body));
}

static void replay_repeats_a_moving_surface_to_the_bit(void **state)
{
    (void)state;
    rocking r, other;
    vbss_record *record;
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_record_config config;
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 1;
    begin(&r);
    expect_ok(vbss_record_create(r.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(r.scene, record));
    for (uint32_t i = 1; i <= STEPS; i++) {
        double x[ROW * ROW][3];
        place_vertices(i, x);
        expect_ok(vbss_scene_move_surface(r.scene, r.surface, x[0], ROW * ROW));
        expect_ok(vbss_scene_step(r.scene, 1e-3));
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    begin(&other);
    expect_ok(vbss_replay_create(other.context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_begin(replay, other.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    uint64_t one = 0, two = 0;
    expect_ok(vbss_scene_get_hash(r.scene, &one));
    expect_ok(vbss_scene_get_hash(other.scene, &two));
    assert_true(one == two);
    expect_ok(vbss_replay_destroy(replay));
    log_free(&log);
    harness_context_end(other.context, &other.memory);
    harness_context_end(r.context, &r.memory);
}

/* The replay has no host that could say where a hole is. */
static void replay_follows_another_mesh_without_the_host(void **state)
{
    (void)state;
    enum { FINER = 2 * CELLS, FINER_ROW = FINER + 1, AT = 15 };
    rocking r;
    harness_memory memory;
    vbss_record *record;
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_record_config config;
    vbss_scene *loaded = NULL;
    log_bytes log = {NULL, 0};
    double finer[FINER_ROW * FINER_ROW][3];
    uint32_t triangles[2 * FINER * FINER][3];
    for (uint32_t i = 0; i < FINER_ROW * FINER_ROW; i++) {
        const uint32_t x = i / FINER_ROW;
        finer[i][0] = 5e-3 * x - 20e-3;
        finer[i][1] = -1e-3;
        finer[i][2] = 5e-3 * (i % FINER_ROW) - 20e-3;
    }
    for (uint32_t i = 0; i < FINER * FINER; i++) {
        const uint32_t a = i / FINER * FINER_ROW + i % FINER, b = a + FINER_ROW;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[2 * (size_t)i], cell, sizeof cell);
    }
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 1;
    begin(&r);
    expect_ok(vbss_record_create(r.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(r.scene, record));
    for (uint32_t i = 1; i <= STEPS; i++) {
        if (i == AT) {
            expect_ok(vbss_scene_remesh_surface(r.scene, r.surface, finer[0], FINER_ROW * FINER_ROW,
                                                triangles[0], 2 * FINER * FINER, NULL, NULL));
        }
        expect_ok(vbss_scene_step(r.scene, 1e-3));
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &loaded));
    expect_ok(vbss_replay_begin(replay, loaded));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    expect_ok(vbss_replay_destroy(replay));
    log_free(&log);
    harness_context_end(context, &memory);
    harness_context_end(r.context, &r.memory);
}

int test_host_surface_log(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(replay_repeats_a_moving_surface_to_the_bit),
        harness_test(replay_follows_another_mesh_without_the_host),
    };
    return cmocka_run_group_tests_name("record.host_surface_log", tests, NULL, NULL);
}
