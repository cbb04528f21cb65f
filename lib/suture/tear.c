/* Tears: how a hole moves through its wall. It goes on straight lines from triangle to triangle, as if both
 * were unfolded at their common side. */
#include "base/stream.h"
#include "suture/suture.h"

#include "suture/tuning.h"

/* A triangle of the wall as the hole moves through it. Index k belongs to corner k and to the side
 * opposite to it. */
typedef struct tear_triangle {
    vec3 corner[3];
    vec3 gradient[3]; /* of the barycentric coordinates, in the plane, 1/m */
} tear_triangle;

static double get_thickness(const suture_wall *wall, uint32_t triangle)
{
    return wall->triangle_thickness != NULL ? wall->triangle_thickness[triangle]
                                            : wall->law->thickness;
}

double vbss_suture_tear_force(const suture_wall *wall, uint32_t triangle)
{
    return wall->law->tear_energy * get_thickness(wall, triangle);
}

vec3 vbss_suture_wall_normal(const suture_wall *wall, const vec3 *x, uint32_t triangle)
{
    const uint32_t *n = wall->triangles[triangle];
    return vec3_unit_or(vec3_cross(vec3_sub(x[n[1]], x[n[0]]), vec3_sub(x[n[2]], x[n[0]])),
                        vec3_make(0.0, 0.0, 1.0));
}

/* False for a triangle without an area. */
static bool load_triangle(const suture_wall *wall, uint32_t triangle, tear_triangle *t)
{
    for (int k = 0; k < 3; k++) {
        t->corner[k] = wall->now[wall->triangles[triangle][k]];
    }
    const vec3 area =
        vec3_cross(vec3_sub(t->corner[1], t->corner[0]), vec3_sub(t->corner[2], t->corner[0]));
    const double size = vec3_norm_squared(area);
    for (int k = 0; k < 3; k++) {
        const vec3 side = vec3_sub(t->corner[(k + 2) % 3], t->corner[(k + 1) % 3]);
        t->gradient[k] = vec3_scale(vec3_cross(area, side), size > 0.0 ? 1.0 / size : 0.0);
    }
    return size > 0.0;
}

/* Moves along the unit direction by up to `distance`. Returns the length of the path, and the side at which
 * it ended early; -1: at none. `entered`: side at which the hole has come in, or -1. */
static double cross_triangle(const tear_triangle *t, vec3 direction, int entered, double distance,
                             double barycentric[3], int *side)
{
    double rate[3];
    *side = -1;
    for (int k = 0; k < 3; k++) {
        rate[k] = vec3_dot(t->gradient[k], direction);
        if (k != entered && rate[k] < 0.0 && barycentric[k] < -rate[k] * distance) {
            distance = barycentric[k] / -rate[k];
            *side = k;
        }
    }
    for (int k = 0; k < 3; k++) {
        barycentric[k] += distance * rate[k];
    }
    if (*side >= 0) {
        barycentric[*side] = 0.0;
    }
    vbss_suture_normalise_barycentric(barycentric);
    return distance;
}

/* The triangle beyond a side, or DRAIN_NONE at a free edge. */
static uint32_t find_neighbour(const suture_wall *wall, uint32_t triangle, int side)
{
    const uint32_t *own = wall->triangles[triangle];
    const uint32_t a = own[(side + 1) % 3], b = own[(side + 2) % 3];
    for (size_t i = 0; i < wall->edge_count; i++) {
        const uint32_t *nodes = wall->edges + i * wall->edge_stride;
        const uint32_t *beside = wall->beside_edges + i * wall->edge_stride;
        if ((nodes[0] == a && nodes[1] == b) || (nodes[0] == b && nodes[1] == a)) {
            return beside[0] == triangle ? beside[1] : beside[0];
        }
    }
    return DRAIN_NONE;
}

/* Corner of a triangle that is this node; -1: none. */
static int find_corner(const suture_wall *wall, uint32_t triangle, uint32_t node)
{
    for (int k = 0; k < 3; k++) {
        if (wall->triangles[triangle][k] == node) {
            return k;
        }
    }
    return -1;
}

