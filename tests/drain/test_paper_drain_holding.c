/* Method VBLAST: what is attached to its particles. */
#include "fixtures/baseline_of.h"
#include "drain/paper_drain_rig.h"

static void pinned_particles_move_linearly_to_targets(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    paper_begin(&r, &config);
    const uint32_t node = PAPER_MIDDLE + 1;
    vec3 from = paper_place(&r, node), displacement = vec3_make(1e-3, 2e-3, -0.5e-3);
    uint32_t pin = paper_attach(&r, VBSS_DRAIN_ATTACHMENT_PIN, node, from, 0.0);
    paper_run(&r, 1e-3, 1);
    expect_near_vec3(vec3_zero(), paper_reaction(&r, pin), 1e-12);
    paper_take(&r, pin, vec3_add(from, displacement));
    paper_run(&r, 1e-3, 1);
    expect_near_vec3(vec3_add(from, displacement), paper_place(&r, node), 0.0);
    expect_near_vec3(vec3_scale(displacement, 1e3), r.object->v[node], 1e-12);
    paper_run(&r, 1e-3, 2);
    expect_near_vec3(vec3_zero(), r.object->v[node], 1e-12);
    expect_near_vec3(vec3_scale(displacement, 125.0), paper_reaction(&r, pin), 1e-13);
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        expect_near_vec3(vec3_zero(), i == node ? vec3_zero() : paper_moved(&r, i), 0.0);
    }
    expect_ok(vbss_drain_detach(r.drain, pin));
    paper_run(&r, 1e-3, 1);
    assert_true(vec3_norm(r.object->v[node]) > 0.1);
    paper_end(&r);
}

/* In one explicit step: mass times acceleration, drag, and what else acts at the particle. */
static void reaction_equals_momentum_change(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_substeps = 1;
    config.drag = 30.0;
    config.gravity[1] = -9.81;
    paper_begin(&r, &config);
    const uint32_t node = PAPER_MIDDLE + 5;
    const double h = 1e-4;
    double mass = r.object->mass[node];
    vec3 from = paper_place(&r, node), displacement = vec3_make(1e-5, -3e-5, 2e-5);
    vec3 pull = vec3_make(0.01, 0.0, 0.02), at = vec3_make(0.0, -5e-3, 1e-3);
    uint32_t pin =
        paper_attach(&r, VBSS_DRAIN_ATTACHMENT_PIN, node, vec3_add(from, displacement), 0.0);
    uint32_t spring = paper_attach(&r, VBSS_DRAIN_ATTACHMENT_SPRING, node, at, 40.0);
    paper_attach(&r, VBSS_DRAIN_ATTACHMENT_FORCE, node, pull, 0.0);
    paper_run(&r, h, 1);
    vec3 v = vec3_scale(displacement, 1.0 / h), others = vec3_add(pull, paper_reaction(&r, spring));
    expect_near_vec3(vec3_scale(vec3_sub(at, vec3_add(from, displacement)), 40.0),
                     paper_reaction(&r, spring), 1e-15);
    vec3 wanted = vec3_scale(v, mass * (1.0 / h + 30.0));
    wanted.y += 9.81 * mass;
    expect_near_vec3(vec3_sub(wanted, others), paper_reaction(&r, pin), 1e-15);
    paper_end(&r);
}

/* Implicit, so a spring of any stiffness is stable; and in balance with the particle's own. */
static void attached_springs_need_no_shorter_steps(void **state)
{
    (void)state;
    const double stiffness[] = {50.0, 1e4, 1e9};
    for (int k = 0; k < 3; k++) {
        paper_rig r;
        vbss_drain_config config = paper_config();
        baseline_of(&config.baseline)->drain_damping = 0.3;
        paper_begin(&r, &config);
        const uint32_t node = PAPER_DOUBLE;
        vec3 displacement = vec3_make(0.0, 2e-3, 1e-3),
             end = vec3_add(paper_place(&r, node), displacement);
        double share = stiffness[k] / (stiffness[k] + 125.0);
        uint32_t id = paper_attach(&r, VBSS_DRAIN_ATTACHMENT_SPRING, node, end, stiffness[k]);
        paper_run(&r, 1e-3, 500);
        assert_int_equal(3 * 500, paper_statistics(&r).parts);
        expect_near_vec3(vec3_scale(displacement, share), paper_moved(&r, node), 1e-12);
        expect_near_vec3(vec3_scale(displacement, 125.0 * share), paper_reaction(&r, id), 1e-6);
        paper_end(&r);
    }
}

static void fully_pinned_drain_stays(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = paper_config();
    config.attachment_capacity = PAPER_NODES;
    baseline_of(&config.baseline)->drain_damping = 0.5;
    config.gravity[0] = 3.0;
    paper_begin(&r, &config);
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        paper_attach(&r, VBSS_DRAIN_ATTACHMENT_PIN, i, paper_place(&r, i), 0.0);
    }
    paper_run(&r, 1e-3, 5);
    assert_int_equal(5, paper_statistics(&r).parts);
    for (uint32_t i = 0; i < PAPER_NODES; i++) {
        expect_near_vec3(vec3_zero(), paper_moved(&r, i), 0.0);
        expect_near_vec3(vec3_make(-3.0 * r.object->mass[i], 0, 0), paper_reaction(&r, i + 1),
                         1e-18);
    }
    paper_end(&r);
}

int test_paper_drain_holding(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(pinned_particles_move_linearly_to_targets),
        harness_test(reaction_equals_momentum_change),
        harness_test(attached_springs_need_no_shorter_steps),
        harness_test(fully_pinned_drain_stays),
    };
    return cmocka_run_group_tests_name("drain.paper_drain_holding", tests, NULL, NULL);
}
