/* What a detector told of a thread, against its truth. */
#ifndef VBSS_BENCH_KNOTS_TOLD_H
#define VBSS_BENCH_KNOTS_TOLD_H

#include "harness/bench.h"
#include "knot/knot.h"
#include "fixtures/knot_families.h"

typedef struct told {
    uint64_t hash;                /* of what was told */
    bool right, wrong, uncertain; /* not right and not wrong where there is no truth */
    bool certified;               /* all of it */
    bool orderable, ordered;      /* two throws and more; and it is known which is which */
    uint32_t crossings;
    const char *fault; /* what is wrong */
} told;

/* By the whole reading. */
told told_by_judge(vbss_knot_detector *detector, const family_case *truth);
/* By one closed curve: which throws there are, stray ones too, in no order. */
told told_by_closure(const knot_reading *reading, const family_case *truth);

typedef struct told_counts {
    uint64_t configurations, right, wrong, uncertain, certified, orderable, ordered, crossings;
    const char *first_fault;
} told_counts;
void told_add(told_counts *counts, const told *t);
/* As counters; wrong ones make the case an error. */
void told_report(const told_counts *counts, bench_result *result);

#endif
