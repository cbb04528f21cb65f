/* Geodesic exclusion: the nodes of a mesh that are close to its edges and triangles along the
 * surface, computed once and stored as bits.
 *
 * The arc between two nodes is the shortest path along edges, so the two sides of a slit are
 * connected only around its tips. Path lengths are rounded sums from the start of a path. Their
 * minimum does not depend on the order in which paths are tried, because addition preserves the
 * order of numbers. */
#include "base/bits.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/shapes.h"

#include <string.h>

/* The edges at each node, and scratch to follow them. */
typedef struct surface {
    uint32_t *first;              /* node -> first neighbour; one extra at the end */
    uint32_t *neighbours, *edges; /* and the edge to each neighbour */
    double *lengths;              /* length of that edge */
    double *arcs;                 /* node -> arc length, if reached */
    uint32_t *queue;              /* nodes still to be expanded, each once */
    bool *queued;
    uint64_t *near; /* one row of bits for each node */
    uint32_t words; /* words in a row */
} surface;

enum { SURFACE_ARRAYS = 8 };
static void list_arrays(surface *g, const collision_shape *s, vbss_array arrays[SURFACE_ARRAYS])
{
    size_t n = s->node_count, half_edges = 2 * (size_t)s->edge_count;
    const vbss_array all[SURFACE_ARRAYS] = {
        {&g->first, n + 2, sizeof *g->first},
        {&g->neighbours, half_edges, sizeof *g->neighbours},
        {&g->edges, half_edges, sizeof *g->edges},
        {&g->lengths, half_edges, sizeof *g->lengths},
        {&g->arcs, n, sizeof *g->arcs},
        {&g->queue, n, sizeof *g->queue},
        {&g->queued, n, sizeof *g->queued},
        {&g->near, n * g->words, sizeof *g->near},
    };
    memcpy(arrays, all, sizeof all);
}

static void list_neighbours(surface *g, const collision_shape *s, const vec3 *at)
{
    for (uint32_t e = 0; e < s->edge_count; e++) {
        g->first[s->edges[e][0] + 2]++;
        g->first[s->edges[e][1] + 2]++;
    }
    for (uint32_t n = 0; n < s->node_count; n++) {
        g->first[n + 2] += g->first[n + 1];
    }
    /* During the loop, the start of a node is one entry further on. */
    for (uint32_t e = 0; e < s->edge_count; e++) {
        const uint32_t *nodes = s->edges[e];
        double length = vec3_norm(vec3_sub(at[nodes[1]], at[nodes[0]]));
        for (int k = 0; k < 2; k++) {
            uint32_t entry = g->first[nodes[k] + 1]++;
            g->neighbours[entry] = nodes[1 - k];
            g->edges[entry] = e;
            g->lengths[entry] = length;
        }
    }
}

static uint64_t *row_of(const surface *g, uint32_t node)
{
    return g->near + (size_t)node * g->words;
}

static void set_bit(uint64_t *row, uint32_t node)
{
    row[node / 64] |= UINT64_C(1) << node % 64;
}

/* Marks the nodes whose arc from `source` is below `distance`. The arc of a node is valid once it
 * is marked. */
static void find_near(surface *g, uint32_t node_count, uint32_t source, double distance)
{
    uint64_t *row = row_of(g, source);
    uint32_t next = 0, queue_length = 1;
    g->queue[0] = source;
    g->arcs[source] = 0.0;
    set_bit(row, source);
    while (queue_length > 0) {
        uint32_t node = g->queue[next];
        next = (next + 1) % node_count;
        queue_length--;
        g->queued[node] = false;
        for (uint32_t i = g->first[node]; i < g->first[node + 1]; i++) {
            uint32_t other = g->neighbours[i];
            double arc = g->arcs[node] + g->lengths[i];
            if (arc >= distance || (near_bit(row, other) != 0 && arc >= g->arcs[other])) {
                continue;
            }
            set_bit(row, other);
            g->arcs[other] = arc;
            if (!g->queued[other]) {
                g->queue[(next + queue_length++) % node_count] = other;
                g->queued[other] = true;
            }
        }
    }
}

/* The two directions of a path may round differently: close in one direction counts as close. */
static void make_symmetric(surface *g, uint32_t node_count)
{
    for (uint32_t p = 0; p < node_count; p++) {
        for (uint32_t q = 0; q < p; q++) {
            if ((near_bit(row_of(g, p), q) | near_bit(row_of(g, q), p)) != 0) {
                set_bit(row_of(g, p), q);
                set_bit(row_of(g, q), p);
            }
        }
    }
}

/* Nodes close to any of the feature's nodes are close to the feature. */
static void join_nodes(const surface *g, const uint32_t *nodes, int count, uint64_t *row)
{
    for (int k = 0; k < count; k++) {
        for (uint32_t w = 0; w < g->words; w++) {
            row[w] |= row_of(g, nodes[k])[w];
        }
    }
}

static void compute_exclusion(surface *g, const collision_shape *s, const vec3 *at, double distance,
                              collision_exclusion *exclusion)
{
    list_neighbours(g, s, at);
    for (uint32_t node = 0; node < s->node_count; node++) {
        find_near(g, s->node_count, node, distance);
    }
    make_symmetric(g, s->node_count);
    for (size_t i = 0; i < s->edge_count; i++) {
        join_nodes(g, s->edges[i], 2, exclusion->edges + i * g->words);
    }
    for (size_t i = 0; i < s->triangle_count; i++) {
        join_nodes(g, s->triangles[i], 3, exclusion->triangles + i * g->words);
    }
    memcpy(exclusion->first_edge, g->first, ((size_t)s->node_count + 1) * sizeof *g->first);
    memcpy(exclusion->edges_of, g->edges, 2 * (size_t)s->edge_count * sizeof *g->edges);
}

