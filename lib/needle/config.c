/* Configuration of a needle: defaults, presets, and range checks. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/pi.h"
#include "needle/needle.h"

_Static_assert(sizeof(vbss_needle_config) == 192, "published size");

static const vbss_needle_config defaults = {
    .struct_size = sizeof(vbss_needle_config),
    .method = VBSS_METHOD_IMPLICIT,
    .segment_count = 8,
    .radius = 10.5e-3,
    .wire_radius = 0.35e-3,
    .arc = VBSS_PI,
    .density = 7900.0,
    .friction = 0.2,
    .orientation = {1.0, 0.0, 0.0, 0.0},
};
static const uint32_t config_sizes[] = {192, 0};
static const vbss_layout config_layout = {"vbss_needle_config", &defaults, config_sizes};

vbss_result vbss_needle_config_init(vbss_needle_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

vbss_result vbss_needle_config_preset(vbss_needle_config *config, vbss_needle_preset preset)
{
    VBSS_ENTER(NULL);
    vbss_needle_config own; /* only for the check of struct_size */
    VBSS_TRY(vbss_config_read(NULL, &config_layout, config, &own));
    if (preset != VBSS_NEEDLE_PRESET_VBLAST && preset != VBSS_NEEDLE_PRESET_SH) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    config->radius = preset == VBSS_NEEDLE_PRESET_SH ? 8.28e-3 : defaults.radius;
    config->wire_radius = defaults.wire_radius;
    config->arc = defaults.arc;
    return VBSS_OK;
}

vbss_result vbss_needle_config_shape(vbss_needle_config *config, double circle, double length,
                                     double wire_diameter)
{
    VBSS_ENTER(NULL);
    vbss_needle_config own; /* only for the check of struct_size */
    VBSS_TRY(vbss_config_read(NULL, &config_layout, config, &own));
    VBSS_TRY(vbss_check_range(NULL, circle, 0.05, 0.9, "circle"));
    VBSS_TRY(vbss_check_range(NULL, length, 1e-3, 1.0, "length"));
    double arc = 2.0 * VBSS_PI * circle, radius = length / arc;
    VBSS_TRY(vbss_check_range(NULL, wire_diameter, 1e-5, 0.4 * radius, "wire_diameter"));
    config->radius = radius;
    config->wire_radius = 0.5 * wire_diameter;
    config->arc = arc;
    return VBSS_OK;
}

static vbss_result check(vbss_context *context, const vbss_needle_config *c)
{
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"method", c->method, VBSS_METHOD_IMPLICIT, VBSS_METHOD_VBLAST},
        {"segment_count", c->segment_count, 2.0, NEEDLE_MAX_SEGMENTS},
        {"reserved", c->reserved, 0.0, 0.0},
        {"radius", c->radius, 1e-4, 1.0},
        {"wire_radius", c->wire_radius, 1e-6, 0.2 * c->radius},
        {"arc", c->arc, 0.1, 6.0},
        {"density", c->density, 1.0, 1e5},
        {"friction", c->friction, 0.0, 10.0},
        {"drag", c->drag, 0.0, 1e6},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    VBSS_TRY(vbss_check_vector(context, c->gravity, 1e6, "gravity"));
    VBSS_TRY(vbss_check_vector(context, c->position, 1e3, "position"));
    VBSS_TRY(vbss_check_vector(context, c->velocity, 1e5, "velocity"));
    return vbss_check_vector(context, c->angular_velocity, 1e6, "angular_velocity");
}

vbss_result vbss_needle_read_config(vbss_context *context, const vbss_needle_config *config,
                                    vbss_needle_config *own)
{
    if (config == NULL) {
        *own = defaults;
        return VBSS_OK;
    }
    VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    return check(context, own);
}
