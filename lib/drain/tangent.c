/* Modified Newton method: the matrix of a drain is that of an earlier shape, until a node is too far from it. Only the
 * forces are always those of the present shape.
 *
 * Which shape is part of the state. Whether a system still has its factor is not: a drain that was restored assembles
 * the matrix again, to the same bits. */
#include "drain/drain.h"

#include <string.h>

static void go_to(drain_object *d, uint32_t tangent)
{
    d->factored_in = d->attempt_tangent == tangent ? d->factored_in : NULL;
    d->attempt_tangent = tangent;
}

void vbss_drain_begin_tangent(drain_object *d)
{
    go_to(d, d->tangent);
}

static bool is_near(const drain_object *d, const vec3 *shape, double distance)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        largest = vbss_max_or_nan(vec3_norm_squared(vec3_sub(d->trial[i], shape[i])), largest);
    }
    return largest <= distance * distance;
}

/* One that neither the state nor the checkpoint needs. */
static uint32_t find_free(const drain_object *d)
{
    uint32_t free = 0;
    while (free == d->tangent || free == d->saved_tangent) {
        free++;
    }
    return free;
}

void vbss_drain_choose_tangent(drain_object *d, double h, double distance)
{
    const drain_tangent *now = &d->tangents[d->attempt_tangent];
    d->keeps_tangent = now->h == h && is_near(d, now->shape, distance);
    if (d->keeps_tangent) {
        return;
    }
    d->attempt_tangent = find_free(d);
    d->factored_in = NULL;
    drain_tangent *next = &d->tangents[d->attempt_tangent];
    next->h = h;
    memcpy(next->shape, d->trial, d->mesh.node_count * sizeof *d->trial);
    d->statistics.matrices++;
}

void vbss_drain_commit_tangent(drain_object *d)
{
    d->tangent = d->attempt_tangent;
}

void vbss_drain_checkpoint_tangent(drain_object *d)
{
    d->saved_tangent = d->tangent;
}

void vbss_drain_rollback_tangent(drain_object *d)
{
    d->tangent = d->saved_tangent;
    go_to(d, d->tangent);
}

void vbss_drain_drop_tangent(drain_object *d)
{
    d->factored_in = NULL;
    for (int i = 0; i < DRAIN_TANGENTS; i++) {
        d->tangents[i].h = 0.0;
    }
}
