/* The state of a needle: how it begins, is set, is taken from a scene, and is shown after a restore. */
#include "base/check.h"
#include "fixture.h"

static void throw_it(vbss_needle_config *config)
{
    expect_ok(vbss_needle_config_init(config, sizeof *config));
    config->drag = 0.5;
    vec3_store(config->gravity, vec3_make(0.3, -0.2, -9.81));
    vec3_store(config->position, vec3_make(0.1, 0.2, 0.3));
    vec3_store(config->velocity, vec3_make(0.5, -1.0, 2.0));
    vec3_store(config->angular_velocity, vec3_make(40.0, -20.0, 3.0));
}

static void restored_needle_shows_same_views(void **state)
{
    (void)state;
    fixture f;
    uint8_t bytes[1024];
    uint64_t need, written;
    begin(&f);
    throw_it(&f.config);
    vbss_needle *first = make(&f);
    vec3_store(f.config.position, vec3_zero()); /* where it began does not matter any more */
    vbss_needle *second = make(&f);
    steps(first, 1e-3, 7);
    expect_result(VBSS_ERROR_CAPACITY, vbss_needle_save(first, NULL, 0, &need));
    expect_ok(vbss_needle_save(first, bytes, sizeof bytes, &written));
    assert_int_equal(need, written);
    uint64_t generation = inside(second)->generation;
    expect_ok(vbss_needle_restore(second, bytes, written));
    assert_true(inside(second)->generation > generation);
    const vbss_needle_state a = get_state(first), b = get_state(second);
    assert_memory_equal(&a, &b, sizeof a);
    assert_memory_equal(&inside(first)->body, &inside(second)->body, sizeof(vbss_rigid));
    end(&f);
}

static void motion_of_owner_is_taken_over(void **state)
{
    (void)state;
    fixture f;
    vbss_slot *slot;
    begin(&f);
    vec3_store(f.config.velocity, vec3_make(1.0, 2.0, 3.0));
    vec3_store(f.config.angular_velocity, vec3_make(10.0, -20.0, 30.0));
    vbss_needle *needle = make(&f), *twin = make(&f);
    expect_ok(vbss_slot_open(needle, &vbss_needle_kind, &slot));
    slot->owner = &f;
    steps(twin, 1e-3, 3);
    uint64_t generation = inside(needle)->generation;
    vbss_needle_set_motion(inside(needle), &inside(twin)->body.now, 5);
    assert_true(inside(needle)->generation > generation);
    assert_memory_equal(&inside(twin)->body, &inside(needle)->body, sizeof(vbss_rigid));
    vbss_needle_state seen = get_state(needle);
    assert_int_equal(seen.body, 5);
    seen.body = 0;
    const vbss_needle_state wanted = get_state(twin);
    assert_memory_equal(&wanted, &seen, sizeof seen);
    slot->owner = NULL;
    vbss_needle_set_motion(inside(needle), &inside(twin)->body.now, 0); /* it leaves */
    steps(twin, 1e-3, 3);
    steps(needle, 1e-3, 3);
    assert_true(hash_of(needle) == hash_of(twin)); /* and flies on as if it had always been free */
    assert_int_equal(get_state(needle).body, 0);
    end(&f);
}

static void initial_state_matches_config(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const double q[4] = {-2.0, 1.0, 4.0, 2.0}; /* of length 5 */
    vec3_store(f.config.position, vec3_make(0.1, -0.2, 0.3));
    memcpy(f.config.orientation, q, sizeof q);
    vec3_store(f.config.velocity, vec3_make(1.0, 2.0, 3.0));
    vec3_store(f.config.angular_velocity, vec3_make(-30.0, 20.0, 10.0));
    vbss_needle *needle = make(&f);
    const vbss_needle_state s = get_state(needle);
    expect_near_vec3(vec3_make(0.1, -0.2, 0.3), vec3_load(s.position), 1e-15);
    expect_near_vec3(vec3_make(1.0, 2.0, 3.0), vec3_load(s.velocity), 1e-14);
    expect_near_vec3(vec3_make(-30.0, 20.0, 10.0), vec3_load(s.angular_velocity), 0.0);
    for (int i = 0; i < 4; i++) {
        expect_near(q[i] / 5.0, s.orientation[i], 1e-15);
    }
    /* The centre of mass, with what turning adds. */
    pose at = pose_make(vec3_load(s.position), quat_make(-0.4, 0.2, 0.8, 0.4));
    vec3 arm = quat_rotate(at.orientation, vec3_load(weigh(needle).centre));
    vec3 turning = vec3_cross(vec3_load(s.angular_velocity), arm);
    expect_near_vec3(vec3_add(vec3_load(s.velocity), turning), inside(needle)->body.now.v, 1e-14);
    expect_near_vec3(vec3_add(at.position, arm), inside(needle)->body.now.pose.position, 1e-15);
    end(&f);
}

static void state_can_be_set_anywhere(void **state)
{
    (void)state;
    const double p[3] = {0.3, 0.2, -0.1}, q[4] = {0.0, 3.0, 0.0, 4.0}, v[3] = {-1.0, 0.5, 2.0},
                 w[3] = {5.0, 6.0, -7.0};
    fixture f;
    begin(&f);
    vec3_store(f.config.velocity, vec3_make(1.0, 2.0, 3.0));
    vec3_store(f.config.angular_velocity, vec3_make(-30.0, 20.0, 10.0));
    vbss_needle *moved = make(&f);
    steps(moved, 1e-3, 10);
    uint64_t generation = inside(moved)->generation;
    expect_ok(vbss_needle_set_state(moved, p, q, v, w));
    assert_true(inside(moved)->generation > generation);
    memcpy(f.config.position, p, sizeof p);
    memcpy(f.config.orientation, q, sizeof q);
    memcpy(f.config.velocity, v, sizeof v);
    memcpy(f.config.angular_velocity, w, sizeof w);
    assert_true(hash_of(moved) == hash_of(make(&f))); /* as if it had begun there */
    steps(moved, 1e-3, 10);
    const quat turned = inside(moved)->body.now.pose.orientation;
    expect_ok(vbss_needle_set_state(moved, p, NULL, NULL, NULL));
    assert_memory_equal(&turned, &inside(moved)->body.now.pose.orientation, sizeof turned);
    const vbss_needle_state s = get_state(moved);
    expect_near_vec3(vec3_load(p), vec3_load(s.position), 1e-15);
    assert_true(vbss_max_abs(s.velocity, 3) == 0.0);
    assert_true(vbss_max_abs(s.angular_velocity, 3) == 0.0);
    end(&f);
}

int test_needle_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_needle_shows_same_views),
        harness_test(motion_of_owner_is_taken_over),
        harness_test(initial_state_matches_config),
        harness_test(state_can_be_set_anywhere),
    };
    return cmocka_run_group_tests_name("needle.needle_state", tests, NULL, NULL);
}
