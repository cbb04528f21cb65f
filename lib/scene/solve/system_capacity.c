/* Capacity of the linear system of a scene, from its configuration and its drains. */
#include "base/error.h"
#include "base/memory.h"
#include "scene/solve/solve.h"
#include "scene/tuning.h"
#include "scene/world/world.h"
#include "thread/twist.h"

static uint32_t smaller(uint64_t a, uint64_t b)
{
    return (uint32_t)(a < b ? a : b);
}

/* Capacity for threads and rigid bodies of `n` blocks, but no more than if all blocks were coupled
 * with each other. */
static vbss_system_capacity base_capacity(const scene_object *s, uint32_t n)
{
    vbss_system_capacity c = vbss_system_capacity_of_chains(n, THREAD_BANDWIDTH, n, 0);
    const uint64_t all = (uint64_t)n * (n > 0 ? n - 1 : 0) / 2;
    const uint64_t matrix = s->config.matrix_capacity > 0
                                ? s->config.matrix_capacity
                                : SCENE_MATRIX_BASE + (uint64_t)SCENE_MATRIX_PER_BLOCK * n;
    c.pairs = smaller(all, matrix / SCENE_MATRIX_PER_PAIR);
    c.factor = smaller(all, matrix / SCENE_MATRIX_PER_FACTOR_PAIR);
    c.arena = smaller(7 * all + 2 * (uint64_t)n + 1, matrix);
    return c;
}

static void add_capacity(vbss_system_capacity *capacity, const drain_object *d)
{
    uint32_t n = d->mesh.node_count;
    uint64_t all = (uint64_t)n * (n - 1) / 2;
    uint32_t pairs = smaller(all, (uint64_t)SCENE_PAIRS_PER_DRAIN_NODE * n);
    capacity->blocks += n;
    capacity->couplings += d->order.pair_count;
    capacity->entries += SCENE_FILL_IN_ENTRY_RATIO * d->order.factor_entries;
    capacity->products += SCENE_FILL_IN_PRODUCT_RATIO * d->order.factor_products;
    capacity->separators += n;
    capacity->pairs += pairs;
    capacity->factor += pairs;
    capacity->arena += SCENE_MATRIX_PER_DRAIN_ENTRY * d->order.factor_entries;
}

uint32_t vbss_scene_surface_blocks(const scene_host_surface *h)
{
    return scene_is_compliant(h) ? smaller(h->vertex_count, SCENE_MAX_TOUCHED_VERTICES) : 0;
}

vbss_result vbss_scene_create_system(scene_object *s, const drain_object *added,
                                     uint32_t added_blocks)
{
    uint32_t blocks = s->node_capacity + 2 * s->config.rigid_capacity + added_blocks;
    if (s->step.spring_capacity > 0) { /* rolls of threads with friction torque */
        blocks += s->node_capacity / SCENE_ROLLS_PER_BLOCK + s->body_capacity;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        blocks += vbss_scene_surface_blocks(scene_host_surface_of(&s->bodies[i]));
    }
    vbss_system_capacity capacity = base_capacity(s, blocks);
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

vbss_result vbss_scene_reserve_rolls(scene_object *s, const thread_object *t)
{
    if (!thread_has_friction_torque(t) || s->step.spring_capacity > 0) {
        return VBSS_OK;
    }
    const uint32_t capacity = 2 * s->node_capacity; /* a roll ends two spans */
    s->step.springs = vbss_allocate(s->context, capacity, sizeof *s->step.springs, "scene");
    if (s->step.springs == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->step.spring_capacity = capacity;
    const vbss_result result = vbss_scene_create_system(s, NULL, 0);
    if (result != VBSS_OK) {
        vbss_release(s->context, s->step.springs, capacity, sizeof *s->step.springs);
        s->step.springs = NULL;
        s->step.spring_capacity = 0;
    }
    return result;
}
