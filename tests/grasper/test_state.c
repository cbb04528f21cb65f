/* A grasper is saved with all that it was told and shows, and restored to the same bits. */
#include "base/error.h"
#include "base/rotation.h"
#include "fixture.h"

/* ---- a life: told new things every step, shown what a scene would find */

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    vbss_grasper_config config;
    (void)user;
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.has_trocar = 1;
    config.trocar[1] = 0.2;
    config.driver_bend = 0.3;
    return vbss_grasper_create(context, &config, (vbss_grasper **)handle);
}

/* What is next follows from what is, as it does in a scene. */
static vbss_result step(void *handle)
{
    grasper_object *g;
    VBSS_TRY(vbss_grasper_open(handle, &g));
    vec3 p = g->commanded_pose.position;
    quat turn = vbss_quat_from_rotation_vector(vec3_make(0.1, 0.0, 0.2));
    VBSS_TRY(move_to(handle, vec3_make(0.01 + 0.9 * p.x, 0.5 * p.y, 0.1 - p.z),
                     quat_mul(turn, g->commanded_pose.orientation)));
    VBSS_TRY(vbss_grasper_set_opening(handle, 1.0 - 0.7 * g->opening));
    VBSS_TRY(vbss_grasper_exchange(handle, 3 - g->commanded_kind));
    g->jaw_angle = vbss_grasper_next_angle(g, 1e-2, 0.0);
    g->jaw_force = vbss_grasper_jaw_force_at(g, g->jaw_angle);
    g->kind = g->jaw_force > 0.0 ? g->kind : g->commanded_kind;
    g->velocity = vec3_sub(g->tool_pose.position, vec3_scale(g->velocity, 0.5));
    g->angular_velocity = vec3_add(g->velocity, vec3_scale(g->angular_velocity, 0.5));
    g->hand_force = vec3_cross(g->velocity, g->angular_velocity);
    g->hand_torque = vec3_add(g->hand_force, vec3_scale(g->hand_torque, 0.5));
    vbss_grasper_update_view(g);
    return VBSS_OK;
}

static vbss_result destroy(void *handle)
{
    return vbss_grasper_destroy(handle);
}

static harness_body body(void)
{
    harness_body b = {.name = "a grasper",
                      .kind = &vbss_grasper_kind_of_slot,
                      .create = create,
                      .step = step,
                      .destroy = destroy};
    return b;
}

static void restored_grasper_continues_bit_equal(void **state)
{
    (void)state;
    const harness_body b = body();
    for (size_t before = 1; before < 12; before++) {
        harness_save_restore_continue(&b, before, 20);
    }
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    const harness_body b = body();
    harness_refuses_bad_snapshots(&b, 4);
    harness_refuses_bad_snapshots(&b, 5);
}

static void commands_do_not_allocate(void **state)
{
    (void)state;
    const harness_body b = body();
    assert_int_equal(harness_step_allocations(&b, 100), 0);
}

/* ---- what is shown comes back too */

static void restored_grasper_shows_same_views(void **state)
{
    (void)state;
    fixture f;
    uint8_t bytes[4096];
    uint64_t written;
    begin(&f);
    f.config.shears_bend = -0.2;
    vbss_grasper *first = make(&f), *second = make(&f);
    for (int i = 0; i < 7; i++) {
        expect_ok(step(first));
    }
    expect_ok(vbss_object_save(first, &vbss_grasper_kind_of_slot, bytes, sizeof bytes, &written));
    uint64_t generation = inside(second)->generation;
    expect_ok(vbss_object_restore(second, &vbss_grasper_kind_of_slot, bytes, written));
    assert_true(inside(second)->generation > generation);
    const vbss_grasper_state a = look(first), b = look(second);
    assert_memory_equal(&a, &b, sizeof a);
    assert_memory_equal(inside(first)->view_capsules, inside(second)->view_capsules,
                        sizeof inside(first)->view_capsules);
    end(&f);
}

/* ---- nonsense */

