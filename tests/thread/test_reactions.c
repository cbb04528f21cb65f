/* What attachments say they do: at rest they carry the thread. */
#include <math.h>

#include "thread/rig.h"

static const double length = 0.15, density = 6.4e-5, gravity = 9.81;

static vbss_thread_config damped_config(uint32_t segments, vbss_thread_bending bending)
{
    vbss_thread_config c = rig_config(length, segments);
    c.bending = bending;
    c.drag = 20.0;
    c.spectral_radius = 0.0;
    return c;
}

static vbss_thread_bending bending_of(int i)
{
    return i % 2 == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
}

/* Of the weight, attached masses included, about a place. */
static vec3 moment_of_weight(rig *r, vec3 about)
{
    vbss_thread_momentum m = rig_momentum(r);
    vec3 weight = vec3_make(0.0, -m.mass * gravity, 0.0);
    return vec3_cross(vec3_sub(vec3_load(m.centre), about), weight);
}

static void clamp_carries_weight_and_moment(void **state)
{
    (void)state;
    const vec3 directions[] = {
        {1.0, 0.0, 0.0}, {0.6, 0.8, 0.0}, {0.0, -0.6, -0.8}, {1.0, 2.0, 2.0}};
    for (int i = 0; i < 8; i++) {
        vbss_thread_config c = damped_config(20, bending_of(i));
        vec3_store(c.direction, directions[i / 2]);
        rig r;
        rig_begin(&r, &c);
        uint32_t clamp = rig_clamp_here(&r, 0, directions[i / 2]);
        rig_mass(&r, 12, 1e-6);
        rig_relax(&r, 0.05, 1e-12, 300);
        double weight = gravity * (density * length + 1e-6);
        expect_near_vec3(vec3_make(0.0, weight, 0.0), rig_reaction_force(&r, clamp), 1e-12);
        vec3 needed = vec3_scale(moment_of_weight(&r, rig_position(&r, 0)), -1.0);
        vec3 torque = rig_reaction_torque(&r, clamp);
        assert_true(vec3_norm(needed) > 1e-7);
        expect_near_vec3(needed, torque, 1e-14);
        rig_end(&r);
    }
}

/* Clamped in the middle and at an end, pinned at the other: no single one is determined. */
static void attachment_forces_balance(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        vbss_thread_config c = damped_config(18, bending_of(i));
        rig r;
        rig_begin(&r, &c);
        uint32_t ids[] = {
            rig_pin(&r, 0, vec3_make(0.02, 0.0, 0.01)),
            rig_clamp(&r, 7, vec3_make(0.06, 0.01, 0.0), vec3_make(1.0, 0.5, 0.2)),
            rig_clamp(&r, 11, vec3_make(0.08, 0.0, 0.0), vec3_make(1.0, -1.0, 0.0)),
            rig_spring(&r, 14, vec3_make(0.1, 0.02, 0.01), 0.01, 0.0),
            rig_force(&r, 16, vec3_make(1e-5, 2e-5, -3e-5)),
            rig_pin(&r, 18, vec3_make(0.13, 0.0, -0.01)),
        };
        rig_mass(&r, 3, 2e-6);
        rig_relax(&r, 0.02, 1e-12, 600);
        vec3 force = vec3_zero(), torque = moment_of_weight(&r, vec3_zero());
        for (size_t k = 0; k < sizeof ids / sizeof ids[0]; k++) {
            vbss_thread_reaction a;
            expect_ok(vbss_thread_get_reaction(r.thread, ids[k], &a, sizeof a));
            vec3 arm = rig_position(&r, a.node);
            force = vec3_add(force, vec3_load(a.force));
            torque = vec3_add(torque, vec3_cross(arm, vec3_load(a.force)));
            torque = vec3_add(torque, vec3_load(a.torque));
        }
        double weight = gravity * (density * length + 2e-6);
        expect_near_vec3(vec3_make(0.0, weight, 0.0), force, 1e-12);
        expect_near_vec3(vec3_zero(), torque, 1e-13);
        rig_end(&r);
    }
}

