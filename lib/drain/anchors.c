/* Anchors: nodes of the bottom strip that are fixed to the block until they tear off. */
#include "drain/drain.h"

#include <string.h>

void vbss_drain_update_anchored(drain_object *d)
{
    memset(d->anchored, 0, d->mesh.node_count);
    for (uint32_t i = 0; i < d->mesh.anchor_count; i++) {
        d->anchored[d->mesh.anchors[i]] = !d->torn[i];
    }
}

/* An anchored node is in static balance. */
vec3 vbss_drain_anchor_force(const drain_object *d, uint32_t anchor, const vec3 *forces)
{
    uint32_t node = d->mesh.anchors[anchor];
    if (d->torn[anchor]) {
        return vec3_zero();
    }
    return vec3_neg(vec3_add_scaled(forces[node], d->mass[node], d->gravity));
}

/* At most one anchor tears in a step. Its neighbours take over its load, and only the next step
 * shows whether they hold. */
void vbss_drain_tear_anchor(drain_object *d, const vec3 *forces)
{
    uint32_t worst = UINT32_MAX;
    d->anchor_load = 0.0;
    for (uint32_t i = 0; i < d->mesh.anchor_count; i++) {
        double load = vec3_norm(vbss_drain_anchor_force(d, i, forces)) / d->anchor_strength[i];
        if (load > d->anchor_load) {
            d->anchor_load = load;
            worst = i;
        }
    }
    if (d->anchor_load > 1.0) {
        d->torn[worst] = 1;
        d->statistics.torn++;
        d->is_sparsity_valid = false;
        vbss_drain_drop_tangent(d);
        vbss_drain_update_anchored(d);
    }
}
