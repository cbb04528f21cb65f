/* Method VBLAST: its configuration, and numbers that are rejected. */
#include "fixtures/baseline_of.h"
#include "base/error.h"
#include "drain/paper_drain_rig.h"

#include "drain/mesh_rig.h"

/* ---- the configuration */

static vbss_result make(vbss_context *context, const vbss_drain_config *config)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, config, &drain));
    return vbss_drain_destroy(drain);
}

static void bad_methods_are_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_drain_config config;
    const vbss_method methods[] = {-1, 2, INT32_MAX};
    for (int k = 0; k < 3; k++) {
        config = paper_config();
        config.method = methods[k];
        expect_result(VBSS_ERROR_OUT_OF_RANGE, make(context, &config));
    }
    harness_context_end(context, &memory);
}

static void any_drain_that_is_allowed_can_be_made(harness_source *source, void *user)
{
    paper_rig r;
    drain_mesh_options o = mesh_rig_draw(source, false);
    vbss_drain_config config = paper_config();
    (void)user;
    config.radius = o.radius;
    config.length = o.length;
    config.slit_length = o.slit_length;
    config.slit_opening = o.opening;
    config.mark_arc = o.mark_arc;
    config.thickness = 0.1 * o.radius;
    paper_begin(&r, &config);
    for (uint32_t i = 0; i < r.object->mesh.node_count; i++) {
        assert_true(r.object->mass[i] > 0.0);
    }
    paper_run(&r, 1e-3, 2);
    assert_true(paper_statistics(&r).last_move == 0.0);
    paper_end(&r);
}

static void drain_of_any_size_is_at_rest(void **state)
{
    (void)state;
    harness_property("paper's drain of any measures", 300, any_drain_that_is_allowed_can_be_made,
                     NULL);
}

static vbss_drain_config tugged_config(void)
{
    vbss_drain_config config = paper_config();
    baseline_of(&config.baseline)->drain_damping = 0.05;
    config.drag = 20.0;
    config.gravity[1] = -9.81;
    return config;
}

/* ---- what is refused */

static void non_finite_numbers_are_rejected(void **state)
{
    (void)state;
    paper_rig r;
    vbss_drain_config config = tugged_config();
    paper_begin(&r, &config);
    uint64_t hash = paper_hash(&r);
    for (int k = 0; k < 3; k++) {
        double numbers[3 * PAPER_NODES] = {0.0};
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_drain_step(r.drain, harness_bad_numbers[k]));
        for (uint32_t i = 0; i < 3 * PAPER_NODES; i++) {
            numbers[i] = harness_bad_numbers[k];
            expect_result(VBSS_ERROR_NOT_FINITE,
                          vbss_drain_set_state(r.drain, numbers, NULL, PAPER_NODES));
            expect_result(VBSS_ERROR_NOT_FINITE,
                          vbss_drain_set_state(r.drain, NULL, numbers, PAPER_NODES));
            numbers[i] = 0.0;
        }
    }
    assert_true(hash == paper_hash(&r));
    paper_end(&r);
}

int test_paper_drain_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(bad_methods_are_rejected),
        harness_test(drain_of_any_size_is_at_rest),
        harness_test(non_finite_numbers_are_rejected),
    };
    return cmocka_run_group_tests_name("drain.paper_drain_config", tests, NULL, NULL);
}
