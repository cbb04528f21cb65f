#include "scenes/collision_integers.h"

static vec3 draw_integers(vbss_random *random, int low, int high)
{
    double x = draw_integer(random, low, high);
    double y = draw_integer(random, low, high);
    double z = draw_integer(random, low, high);
    return vec3_make(x, y, z);
}

static void draw_all(vbss_random *random, vec3 x[4], int low, int high)
{
    for (int i = 0; i < 4; i++) {
        x[i] = draw_integers(random, low, high);
    }
}

/* The first vertex of b. */
static int first_b(vbss_pair_kind kind)
{
    return kind == VBSS_PAIR_EDGE_EDGE ? 2 : 1;
}

/* A vertex of a, and one of b. */
static int draw_a(vbss_random *random, vbss_pair_kind kind)
{
    return draw_integer(random, 0, first_b(kind) - 1);
}

static int draw_b(vbss_random *random, vbss_pair_kind kind)
{
    return draw_integer(random, first_b(kind), 3);
}

void collision_make_integers(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    (void)kind;
    draw_all(random, m->start, -2, 2);
    draw_all(random, m->end, -2, 2);
}

/* All vertices in one plane at all times: z = i x + j y + c, of which c may move. */
void collision_make_planar(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    (void)kind;
    int i = draw_integer(random, -1, 1), j = draw_integer(random, -1, 1);
    int c[2] = {0, 0};
    if (draw_chance(random, 0.5)) {
        c[0] = draw_integer(random, -2, 2);
        c[1] = draw_integer(random, -2, 2);
    }
    draw_all(random, m->start, -3, 3);
    draw_all(random, m->end, -3, 3);
    for (int k = 0; k < 4; k++) {
        m->start[k].z = i * m->start[k].x + j * m->start[k].y + c[0];
        m->end[k].z = i * m->end[k].x + j * m->end[k].y + c[1];
    }
}

/* All vertices on one line at all times: they move along it, or it moves with them. */
void collision_make_collinear(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    (void)kind;
    bool line_moves = draw_chance(random, 0.5);
    vec3 base = draw_integers(random, -1, 1), along = draw_integers(random, -1, 1);
    vec3 end_base = line_moves ? draw_integers(random, -1, 1) : base;
    vec3 end_along = line_moves ? draw_integers(random, -1, 1) : along;
    for (int i = 0; i < 4; i++) {
        double at = draw_integer(random, -4, 4);
        m->start[i] = vec3_add_scaled(base, at, along);
        at = line_moves ? at : draw_integer(random, -4, 4);
        m->end[i] = vec3_add_scaled(end_base, at, end_along);
    }
}

/* Makes b less than it should be: an edge a point; a triangle a segment or a point. */
static void collapse_b(vbss_random *random, vbss_pair_kind kind, vec3 x[4])
{
    if (kind == VBSS_PAIR_EDGE_EDGE) {
        x[3] = x[2];
        return;
    }
    int kept = draw_integer(random, 1, 3), other = 1 + kept % 3, third = 1 + other % 3;
    switch (draw_integer(random, 0, 2)) {
    case 0:
        x[other] = x[kept];
        break;
    case 1:
        x[other] = x[third] = x[kept];
        break;
    default: /* half way between the others, which are made even */
        x[third] = vec3_add_scaled(x[kept], 2.0, vec3_sub(x[third], x[kept]));
        x[other] = vec3_scale(vec3_add(x[kept], x[third]), 0.5);
        break;
    }
}

/* At the start, at the end, or always; of two edges sometimes both. */
void collision_make_zero_length(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    collision_make_integers(random, kind, m);
    int when = draw_integer(random, 0, 3);
    uint64_t rule = vbss_random_u64(random); /* the same rule at both times */
    for (int end = 0; end < 2; end++) {
        vbss_random same;
        vbss_random_seed(&same, rule, 1);
        vec3 *x = end == 0 ? m->start : m->end;
        if (when != 1 - end) {
            collapse_b(&same, kind, x);
            if (kind == VBSS_PAIR_EDGE_EDGE && draw_chance(&same, 0.3)) {
                x[1] = x[0];
            }
        }
    }
}

/* Edges: b is parallel to a at both times, often at all. A point: it moves relative to a rigid triangle
 * along its plane. */
void collision_make_parallel(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    collision_make_integers(random, kind, m);
    if (kind == VBSS_PAIR_EDGE_EDGE) {
        double ratio = draw_integer(random, -2, 2);
        double end_ratio = draw_chance(random, 0.5) ? ratio : draw_integer(random, -2, 2);
        vec3 along = vec3_sub(m->start[1], m->start[0]);
        if (draw_chance(random, 0.5)) { /* a does not turn */
            m->end[1] = vec3_add(m->end[0], along);
        }
        vec3 end_along = vec3_sub(m->end[1], m->end[0]);
        m->start[3] = vec3_add_scaled(m->start[2], ratio, along);
        m->end[3] = vec3_add_scaled(m->end[2], end_ratio, end_along);
        return;
    }
    vec3 way = draw_integers(random, -2, 2);
    vec3 e1 = vec3_sub(m->start[2], m->start[1]), e2 = vec3_sub(m->start[3], m->start[1]);
    if (draw_chance(random, 0.5)) { /* in the plane itself */
        m->start[0] = vec3_add_scaled(m->start[1], draw_integer(random, -2, 2), e1);
        m->start[0] = vec3_add_scaled(m->start[0], draw_integer(random, -2, 2), e2);
    }
    for (int i = 0; i < 4; i++) {
        m->end[i] = vec3_add(m->start[i], way);
    }
    m->end[0] = vec3_add_scaled(m->end[0], draw_integer(random, -2, 2), e1);
    m->end[0] = vec3_add_scaled(m->end[0], draw_integer(random, -2, 2), e2);
}