static void spring_extension_is_hanging_weight(void **state)
{
    (void)state;
    const double stiffness = 0.02;
    const vec3 end = {0.01, 0.02, 0.03};
    vbss_thread_config c = damped_config(15, VBSS_THREAD_BENDING_SPLINE);
    c.drag = 8.0;
    rig r;
    rig_begin(&r, &c);
    uint32_t spring = rig_spring(&r, 0, end, stiffness, 0.0);
    double weight = density * length * gravity;
    rig_relax(&r, 0.02, 1e-9, 1500);
    expect_near_vec3(vec3_make(0.0, weight, 0.0), rig_reaction_force(&r, spring), 1e-10);
    vec3 hangs = vec3_sub(end, vec3_make(0.0, weight / stiffness, 0.0));
    expect_near_vec3(hangs, rig_position(&r, 0), 1e-7);
    /* Its other end moves, and at rest the thread has moved as far. */
    vec3 further = vec3_make(-0.02, 0.03, 0.0);
    rig_move(&r, spring, further);
    rig_relax(&r, 0.02, 1e-9, 1500);
    expect_near_vec3(vec3_sub(further, vec3_sub(end, hangs)), rig_position(&r, 0), 1e-7);
    rig_end(&r);
}

/* A spring's force at the end of each step is what its ends then say. */
static void spring_damper_follows_its_law(void **state)
{
    (void)state;
    const double stiffness = 5.0, damping = 0.01, h = 1e-3;
    vbss_thread_config c = rig_config(length, 15);
    rig r;
    rig_begin(&r, &c);
    rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    vec3 end = rig_position(&r, 10), velocity = {0.1, 0.2, -0.3};
    uint32_t spring = rig_spring(&r, 10, end, stiffness, damping);
    for (int k = 0; k < 40; k++) {
        end = vec3_add_scaled(end, h, velocity);
        rig_move(&r, spring, end);
        rig_run(&r, h, 1);
        vec3 stretch = vec3_sub(end, rig_position(&r, 10));
        vec3 slip = vec3_sub(velocity, rig_velocity(&r, 10));
        vec3 wanted = vec3_add_scaled(vec3_scale(stretch, stiffness), damping, slip);
        expect_near_vec3(wanted, rig_reaction_force(&r, spring), 1e-12);
        assert_true(vec3_norm(wanted) > 1e-4);
    }
    rig_end(&r);
}

static void forces_and_masses_report_themselves(void **state)
{
    (void)state;
    const vec3 pull = {1e-4, 2e-4, -1e-4};
    vbss_thread_config c = damped_config(12, VBSS_THREAD_BENDING_SPLINE);
    rig r;
    rig_begin(&r, &c);
    uint32_t pin = rig_pin_here(&r, 0);
    uint32_t force = rig_force(&r, 12, pull), heavy = rig_mass(&r, 6, 3e-5);
    assert_true(vec3_norm(rig_reaction_force(&r, force)) == 0.0); /* before the first step */
    rig_relax(&r, 0.02, 1e-12, 600);
    expect_near_vec3(pull, rig_reaction_force(&r, force), 0.0);
    expect_near_vec3(vec3_make(0.0, -3e-5 * gravity, 0.0), rig_reaction_force(&r, heavy), 1e-12);
    expect_near_vec3(vec3_zero(), rig_reaction_torque(&r, pin), 0.0);
    double weight = gravity * (density * length + 3e-5);
    vec3 held = vec3_sub(vec3_make(0.0, weight, 0.0), pull);
    expect_near_vec3(held, rig_reaction_force(&r, pin), 1e-11);
    rig_end(&r);
}

static void mass_in_free_fall_is_weightless(void **state)
{
    (void)state;
    vbss_thread_config c = rig_config(length, 12);
    rig r;
    rig_begin(&r, &c);
    uint32_t heavy = rig_mass(&r, 6, 3e-5);
    rig_run(&r, 1e-3, 20);
    expect_near_vec3(vec3_zero(), rig_reaction_force(&r, heavy), 1e-12);
    expect_near_vec3(vec3_make(0.0, -0.02 * gravity, 0.0), rig_velocity(&r, 12), 1e-12);
    rig_end(&r);
}

