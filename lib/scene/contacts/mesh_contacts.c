/* Static meshes, rigid meshes and host surfaces: directions in which their edges push, and which features are behind a one-sided static mesh.
 *
 * An edge ahead of a thread that slides over level triangles is at a slant to it. A contact along the slant would brake
 * the thread. It acts along the normal of the triangle instead, unless the thread is below the plane of the
 * triangle already: then the surface falls away there, and the plane would lift the thread off it. */
#include "collision/closest.h"
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

typedef struct mesh_view {
    const collision_shape *shape;
    const scene_static_mesh *mesh;
    scene_vertices x;
} mesh_view;

static vec3 vertex_of(const mesh_view *v, uint32_t index)
{
    return scene_vertex(v->x, index);
}

static mesh_view view_of(const scene_object *s, const scene_body *b, scene_vertices x)
{
    return (mesh_view){s->collision->shapes[b->shape], &b->rigid.mesh, x};
}

/* Normal of a triangle; its length is twice the area. */
static vec3 area_normal(const mesh_view *v, uint32_t triangle)
{
    const uint32_t *n = v->shape->triangles[triangle];
    const vec3 first = vertex_of(v, n[0]);
    return vec3_cross(vec3_sub(vertex_of(v, n[1]), first), vec3_sub(vertex_of(v, n[2]), first));
}

/* ---- normals of edges */

/* The nearest plane of a triangle that a point projects onto. */
typedef struct nearest_plane {
    vec3 normal;     /* unit vector toward the point, or its separation if there is no such plane */
    double distance; /* infinite if there is no such plane */
    double smallest; /* planes nearer than this are not used, m */
} nearest_plane;

static void use_plane(nearest_plane *nearest, vec3 area, vec3 separation)
{
    const vec3 normal = vec3_unit_or(area, vec3_zero());
    const double height = vec3_dot(normal, separation);
    if (fabs(height) >= nearest->smallest && fabs(height) < nearest->distance) {
        nearest->normal = height > 0.0 ? normal : vec3_neg(normal);
        nearest->distance = fabs(height);
    }
}

static vec3 normal_inside_edge(const mesh_view *v, uint32_t number, double smallest,
                               vec3 separation)
{
    const uint32_t *edge = v->shape->edges[number], *beside = v->mesh->triangles_of_edge[number];
    const vec3 begin = vertex_of(v, edge[0]), along = vec3_sub(vertex_of(v, edge[1]), begin);
    nearest_plane nearest = {separation, (double)INFINITY, smallest};
    for (uint32_t i = 0; i < 2 && beside[i] != SCENE_NO_FACE; i++) {
        const uint32_t *n = v->shape->triangles[beside[i]];
        const vec3 area = area_normal(v, beside[i]), across = vec3_cross(area, along);
        const vec3 sum =
            vec3_add(vertex_of(v, n[0]), vec3_add(vertex_of(v, n[1]), vertex_of(v, n[2])));
        const vec3 middle = vec3_scale(sum, 1.0 / 3.0);
        const double side = vec3_dot(across, vec3_sub(middle, begin));
        if (side * vec3_dot(across, separation) > 0.0) {
            use_plane(&nearest, area, separation);
        }
    }
    return nearest.normal;
}

/* Sides of a triangle from one of its corners, in the order of the triangle. */
static void get_sides_at(const mesh_view *v, uint32_t triangle, uint32_t vertex, vec3 sides[2])
{
    const uint32_t *n = v->shape->triangles[triangle];
    const uint32_t corner = n[0] == vertex ? 0 : n[1] == vertex ? 1 : 2;
    const vec3 at = vertex_of(v, vertex);
    sides[0] = vec3_sub(vertex_of(v, n[(corner + 1) % 3]), at);
    sides[1] = vec3_sub(vertex_of(v, n[(corner + 2) % 3]), at);
}

static vec3 normal_at_vertex(const mesh_view *v, uint32_t vertex, double smallest, vec3 separation)
{
    const uint32_t *first = v->mesh->first_triangle;
    nearest_plane nearest = {separation, (double)INFINITY, smallest};
    vec3 ridge = vec3_zero();
    double ahead = 0.0; /* along the ridge */
    for (uint32_t i = first[vertex]; i < first[vertex + 1]; i++) {
        vec3 sides[2];
        get_sides_at(v, v->mesh->triangles_of[i], vertex, sides);
        const vec3 area = vec3_cross(sides[0], sides[1]);
        if (vec3_dot(vec3_cross(area, sides[0]), separation) >= 0.0 &&
            vec3_dot(vec3_cross(sides[1], area), separation) >= 0.0) {
            use_plane(&nearest, area, separation);
        }
        for (int k = 0; k < 2; k++) {
            const vec3 side = vec3_unit_or(sides[k], vec3_zero());
            if (vec3_dot(side, separation) > ahead) {
                ahead = vec3_dot(side, separation);
                ridge = side;
            }
        }
    }
    return nearest.distance < (double)INFINITY ? nearest.normal
                                               : vec3_add_scaled(separation, -ahead, ridge);
}

/* The vertices and the separation are in one frame, and so is the normal. */
static vec3 normal_at_edge(const mesh_view *v, uint32_t edge, double at, double contact_distance,
                           vec3 separation)
{
    const double smallest = (1.0 - SCENE_PLANE_TOLERANCE) * contact_distance;
    const vec3 direction =
        at > 0.0 && at < 1.0
            ? normal_inside_edge(v, edge, smallest, separation)
            : normal_at_vertex(v, v->shape->edges[edge][at > 0.0 ? 1 : 0], smallest, separation);
    return vec3_unit_or(direction, vec3_unit_or(separation, vec3_zero()));
}

