/* Changes of a running scene: friction, gravity, couplings, limits, filters, forces and poses. */
#include <stdlib.h>

#include "fixtures/solver_of.h"
#include "scene/small.h"

#include <vblast_ss/scene_query.h>
#include <vblast_ss/scene_settings.h>

#define STEP 1e-3
#define RADIUS 2e-3

static const vec3 half = {3e-3, 0.0, 0.0};

static vec3 velocity_of(const small *s, uint32_t body)
{
    return vec3_load(small_rigid(s, body).velocity);
}

static vbss_scene_body_info info_of(const small *s, uint32_t body)
{
    vbss_scene_body_info info;
    expect_ok(vbss_scene_get_body(s->scene, body, &info, sizeof info));
    return info;
}

/* A stick that rests on the floor under gravity. */
static uint32_t begin_on_floor(small *s)
{
    small_begin(s);
    s->config.floor = 1;
    small_create(s);
    s->rigid.gravity[1] = -9.81;
    const uint32_t body =
        small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, RADIUS, 0.0), half, RADIUS);
    small_steps(s, 20, STEP);
    return body;
}

/* ---- gravity */

static void gravity_changed_at_rest_is_acceleration(void **state)
{
    (void)state;
    small s;
    const double up[3] = {0.5, 2.0, -0.25};
    const uint32_t body = begin_on_floor(&s);
    expect_near(0.0, vec3_norm(velocity_of(&s, body)), 1e-6);
    expect_ok(vbss_scene_set_gravity(s.scene, 0, up));
    small_steps(&s, 10, STEP);
    expect_near(0.0, vec3_distance(vec3_scale(vec3_load(up), 10.0 * STEP), velocity_of(&s, body)),
                1e-5);
    expect_near(2.0, info_of(&s, body).gravity[1], 0.0);
    small_end(&s);
}

static void gravity_of_all_moves_threads_and_leaves_tools(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    const double g[3] = {0.0, -4.0, 0.0};
    small_begin_scene(&s);
    const uint32_t number =
        small_thread(&s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.02, 0.1, 0.0), 10, &thread);
    const uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), half, RADIUS);
    expect_ok(vbss_scene_set_gravity(s.scene, 0, g));
    small_steps(&s, 100, STEP);
    expect_near(0.1 - 0.5 * 4.0 * 0.01, small_node(thread, 5).y, 1e-3);
    expect_near(0.0, vec3_norm(small_position(&s, tool)), 1e-15);
    expect_near(-4.0, info_of(&s, number).gravity[1], 0.0);
    expect_ok(vbss_scene_set_gravity(s.scene, tool, g));
    small_steps(&s, 300, STEP); /* the spring of the coupling carries the tool */
    expect_near(-s.rigid.mass * 4.0 / s.rigid.stiffness, small_position(&s, tool).y, 1e-9);
    small_end(&s);
}

/* ---- friction */

static void friction_changed_lets_body_slide_that_rested(void **state)
{
    (void)state;
    small s;
    const double tilted[3] = {1.9, -9.81, 0.0}; /* less than the friction of 0.3 bears */
    const uint32_t body = begin_on_floor(&s);
    expect_ok(vbss_scene_set_friction(s.scene, body, 0.3));
    expect_ok(vbss_scene_set_gravity(s.scene, 0, tilted));
    small_steps(&s, 50, STEP);
    expect_near(0.0, velocity_of(&s, body).x, 1e-4);
    expect_ok(vbss_scene_set_friction(s.scene, body, 0.0));
    small_steps(&s, 100, STEP);
    expect_near(1.9 * 0.1, velocity_of(&s, body).x, 2e-3);
    expect_near(0.0, info_of(&s, body).friction, 0.0);
    small_end(&s);
}

/* ---- tools */

static void coupling_changed_is_stiffness_of_tool(void **state)
{
    (void)state;
    small s;
    const double g[3] = {0.0, -10.0, 0.0};
    small_begin_scene(&s);
    const uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), half, RADIUS);
    expect_ok(vbss_scene_set_gravity(s.scene, tool, g));
    expect_ok(vbss_scene_set_coupling(s.scene, tool, 500.0, 10.0, 1.0, 0.01));
    small_steps(&s, 500, STEP);
    expect_near(-s.rigid.mass * 10.0 / 500.0, small_position(&s, tool).y, 1e-9);
    small_end(&s);
}

