/* Shapes in camera space: where they are in the picture, and where a ray hits them. */
#include "picture.h"

static const double thinnest = 0.8; /* radius in pixels: what is thinner would be hard to see */

shape shape_placed(const view *v, const shape *s)
{
    shape placed = *s;
    bool flat = s->kind == SHAPE_TRIANGLE || s->kind == SHAPE_FLOOR;
    placed.a = view_place(v, s->a);
    placed.b = flat ? view_turn(v, s->b) : view_place(v, s->b);
    placed.c = view_turn(v, s->c);
    double scale = view_scale_at(v, flat ? placed.a.z : 0.5 * (placed.a.z + placed.b.z));
    if (flat) {
        placed.radius = 1.5 / scale; /* depths nearer to each other than that are one */
    } else if (s->kind == SHAPE_CAPSULE) {
        placed.radius = fmax(s->radius, thinnest / scale);
    } else if (s->kind == SHAPE_LINE) {
        placed.radius = 0.6 / scale;
    }
    return placed;
}

/* ---- boxes of pixels */

static void widen(box *b, double x, double y)
{
    *b = (box){fmin(b->x0, x), fmax(b->x1, x), fmin(b->y0, y), fmax(b->y1, y)};
}

/* Round a cube about the place, which holds its ball; false when that reaches behind the eye. */
static bool widen_by_ball(box *b, const view *v, vec place, double radius)
{
    for (int corner = 0; corner < 8; corner++) {
        double x, y;
        vec at = {place.x + ((corner & 1) != 0 ? radius : -radius),
                  place.y + ((corner & 2) != 0 ? radius : -radius),
                  place.z + ((corner & 4) != 0 ? radius : -radius)};
        if (!view_project(v, at, &x, &y)) {
            return false;
        }
        widen(b, x, y);
    }
    return true;
}

box shape_box(const view *v, const shape *placed, double t0, double t1)
{
    box b = {1e30, -1e30, 1e30, -1e30};
    bool whole;
    if (placed->kind == SHAPE_CAPSULE || placed->kind == SHAPE_LINE) {
        vec from = vec_lerp(placed->a, placed->b, t0), to = vec_lerp(placed->a, placed->b, t1);
        whole =
            widen_by_ball(&b, v, from, placed->radius) && widen_by_ball(&b, v, to, placed->radius);
    } else {
        vec far = placed->kind == SHAPE_FLOOR ? vec_add(placed->b, placed->c) : placed->b;
        whole = widen_by_ball(&b, v, placed->a, 0.0) &&
                widen_by_ball(&b, v, vec_add(placed->a, placed->b), 0.0) &&
                widen_by_ball(&b, v, vec_add(placed->a, placed->c), 0.0) &&
                widen_by_ball(&b, v, vec_add(placed->a, far), 0.0);
    }
    return whole ? b : (box){0.0, v->width, 0.0, v->height};
}

/* ---- rays */

/* The ray passes `gap`, a vector across it, from the centre of a ball it comes nearest to at t. */
static bool enters_ball(vec gap, double t_nearest, double radius, double *t)
{
    double inside = radius * radius - vec_dot(gap, gap);
    if (inside < 0.0) {
        return false;
    }
    *t = t_nearest - sqrt(inside);
    return true;
}

static bool hit_capsule(const shape *s, const ray *r, double *t)
{
    vec axis = vec_sub(s->b, s->a);
    double length2 = vec_dot(axis, axis), slope = vec_dot(axis, r->along);
    /* Where the ray is nearest to a and to b; from there, numbers are small however far the eye. */
    double ta = vec_dot(vec_sub(s->a, r->from), r->along);
    vec gap_a = vec_sub(vec_add(r->from, vec_scale(r->along, ta)), s->a);
    double tb = ta + slope;
    vec gap_b = vec_sub(vec_add(gap_a, vec_scale(r->along, slope)), axis);
    double across2 = length2 - slope * slope; /* of the axis across the ray */
    if (across2 > 1e-9 * length2) {
        /* The cylinder round the axis: |gap_a + u along| across the axis is the radius. */
        double lean = vec_dot(gap_a, axis);
        double half = lean * slope; /* length2 times the linear term */
        double constant = length2 * (vec_dot(gap_a, gap_a) - s->radius * s->radius) - lean * lean;
        double root2 = half * half - across2 * constant;
        if (root2 < 0.0) {
            return false; /* nor do the balls reach beyond it */
        }
        double u = (half - sqrt(root2)) / across2;
        double along_axis = lean + u * slope;
        if (along_axis >= 0.0 && along_axis <= length2) {
            *t = ta + u;
            return true;
        }
        return along_axis < 0.0 ? enters_ball(gap_a, ta, s->radius, t)
                                : enters_ball(gap_b, tb, s->radius, t);
    }
    return slope >= 0.0 ? enters_ball(gap_a, ta, s->radius, t)
                        : enters_ball(gap_b, tb, s->radius, t);
}

static bool hit_plane(const shape *s, const ray *r, double *t)
{
    vec across = vec_cross(r->along, s->c), from = vec_sub(r->from, s->a);
    double volume = vec_dot(s->b, across);
    if (fabs(volume) < 1e-300) {
        return false; /* seen from its edge */
    }
    vec other = vec_cross(from, s->b);
    double u = vec_dot(from, across) / volume, w = vec_dot(r->along, other) / volume;
    bool within = s->kind == SHAPE_FLOOR ? u <= 1.0 && w <= 1.0 : u + w <= 1.0;
    *t = vec_dot(s->c, other) / volume;
    return u >= 0.0 && w >= 0.0 && within;
}

bool shape_hit(const shape *placed, const ray *r, double *t)
{
    bool is_round = placed->kind == SHAPE_CAPSULE || placed->kind == SHAPE_LINE;
    return is_round ? hit_capsule(placed, r, t) : hit_plane(placed, r, t);
}

vec shape_normal(const shape *placed, const ray *r, vec point)
{
    if (placed->kind == SHAPE_CAPSULE || placed->kind == SHAPE_LINE) {
        vec axis = vec_sub(placed->b, placed->a), out = vec_sub(point, placed->a);
        double length2 = vec_dot(axis, axis);
        double at = length2 > 0.0 ? clamp(vec_dot(out, axis) / length2, 0.0, 1.0) : 0.0;
        out = vec_sub(out, vec_scale(axis, at));
        return vec_scale(out, 1.0 / fmax(vec_length(out), 1e-300));
    }
    vec normal = vec_cross(placed->b, placed->c);
    double length = vec_length(normal);
    return vec_scale(normal, (vec_dot(normal, r->along) > 0.0 ? -1.0 : 1.0) / fmax(length, 1e-300));
}