/* In half of the queries one coordinate is off by so little that most methods cannot tell. */
static void nudge(vbss_random *random, vec3 x[4])
{
    if (draw_chance(random, 0.5)) {
        int i = draw_integer(random, 0, 3);
        double way = draw_chance(random, 0.5) ? 1.0 : -1.0;
        x[i].x += ldexp(way, -draw_integer(random, 8, 50));
    }
}

/* A vertex of a is one of b at the start, at the end, or at both. */
void collision_make_shared(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    collision_make_integers(random, kind, m);
    int when = draw_integer(random, 0, 2);
    int i = draw_a(random, kind), j = draw_b(random, kind);
    if (when != 1) {
        m->start[i] = m->start[j];
    }
    if (when != 0) {
        m->end[i] = m->end[j];
    }
    nudge(random, when == 1 ? m->end : m->start);
}

/* The end is the start with vertices permuted and some axes mirrored, so that much happens at 1/2. */
void collision_make_symmetric(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    (void)kind;
    draw_all(random, m->start, -2, 2);
    int order[4] = {0, 1, 2, 3};
    for (int i = 3; i > 0; i--) {
        int j = draw_integer(random, 0, draw_chance(random, 0.5) ? i : 0);
        j = draw_chance(random, 0.5) ? i : j;
        int kept = order[i];
        order[i] = order[j];
        order[j] = kept;
    }
    vec3 mirror;
    mirror.x = draw_chance(random, 0.5) ? 1.0 : -1.0;
    mirror.y = draw_chance(random, 0.5) ? 1.0 : -1.0;
    mirror.z = draw_chance(random, 0.5) ? 1.0 : -1.0;
    bool a_stays = draw_chance(random, 0.5);
    for (int i = 0; i < 4; i++) {
        vec3 x = m->start[order[i]];
        bool stays = a_stays && i < first_b(kind);
        m->end[i] = stays ? m->start[i] : vec3_make(mirror.x * x.x, mirror.y * x.y, mirror.z * x.z);
    }
}

/* Features that touch in a lattice point, often at an end or on an edge. */
static void draw_touching(vbss_random *random, vbss_pair_kind kind, vec3 x[4])
{
    vec3 where = draw_integers(random, -1, 1);
    if (kind == VBSS_PAIR_EDGE_EDGE) {
        for (int edge = 0; edge < 2; edge++) {
            vec3 along = draw_integers(random, -1, 1);
            double before = draw_integer(random, 0, 2), after = draw_integer(random, 0, 2);
            vec3 *ends = edge == 0 ? x : x + 2;
            ends[0] = vec3_add_scaled(where, -before, along);
            ends[1] = vec3_add_scaled(where, after, along);
        }
        return;
    }
    vec3 e1 = draw_integers(random, -2, 2), e2 = draw_integers(random, -2, 2);
    int first = draw_integer(random, 1, 3), second = 1 + first % 3, third = 1 + second % 3;
    x[0] = where;
    x[first] = vec3_add(where, e1);
    x[second] = vec3_add(where, e2);
    switch (draw_integer(random, 0, 3)) {
    case 0: /* the third corner is the point */
        x[third] = where;
        break;
    case 1: /* the point half way between the first and the third */
        x[third] = vec3_sub(where, e1);
        break;
    default: /* in the middle */
        x[third] = vec3_sub(vec3_sub(where, e1), e2);
        break;
    }
}

void collision_make_touch_at_end(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    bool at_start = draw_chance(random, 0.5);
    draw_touching(random, kind, at_start ? m->start : m->end);
    nudge(random, at_start ? m->start : m->end);
    draw_all(random, at_start ? m->end : m->start, -2, 2);
}

static double determinant(vec3 a, vec3 b, vec3 c)
{
    return vec3_dot(a, vec3_cross(b, c));
}

/* Speed of the volume of the four vertices. Exact: small integers. */
static double volume_speed(const vec3 x[4], const vec3 v[4])
{
    vec3 a = vec3_sub(x[1], x[0]), b = vec3_sub(x[2], x[0]), c = vec3_sub(x[3], x[0]);
    vec3 da = vec3_sub(v[1], v[0]), db = vec3_sub(v[2], v[0]), dc = vec3_sub(v[3], v[0]);
    return determinant(da, b, c) + determinant(a, db, c) + determinant(a, b, dc);
}

/* Touch at 1/2 with a double root of the volume there. */
void collision_make_graze(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    vec3 x[4], v[4];
    draw_touching(random, kind, x);
    do {
        draw_all(random, v, -2, 2);
    } while (volume_speed(x, v) != 0.0);
    for (int i = 0; i < 4; i++) {
        m->start[i] = vec3_sub(x[i], v[i]);
        m->end[i] = vec3_add(x[i], v[i]);
    }
    nudge(random, m->end);
}

void collision_make_any(vbss_random *random, vbss_pair_kind kind, collision_motion *m)
{
    static const collision_maker makers[] = {
        collision_make_integers,    collision_make_planar,   collision_make_collinear,
        collision_make_zero_length, collision_make_parallel, collision_make_shared,
        collision_make_symmetric,   collision_make_graze,    collision_make_touch_at_end};
    makers[vbss_random_below(random, sizeof makers / sizeof makers[0])](random, kind, m);
}
