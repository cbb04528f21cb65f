/* Shapes: adding, removing, moving. */
#include "collision/shapes.h"

#include <string.h>

#include "base/check.h"
#include "base/double_double.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/stream.h"

#define LARGEST_RADIUS 1e29

/* ---- memory: one table says what there is; what is not needed stays NULL */

enum { PARTS = 23 + NEAR_PARTS };

typedef struct part_list {
    vbss_array parts[PARTS];
    size_t count;
} part_list;

/* `pointer` is the address of the shape's pointer to the array. */
static void add_part(part_list *list, void *pointer, size_t count, size_t size)
{
    const vbss_array part = {pointer, count, size};
    if (count > 0) {
        list->parts[list->count++] = part;
    }
}

static void add_tree(part_list *list, collision_tree *tree, uint32_t features, bool ordered)
{
    size_t groups = vbss_collision_tree_groups(features);
    add_part(list, &tree->boxes, features, sizeof *tree->boxes);
    add_part(list, &tree->group_boxes, groups, sizeof *tree->group_boxes);
    add_part(list, &tree->groups, groups, sizeof *tree->groups);
    /* A single group has no use for an order. */
    add_part(list, &tree->order, ordered && features > TREE_LANES ? features : 0,
             sizeof *tree->order);
}

static void list_parts(collision_shape *s, part_list *list)
{
    bool chain = s->kind == SHAPE_CHAIN;
    uint32_t n = s->node_capacity, e = chain ? n - 1 : s->edge_count, t = s->triangle_count;
    list->count = 0;
    add_part(list, &s->start, n, sizeof *s->start);
    add_part(list, &s->end, n, sizeof *s->end);
    add_part(list, &s->edges, e, sizeof *s->edges);
    add_part(list, &s->triangles, t, sizeof *s->triangles);
    add_part(list, &s->far_before, chain ? e : 0, sizeof *s->far_before);
    add_part(list, &s->far_after, chain ? (e + TREE_LANES - 1) / TREE_LANES : 0,
             sizeof *s->far_after);
    add_part(list, &s->edge_rows, e, sizeof *s->edge_rows);
    add_part(list, &s->point_rows, n, sizeof *s->point_rows);
    add_part(list, &s->goes, s->keeps_apart ? n : 0, sizeof *s->goes);
    add_part(list, &s->gone, s->keeps_apart ? n : 0, sizeof *s->gone);
    add_part(list, &s->known_start, s->keeps_apart ? n : 0, sizeof *s->known_start);
    add_tree(list, &s->point_tree, n, !chain);
    add_tree(list, &s->edge_tree, e, !chain);
    add_tree(list, &s->triangle_tree, t, true);
    if (s->near.words > 0) {
        vbss_collision_near_parts(s, &s->near, list->parts + list->count);
        list->count += NEAR_PARTS;
    }
}

void vbss_collision_shape_free(vbss_context *context, collision_shape *s)
{
    part_list list;
    list_parts(s, &list);
    vbss_release_arrays(context, list.parts, list.count);
    vbss_release(context, s, 1, sizeof *s);
}

/* By which the boxes of a shape's features are larger than their swept vertices, so that two features
 * that come within D (1 + tolerance) + margin of each other have overlapping boxes: each has its
 * radius and half of thickness and margin. The factor is more than the few roundings here and in D
 * can lose, and DBL_MIN what they lose of numbers too small to be normal. Rounding in `low - reach`
 * and `high + reach` loses nothing, as it keeps the order of any two numbers: docs/collision.md. */
static double reach_of(const vbss_collision_config *config, double radius)
{
    double share = (radius + 0.5 * config->thickness) * (1.0 + config->tolerance);
    return (share + 0.5 * config->margin) * (1.0 + 8.0 * DBL_EPSILON) + DBL_MIN;
}

