#include <math.h>
#include <string.h>

#include "base/rotation.h"
#include "solver/rigid_rig.h"

/* ---- the equations */

static void draw_body(harness_source *source, vbss_rigid *body)
{
    memset(body, 0, sizeof *body);
    rigid_draw_mass(source, body);
    body->gravity = harness_draw_vec3(source, -10.0, 10.0);
    body->drag = harness_draw_below(source, 2) * harness_draw_real(source, 0.0, 100.0);
    if (harness_draw_below(source, 3) != 0) {
        body->coupling.stiffness = pow(10.0, harness_draw_real(source, -2.0, 6.0));
        body->coupling.damping = pow(10.0, harness_draw_real(source, -4.0, 3.0));
        body->coupling.turning_stiffness = pow(10.0, harness_draw_real(source, -6.0, 3.0));
        body->coupling.turning_damping = pow(10.0, harness_draw_real(source, -6.0, 1.0));
    }
    body->now.pose = rigid_draw_pose(source, 0.1);
    body->now.v = harness_draw_vec3(source, -1.0, 1.0);
    body->now.w = harness_draw_vec3(source, -10.0, 10.0);
    body->target_start = rigid_draw_pose(source, 0.1);
    body->target_end = rigid_draw_pose(source, 0.1);
    assert_true(vbss_rigid_is_valid(body));
}

enum { BODIES = 3 };

typedef struct bodies {
    vbss_rigid body[BODIES];
    vbss_rigid_blocks blocks[BODIES];
    vbss_rigid_motion predicted[BODIES];
    pose trial[BODIES];
    harness_memory memory;
    vbss_context *context;
    vbss_system *system;
} bodies;

static bodies all;

static void begin_bodies(const vbss_role roles[BODIES])
{
    all.context = harness_context(&all.memory);
    expect_ok(vbss_system_create(all.context, 2 * BODIES, 1, 2 * BODIES, BODIES, &all.system));
    vbss_system_begin_pattern(all.system);
    for (int i = 0; i < BODIES; i++) {
        expect_ok(vbss_rigid_register(all.system, roles[i], &all.blocks[i]));
        assert_int_equal(all.blocks[i].first, 2 * i);
        assert_int_equal(all.blocks[i].coupling == VBSS_NO_COUPLING,
                         roles[i] == VBSS_ROLE_PRESCRIBED);
    }
    expect_ok(vbss_system_analyse(all.system));
}

static void end_bodies(void)
{
    vbss_system_destroy(all.context, all.system);
    harness_context_end(all.context, &all.memory);
}

/* A step of those from the first on, with two linearisations. */
static void step_bodies(int first, int count)
{
    const vbss_rigid_substep part = {1e-3, 0.0, 1.0};
    vbss_system *s = all.system;
    for (int i = 0; i < count; i++) {
        vbss_rigid_predict(&all.body[first + i], &part, &all.predicted[i]);
        all.trial[i] = all.predicted[i].pose;
    }
    for (int round = 0; round < 2; round++) {
        vbss_system_clear(s);
        for (int i = 0; i < count; i++) {
            vbss_rigid_assemble(&all.body[first + i], &part, &all.predicted[i], &all.trial[i], s,
                                &all.blocks[i]);
        }
        rigid_rig_solve(s);
        for (int i = 0; i < count; i++) {
            const vec3 *u = &s->solution[all.blocks[i].first];
            vbss_rigid_apply_increment(&all.trial[i], u[0], u[1]);
        }
    }
    for (int i = 0; i < count; i++) {
        vbss_rigid_commit(&all.body[first + i], &part, &all.predicted[i], &all.trial[i]);
    }
}

/* Symmetric to the bit, and L L^T can be taken. */
static void expect_positive_definite(mat3 a)
{
    assert_true(a.m[0][1] == a.m[1][0] && a.m[0][2] == a.m[2][0] && a.m[1][2] == a.m[2][1]);
    double largest = fmax(a.m[0][0], fmax(a.m[1][1], a.m[2][2]));
    double d1 = a.m[1][1] - a.m[1][0] * a.m[1][0] / a.m[0][0];
    assert_true(a.m[0][0] > 0.0 && d1 > 0.0);
    assert_true(mat3_determinant(mat3_scale(a, 1.0 / largest)) > 0.0);
}

