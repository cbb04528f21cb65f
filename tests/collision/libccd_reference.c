#include "collision/libccd_reference.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include <ccd/ccd.h>

/* libccd's default is no limit; FCL gives it this one. */
#define ITERATION_LIMIT 500

static void support(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *farthest)
{
    const libccd_hull *h = object;
    const double *d = direction->v;
    double largest = -DBL_MAX;
    uint32_t best = 0;
    for (uint32_t i = 0; i < h->count; i++) {
        const double *p = h->points[i];
        double along = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
        if (along > largest) {
            largest = along;
            best = i;
        }
    }
    double length = h->radius > 0.0 ? sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) : 0.0;
    double share = length > 0.0 ? h->radius / length : 0.0;
    for (int k = 0; k < 3; k++) {
        farthest->v[k] = h->points[best][k] + share * d[k];
    }
}

bool libccd_meet(const libccd_hull *a, const libccd_hull *b)
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = support;
    ccd.support2 = support;
    ccd.max_iterations = ITERATION_LIMIT;
    return ccdGJKIntersect(a, b, &ccd) != 0;
}

void libccd_features(vbss_collision_pair_kind kind, const double vertices[12], double thickness,
                     libccd_hull *a, libccd_hull *b)
{
    uint32_t of_a = kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    a->count = of_a;
    b->count = 4 - of_a;
    a->radius = b->radius = 0.5 * thickness;
    memcpy(a->points, vertices, of_a * sizeof a->points[0]);
    memcpy(b->points, vertices + 3 * (size_t)of_a, b->count * sizeof b->points[0]);
}

void libccd_swept_difference(vbss_collision_pair_kind kind, const double start[12],
                             const double end[12], double thickness, libccd_hull *difference)
{
    size_t of_a = kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    difference->count = 0;
    difference->radius = thickness;
    for (size_t a = 0; a < of_a; a++) {
        for (size_t b = of_a; b < 4; b++) {
            for (int late = 0; late < 2; late++) {
                const double *now = late ? end : start;
                double *d = difference->points[difference->count++];
                for (size_t k = 0; k < 3; k++) {
                    d[k] = now[3 * b + k] - now[3 * a + k];
                }
            }
        }
    }
}

bool libccd_holds_origin(const libccd_hull *difference)
{
    static const libccd_hull origin = {.count = 1};
    return libccd_meet(difference, &origin);
}