/* A force on a node that something holds goes into what holds it, not into the thread. */
static void held_node_carries_applied_load(void **state)
{
    (void)state;
    vbss_thread_config c = damped_config(12, VBSS_THREAD_BENDING_SPLINE);
    rig r;
    rig_begin(&r, &c);
    uint32_t clamp = rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    rig_relax(&r, 0.02, 1e-12, 600);
    vec3 before = rig_reaction_force(&r, clamp), tip = rig_tip(&r);
    rig_force(&r, 0, vec3_make(3.0, -2.0, 1.0));
    rig_spring(&r, 0, vec3_make(0.0, 0.1, 0.0), 10.0, 0.0);
    rig_mass(&r, 0, 0.5);
    rig_relax(&r, 0.02, 1e-12, 600);
    vec3 others = vec3_make(3.0, -2.0 + 1.0 - 0.5 * gravity, 1.0);
    expect_near_vec3(vec3_sub(before, others), rig_reaction_force(&r, clamp), 1e-9);
    expect_near_vec3(tip, rig_tip(&r), 1e-10);
    rig_end(&r);
}

static void twenty_newtons_are_held(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        vbss_thread_config c = damped_config(30, bending_of(i));
        rig r;
        rig_begin(&r, &c);
        uint32_t clamp = rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
        rig_force(&r, 30, vec3_make(20.0, 0.0, 0.0));
        rig_relax(&r, 0.01, 1e-9, 600);
        expect_near_vec3(vec3_make(-20.0, density * length * gravity, 0.0),
                         rig_reaction_force(&r, clamp), 1e-7);
        /* SPLINE takes some of the stretch of 5 % at the clamp for curvature. */
        bool spline = c.bending == VBSS_THREAD_BENDING_SPLINE;
        for (uint32_t k = 0; k < 30; k++) {
            double bound = spline && k < 4 ? 0.2 : 3e-4;
            expect_near(20.0, rig_tension(&r, k), bound);
        }
        double stretched = length * (1.0 + 20.0 / c.axial_stiffness);
        expect_near(stretched, rig_tip(&r).x, spline ? 4e-6 : 1e-8);
        rig_end(&r);
    }
}

/* Both ends clamped and drawn apart in one step; EA alone decides the force. */
static void separated_clamps_feel_stretch(void **state)
{
    (void)state;
    vbss_thread_config c = damped_config(30, VBSS_THREAD_BENDING_SPLINE);
    c.gravity[1] = 0.0;
    rig r;
    rig_begin(&r, &c);
    uint32_t near = rig_clamp_here(&r, 0, vec3_make(1.0, 0.0, 0.0));
    uint32_t far = rig_clamp_here(&r, 30, vec3_make(1.0, 0.0, 0.0));
    rig_run(&r, 1e-3, 2);
    rig_move(&r, far, vec3_make(length * (1.0 + 20.0 / c.axial_stiffness), 0.0, 0.0));
    rig_run(&r, 1e-3, 50);
    rig_relax(&r, 0.01, 1e-9, 600);
    vec3 pull = rig_reaction_force(&r, far);
    expect_near(20.0, pull.x, 0.03);
    expect_near_vec3(vec3_scale(pull, -1.0), rig_reaction_force(&r, near), 1e-8);
    rig_end(&r);
}

/* ---- when: what they say is of the last step, whatever is changed after it */

static vbss_thread_config with_variant(int variant, vbss_thread_config c)
{
    c.method = variant == 2 ? VBSS_METHOD_VBLAST : VBSS_METHOD_IMPLICIT;
    c.bending = variant == 1 ? VBSS_THREAD_BENDING_LOCAL : VBSS_THREAD_BENDING_SPLINE;
    return c;
}

