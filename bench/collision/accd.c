/* Peer: additive conservative advancement (Li, Kaufman and Jiang, Codimensional incremental potential
 * contact, ACM TOG 40(4), 2021), written from the paper for this bench: nobody packages it alone.
 *
 * The mean motion of the four vertices is taken off. No point then approaches the other feature faster
 * than the fastest vertices of both together, so for the share 1 - s of the gap over that speed they
 * cannot meet. Steps of that length follow each other until the gap is below the share s of the first
 * one, which is a hit, or the time is over. The gap to the distance xi is (d^2 - xi^2) / (d + xi); xi is
 * D here, which makes D what is hit. Distances come from the library's own closest points, so that what
 * is compared is the advancement.
 *
 * The paper has no limit of steps; features that slide along each other at a small gap need nearly any
 * number of them. Here they are told as hits, undecided, after PASS_LIMIT. */
#include <math.h>

#include "collision/closest.h"
#include "collision/query_method.h"

#define PASS_LIMIT 10000

typedef struct advancement {
    vbss_collision_pair_kind kind;
    double thickness, speed;
    vec3 x[4], v[4];
} advancement;

static double distance_now(const advancement *a)
{
    if (a->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        double s, u;
        vec3 edge_a = vec3_sub(a->x[1], a->x[0]), edge_b = vec3_sub(a->x[3], a->x[2]);
        return vec3_norm(closest_between_edges(edge_a, edge_b, vec3_sub(a->x[2], a->x[0]), &s, &u));
    }
    double weights[3];
    const vec3 corners[3] = {vec3_sub(a->x[1], a->x[0]), vec3_sub(a->x[2], a->x[0]),
                             vec3_sub(a->x[3], a->x[0])};
    return vec3_norm(closest_on_triangle(corners, weights));
}

static double gap_now(const advancement *a)
{
    double d = distance_now(a), xi = a->thickness;
    return d > xi ? (d * d - xi * xi) / (d + xi) : 0.0;
}

static advancement begin_advancement(const query *q)
{
    advancement a = {.kind = q->kind, .thickness = q->thickness};
    vec3 mean = vec3_zero();
    double speed[4];
    for (size_t k = 0; k < 4; k++) {
        a.x[k] = vec3_load(q->start + 3 * k);
        a.v[k] = vec3_sub(vec3_load(q->end + 3 * k), a.x[k]);
        mean = vec3_add_scaled(mean, 0.25, a.v[k]);
    }
    for (size_t k = 0; k < 4; k++) {
        a.v[k] = vec3_sub(a.v[k], mean);
        speed[k] = vec3_norm(a.v[k]);
    }
    a.speed = a.kind == VBSS_COLLISION_PAIR_EDGE_EDGE
                  ? fmax(speed[0], speed[1]) + fmax(speed[2], speed[3])
                  : speed[0] + fmax(fmax(speed[1], speed[2]), speed[3]);
    return a;
}

/* One more is undecided when the limit was reached. */
static bool comes_near(const query *q, double s, uint32_t *undecided)
{
    advancement a = begin_advancement(q);
    double gap = gap_now(&a), enough = s * gap, time = 0.0;
    if (!(gap > 0.0)) {
        return true;
    }
    if (!(a.speed > 0.0)) {
        return false;
    }
    for (int pass = 0; pass < PASS_LIMIT; pass++) {
        double step = (1.0 - s) * gap / a.speed;
        for (size_t k = 0; k < 4; k++) {
            a.x[k] = vec3_add_scaled(a.x[k], step, a.v[k]);
        }
        gap = gap_now(&a);
        if (time > 0.0 && gap < enough) {
            return true;
        }
        time += step;
        if (time > 1.0) {
            return false;
        }
    }
    *undecided += 1;
    return true;
}

static void run(const query_rows *rows, query_answers *answers, double s)
{
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        answers->hit[i] = comes_near(&rows->metres[i], s, &answers->undecided);
    }
}

static void run_coarse(const query_rows *rows, query_answers *answers)
{
    run(rows, answers, 0.1);
}

static void run_fine(const query_rows *rows, query_answers *answers)
{
    run(rows, answers, 1e-3);
}

#define NOTE "additive conservative advancement, our C; limit of " QUERY_TEXT(PASS_LIMIT) " steps"

const query_method query_accd_coarse = {.name = "accd-0.1",
                                        .note = NOTE,
                                        .edges = true,
                                        .points = true,
                                        .thin = true,
                                        .run = run_coarse};
const query_method query_accd_fine = {.name = "accd-0.001",
                                      .note = NOTE,
                                      .edges = true,
                                      .points = true,
                                      .thin = true,
                                      .run = run_fine};
