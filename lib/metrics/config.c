/* Configuration of a measurement: defaults and range checks. */
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "metrics/metrics.h"

_Static_assert(sizeof(vbss_metrics_config) == 192, "published size");

static const vbss_metrics_config defaults = {
    .struct_size = sizeof(vbss_metrics_config),
    .tightness_test = VBSS_METRICS_TEST_PULL,
    .throw_capacity = 64,
    .phase_capacity = 256,
    .incident_capacity = 256,
    .throws_wanted = 3,
    .duration = 600.0,
    .drain_radius = 6.5e-3,
    .stiffness = 427.0,
    .pull_force = 2.0,
    .pull_time = 1.0,
    .slip_limit = 1e-3,
    .idle_speed = 5e-3,
    .idle_release = 6e-3,
    .max_time = 600.0,
    .weight_deviation = 10.0,
    .weight_gap = 10.0,
    .weight_tightness = 1.0,
    .weight_host = 1.0,
    .max_speed = 2.0, /* upper limbs, ISO 13855 */
    .lost_share = 0.02,
};
static const uint32_t config_sizes[] = {176, 192, 0};
static const vbss_layout config_layout = {"vbss_metrics_config", &defaults, config_sizes};

vbss_result vbss_metrics_config_init(vbss_metrics_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

static vbss_result check_config(vbss_context *context, const vbss_metrics_config *c)
{
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"tightness_test", c->tightness_test, VBSS_METRICS_TEST_PULL, VBSS_METRICS_TEST_STRAIN},
        {"throw_capacity", c->throw_capacity, 1.0, 4096.0},
        {"phase_capacity", c->phase_capacity, 1.0, 65536.0},
        {"incident_capacity", c->incident_capacity, 1.0, 65536.0},
        {"throws_wanted", c->throws_wanted, 0.0, 64.0},
        {"duration", c->duration, 1.0, 7200.0},
        {"drain_radius", c->drain_radius, 1e-4, 1.0},
        {"stiffness", c->stiffness, 1e-3, 1e9},
        {"pull_force", c->pull_force, 1e-3, 1e3},
        {"pull_time", c->pull_time, 0.0, 1e3},
        {"slip_limit", c->slip_limit, 1e-6, 1.0},
        {"strain_threshold", c->strain_threshold, 0.0, 1.0},
        {"idle_speed", c->idle_speed, 0.0, 1.0},
        {"idle_release", c->idle_release, c->idle_speed, 1.0},
        {"max_time", c->max_time, 1e-3, 1e6},
        {"weight_deviation", c->weight_deviation, 0.0, 1e6},
        {"weight_gap", c->weight_gap, 0.0, 1e6},
        {"weight_tightness", c->weight_tightness, 0.0, 1e6},
        {"weight_throw", c->weight_throw, 0.0, 1e6},
        {"weight_granny", c->weight_granny, 0.0, 1e6},
        {"weight_attempt", c->weight_attempt, 0.0, 1e6},
        {"weight_drop", c->weight_drop, 0.0, 1e6},
        {"weight_transfer", c->weight_transfer, 0.0, 1e6},
        {"weight_host", c->weight_host, 0.0, 1e6},
        {"max_speed", c->max_speed, 0.0, 1e6},
        {"lost_share", c->lost_share, 0.0, 1.0},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    return VBSS_OK;
}

vbss_result vbss_metrics_read_config(vbss_context *context, const vbss_metrics_config *config,
                                     vbss_metrics_config *own)
{
    if (config == NULL) {
        *own = defaults;
        return VBSS_OK;
    }
    VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    return check_config(context, own);
}
