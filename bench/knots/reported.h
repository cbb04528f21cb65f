/* What a detector told of a thread, against its truth. */
#ifndef VBSS_BENCH_KNOTS_REPORTED_H
#define VBSS_BENCH_KNOTS_REPORTED_H

#include "harness/bench.h"
#include "knot/knot.h"
#include "fixtures/knot_families.h"

typedef struct reported {
    uint64_t hash;                /* of what was told */
    bool right, wrong, uncertain; /* not right and not wrong where there is no truth */
    bool certified;               /* all of it */
    bool orderable, ordered;      /* two throws and more; and it is known which is which */
    uint32_t crossings;
    const char *fault; /* what is wrong */
} reported;

/* By the whole reading. */
reported reported_by_judge(vbss_knot_detector *detector, const family_case *truth);
/* By one closed curve: which throws there are, stray ones too, in no order. */
reported reported_by_closure(const knot_reading *reading, const family_case *truth);

typedef struct reported_counts {
    uint64_t configurations, right, wrong, uncertain, certified, orderable, ordered, crossings;
    const char *first_fault;
} reported_counts;
void reported_add(reported_counts *counts, const reported *t);
/* As counters; wrong ones make the case an error. */
void reported_report(const reported_counts *counts, bench_result *result);

#endif