/* A shape without topology. Its counts are in range. */
static vbss_result make(collision_object *c, collision_shape_kind kind, const uint32_t counts[3],
                        double radius, collision_shape **shape)
{
    collision_shape *s = vbss_allocate(c->context, 1, sizeof *s, "shape");
    part_list list;
    *shape = NULL;
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->kind = kind;
    s->node_count = s->node_capacity = counts[0];
    s->edge_count = counts[1];
    s->triangle_count = counts[2];
    s->radius = radius;
    s->category = 1;
    s->mask = UINT32_MAX;
    s->reach = reach_of(&c->config, radius);
    s->keeps_apart = c->keeps_apart;
    list_parts(s, &list);
    vbss_result result = vbss_allocate_arrays(c->context, list.parts, list.count, "shape");
    if (result != VBSS_OK) {
        vbss_collision_shape_free(c->context, s);
        return result;
    }
    vbss_collision_tree_set_count(&s->point_tree, s->node_count);
    vbss_collision_tree_set_count(&s->edge_tree, s->edge_count);
    vbss_collision_tree_set_count(&s->triangle_tree, s->triangle_count);
    *shape = s;
    return VBSS_OK;
}

static uint64_t topology_of(collision_shape *s)
{
    vbss_stream stream;
    uint32_t counts[4] = {(uint32_t)s->kind, s->node_count, s->edge_count, s->triangle_count};
    vbss_stream_begin_hash(&stream);
    vbss_stream_u32(&stream, 1, counts, 4);
    vbss_stream_f64(&stream, 2, &s->radius, 1);
    if (s->kind == SHAPE_CHAIN) {
        vbss_stream_u32(&stream, 3, s->far_before, s->edge_count);
    }
    if (s->kind == SHAPE_MESH) {
        vbss_stream_u32(&stream, 4, s->triangles[0], 3u * (size_t)s->triangle_count);
    }
    if (s->near.words > 0) { /* a triangle's are those of its edges */
        vbss_stream_u64(&stream, 5, s->near.edges, (size_t)s->edge_count * s->near.words);
    }
    return vbss_hash_end(&stream.hash);
}

/* Names a finished shape. */
static void publish(collision_object *c, collision_shape *s, uint32_t *name)
{
    s->topology = topology_of(s);
    *name = c->shape_count;
    c->shapes[c->shape_count++] = s;
    c->living_known = false;
    vbss_collision_forget(c);
    c->generation++;
}

/* What all shapes have to be asked first. */
static vbss_result check_new(const collision_object *c, double radius, const uint32_t *name)
{
    VBSS_TRY(vbss_check_pointer(c->context, name, "shape"));
    if (radius != 0.0) {
        VBSS_TRY(
            vbss_check_range(c->context, radius, COLLISION_THINNEST, LARGEST_RADIUS, "radius"));
    }
    if (c->shape_count >= c->config.shape_capacity) {
        return vbss_fail(c->context, VBSS_ERROR_CAPACITY, "shape_capacity is %u",
                         c->config.shape_capacity);
    }
    return VBSS_OK;
}

/* ---- chains */

/* sum += x, in twice the digits: whoever asks for an exact multiple of D must get it. */
static void add_exactly(double sum[2], double x)
{
    double s = sum[0] + x, added = s - sum[0];
    double error = ((sum[0] - (s - added)) + (x - added)) + sum[1];
    sum[0] = s + error;
    sum[1] = error - (sum[0] - s);
}

static bool reaches(const double arc[2], const double limit[2])
{
    double difference[2] = {arc[0], arc[1]};
    add_exactly(difference, -limit[0]);
    add_exactly(difference, -limit[1]);
    return difference[0] >= 0.0;
}

/* far_before and far_after. The arc between edge `before` and edge b is that of the edges between them;
 * both only go forward. */
