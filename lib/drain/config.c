/* Configuration of a drain: defaults and checks. */
#include "base/baseline_config.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "drain/surface.h"

/* Size up to `surface`, and up to `tear_energy`. */
#define FIRST_SIZE VBSS_SIZE_WITH_SPLIT_POINTERS(vbss_drain_config, 280u)
#define SIZE (FIRST_SIZE + (uint32_t)sizeof(double))
_Static_assert(sizeof(vbss_drain_config) == SIZE, "published size");

static const vbss_drain_config defaults = {
    .struct_size = sizeof(vbss_drain_config),
    .method = VBSS_METHOD_IMPLICIT,
    .mesh = VBSS_DRAIN_MESH_137,
    .mesh_divisions = 1,
    .attachment_capacity = 8,
    .iteration_limit = 1,
    .halving_limit = 4,
    .radius = 6.5e-3,
    .length = 32e-3,
    .thickness = 1e-3,
    .slit_length = 10e-3,
    .slit_opening = 3e-3,
    .mark_arc = 4.5e-3,
    .young_modulus = 1.2e6,
    .poisson_ratio = 0.47,
    .density = 950.0,
    .drag = 20.0,
    .orientation = {1.0, 0.0, 0.0, 0.0},
    .tear_stress = 5e4,
    .position_tolerance = 1e-6,
    .move_limit = 1e-3,
    .friction = 0.3,
    .puncture_force = 1.0,
    .hole_force = 0.25,
    .hole_friction = 0.3,
    .hole_stiffness = 2e4,
    .hole_damping = 0.05,
    .tip_length = 0.5e-3,
    .thread_force = 0.02,
};
static const uint32_t config_sizes[] = {FIRST_SIZE, SIZE, 0};
static const vbss_layout config_layout = {"vbss_drain_config", &defaults, config_sizes};

vbss_result vbss_drain_config_init(vbss_drain_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

drain_mesh_options vbss_drain_mesh_options_of(const vbss_drain_config *c, drain_mesh_kind kind)
{
    const drain_mesh_options options = {.kind = kind,
                                        .divisions = c->mesh_divisions,
                                        .radius = c->radius,
                                        .length = c->length,
                                        .slit_length = c->slit_length,
                                        .opening = c->slit_opening,
                                        .mark_arc = c->mark_arc,
                                        .surface = c->surface};
    return options;
}

static vbss_result check(vbss_context *context, const vbss_drain_config *c)
{
    const bool is_tube = c->surface == NULL;
    const double low = is_tube ? 0.01 * c->radius : 1e-6, high = is_tube ? 0.3 * c->radius : 0.1;
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"method", c->method, VBSS_METHOD_IMPLICIT, VBSS_METHOD_VBLAST},
        {"mesh", c->mesh, VBSS_DRAIN_MESH_137, VBSS_DRAIN_MESH_225},
        {"mesh_divisions", c->mesh_divisions, 1.0, 4.0},
        {"attachment_capacity", c->attachment_capacity, 0.0, 256.0},
        {"iteration_limit", c->iteration_limit, 1.0, 50.0},
        {"halving_limit", c->halving_limit, 0.0, 10.0},
        {"reserved", c->reserved, 0.0, 0.0},
        {"radius", c->radius, 1e-4, 1.0},
        {"thickness", c->thickness, low, high},
        {"young_modulus", c->young_modulus, 1e3, 1e12},
        {"poisson_ratio", c->poisson_ratio, 0.0, 0.49},
        {"density", c->density, 1.0, 1e5},
        {"drag", c->drag, 0.0, 1e6},
        {"tear_stress", c->tear_stress, 1.0, 1e12},
        {"position_tolerance", c->position_tolerance, 1e-15, 1.0},
        {"move_limit", c->move_limit, 1e-9, 1.0},
        {"friction", c->friction, 0.0, 10.0},
        {"puncture_force", c->puncture_force, 1e-3, 1e3},
        {"hole_force", c->hole_force, 1e-6, 1e3},
        {"hole_friction", c->hole_friction, 0.0, 10.0},
        {"hole_stiffness", c->hole_stiffness, 1.0, 1e7},
        {"hole_damping", c->hole_damping, 0.0, 1e3},
        {"tip_length", c->tip_length, 0.0, 0.1},
        {"thread_force", c->thread_force, 1e-6, 1e3},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    if (c->tear_energy != 0.0) {
        VBSS_TRY(vbss_check_range(context, c->tear_energy, 1.0, 1e7, "tear_energy"));
    }
    VBSS_TRY(vbss_check_finite(context, c->gravity, 3, "gravity"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->gravity, 3), 0.0, 1e6, "gravity"));
    VBSS_TRY(vbss_check_finite(context, c->position, 3, "position"));
    return vbss_check_range(context, vbss_max_abs(c->position, 3), 0.0, 1e3, "position");
}

vbss_result vbss_drain_read_config(vbss_context *context, const vbss_drain_config *config,
                                   vbss_drain_config *own, vbss_baseline_config *baseline,
                                   vbss_drain_surface *surface)
{
    *own = defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    }
    VBSS_TRY(vbss_baseline_read_config(context, &own->baseline, baseline));
    VBSS_TRY(check(context, own));
    if (own->surface == NULL) {
        return VBSS_OK;
    }
    if (own->method != VBSS_METHOD_IMPLICIT) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "method VBLAST has a drain of its own and takes no surface");
    }
    VBSS_TRY(vbss_drain_read_surface(context, own->surface, surface));
    own->surface = surface;
    return VBSS_OK;
}