static void any_blocks(harness_source *source, void *user)
{
    (void)user;
    const vbss_role roles[BODIES] = {VBSS_ROLE_INTERIOR, VBSS_ROLE_SEPARATOR, VBSS_ROLE_INTERIOR};
    const vbss_rigid_substep part = {1e-3, 0.25, 0.75};
    begin_bodies(roles);
    vbss_system_clear(all.system);
    for (int i = 0; i < BODIES; i++) {
        vbss_rigid *body = &all.body[i];
        vbss_rigid_motion predicted;
        draw_body(source, body);
        vbss_rigid_predict(body, &part, &predicted);
        pose trial = rigid_draw_pose(source, 0.1);
        memset(&all.system->off_diagonal[all.blocks[i].coupling], 0x7f, sizeof(block));
        vbss_rigid_assemble(body, &part, &predicted, &trial, all.system, &all.blocks[i]);
        const block *diagonal = &all.system->diagonal[all.blocks[i].first];
        expect_positive_definite(block_mat3(&diagonal[0]));
        expect_positive_definite(block_mat3(&diagonal[1]));
        double wanted = (1.0 + 0.5e-3 * body->drag) * body->mass / 0.25e-6;
        wanted += body->coupling.stiffness + body->coupling.damping / 0.5e-3;
        expect_near(wanted, block_mat3(&diagonal[0]).m[1][1], 1e-13 * wanted);
    }
    rigid_rig_solve(all.system); /* the couplings are zero */
    for (int i = 0; i < BODIES; i++) {
        uint32_t b = all.blocks[i].first;
        vec3 rhs = mat3_mul_vec3(block_mat3(&all.system->diagonal[b]), all.system->solution[b]);
        expect_near(0.0, vec3_distance(rhs, all.system->rhs[b]), 1e-12 * vec3_norm(rhs));
    }
    end_bodies();
}

static void blocks_are_symmetric_positive_definite(void **state)
{
    (void)state;
    harness_property("blocks", 200, any_blocks, NULL);
}

/* Bodies in one system, which nothing couples, move as each alone; of what role does not matter. */
static void bodies_beside_each_other_do_not_meet(harness_source *source, void *user)
{
    (void)user;
    const vbss_role runs[BODIES] = {VBSS_ROLE_INTERIOR, VBSS_ROLE_INTERIOR, VBSS_ROLE_INTERIOR};
    const vbss_role mixed[BODIES] = {VBSS_ROLE_SEPARATOR, VBSS_ROLE_INTERIOR, VBSS_ROLE_SEPARATOR};
    vbss_rigid start[BODIES], alone[BODIES];
    for (int i = 0; i < BODIES; i++) {
        draw_body(source, &start[i]);
    }
    memcpy(all.body, start, sizeof start);
    begin_bodies(runs);
    for (int i = 0; i < BODIES; i++) {
        /* The other blocks keep what the last step left there: sound numbers, of no one. */
        step_bodies(0, BODIES);
        memcpy(all.body, start, sizeof start);
        step_bodies(i, 1);
        alone[i] = all.body[i];
    }
    memcpy(all.body, start, sizeof start);
    step_bodies(0, BODIES);
    assert_memory_equal(alone, all.body, sizeof alone);
    end_bodies();
    memcpy(all.body, start, sizeof start);
    begin_bodies(mixed);
    step_bodies(0, BODIES);
    for (int i = 0; i < BODIES; i++) {
        vec3 displacement = vec3_sub(alone[i].now.pose.position, start[i].now.pose.position);
        vec3 other = vec3_sub(all.body[i].now.pose.position, start[i].now.pose.position);
        expect_near(0.0, vec3_distance(displacement, other),
                    1e-12 * vec3_norm(displacement) + 1e-16);
        expect_near(0.0,
                    rigid_turn(alone[i].now.pose.orientation, all.body[i].now.pose.orientation),
                    1e-11);
    }
    end_bodies();
}

static void motion_is_independent_of_role_and_neighbours(void **state)
{
    (void)state;
    harness_property("bodies", 50, bodies_beside_each_other_do_not_meet, NULL);
}

/* Others add a spring at an arm, with the coupling of both blocks: K, -K [r], [r]^T K [r]. It pulls the
 * point of the arm to where it belongs, and its force turns the body too. */
