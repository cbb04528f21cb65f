#include "scenes/clutter.h"

#include "base/elementary.h"
#include "base/random.h"
#include "scenes/knot_path.h"

#define PI 3.141592653589793
#define PIECE 0.8e-3  /* m: of a limb that wanders */
#define STRAIGHT 4e-3 /* m: its segments in the end */

enum { STRAIGHT_PIECES = 4, CURL_PIECES = 14 };

static double draw(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

static bool put(thread_line *line, vec3 x)
{
    if (line->count == STACK_POINTS) {
        return false;
    }
    line->x[line->count++] = x;
    return true;
}

/* ---- climbing */

typedef struct climb {
    thread_line *line;
    vec3 right, ahead, up, axis; /* frame; a point of the axis */
    double slope;
} climb;

/* A point beside the axis, higher than the last by as much as the way to it asks for. */
static bool go_to(climb *c, double x, double y)
{
    vec3 last = c->line->x[c->line->count - 1];
    vec3 flat = vec3_add_scaled(vec3_add_scaled(c->axis, x, c->right), y, c->ahead);
    vec3 way = vec3_sub(flat, last);
    way = vec3_add_scaled(way, -vec3_dot(way, c->up), c->up);
    double length = vec3_norm(way);
    vec3 next = vec3_add(last, vec3_add_scaled(way, c->slope * length + 1e-6, c->up));
    return put(c->line, next);
}

/* Beside the axis, and the direction of the last segment there (unit, or nothing). */
typedef struct stand {
    double x, y, dx, dy;
} stand;

static stand where(const climb *c)
{
    const vec3 *last = &c->line->x[c->line->count - 1];
    vec3 from = vec3_sub(last[0], c->axis), way = vec3_sub(last[0], last[-1]);
    double dx = vec3_dot(way, c->right), dy = vec3_dot(way, c->ahead);
    double length = sqrt(dx * dx + dy * dy), by = length > 0.0 ? 1.0 / length : 0.0;
    return (stand){vec3_dot(from, c->right), vec3_dot(from, c->ahead), dx * by, dy * by};
}

/* A bent way to a point of the disc, which does not begin by turning sharply. */
static bool wander(climb *c, vbss_random *random, double reach)
{
    stand s = where(c);
    double wx = 0.0, wy = 0.0, bend = 0.0;
    for (int tries = 0; tries < 40; tries++) {
        double radius = reach * sqrt(vbss_random_uniform(random)), sine, cosine;
        vbss_sincos(draw(random, 0.0, 2.0 * PI), &sine, &cosine);
        wx = radius * cosine - s.x;
        wy = radius * sine - s.y;
        bend = draw(random, -0.5, 0.5);
        double bx = wx - PI * bend * wy, by = wy + PI * bend * wx;
        if (s.dx * bx + s.dy * by >= -0.3 * sqrt(bx * bx + by * by)) {
            break;
        }
    }
    uint32_t pieces = (uint32_t)(sqrt(wx * wx + wy * wy) / PIECE) + 2;
    for (uint32_t i = 1; i <= pieces; i++) {
        double t = (double)i / pieces, side = bend * vbss_sin(PI * t);
        if (!go_to(c, s.x + t * wx - side * wy, s.y + t * wy + side * wx)) {
            return false;
        }
    }
    return true;
}

/* So many pieces of a circle, on from where it goes. */
static bool curl(climb *c, vbss_random *random, int pieces)
{
    stand s = where(c);
    double radius = draw(random, 0.8e-3, 3e-3), sine, cosine;
    int sense = vbss_random_below(random, 2) == 0 ? 1 : -1;
    double begin = vbss_atan2(-sense * s.dx, sense * s.dy);
    vbss_sincos(begin, &sine, &cosine);
    double x = s.x - radius * cosine, y = s.y - radius * sine;
    for (int i = 1; i <= pieces; i++) {
        vbss_sincos(begin + sense * 2.0 * PI * i / CURL_PIECES, &sine, &cosine);
        if (!go_to(c, x + radius * cosine, y + radius * sine)) {
            return false;
        }
    }
    return true;
}

static bool is_highest(const thread_line *line, vec3 up)
{
    vec3 end = line->x[line->count - 1];
    for (uint32_t i = 0; i + 1 < line->count; i++) {
        if (vec3_dot(vec3_sub(line->x[i], end), up) > 1e-9) {
            return false;
        }
    }
    return true;
}

/* From the long limb's end. */
static bool climb_on(thread_line *line, const clutter *how, vbss_random *random)
{
    if (!is_highest(line, how->up)) {
        return false;
    }
    uint32_t first = line->count;
    vec3 right = vec3_any_normal(how->up);
    climb c = {line, right, vec3_cross(how->up, right), how->up, how->over, how->slope};
    bool on = curl(&c, random, CURL_PIECES / 2);
    for (uint32_t i = 0; i < how->passes && on; i++) {
        on = wander(&c, random, how->reach) &&
             (vbss_random_below(random, 3) != 0 || curl(&c, random, CURL_PIECES));
    }
    if (!on) {
        return false;
    }
    for (int i = 0; i < STRAIGHT_PIECES; i++) {
        if (!put(line, vec3_add_scaled(line->x[line->count - 1], STRAIGHT, how->up))) {
            return false;
        }
    }
    vec3 out = vec3_sub(line->x[0], line->x[1]); /* the other limb has all that lies beyond it */
    for (uint32_t i = first; i < line->count; i++) {
        if (vec3_dot(vec3_sub(line->x[i], line->x[0]), out) >= 0.0) {
            return false;
        }
    }
    return true;
}

bool clutter_limb(thread_line *line, const clutter *how, uint64_t seed)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 97);
    if (how->tail) {
        thread_line_reverse(line);
    }
    bool climbed = climb_on(line, how, &random);
    if (how->tail) {
        thread_line_reverse(line);
    }
    return climbed;
}

