/* A thread that tears a wall at its hole, in a log: replayed to the bit, also from snapshots inside the log, when the wall is a
 * sheet, a surface of the host, or the slit drain. */
#include "record/replayed.h"
#include "scene/tear_rig.h"

enum { STEPS = 120, INTERVAL = 16 };

typedef enum wall { SHEET, HOST_SURFACE, DRAIN } wall;

/* of both ends of the thread, m/s: the drain yields, before it tears */
static const double speeds[] = {[SHEET] = 40e-3, [HOST_SURFACE] = 40e-3, [DRAIN] = 80e-3};

static double torn_length_of(vbss_scene *scene)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
    return hole.torn_length;
}

static vec3 create(tear_rig *r, wall kind)
{
    vec3 direction = {1.0, 0.0, 0.0};
    tear_rig_begin(r, false);
    r->is_of_host = kind == HOST_SURFACE;
    if (kind == DRAIN) {
        tear_rig_create_drain(r, &direction);
    } else {
        tear_rig_create(r, 6, 6);
    }
    return vec3_scale(direction, speeds[kind]);
}

typedef struct tear {
    tear_rig rig;
    vec3 velocity;
    double torn[STEPS + 1]; /* m, after each step */
} tear;

static void step_tear(void *user, uint32_t k)
{
    tear *t = user;
    tear_rig_step(&t->rig, t->velocity);
    t->torn[k] = torn_length_of(t->rig.s.scene);
}

static void expect_torn(void *user, vbss_scene *scene, uint32_t k)
{
    const tear *t = user;
    expect_near(t->torn[k], torn_length_of(scene), 0.0);
}

static void expect_replay_of(wall kind)
{
    uint64_t hashes[STEPS + 1];
    tear t = {.torn = {0.0}};
    t.velocity = create(&t.rig, kind);
    const replayed r = {t.rig.s.scene, STEPS, INTERVAL, &t, step_tear, expect_torn};
    log_bytes log = replayed_log(&r, hashes);
    uint32_t first = 1;
    while (first < STEPS && t.torn[first] == 0.0) {
        first++;
    }
    assert_true(first > 1 && first < STEPS - 20 && t.torn[STEPS] > 0.5e-3);
    /* Within the tear, before it, and as it begins. */
    const uint32_t sought[] = {STEPS - 3, first / 2, first + 7, first};
    expect_replayed(&r, &log, hashes, sought, sizeof sought / sizeof sought[0]);
    log_free(&log);
    tear_rig_end(&t.rig);
}

static void tear_in_a_sheet_is_replayed(void **state)
{
    (void)state;
    expect_replay_of(SHEET);
}

static void tear_in_a_host_surface_is_replayed(void **state)
{
    (void)state;
    expect_replay_of(HOST_SURFACE);
}

static void tear_in_the_drain_is_replayed(void **state)
{
    (void)state;
    expect_replay_of(DRAIN);
}

int test_tear_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tear_in_a_sheet_is_replayed),
        cmocka_unit_test(tear_in_a_host_surface_is_replayed),
        cmocka_unit_test(tear_in_the_drain_is_replayed),
    };
    return cmocka_run_group_tests_name("record.tear_log", tests, NULL, NULL);
}
