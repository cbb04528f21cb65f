#include "scripted/pull.h"

#include <math.h>

#include "base/error.h"

vbss_result scripted_take(scripted_pull *p, vbss_thread *thread, uint32_t node, double stiffness)
{
    vbss_view x;
    vbss_thread_attachment hand;
    VBSS_TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x));
    VBSS_TRY(vbss_thread_attachment_init(&hand, sizeof hand));
    hand.kind = VBSS_THREAD_ATTACHMENT_SPRING;
    hand.node = p->node = node;
    hand.stiffness = p->stiffness = stiffness;
    hand.damping = 0.1;
    p->hand = vec3_load((const double *)x.data + 3 * (size_t)node);
    vec3_store(hand.position, p->hand);
    return vbss_thread_attach(thread, &hand, &p->attachment);
}

vbss_result scripted_pull_toward(scripted_pull *p, vbss_thread *thread, vec3 goal, double wanted,
                                 double distance)
{
    vbss_thread_reaction reaction;
    VBSS_TRY(vbss_thread_get_reaction(thread, p->attachment, &reaction, sizeof reaction));
    p->force = vec3_norm(vec3_load(reaction.force));
    const double lacking = 1.0 - p->force / wanted;
    const vec3 direction = vec3_unit_or(vec3_sub(goal, p->hand), vec3_zero());
    const double step = distance * fmax(-1.0, fmin(1.0, 4.0 * lacking));
    p->hand = vec3_add_scaled(p->hand, step, direction);
    double target[3];
    vec3_store(target, p->hand);
    return vbss_thread_set_attachment_target(thread, p->attachment, target, NULL);
}

vbss_result scripted_release(scripted_pull *p, vbss_thread *thread)
{
    const uint32_t attachment = p->attachment;
    *p = (scripted_pull){0};
    return attachment != 0 ? vbss_thread_detach(thread, attachment) : VBSS_OK;
}
