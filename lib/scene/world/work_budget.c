/* The operation budget of a step. */
#include "scene/tuning.h"
#include "scene/world/world.h"

double vbss_scene_count_operations(double budget_us, double operations_per_us)
{
    return floor(budget_us * operations_per_us + 0.5);
}

uint32_t vbss_scene_attempt_cost(const scene_object *s)
{
    return SCENE_CANDIDATE_COST * s->collision->candidate_count +
           SCENE_ATTEMPT_NODE_COST * s->node_count;
}

void vbss_scene_charge_budget(scene_object *s, uint32_t operations)
{
    s->contacts->counters.operations += operations;
}

bool vbss_scene_is_over_budget(const scene_object *s)
{
    return s->step.budget > 0 && s->contacts->counters.operations >= s->step.budget;
}

static bool is_first_step(const scene_object *s)
{
    return s->report.statistics.steps == 0;
}

bool vbss_scene_limits_steps(const scene_object *s)
{
    return s->config.mode == VBSS_SCENE_MODE_REAL_TIME && s->settings.step_budget > 0;
}

bool vbss_scene_has_step_budget(const scene_object *s)
{
    return vbss_scene_limits_steps(s) && !is_first_step(s);
}

bool vbss_scene_is_beyond_step_limits(const scene_object *s, uint64_t operations, uint32_t attempts)
{
    const uint64_t limits = is_first_step(s) ? SCENE_FIRST_STEP_LIMITS : 1;
    return vbss_scene_limits_steps(s) && (operations >= limits * s->settings.step_budget ||
                                          attempts >= limits * s->solver.attempt_limit);
}
