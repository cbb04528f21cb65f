/* Draws a drain as a wall of finite thickness.
 *
 * Curved patches over the triangles are the middle surface. All edges have the same number of
 * divisions. The outer and the inner face are half the thickness away from them. Rims close the
 * wall where the mesh ends: at both ends of the tube and along the slit. The vertices of a face are
 * numbered by node, then by edge, then by triangle, so neighbouring triangles share them. */
#include "visual/visual.h"

typedef struct wall {
    const visual_object *v;
    visual_frame *frame;
    const scene_drain_info *drain;
    const vec3 *normals; /* per node, unit */
    uint32_t divisions;  /* per edge */
    /* Vertex of node 0 on the outer face; offset from there to its vertex on the inner face. */
    uint32_t first_vertex, inner_face_offset;
    double half_thickness; /* m */
} wall;

/* The normal of a node is the weighted mean of the normals of its triangles. The weight is
 * sin(angle) / (|a| |b|) for the edges a and b at the node; exact on a sphere (Max 1999). */
static void compute_normals(const scene_drain_info *d, vec3 *normals)
{
    for (uint32_t i = 0; i < d->node_count; i++) {
        normals[i] = vec3_zero();
    }
    for (uint32_t t = 0; t < d->triangle_count; t++) {
        const uint32_t *node = d->triangles[t];
        const vec3 x[3] = {d->positions[node[0]], d->positions[node[1]], d->positions[node[2]]};
        vec3 normal = vec3_cross(vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]));
        double squared[3]; /* squared length of the edge from corner k to the next */
        for (int k = 0; k < 3; k++) {
            squared[k] = vbss_max(vec3_norm_squared(vec3_sub(x[(k + 1) % 3], x[k])), 1e-300);
        }
        for (int k = 0; k < 3; k++) {
            double weight = 1.0 / (squared[k] * squared[(k + 2) % 3]);
            normals[node[k]] = vec3_add_scaled(normals[node[k]], weight, normal);
        }
    }
    for (uint32_t i = 0; i < d->node_count; i++) {
        normals[i] = vec3_unit_or(normals[i], vec3_make(0.0, 1.0, 0.0));
    }
}

static visual_edge edge_between(const wall *w, uint32_t a, uint32_t b)
{
    const vec3 *x = w->drain->positions;
    const vec3 ends[2] = {x[a], x[b]}, normals[2] = {w->normals[a], w->normals[b]};
    return vbss_visual_make_edge(ends, normals);
}

/* Divisions that the most curved edge needs. */
static uint32_t count_divisions(const wall *w)
{
    double chord_error = 0.0;
    for (uint32_t i = 0; i < w->drain->edge_count; i++) {
        const uint32_t *node = w->drain->edges[i];
        const visual_edge edge = edge_between(w, node[0], node[1]);
        chord_error = vbss_max(chord_error, vbss_visual_edge_chord_error(&edge));
    }
    double divisions = sqrt(chord_error / w->v->config.surface_tolerance);
    return (uint32_t)vbss_max(vbss_min(divisions, w->v->config.division_limit) + 0.999, 1.0);
}

/* ---- vertices */

/* Attributes of a vertex that are interpolated linearly. */
typedef struct vertex_attributes {
    vec3 rest;
    double texture[2];
} vertex_attributes;

static vertex_attributes attributes_at(const wall *w, uint32_t node)
{
    const scene_drain_info *d = w->drain;
    const vertex_attributes attributes = {
        d->rest_positions[node],
        {d->material_coordinates[node][1], fabs(d->material_coordinates[node][0])}};
    return attributes;
}

static vertex_attributes interpolate_attributes(const vertex_attributes *of, const double *weights,
                                                int count)
{
    vertex_attributes sum = {vec3_zero(), {0.0, 0.0}};
    for (int k = 0; k < count; k++) {
        sum.rest = vec3_add_scaled(sum.rest, weights[k], of[k].rest);
        sum.texture[0] += weights[k] * of[k].texture[0];
        sum.texture[1] += weights[k] * of[k].texture[1];
    }
    return sum;
}

static void put_face_vertices(const wall *w, uint32_t index, vec3 middle, vec3 normal,
                              const vertex_attributes *m)
{
    visual_point p = {vec3_add_scaled(middle, w->half_thickness, normal),
                      normal,
                      {m->texture[0], m->texture[1]},
                      m->rest,
                      1.0};
    visual_set_vertex(w->v, w->frame, w->first_vertex + index, &p);
    p.position = vec3_add_scaled(middle, -w->half_thickness, normal);
    p.normal = vec3_neg(normal);
    p.value = -1.0;
    visual_set_vertex(w->v, w->frame, w->first_vertex + w->inner_face_offset + index, &p);
}

static void put_node_vertices(const wall *w)
{
    for (uint32_t i = 0; i < w->drain->node_count; i++) {
        const vertex_attributes m = attributes_at(w, i);
        put_face_vertices(w, i, w->drain->positions[i], w->normals[i], &m);
    }
}

static void put_edge_vertices(const wall *w)
{
    const scene_drain_info *d = w->drain;
    const uint32_t inner = w->divisions - 1;
    for (uint32_t i = 0; i < d->edge_count; i++) {
        const uint32_t *node = d->edges[i];
        const visual_edge edge = edge_between(w, node[0], node[1]);
        const vertex_attributes ends[2] = {attributes_at(w, node[0]), attributes_at(w, node[1])};
        for (uint32_t k = 0; k < inner; k++) {
            double fraction = (double)(k + 1) / (double)w->divisions;
            const double weights[2] = {1.0 - fraction, fraction};
            vec3 normal, x = vbss_visual_edge_point(&edge, fraction, &normal);
            const vertex_attributes attributes = interpolate_attributes(ends, weights, 2);
            put_face_vertices(w, d->node_count + i * inner + k, x, normal, &attributes);
        }
    }
}

