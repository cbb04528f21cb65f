/* Public queries of closest points. */
#include "collision/closest.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/double_double.h"
#include "base/error.h"
#include "collision/collision.h"

_Static_assert(sizeof(vbss_collision_closest) == 136, "published size");
static const uint32_t closest_sizes[] = {136, 0};
static const vbss_layout closest_layout = {"vbss_collision_closest", NULL, closest_sizes};

static vbss_result check_coordinates(const double *coordinates, size_t count, const char *name)
{
    return vbss_collision_check_coordinates(NULL, coordinates, count, name);
}

static vec3 vertex(const double *coordinates, int k)
{
    return vec3_load(coordinates + 3 * (size_t)k);
}

/* The weighted sum of `count` vertices. */
static void store_point(double point[3], const double *vertices, const double *weights, int count)
{
    vec3 sum = vec3_zero();
    for (int k = 0; k < count; k++) {
        sum = vec3_add_scaled(sum, weights[k], vertex(vertices, k));
    }
    vec3_store(point, sum);
}

/* The vector from a to b, multiplied by `scale`. */
typedef struct scaled_separation {
    vec3 separation;
    double scale;
} scaled_separation;

static double length_of(scaled_separation s)
{
    return vec3_norm(s.separation) / s.scale;
}

/* Completes the result; its weights must be set. */
static void fill(vbss_collision_closest *own, const double *a, int vertices_of_a, const double *b,
                 int vertices_of_b, scaled_separation separation)
{
    own->struct_size = sizeof *own;
    own->distance = length_of(separation);
    vec3_store(own->normal, vec3_unit_or(separation.separation, vec3_zero()));
    store_point(own->point_a, a, own->weights_a, vertices_of_a);
    store_point(own->point_b, b, own->weights_b, vertices_of_b);
}

static vbss_result write_closest(vbss_collision_closest *own, const double *a, int vertices_of_a,
                                 const double *b, int vertices_of_b, scaled_separation separation,
                                 vbss_collision_closest *closest, uint32_t struct_size)
{
    fill(own, a, vertices_of_a, b, vertices_of_b, separation);
    return vbss_struct_write(NULL, &closest_layout, own, closest, struct_size);
}

/* The power of two that scales the largest coordinate to [1, 2), so that products of four lengths
 * do not underflow. */
static double scale_of(const vec3 *relative, int count)
{
    uint64_t exponent = 0;
    for (int k = 0; k < count; k++) {
        double largest =
            vbss_max(vbss_max(fabs(relative[k].x), fabs(relative[k].y)), fabs(relative[k].z));
        uint64_t here = bits_of(largest) >> 52;
        exponent = here > exponent ? here : exponent;
    }
    return double_of((UINT64_C(2046) - (exponent > 0 ? exponent : 1)) << 52);
}

static double scale_all(vec3 *relative, int count)
{
    double scale = scale_of(relative, count);
    for (int k = 0; k < count; k++) {
        relative[k] = vec3_scale(relative[k], scale);
    }
    return scale;
}

/* Closest points of two segments, as fractions along them. */
static scaled_separation closest_on_segments(const double a[6], const double b[6], double *s,
                                             double *u)
{
    vec3 from = vertex(a, 0), start_b = vertex(b, 0);
    vec3 v[3] = {vec3_sub(vertex(a, 1), from), vec3_sub(vertex(b, 1), start_b),
                 vec3_sub(start_b, from)};
    double scale = scale_all(v, 3);
    scaled_separation separation = {closest_between_edges(v[0], v[1], v[2], s, u), scale};
    return separation;
}

static scaled_separation closest_on_axes(const double a[6], const double b[6],
                                         vbss_collision_closest *own)
{
    double s, u;
    scaled_separation separation = closest_on_segments(a, b, &s, &u);
    own->weights_a[0] = 1.0 - s;
    own->weights_a[1] = s;
    own->weights_b[0] = 1.0 - u;
    own->weights_b[1] = u;
    return separation;
}

vbss_result vbss_collision_closest_segments(const double a[6], const double b[6],
                                            vbss_collision_closest *closest, uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(check_coordinates(a, 6, "a"));
    VBSS_TRY(check_coordinates(b, 6, "b"));
    vbss_collision_closest own = {0};
    scaled_separation separation = closest_on_axes(a, b, &own);
    return write_closest(&own, a, 2, b, 2, separation, closest, struct_size);
}

static scaled_separation closest_to_triangle(vec3 point, const double triangle[9],
                                             double weights[3])
{
    vec3 f[3];
    for (int k = 0; k < 3; k++) {
        f[k] = vec3_sub(vertex(triangle, k), point);
    }
    double scale = scale_all(f, 3);
    scaled_separation separation = {closest_on_triangle(f, weights), scale};
    return separation;
}

