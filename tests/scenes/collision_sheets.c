/* Hard families of a point and a triangle with thickness, lengths in mm, D = 0.25; the kin of the families
 * of capsules. Vertex 0 is the point; the triangle has sides of a few mm. */
#include "scenes/collision_build.h"

/* At rest, in a random frame, not far from regular. */
typedef struct triangle {
    vec3 corners[3], normal;
} triangle;

static triangle draw_triangle(vbss_random *random, collision_motion *m)
{
    triangle t;
    t.normal = vbss_random_direction(random);
    vec3 u = vec3_any_normal(t.normal), v = vec3_cross(t.normal, u);
    for (int k = 0; k < 3; k++) {
        double sine, cosine;
        vbss_sincos(2.0943951023931953 * k + draw_real(random, -0.5, 0.5), &sine, &cosine);
        double radius = draw_real(random, 1.0, 2.5);
        t.corners[k] = vec3_add_scaled(vec3_scale(u, radius * cosine), radius * sine, v);
        m->start[1 + k] = m->end[1 + k] = t.corners[k];
    }
    return t;
}

/* A point of the plane, often outside. */
static vec3 draw_in_plane(vbss_random *random, const triangle *t)
{
    double v = draw_real(random, -0.3, 1.0);
    double w = draw_real(random, -0.3, 1.0);
    vec3 x = vec3_scale(t->corners[0], 1.0 - v - w);
    return vec3_add_scaled(vec3_add_scaled(x, v, t->corners[1]), w, t->corners[2]);
}

static void wobble(vbss_random *random, collision_motion *m, double by)
{
    for (int i = 0; i < 4; i++) {
        m->end[i] = vec3_add(m->start[i], draw_vec3(random, -by, by));
    }
}

/* The point goes from above `where` to below it, or not quite. */
static void put_pass(vbss_random *random, collision_motion *m, vec3 where, vec3 normal)
{
    double gap = draw_real(random, 0.3, 2.0);
    double end_gap = gap * draw_real(random, -0.9, 1.5);
    m->start[0] = vec3_add_scaled(where, gap, normal);
    m->end[0] = vec3_add_scaled(where, -end_gap, normal);
}

static void generic_fast(vbss_random *random, collision_motion *m)
{
    for (int i = 0; i < 4; i++) {
        m->start[i] = draw_vec3(random, -3.0, 3.0);
    }
    wobble(random, m, 1.8);
    vec3 way = vbss_random_direction(random);
    m->end[0] = vec3_add_scaled(m->end[0], draw_real(random, 0.0, 6.0), way);
}

static void far_origin(vbss_random *random, collision_motion *m)
{
    generic_fast(random, m);
    vec3 offset = vec3_make(1e4, -7e3, 3e3);
    for (int i = 0; i < 4; i++) {
        m->start[i] = vec3_add(m->start[i], offset);
        m->end[i] = vec3_add(m->end[i], offset);
    }
}

static void slow(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    double gap = COLLISION_THICKNESS * draw_real(random, 0.98, 1.3);
    m->start[0] = vec3_add_scaled(draw_in_plane(random, &t), gap, t.normal);
    wobble(random, m, 0.05);
}

static void pass(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    put_pass(random, m, draw_in_plane(random, &t), t.normal);
}

/* Past an edge, nearly D away from it. */
static void edge_graze(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    vec3 along = vec3_sub(t.corners[1], t.corners[0]);
    vec3 outward = vec3_unit_or(vec3_cross(along, t.normal), t.normal);
    vec3 where = vec3_add_scaled(t.corners[0], draw_real(random, 0.0, 1.0), along);
    where = vec3_add_scaled(where, draw_nearly(random, COLLISION_THICKNESS), outward);
    put_pass(random, m, where, t.normal);
}

/* Over the face, nearly D away from it where it is nearest. */
static void face_graze(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    vec3 from = draw_in_plane(random, &t);
    vec3 to = draw_in_plane(random, &t);
    double height = draw_nearly(random, COLLISION_THICKNESS);
    double end_height = height + draw_real(random, 0.0, 0.5);
    m->start[0] = vec3_add_scaled(from, height, t.normal);
    m->end[0] = vec3_add_scaled(to, end_height, t.normal);
}

/* The third corner stands 10^U(-12, -2) off the edge of the others, which all wobble. */
static void sliver(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    vec3 along = vec3_sub(t.corners[1], t.corners[0]);
    vec3 foot = vec3_add_scaled(t.corners[0], draw_real(random, -0.2, 1.2), along);
    vec3 off = vbss_random_direction(random);
    m->start[3] = vec3_add_scaled(foot, draw_power_of_ten(random, -12.0, -2.0), off);
    m->end[3] = m->start[3];
    vec3 where = vec3_add(foot, draw_vec3(random, -0.5, 0.5));
    put_pass(random, m, where, t.normal);
    if (draw_chance(random, 0.5)) {
        vec3 moved = m->end[0];
        wobble(random, m, 0.5);
        m->end[0] = moved;
    }
}

/* Two corners or all three in one point. */
static void no_area(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    m->start[3] = m->end[3] = t.corners[0];
    if (draw_chance(random, 0.3)) {
        m->start[2] = m->end[2] = t.corners[0];
    }
    vec3 where = vec3_add(t.corners[0], draw_vec3(random, -0.5, 0.5));
    put_pass(random, m, where, t.normal);
}

static void in_plane(vbss_random *random, collision_motion *m)
{
    for (int i = 0; i < 8; i++) {
        vec3 x = draw_vec3(random, -4.0, 4.0);
        x.z = 0.0;
        *(i < 4 ? &m->start[i] : &m->end[i - 4]) = x;
    }
}

/* One corner or two swing through the point's place, which hardly moves. */
static void swing(vbss_random *random, collision_motion *m)
{
    triangle t = draw_triangle(random, m);
    vec3 where = draw_in_plane(random, &t);
    m->start[0] = vec3_add_scaled(where, draw_real(random, 0.3, 1.5), t.normal);
    m->end[0] = vec3_add(m->start[0], draw_vec3(random, -0.2, 0.2));
    int swinging = draw_integer(random, 1, 2);
    for (int k = 1; k <= swinging; k++) {
        m->end[k] = vec3_add_scaled(m->start[k], draw_real(random, 2.0, 8.0), t.normal);
    }
}

/* ---- the sets */

static const collision_draw families[] = {generic_fast, slow,    pass,     edge_graze, face_graze,
                                          sliver,       no_area, in_plane, swing,      far_origin};
const char *const collision_sheet_names[] = {
    "triangle, generic fast", "triangle, slow",      "triangle, pass",    "triangle, edge graze",
    "triangle, face graze",   "triangle, sliver",    "triangle, no area", "triangle, in its plane",
    "triangle, swing",        "triangle, far origin"};
const uint32_t collision_sheet_count = sizeof families / sizeof families[0];
_Static_assert(sizeof families / sizeof families[0] ==
                   sizeof collision_sheet_names / sizeof collision_sheet_names[0],
               "a name for each");

bool collision_set_sheet(uint32_t family, uint32_t count, uint64_t seed, collision_set *set)
{
    return collision_set_make(set, collision_sheet_names[family], count, VBSS_PAIR_POINT_TRIANGLE,
                              families[family], seed, 150 + family);
}
