/* Threads of scenes that adapt their meshes: what must be true after any step, and whether a change of the mesh
 * moved anything through anything. */
#ifndef VBSS_TESTS_SCENE_MESH_RIG_H
#define VBSS_TESTS_SCENE_MESH_RIG_H

#include "scene/cut_rig.h"
#include "scene/api/api.h"
#include "scene/topology/topology.h"
#include "thread/remesh.h"

static inline thread_object *mesh_thread(vbss_thread *handle)
{
    thread_object *t = NULL;
    expect_ok(vbss_thread_open(handle, &t));
    return t;
}

static inline scene_object *mesh_scene(vbss_scene *scene)
{
    scene_object *s = NULL;
    expect_ok(vbss_scene_open(scene, &s));
    return s;
}

static inline vbss_thread_statistics mesh_statistics(vbss_thread *thread)
{
    vbss_thread_statistics s;
    expect_ok(vbss_thread_get_statistics(thread, &s, sizeof s));
    return s;
}

/* Ratio of the most unlike neighbours. */
static inline double mesh_ratio(const thread_object *t)
{
    double largest = 1.0;
    for (uint32_t i = 0; i + 2 < t->node_count; i++) {
        double ratio = t->rest[i + 1] / t->rest[i];
        largest = fmax(largest, fmax(ratio, 1.0 / ratio));
    }
    return largest;
}

/* A thread as it was. */
enum { MESH_NODES = 1024 };
typedef struct mesh_line {
    uint32_t count;
    vec3 x[MESH_NODES];
    double arc[MESH_NODES];
} mesh_line;

static inline void mesh_keep(mesh_line *line, const thread_object *t)
{
    assert_true(t->node_count <= MESH_NODES);
    line->count = t->node_count;
    for (uint32_t i = 0; i < t->node_count; i++) {
        line->x[i] = t->now.x[i];
        line->arc[i] = vbss_thread_arc_length(t, i);
    }
}

/* The place at an arc length of a line. */
static inline vec3 mesh_at(const mesh_line *line, double arc)
{
    uint32_t i = 0;
    while (i + 2 < line->count && line->arc[i + 1] < arc) {
        i++;
    }
    double l = line->arc[i + 1] - line->arc[i];
    return vec3_lerp(line->x[i], line->x[i + 1], fmin(fmax((arc - line->arc[i]) / l, 0.0), 1.0));
}

/* Both lines with the nodes of both, so that the one can be moved into the other; how many. Nodes at the same arc
 * length, up to rounding, are one. */
static inline uint32_t mesh_join(const mesh_line *a, const mesh_line *b, vec3 *start, vec3 *end)
{
    uint32_t i = 0, k = 0, count = 0;
    while (i < a->count && k < b->count) {
        double p = a->arc[i], q = b->arc[k], smallest = fmin(p, q);
        bool same = fabs(p - q) < 1e-9;
        assert_true(count < 2 * MESH_NODES);
        start[count] = same || p < q ? a->x[i] : mesh_at(a, smallest);
        end[count] = same || q < p ? b->x[k] : mesh_at(b, smallest);
        i += same || p < q;
        k += same || q < p;
        count++;
    }
    return count;
}

#endif
