/* The sets of tests/fixtures/collision_sets.h in the form that methods take; made once each, when a case
 * first needs one. */
#ifndef VBSS_BENCH_COLLISION_QUERY_SETS_H
#define VBSS_BENCH_COLLISION_QUERY_SETS_H

#include "collision/query_method.h"

typedef enum query_set_sort {
    EDGES,  /* D > 0, edges */
    POINTS, /* D > 0, points and triangles */
    THIN    /* D = 0, either */
} query_set_sort;

typedef struct query_set {
    char name[64]; /* as it stands in the names of cases */
    query_set_sort sort;
    bool quick; /* fewer questions */
    bool made;
    query_rows rows; /* looks into the next four */
    query *metres, *millimetres;
    double *start, *end;
    bool *truth;
    double *clearance; /* smallest distance over time minus D, mm; NAN when it was not computed */
    uint32_t positives;
} query_set;

/* 0 and up: the sets there are; NULL after the last. */
query_set *query_set_at(size_t index);
/* Why it cannot be made here; NULL when it can. */
const char *query_set_missing(const query_set *set);
/* True once it is made. */
bool query_set_make(query_set *set);
void query_sets_release(void);

#endif
