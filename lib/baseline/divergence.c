/* Divergence of the explicit method: too few substeps, or springs that are too stiff for them, let
 * a motion grow by a factor in each substep. The bound is relative, so it holds for any unit of
 * length. It is so wide that a thread that is pulled beyond its length for a while stays within. */
#include "baseline/divergence.h"

#include "base/error.h"
#include "base/number_text.h"
#include "baseline/drain.h"
#include "thread/tuning.h"

/* A sum is finite only if all its terms are. The limit keeps products of coordinates finite. */
static bool is_finite(const vec3 *x, const vec3 *v, uint32_t count)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        sum += vec3_norm_squared(x[i]) + vec3_norm_squared(v[i]);
    }
    return sum < 1e50;
}

static vbss_result fail_divergence(vbss_context *context, const char *distance, double value,
                                   double limit)
{
    return vbss_fail(context, VBSS_ERROR_NOT_FINITE,
                     "the explicit method has diverged: %s is %s m, the limit is %s m", distance,
                     VBSS_NUMBER(value), VBSS_NUMBER(limit));
}

static vec3 smaller(vec3 a, vec3 b)
{
    return vec3_make(vbss_min(a.x, b.x), vbss_min(a.y, b.y), vbss_min(a.z, b.z));
}

static vec3 larger(vec3 a, vec3 b)
{
    return vec3_make(vbss_max(a.x, b.x), vbss_max(a.y, b.y), vbss_max(a.z, b.z));
}

/* Returns the diagonal of the box around all points that attachments pull nodes to. */
static double attachment_span(const thread_object *t)
{
    vec3 low = vec3_zero(), high = vec3_zero();
    bool any = false;
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        bool has_point = a->kind == VBSS_THREAD_ATTACHMENT_PIN ||
                         a->kind == VBSS_THREAD_ATTACHMENT_CLAMP ||
                         a->kind == VBSS_THREAD_ATTACHMENT_SPRING;
        if (a->id != 0 && has_point) {
            low = smaller(any ? low : a->position, smaller(a->position, a->target));
            high = larger(any ? high : a->position, larger(a->position, a->target));
            any = true;
        }
    }
    return vec3_distance(low, high);
}

vbss_result vbss_baseline_check_thread(const thread_object *t)
{
    if (!is_finite(t->now.x, t->now.v, t->node_count)) {
        return vbss_fail(t->context, VBSS_ERROR_NOT_FINITE,
                         "the explicit method has diverged: the state is not finite");
    }
    double rest_length = 0.0, longest = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        rest_length += t->rest[i];
        longest = vbss_max(longest, vec3_distance(t->now.x[i + 1], t->now.x[i]));
    }
    double limit = BASELINE_DIVERGENCE_RATIO * (rest_length + attachment_span(t));
    return longest <= limit ? VBSS_OK
                            : fail_divergence(t->context, "a segment's length", longest, limit);
}

vbss_result vbss_baseline_check_drain(const drain_object *d)
{
    const vec3 *rest = d->baseline->rest;
    if (!is_finite(d->x, d->v, d->mesh.node_count)) {
        return vbss_fail(d->context, VBSS_ERROR_NOT_FINITE,
                         "the explicit method has diverged: the state is not finite");
    }
    double farthest = 0.0, attached = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        farthest = vbss_max(farthest, vec3_distance(d->x[i], rest[i]));
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind != VBSS_DRAIN_ATTACHMENT_FORCE) {
            attached = vbss_max(attached, vec3_distance(a->position, rest[a->node]));
            attached = vbss_max(attached, vec3_distance(a->target, rest[a->node]));
        }
    }
    double limit = BASELINE_DIVERGENCE_RATIO * (d->config.length + attached);
    return farthest <= limit
               ? VBSS_OK
               : fail_divergence(d->context, "a node's distance from rest", farthest, limit);
}
