/* What a mesh that adapts itself wants where, by lengths and curvature. */
#include "thread/mesh.h"

/* ---- shape */

double vbss_thread_node_curvature(const thread_object *t, uint32_t node)
{
    return vec3_norm(vbss_thread_curvature(t, t->now.x, node));
}

static double curvature_of_segment(const thread_object *t, uint32_t segment)
{
    return vbss_max(vbss_thread_node_curvature(t, segment),
                    vbss_thread_node_curvature(t, segment + 1));
}

double vbss_thread_sagitta(const thread_object *t, uint32_t segment)
{
    double l = t->rest[segment];
    return 0.125 * l * l * curvature_of_segment(t, segment);
}

bool vbss_thread_is_too_bent(const thread_object *t, uint32_t segment)
{
    double l = t->rest[segment];
    return l > MESH_LENIENCE * t->config.finest_length &&
           curvature_of_segment(t, segment) * l > t->config.refine_angle;
}

bool vbss_thread_is_straight(const thread_object *t, uint32_t node)
{
    double curvature =
        vbss_max(curvature_of_segment(t, node - 1), vbss_thread_node_curvature(t, node + 1));
    return curvature * vbss_max(t->rest[node - 1], t->rest[node]) < t->config.coarsen_angle;
}

/* ---- lengths */

uint32_t vbss_thread_first_to_divide(const thread_object *t, uint32_t segment)
{
    uint32_t segments = t->node_count - 1;
    for (uint32_t k = 0; k < segments; k++) {
        double most = 0.5 * MESH_RATIO * t->rest[segment];
        if (segment > 0 && t->rest[segment - 1] > most) {
            segment--;
        } else if (segment + 1 < segments && t->rest[segment + 1] > most) {
            segment++;
        } else {
            break;
        }
    }
    return segment;
}

bool vbss_thread_may_join(const thread_object *t, uint32_t node)
{
    double l = t->rest[node - 1] + t->rest[node];
    bool before = node < 2 || l <= MESH_RATIO * t->rest[node - 2];
    bool behind = node + 2 >= t->node_count || l <= MESH_RATIO * t->rest[node + 1];
    return l <= MESH_LENIENCE * t->config.coarsest_length && before && behind;
}

bool vbss_thread_holds_among(const thread_object *t, uint32_t low, uint32_t high)
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

/* ---- after a step */

uint32_t vbss_thread_next_look(thread_object *t)
{
    uint32_t look = t->next_look < t->node_count - 1 ? t->next_look : 0;
    t->next_look = look + 1;
    return look;
}

void vbss_thread_note_mesh(thread_object *t)
{
    vbss_thread_statistics *s = &t->statistics;
    s->most_nodes = t->node_count > s->most_nodes ? t->node_count : s->most_nodes;
}

/* A whole part of the coarsest length is more than any change takes of a sound mesh. */
#define ROOM 0.05

static bool divide(thread_object *t, uint32_t segment)
{
    segment = vbss_thread_first_to_divide(t, segment);
    if (t->node_count == t->node_capacity) {
        t->statistics.refused_capacity++;
        return false;
    }
    if (vbss_thread_holds_among(t, segment > 1 ? segment - 2 : 0, segment + 3)) {
        t->statistics.refused_held++;
        return false;
    }
    vbss_thread_divide_segment(t, segment, ROOM * t->rest[segment]);
    return true;
}

static bool remove_node(thread_object *t, uint32_t node)
{
    if (!vbss_thread_may_join(t, node) || !vbss_thread_is_straight(t, node)) {
        return false;
    }
    if (vbss_thread_holds_among(t, node > 2 ? node - 2 : 0, node + 2)) {
        t->statistics.refused_held++;
        return false;
    }
    return vbss_thread_remove_node(t, node, ROOM * (t->rest[node - 1] + t->rest[node]));
}

void vbss_thread_adapt(thread_object *t)
{
    if (!thread_is_adaptive(t)) {
        return;
    }
    uint32_t left = t->config.mesh_operations;
    (void)vbss_thread_prepare(t);
    for (uint32_t k = 0; k < MESH_LOOKS && left > 0; k++) {
        uint32_t segment = vbss_thread_next_look(t);
        bool changed = vbss_thread_is_too_bent(t, segment) ? divide(t, segment)
                       : segment > 0                       ? remove_node(t, segment)
                                                           : false;
        left -= changed;
    }
    vbss_thread_note_mesh(t);
}