/* ---- a throw of a limb round itself */

static bool throw_on(thread_line *line, const knot_pile *pile, double size, double behind)
{
    knot_curve curve;
    knot_curve_begin(&curve, KNOT_PATH_SPACING * size);
    knot_path_pile(pile, size, 2.0 * size, &curve);
    double length = knot_curve_length(&curve), step = 0.3 * size;
    vec3 begin = knot_curve_at(&curve, 0.0), end = line->x[line->count - 1];
    vec3 ahead = vec3_unit_or(vec3_sub(end, line->x[line->count - 2]), vec3_zero());
    vec3 up = vec3_any_normal(ahead), left = vec3_cross(up, ahead);
    /* its loop reaches back as far as its middle is ahead */
    vec3 at = vec3_add_scaled(end, 2.0 * fabs(begin.x), ahead);
    uint32_t pieces = (uint32_t)(length / step) + 1;
    for (uint32_t i = 0; i <= pieces; i++) {
        vec3 from = vec3_sub(knot_curve_at(&curve, length * i / pieces), begin);
        vec3 x = vec3_add_scaled(at, from.x, ahead);
        x = vec3_add_scaled(vec3_add_scaled(x, from.y, left), from.z, up);
        if (!put(line, x)) {
            return false;
        }
    }
    uint32_t straight = (uint32_t)(behind / 2e-3) + 1;
    for (uint32_t i = 0; i < straight; i++) {
        if (!put(line, vec3_add_scaled(line->x[line->count - 1], behind / straight, ahead))) {
            return false;
        }
    }
    return true;
}

bool clutter_throw(thread_line *line, bool tail, int wraps, int sign, double size, double behind)
{
    knot_pile pile = {.throws = 1, .wraps = {wraps}, .signs = {sign}};
    if (tail) {
        thread_line_reverse(line);
    }
    bool done = throw_on(line, &pile, size, behind);
    if (tail) {
        thread_line_reverse(line);
    }
    return done;
}

void clutter_cut(thread_line *line, bool tail, double share)
{
    if (tail) {
        thread_line_reverse(line);
    }
    double last = line->count - 1.0;
    double kept = line->tissue_place >= 0.0 ? line->hole_places[1] : 0.5 * last;
    line->count = (uint32_t)(last - share * (last - kept)) + 1;
    if (tail) {
        thread_line_reverse(line);
    }
}