static void measure_arcs(collision_shape *s, const double *rest_lengths, const double limit[2])
{
    double arc[2] = {0.0, 0.0};
    uint32_t before = 0, group = 0, groups = (s->edge_count + TREE_LANES - 1) / TREE_LANES;
    for (uint32_t b = 2; b < s->edge_count; b++) {
        add_exactly(arc, rest_lengths != NULL ? rest_lengths[b - 1] : 0.0);
        while (before + 2 <= b && (rest_lengths == NULL || reaches(arc, limit))) {
            before++;
            add_exactly(arc, rest_lengths != NULL ? -rest_lengths[before] : 0.0);
        }
        s->far_before[b] = before;
        while (group < groups && group * TREE_LANES < before) {
            s->far_after[group++] = b;
        }
    }
    while (group < groups) {
        s->far_after[group++] = s->edge_count;
    }
}

static void measure_chain(const collision_object *c, collision_shape *s, const double *rest_lengths)
{
    double limit[2];
    limit[0] = two_product(c->config.exclusion, vbss_collision_distance(c, s, s), &limit[1]);
    measure_arcs(s, rest_lengths, limit);
}

static void number_edges(collision_shape *s)
{
    for (uint32_t i = 0; i < s->edge_count; i++) {
        s->edges[i][0] = i;
        s->edges[i][1] = i + 1;
    }
}

static vbss_result check_chain(const collision_object *c, uint32_t node_count,
                               const double *rest_lengths)
{
    VBSS_TRY(vbss_check_range(c->context, node_count, 2.0, 65537.0, "node_count"));
    for (uint32_t i = 0; rest_lengths != NULL && i + 1 < node_count; i++) {
        if (!(rest_lengths[i] >= 0.0 && rest_lengths[i] <= COLLISION_FARTHEST)) {
            vbss_result result =
                isfinite(rest_lengths[i]) ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE;
            return vbss_fail(c->context, result, "rest_lengths[%u] is %g, outside [0, %g]", i,
                             rest_lengths[i], COLLISION_FARTHEST);
        }
    }
    return VBSS_OK;
}

vbss_result vbss_collision_add_chain(vbss_collision *collision, uint32_t node_count,
                                     const double *rest_lengths, double radius, uint32_t *shape)
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(check_chain(c, node_count, rest_lengths));
    VBSS_TRY(check_new(c, radius, shape));
    const uint32_t counts[3] = {node_count, node_count - 1, 0};
    VBSS_TRY(make(c, SHAPE_CHAIN, counts, radius, &s));
    number_edges(s);
    measure_chain(c, s, rest_lengths);
    publish(c, s, shape);
    return VBSS_OK;
}

/* ---- chains that change */

vbss_result vbss_collision_add_sleeping_chain(collision_object *c, uint32_t node_capacity,
                                              double radius, uint32_t *name)
{
    collision_shape *s = NULL;
    const uint32_t counts[3] = {node_capacity, node_capacity - 1, 0};
    VBSS_TRY(check_new(c, radius, name));
    VBSS_TRY(make(c, SHAPE_CHAIN, counts, radius, &s));
    number_edges(s);
    s->asleep = true;
    publish(c, s, name);
    return VBSS_OK;
}

static void changed(collision_object *c, bool living)
{
    c->living_known = c->living_known && !living;
    vbss_collision_forget(c);
    c->generation++;
}

void vbss_collision_change_chain(collision_object *c, uint32_t name, uint32_t node_count,
                                 const double *rest_lengths)
{
    collision_shape *s = c->shapes[name];
    bool woken = s->asleep;
    s->asleep = false;
    s->start_known = false;
    s->node_count = node_count;
    s->edge_count = node_count - 1;
    vbss_collision_tree_set_count(&s->point_tree, s->node_count);
    vbss_collision_tree_set_count(&s->edge_tree, s->edge_count);
    measure_chain(c, s, rest_lengths);
    s->topology = topology_of(s);
    vbss_collision_shape_moved(s);
    changed(c, woken);
}

void vbss_collision_send_to_sleep(collision_object *c, uint32_t name)
{
    c->shapes[name]->asleep = true;
    changed(c, true);
}