vbss_result vbss_collision_closest_point_triangle(const double point[3], const double triangle[9],
                                                  vbss_collision_closest *closest,
                                                  uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(check_coordinates(point, 3, "point"));
    VBSS_TRY(check_coordinates(triangle, 9, "triangle"));
    vbss_collision_closest own = {0};
    own.weights_a[0] = 1.0;
    scaled_separation separation = closest_to_triangle(vertex(point, 0), triangle, own.weights_b);
    return write_closest(&own, point, 1, triangle, 3, separation, closest, struct_size);
}

/* Whether the segment pierces the triangle; its position along the segment, and the weights of the
 * corners. */
static bool segment_pierces_triangle(const double segment[6], const double triangle[9],
                                     double *fraction, double weights[3])
{
    vec3 corner = vertex(triangle, 0);
    vec3 v[4] = {vec3_sub(vertex(triangle, 1), corner), vec3_sub(vertex(triangle, 2), corner),
                 vec3_sub(vertex(segment, 0), corner), vec3_sub(vertex(segment, 1), corner)};
    scale_all(v, 4);
    vec3 n = vec3_cross(v[0], v[1]);
    double from = vec3_dot(n, v[2]), to = vec3_dot(n, v[3]);
    if (!((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0))) {
        return false;
    }
    *fraction = from / (from - to);
    closest_to_triangle(vec3_lerp(vertex(segment, 0), vertex(segment, 1), *fraction), triangle,
                        weights);
    return weights[0] > 0.0 && weights[1] > 0.0 && weights[2] > 0.0;
}

vbss_result vbss_collision_closest_segment_triangle(const double segment[6],
                                                    const double triangle[9],
                                                    vbss_collision_closest *closest,
                                                    uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(check_coordinates(segment, 6, "segment"));
    VBSS_TRY(check_coordinates(triangle, 9, "triangle"));
    vbss_collision_closest own = {0};
    double fraction, weights[3];
    if (segment_pierces_triangle(segment, triangle, &fraction, weights)) {
        own.weights_a[0] = 1.0 - fraction;
        own.weights_a[1] = fraction;
        for (int k = 0; k < 3; k++) {
            own.weights_b[k] = weights[k];
        }
        scaled_separation none = {vec3_zero(), 1.0};
        return write_closest(&own, segment, 2, triangle, 3, none, closest, struct_size);
    }
    scaled_separation best = {vec3_zero(), 1.0};
    double min_distance = DBL_MAX;
    for (int end = 0; end < 2; end++) {
        scaled_separation separation = closest_to_triangle(vertex(segment, end), triangle, weights);
        if (length_of(separation) < min_distance) {
            min_distance = length_of(separation);
            best = separation;
            own.weights_a[0] = 1.0 - (double)end;
            own.weights_a[1] = (double)end;
            for (int k = 0; k < 3; k++) {
                own.weights_b[k] = weights[k];
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3;
        double edge[6], u;
        vec3_store(edge, vertex(triangle, k));
        vec3_store(edge + 3, vertex(triangle, next));
        scaled_separation separation = closest_on_segments(segment, edge, &fraction, &u);
        if (length_of(separation) < min_distance) {
            min_distance = length_of(separation);
            best = separation;
            own.weights_a[0] = 1.0 - fraction;
            own.weights_a[1] = fraction;
            own.weights_b[k] = 1.0 - u;
            own.weights_b[next] = u;
            own.weights_b[(k + 2) % 3] = 0.0;
        }
    }
    return write_closest(&own, segment, 2, triangle, 3, best, closest, struct_size);
}

vbss_result vbss_collision_closest_capsules(const double a[6], double radius_a, const double b[6],
                                            double radius_b, vbss_collision_closest *closest,
                                            uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(check_coordinates(a, 6, "a"));
    VBSS_TRY(check_coordinates(b, 6, "b"));
    VBSS_TRY(vbss_check_range(NULL, radius_a, 0.0, COLLISION_MAX_COORDINATE, "radius_a"));
    VBSS_TRY(vbss_check_range(NULL, radius_b, 0.0, COLLISION_MAX_COORDINATE, "radius_b"));
    vbss_collision_closest own = {0};
    fill(&own, a, 2, b, 2, closest_on_axes(a, b, &own));
    own.distance = own.distance - radius_a - radius_b;
    vec3 normal = vec3_load(own.normal);
    vec3_store(own.point_a, vec3_add_scaled(vec3_load(own.point_a), radius_a, normal));
    vec3_store(own.point_b, vec3_add_scaled(vec3_load(own.point_b), -radius_b, normal));
    return vbss_struct_write(NULL, &closest_layout, &own, closest, struct_size);
}
