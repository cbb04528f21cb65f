/* What acts on single nodes: how it comes, moves and goes. */
#include "fixture.h"

/* ---- ids and places */

static void ids_increase_and_are_never_reused(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.attachment_capacity = 3;
    vbss_thread *thread = make(&f);
    for (uint32_t id = 1; id <= 50; id++) {
        assert_int_equal(hold(thread, (vbss_thread_attachment_kind)(id % 5), id % 13, vec3_zero()),
                         id);
        if (id >= 2) {
            vbss_thread_reaction r;
            expect_ok(vbss_thread_detach(thread, id - 1));
            expect_result(VBSS_ERROR_NOT_FOUND, vbss_thread_detach(thread, id - 1));
            expect_result(VBSS_ERROR_NOT_FOUND,
                          vbss_thread_get_reaction(thread, id - 1, &r, sizeof r));
        }
    }
    end(&f);
}

static void full_thread_rejects_attachment(void **state)
{
    (void)state;
    const uint32_t capacities[] = {0, 1, 3, 256};
    for (int k = 0; k < 4; k++) {
        fixture f;
        uint32_t id = 77;
        begin(&f);
        f.config.attachment_capacity = capacities[k];
        vbss_thread *thread = make(&f);
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_SPRING, 4);
        for (uint32_t i = 0; i < capacities[k]; i++) {
            attach(thread, &a);
        }
        uint64_t hash = hash_of(thread);
        expect_result(VBSS_ERROR_CAPACITY, vbss_thread_attach(thread, &a, &id));
        assert_int_equal(id, 77);
        assert_true(hash_of(thread) == hash);
        steps(thread, 2, 1e-3);
        if (capacities[k] > 0) {
            expect_ok(vbss_thread_detach(thread, capacities[k]));
            assert_int_equal(attach(thread, &a), capacities[k] + 1);
        }
        end(&f);
    }
}

static void node_takes_one_hold_and_many_loads(void **state)
{
    (void)state;
    const vbss_thread_attachment_kind kinds[] = {VBSS_THREAD_ATTACHMENT_PIN,
                                                 VBSS_THREAD_ATTACHMENT_CLAMP};
    for (int first = 0; first < 2; first++) {
        for (int second = 0; second < 2; second++) {
            fixture f;
            uint32_t id = 77;
            begin(&f);
            vbss_thread *thread = make(&f);
            uint32_t held = hold(thread, kinds[first], 6, vec3_zero());
            vbss_thread_attachment a = plain(kinds[second], 6);
            expect_result(VBSS_ERROR_IN_USE, vbss_thread_attach(thread, &a, &id));
            assert_int_equal(id, 77);
            for (int i = 0; i < 6; i++) {
                hold(thread, VBSS_THREAD_ATTACHMENT_FORCE + i % 3, 6, vec3_zero());
            }
            steps(thread, 2, 1e-3);
            expect_ok(vbss_thread_detach(thread, held));
            attach(thread, &a); /* free again */
            steps(thread, 2, 1e-3);
            end(&f);
        }
    }
}

/* ---- where they take the thread */

static void held_node_reaches_target_after_step(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_thread *thread = make(&f);
    vec3 to = vec3_make(0.001, 0.002, -0.003);
    uint32_t pin = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, to);
    expect_near_vec3(vec3_zero(), place_of(thread, 0), 0.0); /* nothing moves outside a step */
    for (int i = 1; i <= 20; i++) {
        expect_ok(vbss_thread_step(thread, i % 3 == 0 ? 1e-3 : 3e-4));
        expect_near_vec3(to, place_of(thread, 0), 0.0);
        to = vec3_add(to, vec3_make(1e-3, i % 2 == 0 ? 1e-3 : -1e-3, 0.0));
        move(thread, pin, vec3_zero()); /* the last word counts */
        move(thread, pin, to);
    }
    /* Placed elsewhere, it is taken back. */
    double x[39] = {0.0};
    for (int i = 0; i < 13; i++) {
        x[3 * (size_t)i] = 0.1 + i * 0.15 / 12;
    }
    expect_ok(vbss_thread_set_state(thread, x, NULL, 13));
    expect_near_vec3(vec3_make(0.1, 0.0, 0.0), place_of(thread, 0), 0.0);
    expect_ok(vbss_thread_step(thread, 1e-3));
    expect_near_vec3(to, place_of(thread, 0), 0.0);
    end(&f);
}