static void speed_limit_changed_bounds_driven_body(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    const uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, RADIUS);
    expect_ok(vbss_scene_set_speed_limit(s.scene, 0.5));
    small_move(&s, tool, vec3_make(0.0, 0.0, 0.01));
    small_steps(&s, 10, STEP);
    expect_near(0.5 * 10.0 * STEP, small_position(&s, tool).z, 1e-12);
    small_end(&s);
}

/* ---- forces and motion */

static void force_acts_for_one_step_and_calls_add_up(void **state)
{
    (void)state;
    small s;
    const double f[3] = {0.2, 0.0, 0.0};
    small_begin_scene(&s);
    const uint32_t body = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), half, RADIUS);
    expect_ok(vbss_scene_apply_force(s.scene, body, f, NULL, NULL));
    expect_ok(vbss_scene_apply_force(s.scene, body, f, NULL, NULL));
    small_steps(&s, 1, STEP);
    expect_near(2.0 * 0.2 / s.rigid.mass * STEP, velocity_of(&s, body).x, 1e-15);
    small_steps(&s, 5, STEP);
    expect_near(2.0 * 0.2 / s.rigid.mass * STEP, velocity_of(&s, body).x, 1e-15);
    small_end(&s);
}

static void force_beside_centre_turns_body_as_torque_does(void **state)
{
    (void)state;
    small s;
    const double f[3] = {0.0, 0.1, 0.0}, point[3] = {3e-3, 0.0, 0.0}, none[3] = {0.0, 0.0, 0.0},
                 torque[3] = {0.0, 0.0, 3e-4};
    small_begin_scene(&s);
    const uint32_t a = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), half, RADIUS);
    const uint32_t b =
        small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.1, 0.0), half, RADIUS);
    expect_ok(vbss_scene_apply_force(s.scene, a, f, point, NULL));
    expect_ok(vbss_scene_apply_force(s.scene, b, none, NULL, torque));
    small_steps(&s, 1, STEP);
    const double spin = small_rigid(&s, a).angular_velocity[2];
    assert_true(spin > 0.1);
    expect_near(spin, small_rigid(&s, b).angular_velocity[2], 1e-9 * spin);
    small_end(&s);
}

static void pose_and_velocity_are_those_that_were_set(void **state)
{
    (void)state;
    small s;
    const double p[3] = {0.01, 0.02, -0.03}, q[4] = {0.6, 0.0, 0.8, 0.0}, v[3] = {1.0, -2.0, 0.5},
                 w[3] = {3.0, 1.0, -2.0};
    small_begin_scene(&s);
    const uint32_t body =
        small_capsule(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), vec3_make(6e-3, 0.0, 0.0), RADIUS);
    expect_ok(vbss_scene_set_rigid_pose(s.scene, body, p, q));
    expect_ok(vbss_scene_set_rigid_velocity(s.scene, body, v, w));
    const vbss_scene_rigid_state now = small_rigid(&s, body);
    for (int k = 0; k < 3; k++) {
        expect_near(p[k], now.position[k], 1e-15);
        expect_near(v[k], now.velocity[k], 1e-14);
        expect_near(w[k], now.angular_velocity[k], 0.0);
    }
    for (int k = 0; k < 4; k++) {
        expect_near(q[k], now.orientation[k], 1e-15);
    }
    small_steps(&s, 1, STEP); /* the centre of mass goes on from there */
    expect_near(p[1] + v[1] * STEP, small_position(&s, body).y, 1e-4);
    small_end(&s);
}

/* ---- filters */

