/* What a detector says of a thread whose truth is known, and whether that is so. */
#ifndef VBSS_TESTS_KNOT_JUDGE_H
#define VBSS_TESTS_KNOT_JUDGE_H

#include <vblast_ss/vblast_ss.h>

#include "fixtures/knot_families.h"

enum { JUDGE_THROWS = 8 };

typedef struct judge {
    vbss_context *context;
    vbss_knot_detector *detector;
    vbss_knot_detector_config config; /* change it before the detector is made */
} judge;

/* All that a detector says of one input. */
typedef struct judge_saying {
    vbss_knot_state state;
    vbss_knot_throw throws[JUDGE_THROWS];
    char notation[32];
} judge_saying;

/* The configuration: room for the longest thread_line. */
void judge_begin(judge *j);
bool judge_make(judge *j);
void judge_end(judge *j);

/* An input of that line; it is not copied. */
vbss_knot_input judge_input_of(const thread_line *line);
/* Forgets what was, and judges. */
vbss_result judge_hear(judge *j, const vbss_knot_input *input, judge_saying *saying);

/* NULL when all that is said is true; otherwise what is not. Nothing is wrong with what is uncertain, or where there is
 * no truth. `tail_last`: the host counts from the long limb's end. */
const char *judge_fault(const judge_saying *saying, const family_case *truth, bool tail_last);

bool judge_is_uncertain(const judge_saying *saying);
/* Proved: every throw, or that there is none. */
bool judge_is_certified(const judge_saying *saying);
/* Every throw that is not stray has its position. */
bool judge_is_ordered(const judge_saying *saying);

/* Counts of many; `untrue` are sayings where there is no truth. */
typedef struct judge_counts {
    uint64_t heard, wrong, uncertain, certified, ordered, located, untrue;
    uint64_t stacks, recognised,
        proved;      /* stacks of throws and unknots: all, named right, certified */
    char first[200]; /* what was wrong first */
} judge_counts;
/* `what` says what was shown. */
void judge_count(judge_counts *counts, const judge_saying *saying, const family_case *truth,
                 bool tail_last, const char *what);
void judge_add_up(judge_counts *sum, const judge_counts *counts);

#endif
