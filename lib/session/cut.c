/* How much of a limb was left by a cut, where that is outside the knot. */
#include <math.h>

#include "session/session.h"

/* Distance between nodes of two strands that touch, at most, m: a diameter between the axes, and half a
 * segment along each of them. Derived. */
static double touching_distance(const scene_thread_info *t)
{
    double longest = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        longest = vbss_max(longest, t->rest_lengths[i]);
    }
    return sqrt(4.0 * t->radius * t->radius + 0.5 * longest * longest);
}

/* A thread, whose nodes are counted from an end. */
typedef struct strand {
    const scene_thread_info *thread;
    bool from_last;
} strand;

static vec3 node_position(const strand *a, uint32_t i)
{
    return a->thread->positions[a->from_last ? a->thread->node_count - 1 - i : i];
}

static double segment_length(const strand *a, uint32_t i)
{
    return a->thread->rest_lengths[a->from_last ? a->thread->node_count - 2 - i : i];
}

/* True if a node of the strand is near the point, where arc lengths from `first` to `last` do not count. */
static bool has_node_within(const strand *a, double distance, vec3 point, double first, double last)
{
    double arc = 0.0;
    for (uint32_t i = 0; i < a->thread->node_count; i++) {
        if ((arc < first || arc > last) && vec3_distance(node_position(a, i), point) < distance) {
            return true;
        }
        arc += i + 1 < a->thread->node_count ? segment_length(a, i) : 0.0;
    }
    return false;
}

/* Arc length from the end to the first node that touches another strand, m, or the same one if `other` is that;
 * infinite if none does. Neighbours along the strand, and the two ends at the cut, are excluded. */
static double find_free_length(const strand *a, const strand *other, double distance)
{
    const double near = 2.0 * distance;
    double arc = 0.0;
    for (uint32_t i = 0; i < a->thread->node_count; i++) {
        const double middle = a == other ? arc : -arc;
        if (has_node_within(other, distance, node_position(a, i), middle - near, middle + near)) {
            return arc;
        }
        arc += i + 1 < a->thread->node_count ? segment_length(a, i) : 0.0;
    }
    return (double)INFINITY;
}

double vbss_session_find_free_length(const session_object *s, uint32_t entry_count, uint32_t number,
                                     uint32_t limb)
{
    const scene_thread_info left =
        vbss_scene_inspect_thread(vbss_scene_inspect_body(s->scene, number).thread);
    const strand stitched = {&left, limb == SESSION_ENTRY};
    const double distance = touching_distance(&left);
    for (uint32_t i = 0; i < entry_count; i++) {
        const scene_body_info body = vbss_scene_inspect_entry(s->scene, i);
        if (body.thread == NULL || body.number == number) {
            continue;
        }
        const scene_thread_info piece = vbss_scene_inspect_thread(body.thread);
        const strand severed = {&piece, limb == SESSION_EXIT};
        if (vec3_distance(node_position(&severed, 0), node_position(&stitched, 0)) < distance) {
            return isfinite(find_free_length(&severed, &stitched, distance))
                       ? 0.0
                       : vbss_min(find_free_length(&stitched, &stitched, distance), left.length);
        }
    }
    return 0.0;
}
