/* What a grasper shows after a restore, and whose its snapshot is; other snapshots: contract.grasper. */
#include "base/error.h"
#include "base/rotation.h"
#include "fixture.h"

/* New commands, and what a scene would write. */
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
    const vbss_grasper_state a = get_state(first), b = get_state(second);
    assert_memory_equal(&a, &b, sizeof a);
    assert_memory_equal(inside(first)->view_capsules, inside(second)->view_capsules,
                        sizeof inside(first)->view_capsules);
    end(&f);
}

/* A snapshot names the body that the grasper is in a scene. */
static void snapshot_of_other_body_is_rejected(void **state)
{
    (void)state;
    const vbss_kind *kind = &vbss_grasper_kind_of_slot;
    fixture f;
    uint8_t bytes[4096];
    uint64_t written;
    begin(&f);
    vbss_grasper *grasper = make(&f), *elsewhere = make(&f);
    const uint64_t hash = hash_of(grasper);
    inside(elsewhere)->body_id = 3;
    expect_ok(vbss_object_save(elsewhere, kind, bytes, sizeof bytes, &written));
    assert_true(vbss_object_restore(grasper, kind, bytes, written) < 0);
    assert_true(hash_of(grasper) == hash);
    end(&f);
}

int test_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_grasper_shows_same_views),
        harness_test(snapshot_of_other_body_is_rejected),
    };
    return cmocka_run_group_tests_name("grasper.state", tests, NULL, NULL);
}
