/* The vertices of a wall, four nodes, edges or triangles at a time. A tube has more than four of
 * each. If fewer are left, some of those before them are computed and stored once more. */
#include "base/simd_dispatch.h"
#include "visual/vertex_lanes.h"

/* ---- normals of nodes */

/* The weight of a triangle at a node is 1 / (|a|^2 |b|^2) for its edges a and b there, and its
 * normal is a x b (Max 1999). */
static void find_terms(const vlanes x[3], vlanes terms[3])
{
    const vlanes edge[3] = {v_sub(x[1], x[0]), v_sub(x[2], x[1]), v_sub(x[2], x[0])};
    const vlanes normal = v_cross(edge[0], edge[2]);
    lanes squared[3];
    for (int k = 0; k < 3; k++) {
        squared[k] = lanes_max(v_dot(edge[k], edge[k]), lanes_splat(1e-300));
    }
    for (int k = 0; k < 3; k++) {
        const lanes both = lanes_times(squared[k], squared[k == 0 ? 2 : k - 1]);
        terms[k] = v_scale(normal, lanes_div(lanes_splat(1.0), both));
    }
}

static void normalise(vec3 *normals, uint32_t count)
{
    for (uint32_t i = 0; i < count; i += LANES) {
        uint32_t index[LANES];
        clamp_indices(i, count - 1, index);
        v_scatter(normals, index,
                  v_unit_or(v_gather(normals, index), v_splat(vec3_make(0.0, 1.0, 0.0))));
    }
}

/* Adds the terms of `count` triangles from number t on, one triangle after the other. */
static void add_terms(const visual_wall *w, uint32_t t, uint32_t count, const vlanes terms[3])
{
    double numbers[3][3][LANES];
    for (int k = 0; k < 3; k++) {
        lanes_store(numbers[k][0], terms[k].x);
        lanes_store(numbers[k][1], terms[k].y);
        lanes_store(numbers[k][2], terms[k].z);
    }
    for (uint32_t l = 0; l < count; l++) {
        for (int k = 0; k < 3; k++) {
            vec3 *sum = &w->normals[w->drain->triangles[t + l][k]];
            const vec3 term = {numbers[k][0][l], numbers[k][1][l], numbers[k][2][l]};
            *sum = vec3_add(*sum, term);
        }
    }
}

void VBSS_WIDE_NAME(vbss_visual_find_wall_normals)(const visual_wall *w)
{
    const scene_drain_info *d = w->drain;
    for (uint32_t i = 0; i < d->node_count; i++) {
        w->normals[i] = vec3_zero();
    }
    for (uint32_t t = 0; t < d->triangle_count; t += LANES) {
        uint32_t index[LANES];
        vlanes x[3], terms[3];
        clamp_indices(t, d->triangle_count - 1, index);
        for (int k = 0; k < 3; k++) {
            const uint32_t nodes[LANES] = {d->triangles[index[0]][k], d->triangles[index[1]][k],
                                           d->triangles[index[2]][k], d->triangles[index[3]][k]};
            x[k] = v_gather(d->positions, nodes);
        }
        find_terms(x, terms);
        add_terms(w, t, d->triangle_count - t < LANES ? d->triangle_count - t : LANES, terms);
    }
    normalise(w->normals, d->node_count);
}

/* ---- curves of edges: cubic Bezier curves with quadratic normals */

typedef struct edge_curves {
    vlanes corner[2], control[2], normal[2], middle_normal; /* m; m; unit; unit */
} edge_curves;

/* The point at a third of the edge, projected into the tangent plane of the corner. */
static inline vlanes control_point(vlanes corner, vlanes other, vlanes normal)
{
    const vlanes chord = v_sub(other, corner);
    const vlanes flat = v_add_scaled(chord, lanes_scale(-1.0, v_dot(chord, normal)), normal);
    return v_add_scaled(corner, lanes_splat(1.0 / 3.0), flat);
}

/* The mean of the normals of the ends, reflected in the middle plane, so that an inflection is
 * followed. */
static inline vlanes middle_normal(const edge_curves *e)
{
    const vlanes chord = v_sub(e->corner[1], e->corner[0]), sum = v_add(e->normal[0], e->normal[1]);
    const lanes length = v_dot(chord, chord);
    const lanes twice = lanes_times(lanes_splat(-2.0), v_dot(chord, sum));
    const vlanes reflected = v_add_scaled(sum, lanes_div(twice, length), chord);
    const lanes_mask has_length = lanes_less(lanes_splat(0.0), length);
    return v_unit_or(v_select(has_length, reflected, sum), e->normal[0]);
}

static inline void set_controls(edge_curves *e)
{
    e->control[0] = control_point(e->corner[0], e->corner[1], e->normal[0]);
    e->control[1] = control_point(e->corner[1], e->corner[0], e->normal[1]);
    e->middle_normal = middle_normal(e);
}

