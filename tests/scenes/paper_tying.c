#include "scenes/paper_tying.h"

#include "base/elementary.h"
#include "base/random.h"

#define TWO_PI 6.283185307179586

typedef struct builder {
    vbss_random random;
    double segment;
    uint32_t count;
    vec3 *points;
} builder;

static double uniform(builder *b, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(&b->random);
}

static void line_to(builder *b, vec3 to)
{
    vec3 from = b->points[b->count - 1];
    double pieces = floor(vec3_distance(from, to) / b->segment + 0.5);
    uint32_t n = pieces >= 1.0 ? (uint32_t)pieces : 1;
    for (uint32_t k = 1; k <= n && b->count < PAPER_TYING_POINTS; k++) {
        b->points[b->count++] = vec3_lerp(from, to, (double)k / n);
    }
}

static vec3 around(double angle, double radius, double height)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    return vec3_make(radius * cosine, radius * sine, height);
}

/* Turns about the line through `centre` along `axis`, which is steep; the first and the last strand go far out. */
static void wrap(builder *b, const paper_tying *tying, vec3 centre, vec3 axis)
{
    double hand = vbss_random_below(&b->random, 2) == 0 ? -TWO_PI : TWO_PI;
    double begin = uniform(b, 0.0, TWO_PI);
    double turns = tying->wraps + uniform(b, 0.3, 0.7);
    double radius = uniform(b, 2.65e-3, 4e-3), growth = uniform(b, -0.15, 0.15);
    double lobes = uniform(b, 0.0, 0.15), phase = uniform(b, 0.0, TWO_PI);
    double rise = (tying->towards_handle ? 1.0 : -1.0) * uniform(b, 2e-3, 4e-3);
    uint32_t pieces = (uint32_t)(TWO_PI * turns * radius / b->segment) + 1;
    /* Out of the tissue, past the turns on the outside. */
    vec3 beside = vec3_add(centre, around(begin, 2.5 * radius, 0.0));
    beside.z = b->points[b->count - 1].z;
    line_to(b, beside);
    for (uint32_t k = 0; k <= pieces + 1; k++) {
        double turn = turns * (double)(k == 0 ? 0 : k - 1) / pieces;
        double wave = lobes * vbss_sin(2.3 * TWO_PI * turn + phase);
        double r = k == 0 ? 2.5 * radius : radius * (1.0 + growth * turn + wave);
        vec3 out = around(begin + hand * turn, r, 0.0);
        vec3 x = vec3_add_scaled(vec3_add(centre, out), rise * (turn - 0.5 * turns), axis);
        line_to(b, x);
    }
    double leaves = begin + hand * (turns + uniform(b, -0.1, 0.1));
    line_to(b, around(leaves, 60e-3, centre.z - 10e-3));
}

uint32_t paper_tying_make(const paper_tying *tying, uint64_t seed, vec3 points[PAPER_TYING_POINTS])
{
    builder b = {.segment = tying->segment, .count = 1, .points = points};
    vbss_random_seed(&b.random, seed, 7);
    double beside = uniform(&b, 0.2e-3, 0.9e-3), around_jaw = uniform(&b, 0.0, TWO_PI);
    vec3 jaw = around(around_jaw, beside, 2e-3), up = vec3_make(0.0, 0.0, 1.0), hole, centre;
    double side = uniform(&b, 0.0, TWO_PI);
    if (tying->stage == PAPER_TYING_DRAWN) {
        double slope = uniform(&b, 0.0, tying->tilt), length = uniform(&b, 20e-3, 27e-3);
        double share = uniform(&b, 0.3, 0.8);
        hole = vec3_add(jaw, around(side, length * vbss_sin(slope), -length * vbss_cos(slope)));
        centre = vec3_lerp(jaw, hole, share);
        up = vec3_unit_or(vec3_sub(jaw, hole), up);
    } else {
        double far = uniform(&b, 10e-3, 15e-3), height = uniform(&b, 15e-3, 25e-3);
        hole = around(side, far, height);
        centre = vec3_make(0.0, 0.0, uniform(&b, 9e-3, 18e-3));
    }
    vec3 held = jaw;
    if (tying->stage == PAPER_TYING_WRAPPED) {
        double away = uniform(&b, 3e-3, 8e-3), height = uniform(&b, -4e-3, 4e-3);
        held = around(side, away, height);
    }
    /* The tail's end goes on as it came, within half a right angle. */
    vec3 astray = vec3_scale(vbss_random_direction(&b.random), 0.7);
    vec3 on = vec3_unit_or(vec3_add(vec3_unit_or(vec3_sub(held, hole), up), astray), up);
    points[0] = vec3_add_scaled(held, 3.5e-3, on);
    line_to(&b, held);
    line_to(&b, hole);
    if (tying->wraps > 0) {
        wrap(&b, tying, centre, up);
    } else {
        line_to(&b, around(side, 60e-3, hole.z));
    }
    return b.count;
}
