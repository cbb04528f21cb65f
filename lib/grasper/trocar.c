/* Rotation of a commanded pose so that the shaft passes through the trocar. */
#include "grasper/grasper.h"
#include "grasper/tuning.h"

bool vbss_grasper_apply_trocar(const grasper_object *g, pose commanded, pose *target)
{
    *target = commanded;
    if (g->config.has_trocar == 0) {
        return true;
    }
    vec3 direction = vec3_sub(vec3_load(g->config.trocar), commanded.position);
    double distance = vec3_norm(direction);
    double min_distance = GRASPER_MIN_TROCAR_RATIO * vbss_grasper_current_jaws(g)->length;
    double aside = vbss_grasper_bend_point(g).y, reach = fabs(aside);
    if (!(distance > reach * (1.0 + 1e-9)) || !(distance > min_distance)) {
        return false;
    }
    /* Bent jaws put the axis of the shaft beside the tip. This is the point of the axis at the
     * trocar's distance from the tip. */
    double along = sqrt((distance - reach) * (distance + reach));
    vec3 trocar_in_tool = vec3_scale(vec3_make(0.0, aside, along), 1.0 / distance);
    direction = vec3_scale(direction, 1.0 / distance);
    /* The second pass corrects the rounding error of a rotation between nearly opposite
     * directions. */
    for (int i = 0; i < 2; i++) {
        vec3 current = quat_rotate(target->orientation, trocar_in_tool);
        target->orientation =
            quat_unit(quat_mul(quat_between(current, direction), target->orientation));
    }
    return true;
}