/* ---- excluded lanes for the traversal */

static void set_leaves(const collision_bvh *t, uint32_t *leaf_of)
{
    for (uint32_t leaf = 0; leaf < t->count; leaf++) {
        leaf_of[t->order != NULL ? t->order[leaf] : leaf] = leaf;
    }
}

static inline void set_lane(uint8_t *lanes, uint32_t count_b, uint32_t leaf_a, uint32_t leaf_b)
{
    uint8_t *at = &lanes[(size_t)(leaf_a / COLLISION_BVH_WIDTH) * count_b + leaf_b];
    *at |= (uint8_t)(1u << leaf_a % COLLISION_BVH_WIDTH);
}

void vbss_collision_update_excluded_edges(collision_shape *s)
{
    const collision_bvh *t = &s->edge_bvh;
    const collision_exclusion *exclusion = &s->exclusion;
    memset(exclusion->edge_lanes, 0, (size_t)t->level_groups[0] * t->count);
    set_leaves(t, exclusion->leaf_of);
    for (uint32_t b = 0; b < t->count; b++) {
        const uint64_t *row = exclusion->edges + (size_t)b * exclusion->words;
        for (uint32_t w = 0; w < exclusion->words; w++) {
            for (uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
                uint32_t node = w * BITS_PER_WORD + lowest_bit(bits);
                for (uint32_t i = exclusion->first_edge[node]; i < exclusion->first_edge[node + 1];
                     i++) {
                    set_lane(exclusion->edge_lanes, t->count,
                             exclusion->leaf_of[exclusion->edges_of[i]], exclusion->leaf_of[b]);
                }
            }
        }
    }
}

void vbss_collision_update_excluded_points(collision_shape *s)
{
    const collision_bvh *a = &s->point_bvh, *b = &s->triangle_bvh;
    const collision_exclusion *exclusion = &s->exclusion;
    memset(exclusion->point_lanes, 0, (size_t)a->level_groups[0] * b->count);
    set_leaves(a, exclusion->leaf_of);
    for (uint32_t leaf_b = 0; leaf_b < b->count; leaf_b++) {
        uint32_t triangle = b->order != NULL ? b->order[leaf_b] : leaf_b;
        const uint64_t *row = exclusion->triangles + (size_t)triangle * exclusion->words;
        for (uint32_t w = 0; w < exclusion->words; w++) {
            for (uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
                uint32_t node = w * BITS_PER_WORD + lowest_bit(bits);
                set_lane(exclusion->point_lanes, b->count, exclusion->leaf_of[node], leaf_b);
            }
        }
    }
}

static vbss_result check_arguments(const collision_object *c, uint32_t id, const vec3 *at,
                                   double distance, collision_shape **shape)
{
    VBSS_TRY(vbss_collision_find_shape(c, id, shape));
    const collision_shape *s = *shape;
    if (s->kind != COLLISION_SHAPE_MESH) {
        return vbss_fail(c->context, VBSS_ERROR_INCOMPATIBLE, "shape %u is no mesh", id);
    }
    VBSS_TRY(vbss_check_range(c->context, distance, 0.0, COLLISION_MAX_COORDINATE, "distance"));
    VBSS_TRY(vbss_collision_check_coordinates(c->context, &at[0].x, 3 * (size_t)s->node_count,
                                              "positions"));
    uint64_t rows = (uint64_t)s->node_count + s->edge_count + s->triangle_count;
    if (rows * ((s->node_count + 63) / 64) * sizeof(uint64_t) > COLLISION_EXCLUSION_BYTES) {
        return vbss_fail(c->context, VBSS_ERROR_CAPACITY,
                         "a mesh of %u nodes is too large to know what is near", s->node_count);
    }
    return VBSS_OK;
}

vbss_result vbss_collision_exclude_near(collision_object *c, uint32_t id, const vec3 *at,
                                        double distance)
{
    collision_shape *s = NULL;
    VBSS_TRY(check_arguments(c, id, at, distance, &s));
    surface g = {.words = (s->node_count + 63) / 64};
    collision_exclusion exclusion = {.words = g.words}, before = s->exclusion;
    vbss_array arrays[SURFACE_ARRAYS], exclusion_arrays[COLLISION_EXCLUSION_ARRAYS];
    list_arrays(&g, s, arrays);
    vbss_collision_exclusion_arrays(s, &exclusion, exclusion_arrays);
    vbss_result result =
        vbss_allocate_arrays(c->context, arrays, SURFACE_ARRAYS, "surface of a mesh");
    if (result == VBSS_OK) {
        result = vbss_allocate_arrays(c->context, exclusion_arrays, COLLISION_EXCLUSION_ARRAYS,
                                      "near nodes of a mesh");
    }
    if (result == VBSS_OK) {
        compute_exclusion(&g, s, at, distance, &exclusion);
        s->exclusion = exclusion;
        exclusion = before;
        vbss_collision_update_excluded_edges(s);
        vbss_collision_update_excluded_points(s);
        vbss_collision_update_pair_rules(c, s);
    }
    /* the previous exclusion after a success, otherwise the incomplete new one */
    vbss_release_arrays(c->context, exclusion_arrays, COLLISION_EXCLUSION_ARRAYS);
    vbss_release_arrays(c->context, arrays, SURFACE_ARRAYS);
    return result;
}
