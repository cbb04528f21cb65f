/* Degenerate queries of thickness 0: small integers in special position, and the same a little off. */
#include "scenes/collision_integers.h"

/* Calls `change` for each coordinate, of the start first. */
static void change_all(vbss_random *random, collision_motion *m,
                       double (*change)(vbss_random *random, double x))
{
    for (int i = 0; i < 8; i++) {
        vec3 *p = i < 4 ? &m->start[i] : &m->end[i - 4];
        p->x = change(random, p->x);
        p->y = change(random, p->y);
        p->z = change(random, p->z);
    }
}

/* ---- as the reference has them */

static double draw_third(vbss_random *random, double x)
{
    (void)x;
    return draw_integer(random, -6, 6) / 3.0;
}

static void thirds(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    (void)kind;
    *m = (collision_motion){.start = {{0.0, 0.0, 0.0}}};
    change_all(random, m, draw_third);
}

static double add_noise(vbss_random *random, double x)
{
    return x + 1e-9 * draw_real(random, -1.0, 1.0);
}

static void noisy_integers(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    collision_make_integers(random, kind, m);
    change_all(random, m, add_noise);
}

/* ---- widely different magnitudes */

static const double magnitudes[] = {1e-17, 1e-8, 1.0, 1e6};

static double draw_magnitude(vbss_random *random)
{
    return magnitudes[vbss_random_below(random, sizeof magnitudes / sizeof magnitudes[0])];
}

static double draw_any_size(vbss_random *random, double x)
{
    return x * draw_magnitude(random);
}

/* One size for each axis: special positions stay special, up to rounding. */
static void stretch(vbss_random *random, collision_motion *m)
{
    vec3 sizes;
    sizes.x = draw_magnitude(random);
    sizes.y = draw_magnitude(random);
    sizes.z = draw_magnitude(random);
    for (int i = 0; i < 8; i++) {
        vec3 *p = i < 4 ? &m->start[i] : &m->end[i - 4];
        *p = vec3_make(p->x * sizes.x, p->y * sizes.y, p->z * sizes.z);
    }
}

/* A detail far from the origin, or one coordinate that runs far away. */
static void displace(vbss_random *random, collision_motion *m)
{
    double size = draw_magnitude(random);
    double offset = 0.1 * draw_magnitude(random);
    for (int i = 0; i < 8; i++) {
        vec3 *p = i < 4 ? &m->start[i] : &m->end[i - 4];
        *p = vec3_make(p->x * size + offset, p->y * size - offset, p->z * size);
    }
    if (draw_chance(random, 0.5)) {
        int far_one = draw_integer(random, 0, 3);
        m->end[far_one].z = draw_chance(random, 0.5) ? 1e6 : -1e6;
    }
}

static void mixed_magnitudes(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    collision_make_any(random, kind, m);
    switch (draw_integer(random, 0, 3)) {
    case 0:
        change_all(random, m, draw_any_size);
        break;
    case 1:
        displace(random, m);
        break;
    default:
        stretch(random, m);
        break;
    }
}

/* ---- the next doubles */

/* By at most two units in the last place; next to 0 by a tiny number. */
static double change_last_place(vbss_random *random, double x)
{
    double way = draw_chance(random, 0.5) ? (double)INFINITY : -(double)INFINITY;
    int count = draw_chance(random, 0.3) ? draw_integer(random, 1, 2) : 0;
    if (x == 0.0 && count > 0 && !draw_chance(random, 0.02)) {
        return copysign(ldexp(1.0, -draw_integer(random, 50, 60)), way);
    }
    for (int i = 0; i < count; i++) {
        x = nextafter(x, way);
    }
    return x;
}

static void last_places(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    collision_make_any(random, kind, m);
    change_all(random, m, change_last_place);
}

/* Where a point may be on an edge: often at its end. */
static double draw_share(vbss_random *random)
{
    int choice = draw_integer(random, 0, 2);
    return choice == 2 ? vbss_random_uniform(random) : choice;
}

