/* Contact filters: which bodies collide. The rule is that of Box2D: two bodies collide if each
 * has a category that the other's mask contains. */
#include "scene/world/world.h"

scene_filter vbss_scene_default_filter(void)
{
    return (scene_filter){.category = 1u, .mask = UINT32_MAX};
}

scene_settings vbss_scene_created_settings(const scene_object *s)
{
    return (scene_settings){.floor_friction = s->config.floor_friction,
                            .thread_friction = s->config.thread_friction,
                            .speed_limit = s->config.speed_limit,
                            .step_budget = (uint32_t)vbss_scene_count_operations(
                                s->solver.step_budget_us, s->solver.operations_per_us),
                            .call_budget = (uint32_t)vbss_scene_count_operations(
                                s->solver.call_budget_us, s->solver.operations_per_us),
                            .floor_filter = vbss_scene_default_filter()};
}

const scene_filter *vbss_scene_filter_of(const scene_object *s, const scene_body *b)
{
    return b == NULL ? &s->settings.floor_filter : &b->filter;
}

bool vbss_scene_do_collide(const scene_object *s, const scene_body *a, const scene_body *b)
{
    const scene_filter *f = vbss_scene_filter_of(s, a), *g = vbss_scene_filter_of(s, b);
    return a == b || ((f->category & g->mask) != 0 && (g->category & f->mask) != 0);
}

/* Candidates of the same two shapes follow each other. */
void vbss_scene_filter_candidates(scene_object *s)
{
    collision_object *c = s->collision;
    uint32_t count = 0, shape_a = UINT32_MAX, shape_b = UINT32_MAX;
    bool do_collide = false;
    for (uint32_t i = 0; i < c->candidate_count; i++) {
        const collision_candidate *q = &c->candidates[i];
        if (q->shape_a != shape_a || q->shape_b != shape_b) {
            shape_a = q->shape_a;
            shape_b = q->shape_b;
            do_collide = vbss_scene_do_collide(s, &s->bodies[s->body_of_shape[shape_a]],
                                               &s->bodies[s->body_of_shape[shape_b]]);
        }
        if (do_collide) {
            c->candidates[count++] = *q;
        }
    }
    c->candidate_count = count;
}
