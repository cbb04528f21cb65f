/* The typical load: a closed thread of 120 segments of about 1.5 diameters, tied into a flat trefoil that
 * slides along itself while it is pulled tight: its three crossings come nearer, touch, and are pressed
 * into each other, as there is no response. A tremor of hands lies over it. One step is 1 ms; a node
 * moves at 30 mm/s at most. */
#include "base/rotation.h"
#include "scenes/collision_build.h"

#define THICKNESS COLLISION_THICKNESS
#define TWO_PI 6.283185307179586
#define EXCLUSION 1.6 /* arcs shorter than this times D are no candidates */
enum { SEGMENTS = 120, STEPS = 400, TREMORS = 4 };

typedef struct trefoil {
    quat orientation;
    double phases[TREMORS];
    vec3 directions[TREMORS];
} trefoil;

static trefoil draw_trefoil(uint64_t seed)
{
    trefoil knot;
    vbss_random random;
    vbss_random_seed(&random, seed, 200);
    vec3 axis = vbss_random_direction(&random);
    knot.orientation =
        vbss_quat_from_rotation_vector(vec3_scale(axis, draw_real(&random, 0.0, 0.5 * TWO_PI)));
    for (int i = 0; i < TREMORS; i++) {
        knot.phases[i] = draw_real(&random, 0.0, TWO_PI);
        knot.directions[i] = vbss_random_direction(&random);
    }
    return knot;
}

/* Where a node is after a step, mm. */
static vec3 node_at(const trefoil *knot, int node, int step)
{
    double done = (double)step / STEPS;
    double size = 1.5 - 0.1 * done;                   /* of the knot in its plane */
    double gap = THICKNESS * (1.5 - 0.75 * done);     /* between the strands of a crossing */
    double t = TWO_PI * node / SEGMENTS + 1.5 * done; /* slides along itself */
    double s1, c1, s2, c2, s3, c3;
    vbss_sincos(t, &s1, &c1);
    vbss_sincos(2.0 * t, &s2, &c2);
    vbss_sincos(3.0 * t, &s3, &c3);
    vec3 x = vec3_make(size * (s1 + 2.0 * s2), size * (c1 - 2.0 * c2), -0.5 * gap * s3);
    x = quat_rotate(knot->orientation, x);
    for (int i = 0; i < TREMORS; i++) { /* 8 to 14 Hz */
        double beat = TWO_PI * (8.0 + 2.0 * i) * 1e-3 * step;
        double along = knot->phases[i] + TWO_PI * (3.0 + i) * node / SEGMENTS;
        x = vec3_add_scaled(x, 0.01 * vbss_sin(beat + along), knot->directions[i]);
    }
    return x;
}

static void nodes_at(const trefoil *knot, int step, vec3 nodes[SEGMENTS])
{
    for (int i = 0; i < SEGMENTS; i++) {
        nodes[i] = node_at(knot, i, step);
    }
}

/* ---- candidates */

typedef struct box {
    double low[3], high[3];
} box;

/* Of a segment over a step. */
static box swept_box(const collision_motion *m, int first)
{
    box b;
    for (int k = 0; k < 3; k++) {
        b.low[k] = (double)INFINITY;
        b.high[k] = -(double)INFINITY;
    }
    for (int i = first; i < first + 2; i++) {
        double x[6];
        vec3_store(x, m->start[i]);
        vec3_store(x + 3, m->end[i]);
        for (int k = 0; k < 6; k++) {
            b.low[k % 3] = fmin(b.low[k % 3], x[k]);
            b.high[k % 3] = fmax(b.high[k % 3], x[k]);
        }
    }
    return b;
}

static bool within(const box *a, const box *b, double distance)
{
    for (int k = 0; k < 3; k++) {
        if (a->low[k] - b->high[k] > distance || b->low[k] - a->high[k] > distance) {
            return false;
        }
    }
    return true;
}

/* Of the thread between the nearest ends of two segments, the shorter way round. */
static double arc_between(const vec3 nodes[SEGMENTS], int i, int j)
{
    double forward = 0.0, backward = 0.0;
    for (int k = i + 1; k < j; k++) {
        forward += vec3_distance(nodes[k], nodes[k + 1]);
    }
    for (int k = j + 1; k < i + SEGMENTS; k++) {
        backward += vec3_distance(nodes[k % SEGMENTS], nodes[(k + 1) % SEGMENTS]);
    }
    return fmin(forward, backward);
}

static void put_segment(collision_motion *m, int first, const vec3 start[SEGMENTS],
                        const vec3 end[SEGMENTS], int segment)
{
    for (int i = 0; i < 2; i++) {
        m->start[first + i] = start[(segment + i) % SEGMENTS];
        m->end[first + i] = end[(segment + i) % SEGMENTS];
    }
}

/* Most queries of a seed that fit; there are about 8000. */
enum { CAPACITY = 16384 };

static void add_step(collision_set *set, const vec3 start[SEGMENTS], const vec3 end[SEGMENTS])
{
    for (int i = 0; i < SEGMENTS; i++) {
        for (int j = i + 2; j < SEGMENTS && set->count < CAPACITY; j++) {
            collision_motion m;
            put_segment(&m, 0, start, end, i);
            put_segment(&m, 2, start, end, j);
            box a = swept_box(&m, 0), b = swept_box(&m, 2);
            if (within(&a, &b, THICKNESS) && arc_between(start, i, j) >= EXCLUSION * THICKNESS) {
                collision_query *query = &set->queries[set->count];
                collision_query_fill(query, VBSS_PAIR_EDGE_EDGE, THICKNESS, &m);
                set->count += collision_truth(query) ? 1 : 0;
            }
        }
    }
}

bool collision_set_thread(uint64_t seed, collision_set *set)
{
    if (!collision_set_begin(set, "thread", CAPACITY)) {
        return false;
    }
    trefoil knot = draw_trefoil(seed);
    vec3 nodes[2][SEGMENTS];
    nodes_at(&knot, 0, nodes[0]);
    for (int step = 1; step < STEPS; step++) {
        nodes_at(&knot, step, nodes[step % 2]);
        add_step(set, nodes[(step + 1) % 2], nodes[step % 2]);
    }
    return true;
}
