/* Configuration of a grasper: defaults, presets, and range checks. */
#include "base/api_call.h"
#include "base/baseline_config.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "grasper/grasper.h"

_Static_assert(sizeof(vbss_grasper_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_grasper_config, 304u, 1u),
               "published size");

static const vbss_grasper_config defaults = {
    .struct_size = sizeof(vbss_grasper_config),
    .method = VBSS_METHOD_IMPLICIT,
    .kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER,
    .driver_length = 13e-3,
    .driver_radius = 0.5e-3,
    .driver_opening = 0.35,
    .shears_length = 15e-3,
    .shears_radius = 0.5e-3,
    .shears_opening = 0.35,
    .neck_radius = 1.2e-3,
    .shaft_length = 0.15,
    .shaft_radius = 2.5e-3,
    .friction = 0.15,
    .closing_force = 8.0,
    .closing_angle = 0.1,
    .jaw_speed = 8.0,
    .grip_friction = 0.5,
    .grip_length = 1e-3,
    .grip_stiffness = 3000.0,
    .mass = 0.02,
    .stiffness = 400.0,
    .damping = 5.0,
    .turning_stiffness = 5.0,
    .turning_damping = 0.05,
    .needle_stiffness = 3e4,
    .needle_turning_stiffness = 0.5,
    .needle_torque = 0.03,
    .solenoid_opening = 0.2,
};
static const uint32_t config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_grasper_config, 304u, 1u), 0};
static const vbss_layout config_layout = {"vbss_grasper_config", &defaults, config_sizes};

vbss_result vbss_grasper_config_init(vbss_grasper_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

vbss_result vbss_grasper_config_preset(vbss_grasper_config *config, vbss_grasper_preset preset)
{
    VBSS_ENTER(NULL);
    vbss_grasper_config own; /* only for the check of struct_size */
    VBSS_TRY(vbss_config_read(NULL, &config_layout, config, &own));
    if (preset != VBSS_GRASPER_PRESET_STRAIGHT && preset != VBSS_GRASPER_PRESET_ANGLED) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    bool angled = preset == VBSS_GRASPER_PRESET_ANGLED;
    config->driver_length = defaults.driver_length;
    config->driver_radius = defaults.driver_radius;
    config->driver_opening = defaults.driver_opening;
    config->driver_bend = angled ? 0.8 : 0.0;
    config->driver_neck = angled ? 5e-3 : 0.0;
    return VBSS_OK;
}

typedef struct range {
    const char *name;
    double value, low, high;
} range;

static vbss_result check(vbss_context *context, const range *ranges, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const range *r = &ranges[i];
        VBSS_TRY(vbss_check_range(context, r->value, r->low, r->high, r->name));
    }
    return VBSS_OK;
}

static vbss_result check_shape(vbss_context *context, const vbss_grasper_config *c)
{
    const range ranges[] = {
        {"method", c->method, VBSS_METHOD_IMPLICIT, VBSS_METHOD_VBLAST},
        {"kind", c->kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER, VBSS_GRASPER_KIND_SHEARS},
        {"has_trocar", c->has_trocar, 0.0, 1.0},
        {"trocar", c->trocar[0], -1e3, 1e3},
        {"trocar", c->trocar[1], -1e3, 1e3},
        {"trocar", c->trocar[2], -1e3, 1e3},
        {"driver_length", c->driver_length, 1e-4, 1.0},
        {"driver_radius", c->driver_radius, 1e-6, 0.1},
        {"driver_bend", c->driver_bend, -1.5, 1.5},
        {"driver_opening", c->driver_opening, 1e-3, 1.2},
        {"shears_length", c->shears_length, 1e-4, 1.0},
        {"shears_radius", c->shears_radius, 1e-6, 0.1},
        {"shears_bend", c->shears_bend, -1.5, 1.5},
        {"shears_opening", c->shears_opening, 1e-3, 1.2},
        {"driver_neck", c->driver_neck, 0.0, 1.0},
        {"shears_neck", c->shears_neck, 0.0, 1.0},
        {"neck_radius", c->neck_radius, 1e-6, 0.1},
        {"shaft_length", c->shaft_length, 1e-3, 10.0},
        {"shaft_radius", c->shaft_radius, 1e-6, 0.1},
    };
    VBSS_TRY(check(context, ranges, sizeof ranges / sizeof ranges[0]));
    if (c->driver_radius >= c->driver_length || c->shears_radius >= c->shears_length) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "jaws are thicker than they are long");
    }
    return VBSS_OK;
}

static vbss_result check_strength(vbss_context *context, const vbss_grasper_config *c)
{
    const range ranges[] = {
        {"friction", c->friction, 0.0, 10.0},
        {"closing_force", c->closing_force, 0.0, 1e4},
        {"closing_angle", c->closing_angle, 1e-3, 1.0},
        {"jaw_speed", c->jaw_speed, 1e-2, 1e3},
        {"grip_friction", c->grip_friction, 0.0, 10.0},
        {"grip_length", c->grip_length, 1e-5, 1e-1},
        {"grip_stiffness", c->grip_stiffness, 1.0, 1e6},
        {"mass", c->mass, 1e-4, 1e2},
        {"stiffness", c->stiffness, 0.0, 1e9},
        {"damping", c->damping, 0.0, 1e6},
        {"turning_stiffness", c->turning_stiffness, 0.0, 1e9},
        {"turning_damping", c->turning_damping, 0.0, 1e6},
        {"exchange_centre", c->exchange_centre[0], -1e3, 1e3},
        {"exchange_centre", c->exchange_centre[1], -1e3, 1e3},
        {"exchange_centre", c->exchange_centre[2], -1e3, 1e3},
        {"exchange_distance", c->exchange_distance, 0.0, 1e3},
        {"needle_stiffness", c->needle_stiffness, 1.0, 1e7},
        {"needle_turning_stiffness", c->needle_turning_stiffness, 1e-6, 1e4},
        {"needle_torque", c->needle_torque, 0.0, 1e2},
        {"solenoid_opening", c->solenoid_opening, 0.0, 1.0},
    };
    return check(context, ranges, sizeof ranges / sizeof ranges[0]);
}

vbss_result vbss_grasper_read_config(vbss_context *context, const vbss_grasper_config *config,
                                     vbss_grasper_config *own, vbss_baseline_config *baseline)
{
    *own = defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    }
    VBSS_TRY(vbss_baseline_read_config(context, &own->baseline, baseline));
    VBSS_TRY(check_shape(context, own));
    return check_strength(context, own);
}