/* A ball falls on two fixed rods, one below the other; it passes the first alone. */
static void filtered_bodies_pass_through_each_other_and_nothing_else(void **state)
{
    (void)state;
    small s;
    const double g[3] = {0.0, -9.81, 0.0};
    const vec3 along_z = {0.0, 0.0, 0.02};
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -0.05;
    small_create(&s);
    const uint32_t upper = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -0.01, 0.0),
                                       vec3_make(0.02, 0.0, 0.0), RADIUS);
    const uint32_t lower =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -0.03, 0.0), along_z, RADIUS);
    const uint32_t ball = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), half, RADIUS);
    expect_ok(vbss_scene_set_gravity(s.scene, 0, g));
    expect_ok(vbss_scene_set_filter(s.scene, upper, 2u, UINT32_MAX));
    expect_ok(vbss_scene_set_filter(s.scene, ball, 1u, ~2u));
    bool has_touched_lower = false;
    for (int i = 0; i < 120; i++) {
        small_steps(&s, 1, STEP);
        const vbss_view view = small_view(&s, VBSS_SCENE_VIEW_CONTACTS);
        const uint32_t(*contacts)[5] = (const uint32_t(*)[5])view.data;
        for (uint64_t k = 0; k < view.count; k++) {
            assert_true(contacts[k][1] != upper && contacts[k][3] != upper);
            has_touched_lower =
                has_touched_lower || contacts[k][1] == lower || contacts[k][3] == lower;
        }
    }
    assert_true(has_touched_lower);
    assert_int_equal(small_statistics(&s).clamped, 0);
    assert_true(small_position(&s, ball).y > -0.05);
    small_end(&s);
}

static void body_filtered_from_floor_falls_through_it(void **state)
{
    (void)state;
    small s;
    const uint32_t body = begin_on_floor(&s);
    expect_ok(vbss_scene_set_filter(s.scene, 0, 1u, ~1u));
    small_steps(&s, 100, STEP);
    expect_near(RADIUS - 0.5 * 9.81 * 0.01, small_position(&s, body).y, 1e-3);
    assert_int_equal(small_statistics(&s).clamped, 0);
    small_end(&s);
}

/* ---- state */

typedef struct changed {
    uint32_t body, tool, thread;
} changed;

static changed begin_changed(small *s)
{
    changed c;
    small_begin(s);
    s->config.floor = 1;
    small_create(s);
    s->thread.gravity[1] = -9.81;
    c.body = small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.02, 0.0), half, RADIUS);
    c.tool = small_stick(s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.1, 0.02, 0.0), half, RADIUS);
    c.thread = small_thread(s, vec3_make(-0.02, 0.03, 0.0), vec3_make(0.02, 0.03, 0.0), 20, NULL);
    return c;
}

static void change(small *s, const changed *c, int which)
{
    const double g[3] = {1.0, -3.0, 0.5}, f[3] = {0.01, 0.02, 0.03}, p[3] = {0.0, 0.05, 0.0},
                 v[3] = {0.1, 0.2, 0.3};
    switch (which) {
    case 0:
        expect_ok(vbss_scene_set_gravity(s->scene, 0, g));
        break;
    case 1:
        expect_ok(vbss_scene_set_friction(s->scene, c->body, 0.7));
        break;
    case 2:
        expect_ok(vbss_scene_set_friction(s->scene, 0, 0.9));
        break;
    case 3:
        expect_ok(vbss_scene_set_thread_friction(s->scene, 0.01));
        break;
    case 4:
        expect_ok(vbss_scene_set_coupling(s->scene, c->tool, 100.0, 1.0, 0.1, 1e-3));
        break;
    case 5:
        expect_ok(vbss_scene_set_speed_limit(s->scene, 3.0));
        break;
    case 6:
        expect_ok(vbss_scene_set_filter(s->scene, c->thread, 4u, ~1u));
        break;
    case 7:
        expect_ok(vbss_scene_apply_force(s->scene, c->body, f, p, f));
        break;
    case 8:
        expect_ok(vbss_scene_set_rigid_velocity(s->scene, c->body, v, v));
        break;
    case 9:
        expect_ok(vbss_scene_set_budgets(s->scene, 400.0, 300.0, 250.0));
        break;
    default:
        expect_ok(vbss_scene_set_rigid_pose(s->scene, c->body, p, NULL));
        break;
    }
}
enum { CHANGES = 11 };

static void each_change_is_in_hash_and_restored_scene_goes_on_with_same_bits(void **state)
{
    (void)state;
    for (int which = 0; which < CHANGES; which++) {
        small s, other;
        const changed c = begin_changed(&s);
        (void)begin_changed(&other);
        small_steps(&s, 20, STEP);
        const uint64_t before = small_hash(&s);
        change(&s, &c, which);
        assert_true(small_hash(&s) != before);
        const small_state saved = small_save(&s);
        const uint64_t changed_hash = small_hash(&s);
        small_steps(&s, 60, STEP);
        expect_ok(vbss_scene_restore(other.scene, saved.bytes, saved.count));
        assert_true(small_hash(&other) == changed_hash);
        small_steps(&other, 60, STEP);
        assert_true(small_hash(&s) == small_hash(&other));
        free(saved.bytes);
        small_end(&other);
        small_end(&s);
    }
}

