/* What does not change while a drain moves: the triangles of its wall, and the attributes of its
 * vertices other than position and normal. */
#include <string.h>

#include "visual/visual.h"

/* ---- attributes */

/* Attributes of a vertex. They are interpolated linearly between nodes. */
typedef struct vertex_attributes {
    vec3 rest;
    double texture[2];
} vertex_attributes;

static vertex_attributes attributes_at(const scene_drain_info *d, uint32_t node)
{
    const vertex_attributes attributes = {
        d->rest_positions[node],
        {d->material_coordinates[node][1], fabs(d->material_coordinates[node][0])}};
    return attributes;
}

static vertex_attributes interpolate(const scene_drain_info *d, const uint32_t *node,
                                     const double *weights, int count)
{
    vertex_attributes sum = {vec3_zero(), {0.0, 0.0}};
    for (int k = 0; k < count; k++) {
        const vertex_attributes at = attributes_at(d, node[k]);
        sum.rest = vec3_add_scaled(sum.rest, weights[k], at.rest);
        sum.texture[0] += weights[k] * at.texture[0];
        sum.texture[1] += weights[k] * at.texture[1];
    }
    return sum;
}

static void put(visual_vertex *out, const vertex_attributes *m, float value)
{
    out->texture[0] = visual_to_float(m->texture[0]);
    out->texture[1] = visual_to_float(m->texture[1]);
    visual_store(out->material, m->rest);
    out->value = value;
}

static void put_on_faces(const visual_wall *w, uint32_t vertex, const vertex_attributes *m)
{
    put(&w->outer[vertex], m, 1.0F);
    put(&w->outer[vertex + w->face_count], m, -1.0F);
}

static void write_node_attributes(const visual_wall *w)
{
    for (uint32_t i = 0; i < w->drain->node_count; i++) {
        const vertex_attributes m = attributes_at(w->drain, i);
        put_on_faces(w, i, &m);
    }
}

/* Those on the edges of the faces and on the rims. */
static void write_edge_attributes(const visual_wall *w)
{
    const scene_drain_info *d = w->drain;
    const uint32_t n = w->divisions;
    uint32_t vertex = d->node_count;
    visual_vertex *rim = &w->outer[2 * (size_t)w->face_count];
    for (uint32_t i = 0; i < d->edge_count; i++) {
        const bool is_free = d->edges[i][3] == SCENE_INSPECT_NONE;
        for (uint32_t k = 0; k <= n; k++) {
            const double fraction = (double)k / (double)n;
            const double weights[2] = {1.0 - fraction, fraction};
            const vertex_attributes m = interpolate(d, d->edges[i], weights, 2);
            if (k > 0 && k < n) {
                put_on_faces(w, vertex++, &m);
            }
            if (is_free) {
                put(rim++, &m, 0.0F);
                put(rim++, &m, 0.0F);
            }
        }
    }
}

static void write_interior_attributes(const visual_wall *w)
{
    const scene_drain_info *d = w->drain;
    const uint32_t n = w->divisions;
    uint32_t vertex = d->node_count + d->edge_count * (n - 1);
    for (uint32_t t = 0; t < d->triangle_count && n > 2; t++) {
        for (uint32_t i = 1; i + 1 < n; i++) {
            for (uint32_t k = 1; i + k < n; k++) {
                const double weights[3] = {(double)(n - i - k) / (double)n, (double)i / (double)n,
                                           (double)k / (double)n};
                const vertex_attributes m = interpolate(d, d->triangles[t], weights, 3);
                put_on_faces(w, vertex++, &m);
            }
        }
    }
}

/* ---- triangles */

static uint32_t find_edge(const scene_drain_info *d, uint32_t a, uint32_t b)
{
    const uint32_t low = a < b ? a : b, high = a < b ? b : a;
    uint32_t edge = d->first_edge[low];
    while (d->edges[edge][0] + d->edges[edge][1] != low + high) {
        edge = d->next_edge[edge];
    }
    return edge;
}

/* The vertex k divisions from a toward b. */
static uint32_t vertex_on_edge(const visual_wall *w, uint32_t edge, uint32_t a, uint32_t b,
                               uint32_t k)
{
    const scene_drain_info *d = w->drain;
    if (k == 0 || k == w->divisions) {
        return k == 0 ? a : b;
    }
    uint32_t from_first = d->edges[edge][0] == a ? k : w->divisions - k;
    return d->node_count + edge * (w->divisions - 1) + from_first - 1;
}