typedef void (*spoiler)(grasper_object *g);
static void no_kind(grasper_object *g)
{
    g->kind = 0;
}
static void no_kind_told(grasper_object *g)
{
    g->commanded_kind = 3;
}
static void told_too_far(grasper_object *g)
{
    g->commanded_pose.position.z = -1e3 * (1.0 + 1e-12);
}
static void told_no_turn(grasper_object *g)
{
    g->commanded_pose.orientation.w = 0.5;
}
static void is_no_turn(grasper_object *g)
{
    g->tool_pose.orientation.x = 1e-2;
}
static void handle_too_open(grasper_object *g)
{
    g->opening = 1.1;
}
static void handle_too_closed(grasper_object *g)
{
    g->opening = -1e-9;
}
static void jaws_through_each_other(grasper_object *g)
{
    g->jaw_angle = -1e-9;
}
static void jaws_turned_back(grasper_object *g)
{
    g->jaw_angle = 2.0;
}
static void pulling_jaws(grasper_object *g)
{
    g->jaw_force = -1.0;
}
static void too_strong_jaws(grasper_object *g)
{
    g->jaw_force = 8.5;
}
static void holds_outside_scenes(grasper_object *g)
{
    g->grasp_count = 1;
}
static void not_finite(grasper_object *g)
{
    g->hand_torque.y = (double)INFINITY;
}

static void impossible_state_is_rejected(void **state)
{
    (void)state;
    static const spoiler spoilers[] = {
        no_kind,      no_kind_told,         told_too_far,      told_no_turn,
        is_no_turn,   handle_too_open,      handle_too_closed, jaws_through_each_other,
        pulling_jaws, holds_outside_scenes, jaws_turned_back,  too_strong_jaws,
        not_finite,
    };
    const vbss_kind *kind = &vbss_grasper_kind_of_slot;
    fixture f;
    uint8_t bytes[4096];
    uint64_t written;
    begin(&f);
    for (size_t i = 0; i < sizeof spoilers / sizeof spoilers[0]; i++) {
        vbss_grasper *good = make(&f), *bad = make(&f);
        uint64_t hash = hash_of(good);
        spoilers[i](inside(bad));
        expect_ok(vbss_object_save(bad, kind, bytes, sizeof bytes, &written));
        expect_result(VBSS_ERROR_CORRUPT, vbss_object_restore(good, kind, bytes, written));
        assert_true(hash_of(good) == hash);
    }
    end(&f);
}

/* ---- another grasper's */

static void expect_foreign(fixture *f, vbss_grasper *other)
{
    const vbss_kind *kind = &vbss_grasper_kind_of_slot;
    uint8_t bytes[4096];
    uint64_t written;
    vbss_grasper_config plain;
    expect_ok(vbss_grasper_config_init(&plain, sizeof plain));
    vbss_grasper *grasper;
    expect_ok(vbss_grasper_create(f->context, &plain, &grasper));
    uint64_t hash = hash_of(grasper);
    expect_ok(vbss_object_save(other, kind, bytes, sizeof bytes, &written));
    assert_true(vbss_object_restore(grasper, kind, bytes, written) < 0);
    assert_true(hash_of(grasper) == hash);
    expect_ok(vbss_grasper_destroy(grasper));
}

static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const vbss_grasper_config plain = f.config;
    /* every number of the configuration, each a little larger than its default */
    size_t first = offsetof(vbss_grasper_config, trocar);
    for (size_t at = first; at < sizeof plain; at += sizeof(double)) {
        double value;
        memcpy(&value, (const char *)&plain + at, sizeof value);
        value = value == 0.0 ? 1e-3 : value * (1.0 + DBL_EPSILON);
        memcpy((char *)&f.config + at, &value, sizeof value);
        expect_foreign(&f, make(&f));
        f.config = plain;
    }
    f.config.method = VBSS_METHOD_PAPER;
    expect_foreign(&f, make(&f));
    f.config = plain;
    f.config.kind = VBSS_GRASPER_SHEARS;
    expect_foreign(&f, make(&f));
    f.config = plain;
    f.config.has_trocar = 1;
    expect_foreign(&f, make(&f));
    f.config = plain;
    vbss_grasper *elsewhere = make(&f);
    inside(elsewhere)->body_id = 3;
    expect_foreign(&f, elsewhere);
    end(&f);
}

int test_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_grasper_continues_bit_equal),
        harness_test(bad_snapshots_are_rejected),
        harness_test(commands_do_not_allocate),
        harness_test(restored_grasper_shows_same_views),
        harness_test(impossible_state_is_rejected),
        harness_test(snapshot_of_other_config_is_rejected),
    };
    return cmocka_run_group_tests_name("grasper.state", tests, NULL, NULL);
}
