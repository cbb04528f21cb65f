#include "knots/draw.h"

#include <math.h>

#define PI 3.14159265358979324
#define FULL_TENSION 2.0 /* N */
#define EYE_AWAY 0.1     /* m */

/* ---- the thread */

/* A segment is painted in up to so many parts, each turning by so much at most, rad. */
enum { MAX_PARTS = 3, CURVE_POINTS = MAX_PARTS * KNOT_NODES };
#define PART_TURN 0.15

typedef struct curve {
    size_t count;
    vec3 x[CURVE_POINTS];
    painter_colour colours[CURVE_POINTS]; /* from each point to the next */
} curve;

/* Of the parabola through a node and its neighbours, for a parameter that is 1 over a segment's length. */
static vec3 slope(const vec3 *x, uint32_t n, uint32_t node, double length)
{
    vec3 before = x[node > 0 ? node - 1 : 0], after = x[node + 1 < n ? node + 1 : n - 1];
    double path_length = vec3_distance(before, x[node]) + vec3_distance(x[node], after);
    return vec3_scale(vec3_sub(after, before), length / path_length);
}

/* Tensions are of segments' middles; between those they are taken to go straight. */
static double tension_at(const double *tensions, uint32_t n, uint32_t segment, double t)
{
    bool later = t > 0.5, none = later ? segment + 2 >= n : segment == 0;
    double here = tensions[segment];
    double beside = none ? here : tensions[later ? segment + 1 : segment - 1];
    return here + fabs(t - 0.5) * (beside - here);
}

painter_colour draw_by_tension(const void *tensions, uint32_t segment, double t)
{
    const draw_tensions *d = tensions;
    return painter_ramp(tension_at(d->tensions, d->node_count, segment, t), 0.0, FULL_TENSION);
}

painter_colour draw_by_limb(const void *knot, uint32_t segment, double t)
{
    const gallery_knot *g = knot;
    (void)t;
    return segment < g->knot.node_count / 2 ? PAINTER_SKY : PAINTER_ORANGE;
}

static void add_segment(curve *c, const vec3 *x, uint32_t n, uint32_t i, draw_colour *colour,
                        const void *user)
{
    double length = vec3_distance(x[i], x[i + 1]);
    vec3 begin = slope(x, n, i, length), end = slope(x, n, i + 1, length);
    double turn = vec3_distance(begin, end) / length;
    int parts = (int)vbss_min(1.0 + turn / PART_TURN, MAX_PARTS);
    for (int part = 0; part < parts; part++) {
        double t = (double)part / parts, u = 1.0 - t;
        vec3 at = vec3_scale(x[i], u * u * (1.0 + 2.0 * t));
        at = vec3_add_scaled(at, t * t * (3.0 - 2.0 * t), x[i + 1]);
        at = vec3_add_scaled(at, t * u * u, begin);
        c->x[c->count] = vec3_add_scaled(at, -t * t * u, end);
        c->colours[c->count++] = colour(user, i, t + 0.5 / parts);
    }
}

bool draw_thread(painter *p, const gallery_knot *g, const vec3 *x, uint32_t first, uint32_t last,
                 draw_colour *colour, const void *user)
{
    static curve c;
    c.count = 0;
    for (uint32_t i = first; i < last; i++) {
        add_segment(&c, x, g->knot.node_count, i, colour, user);
    }
    c.x[c.count++] = x[last];
    return painter_add_chain(p, &c.x[0].x, c.count, 0, g->knot.options.thread.radius,
                             PAINTER_VIOLET, c.colours) == PAINTER_OK;
}

/* ---- what it is tied round, and held open by */

enum { TUBE_SIDES = 80 };
#define TUBE_FRONT 1.2e-3 /* m */
#define TUBE_BACK 2.5e-3
#define TUBE_INSIDE 0.7 /* of the radius */
#define PEG_FRONT 1.5e-3
#define PEG_BACK 3e-3

static void put_ring(vec3 *vertices, vec3 middle, double y, double radius)
{
    for (int i = 0; i < TUBE_SIDES; i++) {
        double angle = 2.0 * PI * i / TUBE_SIDES;
        vertices[i] = vec3_make(middle.x + radius * cos(angle), y, middle.z + radius * sin(angle));
    }
}

bool draw_cylinder(painter *p, const gallery_knot *g, double y, bool whole)
{
    vec3 vertices[4][TUBE_SIDES], at = g->knot.line.cylinder_begin;
    uint32_t corners[18 * TUBE_SIDES], count = 0;
    uint32_t first = whole ? 0 : TUBE_SIDES, last = whole ? 3 * TUBE_SIDES : 2 * TUBE_SIDES;
    double radius = g->knot.options.knot.cylinder_radius, bore = TUBE_INSIDE * radius;
    put_ring(vertices[0], at, y + TUBE_BACK, radius);
    put_ring(vertices[1], at, y - TUBE_FRONT, radius);
    put_ring(vertices[2], at, y - TUBE_FRONT, bore);
    put_ring(vertices[3], at, y + TUBE_BACK, bore);
    for (uint32_t i = first; i < last; i++) { /* outside, rim, inside */
        uint32_t next = (i + 1) % TUBE_SIDES == 0 ? i + 1 - TUBE_SIDES : i + 1;
        uint32_t of[6] = {i, next, i + TUBE_SIDES, next, next + TUBE_SIDES, i + TUBE_SIDES};
        for (int k = 0; k < 6; k++) {
            corners[count++] = of[k];
        }
    }
    return !g->cylinder ||
           painter_add_triangles(p, &vertices[0][0].x, sizeof vertices / sizeof(vec3), 0, corners,
                                 count / 3, PAINTER_STEEL) == PAINTER_OK;
}

bool draw_pegs(painter *p, const gallery_knot *g, const gallery_frame *f)
{
    bool good = true;
    for (int k = 0; k < TIED_KNOT_PEGS && g->knot.peg_radius > 0.0 && f->shows_pegs; k++) {
        double begin[3], end[3];
        vec3_store(begin, vec3_add(f->pegs[k], vec3_make(0.0, -PEG_FRONT, 0.0)));
        vec3_store(end, vec3_add(f->pegs[k], vec3_make(0.0, PEG_BACK, 0.0)));
        good = good &&
               painter_add_capsule(p, begin, end, g->knot.peg_radius, PAINTER_TISSUE) == PAINTER_OK;
    }
    return good;
}

/* ---- where from */

bool draw_seen_from(painter *p, vec3 target, double azimuth, double elevation, double width)
{
    painter_camera c = {.width = width};
    vec3 level = vec3_make(sin(azimuth), -cos(azimuth), 0.0), up = vec3_make(0.0, 0.0, 1.0);
    vec3 back = vec3_add_scaled(vec3_scale(level, cos(elevation)), sin(elevation), up);
    vec3_store(c.target, target);
    vec3_store(c.eye, vec3_add_scaled(target, EYE_AWAY, back));
    vec3_store(c.up, vec3_add_scaled(vec3_scale(up, cos(elevation)), -sin(elevation), level));
    return painter_set_camera(p, &c) == PAINTER_OK;
}
