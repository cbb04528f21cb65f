/* Default configurations that the headers return: they are those of the init functions, and those that
 * the library uses for NULL. */
#include "harness/harness.h"

#include <string.h>

#include <vblast_ss/vblast_ss.h>

/* The size field comes first, and the rest is that of the init function to the bit. */
#define EXPECT_DEFAULTS(type, stem)                              \
    do {                                                         \
        type filled;                                             \
        memset(&filled, 0xa5, sizeof filled);                    \
        expect_ok(stem##_init(&filled, sizeof filled));          \
        const type returned = stem##_default();                  \
        assert_int_equal(returned.struct_size, sizeof returned); \
        assert_memory_equal(&filled, &returned, sizeof filled);  \
    } while (0)

static void defaults_of_headers_are_those_of_library(void **state)
{
    (void)state;
    EXPECT_DEFAULTS(vbss_device_adapter, vbss_device_adapter);
    EXPECT_DEFAULTS(vbss_device_sample, vbss_device_sample);
    EXPECT_DEFAULTS(vbss_device_capabilities, vbss_device_capabilities);
    EXPECT_DEFAULTS(vbss_device_coupling, vbss_device_coupling);
    EXPECT_DEFAULTS(vbss_context_config, vbss_context_config);
    EXPECT_DEFAULTS(vbss_collision_config, vbss_collision_config);
    EXPECT_DEFAULTS(vbss_collision_batch, vbss_collision_batch);
    EXPECT_DEFAULTS(vbss_device_calibration, vbss_device_calibration);
    EXPECT_DEFAULTS(vbss_device_config, vbss_device_config);
    EXPECT_DEFAULTS(vbss_drain_config, vbss_drain_config);
    EXPECT_DEFAULTS(vbss_drain_attachment, vbss_drain_attachment);
    EXPECT_DEFAULTS(vbss_grasper_config, vbss_grasper_config);
    EXPECT_DEFAULTS(vbss_openhaptics_config, vbss_openhaptics_config);
    EXPECT_DEFAULTS(vbss_nidaqmx_config, vbss_nidaqmx_config);
    EXPECT_DEFAULTS(vbss_knot_detector_config, vbss_knot_detector_config);
    EXPECT_DEFAULTS(vbss_knot_input, vbss_knot_input);
    EXPECT_DEFAULTS(vbss_mapping_config, vbss_mapping_config);
    EXPECT_DEFAULTS(vbss_metrics_config, vbss_metrics_config);
    EXPECT_DEFAULTS(vbss_metrics_sample, vbss_metrics_sample);
    EXPECT_DEFAULTS(vbss_metrics_event, vbss_metrics_event);
    EXPECT_DEFAULTS(vbss_metrics_pull, vbss_metrics_pull);
    EXPECT_DEFAULTS(vbss_mock_config, vbss_mock_config);
    EXPECT_DEFAULTS(vbss_needle_config, vbss_needle_config);
    EXPECT_DEFAULTS(vbss_output_config, vbss_output_config);
    EXPECT_DEFAULTS(vbss_output_command, vbss_output_command);
    EXPECT_DEFAULTS(vbss_record_config, vbss_record_config);
    EXPECT_DEFAULTS(vbss_scene_config, vbss_scene_config);
    EXPECT_DEFAULTS(vbss_scene_rigid_config, vbss_scene_rigid_config);
    EXPECT_DEFAULTS(vbss_session_config, vbss_session_config);
    EXPECT_DEFAULTS(vbss_solver_options, vbss_solver_options);
    EXPECT_DEFAULTS(vbss_thread_config, vbss_thread_config);
    EXPECT_DEFAULTS(vbss_thread_attachment, vbss_thread_attachment);
    EXPECT_DEFAULTS(vbss_visual_config, vbss_visual_config);
}

/* NOLINTBEGIN(bugprone-macro-parentheses): C has no parentheses around a type */
/* The bytes that the save function writes of an object. */
#define EXPECT_SAME_STATE(kind, config)                                                \
    do {                                                                               \
        static uint8_t bytes[2][1 << 18];                                              \
        uint64_t counts[2];                                                            \
        kind *objects[2];                                                              \
        const kind##_config defaults = config;                                         \
        expect_ok(kind##_create(context, NULL, &objects[0]));                          \
        expect_ok(kind##_create(context, &defaults, &objects[1]));                     \
        for (int i = 0; i < 2; i++) {                                                  \
            expect_ok(kind##_save(objects[i], bytes[i], sizeof bytes[i], &counts[i])); \
        }                                                                              \
        assert_int_equal(counts[0], counts[1]);                                        \
        assert_memory_equal(bytes[0], bytes[1], counts[0]);                            \
    } while (0)
/* NOLINTEND(bugprone-macro-parentheses) */

static void objects_of_null_and_of_defaults_have_equal_states(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    EXPECT_SAME_STATE(vbss_thread, vbss_thread_config_default());
    EXPECT_SAME_STATE(vbss_drain, vbss_drain_config_default());
    EXPECT_SAME_STATE(vbss_needle, vbss_needle_config_default());
    EXPECT_SAME_STATE(vbss_scene, vbss_scene_config_default());
    harness_context_end(context, &memory);
}

int test_defaults(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_of_headers_are_those_of_library),
        cmocka_unit_test(objects_of_null_and_of_defaults_have_equal_states),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
