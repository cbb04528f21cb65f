/* A shaft that goes through a trocar: what it is told is turned until it does. */
#include "grasper/grasper.h"

/* A tip that is in its trocar, m: there is no way from one to the other. */
#define IN_THE_TROCAR 1e-12

bool vbss_grasper_through_trocar(const grasper_object *g, pose told, pose *target)
{
    *target = told;
    if (g->config.has_trocar == 0) {
        return true;
    }
    vec3 way = vec3_sub(vec3_load(g->config.trocar), told.position);
    double far = vec3_norm(way);
    double aside = vbss_grasper_bend_point(g).y, reach = fabs(aside);
    if (!(far > reach * (1.0 + 1e-9)) || !(far > IN_THE_TROCAR)) {
        return false;
    }
    /* Bent jaws put the shaft's axis beside the tip: where on it, that far from the tip, the trocar is. */
    double along = sqrt((far - reach) * (far + reach));
    vec3 own = vec3_scale(vec3_make(0.0, aside, along), 1.0 / far);
    way = vec3_scale(way, 1.0 / far);
    /* Twice: between nearly opposite directions the first turn is not good to rounding. */
    for (int i = 0; i < 2; i++) {
        vec3 is = quat_rotate(target->orientation, own);
        target->orientation = quat_unit(quat_mul(quat_between(is, way), target->orientation));
    }
    return true;
}