/* Continues in the triangle beyond a side. Returns the side at which the hole comes in. */
static int enter_neighbour(const suture_wall *wall, uint32_t to, int side, suture_hole *hole,
                           const tear_triangle *from, vec3 *direction)
{
    double barycentric[3] = {0.0, 0.0, 0.0};
    int entered = 3;
    for (int i = 1; i <= 2; i++) {
        const int own = (side + i) % 3;
        const int corner = find_corner(wall, to, wall->triangles[hole->triangle][own]);
        barycentric[corner] = hole->barycentric[own];
        entered -= corner;
    }
    tear_triangle t;
    (void)load_triangle(wall, to, &t);
    const vec3 along = vec3_unit_or(
        vec3_sub(from->corner[(side + 2) % 3], from->corner[(side + 1) % 3]), vec3_zero());
    const vec3 out = vec3_unit_or(vec3_neg(from->gradient[side]), vec3_zero());
    const vec3 in = vec3_unit_or(t.gradient[entered], vec3_zero());
    *direction = vec3_add_scaled(vec3_scale(along, vec3_dot(along, *direction)),
                                 vec3_dot(out, *direction), in);
    hole->triangle = to;
    for (int k = 0; k < 3; k++) {
        hole->barycentric[k] = barycentric[k];
    }
    return entered;
}

/* A triangle with three anchored nodes does not tear. */
static bool stops_tears(const suture_wall *wall, uint32_t triangle)
{
    const uint32_t *node = wall->triangles[triangle];
    return wall->anchored != NULL && wall->anchored[node[0]] && wall->anchored[node[1]] &&
           wall->anchored[node[2]];
}

double vbss_suture_move_hole(const suture_wall *wall, suture_hole *hole, vec3 direction,
                             double distance)
{
    const vec3 normal = vbss_suture_wall_normal(wall, wall->now, hole->triangle);
    double moved = 0.0;
    int entered = -1, side;
    direction = vec3_add_scaled(direction, -vec3_dot(direction, normal), normal);
    direction = vec3_unit_or(direction, vec3_zero());
    hole->free_side = 0;
    for (uint32_t i = 0; i < SUTURE_MAX_TORN_TRIANGLES && moved < distance; i++) {
        tear_triangle t;
        if (!load_triangle(wall, hole->triangle, &t)) {
            break;
        }
        moved += cross_triangle(&t, direction, entered, distance - moved, hole->barycentric, &side);
        if (side < 0) {
            return distance;
        }
        const uint32_t to = find_neighbour(wall, hole->triangle, side);
        if (to == DRAIN_NONE) {
            hole->free_side = (uint32_t)side + 1;
            break;
        }
        if (stops_tears(wall, to)) {
            break;
        }
        entered = enter_neighbour(wall, to, side, hole, &t, &direction);
    }
    return moved;
}

bool vbss_suture_is_outside(const suture_wall *wall, const suture_hole *hole, vec3 point)
{
    tear_triangle t;
    return hole->free_side != 0 && load_triangle(wall, hole->triangle, &t) &&
           vec3_dot(vec3_sub(point, vbss_hole_point(hole, wall, wall->now)),
                    t.gradient[hole->free_side - 1]) < 0.0;
}

void vbss_suture_serialise_tear(vbss_stream *stream, uint16_t first_tag, suture_hole *hole)
{
    uint32_t words[] = {(uint32_t)hole->tear, hole->free_side};
    vbss_stream_u32(stream, first_tag, words, 2);
    vbss_stream_f64(stream, first_tag + 1, &hole->torn_length, 1);
    vbss_stream_f64(stream, first_tag + 2, &hole->tear_work, 1);
    if (words[0] > SUTURE_TEARS || words[1] > 3 || !(hole->torn_length >= 0.0) ||
        !(hole->tear_work >= 0.0)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such tear");
        words[0] = words[1] = 0;
        hole->torn_length = hole->tear_work = 0.0;
    }
    hole->tear = (suture_tear)words[0];
    hole->free_side = words[1];
}
