/* Closest points as a host asks for them. */
#include "collision/closest.h"

#include "base/check.h"
#include "base/double_double.h"
#include "base/error.h"
#include "collision/collision.h"

_Static_assert(sizeof(vbss_closest) == 136, "published size");
static const uint32_t closest_sizes[] = {136, 0};
static const vbss_layout closest_layout = {"vbss_closest", NULL, closest_sizes};

static vbss_result check(const double *coordinates, size_t count, const char *name)
{
    return vbss_collision_check_coordinates(NULL, coordinates, count, name);
}

static vec3 vertex(const double *coordinates, int k)
{
    return vec3_load(coordinates + 3 * (size_t)k);
}

/* The point with these weights of `count` vertices. */
static void store_point(double point[3], const double *vertices, const double *weights, int count)
{
    vec3 sum = vec3_zero();
    for (int k = 0; k < count; k++) {
        sum = vec3_add_scaled(sum, weights[k], vertex(vertices, k));
    }
    vec3_store(point, sum);
}

/* A vector from a to b, `scale` times as long as it is. */
typedef struct scaled {
    vec3 apart;
    double scale;
} scaled;

static double length_of(scaled s)
{
    return vec3_norm(s.apart) / s.scale;
}

/* Weights are set; the rest follows. */
static void fill(vbss_closest *own, const double *a, int vertices_of_a, const double *b,
                 int vertices_of_b, scaled apart)
{
    own->struct_size = sizeof *own;
    own->distance = length_of(apart);
    vec3_store(own->normal, vec3_unit_or(apart.apart, vec3_zero()));
    store_point(own->point_a, a, own->weights_a, vertices_of_a);
    store_point(own->point_b, b, own->weights_b, vertices_of_b);
}

static vbss_result finish(vbss_closest *own, const double *a, int vertices_of_a, const double *b,
                          int vertices_of_b, scaled apart, vbss_closest *closest,
                          uint32_t struct_size)
{
    fill(own, a, vertices_of_a, b, vertices_of_b, apart);
    return vbss_struct_write(NULL, &closest_layout, own, closest, struct_size);
}

/* The power of two that brings the largest coordinate to between 1 and 2: products of four lengths shall
 * not underflow, however small they are. */
static double scale_of(const vec3 *relative, int count)
{
    uint64_t exponent = 0;
    for (int k = 0; k < count; k++) {
        double largest =
            greater(greater(fabs(relative[k].x), fabs(relative[k].y)), fabs(relative[k].z));
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

/* Shares of the way along two segments. */
static scaled segments(const double a[6], const double b[6], double *s, double *u)
{
    vec3 from = vertex(a, 0), begin = vertex(b, 0);
    vec3 v[3] = {vec3_sub(vertex(a, 1), from), vec3_sub(vertex(b, 1), begin),
                 vec3_sub(begin, from)};
    double scale = scale_all(v, 3);
    scaled apart = {closest_edges(v[0], v[1], v[2], s, u), scale};
    return apart;
}

static scaled axes(const double a[6], const double b[6], vbss_closest *own)
{
    double s, u;
    scaled apart = segments(a, b, &s, &u);
    own->weights_a[0] = 1.0 - s;
    own->weights_a[1] = s;
    own->weights_b[0] = 1.0 - u;
    own->weights_b[1] = u;
    return apart;
}

vbss_result vbss_closest_segments(const double a[6], const double b[6], vbss_closest *closest,
                                  uint32_t struct_size)
{
    VBSS_TRY(check(a, 6, "a"));
    VBSS_TRY(check(b, 6, "b"));
    vbss_closest own = {0};
    scaled apart = axes(a, b, &own);
    return finish(&own, a, 2, b, 2, apart, closest, struct_size);
}

static scaled corners(vec3 point, const double triangle[9], double weights[3])
{
    vec3 f[3];
    for (int k = 0; k < 3; k++) {
        f[k] = vec3_sub(vertex(triangle, k), point);
    }
    double scale = scale_all(f, 3);
    scaled apart = {closest_corners(f, weights), scale};
    return apart;
}

vbss_result vbss_closest_point_triangle(const double point[3], const double triangle[9],
                                        vbss_closest *closest, uint32_t struct_size)
{
    VBSS_TRY(check(point, 3, "point"));
    VBSS_TRY(check(triangle, 9, "triangle"));
    vbss_closest own = {0};
    own.weights_a[0] = 1.0;
    scaled apart = corners(vertex(point, 0), triangle, own.weights_b);
    return finish(&own, point, 1, triangle, 3, apart, closest, struct_size);
}

/* Where the segment goes through the triangle, if it does: the share of its way, and the weights. */
static bool goes_through(const double segment[6], const double triangle[9], double *share,
                         double weights[3])
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
    *share = from / (from - to);
    corners(vec3_lerp(vertex(segment, 0), vertex(segment, 1), *share), triangle, weights);
    return weights[0] > 0.0 && weights[1] > 0.0 && weights[2] > 0.0;
}

vbss_result vbss_closest_segment_triangle(const double segment[6], const double triangle[9],
                                          vbss_closest *closest, uint32_t struct_size)
{
    VBSS_TRY(check(segment, 6, "segment"));
    VBSS_TRY(check(triangle, 9, "triangle"));
    vbss_closest own = {0};
    double share, weights[3];
    if (goes_through(segment, triangle, &share, weights)) {
        own.weights_a[0] = 1.0 - share;
        own.weights_a[1] = share;
        for (int k = 0; k < 3; k++) {
            own.weights_b[k] = weights[k];
        }
        scaled none = {vec3_zero(), 1.0};
        return finish(&own, segment, 2, triangle, 3, none, closest, struct_size);
    }
    scaled best = {vec3_zero(), 1.0};
    double least = DBL_MAX;
    for (int end = 0; end < 2; end++) {
        scaled apart = corners(vertex(segment, end), triangle, weights);
        if (length_of(apart) < least) {
            least = length_of(apart);
            best = apart;
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
        scaled apart = segments(segment, edge, &share, &u);
        if (length_of(apart) < least) {
            least = length_of(apart);
            best = apart;
            own.weights_a[0] = 1.0 - share;
            own.weights_a[1] = share;
            own.weights_b[k] = 1.0 - u;
            own.weights_b[next] = u;
            own.weights_b[(k + 2) % 3] = 0.0;
        }
    }
    return finish(&own, segment, 2, triangle, 3, best, closest, struct_size);
}

vbss_result vbss_closest_capsules(const double a[6], double radius_a, const double b[6],
                                  double radius_b, vbss_closest *closest, uint32_t struct_size)
{
    VBSS_TRY(check(a, 6, "a"));
    VBSS_TRY(check(b, 6, "b"));
    VBSS_TRY(vbss_check_range(NULL, radius_a, 0.0, COLLISION_FARTHEST, "radius_a"));
    VBSS_TRY(vbss_check_range(NULL, radius_b, 0.0, COLLISION_FARTHEST, "radius_b"));
    vbss_closest own = {0};
    fill(&own, a, 2, b, 2, axes(a, b, &own));
    own.distance = own.distance - radius_a - radius_b;
    vec3 normal = vec3_load(own.normal);
    vec3_store(own.point_a, vec3_add_scaled(vec3_load(own.point_a), radius_a, normal));
    vec3_store(own.point_b, vec3_add_scaled(vec3_load(own.point_b), -radius_b, normal));
    return vbss_struct_write(NULL, &closest_layout, &own, closest, struct_size);
}
