/* Shapes: creation, removal and motion. */
#include "base/number_text.h"
#include "collision/shapes.h"

#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/double_double.h"
#include "base/error.h"

#define MAX_RADIUS 1e29

void vbss_collision_register_shape(collision_object *c, collision_shape *s, uint32_t *id)
{
    s->topology_hash = vbss_collision_hash_topology(s);
    *id = c->shape_count;
    c->shapes[c->shape_count++] = s;
    c->active_valid = false;
    vbss_collision_clear_results(c);
    c->generation++;
}

void vbss_collision_skip_shapes(collision_object *c, uint32_t next)
{
    c->shape_count = next > c->shape_count ? next : c->shape_count;
}

vbss_result vbss_collision_check_new_shape(const collision_object *c, double radius,
                                           const uint32_t *id)
{
    VBSS_TRY(vbss_check_pointer(c->context, id, "shape"));
    if (radius != 0.0) {
        VBSS_TRY(
            vbss_check_range(c->context, radius, COLLISION_MIN_THICKNESS, MAX_RADIUS, "radius"));
    }
    if (c->shape_count >= c->config.shape_capacity) {
        return vbss_fail(c->context, VBSS_ERROR_CAPACITY, "shape_capacity is %u",
                         c->config.shape_capacity);
    }
    return VBSS_OK;
}

/* ---- chains */

/* sum += x in double-double arithmetic, so that an exact multiple of D is compared exactly. */
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

/* Computes far_before and far_after. The arc between two edges is that of the edges between them;
 * both indices only increase. */
static void measure_arcs(collision_shape *s, const double *rest_lengths, const double limit[2])
{
    double arc[2] = {0.0, 0.0};
    uint32_t before = 0, group = 0,
             groups = (s->edge_count + COLLISION_BVH_WIDTH - 1) / COLLISION_BVH_WIDTH;
    for (uint32_t b = 2; b < s->edge_count; b++) {
        add_exactly(arc, rest_lengths != NULL ? rest_lengths[b - 1] : 0.0);
        while (before + 2 <= b && (rest_lengths == NULL || reaches(arc, limit))) {
            before++;
            add_exactly(arc, rest_lengths != NULL ? -rest_lengths[before] : 0.0);
        }
        s->far_before[b] = before;
        while (group < groups && group * COLLISION_BVH_WIDTH < before) {
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
    limit[0] =
        two_product(c->config.exclusion, vbss_collision_contact_distance(c, s, s), &limit[1]);
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
        if (!(rest_lengths[i] >= 0.0 && rest_lengths[i] <= COLLISION_MAX_COORDINATE)) {
            vbss_result result =
                isfinite(rest_lengths[i]) ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE;
            return vbss_fail(c->context, result, "rest_lengths[%u] is %s, outside [0, %s]", i,
                             VBSS_NUMBER(rest_lengths[i]), VBSS_NUMBER(COLLISION_MAX_COORDINATE));
        }
    }
    return VBSS_OK;
}

vbss_result vbss_collision_add_chain(vbss_collision *collision, uint32_t node_count,
                                     const double *rest_lengths, double radius, uint32_t *shape)
{
    VBSS_ENTER(collision);
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(check_chain(c, node_count, rest_lengths));
    VBSS_TRY(vbss_collision_check_new_shape(c, radius, shape));
    const uint32_t counts[3] = {node_count, node_count - 1, 0};
    VBSS_TRY(vbss_collision_create_shape(c, COLLISION_SHAPE_CHAIN, counts, radius, &s));
    number_edges(s);
    measure_chain(c, s, rest_lengths);
    vbss_collision_register_shape(c, s, shape);
    return VBSS_OK;
}

/* ---- chains with a variable number of nodes */

vbss_result vbss_collision_add_disabled_chain(collision_object *c, uint32_t node_capacity,
                                              double radius, uint32_t *id)
{
    collision_shape *s = NULL;
    const uint32_t counts[3] = {node_capacity, node_capacity - 1, 0};
    VBSS_TRY(vbss_collision_check_new_shape(c, radius, id));
    VBSS_TRY(vbss_collision_create_shape(c, COLLISION_SHAPE_CHAIN, counts, radius, &s));
    number_edges(s);
    s->is_disabled = true;
    vbss_collision_register_shape(c, s, id);
    return VBSS_OK;
}

static void invalidate_results(collision_object *c, bool living)
{
    c->active_valid = c->active_valid && !living;
    vbss_collision_clear_results(c);
    c->generation++;
}

void vbss_collision_resize_chain(collision_object *c, uint32_t id, uint32_t node_count,
                                 const double *rest_lengths)
{
    collision_shape *s = c->shapes[id];
    bool was_disabled = s->is_disabled;
    s->is_disabled = false;
    s->has_search_start = s->has_loose_boxes = false;
    s->node_count = node_count;
    s->edge_count = node_count - 1;
    vbss_collision_bvh_set_count(&s->point_bvh, s->node_count);
    vbss_collision_bvh_set_count(&s->edge_bvh, s->edge_count);
    measure_chain(c, s, rest_lengths);
    s->topology_hash = vbss_collision_hash_topology(s);
    vbss_collision_shape_invalidate(s);
    invalidate_results(c, was_disabled);
}

void vbss_collision_disable_chain(collision_object *c, uint32_t id)
{
    c->shapes[id]->is_disabled = true;
    invalidate_results(c, true);
}

/* ---- capsules */

vbss_result vbss_collision_add_capsules(vbss_collision *collision, uint32_t capsule_count,
                                        double radius, uint32_t *shape)
{
    VBSS_ENTER(collision);
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_check_range(c->context, capsule_count, 1.0, 32768.0, "capsule_count"));
    VBSS_TRY(vbss_collision_check_new_shape(c, radius, shape));
    const uint32_t counts[3] = {2 * capsule_count, capsule_count, 0};
    VBSS_TRY(vbss_collision_create_shape(c, COLLISION_SHAPE_CAPSULES, counts, radius, &s));
    for (uint32_t i = 0; i < s->edge_count; i++) {
        s->edges[i][0] = 2 * i;
        s->edges[i][1] = 2 * i + 1;
    }
    vbss_collision_register_shape(c, s, shape);
    return VBSS_OK;
}

