/* What a needle may be asked for and when: handles, callbacks, scenes; and where it is put. */
#include "base/check.h"
#include "fixture.h"

/* ---- structs that go out */

enum { OUTS = 4 };

static vbss_result write_out(vbss_needle *needle, int which, void *out, uint32_t size)
{
    switch (which) {
    case 0:
        return vbss_needle_get_state(needle, out, size);
    case 1:
        return vbss_needle_get_mass(needle, out, size);
    case 2:
        return vbss_needle_get_energies(needle, out, size);
    default:
        return vbss_needle_get_view(needle, VBSS_NEEDLE_VIEW_POINTS, out, size);
    }
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[OUTS] = {208, 144, 32, sizeof(vbss_view)};
    fixture f;
    begin(&f);
    vbss_needle *needle = make(&f);
    for (int which = 0; which < OUTS; which++) {
        unsigned char out[320];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, write_out(needle, which, NULL, sizes[which]));
        for (uint32_t size = 0; size < sizes[which]; size++) {
            expect_result(VBSS_ERROR_STRUCT_SIZE, write_out(needle, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(needle, which, out, 256));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = 0; i < sizeof out; i++) {
            assert_true(i < sizes[which] || out[i] == (i < 256 ? 0 : 0xff));
        }
    }
    end(&f);
}

/* ---- handles */

static const double zero[3] = {0.0, 0.0, 0.0};

static vbss_result call_step(void *n)
{
    return vbss_needle_step(n, 1e-3);
}
static vbss_result call_set_state(void *n)
{
    return vbss_needle_set_state(n, zero, NULL, NULL, NULL);
}
static vbss_result call_restore(void *n)
{
    uint8_t bytes[64] = {0};
    return vbss_needle_restore(n, bytes, sizeof bytes);
}
static vbss_result call_destroy(void *n)
{
    /* NULL is nothing to destroy */
    return n == NULL ? VBSS_ERROR_INVALID_HANDLE : vbss_needle_destroy(n);
}
static vbss_result call_place(void *n)
{
    double position[3];
    return vbss_needle_get_place(n, 0.0, position, NULL);
}
static vbss_result call_save(void *n)
{
    uint64_t written;
    vbss_result result = vbss_needle_save(n, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *n)
{
    uint64_t hash;
    return vbss_needle_get_hash(n, &hash);
}
static vbss_result call_out(void *n, int which)
{
    unsigned char out[256];
    return write_out(n, which, out, sizeof out);
}
static vbss_result call_state(void *n)
{
    return call_out(n, 0);
}
static vbss_result call_mass(void *n)
{
    return call_out(n, 1);
}
static vbss_result call_energies(void *n)
{
    return call_out(n, 2);
}
static vbss_result call_view(void *n)
{
    return call_out(n, 3);
}

/* Those that change something come first. */
enum { EDITS = 4, CALLS = 11 };
static const harness_handle_call calls[CALLS] = {
    call_step, call_set_state, call_restore, call_destroy,  call_place, call_save,
    call_hash, call_state,     call_mass,    call_energies, call_view};

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_needle *destroyed = make(&f), *none = destroyed;
    expect_ok(vbss_needle_destroy(destroyed));
    expect_ok(vbss_needle_destroy(NULL));
    harness_refuses_bad_handles(f.context, destroyed, calls, CALLS);
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_needle_create((vbss_context *)destroyed, &f.config, &none));
    assert_null(none);
    end(&f);
}

typedef struct listener {
    vbss_context *context;
    vbss_needle *needle;
    vbss_result results[CALLS], created;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_needle *made = NULL;
    (void)level;
    (void)message;
    l->heard++;
    for (int i = 0; i < CALLS; i++) {
        l->results[i] = calls[i](l->needle);
    }
    l->created = vbss_needle_create(l->context, NULL, &made);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &l.context));
    expect_ok(vbss_needle_create(l.context, NULL, &l.needle));
    uint64_t hash = hash_of(l.needle);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_needle_step(l.needle, 1.0));
    assert_int_equal(l.heard, 1);
    for (int i = 0; i < CALLS; i++) {
        expect_result(i < EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    assert_true(hash_of(l.needle) == hash);
    harness_context_end(l.context, &memory);
}

/* ---- what a scene does with it */

static void in_scene_host_may_only_read(void **state)
{
    (void)state;
    fixture f;
    vbss_slot *slot;
    begin(&f);
    vec3_store(f.config.velocity, vec3_make(1.0, 2.0, 3.0));
    vec3_store(f.config.angular_velocity, vec3_make(10.0, -20.0, 30.0));
    vbss_needle *needle = make(&f), *twin = make(&f);
    uint64_t hash = hash_of(needle);
    expect_ok(vbss_slot_open(needle, &vbss_needle_kind, &slot));
    slot->owner = &f;
    for (int i = 0; i < CALLS; i++) {
        expect_result(i < EDITS ? VBSS_ERROR_IN_SCENE : VBSS_OK, calls[i](needle));
    }
    assert_true(hash_of(needle) == hash);
    steps(twin, 1e-3, 3);
    uint64_t generation = inside(needle)->generation;
    vbss_needle_set_motion(inside(needle), &inside(twin)->body.now, 5);
    assert_true(inside(needle)->generation > generation);
    assert_memory_equal(&inside(twin)->body, &inside(needle)->body, sizeof(vbss_rigid));
    vbss_needle_state seen = look(needle);
    assert_int_equal(seen.body, 5);
    seen.body = 0;
    const vbss_needle_state wanted = look(twin);
    assert_memory_equal(&wanted, &seen, sizeof seen);
    slot->owner = NULL;
    vbss_needle_set_motion(inside(needle), &inside(twin)->body.now, 0); /* it leaves */
    steps(twin, 1e-3, 3);
    steps(needle, 1e-3, 3);
    assert_true(hash_of(needle) == hash_of(twin)); /* and flies on as if it had always been free */
    assert_int_equal(look(needle).body, 0);
    end(&f);
}

/* ---- where it is put */

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
    const vbss_needle_state s = look(needle);
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
    const vbss_needle_state s = look(moved);
    expect_near_vec3(vec3_load(p), vec3_load(s.position), 1e-15);
    assert_true(vbss_max_abs(s.velocity, 3) == 0.0);
    assert_true(vbss_max_abs(s.angular_velocity, 3) == 0.0);
    end(&f);
}

int test_needle_life(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(output_struct_size_protocol),
        harness_test(every_call_rejects_invalid_handles),
        harness_test(calls_inside_callback_are_rejected),
        harness_test(in_scene_host_may_only_read),
        harness_test(initial_state_matches_config),
        harness_test(state_can_be_set_anywhere),
    };
    return cmocka_run_group_tests_name("needle.needle_life", tests, NULL, NULL);
}
