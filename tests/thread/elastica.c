#include "thread/elastica.h"

#include <math.h>

typedef struct shape {
    double angle, curvature, x, drop;
} shape;

static shape slope_of(const elastica *e, double s, shape at)
{
    double below = e->load + e->weight * (1.0 - s / e->length);
    double along = cos(at.angle);
    return (shape){at.curvature, -below * along / e->bending, along, sin(at.angle)};
}

static shape moved(shape a, double factor, shape b)
{
    return (shape){a.angle + factor * b.angle, a.curvature + factor * b.curvature,
                   a.x + factor * b.x, a.drop + factor * b.drop};
}

/* From the tip to the clamp, or until it bends the other way. */
static shape shoot(const elastica *e, double tip_angle)
{
    enum { STEPS = 1000 };
    double h = -e->length / STEPS;
    shape at = {tip_angle, 0.0, 0.0, 0.0};
    for (int k = 0; k < STEPS && at.angle >= 0.0; k++) {
        double s = e->length + k * h;
        shape a = slope_of(e, s, at), b = slope_of(e, s + 0.5 * h, moved(at, 0.5 * h, a));
        shape c = slope_of(e, s + 0.5 * h, moved(at, 0.5 * h, b));
        shape d = slope_of(e, s + h, moved(at, h, c));
        at = moved(at, h / 6.0, moved(moved(moved(a, 2.0, b), 2.0, c), 1.0, d));
    }
    return at;
}

elastica elastica_solve(const vbss_thread_config *c, double load)
{
    elastica e = {.length = c->length, .load = load, .bending = c->bending_stiffness};
    e.weight = -c->gravity[1] * c->linear_density * c->length;
    double low = 0.0, high = 0x1.921fb54442d18p0;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        *(shoot(&e, middle).angle > 0.0 ? &high : &low) = middle;
    }
    shape clamp = shoot(&e, high);
    e.x = -clamp.x;
    e.drop = -clamp.drop;
    e.angle = high;
    e.moment = e.bending * clamp.curvature;
    return e;
}
