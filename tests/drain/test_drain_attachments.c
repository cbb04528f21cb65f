/* What acts on single nodes: how it comes, moves and goes, and what it does. */
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"

/* ---- ids and places */

static void ids_increase_and_are_never_reused(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    r.config.attachment_capacity = 3;
    drain_rig_make(&r);
    for (uint32_t id = 1; id <= 50; id++) {
        uint32_t node = id % 5; /* of the first row, on top */
        uint32_t given = id % 3 == 0   ? drain_rig_pin_here(&r, node)
                         : id % 3 == 1 ? drain_rig_force(&r, node, vec3_zero())
                                       : drain_rig_spring(&r, node, vec3_zero(), 0.0);
        assert_int_equal(given, id);
        if (id >= 2) {
            double force[3];
            drain_rig_detach(&r, id - 1);
            expect_result(VBSS_ERROR_NOT_FOUND, vbss_drain_detach(r.drain, id - 1));
            expect_result(VBSS_ERROR_NOT_FOUND, vbss_drain_get_reaction(r.drain, id - 1, force));
        }
    }
    drain_rig_end(&r);
}

static void full_drain_rejects_attachment(void **state)
{
    (void)state;
    const uint32_t capacities[] = {0, 1, 3, 256};
    for (int k = 0; k < 4; k++) {
        drain_rig r;
        vbss_drain_attachment a;
        uint32_t id = 77;
        drain_rig_begin(&r);
        r.config.attachment_capacity = capacities[k];
        drain_rig_make(&r);
        for (uint32_t i = 0; i < capacities[k]; i++) {
            drain_rig_force(&r, i % 5, vec3_zero());
        }
        uint64_t hash = drain_rig_hash(&r);
        expect_ok(vbss_drain_attachment_init(&a, sizeof a));
        expect_result(VBSS_ERROR_CAPACITY, vbss_drain_attach(r.drain, &a, &id));
        assert_int_equal(id, 77);
        assert_true(drain_rig_hash(&r) == hash);
        drain_rig_run(&r, 1e-3, 2);
        if (capacities[k] > 0) {
            drain_rig_detach(&r, capacities[k]);
            assert_int_equal(drain_rig_force(&r, 0, vec3_zero()), capacities[k] + 1);
        }
        drain_rig_end(&r);
    }
}

static void node_takes_one_pin_and_many_loads(void **state)
{
    (void)state;
    drain_rig r;
    vbss_drain_attachment a;
    uint32_t id = 77;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    uint32_t node = r.places.marks[0], pin = drain_rig_pin_here(&r, node);
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = node;
    expect_result(VBSS_ERROR_IN_USE, vbss_drain_attach(r.drain, &a, &id));
    assert_int_equal(id, 77);
    vec3 kept = drain_rig_position(&r, node), pull = vec3_make(0.0, 0.01, 0.02);
    for (int i = 0; i < 3; i++) {
        drain_rig_force(&r, node, pull);
        drain_rig_spring(&r, node, vec3_add(kept, vec3_make(1e-3, 0.0, 0.0)), 10.0);
    }
    drain_rig_run(&r, 1e-3, 5);
    /* The pin bears all that pulls beside it, and nothing else moves. */
    expect_near_vec3(kept, drain_rig_position(&r, node), 0.0);
    expect_near_vec3(vec3_make(-0.03, -0.03, -0.06), drain_rig_reaction(&r, pin), 1e-12);
    expect_near(0.0, drain_rig_fastest(&r), 1e-12);
    drain_rig_detach(&r, pin);
    drain_rig_run(&r, 1e-3, 2);
    assert_true(vec3_distance(kept, drain_rig_position(&r, node)) > 1e-6);
    a.kind = VBSS_DRAIN_ATTACHMENT_PIN;
    expect_ok(vbss_drain_attach(r.drain, &a, &id)); /* free again */
    drain_rig_end(&r);
}

/* ---- where they take the drain */

