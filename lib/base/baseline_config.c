/* The parameters of the baseline: defaults and checks. */
#include "base/baseline_config.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"

_Static_assert(sizeof(vbss_baseline_config) == 104, "published size");

static const vbss_baseline_config defaults = {
    .struct_size = sizeof(vbss_baseline_config),
    .thread_iteration_limit = 50,
    .scene_pass_limit = 4,
    .collision_parallel = 1e-6,
    .collision_unit = 1e-3,
    .thread_tolerance = 1e-6,
    .drain_stiffness = 125.0,
    .drain_damping = 0.7,
    .grasper_stiffness = 50.0,
    .grasper_distance = 2e-3,
};
static const uint32_t sizes[] = {104, 0};
static const vbss_layout layout = {"vbss_baseline_config", &defaults, sizes};

vbss_result vbss_baseline_config_init(vbss_baseline_config *config, uint32_t struct_size)
{
    return vbss_config_init(&layout, config, struct_size);
}

vbss_result vbss_baseline_read_config(vbss_context *context, const vbss_baseline_config **config,
                                      vbss_baseline_config *own)
{
    const vbss_baseline_config *given = *config;
    *own = defaults;
    *config = own;
    if (given == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_config_read(context, &layout, given, own));
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"thread_substeps", own->thread_substeps, 0.0, 100000.0},
        {"thread_iteration_limit", own->thread_iteration_limit, 1.0, 1000.0},
        {"drain_substeps", own->drain_substeps, 0.0, 100000.0},
        {"scene_pass_limit", own->scene_pass_limit, 1.0, 1000.0},
        {"reserved", own->reserved, 0.0, 0.0},
        {"collision_parallel", own->collision_parallel, 0.0, 1.0},
        {"collision_unit", own->collision_unit, 1e-9, 1e3},
        {"thread_stiffness", own->thread_stiffness, 0.0, 1e9},
        {"thread_damping", own->thread_damping, 0.0, 1.0},
        {"thread_tolerance", own->thread_tolerance, 1e-14, 1.0},
        {"drain_stiffness", own->drain_stiffness, 0.0, 1e9},
        {"drain_damping", own->drain_damping, 0.0, 1.0},
        {"grasper_stiffness", own->grasper_stiffness, 0.0, 1e6},
        {"grasper_distance", own->grasper_distance, 0.0, 0.1},
        {"scene_thickness", own->scene_thickness, 0.0, 1e-2},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    return VBSS_OK;
}
