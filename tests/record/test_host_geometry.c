/* A log of a scene with a static mesh, a plane and a rigid mesh: it replays to the same hashes in a scene of its own, and one that
 * was made before. */
#include "fixture.h"
#include "record/record.h"

enum { STEPS = 80, ADDED_AT = 5 };

typedef struct geometry {
    harness_memory memory;
    vbss_context *context;
    vbss_scene *scene;
} geometry;

static void add_mesh(const geometry *g)
{
    static const double vertices[][3] = {
        {-0.02, 0.0, -0.02}, {-0.02, 3e-3, 0.02}, {0.02, 0.0, 0.02}, {0.02, 2e-3, -0.02}};
    static const uint32_t triangles[][3] = {{0, 1, 2}, {0, 2, 3}};
    uint32_t body;
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = 4;
    mesh.triangle_count = 2;
    mesh.vertices = vertices[0];
    mesh.triangles = triangles[0];
    expect_ok(vbss_scene_add_static_mesh(g->scene, &mesh, &body));
}

/* A driven mesh below the thread, which rises and turns in each step. */
static uint32_t add_rigid_mesh(const geometry *g)
{
    static const double vertices[][3] = {
        {-0.006, 0.0, -0.01}, {-0.006, 1e-3, 0.01}, {0.006, 0.0, 0.01}, {0.006, 1e-3, -0.01}};
    static const uint32_t triangles[][3] = {{0, 1, 2}, {0, 2, 3}};
    uint32_t body;
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    vbss_scene_rigid_config motion = vbss_scene_rigid_config_default();
    mesh.vertex_count = 4;
    mesh.triangle_count = 2;
    mesh.vertices = vertices[0];
    mesh.triangles = triangles[0];
    motion.position[1] = 3e-3;
    expect_ok(vbss_scene_add_rigid_mesh(g->scene, &motion, &mesh, &body));
    return body;
}

static void move_rigid_mesh(const geometry *g, uint32_t body, uint32_t step)
{
    const double position[3] = {0.0, 3e-3 + 0.05e-3 * step, 0.0},
                 orientation[4] = {1.0, 0.002 * step, 0.0, 0.003 * step};
    expect_ok(vbss_scene_set_rigid_target(g->scene, body, position, orientation));
}

static void add_plane(const geometry *g, double slope)
{
    uint32_t body;
    vbss_scene_plane_config plane = vbss_scene_plane_config_default();
    plane.normal[0] = slope;
    plane.height = 1e-3;
    expect_ok(vbss_scene_add_plane(g->scene, &plane, &body));
}

static void begin(geometry *g)
{
    vbss_scene_config config = vbss_scene_config_default();
    vbss_thread_config own = vbss_thread_config_default();
    vbss_thread *thread;
    uint32_t body;
    *g = (geometry){.context = NULL};
    g->context = harness_context(&g->memory);
    config.node_capacity = 60;
    own.segment_count = 20;
    own.length = 0.02;
    own.start[0] = -0.01;
    own.start[1] = 5e-3;
    expect_ok(vbss_scene_create(g->context, &config, &g->scene));
    expect_ok(vbss_thread_create(g->context, &own, &thread));
    expect_ok(vbss_scene_add_thread(g->scene, thread, &body));
    add_mesh(g);
    add_plane(g, 0.2);
}

static log_bytes log_of_fall(const geometry *g, bool adds_geometry, uint64_t *hash)
{
    uint32_t mesh = 0;
    vbss_record *record;
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_create(g->scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(g->scene, record));
    for (uint32_t i = 0; i < STEPS; i++) {
        if (adds_geometry && i == ADDED_AT) {
            add_plane(g, -0.2);
            mesh = add_rigid_mesh(g);
        }
        if (mesh != 0) {
            move_rigid_mesh(g, mesh, i);
        }
        expect_ok(vbss_scene_step(g->scene, 1e-3));
    }
    vbss_scene_statistics statistics;
    expect_ok(vbss_scene_get_statistics(g->scene, &statistics, sizeof statistics));
    assert_true(statistics.contacts > 0);
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    expect_ok(vbss_scene_get_hash(g->scene, hash));
    return log;
}

/* `made`: a scene that was made alike; NULL: the log makes its own. */
static void expect_replay(const log_bytes *log, const geometry *made, uint64_t expected)
{
    harness_memory memory;
    vbss_context *own = harness_context(&memory);
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_scene *scene = NULL;
    uint64_t hash;
    expect_ok(
        vbss_replay_create(made != NULL ? made->context : own, log->bytes, log->count, &replay));
    if (made != NULL) {
        scene = made->scene;
        expect_ok(vbss_replay_begin(replay, scene));
    } else {
        expect_ok(vbss_replay_load_scene(replay, &scene));
    }
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    expect_ok(vbss_scene_get_hash(scene, &hash));
    assert_true(hash == expected);
    expect_ok(vbss_replay_destroy(replay));
    harness_context_end(own, &memory);
}

static void fall_on_a_mesh_and_a_plane_replays_bit_equal(void **state)
{
    (void)state;
    geometry g, other;
    uint64_t hash;
    begin(&g);
    begin(&other);
    log_bytes log = log_of_fall(&g, false, &hash);
    expect_replay(&log, NULL, hash);
    expect_replay(&log, &other, hash);
    expect_replay(&log, &g, hash);
    log_free(&log);
    harness_context_end(other.context, &other.memory);
    harness_context_end(g.context, &g.memory);
}

/* A log also describes bodies that were added during the recording. */
static void geometry_added_while_recording_replays_bit_equal(void **state)
{
    (void)state;
    geometry g;
    uint64_t hash;
    begin(&g);
    log_bytes log = log_of_fall(&g, true, &hash);
    expect_replay(&log, NULL, hash);
    log_free(&log);
    harness_context_end(g.context, &g.memory);
}

int test_host_geometry(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(fall_on_a_mesh_and_a_plane_replays_bit_equal),
        harness_test(geometry_added_while_recording_replays_bit_equal),
    };
    return cmocka_run_group_tests_name("record.host_geometry", tests, NULL, NULL);
}
