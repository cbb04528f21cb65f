/* Newton: what acts on a drain that rests adds up to nothing. */
#include "scene/drains_rig.h"

static vec3 sum_of_anchors(vbss_drain *drain)
{
    vbss_view anchors;
    vec3 sum = vec3_zero();
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_ANCHOR_FORCES, &anchors, sizeof anchors));
    for (uint64_t i = 0; i < anchors.count; i++) {
        sum = vec3_add(sum, ((const vec3 *)anchors.data)[i]);
    }
    return sum;
}

static double weight_of(vbss_drain *drain)
{
    const drain_object *d = drains_rig_object(drain);
    double weight = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        weight += 9.81 * d->mass[i];
    }
    return weight;
}

/* A tool that stays in the wall is held by what the anchors hold, once all is at rest. */
static void anchors_carry_tool_pressure(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    small_begin_scene(&s);
    small_drain(&s, &drain);
    uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.3e-3, 8.4e-3, 4e-3),
                                vec3_zero(), 1.25e-3);
    for (int i = 0; i < 400; i++) {
        small_move(&s, tool, vec3_make(0.3e-3, 8.4e-3 - vbss_min(4e-5 * i, 3e-3), 4e-3));
        small_steps(&s, 1, 1e-3);
    }
    vec3 felt = vec3_load(small_rigid(&s, tool).contact_force);
    assert_true(felt.y > 0.02);
    expect_near(0.0, vec3_distance(sum_of_anchors(drain), felt), 0.01 * vec3_norm(felt));
    small_end(&s);
}

static void floor_carries_fallen_drain(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    vec3 sum = vec3_zero();
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -7.2e-3;
    s.drain.tear_stress = 1.0; /* it comes off its block at once */
    s.drain.gravity[1] = -9.81;
    small_create(&s);
    small_drain(&s, &drain);
    small_steps(&s, 600, 1e-3);
    vbss_view contacts = small_view(&s, VBSS_SCENE_VIEW_CONTACTS);
    for (uint64_t i = 0; i < contacts.count; i++) {
        sum = vec3_add(sum, small_vector(&s, VBSS_SCENE_VIEW_CONTACT_FORCES, i));
    }
    double weight = weight_of(drain);
    assert_true(vec3_norm(sum_of_anchors(drain)) == 0.0);
    expect_near(0.0, vec3_distance(sum, vec3_make(0.0, weight, 0.0)), 0.01 * weight);
    small_end(&s);
}

int test_drain_balance(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(anchors_carry_tool_pressure),
        cmocka_unit_test(floor_carries_fallen_drain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
