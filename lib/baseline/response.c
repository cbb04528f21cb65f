/* The response of VBLaST-SS (Qi et al. 2017, algorithm 2), with one consistent set of signs, and
 * with rules for the cases that the paper leaves open: docs/explanation/paper-collision.md. The vectors q
 * and w lead from b to a. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/collision.h"

#include "collision/closest.h"
#include "collision/tuning.h"

_Static_assert(sizeof(vbss_collision_response) == 144, "published size");

static const uint32_t response_sizes[] = {144, 0}, impact_sizes[] = {136, 0};
static const vbss_layout response_layout = {"vbss_collision_response", NULL, response_sizes};
static const vbss_collision_impact no_impact = {.struct_size = sizeof no_impact};
static const vbss_layout impact_layout = {"vbss_collision_impact", &no_impact, impact_sizes};

typedef struct hit_pair {
    vbss_collision_pair_kind kind;
    int first_of_b; /* vertices before it belong to a */
    vec3 start[4], end[4];
    double inverse_masses[4];
    double thickness;
    vbss_collision_impact impact; /* all zero if there is none */
} hit_pair;

/* ---- vectors from b to a at one time */

typedef struct separation {
    vec3 line;         /* w: between the lines, or from the plane to the point; zero if undefined */
    vec3 nearest;      /* between the closest points */
    vec3 across;       /* normal to both features; zero if it is not unique */
    double weights[4]; /* weights of the closest points */
    double min_length; /* shorter vectors have no direction */
} separation;

static bool has_direction(const separation *s, vec3 v)
{
    return vec3_norm(v) > s->min_length;
}

static double larger_component(double size, vec3 v)
{
    double components[3];
    vec3_store(components, v);
    double largest = vbss_max_abs(components, 3);
    return largest > size ? largest : size;
}

/* Returns the component of r along n, reversed so that it leads from b to a; zero if n is zero. */
static vec3 back_along(vec3 n, vec3 r)
{
    double nn = vec3_norm_squared(n);
    return nn > 0.0 ? vec3_scale(n, -vec3_dot(r, n) / nn) : vec3_zero();
}

static void separate_edges(vec3 a, vec3 b, vec3 r, separation *s)
{
    double *w = s->weights;
    s->nearest = vec3_neg(closest_between_edges(a, b, r, &w[1], &w[3]));
    w[0] = 1.0 - w[1];
    w[2] = 1.0 - w[3];
    double ab = vec3_dot(a, b), squares = vec3_norm_squared(a) * vec3_norm_squared(b);
    if (squares - ab * ab > CLOSEST_PARALLEL * squares) {
        s->across = vec3_cross(a, b);
        s->line = back_along(s->across, r);
    } else if (ab != 0.0) { /* the paper's rule for parallel edges */
        s->line = vec3_neg(vec3_add_scaled(r, -vec3_dot(a, r) / ab, b));
    }
}

static void separate_point(const vec3 corners[3], separation *s)
{
    s->nearest = vec3_neg(closest_on_triangle(corners, &s->weights[1]));
    s->weights[0] = 1.0;
    vec3 e = vec3_sub(corners[1], corners[0]), f = vec3_sub(corners[2], corners[0]);
    vec3 n = vec3_cross(e, f);
    if (vec3_norm(n) > BASELINE_MIN_DIRECTION_RATIO * vec3_norm(e) * vec3_norm(f)) {
        s->across = n;
        s->line = back_along(n, corners[0]);
    }
}

static separation separate(const hit_pair *pair, const vec3 at[4])
{
    separation s = {.min_length = 0.0};
    vec3 to[3];
    double size = 0.0;
    for (int k = 0; k < 3; k++) {
        to[k] = vec3_sub(at[k + 1], at[0]);
        size = larger_component(size, to[k]);
    }
    s.min_length = BASELINE_MIN_DIRECTION_RATIO * size;
    if (pair->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        separate_edges(to[0], vec3_sub(to[2], to[1]), to[1], &s);
    } else {
        separate_point(to, &s);
    }
    return s;
}

/* ---- direction and depth */

typedef struct correction {
    vec3 q;
    double depth;
    bool completed;
} correction;

/* Returns the direction for features that meet, where the vector between them has none.
 * `closing` is the motion of b relative to a. */