/* The vertices of a divided triangle. */
typedef struct lattice {
    const uint32_t *node;
    uint32_t edge[3], first_interior;
} lattice;

/* The vertex i divisions toward the second corner and k toward the third. */
static uint32_t vertex_at(const visual_wall *w, const lattice *l, uint32_t i, uint32_t k)
{
    const uint32_t n = w->divisions, *node = l->node;
    if (k == 0) {
        return vertex_on_edge(w, l->edge[0], node[0], node[1], i);
    }
    if (i == 0) {
        return vertex_on_edge(w, l->edge[2], node[0], node[2], k);
    }
    if (i + k == n) {
        return vertex_on_edge(w, l->edge[1], node[1], node[2], k);
    }
    /* Rows 1 to i - 1 have n - 2, n - 3, ... interior vertices. */
    return l->first_interior + (i - 1) * (2 * n - 2 - i) / 2 + k - 1;
}

/* The next triangle to write. */
typedef uint32_t (*triangle_cursor)[3];

static void put_triangle(triangle_cursor *next, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *out = *(*next)++;
    out[0] = a;
    out[1] = b;
    out[2] = c;
}

static void put_face_triangles(const visual_wall *w, triangle_cursor *next, uint32_t a, uint32_t b,
                               uint32_t c)
{
    const uint32_t outer = w->first_vertex, inner = w->first_vertex + w->face_count;
    put_triangle(next, outer + a, outer + b, outer + c);
    put_triangle(next, inner + a, inner + c, inner + b);
}

static void write_face_triangles(const visual_wall *w, triangle_cursor *next)
{
    const scene_drain_info *d = w->drain;
    const uint32_t n = w->divisions;
    lattice l = {.first_interior = d->node_count + d->edge_count * (n - 1)};
    for (uint32_t t = 0; t < d->triangle_count; t++) {
        l.node = d->triangles[t];
        for (int k = 0; k < 3; k++) {
            l.edge[k] = find_edge(d, l.node[k], l.node[(k + 1) % 3]);
        }
        for (uint32_t i = 0; i < n; i++) {
            for (uint32_t k = 0; i + k < n; k++) {
                uint32_t b = vertex_at(w, &l, i + 1, k), c = vertex_at(w, &l, i, k + 1);
                put_face_triangles(w, next, vertex_at(w, &l, i, k), b, c);
                if (i + k + 1 < n) {
                    put_face_triangles(w, next, b, vertex_at(w, &l, i + 1, k + 1), c);
                }
            }
        }
        l.first_interior += visual_interior_vertices(n);
    }
}

static void write_rim_triangles(const visual_wall *w, triangle_cursor *next)
{
    uint32_t vertex = w->first_vertex + 2 * w->face_count;
    for (uint32_t i = 0; i < w->rim_count; i++) {
        for (uint32_t k = 0; k < w->divisions; k++) {
            put_triangle(next, vertex, vertex + 1, vertex + 2);
            put_triangle(next, vertex + 1, vertex + 3, vertex + 2);
            vertex += 2;
        }
        vertex += 2;
    }
}

void vbss_visual_write_wall_topology(const visual_wall *w)
{
    triangle_cursor next = w->triangles;
    write_node_attributes(w);
    write_edge_attributes(w);
    write_interior_attributes(w);
    write_face_triangles(w, &next);
    write_rim_triangles(w, &next);
}

void vbss_visual_copy_wall_topology(const visual_wall *w, const visual_frame *from,
                                    const visual_wall_record *record)
{
    const uint32_t vertices = visual_wall_vertices(w), words = 3 * visual_wall_triangles(w);
    const uint32_t offset = w->first_vertex - record->first_vertex; /* modulo 2^32 */
    const visual_vertex *vertex = &from->vertices[record->first_vertex];
    const uint32_t *index = from->triangles[record->first_triangle];
    uint32_t *out = w->triangles[0];
    for (uint32_t i = 0; i < vertices; i++) {
        memcpy(w->outer[i].texture, vertex[i].texture, sizeof vertex->texture);
        memcpy(w->outer[i].material, vertex[i].material, sizeof vertex->material);
        w->outer[i].value = vertex[i].value;
    }
    for (uint32_t i = 0; i < words; i++) {
        out[i] = index[i] + offset;
    }
}
