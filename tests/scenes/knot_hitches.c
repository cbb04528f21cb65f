/* Two half hitches: the tail turns twice about the straight standing part and is held by its own middle,
 * which crosses over both its ends. From node 0: tail, turns, the loop round the cylinder, standing part. */
#include "base/elementary.h"
#include "scenes/knot_path.h"

#define PI 3.141592653589793

/* Lengths in sizes. */
#define TURN_RADIUS 1.15 /* of the turns about the standing part */
#define RISE 0.7         /* by which the middle passes further out */
#define GAP 0.35         /* of an end from the middle plane */
#define SPREAD 1.8       /* of the turns from it, about */
#define ALIKE_SPREAD (SPREAD / 0.65)
#define BEND 1.3       /* radius of bends in the plane of x and z */
#define TAIL_ABOVE 3.4 /* the tail's distance from the standing part (alike) */
#define TAIL_BELOW 3.0 /* or from the loop (reversed) */

/* Reversed turns: how sharply their middle goes over from one to the other, rad; and how far before the
 * front it stays. */
#define SIDEWAYS 0.8
#define BACK 0.55
#define SHORT_OF_FRONT 0.25

typedef struct turns {
    double size;
    bool reversed;
    double front; /* the side of the ends: +1: at y > 0 */
} turns;

/* Angle about the standing part, from the front upwards, and place along it, for w from -2 pi to 2 pi. */
static void unroll(const turns *h, double w, double *angle, double *x)
{
    double sine, cosine;
    vbss_sincos(0.25 * w, &sine, &cosine);
    if (!h->reversed) {
        *angle = -(w + 2.0 * PI);
        *x = -(ALIKE_SPREAD * 2.0 * sine * cosine * cosine * cosine + GAP * sine);
        return;
    }
    double most = sqrt(4.0 * PI * PI + BACK * BACK) - BACK;
    *angle = (2.0 * PI - SHORT_OF_FRONT) * (1.0 - (sqrt(w * w + BACK * BACK) - BACK) / most);
    *x = -(GAP + (SPREAD - GAP) * cosine * cosine) * w / sqrt(w * w + SIDEWAYS * SIDEWAYS);
}

static vec3 on_turns(double t, const void *user)
{
    const turns *h = user;
    double w = 2.0 * PI * (2.0 * t - 1.0), angle, x, sine, cosine;
    unroll(h, w, &angle, &x);
    double rising = fabs(w) < PI ? vbss_cos(0.5 * w) : 0.0;
    vbss_sincos(angle, &sine, &cosine);
    double radius = TURN_RADIUS + RISE * rising * rising;
    return vec3_scale(vec3_make(x, h->front * radius * cosine, radius * sine), h->size);
}

/* Control points from the first on go over softly from one plane y = const to another. */
static void go_over(knot_curve *curve, uint32_t first, double y)
{
    for (uint32_t i = first; i < curve->count; i++) {
        double t = (double)(i - first) / (curve->count - first);
        curve->points[i].y += y * (1.0 - t * t * t * (10.0 + t * (6.0 * t - 15.0)));
    }
}

void knot_path_hitches(const knot_shape *shape, double loop_radius, knot_curve *curve,
                       double *cylinder_x)
{
    double size = shape->size, bend = BEND * size, gap = GAP * size;
    turns h = {size, shape->kind == KNOT_REVERSED_HALF_HITCHES, shape->mirrored ? 1.0 : -1.0};
    double y = h.front * TURN_RADIUS * size, up = h.reversed ? -1.0 : 1.0;
    double z = h.reversed ? -2.0 * loop_radius - TAIL_BELOW * size : TAIL_ABOVE * size;
    double loop_x = -loop_radius - 2.0 * SPREAD * size, low = -2.0 * loop_radius;
    double begin = vbss_min(loop_x, gap - bend) - loop_radius, end = 3.0 * SPREAD * size;
    /* the tail, towards +x and then to the front of the standing part */
    knot_curve_straight(curve, vec3_make(begin, y, z), vec3_make(gap - bend, y, z));
    knot_curve_arc(curve, vec3_make(gap - bend, y, z - up * bend), bend, up * 0.5 * PI, 0.0);
    knot_curve_straight(curve, vec3_make(gap, y, z - up * bend), vec3_make(gap, y, 0.0));
    knot_curve_piece(curve, (4.0 * PI * TURN_RADIUS + 4.0 * SPREAD) * size, on_turns, &h);
    /* down, round the cylinder, and out as the standing part */
    knot_curve_straight(curve, vec3_make(-gap, y, 0.0), vec3_make(-gap, y, low + bend));
    uint32_t first = curve->count;
    knot_curve_arc(curve, vec3_make(-gap - bend, 0.0, low + bend), bend, 0.0, -0.5 * PI);
    knot_curve_straight(curve, vec3_make(-gap - bend, 0.0, low), vec3_make(loop_x, 0.0, low));
    knot_curve_arc(curve, vec3_make(loop_x, 0.0, -loop_radius), loop_radius, -0.5 * PI, -1.5 * PI);
    go_over(curve, first, y);
    knot_curve_straight(curve, vec3_make(loop_x, 0.0, 0.0), vec3_make(end, 0.0, 0.0));
    knot_curve_finish(curve, vec3_make(end, 0.0, 0.0));
    *cylinder_x = loop_x;
}
