/* Capacity of the linear system of a scene, from its configuration and its drains. */
#include "base/error.h"
#include "scene/solve/solve.h"
#include "scene/tuning.h"

static void add_capacity(vbss_system_capacity *capacity, const drain_object *d)
{
    uint32_t n = d->mesh.node_count, all = n * (n - 1) / 2,
             max_pairs = SCENE_PAIRS_PER_DRAIN_NODE * n;
    capacity->blocks += n;
    capacity->couplings += d->order.pair_count;
    capacity->entries += SCENE_FILL_IN_ENTRY_RATIO * d->order.factor_entries;
    capacity->products += SCENE_FILL_IN_PRODUCT_RATIO * d->order.factor_products;
    capacity->separators += n;
    capacity->pairs += all < max_pairs ? all : max_pairs;
}

vbss_result vbss_scene_create_system(scene_object *s, const drain_object *added)
{
    uint32_t blocks = s->node_capacity + 2 * s->config.rigid_capacity;
    vbss_system_capacity capacity = vbss_system_capacity_of_chains(
        blocks, THREAD_BANDWIDTH, blocks, SCENE_PAIRS_PER_SEPARATOR * blocks);
    vbss_system *new_system;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            add_capacity(&capacity, s->bodies[i].drain.drain);
        }
    }
    if (added != NULL) {
        add_capacity(&capacity, added);
    }
    VBSS_TRY(vbss_system_create_with_capacity(s->context, &capacity, &new_system));
    vbss_system_destroy(s->context, s->system);
    s->system = new_system;
    s->step.pattern_hash = 0;
    return VBSS_OK;
}