/* A hand at constant speed gives its node that speed: let go, the node flies on with it. */
static void held_node_has_holder_velocity(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.gravity[1] = 0.0;
    vbss_thread *thread = make(&f);
    uint32_t pin = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    for (int i = 1; i <= 20; i++) {
        move(thread, pin, vec3_make(0.0, 1e-3 * (i < 10 ? i : 10), 0.0));
        expect_ok(vbss_thread_step(thread, 1e-3));
        double speed = i <= 10 ? 1.0 : 0.0;
        expect_near(speed, vector_at(thread, VBSS_THREAD_VIEW_VELOCITIES, 0).y, 1e-9);
    }
    end(&f);
}

/* Step sizes that differ leave no speed in a hand that rests. */
static void node_released_from_resting_hand_stays(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.gravity[1] = 0.0;
    f.config.segment_count = 1;
    vbss_thread *thread = make(&f);
    uint32_t pin = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    steps(thread, 2, 1e-6);
    move(thread, pin, vec3_make(0.0, 1e-6, 0.0));
    steps(thread, 1, 1e-6);
    steps(thread, 4, 1e-2);
    expect_ok(vbss_thread_detach(thread, pin));
    vec3 before = place_of(thread, 0);
    steps(thread, 1, 1e-3);
    expect_near_vec3(before, place_of(thread, 0), 1e-3);
    end(&f);
}

/* ---- what they do */

/* At rest all that acts adds up to the weight, in force and in moment. */
static void expect_balance(fixture *f, vbss_thread *thread, const uint32_t *ids, size_t count)
{
    vbss_thread_momentum m = momentum_of(thread);
    vec3 g = vec3_load(f->config.gravity);
    double mass = f->config.linear_density * f->config.length;
    vec3 force = vec3_scale(g, m.mass), torque = vec3_cross(vec3_load(m.centre), force);
    for (size_t i = 0; i < count; i++) {
        vbss_thread_reaction r = reaction_of(thread, ids[i]);
        vec3 one = vec3_load(r.force);
        force = vec3_add(force, one);
        torque = vec3_add(torque, vec3_cross(place_of(thread, r.node), one));
        torque = vec3_add(torque, vec3_load(r.torque));
    }
    double scale = mass * 9.81;
    expect_near_vec3(vec3_zero(), force, 1e-6 * scale);
    expect_near_vec3(vec3_zero(), torque, 1e-6 * scale * f->config.length);
}

static void reactions_balance_weight(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        fixture f;
        begin(&f);
        f.config.bending = bending;
        f.config.drag = 18.0;
        f.config.damping = 200.0;
        vbss_thread *thread = make(&f);
        vbss_thread_reaction r;
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, 0);
        a.direction[1] = 0.7;
        a.direction[2] = 0.4;
        uint32_t ids[3] = {attach(thread, &a), 0, 0};
        a = plain(VBSS_THREAD_ATTACHMENT_SPRING, 8);
        a.position[0] = 0.05;
        a.position[1] = 0.01;
        a.stiffness = 0.1;
        a.damping = 1e-3;
        ids[1] = attach(thread, &a);
        a = plain(VBSS_THREAD_ATTACHMENT_FORCE, 12);
        a.force[2] = 2e-5;
        ids[2] = attach(thread, &a);
        r = reaction_of(thread, ids[0]);
        expect_near_vec3(vec3_zero(), vec3_load(r.force), 0.0);
        steps(thread, 8000, 1e-3);
        expect_balance(&f, thread, ids, 3);
        end(&f);
    }
}

static void attached_mass_has_weight_and_inertia(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.drag = 18.0;
    f.config.damping = 200.0;
    vbss_thread *thread = make(&f);
    uint32_t pin = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_MASS, 12);
    a.mass = 5e-3;
    uint32_t mass = attach(thread, &a);
    expect_near(0.15 * 6.4e-5 + 5e-3, momentum_of(thread).mass, 1e-17);
    steps(thread, 8000, 1e-3);
    double weight = 5e-3 * 9.81, own = 0.15 * 6.4e-5 * 9.81;
    expect_near(-weight, reaction_of(thread, mass).force[1], 1e-6 * weight);
    expect_near(weight + own, reaction_of(thread, pin).force[1], 1e-6 * weight);
    end(&f);
}

