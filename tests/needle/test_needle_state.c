/* A needle is saved with all that its flight hangs on, and restored to the same bits. */
#include "fixture.h"

/* ---- a life: thrown, with gravity and drag */

static void throw_it(vbss_needle_config *config)
{
    expect_ok(vbss_needle_config_init(config, sizeof *config));
    config->drag = 0.5;
    vec3_store(config->gravity, vec3_make(0.3, -0.2, -9.81));
    vec3_store(config->position, vec3_make(0.1, 0.2, 0.3));
    vec3_store(config->velocity, vec3_make(0.5, -1.0, 2.0));
    vec3_store(config->angular_velocity, vec3_make(40.0, -20.0, 3.0));
}

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    vbss_needle_config config;
    (void)user;
    throw_it(&config);
    return vbss_needle_create(context, &config, (vbss_needle **)handle);
}

static vbss_result edit(void *handle)
{
    const double p[3] = {0.3, 0.2, -0.1}, q[4] = {0.0, 3.0, 0.0, 4.0}, v[3] = {-1.0, 0.5, 2.0},
                 w[3] = {5.0, 60.0, -7.0};
    return vbss_needle_set_state(handle, p, q, v, w);
}

static vbss_result step(void *handle)
{
    return vbss_needle_step(handle, 1e-3);
}

static vbss_result destroy(void *handle)
{
    return vbss_needle_destroy(handle);
}

static harness_body body(void)
{
    harness_body b = {.name = "a needle",
                      .kind = &vbss_needle_kind,
                      .create = create,
                      .edit = edit,
                      .step = step,
                      .destroy = destroy};
    return b;
}

static void restored_needle_continues_bit_equal(void **state)
{
    (void)state;
    const harness_body b = body();
    for (size_t before = 0; before < 8; before++) {
        harness_save_restore_continue(&b, before, 50);
    }
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    const harness_body b = body();
    harness_refuses_bad_snapshots(&b, 0);
    harness_refuses_bad_snapshots(&b, 5);
}

static void step_does_not_allocate(void **state)
{
    (void)state;
    const harness_body b = body();
    assert_int_equal(harness_step_allocations(&b, 100), 0);
}

/* Alone, beside others, and elsewhere in memory. */
static void flights_are_bit_equal(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    throw_it(&f.config);
    vbss_needle *first = make(&f);
    uint64_t hashes[100];
    for (int i = 0; i < 100; i++) {
        steps(first, 1e-3, 10);
        hashes[i] = hash_of(first);
        assert_true(i == 0 || hashes[i] != hashes[i - 1]);
    }
    vbss_needle *between = make(&f), *second = make(&f);
    for (int i = 0; i < 100; i++) {
        steps(between, 3e-3, 1);
        steps(second, 1e-3, 10);
        assert_true(hash_of(second) == hashes[i]);
    }
    end(&f);
}

/* ---- what is shown comes back too */

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
    const vbss_needle_state a = look(first), b = look(second);
    assert_memory_equal(&a, &b, sizeof a);
    assert_memory_equal(&inside(first)->body, &inside(second)->body, sizeof(vbss_rigid));
    end(&f);
}

/* ---- nonsense, and what belongs to others */

static void impossible_state_is_rejected(void **state)
{
    (void)state;
    fixture f;
    uint8_t bytes[1024];
    uint64_t written;
    begin(&f);
    for (int i = 0; i < 4; i++) {
        vbss_needle *good = make(&f), *bad = make(&f);
        vbss_rigid_motion *now = &inside(bad)->body.now;
        double *spoiled[] = {&now->pose.orientation.w, &now->pose.position.y, &now->v.x, &now->w.z};
        *spoiled[i] = i == 0 ? 0.5 : (double)INFINITY;
        uint64_t hash = hash_of(good);
        expect_ok(vbss_needle_save(bad, bytes, sizeof bytes, &written));
        expect_result(VBSS_ERROR_CORRUPT, vbss_needle_restore(good, bytes, written));
        assert_true(hash_of(good) == hash);
    }
    end(&f);
}

static void expect_foreign(const fixture *f)
{
    uint8_t bytes[1024];
    uint64_t written;
    vbss_needle *plain;
    expect_ok(vbss_needle_create(f->context, NULL, &plain));
    uint64_t hash = hash_of(plain);
    expect_ok(vbss_needle_save(make(f), bytes, sizeof bytes, &written));
    expect_result(VBSS_ERROR_CORRUPT, vbss_needle_restore(plain, bytes, written));
    assert_true(hash_of(plain) == hash);
    expect_ok(vbss_needle_destroy(plain));
}

static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const vbss_needle_config plain = f.config;
    /* every number up to where it begins, each a little larger than its default */
    size_t first = offsetof(vbss_needle_config, radius);
    for (size_t at = first; at < offsetof(vbss_needle_config, position); at += sizeof(double)) {
        double value;
        memcpy(&value, (const char *)&plain + at, sizeof value);
        value = value == 0.0 ? 1e-3 : value * (1.0 + DBL_EPSILON);
        memcpy((char *)&f.config + at, &value, sizeof value);
        expect_foreign(&f);
        f.config = plain;
    }
    f.config.method = VBSS_METHOD_PAPER;
    expect_foreign(&f);
    f.config = plain;
    f.config.segment_count = 9;
    expect_foreign(&f);
    end(&f);
}

int test_needle_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_needle_continues_bit_equal),
        harness_test(bad_snapshots_are_rejected),
        harness_test(step_does_not_allocate),
        harness_test(flights_are_bit_equal),
        harness_test(restored_needle_shows_same_views),
        harness_test(impossible_state_is_rejected),
        harness_test(snapshot_of_other_config_is_rejected),
    };
    return cmocka_run_group_tests_name("needle.needle_state", tests, NULL, NULL);
}
