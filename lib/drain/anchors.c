/* What holds a drain on its block: the nodes of its bottom strip do not move until they tear off, for ever. */
#include "drain/drain.h"

#include <string.h>

void vbss_drain_find_anchored(drain_object *d)
{
    memset(d->anchored, 0, d->mesh.node_count);
    for (uint32_t i = 0; i < d->mesh.fixed_count; i++) {
        d->anchored[d->mesh.fixed[i]] = !d->torn[i];
    }
}

/* What does not move is in balance. */
vec3 vbss_drain_anchor_force(const drain_object *d, uint32_t anchor, const vec3 *forces)
{
    uint32_t node = d->mesh.fixed[anchor];
    if (d->torn[anchor]) {
        return vec3_zero();
    }
    return vec3_neg(vec3_add_scaled(forces[node], d->mass[node], d->gravity));
}

/* One a step: its neighbours take over what it bore, and whether they bear that is known only then. */
void vbss_drain_tear(drain_object *d, const vec3 *forces)
{
    uint32_t worst = UINT32_MAX;
    double most = 1.0;
    for (uint32_t i = 0; i < d->mesh.fixed_count; i++) {
        double load = vec3_norm(vbss_drain_anchor_force(d, i, forces)) / d->strength[i];
        if (load > most) {
            most = load;
            worst = i;
        }
    }
    if (worst != UINT32_MAX) {
        d->torn[worst] = 1;
        d->statistics.torn++;
        d->pattern_known = false;
        vbss_drain_find_anchored(d);
    }
}