/* Momentum is force times time: the force, and its change at once. */
static void force_changes_momentum_at_its_rate(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.gravity[1] = 0.0;
    vbss_thread *thread = make(&f);
    uint32_t pull = hold(thread, VBSS_THREAD_ATTACHMENT_FORCE, 5, vec3_zero());
    vec3 force = vec3_zero(), sum = vec3_zero();
    for (int i = 0; i < 40; i++) {
        double h = i % 4 == 0 ? 2e-3 : 1e-3;
        vec3 last = force;
        force = vec3_scale(vec3_make(1e-5, -2e-5, 3e-5), 1.0 + i % 3);
        move(thread, pull, force);
        expect_near_vec3(last, vec3_load(reaction_of(thread, pull).force), 1e-12 * vec3_norm(last));
        expect_ok(vbss_thread_step(thread, h));
        expect_near_vec3(force, vec3_load(reaction_of(thread, pull).force),
                         1e-12 * vec3_norm(force));
        sum = vec3_add_scaled(sum, h, force);
    }
    expect_near_vec3(sum, vec3_load(momentum_of(thread).linear), 3e-3 * vec3_norm(sum));
    expect_ok(vbss_thread_detach(thread, pull));
    vec3 kept = vec3_load(momentum_of(thread).linear);
    steps(thread, 20, 1e-3);
    expect_near_vec3(kept, vec3_load(momentum_of(thread).linear), 1e-9 * vec3_norm(kept));
    end(&f);
}

/* ---- everywhere and in any order */

static void attach_detach_order_does_not_matter(void **state)
{
    (void)state;
    vbss_random random;
    vbss_random_seed(&random, 7, 7);
    for (int round = 0; round < 30; round++) {
        fixture f;
        begin(&f);
        f.config.segment_count = 1 + vbss_random_below(&random, 9);
        f.config.attachment_capacity = 12;
        vbss_thread *thread = make(&f);
        uint32_t ids[12], count = 0;
        for (int i = 0; i < 40; i++) {
            vbss_thread_attachment a =
                plain((vbss_thread_attachment_kind)vbss_random_below(&random, 5),
                      vbss_random_below(&random, nodes_of(thread)));
            vec3 x = place_of(thread, a.node), direction = vbss_random_direction(&random);
            vec3_store(a.position, vec3_add_scaled(x, 1e-3, direction));
            vec3_store(a.direction, vbss_random_direction(&random));
            vec3_store(a.force, vec3_scale(direction, 1e-5));
            a.stiffness = 10.0 * vbss_random_uniform(&random);
            a.damping = 1e-3 * vbss_random_uniform(&random);
            a.mass = 1e-5 * vbss_random_uniform(&random);
            uint32_t id;
            if (count < 12 && vbss_thread_attach(thread, &a, &id) == VBSS_OK) {
                ids[count++] = id;
            } else if (count > 0) {
                uint32_t gone = vbss_random_below(&random, count);
                expect_ok(vbss_thread_detach(thread, ids[gone]));
                ids[gone] = ids[--count];
            }
            expect_ok(vbss_thread_step(thread, 1e-3));
            assert_true(all_finite(thread));
        }
        end(&f);
    }
}

int test_attachments(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ids_increase_and_are_never_reused),
        cmocka_unit_test(full_thread_rejects_attachment),
        cmocka_unit_test(node_takes_one_hold_and_many_loads),
        cmocka_unit_test(held_node_reaches_target_after_step),
        cmocka_unit_test(held_node_has_holder_velocity),
        cmocka_unit_test(node_released_from_resting_hand_stays),
        cmocka_unit_test(reactions_balance_weight),
        cmocka_unit_test(attached_mass_has_weight_and_inertia),
        cmocka_unit_test(force_changes_momentum_at_its_rate),
        cmocka_unit_test(attach_detach_order_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
