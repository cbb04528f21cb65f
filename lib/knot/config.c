/* Configuration of a detector: defaults and range checks. */
#include "base/check.h"
#include "base/error.h"
#include "knot/knot.h"

static const uint32_t config_sizes[] = {96, 0};
_Static_assert(sizeof(vbss_knot_detector_config) == 96, "published size");
/* slip_limit: of knots tied in simulation, flat throws at rest measure up to 0.31; a knot that slides
 * along a pulled end has a throw of at least 0.48, and one tied as half hitches of at least 0.53
 * (docs/notebook/knots.md). At 0.45 one limb bends 2.6 times as much as the other. */
static const vbss_knot_detector_config config_defaults = {.struct_size =
                                                              sizeof(vbss_knot_detector_config),
                                                          .method = VBSS_KNOT_METHOD_TOPOLOGY,
                                                          .point_capacity = 1024,
                                                          .tool_capacity = 4,
                                                          .crossing_capacity = 512,
                                                          .direction_limit = 6,
                                                          .closure_count = 8,
                                                          .closure_tolerance = 2,
                                                          .step_budget = 8000,
                                                          .interval = 20,
                                                          .event_capacity = 64,
                                                          .tail_reach = 0.03,
                                                          .tail_least = 0.003,
                                                          .wrap_turns = 0.75,
                                                          .slip_limit = 0.45,
                                                          .plane_offset = -0.002,
                                                          .seed = 1};
const vbss_layout vbss_knot_config_layout = {"vbss_knot_detector_config", &config_defaults,
                                             config_sizes};

vbss_result vbss_knot_detector_config_init(vbss_knot_detector_config *config, uint32_t struct_size)
{
    return vbss_config_init(&vbss_knot_config_layout, config, struct_size);
}

vbss_result vbss_knot_check_config(vbss_context *context, const vbss_knot_detector_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->method, VBSS_KNOT_METHOD_TOPOLOGY,
                              VBSS_KNOT_METHOD_PROJECTION, "method"));
    VBSS_TRY(vbss_check_range(context, c->point_capacity, 2.0, 8192.0, "point_capacity"));
    VBSS_TRY(vbss_check_range(context, c->tool_capacity, 0.0, 16.0, "tool_capacity"));
    VBSS_TRY(vbss_check_range(context, c->crossing_capacity, 8.0, 2048.0, "crossing_capacity"));
    VBSS_TRY(vbss_check_range(context, c->direction_limit, 1.0, 64.0, "direction_limit"));
    VBSS_TRY(vbss_check_range(context, c->closure_count, 0.0, KNOT_CLOSURES, "closure_count"));
    VBSS_TRY(
        vbss_check_range(context, c->closure_tolerance, 0.0, KNOT_CLOSURES, "closure_tolerance"));
    VBSS_TRY(vbss_check_range(context, c->step_budget, 100.0, 1e9, "step_budget"));
    VBSS_TRY(vbss_check_range(context, c->event_capacity, 8.0, 4096.0, "event_capacity"));
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_range(context, c->tail_reach, 0.0, 1.0, "tail_reach"));
    VBSS_TRY(vbss_check_range(context, c->tail_least, 0.0, 1.0, "tail_least"));
    VBSS_TRY(vbss_check_range(context, c->wrap_turns, 0.1, 2.0, "wrap_turns"));
    VBSS_TRY(vbss_check_range(context, c->slip_limit, 0.0, 1.0, "slip_limit"));
    return vbss_check_range(context, c->plane_offset, -1.0, 1.0, "plane_offset");
}