static void snapshot_from_before_takes_changes_back(void **state)
{
    (void)state;
    small s;
    const changed c = begin_changed(&s);
    small_steps(&s, 20, STEP);
    const small_state saved = small_save(&s);
    const uint64_t before = small_hash(&s);
    for (int which = 0; which < CHANGES; which++) {
        change(&s, &c, which);
    }
    expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
    assert_true(small_hash(&s) == before);
    const vbss_scene_body_info info = info_of(&s, c.thread);
    assert_true(info.category == 1u && info.mask == UINT32_MAX);
    free(saved.bytes);
    small_end(&s);
}

static void body_that_leaves_has_its_configured_gravity_again(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    const double g[3] = {0.0, 0.0, 0.0};
    small_begin_scene(&s);
    s.thread.gravity[1] = -2.0;
    const uint32_t body = small_thread(&s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 10, &thread);
    expect_ok(vbss_scene_set_gravity(s.scene, body, g));
    expect_ok(vbss_scene_remove(s.scene, body));
    for (int i = 0; i < 10; i++) {
        expect_ok(vbss_thread_step(thread, STEP));
    }
    assert_true(small_node(thread, 5).y < -5e-5);
    small_end(&s);
}

/* ---- suspended steps */

/* A scene whose step is suspended, because a call has room for little work. */
static changed begin_suspended(small *s)
{
    changed c;
    small_begin(s);
    s->config.floor = 1;
    set_call_operations(&s->config, 3000);
    small_create(s);
    s->thread.gravity[1] = -9.81;
    c.body = small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.02, 0.1), half, RADIUS);
    c.tool = small_stick(s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 0.02, 0.0), half, RADIUS);
    c.thread = small_thread(s, vec3_make(-0.02, 3e-4, 0.0), vec3_make(0.02, 3e-4, 0.0), 40, NULL);
    for (int i = 0; i < 300 && !small_object(s)->cursor.is_suspended; i++) {
        small_steps(s, 1, STEP);
    }
    assert_true(small_object(s)->cursor.is_suspended);
    return c;
}

static void change_ends_suspended_step_and_force_does_not(void **state)
{
    (void)state;
    for (int which = 0; which < CHANGES; which++) {
        const bool is_force = which == 7;
        small s;
        const changed c = begin_suspended(&s);
        change(&s, &c, which);
        assert_true(small_object(&s)->cursor.is_suspended == is_force);
        small_steps(&s, 3, STEP);
        assert_true(!is_force || vec3_norm(velocity_of(&s, c.body)) > 1e-5);
        small_end(&s);
    }
}

static void refused_change_leaves_step_suspended(void **state)
{
    (void)state;
    small s;
    const changed c = begin_suspended(&s);
    const uint64_t before = small_hash(&s);
    assert_int_equal(vbss_scene_set_friction(s.scene, c.thread, 0.1), VBSS_ERROR_INCOMPATIBLE);
    assert_int_equal(vbss_scene_set_coupling(s.scene, c.body, 1.0, 1.0, 1.0, 1.0),
                     VBSS_ERROR_INCOMPATIBLE);
    assert_true(small_object(&s)->cursor.is_suspended);
    assert_true(small_hash(&s) == before);
    small_end(&s);
}

/* ---- refusals */

