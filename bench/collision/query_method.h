/* What every method of the query cases gives the suite, ours and the peers' alike: answers to the
 * questions of a set. It does not see the truth. */
#ifndef VBSS_BENCH_COLLISION_QUERY_METHOD_H
#define VBSS_BENCH_COLLISION_QUERY_METHOD_H

#include <stdbool.h>
#include <stdint.h>

#include <vblast_ss/collision.h>

#include "harness/bench.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets are made in mm and asked in m. This mm is a power of two, so that the change of unit rounds
 * nothing that matters, and there and back nothing. */
#define QUERY_MM (1.0 / 1024.0)

/* A macro's value as text, for the version in a note. */
#define QUERY_TEXT_OF(value) #value
#define QUERY_TEXT(macro) QUERY_TEXT_OF(macro)

typedef struct query {
    vbss_collision_pair_kind kind;
    double thickness;
    double start[12], end[12];
} query;

/* All questions of a set have one kind and one D. */
typedef struct query_rows {
    vbss_collision_pair_kind kind;
    uint32_t count;
    double thickness;
    const query *metres;       /* the set */
    const query *millimetres;  /* the same, for peers whose tolerances are absolute */
    const double *start, *end; /* the same in metres as 12 rows of `count` */
} query_rows;

typedef struct query_answers {
    int32_t *hit;       /* of each question */
    uint32_t undecided; /* told as hits, but known to be a guess */
} query_answers;

typedef struct query_method {
    const char *name;
    const char *note;   /* what it does; version of the library */
    bool edges, points; /* it takes sets with D > 0, of edges, of points and triangles */
    bool thin;          /* it takes sets with D = 0, of both */
    /* All may be NULL but run. */
    bool (*begin)(const query_rows *rows);
    void (*run)(const query_rows *rows,
                query_answers *answers); /* timed, and called over and over */
    void (*finish)(const query_rows *rows, const query_answers *answers, bench_result *result);
    void (*end)(void);
} query_method;

/* Ours: ours.c. */
extern const query_method query_conservative, query_conservative_fine, query_conservative_call;
extern const query_method query_conservative_batch, query_conservative_batch_plain;
extern const query_method query_batch_call, query_paper_call;
extern const query_method query_paper, query_paper_metres, query_cubic;
/* Additive conservative advancement: accd.c. */
extern const query_method query_accd_coarse, query_accd_fine;
/* Only those whose library was found are linked: see the definitions VBSS_HAVE_FCL and
 * VBSS_HAVE_LIBCCD, which hold its version. */
extern const query_method query_fcl_end, query_fcl_intersect;
extern const query_method query_libccd_end, query_libccd_swept;

#ifdef __cplusplus
}
#endif

#endif
