/* Which nodes of a mesh are near its edges and triangles along the surface: worked out once, as bits.
 *
 * The arc between two nodes is that of the shortest way over edges, so that the sides of a slit are joined
 * only around its tips. Sums are rounded from where a way begins; the least of them does not depend on
 * the order in which ways are tried, as adding keeps the order of numbers. */
#include "base/bits.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/shapes.h"

#include <string.h>

/* Edges as seen from nodes, and room to go along them. */
typedef struct surface {
    uint32_t *first;              /* neighbour of a node; then where its last one ends */
    uint32_t *neighbours, *edges; /* and which edge leads there */
    double *lengths;              /* of the edges to them */
    double *arcs;                 /* of the nodes that have been reached */
    uint32_t *queue;              /* nodes to go on from, each once */
    bool *queued;
    uint64_t *near; /* a row for each node */
    uint32_t words; /* in a row */
} surface;

enum { SURFACE_PARTS = 8 };
static void list_parts(surface *g, const collision_shape *s, vbss_array parts[SURFACE_PARTS])
{
    size_t n = s->node_count, ways = 2 * (size_t)s->edge_count;
    const vbss_array all[SURFACE_PARTS] = {
        {&g->first, n + 2, sizeof *g->first}, {&g->neighbours, ways, sizeof *g->neighbours},
        {&g->edges, ways, sizeof *g->edges},  {&g->lengths, ways, sizeof *g->lengths},
        {&g->arcs, n, sizeof *g->arcs},       {&g->queue, n, sizeof *g->queue},
        {&g->queued, n, sizeof *g->queued},   {&g->near, n * g->words, sizeof *g->near},
    };
    memcpy(parts, all, sizeof all);
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
    /* While they are filled in, the begin of a node's stands one further on. */
    for (uint32_t e = 0; e < s->edge_count; e++) {
        const uint32_t *nodes = s->edges[e];
        double length = vec3_norm(vec3_sub(at[nodes[1]], at[nodes[0]]));
        for (int k = 0; k < 2; k++) {
            uint32_t place = g->first[nodes[k] + 1]++;
            g->neighbours[place] = nodes[1 - k];
            g->edges[place] = e;
            g->lengths[place] = length;
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

/* Marks the nodes whose arc from `source` is below `distance`; a node's arc is known once it is marked. */
static void mark_near(surface *g, uint32_t node_count, uint32_t source, double distance)
{
    uint64_t *row = row_of(g, source);
    uint32_t next = 0, waiting = 1;
    g->queue[0] = source;
    g->arcs[source] = 0.0;
    set_bit(row, source);
    while (waiting > 0) {
        uint32_t node = g->queue[next];
        next = (next + 1) % node_count;
        waiting--;
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
                g->queue[(next + waiting++) % node_count] = other;
                g->queued[other] = true;
            }
        }
    }
}

/* There and back may be rounded differently: near one way is near. */
static void join_ways(surface *g, uint32_t node_count)
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

/* Near a feature is what is near one of its nodes. */
static void join_nodes(const surface *g, const uint32_t *nodes, int count, uint64_t *row)
{
    for (int k = 0; k < count; k++) {
        for (uint32_t w = 0; w < g->words; w++) {
            row[w] |= row_of(g, nodes[k])[w];
        }
    }
}

static void work_out(surface *g, const collision_shape *s, const vec3 *at, double distance,
                     collision_near *near)
{
    list_neighbours(g, s, at);
    for (uint32_t node = 0; node < s->node_count; node++) {
        mark_near(g, s->node_count, node, distance);
    }
    join_ways(g, s->node_count);
    for (size_t i = 0; i < s->edge_count; i++) {
        join_nodes(g, s->edges[i], 2, near->edges + i * g->words);
    }
    for (size_t i = 0; i < s->triangle_count; i++) {
        join_nodes(g, s->triangles[i], 3, near->triangles + i * g->words);
    }
    memcpy(near->first_edge, g->first, ((size_t)s->node_count + 1) * sizeof *g->first);
    memcpy(near->edges_of, g->edges, 2 * (size_t)s->edge_count * sizeof *g->edges);
}

/* ---- as walks ask it */

static void set_places(const collision_tree *t, uint32_t *places)
{
    for (uint32_t place = 0; place < t->count; place++) {
        places[t->order != NULL ? t->order[place] : place] = place;
    }
}

static inline void set_lane(uint8_t *lanes, uint32_t count_b, uint32_t place_a, uint32_t place_b)
{
    uint8_t *at = &lanes[(size_t)(place_a / TREE_LANES) * count_b + place_b];
    *at |= (uint8_t)(1u << place_a % TREE_LANES);
}

void vbss_collision_near_edge_lanes(collision_shape *s)
{
    const collision_tree *t = &s->edge_tree;
    const collision_near *near = &s->near;
    memset(near->edge_lanes, 0, (size_t)t->level_groups[0] * t->count);
    set_places(t, near->places);
    for (uint32_t b = 0; b < t->count; b++) {
        const uint64_t *row = near->edges + (size_t)b * near->words;
        for (uint32_t w = 0; w < near->words; w++) {
            for (uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
                uint32_t node = w * BITS + lowest_bit(bits);
                for (uint32_t i = near->first_edge[node]; i < near->first_edge[node + 1]; i++) {
                    set_lane(near->edge_lanes, t->count, near->places[near->edges_of[i]],
                             near->places[b]);
                }
            }
        }
    }
}

void vbss_collision_near_point_lanes(collision_shape *s)
{
    const collision_tree *a = &s->point_tree, *b = &s->triangle_tree;
    const collision_near *near = &s->near;
    memset(near->point_lanes, 0, (size_t)a->level_groups[0] * b->count);
    set_places(a, near->places);
    for (uint32_t place_b = 0; place_b < b->count; place_b++) {
        uint32_t triangle = b->order != NULL ? b->order[place_b] : place_b;
        const uint64_t *row = near->triangles + (size_t)triangle * near->words;
        for (uint32_t w = 0; w < near->words; w++) {
            for (uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
                uint32_t node = w * BITS + lowest_bit(bits);
                set_lane(near->point_lanes, b->count, near->places[node], place_b);
            }
        }
    }
}

static vbss_result check(const collision_object *c, uint32_t name, const vec3 *at, double distance,
                         collision_shape **shape)
{
    VBSS_TRY(vbss_collision_find_shape(c, name, shape));
    const collision_shape *s = *shape;
    if (s->kind != SHAPE_MESH) {
        return vbss_fail(c->context, VBSS_ERROR_OUT_OF_RANGE, "shape %u is no mesh", name);
    }
    VBSS_TRY(vbss_check_range(c->context, distance, 0.0, COLLISION_FARTHEST, "distance"));
    VBSS_TRY(vbss_collision_check_coordinates(c->context, &at[0].x, 3 * (size_t)s->node_count,
                                              "positions"));
    uint64_t rows = (uint64_t)s->node_count + s->edge_count + s->triangle_count;
    if (rows * ((s->node_count + 63) / 64) * sizeof(uint64_t) > NEAR_BYTES) {
        return vbss_fail(c->context, VBSS_ERROR_CAPACITY,
                         "a mesh of %u nodes is too large to know what is near", s->node_count);
    }
    return VBSS_OK;
}

void vbss_collision_near_parts(const collision_shape *s, collision_near *near,
                               vbss_array parts[NEAR_PARTS])
{
    size_t n = s->node_count, e = s->edge_count, t = s->triangle_count;
    const vbss_array all[NEAR_PARTS] = {
        {&near->edges, e * near->words, sizeof *near->edges},
        {&near->triangles, t * near->words, sizeof *near->triangles},
        {&near->edge_lanes, s->edge_tree.level_groups[0] * e, sizeof *near->edge_lanes},
        {&near->point_lanes, s->point_tree.level_groups[0] * t, sizeof *near->point_lanes},
        {&near->first_edge, n + 1, sizeof *near->first_edge},
        {&near->edges_of, 2 * e, sizeof *near->edges_of},
        {&near->places, e > n ? e : n, sizeof *near->places},
    };
    memcpy(parts, all, sizeof all);
}

vbss_result vbss_collision_leave_out_near(collision_object *c, uint32_t name, const vec3 *at,
                                          double distance)
{
    collision_shape *s = NULL;
    VBSS_TRY(check(c, name, at, distance, &s));
    surface g = {.words = (s->node_count + 63) / 64};
    collision_near near = {.words = g.words}, before = s->near;
    vbss_array parts[SURFACE_PARTS], near_parts[NEAR_PARTS];
    list_parts(&g, s, parts);
    vbss_collision_near_parts(s, &near, near_parts);
    vbss_result result =
        vbss_allocate_arrays(c->context, parts, SURFACE_PARTS, "surface of a mesh");
    if (result == VBSS_OK) {
        result = vbss_allocate_arrays(c->context, near_parts, NEAR_PARTS, "near nodes of a mesh");
    }
    if (result == VBSS_OK) {
        work_out(&g, s, at, distance, &near);
        s->near = near;
        near = before;
        vbss_collision_near_edge_lanes(s);
        vbss_collision_near_point_lanes(s);
        vbss_collision_rules_changed(c, s);
    }
    /* those before, or new ones that are not all there */
    vbss_release_arrays(c->context, near_parts, NEAR_PARTS);
    vbss_release_arrays(c->context, parts, SURFACE_PARTS);
    return result;
}
