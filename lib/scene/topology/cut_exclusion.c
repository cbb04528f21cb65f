/* Pairs of segments next to a cut are excluded from contact until the two ends have separated. */
#include "collision/closest.h"
#include "scene/topology/topology.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* Arc length from the end of one segment to the start of the other across cuts, m. Returns -1 if
 * no cut connects them, or if it exceeds max_arc. Both parts of a divided segment count as the
 * whole segment. */
static double arc_across(const scene_object *s, const scene_body *a, uint32_t segment_a,
                         const scene_body *b, uint32_t segment_b, double max_arc)
{
    const scene_body *piece = b, *before = vbss_scene_body(s, b->thread.cut_from);
    double arc = 0.0;
    bool divided = b->thread.has_split_segment;
    for (uint32_t k = divided && before == a && segment_a + 2 == a->thread.thread->node_count ? 1
                                                                                              : 0;
         k < segment_b && arc < max_arc; k++) {
        arc += b->thread.thread->rest[k];
    }
    for (uint32_t steps = 0;
         before != NULL && before != a && arc < max_arc && steps < SCENE_MAX_THREADS; steps++) {
        const thread_object *t = before->thread.thread;
        for (uint32_t k = 0; k + 1 < t->node_count && arc < max_arc; k++) {
            arc += t->rest[k];
        }
        piece = before;
        before = vbss_scene_body(s, piece->thread.cut_from);
    }
    if (before != a) {
        return -1.0;
    }
    uint32_t end = a->thread.thread->node_count - 1;
    end -= divided && piece == b && segment_b == 0;
    for (uint32_t k = segment_a + 1; k < end && arc < max_arc; k++) {
        arc += a->thread.thread->rest[k];
    }
    return arc < max_arc ? arc : -1.0;
}

static double excluded_arc(const scene_object *s, const scene_body *a, const scene_body *b)
{
    const collision_object *c = s->collision;
    return (1.0 - SCENE_CUT_EXCLUSION_ROUNDING) * c->config.exclusion *
           vbss_collision_contact_distance(c, c->shapes[a->shape], c->shapes[b->shape]);
}

bool vbss_scene_is_excluded_across_cut(const scene_object *s, const scene_body *a,
                                       uint32_t segment_a, const scene_body *b, uint32_t segment_b)
{
    if (a == b || (a->thread.cut_from == 0 && b->thread.cut_from == 0)) {
        return false;
    }
    double max_arc = excluded_arc(s, a, b);
    return arc_across(s, a, segment_a, b, segment_b, max_arc) >= 0.0 ||
           arc_across(s, b, segment_b, a, segment_a, max_arc) >= 0.0;
}

static double segment_distance(const thread_object *t, uint32_t i, const thread_object *u,
                               uint32_t k)
{
    const vec3 *x = t->now.x + i, *y = u->now.x + k;
    double at[2];
    return vec3_norm(closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(y[1], y[0]),
                                           vec3_sub(y[0], x[0]), &at[0], &at[1]));
}

/* Whether a segment of `b` is nearer than the contact distance to one of `a` that is excluded
 * across the cut. */
static bool do_ends_overlap(const scene_object *s, const scene_body *a, const scene_body *b)
{
    const thread_object *t = a->thread.thread, *u = b->thread.thread;
    double contact_distance = t->config.radius + u->config.radius;
    for (uint32_t k = 0; k + 1 < u->node_count; k++) {
        uint32_t i = t->node_count - 1, first = i;
        while (i > 0 && vbss_scene_is_excluded_across_cut(s, a, i - 1, b, k)) {
            i--;
            if (segment_distance(t, i, u, k) < contact_distance) {
                return true;
            }
        }
        if (i == first) {
            return false; /* later segments are farther away still */
        }
    }
    return false;
}

void vbss_scene_update_cut_exclusions(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_THREAD || b->thread.cut_from == 0) {
            continue;
        }
        const scene_body *before = vbss_scene_body(s, b->thread.cut_from);
        bool apart = true;
        for (uint32_t steps = 0; apart && before != NULL && steps < SCENE_MAX_THREADS; steps++) {
            apart = !do_ends_overlap(s, before, b);
            before = vbss_scene_body(s, before->thread.cut_from);
        }
        b->thread.cut_from = apart ? 0 : b->thread.cut_from;
    }
}
