#include "scenes/knot_path.h"

#include "base/elementary.h"

#define PI 3.141592653589793

/* Lengths in sizes. */
#define STRAND 0.25   /* distance of a strand from the axis of its throw */
#define HALF_TURN 1.5 /* length of a half turn; one more is spent on beginning and ending softly */
#define TURN_RADIUS 1.2 /* between throws */
#define BIGHT 2.0       /* least radius of the loop below */
#define LEAD 0.6        /* straight, at either end */

/* The cylinder's surface is passed at this many sums of both radii from its axis, at least. */
#define CLEARANCE 1.4

static const knot_pile flat_knots[] = {
    [KNOT_LOOP] = {1, {0}, {1}},
    [KNOT_OVERHAND] = {1, {1}, {1}},
    [KNOT_DOUBLE_OVERHAND] = {1, {2}, {1}},
    [KNOT_SQUARE] = {2, {1, 1}, {1, -1}},
    [KNOT_GRANNY] = {2, {1, 1}, {1, 1}},
    [KNOT_SURGEON] = {2, {2, 1}, {1, -1}},
    [KNOT_FLS] = {3, {2, 1, 1}, {1, -1, 1}},
};

/* ---- one strand through a throw */

typedef struct strand {
    double size;
    double height;    /* of the throw's axis */
    int half_turns;   /* an odd number */
    int direction;    /* of travel along x */
    int sign;         /* +1: the two strands turn about each other right-handed */
    bool from_bottom; /* or from the top; it ends at the other one */
} strand;

static double half_width(const strand *s)
{
    return 0.5 * (s->half_turns + 1) * HALF_TURN * s->size;
}

/* How far a strand has turned when it has gone a length t, in half turns: at full rate but for the first
 * and the last unit of length, where the rate grows from and falls to nothing. */
static double half_turns_after(double t, int half_turns)
{
    if (t < 1.0) {
        return 0.5 * t * t;
    }
    double left = half_turns + 1 - t;
    return left < 1.0 ? half_turns - 0.5 * left * left : t - 0.5;
}

static vec3 on_strand(double t, const void *user)
{
    const strand *s = user;
    double sine, cosine;
    vbss_sincos(PI * half_turns_after(t * (s->half_turns + 1), s->half_turns), &sine, &cosine);
    double side = s->from_bottom ? STRAND * s->size : -STRAND * s->size;
    return vec3_make(s->direction * half_width(s) * (2.0 * t - 1.0),
                     side * s->direction * s->sign * sine, s->height - side * cosine);
}

static void put_strand(knot_curve *curve, const strand *s)
{
    knot_curve_piece(curve, 2.0 * half_width(s), on_strand, s);
}

/* ---- throws on top of each other */

/* Round a half turn from one height to another on that side, from x = |from| to x = |to|. */
static void put_turn(knot_curve *curve, int side, double from, double z_from, double to,
                     double z_to)
{
    double out = side * vbss_max(from, to), radius = 0.5 * fabs(z_to - z_from);
    double start = z_to > z_from ? -0.5 * PI : 0.5 * PI;
    knot_curve_straight(curve, vec3_make(side * from, 0.0, z_from), vec3_make(out, 0.0, z_from));
    knot_curve_arc(curve, vec3_make(out, 0.0, 0.5 * (z_from + z_to)), radius, start,
                   start + (z_to > z_from ? side : -side) * PI);
    knot_curve_straight(curve, vec3_make(out, 0.0, z_to), vec3_make(side * to, 0.0, z_to));
}

static double bight_radius(const knot_shape *shape)
{
    double least = BIGHT * shape->size;
    double clear = CLEARANCE * (shape->cylinder_radius + shape->thread_radius);
    return shape->cylinder ? vbss_max(least, clear) : least;
}

vec3 knot_path_put_pile(const knot_pile *pile, double size, double radius, knot_curve *curve)
{
    uint32_t top = pile->throws - 1;
    double strand_height = STRAND * size;
    strand throws[KNOT_PILE_THROWS];
    for (uint32_t i = 0; i <= top; i++) {
        throws[i] = (strand){.size = size,
                             .height = i * 2.0 * (TURN_RADIUS + STRAND) * size,
                             .half_turns = 2 * pile->wraps[i] + 1,
                             .direction = (top - i) % 2 == 0 ? 1 : -1,
                             .sign = pile->signs[i]};
    }
    double half = half_width(&throws[top]), lead = LEAD * size;
    double z = throws[top].height + strand_height;
    knot_curve_straight(curve, vec3_make(-half - lead, 0.0, z), vec3_make(-half, 0.0, z));
    for (uint32_t i = top + 1; i-- > 0;) {
        put_strand(curve, &throws[i]);
        if (i > 0) {
            put_turn(curve, throws[i].direction, half_width(&throws[i]),
                     throws[i].height - strand_height, half_width(&throws[i - 1]),
                     throws[i - 1].height + strand_height);
        }
    }
    double low = -strand_height - 2.0 * radius, wide = half_width(&throws[0]);
    int side = throws[0].direction;
    put_turn(curve, side, wide, -strand_height, 0.0, low);
    put_turn(curve, -side, 0.0, low, wide, -strand_height);
    for (uint32_t i = 0; i <= top; i++) {
        throws[i].from_bottom = true;
        put_strand(curve, &throws[i]);
        if (i < top) {
            put_turn(curve, throws[i].direction, half_width(&throws[i]),
                     throws[i].height + strand_height, half_width(&throws[i + 1]),
                     throws[i + 1].height - strand_height);
        }
    }
    knot_curve_straight(curve, vec3_make(half, 0.0, z), vec3_make(half + lead, 0.0, z));
    return vec3_make(half + lead, 0.0, z);
}

void knot_path_pile(const knot_pile *pile, double size, double radius, knot_curve *curve)
{
    vec3 end = knot_path_put_pile(pile, size, radius, curve);
    knot_curve_finish(curve, end);
}

void knot_path(const knot_shape *shape, knot_curve *curve, knot_line *line)
{
    bool hitches = shape->kind == KNOT_HALF_HITCHES || shape->kind == KNOT_REVERSED_HALF_HITCHES;
    double radius = bight_radius(shape), x = 0.0, z = -radius;
    knot_curve_begin(curve, KNOT_PATH_SPACING * shape->size);
    if (hitches) {
        knot_path_hitches(shape, radius, curve, &x);
    } else {
        knot_pile pile = flat_knots[shape->kind];
        for (uint32_t i = 0; i < pile.throws && shape->mirrored; i++) {
            pile.signs[i] = -pile.signs[i];
        }
        knot_path_pile(&pile, shape->size, radius, curve);
        z -= STRAND * shape->size;
    }
    if (shape->cylinder) {
        double reach = 10.0 * shape->size;
        line->cylinder_begin = vec3_make(x, -reach, z);
        line->cylinder_end = vec3_make(x, reach, z);
    }
}
