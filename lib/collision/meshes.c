/* Shapes that are meshes: creation, with the list of their edges, and one in the place of another. */
#include "collision/shapes.h"

#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"

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

/* Stable sort by node number `which` of each pair. `offsets` has node_count + 1 entries. */
static void sort_by_node(node_pair *from, node_pair *to, uint32_t count, int which,
                         uint32_t *offsets, uint32_t node_count)
{
    memset(offsets, 0, (node_count + 1) * sizeof *offsets);
    for (uint32_t i = 0; i < count; i++) {
        offsets[from[i][which] + 1]++;
    }
    for (uint32_t i = 0; i < node_count; i++) {
        offsets[i + 1] += offsets[i];
    }
    for (uint32_t i = 0; i < count; i++) {
        memcpy(to[offsets[from[i][which]]++], from[i], sizeof *from);
    }
}

/* Lists the sides of all triangles, lower node first, sorted and without duplicates. Returns their
 * number. */
static uint32_t list_edges(const uint32_t *triangles, uint32_t triangle_count, uint32_t node_count,
                           node_pair *edges, node_pair *spare, uint32_t *offsets)
{
    uint32_t count = 0, unique_count = 0;
    for (uint32_t i = 0; i < triangle_count; i++) {
        const uint32_t *n = triangles + 3 * (size_t)i;
        for (int k = 0; k < 3; k++, count++) {
            uint32_t p = n[k], q = n[(k + 1) % 3];
            edges[count][0] = p < q ? p : q;
            edges[count][1] = p < q ? q : p;
        }
    }
    sort_by_node(edges, spare, count, 1, offsets, node_count);
    sort_by_node(spare, edges, count, 0, offsets, node_count);
    for (uint32_t i = 0; i < count; i++) {
        if (unique_count == 0 || memcmp(edges[unique_count - 1], edges[i], sizeof *edges) != 0) {
            memmove(edges[unique_count++], edges[i], sizeof *edges);
        }
    }
    return unique_count;
}

vbss_result vbss_collision_create_mesh(collision_object *c, uint32_t node_count,
                                       const uint32_t *triangles, uint32_t triangle_count,
                                       double radius, collision_shape **shape)
{
    const size_t sides = 3u * (size_t)triangle_count;
    node_pair *edges = NULL, *spare = NULL;
    uint32_t *offsets = NULL;
    const vbss_array working[] = {{&edges, sides, sizeof *edges},
                                  {&spare, sides, sizeof *spare},
                                  {&offsets, (size_t)node_count + 1, sizeof *offsets}};
    vbss_result result = vbss_allocate_arrays(c->context, working, 3, "edges of a mesh");
    if (result == VBSS_OK) {
        uint32_t edge_count =
            list_edges(triangles, triangle_count, node_count, edges, spare, offsets);
        const uint32_t counts[3] = {node_count, edge_count, triangle_count};
        result = vbss_collision_create_shape(c, COLLISION_SHAPE_MESH, counts, radius, shape);
    }
    if (result == VBSS_OK) {
        memcpy((*shape)->edges, edges, (*shape)->edge_count * sizeof *edges);
        memcpy((*shape)->triangles, triangles, sides * sizeof *triangles);
    }
    vbss_release_arrays(c->context, working, 3);
    return result;
}

collision_shape *vbss_collision_exchange_shape(collision_object *c, uint32_t id,
                                               collision_shape *shape)
{
    collision_shape *before = c->shapes[id];
    shape->topology_hash = vbss_collision_hash_topology(shape);
    c->shapes[id] = shape;
    c->active_valid = false;
    vbss_collision_clear_results(c);
    c->generation++;
    return before;
}

vbss_result vbss_collision_add_mesh(vbss_collision *collision, uint32_t node_count,
                                    const uint32_t *triangles, uint32_t triangle_count,
                                    double radius, uint32_t *shape)
{
    VBSS_ENTER(collision);
    collision_object *c;
    collision_shape *s = NULL;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_check_range(c->context, node_count, 3.0, 65536.0, "node_count"));
    VBSS_TRY(vbss_check_range(c->context, triangle_count, 1.0, 131072.0, "triangle_count"));
    VBSS_TRY(vbss_check_pointer(c->context, triangles, "triangles"));
    VBSS_TRY(check_triangles(c, node_count, triangles, triangle_count));
    VBSS_TRY(vbss_collision_check_new_shape(c, radius, shape));
    VBSS_TRY(vbss_collision_create_mesh(c, node_count, triangles, triangle_count, radius, &s));
    vbss_collision_register_shape(c, s, shape);
    return VBSS_OK;
}