static void expect_same_vector(vec3 wanted, vec3 got)
{
    expect_same_bits(wanted.x, got.x);
    expect_same_bits(wanted.y, got.y);
    expect_same_bits(wanted.z, got.z);
}

static const vec3 x_axis = {1.0, 0.0, 0.0};

static void reactions_are_of_last_step(void **state)
{
    (void)state;
    for (int variant = 0; variant < 3; variant++) {
        vbss_thread_config c = with_variant(variant, damped_config(12, VBSS_THREAD_BENDING_SPLINE));
        vec3 x[13], v[13];
        rig r;
        rig_begin(&r, &c);
        uint32_t pin = rig_pin_here(&r, 0), pull = rig_force(&r, 12, vec3_zero());
        uint32_t spring = rig_spring(&r, 6, rig_position(&r, 6), 1.0, 0.0);
        uint32_t clamp = rig_clamp_here(&r, 9, x_axis);
        expect_same_vector(vec3_zero(), rig_reaction_force(&r, pin));
        expect_same_vector(vec3_zero(), rig_reaction_torque(&r, clamp));
        rig_run(&r, 1e-3, 1000);
        const uint32_t ids[4] = {pin, pull, spring, clamp};
        vec3 force[4], torque = rig_reaction_torque(&r, clamp);
        for (int k = 0; k < 4; k++) {
            force[k] = rig_reaction_force(&r, ids[k]);
        }
        uint32_t mass = 0, load = 0;
        for (int edit = 0; edit < 7; edit++) {
            switch (edit) {
            case 0:
                mass = rig_mass(&r, 0, 0.5);
                break;
            case 1:
                load = rig_force(&r, 0, vec3_make(0.0, -3.0, 0.0));
                break;
            case 2:
                rig_move(&r, pull, vec3_make(0.0, 0.0, 1e-3));
                break;
            case 3:
                rig_move(&r, spring, rig_position(&r, 6));
                rig_move(&r, clamp, vec3_add_scaled(rig_position(&r, 9), 1e-6, x_axis));
                break;
            case 4:
                expect_ok(vbss_thread_detach(r.thread, rig_pin_here(&r, 3)));
                break;
            case 5:
                rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
                rig_read(&r, VBSS_THREAD_VIEW_VELOCITIES, v);
                rig_place(&r, NULL, v);
                break;
            default:
                x[4].z += 1e-9;
                rig_place(&r, x, v);
                break;
            }
            for (int k = 0; k < 4; k++) {
                expect_same_vector(force[k], rig_reaction_force(&r, ids[k]));
            }
            expect_same_vector(torque, rig_reaction_torque(&r, clamp));
        }
        /* What has made no step has done nothing. */
        expect_same_vector(vec3_zero(), rig_reaction_force(&r, mass));
        expect_same_vector(vec3_zero(), rig_reaction_force(&r, load));
        rig_run(&r, 1e-3, 1);
        expect_near(3.0 + 0.5 * gravity, rig_reaction_force(&r, pin).y, 1e-3);
        expect_near_vec3(vec3_make(0.0, -3.0, 0.0), rig_reaction_force(&r, load), 1e-12);
        expect_near_vec3(vec3_make(0.0, 0.0, 1e-3), rig_reaction_force(&r, pull), 1e-15);
        rig_end(&r);
    }
}

int test_reactions(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reactions_are_of_last_step),
        cmocka_unit_test(clamp_carries_weight_and_moment),
        cmocka_unit_test(attachment_forces_balance),
        cmocka_unit_test(spring_extension_is_hanging_weight),
        cmocka_unit_test(spring_damper_follows_its_law),
        cmocka_unit_test(forces_and_masses_report_themselves),
        cmocka_unit_test(mass_in_free_fall_is_weightless),
        cmocka_unit_test(held_node_carries_applied_load),
        cmocka_unit_test(twenty_newtons_are_held),
        cmocka_unit_test(separated_clamps_feel_stretch),
    };
    return cmocka_run_group_tests_name("thread.reactions", tests, NULL, NULL);
}
