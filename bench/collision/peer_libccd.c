/* Peer: libccd, GJK between convex shapes, in double. It knows no motion, so it is asked in two ways:
 * - libccd-end: the two features at the end of the step. What passes through in the step is missed.
 * - libccd-swept: whether the hull of the differences of vertices at the start and at the end, inflated
 *   by D, holds the origin. That misses nothing but by the rounding of GJK, and tells hits that are
 *   none, as what happens at different times counts too. */
#include "collision/libccd_reference.h"
#include "collision/query_method.h"

static void run_end(const query_rows *rows, query_answers *answers)
{
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        const query *q = &rows->millimetres[i];
        libccd_hull a, b;
        libccd_features(q->kind, q->end, q->thickness, &a, &b);
        answers->hit[i] = libccd_meet(&a, &b);
    }
}

static void run_swept(const query_rows *rows, query_answers *answers)
{
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        const query *q = &rows->millimetres[i];
        libccd_hull difference;
        libccd_swept_difference(q->kind, q->start, q->end, q->thickness, &difference);
        answers->hit[i] = libccd_holds_origin(&difference);
    }
}

#define LIBRARY "libccd " VBSS_HAVE_LIBCCD ", GJK in double, in mm; "

const query_method query_libccd_end = {.name = "libccd-end",
                                       .note = LIBRARY
                                       "the features at the end of the step: it knows no motion",
                                       .edges = true,
                                       .points = true,
                                       .run = run_end};
const query_method query_libccd_swept = {.name = "libccd-swept",
                                         .note = LIBRARY
                                         "the hull of the differences of vertices over the step",
                                         .edges = true,
                                         .points = true,
                                         .thin = true,
                                         .run = run_swept};