static void pinned_node_reaches_target_after_step(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    r.config.move_limit = 5e-5; /* some steps are made in parts */
    drain_rig_make(&r);
    uint32_t node = r.places.marks[1];
    vec3 from = drain_rig_position(&r, node);
    vec3 to = vec3_add(from, vec3_make(1e-5, -2e-4, 3e-4));
    uint32_t pin = drain_rig_pin(&r, node, to);
    expect_near_vec3(from, drain_rig_position(&r, node), 0.0); /* nothing moves outside a step */
    for (int i = 1; i <= 40; i++) {
        double h = i % 3 == 0 ? 1e-3 : 3e-4;
        vec3 displacement = vec3_sub(to, drain_rig_position(&r, node));
        expect_ok(vbss_drain_step(r.drain, h));
        expect_near_vec3(to, drain_rig_position(&r, node), 0.0);
        /* Evenly: all parts of a step have the same speed. */
        expect_near_vec3(vec3_scale(displacement, 1.0 / h),
                         drain_rig_vectors(&r, VBSS_DRAIN_VIEW_VELOCITIES)[node], 1e-9);
        to = vec3_add(to, vec3_make(1e-4 * (i % 7 - 3), i % 2 == 0 ? 3e-4 : -3e-4, -1e-4));
        drain_rig_move(&r, pin, vec3_zero()); /* the last word counts */
        drain_rig_move(&r, pin, to);
    }
    assert_true(drain_rig_statistics(&r).parts > drain_rig_statistics(&r).steps);
    drain_rig_end(&r);
}

static void moved_node_returns_to_pin(void **state)
{
    (void)state;
    drain_rig r;
    static vec3 x[DRAIN_RIG_NODES];
    drain_rig_begin(&r);
    drain_rig_make(&r);
    uint32_t node = r.places.marks[0];
    vec3 kept = drain_rig_position(&r, node);
    drain_rig_pin_here(&r, node);
    drain_rig_copy(&r, x);
    x[node].y += 4e-4;
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, r.places.node_count));
    expect_near_vec3(x[node], drain_rig_position(&r, node), 0.0);
    drain_rig_run(&r, 1e-3, 1);
    expect_near_vec3(kept, drain_rig_position(&r, node), 1e-18);
    drain_rig_end(&r);
}

/* ---- what they do */