static void refused_changes_change_nothing_and_say_why(void **state)
{
    (void)state;
    small s;
    const double g[3] = {0.0, -1.0, 0.0}, big[3] = {2e6, 0.0, 0.0},
                 bad[3] = {harness_bad_numbers[0], 0.0, 0.0}, inside[3] = {0.1, 0.02, 0.0};
    changed c;
    small_begin(&s);
    s.config.overlap = VBSS_SCENE_OVERLAP_REFUSE;
    small_create(&s);
    c.body = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.02, 0.0), half, RADIUS);
    c.tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.1, 0.02, 0.0), half, RADIUS);
    c.thread = small_thread(&s, vec3_make(-0.02, 0.03, 0.0), vec3_make(0.02, 0.03, 0.0), 20, NULL);
    const uint32_t driven =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.2, 0.02, 0.0), half, RADIUS);
    const uint64_t before = small_hash(&s);
    const vbss_result numbers[] = {
        vbss_scene_set_gravity(s.scene, c.body, big),
        vbss_scene_set_friction(s.scene, c.body, -0.1),
        vbss_scene_set_thread_friction(s.scene, 11.0),
        vbss_scene_set_coupling(s.scene, c.tool, -1.0, 1.0, 1.0, 1.0),
        vbss_scene_set_speed_limit(s.scene, -1.0),
        vbss_scene_set_budgets(s.scene, -1.0, 420.0, 500.0),
        vbss_scene_set_budgets(s.scene, 500.0, 2e7, 500.0),
        vbss_scene_set_budgets(s.scene, 500.0, 420.0, 0.0),
        vbss_scene_set_budgets(s.scene, 500.0, 1e-4, 500.0),
        vbss_scene_set_rigid_pose(s.scene, c.body, inside, NULL),
    };
    const vbss_result kinds[] = {
        vbss_scene_set_friction(s.scene, c.thread, 0.1),
        vbss_scene_set_coupling(s.scene, c.body, 1.0, 1.0, 1.0, 1.0),
        vbss_scene_apply_force(s.scene, driven, g, NULL, NULL),
        vbss_scene_apply_force(s.scene, c.thread, g, NULL, NULL),
        vbss_scene_set_rigid_velocity(s.scene, c.tool, g, NULL),
        vbss_scene_set_rigid_pose(s.scene, c.tool, g, NULL),
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        assert_int_equal(numbers[i], VBSS_ERROR_OUT_OF_RANGE);
    }
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        assert_int_equal(kinds[i], VBSS_ERROR_INCOMPATIBLE);
    }
    assert_int_equal(vbss_scene_set_gravity(s.scene, 77, g), VBSS_ERROR_NOT_FOUND);
    assert_int_equal(vbss_scene_set_filter(s.scene, 77, 1u, 1u), VBSS_ERROR_NOT_FOUND);
    assert_int_equal(vbss_scene_set_gravity(s.scene, 0, bad), VBSS_ERROR_NOT_FINITE);
    assert_int_equal(vbss_scene_set_budgets(s.scene, bad[0], 420.0, 500.0), VBSS_ERROR_NOT_FINITE);
    assert_int_equal(vbss_scene_set_gravity(s.scene, 0, NULL), VBSS_ERROR_NULL_ARGUMENT);
    assert_int_equal(vbss_scene_apply_force(s.scene, c.body, bad, NULL, NULL),
                     VBSS_ERROR_NOT_FINITE);
    assert_true(small_hash(&s) == before);
    const uint32_t pin = small_pin(&s, c.thread, 0, c.body);
    assert_int_equal(vbss_scene_set_rigid_pose(s.scene, c.body, g, NULL), VBSS_ERROR_IN_USE);
    const char *text = NULL;
    vbss_result result;
    expect_ok(vbss_context_get_last_error(s.context, &result, &text));
    assert_non_null(strstr(text, "a pin holds body"));
    expect_ok(vbss_scene_unpin_thread(s.scene, pin));
    small_end(&s);
}

int test_settings(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gravity_changed_at_rest_is_acceleration),
        cmocka_unit_test(gravity_of_all_moves_threads_and_leaves_tools),
        cmocka_unit_test(friction_changed_lets_body_slide_that_rested),
        cmocka_unit_test(coupling_changed_is_stiffness_of_tool),
        cmocka_unit_test(speed_limit_changed_bounds_driven_body),
        cmocka_unit_test(force_acts_for_one_step_and_calls_add_up),
        cmocka_unit_test(force_beside_centre_turns_body_as_torque_does),
        cmocka_unit_test(pose_and_velocity_are_those_that_were_set),
        cmocka_unit_test(filtered_bodies_pass_through_each_other_and_nothing_else),
        cmocka_unit_test(body_filtered_from_floor_falls_through_it),
        cmocka_unit_test(each_change_is_in_hash_and_restored_scene_goes_on_with_same_bits),
        cmocka_unit_test(snapshot_from_before_takes_changes_back),
        cmocka_unit_test(body_that_leaves_has_its_configured_gravity_again),
        cmocka_unit_test(change_ends_suspended_step_and_force_does_not),
        cmocka_unit_test(refused_change_leaves_step_suspended),
        cmocka_unit_test(refused_changes_change_nothing_and_say_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