/* ---- queries and motion */

vbss_result vbss_collision_remove(vbss_collision *collision, uint32_t shape)
{
    VBSS_ENTER(collision);
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    /* before the release, because the host's function may read the object */
    c->shapes[shape] = NULL;
    c->active_valid = false;
    vbss_collision_clear_results(c);
    c->generation++;
    vbss_collision_shape_free(c->context, s);
    return VBSS_OK;
}

vbss_result vbss_collision_set_filter(vbss_collision *collision, uint32_t shape, uint32_t category,
                                      uint32_t mask)
{
    VBSS_ENTER(collision);
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    s->category = category;
    s->mask = mask;
    c->near_valid = false;
    vbss_collision_clear_results(c);
    c->generation++;
    return VBSS_OK;
}

vbss_result vbss_collision_set_motion(vbss_collision *collision, uint32_t shape,
                                      const double *start, const double *end, uint32_t node_count)
{
    VBSS_ENTER(collision);
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
    vbss_collision_shape_invalidate(s);
    vbss_collision_clear_results(c); /* candidates of other positions would be incomplete */
    c->generation++;
    return VBSS_OK;
}

vbss_result vbss_collision_get_edge(vbss_collision *collision, uint32_t shape, uint32_t edge,
                                    uint32_t nodes[2])
{
    VBSS_ENTER(collision);
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_open(collision, &c));
    VBSS_TRY(vbss_collision_find_shape(c, shape, &s));
    VBSS_TRY(vbss_check_range(c->context, edge, 0.0, s->edge_count - 1.0, "edge"));
    VBSS_TRY(vbss_check_pointer(c->context, nodes, "nodes"));
    memcpy(nodes, s->edges[edge], sizeof s->edges[edge]);
    return VBSS_OK;
}

void vbss_collision_set_end_positions(collision_shape *s, const vec3 *end)
{
    memcpy(s->end, end, s->node_count * sizeof *end);
}