/* In rest all that acts adds up to nothing, in force and in moment. */
static void expect_balance(drain_rig *r, const uint32_t *ids, const uint32_t *nodes, size_t count,
                           double scale)
{
    double masses[DRAIN_RIG_NODES];
    vec3 force = vec3_zero(), torque = vec3_zero(), g = vec3_load(r->config.gravity);
    drain_rig_masses(r, masses);
    const vec3 *x = drain_rig_vectors(r, VBSS_DRAIN_VIEW_POSITIONS);
    for (uint32_t i = 0; i < r->places.node_count; i++) {
        force = vec3_add_scaled(force, masses[i], g);
        torque = vec3_add_scaled(torque, masses[i], vec3_cross(x[i], g));
    }
    const vec3 *held = drain_rig_vectors(r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
    const uint32_t *anchors = drain_rig_numbers(r, VBSS_DRAIN_VIEW_ANCHORS);
    for (uint32_t i = 0; i < drain_rig_count(r, VBSS_DRAIN_VIEW_ANCHORS); i++) {
        force = vec3_add(force, held[i]);
        torque = vec3_add(torque, vec3_cross(x[anchors[i]], held[i]));
    }
    for (size_t i = 0; i < count; i++) {
        vec3 one = drain_rig_reaction(r, ids[i]);
        force = vec3_add(force, one);
        torque = vec3_add(torque, vec3_cross(x[nodes[i]], one));
    }
    expect_near_vec3(vec3_zero(), force, 1e-9 * scale);
    expect_near_vec3(vec3_zero(), torque, 1e-9 * scale * r->config.radius);
}

static void reactions_and_anchors_balance_loads(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_statics(&r);
    r.config.gravity[1] = -9.81;
    drain_rig_make(&r);
    const uint32_t *marks = r.places.marks, *gap = r.places.gap_points;
    vec3 end = vec3_add(drain_rig_position(&r, gap[0]), vec3_make(1e-3, 2e-3, 0.0));
    vec3 to = vec3_add(drain_rig_position(&r, marks[0]), vec3_make(0.0, 1e-3, 1e-3));
    const uint32_t ids[] = {drain_rig_pin(&r, marks[0], to),
                            drain_rig_spring(&r, gap[0], end, 30.0),
                            drain_rig_force(&r, gap[1], vec3_make(3e-3, -5e-3, 0.02))};
    const uint32_t nodes[] = {marks[0], gap[0], gap[1]};
    expect_near_vec3(vec3_zero(), drain_rig_reaction(&r, ids[0]), 0.0); /* before its first step */
    drain_rig_relax(&r, 1e-13, 500);
    expect_near_vec3(vec3_make(3e-3, -5e-3, 0.02), drain_rig_reaction(&r, ids[2]), 0.0);
    vec3 displacement = vec3_sub(end, drain_rig_position(&r, gap[0]));
    expect_near_vec3(vec3_scale(displacement, 30.0), drain_rig_reaction(&r, ids[1]), 1e-15);
    expect_near(0.5 * 30.0 * vec3_norm_squared(displacement), drain_rig_energies(&r).springs,
                1e-15);
    double pulls = vec3_norm(drain_rig_reaction(&r, ids[0]));
    assert_true(pulls > 0.02);
    expect_balance(&r, ids, nodes, 3, pulls);
    drain_rig_end(&r);
}

static vec3 momentum_of(drain_rig *r, const double *masses)
{
    const vec3 *v = drain_rig_vectors(r, VBSS_DRAIN_VIEW_VELOCITIES);
    vec3 sum = vec3_zero();
    for (uint32_t i = 0; i < r->places.node_count; i++) {
        sum = vec3_add_scaled(sum, masses[i], v[i]);
    }
    return sum;
}

/* In motion it adds up to the change of momentum: backward Euler's balance at the end of the step. */
static void reactions_and_anchors_change_momentum(void **state)
{
    (void)state;
    drain_rig r;
    double masses[DRAIN_RIG_NODES];
    drain_rig_begin(&r);
    drain_rig_statics(&r);
    r.config.gravity[2] = 3.0;
    drain_rig_make(&r);
    drain_rig_masses(&r, masses);
    vec3 at = drain_rig_position(&r, r.places.marks[0]);
    uint32_t pin = drain_rig_pin(&r, r.places.marks[0], at);
    uint32_t pull = drain_rig_force(&r, r.places.marks[0], vec3_make(0.0, 0.01, 0.0));
    uint32_t spring = drain_rig_spring(&r, r.places.marks[1], vec3_zero(), 10.0);
    double mass = 0.0;
    for (uint32_t i = 0; i < r.places.node_count; i++) {
        mass += masses[i];
    }
    for (int step = 1; step <= 30; step++) {
        double h = step % 2 == 0 ? 1e-3 : 2e-3;
        vec3 before = momentum_of(&r, masses);
        at = vec3_add(at, vec3_make(1e-5, 4e-5, 8e-5));
        drain_rig_move(&r, pin, at);
        drain_rig_run(&r, h, 1);
        vec3 after = momentum_of(&r, masses);
        vec3 forces = vec3_add(drain_rig_anchor_sum(&r), drain_rig_reaction(&r, pin));
        forces = vec3_add(forces, drain_rig_reaction(&r, pull));
        forces = vec3_add(forces, drain_rig_reaction(&r, spring));
        forces = vec3_add_scaled(forces, mass, vec3_load(r.config.gravity));
        forces = vec3_add_scaled(forces, -r.config.drag, after);
        expect_near_vec3(vec3_scale(vec3_sub(after, before), 1.0 / h), forces, 1e-8);
    }
    drain_rig_end(&r);
}

/* ---- everywhere and in any order */

static void attach_detach_order_does_not_matter(void **state)
{
    (void)state;
    vbss_random random;
    drain_rig r;
    uint32_t ids[12], count = 0;
    vbss_random_seed(&random, 7, 7);
    drain_rig_begin(&r);
    r.config.attachment_capacity = 12;
    drain_rig_make(&r);
    for (int i = 0; i < 400; i++) {
        vbss_drain_attachment a;
        uint32_t id;
        expect_ok(vbss_drain_attachment_init(&a, sizeof a));
        a.kind = (vbss_drain_attachment_kind)vbss_random_below(&random, 3);
        a.node = vbss_random_below(&random, r.places.node_count);
        vec3 direction = vbss_random_direction(&random);
        vec3_store(a.position, vec3_add_scaled(drain_rig_position(&r, a.node), 1e-3, direction));
        vec3_store(a.force, vec3_scale(direction, 1e-2));
        a.stiffness = 10.0 * vbss_random_uniform(&random);
        if (count < 12 && vbss_drain_attach(r.drain, &a, &id) == VBSS_OK) {
            ids[count++] = id;
        } else if (count > 0) {
            uint32_t gone = vbss_random_below(&random, count);
            drain_rig_detach(&r, ids[gone]);
            ids[gone] = ids[--count];
        }
        drain_rig_run(&r, 1e-3, 1);
        assert_true(isfinite(drain_rig_energies(&r).total));
    }
    drain_rig_end(&r);
}

int test_drain_attachments(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ids_increase_and_are_never_reused),
        cmocka_unit_test(full_drain_rejects_attachment),
        cmocka_unit_test(node_takes_one_pin_and_many_loads),
        cmocka_unit_test(pinned_node_reaches_target_after_step),
        cmocka_unit_test(moved_node_returns_to_pin),
        cmocka_unit_test(reactions_and_anchors_balance_loads),
        cmocka_unit_test(reactions_and_anchors_change_momentum),
        cmocka_unit_test(attach_detach_order_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
