/* Configuration of visuals: defaults and range checks. */
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "visual/visual.h"

_Static_assert(sizeof(vbss_visual_config) == 104, "published size");

static const vbss_visual_config defaults = {
    .struct_size = sizeof(vbss_visual_config),
    .source_capacity = 8,
    .part_capacity = 32,
    .vertex_capacity = 65536,
    .triangle_capacity = 131072,
    .spot_capacity = 32,
    .node_capacity = 4096,
    .side_limit = 32,
    .division_limit = 12,
    .tube_tolerance = 5e-6,
    .surface_tolerance = 2e-5,
    .mark_radius = 1e-3,
    .tip_length = 4e-3,
    .floor_size = 0.3,
};
static const uint32_t config_sizes[] = {104, 0};
static const vbss_layout config_layout = {"vbss_visual_config", &defaults, config_sizes};

vbss_result vbss_visual_config_init(vbss_visual_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

static vbss_result check(vbss_context *context, const vbss_visual_config *c)
{
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"source_capacity", c->source_capacity, 1.0, 256.0},
        {"part_capacity", c->part_capacity, 1.0, 4096.0},
        {"vertex_capacity", c->vertex_capacity, 16.0, 16777216.0},
        {"triangle_capacity", c->triangle_capacity, 16.0, 16777216.0},
        {"spot_capacity", c->spot_capacity, 0.0, 4096.0},
        {"node_capacity", c->node_capacity, 2.0, 65537.0},
        {"side_limit", c->side_limit, 6.0, VISUAL_MAX_SIDES},
        {"division_limit", c->division_limit, 1.0, 32.0},
        {"reserved", c->reserved, 0.0, 0.0},
        {"tube_tolerance", c->tube_tolerance, 1e-8, 1.0},
        {"surface_tolerance", c->surface_tolerance, 1e-8, 1.0},
        {"mark_radius", c->mark_radius, 0.0, 0.1},
        {"tip_length", c->tip_length, 0.0, 1.0},
        {"floor_size", c->floor_size, 1e-3, 1e3},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    return vbss_check_vector(context, c->origin, 1e3, "origin");
}

vbss_result vbss_visual_read_config(vbss_context *context, const vbss_visual_config *config,
                                    vbss_visual_config *own)
{
    if (config == NULL) {
        *own = defaults;
        return VBSS_OK;
    }
    VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    return check(context, own);
}