/* Features that touch at some time, at an end or on an edge: up to rounding, so by chance. */
static void rounded_touches(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    vec3 x[4], where = draw_vec3(random, -1.0, 1.0);
    double far = draw_chance(random, 0.3) ? 1000.0 : 0.0;
    where = vec3_add(where, draw_vec3(random, -far, far));
    x[0] = where;
    for (int i = kind == VBSS_PAIR_EDGE_EDGE ? 0 : 2; i < 4; i += 2) {
        vec3 along = draw_vec3(random, -2.0, 2.0);
        double share = draw_share(random);
        vec3 *ends = x + (kind == VBSS_PAIR_EDGE_EDGE ? i : 1);
        ends[0] = vec3_add_scaled(where, -share, along);
        ends[1] = vec3_add_scaled(where, 1.0 - share, along);
    }
    if (kind == VBSS_PAIR_POINT_TRIANGLE) {
        x[3] = vec3_add(where, draw_vec3(random, -2.0, 2.0));
    }
    double when = draw_share(random);
    for (int i = 0; i < 4; i++) {
        vec3 v = draw_vec3(random, -1.0, 1.0);
        m->start[i] = vec3_add_scaled(x[i], -when, v);
        m->end[i] = vec3_add_scaled(x[i], 1.0 - when, v);
    }
}

/* All vertices in one plane, or on one line, up to rounding: the volume is nothing but rounding. */
static void rounded_planes(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    (void)kind;
    vec3 u = vbss_random_direction(random);
    vec3 v = vbss_random_direction(random);
    if (draw_chance(random, 0.2)) {
        v = vec3_zero();
    }
    double far = draw_chance(random, 0.3) ? 100.0 : 0.0;
    vec3 where = draw_vec3(random, -far, far);
    for (int i = 0; i < 8; i++) {
        vec3 x = vec3_add_scaled(where, draw_real(random, -2.0, 2.0), u);
        *(i < 4 ? &m->start[i] : &m->end[i - 4]) =
            vec3_add_scaled(x, draw_real(random, -2.0, 2.0), v);
    }
}

/* ---- the sets */

static const collision_maker makers[] = {collision_make_integers,
                                         thirds,
                                         noisy_integers,
                                         collision_make_planar,
                                         collision_make_collinear,
                                         collision_make_zero_length,
                                         collision_make_parallel,
                                         collision_make_shared,
                                         collision_make_symmetric,
                                         collision_make_graze,
                                         collision_make_touch_at_end,
                                         mixed_magnitudes,
                                         last_places,
                                         rounded_touches,
                                         rounded_planes};
const char *const collision_degenerate_names[] = {"integers",
                                                  "thirds",
                                                  "noisy integers",
                                                  "planar",
                                                  "collinear",
                                                  "zero length",
                                                  "parallel",
                                                  "shared vertices",
                                                  "time-symmetric",
                                                  "graze",
                                                  "touch at start or end",
                                                  "mixed magnitudes",
                                                  "last places",
                                                  "rounded touches",
                                                  "rounded planes"};
const uint32_t collision_degenerate_count = sizeof makers / sizeof makers[0];
_Static_assert(sizeof makers / sizeof makers[0] ==
                   sizeof collision_degenerate_names / sizeof collision_degenerate_names[0],
               "a name for each");

bool collision_set_degenerate(uint32_t which, vbss_pair_kind kind, uint32_t count, uint64_t seed,
                              collision_oracle oracle, collision_set *set)
{
    if (!collision_set_begin(set, collision_degenerate_names[which], count)) {
        return false;
    }
    vbss_random random;
    vbss_random_seed(&random, seed, 300 + 2 * which + (uint32_t)kind);
    for (; set->count < count; set->count++) {
        collision_motion motion;
        makers[which](&random, kind, &motion);
        collision_query *query = &set->queries[set->count];
        collision_query_fill(query, kind, 0.0, &motion);
        query->hit = oracle != NULL && oracle(query);
    }
    return true;
}
