/* Sutures by material and size: diameters of USP <861>, and what follows from a round section. */
#include <float.h>
#include <string.h>

#include <vblast_ss/thread.h>

#include "base/pi.h"
#include "harness/harness.h"

static vbss_thread_config suture(vbss_thread_material material, vbss_thread_usp_size size)
{
    vbss_thread_config config = vbss_thread_config_default();
    expect_ok(vbss_thread_config_suture(&config, material, size));
    return config;
}

/* Limits of the average diameter, mm. */
static void diameters_are_the_middle_of_the_range_of_the_standard(void **state)
{
    (void)state;
    static const struct {
        vbss_thread_usp_size size;
        double min, max;
    } rows[] = {
        {VBSS_THREAD_USP_10_0, 0.020, 0.029}, {VBSS_THREAD_USP_9_0, 0.030, 0.039},
        {VBSS_THREAD_USP_8_0, 0.040, 0.049},  {VBSS_THREAD_USP_7_0, 0.050, 0.069},
        {VBSS_THREAD_USP_6_0, 0.070, 0.099},  {VBSS_THREAD_USP_5_0, 0.100, 0.149},
        {VBSS_THREAD_USP_4_0, 0.150, 0.199},  {VBSS_THREAD_USP_3_0, 0.200, 0.249},
        {VBSS_THREAD_USP_2_0, 0.300, 0.339},  {VBSS_THREAD_USP_0, 0.350, 0.399},
        {VBSS_THREAD_USP_1, 0.400, 0.499},    {VBSS_THREAD_USP_2, 0.500, 0.599},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        for (vbss_thread_material m = 0; m <= VBSS_THREAD_MATERIAL_NYLON; m++) {
            double diameter = 2e3 * suture(m, rows[i].size).radius;
            expect_near(0.5 * (rows[i].min + rows[i].max), diameter, 0.0006);
        }
    }
}

static void silk_2_0_agrees_with_the_preset(void **state)
{
    (void)state;
    vbss_thread_config found = suture(VBSS_THREAD_MATERIAL_SILK, VBSS_THREAD_USP_2_0);
    vbss_thread_config preset = vbss_thread_config_default();
    expect_ok(vbss_thread_config_preset(&preset, VBSS_THREAD_PRESET_SILK_2_0));
    expect_same_bits(preset.radius, found.radius);
    expect_near(preset.linear_density, found.linear_density, 1e-3 * preset.linear_density);
    expect_near(preset.axial_stiffness, found.axial_stiffness, 1e-3 * preset.axial_stiffness);
    expect_near(preset.bending_stiffness, found.bending_stiffness, 1e-2 * preset.bending_stiffness);
}

/* EI = E I of a round rod; a braid has a hundredth of that or less. */
static void monofilaments_bend_as_solid_rods(void **state)
{
    (void)state;
    for (vbss_thread_material m = 0; m <= VBSS_THREAD_MATERIAL_NYLON; m++) {
        for (vbss_thread_usp_size size = -10; size <= 2; size++) {
            if (size == -1) {
                continue;
            }
            vbss_thread_config c = suture(m, size);
            double solid = 0.25 * c.axial_stiffness * c.radius * c.radius;
            if (m >= VBSS_THREAD_MATERIAL_POLYPROPYLENE) {
                expect_near(solid, c.bending_stiffness, 4.0 * DBL_EPSILON * solid);
            } else {
                assert_true(c.bending_stiffness < 0.01 * solid);
            }
        }
    }
}

static void densities_are_those_of_the_materials(void **state)
{
    (void)state;
    const double wanted[] = {1305.0, 1500.0, 905.0, 1140.0};
    for (vbss_thread_material m = 0; m <= VBSS_THREAD_MATERIAL_NYLON; m++) {
        vbss_thread_config c = suture(m, VBSS_THREAD_USP_3_0);
        expect_near(wanted[m], c.linear_density / (VBSS_PI * c.radius * c.radius), 1e-9);
    }
}

static void other_sutures_are_refused_and_change_nothing(void **state)
{
    (void)state;
    vbss_thread_config config = vbss_thread_config_default();
    const vbss_thread_config kept = config;
    const int32_t sizes[] = {-11, -1, 3, INT32_MIN, INT32_MAX}, bad[] = {-1, 4, INT32_MAX};
    for (int k = 0; k < 5; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_thread_config_suture(&config, VBSS_THREAD_MATERIAL_SILK, sizes[k]));
        assert_memory_equal(&config, &kept, sizeof config);
    }
    for (int k = 0; k < 3; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_thread_config_suture(&config, bad[k], VBSS_THREAD_USP_2_0));
        assert_memory_equal(&config, &kept, sizeof config);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_thread_config_suture(NULL, VBSS_THREAD_MATERIAL_SILK, VBSS_THREAD_USP_2_0));
    config.struct_size = 3;
    expect_result(
        VBSS_ERROR_STRUCT_SIZE,
        vbss_thread_config_suture(&config, VBSS_THREAD_MATERIAL_SILK, VBSS_THREAD_USP_2_0));
}

static void every_suture_makes_a_thread(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (vbss_thread_material m = 0; m <= VBSS_THREAD_MATERIAL_NYLON; m++) {
        for (vbss_thread_usp_size size = -10; size <= 2; size++) {
            if (size == -1) {
                continue;
            }
            vbss_thread_config c = suture(m, size);
            vbss_thread *thread;
            expect_ok(vbss_thread_create(context, &c, &thread));
            expect_ok(vbss_thread_step(thread, 1e-3));
            expect_ok(vbss_thread_destroy(thread));
        }
    }
    harness_context_end(context, &memory);
}

int test_sutures(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(diameters_are_the_middle_of_the_range_of_the_standard),
        harness_test(silk_2_0_agrees_with_the_preset),
        harness_test(monofilaments_bend_as_solid_rods),
        harness_test(densities_are_those_of_the_materials),
        harness_test(other_sutures_are_refused_and_change_nothing),
        harness_test(every_suture_makes_a_thread),
    };
    return cmocka_run_group_tests_name("thread.sutures", tests, NULL, NULL);
}
