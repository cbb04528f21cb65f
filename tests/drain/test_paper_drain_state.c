/* Method PAPER: its configuration, what is saved, and what a step must not do. */
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

static void bad_method_numbers_are_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const struct {
        size_t offset;
        double high;
    } fields[] = {{offsetof(vbss_drain_config, paper_stiffness), 1e9},
                  {offsetof(vbss_drain_config, paper_damping), 1.0}};
    for (int f = 0; f < 2; f++) {
        const double values[] = {0.0, fields[f].high, -1e-9, fields[f].high * (1.0 + 1e-12)};
        for (int k = 0; k < 7; k++) {
            vbss_drain_config config = paper_config();
            double value = k < 4 ? values[k] : harness_bad_numbers[k - 4];
            memcpy((char *)&config + fields[f].offset, &value, sizeof value);
            expect_result(k < 2   ? VBSS_OK
                          : k < 4 ? VBSS_ERROR_OUT_OF_RANGE
                                  : VBSS_ERROR_NOT_FINITE,
                          make(context, &config));
        }
    }
    vbss_drain_config config = paper_config();
    config.paper_substeps = 100000;
    expect_ok(make(context, &config));
    config.paper_substeps = 100001;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, make(context, &config));
    config = paper_config();
    config.reserved2 = 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, make(context, &config));
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

/* ---- a drain that is tugged */

static vbss_result attach(vbss_drain *drain, vbss_drain_attachment_kind kind, uint32_t node,
                          double stiffness)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.position[1] = 8e-3;
    a.stiffness = stiffness;
    return vbss_drain_attach(drain, &a, &id);
}

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, user, &drain));
    *handle = drain;
    VBSS_TRY(attach(drain, VBSS_DRAIN_ATTACHMENT_PIN, PAPER_MIDDLE + 1, 0.0));
    VBSS_TRY(attach(drain, VBSS_DRAIN_ATTACHMENT_FORCE, PAPER_MIDDLE + 11, 0.0));
    return attach(drain, VBSS_DRAIN_ATTACHMENT_SPRING, PAPER_DOUBLE, 70.0);
}

/* Moves depend on the state alone, so a restored drain goes on alike. */
static vbss_result step(void *handle)
{
    vbss_drain_statistics s;
    VBSS_TRY(vbss_drain_get_statistics(handle, &s, sizeof s));
    double swing = 0.01 * (double)((s.steps * 7) % 11);
    const double pin[3] = {0.1 * swing, 7e-3, 1e-3}, force[3] = {0.0, swing, -2.0 * swing};
    VBSS_TRY(vbss_drain_move(handle, 1, pin));
    VBSS_TRY(vbss_drain_move(handle, 2, force));
    return vbss_drain_step(handle, 1e-3);
}

static vbss_result destroy(void *handle)
{
    return vbss_drain_destroy(handle);
}

static vbss_drain_config tugged_config(void)
{
    vbss_drain_config config = paper_config();
    config.paper_damping = 0.05;
    config.drag = 20.0;
    config.gravity[1] = -9.81;
    return config;
}

static harness_body tugged(vbss_drain_config *config)
{
    *config = tugged_config();
    const harness_body body = {"paper's drain", &vbss_drain_kind, create, NULL, step, destroy,
                               config};
    return body;
}

static void restored_drain_continues_bit_equal(void **state)
{
    (void)state;
    vbss_drain_config config;
    harness_body body = tugged(&config);
    harness_save_restore_continue(&body, 1, 30);
    harness_save_restore_continue(&body, 37, 30);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    vbss_drain_config config;
    harness_body body = tugged(&config);
    harness_refuses_bad_snapshots(&body, 12);
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    vbss_drain_config config;
    harness_body body = tugged(&config);
    assert_int_equal(0, harness_step_allocations(&body, 100));
}

static vbss_result live(vbss_context *context, void *user)
{
    void *drain = NULL;
    vbss_result result = create(context, user, &drain);
    if (drain == NULL) {
        return result;
    }
    expect_ok(result);
    expect_ok(step(drain));
    return destroy(drain);
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    vbss_drain_config config = tugged_config();
    harness_fail_every_allocation(live, &config);
}

static uint64_t hash_after(uint32_t steps)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_drain_config config = tugged_config();
    void *drain = NULL;
    uint64_t hash = 0;
    expect_ok(create(context, &config, &drain));
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(step(drain));
    }
    expect_ok(vbss_drain_get_hash(drain, &hash));
    harness_context_end(context, &memory);
    return hash;
}

static void runs_are_bit_equal(void **state)
{
    (void)state;
    assert_true(hash_after(200) == hash_after(200));
    assert_true(hash_after(200) != hash_after(201));
}

/* ---- what is refused */

static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    uint8_t bytes[16384];
    uint64_t written;
    paper_rig r, other;
    vbss_drain_config config = tugged_config();
    paper_begin(&r, &config);
    expect_ok(vbss_drain_save(r.drain, bytes, sizeof bytes, &written));
    for (int k = 0; k < 4; k++) {
        config = tugged_config();
        config.paper_stiffness *= k == 0 ? 0.999 : 1.0;
        config.paper_damping *= k == 1 ? 0.999 : 1.0;
        config.paper_substeps += k == 2;
        config.method = k == 3 ? VBSS_METHOD_OURS : VBSS_METHOD_PAPER;
        paper_begin(&other, &config);
        uint64_t hash = paper_hash(&other);
        assert_true(vbss_drain_restore(other.drain, bytes, written) < 0);
        assert_true(hash == paper_hash(&other));
        paper_end(&other);
    }
    paper_end(&r);
}

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

int test_paper_drain_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(bad_method_numbers_are_rejected),
        harness_test(drain_of_any_size_is_at_rest),
        harness_test(restored_drain_continues_bit_equal),
        harness_test(bad_snapshots_are_rejected),
        harness_test(steps_do_not_allocate),
        harness_test(each_failed_allocation_is_reported),
        harness_test(runs_are_bit_equal),
        harness_test(snapshot_of_other_config_is_rejected),
        harness_test(non_finite_numbers_are_rejected),
    };
    return cmocka_run_group_tests_name("drain.paper_drain_state", tests, NULL, NULL);
}