static inline void set_edges(edge_curves *e, const visual_wall *w, const uint32_t index[LANES])
{
    uint32_t from[LANES], to[LANES];
    for (int l = 0; l < LANES; l++) {
        from[l] = w->drain->edges[index[l]][0];
        to[l] = w->drain->edges[index[l]][1];
    }
    e->corner[0] = v_gather(w->drain->positions, from);
    e->corner[1] = v_gather(w->drain->positions, to);
    e->normal[0] = v_gather(w->normals, from);
    e->normal[1] = v_gather(w->normals, to);
    set_controls(e);
}

/* Point and unit normal at the fraction k / n. At an end both are those of the node. */
static inline vlanes edge_point(const edge_curves *e, uint32_t k, uint32_t n, vlanes *normal)
{
    if (k == 0 || k == n) {
        *normal = e->normal[k != 0];
        return e->corner[k != 0];
    }
    const double b = (double)k / (double)n, a = 1.0 - b;
    vlanes m = v_scale(e->normal[0], lanes_splat(a * a));
    m = v_add_scaled(m, lanes_splat(a * b), e->middle_normal);
    m = v_add_scaled(m, lanes_splat(b * b), e->normal[1]);
    *normal = v_unit_or(m, e->normal[0]);
    vlanes x = v_scale(e->corner[0], lanes_splat(a * a * a));
    x = v_add_scaled(x, lanes_splat(3.0 * a * a * b), e->control[0]);
    x = v_add_scaled(x, lanes_splat(3.0 * a * b * b), e->control[1]);
    return v_add_scaled(x, lanes_splat(b * b * b), e->corner[1]);
}

/* Squared largest second difference of the curves. That of a cubic is largest at an end. */
static inline lanes second_difference(const edge_curves *e)
{
    const vlanes middle = v_sub(e->control[1], e->control[0]);
    const vlanes start = v_sub(middle, v_sub(e->control[0], e->corner[0]));
    const vlanes end = v_sub(v_sub(e->corner[1], e->control[1]), middle);
    return lanes_max(v_dot(start, start), v_dot(end, end));
}

/* ---- vertices of faces */

/* Stores four points of the middle surface on both faces, in vertices that are `step` apart.
 * `vertex` counts on a face. */
static inline void store_on_faces(const visual_wall *w, uint32_t vertex, uint32_t step,
                                  vlanes middle, vlanes normal)
{
    visual_vertex *outer = &w->outer[vertex], *inner = outer + w->face_count;
    const vlanes origin = v_splat(w->origin);
    const vlanes offset = v_scale(normal, lanes_splat(w->half_thickness));
    visual_store_points(outer, step, v_sub(v_add(middle, offset), origin), normal);
    visual_store_points(inner, step, v_sub(v_sub(middle, offset), origin),
                        v_scale(normal, lanes_splat(-1.0)));
}

static void write_nodes(const visual_wall *w)
{
    const uint32_t count = w->drain->node_count;
    for (uint32_t i = 0; i < count; i += LANES) {
        const uint32_t first = next_four(i, count);
        const uint32_t node[LANES] = {first, first + 1, first + 2, first + 3};
        store_on_faces(w, first, 1, v_gather(w->drain->positions, node),
                       v_gather(w->normals, node));
    }
}

double VBSS_WIDE_NAME(vbss_visual_write_wall_edges)(const visual_wall *w)
{
    const uint32_t inside = w->divisions - 1, count = w->drain->edge_count;
    lanes largest = lanes_splat(0.0);
    for (uint32_t i = 0; i < count; i += LANES) {
        const uint32_t first = next_four(i, count);
        const uint32_t edge[LANES] = {first, first + 1, first + 2, first + 3};
        edge_curves e;
        set_edges(&e, w, edge);
        largest = lanes_max(second_difference(&e), largest);
        for (uint32_t k = 0; k < inside; k++) {
            vlanes normal, x = edge_point(&e, k + 1, w->divisions, &normal);
            store_on_faces(w, w->drain->node_count + first * inside + k, inside, x, normal);
        }
    }
    double squared = 0.0;
    for (int l = 0; l < LANES; l++) {
        squared = vbss_max(squared, lanes_at(largest, l));
    }
    return 0.75 * sqrt(squared);
}

/* ---- patches over triangles */

typedef struct patches {
    vlanes corner[3], normal[3];            /* m; unit */
    vlanes control[3][2], middle_normal[3]; /* of the edge from corner k to the next one */
    vlanes centre;                          /* inner control point, m */
} patches;

/* Of four triangles, one after the other. */
static void set_patches(patches *p, const visual_wall *w, uint32_t triangle)
{
    const uint32_t(*of)[3] = &w->drain->triangles[triangle];
    vlanes controls = v_splat(vec3_zero()), corners = controls;
    for (int k = 0; k < 3; k++) {
        const uint32_t node[LANES] = {of[0][k], of[1][k], of[2][k], of[3][k]};
        p->corner[k] = v_gather(w->drain->positions, node);
        p->normal[k] = v_gather(w->normals, node);
    }
    for (int k = 0; k < 3; k++) {
        const int next = k == 2 ? 0 : k + 1;
        edge_curves e = {.corner = {p->corner[k], p->corner[next]},
                         .normal = {p->normal[k], p->normal[next]}};
        set_controls(&e);
        p->control[k][0] = e.control[0];
        p->control[k][1] = e.control[1];
        p->middle_normal[k] = e.middle_normal;
        controls = v_add(controls, v_add(e.control[0], e.control[1]));
        corners = v_add(corners, e.corner[0]);
    }
    p->centre =
        v_add_scaled(v_scale(controls, lanes_splat(0.25)), lanes_splat(-1.0 / 6.0), corners);
}