static vec3 direction_where_they_meet(const hit_pair *pair, const separation *before,
                                      const separation *after, vec3 closing)
{
    if (has_direction(before, before->line)) {
        return vec3_unit_or(before->line, vec3_zero());
    }
    if (has_direction(before, before->nearest)) {
        return vec3_unit_or(before->nearest, vec3_zero());
    }
    vec3 known = vec3_neg(vec3_load(pair->impact.normal));
    if (vec3_norm_squared(known) == 0.0) {
        known = after->across;
        known = vec3_dot(known, closing) < 0.0 ? vec3_neg(known) : known;
    }
    vec3 side = vec3_sub(pair->end[3], pair->end[2]);
    vec3 any = vec3_any_normal(vec3_unit_or(side, vec3_make(0.0, 0.0, 1.0)));
    return vec3_unit_or(known, any);
}

/* Computes the correction as printed in the paper. The shortest vector is that of step (i) of
 * the test, unless the lines have crossed. */
static correction at_end_of_step(const hit_pair *pair, const separation *before,
                                 const separation *after, vec3 closing)
{
    correction c = {.depth = pair->thickness};
    bool lines = has_direction(before, before->line) && has_direction(after, after->line);
    double sign =
        lines ? vec3_dot(before->line, after->line) : vec3_dot(before->nearest, after->nearest);
    vec3 apart = lines && sign < 0.0 ? after->line : after->nearest;
    c.completed = !lines || sign == 0.0;
    if (!has_direction(after, apart)) {
        c.q = direction_where_they_meet(pair, before, after, closing);
        c.completed = true;
        return c;
    }
    double sigma = sign < 0.0 ? -1.0 : 1.0, length = vec3_norm(apart);
    c.q = vec3_scale(apart, sigma / length);
    c.depth -= sigma * length;
    /* features at least D apart need no correction, and a response never pulls them together */
    if (c.depth < 0.0) {
        c.depth = 0.0;
        c.completed = true;
    }
    return c;
}

static correction at_time_of_impact(const hit_pair *pair, const separation *before,
                                    const separation *after, vec3 closing)
{
    correction c = {.depth = pair->thickness};
    vec3 normal = vec3_load(pair->impact.normal);
    c.completed = vec3_norm_squared(normal) == 0.0;
    c.q = c.completed ? direction_where_they_meet(pair, before, after, closing)
                      : vec3_unit_or(vec3_neg(normal), vec3_zero());
    return c;
}

/* ---- shares of the correction */

typedef struct side {
    int first, last;   /* range of vertices */
    vec3 displacement; /* motion of its contact point over the step */
    double mobility;   /* motion for a unit impulse, 1/kg; 0 if immovable */
    bool rigid;
} side;

static side side_of(const hit_pair *pair, const double weights[4], int first, int last)
{
    side s = {.first = first, .last = last};
    double largest = 0.0;
    for (int k = first; k <= last; k++) {
        double m = pair->inverse_masses[k];
        s.displacement =
            vec3_add_scaled(s.displacement, weights[k], vec3_sub(pair->end[k], pair->start[k]));
        s.mobility += weights[k] * weights[k] * m;
        largest = m > largest ? m : largest;
    }
    s.rigid = largest == 0.0;
    if (s.mobility <= BASELINE_MIN_MOBILITY_RATIO * largest) {
        s.mobility = 0.0;
    }
    return s;
}

static double share_of_a(const side *a, const side *b, correction *c)
{
    if (a->mobility == 0.0 || b->mobility == 0.0) {
        c->completed = c->completed || !(a->rigid || b->rigid);
        return a->mobility > 0.0 ? 1.0 : b->mobility > 0.0 ? 0.0 : 0.5;
    }
    double closing_a = -vec3_dot(a->displacement, c->q),
           closing = closing_a + vec3_dot(b->displacement, c->q);
    if (fabs(closing) >
        BASELINE_MIN_CLOSING_RATIO * (vec3_norm(a->displacement) + vec3_norm(b->displacement))) {
        return closing_a / closing;
    }
    c->completed = true;
    return a->mobility / (a->mobility + b->mobility);
}

/* Moves the contact point of a side by exactly `shift`. */
static void displace(const hit_pair *pair, const double weights[4], const side *s, vec3 shift,
                     vbss_collision_response *response)
{
    for (int k = s->first; k <= s->last && s->mobility > 0.0; k++) {
        double part = weights[k] * pair->inverse_masses[k] / s->mobility;
        vec3_store(response->displacement + 3 * (size_t)k, vec3_scale(shift, part));
    }
}