/* In the frame of a rigid mesh, which saves the transformation of the vertices around the edge. */
vec3 vbss_scene_mesh_normal(const scene_object *s, const scene_body *mesh, scene_vertices x,
                            uint32_t edge, double at, double contact_distance, vec3 separation)
{
    const mesh_view v = view_of(s, mesh, (scene_vertices){x.x, NULL});
    if (x.at == NULL) {
        return normal_at_edge(&v, edge, at, contact_distance, separation);
    }
    const vec3 local = quat_rotate_back(x.at->orientation, separation);
    return quat_rotate(x.at->orientation, normal_at_edge(&v, edge, at, contact_distance, local));
}

/* ---- one-sided meshes */

static double height_over(const mesh_view *v, uint32_t triangle, vec3 point)
{
    return vec3_dot(area_normal(v, triangle),
                    vec3_sub(point, vertex_of(v, v->shape->triangles[triangle][0])));
}

/* One or two triangles at an edge, as a wedge. */
typedef struct wedge {
    const mesh_view *view;
    const uint32_t *triangles;
    uint32_t count;
    bool is_convex; /* behind it is what is behind both; otherwise what is behind one */
} wedge;

static wedge wedge_at(const mesh_view *v, uint32_t number)
{
    const uint32_t *edge = v->shape->edges[number];
    wedge w = {.view = v, .triangles = v->mesh->triangles_of_edge[number], .is_convex = true};
    w.count = w.triangles[1] != SCENE_NO_FACE ? 2 : 1;
    for (int k = 0; k < 3 && w.count == 2; k++) {
        const uint32_t corner = v->shape->triangles[w.triangles[1]][k];
        if (corner != edge[0] && corner != edge[1]) {
            w.is_convex = height_over(v, w.triangles[0], vertex_of(v, corner)) <= 0.0;
        }
    }
    return w;
}

/* Whether both ends are behind the same triangle of a concave wedge, or behind both of a convex one. Then a part
 * of the segment that meets the edge in a straight motion comes from behind. */
static bool is_behind_wedge(const wedge *w, const vec3 segment[2])
{
    bool behind_all = true, behind_one = false;
    for (uint32_t i = 0; i < w->count; i++) {
        const bool behind = height_over(w->view, w->triangles[i], segment[0]) < 0.0 &&
                            height_over(w->view, w->triangles[i], segment[1]) < 0.0;
        behind_all = behind_all && behind;
        behind_one = behind_one || behind;
    }
    return w->is_convex ? behind_all : behind_one;
}

/* Whether a segment intersects a triangle. Nothing that has always been in front of a mesh does. */
static bool does_intersect(const mesh_view *v, uint32_t triangle, const vec3 segment[2])
{
    const double first = height_over(v, triangle, segment[0]),
                 second = height_over(v, triangle, segment[1]);
    if ((first < 0.0) == (second < 0.0)) {
        return false;
    }
    const vec3 point = vec3_lerp(segment[0], segment[1], first / (first - second));
    const uint32_t *n = v->shape->triangles[triangle];
    const vec3 corners[3] = {vec3_sub(vertex_of(v, n[0]), point),
                             vec3_sub(vertex_of(v, n[1]), point),
                             vec3_sub(vertex_of(v, n[2]), point)};
    double weights[3];
    (void)closest_on_triangle(corners, weights);
    return weights[0] > 0.0 && weights[1] > 0.0 && weights[2] > 0.0;
}

static bool is_segment_behind(const mesh_view *v, uint32_t edge, const vec3 segment[2])
{
    const wedge w = wedge_at(v, edge);
    bool behind = is_behind_wedge(&w, segment);
    for (uint32_t i = 0; i < w.count && !behind; i++) {
        behind = does_intersect(v, w.triangles[i], segment);
    }
    return behind;
}

/* Whether the corners of a triangle are behind all triangles at a vertex. */
static bool is_triangle_behind(const mesh_view *v, uint32_t vertex, const collision_shape *other,
                               uint32_t triangle)
{
    bool behind = true;
    const uint32_t *first = v->mesh->first_triangle, *n = other->triangles[triangle];
    for (uint32_t i = first[vertex]; behind && i < first[vertex + 1]; i++) {
        for (int k = 0; k < 3; k++) {
            behind = behind && height_over(v, v->mesh->triangles_of[i], other->start[n[k]]) < 0.0;
        }
    }
    return behind;
}

bool vbss_scene_is_behind_mesh(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    const bool is_mesh_a = scene_is_mesh(a);
    const scene_body *mesh = is_mesh_a ? a : b;
    if (!scene_is_mesh(mesh) || !mesh->rigid.mesh.is_one_sided) {
        return false;
    }
    const mesh_view v = view_of(s, mesh, scene_mesh_vertices(s, mesh));
    const collision_shape *other = s->collision->shapes[is_mesh_a ? q->shape_b : q->shape_a];
    const uint32_t feature = is_mesh_a ? q->a : q->b, other_feature = is_mesh_a ? q->b : q->a;
    if (q->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        return is_mesh_a ? is_triangle_behind(&v, feature, other, other_feature)
                         : height_over(&v, feature, other->start[other_feature]) < 0.0;
    }
    const uint32_t *n = other->edges[other_feature];
    const vec3 segment[2] = {other->start[n[0]], other->start[n[1]]};
    return is_segment_behind(&v, feature, segment);
}