/* ---- capsules */

vbss_result vbss_collision_add_capsules(vbss_collision *collision, uint32_t capsule_count,
                                        double radius, uint32_t *shape)
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_check_range(c->context, capsule_count, 1.0, 32768.0, "capsule_count"));
    VBSS_TRY(check_new(c, radius, shape));
    const uint32_t counts[3] = {2 * capsule_count, capsule_count, 0};
    VBSS_TRY(make(c, SHAPE_CAPSULES, counts, radius, &s));
    for (uint32_t i = 0; i < s->edge_count; i++) {
        s->edges[i][0] = 2 * i;
        s->edges[i][1] = 2 * i + 1;
    }
    publish(c, s, shape);
    return VBSS_OK;
}

/* ---- meshes */

static vbss_result check_triangles(const collision_object *c, uint32_t node_count,
                                   const uint32_t *triangles, uint32_t triangle_count)
{
    for (uint32_t i = 0; i < triangle_count; i++) {
        const uint32_t *n = triangles + 3 * (size_t)i;
        for (int k = 0; k < 3; k++) {
            if (n[k] >= node_count) {
                return vbss_fail(c->context, VBSS_ERROR_OUT_OF_RANGE,
                                 "triangle %u has node %u of %u", i, n[k], node_count);
            }
            if (n[k] == n[(k + 1) % 3]) {
                return vbss_fail(c->context, VBSS_ERROR_OUT_OF_RANGE,
                                 "triangle %u has node %u twice", i, n[k]);
            }
        }
    }
    return VBSS_OK;
}

typedef uint32_t node_pair[2];

/* Keeps the order of pairs whose node `which` is the same. `places` has node_count + 1 entries. */
static void sort_by_node(node_pair *from, node_pair *to, uint32_t count, int which,
                         uint32_t *places, uint32_t node_count)
{
    memset(places, 0, (node_count + 1) * sizeof *places);
    for (uint32_t i = 0; i < count; i++) {
        places[from[i][which] + 1]++;
    }
    for (uint32_t i = 0; i < node_count; i++) {
        places[i + 1] += places[i];
    }
    for (uint32_t i = 0; i < count; i++) {
        memcpy(to[places[from[i][which]]++], from[i], sizeof *from);
    }
}

/* The three sides of each triangle, lower node first, sorted, each once; returns how many. */
static uint32_t list_edges(const uint32_t *triangles, uint32_t triangle_count, uint32_t node_count,
                           node_pair *edges, node_pair *spare, uint32_t *places)
{
    uint32_t count = 0, kept = 0;
    for (uint32_t i = 0; i < triangle_count; i++) {
        const uint32_t *n = triangles + 3 * (size_t)i;
        for (int k = 0; k < 3; k++, count++) {
            uint32_t p = n[k], q = n[(k + 1) % 3];
            edges[count][0] = p < q ? p : q;
            edges[count][1] = p < q ? q : p;
        }
    }
    sort_by_node(edges, spare, count, 1, places, node_count);
    sort_by_node(spare, edges, count, 0, places, node_count);
    for (uint32_t i = 0; i < count; i++) {
        if (kept == 0 || memcmp(edges[kept - 1], edges[i], sizeof *edges) != 0) {
            memmove(edges[kept++], edges[i], sizeof *edges);
        }
    }
    return kept;
}

