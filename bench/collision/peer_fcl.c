/* Peer: FCL. Its continuous collision of bodies takes rigid motion only, which an edge of a thread does
 * not do, so it is asked in two ways:
 * - fcl-end, D > 0: distance of the two capsules at the end of the step, with their poses worked out, as
 *   who steps capsules would. What passes through in the step is missed.
 * - fcl-intersect, D = 0: the test of two moving edges, or a moving point and triangle, that its
 *   deformable meshes stand on. It knows no thickness. */
#include "collision/fcl_reference.h"
#include "collision/query_method.h"

static void run_end(const query_rows *rows, query_answers *answers)
{
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        const query *q = &rows->millimetres[i];
        double r = 0.5 * q->thickness;
        answers->hit[i] = fcl_capsules_distance(q->end, r, q->end + 6, r) <= 0.0;
    }
}

static void run_intersect(const query_rows *rows, query_answers *answers)
{
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        const query *q = &rows->millimetres[i];
        double time;
        answers->hit[i] = fcl_features_meet(q->kind, q->start, q->end, &time);
    }
}

#define LIBRARY "FCL " VBSS_HAVE_FCL ", in mm; "

const query_method query_fcl_end = {.name = "fcl-end",
                                    .note = LIBRARY "capsules' distance at the end of the step",
                                    .edges = true,
                                    .run = run_end};
const query_method query_fcl_intersect = {.name = "fcl-intersect",
                                          .note = LIBRARY
                                          "roots of the coplanarity cubic by Newton and bisection",
                                          .thin = true,
                                          .run = run_intersect};
