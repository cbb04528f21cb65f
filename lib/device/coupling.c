/* A virtual coupling: a spring and a damper between the hand and the tool. */
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_device_coupling) == 96, "published size");

static const vbss_device_coupling coupling_defaults = {.struct_size = sizeof(vbss_device_coupling)};
static const uint32_t coupling_sizes[] = {96, 0};
const vbss_layout vbss_device_coupling_layout = {"vbss_device_coupling", &coupling_defaults,
                                                 coupling_sizes};

vbss_result vbss_device_coupling_init(vbss_device_coupling *coupling, uint32_t struct_size)
{
    return vbss_config_init(&vbss_device_coupling_layout, coupling, struct_size);
}

vbss_result vbss_device_check_coupling(vbss_context *context, const vbss_device_coupling *c)
{
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_vector(context, c->position, 1e3, "position"));
    VBSS_TRY(vbss_check_vector(context, c->velocity, 1e3, "velocity"));
    VBSS_TRY(vbss_check_vector(context, c->force, 1e3, "force"));
    VBSS_TRY(vbss_check_range(context, c->stiffness, 0.0, 1e6, "stiffness"));
    return vbss_check_range(context, c->damping, 0.0, 1e6, "damping");
}

vec3 vbss_device_coupling_force(const vbss_device_coupling *c, vec3 position, vec3 velocity)
{
    vec3 offset = vec3_sub(vec3_load(c->position), position);
    vec3 relative_velocity = vec3_sub(vec3_load(c->velocity), velocity);
    vec3 spring = vec3_add_scaled(vec3_load(c->force), c->stiffness, offset);
    return vec3_add_scaled(spring, c->damping, relative_velocity);
}