vbss_result vbss_collision_add_mesh(vbss_collision *collision, uint32_t node_count,
                                    const uint32_t *triangles, uint32_t triangle_count,
                                    double radius, uint32_t *shape)
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_check_range(c->context, node_count, 3.0, 65536.0, "node_count"));
    VBSS_TRY(vbss_check_range(c->context, triangle_count, 1.0, 131072.0, "triangle_count"));
    VBSS_TRY(vbss_check_pointer(c->context, triangles, "triangles"));
    VBSS_TRY(check_triangles(c, node_count, triangles, triangle_count));
    VBSS_TRY(check_new(c, radius, shape));

    size_t sides = 3u * (size_t)triangle_count;
    node_pair *edges = NULL, *spare = NULL;
    uint32_t *places = NULL;
    const vbss_array working[] = {{&edges, sides, sizeof *edges},
                                  {&spare, sides, sizeof *spare},
                                  {&places, (size_t)node_count + 1, sizeof *places}};
    vbss_result result = vbss_allocate_arrays(c->context, working, 3, "edges of a mesh");
    if (result == VBSS_OK) {
        uint32_t edge_count =
            list_edges(triangles, triangle_count, node_count, edges, spare, places);
        const uint32_t counts[3] = {node_count, edge_count, triangle_count};
        result = make(c, SHAPE_MESH, counts, radius, &s);
    }
    if (result == VBSS_OK) {
        memcpy(s->edges, edges, s->edge_count * sizeof *edges);
        memcpy(s->triangles, triangles, sides * sizeof *triangles);
        publish(c, s, shape);
    }
    vbss_release_arrays(c->context, working, 3);
    return result;
}

/* ---- living with shapes */

void vbss_collision_rules_changed(collision_object *c, collision_shape *s)
{
    s->topology = topology_of(s);
    vbss_collision_forget(c);
    c->generation++;
}

vbss_result vbss_collision_find_shape(const collision_object *c, uint32_t name,
                                      collision_shape **shape)
{
    *shape = name < c->shape_count ? c->shapes[name] : NULL;
    if (*shape == NULL) {
        vbss_fail(c->context, VBSS_ERROR_OUT_OF_RANGE, "there is no shape %u", name);
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    return VBSS_OK;
}

vbss_result vbss_collision_remove(vbss_collision *collision, uint32_t shape)
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    c->shapes[shape] = NULL; /* first: the host's release may look at the object */
    c->living_known = false;
    vbss_collision_forget(c);
    c->generation++;
    vbss_collision_shape_free(c->context, s);
    return VBSS_OK;
}

vbss_result vbss_collision_set_filter(vbss_collision *collision, uint32_t shape, uint32_t category,
                                      uint32_t mask)
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    s->category = category;
    s->mask = mask;
    vbss_collision_forget(c);
    c->generation++;
    return VBSS_OK;
}

vbss_result vbss_collision_move(vbss_collision *collision, uint32_t shape, const double *start,
                                const double *end, uint32_t node_count)
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    VBSS_TRY(vbss_check_range(c->context, node_count, s->node_count, s->node_count, "node_count"));
    VBSS_TRY(vbss_check_pointer(c->context, end, "end"));
    size_t numbers = 3u * (size_t)node_count, bytes = node_count * sizeof(vec3);
    if (start != NULL) {
        VBSS_TRY(vbss_collision_check_coordinates(c->context, start, numbers, "start"));
    }
    VBSS_TRY(vbss_collision_check_coordinates(c->context, end, numbers, "end"));
    memcpy(s->start, start != NULL ? start : &s->end[0].x, bytes);
    memcpy(s->end, end, bytes);
    vbss_collision_shape_moved(s);
    vbss_collision_forget(c); /* candidates of other places would miss */
    c->generation++;
    return VBSS_OK;
}

vbss_result vbss_collision_get_edge(vbss_collision *collision, uint32_t shape, uint32_t edge,
                                    uint32_t nodes[2])
{
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_open(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    VBSS_TRY(vbss_check_range(c->context, edge, 0.0, s->edge_count - 1.0, "edge"));
    VBSS_TRY(vbss_check_pointer(c->context, nodes, "nodes"));
    memcpy(nodes, s->edges[edge], sizeof s->edges[edge]);
    return VBSS_OK;
}

void vbss_collision_end_elsewhere(collision_shape *s, const vec3 *end)
{
    memcpy(s->end, end, s->node_count * sizeof *end);
}
