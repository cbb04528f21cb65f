/* The options of a scene's solver: defaults and checks. */
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/api/api.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

_Static_assert(sizeof(vbss_solver_options) == 72, "published size");

static const vbss_solver_options defaults = {
    .struct_size = sizeof(vbss_solver_options),
    .iteration_limit = 12,
    .active_set_limit = 36,
    .halving_limit = 5,
    .attempt_limit = 3,
    .stretch_tolerance = 1e-3,
    .penetration_tolerance = 0.1,
    .contact_margin = 3e-5,
    .step_budget_us = 500.0,
    .call_budget_us = 420.0,
    .operations_per_us = SCENE_DEFAULT_OPERATIONS_PER_US,
};
static const uint32_t sizes[] = {72, 0};
static const vbss_layout layout = {"vbss_solver_options", &defaults, sizes};

vbss_result vbss_solver_options_init(vbss_solver_options *options, uint32_t struct_size)
{
    return vbss_config_init(&layout, options, struct_size);
}

/* A budget that is not 0 must not become 0 operations, which would mean no limit. */
static vbss_result check_budget(vbss_context *context, double budget_us, double operations_per_us,
                                const char *name)
{
    VBSS_TRY(vbss_check_range(context, budget_us, 0.0, 1e7, name));
    const double operations = vbss_scene_count_operations(budget_us, operations_per_us);
    if (budget_us > 0.0 && !(operations >= 1.0 && operations <= UINT32_MAX)) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "%s is %s, which is %s operations at operations_per_us %s, outside [1, "
                         "4294967295]; 0 is no limit",
                         name, VBSS_NUMBER(budget_us), VBSS_NUMBER(operations),
                         VBSS_NUMBER(operations_per_us));
    }
    return VBSS_OK;
}

vbss_result vbss_solver_options_check_budgets(vbss_context *context, double step_budget_us,
                                              double call_budget_us, double operations_per_us)
{
    VBSS_TRY(vbss_check_range(context, operations_per_us, 1e-3, 1e6, "operations_per_us"));
    VBSS_TRY(check_budget(context, step_budget_us, operations_per_us, "step_budget_us"));
    return check_budget(context, call_budget_us, operations_per_us, "call_budget_us");
}

vbss_result vbss_solver_options_read(vbss_context *context, const vbss_solver_options *given,
                                     vbss_solver_options *own)
{
    *own = defaults;
    if (given == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_config_read(context, &layout, given, own));
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"iteration_limit", own->iteration_limit, 1.0, 100.0},
        {"active_set_limit", own->active_set_limit, 1.0, 1000.0},
        {"halving_limit", own->halving_limit, 0.0, 10.0},
        {"attempt_limit", own->attempt_limit, 1.0, 1000.0},
        {"reserved", own->reserved, 0.0, 0.0},
        {"stretch_tolerance", own->stretch_tolerance, 1e-9, 0.1},
        {"penetration_tolerance", own->penetration_tolerance, 1e-3, 0.5},
        {"contact_margin", own->contact_margin, 0.0, 0.1},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    return vbss_solver_options_check_budgets(context, own->step_budget_us, own->call_budget_us,
                                             own->operations_per_us);
}