/* Point and unit normal at barycentric coordinates. */
static vlanes patch_point(const patches *p, const double weights[3], vlanes *normal)
{
    vlanes x = v_scale(p->centre, lanes_splat(6.0 * weights[0] * weights[1] * weights[2]));
    vlanes n = v_splat(vec3_zero());
    for (int k = 0; k < 3; k++) {
        const double a = weights[k], b = weights[k == 2 ? 0 : k + 1];
        x = v_add_scaled(x, lanes_splat(a * a * a), p->corner[k]);
        x = v_add_scaled(x, lanes_splat(3.0 * a * a * b), p->control[k][0]);
        x = v_add_scaled(x, lanes_splat(3.0 * a * b * b), p->control[k][1]);
        n = v_add_scaled(n, lanes_splat(a * a), p->normal[k]);
        n = v_add_scaled(n, lanes_splat(a * b), p->middle_normal[k]);
    }
    *normal = v_unit_or(n, p->normal[0]);
    return x;
}

/* Triangles whose patches are made before their points: many short chains of operations keep a
 * processor busier than a few long ones. */
enum { PATCH_BLOCK = 8 * LANES };

/* `vertex` is that of triangle 0. */
static void write_patch_points(const visual_wall *w, const patches *p, uint32_t start, uint32_t end,
                               const double weights[3], uint32_t vertex)
{
    const uint32_t step = visual_interior_vertices(w->divisions);
    for (uint32_t t = start; t < end; t += LANES, p++) {
        vlanes normal, x = patch_point(p, weights, &normal);
        store_on_faces(w, vertex + next_four(t, w->drain->triangle_count) * step, step, x, normal);
    }
}

/* Writes the vertices inside the triangles of a block. */
static void write_interior(const visual_wall *w, uint32_t start, uint32_t end)
{
    const uint32_t n = w->divisions;
    uint32_t vertex = w->drain->node_count + w->drain->edge_count * (n - 1);
    patches block[PATCH_BLOCK / LANES];
    for (uint32_t t = start; t < end; t += LANES) {
        set_patches(&block[(t - start) / LANES], w, next_four(t, w->drain->triangle_count));
    }
    for (uint32_t i = 1; i + 1 < n; i++) {
        for (uint32_t k = 1; i + k < n; k++) {
            const double weights[3] = {(double)(n - i - k) / (double)n, (double)i / (double)n,
                                       (double)k / (double)n};
            write_patch_points(w, block, start, end, weights, vertex++);
        }
    }
}

static void write_interiors(const visual_wall *w)
{
    const uint32_t count = w->drain->triangle_count;
    for (uint32_t t = 0; t < count && w->divisions > 2; t += PATCH_BLOCK) {
        write_interior(w, t, count - t < PATCH_BLOCK ? count : t + PATCH_BLOCK);
    }
}

/* ---- rims */

/* Writes the rims of four free edges. `first` is the number of the first one among them. */
static void write_rim(const visual_wall *w, const uint32_t edge[LANES], uint32_t first)
{
    edge_curves e;
    const vlanes origin = v_splat(w->origin);
    const uint32_t step = 2 * (w->divisions + 1); /* vertices of a rim */
    visual_vertex *out = &w->outer[2 * w->face_count + first * step];
    set_edges(&e, w, edge);
    const vlanes chord = v_sub(e.corner[1], e.corner[0]);
    for (uint32_t k = 0; k <= w->divisions; k++, out += 2) {
        vlanes normal, middle = edge_point(&e, k, w->divisions, &normal);
        const vlanes outward = v_unit_or(v_cross(chord, normal), normal);
        const vlanes offset = v_scale(normal, lanes_splat(w->half_thickness));
        visual_store_points(out, step, v_sub(v_add(middle, offset), origin), outward);
        visual_store_points(out + 1, step, v_sub(v_sub(middle, offset), origin), outward);
    }
}

static void write_rims(const visual_wall *w)
{
    uint32_t edge[LANES] = {0}, count = 0; /* the last four free edges */
    for (uint32_t i = 0; i < w->drain->edge_count; i++) {
        if (w->drain->edges[i][3] != SCENE_INSPECT_NONE) {
            continue;
        }
        memmove(edge, edge + 1, sizeof edge - sizeof *edge);
        edge[LANES - 1] = i;
        count++;
        if (count % LANES == 0 || count == w->rim_count) {
            write_rim(w, edge, count - LANES);
        }
    }
}

void VBSS_WIDE_NAME(vbss_visual_write_wall)(const visual_wall *w)
{
    write_nodes(w);
    write_interiors(w);
    write_rims(w);
}
