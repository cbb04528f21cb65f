/* Limits of work that fit a slot, from the speed of the core. */
#include <vblast_ss/budget.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "scene/api/api.h"

#include <string.h>

_Static_assert(sizeof(vbss_budget_config) == 32, "published size");

static const vbss_budget_config defaults = {
    .struct_size = sizeof(vbss_budget_config),
    .slot = 1e-3,
    .share = 0.5,
};
static const uint32_t budget_sizes[] = {32, 0};
static const vbss_layout budget_layout = {"vbss_budget_config", &defaults, budget_sizes};

/* Bounds of call_budget, operations. Chosen: a fifth of the default, with which a step of the task still
 * begins its first solve, and ten times the default. */
enum {
    MIN_SLOT_LIMIT = SCENE_DEFAULT_CALL_BUDGET / 5,
    MAX_SLOT_LIMIT = 10 * SCENE_DEFAULT_CALL_BUDGET
};

vbss_result vbss_budget_config_init(vbss_budget_config *budget, uint32_t struct_size)
{
    return vbss_config_init(&budget_layout, budget, struct_size);
}

static vbss_result check_budget(vbss_context *context, const vbss_budget_config *b)
{
    VBSS_TRY(vbss_check_range(context, b->operations_per_microsecond, 1e-3, 1e6,
                              "operations_per_microsecond"));
    VBSS_TRY(vbss_check_range(context, b->slot, 1e-5, 1.0, "slot"));
    VBSS_TRY(vbss_check_range(context, b->share, 0.01, 1.0, "share"));
    return vbss_check_range(context, b->allows_more, 0.0, 1.0, "allows_more");
}

/* Operations that fit into the share of the slot, within the bounds. */
static uint32_t fit_slot_limit(vbss_context *context, const vbss_budget_config *b)
{
    const double max = b->allows_more ? MAX_SLOT_LIMIT : SCENE_DEFAULT_CALL_BUDGET;
    const double fitting = 1e6 * b->slot * b->share * b->operations_per_microsecond;
    if (fitting < MIN_SLOT_LIMIT) {
        vbss_message(context, VBSS_LOG_WARNING,
                     "the core does %.0f operations in its share of a slot; call_budget is %d, and "
                     "calls take longer",
                     fitting, (int)MIN_SLOT_LIMIT);
        return MIN_SLOT_LIMIT;
    }
    return (uint32_t)(fitting < max ? fitting : max);
}

vbss_result vbss_budget_fit_scene(vbss_context *context, const vbss_budget_config *budget,
                                  vbss_scene_config *config)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_budget_config own;
    vbss_scene_config scene;
    VBSS_TRY(vbss_config_read(context, &budget_layout, budget, &own));
    VBSS_TRY(vbss_config_read(context, &vbss_scene_config_layout, config, &scene));
    VBSS_TRY(check_budget(context, &own));
    config->call_budget = fit_slot_limit(context, &own);
    config->step_budget = (uint32_t)((uint64_t)config->call_budget * SCENE_DEFAULT_STEP_BUDGET /
                                     SCENE_DEFAULT_CALL_BUDGET);
    return VBSS_OK;
}