static void spring_at_arm_couples_both_blocks(void **state)
{
    (void)state;
    static const vbss_role each[2] = {VBSS_ROLE_INTERIOR, VBSS_ROLE_SEPARATOR};
    for (int k = 0; k < 2; k++) {
        rigid_rig rig;
        rigid_rig_begin(&rig, each[k]);
        vec3 arm = vec3_make(0.02, 0.01, -0.03), goal = vec3_make(0.02, 0.0101, -0.03);
        vbss_system *s = rig.system;
        uint32_t b = rig.blocks.first;
        vbss_rigid_substep part = {1e-3, 0.0, 1.0};
        vbss_rigid_motion predicted;
        vbss_rigid_predict(&rig.body, &part, &predicted);
        pose trial = predicted.pose;
        vbss_system_clear(s);
        vbss_rigid_assemble(&rig.body, &part, &predicted, &trial, s, &rig.blocks);
        double stiffness = 1e9;
        mat3 of_turn = mat3_scale(mat3_cross(arm), -1.0); /* dtheta x r */
        mat3 turning = mat3_mul(mat3_transpose(of_turn), mat3_scale(of_turn, stiffness));
        mat3 both = mat3_scale(s->couplings[rig.blocks.coupling].is_transposed != 0
                                   ? of_turn
                                   : mat3_transpose(of_turn),
                               stiffness);
        vec3 force = vec3_scale(vec3_sub(goal, arm), stiffness);
        block_set(&s->diagonal[b], mat3_add(block_mat3(&s->diagonal[b]),
                                            mat3_diagonal(stiffness, stiffness, stiffness)));
        block_set(&s->diagonal[b + 1], mat3_add(block_mat3(&s->diagonal[b + 1]), turning));
        block_set(&s->off_diagonal[rig.blocks.coupling], both);
        s->rhs[b] = vec3_add(s->rhs[b], force);
        s->rhs[b + 1] = vec3_add(s->rhs[b + 1], vec3_cross(arm, force));
        rigid_rig_solve(s);
        vec3 u = vec3_add(s->solution[b], vec3_cross(s->solution[b + 1], arm));
        expect_near(0.0, vec3_distance(u, vec3_sub(goal, arm)), 1e-4 * 1e-4);
        /* One impulse: what it does to both momenta fits. */
        vec3 impulse = vec3_scale(s->solution[b], rig.body.mass);
        mat3 inertia = vbss_rigid_world_inertia(&rig.body, trial.orientation);
        vec3 twist = mat3_mul_vec3(inertia, s->solution[b + 1]);
        expect_near(0.0, vec3_distance(twist, vec3_cross(arm, impulse)), 1e-9 * vec3_norm(twist));
        rigid_rig_end(&rig);
    }
}

static void driven_body_reaches_target(void **state)
{
    (void)state;
    rigid_rig rig;
    rigid_rig_begin(&rig, VBSS_ROLE_PRESCRIBED);
    pose end = {vec3_make(0.001, 0.002, 0.003),
                vbss_quat_from_rotation_vector(vec3_make(0.0, 0.03, 0.04))};
    vbss_rigid_set_target(&rig.body, end);
    vbss_rigid_substep part = {2e-3, 0.0, 0.5};
    vbss_rigid_motion m = vbss_rigid_target_motion(&rig.body, &part);
    quat middle = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.015, 0.02));
    expect_near(0.0, vec3_distance(vec3_make(0.0005, 0.001, 0.0015), m.pose.position), 1e-18);
    expect_near(0.0, rigid_turn(middle, m.pose.orientation), 1e-15);
    expect_near(0.0, vec3_distance(vec3_make(0.5, 1.0, 1.5), m.v), 1e-15);
    expect_near(0.0, vec3_distance(vec3_make(0.0, 15.0, 20.0), m.w), 1e-13);
    part.end_fraction = 1.0;
    m = vbss_rigid_target_motion(&rig.body, &part);
    assert_memory_equal(&end, &m.pose, sizeof end);
    vbss_system_clear(rig.system);
    vbss_rigid_assemble(&rig.body, &part, &m, &m.pose, rig.system, &rig.blocks);
    rigid_rig_solve(rig.system); /* no equation */
    expect_near(0.0, vec3_norm(rig.system->solution[rig.blocks.first]), 0.0);
    expect_near(0.0, vec3_norm(rig.system->solution[rig.blocks.first + 1]), 0.0);
    rigid_rig_end(&rig);
}

static void missing_block_capacity_is_reported(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_system *system;
    vbss_rigid_blocks blocks;
    expect_ok(vbss_system_create(context, 3, 1, 0, 0, &system));
    vbss_system_begin_pattern(system);
    expect_ok(vbss_rigid_register(system, VBSS_ROLE_INTERIOR, &blocks));
    expect_result(VBSS_ERROR_CAPACITY, vbss_rigid_register(system, VBSS_ROLE_INTERIOR, &blocks));
    vbss_system_destroy(context, system);
    harness_context_end(context, &memory);
}

int test_rigid(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(blocks_are_symmetric_positive_definite),
        harness_test(motion_is_independent_of_role_and_neighbours),
        harness_test(spring_at_arm_couples_both_blocks),
        harness_test(driven_body_reaches_target),
        harness_test(missing_block_capacity_is_reported),
    };
    return cmocka_run_group_tests_name("solver.rigid", tests, NULL, NULL);
}