/* Number of vertices strictly inside a divided triangle. */
static uint32_t interior_vertex_count(uint32_t divisions)
{
    return divisions < 3 ? 0 : (divisions - 1) * (divisions - 2) / 2;
}

static void put_interior_vertices(const wall *w)
{
    const scene_drain_info *d = w->drain;
    const uint32_t n = w->divisions;
    uint32_t index = d->node_count + d->edge_count * (n - 1);
    for (uint32_t t = 0; t < d->triangle_count && n > 2; t++) {
        const uint32_t *node = d->triangles[t];
        const visual_edge edges[3] = {edge_between(w, node[0], node[1]),
                                      edge_between(w, node[1], node[2]),
                                      edge_between(w, node[2], node[0])};
        const visual_patch patch = vbss_visual_make_patch(edges);
        const vertex_attributes corners[3] = {attributes_at(w, node[0]), attributes_at(w, node[1]),
                                              attributes_at(w, node[2])};
        for (uint32_t i = 1; i + 1 < n; i++) {
            for (uint32_t k = 1; i + k < n; k++) {
                const double weights[3] = {(double)(n - i - k) / (double)n, (double)i / (double)n,
                                           (double)k / (double)n};
                vec3 normal, x = vbss_visual_patch_point(&patch, weights, &normal);
                const vertex_attributes attributes = interpolate_attributes(corners, weights, 3);
                put_face_vertices(w, index++, x, normal, &attributes);
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
static uint32_t vertex_on_edge(const wall *w, uint32_t edge, uint32_t a, uint32_t b, uint32_t k)
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
static uint32_t vertex_at(const wall *w, const lattice *l, uint32_t i, uint32_t k)
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

static void add_face_triangles(const wall *w, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t outer = w->first_vertex, inner = w->first_vertex + w->inner_face_offset;
    visual_add_triangle(w->v, w->frame, outer + a, outer + b, outer + c);
    visual_add_triangle(w->v, w->frame, inner + a, inner + c, inner + b);
}

static void add_triangles(const wall *w)
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
                add_face_triangles(w, vertex_at(w, &l, i, k), b, c);
                if (i + k + 1 < n) {
                    add_face_triangles(w, b, vertex_at(w, &l, i + 1, k + 1), c);
                }
            }
        }
        l.first_interior += interior_vertex_count(n);
    }
}

/* ---- rims: flat strips between the faces, which share no vertices with them: rims are sharp */

static void put_rim_vertices(const wall *w, const visual_edge *edge, double fraction,
                             const vertex_attributes *attributes)
{
    const uint32_t first = w->frame->vertex_count;
    vec3 normal, middle = vbss_visual_edge_point(edge, fraction, &normal);
    vec3 chord = vec3_sub(edge->corner[1], edge->corner[0]);
    vec3 out = vec3_cross(chord, normal);
    visual_point p = {vec3_add_scaled(middle, w->half_thickness, normal),
                      vec3_unit_or(out, normal),
                      {attributes->texture[0], attributes->texture[1]},
                      attributes->rest,
                      0.0};
    w->frame->vertex_count += 2;
    visual_set_vertex(w->v, w->frame, first, &p);
    p.position = vec3_add_scaled(middle, -w->half_thickness, normal);
    visual_set_vertex(w->v, w->frame, first + 1, &p);
}

static void draw_rims(const wall *w)
{
    const scene_drain_info *d = w->drain;
    for (uint32_t i = 0; i < d->edge_count; i++) {
        const uint32_t *node = d->edges[i];
        if (d->edges[i][3] != SCENE_INSPECT_NONE) {
            continue;
        }
        const visual_edge edge = edge_between(w, node[0], node[1]);
        const vertex_attributes ends[2] = {attributes_at(w, node[0]), attributes_at(w, node[1])};
        for (uint32_t k = 0; k <= w->divisions; k++) {
            double fraction = (double)k / (double)w->divisions;
            const double weights[2] = {1.0 - fraction, fraction};
            const vertex_attributes attributes = interpolate_attributes(ends, weights, 2);
            put_rim_vertices(w, &edge, fraction, &attributes);
            if (k > 0) {
                uint32_t current = w->frame->vertex_count - 2, previous = current - 2;
                visual_add_triangle(w->v, w->frame, previous, previous + 1, current);
                visual_add_triangle(w->v, w->frame, previous + 1, current + 1, current);
            }
        }
    }
}

/* ---- marks */

static void add_mark_decals(const wall *w)
{
    const scene_drain_info *d = w->drain;
    for (int k = 0; k < 2; k++) {
        if (d->marks[k] != SCENE_INSPECT_NONE) {
            vbss_visual_add_decal(w->v, w->frame, VBSS_SPOT_MARK, d->rest_positions[d->marks[k]],
                                  w->v->config.mark_radius);
        }
    }
}

void vbss_visual_draw_drain(visual_object *v, visual_frame *f, const scene_drain_info *d)
{
    wall w = {v, f, d, v->node_vectors, 1, f->vertex_count, 0, 0.5 * d->thickness};
    compute_normals(d, v->node_vectors);
    w.divisions = count_divisions(&w);
    w.inner_face_offset = d->node_count + d->edge_count * (w.divisions - 1) +
                          d->triangle_count * interior_vertex_count(w.divisions);
    f->vertex_count += 2 * w.inner_face_offset;
    put_node_vertices(&w);
    put_edge_vertices(&w);
    put_interior_vertices(&w);
    add_triangles(&w);
    draw_rims(&w);
    add_mark_decals(&w);
}
