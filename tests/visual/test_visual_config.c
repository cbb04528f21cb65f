/* What a visual can be made of: the size protocol, every bad number, memory that fails. */
#include "fixture.h"

static vbss_result init(void *config, uint32_t struct_size)
{
    return vbss_visual_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_visual *visual = NULL;
    vbss_result result = vbss_visual_create(context, config, &visual);
    return result == VBSS_OK ? vbss_visual_destroy(visual) : result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[] = {104, 0};
    const harness_config config = {sizes, init, create_and_destroy};
    harness_config_protocol(&config);
}

static void null_config_is_default(void **state)
{
    (void)state;
    fixture f;
    vbss_slot *slot;
    begin(&f);
    expect_ok(vbss_visual_create(f.context, NULL, &f.visual));
    expect_ok(vbss_slot_open(f.visual, &vbss_visual_kind_of_slot, &slot));
    assert_memory_equal(&f.config, &((visual_object *)slot->object)->config, sizeof f.config);
    end(&f);
}

static void expect_config(const fixture *f, vbss_result wanted)
{
    vbss_visual *visual = (vbss_visual *)f->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(f->context, &before, sizeof before));
    expect_result(wanted, vbss_visual_create(f->context, &f->config, &visual));
    if (wanted == VBSS_OK) {
        expect_ok(vbss_visual_destroy(visual));
    } else {
        assert_null(visual);
    }
    expect_ok(vbss_context_get_statistics(f->context, &after, sizeof after));
    assert_true(after.objects_alive == before.objects_alive);
}

static void out_of_range_numbers_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const struct {
        uint32_t *value, low, high;
    } counts[] = {{&f.config.source_capacity, 1, 256}, {&f.config.part_capacity, 1, 4096},
                  {&f.config.vertex_capacity, 16, 0},  {&f.config.triangle_capacity, 16, 0},
                  {&f.config.spot_capacity, 0, 4096},  {&f.config.node_capacity, 2, 65537},
                  {&f.config.side_limit, 6, 64},       {&f.config.division_limit, 1, 32},
                  {&f.config.reserved, 0, 0}};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        const uint32_t usual = *counts[i].value;
        *counts[i].value = counts[i].low;
        expect_config(&f, VBSS_OK);
        *counts[i].value = counts[i].low - 1;
        expect_config(&f, VBSS_ERROR_OUT_OF_RANGE); /* 0 - 1 is too large */
        *counts[i].value = counts[i].high > 0 ? counts[i].high : usual;
        expect_config(&f, VBSS_OK);
        *counts[i].value = counts[i].high > 0 ? counts[i].high + 1 : 16777217;
        expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
        *counts[i].value = usual;
    }
    const struct {
        double *value, low, high;
    } lengths[] = {{&f.config.tube_tolerance, 1e-8, 1.0}, {&f.config.surface_tolerance, 1e-8, 1.0},
                   {&f.config.mark_radius, 0.0, 0.1},     {&f.config.tip_length, 0.0, 1.0},
                   {&f.config.floor_size, 1e-3, 1e3},     {&f.config.origin[0], -1e3, 1e3},
                   {&f.config.origin[2], -1e3, 1e3}};
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        const double usual = *lengths[i].value;
        const double good[] = {lengths[i].low, lengths[i].high};
        const double bad[] = {lengths[i].low - 1e-9, lengths[i].high * 1.001};
        for (int k = 0; k < 2; k++) {
            *lengths[i].value = good[k];
            expect_config(&f, VBSS_OK);
            *lengths[i].value = bad[k];
            expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
        }
        for (int k = 0; k < 3; k++) {
            *lengths[i].value = harness_bad_numbers[k];
            expect_config(&f, VBSS_ERROR_NOT_FINITE);
        }
        *lengths[i].value = usual;
    }
    end(&f);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    (void)user;
    return create_and_destroy(context, NULL);
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    harness_fail_every_allocation(attempt, NULL);
}

int test_visual_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(config_size_protocol),
        harness_test(null_config_is_default),
        harness_test(out_of_range_numbers_are_rejected),
        harness_test(each_failed_allocation_is_reported_without_leak),
    };
    return cmocka_run_group_tests_name("visual.visual_config", tests, NULL, NULL);
}