static vbss_collision_response respond(const hit_pair *pair,
                                       vbss_collision_response_variant variant)
{
    /* A hit at time 1 has no earlier time of impact, and its normal may be that after a
     * crossing. */
    bool end_of_step = variant == VBSS_COLLISION_RESPONSE_END_OF_STEP || pair->impact.time == 1.0;
    separation before = separate(pair, pair->start), after = separate(pair, pair->end);
    const double *weights = end_of_step ? after.weights : pair->impact.weights;
    side a = side_of(pair, weights, 0, pair->first_of_b - 1);
    side b = side_of(pair, weights, pair->first_of_b, 3);
    vec3 closing = vec3_sub(b.displacement, a.displacement);
    correction c = end_of_step ? at_end_of_step(pair, &before, &after, closing)
                               : at_time_of_impact(pair, &before, &after, closing);
    double share = share_of_a(&a, &b, &c);
    vbss_collision_response response = {
        .struct_size = sizeof response, .depth = c.depth, .share_a = share};
    response.completed = c.completed ? 1 : 0;
    vec3_store(response.direction, c.q);
    displace(pair, weights, &a, vec3_scale(c.q, share * c.depth), &response);
    displace(pair, weights, &b, vec3_scale(c.q, -(1.0 - share) * c.depth), &response);
    return response;
}

/* ---- argument checks */

static vbss_result check_masses(const double inverse_masses[4])
{
    VBSS_TRY(vbss_check_pointer(NULL, inverse_masses, "inverse_masses"));
    for (int k = 0; k < 4; k++) {
        VBSS_TRY(vbss_check_range(NULL, inverse_masses[k], 0.0, 1e30, "inverse_masses"));
    }
    return vbss_max_abs(inverse_masses, 4) > 0.0
               ? VBSS_OK
               : vbss_fail(NULL, VBSS_ERROR_OUT_OF_RANGE, "all inverse_masses are 0");
}

static vbss_result check_sum(const double *weights, int count)
{
    double sum = 0.0;
    for (int k = 0; k < count; k++) {
        VBSS_TRY(vbss_check_range(NULL, weights[k], -1e-6, 1.000001, "impact->weights"));
        sum += weights[k];
    }
    return vbss_check_range(NULL, sum, 0.999999, 1.000001, "sum of impact->weights");
}

/* Accepts the impacts that a test can return: a hit with weights, and with a unit normal or
 * none. */
static vbss_result check_impact(const vbss_collision_impact *impact, int first_of_b)
{
    VBSS_TRY(vbss_check_range(NULL, impact->hit, 1.0, 1.0, "impact->hit"));
    VBSS_TRY(vbss_check_range(NULL, impact->time, 0.0, 1.0, "impact->time"));
    double length = vec3_norm(vec3_load(impact->normal));
    if (length != 0.0) {
        VBSS_TRY(vbss_check_range(NULL, length, 0.999999, 1.000001, "length of impact->normal"));
    }
    VBSS_TRY(check_sum(impact->weights, first_of_b));
    return check_sum(impact->weights + first_of_b, 4 - first_of_b);
}

vbss_result vbss_collision_get_vblast_response(vbss_collision_pair_kind kind,
                                               vbss_collision_response_variant variant,
                                               const vbss_collision_impact *impact,
                                               const double start[12], const double end[12],
                                               double thickness, const double inverse_masses[4],
                                               vbss_collision_response *response,
                                               uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(vbss_check_range(NULL, kind, VBSS_COLLISION_PAIR_EDGE_EDGE,
                              VBSS_COLLISION_PAIR_POINT_TRIANGLE, "kind"));
    VBSS_TRY(vbss_check_range(NULL, variant, VBSS_COLLISION_RESPONSE_END_OF_STEP,
                              VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT, "variant"));
    VBSS_TRY(vbss_collision_check_coordinates(NULL, start, 12, "start"));
    VBSS_TRY(vbss_collision_check_coordinates(NULL, end, 12, "end"));
    VBSS_TRY(vbss_check_range(NULL, thickness, 0.0, COLLISION_MAX_COORDINATE, "thickness"));
    VBSS_TRY(check_masses(inverse_masses));
    hit_pair pair = {.kind = kind, .thickness = thickness};
    pair.first_of_b = kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    if (impact != NULL || variant == VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT) {
        VBSS_TRY(vbss_config_read(NULL, &impact_layout, impact, &pair.impact));
        VBSS_TRY(check_impact(&pair.impact, pair.first_of_b));
    }
    for (int k = 0; k < 4; k++) {
        pair.start[k] = vec3_load(start + 3 * (size_t)k);
        pair.end[k] = vec3_load(end + 3 * (size_t)k);
        pair.inverse_masses[k] = inverse_masses[k];
    }
    vbss_collision_response own = respond(&pair, variant);
    return vbss_struct_write(NULL, &response_layout, &own, response, struct_size);
}
