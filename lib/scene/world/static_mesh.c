/* What a scene keeps of a static mesh: the triangles at each vertex and at each edge. */
#include "base/error.h"
#include "base/memory.h"
#include "scene/world/world.h"

enum { MESH_ARRAYS = 4 };

static void list_arrays(scene_static_mesh *m, const collision_shape *shape,
                        vbss_array arrays[MESH_ARRAYS])
{
    arrays[0] =
        (vbss_array){&m->first_triangle, (size_t)shape->node_count + 1, sizeof *m->first_triangle};
    arrays[1] =
        (vbss_array){&m->triangles_of, 3 * (size_t)shape->triangle_count, sizeof *m->triangles_of};
    arrays[2] =
        (vbss_array){&m->near_features, collision_max_features(shape), sizeof *m->near_features};
    arrays[3] =
        (vbss_array){&m->triangles_of_edge, shape->edge_count, sizeof *m->triangles_of_edge};
}

static void list_triangles_at_vertices(scene_static_mesh *m, const collision_shape *shape)
{
    uint32_t *first = m->first_triangle;
    for (uint32_t i = 0; i <= shape->node_count; i++) {
        first[i] = 0;
    }
    for (uint32_t i = 0; i < shape->triangle_count; i++) {
        for (int k = 0; k < 3; k++) {
            first[shape->triangles[i][k]]++;
        }
    }
    uint32_t sum = 0;
    for (uint32_t i = 0; i <= shape->node_count; i++) {
        sum += first[i];
        first[i] = sum; /* the end of its entries */
    }
    for (uint32_t i = shape->triangle_count; i-- > 0;) {
        for (int k = 0; k < 3; k++) {
            m->triangles_of[--first[shape->triangles[i][k]]] = i;
        }
    }
}

static bool has_vertex(const uint32_t *triangle, uint32_t vertex)
{
    return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

static bool has_directed_edge(const uint32_t *t, uint32_t from, uint32_t to)
{
    return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
           (t[2] == from && t[0] == to);
}

/* Lists the triangles that have both vertices of an edge, in ascending order, at most `room` of them.
 * Returns their number. */
static uint32_t list_edge_triangles(const scene_static_mesh *m, const collision_shape *shape,
                                    const uint32_t edge[2], uint32_t *list, uint32_t room)
{
    const uint32_t *first = m->first_triangle;
    const bool is_second_smaller =
        first[edge[1] + 1] - first[edge[1]] < first[edge[0] + 1] - first[edge[0]];
    const uint32_t here = edge[is_second_smaller ? 1 : 0], there = edge[is_second_smaller ? 0 : 1];
    uint32_t count = 0;
    for (uint32_t i = first[here]; i < first[here + 1] && count < room; i++) {
        if (has_vertex(shape->triangles[m->triangles_of[i]], there)) {
            list[count++] = m->triangles_of[i];
        }
    }
    return count;
}

/* Whether an edge belongs to one triangle, or to two that list it in opposite directions. */
static bool is_wound_alike(const scene_static_mesh *m, const collision_shape *shape,
                           const uint32_t edge[2])
{
    uint32_t beside[3];
    const uint32_t count = list_edge_triangles(m, shape, edge, beside, 3);
    return count == 1 ||
           (count == 2 && has_directed_edge(shape->triangles[beside[0]], edge[0], edge[1]) !=
                              has_directed_edge(shape->triangles[beside[1]], edge[0], edge[1]));
}

static void list_triangles_at_edges(scene_static_mesh *m, const collision_shape *shape)
{
    for (uint32_t i = 0; i < shape->edge_count; i++) {
        uint32_t *list = m->triangles_of_edge[i];
        list[0] = list[1] = SCENE_NO_FACE;
        (void)list_edge_triangles(m, shape, shape->edges[i], list, 2);
    }
}

static vbss_result check_winding(vbss_context *context, const scene_static_mesh *m,
                                 const collision_shape *shape)
{
    for (uint32_t i = 0; m->is_one_sided && i < shape->edge_count; i++) {
        if (!is_wound_alike(m, shape, shape->edges[i])) {
            return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                             "one-sided mesh: the edge of vertices %u and %u belongs to more than "
                             "two triangles, or two list it in the same direction",
                             shape->edges[i][0], shape->edges[i][1]);
        }
    }
    return VBSS_OK;
}

vbss_result vbss_scene_create_static_mesh(scene_object *s, scene_static_mesh *m,
                                          const collision_shape *shape)
{
    vbss_array arrays[MESH_ARRAYS];
    list_arrays(m, shape, arrays);
    vbss_result result =
        vbss_allocate_arrays(s->context, arrays, MESH_ARRAYS, "static mesh in a scene");
    if (result == VBSS_OK) {
        list_triangles_at_vertices(m, shape);
        list_triangles_at_edges(m, shape);
        result = check_winding(s->context, m, shape);
    }
    if (result != VBSS_OK) {
        vbss_release_arrays(s->context, arrays, MESH_ARRAYS);
    }
    return result;
}

void vbss_scene_release_mesh_arrays(scene_object *s, scene_static_mesh *m,
                                    const collision_shape *shape)
{
    vbss_array arrays[MESH_ARRAYS];
    list_arrays(m, shape, arrays);
    vbss_release_arrays(s->context, arrays, MESH_ARRAYS);
}

void vbss_scene_release_static_mesh(scene_object *s, scene_body *b)
{
    if (scene_is_mesh(b)) {
        vbss_scene_release_mesh_arrays(s, &b->rigid.mesh, s->collision->shapes[b->shape]);
    }
    if (scene_host_surface_of(b) != NULL) {
        vbss_scene_release_host_surface(s, &b->rigid);
    }
}
