/* Criteria of remeshing: where a thread needs nodes, by lengths and curvature. */
#include "thread/remesh.h"
#include "thread/tuning.h"

/* ---- shape */

double vbss_thread_node_curvature(const thread_object *t, uint32_t node)
{
    return vec3_norm(vbss_thread_curvature(t, t->now.x, node));
}

static double segment_curvature(const thread_object *t, uint32_t segment)
{
    return vbss_max(vbss_thread_node_curvature(t, segment),
                    vbss_thread_node_curvature(t, segment + 1));
}

double vbss_thread_sagitta(const thread_object *t, uint32_t segment)
{
    double l = t->rest[segment];
    return 0.125 * l * l * segment_curvature(t, segment);
}

bool vbss_thread_needs_refinement(const thread_object *t, uint32_t segment)
{
    double l = t->rest[segment];
    return l > REMESH_LENGTH_TOLERANCE * t->config.finest_length &&
           segment_curvature(t, segment) * l > t->config.refine_angle;
}

bool vbss_thread_is_straight(const thread_object *t, uint32_t node)
{
    double curvature =
        vbss_max(segment_curvature(t, node - 1), vbss_thread_node_curvature(t, node + 1));
    return curvature * vbss_max(t->rest[node - 1], t->rest[node]) < t->config.coarsen_angle;
}

/* ---- lengths */

uint32_t vbss_thread_first_segment_to_split(const thread_object *t, uint32_t segment)
{
    uint32_t segments = t->node_count - 1;
    for (uint32_t k = 0; k < segments; k++) {
        double max_length = 0.5 * REMESH_MAX_LENGTH_RATIO * t->rest[segment];
        if (segment > 0 && t->rest[segment - 1] > max_length) {
            segment--;
        } else if (segment + 1 < segments && t->rest[segment + 1] > max_length) {
            segment++;
        } else {
            break;
        }
    }
    return segment;
}

bool vbss_thread_can_coarsen(const thread_object *t, uint32_t node)
{
    double l = t->rest[node - 1] + t->rest[node];
    bool before = node < 2 || l <= REMESH_MAX_LENGTH_RATIO * t->rest[node - 2];
    bool after = node + 2 >= t->node_count || l <= REMESH_MAX_LENGTH_RATIO * t->rest[node + 1];
    return l <= REMESH_LENGTH_TOLERANCE * t->config.coarsest_length && before && after;
}

bool vbss_thread_has_attached_node(const thread_object *t, uint32_t low, uint32_t high)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->node >= low && a->node <= high) {
            return true;
        }
    }
    for (uint32_t i = low; i <= high && i < t->node_count; i++) {
        if (t->welded[i] != 0) {
            return true;
        }
    }
    return false;
}

/* ---- remeshing after a step */

uint32_t vbss_thread_next_segment_to_check(thread_object *t)
{
    uint32_t segment = t->next_segment_to_check < t->node_count - 1 ? t->next_segment_to_check : 0;
    t->next_segment_to_check = segment + 1;
    return segment;
}

void vbss_thread_record_node_count(thread_object *t)
{
    vbss_thread_statistics *s = &t->statistics;
    s->most_nodes = t->node_count > s->most_nodes ? t->node_count : s->most_nodes;
}

static bool try_split(thread_object *t, uint32_t segment)
{
    segment = vbss_thread_first_segment_to_split(t, segment);
    if (t->node_count == t->node_capacity) {
        t->statistics.refused_capacity++;
        return false;
    }
    if (vbss_thread_has_attached_node(t, segment > 1 ? segment - 2 : 0, segment + 3)) {
        t->statistics.refused_held++;
        return false;
    }
    vbss_thread_split_segment(t, segment, REMESH_MAX_DISPLACEMENT_RATIO * t->rest[segment]);
    return true;
}

static bool try_coarsen(thread_object *t, uint32_t node)
{
    if (!vbss_thread_can_coarsen(t, node) || !vbss_thread_is_straight(t, node)) {
        return false;
    }
    if (vbss_thread_has_attached_node(t, node > 2 ? node - 2 : 0, node + 2)) {
        t->statistics.refused_held++;
        return false;
    }
    return vbss_thread_remove_node(
        t, node, REMESH_MAX_DISPLACEMENT_RATIO * (t->rest[node - 1] + t->rest[node]));
}

void vbss_thread_adapt_mesh(thread_object *t)
{
    if (!thread_is_adaptive(t)) {
        return;
    }
    uint32_t remaining = t->config.mesh_operations;
    (void)vbss_thread_prepare_query(t);
    for (uint32_t k = 0; k < REMESH_CHECKS_PER_STEP && remaining > 0; k++) {
        uint32_t segment = vbss_thread_next_segment_to_check(t);
        bool changed = vbss_thread_needs_refinement(t, segment) ? try_split(t, segment)
                       : segment > 0                            ? try_coarsen(t, segment)
                                                                : false;
        remaining -= changed;
    }
    vbss_thread_record_node_count(t);
}
